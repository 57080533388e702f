#include "construct/pattern/details.h"

#include "construct/common/of.h"
#include "construct/pattern/strains.h"
#include "core/elementary/elementary.h"
#include "numeric/quadrature.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* Compensations of cloth as it is made. */
static const double usual[2] = {-0.01, 0.08};
/* Of a seam's length: no mark is so near to its end. */
static const double mark_share = 1e-6;

enum { NODES = 8, PARTS = 4 /* of a span, looked at for extremes */, CELLS = 16 };

static const char *const edge_names[TAUT_FLAT_EDGES] = {"right", "end", "left", "start"};

/* ---- lengths ---- */

static double flat_length(const taut_curve *curve)
{
    const taut_basis *basis = taut_curve_t(curve);
    const double *breaks = taut_basis_breaks(basis);
    double nodes[NODES], weights[NODES], sum = 0;
    taut_gauss_rule(NODES, nodes, weights);
    for (int i = 0; i < taut_basis_span_count(basis); i++) {
        const double half = (breaks[i + 1] - breaks[i]) / 2;
        for (int k = 0; k < NODES; k++) {
            double y[2][3];
            taut_curve_eval(curve, breaks[i] + half * (1 + nodes[k]), 1, y[0]);
            sum += weights[k] * half * taut_hypot(y[1][0], y[1][1]);
        }
    }
    return sum;
}

/* Of start (s = 0) or end (s = 1) on the surface. */
static double across_length(const taut_pattern_piece *piece, double s)
{
    double nodes[NODES], weights[NODES], sum = 0;
    taut_gauss_rule(NODES, nodes, weights);
    for (int i = 0; i < CELLS * NODES; i++) {
        double g[3];
        const double t = (i / NODES + (1 + nodes[i % NODES]) / 2) / CELLS;
        taut_pattern_piece_metric(piece, s, t, g);
        sum += weights[i % NODES] / (2 * CELLS) * sqrt(g[2]);
    }
    return sum;
}

/* ---- strains ---- */

static void add_strain(const taut_pattern_piece *piece, taut_record *at)
{
    const taut_pattern_strains all = taut_pattern_strains_of(piece);
    taut_record *strain = taut_record_add_object(at, "strain");
    taut_record_add_number(strain, "min", all.low);
    taut_record_add_number(strain, "max", all.high);
    taut_record_add_numbers(strain, "at", 2, all.at);
    taut_record_add_numbers(strain, "warp", 2, all.warp);
    taut_record_add_numbers(strain, "weft", 2, all.weft);
    taut_record_add_number(strain, "shear", all.shear);
}

/* ---- pieces ---- */

static const taut_pattern_side *side_of(const taut_pattern_piece *piece, int edge)
{
    return edge == TAUT_FLAT_RIGHT  ? piece->edge[TAUT_PIECE_RIGHT]
           : edge == TAUT_FLAT_LEFT ? piece->edge[TAUT_PIECE_LEFT]
                                    : NULL;
}

static void add_edges(const taut_pattern_told *told, int index, taut_record *at)
{
    const taut_edge *ends = told->problem->rules[0].edges;
    const taut_pattern_piece *piece = &told->layout->pieces[index];
    const taut_pattern_outline *outline = &told->outlines[index];
    const taut_pattern_margin *margin = &told->margins[index];
    const int scale = told->layout->carrier->scale;
    taut_record *edges = taut_record_add_object(at, "edges");
    for (int e = 0; e < TAUT_FLAT_EDGES; e++) {
        const taut_pattern_side *side = side_of(piece, e);
        taut_record *edge = taut_record_add_object(edges, edge_names[e]);
        const double length =
            side != NULL ? side->length : across_length(piece, e == TAUT_FLAT_END);
        taut_record_add_text(edge, side != NULL && side->is_seam ? "seam" : "edge",
                             side != NULL ? side->name : taut_edge_name(ends[e == TAUT_FLAT_END]));
        taut_record_add_number(edge, "length", ldexp(length, scale));
        taut_record_add_number(edge, "flat_length", ldexp(flat_length(outline->edges[e]), scale));
        if (margin->width[e] > 0) {
            taut_record_add_number(edge, "allowance", ldexp(margin->width[e], scale));
        }
        if (margin->is_folded[e]) {
            taut_record_add_bool(edge, "hem", 1);
        }
    }
}

static void describe_piece(const taut_pattern_told *told, int index, taut_record *list)
{
    const taut_pattern_piece *piece = &told->layout->pieces[index];
    const taut_pattern_outline *outline = &told->outlines[index];
    const int scale = told->layout->carrier->scale;
    const double extent[2] = {ldexp(outline->high[0] - outline->low[0], scale),
                              ldexp(outline->high[1] - outline->low[1], scale)};
    double y[2][3][2];
    taut_record *at = taut_record_add_object(list, NULL);

    taut_record_add_text(at, "name", piece->name);
    add_edges(told, index, at);
    taut_record *alone = taut_record_add_object(at, "alone");
    for (int e = 0; e < TAUT_FLAT_EDGES; e++) {
        taut_record_add_number(alone, edge_names[e],
                               ldexp(flat_length(piece->alone_edges[e]), scale));
    }
    taut_record_add_number(alone, "flat_area", ldexp(piece->alone.flat_area, 2 * scale));
    taut_record_add_number(alone, "energy", ldexp(piece->alone.energy, 2 * scale));
    taut_record_add_number(at, "area", ldexp(piece->flat.area, 2 * scale));
    taut_record_add_number(at, "flat_area", ldexp(piece->flat.flat_area, 2 * scale));
    taut_record_add_number(at, "cut_area", ldexp(outline->area, 2 * scale));
    taut_record_add_number(at, "curvature", piece->curvature);
    taut_record_add_numbers(at, "extent", 2, extent);
    taut_flat_at(&piece->flat, 0.5, 0, y[0]);
    taut_flat_at(&piece->flat, 0.5, 1, y[1]);
    taut_record_add_number(
        at, "width_middle",
        ldexp(taut_hypot(y[1][0][0] - y[0][0][0], y[1][0][1] - y[0][0][1]), scale));
    add_strain(piece, at);
    taut_record_add_number(at, "energy", ldexp(piece->flat.energy, 2 * scale));
    taut_record_add_number(at, "torque", ldexp(piece->flat.torque, 2 * scale));
    taut_record_add_number(at, "steps", piece->alone.steps + piece->flat.steps);
    taut_record_add_bool(at, "developed", piece->is_developable && piece->flat.steps == 0);
}

/* ---- seams ---- */

static void widen(double range[2], double x)
{
    range[0] = fmin(range[0], x);
    range[1] = fmax(range[1], x);
}

/* Lengths of the surface from the start. */
static void add_marks(const taut_pattern_side *seam, double spacing, int scale, taut_record *at)
{
    const double length = ldexp(seam->length, scale);
    taut_record *list = taut_record_add_list(at, "marks");
    for (int k = 1; spacing > 0 && k * spacing < length * (1 - mark_share); k++) {
        taut_record_add_number(list, NULL, k * spacing);
    }
}

static void describe_seam(const taut_pattern_told *told, int index, taut_record *list)
{
    const taut_pattern_layout *layout = told->layout;
    const taut_pattern_cut *cut = told->cut;
    const taut_pattern_outline *outlines = told->outlines;
    const taut_pattern_side *seam = &layout->sides[index];
    const int right = seam->owners[TAUT_PIECE_RIGHT], left = seam->owners[TAUT_PIECE_LEFT];
    const int scale = layout->carrier->scale, count = PARTS * layout->pieces[right].alone.spans[0];
    double stretch[2] = {INFINITY, -INFINITY}, apart = 0;

    for (int i = 0; i <= count; i++) {
        const double s = (double)i / count;
        double speed[2], y[2][2][3];
        taut_pattern_held_speed(layout, cut, right, TAUT_PIECE_RIGHT, s, speed);
        widen(stretch, speed[0] / seam->length);
        taut_curve_eval(layout->pieces[right].alone_edges[TAUT_FLAT_RIGHT], s, 1, y[0][0]);
        taut_curve_eval(layout->pieces[left].alone_edges[TAUT_FLAT_LEFT], s, 1, y[1][0]);
        apart = fmax(apart,
                     fabs(taut_hypot(y[0][1][0], y[0][1][1]) - taut_hypot(y[1][1][0], y[1][1][1])) /
                         seam->length);
    }
    taut_record *at = taut_record_add_object(list, NULL);
    taut_record_add_text(at, "name", seam->name);
    taut_record *pieces = taut_record_add_list(at, "pieces");
    taut_record_add_text(pieces, NULL, layout->pieces[right < left ? right : left].name);
    taut_record_add_text(pieces, NULL, layout->pieces[right < left ? left : right].name);
    taut_record_add_number(at, "length", ldexp(seam->length, scale));
    taut_record_add_number(at, "flat_length",
                           ldexp(flat_length(outlines[right].edges[TAUT_FLAT_RIGHT]), scale));
    if (cut->seam_length == TAUT_PATTERN_TRUE) {
        taut_record_add_number(at, "compensation", 1 - seam->share);
    }
    add_marks(seam, told->problem->marks.spacing, scale, at);
    taut_record_add_numbers(at, "stretch", 2, stretch);
    taut_record_add_number(at, "disagreement", apart);
    taut_record_add_number(at, "closure",
                           ldexp(fmax(outlines[right].closure, outlines[left].closure), scale));
}

/* ---- the whole ---- */

/* Edges that are folded over, the pieces along them together. */
static void describe_hems(const taut_pattern_told *told, taut_record *details)
{
    const int scale = told->layout->carrier->scale;
    taut_record *list = taut_record_add_list(details, "hems");
    for (int h = 0; h < told->problem->hem_count; h++) {
        const taut_pattern_hem *hem = &told->problem->hems[h];
        taut_record *at = taut_record_add_object(list, NULL);
        double sums[2] = {0, 0};
        for (int k = 0; k < told->layout->piece_count; k++) {
            const taut_pattern_piece *piece = &told->layout->pieces[k];
            for (int e = 0; e < TAUT_FLAT_EDGES; e++) {
                const taut_pattern_side *side = side_of(piece, e);
                if (taut_pattern_border_of(told->problem, told->layout, k, e) == (int)hem->edge) {
                    sums[0] +=
                        side != NULL ? side->length : across_length(piece, e == TAUT_FLAT_END);
                    sums[1] += flat_length(told->outlines[k].edges[e]);
                }
            }
        }
        taut_record_add_text(at, "edge", taut_edge_name(hem->edge));
        taut_record_add_number(at, "pocket", hem->pocket);
        taut_record_add_number(at, "length", ldexp(sums[0], scale));
        taut_record_add_number(at, "flat_length", ldexp(sums[1], scale));
    }
}

static void describe_allowance(const taut_pattern_allowance *a, taut_record *details)
{
    static const char *const corners[] = {"mitre", "square", "mirror"};
    if (a->seam > 0 || a->border > 0 || a->overlap > 0) {
        taut_record *at = taut_record_add_object(details, "allowance");
        taut_record_add_number(at, "seam", a->overlap > 0 ? 0 : a->seam);
        taut_record_add_number(at, "border", a->border);
        if (a->overlap > 0) {
            taut_record_add_number(at, "overlap", a->overlap);
            taut_record_add_bool(at, "split", a->is_split);
        }
        taut_record_add_text(at, "corner", corners[a->corner]);
    }
}

static void describe_marks(const taut_pattern_marks *marks, taut_record *details)
{
    static const char *const notches[] = {"slit", "v", "dot"};
    if (marks->spacing > 0) {
        taut_record *at = taut_record_add_object(details, "marks");
        taut_record_add_number(at, "spacing", marks->spacing);
        taut_record_add_text(at, "notch", notches[marks->notch]);
    }
}

static void describe_roll(const taut_pattern_layout *layout, const taut_pattern_roll *roll,
                          double gap, taut_record *details)
{
    const int scale = layout->carrier->scale;
    taut_record *at = taut_record_add_object(details, "roll");
    taut_record_add_number(at, "width", ldexp(roll->size[1], scale));
    taut_record_add_number(at, "length", ldexp(roll->size[0], scale));
    taut_record_add_number(at, "gap", gap);
    taut_record_add_number(at, "waste", roll->waste);
    taut_record *list = taut_record_add_list(at, "pieces");
    for (int k = 0; k < layout->piece_count; k++) {
        const double place[2] = {ldexp(roll->at[k][0], scale), ldexp(roll->at[k][1], scale)};
        taut_record *one = taut_record_add_object(list, NULL);
        taut_record_add_text(one, "name", layout->pieces[k].name);
        taut_record_add_numbers(one, "at", 2, place);
    }
}

static void describe_cloth(const taut_pattern_problem *problem, const taut_pattern_cut *cut,
                           taut_record *details)
{
    const taut_pattern_material *m = &problem->cloth.material;
    taut_record *cloth = taut_record_add_object(details, "cloth");
    taut_record_add_number(cloth, "thread", cut->thread);
    if (cut->has_law) {
        taut_record *material = taut_record_add_object(cloth, "material");
        taut_record_add_numbers(material, "E", 2, m->e);
        taut_record_add_number(material, "nu", m->nu);
        taut_record_add_number(material, "G", m->g);
    }
    taut_record *compensation = taut_record_add_object(details, "compensation");
    taut_record_add_number(compensation, "warp", cut->compensation.warp);
    taut_record_add_number(compensation, "weft", cut->compensation.weft);
}

/* Where cloth that is to be stressed is compressed by more than it is cut smaller either way. */
static void add_slack(const taut_pattern_told *told, taut_record *warnings)
{
    const double c = fmax(told->cut->compensation.warp, told->cut->compensation.weft);
    for (int k = 0; c > 0 && k < told->layout->piece_count; k++) {
        const taut_pattern_strains all = taut_pattern_strains_of(&told->layout->pieces[k]);
        char text[128];
        if (-all.low > c) {
            snprintf(text, sizeof text,
                     "slack: %s is compressed by %.6g at (%.6g, %.6g), and cut smaller by %.6g",
                     told->layout->pieces[k].name, -all.low, all.at_low[0], all.at_low[1], c);
            taut_record_add_text(warnings, NULL, text);
        }
    }
}

static void add_warnings(const taut_pattern_told *told, taut_record *details)
{
    static const char *const rings[] = {"ring: u0 and u1 are one line of the surface, and the "
                                        "edges cut along it are not made equal",
                                        "ring: v0 and v1 are one line of the surface, and the "
                                        "edges cut along it are not made equal"};
    static const char *const shares[] = {
        "compensation: the warp's is outside [-0.01, 0.08], which is unusual",
        "compensation: the weft's is outside [-0.01, 0.08], which is unusual"};
    const double c[2] = {told->cut->compensation.warp, told->cut->compensation.weft};
    taut_record *warnings = taut_record_add_list(details, "warnings");
    for (int k = 0; k < 2; k++) {
        if (told->is_ring[k]) {
            taut_record_add_text(warnings, NULL, rings[k]);
        }
    }
    for (int k = 0; k < 2; k++) {
        if (!(c[k] >= usual[0]) || !(c[k] <= usual[1])) {
            taut_record_add_text(warnings, NULL, shares[k]);
        }
    }
    add_slack(told, warnings);
}

void taut_pattern_describe(const taut_pattern_told *told, taut_record *details)
{
    const taut_pattern_layout *layout = told->layout;
    const taut_pattern_problem *problem = told->problem;
    taut_record_add_text(details, "pattern", "cloth");
    describe_cloth(problem, told->cut, details);
    taut_record_add_text(details, "seam_length",
                         told->cut->seam_length == TAUT_PATTERN_TRUE ? "true" : "shared");
    const double strain = problem->strain > 0 ? problem->strain : problem->rules[0].strain;
    if (strain > 0) {
        taut_record_add_number(details, "strain", strain);
    }
    describe_allowance(&problem->allowance, details);
    describe_marks(&problem->marks, details);
    taut_record *pieces = taut_record_add_list(details, "pieces");
    for (int k = 0; k < layout->piece_count; k++) {
        describe_piece(told, k, pieces);
    }
    taut_record *seams = taut_record_add_list(details, "seams");
    for (int k = 0; k < layout->side_count; k++) {
        if (layout->sides[k].is_seam) {
            describe_seam(told, k, seams);
        }
    }
    describe_hems(told, details);
    describe_roll(layout, told->roll, told->gap, details);
    taut_record *domain = taut_record_add_list(details, "domain");
    for (int k = 0; k < layout->side_count; k++) {
        taut_construct_add_stretch(domain, layout->sides[k].name, NULL, layout->sides[k].part.basis,
                                   layout->sides[k].part.window);
    }
    add_warnings(told, details);
}
