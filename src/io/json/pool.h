/* pool.h -- many small pieces that live and die together. */
#ifndef TAUT_IO_JSON_POOL_H
#define TAUT_IO_JSON_POOL_H

#include <stddef.h>

/* Zero-initialise. */
typedef struct taut_pool {
    struct taut_pool_block *blocks; /* newest first */
    char *free;                     /* what is left of the newest */
    size_t left;
} taut_pool;

/* count * size bytes, aligned to 8; NULL when memory runs out. */
void *taut_pool_take(taut_pool *pool, size_t count, size_t size);
void taut_pool_free(taut_pool *pool);

#endif /* TAUT_IO_JSON_POOL_H */
