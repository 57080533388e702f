/* left_out_nets.c -- nets of curves are left out of the module that is held small (TAUT_WEB_NETS): their documents are read, and
 * making or judging one says where it is done. So is where a film is how far from least: no witness is found there; and
 * faces of STEP files are whole. */
#include "certify/certify_ops.h"
#include "construct/construct_ops.h"
#include "core/fail.h"
#include "io/step/cuts.h"
#include "measure/dual/density.h"

#include <math.h>

static taut_status refuse(taut_error *error)
{
    return taut_fail(error, TAUT_IO, "not-installed", NULL, taut_none, taut_none,
                     "nets of curves are not traced by this module: let the program `taut trace` "
                     "do it, or the studio, whose "
                     "module has them");
}

static taut_status make(const void *data, const taut_make_options *options, taut_model **model,
                        taut_error *error)
{
    (void)data;
    (void)options;
    (void)model;
    return refuse(error);
}

static taut_status certify(const taut_model *model, const void *data, const taut_audit *audit,
                           taut_certificate *certificate, taut_error *error)
{
    (void)model;
    (void)data;
    (void)audit;
    (void)certificate;
    return refuse(error);
}

const taut_construct_ops taut_construct_trace = {.make = make};
const taut_certify_ops taut_certify_trace = {.certify = certify};

taut_status taut_dual_density_new(const taut_surface *film, const taut_record *details,
                                  taut_dual_density **density)
{
    (void)film;
    (void)details;
    *density = NULL;
    return TAUT_OK;
}

void taut_dual_density_free(taut_dual_density *density)
{
    (void)density;
}

double taut_dual_density_at(const taut_dual_density *density, double u, double v)
{
    (void)density;
    (void)u;
    (void)v;
    return (double)NAN;
}

taut_status taut_step_find_cuts(const taut_model *model, const taut_shells *shells,
                                const taut_step_form *forms, int are_sheets, taut_arena *arena,
                                taut_step_cuts **cuts)
{
    (void)model;
    (void)forms;
    (void)are_sheets;
    *cuts = taut_arena_take(arena, (size_t)shells->face_count, sizeof **cuts);
    return *cuts != NULL ? TAUT_OK : TAUT_NO_MEMORY;
}
