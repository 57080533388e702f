/* seams.c
 *
 *   cover       ends of sides that are not where they are to be: each seam is the right of one piece and the left of another
 *               one, each other side is a border of the window, and all sides run from one border of it to the opposite one
 *               (exact)
 *   on-surface  largest distance of S(t) from X(w(t)) over the size, PLACES in each span (check)
 *   geodesic    int |k_g| ds by the seam's own second derivative (check)
 *   edges       largest distance of the line that is sewn from the flat piece's own edge, over the size (check)
 *   seams       lengths of the two flat edges from their beginning to equal places of the surface, their largest difference over
 *               the length (check)
 *   lengths     of seams whose length is to be that of the surface: what they are longer by, over it (check)
 */
#include "certify/pattern/seams.h"

#include "certify/pattern/worst.h"
#include "core/vec3.h"
#include "numeric/quadrature.h"
#include "taut/measure.h"

#include <string.h>

enum { PLACES = 8, NODES = 16, STEPS = 1024, FEW = 4 };
static const double geodesic_limit = 1e-6, seam_limit = 1e-9, edge_limit = 1e-6;

/* ---- cover ---- */

/* Which border of the window a place is on exactly, from 0: u0, u1, v0, v1; -1: none. */
static int is_on(const taut_cloth *cloth, const double *at, int border)
{
    const taut_basis *basis =
        border < 2 ? taut_surface_u(cloth->surface) : taut_surface_v(cloth->surface);
    return at[border / 2] == (border % 2 == 0 ? taut_basis_lo(basis) : taut_basis_hi(basis));
}

static const double *end_of(const taut_cloth_side *side, int end)
{
    const int count = taut_basis_count(taut_curve_t(side->window));
    return taut_curve_points(side->window) + (end == 0 ? 0 : 3 * (count - 1));
}

/* All of a side on one border, exactly: its control points are. */
static int lies_on(const taut_cloth *cloth, const taut_cloth_side *side, int border)
{
    const int count = taut_basis_count(taut_curve_t(side->window));
    int all = 1;
    for (int k = 0; k < count; k++) {
        all &= is_on(cloth, taut_curve_points(side->window) + 3 * k, border);
    }
    return all;
}

static void count_wrong(taut_worst *w, int is_wrong, const char *name, double at)
{
    if (is_wrong) {
        if (w->residual == 0) {
            snprintf(w->where, sizeof w->where, "%.40s at %.6g", name, at);
        }
        w->residual += 1;
    }
}

/* The borders that all sides begin and end on: two opposite ones; 0 where there are none such. */
static int find_ends(const taut_cloth *cloth, int ends[2])
{
    for (int first = 0; first < 4; first++) {
        const int second = first ^ 1;
        int all = 1;
        for (int k = 0; k < cloth->side_count; k++) {
            all &= is_on(cloth, end_of(&cloth->sides[k], 0), first) &&
                   is_on(cloth, end_of(&cloth->sides[k], 1), second);
        }
        if (all) {
            ends[0] = first;
            ends[1] = second;
            return 1;
        }
    }
    return 0;
}

static taut_status add_cover(const taut_cloth *cloth, taut_certificate *certificate)
{
    taut_worst w = {cloth->missing, ""};
    int ends[2] = {0, 0}, borders[2] = {0, 0};

    snprintf(w.where, sizeof w.where, "%.80s", cloth->where);
    count_wrong(&w, !find_ends(cloth, ends), "sides", 0);
    for (int k = 0; k < cloth->side_count; k++) {
        const taut_cloth_side *side = &cloth->sides[k];
        const int owners = (side->owners[0] >= 0) + (side->owners[1] >= 0);
        count_wrong(&w, owners != (side->space != NULL ? 2 : 1), side->name, 0);
        for (int b = 0; side->space == NULL && b < 2; b++) {
            borders[b] += lies_on(cloth, side, 2 * (1 - ends[0] / 2) + b);
        }
    }
    count_wrong(&w, borders[0] != 1 || borders[1] != 1, "borders", 0);
    /* pieces between them stand in a row where right and left are in one order at both ends: of exact numbers */
    for (int k = 0; k < cloth->piece_count; k++) {
        const taut_cloth_piece *piece = &cloth->pieces[k];
        const int along = 1 - ends[0] / 2;
        for (int end = 0; end < 2; end++) {
            const double right = end_of(&cloth->sides[piece->sides[0]], end)[along];
            const double left = end_of(&cloth->sides[piece->sides[1]], end)[along];
            const int falls =
                ends[0] == 2 || ends[0] == 1; /* t runs towards falling u where s runs with v */
            count_wrong(&w, falls ? !(left < right) : !(left > right), piece->name, end);
        }
    }
    return taut_worst_add(&w, "cover", TAUT_EXACT, 0, certificate);
}

/* ---- on the surface ---- */

/* A place of a seam: the distance from the surface there, and k_g. 0 where it leaves the window. */
static int look_at(const taut_cloth *cloth, const taut_cloth_side *side, double t, double *away,
                   double *bend, double *speed)
{
    const taut_basis *bases[2] = {taut_surface_u(cloth->surface), taut_surface_v(cloth->surface)};
    double c[3][3], at[3], on[3][3], sideways[3], apart[3];
    taut_forms forms;

    taut_cloth_line(cloth, side->space, t, 2, c);
    taut_curve_eval(side->window, t, 0, at);
    for (int d = 0; d < 2; d++) {
        const double lo = taut_basis_lo(bases[d]), hi = taut_basis_hi(bases[d]);
        const double room = 1e-9 * (hi - lo);
        if (!(at[d] >= lo - room) || !(at[d] <= hi + room)) {
            return 0;
        }
        at[d] = fmin(fmax(at[d], lo), hi);
    }
    if (taut_surface_eval(cloth->surface, at[0], at[1], 1, on[0]) != TAUT_OK ||
        taut_surface_forms_points(cloth->surface, 1, &at[0], &at[1], 1, &forms) != TAUT_OK) {
        return 0;
    }
    taut_difference(c[0], on[0], apart);
    *away = taut_norm(apart) / cloth->size;
    *speed = taut_norm(c[1]);
    taut_cross(forms.normal, c[1], sideways);
    *bend = taut_dot(c[2], sideways) / (*speed * *speed * *speed);
    return 1;
}

static taut_status add_on_surface(const taut_cloth *cloth, taut_certificate *certificate)
{
    taut_worst distance = {0, ""}, turn = {0, ""};
    double nodes[NODES], weights[NODES];
    int any = 0;

    taut_gauss_rule(NODES, nodes, weights);
    for (int k = 0; k < cloth->side_count; k++) {
        const taut_cloth_side *side = &cloth->sides[k];
        const taut_basis *basis = side->space != NULL ? taut_curve_t(side->space) : NULL;
        double sum = 0, away = 0, bend = 0, speed = 0;
        any |= basis != NULL;
        for (int i = 0; basis != NULL && i < taut_basis_span_count(basis); i++) {
            const double a = taut_basis_breaks(basis)[i], b = taut_basis_breaks(basis)[i + 1];
            for (int q = 0; q < PLACES; q++) {
                const double t = a + (b - a) * (q + 0.5) / PLACES;
                const int is_there = look_at(cloth, side, t, &away, &bend, &speed);
                taut_worst_take(&distance, is_there ? away : INFINITY, side->name, t);
            }
            for (int q = 0; q < NODES; q++) {
                const double t = (a + b) / 2 + (b - a) / 2 * nodes[q];
                sum += look_at(cloth, side, t, &away, &bend, &speed)
                           ? weights[q] * (b - a) / 2 * fabs(bend) * speed
                           : INFINITY;
            }
        }
        if (basis != NULL) {
            taut_worst_take(&turn, sum, side->name, taut_basis_lo(basis));
        }
    }
    if (!any) {
        return TAUT_OK;
    }
    const taut_status status =
        taut_worst_add(&distance, "on-surface", TAUT_CHECK, cloth->tolerance, certificate);
    return status == TAUT_OK
               ? taut_worst_add(&turn, "geodesic", TAUT_CHECK, geodesic_limit, certificate)
               : status;
}

/* ---- flat lengths ---- */

static double length_between(const taut_cloth *cloth, const taut_curve *line, double a, double b,
                             const double *nodes, const double *weights)
{
    double y[2][3], sum = 0;
    for (int q = 0; q < FEW; q++) {
        taut_cloth_line(cloth, line, a + (b - a) * (1 + nodes[q]) / 2, 1, y);
        sum += weights[q] * (b - a) / 2 * taut_hypot(y[1][0], y[1][1]);
    }
    return sum;
}

double taut_cloth_length(const taut_cloth *cloth, const taut_curve *line)
{
    double nodes[FEW], weights[FEW], sum = 0;
    const double lo = taut_basis_lo(taut_curve_t(line)), hi = taut_basis_hi(taut_curve_t(line));
    taut_gauss_rule(FEW, nodes, weights);
    for (int k = 0; k < STEPS; k++) {
        sum += length_between(cloth, line, lo + (hi - lo) * k / STEPS,
                              lo + (hi - lo) * (k + 1) / STEPS, nodes, weights);
    }
    return sum;
}

static const taut_curve *edge_of(const taut_cloth *cloth, const taut_cloth_side *side, int which)
{
    return cloth->pieces[side->owners[which]]
        .edges[which == 0 ? TAUT_CLOTH_RIGHT : TAUT_CLOTH_LEFT];
}

static taut_status add_seams(const taut_cloth *cloth, taut_certificate *certificate)
{
    taut_worst w = {0, ""}, lengths = {0, ""};
    double nodes[FEW], weights[FEW];
    int any = 0;

    taut_gauss_rule(FEW, nodes, weights);
    for (int k = 0; k < cloth->side_count; k++) {
        const taut_cloth_side *side = &cloth->sides[k];
        double sums[2] = {0, 0}, apart = 0, at = 0;
        if (side->space == NULL || side->owners[0] < 0 || side->owners[1] < 0) {
            continue;
        }
        any = 1;
        for (int i = 0; i < STEPS; i++) {
            const double a = (double)i / STEPS, b = (double)(i + 1) / STEPS;
            for (int which = 0; which < 2; which++) {
                sums[which] +=
                    length_between(cloth, edge_of(cloth, side, which), a, b, nodes, weights);
            }
            if (!(fabs(sums[0] - sums[1]) <= apart)) {
                apart = fabs(sums[0] - sums[1]);
                at = b;
            }
        }
        taut_worst_take(&w, apart / fmax(sums[0], sums[1]), side->name, at);
        double share = cloth->warp == 0 && cloth->weft == 0 ? 1 : side->share;
        if (cloth->problem != NULL && cloth->problem->compensation.has_seam) {
            share = 1 - cloth->problem->compensation.seam;
        }
        for (int which = 0; which < 2; which++) {
            taut_worst_take(&lengths, fabs(sums[which] / (share * side->length) - 1), side->name,
                            1);
        }
    }
    if (!any) {
        return TAUT_OK;
    }
    const taut_status status = taut_worst_add(&w, "seams", TAUT_CHECK, seam_limit, certificate);
    return status == TAUT_OK && cloth->is_true
               ? taut_worst_add(&lengths, "lengths", TAUT_CHECK, seam_limit, certificate)
               : status;
}

static taut_status add_edges(const taut_cloth *cloth, taut_certificate *certificate)
{
    taut_worst w = {0, ""};
    for (int k = 0; k < cloth->piece_count; k++) {
        const taut_cloth_piece *piece = &cloth->pieces[k];
        for (int e = 0; e < TAUT_CLOTH_EDGES; e++) {
            for (int i = 0; i <= STEPS / 4; i++) {
                const double x = (double)i / (STEPS / 4);
                const int along = e == TAUT_CLOTH_RIGHT || e == TAUT_CLOTH_LEFT;
                const double fixed = e == TAUT_CLOTH_END || e == TAUT_CLOTH_LEFT;
                double y[1][3], on[3];
                taut_cloth_line(cloth, piece->edges[e], x, 0, y);
                taut_surface_eval(piece->flat, along ? x : fixed, along ? fixed : x, 0, on);
                taut_worst_take(&w, taut_distance(y[0], on) / cloth->size, piece->name, x);
            }
        }
    }
    return taut_worst_add(&w, "edges", TAUT_CHECK, edge_limit, certificate);
}

taut_status taut_cloth_add_lines(const taut_cloth *cloth, taut_certificate *certificate)
{
    taut_status status = add_cover(cloth, certificate);
    if (status == TAUT_OK) {
        status = add_on_surface(cloth, certificate);
    }
    if (status == TAUT_OK) {
        status = add_edges(cloth, certificate);
    }
    return status == TAUT_OK ? add_seams(cloth, certificate) : status;
}
