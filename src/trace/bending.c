#include "trace/bending.h"

#include "core/vec3.h"
#include "numeric/bracket.h"
#include "numeric/quadrature.h"

enum { SAMPLES = TAUT_BENDING_NODES + 2 };

taut_lath_bending taut_lath_bending_at(taut_linefield_kind kind, const taut_segment *segment,
                                       double t)
{
    const taut_carrier *carrier = segment->start.on;
    double window[TAUT_QUINTIC][2], x[TAUT_CARRIER_VECTORS][3], at[2], way[2], ab[2], bend[2];
    double out[3], tangent[3], sideways[3];
    taut_form_pair forms;
    taut_lath_bending b = {{0}};

    taut_segment_window(segment, window);
    taut_quintic_at(2, window[0], t, at, way, bend);
    taut_carrier_at(carrier, segment->start.span, at, 3, x);
    taut_carrier_forms((const double(*)[3])x, &forms);
    const double square =
        forms.e * way[0] * way[0] + 2 * forms.f * way[0] * way[1] + forms.g * way[1] * way[1];
    ab[0] = way[0] / sqrt(square);
    ab[1] = way[1] / sqrt(square);
    if (kind.net != TAUT_TRACE_GEODESIC) {
        double exact[2];
        if (taut_linefield_direction(carrier, kind, &forms, exact) != TAUT_LINEFIELD_FINE) {
            return b;
        }
        const double sign = exact[0] * (forms.e * ab[0] + forms.f * ab[1]) +
                                        exact[1] * (forms.f * ab[0] + forms.g * ab[1]) <
                                    0
                                ? -1
                                : 1;
        ab[0] = sign * exact[0];
        ab[1] = sign * exact[1];
    }
    b.value[TAUT_K_N] = taut_linefield_normal_curvature(&forms, ab);
    b.value[TAUT_TAU_G] = taut_linefield_torsion(&forms, ab);
    if (taut_linefield_bend(kind.net, (const double(*)[3])x, &forms, ab, bend)) {
        taut_linefield_tangent((const double(*)[3])x, ab, tangent);
        taut_linefield_acceleration((const double(*)[3])x, ab, bend, out);
        taut_cross(forms.normal, tangent, sideways);
        b.value[TAUT_K_G] = taut_dot(out, sideways);
    }
    return b;
}

void taut_lath_bending_sample(taut_linefield_kind kind, const taut_segment *segment,
                              taut_lath_samples *samples)
{
    const taut_station *from = &segment->from, *to = &segment->to;
    double nodes[TAUT_BENDING_NODES], weights[TAUT_BENDING_NODES];

    const double length = to->s - from->s;
    const double first = segment->way < 0 ? from->blind / length : 0;
    const double last = segment->way < 0 ? 1 : 1 - to->blind / length;

    *samples = (taut_lath_samples){.kind = kind, .segment = segment};
    taut_gauss_rule(TAUT_BENDING_NODES, nodes, weights);
    samples->t[SAMPLES - 1] = 1;
    for (int i = 0; i < SAMPLES; i++) {
        const int is_node = i > 0 && i < SAMPLES - 1;
        const double t = is_node ? (1 + nodes[i - 1]) / 2 : i == 0 ? 0 : 1;
        samples->t[i] = first < last ? fmin(fmax(t, first), last) : t;
        samples->weight[i] = is_node ? weights[i - 1] / 2 : 0;
        if (first < last && (is_node || samples->t[i] != t)) {
            samples->at[i] = taut_lath_bending_at(kind, segment, samples->t[i]);
        } else if (first < last) {
            const taut_station *end = i == 0 ? from : to;
            samples->at[i] = (taut_lath_bending){{end->k_n, end->k_g, end->tau_g}};
        }
    }
}

/* A measure along a segment. */
typedef struct measured {
    const taut_lath_samples *samples;
    taut_lath_measure *measure;
    const void *context;
} measured;

static double measure_at(const void *context, double t)
{
    const measured *m = context;
    const taut_lath_bending here = taut_lath_bending_at(m->samples->kind, m->samples->segment, t);
    return m->measure(&here, m->context);
}

static void take_most(const taut_lath_samples *samples, double value, double t,
                      taut_lath_most *most)
{
    const double from = samples->segment->from.s, length = samples->segment->to.s - from;
    if (value > most->value) {
        *most = (taut_lath_most){value, from + t * length};
    }
}

void taut_lath_take_most(const taut_lath_samples *samples, taut_lath_measure *measure,
                         const void *context, int ends, taut_lath_most *most)
{
    const measured along = {samples, measure, context};
    const double length = samples->segment->to.s - samples->segment->from.s;
    double value[SAMPLES];

    for (int i = 0; i < SAMPLES; i++) {
        value[i] = measure(&samples->at[i], context);
    }
    for (int i = 0; i < SAMPLES; i++) {
        const int before = i > 0 ? i - 1 : i, after = i < SAMPLES - 1 ? i + 1 : i;
        const int is_top = (ends || before + after == 2 * i) && value[i] >= value[before] &&
                           value[i] >= value[after];
        take_most(samples, value[i], samples->t[i], most);
        if (is_top && value[i] > most->value * 0.9 && value[i] * length > taut_least_angle) {
            double t;
            const double top =
                taut_bracket_most(measure_at, &along, samples->t[before], samples->t[after], &t);
            take_most(samples, top, t, most);
        }
    }
}
