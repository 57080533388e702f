#include "platform/module.h"

#include "core/fail.h"
#include "platform/system.h"

taut_status taut_module_missing(const char *name, const char *package, taut_error *error)
{
    return taut_fail(error, TAUT_IO, "not-installed", NULL, taut_none, taut_none,
                     "the part of taut that needs %s is not installed: install %s and build "
                     "taut again",
                     name, package);
}

taut_status taut_module_load(const char *name, const char *package, const void **table,
                             taut_error *error)
{
    const void *symbol = taut_system_module(name);
    const char *const lacks = taut_system_lacks_modules();
    if (symbol == NULL && lacks != NULL) {
        return taut_fail(error, TAUT_IO, "not-installed", NULL, taut_none, taut_none,
                         "the part of taut that needs %s %s", name, lacks);
    }
    if (symbol == NULL) {
        return taut_module_missing(name, package, error);
    }
    *table = symbol;
    return TAUT_OK;
}
