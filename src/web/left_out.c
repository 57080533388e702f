/* left_out.c -- formats that the module does not have: what they stand on is not there. */
#include "core/fail.h"
#include "io/cad/cad.h"
#include "io/format.h"

static taut_status write_nothing(const taut_model *model, const taut_write_options *options,
                                 FILE *out, taut_error *error)
{
    (void)model;
    (void)options;
    (void)out;
    return taut_fail(error, TAUT_IO, "not-installed", NULL, taut_none, taut_none,
                     "this format is not written in the browser: write json, and let the program "
                     "`taut convert` make the file of it");
}

const taut_format_ops taut_format_html = {.write = write_nothing};
const taut_format_ops taut_format_iges = {.write = write_nothing};

taut_status taut_cad_read_step(const char *path, taut_model **model, taut_error *error)
{
    (void)path;
    (void)model;
    return taut_fail(error, TAUT_IO, "not-installed", NULL, taut_none, taut_none,
                     "STEP is not read in the browser: let the program `taut convert` read it");
}
