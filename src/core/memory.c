#include "core/memory.h"

#include "platform/system.h"

#include <stdint.h>

/* The product in *bytes, at least 1; 0 when it overflows. */
static int multiply_sizes(size_t count, size_t size, size_t *bytes)
{
    if (size != 0 && count > SIZE_MAX / 2 / size) {
        return 0;
    }
    *bytes = count * size > 0 ? count * size : 1;
    return 1;
}

void *taut_alloc(size_t count, size_t size)
{
    size_t bytes = 0;
    return multiply_sizes(count, size, &bytes) ? taut_system_take(bytes) : NULL;
}

void *taut_alloc_zero(size_t count, size_t size)
{
    size_t bytes = 0;
    return multiply_sizes(count, size, &bytes) ? taut_system_take_zero(bytes) : NULL;
}

void *taut_realloc(void *block, size_t count, size_t size)
{
    size_t bytes = 0;
    return multiply_sizes(count, size, &bytes) ? taut_system_resize(block, bytes) : NULL;
}

void *taut_alloc_aligned(size_t count, size_t size)
{
    size_t bytes = 0;
    if (!multiply_sizes(count, size, &bytes)) {
        return NULL;
    }
    return taut_system_take_aligned((bytes + 63) / 64 * 64);
}

void taut_free(void *block)
{
    taut_system_release(block);
}
