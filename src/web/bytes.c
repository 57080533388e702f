/* bytes.c -- memset, memcpy and memmove of the module for browsers by the processor's own instructions, in place of the C
 * library's loops. Compiled with -mbulk-memory (cmake/web.cmake), which takes each builtin for one instruction. */
#include <string.h>

void *memset(void *at, int value, size_t count)
{
    return __builtin_memset(at, value, count);
}

void *memcpy(void *restrict to, const void *restrict from, size_t count)
{
    return __builtin_memcpy(to, from, count);
}

void *memmove(void *to, const void *from, size_t count)
{
    return __builtin_memmove(to, from, count);
}
