/* area.c
 *
 *     iint sqrt(det G) ds dt by eight places of Gauss in each of so many cells each way, twice as many until the sum hardly changes
 *     where it still does: cells that end at the knots of the surface too, across which its metric has kinks
 *         along s where right or left cross one; along t, at each s, where the line across does
 *
 * A line of knots comes into a piece and leaves it at its sides, so that the inner integral is smooth along s but for what is said below.
 */
#include "certify/pattern/area.h"

#include "certify/pattern/worst.h"
#include "core/vec3.h"
#include "numeric/quadrature.h"
#include "taut/measure.h"

#include <stdlib.h>
#include <string.h>

static const double area_limit = 1e-10, area_error_most = 1e-6, area_doubt = 1e-11;
/* Knots of the surface run across cells anyhow, so that two sums may be nearer to each other than to the area. */
static const double area_share = 4;
/* Cells of a piece each way, at first and at the most; between knots. */
enum { CELLS = 2, CELLS_MOST = 16, KNOT_CELLS_MOST = 8, NODES = 8 };
enum { WHOLE_CELLS_MOST = 16384 }; /* of a surface */
/* A line is looked at in so many parts, and has so many breaks at the most. */
enum { PARTS = 16, BREAKS = 600, ROUNDS = 80 };
/* Operations, about, of a place. */
static const double work_of_place = 4e3;

typedef struct rule {
    double nodes[NODES], weights[NODES];
} rule;

static double element(const double g[3])
{
    return sqrt(g[0] * g[2] - g[1] * g[1]);
}

static double area_of(const taut_cloth *cloth, const taut_cloth_piece *piece, int cells)
{
    rule r;
    double sum = 0;
    taut_gauss_rule(NODES, r.nodes, r.weights);
    for (int i = 0;
         i < cells * NODES && !taut_crew_beat(cloth->crew, cells * NODES * work_of_place); i++) {
        const double s = (i / NODES + (1 + r.nodes[i % NODES]) / 2) / cells;
        taut_cloth_across across;
        taut_cloth_across_at(cloth, piece, s, 1, &across);
        for (int k = 0; k < cells * NODES; k++) {
            const double t = (k / NODES + (1 + r.nodes[k % NODES]) / 2) / cells;
            double g[3];
            sum += taut_cloth_metric_on(cloth, &across, t, g)
                       ? r.weights[i % NODES] * r.weights[k % NODES] / (4.0 * cells * cells) *
                             element(g)
                       : (double)NAN;
        }
    }
    return sum;
}

/* ---- between knots ---- */

/* A line of the window: right or left over s, or the line across at an s, over t. */
typedef struct line {
    const taut_cloth *cloth;
    const taut_cloth_piece *piece;
    const taut_cloth_across *across; /* NULL: a side */
    int is_left;
} line;

static double line_at(const line *l, double x, int d)
{
    double w[3][2] = {{NAN, NAN}};
    taut_cloth_across across;
    if (l->across != NULL) {
        taut_cloth_window_on(l->cloth, l->across, x, w);
        return w[0][d];
    }
    taut_cloth_across_at(l->cloth, l->piece, x, 0, &across);
    return across.sides[l->is_left][0][d];
}

/* Where a coordinate is a knot between two places that it is to both sides of. */
static double crossing(const line *l, int d, double knot, double a, double b)
{
    double at[2] = {a, b}, off[2] = {line_at(l, a, d) - knot, line_at(l, b, d) - knot};
    int last = -1;
    for (int round = 0; round < ROUNDS && at[1] - at[0] > 1e-15; round++) { /* regula falsi */
        const double x = at[0] + (at[1] - at[0]) * off[0] / (off[0] - off[1]);
        const double f = line_at(l, x, d) - knot;
        const int side = f * off[1] > 0;
        if (f == 0 || !(x > at[0]) || !(x < at[1])) {
            return x;
        }
        off[!side] /= side == last ? 2 : 1; /* of Illinois */
        at[side] = x;
        off[side] = f;
        last = side;
    }
    return (at[0] + at[1]) / 2;
}

/* Adds where a line crosses knots. */
static void add_crossings(const line *l, double breaks[BREAKS], int *count)
{
    const taut_basis *bases[2] = {taut_surface_u(l->piece->on), taut_surface_v(l->piece->on)};
    for (int d = 0; d < 2; d++) {
        const double *knots = taut_basis_breaks(bases[d]);
        double before = line_at(l, 0, d);
        for (int i = 0; i < PARTS; i++) {
            const double a = (double)i / PARTS, b = (double)(i + 1) / PARTS;
            const double after = line_at(l, b, d);
            for (int k = 1; k < taut_basis_span_count(bases[d]); k++) {
                const double off[2] = {before - knots[k], after - knots[k]};
                if ((off[0] * off[1] < 0 || off[1] == 0) && *count < BREAKS - 2) {
                    breaks[(*count)++] = off[1] == 0 ? b : crossing(l, d, knots[k], a, b);
                }
            }
            before = after;
        }
    }
}

static int by_value(const void *a, const void *b)
{
    const double p = *(const double *)a, q = *(const double *)b;
    return (p > q) - (p < q);
}

/* From 0 to 1 in order. */
static int close_breaks(double breaks[BREAKS], int count)
{
    breaks[count++] = 0;
    qsort(breaks, (size_t)count, sizeof *breaks, by_value);
    breaks[count++] = 1;
    return count;
}

/* What a line across adds at a place, over its length in t. */
static double place_on(const taut_cloth *cloth, const taut_cloth_across *across, double t)
{
    double g[3];
    return taut_cloth_metric_on(cloth, across, t, g) ? element(g) : (double)NAN;
}

static double across_of(const taut_cloth *cloth, const taut_cloth_piece *piece, double s, int cells,
                        const rule *r)
{
    taut_cloth_across across;
    double breaks[BREAKS], sum = 0;
    int count = 0;
    taut_cloth_across_at(cloth, piece, s, 1, &across);
    const line own = {cloth, piece, &across, 0};
    add_crossings(&own, breaks, &count);
    count = close_breaks(breaks, count);
    for (int k = 0; k + 1 < count; k++) {
        const double width = breaks[k + 1] - breaks[k];
        const int parts = 1 + (int)(cells * width);
        for (int q = 0; width > 0 && q < parts * NODES; q++) {
            const double x = (q / NODES + (1 + r->nodes[q % NODES]) / 2) / parts;
            sum += r->weights[q % NODES] / 2 * width / parts *
                   place_on(cloth, &across, breaks[k] + x * width);
        }
    }
    return sum;
}

/* So many cells along s between any two breaks: where lines of knots cross inside the piece the inner integral has a third derivative
 * that jumps, and these places are not looked for. */
static double area_between_knots(const taut_cloth *cloth, const taut_cloth_piece *piece, int cells)
{
    rule r;
    double breaks[BREAKS], sum = 0;
    int count = 0;
    taut_gauss_rule(NODES, r.nodes, r.weights);
    for (int side = 0; side < 2; side++) {
        const line own = {cloth, piece, NULL, side};
        add_crossings(&own, breaks, &count);
    }
    count = close_breaks(breaks, count);
    for (int k = 0; k + 1 < count; k++) {
        const double width = breaks[k + 1] - breaks[k];
        for (int q = 0; width > 0 && q < cells * NODES &&
                        !taut_crew_beat(cloth->crew, cells * NODES * work_of_place);
             q++) {
            const double x = (q / NODES + (1 + r.nodes[q % NODES]) / 2) / cells;
            sum += r.weights[q % NODES] / 2 * width / cells *
                   across_of(cloth, piece, breaks[k] + x * width, cells, &r);
        }
    }
    return sum;
}

/* ---- the whole ---- */

/* Of a surface by so many cells between any two knots. */
static double area_of_surface(const taut_surface *surface, int cells, const taut_crew *crew)
{
    const taut_basis *u = taut_surface_u(surface), *v = taut_surface_v(surface);
    const double *a = taut_basis_breaks(u), *b = taut_basis_breaks(v);
    const int rows = taut_basis_span_count(u) * cells * NODES;
    const int columns = taut_basis_span_count(v) * cells * NODES;
    rule r;
    double sum = 0;
    taut_gauss_rule(NODES, r.nodes, r.weights);
    for (int i = 0; i < rows && !taut_crew_beat(crew, columns * work_of_place); i++) {
        const int cell = i / NODES, span = cell / cells;
        const double width = (a[span + 1] - a[span]) / cells;
        const double at = a[span] + (cell % cells + (1 + r.nodes[i % NODES]) / 2) * width;
        double row = 0;
        for (int k = 0; k < columns; k++) {
            const int part = k / NODES, knot = part / cells;
            const double height = (b[knot + 1] - b[knot]) / cells;
            const double y = b[knot] + (part % cells + (1 + r.nodes[k % NODES]) / 2) * height;
            double x[3][3];
            const int is_there = taut_surface_eval(surface, at, y, 1, x[0]) == TAUT_OK;
            const double g[3] = {taut_dot(x[1], x[1]), taut_dot(x[1], x[2]), taut_dot(x[2], x[2])};
            row += is_there ? r.weights[k % NODES] / 2 * height * element(g) : (double)NAN;
        }
        sum += r.weights[i % NODES] / 2 * width * row;
    }
    return sum;
}

/* That of taut_surface_area, unless control points that are far larger than the surface leave it less exact than pieces are: then by
 * places of it, of which rounding is that of values. */
static taut_status whole_of(const taut_surface *surface, const taut_crew *crew, double *area)
{
    const double spans = (double)taut_basis_span_count(taut_surface_u(surface)) *
                         taut_basis_span_count(taut_surface_v(surface));
    double error = 0;
    if (taut_surface_area(surface, area, &error) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    if (error > area_doubt * *area) {
        double before = area_of_surface(surface, 1, crew), apart = INFINITY;
        for (int cells = 2; spans * cells * cells <= WHOLE_CELLS_MOST && apart > area_doubt;
             cells *= 2) {
            const double after = area_of_surface(surface, cells, crew);
            apart = fabs(after - before) / after;
            before = after;
        }
        *area = apart * *area < error ? before : *area;
    }
    return TAUT_OK;
}

typedef double measure(const taut_cloth *cloth, const taut_cloth_piece *piece, int cells);

/* Of all pieces, with twice as many cells until it hardly changes; *doubt: by how much it did, over the whole. */
static double sum_of(const taut_cloth *cloth, measure *of, int first, int most, double whole,
                     double *doubt)
{
    double sum = 0;
    *doubt = INFINITY;
    for (int cells = 2 * first; cells <= most && *doubt > area_doubt; cells *= 2) {
        sum = *doubt = 0;
        for (int k = 0; k < cloth->piece_count; k++) {
            const double fine = of(cloth, &cloth->pieces[k], cells);
            *doubt += fabs(fine - of(cloth, &cloth->pieces[k], cells / 2)) / whole;
            sum += fine;
        }
    }
    return sum;
}

taut_status taut_cloth_add_exhausts(const taut_cloth *cloth, double *area,
                                    taut_certificate *certificate)
{
    double whole = 0, doubt = 0;
    taut_worst w = {0, "the whole"};

    for (int k = 0; k < cloth->surface_count; k++) {
        double one = 0;
        if (whole_of(cloth->surfaces[k], cloth->crew, &one) != TAUT_OK) {
            return TAUT_NO_MEMORY;
        }
        whole += one;
    }
    *area = sum_of(cloth, area_of, CELLS, CELLS_MOST, whole, &doubt);
    if (area_share * doubt > area_limit) {
        double other = 0;
        const double sum = sum_of(cloth, area_between_knots, 1, KNOT_CELLS_MOST, whole, &other);
        *area = other < doubt ? sum : *area;
        doubt = fmin(doubt, other);
    }
    w.residual = fabs(*area - whole) / whole;
    return taut_worst_add(&w, "exhausts", TAUT_CHECK,
                          fmin(fmax(area_limit, area_share * doubt), area_error_most), certificate);
}
