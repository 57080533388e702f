#include "io/dxf/read.h"

#include "core/constants.h"
#include "core/elementary/elementary.h"
#include "core/fail.h"
#include "core/memory.h"
#include "io/dxf/pairs.h"
#include "io/dxf/shapes.h"
#include "io/file/in.h"
#include "taut/limits.h"

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { DEPTH_MAX = 16, VISITS_MAX = 1000000, KINDS_MAX = 40, KIND_ROOM = 64, NOTE_ROOM = 160 };
static const char binary_mark[] = "AutoCAD Binary DXF";

/* What is left out, and how often. */
typedef struct left_out {
    char what[KIND_ROOM];
    size_t count;
} left_out;

/* Its entities, and where it has its origin. */
typedef struct block {
    const taut_dxf_pair *name; /* or NULL */
    taut_dxf_pairs content;
    double base[3];
} block;

typedef struct drawing {
    taut_arena *arena;
    taut_dxf_pairs all;
    block *blocks;
    size_t block_count;
    taut_model *model;
    char (*names)[TAUT_NAME_MAX + 1]; /* of the curves, before those alike are told apart */
    int name_room, visits;
    left_out left[KINDS_MAX];
    int left_count;
} drawing;

/* Where entities are put, and what they are called by. */
typedef struct place {
    taut_dxf_placing placing;
    const char *block; /* "" in the drawing itself */
    const char *layer; /* what layer 0 stands for; NULL: itself */
    int depth;
} place;

static void leave_out(drawing *d, const char *what, size_t length)
{
    const size_t size = length < KIND_ROOM ? length : KIND_ROOM - 1;
    int i = 0;
    while (i < d->left_count &&
           (strlen(d->left[i].what) != size || memcmp(d->left[i].what, what, size) != 0)) {
        i++;
    }
    if (i == KINDS_MAX) {
        i--; /* as one of the last kind: there are no so many */
    }
    if (i == d->left_count) {
        memcpy(d->left[i].what, what, size);
        for (size_t k = 0; k < size; k++) {
            char *c = &d->left[i].what[k];
            *c = *c >= ' ' && *c <= '~' ? *c : '?';
        }
        d->left_count++;
    }
    d->left[i].count++;
}

/* The entity at pair i of a list: up to the next, a POLYLINE with its vertices. */
static taut_dxf_pairs entity_at(taut_dxf_pairs list, size_t i)
{
    const int with_vertices = taut_dxf_is(&list.at[i], 0, "POLYLINE");
    size_t to = i + 1;
    while (to < list.count &&
           (list.at[to].code != 0 || (with_vertices && (taut_dxf_is(&list.at[to], 0, "VERTEX") ||
                                                        taut_dxf_is(&list.at[to], 0, "SEQEND"))))) {
        to++;
    }
    return (taut_dxf_pairs){list.at + i, to - i};
}

/* The pairs of a section, without its name. */
static taut_dxf_pairs find_section(taut_dxf_pairs all, const char *name)
{
    for (size_t i = 0; i + 1 < all.count; i++) {
        if (taut_dxf_is(&all.at[i], 0, "SECTION") && taut_dxf_is(&all.at[i + 1], 2, name)) {
            size_t to = i + 2;
            while (to < all.count && !taut_dxf_is(&all.at[to], 0, "ENDSEC")) {
                to++;
            }
            return (taut_dxf_pairs){all.at + i + 2, to - i - 2};
        }
    }
    return (taut_dxf_pairs){NULL, 0};
}

/* The name that taut gave it; 0 where there is none. */
static int own_name(taut_dxf_pairs entity, char name[TAUT_NAME_MAX + 1])
{
    for (size_t i = 0; i + 1 < entity.count; i++) {
        if (taut_dxf_is(&entity.at[i], 1001, "TAUT") && entity.at[i + 1].code == 1000) {
            taut_dxf_name(&entity.at[i + 1], name, TAUT_NAME_MAX + 1);
            return name[0] != '\0';
        }
    }
    return 0;
}

static void layer_of(taut_dxf_pairs entity, place *at, char layer[TAUT_NAME_MAX + 1])
{
    const taut_dxf_pair *pair = taut_dxf_first(entity, 8);
    snprintf(layer, TAUT_NAME_MAX + 1, "0");
    if (pair != NULL && pair->length > 0) {
        taut_dxf_name(pair, layer, TAUT_NAME_MAX + 1);
    }
    if (strcmp(layer, "0") == 0 && at->layer != NULL) {
        snprintf(layer, TAUT_NAME_MAX + 1, "%s", at->layer);
    }
}

static void name_entity(taut_dxf_pairs entity, place *at, char name[TAUT_NAME_MAX + 1])
{
    char layer[TAUT_NAME_MAX + 1];
    if (at->depth == 0 && own_name(entity, name)) {
        return;
    }
    layer_of(entity, at, layer);
    if (at->block[0] == '\0') {
        memcpy(name, layer, sizeof layer);
        return;
    }
    snprintf(name, TAUT_NAME_MAX + 1, "%.120s/%.120s", at->block, layer);
}

/* Room for one name more. */
static int grow_names(drawing *d)
{
    const int count = taut_model_curve_count(d->model);
    if (count < d->name_room) {
        return 1;
    }
    const int room = d->name_room > 0 ? 2 * d->name_room : 64;
    char(*names)[TAUT_NAME_MAX + 1] = taut_arena_take(d->arena, (size_t)room, sizeof *names);
    if (names == NULL) {
        return 0;
    }
    if (count > 0) {
        memcpy(names, d->names, (size_t)count * sizeof *names);
    }
    d->names = names;
    d->name_room = room;
    return 1;
}

static taut_status new_curve(const taut_dxf_curve *made, const double *points,
                             const double *weights, const char *name, taut_curve **curve,
                             taut_error *error)
{
    const taut_basis_spec spec = {.type = "bspline",
                                  .degree = made->degree,
                                  .knot_count = (int)(made->count + (size_t)made->degree + 1),
                                  .knots = made->knots};
    taut_basis *t = NULL;
    const taut_status status = taut_basis_new(&spec, (int)made->count, &t, error);
    if (status != TAUT_OK) {
        return status;
    }
    const taut_status given = taut_curve_new(name, t, points, weights, curve, error);
    taut_basis_free(t);
    return given;
}

static taut_status fail_count(taut_error *error)
{
    return taut_fail(error, TAUT_BAD_INPUT, "size", NULL, TAUT_OBJECTS_MAX, TAUT_OBJECTS_MAX,
                     "found more than %d curves, or blocks within blocks without an end",
                     TAUT_OBJECTS_MAX);
}

static taut_status add_curve(drawing *d, place *at, taut_dxf_pairs entity,
                             const taut_dxf_curve *made, taut_error *error)
{
    double *points = taut_arena_take(d->arena, 3 * made->count, sizeof *points);
    double *weights = taut_arena_take(d->arena, made->count, sizeof *weights);
    int rational = 0;
    taut_curve *curve = NULL;
    if (points == NULL || weights == NULL || !grow_names(d)) {
        return taut_fail_memory(error);
    }
    if (taut_model_curve_count(d->model) >= TAUT_OBJECTS_MAX) {
        return fail_count(error);
    }
    for (size_t i = 0; i < made->count; i++) {
        const double *p = made->points[i];
        weights[i] = p[3];
        rational = rational || p[3] != 1;
        for (int r = 0; r < 3; r++) {
            points[3 * i + (size_t)r] = at->placing[r][3];
            for (int k = 0; k < 3; k++) {
                points[3 * i + (size_t)r] += at->placing[r][k] * (p[k] / p[3]);
            }
        }
    }
    char *name = d->names[taut_model_curve_count(d->model)];
    name_entity(entity, at, name);
    taut_status status = new_curve(made, points, rational ? weights : NULL, name, &curve, error);
    if (status == TAUT_OK && taut_model_add_curve(d->model, curve) != TAUT_OK) {
        taut_curve_free(curve);
        return taut_fail_memory(error);
    }
    if (status == TAUT_BAD_INPUT) {
        leave_out(d, entity.at[0].value, entity.at[0].length);
        status = TAUT_OK;
    }
    return status;
}

/* All blocks of the file. */
static taut_status list_blocks(drawing *d, taut_dxf_pairs section, taut_error *error)
{
    size_t count = 0;
    taut_status status = TAUT_OK;
    for (size_t i = 0; i < section.count; i++) {
        count += (size_t)taut_dxf_is(&section.at[i], 0, "BLOCK");
    }
    d->blocks = taut_arena_take(d->arena, count, sizeof *d->blocks);
    if (d->blocks == NULL) {
        return taut_fail_memory(error);
    }
    for (size_t i = 0; i < section.count && status == TAUT_OK; i++) {
        if (!taut_dxf_is(&section.at[i], 0, "BLOCK")) {
            continue;
        }
        const taut_dxf_pairs head = entity_at(section, i);
        size_t to = i + head.count;
        while (to < section.count && !taut_dxf_is(&section.at[to], 0, "ENDBLK")) {
            to++;
        }
        block *made = &d->blocks[d->block_count++];
        *made = (block){.name = taut_dxf_first(head, 2),
                        .content = {head.at + head.count, to - i - head.count}};
        status = taut_dxf_find_point(head, 10, made->base, error);
        i = to - 1;
    }
    return status;
}

static const block *find_block(const drawing *d, const taut_dxf_pair *name)
{
    for (size_t i = 0; i < d->block_count && name != NULL; i++) {
        const taut_dxf_pair *own = d->blocks[i].name;
        if (own != NULL && own->length == name->length &&
            memcmp(own->value, name->value, name->length) == 0) {
            return &d->blocks[i];
        }
    }
    return NULL;
}

static taut_status add_entities(drawing *d, taut_dxf_pairs list, place *at, taut_error *error);

/* Columns and rows of an INSERT, at most what a model holds. */
static taut_status read_grid(taut_dxf_pairs entity, int count[2], double step[2], taut_error *error)
{
    taut_status status = TAUT_OK;
    for (int k = 0; k < 2 && status == TAUT_OK; k++) {
        double many = 1;
        status = taut_dxf_find(entity, 70 + k, &many, error);
        status = status == TAUT_OK ? taut_dxf_find(entity, 44 + k, &step[k], error) : status;
        count[k] = many >= 1 && many <= TAUT_OBJECTS_MAX ? (int)many : 1;
    }
    return status;
}

/* From the block's coordinates to those around it, without the shift within a grid. */
static taut_status read_insert(taut_dxf_pairs entity, const double base[3], double shift[3],
                               double direction[2], taut_dxf_placing turn, taut_dxf_placing axes,
                               taut_error *error)
{
    double normal[3] = {0, 0, 1}, scale[3] = {1, 1, 1}, angle = 0;
    taut_status status = taut_dxf_find_point(entity, 10, shift, error);
    status = status == TAUT_OK ? taut_dxf_find_point(entity, 210, normal, error) : status;
    for (int k = 0; k < 3 && status == TAUT_OK; k++) {
        status = taut_dxf_find(entity, 41 + k, &scale[k], error);
    }
    status = status == TAUT_OK ? taut_dxf_find(entity, 50, &angle, error) : status;
    taut_dxf_object_axes(normal, axes);
    const double c = taut_cos(angle * TAUT_PI / 180), s = taut_sin(angle * TAUT_PI / 180);
    direction[0] = c;
    direction[1] = s;
    const double m[3][3] = {
        {c * scale[0], -s * scale[1], 0}, {s * scale[0], c * scale[1], 0}, {0, 0, scale[2]}};
    for (int r = 0; r < 3; r++) {
        turn[r][3] = 0;
        for (int k = 0; k < 3; k++) {
            turn[r][k] = m[r][k];
            turn[r][3] -= m[r][k] * base[k];
        }
    }
    return status;
}

static taut_status add_insert(drawing *d, taut_dxf_pairs entity, place *at, taut_error *error)
{
    const taut_dxf_pair *name = taut_dxf_first(entity, 2);
    const block *found = find_block(d, name);
    char called[TAUT_NAME_MAX + 1], layer[TAUT_NAME_MAX + 1];
    double shift[3] = {0, 0, 0}, step[2] = {0, 0}, direction[2];
    taut_dxf_placing turn, axes;
    int count[2] = {1, 1};
    if (at->depth >= DEPTH_MAX) {
        return fail_count(error);
    }
    if (found == NULL) {
        leave_out(d, "INSERT of no block", 18);
        return TAUT_OK;
    }
    taut_status status = read_grid(entity, count, step, error);
    status = status == TAUT_OK
                 ? read_insert(entity, found->base, shift, direction, turn, axes, error)
                 : status;
    if (status != TAUT_OK) {
        return status;
    }
    taut_dxf_name(name, called, sizeof called);
    layer_of(entity, at, layer);
    place inside = {.block = called, .layer = layer, .depth = at->depth + 1};
    for (int i = 0; i < count[0] && status == TAUT_OK; i++) {
        for (int j = 0; j < count[1] && status == TAUT_OK; j++) {
            taut_dxf_placing put, lifted;
            memcpy(put, turn, sizeof put);
            const double way[2] = {i * step[0], j * step[1]};
            const double c = direction[0], s = direction[1];
            const double far[3] = {shift[0] + c * way[0] - s * way[1],
                                   shift[1] + s * way[0] + c * way[1], shift[2]};
            for (int r = 0; r < 3; r++) {
                put[r][3] += far[r];
            }
            taut_dxf_compose(axes, put, lifted);
            taut_dxf_compose(at->placing, lifted, inside.placing);
            status = add_entities(d, found->content, &inside, error);
        }
    }
    return status;
}

static int is_on_paper(taut_dxf_pairs entity)
{
    const taut_dxf_pair *pair = taut_dxf_first(entity, 67);
    return pair != NULL && pair->length == 1 && pair->value[0] == '1';
}

static taut_status add_entity(drawing *d, taut_dxf_pairs entity, place *at, taut_error *error)
{
    taut_dxf_curve made;
    taut_dxf_kind kind = TAUT_DXF_OTHER;
    const char *why = NULL;
    if (++d->visits > VISITS_MAX) {
        return fail_count(error);
    }
    if (is_on_paper(entity)) {
        return TAUT_OK;
    }
    if (taut_dxf_is(&entity.at[0], 0, "INSERT")) {
        return add_insert(d, entity, at, error);
    }
    const taut_status status = taut_dxf_shape(entity, d->arena, &made, &kind, &why, error);
    if (status != TAUT_OK) {
        return status;
    }
    if (kind == TAUT_DXF_MADE) {
        return add_curve(d, at, entity, &made, error);
    }
    const char *what = why != NULL ? why : entity.at[0].value;
    leave_out(d, what, why != NULL ? strlen(why) : entity.at[0].length);
    return TAUT_OK;
}

static taut_status add_entities(drawing *d, taut_dxf_pairs list, place *at, taut_error *error)
{
    taut_status status = TAUT_OK;
    for (size_t i = 0; i < list.count && status == TAUT_OK;) {
        if (list.at[i].code != 0) {
            i++;
            continue;
        }
        const taut_dxf_pairs entity = entity_at(list, i);
        status = add_entity(d, entity, at, error);
        i += entity.count;
    }
    return status;
}

/* A unit of $INSUNITS, as one that taut has: so many of it. */
typedef struct drawing_unit {
    const char *name, *unit;
    double factor;
} drawing_unit;

/* By number. Those of surveyors are 1200 / 3937 of a metre, or a part or multiple of it. */
static const drawing_unit units[] = {
    {NULL, NULL, 0},
    {"in", "in", 1},
    {"ft", "ft", 1},
    {"miles", "ft", 5280},
    {"mm", "mm", 1},
    {"cm", "cm", 1},
    {"m", "m", 1},
    {"kilometres", "m", 1e3},
    {"microinches", "in", 1e-6},
    {"mils", "in", 1e-3},
    {"yards", "ft", 3},
    {"angstroms", "mm", 1e-7},
    {"nanometres", "mm", 1e-6},
    {"micrometres", "mm", 1e-3},
    {"decimetres", "cm", 10},
    {"decametres", "m", 10},
    {"hectometres", "m", 100},
    {"gigametres", "m", 1e9},
    {NULL, NULL, 0}, /* of astronomers, three of them */
    {NULL, NULL, 0},
    {NULL, NULL, 0},
    {"US survey feet", "m", 1200.0 / 3937},
    {"US survey inches", "m", 100.0 / 3937},
    {"US survey yards", "m", 3600.0 / 3937},
    {"US survey miles", "m", 6336000.0 / 3937},
};

/* The one that the header says; NULL where it says none. */
static const drawing_unit *unit_of(taut_dxf_pairs all)
{
    const taut_dxf_pairs header = find_section(all, "HEADER");
    size_t i = 0;
    while (i + 1 < header.count && !taut_dxf_is(&header.at[i], 9, "$INSUNITS")) {
        i++;
    }
    if (i + 1 >= header.count) {
        return NULL;
    }
    const taut_dxf_pair *pair = &header.at[i + 1];
    size_t number = 0;
    for (size_t k = 0; k < pair->length && number < sizeof units / sizeof units[0]; k++) {
        const int digit = pair->value[k] - '0';
        number = digit >= 0 && digit < 10 ? 10 * number + (size_t)digit : SIZE_MAX;
    }
    return number < sizeof units / sizeof units[0] && units[number].unit != NULL ? &units[number]
                                                                                 : NULL;
}

typedef struct numbered {
    const char *name;
    int index;
} numbered;

static int compare_names(const void *a, const void *b)
{
    const numbered *x = a, *y = b;
    const int order = strcmp(x->name, y->name);
    return order != 0 ? order : (x->index > y->index) - (x->index < y->index);
}

/* Those alike get numbers: the model over again. */
static taut_status tell_apart(drawing *d, taut_error *error)
{
    const int count = taut_model_curve_count(d->model);
    numbered *sorted = taut_arena_take(d->arena, (size_t)count, sizeof *sorted);
    taut_model *made = NULL;
    if (sorted == NULL || taut_model_new(&made) != TAUT_OK) {
        return taut_fail_memory(error);
    }
    for (int i = 0; i < count; i++) {
        sorted[i] = (numbered){d->names[i], i};
    }
    qsort(sorted, (size_t)count, sizeof *sorted, compare_names);
    int *number = taut_arena_take(d->arena, (size_t)count, sizeof *number); /* 0: alone */
    taut_status status = number != NULL ? TAUT_OK : TAUT_NO_MEMORY;
    for (int i = 0; i < count && status == TAUT_OK; i++) {
        const int like_last = i > 0 && strcmp(sorted[i].name, sorted[i - 1].name) == 0;
        const int like_next = i + 1 < count && strcmp(sorted[i].name, sorted[i + 1].name) == 0;
        number[sorted[i].index] = like_last ? number[sorted[i - 1].index] + 1 : like_next;
    }
    for (int i = 0; i < count && status == TAUT_OK; i++) {
        const taut_curve *curve = taut_model_curve(d->model, i);
        char name[TAUT_NAME_MAX + 1];
        taut_curve *copy = NULL;
        if (number[i] > 0) {
            snprintf(name, sizeof name, "%.240s.%d", d->names[i], number[i]);
        } else {
            snprintf(name, sizeof name, "%s", d->names[i]);
        }
        status = taut_curve_new(name, taut_curve_t(curve), taut_curve_points(curve),
                                taut_curve_weights(curve), &copy, error);
        if (status == TAUT_OK && taut_model_add_curve(made, copy) != TAUT_OK) {
            taut_curve_free(copy);
            status = TAUT_NO_MEMORY;
        }
    }
    taut_model_free(d->model);
    d->model = made;
    return status == TAUT_NO_MEMORY ? taut_fail_memory(error) : status;
}

static taut_status add_notes(drawing *d, const drawing_unit *unit, taut_error *error)
{
    taut_record *details = taut_record_new(), *notes = NULL;
    char text[NOTE_ROOM];
    taut_record_add_text(details, "read_from", "DXF");
    notes = taut_record_add_list(details, "notes");
    if (unit == NULL) {
        taut_record_add_text(notes, NULL, "the drawing says no unit that taut has: taken as mm");
    } else if (unit->factor != 1) {
        snprintf(text, sizeof text,
                 "the drawing is in %s: its lengths are multiplied by %.9g, to be in %s",
                 unit->name, unit->factor, unit->unit);
        taut_record_add_text(notes, NULL, text);
    }
    for (int i = 0; i < d->left_count; i++) {
        snprintf(text, sizeof text, "%s is left out (%zu)", d->left[i].what, d->left[i].count);
        taut_record_add_text(notes, NULL, text);
    }
    if (taut_record_status(details) != TAUT_OK) {
        taut_record_free(details);
        return taut_fail_memory(error);
    }
    if (taut_record_count(notes) > 0) {
        taut_model_set_details(d->model, details);
    } else {
        taut_record_free(details);
    }
    return TAUT_OK;
}

static taut_status read_text(const char *text, size_t length, drawing *d, taut_error *error)
{
    place at = {.block = ""};
    if (length >= sizeof binary_mark - 1 &&
        memcmp(text, binary_mark, sizeof binary_mark - 1) == 0) {
        return taut_fail(error, TAUT_BAD_INPUT, "broken", NULL, taut_none, taut_none,
                         "this is a binary DXF file: save it as text (ASCII)");
    }
    taut_status status = taut_dxf_split(text, length, d->arena, &d->all, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = list_blocks(d, find_section(d->all, "BLOCKS"), error);
    if (status != TAUT_OK) {
        return status;
    }
    const taut_dxf_pairs entities = find_section(d->all, "ENTITIES");
    if (entities.at == NULL) {
        return taut_fail(error, TAUT_BAD_INPUT, "broken", NULL, taut_none, taut_none,
                         "there is no section ENTITIES, as a DXF file has it");
    }
    const drawing_unit *unit = unit_of(d->all);
    for (int k = 0; k < 3; k++) {
        at.placing[k][k] = unit != NULL ? unit->factor : 1;
    }
    status = add_entities(d, entities, &at, error);
    if (status == TAUT_OK) {
        status = tell_apart(d, error);
    }
    if (status != TAUT_OK) {
        return status;
    }
    if (taut_model_set_unit(d->model, unit != NULL ? unit->unit : "mm") != TAUT_OK) {
        return taut_fail_memory(error);
    }
    return add_notes(d, unit, error);
}

taut_status taut_dxf_read(const char *path, const taut_read_options *options, taut_model **model,
                          taut_error *error)
{
    (void)options;
    drawing d = {.arena = taut_arena_new()};
    char *text = NULL;
    size_t length = 0;
    taut_status status = taut_file_read(path, &text, &length, error);
    if (status == TAUT_OK && taut_model_new(&d.model) != TAUT_OK) {
        status = taut_fail_memory(error);
    }
    if (status == TAUT_OK) {
        status = read_text(text, length, &d, error);
    }
    taut_free(text);
    taut_arena_free(d.arena);
    if (status != TAUT_OK) {
        taut_model_free(d.model);
        return status;
    }
    *model = d.model;
    return TAUT_OK;
}
