#include "construct/trace/details.h"

#include "construct/trace/summary.h"
#include "core/constants.h"
#include "core/vec3.h"
#include "trace/panel.h"
#include "trace/singular.h"
#include "trace/straight.h"

#include <stdio.h>
#include <string.h>

enum { GRID = 101 };
static const char *const nets[] = {"asymptotic", "principal", "geodesic", "isoparametric"};
static const char *const families[4][2] = {{"+", "-"}, {"max", "min"}, {"G", "G"}, {"u", "v"}};
static const char *const edges[] = {"u0", "u1", "v0", "v1"};
/* A kink is worth a warning from this angle on. */
static const double kink_warning = 1e-6;

/* ---- records ---- */

static void add_ended(const taut_lath *lath, int end, taut_record *list)
{
    char text[32];
    const int *e = lath->edges[end];

    snprintf(text, sizeof text, "%s", taut_walk_end_word(lath->ended[end]));
    if (lath->ended[end] == TAUT_END_EDGE) {
        snprintf(text, sizeof text, "edge %s", edges[e[0]]);
    } else if (lath->ended[end] == TAUT_END_CORNER) {
        const int u = e[0] < 2 ? e[0] : e[1], v = e[0] < 2 ? e[1] : e[0];
        snprintf(text, sizeof text, "corner %s%s", edges[u], edges[v]);
    }
    taut_record_add_text(list, NULL, text);
}

void taut_trace_node_name(const taut_net *net, const taut_node *node, char *text, size_t size)
{
    const int length = snprintf(text, size, "%s%s", net->laths[node->laths[0]].name,
                                net->laths[node->laths[1]].name);
    if (node->occurrence > 1 && length > 0 && (size_t)length < size) {
        snprintf(text + length, size - (size_t)length, ".%d", node->occurrence);
    }
}

static void add_nodes_of(const taut_net *net, int index, taut_record *lath)
{
    taut_record *list = taut_record_add_list(lath, "nodes");
    for (int k = 0; k < net->nodes.count; k++) {
        const taut_node *node = &net->nodes.list[k];
        for (int side = 0; side < 2; side++) {
            if (node->laths[side] == index) {
                char name[2 * TAUT_LATH_NAME + 8];
                taut_record *pair = taut_record_add_list(list, NULL);
                taut_trace_node_name(net, node, name, sizeof name);
                taut_record_add_text(pair, NULL, name);
                taut_record_add_number(pair, NULL, ldexp(node->s[side], net->carrier->scale));
            }
        }
    }
}

static void add_if_finite(taut_record *at, const char *name, double value)
{
    if (isfinite(value)) {
        taut_record_add_number(at, name, value);
    }
}

static void describe_stress(const taut_net *net, const taut_strip_stress *stress,
                            taut_record *strip)
{
    const int scale = net->carrier->scale;
    taut_record *at = taut_record_add_object(strip, "stress");
    taut_record_add_number(at, "bending", stress->bending);
    taut_record_add_number(at, "torsion", stress->torsion);
    taut_record_add_number(at, "helix", stress->helix);
    taut_record_add_number(at, "combined", stress->combined);
    taut_record_add_number(at, "use", stress->use);
    taut_record_add_number(at, "at", ldexp(stress->at, scale));
    add_if_finite(at, "t_max", ldexp(stress->thickest, scale));
    add_if_finite(at, "w_max", ldexp(stress->widest, scale));
}

static void describe_slots(const taut_net *net, const taut_strip *strip, taut_record *lath)
{
    const int scale = net->carrier->scale;
    taut_record *list = taut_record_add_list(lath, "slots");
    for (int k = 0; k < strip->slot_count; k++) {
        const taut_slot *slot = &strip->slots[k];
        taut_record *at = taut_record_add_object(list, NULL);
        char name[2 * TAUT_LATH_NAME + 8];
        taut_trace_node_name(net, &net->nodes.list[slot->node], name, sizeof name);
        taut_record_add_text(at, "node", name);
        taut_record_add_number(at, "at", ldexp(slot->at, scale));
        taut_record_add_text(at, "from", slot->side == 0 ? "n" : "-n");
        taut_record_add_number(at, "width", ldexp(slot->width, scale));
        taut_record_add_number(at, "depth", ldexp(slot->depth, scale));
    }
}

static void describe_strip(const taut_net *net, const taut_strip *strip, taut_record *at)
{
    static const char *const strips[] = {"standing", "plank", "developable", "envelope"};
    const taut_trace_laths *laths = net->problem->laths;
    const int scale = net->carrier->scale;

    taut_record_add_text(at, "strip", strips[laths->strip]);
    if (laths->width > 0) {
        taut_record_add_number(at, "width", laths->width);
    }
    if (laths->thickness > 0) {
        taut_record_add_number(at, "thickness", laths->thickness);
    }
    add_if_finite(at, "least_radius", ldexp(strip->least_radius, scale));
    if (laths->width > 0) {
        taut_record_add_number(at, "edge_length", ldexp(strip->edge_length, scale));
        taut_record_add_number(at, "mean_stretch", ldexp(strip->mean_stretch, scale));
    }
    taut_record_add_number(at, "cut_length", ldexp(strip->cut_length, scale));
    taut_record *end = taut_record_add_list(at, "pattern_end");
    taut_record_add_number(end, NULL, ldexp(strip->end[0], scale));
    taut_record_add_number(end, NULL, ldexp(strip->end[1], scale));
    taut_record_add_number(end, NULL, strip->end[2]);
    if (strip->has_stress) {
        describe_stress(net, &strip->stress, at);
    }
    if (strip->slots != NULL) {
        describe_slots(net, strip, at);
    }
}

/* The name of a surface, where there are several. */
static void add_surface(const taut_net *net, const char *member, const taut_carrier *on,
                        taut_record *at)
{
    if (net->carrier_count > 1) {
        taut_record_add_text(at, member, taut_surface_name(on->surface));
    }
}

/* Those that a lath lies on, in its order: from the first to the last. */
static void add_passed(const taut_net *net, const taut_lath *lath, taut_record *at)
{
    const taut_carrier *last = lath->end_on[0];
    taut_record *list = net->carrier_count > 1 ? taut_record_add_list(at, "surfaces") : NULL;

    add_surface(net, NULL, last, list);
    for (int k = 0; k <= lath->count; k++) {
        const taut_carrier *on = k < lath->count ? lath->segments[k].start.on : lath->end_on[1];
        if (on != last) {
            add_surface(net, NULL, on, list);
        }
        last = on;
    }
}

static void describe_lath(const taut_net *net, int index, const taut_lath_summary *s,
                          const taut_strip *strip, taut_record *list)
{
    const taut_lath *lath = &net->laths[index];
    const int scale = net->carrier->scale;
    taut_record *at = taut_record_add_object(list, NULL);
    const double seed[TAUT_BENDINGS] = {lath->at_seed.k_n, lath->at_seed.k_g, lath->at_seed.tau_g};
    static const char *const names[] = {"k_n", "k_g", "tau_g"};

    taut_record_add_text(at, "name", lath->name);
    taut_record_add_text(at, "family", families[net->problem->net][lath->family]);
    taut_record_add_numbers(at, "seed", 2, lath->seed);
    add_surface(net, "surface", lath->at_seed.on, at);
    taut_record_add_numbers(at, "from", 2, lath->ends[0]);
    taut_record_add_numbers(at, "to", 2, lath->ends[1]);
    add_passed(net, lath, at);
    taut_record *ended = taut_record_add_list(at, "ended");
    add_ended(lath, 0, ended);
    add_ended(lath, 1, ended);
    taut_record_add_number(at, "length", ldexp(lath->length, scale));
    taut_record_add_number(at, "twist", s->twist);
    taut_record_add_number(at, "turn", s->turn);
    taut_record_add_number(at, "steps", lath->steps);
    add_nodes_of(net, index, at);
    for (int k = 0; k < TAUT_BENDINGS; k++) {
        taut_record *bending = taut_record_add_object(at, names[k]);
        taut_record_add_number(bending, "seed", ldexp(seed[k], -scale));
        taut_record_add_number(bending, "max", ldexp(s->most[k].value, -scale));
        taut_record_add_number(bending, "max_at", ldexp(s->most[k].at, scale));
    }
    if (strip != NULL) {
        describe_strip(net, strip, at);
    }
}

/* Of laths that stand: the slots of both, the larger one. */
static void add_twisted(const taut_net *net, const taut_node *node, taut_record *at)
{
    const taut_trace_laths *laths = net->problem->laths;
    if (laths == NULL || taut_strip_lies(laths->strip) || !(laths->width > 0)) {
        return;
    }
    const double width = ldexp(laths->width, -net->carrier->scale);
    const double first = taut_slot_twisted(net, node, 0, width);
    const double second = taut_slot_twisted(net, node, 1, width);
    if (first > 0 && second > 0) {
        taut_record_add_number(at, "slot_twisted", fmax(first, second));
    }
}

static void describe_node(const taut_net *net, const taut_node *node, taut_record *list)
{
    const int scale = net->carrier->scale;
    taut_record *at = taut_record_add_object(list, NULL);
    char name[2 * TAUT_LATH_NAME + 8];
    double point[3];

    taut_trace_node_name(net, node, name, sizeof name);
    taut_carrier_point(net->carrier, node->x, point);
    taut_record_add_text(at, "node", name);
    add_surface(net, "surface", node->on, at);
    taut_record_add_numbers(at, "at", 2, node->at);
    taut_record_add_numbers(at, "point", 3, point);
    taut_record_add_numbers(at, "normal", 3, node->normal);
    taut_record_add_number(at, "angle", node->angle);
    taut_record_add_number(at, "tau", ldexp(node->tau, -scale));
    taut_record_add_number(at, "H", ldexp(node->mean, -scale));
    taut_record *s = taut_record_add_list(at, "s");
    taut_record_add_number(s, NULL, ldexp(node->s[0], scale));
    taut_record_add_number(s, NULL, ldexp(node->s[1], scale));
    taut_record_add_number(at, "slot", taut_cos(node->angle / 2) / taut_sin(node->angle / 2));
    add_twisted(net, node, at);
    if (node->is_on_border) {
        taut_record_add_bool(at, "border", 1);
    }
}

static double hyperbolic_share(const taut_carrier *carrier)
{
    int count = 0;
    for (int i = 0; i < GRID; i++) {
        for (int j = 0; j < GRID; j++) {
            const double at[2] = {
                carrier->lo[0] + (carrier->hi[0] - carrier->lo[0]) * i / (GRID - 1),
                carrier->lo[1] + (carrier->hi[1] - carrier->lo[1]) * j / (GRID - 1)};
            double x[TAUT_CARRIER_VECTORS][3];
            taut_form_pair forms;
            taut_carrier_forms_at(carrier, at, x, &forms);
            count += forms.w > 0 && forms.l * forms.n - forms.m * forms.m < 0;
        }
    }
    return (double)count / (GRID * GRID);
}

/* The mean of those of all surfaces. */
static double mean_share(const taut_net *net)
{
    double sum = 0;
    for (int k = 0; k < net->carrier_count; k++) {
        sum += hyperbolic_share(net->carriers[k]);
    }
    return sum / net->carrier_count;
}

static void describe_singular(const taut_net *net, taut_record *details)
{
    const taut_trace_net kind = net->problem->net;
    const int has_some = kind == TAUT_TRACE_ASYMPTOTIC || kind == TAUT_TRACE_PRINCIPAL;
    taut_record *list = taut_record_add_list(details, "singular_points");
    taut_singular found[TAUT_SINGULAR_MAX];

    for (int i = 0; has_some && i < net->carrier_count; i++) {
        const int count =
            taut_singular_find(net->carriers[i], kind == TAUT_TRACE_ASYMPTOTIC, found);
        for (int k = 0; k < count; k++) {
            taut_record *at = taut_record_add_object(list, NULL);
            add_surface(net, "surface", net->carriers[i], at);
            taut_record_add_numbers(at, "at", 2, found[k].at);
            taut_record_add_number(at, "index", found[k].index);
        }
    }
}

static void describe_panel(const taut_net *net, const taut_panel *panel, taut_record *list)
{
    taut_record *at = taut_record_add_object(list, NULL);
    taut_record *nodes = taut_record_add_list(at, "nodes");
    taut_record *points = taut_record_add_list(at, "points");
    for (int k = 0; k < 4; k++) {
        const taut_node *node = &net->nodes.list[panel->corners[k]];
        char name[2 * TAUT_LATH_NAME + 8];
        double point[3];
        taut_trace_node_name(net, node, name, sizeof name);
        taut_carrier_point(net->carrier, node->x, point);
        taut_record_add_text(nodes, NULL, name);
        taut_record_add_numbers(points, NULL, 3, point);
    }
    taut_record_add_number(at, "planarity", panel->planarity);
}

static taut_status describe_panels(const taut_net *net, taut_record *details)
{
    taut_panels panels;
    if (!net->problem->panels) {
        return TAUT_OK;
    }
    const taut_status status = taut_panels_of(net, &panels);
    if (status == TAUT_OK) {
        taut_record_add_number(details, "panel_count", panels.count);
        taut_record_add_number(details, "max_planarity", panels.planarity);
        taut_record *list = taut_record_add_list(details, "panels");
        for (int k = 0; k < panels.count; k++) {
            describe_panel(net, &panels.list[k], list);
        }
    }
    return status;
}

static void describe_left_out(const taut_net *net, taut_record *details)
{
    static const char *const faults[] = {"along", "elliptic", "flat", "singular", "crease"};
    taut_record *list = taut_record_add_list(details, "left_out");
    for (int k = 0; k < net->left_count; k++) {
        const taut_left_out *left = &net->left_out[k];
        taut_record *at = taut_record_add_object(list, NULL);
        taut_record_add_text(at, "family", families[net->problem->net][left->family]);
        add_surface(net, "surface", left->on, at);
        taut_record_add_numbers(at, "at", 2, left->at);
        taut_record_add_text(at, "reason", left->is_short ? "short" : faults[left->fault]);
    }
}

static void describe_kinks(const taut_net *net, taut_record *details)
{
    taut_record *list = taut_record_add_list(details, "kinks");
    for (int k = 0; k < net->count; k++) {
        const taut_lath *lath = &net->laths[k];
        for (int i = 0; i < lath->kink_count; i++) {
            taut_record *at = taut_record_add_object(list, NULL);
            taut_record_add_text(at, "lath", lath->name);
            add_surface(net, "surface", lath->kinks[i].on, at);
            taut_record_add_numbers(at, "at", 2, lath->kinks[i].at);
            taut_record_add_number(at, "angle", lath->kinks[i].angle);
        }
    }
}

/* What the reader of the surface's file had to say, of trimmed faces say. */
static void warn_of_notes(const taut_net *net, taut_record *warnings)
{
    const taut_model *model = net->problem->model;
    const taut_record *notes =
        model != NULL ? taut_record_get(taut_model_details(model), "notes") : NULL;
    for (size_t k = 0; k < taut_record_count(notes); k++) {
        taut_record_add_record(warnings, NULL, taut_record_at(notes, k));
    }
}

static void warn_of_kinks(const taut_net *net, taut_record *warnings)
{
    for (int k = 0; k < net->count; k++) {
        const taut_lath *lath = &net->laths[k];
        for (int i = 0; i < lath->kink_count; i++) {
            const taut_kink *kink = &lath->kinks[i];
            if (kink->angle > kink_warning) {
                char text[160];
                snprintf(text, sizeof text, "%s has a corner of %.3g degrees at (%.6g, %.6g)",
                         lath->name, kink->angle * 180 / TAUT_PI, kink->at[0], kink->at[1]);
                taut_record_add_text(warnings, NULL, text);
            }
        }
    }
}

static void warn_of_use(const taut_net *net, const taut_strip *strips, taut_record *warnings)
{
    for (int k = 0; strips != NULL && k < net->count; k++) {
        const taut_strip_stress *stress = &strips[k].stress;
        if (strips[k].has_stress && stress->use > 1) {
            char text[120];
            snprintf(text, sizeof text, "over: %s has %.4g times its strength, %.6g along it",
                     net->laths[k].name, stress->use, ldexp(stress->at, net->carrier->scale));
            taut_record_add_text(warnings, NULL, text);
        }
    }
}

static void warn_of_longer(const taut_net *net, taut_record *warnings)
{
    for (int k = 0; k < net->count; k++) {
        if (net->laths[k].is_longer) {
            char text[120];
            snprintf(text, sizeof text, "%s is a geodesic, but not the shortest way to its end",
                     net->laths[k].name);
            taut_record_add_text(warnings, NULL, text);
        }
    }
}

taut_status taut_trace_describe(const taut_net *net, const taut_strip *strips, taut_record *details)
{
    taut_lath_summary *summaries = NULL;
    taut_status status = taut_lath_summaries_new(net, &summaries);
    double drift = 0;

    if (status != TAUT_OK) {
        return status;
    }
    taut_record_add_text(details, "trace", nets[net->problem->net]);
    taut_record *laths = taut_record_add_list(details, "laths");
    for (int k = 0; k < net->count; k++) {
        describe_lath(net, k, &summaries[k], strips != NULL ? &strips[k] : NULL, laths);
        drift = fmax(drift, summaries[k].drift);
    }
    taut_record *nodes = taut_record_add_list(details, "nodes");
    for (int k = 0; k < net->nodes.count; k++) {
        describe_node(net, &net->nodes.list[k], nodes);
    }
    taut_record_add_number(details, "hyperbolic_share", mean_share(net));
    taut_record_add_number(details, "drift", ldexp(drift, net->carrier->scale));
    describe_singular(net, details);
    status = describe_panels(net, details);
    describe_left_out(net, details);
    describe_kinks(net, details);
    taut_record *warnings = taut_record_add_list(details, "warnings");
    warn_of_notes(net, warnings);
    warn_of_kinks(net, warnings);
    warn_of_longer(net, warnings);
    warn_of_use(net, strips, warnings);
    if (net->left_count > 0) {
        char text[80];
        snprintf(text, sizeof text, "%d seed%s left out", net->left_count,
                 net->left_count == 1 ? " was" : "s were");
        taut_record_add_text(warnings, NULL, text);
    }
    return status;
}
