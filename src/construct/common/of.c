#include "construct/common/of.h"

#include "core/fail.h"
#include "geometry/keep.h"

#include <string.h>

taut_status taut_construct_of(const taut_model *model, const taut_problem *of,
                              const taut_make_options *options, taut_arena *arena,
                              const taut_model **made, taut_error *error)
{
    taut_model *own = NULL;
    const taut_make_options plain = {
        .tolerance = options->tolerance, .threads = options->threads, .monitor = options->monitor};
    *made = model;
    if (of == NULL) {
        return TAUT_OK;
    }
    const taut_status status = taut_make(of, &plain, &own, error);
    if (status != TAUT_OK) {
        taut_error_prefix(error, "/of");
        return status;
    }
    *made = own;
    return taut_keep_model(arena, own) ? TAUT_OK : taut_fail_memory(error);
}

taut_status taut_construct_choose(const taut_model *model, const char *name,
                                  const taut_surface **surface, taut_error *error)
{
    const int count = taut_model_surface_count(model);
    for (int i = 0; i < count; i++) {
        const taut_surface *one = taut_model_surface(model, i);
        if (name == NULL ? count == 1 : strcmp(taut_surface_name(one), name) == 0) {
            *surface = one;
            return TAUT_OK;
        }
    }
    if (name == NULL) {
        return taut_fail(error, TAUT_BAD_INPUT, count == 0 ? "no-surface" : "missing", "/surface",
                         count, 1, "the model has %d surfaces: say which one", count);
    }
    return taut_fail(error, TAUT_BAD_INPUT, "no-such-object", "/surface", taut_none, taut_none,
                     "the model has no surface named \"%.60s\"", name);
}

void taut_construct_describe_of(const taut_problem *of, const taut_model *made,
                                taut_record *details)
{
    taut_record *at = taut_record_add_object(details, "of");
    taut_record_add_text(at, "construct", taut_problem_construction(of));
    if (taut_model_details(made) != NULL) {
        taut_record_add_record(at, "details", taut_model_details(made));
    }
}

void taut_construct_add_stretch(taut_record *domain, const char *name, const char *surface,
                                const taut_basis *basis, const double *points)
{
    taut_record *at = taut_record_add_object(domain, NULL);
    taut_basis_spec spec;

    taut_basis_spec_of(basis, &spec);
    taut_record_add_text(at, "name", name);
    if (surface != NULL) {
        taut_record_add_text(at, "surface", surface);
    }
    taut_record *t = taut_record_add_object(at, "t");
    taut_record_add_text(t, "type", "bspline");
    taut_record_add_number(t, "degree", spec.degree);
    taut_record_add_numbers(t, "knots", spec.knot_count, spec.knots);
    taut_record *list = taut_record_add_list(at, "points");
    for (int k = 0; k < taut_basis_count(basis); k++) {
        taut_record *point = taut_record_add_list(list, NULL);
        taut_record_add_number(point, NULL, points[2 * k]);
        taut_record_add_number(point, NULL, points[2 * k + 1]);
    }
}
