/* module.h -- parts that need a heavy library, loaded when first wanted.
 *
 * A module is a shared object `taut-<name>.so` with one symbol, `taut_module_table`, that points at
 * a const table the module and its user agree on (such as draw/canvas.h). Start-up of everything
 * else stays free of the heavy library.
 */
#ifndef TAUT_PLATFORM_MODULE_H
#define TAUT_PLATFORM_MODULE_H

#include "taut/status.h"

/* The table of a module, in *table, for the life of the process. Looked for beside the library
 * (../lib/taut, taut), where it was built, and where it was to be installed. `package` is what a
 * person has to install when it is not there: TAUT_IO with that advice. Safe from any thread. */
taut_status taut_module_load(const char *name, const char *package, const void **table,
                             taut_error *error);

/* TAUT_IO with that advice, for a part that is a program. */
taut_status taut_module_missing(const char *name, const char *package, taut_error *error);

#endif /* TAUT_PLATFORM_MODULE_H */
