/* failing_memory.c -- the functions of src/core/memory.c, with a countdown to failure and a count
 * of the blocks alive. Linked into a fault test, it takes the place of the library's own. */
#include "core/memory.h"
#include "fault.h"
#include "platform/system.h"

#include <stdatomic.h>
#include <stdint.h>

static atomic_long countdown = 0; /* 0: never fails; k: the k-th allocation from now does */
static atomic_int keep_failing = 0;
static atomic_long counted_from = 0;
static atomic_long live = 0;
static atomic_long refused = 0;
static atomic_size_t granted = 0; /* bytes since fault_arm */

void fault_arm(long k, int and_later)
{
    atomic_store(&refused, 0);
    atomic_store(&granted, 0);
    atomic_store(&keep_failing, and_later);
    atomic_store(&counted_from, k);
    atomic_store(&countdown, k);
}

long fault_disarm(void)
{
    atomic_store(&countdown, 0);
    return atomic_load(&refused);
}

long fault_counted(void)
{
    return atomic_load(&counted_from) - atomic_load(&countdown);
}

size_t fault_bytes(void)
{
    return atomic_load(&granted);
}

long fault_live(void)
{
    return atomic_load(&live);
}

/* The bytes of count * size, at least 1; 0 when this allocation is to fail. */
static size_t grant(size_t count, size_t size)
{
    const long left = atomic_load(&countdown);
    if (left > 0 && atomic_fetch_sub(&countdown, 1) == 1) {
        atomic_store(&countdown, atomic_load(&keep_failing) ? 1 : 0);
        atomic_fetch_add(&refused, 1);
        return 0;
    }
    if (size != 0 && count > SIZE_MAX / 2 / size) {
        return 0;
    }
    atomic_fetch_add(&granted, count * size);
    return count * size > 0 ? count * size : 1;
}

static void *counted(void *block)
{
    if (block != NULL) {
        atomic_fetch_add(&live, 1);
    }
    return block;
}

void *taut_alloc(size_t count, size_t size)
{
    const size_t bytes = grant(count, size);
    return bytes > 0 ? counted(taut_system_take(bytes)) : NULL;
}

void *taut_alloc_zero(size_t count, size_t size)
{
    const size_t bytes = grant(count, size);
    return bytes > 0 ? counted(taut_system_take_zero(bytes)) : NULL;
}

void *taut_alloc_aligned(size_t count, size_t size)
{
    const size_t bytes = grant(count, size);
    return bytes > 0 ? counted(taut_system_take_aligned((bytes + 63) / 64 * 64)) : NULL;
}

void *taut_realloc(void *block, size_t count, size_t size)
{
    const size_t bytes = grant(count, size);
    if (bytes == 0) {
        return NULL;
    }
    return block != NULL ? taut_system_resize(block, bytes) : counted(taut_system_take(bytes));
}

void taut_free(void *block)
{
    if (block != NULL) {
        atomic_fetch_sub(&live, 1);
    }
    taut_system_release(block);
}
