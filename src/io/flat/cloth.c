#include "io/flat/cloth.h"

#include "core/constants.h"
#include "core/elementary/elementary.h"
#include "core/fail.h"
#include "core/unit.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { CUT, SEW, FOLD, MARK, TEXT, ROLL, LAYERS };
static const taut_flat_layer layers[LAYERS] = {
    [CUT] = {"CUT", "1", "#d00000"},   [SEW] = {"SEW", "5", "#0000d0"},
    [FOLD] = {"FOLD", "6", "#a000a0"}, [MARK] = {"MARK", "3", "#008000"},
    [TEXT] = {"TEXT", "4", "#006060"}, [ROLL] = {"ROLL", "8", "#808080"}};
/* Of chords, in mm and over the roll; of letters, over a piece's width, in mm at most; of the arrow, over its length. */
static const double chord = 0.05, chord_share = 1e-5, letters = 0.05, letters_most = 20,
                    arrow = 0.2, barb = 0.2;

enum { LOOK = 4 /* places of a span, for its bend */, LINES = 7, TEXTS = 6 /* of a piece */ };
/* A mark reaches so far into the allowance, or so far, in mm, into the piece where there is none; its half width over that; and letters
 * beside it. */
static const double mark_share = 0.6, mark_length = 5, mark_wide = 0.35, mark_letters = 0.8;

typedef struct drawing {
    const taut_model *model;
    taut_arena *arena;
    taut_flat *flat;
    double error; /* of chords, in the model's unit */
    double most;  /* height of letters */
    double millimetre;
} drawing;

static const taut_record *member(const taut_record *object, const char *key)
{
    return object != NULL && taut_record_kind_of(object) == TAUT_RECORD_OBJECT
               ? taut_record_get(object, key)
               : NULL;
}

static const taut_curve *curve_named(const taut_model *model, const char *piece, const char *what)
{
    char name[TAUT_NAME_MAX + 16];
    snprintf(name, sizeof name, "%.200s.%s", piece, what);
    for (int i = 0; i < taut_model_curve_count(model); i++) {
        if (strcmp(taut_curve_name(taut_model_curve(model, i)), name) == 0) {
            return taut_model_curve(model, i);
        }
    }
    return NULL;
}

int taut_flat_is_cloth(const taut_model *model)
{
    const taut_record *details = taut_model_details(model), *kind = member(details, "pattern");
    return kind != NULL && strcmp(taut_record_text(kind), "cloth") == 0 &&
           member(details, "roll") != NULL && taut_record_count(member(details, "pieces")) > 0;
}

/* How many chords a span is to have. */
static int chords_of(const drawing *to, const taut_curve *curve, double a, double b)
{
    enum { MOST = 1000 };
    double bend = 0;
    for (int k = 0; k <= LOOK; k++) {
        double y[3][3];
        taut_curve_eval(curve, a + (b - a) * k / LOOK, 2, y[0]);
        bend = fmax(bend, taut_hypot(y[2][0], y[2][1]));
    }
    const double count = ceil(1.1 * (b - a) * sqrt(bend / (8 * to->error)));
    return count > 1 ? (int)fmin(count, MOST) : 1;
}

/* The curve as a polyline from a place on; closed: without its last point. */
static void add_curve(drawing *to, int layer, const taut_curve *curve, const double at[2],
                      int closed)
{
    const taut_basis *basis = taut_curve_t(curve);
    const double *breaks = taut_basis_breaks(basis);
    const int spans = taut_basis_span_count(basis);
    size_t count = 1, n = 0;

    for (int i = 0; i < spans; i++) {
        count += (size_t)chords_of(to, curve, breaks[i], breaks[i + 1]);
    }
    double(*points)[2] = taut_arena_take(to->arena, count, sizeof *points);
    if (points == NULL) {
        return;
    }
    for (int i = 0; i < spans; i++) {
        const int chords = chords_of(to, curve, breaks[i], breaks[i + 1]);
        for (int k = i == 0 ? 0 : 1; k <= chords; k++) {
            const double t =
                k == chords ? breaks[i + 1] : breaks[i] + (breaks[i + 1] - breaks[i]) * k / chords;
            double y[3];
            taut_curve_eval(curve, t, 0, y);
            points[n][0] = y[0] + at[0];
            points[n][1] = y[1] + at[1];
            n++;
        }
    }
    to->flat->lines[to->flat->line_count++] =
        (taut_flat_line){layer, closed, n - (closed ? 1 : 0), (const double(*)[2])points};
}

static void add_text(drawing *to, const char *text, const double at[2], double angle, double height)
{
    const char *own = taut_arena_text(to->arena, text);
    to->flat->texts[to->flat->text_count++] =
        (taut_flat_text){own != NULL ? own : "", {at[0], at[1]}, angle, height};
}

/* From its tail to its tip along the warp, and its barbs. */
static void add_arrow(drawing *to, const double middle[2], double length)
{
    const double half = length / 2, b = barb * half;
    const double shape[5][2] = {{-half, 0}, {half, 0}, {half - b, b}, {half, 0}, {half - b, -b}};
    double(*points)[2] = taut_arena_take(to->arena, 5, sizeof *points);
    for (int k = 0; points != NULL && k < 5; k++) {
        points[k][0] = middle[0] + shape[k][0];
        points[k][1] = middle[1] + shape[k][1];
    }
    to->flat->lines[to->flat->line_count++] =
        (taut_flat_line){MARK, 0, 5, (const double(*)[2])points};
}

/* ---- what is sewn ---- */

static const char *const edge_names[4] = {"right", "end", "left", "start"};

static double number_of(const taut_record *object, const char *key)
{
    const taut_record *found = member(object, key);
    return found != NULL ? taut_record_number(found) : 0;
}

/* The lines to sew along, where the cloth is cut elsewhere; hems are folded there. */
static void add_sewing(drawing *to, const taut_record *piece, const char *name, const double at[2])
{
    int any = 0;
    for (int e = 0; e < 4; e++) {
        any |= number_of(member(member(piece, "edges"), edge_names[e]), "allowance") > 0;
    }
    for (int e = 0; any && e < 4; e++) {
        const taut_curve *curve = curve_named(to->model, name, edge_names[e]);
        const taut_record *hem = member(member(member(piece, "edges"), edge_names[e]), "hem");
        if (curve != NULL) {
            add_curve(to, hem != NULL ? FOLD : SEW, curve, at, 0);
        }
    }
}

/* One mark: from a place of the seam along its outward normal. */
static void add_mark(drawing *to, const char *notch, const double place[2], const double out[2],
                     double length)
{
    const int is_v = strcmp(notch, "v") == 0, is_dot = strcmp(notch, "dot") == 0;
    const size_t count = is_dot ? 5 : is_v ? 3 : 2;
    const double wide = mark_wide * length;
    double(*points)[2] = taut_arena_take(to->arena, count, sizeof *points);
    for (size_t k = 0; points != NULL && k < count; k++) {
        /* along the normal and across it */
        const double slit[2] = {k == 0 ? 0 : length, 0};
        const double v[2] = {k == 1 ? 0 : length, k == 0 ? -wide : k == 2 ? wide : 0};
        const double dot[2] = {k == 0 || k == 4 ? -wide
                               : k == 2         ? wide
                                                : 0,
                               k == 1   ? -wide
                               : k == 3 ? wide
                                        : 0};
        const double *shape = is_dot ? dot : is_v ? v : slit;
        points[k][0] = place[0] + shape[0] * out[0] - shape[1] * out[1];
        points[k][1] = place[1] + shape[0] * out[1] + shape[1] * out[0];
    }
    to->flat->lines[to->flat->line_count++] =
        (taut_flat_line){MARK, is_dot, is_dot ? 4 : count, (const double(*)[2])points};
}

/* The part of its seam that an edge is. */
static void part_of(const taut_record *edge, double part[2])
{
    const taut_record *told = member(edge, "part");
    part[0] = told != NULL ? taut_record_number(taut_record_at(told, 0)) : 0;
    part[1] = told != NULL ? taut_record_number(taut_record_at(told, 1)) : 1;
}

/* The marks along an edge, numbered from the seam's start. */
static void add_marks(drawing *to, const taut_record *piece, const char *name, int e,
                      const taut_record *seam, const double at[2])
{
    const char *what = edge_names[e];
    const taut_record *edge = member(member(piece, "edges"), what);
    const taut_record *marks = member(seam, "marks");
    const taut_curve *curve = curve_named(to->model, name, what);
    const char *notch =
        taut_record_text(member(member(taut_model_details(to->model), "marks"), "notch"));
    const double whole = number_of(seam, "length"), left = number_of(edge, "allowance");
    const double length = left > 0 ? mark_share * left : -mark_length * to->millimetre;
    const int is_turned = member(edge, "turned") != NULL;
    double part[2];

    part_of(edge, part);
    for (size_t k = 0; curve != NULL && k < taut_record_count(marks); k++) {
        const double share = taut_record_number(taut_record_at(marks, k)) / whole;
        const double own = is_turned ? 1 - share : share; /* the seam runs the other way */
        const double x = (own - part[0]) / (part[1] - part[0]);
        double y[2][3];
        char number[24];
        if (!(x > 0) || !(x < 1)) {
            continue;
        }
        taut_curve_eval(curve, x, 1, y[0]);
        const double speed = taut_hypot(y[1][0], y[1][1]), sign = e < 2 ? 1 : -1;
        const double out[2] = {sign * y[1][1] / speed, -sign * y[1][0] / speed};
        const double place[2] = {y[0][0] + at[0], y[0][1] + at[1]};
        const double height = fmin(mark_letters * fabs(length), to->most / 2);
        const double beside[2] = {place[0] - height * out[0], place[1] - height * out[1]};
        add_mark(to, notch, place, out, length);
        snprintf(number, sizeof number, "%zu", k + 1);
        add_text(to, number, beside, taut_atan2(y[1][1], y[1][0]), height);
    }
}

/* ---- names ---- */

/* Who is on the other side of a seam: the only other piece, or nobody to name. */
static void add_neighbour(drawing *to, const char *name, const taut_record *seam,
                          const double place[2], double angle, double height)
{
    const taut_record *pieces = member(seam, "pieces");
    const char *first = taut_record_text(taut_record_at(pieces, 0));
    const char *second = taut_record_text(taut_record_at(pieces, 1));
    const char *own = taut_record_text(member(seam, "name"));
    char text[64];
    if (taut_record_count(pieces) == 2) {
        snprintf(text, sizeof text, "%.20s: %.20s", own, strcmp(first, name) == 0 ? second : first);
    } else { /* several meet on it, or one is sewn to itself */
        snprintf(text, sizeof text, "%.20s", own);
    }
    add_text(to, text, place, angle, height);
}

/* The piece's own name and its arrow in the middle, and along each seam who is on its other side. */
static void add_names(drawing *to, const taut_record *piece, const char *name, const double at[2])
{
    const taut_record *seams = member(taut_model_details(to->model), "seams");
    double middle[4][3], centre[2] = {0, 0}, ways[4];

    for (int e = 0; e < 4; e++) {
        const taut_curve *edge = curve_named(to->model, name, edge_names[e]);
        double y[2][3];
        if (edge == NULL) {
            return;
        }
        taut_curve_eval(edge, 0.5, 1, y[0]);
        memcpy(middle[e], y[0], sizeof middle[e]);
        ways[e] = taut_atan2(y[1][1], y[1][0]);
        for (int d = 0; e % 2 == 0 && d < 2; d++) {
            centre[d] += y[0][d] / 2 + at[d] / 2;
        }
    }
    const double wide = taut_hypot(middle[2][0] - middle[0][0], middle[2][1] - middle[0][1]);
    const double height = fmin(letters * wide, to->most);
    const double above[2] = {centre[0], centre[1] + 1.5 * height};
    add_text(to, name, above, 0, height);
    add_arrow(to, centre, arrow * wide);
    for (int e = 0; e < 4; e++) {
        const taut_record *seam = member(member(member(piece, "edges"), edge_names[e]), "seam");
        for (size_t i = 0; seam != NULL && i < taut_record_count(seams); i++) {
            const taut_record *one = taut_record_at(seams, i);
            if (strcmp(taut_record_text(member(one, "name")), taut_record_text(seam)) != 0) {
                continue;
            }
            const double inward = e < 2 ? 1.2 * height : -1.2 * height;
            const double place[2] = {middle[e][0] + at[0] - inward * taut_sin(ways[e]),
                                     middle[e][1] + at[1] + inward * taut_cos(ways[e])};
            add_neighbour(to, name, one, place, ways[e], height);
            add_marks(to, piece, name, e, one, at);
        }
    }
}

/* Lines and texts from these on, turned by half a turn about a place. */
static void turn(drawing *to, size_t line, size_t text, const double about[2])
{
    for (; line < to->flat->line_count; line++) {
        taut_flat_line *one = &to->flat->lines[line];
        double(*points)[2] = taut_arena_copy(to->arena, one->points, one->count, sizeof *points);
        for (size_t k = 0; points != NULL && k < 2 * one->count; k++) {
            points[k / 2][k % 2] = 2 * about[k % 2] - one->points[k / 2][k % 2];
        }
        one->points = (const double(*)[2])points;
    }
    for (; text < to->flat->text_count; text++) {
        taut_flat_text *one = &to->flat->texts[text];
        for (int d = 0; d < 2; d++) {
            one->at[d] = 2 * about[d] - one->at[d];
        }
        one->angle += one->angle > 0 ? -TAUT_PI : TAUT_PI;
    }
}

/* The lower side: all of it mirrored across the roll, texts but for their places. */
static void mirror(drawing *to)
{
    for (size_t line = 0; line < to->flat->line_count; line++) {
        taut_flat_line *one = &to->flat->lines[line];
        double(*points)[2] = taut_arena_copy(to->arena, one->points, one->count, sizeof *points);
        for (size_t k = 0; points != NULL && k < one->count; k++) {
            points[k][1] = to->flat->size[1] - points[k][1];
        }
        one->points = (const double(*)[2])points;
    }
    for (size_t text = 0; text < to->flat->text_count; text++) {
        taut_flat_text *one = &to->flat->texts[text];
        one->at[1] = to->flat->size[1] - one->at[1];
        one->angle = -one->angle;
    }
}

static int add_piece(drawing *to, const taut_record *piece, const taut_record *roll)
{
    const char *name = taut_record_text(member(piece, "name"));
    const taut_curve *cut = curve_named(to->model, name, "cut");
    const taut_record *places = member(roll, "pieces");
    for (size_t k = 0; k < taut_record_count(places); k++) {
        const taut_record *place = taut_record_at(places, k), *pair = member(place, "at");
        const double at[2] = {taut_record_number(taut_record_at(pair, 0)),
                              taut_record_number(taut_record_at(pair, 1))};
        if (strcmp(taut_record_text(member(place, "name")), name) == 0 && cut != NULL &&
            isfinite(at[0]) && isfinite(at[1])) {
            const size_t line = to->flat->line_count, text = to->flat->text_count;
            add_curve(to, CUT, cut, at, 1);
            add_sewing(to, piece, name, at);
            add_names(to, piece, name, at);
            if (member(place, "turned") != NULL) {
                turn(to, line, text, at);
            }
            return 1;
        }
    }
    return 0;
}

static void add_roll(drawing *to, const double size[2])
{
    double(*corners)[2] = taut_arena_take(to->arena, 4, sizeof *corners);
    for (int k = 0; corners != NULL && k < 4; k++) {
        corners[k][0] = k == 1 || k == 2 ? size[0] : 0;
        corners[k][1] = k >= 2 ? size[1] : 0;
    }
    to->flat->lines[to->flat->line_count++] =
        (taut_flat_line){ROLL, 1, 4, (const double(*)[2])corners};
}

taut_status taut_flat_read_cloth(const taut_model *model, taut_arena *arena, taut_flat *flat,
                                 taut_error *error)
{
    const taut_record *details = taut_model_details(model), *roll = member(details, "roll");
    const taut_record *pieces = member(details, "pieces");
    const taut_record *side = member(member(details, "cloth"), "side");
    const size_t count = taut_record_count(pieces);
    const double millimetre = taut_unit_ratio("mm", taut_model_unit(model));
    drawing to = {.model = model,
                  .arena = arena,
                  .flat = flat,
                  .most = letters_most * millimetre,
                  .millimetre = millimetre};
    int is_fine = 1;

    const taut_record *seams = member(details, "seams");
    size_t marks = 0;
    for (size_t k = 0; k < taut_record_count(seams); k++) { /* of each side */
        marks += 2 * taut_record_count(member(taut_record_at(seams, k), "marks"));
    }
    *flat =
        (taut_flat){.layer_count = LAYERS,
                    .text_layer = TEXT,
                    .layers = layers,
                    .lines = taut_arena_take(arena, LINES * count + marks + 1, sizeof *flat->lines),
                    .texts = taut_arena_take(arena, TEXTS * count + marks + 1, sizeof *flat->texts),
                    .size = {taut_record_number(member(roll, "length")),
                             taut_record_number(member(roll, "width"))}};
    if (taut_arena_status(arena) != TAUT_OK) {
        return taut_fail_memory(error);
    }
    to.error = fmin(chord * millimetre, chord_share * fmax(flat->size[0], flat->size[1]));
    is_fine = flat->size[0] > 0 && flat->size[1] > 0 && isfinite(flat->size[0] + flat->size[1]);
    add_roll(&to, flat->size);
    for (size_t k = 0; is_fine && k < count; k++) {
        is_fine = add_piece(&to, taut_record_at(pieces, k), roll);
    }
    if (is_fine && side != NULL && taut_record_kind_of(side) == TAUT_RECORD_TEXT &&
        strcmp(taut_record_text(side), "lower") == 0) {
        mirror(&to);
    }
    if (taut_arena_status(arena) != TAUT_OK) {
        return taut_fail_memory(error);
    }
    return is_fine
               ? TAUT_OK
               : taut_fail(error, TAUT_BAD_INPUT, "value", "/details/roll", taut_none, taut_none,
                           "the model's pieces are not what a pattern tells of them");
}
