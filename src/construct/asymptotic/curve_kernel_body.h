/* curve_kernel_body.h -- the loops behind curve_kernel.h, compiled once per instruction set.
 *
 * Four nodes lie side by side, and CURVE_WIDTH of these lanes, 2 or 4, in a vector; sums are taken lane
 * by lane, then of the first two, the last two, and both. Vectors are gcc's and clang's vector
 * extension.
 */
#include "construct/asymptotic/curve_kernel.h"
#include "core/vec3.h"

#include <string.h>

typedef double lanes __attribute__((vector_size(8 * CURVE_WIDTH), aligned(8), may_alias));

#define OF(pointer) (*(const lanes *)(const void *)(pointer))
#define INLINE static inline __attribute__((always_inline))

/* What a vector of nodes has: phi_j, the curve, and two derivatives of each. */
typedef struct node_group {
    lanes phi[3][TAUT_QUAD_POINTS], r[3][3];
} node_group;

INLINE lanes dot_of(const lanes *x, const lanes *y)
{
    return x[0] * y[0] + x[1] * y[1] + x[2] * y[2];
}

INLINE double total(lanes x)
{
    return CURVE_WIDTH == 2 ? x[0] + x[1]
                            : (x[0] + x[1]) + (x[CURVE_WIDTH - 2] + x[CURVE_WIDTH - 1]);
}

/* phi by the quotient rule on w_j B_j / W. */
INLINE void fill_group(const taut_curve_rule *rule, int node, const taut_quad_edge *edge,
                       node_group *at)
{
    const int n = rule->degree, lane = node % TAUT_CURVE_LANES;
    const double(*const basis)[TAUT_QUAD_POINTS][TAUT_CURVE_LANES] =
        rule->basis[node / TAUT_CURVE_LANES];
    lanes w[3] = {{0}}, inverse, slope, bend;
    for (int j = 0; j <= n; j++) {
        for (int d = 0; d < 3; d++) {
            w[d] += edge->weights[j] * OF(basis[d][j] + lane);
        }
    }
    inverse = 1.0 / w[0];
    slope = w[1] * inverse;
    bend = w[2] * inverse;
    memset(at->r, 0, sizeof at->r);
    for (int j = 0; j <= n; j++) {
        const lanes factor = edge->weights[j] * inverse;
        at->phi[0][j] = factor * OF(basis[0][j] + lane);
        at->phi[1][j] = factor * OF(basis[1][j] + lane) - slope * at->phi[0][j];
        at->phi[2][j] =
            factor * OF(basis[2][j] + lane) - 2 * slope * at->phi[1][j] - bend * at->phi[0][j];
        for (int d = 0; d < 3; d++) {
            for (int c = 0; c < 3; c++) {
                at->r[d][c] += at->phi[d][j] * edge->points[j][c];
            }
        }
    }
}

/* Adds some nodes' part of the gradients. From dr/d(log w_k) = phi_k (P_k - r):
 *     d(r'')/d(log w_k) = phi_k'' (P_k - r) - 2 phi_k' r' - phi_k r''                            */
INLINE void add_gradients(int n, lanes weight, const node_group *at, const taut_quad_edge *edge,
                          lanes by_point[TAUT_QUAD_POINTS][3], lanes by_log[TAUT_QUAD_POINTS])
{
    const lanes r1r2 = dot_of(at->r[1], at->r[2]), r2r2 = dot_of(at->r[2], at->r[2]);
    for (int k = 0; k <= n; k++) {
        lanes along = -2 * at->phi[1][k] * r1r2 - at->phi[0][k] * r2r2;
        for (int c = 0; c < 3; c++) {
            const lanes part = at->phi[2][k] * at->r[2][c];
            by_point[k][c] += weight * part;
            along += part * (edge->points[k][c] - at->r[0][c]);
        }
        by_log[k] += weight * along;
    }
}

/* The energy over the lanes from `lane`, and what they add to its gradients. */
INLINE double energy_from(int lane, const taut_curve_rule *rule, const taut_quad_edge *edge,
                          double by_point[TAUT_QUAD_POINTS][3], double by_log[TAUT_QUAD_POINTS])
{
    const int n = rule->degree;
    lanes energy = {0}, points[TAUT_QUAD_POINTS][3] = {{{0}}}, logs[TAUT_QUAD_POINTS] = {{0}};
    for (int k = lane; k < rule->nodes; k += TAUT_CURVE_LANES) {
        const lanes weight = OF(rule->weight + k);
        node_group at;
        fill_group(rule, k, edge, &at);
        energy += weight * dot_of(at.r[2], at.r[2]);
        if (by_point != NULL) {
            add_gradients(n, 2 * weight, &at, edge, points, logs);
        }
    }
    for (int j = 0; j <= n && by_point != NULL; j++) {
        for (int c = 0; c < 3; c++) {
            by_point[j][c] += total(points[j][c]);
        }
        by_log[j] += total(logs[j]);
    }
    return total(energy);
}

static double curve_energy(const taut_curve_rule *rule, const taut_quad_edge *edge,
                           double by_point[TAUT_QUAD_POINTS][3], double by_log[TAUT_QUAD_POINTS])
{
    double energy = 0.0;
    if (by_point != NULL) {
        memset(by_point, 0, TAUT_QUAD_POINTS * sizeof *by_point);
        memset(by_log, 0, TAUT_QUAD_POINTS * sizeof *by_log);
    }
    for (int lane = 0; lane < TAUT_CURVE_LANES; lane += CURVE_WIDTH) {
        energy += energy_from(lane, rule, edge, by_point, by_log);
    }
    return energy;
}

/* Of each inner weight the arm a_k = phi_k (P_k - r), which is dr/d(log w_k): bend = a_k'', and
 * q = r'' times a_k, a_k', a_k''. */
typedef struct arm_group {
    lanes bend[TAUT_QUAD_POINTS][3], along[3][TAUT_QUAD_POINTS];
} arm_group;

INLINE void fill_arms(int n, const taut_quad_edge *edge, const node_group *at, arm_group *arms)
{
    const lanes r1r2 = dot_of(at->r[1], at->r[2]);
    for (int j = 1; j < n; j++) {
        lanes reach = {0};
        for (int c = 0; c < 3; c++) {
            const lanes arm = edge->points[j][c] - at->r[0][c];
            reach += arm * at->r[2][c];
            arms->bend[j][c] =
                at->phi[2][j] * arm - 2 * at->phi[1][j] * at->r[1][c] - at->phi[0][j] * at->r[2][c];
        }
        arms->along[0][j] = at->phi[0][j] * reach;
        arms->along[1][j] = at->phi[1][j] * reach - at->phi[0][j] * r1r2;
        arms->along[2][j] = dot_of(at->r[2], arms->bend[j]);
    }
}

/* (f g)'' of two basis functions or arms. */
INLINE lanes product_bend(const lanes f[3][TAUT_QUAD_POINTS], int j,
                          const lanes g[3][TAUT_QUAD_POINTS], int k)
{
    return f[2][j] * g[0][k] + 2 * f[1][j] * g[1][k] + f[0][j] * g[2][k];
}

typedef lanes lane_square[TAUT_CURVE_WAYS][TAUT_CURVE_WAYS];

/* A move by a move: q is linear in them. A move by a weight:
 * d(phi_j)/d(log w_k) = phi_j (delta_jk - phi_k). */
INLINE void add_moves(int n, lanes weight, const node_group *at, const arm_group *arms,
                      const taut_curve_moves *moves, lanes *first, lane_square second)
{
    for (int a = 0; a < moves->count; a++) {
        const int j = moves->point[a];
        const double *const way = moves->direction[a];
        const lanes own = weight * at->phi[2][j];
        const lanes along =
            weight * (way[0] * at->r[2][0] + way[1] * at->r[2][1] + way[2] * at->r[2][2]);
        first[a] += at->phi[2][j] * along;
        for (int b = 0; b <= a; b++) {
            second[a][b] += own * at->phi[2][moves->point[b]];
        }
        for (int k = 1; k < n; k++) {
            const lanes *const bend = arms->bend[k];
            second[moves->count + k - 1][a] +=
                own * (way[0] * bend[0] + way[1] * bend[1] + way[2] * bend[2]) -
                along * product_bend(at->phi, j, at->phi, k);
        }
        if (j >= 1 && j < n) {
            second[moves->count + j - 1][a] += at->phi[2][j] * along;
        }
    }
}

/* A weight by a weight: d(a_k)/d(log w_m) = delta_km a_k - phi_m a_k - phi_k a_m. */
INLINE void add_weights(int n, lanes weight, const node_group *at, const arm_group *arms, int count,
                        lanes *first, lane_square second)
{
    for (int k = 1; k < n; k++) {
        lanes *const row = second[count + k - 1] + count - 1;
        for (int m = 1; m <= k; m++) {
            row[m] += weight * (dot_of(arms->bend[k], arms->bend[m]) -
                                product_bend(at->phi, m, arms->along, k) -
                                product_bend(at->phi, k, arms->along, m));
        }
        first[count + k - 1] += weight * arms->along[2][k];
        row[k] += weight * arms->along[2][k];
    }
}

INLINE void second_from(int lane, const taut_curve_rule *rule, const taut_quad_edge *edge,
                        const taut_curve_moves *moves, double first[TAUT_CURVE_WAYS],
                        double second[TAUT_CURVE_WAYS][TAUT_CURVE_WAYS])
{
    const int n = rule->degree, ways = moves->count + n - 1;
    lanes slope[TAUT_CURVE_WAYS];
    lane_square bend;
    memset(slope, 0, sizeof slope);
    memset(bend, 0, sizeof bend);
    for (int k = lane; k < rule->nodes; k += TAUT_CURVE_LANES) {
        const lanes weight = 2 * OF(rule->weight + k);
        node_group at;
        arm_group arms;
        fill_group(rule, k, edge, &at);
        fill_arms(n, edge, &at, &arms);
        add_moves(n, weight, &at, &arms, moves, slope, bend);
        add_weights(n, weight, &at, &arms, moves->count, slope, bend);
    }
    for (int a = 0; a < ways; a++) {
        first[a] += total(slope[a]);
        for (int b = 0; b <= a; b++) {
            second[a][b] += total(bend[a][b]);
        }
    }
}

static void curve_second(const taut_curve_rule *rule, const taut_quad_edge *edge,
                         const taut_curve_moves *moves, double first[TAUT_CURVE_WAYS],
                         double second[TAUT_CURVE_WAYS][TAUT_CURVE_WAYS])
{
    memset(first, 0, TAUT_CURVE_WAYS * sizeof *first);
    memset(second, 0, TAUT_CURVE_WAYS * sizeof *second);
    for (int lane = 0; lane < TAUT_CURVE_LANES; lane += CURVE_WIDTH) {
        second_from(lane, rule, edge, moves, first, second);
    }
    for (int a = 0; a < moves->count; a++) {
        for (int b = 0; b <= a; b++) {
            second[a][b] *= taut_dot(moves->direction[a], moves->direction[b]);
        }
    }
}
