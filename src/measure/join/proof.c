/* proof.c -- the gap and the parametric order of a join by coefficients, not at places.
 *
 * Matched by an affine map, the derivatives of order k across the edge differ on each common piece by
 * d_k = a_k - b_k, and with the weight functions of both edges
 *
 *     D_k = (w_a w_b)^(k+1) d_k,    degree (k+1)(p + q)    (without weights: d_k, degree max(p, q))
 *
 * is a polynomial, determined by its values at the Chebyshev points of the piece:
 *
 *     D_k = sum_j c_j T_j,   |d_k| <= sum_j |c_j| / min (w_a w_b)^(k+1),   |T_j| <= 1
 *
 * with what rounding may do to the values added. c- and h- edges are not polynomials, and pairs that
 * are matched point by point are not one: those stay compared at places.
 */
#include "measure/join/side.h"

#include "core/arena.h"
#include "core/constants.h"
#include "core/elementary/elementary.h"
#include "core/vec3.h"

#include <float.h>
#include <math.h>

enum {
    NODES = 256,
    ORDERS = 4,
    COSINE_WORK = 30 /* operations of a cosine, as pulses count them */
};

/* Roundings that a derivative's value has, of its bound. */
static const double roundings = 256;

/* The weights of an edge; NULL without. The bases that carry weights end in their outermost points. */
static double weight_at(const taut_join_side *side, int span, double t, double *functions)
{
    const double *weights = taut_surface_weights(side->surface);
    const int columns = taut_basis_count(taut_surface_v(side->surface));
    const int last = taut_basis_count(side->across) - 1;
    const int row = (int)side->edge % 2 == 0 ? 0 : last;
    const int first = taut_basis_first(side->along, span);
    double sum = 0;

    if (weights == NULL) {
        return 1;
    }
    (void)taut_basis_eval(side->along, span, t, 0, functions);
    for (int i = 0; i < taut_basis_local(side->along); i++) {
        const int at = first + i;
        sum += functions[i] * weights[side->held == 0 ? row * columns + at : at * columns + row];
    }
    return sum;
}

/* Chebyshev coefficients of n values at the points cos(pi (i + 1/2) / n), stride apart: the sum of
 * their sizes; *constant gets the first. */
static double sum_coefficients(int n, int stride, const double *f, double *constant)
{
    double total = 0;
    for (int j = 0; j < n; j++) {
        double sum = 0;
        for (int i = 0; i < n; i++) {
            sum += f[(size_t)i * (size_t)stride] * taut_cos(TAUT_PI * j * (i + 0.5) / n);
        }
        sum *= (j == 0 ? 1.0 : 2.0) / n;
        *constant = j == 0 ? sum : *constant;
        total += fabs(sum);
    }
    return total;
}

typedef struct proof {
    const taut_join_side *side[2];
    double values[NODES][3], weights[NODES];
    double *functions;
    int is_rational, degree; /* of d_0 */
} proof;

/* One order on one piece: the bound of |d_k|, and the least of what it is held against. */
static void bound_order(proof *p, int k, double from, double to, double *bound, double *limit)
{
    const int n = (p->is_rational ? k + 1 : 1) * p->degree + 1, index = taut_jet_index(0, k);
    const double middle = from + 0.5 * (to - from);
    double sums[3], constant = 0, noise = 0;
    int spans[2];

    if (taut_pulse_beat(p->side[0]->pulse, 4.0 * COSINE_WORK * n * n)) {
        *bound = *limit = 0;
        return;
    }
    for (int s = 0; s < 2; s++) {
        spans[s] = taut_basis_span(p->side[s]->along, taut_join_parameter(p->side[s], middle));
    }
    *limit = INFINITY;
    for (int i = 0; i < n; i++) {
        const double x = taut_cos(TAUT_PI * (i + 0.5) / n), part = middle + 0.5 * (to - from) * x;
        taut_spot spots[2];
        double weight = 1;
        for (int s = 0; s < 2; s++) {
            const taut_basis *along = p->side[s]->along;
            const double *ends = taut_basis_breaks(along) + spans[s];
            const double t = fmin(ends[1], fmax(ends[0], taut_join_parameter(p->side[s], part)));
            taut_join_spot(p->side[s], spans[s], t, 3, &spots[s]);
            weight *= weight_at(p->side[s], spans[s], t, p->functions);
        }
        const double size = fmax(spots[0].bound[index], spots[1].bound[index]);
        p->weights[i] = p->is_rational ? taut_pow(weight, k + 1) : 1;
        noise = fmax(noise, roundings * DBL_EPSILON * size * p->weights[i]);
        *limit = fmin(*limit, taut_join_tolerance * size);
        for (int c = 0; c < 3; c++) {
            p->values[i][c] = p->weights[i] * (spots[0].x[c].c[index] - spots[1].x[c].c[index]);
        }
    }
    for (int c = 0; c < 3; c++) {
        sums[c] = sum_coefficients(n, 3, &p->values[0][c], &constant);
    }
    const double largest = sum_coefficients(n, 1, p->weights, &constant);
    const double least = 2 * constant - largest; /* the constant less all others */
    *bound = least > 0 ? (taut_norm(sums) + n * noise) / least : INFINITY;
}

static int is_polynomial(const taut_join_side *side)
{
    return taut_basis_degree(side->along) >= 0 && taut_basis_degree(side->across) >= 0;
}

taut_status taut_join_prove(const taut_join_side *a, const taut_join_side *b, int break_count,
                            const double *breaks, double gap_limit, taut_join *join)
{
    const int da = taut_basis_degree(a->along), db = taut_basis_degree(b->along);
    const int is_rational =
        taut_surface_weights(a->surface) != NULL || taut_surface_weights(b->surface) != NULL;
    const int degree = is_rational ? da + db : da > db ? da : db;
    taut_status status = TAUT_OK;

    if (!is_polynomial(a) || !is_polynomial(b) || ORDERS * degree >= NODES) {
        return TAUT_OK;
    }
    taut_arena *arena = taut_arena_new();
    const int local_a = taut_basis_local(a->along), local_b = taut_basis_local(b->along);
    proof *p = taut_arena_take(arena, 1, sizeof *p);
    double *functions =
        taut_arena_take(arena, (size_t)(local_a > local_b ? local_a : local_b), sizeof(double));
    status = taut_arena_status(arena);
    if (status == TAUT_OK) {
        int proved = 1;
        *p = (proof){.side = {a, b}, .is_rational = is_rational, .degree = degree};
        p->functions = functions;
        join->gap_bound = 0;
        for (int k = 0; k <= join->c_order; k++) {
            for (int i = 0; i + 1 < break_count && !taut_pulse_is_stopped(a->pulse); i++) {
                double bound = 0, limit = 0;
                bound_order(p, k, breaks[i], breaks[i + 1], &bound, &limit);
                join->gap_bound = k == 0 ? fmax(join->gap_bound, bound) : join->gap_bound;
                proved = proved && bound <= (k == 0 ? gap_limit : limit);
            }
        }
        join->kind = proved ? TAUT_JOIN_BOUND : TAUT_JOIN_CHECK;
    }
    taut_arena_free(arena);
    return status;
}
