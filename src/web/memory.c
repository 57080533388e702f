/* memory.c -- malloc of the module for browsers, in place of that of the C library (heap_body.h), and its other functions of which the
 * module needs less. */
#include "web/heap_body.h"

#include <stdlib.h>
#include <string.h>

extern char __heap_base; /* where the linker has put all else */

enum { PAGE = 65536, LEAST = 16 };

/* Pages of the module's memory: first what there is, then more of them, a sixteenth of all at least. */
static uint32_t take_pages(heap *h, uint32_t size, uint32_t bytes)
{
    const uint32_t pages = (uint32_t)__builtin_wasm_memory_size(0);
    const uint32_t room = (uint32_t)((uintptr_t)pages * PAGE - (uintptr_t)h->base) - size;
    if (size == 0 && room >= bytes) {
        return room & ~(uint32_t)(HEAP_UNIT - 1);
    }
    const uint32_t missing = bytes / PAGE + 1;
    uint32_t wanted = missing > pages / LEAST ? missing : pages / LEAST;
    if (__builtin_wasm_memory_grow(0, wanted) == (size_t)-1) {
        wanted = missing;
        if (__builtin_wasm_memory_grow(0, wanted) == (size_t)-1) {
            return 0;
        }
    }
    return (size == 0 ? room & ~(uint32_t)(HEAP_UNIT - 1) : 0) + wanted * PAGE;
}

static heap all = {.more = take_pages};

static heap *memory(void)
{
    if (all.base == NULL) {
        all.base =
            (char *)(((uintptr_t)&__heap_base + HEAP_UNIT - 1) & ~(uintptr_t)(HEAP_UNIT - 1));
    }
    return &all;
}

void *malloc(size_t bytes)
{
    return heap_take(memory(), bytes);
}

void *calloc(size_t count, size_t size)
{
    size_t bytes = 0;
    void *block = __builtin_mul_overflow(count, size, &bytes) ? NULL : heap_take(memory(), bytes);
    if (block != NULL) {
        memset(block, 0, bytes);
    }
    return block;
}

void *realloc(void *block, size_t bytes)
{
    return heap_resize(memory(), block, bytes);
}

void *aligned_alloc(size_t alignment, size_t bytes)
{
    return heap_take_aligned(memory(), alignment, bytes);
}

void free(void *block)
{
    heap_release(&all, block);
}

char *strerror(int number)
{
    static char text[] = "an error of the host";
    (void)number;
    return text;
}
