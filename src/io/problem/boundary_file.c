#include "io/problem/boundary_file.h"

#include "core/fail.h"
#include "core/unit.h"
#include "core/vec3.h"
#include "geometry/keep.h"
#include "io/problem/member.h"
#include "io/problem/net_document.h"
#include "platform/system.h"
#include "taut/limits.h"
#include "taut/operations.h"
#include "taut/read.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum {
    PATH_ROOM = 4096,
    HALVINGS_MAX = 16,
    NOTE_ROOM = 400,
    PICKS_MAX = 1000,
    NOTES_MAX = 20,
    SAMPLES = 64
};
/* What a net gets that would have nothing inside: 11 x 11 points between straight lines; and what, where there is a little:
 * many points about kinks of the boundary slide and fold. */
enum { CHOSEN_DEGREE = 3, CHOSEN_SPANS = 8, CHOSEN_SPANS_MORE = 2 };

static const double closed = 1e-6; /* the widest gap at a corner, of the size */

static const double alike = 1e-3; /* of its length: an edge so near to another one lies on it */

/* The file's path: beside the document, unless it begins at the root. */
static taut_status find_path(const taut_json *at, const taut_problem *problem, char path[PATH_ROOM],
                             taut_error *error)
{
    const char *name = NULL, *folder = NULL;
    const taut_status status = taut_json_text(at, &name, error);
    if (status != TAUT_OK) {
        return status;
    }
    if (name[0] == '\0' || strcmp(name, "-") == 0) {
        return taut_json_refuse(at, error, "value", "the name of a file");
    }
    folder = taut_system_is_rooted(name) ? "" : problem->folder;
    if (snprintf(path, PATH_ROOM, "%s%s", folder, name) >= PATH_ROOM) {
        return taut_json_refuse(at, error, "value", "a shorter name");
    }
    return TAUT_OK;
}

/* What is wrong with the file, if anything, told at the member that names it. */
static taut_status blame_file(const taut_json *at, const taut_error *found, taut_status status,
                              taut_error *error)
{
    char where[sizeof found->where];
    if (status == TAUT_OK) {
        return TAUT_OK;
    }
    snprintf(where, sizeof where, "%s", found->where);
    taut_json_fail(at, error, found->reason, found->found, found->limit, "%s%s%s", where,
                   where[0] != '\0' ? ": " : "", found->message);
    if (error != NULL) {
        error->status = status;
        memcpy(error->expected, found->expected, sizeof error->expected);
    }
    return status;
}

/* What "boundary" says: a file, or an object of a file and the curves and edges to take out of it. */
typedef struct boundary_source {
    const taut_json *at;
    taut_json file, edges;
    int picks; /* there are edges */
    int faces; /* without them, and without curves, those around the faces are meant; then: they were read */
} boundary_source;

static taut_status find_source(const taut_json *at, boundary_source *source, taut_error *error)
{
    static const char *const members[] = {"file", "edges", NULL};
    source->at = at;
    source->file = *at;
    if (taut_json_kind_at(at) != TAUT_JSON_OBJECT) {
        return TAUT_OK;
    }
    source->file = taut_json_member(at, "file");
    source->edges = taut_json_member(at, "edges");
    source->picks = source->edges.value != NULL;
    return taut_json_object(at, members, error);
}

/* Curves of the loop: four, or any number that are joined to four. */
typedef struct loop {
    int count;
    const taut_curve **curves;
    int *numbers; /* in the list of `taut boundary`, from 1 */
} loop;

static taut_status take_room(taut_arena *arena, int count, loop *all, taut_error *error)
{
    all->count = count;
    all->curves = taut_arena_take(arena, (size_t)count, sizeof *all->curves);
    all->numbers = taut_arena_take(arena, (size_t)count, sizeof *all->numbers);
    return taut_arena_status(arena) == TAUT_OK ? TAUT_OK : taut_fail_memory(error);
}

/* All curves of the file. */
static taut_status take_all(const taut_json *at, const taut_model *model, taut_arena *arena,
                            loop *all, taut_error *error)
{
    const int count = taut_model_curve_count(model);
    if (count == 0 || count > PICKS_MAX) {
        return taut_json_fail(at, error, "size", count, TAUT_SIDES,
                              "found %d curves in that file, expected %d: `taut boundary` lists "
                              "what \"edges\" may pick",
                              count, TAUT_SIDES);
    }
    const taut_status status = take_room(arena, count, all, error);
    for (int i = 0; i < count && status == TAUT_OK; i++) {
        all->curves[i] = taut_model_curve(model, i);
        all->numbers[i] = i + 1;
    }
    return status;
}

/* Is it NAME.1, NAME.2, ...: one of several pieces of a layer, or of the edges of a face? */
static int is_piece_of(const char *piece, const char *name)
{
    const size_t length = strlen(name);
    const char *digits = piece + length + 1;
    return strncmp(piece, name, length) == 0 && piece[length] == '.' && digits[0] != '\0' &&
           strspn(digits, "0123456789") == strlen(digits);
}

static taut_status pick(const taut_json *at, const taut_model *listed, int i, loop *all,
                        taut_error *error)
{
    if (all->count == PICKS_MAX) {
        return taut_json_refuse(at, error, "size", "no more than %d curves or edges", PICKS_MAX);
    }
    all->curves[all->count] = taut_model_curve(listed, i);
    all->numbers[all->count++] = i + 1;
    return TAUT_OK;
}

/* The one curve of this name, else all pieces of that layer or face. */
static taut_status pick_named(const taut_json *at, const taut_model *listed, loop *all,
                              taut_error *error)
{
    const char *name = NULL;
    const int curves = taut_model_curve_count(listed);
    int found = 0, count = 0, pieces = 0;
    taut_status status = taut_json_text(at, &name, error);
    if (status != TAUT_OK) {
        return status;
    }
    for (int i = 0; i < curves; i++) {
        const char *other = taut_curve_name(taut_model_curve(listed, i));
        if (strcmp(other, name) == 0) {
            found = i;
            count++;
        }
        pieces += is_piece_of(other, name);
    }
    if (count == 1) {
        return pick(at, listed, found, all, error);
    }
    for (int i = 0; count == 0 && i < curves && status == TAUT_OK; i++) {
        if (is_piece_of(taut_curve_name(taut_model_curve(listed, i)), name)) {
            status = pick(at, listed, i, all, error);
        }
    }
    return count > 1 || pieces == 0
               ? taut_json_refuse(at, error, "name",
                                  "the name of one curve or edge, or of a layer or face, as "
                                  "`taut boundary` lists them (%d have this one)",
                                  count)
               : status;
}

/* Those that "edges" picks by number, from 1, or name: `least` or more, or one that closes; a name may pick several. */
static taut_status take_picked(const taut_json *edges, const taut_model *listed, int least,
                               taut_arena *arena, loop *all, taut_error *error)
{
    size_t count = 0;
    const int is_array = taut_json_kind_at(edges) == TAUT_JSON_ARRAY;
    int names = 0;
    for (size_t i = 0; is_array && i < taut_json_count_at(edges); i++) {
        const taut_json item = taut_json_item(edges, i);
        names += taut_json_kind_at(&item) == TAUT_JSON_STRING;
    }
    const int one = is_array && (names > 0 || taut_json_count_at(edges) == 1);
    taut_status status = taut_json_array(edges, one ? 1 : (size_t)least, PICKS_MAX,
                                         "curves or edges, by number or name", &count, error);
    status = status == TAUT_OK ? take_room(arena, PICKS_MAX, all, error) : status;
    all->count = 0;
    for (size_t i = 0; i < count && status == TAUT_OK; i++) {
        const taut_json item = taut_json_item(edges, i);
        int number = 0;
        if (taut_json_kind_at(&item) == TAUT_JSON_NUMBER) {
            status = taut_json_integer(&item, 1, taut_model_curve_count(listed), &number, error);
            status = status == TAUT_OK ? pick(&item, listed, number - 1, all, error) : status;
        } else {
            status = pick_named(&item, listed, all, error);
        }
    }
    return status == TAUT_OK && all->count > 1 && all->count < least
               ? taut_json_fail(edges, error, "size", all->count, least,
                                "found %d curves or edges, expected %d or more, or one that closes",
                                all->count, least)
               : status;
}

/* Four sides of a loop; other numbers than four are joined first. */
static taut_status order_loop(const taut_json *at, const loop *all, taut_curve *sides[TAUT_SIDES],
                              taut_error *error)
{
    taut_curve *joined[TAUT_SIDES] = {NULL, NULL, NULL, NULL};
    const taut_curve *four[TAUT_SIDES];
    taut_error found = {.status = TAUT_OK};
    taut_status status = TAUT_OK;
    if (all->count != TAUT_SIDES) {
        status = taut_boundary_join(all->count, all->curves, closed, joined, &found);
    }
    for (int s = 0; s < TAUT_SIDES; s++) {
        four[s] = all->count == TAUT_SIDES ? all->curves[s] : joined[s];
    }
    if (status == TAUT_OK) {
        status = taut_boundary_order(four, closed, sides, &found);
    }
    taut_boundary_free(joined);
    return blame_file(at, &found, status, error);
}

static taut_status order_sides(const boundary_source *source, const taut_model *model,
                               taut_arena *arena, taut_curve *sides[TAUT_SIDES], taut_error *error)
{
    taut_error found = {.status = TAUT_OK};
    taut_model *listed = NULL;
    loop all = {.count = 0};
    taut_status status = TAUT_OK;

    if (source->picks) {
        status = blame_file(source->at, &found, taut_model_boundary(model, &listed, &found), error);
        status = status == TAUT_OK
                     ? take_picked(&source->edges, listed, TAUT_SIDES, arena, &all, error)
                     : status;
    } else {
        status = take_all(source->at, model, arena, &all, error);
    }
    status = status == TAUT_OK ? order_loop(source->at, &all, sides, error) : status;
    taut_model_free(listed);
    return status;
}

/* A file in another unit than the document is told in the document's, and that is said. */
static taut_status convert_unit(const taut_json *at, taut_problem *problem, taut_model **model,
                                taut_error *error)
{
    const char *unit = taut_model_unit(*model), *name = taut_json_text_at(at);
    taut_error found = {.status = TAUT_OK};
    taut_model *converted = NULL;
    char note[NOTE_ROOM];

    if (strcmp(unit, problem->unit) == 0) {
        return TAUT_OK;
    }
    snprintf(note, sizeof note, "%.200s is in %s: its lengths are multiplied by %.9g, to be in %s",
             name, unit, taut_unit_ratio(unit, problem->unit), problem->unit);
    const taut_status status = taut_model_to_unit(*model, problem->unit, &converted, &found);
    if (status != TAUT_OK) {
        return blame_file(at, &found, status, error);
    }
    taut_model_free(*model);
    *model = converted;
    return taut_problem_note(problem, note) == TAUT_OK ? TAUT_OK : taut_fail_memory(error);
}

/* What the reader says of the file is said of the problem too, but for surfaces, which are not asked for. */
static taut_status keep_notes(const taut_json *at, taut_problem *problem, const taut_model *model,
                              taut_error *error)
{
    static const char of_surfaces[] = "surface ";
    const taut_record *details = taut_model_details(model);
    const taut_record *notes = taut_record_get(details, "notes");
    const char *name = taut_json_text_at(at);
    if (taut_record_get(details, "read_from") == NULL) {
        return TAUT_OK; /* notes of another problem */
    }
    for (size_t i = 0; i < taut_record_count(notes) && i < NOTES_MAX; i++) {
        const char *text = taut_record_text(taut_record_at(notes, i));
        char note[NOTE_ROOM];
        if (text == NULL || strncmp(text, of_surfaces, sizeof of_surfaces - 1) == 0) {
            continue;
        }
        snprintf(note, sizeof note, "%.200s: %.190s", name, text);
        if (taut_problem_note(problem, note) != TAUT_OK) {
            return taut_fail_memory(error);
        }
    }
    return TAUT_OK;
}

static taut_status read_file(const char *path, boundary_source *source, taut_model **model,
                             taut_error *error)
{
    /* without picks no faces are asked for */
    const taut_read_options chosen = {.untrim = !source->picks, .edges = source->picks},
                            faces = {.edges = 1};
    taut_status status = taut_model_read_with(path, &chosen, model, error);
    if (status == TAUT_OK && source->faces) {
        source->faces = !source->picks && taut_model_curve_count(*model) == 0 &&
                        taut_model_surface_count(*model) > 0;
    }
    if (status == TAUT_OK && source->faces) {
        taut_model_free(*model);
        *model = NULL;
        status = taut_model_read_with(path, &faces, model, error);
    }
    return status;
}

/* The model of the file that "boundary" names (any that taut reads, beside the problem's own document), in the document's unit; the
 * caller's. */
static taut_status open_source(const taut_json *at, taut_problem *problem, boundary_source *source,
                               taut_model **model, taut_error *error)
{
    taut_error found = {.status = TAUT_OK};
    char path[PATH_ROOM];
    taut_status status = find_source(at, source, error);

    if (status == TAUT_OK) {
        status = find_path(&source->file, problem, path, error);
    }
    if (status != TAUT_OK) {
        return status;
    }
    status = read_file(path, source, model, &found);
    if (status != TAUT_OK) {
        return blame_file(at, &found, status, error);
    }
    status = keep_notes(&source->file, problem, *model, error);
    return status == TAUT_OK ? convert_unit(&source->file, problem, model, error) : status;
}

/* The four sides out of the file, all of its curves or those that are picked, in order and closed; the caller's. */
static taut_status read_sides(const taut_json *at, taut_problem *problem,
                              taut_curve *sides[TAUT_SIDES], taut_error *error)
{
    taut_model *model = NULL;
    boundary_source source = {.faces = 0};
    taut_status status = open_source(at, problem, &source, &model, error);

    if (status == TAUT_OK) {
        status = order_sides(&source, model, problem->arena, sides, error);
    }
    taut_model_free(model);
    return status;
}

static taut_status keep_all(const loop *all, taut_arena *arena, const taut_curve **curves,
                            int *numbers, taut_error *error)
{
    for (int k = 0; k < all->count; k++) {
        taut_curve *copy = NULL;
        if (taut_curve_copy(all->curves[k], &copy) != TAUT_OK || !taut_keep_curve(arena, copy)) {
            return taut_fail_memory(error);
        }
        curves[k] = copy;
        numbers[k] = all->numbers[k];
    }
    return TAUT_OK;
}

/* A polyline of a curve, to see whether another lies on it. */
typedef struct trace {
    double x[SAMPLES + 1][3], length;
} trace;

static void trace_curve(const taut_curve *curve, trace *line)
{
    const taut_basis *t = taut_curve_t(curve);
    const double lo = taut_basis_lo(t), width = taut_basis_hi(t) - lo;
    line->length = 0;
    for (int k = 0; k <= SAMPLES; k++) {
        taut_curve_eval(curve, k == SAMPLES ? taut_basis_hi(t) : lo + width * k / SAMPLES, 0,
                        line->x[k]);
        line->length += k > 0 ? taut_distance(line->x[k], line->x[k - 1]) : 0;
    }
}

/* How far x is from the polyline. */
static double distance_from(const trace *line, const double x[3])
{
    double least = INFINITY;
    for (int k = 0; k < SAMPLES; k++) {
        double along[3], from[3];
        taut_difference(line->x[k + 1], line->x[k], along);
        taut_difference(x, line->x[k], from);
        const double square = taut_dot(along, along);
        const double part = square > 0 ? taut_dot(along, from) / square : 0;
        taut_add_scaled(-fmin(fmax(part, 0), 1), along, from);
        least = fmin(least, taut_length(from));
    }
    return least;
}

/* Do both run between the same ends along the same way? */
static int lie_on_each_other(const trace *a, const trace *b)
{
    const double near = alike * fmax(a->length, b->length);
    const double(*x)[3] = a->x, (*y)[3] = b->x;
    return ((taut_distance(x[0], y[0]) <= near && taut_distance(x[SAMPLES], y[SAMPLES]) <= near) ||
            (taut_distance(x[0], y[SAMPLES]) <= near && taut_distance(x[SAMPLES], y[0]) <= near)) &&
           distance_from(b, x[SAMPLES / 2]) <= near;
}

/* The edges of a file's faces on which no other lies. */
static taut_status take_outline(const taut_json *at, const taut_model *listed, taut_arena *arena,
                                loop *all, taut_error *error)
{
    const int count = taut_model_curve_count(listed);
    if (count > PICKS_MAX) {
        return taut_json_fail(at, error, "size", count, PICKS_MAX,
                              "found %d edges of faces in that file, expected at most %d: `taut "
                              "boundary` lists what \"edges\" may pick",
                              count, PICKS_MAX);
    }
    trace *lines = taut_arena_take(arena, (size_t)count, sizeof *lines);
    taut_status status = take_room(arena, count, all, error);
    if (status != TAUT_OK || lines == NULL) {
        return taut_fail_memory(error);
    }
    for (int i = 0; i < count; i++) {
        trace_curve(taut_model_curve(listed, i), &lines[i]);
    }
    all->count = 0;
    for (int i = 0; i < count && status == TAUT_OK; i++) {
        int alone = 1;
        for (int k = 0; k < count && alone; k++) {
            alone = k == i || !lie_on_each_other(&lines[i], &lines[k]);
        }
        status = alone ? pick(at, listed, i, all, error) : TAUT_OK;
    }
    return status;
}

void taut_boundary_file_curves(taut_reader *document, taut_problem *problem, int least, int most,
                               const taut_curve **curves, int *numbers, int *count)
{
    const taut_json at = taut_json_member(document->object, "boundary");
    taut_error found = {.status = TAUT_OK}, *const error = document->error;
    taut_model *model = NULL, *listed = NULL;
    boundary_source source = {.faces = 1};
    loop all = {.count = 0};

    if (document->status != TAUT_OK) {
        return;
    }
    taut_status status = open_source(&at, problem, &source, &model, error);
    if (status == TAUT_OK && (source.picks || source.faces)) {
        status = blame_file(&at, &found, taut_model_boundary(model, &listed, &found), error);
    }
    if (status == TAUT_OK && source.picks) {
        status = take_picked(&source.edges, listed, least, problem->arena, &all, error);
    } else if (status == TAUT_OK && source.faces) {
        status = take_outline(&at, listed, problem->arena, &all, error);
    } else if (status == TAUT_OK) {
        status = take_all(&at, model, problem->arena, &all, error);
    }
    if (status == TAUT_OK && (all.count < least || all.count > most)) {
        status = taut_json_fail(&at, error, "size", all.count, all.count < least ? least : most,
                                "found %d curves in that file, expected %d to %d: `taut boundary` "
                                "lists what \"edges\" may pick",
                                all.count, least, most);
    }
    status = status == TAUT_OK ? keep_all(&all, problem->arena, curves, numbers, error) : status;
    *count = all.count;
    taut_model_free(listed);
    taut_model_free(model);
    document->status = status;
}

/* Along one direction. */
static taut_status read_degree(const taut_json *at, void *degree, taut_error *error)
{
    return taut_json_integer(at, 0, TAUT_DEGREE_MAX, degree, error);
}

static taut_status read_halvings(const taut_json *at, void *halvings, taut_error *error)
{
    return taut_json_integer(at, 0, HALVINGS_MAX, halvings, error);
}

/* Two whole numbers, which stay 0 and 0 where the member is missing. */
static void read_pair(taut_reader *document, const char *key, taut_json_read *read, int pair[2])
{
    if (taut_reader_has(document, key)) {
        taut_reader_items(document, key, 2, "whole numbers, along u and v", read, pair,
                          sizeof pair[0]);
    }
}

static const taut_basis *keep_basis(const taut_curve *side, taut_arena *arena)
{
    taut_basis *copy = NULL;
    const taut_status status = taut_basis_copy(taut_curve_t(side), &copy);
    return status == TAUT_OK && taut_keep_basis(arena, copy) ? copy : NULL;
}

static taut_status fill_net(taut_curve *const fitted[TAUT_SIDES], const taut_json *at,
                            taut_arena *arena, taut_net_document *net, taut_error *error)
{
    const size_t nu = (size_t)taut_basis_count(taut_curve_t(fitted[TAUT_SIDE_V0]));
    const size_t nv = (size_t)taut_basis_count(taut_curve_t(fitted[TAUT_SIDE_U0]));
    const int is_rational = taut_boundary_is_rational(fitted);
    taut_net_document made = {NULL, NULL, NULL, NULL, NULL};

    if ((double)nu * (double)nv > TAUT_POINTS_MAX) {
        return taut_json_fail(at, error, "size", (double)nu * (double)nv, TAUT_POINTS_MAX,
                              "a net of %zu x %zu points, expected at most %d points", nu, nv,
                              TAUT_POINTS_MAX);
    }
    made.u = keep_basis(fitted[TAUT_SIDE_V0], arena);
    made.v = keep_basis(fitted[TAUT_SIDE_U0], arena);
    made.points = taut_arena_take(arena, 3 * nu * nv, sizeof(double));
    made.known = taut_arena_take(arena, nu * nv, 1);
    made.weights = is_rational ? taut_arena_take(arena, nu * nv, sizeof(double)) : NULL;
    if (made.u == NULL || made.v == NULL || made.points == NULL || made.known == NULL ||
        (is_rational && made.weights == NULL)) {
        return taut_fail_memory(error);
    }
    taut_boundary_net(fitted, made.points, made.known, made.weights);
    *net = made;
    return TAUT_OK;
}

/* What a boundary becomes: curves that are freed together. */
typedef struct boundary_work {
    const taut_json *at;
    taut_problem *problem;
    taut_curve *sides[TAUT_SIDES], *made[TAUT_SIDES];
} boundary_work;

static void clear_work(boundary_work *work)
{
    taut_boundary_free(work->sides);
    taut_boundary_free(work->made);
}

static const int side_along[2] = {TAUT_SIDE_V0, TAUT_SIDE_U0};

/* How many points of the net are not on its boundary? */
static int points_inside(taut_curve *const fitted[TAUT_SIDES])
{
    return (taut_basis_count(taut_curve_t(fitted[TAUT_SIDE_V0])) - 2) *
           (taut_basis_count(taut_curve_t(fitted[TAUT_SIDE_U0])) - 2);
}

/* Are there fewer than two of them along a direction? */
static int is_scant(taut_curve *const fitted[TAUT_SIDES])
{
    return taut_basis_count(taut_curve_t(fitted[TAUT_SIDE_V0])) <= 3 ||
           taut_basis_count(taut_curve_t(fitted[TAUT_SIDE_U0])) <= 3;
}

/* Is it flat between a few lines along a direction? More of them leave less to gain; and where the boundary has many kinks, a finer
 * net may fold, so that it is for the document to ask for. */
static int is_coarse(taut_curve *const fitted[TAUT_SIDES])
{
    int coarse = 0;
    for (int d = 0; d < 2; d++) {
        const taut_basis *t = taut_curve_t(fitted[side_along[d]]);
        coarse |= taut_basis_degree(t) == 1 && taut_basis_span_count(t) < CHOSEN_SPANS;
    }
    return coarse;
}

/* A net with little to find, of which the document says nothing else, gets points to find; that is said. */
static taut_status choose_net(boundary_work *work, taut_error *error)
{
    const int inside = points_inside(work->made), degree[2] = {CHOSEN_DEGREE, CHOSEN_DEGREE};
    taut_error found = {.status = TAUT_OK};
    const int spans = inside > 0 ? CHOSEN_SPANS_MORE : CHOSEN_SPANS;
    int halvings[2] = {0, 0}, told[2] = {0, 0}, count[2] = {0, 0};
    char note[NOTE_ROOM], left[32] = "nothing";

    for (int d = 0; d < 2; d++) {
        const taut_basis *t = taut_curve_t(work->made[side_along[d]]);
        while ((taut_basis_span_count(t) << halvings[d]) < spans) {
            halvings[d]++;
        }
    }
    taut_boundary_free(work->made);
    const taut_status status = taut_boundary_fit(work->sides, degree, halvings, work->made, &found);
    if (status != TAUT_OK) {
        return blame_file(work->at, &found, status, error);
    }
    for (int d = 0; d < 2; d++) {
        const taut_basis *t = taut_curve_t(work->made[side_along[d]]);
        told[d] = taut_basis_degree(t);
        count[d] = taut_basis_count(t);
    }
    if (inside > 0) {
        snprintf(left, sizeof left, "%d point%s", inside, inside > 1 ? "s" : "");
    }
    snprintf(note, sizeof note,
             "the curves alone leave %s to find: chosen are \"degree\": [%d, %d] and "
             "\"refine\": [%d, %d], which is %d x %d points",
             left, told[0], told[1], halvings[0], halvings[1], count[0], count[1]);
    return taut_problem_note(work->problem, note) == TAUT_OK ? TAUT_OK : taut_fail_memory(error);
}

static taut_status tell_coarse(const boundary_work *work, taut_error *error)
{
    char note[NOTE_ROOM];
    snprintf(note, sizeof note,
             "the curves alone leave %d points to find, on a net of degree 1: \"degree\": [2, 2] "
             "and \"refine\" make a finer one",
             points_inside(work->made));
    return taut_problem_note(work->problem, note) == TAUT_OK ? TAUT_OK : taut_fail_memory(error);
}

/* Of sides that there are. `asked`: the document says how fine the net is to be. */
static taut_status make_net(boundary_work *work, const int degree[2], const int halvings[2],
                            int asked, taut_net_document *net, taut_error *error)
{
    taut_error found = {.status = TAUT_OK};
    taut_status status = taut_boundary_fit(work->sides, degree, halvings, work->made, &found);
    if (status != TAUT_OK) {
        return blame_file(work->at, &found, status, error);
    }
    if (!asked && is_scant(work->made)) {
        status = choose_net(work, error);
    } else if (!asked && is_coarse(work->made)) {
        status = tell_coarse(work, error);
    }
    if (status != TAUT_OK) {
        return status;
    }
    return fill_net(work->made, work->at, work->problem->arena, net, error);
}

static taut_status read_net(boundary_work *work, const int degree[2], const int halvings[2],
                            int asked, taut_net_document *net, taut_error *error)
{
    const taut_status status = read_sides(work->at, work->problem, work->sides, error);
    return status == TAUT_OK ? make_net(work, degree, halvings, asked, net, error) : status;
}

void taut_boundary_curves_net(taut_reader *document, taut_problem *problem,
                              const taut_curve *const curves[TAUT_SIDES], taut_net_document *net)
{
    static const int as_they_are[2] = {0, 0};
    static const int around[TAUT_SIDES] = {TAUT_SIDE_V0, TAUT_SIDE_U1, TAUT_SIDE_V1, TAUT_SIDE_U0};
    const taut_json at = taut_json_member(document->object, "curves");
    boundary_work work = {.at = &at, .problem = problem};
    loop all = {.count = TAUT_SIDES};

    if (document->status == TAUT_OK) {
        document->status = take_room(problem->arena, TAUT_SIDES, &all, document->error);
    }
    for (int s = 0; s < TAUT_SIDES && document->status == TAUT_OK; s++) {
        all.curves[s] = curves[around[s]];
    }
    if (document->status == TAUT_OK) {
        document->status = order_loop(&at, &all, work.sides, document->error);
    }
    if (document->status == TAUT_OK) {
        document->status = make_net(&work, as_they_are, as_they_are, 0, net, document->error);
    }
    clear_work(&work);
}

/* The file says what these members would. */
static const char says_all[] = "beside \"boundary\", which says it all";

void taut_boundary_file_net(taut_reader *document, taut_problem *problem, taut_net_document *net)
{
    static const char *const others[] = {"u", "v", "points", "weights", NULL};
    const taut_json at = taut_json_member(document->object, "boundary");
    boundary_work work = {.at = &at, .problem = problem};
    int degree[2] = {0, 0}, halvings[2] = {0, 0};

    taut_member_refuse(document, others, says_all);
    read_pair(document, "degree", read_degree, degree);
    read_pair(document, "refine", read_halvings, halvings);
    const int asked = taut_reader_has(document, "degree") || taut_reader_has(document, "refine");
    if (document->status == TAUT_OK) {
        document->status = read_net(&work, degree, halvings, asked, net, document->error);
    }
    clear_work(&work);
}

static taut_status read_bezier(boundary_work *work, int agree, const taut_curve *sides[TAUT_SIDES],
                               taut_error *error)
{
    taut_error found = {.status = TAUT_OK};
    taut_status status = read_sides(work->at, work->problem, work->sides, error);

    if (status != TAUT_OK) {
        return status;
    }
    status = taut_boundary_bezier(work->sides, work->made, &found);
    if (status == TAUT_OK && agree) {
        status = taut_boundary_agree(work->made, &found);
    }
    if (status != TAUT_OK) {
        return blame_file(work->at, &found, status, error);
    }
    for (int s = 0; s < TAUT_SIDES; s++) {
        taut_curve *made = work->made[s];
        work->made[s] = NULL;
        if (!taut_keep_curve(work->problem->arena, made)) {
            return taut_fail_memory(error);
        }
        sides[s] = made;
    }
    return TAUT_OK;
}

void taut_boundary_file_bezier(taut_reader *document, taut_problem *problem,
                               const char *const *others, int agree,
                               const taut_curve *sides[TAUT_SIDES])
{
    const taut_json at = taut_json_member(document->object, "boundary");
    boundary_work work = {.at = &at, .problem = problem};

    taut_member_refuse(document, others, says_all);
    if (document->status == TAUT_OK) {
        document->status = read_bezier(&work, agree, sides, document->error);
    }
    clear_work(&work);
}
