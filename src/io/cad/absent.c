/* absent.c -- where no process of its own can read and write CAD files: says so. In place of cad.c and what it asks. */
#include "core/fail.h"
#include "io/cad/cad.h"
#include "io/format.h"

static taut_status write_nothing(const taut_model *model, const taut_write_options *options,
                                 const char *path, taut_error *error)
{
    (void)model;
    (void)options;
    (void)path;
    return taut_fail(error, TAUT_IO, "not-installed", NULL, taut_none, taut_none,
                     "IGES is not written on Windows: write STEP, or let taut on Linux convert it");
}

static taut_status read_nothing(const char *path, const taut_read_options *options,
                                taut_model **model, taut_error *error)
{
    (void)path;
    (void)options;
    (void)model;
    return taut_fail(error, TAUT_IO, "not-installed", NULL, taut_none, taut_none,
                     "STEP and IGES are not read on Windows: let taut on Linux convert them");
}

const taut_format_ops taut_format_iges = {.write_path = write_nothing, .read = read_nothing};

taut_status taut_cad_read_step(const char *path, const taut_read_options *options,
                               taut_model **model, taut_error *error)
{
    return read_nothing(path, options, model, error);
}
