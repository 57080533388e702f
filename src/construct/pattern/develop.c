#include "construct/pattern/develop.h"

#include "core/elementary/elementary.h"
#include "numeric/quadrature.h"

#include <math.h>

enum {
    NODES = 8,
    LOOK = 24,
    LOOK_AGAIN = 20, /* nodes that say the same where K is even */
    LOOK_CELLS = 4,
    BORDER_CELLS = 32,
    GRID = 32,
    LEAST = 4 /* spans along, at first; across half as many, at last as many */,
    LEVELS = 5,
    HALVES = 2,
    CLAIMED = 32 /* places of a span */
};
/* K times the area of a piece, up to rounding none; the strain that is no strain; and that of which it is claimed. */
static const double flat_curvature = 1e-11, no_strain = 2e-12, claimed_strain = 8e-12;
/* Of iint |K| dA: sums that are one. */
static const double same_curvature = 1e-7, rough_curvature = 1e-5;
static const double aside = 1e-8; /* of s and t */
/* Operations, about, of a place that is looked at. */
static const double work_of_place = 3e3;

/* iint K dA, iint |K| dA, the area, and the largest |K| that was met. */
typedef struct curvature_sums {
    double gauss, size, area, most;
} curvature_sums;

/* By a rule of so many nodes in so many cells each way. */
static void add_curvature(const taut_pattern_piece *piece, int count, int cells, taut_pulse *pulse,
                          curvature_sums *sums)
{
    double nodes[LOOK], weights[LOOK];
    taut_pattern_kept kept = {.s = NAN};
    const taut_pattern_across across = {piece, &kept};
    taut_gauss_rule(count, nodes, weights);
    *sums = (curvature_sums){.gauss = 0};
    for (int i = 0; i < cells * count && !taut_pulse_beat(pulse, cells * count * work_of_place);
         i++) {
        for (int k = 0; k < cells * count; k++) {
            const double s = (i / count + (1 + nodes[i % count]) / 2) / cells;
            const double t = (k / count + (1 + nodes[k % count]) / 2) / cells;
            double g[3], bend[2], gauss;
            taut_pattern_across_metric(&across, s, t, g);
            taut_pattern_piece_bends(piece, s, t, bend, &gauss);
            const double part = sqrt(g[0] * g[2] - g[1] * g[1]) * weights[i % count] *
                                weights[k % count] / (4 * cells * cells);
            sums->gauss += gauss * part;
            sums->size += fabs(gauss) * part;
            sums->area += part;
            sums->most = fmax(sums->most, fabs(gauss));
        }
    }
}

/* iint K dA by the border, after Gauss and Bonnet: the corners' angles less 2 pi less int k_g ds around it; just inside, as an edge may
 * lie on a knot. */
static double curvature_by_border(const taut_pattern_piece *piece, taut_pulse *pulse)
{
    double nodes[LOOK], weights[LOOK], sum = 0;
    taut_gauss_rule(LOOK, nodes, weights);
    for (int edge = 0; edge < 4; edge++) {
        const int across = edge / 2, is_far = edge % 2;
        const double at = is_far ? 1 - aside : aside;
        taut_pulse_beat(pulse, BORDER_CELLS * LOOK * work_of_place);
        for (int k = 0; k < BORDER_CELLS * LOOK; k++) {
            const double x = (k / LOOK + (1 + nodes[k % LOOK]) / 2) / BORDER_CELLS;
            double bend[2], gauss;
            taut_pattern_piece_bends(piece, across ? at : x, across ? x : at, bend, &gauss);
            sum +=
                (across == is_far ? -1 : 1) * weights[k % LOOK] / 2 / BORDER_CELLS * bend[across];
        }
        double g[3];
        taut_pattern_piece_metric(piece, across ? 1 - aside : aside, at, g);
        sum += (across == is_far ? 1 : -1) * taut_atan2(sqrt(g[0] * g[2] - g[1] * g[1]), g[1]);
    }
    return sum;
}

void taut_pattern_look_at_curvature(taut_pattern_piece *piece, taut_pulse *pulse)
{
    curvature_sums all, other;
    add_curvature(piece, LOOK, 1, pulse, &all);
    piece->curvature = all.gauss;
    piece->is_developable = all.most * all.area < flat_curvature;
    add_curvature(piece, LOOK_AGAIN, 1, pulse, &other);
    int is_rough = 0;
    for (int cells = 2; cells <= LOOK_CELLS && !piece->is_developable &&
                        fabs(other.gauss - all.gauss) > same_curvature * all.size;
         cells *= 2) { /* K that is uneven */
        other = all;
        add_curvature(piece, LOOK, cells, pulse, &all);
        piece->curvature = all.gauss;
        is_rough = fabs(other.gauss - all.gauss) > rough_curvature * all.size;
    }
    if (is_rough && !piece->bounds[TAUT_FLAT_START].is_point &&
        !piece->bounds[TAUT_FLAT_END].is_point) {
        piece->curvature = curvature_by_border(piece, pulse);
    }
}

double taut_pattern_largest_curvature(const taut_pattern_piece *piece, double at[2])
{
    double most = 0;
    at[0] = at[1] = 0;
    for (int i = 0; i <= GRID; i++) {
        for (int k = 0; k <= GRID; k++) {
            const double s = (double)i / GRID, t = (double)k / GRID;
            double bend[2], gauss = 0;
            taut_pattern_piece_bends(piece, s, t, bend, &gauss);
            if (isfinite(gauss) && fabs(gauss) > fabs(most)) {
                most = gauss;
                at[0] = s;
                at[1] = t;
            }
        }
    }
    return most;
}

/* Where a walk in the plane is. */
typedef struct place {
    double at[2], angle;
} place;

/* The integrals of the Lagrange polynomials of the nodes from -1 to each node, by the Legendre polynomials:
 * their own are (P_k+1 - P_k-1) / (2 k + 1). */
static void integrals(const double nodes[NODES], const double weights[NODES],
                      double table[NODES][NODES])
{
    double p[NODES][NODES + 2];
    for (int i = 0; i < NODES; i++) {
        p[i][0] = 1;
        p[i][1] = nodes[i];
        for (int k = 1; k <= NODES; k++) {
            p[i][k + 1] = ((2 * k + 1) * nodes[i] * p[i][k] - k * p[i][k - 1]) / (k + 1);
        }
    }
    for (int i = 0; i < NODES; i++) {
        for (int j = 0; j < NODES; j++) {
            double sum = (1 + nodes[i]) / 2;
            for (int k = 1; k < NODES; k++) {
                sum += p[j][k] * (p[i][k + 1] - p[i][k - 1]) / 2;
            }
            table[i][j] = weights[j] * sum;
        }
    }
}

typedef struct walker {
    const taut_pattern_piece *piece;
    taut_pulse *pulse;
    double nodes[NODES], weights[NODES], table[NODES][NODES];
} walker;

/* From x = from to x = to along the axis (line 0), or along the line s = const (line 1). */
static void walk(const walker *w, int line, double s, double from, double to, place *p)
{
    const double half = (to - from) / 2;
    double bend[NODES], speed[NODES], turn = 0;

    for (int i = 0; i < NODES; i++) {
        const double x = from + half * (1 + w->nodes[i]);
        double g[3], both[2], gauss;
        taut_pattern_piece_metric(w->piece, line == 0 ? x : s, line == 0 ? 0.5 : x, g);
        taut_pattern_piece_bends(w->piece, line == 0 ? x : s, line == 0 ? 0.5 : x, both, &gauss);
        bend[i] = both[line];
        speed[i] = sqrt(g[2 * line]);
    }
    for (int i = 0; i < NODES; i++) {
        double angle = p->angle;
        for (int j = 0; j < NODES; j++) {
            angle += half * w->table[i][j] * bend[j];
        }
        p->at[0] += half * w->weights[i] * speed[i] * taut_cos(angle);
        p->at[1] += half * w->weights[i] * speed[i] * taut_sin(angle);
        turn += half * w->weights[i] * bend[i];
    }
    p->angle += turn;
}

static void fill(const walker *w, const int spans[2], double *places)
{
    const int count[2] = {spans[0] + TAUT_FLAT_DEGREE, spans[1] + TAUT_FLAT_DEGREE};
    place axis = {{0, 0}, 0};
    double s = 0;

    for (int i = 0; i < count[0] && !taut_pulse_beat(w->pulse, count[1] * NODES * work_of_place);
         i++) {
        const double next = taut_flat_greville(spans[0], 0, i);
        double g[3];
        walk(w, 0, 0, s, next, &axis);
        s = next;
        taut_pattern_piece_metric(w->piece, s, 0.5, g);
        const int is_point = (i == 0 && w->piece->bounds[TAUT_FLAT_START].is_point) ||
                             (i == count[0] - 1 && w->piece->bounds[TAUT_FLAT_END].is_point);
        for (int k = 0; is_point && k < count[1]; k++) { /* and no line across */
            places[2 * (i * count[1] + k)] = axis.at[0];
            places[2 * (i * count[1] + k) + 1] = axis.at[1];
        }
        place across = axis;
        across.angle += taut_atan2(sqrt(g[0] * g[2] - g[1] * g[1]), g[1]);
        for (int way = 0; !is_point && way < 2; way++) {
            place p = across;
            double t = 0.5;
            for (int k = 0; k < count[1]; k++) {
                const int j = way == 0 ? k : count[1] - 1 - k;
                const double to = taut_flat_greville(spans[1], 0, j);
                if (way == 0 ? to >= 0.5 : to < 0.5) {
                    walk(w, 1, s, t, to, &p);
                    t = to;
                    places[2 * (i * count[1] + j)] = p.at[0];
                    places[2 * (i * count[1] + j) + 1] = p.at[1];
                }
            }
        }
    }
}

/* The largest strain, so many places of each span looked at. */
static double strain_of(const taut_pattern_piece *piece, const taut_flat *flat, int places,
                        taut_pulse *pulse)
{
    taut_pattern_kept kept = {.s = NAN};
    const taut_pattern_across across = {piece, &kept};
    const double shrink[2] = {1 - flat->warp, 1 - flat->weft};
    double most = 0;
    const int first = piece->bounds[TAUT_FLAT_START].is_point; /* at a point there is no strain */
    const int last = places * flat->spans[0] - piece->bounds[TAUT_FLAT_END].is_point;
    for (int i = first;
         i <= last && !taut_pulse_beat(pulse, (places * flat->spans[1] + 1) * work_of_place); i++) {
        for (int k = 0; k <= places * flat->spans[1]; k++) {
            const double s = (double)i / (places * flat->spans[0]);
            const double t = (double)k / (places * flat->spans[1]);
            double g[3], y[3][2], strain[2];
            taut_pattern_across_metric(&across, s, t, g);
            taut_flat_at(flat, s, t, y);
            taut_flat_strain(shrink, g, (const double(*)[2])y, strain, NULL);
            most = fmax(most, fmax(fabs(strain[0]), fabs(strain[1])));
        }
    }
    return most;
}

taut_status taut_pattern_develop(taut_pattern_piece *piece, const taut_flat_options *options,
                                 taut_arena *arena)
{
    taut_pattern_kept kept = {.s = NAN};
    const taut_pattern_across across = {piece, &kept};
    const taut_flat_strip strip = {taut_pattern_across_metric, &across, NULL};
    walker w = {.piece = piece, .pulse = options->pulse};
    double before = INFINITY;

    taut_gauss_rule(NODES, w.nodes, w.weights);
    integrals(w.nodes, w.weights, w.table);
    for (int level = 0; level <= LEVELS; level++) {
        taut_arena *scratch = taut_arena_new();
        taut_flat_options own = *options;
        own.graded = 0;
        taut_flat flat;
        own.spans[0] = LEAST << (level < LEVELS ? level : LEVELS - 1);
        own.spans[1] = own.spans[0] / (level < LEVELS ? 2 : 1);
        double *places = scratch != NULL
                             ? taut_arena_take(scratch,
                                               (size_t)(own.spans[0] + TAUT_FLAT_DEGREE) *
                                                   (size_t)(own.spans[1] + TAUT_FLAT_DEGREE),
                                               2 * sizeof(double))
                             : NULL;
        taut_status status = TAUT_NO_MEMORY;
        if (places != NULL) {
            fill(&w, own.spans, places);
            status = taut_flat_of_places(scratch, &strip, &own, places, &flat);
        }
        const double strain = status == TAUT_OK ? strain_of(piece, &flat, HALVES, w.pulse) : 0;
        if (status == TAUT_OK && strain < before / 2) { /* rounding ends it */
            status = taut_flat_copy(arena, &flat, &piece->alone);
        }
        taut_arena_free(scratch);
        if (status != TAUT_OK) {
            return status;
        }
        if (strain <= no_strain || strain > before / 2) {
            break;
        }
        before = strain;
    }
    if (before > no_strain && strain_of(piece, &piece->alone, CLAIMED, w.pulse) > claimed_strain) {
        piece->is_developable = 0; /* its metric has kinks between the knots of splines */
    }
    return TAUT_OK;
}
