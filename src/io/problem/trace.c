/* trace.c -- the document of a net, { "trace": NET, "of": MODEL | PROBLEM | FILE, ... }
 * (docs/format.md).
 *
 * It has "trace" where other problems have "construct". What it is traced on may not be a net itself.
 */
#include "taut/trace.h"

#include "core/fail.h"
#include "io/problem/document_ops.h"
#include "io/problem/of_document.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const char *const members[] = {"trace", "of",         "surface", "families",
                                      "seeds", "max_length", "panels",  "laths",
                                      "sheet", "untrim",     "carry",   NULL};
static const char *const sheet_members[] = {"size", "gap", NULL};
static const char *const nets[] = {"asymptotic", "principal", "geodesic", "isoparametric", NULL};
static const char *const families[4][3] = {
    {"+", "-", NULL}, {"max", "min", NULL}, {"G", NULL, NULL}, {"u", "v", NULL}};
static const char *const measures[] = {"conformal", "length", "parameter", NULL};
static const char *const edges[] = {"u0", "u1", "v0", "v1", NULL};
static const char *const seed_members[] = {"at",        "edge", "count", "by",      "ends",
                                           "line",      "lath", "cell",  "cells",   "family",
                                           "direction", "both", "to",    "surface", NULL};

static const char *const lath_members[] = {"strip", "width", "thickness", "material",
                                           "cut",   "play",  NULL};
static const char *const strips[] = {"standing", "plank", "developable", "envelope", NULL};
static const char *const cuts[] = {"mean", "axis", NULL};
static const char *const material_members[] = {"E", "G", "strength", NULL};
/* EN 1993-1-1 and EN 338. */
static const struct {
    const char *name;
    taut_trace_material material;
} materials[] = {{"steel-s235", {210000, 81000, 235}}, {"timber-c24", {11000, 690, 24}}};

/* A word or a value that is wrong has the net's own reason. */
static void take_reason(taut_reader *in, int was_fine, const char *reason)
{
    if (was_fine && in->status == TAUT_BAD_INPUT && in->error != NULL &&
        (strcmp(in->error->reason, "name") == 0 || strcmp(in->error->reason, "value") == 0)) {
        snprintf(in->error->reason, sizeof in->error->reason, "%s", reason);
    }
}

/* ---- families and seeds ---- */

/* A net and what is read for it. */
typedef struct seeds {
    taut_arena *arena;
    taut_trace_problem *data;
    taut_trace_seed *list;
    int count;
} seeds;

static taut_status read_family_word(const taut_json *at, taut_trace_net net, int *family,
                                    taut_error *error)
{
    int word = 0;
    const char *text = taut_json_text_at(at);
    taut_status status =
        text == NULL ? taut_json_refuse(at, error, "type", "the name of a family") : TAUT_OK;
    for (word = 0; status == TAUT_OK && families[net][word] != NULL; word++) {
        if (strcmp(families[net][word], text) == 0) {
            *family = word + 1;
            return TAUT_OK;
        }
    }
    return status == TAUT_OK
               ? taut_json_refuse(at, error, "family", "\"%s\"%s%s%s", families[net][0],
                                  families[net][1] != NULL ? " or \"" : "",
                                  families[net][1] != NULL ? families[net][1] : "",
                                  families[net][1] != NULL ? "\"" : "")
               : status;
}

static void read_families(taut_reader *document, taut_trace_problem *data)
{
    const taut_json at = taut_json_member(document->object, "families");
    size_t count = 0;

    if (document->status != TAUT_OK || at.value == NULL) {
        return;
    }
    taut_reader_array(document, "families", 1, 2, "names of families", &count);
    for (size_t i = 0; document->status == TAUT_OK && i < count; i++) {
        const taut_json item = taut_json_item(&at, i);
        int family = 0;
        document->status = read_family_word(&item, data->net, &family, document->error);
        data->families |= family;
    }
    data->families = data->families == 3 ? 0 : data->families;
}

static taut_status refuse_net(const taut_json *at, const char *what, taut_error *error)
{
    return taut_json_fail(at, error, "net", taut_none, taut_none, "found %s", what);
}

/* The geodesic to a place has no direction of its own. */
static void read_to(taut_reader *in, const taut_json *to, const taut_json *direction,
                    taut_trace_seed *seed)
{
    if (in->status == TAUT_OK && direction->value != NULL) {
        in->status = taut_json_fail(direction, in->error, "conflict", taut_none, taut_none,
                                    "found \"direction\" beside \"to\", expected one of them");
    }
    taut_reader_numbers(in, "to", 2, seed->to);
    seed->has_to = 1;
    if (in->status == TAUT_OK && seed->to[0] == seed->at[0] && seed->to[1] == seed->at[1]) {
        in->status = taut_json_expected(to, in->error, "another place than \"at\"");
    }
}

static void read_at(taut_reader *in, taut_trace_net net, taut_trace_seed *seed)
{
    const taut_json direction = taut_json_member(in->object, "direction");
    const taut_json to = taut_json_member(in->object, "to");

    taut_reader_numbers(in, "at", 2, seed->at);
    seed->has_at = 1;
    if (net != TAUT_TRACE_GEODESIC) {
        if (in->status == TAUT_OK && (direction.value != NULL || to.value != NULL)) {
            in->status = refuse_net(direction.value != NULL ? &direction : &to,
                                    "a direction or an end, which only geodesics need", in->error);
        }
        return;
    }
    if (to.value != NULL) {
        read_to(in, &to, &direction, seed);
        return;
    }
    if (in->status == TAUT_OK && direction.value == NULL) {
        in->status = taut_json_refuse(in->object, in->error, "direction",
                                      "a \"direction\" or \"to\" besides \"at\"");
    }
    taut_reader_numbers(in, "direction", 2, seed->direction);
    if (in->status == TAUT_OK && seed->direction[0] == 0 && seed->direction[1] == 0) {
        in->status =
            taut_json_refuse(&direction, in->error, "direction", "two numbers that are not both 0");
    }
    taut_reader_flag(in, "both", &seed->both);
}

static taut_status read_pair(const taut_json *at, void *pair, taut_error *error)
{
    return taut_json_numbers(at, 2, pair, error);
}

static void read_line(taut_reader *in, taut_trace_seed *seed)
{
    double ends[2][2];
    const taut_json at = taut_json_member(in->object, "line");
    taut_reader_items(in, "line", 2, "places [u, v]", read_pair, ends, sizeof ends[0]);
    if (in->status != TAUT_OK) {
        return;
    }
    memcpy(seed->at, ends[0], sizeof seed->at);
    memcpy(seed->to, ends[1], sizeof seed->to);
    if (seed->at[0] == seed->to[0] && seed->at[1] == seed->to[1]) {
        in->status = taut_json_expected(&at, in->error, "two places that differ");
    }
}

static taut_status read_cell(const taut_json *at, void *value, taut_error *error)
{
    const taut_status status = taut_json_number(at, value, error);
    return status == TAUT_OK && !(*(double *)value > 0)
               ? taut_json_expected(at, error, "a positive number")
               : status;
}

static void read_counted(taut_reader *in, taut_trace_seed *seed)
{
    const int was_fine = in->status == TAUT_OK;
    taut_reader_integer(in, "count", 1, TAUT_TRACE_SEEDS_MAX, &seed->count);
    take_reason(in, was_fine, "count");
    taut_reader_flag(in, "ends", &seed->ends);
}

/* A seed is of one kind; a place stands with cells too. */
static void refuse_two_kinds(taut_reader *in)
{
    static const char *const kinds[] = {"edge", "line", "lath", "cell", "cells", "at"};
    const char *first = NULL;
    for (size_t k = 0; in->status == TAUT_OK && k < sizeof kinds / sizeof kinds[0]; k++) {
        const taut_json at = taut_json_member(in->object, kinds[k]);
        if (at.value == NULL || (strcmp(kinds[k], "at") == 0 && first != NULL && first[0] == 'c')) {
            continue;
        }
        if (first != NULL) {
            in->status =
                taut_json_fail(&at, in->error, "conflict", taut_none, taut_none,
                               "found \"%s\" beside \"%s\", expected one of them", kinds[k], first);
        }
        first = kinds[k];
    }
}

/* Of the members that say what a seed is, the one that is there. */
static void read_kind(taut_reader *in, const seeds *s, taut_trace_seed *seed)
{
    int word = 0;
    refuse_two_kinds(in);
    if (taut_reader_has(in, "edge")) {
        const int was_fine = in->status == TAUT_OK;
        seed->kind = TAUT_TRACE_EDGE;
        taut_reader_word(in, "edge", edges, &word);
        take_reason(in, was_fine, "edge");
        seed->edge = (taut_edge)word;
        read_counted(in, seed);
    } else if (taut_reader_has(in, "line")) {
        seed->kind = TAUT_TRACE_LINE;
        read_line(in, seed);
        read_counted(in, seed);
    } else if (taut_reader_has(in, "lath")) {
        const char *name = "";
        seed->kind = TAUT_TRACE_LATH;
        taut_reader_text(in, "lath", &name);
        seed->lath = taut_arena_text(s->arena, name);
        read_counted(in, seed);
    } else if (taut_reader_has(in, "cell") || taut_reader_has(in, "cells")) {
        seed->kind = taut_reader_has(in, "cell") ? TAUT_TRACE_CELL : TAUT_TRACE_CELLS;
        const int was_fine = in->status == TAUT_OK;
        taut_reader_optional(in, "cell", read_cell, &seed->cell);
        taut_reader_optional_integer(in, "cells", 1, TAUT_TRACE_SEEDS_MAX, &seed->count);
        take_reason(in, was_fine, "count");
        if (taut_reader_has(in, "at")) {
            taut_reader_numbers(in, "at", 2, seed->at);
            seed->has_at = 1;
        }
    } else {
        read_at(in, s->data->net, seed);
    }
}

static taut_status check_net(const taut_reader *in, const taut_trace_seed *seed, taut_trace_net net)
{
    const int is_place = seed->kind == TAUT_TRACE_AT;
    if (net == TAUT_TRACE_GEODESIC && !is_place) {
        return refuse_net(
            in->object, "a seed without a direction; geodesics start at \"at\" in a \"direction\"",
            in->error);
    }
    return TAUT_OK;
}

static taut_status read_seed(const taut_json *at, void *into, taut_error *error)
{
    seeds *s = into;
    taut_trace_seed *seed = &s->list[s->count++];
    taut_reader in = taut_reader_of(at, seed_members, error);
    const taut_json family = taut_json_member(at, "family");
    int word = 0;

    if (in.status == TAUT_OK && family.value != NULL) {
        in.status = read_family_word(&family, s->data->net, &seed->family, error);
    }
    read_kind(&in, s, seed);
    if (taut_reader_has(&in, "surface")) {
        const char *name = "";
        taut_reader_text(&in, "surface", &name);
        seed->surface = taut_arena_text(s->arena, name);
    }
    taut_reader_optional_word(&in, "by", measures, &word);
    seed->by = (taut_trace_by)word;
    return in.status == TAUT_OK ? check_net(&in, seed, s->data->net) : in.status;
}

static void read_seeds(taut_reader *document, taut_arena *arena, taut_trace_problem *data)
{
    const taut_json at = taut_json_member(document->object, "seeds");
    seeds s = {.arena = arena, .data = data};

    if (document->status != TAUT_OK || at.value == NULL) {
        return;
    }
    const size_t count = taut_json_count_at(&at);
    s.list = taut_arena_take(
        arena, (count < TAUT_TRACE_SEEDS_MAX ? count : TAUT_TRACE_SEEDS_MAX) + 1, sizeof *s.list);
    if (s.list == NULL) {
        document->status = taut_fail_memory(document->error);
        return;
    }
    document->status =
        taut_json_each(&at, 1, TAUT_TRACE_SEEDS_MAX, "seeds", read_seed, &s, document->error);
    data->seeds = s.list;
    data->seed_count = s.count;
}

/* ---- laths ---- */

static taut_status read_positive(const taut_json *at, double *value, const char *reason,
                                 taut_error *error)
{
    const taut_status status = taut_json_number(at, value, error);
    return status == TAUT_OK && !(*value > 0)
               ? taut_json_refuse(at, error, reason, "a positive number")
               : status;
}

static taut_status read_width(const taut_json *at, void *value, taut_error *error)
{
    return read_positive(at, value, "width", error);
}

static taut_status read_modulus(const taut_json *at, void *value, taut_error *error)
{
    return read_positive(at, value, "material", error);
}

static taut_status read_play(const taut_json *at, void *into, taut_error *error)
{
    taut_trace_laths *laths = into;
    const taut_status status = taut_json_number(at, &laths->play, error);
    laths->has_play = 1;
    return status == TAUT_OK && !(laths->play >= 0)
               ? taut_json_expected(at, error, "a number that is not negative")
               : status;
}

static taut_status read_material(const taut_json *at, void *into, taut_error *error)
{
    taut_trace_material *material = into;
    const char *name = taut_json_text_at(at);

    for (size_t k = 0; name != NULL && k < sizeof materials / sizeof materials[0]; k++) {
        if (strcmp(name, materials[k].name) == 0) {
            *material = materials[k].material;
            return TAUT_OK;
        }
    }
    if (taut_json_kind_at(at) != TAUT_JSON_OBJECT) {
        return taut_json_refuse(at, error, "material", "\"%s\", \"%s\" or E, G and strength",
                                materials[0].name, materials[1].name);
    }
    taut_reader in = taut_reader_of(at, material_members, error);
    taut_reader_member(&in, "E", read_modulus, &material->e);
    taut_reader_member(&in, "G", read_modulus, &material->g);
    taut_reader_member(&in, "strength", read_modulus, &material->strength);
    return in.status;
}

static void read_strip(taut_reader *in, taut_trace_laths *laths)
{
    int strip = 0;
    taut_reader_word(in, "strip", strips, &strip);
    laths->strip = (taut_trace_strip)strip;
}

static taut_status read_laths(const taut_json *at, void *into, taut_error *error)
{
    taut_trace_laths *laths = into;
    taut_reader in = taut_reader_of(at, lath_members, error);
    int cut = 0;

    read_strip(&in, laths);
    taut_reader_optional(&in, "width", read_width, &laths->width);
    taut_reader_optional(&in, "thickness", read_cell, &laths->thickness);
    taut_reader_optional(&in, "material", read_material, &laths->material);
    taut_reader_optional_word(&in, "cut", cuts, &cut);
    laths->cut = (taut_trace_cut)cut;
    taut_reader_optional(&in, "play", read_play, laths);
    return in.status;
}

static taut_status read_gap(const taut_json *at, void *into, taut_error *error)
{
    taut_trace_sheet *sheet = into;
    const taut_status status = taut_json_number(at, &sheet->gap, error);
    sheet->has_gap = 1;
    return status == TAUT_OK && !(sheet->gap >= 0)
               ? taut_json_expected(at, error, "a number that is not negative")
               : status;
}

static taut_status read_size(const taut_json *at, void *into, taut_error *error)
{
    double *size = into;
    const taut_status status = taut_json_numbers(at, 2, size, error);
    return status == TAUT_OK && !(size[0] > 0 && size[1] > 0)
               ? taut_json_expected(at, error, "two positive numbers")
               : status;
}

static taut_status read_sheet(const taut_json *at, void *into, taut_error *error)
{
    taut_trace_sheet *sheet = into;
    taut_reader in = taut_reader_of(at, sheet_members, error);
    taut_reader_optional(&in, "size", read_size, sheet->size);
    taut_reader_optional(&in, "gap", read_gap, sheet);
    return in.status;
}

static void take_sheet(taut_reader *document, taut_arena *arena, taut_trace_problem *data)
{
    taut_trace_sheet *sheet = NULL;
    if (document->status != TAUT_OK || !taut_reader_has(document, "sheet")) {
        return;
    }
    sheet = taut_arena_take(arena, 1, sizeof *sheet);
    if (sheet == NULL) {
        document->status = taut_fail_memory(document->error);
        return;
    }
    taut_reader_member(document, "sheet", read_sheet, sheet);
    data->sheet = sheet;
}

static void take_laths(taut_reader *document, taut_arena *arena, taut_trace_problem *data)
{
    taut_trace_laths *laths = NULL;
    if (document->status != TAUT_OK || !taut_reader_has(document, "laths")) {
        return;
    }
    laths = taut_arena_take(arena, 1, sizeof *laths);
    if (laths == NULL) {
        document->status = taut_fail_memory(document->error);
        return;
    }
    taut_reader_member(document, "laths", read_laths, laths);
    data->laths = laths;
}

static void trace_read(taut_reader *document, taut_problem *problem, void *into)
{
    taut_trace_problem *const data = into;
    const char *name = NULL;
    int net = 0;

    const int was_fine = document->status == TAUT_OK;
    taut_reader_word(document, "trace", nets, &net);
    take_reason(document, was_fine, "net");
    data->net = (taut_trace_net)net;
    taut_of_document_read(document, problem, &data->model, &data->of);
    if (taut_reader_has(document, "surface")) {
        taut_reader_text(document, "surface", &name);
        data->surface = name != NULL ? taut_arena_text(problem->arena, name) : NULL;
    }
    read_families(document, data);
    read_seeds(document, problem->arena, data);
    taut_reader_optional(document, "max_length", read_cell, &data->max_length);
    taut_reader_flag(document, "panels", &data->panels);
    taut_reader_flag(document, "carry", &data->carry);
    take_laths(document, problem->arena, data);
    take_sheet(document, problem->arena, data);
}

const taut_document_ops taut_document_trace = {
    .members = members,
    .size = sizeof(taut_trace_problem),
    .read = trace_read,
};
