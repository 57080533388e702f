#include "construct/pattern/details.h"

#include "construct/common/of.h"
#include "core/elementary/elementary.h"
#include "numeric/quadrature.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* Compensations of cloth as it is made. */
static const double usual[2] = {-0.01, 0.08};
/* Coated cloth breaks at strains of 0.15 to 0.25, and is stressed to a quarter of what breaks it. */
static const double strained = 0.05;
/* Of a seam's length: no mark is so near to its end. */
static const double mark_share = 1e-6;

enum { NODES = 8, PARTS = 4 /* of a span, looked at for extremes */ };
/* Of a length: what more cells of its spans change, so many at the most. */
static const double settled = 1e-12;
enum { CELLS_MOST = 64 };

static const char *const edge_names[TAUT_FLAT_EDGES] = {"right", "end", "left", "start"};

/* ---- lengths ---- */

/* By the rule of Gauss in so many cells of each span. */
static double length_by(const taut_curve *curve, int cells)
{
    const taut_basis *basis = taut_curve_t(curve);
    const double *breaks = taut_basis_breaks(basis);
    double nodes[NODES], weights[NODES], sum = 0;
    taut_gauss_rule(NODES, nodes, weights);
    for (int i = 0; i < taut_basis_span_count(basis) * cells; i++) {
        const double *ends = breaks + i / cells;
        const double half = (ends[1] - ends[0]) / 2 / cells;
        for (int k = 0; k < NODES; k++) {
            double y[2][3];
            taut_curve_eval(curve, ends[0] + half * (2 * (i % cells) + 1 + nodes[k]), 1, y[0]);
            sum += weights[k] * half * taut_hypot(y[1][0], y[1][1]);
        }
    }
    return sum;
}

/* Of a free edge that bends much within the few spans that it has, next to a corner say, by more of them. */
static double flat_length(const taut_curve *curve)
{
    double sum = length_by(curve, 1);
    for (int cells = 2; cells <= CELLS_MOST; cells *= 2) {
        const double finer = length_by(curve, cells);
        if (!(fabs(finer - sum) > settled * finer)) {
            break;
        }
        sum = finer;
    }
    return sum;
}

/* ---- strains ---- */

static void add_strain(const taut_pattern_piece *piece, taut_record *at)
{
    const taut_pattern_strains all = piece->strains;
    taut_record *strain = taut_record_add_object(at, "strain");
    taut_record_add_number(strain, "min", all.low);
    taut_record_add_number(strain, "max", all.high);
    taut_record_add_numbers(strain, "at", 2, all.at);
    taut_record_add_numbers(strain, "warp", 2, all.warp);
    taut_record_add_numbers(strain, "weft", 2, all.weft);
    taut_record_add_number(strain, "shear", all.shear);
}

/* ---- pieces ---- */

static void add_edges(const taut_pattern_told *told, int index, taut_record *at)
{
    static const char *const borders[] = {"u0", "u1", "v0", "v1"};
    const taut_pattern_piece *piece = &told->layout->pieces[index];
    const taut_pattern_outline *outline = &told->outlines[index];
    const taut_pattern_margin *margin = &told->margins[index];
    const int scale = told->layout->carrier->scale;
    taut_record *edges = taut_record_add_object(at, "edges");
    for (int e = 0; e < TAUT_FLAT_EDGES; e++) {
        const taut_pattern_bound *bound = &piece->bounds[e];
        taut_record *edge = taut_record_add_object(edges, edge_names[e]);
        if (taut_pattern_is_sewn(piece, e)) {
            taut_record_add_text(edge, "seam", bound->line->seam);
        }
        if (bound->border >= 0) {
            taut_record_add_text(edge, "edge", borders[bound->border]);
        }
        if (bound->line != NULL && (bound->from > 0 || bound->to < 1)) {
            const double part[2] = {bound->from, bound->to};
            taut_record_add_numbers(edge, "part", 2, part);
        }
        if (bound->line != NULL && bound->line->is_turned && bound->line->twin > bound->side) {
            taut_record_add_bool(edge, "turned",
                                 1); /* against the seam, which is told by its twin */
        }
        taut_record_add_number(edge, "length", ldexp(taut_pattern_bound_length(piece, e), scale));
        taut_record_add_number(edge, "flat_length", ldexp(flat_length(outline->edges[e]), scale));
        if (taut_pattern_is_held(told->cut, piece, e)) {
            taut_record_add_number(edge, "compensation", 1 - bound->share);
        }
        if (margin->width[e] > 0) {
            taut_record_add_number(edge, "allowance", ldexp(margin->width[e], scale));
        }
        if (margin->is_folded[e]) {
            taut_record_add_bool(edge, "hem", 1);
        }
    }
}

/* Energy over the angle that the thread is turned by: the constraint moves the middle of end across, so far times the chord. */
static double torque_of(const taut_flat *flat)
{
    double y[2][3][2];
    taut_flat_at(flat, 0, 0.5, y[0]);
    taut_flat_at(flat, 1, 0.5, y[1]);
    return flat->torque * taut_hypot(y[1][0][0] - y[0][0][0], y[1][0][1] - y[0][0][1]);
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
    if (told->layout->grounds[piece->ground].name != NULL) {
        taut_record_add_text(at, "surface", told->layout->grounds[piece->ground].name);
    }
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
    taut_record_add_number(at, "torque", ldexp(torque_of(&piece->flat), 2 * scale));
    taut_record_add_number(at, "steps", piece->alone.steps + piece->flat.steps);
    taut_record_add_bool(at, "developed", piece->is_developable && piece->flat.steps == 0);
}

/* ---- seams ---- */

static void widen(double range[2], double x)
{
    range[0] = fmin(range[0], x);
    range[1] = fmax(range[1], x);
}

/* The next place where pieces meet on a seam, beyond a share of it; 1: none. */
static double next_joint(const taut_pattern_side *seam, double share)
{
    double next = 1;
    for (int k = 0; k < seam->holder_count; k++) {
        const double at = fmax(seam->holders[k].from, seam->holders[k].to);
        next = at > share * (1 + mark_share) && at < next ? at : next;
    }
    return next;
}

/* Lengths of the surface from the start: at equal steps, and where pieces meet. */
static void add_marks(const taut_pattern_side *seam, double spacing, int scale, taut_record *at)
{
    const double length = ldexp(seam->length, scale), end = length * (1 - mark_share);
    taut_record *list = taut_record_add_list(at, "marks");
    double joint = spacing > 0 ? next_joint(seam, 0) : 1;
    for (int k = 1; joint < 1 || (spacing > 0 && k * spacing < end);) {
        const double step = k * spacing < end ? k * spacing : length;
        const int is_joint = joint * length < step * (1 + mark_share);
        taut_record_add_number(list, NULL, is_joint && joint < 1 ? joint * length : step);
        k += !(joint < 1) || step < joint * length * (1 + mark_share);
        joint = is_joint && joint < 1 ? next_joint(seam, joint) : joint;
    }
}

static const char *const kind_names[] = {"geodesic", "line", "curve", "circle"};

/* How far apart the stretches of both hands were alone. */
static double disagreement(const taut_pattern_layout *layout, const taut_pattern_side *seam)
{
    double apart = 0;
    for (int i = 0; i < seam->holder_count; i++) {
        for (int k = 0; k < seam->holder_count; k++) {
            const taut_pattern_holder *a = &seam->holders[i], *b = &seam->holders[k];
            const double from = fmax(fmin(a->from, a->to), fmin(b->from, b->to));
            const double to = fmin(fmax(a->from, a->to), fmax(b->from, b->to));
            const int count = PARTS * layout->pieces[a->piece].alone.spans[0];
            for (int n = 0; a->hand < b->hand && from < to && n <= count; n++) {
                const double x = from + (to - from) * n / count;
                const double p = taut_pattern_own_stretch(layout, seam, a, x);
                apart = fmax(apart, fabs(p - taut_pattern_own_stretch(layout, seam, b, x)));
            }
        }
    }
    return apart;
}

static void describe_seam(const taut_pattern_told *told, int index, taut_record *list)
{
    const taut_pattern_layout *layout = told->layout;
    const taut_pattern_cut *cut = told->cut;
    const taut_pattern_outline *outlines = told->outlines;
    const taut_pattern_side *seam = &layout->sides[index];
    const int scale = layout->carrier->scale;
    double stretch[2] = {INFINITY, -INFINITY}, flat = 0, closure = 0;

    taut_record *at = taut_record_add_object(list, NULL);
    taut_record_add_text(at, "name", seam->seam);
    taut_record_add_text(at, "kind",
                         seam->border >= 0 ? kind_names[TAUT_SIDE_LINE] : kind_names[seam->kind]);
    taut_record *pieces = taut_record_add_list(at, "pieces");
    for (int k = 0; k < layout->piece_count; k++) {
        int is_along = 0;
        for (int h = 0; h < seam->holder_count; h++) {
            is_along |= seam->holders[h].piece == k;
        }
        if (is_along) {
            taut_record_add_text(pieces, NULL, layout->pieces[k].name);
        }
    }
    for (int h = 0; h < seam->holder_count; h++) {
        const taut_pattern_holder *one = &seam->holders[h];
        const int count = PARTS * layout->pieces[one->piece].alone.spans[0];
        closure = fmax(closure, outlines[one->piece].closure);
        flat += one->hand == 0 ? flat_length(outlines[one->piece].edges[one->edge]) : 0;
        for (int i = 0; one->hand == 0 && i <= count; i++) {
            double speed[2];
            taut_pattern_held_speed(layout, cut, one->piece, one->edge, (double)i / count, speed);
            widen(stretch, speed[0] / (fabs(one->to - one->from) * seam->length));
        }
    }
    taut_record_add_number(at, "length", ldexp(seam->length, scale));
    taut_record_add_number(at, "flat_length", ldexp(flat, scale));
    if (cut->seam_length == TAUT_PATTERN_TRUE) {
        taut_record_add_number(at, "compensation", 1 - seam->share);
    }
    add_marks(seam, told->problem->marks.spacing, scale, at);
    taut_record_add_numbers(at, "stretch", 2, stretch);
    taut_record_add_number(at, "disagreement", disagreement(layout, seam));
    taut_record_add_number(at, "closure", ldexp(closure, scale));
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
            for (int e = 0; e < TAUT_FLAT_EDGES; e++) {
                if (taut_pattern_border_of(told->layout, k, e) == (int)hem->edge) {
                    sums[0] += taut_pattern_bound_length(&told->layout->pieces[k], e);
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
    if (a->seam > 0 || a->border > 0 || a->overlap > 0 || a->butt > 0 || a->seam_count > 0) {
        taut_record *at = taut_record_add_object(details, "allowance");
        taut_record_add_number(at, "seam", a->overlap > 0 ? 0 : a->seam);
        taut_record_add_number(at, "border", a->border);
        if (a->overlap > 0) {
            taut_record_add_number(at, "overlap", a->overlap);
            taut_record_add_bool(at, "split", a->is_split);
        }
        if (a->has_butt) {
            taut_record_add_number(at, "butt", a->butt);
        }
        taut_record_add_text(at, "corner", corners[a->corner]);
        for (int k = 0; k < a->seam_count; k++) {
            const double pair[2] = {a->seams[k].right, a->seams[k].left};
            taut_record_add_numbers(at, a->seams[k].seam, 2, pair);
        }
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

static void describe_decompensate(const taut_pattern_cut *cut, taut_record *details)
{
    static const char *const components[] = {"along", "both"};
    taut_record *list =
        cut->decompensate_count > 0 ? taut_record_add_list(details, "decompensate") : NULL;
    for (int k = 0; k < cut->decompensate_count; k++) {
        const taut_pattern_decompensate *one = &cut->decompensate[k];
        taut_record *at = taut_record_add_object(list, NULL);
        taut_record_add_text(at, "edge", taut_edge_name(one->edge));
        taut_record_add_number(at, "length", one->length);
        taut_record_add_text(at, "component", components[one->component]);
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
        const taut_nest_place *on = &roll->places[k];
        const double place[2] = {ldexp(on->at[0], scale), ldexp(on->at[1], scale)};
        taut_record *one = taut_record_add_object(list, NULL);
        taut_record_add_text(one, "name", layout->pieces[k].name);
        taut_record_add_numbers(one, "at", 2, place);
        if (on->is_turned) {
            taut_record_add_bool(one, "turned", 1);
        }
    }
}

static void describe_cloth(const taut_pattern_told *told, taut_record *details)
{
    const taut_pattern_problem *problem = told->problem;
    const taut_pattern_cut *cut = told->cut;
    const taut_pattern_material *m = &problem->cloth.material;
    taut_record *cloth = taut_record_add_object(details, "cloth");
    taut_record_add_number(cloth, "thread", cut->thread);
    if (cut->has_law) {
        taut_record *material = taut_record_add_object(cloth, "material");
        taut_record_add_numbers(material, "E", 2, m->e);
        taut_record_add_number(material, "nu", m->nu);
        taut_record_add_number(material, "G", m->g);
    }
    if (problem->cloth.shows_lower) {
        taut_record_add_text(cloth, "side", "lower");
    }
    taut_record *compensation = taut_record_add_object(details, "compensation");
    taut_record_add_number(compensation, "warp", cut->compensation.warp);
    taut_record_add_number(compensation, "weft", cut->compensation.weft);
    if (cut->compensation.has_seam &&
        cut->decompensate_count > 0) { /* it fades out along lengths */
        taut_record_add_number(compensation, "seam", cut->compensation.seam);
    }
    if (isfinite(told->bias)) {
        taut_record_add_number(details, "bias", told->bias);
    }
}

/* Where cloth that is to be stressed is compressed by more than it is cut smaller either way. */
static void add_slack(const taut_pattern_told *told, taut_record *warnings)
{
    const double c = fmax(told->cut->compensation.warp, told->cut->compensation.weft);
    for (int k = 0; c > 0 && k < told->layout->piece_count; k++) {
        const taut_pattern_strains all = told->layout->pieces[k].strains;
        char text[128];
        if (-all.low > c) {
            snprintf(text, sizeof text,
                     "slack: %s is compressed by %.6g at (%.6g, %.6g), and cut smaller by %.6g",
                     told->layout->pieces[k].name, -all.low, all.at_low[0], all.at_low[1], c);
            taut_record_add_text(warnings, NULL, text);
        }
    }
}

/* How many strips its surface is cut in. */
static int strips_beside(const taut_pattern_layout *layout, const taut_pattern_piece *piece)
{
    int count = 0;
    for (int k = 0; k < layout->piece_count; k++) {
        const taut_pattern_piece *one = &layout->pieces[k];
        const int is_new =
            k == 0 || one->strip != one[-1].strip; /* parts of a strip follow on each other */
        count += one->ground == piece->ground && is_new;
    }
    return count;
}

/* Of all pieces the one that is strained most, where that is more than cloth is made for; strains fall with the square of the number
 * of strips. */
static void add_strained(const taut_pattern_told *told, taut_record *warnings)
{
    const taut_pattern_piece *worst = NULL;
    double most = strained;
    for (int k = 0; !told->cut->is_conformal && k < told->layout->piece_count; k++) {
        const taut_pattern_piece *piece = &told->layout->pieces[k];
        const double own = fmax(piece->strains.high, -piece->strains.low);
        worst = own > most ? piece : worst;
        most = fmax(most, own);
    }
    if (worst != NULL) {
        const int count = strips_beside(told->layout, worst);
        char text[192];
        snprintf(
            text, sizeof text,
            "strain: %s is strained by %.3g at (%.4g, %.4g), more than %.2g that cloth is made "
            "for: in place of %d strip%s take about %.0f",
            worst->name, most, worst->strains.at[0], worst->strains.at[1], strained, count,
            count == 1 ? "" : "s", ceil(count * sqrt(most / strained)));
        taut_record_add_text(warnings, NULL, text);
    }
}

static void add_warnings(const taut_pattern_told *told, taut_record *details)
{
    static const char *const shares[] = {
        "compensation: the warp's is outside [-0.01, 0.08], which is unusual",
        "compensation: the weft's is outside [-0.01, 0.08], which is unusual"};
    const double c[2] = {told->cut->compensation.warp, told->cut->compensation.weft};
    taut_record *warnings = taut_record_add_list(details, "warnings");
    for (int k = 0; k < 2; k++) {
        if (!(c[k] >= usual[0]) || !(c[k] <= usual[1])) {
            taut_record_add_text(warnings, NULL, shares[k]);
        }
    }
    add_slack(told, warnings);
    add_strained(told, warnings);
}

void taut_pattern_describe(const taut_pattern_told *told, taut_record *details)
{
    const taut_pattern_layout *layout = told->layout;
    const taut_pattern_problem *problem = told->problem;
    taut_record_add_text(details, "pattern", "cloth");
    describe_cloth(told, details);
    describe_decompensate(told->cut, details);
    taut_record_add_text(details, "seam_length",
                         told->cut->seam_length == TAUT_PATTERN_TRUE ? "true" : "shared");
    if (told->cut->is_conformal) {
        taut_record_add_text(details, "flatten", "conformal");
    }
    double strain = problem->strain;
    for (int k = 0; !(problem->strain > 0) && k < problem->rule_count; k++) {
        strain = fmax(strain, problem->rules[k].strain);
    }
    if (strain > 0) {
        taut_record_add_number(details, "strain", strain);
    }
    if (told->cut->is_straight) {
        taut_record_add_text(details, "ends", "straight");
    }
    describe_allowance(&problem->allowance, details);
    describe_marks(&problem->marks, details);
    taut_record *pieces = taut_record_add_list(details, "pieces");
    for (int k = 0; k < layout->piece_count; k++) {
        describe_piece(told, k, pieces);
    }
    taut_record *seams = taut_record_add_list(details, "seams");
    for (int k = 0; k < layout->side_count; k++) {
        if (layout->sides[k].is_seam && layout->sides[k].twin < k) {
            describe_seam(told, k, seams);
        }
    }
    describe_hems(told, details);
    describe_roll(layout, told->roll, told->gap, details);
    taut_record *domain = taut_record_add_list(details, "domain");
    for (int k = 0; k < layout->side_count; k++) {
        taut_construct_add_stretch(domain, layout->sides[k].name,
                                   layout->grounds[layout->sides[k].ground].name,
                                   layout->sides[k].part.basis, layout->sides[k].part.window);
    }
    add_warnings(told, details);
}
