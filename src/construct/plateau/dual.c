/* dual.c -- the gap of a dual field, and the systems that make it small.
 *
 * With a = (x_v, y_v) / J and b = -(x_u, y_u) / J the field is h = psi_u a + psi_v b. One system:
 *
 *     K = sum_g w_g (phi_u, phi_v)^T [ a.Ha  a.Hb ] (phi_u, phi_v),   r = -sum_g w_g phi_u a.d + phi_v b.d
 *                                    [ a.Hb  b.Hb ]
 *     H = f''(h) = |J| (I / c + h h^T / c^3),    d = f'(h) = |J| h / c - s N_h,    c = sqrt(1 - |h|^2)
 *
 * for Newton, and at h = g, where c = |J| / |N|, with d = -H g for the start. The sums are
 * factorised: along v first, into the three products of functions of v, then along u.
 * A constant is free: the first coefficient is kept at 0.
 */
#include "construct/plateau/dual.h"

#include "core/vec3.h"
#include "numeric/quadrature.h"
#include "numeric/sum.h"

#include <math.h>
#include <string.h>

enum { NODES_BEYOND = 0 }; /* nodes on a span, beyond the functions alive there */
/* Operations, as pulses count them: to make the state of a node, to look at it, and to zero a number of fresh memory. */
enum { OF_STATE = 400, OF_LOOK = 60, OF_ZERO = 4 };

static taut_status axis_init(const taut_basis *basis, taut_arena *arena, taut_dual_axis *axis)
{
    const double *breaks = taut_basis_breaks(basis);
    const double range = taut_basis_hi(basis) - taut_basis_lo(basis);
    double node[TAUT_GAUSS_MAX], weight[TAUT_GAUSS_MAX];
    double both[2 * (TAUT_DEGREE_MAX + 1)];

    axis->count = taut_basis_count(basis);
    axis->local = taut_basis_local(basis);
    axis->spans = taut_basis_span_count(basis);
    axis->nodes = axis->local + NODES_BEYOND;
    const size_t all = (size_t)axis->spans * (size_t)axis->nodes, local = (size_t)axis->local;
    axis->first = taut_arena_take(arena, (size_t)axis->spans, sizeof(int));
    axis->t = taut_arena_take(arena, all, sizeof(double));
    axis->weight = taut_arena_take(arena, all, sizeof(double));
    axis->value = taut_arena_take(arena, all * local, sizeof(double));
    axis->slope = taut_arena_take(arena, all * local, sizeof(double));
    if (taut_arena_status(arena) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    taut_gauss_rule(axis->nodes, node, weight);
    for (size_t g = 0; g < all; g++) {
        const int span = (int)g / axis->nodes, k = (int)g % axis->nodes;
        const double lo = breaks[span], hi = breaks[span + 1];
        axis->first[span] = taut_basis_first(basis, span);
        axis->t[g] = fmin(hi, lo + (hi - lo) * (0.5 + 0.5 * node[k]));
        axis->weight[g] = 0.5 * weight[k] * ((hi - lo) / range);
        (void)taut_basis_eval(basis, span, axis->t[g], 1, both);
        for (size_t a = 0; a < local; a++) {
            axis->value[g * local + a] = both[a];
            axis->slope[g * local + a] = range * both[local + a];
        }
    }
    return TAUT_OK;
}

/* Fills the states of a line from its jets (x, x_u, x_v). */
static void fill_line(taut_dual *dual, double frame[3][3], const double range[2], int line,
                      const double *jets)
{
    const int nodes = dual->v.spans * dual->v.nodes;

    for (int k = 0; k < nodes; k++) {
        const double *xu = jets + 9 * (size_t)k + 3, *xv = xu + 3;
        double *state = dual->state + ((size_t)line * (size_t)nodes + (size_t)k) * TAUT_DUAL_STATE;
        double along[2][3];
        for (int c = 0; c < 3; c++) {
            along[0][c] = range[0] * taut_dot(frame[c], xu);
            along[1][c] = range[1] * taut_dot(frame[c], xv);
        }
        taut_cross(along[0], along[1], state);
        state[3] = along[0][0];
        state[4] = along[0][1];
        state[5] = along[1][0];
        state[6] = along[1][1];
    }
}

/* s and the area, of the states; 0 where J is not of one sign. */
static int look_at_states(taut_dual *dual)
{
    const size_t nodes = (size_t)dual->v.spans * (size_t)dual->v.nodes;
    const size_t all = (size_t)dual->u.spans * (size_t)dual->u.nodes * nodes;
    taut_sum area = {0, 0};

    dual->sign = dual->state[2] > 0 ? 1 : -1;
    for (size_t g = 0; g < all; g++) {
        const double *state = dual->state + g * TAUT_DUAL_STATE;
        if (g % nodes == 0) {
            (void)taut_pulse_beat(dual->pulse, (double)OF_LOOK * (double)nodes);
        }
        if (!(dual->sign * state[2] > 0) || !isfinite(taut_length(state))) {
            return 0;
        }
        taut_sum_add(&area,
                     dual->u.weight[g / nodes] * dual->v.weight[g % nodes] * taut_length(state));
    }
    dual->area = taut_sum_total(&area);
    return 1;
}

static taut_status fill_states(const taut_surface *surface, double frame[3][3], taut_arena *arena,
                               taut_dual *dual)
{
    const taut_basis *u = taut_surface_u(surface), *v = taut_surface_v(surface);
    const double range[2] = {taut_basis_hi(u) - taut_basis_lo(u),
                             taut_basis_hi(v) - taut_basis_lo(v)};
    const int nodes = dual->v.spans * dual->v.nodes;
    double *jets = taut_arena_take(arena, (size_t)nodes, 9 * sizeof(double));
    taut_status status = jets != NULL ? TAUT_OK : TAUT_NO_MEMORY;

    for (int line = 0; status == TAUT_OK && line < dual->u.spans * dual->u.nodes; line++) {
        if (taut_pulse_beat(dual->pulse, (double)OF_STATE * nodes)) {
            return TAUT_INTERRUPTED;
        }
        status = taut_surface_eval_grid(surface, 1, dual->u.t + line, nodes, dual->v.t, 1, 1, jets);
        if (status == TAUT_OK) {
            fill_line(dual, frame, range, line, jets);
        }
    }
    return status;
}

/* The room for systems; unknowns are numbered along the shorter side. */
static taut_status take_system(taut_arena *arena, taut_dual *dual)
{
    const int n = dual->u.count * dual->v.count;
    const size_t local_v = (size_t)dual->v.local;

    dual->along_u = dual->u.count * dual->v.local < dual->v.count * dual->u.local;
    const int width = dual->along_u ? (dual->v.local - 1) * dual->u.count + dual->u.local - 1
                                    : (dual->u.local - 1) * dual->v.count + dual->v.local - 1;
    dual->slopes =
        taut_arena_take(arena, (size_t)dual->v.spans * (size_t)dual->v.nodes, 2 * sizeof(double));
    dual->element = taut_arena_take(arena, 3 * local_v * local_v, sizeof(double));
    dual->right = taut_arena_take(arena, (size_t)n, sizeof(double));
    dual->step = taut_arena_take(arena, (size_t)n, sizeof(double));
    dual->work = taut_arena_take(arena, taut_band_tiles_work(n, width), sizeof(double));
    if (taut_arena_status(arena) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    if (taut_pulse_beat(dual->pulse, (double)OF_ZERO * n * (width + 1.0))) {
        return TAUT_INTERRUPTED;
    }
    return taut_band_init(n, width, &dual->matrix);
}

taut_status taut_dual_new(const taut_surface *surface, const taut_basis *u, const taut_basis *v,
                          double frame[3][3], taut_arena *arena, taut_dual *dual)
{
    taut_dual made = {.sign = 1, .pulse = dual->pulse};
    taut_status status = TAUT_OK;

    if (axis_init(u, arena, &made.u) != TAUT_OK || axis_init(v, arena, &made.v) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    made.state = taut_arena_take_raw(arena,
                                     (size_t)made.u.spans * (size_t)made.u.nodes *
                                         (size_t)made.v.spans * (size_t)made.v.nodes,
                                     TAUT_DUAL_STATE * sizeof(double));
    if (made.state == NULL) {
        return TAUT_NO_MEMORY;
    }
    status = fill_states(surface, frame, arena, &made);
    if (status != TAUT_OK) {
        return status;
    }
    const int is_sound = look_at_states(&made);
    if (taut_pulse_is_stopped(dual->pulse)) {
        return TAUT_INTERRUPTED;
    }
    if (!is_sound) {
        return TAUT_NO_SOLUTION;
    }
    status = take_system(arena, &made);
    if (status != TAUT_OK) {
        return status;
    }
    *dual = made;
    return TAUT_OK;
}

void taut_dual_clear(taut_dual *dual)
{
    taut_band_clear(&dual->matrix);
}

double taut_dual_cost(const taut_dual *dual)
{
    const double meeting = (double)dual->u.local * dual->u.local * dual->v.local * dual->v.local;
    const double lines = (double)dual->u.spans * dual->u.nodes * dual->v.spans;
    return (double)dual->matrix.n * dual->matrix.width * dual->matrix.width + 3 * meeting * lines;
}

/* ---- psi at the nodes of one line ---- */

static void find_slopes(taut_dual *dual, const double *psi, int line)
{
    const taut_dual_axis *u = &dual->u, *v = &dual->v;
    const int nodes = v->spans * v->nodes;
    const double *value = u->value + (size_t)line * (size_t)u->local;
    const double *slope = u->slope + (size_t)line * (size_t)u->local;
    double *along_u = dual->slopes, *along_v = dual->slopes + nodes;

    memset(along_u, 0, 2 * (size_t)nodes * sizeof(double));
    for (int a = 0; a < u->local; a++) {
        const double *row = psi + (size_t)(u->first[line / u->nodes] + a) * (size_t)v->count;
        for (int k = 0; k < nodes; k++) {
            const double *coefficient = row + v->first[k / v->nodes];
            const size_t at = (size_t)k * (size_t)v->local;
            double flat = 0, steep = 0;
            for (int b = 0; b < v->local; b++) {
                flat += coefficient[b] * v->value[at + (size_t)b];
                steep += coefficient[b] * v->slope[at + (size_t)b];
            }
            along_u[k] += slope[a] * flat;
            along_v[k] += value[a] * steep;
        }
    }
}

/* h from the slopes of psi. */
static void find_field(const double *state, double psi_u, double psi_v, double h[2])
{
    h[0] = (psi_u * state[5] - psi_v * state[3]) / state[2];
    h[1] = (psi_u * state[6] - psi_v * state[4]) / state[2];
}

/* f(h) without cancellation: |N| |n - X|^2 / 2. */
static double find_gap(const double *state, double sign, const double h[2], double c)
{
    const double length = taut_length(state);
    const double apart[3] = {sign * state[0] / length - h[0], sign * state[1] / length - h[1],
                             sign * state[2] / length - c};
    return 0.5 * length * taut_dot(apart, apart);
}

taut_dual_value taut_dual_evaluate(taut_dual *dual, const double *psi, double *density)
{
    const taut_dual_axis *u = &dual->u, *v = &dual->v;
    const int nodes = v->spans * v->nodes;
    taut_sum gap = {0, 0};
    double steepest = 0;

    if (density != NULL) {
        memset(density, 0, (size_t)u->spans * (size_t)v->spans * sizeof(double));
    }
    for (int line = 0; line < u->spans * u->nodes; line++) {
        const double *state = dual->state + (size_t)line * (size_t)nodes * TAUT_DUAL_STATE;
        find_slopes(dual, psi, line);
        for (int k = 0; k < nodes; k++, state += TAUT_DUAL_STATE) {
            double h[2];
            find_field(state, dual->slopes[k], dual->slopes[nodes + k], h);
            const double square = h[0] * h[0] + h[1] * h[1];
            const double part =
                u->weight[line] * v->weight[k] * find_gap(state, dual->sign, h, sqrt(1 - square));
            steepest = square <= steepest ? steepest : square; /* NaN stays */
            taut_sum_add(&gap, part);
            if (density != NULL) {
                density[(line / u->nodes) * v->spans + k / v->nodes] += part;
            }
        }
    }
    return (taut_dual_value){.gap = taut_sum_total(&gap), .steepest = sqrt(steepest)};
}

/* ---- systems ---- */

/* One Gauss point: K = (a.Ha, a.Hb, b.Hb) and (a.d, b.d), times its weight. */
typedef struct point_form {
    double matrix[3], right[2];
} point_form;

static point_form make_form(const double *state, const double h[2], double c, const double d[2],
                            double weight)
{
    const double size = weight * fabs(state[2]) / c, stretch = 1 / (c * c);
    const double a[2] = {state[5] / state[2], state[6] / state[2]};
    const double b[2] = {-state[3] / state[2], -state[4] / state[2]};
    const double ah = a[0] * h[0] + a[1] * h[1], bh = b[0] * h[0] + b[1] * h[1];

    return (point_form){
        .matrix = {size * (a[0] * a[0] + a[1] * a[1] + stretch * ah * ah),
                   size * (a[0] * b[0] + a[1] * b[1] + stretch * ah * bh),
                   size * (b[0] * b[0] + b[1] * b[1] + stretch * bh * bh)},
        .right = {-weight * (a[0] * d[0] + a[1] * d[1]), -weight * (b[0] * d[0] + b[1] * d[1])},
    };
}

/* At g; d = -H g, and H g = |N| (1 + |g|^2 |N|^2 / J^2) g = |N|^3 / J^2 g. */
static point_form form_of_start(const taut_dual *dual, const double *state, double weight)
{
    const double length = taut_length(state), c = fabs(state[2]) / length;
    const double g[2] = {dual->sign * state[0] / length, dual->sign * state[1] / length};
    const double size = -length / (c * c);
    const double d[2] = {size * g[0], size * g[1]};
    return make_form(state, g, c, d, weight);
}

static point_form form_of_newton(const taut_dual *dual, const double *state, const double h[2],
                                 double weight)
{
    const double c = sqrt(1 - h[0] * h[0] - h[1] * h[1]), size = fabs(state[2]) / c;
    const double d[2] = {size * h[0] - dual->sign * state[0], size * h[1] - dual->sign * state[1]};
    return make_form(state, h, c, d, weight);
}

int taut_dual_number(const taut_dual *dual, int i, int j)
{
    return dual->along_u ? j * dual->u.count + i : i * dual->v.count + j;
}

/* element[0..2][b][b2] += the sums along v of one span and one line:
 * N N' of a.Ha, N M' of a.Hb, M M' of b.Hb; N values, M slopes of functions of v. */
static void add_to_element(taut_dual *dual, const point_form *form, int k)
{
    const size_t local = (size_t)dual->v.local;
    const double *value = dual->v.value + (size_t)k * local;
    const double *slope = dual->v.slope + (size_t)k * local;

    for (size_t b = 0; b < local; b++) {
        const double flat = form->matrix[0] * value[b], mixed = form->matrix[1] * value[b];
        const double steep = form->matrix[2] * slope[b];
        double *row = dual->element + b * local;
        for (size_t c = 0; c < local; c++) {
            row[c] += flat * value[c];
            row[local * local + c] += mixed * slope[c];
            row[2 * local * local + c] += steep * slope[c];
        }
    }
}

/* The products with the functions of u: rows i = first + a, columns first + a2, below the diagonal.
 */
static void add_to_matrix(taut_dual *dual, int line, int span)
{
    const taut_dual_axis *u = &dual->u, *v = &dual->v;
    const size_t local = (size_t)v->local;
    const double *value = u->value + (size_t)line * (size_t)u->local;
    const double *slope = u->slope + (size_t)line * (size_t)u->local;
    const int i = u->first[line / u->nodes], j = v->first[span];

    for (int pair = 0; pair < u->local * u->local; pair++) {
        const int a = pair / u->local, a2 = pair % u->local;
        const double both = slope[a] * slope[a2], none = value[a] * value[a2];
        const double one = slope[a] * value[a2], other = value[a] * slope[a2];
        for (int b = 0; b < v->local; b++) {
            const int p = taut_dual_number(dual, i + a, j + b);
            const double *e = dual->element + (size_t)b * local;
            double *row = taut_band_row(&dual->matrix, p);
            for (int b2 = 0; b2 < v->local; b2++) {
                const int below = p - taut_dual_number(dual, i + a2, j + b2);
                if (below >= 0) {
                    row[below] +=
                        both * e[b2] + one * e[local * local + (size_t)b2] +
                        other * dual->element[local * local + (size_t)b2 * local + (size_t)b] +
                        none * e[2 * local * local + (size_t)b2];
                }
            }
        }
    }
}

static void add_to_right(taut_dual *dual, const point_form *form, int line, int k)
{
    const taut_dual_axis *u = &dual->u, *v = &dual->v;
    const double *value = u->value + (size_t)line * (size_t)u->local;
    const double *slope = u->slope + (size_t)line * (size_t)u->local;
    const double *m = v->value + (size_t)k * (size_t)v->local;
    const double *n = v->slope + (size_t)k * (size_t)v->local;

    for (int a = 0; a < u->local; a++) {
        const double flat = slope[a] * form->right[0], steep = value[a] * form->right[1];
        for (int b = 0; b < v->local; b++) {
            dual->right[taut_dual_number(dual, u->first[line / u->nodes] + a,
                                         v->first[k / v->nodes] + b)] += flat * m[b] + steep * n[b];
        }
    }
}

taut_status taut_dual_assemble(taut_dual *dual, const double *psi)
{
    const taut_dual_axis *u = &dual->u, *v = &dual->v;
    const int nodes = v->spans * v->nodes;
    const size_t local = (size_t)v->local;
    const double work = 8.0 * v->spans * (double)(local * local) *
                        (double)(v->nodes + u->local * u->local); /* of a line */

    const size_t row = (size_t)dual->matrix.width + 1;
    for (int i = 0; i < dual->matrix.n; i++) {
        if (taut_pulse_beat(dual->pulse, (double)OF_ZERO * (double)row)) {
            return TAUT_INTERRUPTED;
        }
        memset(taut_band_row(&dual->matrix, i), 0, row * sizeof(double));
    }
    memset(dual->right, 0, (size_t)dual->matrix.n * sizeof(double));
    for (int line = 0; line < u->spans * u->nodes; line++) {
        if (taut_pulse_beat(dual->pulse, work)) {
            return TAUT_INTERRUPTED;
        }
        const double *state = dual->state + (size_t)line * (size_t)nodes * TAUT_DUAL_STATE;
        if (psi != NULL) {
            find_slopes(dual, psi, line);
        }
        for (int k = 0; k < nodes; k++, state += TAUT_DUAL_STATE) {
            const double weight = u->weight[line] * v->weight[k];
            point_form form;
            if (psi != NULL) {
                double h[2];
                find_field(state, dual->slopes[k], dual->slopes[nodes + k], h);
                form = form_of_newton(dual, state, h, weight);
            } else {
                form = form_of_start(dual, state, weight);
            }
            if (k % v->nodes == 0) {
                memset(dual->element, 0, 3 * local * local * sizeof(double));
            }
            add_to_element(dual, &form, k);
            add_to_right(dual, &form, line, k);
            if (k % v->nodes == v->nodes - 1) {
                add_to_matrix(dual, line, k / v->nodes);
            }
        }
    }
    return TAUT_OK;
}

/* dual->step = K^-1 right, its first coefficient 0. */
static taut_status solve(taut_dual *dual)
{
    taut_status status = TAUT_OK;

    dual->matrix.a[0] *= 2; /* the constant costs now, and is not taken: the right sums to 0 */
    status = dual->matrix.width >= TAUT_BAND_TILES_LEAST
                 ? taut_band_factor_tiled(&dual->matrix, dual->work, dual->pulse)
                 : taut_band_factor(&dual->matrix);
    if (status != TAUT_OK) {
        return status == TAUT_INTERRUPTED ? status : TAUT_NO_SOLUTION;
    }
    taut_band_solve(&dual->matrix, 1, dual->right);
    for (int i = 0; i < dual->u.count; i++) {
        for (int j = 0; j < dual->v.count; j++) {
            const double x = dual->right[taut_dual_number(dual, i, j)] - dual->right[0];
            if (!isfinite(x)) {
                return TAUT_NO_SOLUTION;
            }
            dual->step[(size_t)i * (size_t)dual->v.count + (size_t)j] = x;
        }
    }
    return TAUT_OK;
}

taut_status taut_dual_start(taut_dual *dual, double *psi)
{
    taut_status status = taut_dual_assemble(dual, NULL);

    if (status == TAUT_OK) {
        status = solve(dual);
    }
    if (status != TAUT_OK) {
        return status;
    }
    memcpy(psi, dual->step, (size_t)dual->matrix.n * sizeof(double));
    return TAUT_OK;
}

taut_status taut_dual_newton(taut_dual *dual, const double *psi)
{
    const taut_status status = taut_dual_assemble(dual, psi);
    return status == TAUT_OK ? solve(dual) : status;
}
