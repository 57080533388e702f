#include "certify/plateau/given.h"

#include "certify/common/verdict.h"
#include "core/vec3.h"
#include "geometry/keep.h"

#include <math.h>
#include <string.h>

enum { DEGREES_ABOVE = 4 /* of psi over the film */ };
/* Rows whose products differ by at most 8 u from those of orthonormal rows, as computed, are within
 * 36 u of such rows: sqrt(9) 12 u by the polar factor. */
static const double frame_defect = 8 * 0x1p-53, frame_error = 36 * 0x1p-53;

static const double *read_numbers(const taut_record *list, size_t count, taut_arena *arena)
{
    double *numbers = taut_arena_take(arena, count, sizeof(double));

    if (numbers == NULL || taut_record_count(list) != count) {
        return NULL;
    }
    for (size_t k = 0; k < count; k++) {
        numbers[k] = taut_record_number(taut_record_at(list, k));
    }
    return numbers;
}

/* A basis on the breaks of `film`, a few degrees above it at most; NULL for any other. */
static const taut_basis *read_basis(const taut_record *record, const taut_basis *film,
                                    taut_arena *arena)
{
    const char *type = taut_record_text(taut_record_get(record, "type"));
    const double degree = taut_record_number(taut_record_get(record, "degree"));
    const taut_record *knots = taut_record_get(record, "knots");
    const taut_record *range = taut_record_get(record, "range");
    const int most = taut_basis_local(film) - 1 + DEGREES_ABOVE,
              spans = taut_basis_span_count(film);
    taut_basis_spec spec = {.type = type};
    taut_basis *basis = NULL;

    if (!(degree >= 1 && degree <= most && degree <= TAUT_DEGREE_MAX) || degree != floor(degree)) {
        return NULL;
    }
    spec.degree = (int)degree;
    if (strcmp(type, "bspline") == 0) {
        if (taut_record_count(knots) > (size_t)(spec.degree + 1) * ((size_t)spans + 1)) {
            return NULL;
        }
        spec.knot_count = (int)taut_record_count(knots);
        spec.knots = read_numbers(knots, taut_record_count(knots), arena);
    } else if (strcmp(type, "bezier") != 0) {
        return NULL;
    } else if (range != NULL) {
        const double *ends = read_numbers(range, 2, arena);
        spec.has_range = 1;
        if (ends == NULL) {
            return NULL;
        }
        memcpy(spec.range, ends, sizeof spec.range);
    }
    const taut_status status = taut_basis_new(&spec, 0, &basis, NULL);
    if ((status == TAUT_OK || status == TAUT_NO_MEMORY) && !taut_keep_basis(arena, basis)) {
        return NULL; /* the arena tells */
    }
    if (status != TAUT_OK) {
        return NULL;
    }
    return taut_basis_span_count(basis) == spans &&
                   memcmp(taut_basis_breaks(basis), taut_basis_breaks(film),
                          ((size_t)spans + 1) * sizeof(double)) == 0
               ? basis
               : NULL;
}

/* The coefficients over 2^exponent, all finite; NULL otherwise. */
static const double *read_coefficients(const taut_record *rows, const taut_flux_task *task,
                                       taut_arena *arena)
{
    const size_t nu = (size_t)taut_basis_count(task->u), nv = (size_t)taut_basis_count(task->v);
    double *all = taut_arena_take(arena, nu * nv, sizeof(double));
    double largest = 0;

    if (all == NULL || taut_record_count(rows) != nu) {
        return NULL;
    }
    for (size_t i = 0; i < nu; i++) {
        const taut_record *row = taut_record_at(rows, i);
        if (taut_record_count(row) != nv) {
            return NULL;
        }
        for (size_t j = 0; j < nv; j++) {
            const double x = taut_record_number(taut_record_at(row, j));
            all[i * nv + j] = ldexp(x, -task->exponent);
            largest = taut_certify_max(largest, fabs(all[i * nv + j]));
        }
    }
    return isfinite(largest) ? all : NULL;
}

/* A right-handed frame whose third row is e made unit; 0 where rounding leaves none. */
static int make_frame(const double given[3], double frame[3][3])
{
    const double largest = taut_largest_coordinate(given);
    double e[3], axis[3] = {0, 0, 0};
    int flat = 0;

    if (!(largest > 0) || !isfinite(largest) || !isfinite(given[0] + given[1] + given[2])) {
        return 0;
    }
    for (int c = 0; c < 3; c++) {
        e[c] = given[c] / largest;
        flat = fabs(given[c]) < fabs(given[flat]) ? c : flat;
    }
    const double length = sqrt(taut_dot(e, e));
    axis[flat] = 1;
    for (int c = 0; c < 3; c++) {
        frame[2][c] = e[c] / length;
    }
    taut_cross(frame[2], axis, frame[1]);
    const double across = sqrt(taut_dot(frame[1], frame[1]));
    for (int c = 0; c < 3; c++) {
        frame[1][c] /= across;
    }
    taut_cross(frame[1], frame[2], frame[0]);
    for (int a = 0; a < 3; a++) {
        for (int b = 0; b <= a; b++) {
            if (!(fabs(taut_dot(frame[a], frame[b]) - (a == b)) <= frame_defect)) {
                return 0;
            }
        }
    }
    return 1;
}

int taut_given_frame(const taut_record *direction, taut_arena *arena, taut_flux_task *task)
{
    const double *e = read_numbers(direction, 3, arena);

    task->frame_error = frame_error;
    return e != NULL && make_frame(e, task->frame);
}

const char *taut_given_psi(const taut_record *witness, taut_arena *arena, taut_flux_task *task)
{
    task->u = read_basis(taut_record_get(witness, "u"), taut_surface_u(task->surface), arena);
    task->v = read_basis(taut_record_get(witness, "v"), taut_surface_v(task->surface), arena);
    if (task->u == NULL || task->v == NULL) {
        return "witness: its bases are not on the spans of the film";
    }
    task->coefficients = read_coefficients(taut_record_get(witness, "coefficients"), task, arena);
    return task->coefficients != NULL ? NULL : "witness: its coefficients do not fit its bases";
}
