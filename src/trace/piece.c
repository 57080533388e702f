/* piece.c
 *
 *     of each lath: the axis of its pattern with its nodes, the stretches between two splits
 *     of each stretch: the band, its slots, its marks, turned so that its ends lie on a level
 *     all of them on sheets by the boxes around their bands (pattern/sheet/sheet.h)
 */
#include "trace/piece.h"

#include "core/constants.h"
#include "core/fail.h"
#include "core/vec3.h"
#include "pattern/sheet/sheet.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* The height of letters over the width, and their breadth over the height; those of DXF, whose height is that of capitals, are as broad
 * as high, and half a height beside a slot keeps them clear of it. */
static const double letter = 0.2, breadth = 0.6;

/* A node on the axis of a pattern. */
typedef struct crossing {
    const char *other; /* the name of the lath that crosses */
    taut_axis_point at;
    const taut_slot *slot; /* NULL: a plank */
    int node;
} crossing;

/* What one lath is cut from. */
typedef struct band {
    const taut_net *net;
    const taut_lath *lath;
    int index, is_plank;
    double width;
    taut_axis_point *axis;
    int axis_count;
    crossing *crossings; /* along it */
    int crossing_count;
} band;

typedef struct builder {
    const taut_net *net;
    taut_arena *arena;
    taut_pieces *pieces;
    int room;
    double sheet[2];   /* zeros: as large as needed */
    const band *worst; /* of the longest part that is longer than a sheet, or NULL */
    double needed;
} builder;

/* ---- axes ---- */

static taut_status make_band(const taut_net *net, const taut_strip *strips, double sagitta,
                             int index, band *b)
{
    const int is_plank = taut_strip_lies(net->problem->laths->strip);
    const size_t most =
        2 * (size_t)net->nodes.count + 1; /* one that crosses itself is there twice */
    double *stops = taut_arena_take(net->arena, most, sizeof *stops);
    const taut_strip *strip = &strips[index];

    *b = (band){.net = net,
                .lath = &net->laths[index],
                .index = index,
                .is_plank = is_plank,
                .width = ldexp(net->problem->laths->width, -net->carrier->scale),
                .crossings = taut_arena_take(net->arena, most, sizeof *b->crossings)};
    if (stops == NULL || b->crossings == NULL) {
        return TAUT_NO_MEMORY;
    }
    for (int k = 0; k < 2 * net->nodes.count; k++) {
        const taut_node *node = &net->nodes.list[k / 2];
        const int side = k % 2;
        if (node->laths[side] != index) {
            continue;
        }
        int i = b->crossing_count++;
        for (; i > 0 && stops[i - 1] > node->s[side]; i--) {
            stops[i] = stops[i - 1];
            b->crossings[i] = b->crossings[i - 1];
        }
        stops[i] = node->s[side];
        b->crossings[i] =
            (crossing){.other = net->laths[node->laths[1 - side]].name, .node = k / 2};
        for (int j = 0; j < strip->slot_count; j++) {
            const taut_slot *slot = &strip->slots[j];
            if (slot->node == k / 2 && slot->side == side) {
                b->crossings[i].slot = slot;
            }
        }
    }
    const taut_status status = taut_strip_axis(net, strip, b->lath, sagitta, b->crossing_count,
                                               stops, &b->axis, &b->axis_count);
    for (int k = 0, i = 0; status == TAUT_OK && i < b->crossing_count; i++) {
        while (k + 1 < b->axis_count && b->axis[k].s < stops[i]) {
            k++;
        }
        b->crossings[i].at = b->axis[k];
    }
    return status;
}

/* The axis at a length along it, between the points next to it. */
static taut_axis_point axis_at(const band *b, double cut)
{
    int k = 1;
    while (k + 1 < b->axis_count && b->axis[k].cut < cut) {
        k++;
    }
    const taut_axis_point *p = &b->axis[k - 1], *q = &b->axis[k];
    const double t = q->cut > p->cut ? fmin(fmax((cut - p->cut) / (q->cut - p->cut), 0), 1) : 0;
    return (taut_axis_point){p->s + t * (q->s - p->s),
                             cut,
                             p->x + t * (q->x - p->x),
                             p->y + t * (q->y - p->y),
                             p->theta + t * (q->theta - p->theta),
                             p->skew + t * (q->skew - p->skew)};
}

/* ---- one piece ---- */

/* A place beside the axis: `along` it and `up` from it. */
static void beside(const taut_axis_point *at, double along, double up, double out[2])
{
    const double c = taut_cos(at->theta), s = taut_sin(at->theta);
    out[0] = at->x + along * c - up * s;
    out[1] = at->y + along * s + up * c;
}

static void add_text(const taut_axis_point *at, const char *text, double along, double up,
                     double height, taut_flat_piece *piece)
{
    taut_piece_text *t = &piece->texts[piece->text_count++];
    snprintf(t->text, sizeof t->text, "%s", text);
    beside(at, along, up, t->at);
    t->angle = at->theta;
    t->height = height;
}

static void add_line(const taut_axis_point *at, double x0, double y0, double x1, double y1,
                     taut_flat_piece *piece)
{
    taut_piece_line *line = &piece->lines[piece->line_count++];
    beside(at, x0, y0, line->ends[0]);
    beside(at, x1, y1, line->ends[1]);
}

static double text_length(const char *text, double height)
{
    return breadth * height * (double)strlen(text);
}

/* What crosses: a slot, or the cross of a hole; and the name beside it. */
static void mark_crossing(const band *b, const crossing *x, double to, double height,
                          taut_flat_piece *piece)
{
    const double half = b->width / 2, letters = text_length(x->other, height);
    double aside = height / 2, up = half / 2;

    if (b->is_plank) {
        add_line(&x->at, -height / 2, 0, height / 2, 0, piece);
        add_line(&x->at, 0, -height / 2, 0, height / 2, piece);
        up = height;
    } else if (x->slot != NULL) {
        taut_piece_slot *slot = &piece->slots[piece->slot_count++];
        const double side = x->slot->side == 0 ? 1 : -1, wide = x->slot->width / 2;
        slot->node = x->node;
        beside(&x->at, -wide, side * half, slot->corners[0]);
        beside(&x->at, -wide, side * (half - x->slot->depth), slot->corners[1]);
        beside(&x->at, wide, side * (half - x->slot->depth), slot->corners[2]);
        beside(&x->at, wide, side * half, slot->corners[3]);
        aside = wide + height / 2;
        up = side * half / 2;
    }
    const double way = x->at.cut + aside + letters > to ? -1 : 1; /* on the piece */
    add_text(&x->at, x->other, way * (aside + letters / 2), up, height, piece);
}

/* Its name at both ends, n on the side of the normal, and an arrow to the end. */
static void mark_ends(const band *b, double from, double to, double height, taut_flat_piece *piece)
{
    const double name = text_length(piece->name, height) / 2 + height / 2;
    const double high = b->width / 2 - height;
    double low = -b->width / 2 + height;
    const taut_axis_point first = axis_at(b, from), last = axis_at(b, to);

    for (int k = 0; k < b->crossing_count;
         k++) { /* slots from below have names beside them there */
        if (b->crossings[k].slot != NULL && b->crossings[k].slot->side == 1) {
            low = b->width / 4 - height;
        }
    }
    add_text(&first, piece->name, name, low, height, piece);
    add_text(&last, piece->name, -name, low, height, piece);
    add_text(&first, "n", height, b->is_plank ? 0 : high, height, piece);
    add_line(&last, -3 * height, high, -height / 2, high, piece);
    add_line(&last, -height, high + height / 4, -height / 2, high, piece);
    add_line(&last, -height, high - height / 4, -height / 2, high, piece);
}

static void turn_point(double point[2], double cosine, double sine)
{
    const double x = point[0];
    point[0] = cosine * x + sine * point[1];
    point[1] = cosine * point[1] - sine * x;
}

/* All points of a piece turned by -angle. */
static void turn_piece(taut_flat_piece *piece, double angle)
{
    const double c = taut_cos(angle), s = taut_sin(angle);
    if (angle == 0) {
        return;
    }
    for (int k = 0; k < piece->outline_count; k++) {
        turn_point(piece->outline[k], c, s);
    }
    for (int k = 0; k < 4 * piece->slot_count; k++) {
        turn_point(piece->slots[k / 4].corners[k % 4], c, s);
    }
    for (int k = 0; k < 2 * piece->line_count; k++) {
        turn_point(piece->lines[k / 2].ends[k % 2], c, s);
    }
    for (int k = 0; k < piece->text_count; k++) {
        turn_point(piece->texts[k].at, c, s);
        piece->texts[k].angle -= angle;
    }
}

static void move_piece(taut_flat_piece *piece, const double by[2])
{
    for (int d = 0; d < 2; d++) {
        for (int k = 0; k < piece->outline_count; k++) {
            piece->outline[k][d] += by[d];
        }
        for (int k = 0; k < 4 * piece->slot_count; k++) {
            piece->slots[k / 4].corners[k % 4][d] += by[d];
        }
        for (int k = 0; k < 2 * piece->line_count; k++) {
            piece->lines[k / 2].ends[k % 2][d] += by[d];
        }
        for (int k = 0; k < piece->text_count; k++) {
            piece->texts[k].at[d] += by[d];
        }
    }
}

/* The stretch from `from` to `to` of a band. */
static taut_status cut_piece(const builder *to_build, const band *b, double from, double to,
                             taut_flat_piece *piece)
{
    const double height = letter * b->width, half = b->width / 2;
    const taut_axis_point ends[2] = {axis_at(b, from), axis_at(b, to)};
    int inner = 0;

    for (int k = 0; k < b->axis_count; k++) {
        inner += b->axis[k].cut > from && b->axis[k].cut < to;
    }
    const int is_straight =
        b->axis[b->axis_count - 1].y == 0 && b->axis[b->axis_count - 1].theta == 0;
    inner = is_straight ? 0 : inner;
    piece->outline = taut_arena_take(to_build->arena, 2 * ((size_t)inner + 2), 2 * sizeof(double));
    piece->slots =
        taut_arena_take(to_build->arena, (size_t)b->crossing_count + 1, sizeof *piece->slots);
    piece->lines =
        taut_arena_take(to_build->arena, 2 * (size_t)b->crossing_count + 3, sizeof *piece->lines);
    piece->texts =
        taut_arena_take(to_build->arena, (size_t)b->crossing_count + 3, sizeof *piece->texts);
    if (taut_arena_status(to_build->arena) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    piece->outline_count = 2 * (inner + 2);
    for (int side = -1; side <= 1; side += 2) {
        const int last = piece->outline_count - 1;
        double(*points)[2] = piece->outline;
        int i = 0;
        beside(&ends[0], ends[0].skew * side * half, side * half, points[side < 0 ? 0 : last]);
        for (int k = 0; !is_straight && k < b->axis_count; k++) {
            if (b->axis[k].cut > from && b->axis[k].cut < to) {
                i++;
                beside(&b->axis[k], b->axis[k].skew * side * half, side * half,
                       points[side < 0 ? i : last - i]);
            }
        }
        beside(&ends[1], ends[1].skew * side * half, side * half,
               points[side < 0 ? i + 1 : last - i - 1]);
    }
    for (int k = 0; k < b->crossing_count; k++) {
        const double at = b->crossings[k].at.cut;
        if (at >= from && at <= to) {
            mark_crossing(b, &b->crossings[k], to, height, piece);
        }
    }
    mark_ends(b, from, to, height, piece);
    turn_piece(piece, is_straight ? 0 : taut_atan2(ends[1].y - ends[0].y, ends[1].x - ends[0].x));
    return TAUT_OK;
}

/* ---- splits ---- */

static taut_flat_piece *next_piece(builder *to, const band *b, int part)
{
    taut_pieces *pieces = to->pieces;
    if (pieces->count == to->room) {
        const int room = to->room > 0 ? 2 * to->room : 64;
        taut_flat_piece *list = taut_arena_take(to->arena, (size_t)room, sizeof *list);
        if (list == NULL) {
            return NULL;
        }
        if (pieces->count > 0) {
            memcpy(list, pieces->list, (size_t)pieces->count * sizeof *list);
        }
        pieces->list = list;
        to->room = room;
    }
    taut_flat_piece *piece = &pieces->list[pieces->count++];
    *piece = (taut_flat_piece){.lath = b->index};
    if (part == 0) {
        snprintf(piece->name, sizeof piece->name, "%s", b->lath->name);
    } else {
        snprintf(piece->name, sizeof piece->name, "%s/%d", b->lath->name, part);
    }
    return piece;
}

/* The farthest place to split at, midway between two crossings, in (from, from + most]; *next: the
 * first one after `from`. Infinity where there is none. */
static double split_after(const band *b, double from, double most, double *next)
{
    double found = INFINITY;
    *next = b->axis[b->axis_count - 1].cut;
    for (int k = b->crossing_count - 1; k > 0; k--) {
        const double at = (b->crossings[k - 1].at.cut + b->crossings[k].at.cut) / 2;
        if (at > from) {
            found = at - from <= most && found == INFINITY ? at : found;
            *next = at;
        }
    }
    return found;
}

/* needed: of the worst of all. */
static taut_status refuse_sheet(const builder *to, const band *b, double needed, int across,
                                taut_error *error)
{
    static const double digits = 5e-6; /* of the message */
    const int scale = to->net->carrier->scale;
    return taut_fail(error, TAUT_NO_SOLUTION, "sheet", across ? "/sheet/size/1" : "/sheet/size/0",
                     ldexp(to->sheet[across], scale), ldexp(needed, scale),
                     "a piece of %s is %.6g %s, and cannot be split between crossings: take sheets "
                     "that are at least %.6g %s",
                     b->lath->name, ldexp(needed, scale), across ? "across" : "long",
                     ldexp(needed * (1 + digits), scale), across ? "across" : "long");
}

/* A part that no sheet is long enough for is looked at, and not made. */
static taut_status cut_band(builder *to, const band *b, taut_error *error)
{
    const double whole = b->axis[b->axis_count - 1].cut;
    const double most = to->sheet[0] > 0 ? to->sheet[0] : INFINITY;
    double from = 0;

    for (int part = whole > most; from < whole; part++) {
        double until = whole, next = whole;
        if (whole - from > most) {
            until = split_after(b, from, most, &next);
            if (until == INFINITY) {
                to->worst = next - from > to->needed ? b : to->worst;
                to->needed = fmax(to->needed, next - from);
                from = next > from ? next : whole;
                continue;
            }
        }
        taut_flat_piece *piece = next_piece(to, b, part);
        if (piece == NULL || cut_piece(to, b, from, until, piece) != TAUT_OK) {
            return taut_fail_memory(error);
        }
        from = until;
    }
    return TAUT_OK;
}

/* ---- sheets ---- */

/* Rounding takes no point over the border: a sheet of their own grows, of a given one they stay. */
static void hold_on_sheet(taut_flat_piece *piece, int is_given, double size[2])
{
    for (int k = 0; k < piece->outline_count; k++) {
        for (int d = 0; d < 2; d++) {
            double *x = &piece->outline[k][d];
            size[d] = is_given ? size[d] : fmax(size[d], *x);
            *x = fmin(fmax(*x, 0), size[d]);
        }
    }
}

static taut_status place(builder *to, const band *bands, double gap, taut_error *error)
{
    static const double least_gap =
        1e-12; /* of the largest piece: what is beside another is not over it by rounding */
    taut_pieces *pieces = to->pieces;
    double largest = 0;
    int worst[2] = {0, 0}; /* the longest and the widest */
    taut_sheet_box *boxes = taut_arena_take(to->arena, (size_t)pieces->count + 1, sizeof *boxes);
    double(*low)[2] = taut_arena_take(to->arena, (size_t)pieces->count + 1, sizeof *low);

    if (boxes == NULL || low == NULL) {
        return taut_fail_memory(error);
    }
    for (int i = 0; i < pieces->count; i++) {
        const taut_flat_piece *piece = &pieces->list[i];
        for (int d = 0; d < 2; d++) {
            double high = -INFINITY;
            low[i][d] = INFINITY;
            for (int k = 0; k < piece->outline_count; k++) {
                low[i][d] = fmin(low[i][d], piece->outline[k][d]);
                high = fmax(high, piece->outline[k][d]);
            }
            boxes[i].size[d] = high - low[i][d];
            largest = fmax(largest, boxes[i].size[d]);
            worst[d] = boxes[i].size[d] > boxes[worst[d]].size[d] ? i : worst[d];
        }
    }
    for (int d = 0; d < 2 && to->sheet[0] > 0 && pieces->count > 0; d++) {
        const int i = worst[d];
        if (boxes[i].size[d] > to->sheet[d]) {
            return refuse_sheet(to, &bands[pieces->list[i].lath], boxes[i].size[d], d, error);
        }
    }
    memcpy(pieces->size, to->sheet, sizeof pieces->size);
    gap = fmax(gap, least_gap * largest);
    if (taut_sheet_pack(to->arena, pieces->count, boxes, gap, pieces->size, &pieces->sheets) !=
        TAUT_OK) {
        return taut_fail_memory(error);
    }
    for (int i = 0; i < pieces->count; i++) {
        const double by[2] = {boxes[i].at[0] - low[i][0], boxes[i].at[1] - low[i][1]};
        pieces->list[i].sheet = boxes[i].sheet;
        move_piece(&pieces->list[i], by);
        hold_on_sheet(&pieces->list[i], to->sheet[0] > 0, pieces->size);
    }
    return TAUT_OK;
}

taut_status taut_pieces_new(const taut_net *net, const taut_strip *strips, double gap,
                            double tolerance, taut_pieces *pieces, taut_error *error)
{
    const taut_trace_sheet *sheet = net->problem->sheet;
    const int scale = net->carrier->scale;
    builder to = {.net = net, .arena = net->arena, .pieces = pieces};
    band *bands = taut_arena_take(net->arena, (size_t)net->count + 1, sizeof *bands);
    taut_status status = TAUT_OK;

    *pieces = (taut_pieces){0};
    if (bands == NULL) {
        return taut_fail_memory(error);
    }
    for (int d = 0; d < 2 && sheet != NULL; d++) {
        to.sheet[d] = ldexp(sheet->size[d], -scale);
    }
    for (int k = 0; status == TAUT_OK && k < net->count; k++) {
        if (make_band(net, strips, tolerance * net->carrier->size, k, &bands[k]) != TAUT_OK) {
            return taut_fail_memory(error);
        }
        status = cut_band(&to, &bands[k], error);
    }
    if (status == TAUT_OK && to.worst != NULL) {
        return refuse_sheet(&to, to.worst, to.needed, 0, error);
    }
    return status == TAUT_OK ? place(&to, bands, ldexp(gap, -scale), error) : status;
}
