/* sums.c -- derivatives of a net as sums over the basis, and what rounding leaves of them.
 *
 *     r^(d,e) = sum P_ij U_i^(d) V_j^(e),    noise = 2^-53 sum p_ij |U_i^(d)| |V_j^(e)|
 *
 * p_ij is the size of P_ij with what cancelled in it (sums.h). Far from zero a parameter t
 * is rounded too, to 2^-53 |t|, which moves r^(d,e) by that times the next derivative.
 */
#include "certify/bonnet/sums.h"

#include "core/constants.h"
#include "core/vec3.h"

#include <math.h>
#include <stdint.h>

enum { ORDERS = TAUT_BONNET_ORDERS, TRIES = 33 };

/* Far from zero, a parameter is known less well than a segment's own rounding would have it. */
static double far_rounding(const taut_basis *basis)
{
    const double lo = taut_basis_lo(basis), hi = taut_basis_hi(basis);
    const double segment = (hi - lo) / taut_basis_span_count(basis);
    return TAUT_UNIT_ROUNDOFF * fmax(0, fmax(fabs(lo), fabs(hi)) - segment);
}

static double parameter_at(int k, double lo, double hi)
{
    return k == TRIES - 1 ? hi : lo + (hi - lo) * k / (TRIES - 1);
}

/* r_u + r_uuu is the coefficient of u, r_v - r_vvv that of v, in all surfaces of the class and at
 * every point; taken in the middle in u, and in v where the sums of absolute values are least. */
void taut_bonnet_scale_of(const taut_surface *surface, int is_exact, taut_bonnet_scale *scale)
{
    const taut_basis *bases[2] = {taut_surface_u(surface), taut_surface_v(surface)};
    const int nv = taut_basis_count(bases[1]);
    double values[2][ORDERS * 4], least = INFINITY;

    *scale = (taut_bonnet_scale){{0, 0}, {far_rounding(bases[0]), far_rounding(bases[1])}};
    if (is_exact || taut_basis_local(bases[0]) != 4 || taut_basis_local(bases[1]) != 4) {
        return;
    }
    for (int k = 0; k < TRIES; k++) {
        const double u = 0.5 * taut_basis_lo(bases[0]) + 0.5 * taut_basis_hi(bases[0]);
        const double v = parameter_at(k, taut_basis_lo(bases[1]), taut_basis_hi(bases[1]));
        const int span[2] = {taut_basis_span(bases[0], u), taut_basis_span(bases[1], v)};
        const int first[2] = {taut_basis_first(bases[0], span[0]),
                              taut_basis_first(bases[1], span[1])};
        double a[2][3] = {{0, 0, 0}, {0, 0, 0}}, gross = 0;
        taut_basis_eval(bases[0], span[0], u, ORDERS - 1, values[0]);
        taut_basis_eval(bases[1], span[1], v, ORDERS - 1, values[1]);
        for (int i = 0; i < 16; i++) {
            const double *p = taut_surface_points(surface) +
                              3 * ((int64_t)(first[0] + i / 4) * nv + first[1] + i % 4);
            const double *fu = values[0] + i / 4, *fv = values[1] + i % 4;
            const double along_u = (fu[4] + fu[12]) * fv[0], along_v = fu[0] * (fv[4] - fv[12]);
            for (int c = 0; c < 3; c++) {
                a[0][c] += p[c] * along_u;
                a[1][c] += p[c] * along_v;
            }
            gross += taut_largest_coordinate(p) * (fabs(fu[12] * fv[0]) + fabs(fu[0] * fv[12]));
        }
        if (gross < least) {
            least = gross;
            scale->linear[0] = taut_largest_coordinate(a[0]);
            scale->linear[1] = taut_largest_coordinate(a[1]);
        }
    }
}

/* About where function i of a direction acts. */
static double abscissa(const taut_basis *basis, int i)
{
    const double lo = taut_basis_lo(basis), hi = taut_basis_hi(basis);
    return lo + (hi - lo) * i / (taut_basis_count(basis) - 1);
}

double taut_bonnet_point_size(const taut_surface *surface, const taut_bonnet_scale *scale, int i,
                              int j)
{
    const taut_basis *u = taut_surface_u(surface), *v = taut_surface_v(surface);
    const double *p = taut_surface_points(surface) + 3 * ((int64_t)i * taut_basis_count(v) + j);
    return taut_largest_coordinate(p) + scale->linear[0] * fabs(abscissa(u, i)) +
           scale->linear[1] * fabs(abscissa(v, j));
}

taut_status taut_bonnet_sums_init(const taut_surface *surface, const taut_bonnet_scale *scale,
                                  taut_arena *arena, taut_bonnet_sums *sums)
{
    const int nu = taut_basis_count(taut_surface_u(surface));
    const int nv = taut_basis_count(taut_surface_v(surface));
    double *sizes = taut_arena_take(arena, (size_t)nu * (size_t)nv, sizeof *sizes);

    sums->surface = surface;
    sums->scale = scale;
    sums->sizes = sizes;
    sums->columns = nv;
    sums->rows = taut_arena_take(arena, 3 * ORDERS * (size_t)nv, sizeof(double));
    sums->row_sizes = taut_arena_take(arena, ORDERS * (size_t)nv, sizeof(double));
    if (sizes == NULL || sums->rows == NULL || sums->row_sizes == NULL) {
        return TAUT_NO_MEMORY;
    }
    for (int i = 0; i < nu; i++) {
        for (int j = 0; j < nv; j++) {
            sizes[(int64_t)i * nv + j] = taut_bonnet_point_size(surface, scale, i, j);
        }
    }
    return TAUT_OK;
}

void taut_bonnet_line_fill(const taut_basis *basis, int span, double t, taut_bonnet_line *line)
{
    line->t = t;
    line->first = taut_basis_first(basis, span);
    line->local = taut_basis_local(basis);
    taut_basis_eval(basis, span, t, ORDERS - 1, line->values);
}

void taut_bonnet_sums_contract(taut_bonnet_sums *sums, const taut_bonnet_line *u, int from, int to)
{
    const int nv = sums->columns;
    for (int d = 0; d < ORDERS; d++) {
        for (int j = from; j < to; j++) {
            double *row = sums->rows + 3 * ((int64_t)d * nv + j);
            double size = 0;
            row[0] = row[1] = row[2] = 0;
            for (int a = 0; a < u->local; a++) {
                const double f = u->values[d * u->local + a];
                const int64_t at = (int64_t)(u->first + a) * nv + j;
                const double *p = taut_surface_points(sums->surface) + 3 * at;
                for (int k = 0; k < 3; k++) {
                    row[k] += f * p[k];
                }
                size += fabs(f) * sums->sizes[at];
            }
            sums->row_sizes[(int64_t)d * nv + j] = size;
        }
    }
}

/* Derivative d in u, e in v: the vector, and its sum of absolute values. */
static double finish(const taut_bonnet_sums *sums, const taut_bonnet_line *v, int d, int e,
                     double *vector)
{
    double gross = 0;
    vector[0] = vector[1] = vector[2] = 0;
    for (int b = 0; b < v->local; b++) {
        const double f = v->values[e * v->local + b];
        const int64_t at = (int64_t)d * sums->columns + v->first + b;
        for (int k = 0; k < 3; k++) {
            vector[k] += f * sums->rows[3 * at + k];
        }
        gross += fabs(f) * sums->row_sizes[at];
    }
    return gross;
}

void taut_bonnet_sums_at(const taut_bonnet_sums *sums, const taut_bonnet_line *v,
                         taut_bonnet_spot *spot)
{
    static const int orders[6][2] = {{0, 0}, {1, 0}, {0, 1}, {2, 0}, {1, 1}, {0, 2}};
    static const int thirds[4][2] = {{3, 0}, {2, 1}, {1, 2}, {0, 3}};
    const double *shift = sums->scale->shift;
    double g[6], third[4] = {0, 0, 0, 0}, unused[3];

    for (int k = 0; k < 6; k++) {
        g[k] = finish(sums, v, orders[k][0], orders[k][1], spot->x[k]);
    }
    for (int k = 0; k < 4 && shift[0] + shift[1] > 0; k++) {
        third[k] = finish(sums, v, thirds[k][0], thirds[k][1], unused);
    }
    spot->noise[0] =
        TAUT_UNIT_ROUNDOFF * (g[1] + g[2]) + shift[0] * (g[3] + g[4]) + shift[1] * (g[4] + g[5]);
    spot->noise[1] = TAUT_UNIT_ROUNDOFF * (g[3] + g[5]) + shift[0] * (third[0] + third[2]) +
                     shift[1] * (third[1] + third[3]);
    taut_forms_of((const double(*)[3])spot->x, &spot->forms);
    spot->slope = spot->noise[0] / sqrt(spot->forms.e);
    spot->bend =
        spot->noise[1] +
        (fabs(spot->forms.l) + 2 * fabs(spot->forms.m) + fabs(spot->forms.n)) * spot->slope;
}
