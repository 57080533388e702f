/* test_round_trip.c -- what is written is read back bit for bit, whatever the locale. */
#include "check.h"
#include "folder.h"
#include "models.h"

#include "taut/read.h"
#include "taut/write.h"

#include <locale.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static const char *folder;
static char path[64];

/* A record with everything in it, deep and with awkward strings. */
static taut_record *any_record(void)
{
    taut_record *root = taut_record_new();
    taut_record *list = taut_record_add_list(root, "list");
    taut_record *inner = taut_record_add_object(list, NULL);
    const double numbers[3] = {any_number(), any_number(), any_number()};

    taut_record_add_number(root, "x", any_number());
    taut_record_add_numbers(root, "three", 3, numbers);
    taut_record_add_text(inner, "quote \" back \\ slash /", "line\nend\ttab \x01 \x7f \xc3\xa9");
    taut_record_add_bool(inner, "", 1);
    taut_record_add_bool(inner, "no", 0);
    taut_record_add_null(inner, "nothing");
    taut_record_add_list(inner, "empty");
    taut_record_add_object(inner, "bare");
    CHECK(taut_record_status(root) == TAUT_OK, "record");
    return root;
}

static int same_record(const taut_record *a, const taut_record *b)
{
    const double x = taut_record_number(a), y = taut_record_number(b);
    if (taut_record_kind_of(a) != taut_record_kind_of(b) ||
        taut_record_count(a) != taut_record_count(b) ||
        taut_record_bool(a) != taut_record_bool(b) ||
        strcmp(taut_record_text(a), taut_record_text(b)) != 0 ||
        (taut_record_kind_of(a) == TAUT_RECORD_NUMBER && memcmp(&x, &y, sizeof x) != 0)) {
        return 0;
    }
    for (size_t i = 0; i < taut_record_count(a); i++) {
        if (strcmp(taut_record_key(a, i), taut_record_key(b, i)) != 0 ||
            !same_record(taut_record_at(a, i), taut_record_at(b, i))) {
            return 0;
        }
    }
    return 1;
}

static taut_certificate *any_certificate(void)
{
    const taut_claim claims[] = {
        {"stationary", TAUT_BOUND, any_number(), 1e-12, TAUT_TRUE, "/points/1/2", 0},
        {"minimal", TAUT_EXACT, nan(""), any_number(), TAUT_UNDECIDED, "", 0},
        {"boundary", TAUT_CHECK, 3, 0.1, TAUT_FALSE, "u0", 0}};
    taut_certificate *certificate = NULL;
    CHECK(taut_certificate_new("dirichlet", &certificate) == TAUT_OK, "certificate");
    for (int i = random_int(0, 3); i < 3; i++) {
        CHECK(taut_certificate_add(certificate, &claims[i]) == TAUT_OK, "claim %d", i);
    }
    taut_certificate_set_figures(certificate, any_record());
    return certificate;
}

static int same_claim(const taut_claim *a, const taut_claim *b)
{
    const int same_residual = memcmp(&a->residual, &b->residual, sizeof(double)) == 0 ||
                              (isnan(a->residual) && isnan(b->residual));
    return strcmp(a->claim, b->claim) == 0 && strcmp(a->where, b->where) == 0 && same_residual &&
           memcmp(&a->limit, &b->limit, sizeof(double)) == 0 && a->holds == b->holds &&
           a->kind == b->kind;
}

static int same_certificate(const taut_certificate *a, const taut_certificate *b)
{
    const int count = taut_certificate_claim_count(a);
    if (strcmp(taut_certificate_construct(a), taut_certificate_construct(b)) != 0 ||
        count != taut_certificate_claim_count(b) ||
        !same_record(taut_certificate_figures(a), taut_certificate_figures(b))) {
        return 0;
    }
    for (int i = 0; i < count; i++) {
        if (!same_claim(taut_certificate_claim(a, i), taut_certificate_claim(b, i))) {
            return 0;
        }
    }
    return 1;
}

static taut_model *any_model(void)
{
    static const char *const names[] = {"", "patch", "a\"b\\c\n\xe2\x82\xac"};
    static const char *const units[] = {"mm", "m", "cm", "in", "ft"};
    taut_model *model = NULL;
    CHECK(taut_model_new(&model) == TAUT_OK, "model");
    for (int i = random_int(0, 3); i < 3; i++) {
        add_any_surface(model, names[i]);
    }
    for (int i = random_int(0, 3); i < 3; i++) {
        add_any_curve(model, names[i]);
    }
    if (random_int(0, 1)) {
        taut_model_set_details(model, any_record());
        taut_model_set_certificate(model, any_certificate());
    }
    CHECK(taut_model_set_unit(model, units[random_int(0, 4)]) == TAUT_OK, "unit");
    return model;
}

static void check_same(const taut_model *a, const taut_model *b)
{
    CHECK(taut_model_surface_count(a) == taut_model_surface_count(b) &&
              taut_model_curve_count(a) == taut_model_curve_count(b) &&
              strcmp(taut_model_unit(a), taut_model_unit(b)) == 0,
          "counts or unit");
    for (int i = 0; i < taut_model_surface_count(a); i++) {
        CHECK(same_surface(taut_model_surface(a, i), taut_model_surface(b, i)), "surface %d", i);
    }
    for (int i = 0; i < taut_model_curve_count(a); i++) {
        CHECK(same_curve(taut_model_curve(a, i), taut_model_curve(b, i)), "curve %d", i);
    }
    CHECK((taut_model_details(a) == NULL) == (taut_model_details(b) == NULL) &&
              same_record(taut_model_details(a), taut_model_details(b)),
          "details");
    if (taut_model_certificate(a) != NULL && taut_model_certificate(b) != NULL) {
        CHECK(same_certificate(taut_model_certificate(a), taut_model_certificate(b)),
              "certificate");
    } else {
        CHECK(taut_model_certificate(a) == taut_model_certificate(b), "certificate");
    }
}

static void test_models(int trials)
{
    for (int trial = 0; trial < trials; trial++) {
        taut_model *model = any_model();
        taut_model *back = NULL;
        taut_error error = {.status = TAUT_OK};
        CHECK(taut_model_write(model, path, NULL, &error) == TAUT_OK, "%s", error.message);
        CHECK(taut_model_read(path, &back, &error) == TAUT_OK, "%s: %s", error.where,
              error.message);
        if (back != NULL) {
            check_same(model, back);
        }
        taut_model_free(model);
        taut_model_free(back);
    }
}

/* A knot vector without the outermost two gives the same basis as the full one. */
static void test_short_knots(void)
{
    static const char full[] = "{\"taut\":1,\"curves\":[{\"t\":{\"type\":\"bspline\",\"degree\":2,"
                               "\"knots\":[0,0,0,1,3,3,3]},"
                               "\"points\":[[0,0,0],[1,0,0],[2,0,0],[3,1,0]]}]}";
    static const char less[] = "{\"taut\":1,\"curves\":[{\"t\":{\"type\":\"bspline\",\"degree\":2,"
                               "\"knots\":[0,0,1,3,3]},"
                               "\"points\":[[0,0,0],[1,0,0],[2,0,0],[3,1,0]]}]}";
    taut_model *a = NULL, *b = NULL;
    CHECK(taut_model_read_text(full, sizeof full - 1, "full", &a, NULL) == TAUT_OK, "full");
    CHECK(taut_model_read_text(less, sizeof less - 1, "less", &b, NULL) == TAUT_OK, "less");
    check_same(a, b);
    taut_model_free(a);
    taut_model_free(b);
}

/* Everything may be missing but the version; white space and a byte order mark do not matter. */
static void test_least_model(void)
{
    static const char *const texts[] = {"{\"taut\":1}", "\xef\xbb\xbf {\"taut\"\n:\r 1.0 }\n",
                                        "{\"unit\": \"mm\", \"curves\": [], \"taut\": 1}"};
    for (size_t i = 0; i < 3; i++) {
        taut_model *model = NULL;
        taut_error error = {.status = TAUT_OK};
        CHECK(taut_model_read_text(texts[i], strlen(texts[i]), "doc", &model, &error) == TAUT_OK,
              "%s %s", error.where, error.message);
        CHECK(model != NULL && taut_model_surface_count(model) == 0 &&
                  strcmp(taut_model_unit(model), "mm") == 0,
              "text %zu", i);
        taut_model_free(model);
    }
}

/* What is not UTF-8 in a name is replaced: the document stays one that can be read. */
static void test_not_utf8(void)
{
    static const char *const names[] = {"a\xff", "\xc3", "\xed\xa0\x80", "\xf5\x80\x80\x80",
                                        "\xe0\x80\x80"};
    for (size_t i = 0; i < 5; i++) {
        taut_model *model = NULL, *back = NULL;
        CHECK(taut_model_new(&model) == TAUT_OK, "model");
        add_any_curve(model, names[i]);
        CHECK(taut_model_write(model, path, NULL, NULL) == TAUT_OK, "name %zu", i);
        CHECK(taut_model_read(path, &back, NULL) == TAUT_OK, "name %zu", i);
        CHECK(back != NULL &&
                  strstr(taut_curve_name(taut_model_curve(back, 0)), "\xef\xbf\xbd") != NULL,
              "name %zu", i);
        taut_model_free(model);
        taut_model_free(back);
    }
}

/* musl takes any name, and has points. */
static int has_comma(void)
{
    return *localeconv()->decimal_point == ',';
}

/* Makes a locale whose decimal point is a comma, if this machine can, and goes there. */
static int enter_comma_locale(void)
{
    static const char source[] = "LC_NUMERIC\ndecimal_point \",\"\nthousands_sep \".\"\n"
                                 "grouping 3;3\nEND LC_NUMERIC\n";
    static const char *const installed[] = {"de_DE.UTF-8", "de_DE.utf8", "fr_FR.UTF-8"};
    char command[256];
    for (size_t i = 0; i < 3; i++) {
        if (setlocale(LC_ALL, installed[i]) != NULL && has_comma()) {
            return 1;
        }
    }
    file_put_text(in_folder("comma.src"), source);
    snprintf(command, sizeof command,
             "localedef -c -i %s/comma.src %s/comma >%s/comma.log 2>&1 || true", folder, folder,
             folder);
    if (system(command) != 0) {
        return 0;
    }
    setenv("LOCPATH", folder, 1);
    return setlocale(LC_NUMERIC, "comma") != NULL && has_comma();
}

static void test_comma_locale(void)
{
    char text[32];
    if (!enter_comma_locale()) {
        printf("left out: no locale with a decimal comma is installed, nor can one be made\n");
        return;
    }
    snprintf(text, sizeof text, "%g", 0.5);
    CHECK(strcmp(text, "0,5") == 0, "the locale has \"%s\"", text);
    test_models(50);
    setlocale(LC_ALL, "C");
}

/* The text of a record: layout and length. */
static void test_record_text(void)
{
    taut_record *record = taut_record_new();
    taut_record *inner = taut_record_add_object(record, "inner");
    const double pair[2] = {0.5, INFINITY};
    char *text = NULL;
    size_t length = 0;
    taut_record_add_numbers(inner, "pair", 2, pair);
    taut_record_add_list(record, "none");
    CHECK(taut_record_write(record, &text, &length) == TAUT_OK, "record");
    CHECK(text != NULL && length == strlen(text) &&
              strcmp(text,
                     "{\n  \"inner\": {\n    \"pair\": [0.5, null]\n  },\n  \"none\": []\n}\n") ==
                  0,
          "\"%s\"", text);
    taut_text_free(text);
    taut_record_free(record);
    CHECK(taut_record_write(NULL, &text, &length) == TAUT_BAD_ARGUMENT, "NULL");
}

/* A certificate without figures is written with none in them. */
static void test_no_figures(void)
{
    taut_model *model = NULL, *back = NULL;
    taut_certificate *certificate = NULL;
    taut_error error = {.status = TAUT_OK};
    CHECK(taut_model_new(&model) == TAUT_OK &&
              taut_certificate_new("plateau", &certificate) == TAUT_OK,
          "model");
    taut_certificate_set_figures(certificate, NULL);
    taut_model_set_certificate(model, certificate);
    CHECK(taut_model_write(model, path, NULL, &error) == TAUT_OK, "%s", error.message);
    CHECK(taut_model_read(path, &back, &error) == TAUT_OK, "%s: %s", error.where, error.message);
    if (back != NULL) {
        const taut_certificate *read = taut_model_certificate(back);
        CHECK(read != NULL && strcmp(taut_certificate_construct(read), "plateau") == 0 &&
                  taut_certificate_claim_count(read) == 0 &&
                  taut_record_count(taut_certificate_figures(read)) == 0,
              "certificate");
    }
    taut_model_free(model);
    taut_model_free(back);
}

int main(void)
{
    random_seed(20240612);
    folder = folder_make();
    snprintf(path, sizeof path, "%s", in_folder("model.json"));
    test_models(300);
    test_short_knots();
    test_least_model();
    test_not_utf8();
    test_no_figures();
    test_record_text();
    test_comma_locale();
    folder_remove();
    return check_failures != 0;
}
