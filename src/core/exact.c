#include "core/exact.h"

#include "core/fail.h"

static void *take_from_arena(void *context, size_t count, size_t size)
{
    return taut_arena_take(context, count, size);
}

taut_exact_memory taut_exact_memory_of(taut_arena *arena)
{
    return (taut_exact_memory){arena, take_from_arena};
}

#ifndef TAUT_NO_MODULES
taut_status taut_exact_load(const taut_exact_ops **ops, taut_error *error)
{
    const void *table = NULL;
    const taut_exact_ops *found = NULL;
    taut_status status = taut_module_load("exact", "libflint-dev", &table, error);
    if (status != TAUT_OK) {
        return status;
    }
    found = table;
    if (found->size != sizeof *found) {
        return taut_fail(error, TAUT_IO, "not-installed", NULL, taut_none, taut_none,
                         "the module taut-exact.so is of another version of taut");
    }
    *ops = found;
    return TAUT_OK;
}
#endif
