/* test_told.c -- what the details of a film say of cables, supports, tension and cells: each number and each word of them changed, left
 * out, and one too many. Honest ones have no claim of it. */
#include "certificates.h"
#include "check.h"

#include "taut/construct.h"
#include "taut/read.h"

#include <string.h>

/* How leaf `at` of what is looked at is changed, and what it is called. */
typedef enum way { ANOTHER_NUMBER, ROUNDED, ANOTHER_WORD, LEFT_OUT } way;
typedef struct forgery {
    way way;
    int seen, at;
    char what[64]; /* empty where there is no such leaf */
} forgery;

static const double other_factor = 1 + 1e-6, rounded_factor = 1 + 1e-11;

static int is_meant(forgery *f, taut_record_kind kind, const char *key)
{
    const int counts = f->way == ANOTHER_WORD ? kind == TAUT_RECORD_TEXT
                       : f->way == LEFT_OUT ? kind == TAUT_RECORD_TEXT || kind == TAUT_RECORD_NUMBER
                                            : kind == TAUT_RECORD_NUMBER;
    if (!counts || f->seen++ != f->at) {
        return 0;
    }
    snprintf(f->what, sizeof f->what, "%s", key != NULL ? key : "an item");
    return 1;
}

static void copy(const taut_record *from, const char *key, taut_record *to, forgery *f)
{
    const taut_record_kind kind = taut_record_kind_of(from);
    const int meant = is_meant(f, kind, key);

    if (meant && f->way == LEFT_OUT) {
        return;
    }
    if (kind == TAUT_RECORD_NUMBER) {
        const double factor = f->way == ROUNDED ? rounded_factor : other_factor;
        taut_record_add_number(to, key, taut_record_number(from) * (meant ? factor : 1));
    } else if (kind == TAUT_RECORD_TEXT) {
        taut_record_add_text(to, key, meant ? "u9" : taut_record_text(from));
    } else {
        const int is_list = kind == TAUT_RECORD_LIST;
        taut_record *one =
            is_list ? taut_record_add_list(to, key) : taut_record_add_object(to, key);
        for (size_t k = 0; k < taut_record_count(from); k++) {
            copy(taut_record_at(from, k), is_list ? NULL : taut_record_key(from, k), one, f);
        }
    }
}

static const char *const members[] = {"tension", "cables", "supports", "held_straight", "cells"};

static int is_member(const char *key)
{
    int is = 0;
    for (size_t k = 0; k < sizeof members / sizeof *members; k++) {
        is |= strcmp(key, members[k]) == 0;
    }
    return is;
}

static taut_model *forged(const taut_model *model, forgery *f)
{
    const taut_record *details = taut_model_details(model);
    taut_record *other = taut_record_new();
    taut_model *made = NULL;

    for (size_t k = 0; k < taut_record_count(details); k++) {
        const char *key = taut_record_key(details, k);
        if (is_member(key)) {
            copy(taut_record_at(details, k), key, other, f);
        } else {
            taut_record_add_record(other, key, taut_record_at(details, k));
        }
    }
    CHECK(taut_record_status(other) == TAUT_OK && taut_model_copy(model, &made) == TAUT_OK, "copy");
    taut_model_set_details(made, other);
    return made;
}

/* What the certificate says of `details`; the others are as they were. */
static taut_verdict judge(const taut_model *model, const taut_problem *problem, const char *what)
{
    taut_certificate *certificate = NULL;
    taut_verdict holds = TAUT_TRUE;

    CHECK(taut_certify(model, problem, NULL, &certificate, NULL) == TAUT_OK, "%s", what);
    for (int k = 0; k < taut_certificate_claim_count(certificate); k++) {
        const taut_claim *claim = taut_certificate_claim(certificate, k);
        if (strcmp(claim->claim, "details") == 0) {
            CHECK(claim->residual > claim->limit && strncmp(claim->where, "details.", 8) == 0,
                  "%s: %g at %s", what, claim->residual, claim->where);
            holds = claim->holds;
        } else {
            CHECK(claim->holds != TAUT_FALSE, "%s: %s", what, claim->claim);
        }
    }
    taut_certificate_free(certificate);
    return holds;
}

static int try_each(const taut_model *model, const taut_problem *problem, way how)
{
    for (int at = 0;; at++) {
        forgery f = {.way = how, .at = at};
        taut_model *lies = forged(model, &f);
        if (f.what[0] != '\0') {
            /* without its one number a member says nothing, which is no lie */
            const int is_lie =
                how != ROUNDED && !(how == LEFT_OUT && strcmp(f.what, "tension") == 0);
            const taut_verdict holds = judge(lies, problem, f.what);
            CHECK(holds == (is_lie ? TAUT_FALSE : TAUT_TRUE), "%s, way %d", f.what, (int)how);
        }
        taut_model_free(lies);
        if (f.what[0] == '\0') {
            return at;
        }
    }
}

/* One more of each list. */
static void try_more(const taut_model *model, const taut_problem *problem)
{
    for (size_t k = 1; k < sizeof members / sizeof *members; k++) {
        taut_record *details = taut_record_copy(taut_model_details(model));
        taut_model *made = NULL;
        const taut_record *list = taut_record_get(details, members[k]);
        taut_record *longer = taut_record_new_list();
        for (size_t i = 0; i < taut_record_count(list); i++) {
            taut_record_add_record(longer, NULL, taut_record_at(list, i));
        }
        taut_record_add_text(longer, NULL, "u0");
        taut_record_add_record(details, members[k], longer);
        taut_record_free(longer);
        CHECK(taut_model_copy(model, &made) == TAUT_OK, "copy");
        taut_model_set_details(made, details);
        CHECK(judge(made, problem, members[k]) == TAUT_FALSE, "one more of %s", members[k]);
        taut_model_free(made);
    }
}

#define SIDE6 "{\"type\":\"bspline\",\"degree\":4,\"count\":6}"
#define SQUARE "\"u0v0\":[0,0,0],\"u1v0\":[2,0,0.3],\"u0v1\":[0,2,0.3],\"u1v1\":[2,2,0]"
/* Two halves of a saddle, with cables along both and a ridge; */
#define HALVES                                                                                     \
    "{\"taut\":1,\"construct\":\"film\",\"patches\":[{\"name\":\"a\",\"u\":" SIDE6 ",\"v\":" SIDE6 \
    ",\"corners\":{\"u0v0\":[0,0,0.5],\"u0v1\":[0,2,-0.5],\"u1v0\":{\"near\":[1,0.2,0]},\"u1v1\":" \
    "{\"near\":[1,1.8,0]}},\"edges\":{\"u0\":{\"cable\":{\"force\":3}}}"                           \
    "},{\"name\":\"b\",\"u\":" SIDE6 ",\"v\":" SIDE6                                               \
    ",\"corners\":{\"u1v0\":[2,0,-0.5],\"u1v1\":[2,2,0.5]},\"edges\":{\"u1\":{\"cable\":{"         \
    "\"unstressed\":2,\"stiffness\":40}}}}],\"seams\":[{\"edges\":[\"a.u1\",\"b.u0\"],"            \
    "\"cable\":{\"force\":0.5}}],\"cables\":[{\"name\":\"low\",\"along\":[\"a.v0\",\"b.v0\"],"     \
    "\"force\":3},{\"name\":\"high\",\"along\":[\"-b.v1\",\"-a.v1\"],\"force\":3.5}]}"

/* How many numbers and words each has that are looked at. */
static const struct {
    const char *name, *text;
    int numbers, words;
} rows[] = {
    {"all four laws",
     "{\"taut\":1,\"construct\":\"film\",\"tension\":1.25,\"corners\":{" SQUARE
     "},\"edges\":{\"u0\":{"
     "\"cable\":{\"sag\":0.13}},\"u1\":{\"cable\":{\"length\":2.1}},\"v0\":{\"cable\":{"
     "\"unstressed\":2,\"stiffness\":40}},\"v1\":{\"cable\":{\"force\":2.5}}}}",
     1 + 4 * 2 + 1, 4 + 4},
    {"held edges", "{\"taut\":1,\"construct\":\"film\",\"corners\":{" SQUARE "}}", 1, 4 + 4},
    {"threads",
     "{\"taut\":1,\"construct\":\"film\",\"force_density\":[1,2],\"corners\":{" SQUARE
     "},\"edges\":{"
     "\"u0\":{\"cable\":{\"force\":2.5}}}}",
     2, 1 + 4 + 3},
    {"a ring",
     "{\"taut\":1,\"construct\":\"film\",\"u\":{\"type\":\"bspline\",\"degree\":4,\"count\":16},"
     "\"v\":" SIDE6
     ",\"seams\":[[\"u0\",\"u1\"]],\"edges\":{\"v0\":{\"fixed\":{\"circle\":{\"center\":[0,0,0],"
     "\"normal\":[0,0,1],\"radius\":1}}},\"v1\":{\"cable\":{\"force\":0.3},\"plane\":{\"point\":[0,"
     "0,0.3],"
     "\"normal\":[0,0,1]}}}}",
     3, 1},
    {"patches", HALVES, 1 + 5 * 2 + 1, 5 + 4 + 4},
    {"a cell",
     "{\"taut\":1,\"construct\":\"film\",\"u\":{\"type\":\"bspline\",\"degree\":4,\"count\":16},"
     "\"v\":" SIDE6
     ",\"seams\":[[\"u0\",\"u1\"]],\"edges\":{\"v0\":{\"fixed\":{\"circle\":{\"center\":[0,0,0],"
     "\"normal\":[0,0,1],\"radius\":1}}},\"v1\":{\"pole\":null}},\"cells\":[{\"name\":\"air\","
     "\"sides\":["
     "\"film\"],\"volume\":1}]}",
     2, 2}};

int main(void)
{
    for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
        taut_problem *problem = NULL;
        taut_model *model = NULL;
        taut_error error = {.status = TAUT_OK};
        const char *text = rows[k].text;
        CHECK(taut_problem_read_text(text, strlen(text), rows[k].name, &problem, &error) ==
                      TAUT_OK &&
                  taut_make(problem, NULL, &model, &error) == TAUT_OK,
              "%s: %s: %s", rows[k].name, error.where, error.message);
        CHECK(judge(model, problem, rows[k].name) == TAUT_TRUE, "%s: the truth", rows[k].name);
        const int numbers = try_each(model, problem, ANOTHER_NUMBER),
                  words = try_each(model, problem, ANOTHER_WORD);
        CHECK(numbers == rows[k].numbers && words == rows[k].words, "%s: %d numbers, %d words",
              rows[k].name, numbers, words);
        CHECK(try_each(model, problem, ROUNDED) == numbers, "%s", rows[k].name);
        CHECK(try_each(model, problem, LEFT_OUT) == numbers + words, "%s", rows[k].name);
        try_more(model, problem);
        taut_model_free(model);
        taut_problem_free(problem);
    }
    return check_failures != 0;
}
