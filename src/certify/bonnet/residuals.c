/* residuals.c -- how isothermal, harmonic and minimal a net is, at sampled parameters.
 *
 * From derivatives by the net and the basis, whatever the basis. First and second ones carry the
 * errors n_u, n_v, n_uu, n_vv (sums.c), and so
 *
 *     |E-G|/E, |F|/E     2 (n_u + n_v) / |r_u|
 *     |r_uu + r_vv|      n_uu + n_vv
 *     |H| / sqrt|K|      (n_uu + n_vv + (|L| + 2 |M| + |N|) (n_u + n_v) / |r_u|) / (2 sqrt|LN-M^2|)
 *
 * ([XuWang2006] sections 1, 9 and 10).
 */
#include "certify/bonnet/parts.h"
#include "certify/bonnet/sums.h"
#include "core/vec3.h"

#include <math.h>

enum { LINES = 33, ORDERS = TAUT_BONNET_ORDERS };
static const double most = 1e30;

void taut_bonnet_raise(taut_bonnet_finding *largest, double residual, double noise, double u,
                       double v)
{
    if (!(residual <= largest->residual)) {
        largest->residual = residual < most ? residual : most;
        largest->at[0] = u;
        largest->at[1] = v;
    }
    if (!(noise <= largest->noise)) {
        largest->noise = noise < most ? noise : most;
    }
}

typedef struct sample_lines {
    int count;
    taut_bonnet_line *at;
} sample_lines;

/* LINES equal steps on one span, fewer on each of several; above 16 spans the middle of each and
 * the ends. */
static int per_span(int spans)
{
    return spans > 16 ? 1 : (LINES - 1) / spans + 1;
}

static double parameter_at(int k, int steps, double lo, double hi)
{
    if (steps == 1) {
        return lo + 0.5 * (hi - lo);
    }
    return k == steps - 1 ? hi : lo + (hi - lo) * k / (steps - 1);
}

static taut_status lines_new(const taut_basis *basis, taut_arena *arena, sample_lines *made)
{
    const int spans = taut_basis_span_count(basis), steps = per_span(spans);
    const double *breaks = taut_basis_breaks(basis);
    const int ends = steps == 1 ? 2 : 0;
    const size_t size = (size_t)ORDERS * (size_t)taut_basis_local(basis);
    double *values = NULL;

    made->count = spans * steps + ends;
    made->at = taut_arena_take(arena, (size_t)made->count, sizeof *made->at);
    values = taut_arena_take(arena, (size_t)made->count * size, sizeof *values);
    if (made->at == NULL || values == NULL) {
        return TAUT_NO_MEMORY;
    }
    for (int i = 0; i < made->count; i++) {
        const int is_end = i >= spans * steps;
        const int span = !is_end ? i / steps : (i - spans * steps) * (spans - 1);
        const double t = is_end ? breaks[i == spans * steps ? 0 : spans]
                                : parameter_at(i % steps, steps, breaks[span], breaks[span + 1]);
        made->at[i].values = values + (size_t)i * size;
        taut_bonnet_line_fill(basis, span, t, &made->at[i]);
    }
    return TAUT_OK;
}

static double over(double a, double b)
{
    return a == 0 ? 0 : a / b;
}

static void raise_at(const taut_bonnet_spot *spot, double u, double v, taut_bonnet_finding *found)
{
    const taut_forms *f = &spot->forms;
    const double(*x)[3] = spot->x;
    const double k = sqrt(fabs(f->gaussian));
    double sum[3], second = fmax(taut_length(x[TAUT_XUU]),
                                 fmax(taut_length(x[TAUT_XUV]), taut_length(x[TAUT_XVV])));

    for (int c = 0; c < 3; c++) {
        sum[c] = x[TAUT_XUU][c] + x[TAUT_XVV][c];
    }
    taut_bonnet_raise(&found[0], over(fmax(fabs(f->e - f->g), fabs(f->f)), f->e),
                      spot->slope * (2 + spot->slope), u, v);
    taut_bonnet_raise(&found[1], over(taut_length(sum), second), over(spot->noise[1], second), u,
                      v);
    taut_bonnet_raise(&found[2], f->regular ? over(fabs(f->mean), k) : most,
                      spot->bend / (2 * k * f->w), u, v);
}

taut_status taut_bonnet_sample(const taut_surface *surface, const taut_bonnet_scale *scale,
                               taut_arena *arena, taut_bonnet_finding found[TAUT_BONNET_SAMPLED])
{
    taut_bonnet_sums sums;
    sample_lines u, v;
    taut_status status = taut_bonnet_sums_init(surface, scale, arena, &sums);

    if (status != TAUT_OK) {
        return status;
    }
    status = lines_new(taut_surface_u(surface), arena, &u);
    if (status != TAUT_OK) {
        return status;
    }
    status = lines_new(taut_surface_v(surface), arena, &v);
    if (status != TAUT_OK) {
        return status;
    }
    for (int i = 0; i < u.count; i++) {
        taut_bonnet_sums_contract(&sums, &u.at[i], 0, sums.columns);
        for (int j = 0; j < v.count; j++) {
            taut_bonnet_spot spot;
            taut_bonnet_sums_at(&sums, &v.at[j], &spot);
            raise_at(&spot, u.at[i].t, v.at[j].t, found);
        }
    }
    return TAUT_OK;
}
