/* test_stream.c -- what taut-cad tells of a CAD file, whole, cut short, and with any byte
 * changed.
 *
 * needs: posix
 */
#include "check.h"

#include "io/cad/answer.h"
#include "taut/curve.h"
#include "taut/surface.h"

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const double knots_u[] = {0, 0, 0, 1, 1, 1}, knots_v[] = {0, 0, 2, 2};
static const double points[] = {0, 0, 0, 0, 1, 0, 1, 0, 1, 1, 1, 1, 2, 0, 0, 2, 1, 0};
static const double weights[] = {1, 2, 3, 4, 5, 6};
static const taut_cad_item face = {"a face", {2, 1},           {3, 2},   {knots_u, knots_v}, points,
                                   weights,  TAUT_CAD_TRIMMED, "a part", 1 + 0x12ab34,       0,
                                   {0}};
static const taut_cad_item edge = {
    "an edge", {1, 0}, {2, 0}, {knots_v, NULL}, points, NULL, TAUT_CAD_APPROXIMATE, NULL,
    0,         0,      {0}};

/* free() it. */
static char *written(const taut_cad_item *items, int count, size_t *length)
{
    static const taut_error none = {.status = TAUT_OK};
    char *bytes = NULL;
    FILE *file = open_memstream(&bytes, length);
    CHECK(taut_cad_put_unit(file, "cm"), "unit");
    for (int i = 0; i < count; i++) {
        CHECK(taut_cad_put_item(file, &items[i]), "item %d", i);
    }
    CHECK(taut_cad_put_product(file, "a \xff whole"), "product");
    CHECK(taut_cad_put_note(file, "face 3 is left out:\x1b[2J"), "note");
    CHECK(taut_cad_put_end(file, TAUT_OK, &none), "end");
    fclose(file);
    return bytes;
}

typedef struct outcome {
    taut_status status, said;
    int has_ended, surfaces, curves, notes;
    char unit[4], name[TAUT_NAME_MAX + 1], product[TAUT_NAME_MAX + 1], last_note[64];
    taut_error error;
} outcome;

/* Bytes as they come, no more than seven at a time. */
typedef struct stream {
    const char *bytes;
    size_t left;
} stream;

static size_t hear(void *context, void *to, size_t room)
{
    stream *s = context;
    const size_t most = room < 7 ? room : 7, part = s->left < most ? s->left : most;
    memcpy(to, s->bytes, part);
    s->bytes += part;
    s->left -= part;
    return part;
}

static outcome read_back(const char *bytes, size_t length)
{
    outcome o = {.status = TAUT_OK, .error = {.status = TAUT_OK}};
    taut_cad_result result = {.notes = taut_record_new_list()};
    stream from = {bytes, length};
    taut_cad_source source = {.more = hear, .context = &from};
    CHECK(taut_model_new(&result.model) == TAUT_OK, "begin");
    o.status = taut_cad_get_all(&source, &result, &o.error);
    o.has_ended = result.has_ended;
    o.said = result.status;
    o.surfaces = taut_model_surface_count(result.model);
    o.curves = taut_model_curve_count(result.model);
    o.notes = (int)taut_record_count(result.notes);
    snprintf(o.last_note, sizeof o.last_note, "%.60s",
             taut_record_text(taut_record_at(result.notes, (size_t)o.notes - 1)));
    snprintf(o.product, sizeof o.product, "%s", result.product);
    snprintf(o.unit, sizeof o.unit, "%s", taut_model_unit(result.model));
    if (o.surfaces > 0) {
        snprintf(o.name, sizeof o.name, "%s",
                 taut_surface_name(taut_model_surface(result.model, 0)));
    }
    taut_model_free(result.model);
    taut_record_free(result.notes);
    return o;
}

static void test_whole(void)
{
    const taut_cad_item items[] = {face, edge};
    size_t length = 0;
    char *bytes = written(items, 2, &length);
    const outcome o = read_back(bytes, length);
    CHECK(o.status == TAUT_OK && o.has_ended && o.said == TAUT_OK, "\"%s\"", o.error.message);
    CHECK(o.surfaces == 1 && o.curves == 1 && o.notes == 3, "%d, %d, %d", o.surfaces, o.curves,
          o.notes);
    CHECK(strcmp(o.last_note, "face 3 is left out:?[2J") == 0, "a note that steers: %s",
          o.last_note);
    CHECK(strcmp(o.product, "a ? whole") == 0, "\"%s\"", o.product);
    CHECK(strcmp(o.unit, "cm") == 0 && strcmp(o.name, "a face") == 0, "%s \"%s\"", o.unit, o.name);
    free(bytes);
}

/* taut-cad may die anywhere: the end is never seen, and nothing else is either but whole items. */
static void test_cut_short(void)
{
    const taut_cad_item items[] = {face, edge};
    size_t length = 0;
    char *bytes = written(items, 2, &length);
    for (size_t n = 1; n < length; n++) {
        const outcome o = read_back(bytes, n);
        CHECK(!o.has_ended && (o.status == TAUT_OK || o.status == TAUT_BAD_INPUT),
              "after %zu bytes: %d", n, (int)o.status);
        CHECK(o.status == TAUT_OK || o.error.message[0] != '\0', "after %zu bytes: nothing is said",
              n);
    }
    free(bytes);
}

/* Any byte may be any other: the numbers are refused, or are such as a model may hold. */
static void test_changed(void)
{
    static const unsigned char masks[] = {0x01, 0x80, 0xff};
    const taut_cad_item items[] = {face, edge};
    size_t length = 0;
    int refused = 0;
    char *bytes = written(items, 2, &length);
    for (size_t k = 0; k < 3 * length; k++) {
        const char kept = bytes[k / 3];
        outcome o;
        bytes[k / 3] = (char)((unsigned char)kept ^ masks[k % 3]);
        o = read_back(bytes, length);
        CHECK(o.status == TAUT_OK || o.status == TAUT_BAD_INPUT, "byte %zu: %d", k / 3,
              (int)o.status);
        CHECK(o.status == TAUT_OK || o.error.message[0] != '\0', "byte %zu: nothing is said",
              k / 3);
        refused += o.status == TAUT_BAD_INPUT;
        bytes[k / 3] = kept;
    }
    CHECK(refused > 100, "%d refused", refused);
    free(bytes);
}

/* What an item says of itself is looked at before memory is taken for it. */
static void test_heads(void)
{
    const struct {
        int degree[2], count[2];
        double found;
    } cases[] = {{{0, 1}, {3, 2}, 3},
                 {{2, 1}, {2, 2}, 2},
                 {{129, 1}, {200, 2}, 200},
                 {{2, 2}, {3, 2}, 2},
                 {{1, 1}, {1000001, 2}, 1000001},
                 {{1, 1}, {1000000, 51}, 51e6}};
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        size_t length = 0;
        char *bytes = written(&face, 1, &length);
        memcpy(bytes + 6, cases[i].degree, sizeof cases[i].degree); /* after "U", the unit, "I" */
        memcpy(bytes + 6 + sizeof cases[i].degree, cases[i].count, sizeof cases[i].count);
        const outcome o = read_back(bytes, length);
        CHECK(o.status == TAUT_BAD_INPUT && strcmp(o.error.reason, "size") == 0 &&
                  o.error.found == cases[i].found,
              "case %zu: %s, \"%s\"", i, o.error.reason, o.error.message);
        free(bytes);
    }
}

/* Names are cut to whole characters of UTF-8; bytes that are none become '?'. */
static void test_names(void)
{
    char name[TAUT_NAME_MAX + 8] = "";
    taut_cad_item item = face;
    size_t length = 0;
    char *bytes = NULL;
    outcome o;
    for (int i = 0; i < 130; i++) {
        memcpy(name + 2 * i, "\xc3\xa4", 2);
    }
    item.name = name;
    bytes = written(&item, 1, &length);
    o = read_back(bytes, length);
    CHECK(o.surfaces == 1 && strlen(o.name) == TAUT_NAME_MAX - 1 &&
              strncmp(o.name, name, TAUT_NAME_MAX - 1) == 0,
          "%zu bytes", strlen(o.name));
    free(bytes);
    item.name = "a\xff"
                "b";
    bytes = written(&item, 1, &length);
    o = read_back(bytes, length);
    CHECK(strcmp(o.name, "a?b") == 0, "\"%s\"", o.name);
    free(bytes);
}

int main(void)
{
    test_whole();
    test_cut_short();
    test_changed();
    test_heads();
    test_names();
    return check_failures != 0;
}
