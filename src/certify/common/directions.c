/* directions.c -- values and first derivatives of X, Y, Z and w by the recurrence of the basis
 * functions ([PieglTiller1997] A2.2, (2.7)), all of it in double-double:
 *
 *     N[i,p] = (t - k_i) / (k_(i+p) - k_i) N[i,p-1] + (k_(i+p+1) - t) / (k_(i+p+1) - k_(i+1)) N[i+1,p-1]
 *     N'[i,p] = p / (k_(i+p) - k_i) N[i,p-1] - p / (k_(i+p+1) - k_(i+1)) N[i+1,p-1]
 *
 * Inside the span all terms of the first are positive; an error is told relative to the sums of
 * absolute values, which are added up beside.
 */
#include "certify/common/directions.h"

#include "core/twice.h"
#include "taut/limits.h"

#include <string.h>

/* Relative to the sum of absolute terms: 10 operations a level of 128, sums of 2^15 terms at most,
 * each right to 2^-100. */
static const double relative_error = 0x1p-80;

/* Functions of one span. */
typedef struct functions {
    int degree, first;
    taut_twice value[TAUT_DEGREE_MAX + 1], slope[TAUT_DEGREE_MAX + 1];
} functions;

/* Knots k_0 .. k_(2p+1) of the functions of a span, which is [k_p, k_(p+1)]. */
static int take_knots(const taut_basis *basis, int span, double *knots)
{
    const int p = taut_basis_degree(basis);
    const int is_spline = strcmp(taut_basis_type(basis), "bspline") == 0;
    if (!is_spline && strcmp(taut_basis_type(basis), "bezier") != 0) {
        return 0;
    }
    if (is_spline) {
        taut_basis_spec spec;
        taut_basis_spec_of(basis, &spec);
        memcpy(knots, spec.knots + taut_basis_first(basis, span),
               2 * (size_t)(p + 1) * sizeof *knots);
        return 1;
    }
    for (int k = 0; k <= 2 * p + 1; k++) {
        knots[k] = k <= p ? taut_basis_lo(basis) : taut_basis_hi(basis);
    }
    return 1;
}

/* b becomes the functions of degree m from those of m - 1; k: the knots about the span, at p. */
static void raise_degree(int m, int p, const double *k, double t, taut_twice *b)
{
    taut_twice carried = taut_twice_of(0);
    for (int r = 0; r < m; r++) {
        const taut_twice right = taut_twice_sum(k[p + 1 + r], -t);
        const taut_twice left = taut_twice_sum(t, -k[p + 1 + r - m]);
        const taut_twice share =
            taut_twice_over(b[r], taut_twice_sum(k[p + 1 + r], -k[p + 1 + r - m]));
        b[r] = taut_twice_add(carried, taut_twice_times(right, share));
        carried = taut_twice_times(left, share);
    }
    b[m] = carried;
}

static int fill_functions(const taut_basis *basis, int span, double t, functions *f)
{
    double k[2 * TAUT_DEGREE_MAX + 2];
    const int p = taut_basis_degree(basis);
    if (!take_knots(basis, span, k)) {
        return 0;
    }
    f->degree = p;
    f->first = taut_basis_first(basis, span);
    f->value[0] = taut_twice_of(1);
    f->slope[0] = taut_twice_of(0);
    for (int m = 1; m <= p; m++) {
        for (int r = 0; m == p && r <= p; r++) {
            taut_twice up = taut_twice_of(0), down = taut_twice_of(0);
            if (r > 0) {
                up = taut_twice_over(f->value[r - 1], taut_twice_sum(k[p + r], -k[r]));
            }
            if (r < p) {
                down = taut_twice_over(f->value[r], taut_twice_sum(k[p + r + 1], -k[r + 1]));
            }
            f->slope[r] =
                taut_twice_times(taut_twice_of(p), taut_twice_add(up, taut_twice_negative(down)));
        }
        raise_degree(m, p, k, t, f->value);
    }
    return 1;
}

/* X, Y, Z, w, or a derivative of them, and the sums of absolute terms. */
typedef struct sums {
    taut_twice x[4];
    double size[4];
} sums;

static void add_term(taut_twice factor, const taut_twice c[4], sums *s)
{
    for (int k = 0; k < 4; k++) {
        s->x[k] = taut_twice_add(s->x[k], taut_twice_times(factor, c[k]));
        s->size[k] += fabs(factor.high) * fabs(c[k].high);
    }
}

/* w X' - w' X, component by component. */
static double direction_of(const sums *s, const sums *change, double x[3])
{
    double most = 0;
    for (int k = 0; k < 3; k++) {
        const taut_twice found =
            taut_twice_add(taut_twice_times(s->x[3], change->x[k]),
                           taut_twice_negative(taut_twice_times(change->x[3], s->x[k])));
        const double size = s->size[3] * change->size[k] + change->size[3] * s->size[k];
        const double error = 2 * relative_error * size + 0x1p-52 * fabs(found.high);
        x[k] = found.high;
        most = error <= most ? most : error; /* NaN stays */
    }
    return most;
}

int taut_certify_directions(const taut_surface *surface, const int span[2], double u, double v,
                            const double origin[3], const int exponent[2], double x[2][3],
                            double error[2])
{
    const int columns = taut_basis_count(taut_surface_v(surface));
    const double *const points = taut_surface_points(surface);
    const double *const weights = taut_surface_weights(surface);
    functions f, g;
    sums all[3];
    memset(all, 0, sizeof all);
    if (!fill_functions(taut_surface_u(surface), span[0], u, &f) ||
        !fill_functions(taut_surface_v(surface), span[1], v, &g)) {
        return 0;
    }
    for (int i = 0; i <= f.degree; i++) {
        for (int j = 0; j <= g.degree; j++) {
            const size_t at = (size_t)(f.first + i) * (size_t)columns + (size_t)(g.first + j);
            const double w = weights != NULL ? ldexp(weights[at], -exponent[1]) : 1;
            taut_twice c[4] = {{0, 0}, {0, 0}, {0, 0}, {w, 0}};
            for (int k = 0; k < 3; k++) {
                const taut_twice apart =
                    taut_twice_sum(ldexp(points[3 * at + (size_t)k], -exponent[0]),
                                   -ldexp(origin[k], -exponent[0]));
                c[k] = taut_twice_times(taut_twice_of(w), apart);
            }
            add_term(taut_twice_times(f.value[i], g.value[j]), c, &all[0]);
            add_term(taut_twice_times(f.slope[i], g.value[j]), c, &all[1]);
            add_term(taut_twice_times(f.value[i], g.slope[j]), c, &all[2]);
        }
    }
    error[0] = direction_of(&all[0], &all[1], x[0]);
    error[1] = direction_of(&all[0], &all[2], x[1]);
    return 1;
}
