/* memory.h -- every allocation of taut's own. tests/fault links another definition that fails the
 * k-th one. */
#ifndef TAUT_CORE_MEMORY_H
#define TAUT_CORE_MEMORY_H

#include <stddef.h>

/* count * size bytes, or NULL: when memory runs out or the product overflows. A count of 0 gives
 * one byte, so that NULL always means failure. */
void *taut_alloc(size_t count, size_t size);
/* The same, zeroed. */
void *taut_alloc_zero(size_t count, size_t size);
/* Resizes to count * size bytes; NULL leaves the old block as it was. */
void *taut_realloc(void *block, size_t count, size_t size);
/* count * size bytes aligned to 64, for kernels; freed by taut_free. */
void *taut_alloc_aligned(size_t count, size_t size);
void taut_free(void *block); /* NULL is fine */

#endif /* TAUT_CORE_MEMORY_H */
