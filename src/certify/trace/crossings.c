/* crossings.c
 *
 *     the angle of the two tangents; of -K = tau^2, H by the forms at the node
 *     at height h a lath that stands goes along T + h n', n' = -k_n T - tau S: the acute angle of the two there
 */
#include "certify/trace/crossings.h"

#include "certify/common/verdict.h"
#include "core/elementary/elementary.h"
#include "core/unit.h"
#include "core/vec3.h"

#include <string.h>

enum { HEIGHTS = 16 };
/* Below, what an angle is off is good enough. */
static const double angle_limit = 1e-6;
/* Of slots, unless the document says otherwise, in mm. */
static const double play_default = 0.2;

const taut_record *taut_net_nodes_of(const taut_net_audit *audit)
{
    return taut_record_get(taut_model_details(audit->lines->model), "nodes");
}

int taut_net_spots_of_node(const taut_net_audit *audit, const taut_record *node,
                           taut_net_spot spots[2])
{
    const taut_net_line *both[2];
    int is_found = taut_net_lines_of_node(audit->lines, taut_net_text(node, "node"), both);

    for (int side = 0; is_found && side < 2; side++) {
        const taut_basis *range = taut_curve_t(both[side]->space);
        const double s =
            taut_record_number(taut_record_at(taut_record_get(node, "s"), (size_t)side));
        is_found =
            !isnan(s) && taut_net_spot_at(audit->cells, audit->lines->net, both[side],
                                          fmin(fmax(s, taut_basis_lo(range)), taut_basis_hi(range)),
                                          &spots[side]);
    }
    return is_found;
}

static double acute_angle(const double a[3], const double b[3])
{
    double across[3];
    taut_cross(a, b, across);
    return taut_atan2(taut_length(across), fabs(taut_dot(a, b)));
}

/* Where a lath that stands goes at height h. */
static void way_at(const taut_net_spot *spot, double h, double way[3])
{
    for (int c = 0; c < 3; c++) {
        way[c] = (1 - h * spot->k_n) * spot->tangent[c] - h * spot->tau * spot->sideways[c];
    }
}

/* The largest cotangent of half the angle over the heights of the slot of one side. */
static double twisted_of(const taut_net_spot spots[2], int side, double width)
{
    double least = INFINITY;
    for (int k = 0; k <= HEIGHTS; k++) {
        const double h = (side == 0 ? 1 : -1) * width / 2 * k / HEIGHTS;
        double way[2][3];
        way_at(&spots[0], h, way[0]);
        way_at(&spots[1], h, way[1]);
        least = taut_certify_min(acute_angle(way[0], way[1]), least);
    }
    return taut_cos(least / 2) / taut_sin(least / 2);
}

/* The width of laths that stand; 0 where there are none. */
static double width_of(const taut_net_audit *audit)
{
    const taut_record *lath =
        taut_record_at(taut_record_get(taut_model_details(audit->lines->model), "laths"), 0);
    const taut_trace_laths *asked = audit->problem != NULL ? audit->problem->laths : NULL;
    const char *strip = taut_net_text(lath, "strip");
    const int stands =
        asked != NULL
            ? asked->strip == TAUT_TRACE_STANDING || asked->strip == TAUT_TRACE_DEVELOPABLE
            : strcmp(strip, "standing") == 0 || strcmp(strip, "developable") == 0;
    const double width = asked != NULL ? asked->width : taut_net_number(lath, "width");
    return stands && width > 0 && (audit->problem == NULL || asked != NULL)
               ? ldexp(width, -audit->unit)
               : 0;
}

/* Is a node on a knot line of the surface, beyond which that may bend otherwise? */
static int is_on_knot(const taut_net_audit *audit, const taut_record *node)
{
    const taut_record *at = taut_record_get(node, "at");
    const double place[2] = {taut_record_number(taut_record_at(at, 0)),
                             taut_record_number(taut_record_at(at, 1))};
    return taut_net_is_on_knot(audit->cells->surfaces[taut_net_surface_of(audit, node)], place);
}

/* Of K and H: differences over the larger of what they are and of what the size would have; of a place on a knot line the least
 * from any side. */
/* Slots that are so many times as wide as laths are thick. */
static const double no_slot = 1e3;

/* Are there laths that stand, whose slots twist? */
static int stands(const taut_net_audit *audit)
{
    const taut_trace_laths *laths = audit->problem != NULL ? audit->problem->laths : NULL;
    return laths != NULL && laths->strip == TAUT_TRACE_STANDING;
}

static void look_at_forms(const taut_net_audit *audit, const taut_record *node, const char *name,
                          taut_net_off *off)
{
    const taut_record *place = taut_record_get(node, "at");
    const int on = taut_net_surface_of(audit, node);
    const taut_surface *surface = audit->cells->surfaces[on];
    const double size = audit->size;
    const double tau = ldexp(taut_net_number(node, "tau"), audit->unit) * size;
    const double mean = ldexp(taut_net_number(node, "H"), audit->unit) * size;
    double worst[2] = {INFINITY, INFINITY};

    for (int side = 0; side < 4; side++) {
        double at[2];
        taut_forms forms;
        for (int d = 0; d < 2; d++) {
            const taut_basis *basis = d == 0 ? taut_surface_u(surface) : taut_surface_v(surface);
            const double lo = taut_basis_lo(basis), hi = taut_basis_hi(basis);
            const double aside = (side >> d & 1 ? 1 : -1) * TAUT_NET_AT_KNOT * (hi - lo);
            at[d] = taut_record_number(taut_record_at(place, (size_t)d)) + aside;
            at[d] = isnan(at[d]) ? lo : fmin(fmax(at[d], lo), hi);
        }
        if (taut_net_cells_look(audit->cells, on, at, NULL, &forms)) {
            const double square = fmax(-forms.gaussian * size * size, 0);
            worst[0] = fmin(worst[0], fabs(tau * tau - square) / fmax(1, square));
            worst[1] =
                fmin(worst[1], fabs(mean - forms.mean * size) / fmax(1, fabs(forms.mean) * size));
        }
    }
    taut_net_off_take(off, isnan(tau) ? tau : worst[0], name, "tau");
    taut_net_off_take(off, isnan(mean) ? mean : worst[1], name, "H");
}

/* How far an angle is from that of the curves' own tangents, as the field may jump there: the least, seen from both sides. */
static double own_angle_off(const taut_net_audit *audit, const taut_record *node, double told)
{
    const taut_net_line *both[2];
    double tangent[2][2][3], least = INFINITY;

    if (!taut_net_lines_of_node(audit->lines, taut_net_text(node, "node"), both)) {
        return NAN;
    }
    for (int k = 0; k < 4; k++) {
        const taut_net_line *line = both[k / 2];
        const taut_basis *range = taut_curve_t(line->space);
        const double lo = taut_basis_lo(range), hi = taut_basis_hi(range);
        const double s =
            taut_record_number(taut_record_at(taut_record_get(node, "s"), (size_t)(k / 2)));
        const double aside = s + (2 * (k % 2) - 1) * TAUT_NET_AT_KNOT * (hi - lo);
        double x[2][3];
        if (isnan(s) ||
            taut_curve_eval(line->space, fmin(fmax(aside, lo), hi), 1, x[0]) != TAUT_OK) {
            return NAN;
        }
        const double length = taut_norm(x[1]);
        for (int c = 0; c < 3; c++) {
            tangent[k / 2][k % 2][c] = x[1][c] / length;
        }
    }
    for (int k = 0; k < 4; k++) {
        least =
            taut_certify_min(fabs(told - acute_angle(tangent[0][k % 2], tangent[1][k / 2])), least);
    }
    return least;
}

/* What an angle is off, from the limit on less what rounding may make of directions there. */
static double less_blur(const taut_net_audit *audit, const taut_record *node, double away)
{
    const taut_record *place = taut_record_get(node, "at");
    const int on = taut_net_surface_of(audit, node);
    const double at[2] = {taut_record_number(taut_record_at(place, 0)),
                          taut_record_number(taut_record_at(place, 1))};
    const int has_radius =
        audit->lines->net == TAUT_TRACE_ASYMPTOTIC || audit->lines->net == TAUT_TRACE_PRINCIPAL;
    taut_forms f;

    if (!has_radius || !(away > angle_limit) ||
        !taut_net_cells_look(audit->cells, on, at, NULL, &f) || !f.regular) {
        return away;
    }
    return fmax(away - taut_net_blur(audit->cells->surfaces[on], audit->size, at, &f), 0);
}

void taut_net_crossings_look(const taut_net_audit *audit, taut_net_off *off)
{
    const taut_record *nodes = taut_net_nodes_of(audit);
    const double width = width_of(audit);

    for (size_t k = 0; k < taut_record_count(nodes); k++) {
        const taut_record *node = taut_record_at(nodes, k);
        const char *name = taut_net_text(node, "node");
        taut_net_spot spots[2];
        if (!taut_net_spots_of_node(audit, node, spots)) {
            taut_net_off_take(off, INFINITY, name, "s");
            continue;
        }
        const double told = taut_net_number(node, "angle");
        const double slot = taut_cos(told / 2) / taut_sin(told / 2);
        const double away = fabs(told - acute_angle(spots[0].tangent, spots[1].tangent));
        const double own = own_angle_off(audit, node, told);
        taut_net_off_take(off, less_blur(audit, node, taut_certify_min(away, own)), name, "angle");
        taut_net_off_take(off, fabs(taut_net_number(node, "slot") - slot) / slot, name, "slot");
        look_at_forms(audit, node, name, off);
        const int is_told = taut_record_get(node, "slot_twisted") != NULL;
        if (width > 0 && (is_told || stands(audit)) && !is_on_knot(audit, node)) {
            const double twisted = fmax(twisted_of(spots, 0, width), twisted_of(spots, 1, width));
            const double off_by = fabs(taut_net_number(node, "slot_twisted") - twisted);
            if (is_told || twisted < no_slot) { /* laths that twist onto each other have none */
                taut_net_off_take(off, off_by / (twisted * twisted), name, "slot_twisted");
            }
        }
    }
}

/* ---- of a lath ---- */

/* Which of a node's curves a line is; -1 for none. */
static int side_of(const taut_net_audit *audit, const taut_record *node, const taut_net_line *line)
{
    const char *name = taut_net_text(node, "node");
    const taut_net_line *both[2];
    if (strstr(name, taut_curve_name(line->space)) == NULL || /* most are not: for little work */
        !taut_net_lines_of_node(audit->lines, name, both)) {
        return -1;
    }
    return both[0] == line ? 0 : both[1] == line ? 1 : -1;
}

static double length_at(const taut_record *node, int side)
{
    return taut_record_number(taut_record_at(taut_record_get(node, "s"), (size_t)side));
}

void taut_net_passed_look(const taut_net_audit *audit, const taut_net_line *line,
                          const taut_record *lath, taut_net_off *off)
{
    const taut_record *nodes = taut_net_nodes_of(audit), *passed = taut_record_get(lath, "nodes");
    const size_t count = taut_record_count(passed);
    size_t found = 0;

    for (size_t k = 0; k < taut_record_count(nodes); k++) { /* both in one order */
        const taut_record *node = taut_record_at(nodes, k);
        const int side = side_of(audit, node, line);
        const taut_record *pair = taut_record_at(passed, found);
        if (side >= 0) {
            const double s = taut_record_number(taut_record_at(pair, 1));
            const int is_same = strcmp(taut_record_text(taut_record_at(pair, 0)),
                                       taut_net_text(node, "node")) == 0 &&
                                s == length_at(node, side);
            taut_net_off_take(off, is_same ? 0 : INFINITY, taut_curve_name(line->space), "nodes");
            found++;
        }
    }
    taut_net_off_take(off, found == count ? 0 : INFINITY, taut_curve_name(line->space), "nodes");
}

const taut_record *taut_net_slot_of(const taut_record *slots, const char *node)
{
    for (size_t k = 0; k < taut_record_count(slots); k++) {
        if (strcmp(taut_net_text(taut_record_at(slots, k), "node"), node) == 0) {
            return taut_record_at(slots, k);
        }
    }
    return NULL;
}

/* Times 2^-unit. */
static double play_of(const taut_net_audit *audit)
{
    const taut_trace_laths *asked = audit->problem->laths;
    const char *unit = taut_model_unit(audit->lines->model);
    const double play = asked->has_play
                            ? asked->play
                            : fmin(play_default * taut_unit_ratio("mm", unit), asked->thickness);
    return ldexp(play, -audit->unit);
}

static void look_at_slot(const taut_net_audit *audit, const taut_record *node, int side,
                         const taut_record *slot, const taut_net_course *course, const char *name,
                         taut_net_off *off)
{
    const taut_net_cut *cut = &course->cut;
    const double length = course->spans[course->count].cut;
    const double at = ldexp(taut_net_number(slot, "at"), -audit->unit);
    const double wide = ldexp(taut_net_number(slot, "width"), -audit->unit);
    const double depth = ldexp(taut_net_number(slot, "depth"), -audit->unit);
    const double place = taut_net_course_see(course, length_at(node, side)).cut;
    const char *from = taut_net_text(slot, "from");
    taut_net_spot spots[2];

    const int is_side = strcmp(from, side == 0 ? "n" : "-n") == 0;
    taut_net_off_take(off, is_side ? fabs(at - place) / length : INFINITY, name, "slots");
    taut_net_off_take(off, fabs(depth - cut->width / 2) / cut->width, name, "slots depth");
    if (audit->problem != NULL && !is_on_knot(audit, node)) {
        const double twisted =
            taut_net_spots_of_node(audit, node, spots) ? twisted_of(spots, side, cut->width) : NAN;
        const double need = twisted * cut->thickness + play_of(audit);
        taut_net_off_take(off, fabs(wide - need) / (need * fmax(1, twisted)), name, "slots width");
    }
}

void taut_net_slots_look(const taut_net_audit *audit, const taut_net_line *line,
                         const taut_record *lath, const taut_net_course *course, taut_net_off *off)
{
    const taut_net_cut *cut = &course->cut;
    const taut_record *nodes = taut_net_nodes_of(audit), *slots = taut_record_get(lath, "slots");
    const char *name = taut_curve_name(line->space);
    const int stands = cut->strip == TAUT_TRACE_STANDING || cut->strip == TAUT_TRACE_DEVELOPABLE;
    size_t count = 0;

    for (size_t k = 0;
         stands && cut->width > 0 && cut->thickness > 0 && k < taut_record_count(nodes); k++) {
        const taut_record *node = taut_record_at(nodes, k);
        const int side = side_of(audit, node, line);
        if (side >= 0) {
            look_at_slot(audit, node, side, taut_net_slot_of(slots, taut_net_text(node, "node")),
                         course, name, off);
            count++;
        }
    }
    taut_net_off_take(off, taut_record_count(slots) == count ? 0 : INFINITY, name, "slots");
}
