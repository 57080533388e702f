/* allowance.c
 *
 *   allowance   of places of each edge: the point at the allowance outwards lies on the line that is cut, and no place of that line is
 *               nearer; largest difference over the largest allowance of the piece. Next to corners where the line is cut short (they
 *               point inwards, are mirrored, or have more cloth along one edge than along the other) neither. With the document,
 *               allowances told that are not those asked for (check)
 */
#include "certify/pattern/allowance.h"

#include "certify/pattern/seams.h"
#include "certify/pattern/worst.h"
#include "core/elementary/elementary.h"
#include "numeric/quadrature.h"

#include <string.h>

enum { PLACES = 64, LOOK = 8 /* of a span of the line that is cut */, ROUNDS = 12, NODES = 5 };
static const double allowance_limit = 1e-6;
/* Of a piece for the pulse: operations, roughly. */
static const double work_of_piece = 2e7;
/* The share of an edge that is next to a corner; the sine of an angle that is none; and how near the line may come to a place, over its
 * distance from the next corner, as edges may meet at an angle and nothing be left along the other one. */
static const double next_to = 0.02, straight_on = 1e-5, apart = 0.4;

double taut_cloth_cut_area(const taut_cloth *cloth, const taut_cloth_piece *piece)
{
    const taut_basis *basis = taut_curve_t(piece->cut);
    const double *breaks = taut_basis_breaks(basis);
    double nodes[NODES], weights[NODES], sum = 0;
    taut_gauss_rule(NODES, nodes, weights);
    for (int i = 0; i < taut_basis_span_count(basis); i++) {
        for (int q = 0; q < NODES; q++) { /* y_1 dy_2, of degree 9 */
            const double half = (breaks[i + 1] - breaks[i]) / 2;
            double y[2][3];
            taut_cloth_line(cloth, piece->cut, breaks[i] + half * (1 + nodes[q]), 1, y);
            sum += weights[q] * half * y[0][0] * y[1][1];
        }
    }
    return sum;
}

/* The line that is cut, at many places. */
typedef struct trail {
    const taut_cloth *cloth;
    const taut_curve *curve;
    size_t count;
    double (*at)[2], *t;
} trail;

static taut_status walk(const taut_cloth *cloth, const taut_curve *curve, taut_arena *arena,
                        trail *way)
{
    const taut_basis *basis = taut_curve_t(curve);
    const double *breaks = taut_basis_breaks(basis);
    const size_t count = (size_t)taut_basis_span_count(basis) * LOOK;
    *way = (trail){cloth, curve, count, taut_arena_take(arena, count, sizeof *way->at),
                   taut_arena_take(arena, count, sizeof *way->t)};
    if (taut_arena_status(arena) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    for (size_t k = 0; k < count; k++) {
        const double a = breaks[k / LOOK], b = breaks[k / LOOK + 1];
        double y[1][3];
        way->t[k] = a + (b - a) * ((double)(k % LOOK) + 0.5) / LOOK;
        taut_cloth_line(cloth, curve, way->t[k], 0, y);
        memcpy(way->at[k], y[0], sizeof way->at[k]);
    }
    return TAUT_OK;
}

/* How far a place is from the line. */
static double distance_from(const trail *way, const double at[2])
{
    const taut_basis *basis = taut_curve_t(way->curve);
    double least = INFINITY, t = 0;
    for (size_t k = 0; k < way->count; k++) {
        const double d = taut_hypot(way->at[k][0] - at[0], way->at[k][1] - at[1]);
        t = d < least ? way->t[k] : t;
        least = fmin(least, d);
    }
    for (int round = 0; round < ROUNDS; round++) {
        double y[3][3];
        taut_cloth_line(way->cloth, way->curve, t, 2, y);
        const double gap[2] = {y[0][0] - at[0], y[0][1] - at[1]};
        const double slope = gap[0] * y[1][0] + gap[1] * y[1][1];
        const double bend =
            y[1][0] * y[1][0] + y[1][1] * y[1][1] + gap[0] * y[2][0] + gap[1] * y[2][1];
        least = fmin(least, taut_hypot(gap[0], gap[1]));
        t = fmin(fmax(t - slope / bend, taut_basis_lo(basis)), taut_basis_hi(basis));
    }
    return least;
}

/* Place and direction of an edge, the way around. */
static void edge_at(const taut_cloth *cloth, const taut_cloth_piece *piece, int e, double x,
                    double y[2][2])
{
    const int is_back = e == TAUT_CLOTH_LEFT || e == TAUT_CLOTH_START;
    double c[2][3];
    taut_cloth_line(cloth, piece->edges[e], is_back ? 1 - x : x, 1, c);
    const double length = taut_hypot(c[1][0], c[1][1]);
    for (int d = 0; d < 2; d++) {
        y[0][d] = c[0][d];
        y[1][d] = (is_back ? -1 : 1) * c[1][d] / length;
    }
}

/* Is the parallel of this edge cut short before the corner after it (which 1), or that of the next edge after it (0)? Where the corner
 * points inwards, or the parallel would end beyond the other one. */
static int is_short(const taut_cloth *cloth, const taut_cloth_piece *piece, int corner, int which)
{
    const int next = (corner + 1) % TAUT_CLOTH_EDGES;
    const double own = piece->allowance[which ? corner : next];
    const double other = piece->allowance[which ? next : corner];
    double a[2][2], b[2][2];
    edge_at(cloth, piece, corner, 1, a);
    edge_at(cloth, piece, next, 0, b);
    const double cosine = a[1][0] * b[1][0] + a[1][1] * b[1][1];
    return a[1][0] * b[1][1] - a[1][1] * b[1][0] < -straight_on || own * cosine > other;
}

/* What is left of the way from a place to the outline beyond the opposite edge, at least: next to a tip, or in narrow strips, where less is
 * left there, it may be nearer than that of the place's own edge. */
static double way_across(const taut_cloth *cloth, const taut_cloth_piece *piece, int e,
                         const double at[2])
{
    const int opposite = (e + 2) % TAUT_CLOTH_EDGES;
    const double other = ldexp(piece->allowance[opposite], -cloth->unit);
    double least = INFINITY, y[2][2];
    if (piece->is_point[opposite] || !(piece->allowance[opposite] < piece->allowance[e])) {
        return INFINITY;
    }
    for (int k = 0; k <= PLACES; k++) {
        edge_at(cloth, piece, opposite, (double)k / PLACES, y);
        least = fmin(least, taut_hypot(y[0][0] - at[0], y[0][1] - at[1]));
    }
    return other + fmax(0, least - piece->flat_lengths[opposite] / PLACES);
}

static void look_at_edge(const taut_cloth *cloth, const taut_cloth_piece *piece, int e,
                         const trail *way, double width, taut_worst *w)
{
    const double a = ldexp(piece->allowance[e], -cloth->unit);
    const taut_record *told = taut_record_get(taut_model_details(cloth->model), "allowance");
    const int mirrors = strcmp(taut_record_text(taut_record_get(told, "corner")), "mirror") == 0;
    const int cut_short[2] = {
        mirrors || is_short(cloth, piece, (e + TAUT_CLOTH_EDGES - 1) % TAUT_CLOTH_EDGES, 0),
        mirrors || is_short(cloth, piece, e, 1)};
    const double length = piece->flat_lengths[e];
    const double room = next_to + 4 * width / length;
    for (int k = 0; !piece->is_point[e] && k <= PLACES; k++) {
        const double x = (double)k / PLACES;
        double y[2][2];
        edge_at(cloth, piece, e, x, y);
        const double out[2] = {y[0][0] + a * y[1][1], y[0][1] - a * y[1][0]};
        const int is_near = (cut_short[0] && x < room) || (cut_short[1] && x > 1 - room);
        if (!is_near) {
            taut_worst_take(w, distance_from(way, out) / width, piece->name, e + x);
        }
        if (x > 0 && x < 1 && !is_near) { /* the line may not come nearer */
            const double near =
                fmin(fmin(a, apart * fmin(x, 1 - x) * length), way_across(cloth, piece, e, y[0]));
            taut_worst_take(w, (near - distance_from(way, y[0])) / width, piece->name, e + x);
        }
    }
}

/* What is asked for along a seam of its own, on this side of it; else `asked`. The seam is the later surface's where two meet on it, and
 * its pieces are all on one side. */
static double of_seam(const taut_cloth *cloth, const taut_cloth_piece *piece, int e, double asked)
{
    const taut_pattern_allowance *a = &cloth->problem->allowance;
    const taut_cloth_side *side = &cloth->sides[piece->sides[e]];
    int is_right = taut_cloth_hand(e);
    for (int k = 0; side->mate > piece->sides[e] && k < cloth->piece_count; k++) {
        for (int other = 0; other < TAUT_CLOTH_EDGES; other++) {
            if (cloth->pieces[k].sides[other] == side->mate) {
                is_right = !taut_cloth_hand(other);
            }
        }
    }
    for (int k = 0; k < a->seam_count; k++) {
        if (side->seam != NULL && strcmp(a->seams[k].seam, side->seam) == 0) {
            return is_right ? a->seams[k].right : a->seams[k].left;
        }
    }
    return asked;
}

/* Is what is told to be left along an edge what was asked for? */
static int is_asked(const taut_cloth *cloth, int index, int e)
{
    const taut_pattern_problem *p = cloth->problem;
    const taut_cloth_piece *piece = &cloth->pieces[index];
    if (piece->is_point[e]) { /* a tip, cut square */
        return piece->allowance[e] ==
               fmax(piece->allowance[TAUT_CLOTH_RIGHT], piece->allowance[TAUT_CLOTH_LEFT]);
    }
    double asked = piece->border[e] < 0 ? p->allowance.seam : p->allowance.border;
    if (piece->border[e] < 0 && p->allowance.overlap > 0) {
        asked = p->allowance.is_split ? p->allowance.overlap / 2
                                      : p->allowance.overlap * (index % 2 == 0);
    }
    if (piece->border[e] < 0 && p->allowance.has_butt &&
        (e == TAUT_CLOTH_START || e == TAUT_CLOTH_END)) {
        asked = p->allowance.butt;
    }
    if (piece->border[e] < 0 && piece->sides[e] >= 0) {
        asked = of_seam(cloth, piece, e, asked);
    }
    for (int k = 0; k < p->hem_count; k++) {
        if ((int)p->hems[k].edge == piece->border[e]) {
            asked = 2 * p->hems[k].pocket + p->allowance.seam;
        }
    }
    return fabs(asked - piece->allowance[e]) <= 1e-12 * asked;
}

taut_status taut_cloth_add_allowance(const taut_cloth *cloth, taut_arena *arena,
                                     taut_certificate *certificate)
{
    taut_worst w = {0, ""};
    int any = 0;
    for (int k = 0; k < cloth->piece_count; k++) {
        const taut_cloth_piece *piece = &cloth->pieces[k];
        double width = 0;
        trail way;
        for (int e = 0; e < TAUT_CLOTH_EDGES; e++) {
            width = fmax(width, ldexp(piece->allowance[e], -cloth->unit));
            if (cloth->problem != NULL && !is_asked(cloth, k, e)) {
                taut_worst_take(&w, INFINITY, piece->name, e);
                any = 1;
            }
        }
        if (!(width > 0)) {
            continue;
        }
        any = 1;
        if (walk(cloth, piece->cut, arena, &way) != TAUT_OK) {
            return TAUT_NO_MEMORY;
        }
        for (int e = 0; e < TAUT_CLOTH_EDGES; e++) {
            look_at_edge(cloth, piece, e, &way, width, &w);
        }
        if (taut_crew_beat(cloth->crew, work_of_piece)) {
            return TAUT_INTERRUPTED;
        }
    }
    return any ? taut_worst_add(&w, "allowance", TAUT_CHECK, allowance_limit, certificate)
               : TAUT_OK;
}
