#include "certify/pattern/lengths.h"

#include "core/elementary/elementary.h"
#include "numeric/quadrature.h"

#include <math.h>

enum { FEW = TAUT_CLOTH_FEW, PARTS = 1024 /* of a flat line */, NODES = 8, STEPS = 32 };
/* Of a piece for the pulse: operations, roughly. */
static const double work_of_piece = 4e7;

double taut_cloth_length_between(const taut_cloth *cloth, const taut_curve *line, double a,
                                 double b, const double nodes[TAUT_CLOTH_FEW],
                                 const double weights[TAUT_CLOTH_FEW])
{
    double y[2][3], sum = 0;
    for (int q = 0; q < FEW; q++) {
        taut_cloth_line(cloth, line, a + (b - a) * (1 + nodes[q]) / 2, 1, y);
        sum += weights[q] * (b - a) / 2 * taut_hypot(y[1][0], y[1][1]);
    }
    return sum;
}

static double flat_length(const taut_cloth *cloth, const taut_curve *line)
{
    double nodes[FEW], weights[FEW], sum = 0;
    const double lo = taut_basis_lo(taut_curve_t(line)), hi = taut_basis_hi(taut_curve_t(line));
    taut_gauss_rule(FEW, nodes, weights);
    for (int k = 0; k < PARTS; k++) {
        sum += taut_cloth_length_between(cloth, line, lo + (hi - lo) * k / PARTS,
                                         lo + (hi - lo) * (k + 1) / PARTS, nodes, weights);
    }
    return sum;
}

static double length_on_surface(const taut_cloth *cloth, const taut_cloth_piece *piece, int e)
{
    const int is_across = e == TAUT_CLOTH_START || e == TAUT_CLOTH_END;
    const double fixed = e == TAUT_CLOTH_END || e == TAUT_CLOTH_LEFT;
    double nodes[NODES], weights[NODES], sum = 0;
    taut_gauss_rule(NODES, nodes, weights);
    for (int k = 0; k < STEPS * NODES; k++) {
        const double x = (k / NODES + (1 + nodes[k % NODES]) / 2) / STEPS;
        double g[3] = {NAN, NAN, NAN};
        taut_cloth_metric(cloth, piece, is_across ? fixed : x, is_across ? x : fixed, g);
        sum += weights[k % NODES] / 2 / STEPS * sqrt(fmax(g[is_across ? 2 : 0], 0));
    }
    return sum;
}

static void measure(void *context, int worker, int64_t task)
{
    const taut_cloth *cloth = context;
    taut_cloth_piece *piece = &cloth->pieces[task];
    (void)worker;
    for (int e = 0; e < TAUT_CLOTH_EDGES; e++) {
        piece->lengths[e] = piece->is_point[e] ? 0 : length_on_surface(cloth, piece, e);
        piece->flat_lengths[e] = flat_length(cloth, piece->edges[e]);
    }
}

taut_status taut_cloth_measure_edges(taut_cloth *cloth)
{
    return taut_crew_run(cloth->crew, taut_crew_workers(cloth->crew, cloth->piece_count),
                         cloth->piece_count, work_of_piece, measure, cloth)
               ? TAUT_INTERRUPTED
               : TAUT_OK;
}
