/* summary.c -- of each lath, by one thread each: its bends between stations, and how far it drifts. */
#include "construct/trace/summary.h"

#include "core/crew.h"
#include "core/vec3.h"
#include "numeric/bracket.h"
#include "numeric/quadrature.h"
#include "trace/straight.h"

static double size_of(const taut_lath_bending *bending, const void *which)
{
    return fabs(bending->value[*(const int *)which]);
}

/* One bend along a segment. */
typedef struct bend {
    const taut_lath_samples *samples;
    int which;
} bend;

static double bend_at(const void *context, double t)
{
    const bend *b = context;
    return taut_lath_bending_at(b->samples->kind, b->samples->segment, t).value[b->which];
}

/* |int bend ds| over a part of the segment, over its length. */
static double sum_part(const bend *along, double from, double to)
{
    double nodes[TAUT_BENDING_NODES], weights[TAUT_BENDING_NODES], sum = 0;
    taut_gauss_rule(TAUT_BENDING_NODES, nodes, weights);
    for (int k = 0; k < TAUT_BENDING_NODES; k++) {
        sum += weights[k] / 2 * bend_at(along, from + (to - from) * (1 + nodes[k]) / 2);
    }
    return fabs(sum) * (to - from);
}

/* int |bend| ds over the segment's length; in parts where it changes its sign, and *changes is set. */
static double sum_of(const taut_lath_samples *samples, double length, int which, int *changes)
{
    const bend along = {samples, which};
    double from = 0, sum = 0, plain = 0;
    for (int i = 1; i <= TAUT_BENDING_NODES; i++) {
        plain += samples->weight[i] * fabs(samples->at[i].value[which]);
    }
    for (int i = 0; plain * length > taut_least_angle && i < TAUT_BENDING_NODES + 1; i++) {
        if (samples->at[i].value[which] * samples->at[i + 1].value[which] < 0) {
            const double root =
                taut_bracket_root(bend_at, &along, samples->t[i], samples->t[i + 1],
                                  samples->at[i].value[which], samples->at[i + 1].value[which]);
            sum += sum_part(&along, from, root);
            from = root;
            *changes = 1;
        }
    }
    return from > 0 ? sum + sum_part(&along, from, 1) : plain;
}

static void sum_segment(const taut_net *net, const taut_lath *lath, const taut_segment *segment,
                        taut_lath_summary *s)
{
    const taut_linefield_kind kind = {net->problem->net, lath->family};
    const double length = segment->to.s - segment->from.s;
    taut_lath_samples samples;
    int changes = 0;

    taut_lath_bending_sample(kind, segment, &samples);
    s->turn += length * sum_of(&samples, length, TAUT_K_G, &changes);
    s->twist += segment->near_parabolic
                    ? segment->to.twist - segment->from.twist
                    : length * sum_of(&samples, length, TAUT_TAU_G, &s->is_turning);
    for (int k = 0; k < TAUT_BENDINGS; k++) {
        taut_lath_take_most(&samples, size_of, &k, 0, &s->most[k]);
    }
}

/* How far an end of a curve, its first (0) or its last one, is from where the curve ends that is followed at a hundredth of the
 * tolerance. */
static double drift_at(const taut_net *net, const taut_lath *lath, int end,
                       const taut_monitor *monitor, taut_arena *arena)
{
    const taut_linefield_kind kind = {net->problem->net, lath->family};
    const taut_carrier *carrier = lath->at_seed.on;
    const double sign = end == 1 ? 1 : -1, *t = lath->seed_tangent;
    const double along[3] = {sign * t[0], sign * t[1], sign * t[2]};
    const double length = end == 1 ? lath->length - lath->seed_s : lath->seed_s;
    const double *there =
        end == 1 ? lath->segments[lath->count - 1].to.x : lath->segments[0].from.x;
    taut_follow_options options = net->options.follow;
    taut_walk *walk = taut_arena_take(arena, 1, sizeof *walk);
    taut_walk_state state;
    int span[2];

    options.tolerance /= 100;
    options.is_bare = 1;
    options.monitor = monitor;
    if (lath->ended[end] == TAUT_END_SEED || lath->ended[end] == TAUT_END_LENGTH) {
        options.max_length = length; /* it does not end by itself */
    }
    taut_carrier_cell(carrier, lath->seed, NULL, span);
    if (walk == NULL || !(length > 0) || taut_straight_way(carrier, kind) != NULL ||
        taut_walk_start(carrier, kind, lath->seed, span, along, &state) != TAUT_LINEFIELD_FINE) {
        return 0;
    }
    taut_carrier_cell(carrier, lath->seed, state.y + TAUT_WALK_A, span);
    if (taut_walk_start(carrier, kind, lath->seed, span, along, &state) != TAUT_LINEFIELD_FINE ||
        taut_follow(kind, &state, &options, arena, walk) != TAUT_OK || walk->count == 0) {
        return 0;
    }
    double x[TAUT_CARRIER_VECTORS][3];
    taut_carrier_at(walk->last.on, walk->last.span, walk->last.y, 0, x);
    return taut_length_between(x[0], there);
}

/* The threads that look at laths. */
typedef struct lookers {
    const taut_net *net;
    taut_lath_summary *list;
} lookers;

static void look_at(void *context, int worker, int64_t task)
{
    const lookers *all = context;
    const taut_lath *lath = &all->net->laths[task];
    taut_lath_summary *s = &all->list[task];
    taut_arena *arena = taut_arena_new();
    taut_pulse *pulse = worker == 0 ? all->net->pulse : NULL;
    const taut_monitor monitor = taut_pulse_monitor(pulse);

    for (int k = 0; k < lath->count && !taut_pulse_beat(pulse, TAUT_LATH_BENDING_WORK); k++) {
        sum_segment(all->net, lath, &lath->segments[k], s);
    }
    s->twist = s->is_turning ? s->twist : lath->twist; /* a step sums |tau_g| ill where it turns */
    for (int end = 0; arena != NULL && end < 2; end++) {
        s->drift = fmax(s->drift, drift_at(all->net, lath, end, &monitor, arena));
    }
    s->status = arena != NULL ? taut_arena_status(arena) : TAUT_NO_MEMORY;
    taut_arena_free(arena);
}

taut_status taut_lath_summaries_new(const taut_net *net, taut_lath_summary **summaries)
{
    const taut_crew crew = {.threads = net->threads, .pulse = net->pulse};
    lookers all = {.net = net,
                   .list = taut_arena_take(net->arena, (size_t)net->count, sizeof *all.list)};
    taut_status status = all.list != NULL ? TAUT_OK : TAUT_NO_MEMORY;

    if (status == TAUT_OK &&
        taut_crew_run(&crew, taut_crew_workers(&crew, net->count), net->count, 0, look_at, &all)) {
        status = TAUT_INTERRUPTED;
    }
    for (int k = 0; status == TAUT_OK && k < net->count; k++) {
        status = all.list[k].status;
    }
    *summaries = all.list;
    return status;
}
