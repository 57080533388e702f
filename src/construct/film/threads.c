#include "construct/film/threads.h"

#include "core/fail.h"
#include "core/vec3.h"

#include <math.h>

enum { REFERENCE_GRID = 33 };
static const double sine_least = 1e-6;

static taut_status check_pair(const double pair[2], const char *where, taut_error *error)
{
    const int is_none = pair[0] == 0 && pair[1] == 0;
    for (int k = 0; k < 2 && !is_none; k++) {
        if (!(pair[k] > 0 && isfinite(pair[k]))) {
            return taut_fail(error, TAUT_BAD_INPUT, "value", where, pair[k], 0,
                             "found %.17g, expected two positive numbers", pair[k]);
        }
    }
    return TAUT_OK;
}

/* Has the reference two directions everywhere that is looked at? */
static taut_status check_reference(const taut_surface *reference, taut_error *error)
{
    const taut_basis *u = taut_surface_u(reference), *v = taut_surface_v(reference);

    for (int k = 0; k < REFERENCE_GRID * REFERENCE_GRID; k++) {
        const double s = (k / REFERENCE_GRID + 0.5) / REFERENCE_GRID,
                     t = (k % REFERENCE_GRID + 0.5) / REFERENCE_GRID;
        double x[TAUT_SURFACE_VECTORS(1)][3], normal[3];
        (void)taut_surface_eval(
            reference, taut_basis_lo(u) + s * (taut_basis_hi(u) - taut_basis_lo(u)),
            taut_basis_lo(v) + t * (taut_basis_hi(v) - taut_basis_lo(v)), 1, x[0]);
        taut_cross(x[TAUT_XU], x[TAUT_XV], normal);
        const double sine = taut_norm(normal) / taut_norm(x[TAUT_XU]) / taut_norm(x[TAUT_XV]);
        if (!(sine > sine_least)) {
            return taut_fail(
                error, TAUT_BAD_INPUT, "value", "/reference", sine, sine_least,
                "the reference has no two directions at (%.3g, %.3g) of its range: the "
                "sine of their angle is %.3g, expected more than %.3g",
                s, t, sine, sine_least);
        }
    }
    return TAUT_OK;
}

/* Forces along threads: one kind of them, and a reference with a prestress, on the bases of the film. */
taut_status taut_film_threads_check(const taut_film_problem *problem, taut_error *error)
{
    const int has_density = problem->force_density[0] > 0,
              has_prestress = problem->prestress[0] > 0;
    taut_status status = check_pair(problem->force_density, "/force_density", error);

    if (status == TAUT_OK) {
        status = check_pair(problem->prestress, "/prestress", error);
    }
    if (status == TAUT_OK && (problem->tension > 0) + has_density + has_prestress > 1) {
        return taut_fail(error, TAUT_BAD_INPUT, "conflict",
                         has_density ? "/force_density" : "/prestress", 2, 1,
                         "found more than one of \"tension\", \"force_density\" and "
                         "\"prestress\", expected one");
    }
    if (status == TAUT_OK && has_prestress != (problem->reference != NULL)) {
        return taut_fail(error, TAUT_BAD_INPUT, "missing",
                         has_prestress ? "/reference" : "/prestress", 0, 1,
                         "\"prestress\" and \"reference\" go together");
    }
    if (status == TAUT_OK && has_prestress &&
        (!taut_basis_equal(problem->u, taut_surface_u(problem->reference)) ||
         !taut_basis_equal(problem->v, taut_surface_v(problem->reference)) ||
         taut_surface_weights(problem->reference) != NULL)) {
        return taut_fail_expected(error, TAUT_BAD_INPUT, "basis", "/reference", taut_none,
                                  "a surface on the bases of the film, without weights",
                                  "the reference is not on the bases of the film");
    }
    if (status == TAUT_OK && problem->updates != 0 && !has_prestress) {
        return taut_fail(error, TAUT_BAD_INPUT, "conflict", "/updates", problem->updates, 0,
                         "\"updates\" go with \"prestress\": leave them out");
    }
    if (status == TAUT_OK && has_prestress) {
        status = check_reference(problem->reference, error);
    }
    return status == TAUT_OK && problem->updates != 0 &&
                   !(problem->updates >= 1 && problem->updates <= TAUT_FILM_UPDATES_MAX)
               ? taut_fail(error, TAUT_BAD_INPUT, "value", "/updates", problem->updates, 1,
                           "found %d, expected a number from 1 to %d", problem->updates,
                           TAUT_FILM_UPDATES_MAX)
               : status;
}

static void find_density(const taut_film_problem *problem, const taut_surface *reference,
                         double tension, double u, double v, double density[2])
{
    const double ratio = (taut_basis_hi(problem->v) - taut_basis_lo(problem->v)) /
                         (taut_basis_hi(problem->u) - taut_basis_lo(problem->u));
    double x[TAUT_SURFACE_VECTORS(1)][3], normal[3];

    density[0] = problem->force_density[0] / tension;
    density[1] = problem->force_density[1] / tension;
    if (problem->prestress[0] > 0) {
        (void)taut_surface_eval(reference, u, v, 1, x[0]);
        taut_cross(x[TAUT_XU], x[TAUT_XV], normal);
        const double area = taut_norm(normal), along = taut_norm(x[TAUT_XU]),
                     across = taut_norm(x[TAUT_XV]);
        density[0] = problem->prestress[0] / tension * ratio * (area / along / along);
        density[1] = problem->prestress[1] / tension / ratio * (area / across / across);
    }
}

void taut_film_threads_lay(const taut_film_problem *problem, const taut_surface *reference,
                           double tension, taut_area_functional *functional,
                           taut_area_density *density)
{
    const taut_area_functional *f = functional;

    for (int line = 0; line < f->u.count; line++) {
        for (int k = 0; k < f->v.count; k++) {
            const size_t at = (size_t)line * (size_t)f->v.count + (size_t)k;
            double found[2];
            find_density(problem, reference, tension, f->u.at[line], f->v.at[k], found);
            density->along_u[at] = found[0];
            density->along_v[at] = found[1];
        }
    }
    functional->density = density;
}
