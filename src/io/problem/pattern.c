/* pattern.c -- the document of a cutting pattern, { "pattern": "cloth", "of": MODEL | PROBLEM | FILE, "seams": [RULE, ...], ... }
 * (docs/format.md).
 *
 * It has "pattern" where other problems have "construct".
 */
#include "taut/pattern.h"

#include "core/constants.h"
#include "core/fail.h"
#include "io/problem/document_ops.h"
#include "io/problem/of_document.h"
#include "problem/problem.h"
#include "taut/film.h"

#include <stdio.h>
#include <string.h>

static const char *const members[] = {
    "pattern",      "of",        "surface",      "seams",     "seam_length", "cloth",
    "compensation", "prestress", "decompensate", "allowance", "held",        "ends",
    "hems",         "marks",     "strain",       "flatten",   "untrim",      NULL};
static const char *const patterns[] = {"cloth", NULL};
static const char *const lengths[] = {"shared", "true", NULL};
static const char *const flattenings[] = {"elastic", "conformal", NULL};
static const char *const sides[] = {"upper", "lower", NULL};
static const char *const ends[] = {"free", "straight", NULL};
static const char *const edges[] = {"u0", "u1", "v0", "v1", NULL};
static const char *const measures[] = {"length", "parameter", NULL};
static const char *const kinds[] = {"across", "radial", "parallel", "geodesic",
                                    "line",   "curve",  "butt",     NULL}; /* in their order */
static const char *const strip_members[] = {"across", "radial", "count",   "width", "strain",
                                            "by",     "trim",   "surface", NULL};
static const char *const parallel_members[] = {"parallel", "spacing", "surface", NULL};
static const char *const geodesic_members[] = {"geodesic", "surface", NULL};
static const char *const line_members[] = {"line", "surface", NULL};
static const char *const curve_members[] = {"curve", "surface", NULL};
static const char *const butt_members[] = {"butt", "at", NULL};
static const char *const at_members[] = {"edge", "part", "length", "parameter", NULL};
static const char *const parameters[] = {"u", "v", NULL};
static const char *const cloth_members[] = {"width", "length", "material", "thread",
                                            "nap",   "gap",    "side",     NULL};
static const char *const material_members[] = {"E", "nu", "G", NULL};
static const char *const compensation_members[] = {"warp", "weft", "seam", NULL};

static const char *const allowance_members[] = {"seam", "border", "overlap", "split",
                                                "butt", "corner", NULL};
static const char *const corners[] = {"mitre", "square", "mirror", NULL};
static const char *const hem_members[] = {"edge", "pocket", NULL};
static const char *const mark_members[] = {"spacing", "notch", NULL};
static const char *const decompensate_members[] = {"edge", "length", "component", NULL};
static const char *const components[] = {"along", "both", NULL};
static const char *const notches[] = {"slit", "v", "dot", NULL};

/* Typical values, in kN/m. ETFE is isotropic: G = E / (2 (1 + nu)). */
static const struct {
    const char *name;
    taut_pattern_material material;
} materials[] = {{"default", {{0, 0}, 0, 0}},
                 {"etfe", {{1, 1}, 0.43, 1 / 2.86}},
                 {"ptfe-glass", {{1200, 800}, 0.5, 30}},
                 {"pvc-pes", {{1000, 700}, 0.2, 20}}};

/* A word or a value that is wrong has the pattern's own reason. */
static void take_reason(taut_reader *in, int was_fine, const char *reason)
{
    if (was_fine && in->status == TAUT_BAD_INPUT && in->error != NULL &&
        (strcmp(in->error->reason, "name") == 0 || strcmp(in->error->reason, "value") == 0)) {
        snprintf(in->error->reason, sizeof in->error->reason, "%s", reason);
    }
}

/* ---- seams ---- */

typedef struct rules {
    taut_pattern_rule *list;
    int count;
    taut_arena *arena;
} rules;

static taut_status read_edge(const taut_json *at, void *edge, taut_error *error)
{
    taut_reader in = {.object = at, .error = error};
    int word = 0;
    in.status = taut_json_word(at, edges, &word, error);
    take_reason(&in, 1, "edge");
    *(taut_edge *)edge = (taut_edge)word;
    return in.status;
}

static taut_status read_positive(const taut_json *at, void *value, taut_error *error)
{
    const taut_status status = taut_json_number(at, value, error);
    return status == TAUT_OK && !(*(double *)value > 0)
               ? taut_json_expected(at, error, "a positive number")
               : status;
}

/* true: that of the cloth; or a width. */
static taut_status read_rule_width(const taut_json *at, void *into, taut_error *error)
{
    return taut_json_kind_at(at) == TAUT_JSON_TRUE ? TAUT_OK : read_positive(at, into, error);
}

static taut_status read_strain(const taut_json *at, void *into, taut_error *error)
{
    const taut_status status = read_positive(at, into, error);
    return status == TAUT_OK && !(*(double *)into <= 1)
               ? taut_json_expected(at, error,
                                    "a strain, at most 1: that of one in a hundred is 0.01")
               : status;
}

/* Strips: how many, or what they are to keep within. */
static taut_status read_strips(const taut_json *at, taut_pattern_rule *rule, taut_error *error)
{
    static const char *const searched[] = {"width", "strain"};
    taut_reader in = taut_reader_of(at, strip_members, error);
    int by = 0;

    if (rule->kind == TAUT_PATTERN_RADIAL) {
        taut_reader_member(&in, "radial", read_edge, &rule->edges[0]);
        rule->edges[1] = (taut_edge)((int)rule->edges[0] ^ 1); /* the opposite one */
    } else {
        taut_reader_items(&in, "across", 2, "edges", read_edge, rule->edges, sizeof rule->edges[0]);
    }
    for (int k = 0; in.status == TAUT_OK && taut_reader_has(&in, "count") && k < 2; k++) {
        if (taut_reader_has(&in, searched[k])) {
            const taut_json other = taut_json_member(at, searched[k]);
            return taut_json_fail(&other, error, "conflict", taut_none, taut_none,
                                  "found \"%s\" beside \"count\", expected one of them",
                                  searched[k]);
        }
    }
    const int was_fine = in.status == TAUT_OK;
    if (!taut_reader_has(&in, "width") && !taut_reader_has(&in, "strain")) {
        taut_reader_integer(&in, "count", 1, TAUT_PATTERN_PIECES_MAX, &rule->count);
        take_reason(&in, was_fine, "count");
    }
    taut_reader_optional(&in, "width", read_rule_width, &rule->width);
    taut_reader_optional(&in, "strain", read_strain, &rule->strain);
    taut_reader_optional_word(&in, "by", measures, &by);
    rule->by = (taut_pattern_by)by;
    taut_reader_optional(&in, "trim", read_positive, &rule->trim);
    if (in.status == TAUT_OK && rule->trim > 0 && rule->kind != TAUT_PATTERN_RADIAL) {
        const taut_json trim = taut_json_member(at, "trim");
        return taut_json_refuse(&trim, error, "rule", "it beside \"radial\" alone");
    }
    return in.status;
}

/* [u, v], or { "edge": E, "part" | "length" | "parameter": x }. */
static taut_status read_at(const taut_json *at, void *into, taut_error *error)
{
    taut_pattern_at *place = into;
    if (taut_json_kind_at(at) == TAUT_JSON_ARRAY) {
        return taut_json_numbers(at, 2, place->uv, error);
    }
    if (taut_json_kind_at(at) != TAUT_JSON_OBJECT) {
        return taut_json_refuse(at, error, "outside",
                                "a place: [u, v], or an edge with a part, length or parameter");
    }
    taut_reader in = taut_reader_of(at, at_members, error);
    const char *found = NULL;
    place->is_on_edge = 1;
    taut_reader_member(&in, "edge", read_edge, &place->edge);
    for (int k = 1; in.status == TAUT_OK && at_members[k] != NULL; k++) {
        const taut_json one = taut_json_member(at, at_members[k]);
        if (!taut_reader_has(&in, at_members[k])) {
            continue;
        }
        if (found != NULL) {
            return taut_json_fail(&one, error, "conflict", taut_none, taut_none,
                                  "found \"%s\" beside \"%s\", expected one of them", at_members[k],
                                  found);
        }
        found = at_members[k];
        place->place = (taut_pattern_place)(k - 1);
        in.status = taut_json_number(&one, &place->value, error);
    }
    return in.status == TAUT_OK && found == NULL
               ? taut_json_expected(at, error, "a part, length or parameter of the edge")
               : in.status;
}

static taut_status read_ends(const taut_json *at, const char *const *own, const char *word,
                             taut_pattern_rule *rule, taut_error *error)
{
    taut_reader in = taut_reader_of(at, own, error);
    taut_reader_items(&in, word, 2, "places", read_at, rule->at, sizeof rule->at[0]);
    if (rule->kind == TAUT_PATTERN_PARALLEL) {
        taut_reader_member(&in, "spacing", read_positive, &rule->spacing);
    }
    return in.status;
}

typedef struct values {
    double *list;
    int count;
} values;

static taut_status read_value(const taut_json *at, void *into, taut_error *error)
{
    values *all = into;
    return taut_json_number(at, &all->list[all->count++], error);
}

/* A number, or a list of them. */
static taut_status read_values(const taut_json *at, const rules *all, taut_pattern_rule *rule,
                               taut_error *error)
{
    const size_t count = taut_json_count_at(at);
    values own = {
        taut_arena_take(all->arena,
                        (count < TAUT_PATTERN_PIECES_MAX ? count : TAUT_PATTERN_PIECES_MAX) + 1,
                        sizeof(double)),
        0};
    if (own.list == NULL) {
        return taut_fail_memory(error);
    }
    const taut_status status =
        taut_json_kind_at(at) == TAUT_JSON_ARRAY
            ? taut_json_each(at, 1, TAUT_PATTERN_PIECES_MAX - 1, "numbers", read_value, &own, error)
            : read_value(at, &own, error);
    rule->values = own.list;
    rule->value_count = own.count;
    return status;
}

static taut_status read_lines(const taut_json *at, const rules *all, taut_pattern_rule *rule,
                              taut_error *error)
{
    taut_reader in = taut_reader_of(at, line_members, error);
    const taut_json line = taut_json_member(at, "line");
    taut_reader own = taut_reader_of(&line, parameters, error);
    if (in.status != TAUT_OK || own.status != TAUT_OK) {
        return in.status != TAUT_OK ? in.status : own.status;
    }
    rule->held = !taut_reader_has(&own, "u");
    const taut_json found = taut_json_member(&line, parameters[rule->held]);
    if (taut_reader_has(&own, "u") == taut_reader_has(&own, "v")) {
        return taut_json_expected(&line, error, "\"u\" or \"v\" with the lines' values");
    }
    return read_values(&found, all, rule, error);
}

/* "P2" and so on: the strip's number from 0; "auto": -1. */
static taut_status read_strip(const taut_json *at, void *into, taut_error *error)
{
    int *strip = into;
    const char *name = taut_json_text_at(at);
    int number = 0;
    if (name != NULL && strcmp(name, "auto") == 0) {
        *strip = -1;
        return TAUT_OK;
    }
    if (name != NULL && name[0] == 'P' && name[1] >= '1' && name[1] <= '9') {
        for (const char *c = name + 1; *c >= '0' && *c <= '9' && number < 100000; c++) {
            number = 10 * number + (*c - '0');
            if (c[1] == '\0') {
                *strip = number - 1;
                return TAUT_OK;
            }
        }
    }
    return taut_json_refuse(at, error, "rule", "a strip, such as \"P2\", or \"auto\"");
}

static taut_status read_butt(const taut_json *at, const rules *all, taut_pattern_rule *rule,
                             taut_error *error)
{
    taut_reader in = taut_reader_of(at, butt_members, error);
    const taut_json shares = taut_json_member(at, "at");
    taut_reader_member(&in, "butt", read_strip, &rule->strip);
    if (in.status == TAUT_OK && rule->strip < 0) {
        return taut_reader_has(&in, "at")
                   ? taut_json_fail(&shares, error, "conflict", taut_none, taut_none,
                                    "found \"at\" beside \"auto\", which cuts equal parts")
                   : TAUT_OK;
    }
    if (in.status == TAUT_OK && !taut_reader_has(&in, "at")) {
        return taut_json_expected(at, error, "\"at\": where along the strip, from 0 to 1");
    }
    return in.status == TAUT_OK ? read_values(&shares, all, rule, error) : in.status;
}

/* The member of this name as a text of the arena. */
static taut_status read_text(const taut_json *at, const char *member, const rules *all,
                             const char **text, taut_error *error)
{
    taut_reader in = {.object = at, .error = error};
    const char *name = NULL;
    taut_reader_text(&in, member, &name);
    *text = name != NULL ? taut_arena_text(all->arena, name) : NULL;
    return in.status == TAUT_OK && name != NULL && *text == NULL ? taut_fail_memory(error)
                                                                 : in.status;
}

static taut_status read_kind(const taut_json *at, rules *all, taut_pattern_rule *rule,
                             taut_error *error)
{
    int kind = -1;

    for (int k = 0; kinds[k] != NULL; k++) {
        const taut_json one = taut_json_member(at, kinds[k]);
        if (one.value == NULL) {
            continue;
        }
        if (kind >= 0) {
            return taut_json_fail(&one, error, "conflict", taut_none, taut_none,
                                  "found \"%s\" beside \"%s\", expected one of them", kinds[k],
                                  kinds[kind]);
        }
        kind = k;
    }
    rule->kind = (taut_pattern_rule_kind)(kind > 0 ? kind : 0);
    switch (kind) {
    case TAUT_PATTERN_ACROSS:
    case TAUT_PATTERN_RADIAL:
        return read_strips(at, rule, error);
    case TAUT_PATTERN_PARALLEL:
        return read_ends(at, parallel_members, "parallel", rule, error);
    case TAUT_PATTERN_GEODESIC:
        return read_ends(at, geodesic_members, "geodesic", rule, error);
    case TAUT_PATTERN_LINE:
        return read_lines(at, all, rule, error);
    case TAUT_PATTERN_BUTT:
        return read_butt(at, all, rule, error);
    case TAUT_PATTERN_CURVE: {
        const taut_reader in = taut_reader_of(at, curve_members, error);
        return in.status == TAUT_OK ? read_text(at, "curve", all, &rule->curve, error) : in.status;
    }
    default:
        return taut_json_refuse(at, error, "rule",
                                "\"across\", \"radial\", \"parallel\", \"geodesic\", "
                                "\"line\", \"curve\" or \"butt\"");
    }
}

static taut_status read_rule(const taut_json *at, void *into, taut_error *error)
{
    rules *all = into;
    taut_pattern_rule *rule = &all->list[all->count++];
    const taut_status status = read_kind(at, all, rule, error);
    return status == TAUT_OK && taut_json_member(at, "surface").value != NULL
               ? read_text(at, "surface", all, &rule->surface, error)
               : status;
}

static void read_rules(taut_reader *document, taut_arena *arena, taut_pattern_problem *data)
{
    const taut_json at = taut_json_member(document->object, "seams");
    const size_t count = taut_json_count_at(&at);
    rules all = {.count = 0, .arena = arena};

    if (document->status != TAUT_OK) {
        return;
    }
    all.list = taut_arena_take(
        arena, (count < TAUT_PATTERN_RULES_MAX ? count : TAUT_PATTERN_RULES_MAX) + 1,
        sizeof *all.list);
    if (all.list == NULL) {
        document->status = taut_fail_memory(document->error);
        return;
    }
    document->status =
        taut_json_each(&at, 1, TAUT_PATTERN_RULES_MAX, "rules", read_rule, &all, document->error);
    data->rules = all.list;
    data->rule_count = all.count;
}

/* ---- cloth ---- */

static taut_status read_material(const taut_json *at, void *into, taut_error *error)
{
    taut_pattern_material *material = into;
    const char *name = taut_json_text_at(at);

    for (size_t k = 0; name != NULL && k < sizeof materials / sizeof materials[0]; k++) {
        if (strcmp(name, materials[k].name) == 0) {
            *material = materials[k].material;
            return TAUT_OK;
        }
    }
    if (taut_json_kind_at(at) != TAUT_JSON_OBJECT) {
        return taut_json_refuse(at, error, "material",
                                "\"%s\", \"%s\", \"%s\", \"%s\", or E, nu and G", materials[0].name,
                                materials[1].name, materials[2].name, materials[3].name);
    }
    taut_reader in = taut_reader_of(at, material_members, error);
    taut_reader_numbers(&in, "E", 2, material->e);
    taut_reader_number(&in, "nu", &material->nu);
    taut_reader_number(&in, "G", &material->g);
    if (in.status == TAUT_OK &&
        !(material->e[0] > 0 && material->e[1] > 0 && material->g > 0 && material->nu >= 0 &&
          material->nu * material->nu * material->e[1] < material->e[0])) {
        return taut_json_refuse(at, error, "material",
                                "E and G above 0, and nu^2 below E_warp/E_weft");
    }
    return in.status;
}

static taut_status read_thread(const taut_json *at, void *into, taut_error *error)
{
    static const char *const words[] = {"along", "across", NULL};
    double *thread = into;
    int word = 0;
    if (taut_json_text_at(at) != NULL) {
        const taut_status status = taut_json_word(at, words, &word, error);
        *thread = word == 1 ? TAUT_PI / 2 : 0;
        return status;
    }
    const taut_status status = taut_json_number(at, thread, error);
    return status == TAUT_OK && !(*thread > -TAUT_PI && *thread <= TAUT_PI)
               ? taut_json_expected(at, error, "an angle in (-pi, pi]")
               : status;
}

static taut_status read_gap(const taut_json *at, void *into, taut_error *error)
{
    taut_pattern_cloth *cloth = into;
    const taut_status status = taut_json_number(at, &cloth->gap, error);
    cloth->has_gap = 1;
    return status == TAUT_OK && !(cloth->gap >= 0)
               ? taut_json_expected(at, error, "a number that is not negative")
               : status;
}

static taut_status read_cloth(const taut_json *at, void *into, taut_error *error)
{
    taut_pattern_cloth *cloth = into;
    taut_reader in = taut_reader_of(at, cloth_members, error);
    taut_reader_optional(&in, "width", read_positive, &cloth->width);
    taut_reader_optional(&in, "length", read_positive, &cloth->length);
    taut_reader_optional(&in, "material", read_material, &cloth->material);
    taut_reader_optional(&in, "thread", read_thread, &cloth->thread);
    taut_reader_flag(&in, "nap", &cloth->has_nap);
    taut_reader_optional_word(&in, "side", sides, &cloth->shows_lower);
    taut_reader_optional(&in, "gap", read_gap, cloth);
    return in.status;
}

static taut_status read_share(const taut_json *at, void *into, taut_error *error)
{
    double *share = into;
    const taut_status status = taut_json_number(at, share, error);
    return status == TAUT_OK && !(*share >= -0.1 && *share <= 0.3)
               ? taut_json_refuse(at, error, "compensation", "a number from -0.1 to 0.3")
               : status;
}

static taut_status read_compensation(const taut_json *at, void *into, taut_error *error)
{
    taut_pattern_compensation *c = into;
    taut_reader in = taut_reader_of(at, compensation_members, error);
    taut_reader_optional(&in, "warp", read_share, &c->warp);
    taut_reader_optional(&in, "weft", read_share, &c->weft);
    taut_reader_optional(&in, "seam", read_share, &c->seam);
    c->has_seam = taut_reader_has(&in, "seam");
    return in.status;
}

/* The tension of a film's patch, the same in all directions; 0 where it is none, or has other stresses. */
static double tension_of(const taut_problem *of, const char *surface)
{
    const taut_film_problem *film =
        of != NULL && of->construct == TAUT_CONSTRUCT_INDEX_film ? of->data : NULL;
    for (int k = 0; film != NULL && k < film->patch_count; k++) {
        const taut_film_problem *patch = &film->patches[k];
        if (surface != NULL ? patch->name != NULL && strcmp(patch->name, surface) == 0
                            : film->patch_count == 1) {
            return patch->tension > 0 ? patch->tension : 1;
        }
    }
    if (film == NULL || film->patch_count > 0 || film->force_density[0] > 0 ||
        film->prestress[0] > 0) {
        return 0;
    }
    return film->tension > 0 ? film->tension : 1;
}

/* "film": that of the film that the surface is, the same in all directions; or that of warp and weft. */
static void take_stress(taut_reader *document, const taut_json *at, taut_pattern_problem *data)
{
    const char *word = taut_json_text_at(at);
    double stress[2] = {0, 0};
    if (word == NULL) {
        taut_reader_numbers(document, "prestress", 2, stress);
    } else {
        stress[0] = stress[1] = strcmp(word, "film") == 0 ? tension_of(data->of, data->surface) : 0;
        if (!(stress[0] > 0)) {
            document->status =
                taut_json_expected(at, document->error,
                                   "two numbers, of warp and weft, or \"film\" where `of` is the "
                                   "problem of a film of one tension");
        }
    }
    data->prestress = (taut_pattern_prestress){stress[0], stress[1]};
}

/* In place of warp and weft. */
static void read_prestress(taut_reader *document, taut_pattern_problem *data)
{
    const taut_json at = taut_json_member(document->object, "prestress");
    const taut_json shares = taut_json_member(document->object, "compensation");
    const taut_json warp = taut_json_member(&shares, "warp"),
                    weft = taut_json_member(&shares, "weft");

    data->has_prestress = taut_reader_has(document, "prestress");
    if (document->status != TAUT_OK || !data->has_prestress) {
        return;
    }
    take_stress(document, &at, data);
    if (document->status == TAUT_OK && taut_reader_has(document, "compensation") &&
        (taut_json_kind_at(&warp) != TAUT_JSON_MISSING ||
         taut_json_kind_at(&weft) != TAUT_JSON_MISSING)) {
        document->status = taut_json_fail(
            &at, document->error, "conflict", taut_none, taut_none,
            "found a prestress beside the compensation of warp or weft, expected one of them");
    }
}

/* ---- what is left beyond seams ---- */

static taut_status read_left(const taut_json *at, void *into, taut_error *error)
{
    double *width = into;
    const taut_status status = taut_json_number(at, width, error);
    return status == TAUT_OK && !(*width >= 0)
               ? taut_json_refuse(at, error, "allowance", "a number that is not negative")
               : status;
}

/* "S3" and so on. */
static int names_seam(const char *key)
{
    return key[0] == 'S' && key[1] >= '1' && key[1] <= '9' &&
           strspn(key + 1, "0123456789") == strlen(key + 1);
}

/* One number for both sides of a seam, or [right, left]. */
static taut_status read_sides(const taut_json *at, taut_pattern_seam_allowance *own,
                              taut_error *error)
{
    double pair[2] = {0, 0};
    size_t count = 0;
    const int is_pair = taut_json_kind_at(at) == TAUT_JSON_ARRAY;
    taut_status status = is_pair ? taut_json_array(at, 2, 2, "numbers", &count, error)
                                 : read_left(at, &pair[0], error);
    for (size_t k = 0; status == TAUT_OK && k < count; k++) {
        const taut_json item = taut_json_item(at, k);
        status = read_left(&item, &pair[k], error);
    }
    own->right = pair[0];
    own->left = pair[is_pair ? 1 : 0];
    return status;
}

/* Members that name seams, in the arena; and in `known` all that there may be. */
static taut_status read_seams_left(const taut_json *at, taut_arena *arena,
                                   taut_pattern_allowance *a, const char ***known,
                                   taut_error *error)
{
    const size_t count = at->value->count;
    taut_pattern_seam_allowance *own = taut_arena_take(arena, count + 1, sizeof *own);
    taut_status status = TAUT_OK;
    size_t n = sizeof allowance_members / sizeof *allowance_members - 1;
    *known = taut_arena_take(arena, count + n + 1, sizeof **known);
    if (own == NULL || *known == NULL) {
        return taut_fail_memory(error);
    }
    memcpy(*known, allowance_members, n * sizeof **known);
    for (size_t i = 0; status == TAUT_OK && i < count; i++) {
        const char *key = at->value->as.members[i].key;
        if (!names_seam(key)) {
            continue;
        }
        const taut_json one = taut_json_member(at, key);
        taut_pattern_seam_allowance *seam = &own[a->seam_count++];
        (*known)[n++] = key;
        seam->seam = taut_arena_text(arena, key);
        status = seam->seam != NULL ? read_sides(&one, seam, error) : taut_fail_memory(error);
    }
    (*known)[n] = NULL;
    a->seams = own;
    return status;
}

static taut_status read_allowance(const taut_json *at, taut_arena *arena, taut_pattern_allowance *a,
                                  taut_error *error)
{
    const char **known = NULL;
    const taut_status status = taut_json_kind_at(at) == TAUT_JSON_OBJECT
                                   ? read_seams_left(at, arena, a, &known, error)
                                   : TAUT_OK;
    if (status != TAUT_OK) {
        return status;
    }
    taut_reader in = taut_reader_of(at, known != NULL ? known : allowance_members, error);
    int word = 0;
    taut_reader_optional(&in, "seam", read_left, &a->seam);
    taut_reader_optional(&in, "border", read_left, &a->border);
    taut_reader_optional(&in, "overlap", read_left, &a->overlap);
    taut_reader_flag(&in, "split", &a->is_split);
    taut_reader_optional(&in, "butt", read_left, &a->butt);
    a->has_butt = taut_reader_has(&in, "butt");
    taut_reader_optional_word(&in, "corner", corners, &word);
    a->corner = (taut_pattern_corner)word;
    if (in.status == TAUT_OK && taut_reader_has(&in, "seam") && taut_reader_has(&in, "overlap")) {
        const taut_json overlap = taut_json_member(at, "overlap");
        return taut_json_fail(&overlap, error, "conflict", taut_none, taut_none,
                              "found \"overlap\" beside \"seam\", expected one of them");
    }
    return in.status;
}

typedef struct hems {
    taut_pattern_hem list[4];
    int count;
} hems;

static taut_status read_hem(const taut_json *at, void *into, taut_error *error)
{
    hems *all = into;
    taut_pattern_hem *hem = &all->list[all->count++];
    taut_reader in = taut_reader_of(at, hem_members, error);
    int word = 0;
    taut_reader_word(&in, "edge", edges, &word);
    take_reason(&in, 1, "edge");
    taut_reader_member(&in, "pocket", read_positive, &hem->pocket);
    hem->edge = (taut_edge)word;
    for (int k = 0; in.status == TAUT_OK && k + 1 < all->count; k++) {
        if (all->list[k].edge == hem->edge) {
            return taut_json_refuse(at, error, "edge", "one hem for each edge");
        }
    }
    return in.status;
}

static void read_hems(taut_reader *document, taut_arena *arena, taut_pattern_problem *data)
{
    const taut_json at = taut_json_member(document->object, "hems");
    hems all = {.count = 0};
    if (document->status != TAUT_OK || !taut_reader_has(document, "hems")) {
        return;
    }
    document->status = taut_json_each(&at, 0, 4, "hems", read_hem, &all, document->error);
    taut_pattern_hem *list = taut_arena_take(arena, 4, sizeof *list);
    if (document->status == TAUT_OK && list == NULL) {
        document->status = taut_fail_memory(document->error);
    }
    if (document->status == TAUT_OK) {
        memcpy(list, all.list, sizeof all.list);
        data->hems = list;
        data->hem_count = all.count;
    }
}

typedef struct yields {
    taut_pattern_decompensate list[4];
    int count;
} yields;

static taut_status read_decompensate(const taut_json *at, void *into, taut_error *error)
{
    yields *all = into;
    taut_pattern_decompensate *one = &all->list[all->count++];
    taut_reader in = taut_reader_of(at, decompensate_members, error);
    int word = 0, component = 0;
    taut_reader_word(&in, "edge", edges, &word);
    take_reason(&in, 1, "edge");
    taut_reader_member(&in, "length", read_positive, &one->length);
    taut_reader_optional_word(&in, "component", components, &component);
    one->edge = (taut_edge)word;
    one->component = (taut_pattern_component)component;
    for (int k = 0; in.status == TAUT_OK && k + 1 < all->count; k++) {
        if (all->list[k].edge == one->edge) {
            return taut_json_refuse(at, error, "edge", "each edge once");
        }
    }
    return in.status;
}

static void read_all_decompensate(taut_reader *document, taut_arena *arena,
                                  taut_pattern_problem *data)
{
    const taut_json at = taut_json_member(document->object, "decompensate");
    yields all = {.count = 0};
    if (document->status != TAUT_OK || !taut_reader_has(document, "decompensate")) {
        return;
    }
    document->status = taut_json_each(&at, 0, 4, "edges", read_decompensate, &all, document->error);
    taut_pattern_decompensate *list = taut_arena_take(arena, 4, sizeof *list);
    if (document->status == TAUT_OK && list == NULL) {
        document->status = taut_fail_memory(document->error);
    }
    if (document->status == TAUT_OK) {
        memcpy(list, all.list, sizeof all.list);
        data->decompensate = list;
        data->decompensate_count = all.count;
    }
}

/* Half the roll apart, unless they are told. */
static void read_marks(taut_reader *document, taut_pattern_problem *data)
{
    const taut_json at = taut_json_member(document->object, "marks");
    int word = 0;
    if (document->status != TAUT_OK || !taut_reader_has(document, "marks")) {
        return;
    }
    taut_reader in = taut_reader_of(&at, mark_members, document->error);
    data->marks.spacing = data->cloth.width / 2;
    if (data->cloth.width > 0) {
        taut_reader_optional(&in, "spacing", read_positive, &data->marks.spacing);
    } else {
        taut_reader_member(&in, "spacing", read_positive, &data->marks.spacing);
    }
    taut_reader_optional_word(&in, "notch", notches, &word);
    data->marks.notch = (taut_pattern_notch)word;
    document->status = in.status;
}

static taut_status read_held(const taut_json *at, void *into, taut_error *error)
{
    static const char *const words[] = {"u0",  "u1",   "v0",    "v1", "right",
                                        "end", "left", "start", NULL};
    taut_pattern_held *held = into;
    taut_reader in = {.object = at, .error = error};
    int word = 0;
    in.status = taut_json_word(at, words, &word, error);
    take_reason(&in, 1, "held");
    if (in.status == TAUT_OK) {
        *(word < 4 ? &held->borders[word] : &held->edges[word - 4]) = 1;
    }
    return in.status;
}

/* ---- the whole ---- */

static void pattern_read(taut_reader *document, taut_problem *problem, void *into)
{
    taut_pattern_problem *const data = into;
    const char *name = NULL;
    int word = 0;

    taut_reader_word(document, "pattern", patterns, &word);
    taut_of_document_read(document, problem, &data->model, &data->of);
    if (taut_reader_has(document, "surface")) {
        taut_reader_text(document, "surface", &name);
        data->surface = name != NULL ? taut_arena_text(problem->arena, name) : NULL;
    }
    read_rules(document, problem->arena, data);
    word = 0;
    taut_reader_optional_word(document, "seam_length", lengths, &word);
    data->seam_length = (taut_pattern_seam_length)word;
    word = 0;
    taut_reader_optional_word(document, "flatten", flattenings, &word);
    data->flatten = (taut_pattern_flattening)word;
    taut_reader_optional(document, "cloth", read_cloth, &data->cloth);
    taut_reader_optional(document, "compensation", read_compensation, &data->compensation);
    read_prestress(document, data);
    read_all_decompensate(document, problem->arena, data);
    if (document->status == TAUT_OK && taut_reader_has(document, "allowance")) {
        const taut_json left = taut_json_member(document->object, "allowance");
        document->status = read_allowance(&left, problem->arena, &data->allowance, document->error);
    }
    word = 0;
    taut_reader_optional_word(document, "ends", ends, &word);
    data->ends = (taut_pattern_ends)word;
    if (document->status == TAUT_OK && taut_reader_has(document, "held")) {
        const taut_json held = taut_json_member(document->object, "held");
        document->status =
            taut_json_each(&held, 0, 8, "edges", read_held, &data->held, document->error);
    }
    read_hems(document, problem->arena, data);
    read_marks(document, data);
    taut_reader_optional(document, "strain", read_strain, &data->strain);
}

const taut_document_ops taut_document_pattern = {
    .members = members,
    .size = sizeof(taut_pattern_problem),
    .read = pattern_read,
};
