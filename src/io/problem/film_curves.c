#include "io/problem/film_curves.h"

#include "core/fail.h"
#include "core/vec3.h"
#include "geometry/keep.h"
#include "io/problem/boundary_file.h"
#include "io/problem/film_curves_closed.h"
#include "io/problem/film_curves_cut.h"
#include "taut/operations.h"

#include <math.h>
#include <stddef.h>
#include <stdio.h>
#include <string.h>

enum { DEGREE = 4, COUNT = 12, DEGREE_MOST = 10, COUNT_MOST = 100 };
static const double gap_closed = 1e-9; /* of the size */
static const double gap_filed = 1e-6;  /* the same of curves of a file, whose decimals may be few */
static const double gap_clamped =
    1e-12; /* of the size, from an end to its control point: rounding */
static const char *const strangers[] = {"boundary", /* beside "curves" */
                                        "corners",  "edges", "points",        "patches",   "seams",
                                        "u",        "v",     "force_density", "prestress", NULL};

typedef struct reading {
    taut_problem *problem;
    taut_film_curve_read *read;
    taut_reader *document;
    const char *member; /* that they come from */
    int count;
    const taut_curve *curves[TAUT_FILM_CURVES_MAX];
    int numbers[TAUT_FILM_CURVES_MAX]; /* what messages call them */
} reading;

static taut_status read_curve(const taut_json *at, void *into, taut_error *error)
{
    reading *r = into;

    (void)error; /* that of the document */
    r->numbers[r->count] = r->count;
    r->read(r->document, at, r->problem->arena, &r->curves[r->count++]);
    return r->document->status;
}

static void end_of(const taut_curve *curve, int end, double x[3])
{
    const taut_basis *t = taut_curve_t(curve);
    (void)taut_curve_eval(curve, end == 0 ? taut_basis_lo(t) : taut_basis_hi(t), 0, x);
}

static double distance(const taut_curve *a, int end_a, const taut_curve *b, int end_b)
{
    double x[3], y[3];
    end_of(a, end_a, x);
    end_of(b, end_b, y);
    return taut_distance(x, y);
}

static taut_status keep(taut_arena *arena, taut_curve *made, const taut_curve **curve)
{
    if (!taut_keep_curve(arena, made)) {
        return TAUT_NO_MEMORY;
    }
    *curve = made;
    return TAUT_OK;
}

static taut_status reverse(taut_arena *arena, const taut_curve **curve, taut_error *error)
{
    taut_curve *made = NULL;
    const taut_status status = taut_curve_reverse(*curve, &made, error);
    return status == TAUT_OK && keep(arena, made, curve) != TAUT_OK ? taut_fail_memory(error)
                                                                    : status;
}

static double size_of(const reading *r)
{
    double size = 0, first[3], x[3];

    end_of(r->curves[0], 0, first);
    for (int k = 0; k < r->count; k++) {
        for (int end = 0; end < 2; end++) {
            end_of(r->curves[k], end, x);
            size = fmax(size, taut_distance(x, first));
        }
    }
    return size;
}

/* Curves of a file in the order in which they meet: each is followed by the one with an end nearest to its own. */
static void arrange(reading *r)
{
    int end = 1;

    for (int k = 1; k < r->count; k++) {
        int nearest = k;
        double least = INFINITY;
        int other = 0;
        for (int j = k; j < r->count; j++) {
            for (int e = 0; e < 2; e++) {
                const double away = distance(r->curves[k - 1], end, r->curves[j], e);
                if (away < least) {
                    least = away;
                    nearest = j;
                    other = e;
                }
            }
        }
        const taut_curve *next = r->curves[nearest];
        const int number = r->numbers[nearest];
        r->curves[nearest] = r->curves[k];
        r->curves[k] = next;
        r->numbers[nearest] = r->numbers[k];
        r->numbers[k] = number;
        end = 1 - other;
    }
}

/* The control point that a curve begins or ends in, or NULL where it does so elsewhere. Evaluated there it may be a rounding off. */
static const double *end_point(const taut_curve *curve, int end, double size)
{
    const int last = taut_basis_count(taut_curve_t(curve)) - 1;
    const double *point = taut_curve_points(curve) + (end == 0 ? 0 : 3 * last);
    double x[3];

    end_of(curve, end, x);
    return taut_distance(x, point) <= gap_clamped * size ? point : NULL;
}

/* Ends that meet within the file's decimals become one point, that of the curve which begins there: an edge of the film has one
 * corner, and could not be on both. Where a curve does not end in its last control point it stays as it is. */
static taut_status close_corner(reading *r, int k, int next_one, double size, taut_error *error)
{
    const taut_curve *curve = r->curves[k], *next = r->curves[next_one];
    const size_t count = (size_t)taut_basis_count(taut_curve_t(curve));
    const double *here = end_point(curve, 1, size), *begin = end_point(next, 0, size);
    double there[3];
    taut_curve *made = NULL;

    end_of(next, 0, there);
    if (begin != NULL) {
        memcpy(there, begin, sizeof there);
    }
    if (here == NULL || taut_distance(there, here) == 0) {
        return TAUT_OK;
    }
    double *points =
        taut_arena_copy(r->problem->arena, taut_curve_points(curve), count, 3 * sizeof(double));
    if (points == NULL) {
        return taut_fail_memory(error);
    }
    memcpy(points + 3 * (count - 1), there, sizeof there);
    const taut_status status = taut_curve_new(taut_curve_name(curve), taut_curve_t(curve), points,
                                              taut_curve_weights(curve), &made, error);
    return status == TAUT_OK && keep(r->problem->arena, made, &r->curves[k]) != TAUT_OK
               ? taut_fail_memory(error)
               : status;
}

/* How far the end of curve k may be from where the next begins: only what ends in a control point can be moved there. */
static double gap_after(const reading *r, int k, double size)
{
    const int is_filed = strcmp(r->member, "boundary") == 0;
    return (is_filed && end_point(r->curves[k], 1, size) != NULL ? gap_filed : gap_closed) * size;
}

/* Every curve begins where the one before it ends; the first as the second meets it. */
static taut_status run_round(reading *r, taut_error *error)
{
    const double size = size_of(r);
    const taut_curve **c = r->curves;
    taut_status status = TAUT_OK;

    if (fmin(distance(c[0], 0, c[1], 0), distance(c[0], 0, c[1], 1)) <
        fmin(distance(c[0], 1, c[1], 0), distance(c[0], 1, c[1], 1))) {
        status = reverse(r->problem->arena, &c[0], error);
    }
    for (int k = 1; status == TAUT_OK && k < r->count; k++) {
        if (distance(c[k - 1], 1, c[k], 1) < distance(c[k - 1], 1, c[k], 0)) {
            status = reverse(r->problem->arena, &c[k], error);
        }
    }
    for (int k = 0; status == TAUT_OK && k < r->count; k++) {
        const int next = (k + 1) % r->count;
        const double away = distance(c[k], 1, c[next], 0), gap = gap_after(r, k, size);
        if (!(away <= gap)) {
            const taut_json at = taut_json_member(r->document->object, r->member);
            status = taut_json_fail(&at, error, "curve-ends", away, gap,
                                    "curve %d ends %.3g away from where curve %d begins: expected "
                                    "curves that go round, in their order",
                                    r->numbers[k], away, r->numbers[next]);
        }
    }
    for (int k = 0; status == TAUT_OK && k < r->count; k++) {
        status = close_corner(r, k, (k + 1) % r->count, size, error);
    }
    return status;
}

static taut_status halve(taut_arena *arena, const taut_curve *curve, const taut_curve *halves[2],
                         taut_error *error)
{
    const taut_basis *t = taut_curve_t(curve);
    taut_model *pieces = NULL;
    taut_status status =
        taut_curve_split(curve, 0.5 * (taut_basis_lo(t) + taut_basis_hi(t)), &pieces, error);

    for (int k = 0; status == TAUT_OK && k < 2; k++) {
        taut_curve *made = NULL;
        status = taut_curve_copy(taut_model_curve(pieces, k), &made);
        if (status != TAUT_OK || keep(arena, made, &halves[k]) != TAUT_OK) {
            status = taut_fail_memory(error);
        }
    }
    taut_model_free(pieces);
    return status;
}

static void set_curve(taut_film_problem *patch, int edge, const taut_curve *curve)
{
    patch->edges[edge] = (taut_film_edge){.kind = TAUT_FILM_FIXED, .curve = curve};
}

static taut_status make_one(reading *r, const taut_basis *basis, taut_film_problem *data,
                            taut_error *error)
{
    taut_status status = reverse(r->problem->arena, &r->curves[2], error);
    if (status == TAUT_OK) {
        status = reverse(r->problem->arena, &r->curves[3], error);
    }
    data->u = data->v = basis;
    set_curve(data, 2, r->curves[0]);
    set_curve(data, 1, r->curves[1]);
    set_curve(data, 3, r->curves[2]);
    set_curve(data, 0, r->curves[3]);
    return status;
}

/* One patch at each corner of each polygon; what they share. */
typedef struct layout {
    taut_film_cut cut;
    const taut_curve *halves[TAUT_FILM_CURVES_MAX][2]; /* the second run backwards */
    taut_film_problem *patches;
    taut_film_seam
        *seams; /* two of each line, from either end to its middle; then those to the centres */
    taut_film_side *sides; /* two of each seam */
    int lines[TAUT_FILM_LINES_MAX][2];
} layout;

/* An edge of a patch that is half a side of its polygon, from the corner to the middle. */
static void lay_half(layout *l, int side, int corner, int half, int patch, int edge)
{
    if (side >= 0) {
        set_curve(&l->patches[patch], edge, l->halves[side][half]);
        return;
    }
    const int line = -1 - side, end = corner != l->cut.from[line];
    l->sides[2 * (2 * line + end) + l->lines[line][end]++] = (taut_film_side){patch, edge, 0};
}

/* Patches from `first` on, and the seams to their centre. */
static void lay_polygon(layout *l, const taut_film_polygon *p, int first, const taut_basis *basis,
                        double tension)
{
    const int lines = 2 * l->cut.line_count;

    for (int k = 0; k < p->count; k++) {
        const int patch = first + k, before = (k + p->count - 1) % p->count;
        taut_film_problem *made = &l->patches[patch];
        made->u = made->v = basis;
        made->tension = tension;
        made->corner_kinds[3] = TAUT_FILM_FREE;
        for (int c = 0; c < 3; c++) {
            const int is_known = (c != 2 && p->sides[k] >= 0) || (c != 1 && p->sides[before] >= 0);
            made->corner_kinds[c] = is_known ? made->corner_kinds[c] : TAUT_FILM_FREE;
        }
        lay_half(l, p->sides[k], p->corners[k], 0, patch, 2);
        lay_half(l, p->sides[before], p->corners[k], 1, patch, 0);
        l->sides[2 * (lines + patch)] = (taut_film_side){patch, 1, 0};
        l->sides[2 * (lines + patch) + 1] = (taut_film_side){first + (k + 1) % p->count, 3, 0};
    }
}

static taut_status make_round(reading *r, layout *l, const taut_basis *basis,
                              taut_film_problem *data, taut_film_parts *parts, taut_error *error)
{
    taut_arena *arena = r->problem->arena;
    const int patches = l->cut.patch_count, seams = 2 * l->cut.line_count + patches;
    l->patches = taut_arena_take(arena, (size_t)patches, sizeof *l->patches);
    l->seams = taut_arena_take(arena, (size_t)seams, sizeof *l->seams);
    l->sides = taut_arena_take(arena, 2 * (size_t)seams, sizeof *l->sides);
    taut_status status = taut_arena_status(arena) == TAUT_OK ? TAUT_OK : taut_fail_memory(error);

    for (int k = 0; status == TAUT_OK && k < r->count; k++) {
        status = halve(arena, r->curves[k], l->halves[k], error);
        if (status == TAUT_OK) {
            status = reverse(arena, &l->halves[k][1], error);
        }
    }
    for (int k = 0, first = 0; status == TAUT_OK && k < l->cut.polygon_count; k++) {
        lay_polygon(l, &l->cut.polygons[k], first, basis, data->tension);
        first += l->cut.polygons[k].count;
    }
    for (int k = 0; status == TAUT_OK && k < patches; k++) {
        char name[160];
        const char *of = data->name != NULL ? data->name : "film";
        snprintf(name, sizeof name, "%.120s-%d", of, k);
        l->patches[k].name = taut_arena_text(arena, name);
        status = l->patches[k].name != NULL ? TAUT_OK : taut_fail_memory(error);
    }
    for (int k = 0; status == TAUT_OK && k < seams; k++) {
        l->seams[k] = (taut_film_seam){.count = 2, .sides = l->sides + 2 * (ptrdiff_t)k};
    }
    data->patch_count = patches;
    data->seam_count = seams;
    data->patches = l->patches;
    data->seams = l->seams;
    *parts = (taut_film_parts){l->patches, l->seams};
    data->name = NULL;
    return status;
}

static taut_status make_patches(reading *r, const taut_basis *basis, taut_film_problem *data,
                                taut_film_parts *parts, taut_error *error)
{
    layout l = {.patches = NULL};

    taut_film_curves_cut(r->count, r->curves, TAUT_FILM_PATCHES_MAX, &l.cut);
    return r->count == 4 && l.cut.polygon_count == 1 ? make_one(r, basis, data, error)
                                                     : make_round(r, &l, basis, data, parts, error);
}

/* One or two curves of a file that close within its decimals are closed. */
static void close_each(reading *r)
{
    for (int k = 0; k < r->count && r->document->status == TAUT_OK; k++) {
        const taut_curve *curve = r->curves[k];
        const double *points = taut_curve_points(curve), gap = distance(curve, 1, curve, 0);
        double size = 0;
        for (int i = 1; i < taut_basis_count(taut_curve_t(curve)); i++) {
            size = fmax(size, taut_distance(points, points + 3 * (ptrdiff_t)i));
        }
        if (gap > gap_closed * size && gap <= gap_filed * size) {
            r->document->status = close_corner(r, k, k, size, r->document->error);
        }
    }
}

/* One curve with three corners or more gives way to its pieces between them. */
static void cut_closed(reading *r)
{
    const taut_curve *pieces[TAUT_FILM_CURVES_MAX];
    char note[64];
    int count = 0;
    r->document->status = taut_film_curve_cut(r->problem->arena, r->curves[0], TAUT_FILM_CURVES_MAX,
                                              pieces, &count, r->document->error);
    if (r->document->status != TAUT_OK || count < 3) {
        return;
    }
    memcpy(r->curves, pieces, (size_t)count * sizeof(const taut_curve *));
    r->count = count;
    for (int k = 0; k < count; k++) {
        r->numbers[k] = k + 1;
    }
    snprintf(note, sizeof note, "one closed curve, cut at its %d corners", count);
    if (taut_problem_note(r->problem, note) != TAUT_OK) {
        r->document->status = taut_fail_memory(r->document->error);
    }
}

/* Fewer than three curves are a boundary where each is closed. */
static void take_around(reading *r, const taut_basis_spec *spec, taut_film_problem *data)
{
    taut_reader *document = r->document;
    const taut_json boundary = taut_json_member(document->object, r->member);
    const taut_json picks = taut_json_member(&boundary, "edges");
    for (int k = 0; k < r->count; k++) {
        if (!taut_film_curve_is_closed(r->curves[k])) {
            document->status = taut_json_fail(
                picks.value != NULL ? &picks : &boundary, document->error, "size", r->count, 3,
                "found %d curves, expected 3 to %d that go round, or one or two that are closed "
                "and have no corners: `taut boundary` lists what \"edges\" may pick",
                r->count, TAUT_FILM_CURVES_MAX);
            return;
        }
    }
    document->status =
        taut_film_curves_around(r->problem, r->count, r->curves, spec, data, document->error);
}

void taut_film_document_curves(taut_reader *document, taut_problem *problem,
                               taut_film_curve_read *read, taut_film_problem *data,
                               taut_film_parts *parts)
{
    const int is_file = !taut_reader_has(document, "curves");
    const taut_json at = taut_json_member(document->object, "curves");
    reading r = {.problem = problem,
                 .read = read,
                 .document = document,
                 .member = is_file ? "boundary" : "curves"};
    taut_basis_spec spec = {.type = "bspline", .degree = DEGREE, .count = COUNT};
    taut_basis *basis = NULL;

    for (int k = is_file; document->status == TAUT_OK && strangers[k] != NULL; k++) {
        const taut_json other = taut_json_member(document->object, strangers[k]);
        if (other.value != NULL) {
            document->status =
                taut_json_fail(&other, document->error, "conflict", 2, 1,
                               "found \"%s\" beside \"%s\": leave it out", strangers[k], r.member);
        }
    }
    taut_reader_optional_integer(document, "degree", 2, DEGREE_MOST, &spec.degree);
    spec.count = spec.count > spec.degree ? spec.count : spec.degree + 1;
    taut_reader_optional_integer(document, "count", spec.degree + 1, COUNT_MOST, &spec.count);
    if (is_file) {
        taut_boundary_file_curves(document, problem, 1, TAUT_FILM_CURVES_MAX, r.curves, r.numbers,
                                  &r.count);
        if (document->status == TAUT_OK && r.count < 3) {
            close_each(&r);
        }
        if (document->status == TAUT_OK && r.count == 1) {
            cut_closed(&r);
        }
        if (document->status == TAUT_OK && r.count < 3) {
            take_around(&r, &spec, data);
            return;
        }
        if (document->status == TAUT_OK) {
            arrange(&r);
        }
    } else if (document->status == TAUT_OK) {
        document->status =
            taut_json_each(&at, 3, TAUT_FILM_CURVES_MAX, "curves", read_curve, &r, document->error);
    }
    if (document->status == TAUT_OK) {
        document->status = run_round(&r, document->error);
    }
    if (document->status == TAUT_OK) {
        document->status = taut_basis_new(&spec, spec.count, &basis, document->error);
    }
    if (document->status == TAUT_OK && !taut_keep_basis(problem->arena, basis)) {
        document->status = taut_fail_memory(document->error);
    }
    if (document->status == TAUT_OK) {
        document->status = make_patches(&r, basis, data, parts, document->error);
    }
}
