#include "io/json/pool.h"

#include "core/memory.h"

#include <stdint.h>

enum { FIRST_BLOCK = 1 << 12, LARGEST_BLOCK = 1 << 20, ALIGNMENT = 8 };

typedef struct taut_pool_block {
    struct taut_pool_block *next;
    size_t size; /* bytes after the header */
} taut_pool_block;

/* Blocks double up to a megabyte; a piece that is larger gets a block of its own. */
static int add_block(taut_pool *pool, size_t bytes)
{
    size_t size = pool->blocks == NULL ? FIRST_BLOCK : 2 * pool->blocks->size;
    taut_pool_block *block = NULL;
    size = size < LARGEST_BLOCK ? size : LARGEST_BLOCK;
    size = size > bytes ? size : bytes;
    block = taut_alloc(1, sizeof *block + size);
    if (block == NULL) {
        return 0;
    }
    *block = (taut_pool_block){pool->blocks, size};
    pool->blocks = block;
    pool->free = (char *)(block + 1);
    pool->left = size;
    return 1;
}

void *taut_pool_take(taut_pool *pool, size_t count, size_t size)
{
    size_t bytes = 0;
    void *piece = NULL;
    if (size != 0 && count > SIZE_MAX / 4 / size) {
        return NULL;
    }
    bytes = (count * size + ALIGNMENT - 1) / ALIGNMENT * ALIGNMENT;
    bytes = bytes > 0 ? bytes : ALIGNMENT;
    if (bytes > pool->left && !add_block(pool, bytes)) {
        return NULL;
    }
    piece = pool->free;
    pool->free += bytes;
    pool->left -= bytes;
    return piece;
}

void taut_pool_free(taut_pool *pool)
{
    while (pool->blocks != NULL) {
        taut_pool_block *block = pool->blocks;
        pool->blocks = block->next;
        taut_free(block);
    }
    pool->free = NULL;
    pool->left = 0;
}
