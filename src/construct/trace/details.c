#include "construct/trace/details.h"

#include "core/constants.h"
#include "core/vec3.h"
#include "numeric/quadrature.h"
#include "trace/bending.h"

#include <stdio.h>
#include <string.h>

enum { NODES = 8, GRID = 101, ROUNDS = 40 };
static const char *const nets[] = {"asymptotic", "principal", "geodesic", "isoparametric"};
static const char *const families[4][2] = {{"+", "-"}, {"max", "min"}, {"G", "G"}, {"u", "v"}};
static const char *const edges[] = {"u0", "u1", "v0", "v1"};
/* A kink is worth a warning from this angle on. */
static const double kink_warning = 1e-6;

/* ---- what a lath does between its stations ---- */

typedef struct summary {
    double turn;
    double most[TAUT_BENDINGS], most_at[TAUT_BENDINGS];
} summary;

static void take_most(summary *s, int k, double value, double at)
{
    if (fabs(value) > s->most[k]) {
        s->most[k] = fabs(value);
        s->most_at[k] = at;
    }
}

/* The largest of |value| near a node of the rule that is larger than its neighbours. */
static void climb(const taut_net *net, const taut_lath *lath, const taut_segment *segment, int k,
                  double low, double high, summary *s)
{
    const taut_linefield_kind kind = {net->problem->net, lath->family};
    const double golden = 0.6180339887498949, length = segment->to.s - segment->from.s;
    double a = high - golden * (high - low), b = low + golden * (high - low);
    double at_a = fabs(taut_bending_at(net->carrier, kind, segment, a).value[k]);
    double at_b = fabs(taut_bending_at(net->carrier, kind, segment, b).value[k]);
    for (int round = 0; round < ROUNDS; round++) {
        if (at_a > at_b) {
            high = b;
            b = a;
            at_b = at_a;
            a = high - golden * (high - low);
            at_a = fabs(taut_bending_at(net->carrier, kind, segment, a).value[k]);
        } else {
            low = a;
            a = b;
            at_a = at_b;
            b = low + golden * (high - low);
            at_b = fabs(taut_bending_at(net->carrier, kind, segment, b).value[k]);
        }
    }
    take_most(s, k, at_a, segment->from.s + a * length);
}

static void sum_segment(const taut_net *net, const taut_lath *lath, const taut_segment *segment,
                        summary *s)
{
    const taut_linefield_kind kind = {net->problem->net, lath->family};
    const double length = segment->to.s - segment->from.s;
    double nodes[NODES], weights[NODES], t[NODES + 2];
    taut_bending at[NODES + 2];

    taut_gauss_rule(NODES, nodes, weights);
    at[0] = (taut_bending){{segment->from.k_n, segment->from.k_g, segment->from.tau_g}};
    at[NODES + 1] = (taut_bending){{segment->to.k_n, segment->to.k_g, segment->to.tau_g}};
    t[0] = 0;
    t[NODES + 1] = 1;
    for (int i = 0; i < NODES; i++) {
        t[i + 1] = (1 + nodes[i]) / 2;
        at[i + 1] = taut_bending_at(net->carrier, kind, segment, t[i + 1]);
        s->turn += weights[i] / 2 * length * fabs(at[i + 1].value[TAUT_K_G]);
    }
    for (int k = 0; k < TAUT_BENDINGS; k++) {
        for (int i = 0; i < NODES + 2; i++) {
            const double here = fabs(at[i].value[k]);
            const int is_top = i > 0 && i < NODES + 1 && here >= fabs(at[i - 1].value[k]) &&
                               here >= fabs(at[i + 1].value[k]);
            take_most(s, k, here, segment->from.s + t[i] * length);
            if (is_top && here > s->most[k] * 0.9 && here > 0) {
                climb(net, lath, segment, k, t[i - 1], t[i + 1], s);
            }
        }
    }
}

/* ---- records ---- */

static void add_ended(const taut_lath *lath, int end, taut_record *list)
{
    static const char *const words[] = {"none",   "edge",    "corner", "parabolic", "envelope",
                                        "flat",   "umbilic", "closed", "crease",    "singular",
                                        "length", "seed",    "stalled"};
    char text[32];
    const int *e = lath->edges[end];

    snprintf(text, sizeof text, "%s", words[lath->ended[end]]);
    if (lath->ended[end] == TAUT_END_EDGE) {
        snprintf(text, sizeof text, "edge %s", edges[e[0]]);
    } else if (lath->ended[end] == TAUT_END_CORNER) {
        const int u = e[0] < 2 ? e[0] : e[1], v = e[0] < 2 ? e[1] : e[0];
        snprintf(text, sizeof text, "corner %s%s", edges[u], edges[v]);
    }
    taut_record_add_text(list, NULL, text);
}

static void node_name(const taut_net *net, const taut_node *node, char *text, size_t size)
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
                node_name(net, node, name, sizeof name);
                taut_record_add_text(pair, NULL, name);
                taut_record_add_number(pair, NULL, ldexp(node->s[side], net->carrier->scale));
            }
        }
    }
}

static void describe_lath(const taut_net *net, int index, taut_record *list)
{
    const taut_lath *lath = &net->laths[index];
    const int scale = net->carrier->scale;
    taut_record *at = taut_record_add_object(list, NULL);
    summary s = {0};
    const double seed[TAUT_BENDINGS] = {lath->at_seed.k_n, lath->at_seed.k_g, lath->at_seed.tau_g};
    static const char *const names[] = {"k_n", "k_g", "tau_g"};

    for (int k = 0; k < lath->count; k++) {
        sum_segment(net, lath, &lath->segments[k], &s);
    }
    taut_record_add_text(at, "name", lath->name);
    taut_record_add_text(at, "family", families[net->problem->net][lath->family]);
    taut_record_add_numbers(at, "seed", 2, lath->seed);
    taut_record_add_numbers(at, "from", 2, lath->ends[0]);
    taut_record_add_numbers(at, "to", 2, lath->ends[1]);
    taut_record *ended = taut_record_add_list(at, "ended");
    add_ended(lath, 0, ended);
    add_ended(lath, 1, ended);
    taut_record_add_number(at, "length", ldexp(lath->length, scale));
    taut_record_add_number(at, "twist", lath->twist);
    taut_record_add_number(at, "turn", s.turn);
    taut_record_add_number(at, "steps", lath->steps);
    add_nodes_of(net, index, at);
    for (int k = 0; k < TAUT_BENDINGS; k++) {
        taut_record *bending = taut_record_add_object(at, names[k]);
        taut_record_add_number(bending, "seed", ldexp(seed[k], -scale));
        taut_record_add_number(bending, "max", ldexp(s.most[k], -scale));
        taut_record_add_number(bending, "max_at", ldexp(s.most_at[k], scale));
    }
}

static void describe_node(const taut_net *net, const taut_node *node, taut_record *list)
{
    const int scale = net->carrier->scale;
    taut_record *at = taut_record_add_object(list, NULL);
    char name[2 * TAUT_LATH_NAME + 8];
    double point[3];

    node_name(net, node, name, sizeof name);
    taut_carrier_point(net->carrier, node->x, point);
    taut_record_add_text(at, "node", name);
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

static void describe_left_out(const taut_net *net, taut_record *details)
{
    static const char *const faults[] = {"along", "elliptic", "flat", "singular"};
    taut_record *list = taut_record_add_list(details, "left_out");
    for (int k = 0; k < net->left_count; k++) {
        const taut_left_out *left = &net->left_out[k];
        taut_record *at = taut_record_add_object(list, NULL);
        taut_record_add_text(at, "family", families[net->problem->net][left->family]);
        taut_record_add_numbers(at, "at", 2, left->at);
        taut_record_add_text(at, "reason", faults[left->fault]);
    }
}

static void describe_kinks(const taut_net *net, taut_record *details, taut_record *warnings)
{
    taut_record *list = taut_record_add_list(details, "kinks");
    for (int k = 0; k < net->count; k++) {
        const taut_lath *lath = &net->laths[k];
        for (int i = 0; i < lath->kink_count; i++) {
            const taut_kink *kink = &lath->kinks[i];
            taut_record *at = taut_record_add_object(list, NULL);
            taut_record_add_text(at, "lath", lath->name);
            taut_record_add_numbers(at, "at", 2, kink->at);
            taut_record_add_number(at, "angle", kink->angle);
            if (kink->angle > kink_warning) {
                char text[160];
                snprintf(text, sizeof text, "%s has a corner of %.3g degrees at (%.6g, %.6g)",
                         lath->name, kink->angle * 180 / TAUT_PI, kink->at[0], kink->at[1]);
                taut_record_add_text(warnings, NULL, text);
            }
        }
    }
}

void taut_trace_describe(const taut_net *net, taut_record *details)
{
    taut_record_add_text(details, "trace", nets[net->problem->net]);
    taut_record *laths = taut_record_add_list(details, "laths");
    for (int k = 0; k < net->count; k++) {
        describe_lath(net, k, laths);
    }
    taut_record *nodes = taut_record_add_list(details, "nodes");
    for (int k = 0; k < net->nodes.count; k++) {
        describe_node(net, &net->nodes.list[k], nodes);
    }
    taut_record_add_number(details, "hyperbolic_share", hyperbolic_share(net->carrier));
    describe_left_out(net, details);
    taut_record *warnings = taut_record_new_list();
    describe_kinks(net, details, warnings);
    if (net->left_count > 0) {
        char text[80];
        snprintf(text, sizeof text, "%d seed%s left out", net->left_count,
                 net->left_count == 1 ? " was" : "s were");
        taut_record_add_text(warnings, NULL, text);
    }
    taut_record_add_record(details, "warnings", warnings);
    taut_record_free(warnings);
}

void taut_trace_describe_part(const taut_lath *lath, const taut_lath_part *part,
                              taut_record *domain)
{
    taut_record *at = taut_record_add_object(domain, NULL);
    taut_basis_spec spec;

    taut_basis_spec_of(part->basis, &spec);
    taut_record_add_text(at, "name", lath->name);
    taut_record *basis = taut_record_add_object(at, "t");
    taut_record_add_text(basis, "type", "bspline");
    taut_record_add_number(basis, "degree", spec.degree);
    taut_record_add_numbers(basis, "knots", spec.knot_count, spec.knots);
    taut_record *points = taut_record_add_list(at, "points");
    for (int k = 0; k < part->count; k++) {
        taut_record *point = taut_record_add_list(points, NULL);
        taut_record_add_number(point, NULL, part->window[2 * k]);
        taut_record_add_number(point, NULL, part->window[2 * k + 1]);
    }
}
