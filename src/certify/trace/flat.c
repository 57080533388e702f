/* flat.c
 *
 *     the pattern's axis: x, y, theta and the length as cut at Gauss's nodes of each span, by the integrals of the polynomials
 *     through the bends there; between them the polynomials through these
 *     of each piece the stretch of the axis, from one split midway between two crossings to the next, and where it lies on the
 *     sheet
 *     the points of an outline by twos: their middle on the axis, each one after the last; their difference square to it, or along
 *     the ruling, as long as the band is wide; the axis between them near to the chord
 *     what crosses the stretch: one slot or one drill cross, and one name
 */
#include "certify/trace/flat.h"

#include "certify/common/verdict.h"
#include "certify/trace/crossings.h"
#include "core/elementary/elementary.h"
#include "core/vec3.h"

#include <stdio.h>
#include <string.h>

enum { NODES = TAUT_NET_NODES, ROUNDS = 24, HALVINGS = 60, ARROW = 3, ENDS = 3 };
/* Of what is drawn, over the tolerance: both an outline's middles and its ends on polylines. */
static const double drawn = 4;
/* The breadth of letters over their height at least; the largest height over the width. */
static const double breadth = 0.6, tallest = 0.5;
/* The sine of an angle to which texts lie along the axis, and crosses along and across it. */
static const double askew = 1e-3;

/* The axis of a pattern in lengths of the document. */
typedef struct axis_span {
    double x[NODES], y[NODES], theta[NODES], cut[NODES];
} axis_span;

typedef struct axis {
    const taut_net_course *course;
    axis_span *spans;
    double scale; /* document to unit size */
} axis;

typedef struct axis_at {
    double t, x, y, theta, cut, skew;
} axis_at;

/* integral[i][k]: of the k-th polynomial from -1 to node i. */
static void fill_integrals(const taut_net_rule *rule, double integral[NODES][NODES])
{
    for (int k = 0; k < NODES; k++) {
        double unit[NODES] = {0};
        unit[k] = 1;
        for (int i = 0; i < NODES; i++) {
            const double half = (1 + rule->nodes[i]) / 2;
            integral[i][k] = 0;
            for (int j = 0; j < NODES; j++) {
                integral[i][k] += half * rule->weights[j] *
                                  taut_net_rule_at(rule, unit, -1 + half * (1 + rule->nodes[j]));
            }
        }
    }
}

static double sum_up(const double integral[NODES], const double *values)
{
    double sum = 0;
    for (int k = 0; k < NODES; k++) {
        sum += integral[k] * values[k];
    }
    return sum;
}

static int axis_new(taut_net_cells *cells, const taut_net_course *course, int unit, axis *a)
{
    double integral[NODES][NODES];
    const taut_net_cut *cut = &course->cut;

    *a = (axis){.course = course, .scale = ldexp(1, -unit)};
    a->spans = taut_arena_take(cells->arena, (size_t)course->count + 1, sizeof *a->spans);
    fill_integrals(course->rule, integral);
    for (int i = 0; a->spans != NULL && i < course->count; i++) {
        const taut_net_bent *span = &course->spans[i];
        axis_span *own = &a->spans[i];
        double rate[3][NODES];
        for (int k = 0; k < NODES; k++) {
            own->theta[k] =
                span->theta +
                (cut->flat >= 0 ? span->half * sum_up(integral[k], span->bend[cut->flat]) : 0);
            rate[0][k] = cut->is_mean ? 1 + span->more[k] : 1;
            rate[1][k] = rate[0][k] * taut_cos(own->theta[k]);
            rate[2][k] = rate[0][k] * taut_sin(own->theta[k]);
        }
        for (int k = 0; k < NODES; k++) {
            own->cut[k] = (span->cut + span->half * sum_up(integral[k], rate[0])) / a->scale;
            own->x[k] = (span->x + span->half * sum_up(integral[k], rate[1])) / a->scale;
            own->y[k] = (span->y + span->half * sum_up(integral[k], rate[2])) / a->scale;
        }
    }
    return a->spans != NULL;
}

static axis_at see(const axis *a, double t)
{
    const taut_net_course *course = a->course;
    int low = 0, high = course->count - 1;
    while (low < high) {
        const int middle = (low + high) / 2;
        if (t > course->spans[middle].to) {
            low = middle + 1;
        } else {
            high = middle;
        }
    }
    const taut_net_bent *span = &course->spans[low];
    const axis_span *own = &a->spans[low];
    const taut_net_rule *rule = course->rule;
    const double x = fmin(fmax(2 * (t - span->from) / (span->to - span->from) - 1, -1), 1);
    return (axis_at){t,
                     taut_net_rule_at(rule, own->x, x),
                     taut_net_rule_at(rule, own->y, x),
                     taut_net_rule_at(rule, own->theta, x),
                     taut_net_rule_at(rule, own->cut, x),
                     course->cut.only_bends ? taut_net_rule_at(rule, span->skew, x) : 0};
}

static double begin_of(const axis *a)
{
    return a->course->spans[0].from;
}

static double end_of(const axis *a)
{
    return a->course->spans[a->course->count - 1].to;
}

/* Where it is so long as cut. */
static double reach(const axis *a, double cut)
{
    double low = begin_of(a), high = end_of(a);
    for (int round = 0; round < HALVINGS; round++) {
        const double middle = (low + high) / 2;
        *(see(a, middle).cut < cut ? &low : &high) = middle;
    }
    return high;
}

/* ---- where a piece lies ---- */

/* A place where another lath, or the same one once more, crosses. */
typedef struct crossing {
    const char *node, *other;
    axis_at at;
} crossing;

typedef struct flat {
    const taut_net_audit *audit;
    const taut_net_line *line;
    const axis *along;
    const taut_record *lath, *piece;
    char name[TAUT_NAME_MAX + 16]; /* what it is to be called */
    double from, to;               /* of the axis */
    double at[2], c,
        s; /* the pattern's origin, and its x on the sheet, as long as the sheet has it */
    double half, room; /* of the width; of what is drawn */
    int is_split, is_plank;
    const crossing *crossings; /* of the whole lath, along it */
    size_t crossing_count;
    taut_net_off *off;
} flat;

static double number_at(const taut_record *list, size_t k)
{
    return taut_record_number(taut_record_at(list, k));
}

/* A point of the sheet, told as [x, y], in the pattern. */
static void seen_from(const flat *f, const taut_record *point, double out[2])
{
    const double square = f->c * f->c + f->s * f->s;
    const double x = number_at(point, 0) - f->at[0], y = number_at(point, 1) - f->at[1];
    out[0] = (f->c * x + f->s * y) / square;
    out[1] = (f->c * y - f->s * x) / square;
}

/* The same from a place of the axis: along it and up from it. */
static void beside(const axis_at *at, const double point[2], double out[2])
{
    const double c = taut_cos(at->theta), s = taut_sin(at->theta);
    const double x = point[0] - at->x, y = point[1] - at->y;
    out[0] = c * x + s * y;
    out[1] = c * y - s * x;
}

static void beside_record(const flat *f, const axis_at *at, const taut_record *point, double out[2])
{
    double there[2];
    seen_from(f, point, there);
    beside(at, there, out);
}

/* Both ends of its axis on the sheet: the middles of its first and last point, and of the two that are halfway. */
static void axis_ends(const taut_record *piece, double ends[2][2])
{
    const taut_record *outline = taut_record_get(piece, "outline");
    const size_t count = taut_record_count(outline), half = count / 2;
    for (size_t d = 0; d < 2; d++) {
        ends[0][d] = (number_at(taut_record_at(outline, 0), d) +
                      number_at(taut_record_at(outline, count - 1), d)) /
                     2;
        ends[1][d] = (number_at(taut_record_at(outline, half - 1), d) +
                      number_at(taut_record_at(outline, half), d)) /
                     2;
    }
}

/* Where a piece that begins at f->from ends: midway between two crossings, where its chord fits best. */
static double split_of(const flat *f, double chord)
{
    const axis_at from = see(f->along, f->from);
    double best = INFINITY, found = end_of(f->along);
    for (size_t k = 1; k < f->crossing_count; k++) {
        const double cut = (f->crossings[k - 1].at.cut + f->crossings[k].at.cut) / 2;
        const axis_at at = see(f->along, reach(f->along, cut));
        const double off = fabs(taut_hypot(at.x - from.x, at.y - from.y) - chord);
        if (at.t > f->from && off < best) {
            best = off;
            found = at.t;
        }
    }
    return found;
}

/* The stretch of the pattern that begins at f->from laid on the axis of the piece. */
static void lay(flat *f, int is_last)
{
    double ends[2][2];
    axis_ends(f->piece, ends);
    const double u = ends[1][0] - ends[0][0], v = ends[1][1] - ends[0][1];
    const double chord = taut_hypot(u, v);
    f->to = is_last ? end_of(f->along) : split_of(f, chord);
    const axis_at from = see(f->along, f->from), to = see(f->along, f->to);
    const double x = to.x - from.x, y = to.y - from.y, square = x * x + y * y;
    f->c = (x * u + y * v) / square;
    f->s = (x * v - y * u) / square;
    f->at[0] = ends[0][0] - (f->c * from.x - f->s * from.y);
    f->at[1] = ends[0][1] - (f->s * from.x + f->c * from.y);
}

static void wrong(const flat *f, int is_so, const char *member)
{
    taut_net_off_take(f->off, is_so ? 0 : INFINITY, taut_curve_name(f->line->space), member);
}

/* ---- its outline ---- */

/* The place of the axis beside a point of the pattern, from one that is before it. */
static axis_at foot(const flat *f, const axis_at *before, const double point[2])
{
    const double lo = f->from, hi = f->to;
    axis_at at = *before;
    double rate = (see(f->along, hi).cut - see(f->along, lo).cut) / (hi - lo);
    for (int round = 0; round < ROUNDS; round++) {
        double away[2];
        beside(&at, point, away);
        const double t = fmin(fmax(at.t + away[0] / rate, lo), hi);
        const axis_at next = see(f->along, t);
        if (!(fabs(away[0]) > f->room / 64) || t == at.t) {
            break;
        }
        rate = next.t != at.t && next.cut != at.cut ? (next.cut - at.cut) / (next.t - at.t) : rate;
        at = next;
    }
    return at;
}

/* How far two points of an outline, one on each edge of the band, are from where they are to be; where a lath is split, `is_split`,
 * they may lie askew: that is cut square to a chord. */
static double pair_off(const flat *f, const taut_record *below, const taut_record *above,
                       int is_split, axis_at *at, const axis_at *before, double middle[2])
{
    double low[2], high[2], away[2];
    seen_from(f, below, low);
    seen_from(f, above, high);
    for (int d = 0; d < 2; d++) {
        middle[d] = (low[d] + high[d]) / 2;
    }
    if (isnan(middle[0]) || isnan(middle[1])) {
        return INFINITY;
    }
    *at = foot(f, before, middle);
    beside(at, middle, away);
    const double aside = taut_hypot(away[0], away[1]);
    beside(at, high, away);
    const double turned = taut_hypot(away[0] - at->skew * f->half, away[1] - f->half);
    return fmax(aside, is_split ? turned - askew * f->half : turned);
}

static void look_at_outline(const flat *f)
{
    const taut_record *outline = taut_record_get(f->piece, "outline");
    const size_t count = taut_record_count(outline);
    const double turned = f->c * f->c + f->s * f->s;
    axis_at before = see(f->along, f->from);
    double last[2] = {before.x, before.y}, worst = fabs(turned - 1) * before.cut;

    worst = fmax(worst, fabs(turned - 1) * (see(f->along, f->to).cut - before.cut));
    for (size_t k = 0; k < count / 2; k++) {
        double middle[2], away[2];
        axis_at at = before;
        const int is_split =
            k == 0 ? f->from > begin_of(f->along) : k + 1 == count / 2 && f->to < end_of(f->along);
        const double off =
            pair_off(f, taut_record_at(outline, k), taut_record_at(outline, count - 1 - k),
                     is_split, &at, &before, middle);
        worst = fmax(worst, off);
        if (off == INFINITY || !(at.t >= before.t - f->room)) {
            worst = INFINITY;
            break;
        }
        const axis_at between = see(f->along, (before.t + at.t) / 2); /* from the chord */
        const double centre[2] = {(last[0] + middle[0]) / 2, (last[1] + middle[1]) / 2};
        beside(&between, centre, away);
        worst = fmax(worst, fabs(away[1]));
        memcpy(last, middle, sizeof last);
        before = at;
    }
    worst =
        fmax(worst, end_of(f->along) >= f->to ? fabs(see(f->along, f->to).cut - before.cut) : 0);
    const double length = see(f->along, end_of(f->along)).cut;
    taut_net_off_take(f->off, fmax(worst - f->room, 0) / length, taut_curve_name(f->line->space),
                      "pieces outline");
    wrong(f, count >= 4 && count % 2 == 0, "pieces outline");
}

/* ---- what crosses it ---- */

static int is_here(const flat *f, const crossing *x)
{
    return x->at.t >= f->from && x->at.t <= f->to;
}

/* How far the corners of a slot are from where they are to be. */
static double slot_off(const flat *f, const taut_record *outline, const taut_record *slot,
                       const axis_at *at)
{
    const double side = strcmp(taut_net_text(slot, "from"), "n") == 0 ? 1 : -1;
    const double wide = taut_net_number(slot, "width") / 2, depth = taut_net_number(slot, "depth");
    const double along[4] = {-wide, -wide, wide, wide};
    const double up[4] = {f->half, f->half - depth, f->half - depth, f->half};
    double off = taut_record_count(outline) == 4 ? 0 : INFINITY;

    for (size_t k = 0; off < INFINITY && k < 4; k++) {
        double corner[2];
        beside_record(f, at, taut_record_at(outline, k), corner);
        const double away = taut_hypot(corner[0] - along[k], corner[1] - side * up[k]);
        off = isnan(away) ? INFINITY : fmax(off, away);
    }
    return off;
}

/* How many slots it has. */
static size_t look_at_slots(const flat *f)
{
    const taut_record *holes = taut_record_get(f->piece, "slots");
    const taut_record *slots = taut_record_get(f->lath, "slots");
    const double length = see(f->along, end_of(f->along)).cut;

    for (size_t k = 0; k < taut_record_count(holes); k++) {
        const taut_record *hole = taut_record_at(holes, k);
        const taut_record *slot = taut_net_slot_of(slots, taut_net_text(hole, "node"));
        double off = INFINITY;
        for (size_t j = 0; slot != NULL && j < f->crossing_count; j++) {
            const crossing *x = &f->crossings[j];
            if (is_here(f, x) && strcmp(x->node, taut_net_text(hole, "node")) == 0) {
                off = fmin(off, slot_off(f, taut_record_get(hole, "outline"), slot, &x->at));
            }
        }
        off = f->is_split ? fmax(off - f->room, 0) : off;
        taut_net_off_take(f->off, off / length, taut_curve_name(f->line->space), "pieces slots");
    }
    return taut_record_count(holes);
}

/* A line as it lies beside a place of the axis; its middle. */
typedef struct engraved {
    double ends[2][2], middle[2];
} engraved;

static engraved line_beside(const flat *f, const axis_at *at, size_t k)
{
    const taut_record *line = taut_record_at(taut_record_get(f->piece, "lines"), k);
    engraved e;
    for (size_t i = 0; i < 2; i++) {
        beside_record(f, at, taut_record_at(line, i), e.ends[i]);
    }
    for (int d = 0; d < 2; d++) {
        e.middle[d] = (e.ends[0][d] + e.ends[1][d]) / 2;
    }
    return e;
}

/* Does a line cross the place, along the axis (d 0) or across it (d 1)? */
static int crosses(const flat *f, const engraved *e, int d)
{
    const double along = fabs(e->ends[1][d] - e->ends[0][d]);
    return taut_hypot(e->middle[0], e->middle[1]) <= f->room && along > 0 && along <= 2 * f->half &&
           fabs(e->ends[1][1 - d] - e->ends[0][1 - d]) <= askew * along;
}

/* One drill cross where each lath crosses a plank, and behind them three lines that end together beside the end: an arrow. */
static void look_at_lines(const flat *f, size_t crossings)
{
    const size_t count = taut_record_count(taut_record_get(f->piece, "lines"));
    const size_t drilled = f->is_plank ? 2 * crossings : 0;
    const axis_at end = see(f->along, f->to);
    int is_so = count == drilled + ARROW;

    for (size_t j = 0; f->is_plank && is_so && j < f->crossing_count; j++) {
        const crossing *x = &f->crossings[j];
        int found[2] = {0, 0};
        for (size_t k = 0; is_here(f, x) && k < drilled; k++) {
            const engraved e = line_beside(f, &x->at, k);
            found[0] |= crosses(f, &e, 0);
            found[1] |= crosses(f, &e, 1);
        }
        is_so = !is_here(f, x) || (found[0] && found[1]);
    }
    for (size_t k = drilled; is_so && k < count; k++) {
        const engraved e = line_beside(f, &end, k), first = line_beside(f, &end, drilled);
        is_so =
            e.ends[0][0] < e.ends[1][0] && fabs(e.ends[1][0]) <= f->half &&
            fabs(e.ends[1][1]) <= f->half &&
            taut_hypot(e.ends[1][0] - first.ends[1][0], e.ends[1][1] - first.ends[1][1]) <= f->room;
    }
    wrong(f, is_so, "pieces lines");
}

/* Is text k this word, along the axis, its middle so near to the place as letters let it, `aside` from it? *up: how far up. */
static int says(const flat *f, size_t k, const char *word, const axis_at *at, double aside,
                double *up)
{
    const taut_record *text = taut_record_at(taut_record_get(f->piece, "texts"), k);
    const double height = taut_net_number(text, "height");
    const double angle = taut_net_number(text, "angle");
    const double reach_of = aside + height + breadth * height * (double)strlen(word) / 2;
    const double c = f->c * taut_cos(at->theta) - f->s * taut_sin(at->theta);
    const double s = f->s * taut_cos(at->theta) + f->c * taut_sin(at->theta);
    double there[2];

    beside_record(f, at, taut_record_get(text, "at"), there);
    *up = there[1];
    return strcmp(taut_net_text(text, "text"), word) == 0 && height > 0 &&
           height <= tallest * 2 * f->half && fabs(there[0]) <= reach_of &&
           fabs(there[1]) <= f->half && fabs(c * taut_sin(angle) - s * taut_cos(angle)) <= askew &&
           c * taut_cos(angle) + s * taut_sin(angle) > 0;
}

/* How many texts say this beside the place, from `low` of the half width up. */
static int count_texts(const flat *f, const char *word, const axis_at *at, double aside, double low)
{
    int found = 0;
    double up = 0;
    for (size_t k = 0; k < taut_record_count(taut_record_get(f->piece, "texts")); k++) {
        found += says(f, k, word, at, aside, &up) && up >= low * f->half - f->room;
    }
    return found;
}

static void look_at_texts(const flat *f, size_t crossings)
{
    const size_t count = taut_record_count(taut_record_get(f->piece, "texts"));
    const axis_at ends[2] = {see(f->along, f->from), see(f->along, f->to)};
    int is_so = count == crossings + ENDS &&
                count_texts(f, "n", &ends[0], 0, f->is_plank ? 0 : breadth / 2) > 0;

    for (int end = 0; end < 2; end++) {
        is_so = is_so && count_texts(f, f->name, &ends[end], 0, -1) > 0;
    }
    for (size_t k = 0; is_so && k < f->crossing_count; k++) {
        const crossing *x = &f->crossings[k];
        const taut_record *slot = taut_net_slot_of(taut_record_get(f->lath, "slots"), x->node);
        const double wide = slot != NULL ? taut_net_number(slot, "width") : 0;
        is_so = !is_here(f, x) || count_texts(f, x->other, &x->at, wide / 2, -1) > 0;
    }
    wrong(f, is_so, "pieces texts");
}

/* ---- all pieces of a lath ---- */

static size_t count_crossings(const flat *f)
{
    size_t found = 0;
    for (size_t k = 0; k < f->crossing_count; k++) {
        found += (size_t)is_here(f, &f->crossings[k]);
    }
    return found;
}

/* All places of the lath where one crosses, along it; NULL: no memory. */
static const crossing *find_crossings(const flat *f, size_t *count)
{
    const taut_record *nodes = taut_net_nodes_of(f->audit);
    const size_t most = 2 * taut_record_count(nodes) + 1;
    crossing *list = taut_arena_take(f->audit->cells->arena, most, sizeof *list);

    *count = 0;
    for (size_t k = 0; list != NULL && k + 1 < most; k++) {
        const taut_record *node = taut_record_at(nodes, k / 2);
        const char *name = taut_net_text(node, "node");
        const size_t side = k % 2;
        const taut_net_line *both[2];
        const double s = number_at(taut_record_get(node, "s"), side);
        size_t i = *count;
        if (isnan(s) || !taut_net_lines_of_node(f->audit->lines, name, both) ||
            both[side] != f->line) {
            continue;
        }
        const crossing x = {name, taut_curve_name(both[1 - side]->space),
                            see(f->along, fmin(fmax(s, begin_of(f->along)), end_of(f->along)))};
        for (; i > 0 && list[i - 1].at.t > x.at.t; i--) {
            list[i] = list[i - 1];
        }
        list[i] = x;
        (*count)++;
    }
    return list;
}

void taut_net_flat_look(const taut_net_audit *audit, const taut_net_line *line,
                        const taut_record *lath, const taut_net_course *course, taut_net_off *off)
{
    const taut_record *pieces = taut_record_get(taut_model_details(audit->lines->model), "pieces");
    const char *name = taut_curve_name(line->space);
    const taut_trace_strip strip = course->cut.strip;
    size_t found = 0, parts = 0, part = 0;
    axis along;

    for (size_t k = 0; k < taut_record_count(pieces); k++) {
        parts += strcmp(taut_net_text(taut_record_at(pieces, k), "lath"), name) == 0;
    }
    if (parts == 0) {
        return;
    }
    if (!axis_new(audit->cells, course, audit->unit, &along)) {
        taut_net_off_take(off, INFINITY, name, "pieces");
        return;
    }
    flat f = {.audit = audit,
              .line = line,
              .along = &along,
              .lath = lath,
              .from = begin_of(&along),
              .half = course->cut.width / along.scale / 2,
              .room = drawn * audit->tolerance * audit->lines->size,
              .is_split = parts > 1,
              .is_plank = strip == TAUT_TRACE_PLANK || strip == TAUT_TRACE_ENVELOPE,
              .off = off};
    f.crossings = find_crossings(&f, &f.crossing_count);
    if (f.crossings == NULL) {
        taut_net_off_take(off, INFINITY, name, "pieces");
        return;
    }
    for (size_t k = 0; k < taut_record_count(pieces); k++) {
        f.piece = taut_record_at(pieces, k);
        if (strcmp(taut_net_text(f.piece, "lath"), name) != 0) {
            continue;
        }
        part++;
        snprintf(f.name, sizeof f.name, "%.200s", name);
        if (parts > 1) {
            snprintf(f.name, sizeof f.name, "%.200s/%zu", name, part);
        }
        wrong(&f, strcmp(taut_net_text(f.piece, "name"), f.name) == 0, "pieces name");
        lay(&f, part == parts);
        look_at_outline(&f);
        found += look_at_slots(&f);
        const size_t crossings = count_crossings(&f);
        look_at_lines(&f, crossings);
        look_at_texts(&f, crossings);
        f.from = f.to;
    }
    const size_t count = taut_record_count(taut_record_get(lath, "slots"));
    taut_net_off_take(off, found == count ? 0 : INFINITY, name, "pieces slots");
}
