/* test_refusals.c -- every way a document can be wrong, and where the message says it is. */
#include "check.h"

#include "taut/read.h"

#include <stdlib.h>
#include <string.h>

/* The pieces of good documents, so that a row shows only what is wrong. */
#define QUAD "{\"type\": \"bezier\", \"degree\": 1}"
#define NET "[[[0,0,0],[0,1,0]],[[1,0,0],[1,1,0]]]"
#define HEAD "\"taut\": 1, \"construct\": \"dirichlet\", "
#define MAKE(construct) "\"taut\": 1, \"construct\": \"" construct "\", "
#define BASES "\"u\": " QUAD ", \"v\": " QUAD ", "
#define SURFACE "{\"u\": " QUAD ", \"v\": " QUAD ", \"points\": " NET "}"

typedef struct refusal {
    const char *document;
    const char *where;  /* the whole of error->where */
    const char *reason; /* NULL: a word of the basis or the construction */
    const char *says;   /* a part of error->expected, or of the sentence where that is empty */
} refusal;

/* Read as problems. */
static const refusal problems[] = {
    /* text that is not JSON: file:line:column */
    {"", "doc:1:1", "syntax", NULL},
    {" \n\t ", "doc:1:1", "syntax", NULL},
    {"{", "doc:1:2", "syntax", NULL},
    {"{\"taut\": 1", "doc:1:11", "syntax", NULL},
    {"{\"taut\": \"abc", "doc:1:14", "syntax", NULL},
    {"{\"taut\": nul}", "doc:1:10", "syntax", "a value"},
    {"{\"taut\": 1,\n \"u\": [1,\n  2 3]}", "doc:3:5", "syntax", "',' or ']'"},
    {"{\"taut\": NaN}", "doc:1:10", "syntax", NULL},
    {"{\"taut\": -Infinity}", "doc:1:10", "syntax", NULL},
    {"{\"taut\": 1e400}", "doc:1:10", "value", NULL},
    {"{\"taut\": 01}", "doc:1:10", "syntax", NULL},
    {"{\"taut\": 1} x", "doc:1:13", "syntax", NULL},
    {"{\"taut\": 1}{}", "doc:1:12", "syntax", NULL},
    {"{\"taut\": 1, \"taut\": 1}", "doc:1:13", "twice", NULL},
    {"{'taut': 1}", "doc:1:2", "syntax", NULL},
    {"// no\n{}", "doc:1:1", "syntax", NULL},
    {"{\"taut\": \"\xff\"}", "doc:1:11", "syntax", NULL},
    {"{\"taut\": \"\xc0\x80\"}", "doc:1:11", "syntax", NULL},
    {"{\"taut\": \"\\u0000\"}", "doc:1:11", "syntax", NULL},
    {"{\"taut\": \"\\ud800\"}", "doc:1:11", "syntax", NULL},
    {"{\"taut\": \"\\ud800\\u0041\"}", "doc:1:11", "syntax", NULL},
    {"{\"taut\": \"\\udc00\"}", "doc:1:11", "syntax", NULL},
    {"{\"taut\": \"\\u12g4\"}", "doc:1:11", "syntax", NULL},
    {"{\"taut\": \"ab\\x\"}", "doc:1:13", "syntax", NULL},
    {"{\"taut\": \"ab\n\"}", "doc:1:13", "syntax", NULL},
    {"{\"taut\": \"ab\\", "doc:1:14", "syntax", NULL},
    {"[1, 2,]", "doc:1:7", "syntax", "a value"},
    {"{\"a\": 1,}", "doc:1:9", "syntax", "the name of a member"},
    {"{\"a\" 1}", "doc:1:6", "syntax", "':'"},
    {"[1.]", "doc:1:2", "syntax", NULL},
    {"[.5]", "doc:1:2", "syntax", NULL},
    {"[+1]", "doc:1:2", "syntax", NULL},
    {"[1e]", "doc:1:2", "syntax", NULL},
    {"[1x]", "doc:1:2", "syntax", NULL},
    {"[truefalse]", "doc:1:2", "syntax", NULL},
    {"\xc3\xa9", "doc:1:1", "syntax", NULL},
    /* the root */
    {"3", "", "type", "an object"},
    {"[]", "", "type", "an object"},
    {"null", "", "type", "an object"},
    {"{}", "/construct", "missing", "the name of a construction"},
    {"{\"taut\": 1}", "/construct", "missing", NULL},
    {"{\"taut\": 1, \"construct\": 3}", "/construct", "type", NULL},
    {"{\"taut\": 1, \"construct\": \"dirichle\"}", "/construct", "name",
     "the nearest one is \"dirichlet\""},
    {"{\"taut\": 1, \"surfaces\": []}", "/construct", "kind", NULL},
    {"{\"construct\": \"dirichlet\"}", "/taut", "missing", "1"},
    {"{\"taut\": 2, \"construct\": \"dirichlet\"}", "/taut", "version", "1"},
    {"{\"taut\": \"1\", \"construct\": \"dirichlet\"}", "/taut", "type", "1"},
    {"{" HEAD "\"point\": 1}", "/point", "unknown-member", "\"points\""},
    {"{" HEAD "\"a/b~c\\n\": 1}", "/a~1b~0c\\u000a", "unknown-member", NULL},
    {"{" HEAD "\"unit\": \"yd\"}", "/unit", "name", "\"mm\", \"m\", \"cm\", \"in\" or \"ft\""},
    {"{" HEAD "\"unit\": 1}", "/unit", "type", NULL},
    {"{" HEAD "\"name\": 1, " BASES "\"points\": " NET "}", "/name", "type", "a string"},
    /* the net */
    {"{" HEAD BASES "\"aspect\": 1}", "/points", "missing", "an array"},
    {"{" HEAD BASES "\"points\": {}}", "/points", "type", NULL},
    {"{" HEAD BASES "\"points\": []}", "/points", "size",
     "an array of rows of points, one at least"},
    {"{" HEAD BASES "\"points\": [[]]}", "/points/0", "size", NULL},
    {"{" HEAD BASES "\"points\": [3]}", "/points/0", "type", NULL},
    {"{" HEAD BASES "\"points\": [[null,null],[null]]}", "/points/1", "size", NULL},
    {"{" HEAD BASES "\"points\": [[null,null],[null,null,null]]}", "/points/1", "size",
     "an array of 2 points"},
    {"{" HEAD BASES "\"points\": [[null,null],7]}", "/points/1", "type", NULL},
    {"{" HEAD BASES "\"points\": [[null,1],[null,null]]}", "/points/0/1", "type", "a point"},
    {"{" HEAD BASES "\"points\": [[null,[1,2]],[null,null]]}", "/points/0/1", "type",
     "a point [x, y, z]"},
    {"{" HEAD BASES "\"points\": [[null,[1,2,3,4]],[null,null]]}", "/points/0/1", "type", NULL},
    {"{" HEAD BASES "\"points\": [[null,[1,\"b\",3]],[null,null]]}", "/points/0/1/1", "value",
     "a number"},
    {"{" HEAD BASES "\"points\": [[null,[1,null,3]],[null,null]]}", "/points/0/1/1", "type", NULL},
    {"{" HEAD BASES "\"points\": [[null,null],[null,null],[null,null]]}", "/points", "size", NULL},
    {"{" HEAD BASES "\"points\": [[null,null,null],[null,null,null]]}", "/points", "size", NULL},
    /* weights and aspect */
    {"{" HEAD BASES "\"points\": " NET ", \"weights\": 1}", "/weights", "type", NULL},
    {"{" HEAD BASES "\"points\": " NET ", \"weights\": [[1,1]]}", "/weights", "size",
     "an array of 2 rows"},
    {"{" HEAD BASES "\"points\": " NET ", \"weights\": [[1,1],[1]]}", "/weights/1", "size",
     "an array of 2 numbers"},
    {"{" HEAD BASES "\"points\": " NET ", \"weights\": [[1,1],[1,0]]}", "/weights/1/1", "value",
     "a positive weight"},
    {"{" HEAD BASES "\"points\": " NET ", \"weights\": [[1,1],[1,-2]]}", "/weights/1/1", "value",
     NULL},
    {"{" HEAD BASES "\"points\": " NET ", \"weights\": [[1,1],[1,null]]}", "/weights/1/1", "type",
     NULL},
    {"{" HEAD BASES "\"points\": " NET ", \"aspect\": 0}", "/aspect", "value", "a positive"},
    {"{" HEAD BASES "\"points\": " NET ", \"aspect\": \"best\"}", "/aspect", "type", NULL},
    /* bases */
    {"{" HEAD "\"v\": " QUAD ", \"points\": " NET "}", "/u", "missing", "an object"},
    {"{" HEAD "\"u\": \"bezier\", \"v\": " QUAD ", \"points\": " NET "}", "/u", "type",
     "an object"},
    {"{" HEAD "\"u\": {}, \"v\": " QUAD ", \"points\": " NET "}", "/u/type", "missing", NULL},
    {"{" HEAD "\"u\": {\"type\": \"bezir\"}, \"v\": " QUAD ", \"points\": " NET "}", "/u/type",
     "name", "nearest one is \"bezier\""},
    {"{" HEAD "\"u\": {\"type\": \"bezier\"}, \"v\": " QUAD ", \"points\": " NET "}", "/u/degree",
     "missing", "a whole number"},
    {"{" HEAD "\"u\": {\"type\": \"bezier\", \"degree\": 0}, \"v\": " QUAD ", \"points\": " NET "}",
     "/u/degree", "value", "a whole number from 1 to 128"},
    {"{" HEAD "\"u\": {\"type\": \"bezier\", \"degree\": 1.5}, \"v\": " QUAD ", \"points\": " NET
     "}",
     "/u/degree", "value", NULL},
    {"{" HEAD "\"u\": {\"type\": \"bezier\", \"degree\": 1e30}, \"v\": " QUAD ", \"points\": " NET
     "}",
     "/u/degree", "value", NULL},
    {"{" HEAD "\"u\": {\"type\": \"bezier\", \"degre\": 1}, \"v\": " QUAD ", \"points\": " NET "}",
     "/u/degre", "unknown-member", "\"degree\""},
    {"{" HEAD "\"u\": {\"type\": \"bezier\", \"degree\": 1, \"knots\": [0]}, \"v\": " QUAD
     ", \"points\": " NET "}",
     "/u/knots", "unknown-member", NULL},
    {"{" HEAD "\"u\": {\"type\": \"h-bezier\", \"alpha\": 1}, \"v\": " QUAD ", \"points\": " NET
     "}",
     "/u/alpha", "unknown-member", NULL},
    {"{" HEAD "\"u\": {\"type\": \"bezier\", \"degree\": 1, \"range\": [1, 1]}, \"v\": " QUAD
     ", \"points\": " NET "}",
     "/u/range", NULL, NULL},
    {"{" HEAD "\"u\": {\"type\": \"bezier\", \"degree\": 1, \"range\": [1]}, \"v\": " QUAD
     ", \"points\": " NET "}",
     "/u/range", "size", "an array of 2 numbers"},
    {"{" HEAD "\"u\": " QUAD ", \"v\": {\"type\": \"bspline\", \"degree\": 1}, \"points\": " NET
     "}",
     "/v", NULL, NULL},
    {"{" HEAD "\"u\": " QUAD ", \"v\": {\"type\": \"bspline\", \"degree\": 1, \"count\": 3}, "
     "\"points\": " NET "}",
     "/points", "size", NULL},
    {"{" HEAD "\"u\": " QUAD ", \"v\": {\"type\": \"bspline\", \"degree\": 1, \"count\": 1e9}, "
     "\"points\": " NET "}",
     "/v/count", "value", "a whole number"},
    {"{" HEAD "\"u\": " QUAD ", \"v\": {\"type\": \"bspline\", \"degree\": 1, \"knots\": 3}, "
     "\"points\": " NET "}",
     "/v/knots", "type", NULL},
    {"{" HEAD "\"u\": " QUAD ", \"v\": {\"type\": \"bspline\", \"degree\": 1, "
     "\"knots\": [0, 0, \"1\", 1]}, \"points\": " NET "}",
     "/v/knots/2", "type", "a number"},
    {"{" HEAD "\"u\": " QUAD ", \"v\": {\"type\": \"bspline\", \"degree\": 1, "
     "\"knots\": [0, 0, 1, 1, 1]}, \"points\": " NET "}",
     "/v/knots", NULL, NULL},
    {"{" HEAD "\"u\": " QUAD ", \"v\": {\"type\": \"bspline\", \"degree\": 1, "
     "\"knots\": [1, 0]}, \"points\": " NET "}",
     "/v/knots", NULL, NULL},
    {"{" HEAD "\"u\": {\"type\": \"c-bezier\", \"alpha\": 1}, \"v\": " QUAD ", \"points\": "
     "[[null,null],[null,null],[null,null],[null,null]], \"weights\": [[1,1],[1,1],[1,1],[1,1]]}",
     "/weights", "conflict", NULL},
    {"{" HEAD "\"u\": " QUAD ", \"v\": {\"type\": \"h-bezier\", \"beta\": 1}, \"points\": "
     "[[null,null,null,null],[null,null,null,null]], \"weights\": 1}",
     "/weights", "conflict", NULL},
    /* what other constructions ask for */
    {"{" MAKE("asymptotic") "\"degree\": 3, \"corners\": {\"u0v0\": [0,0,0], \"u1v0\": [1,0,0], "
                            "\"u0v1\": [0,1,0], \"u1v1\": [1,1,0]}, \"edges\": {\"v0\": {\"legs\": "
                            "[[1,0,0]], "
                            "\"curvature\": [1,1], \"weights\": [1,1,1,1]}}}",
     "/edges/v0/curvature", NULL, NULL},
    {"{" MAKE("harmonic") "\"from\": \"derivative\", \"points\": []}", "/points", NULL, NULL},
    {"{" MAKE("harmonic") BASES "\"points\": " NET ", \"cross_derivative\": []}",
     "/cross_derivative", NULL, NULL},
    {"{" MAKE("harmonic") BASES "\"points\": " NET ", \"edge\": []}", "/edge", NULL, NULL},
    {"{" MAKE("pipe") "\"radius\": 1, \"polygon\": [[0,0,0],[1,0,0],[1,1,0],[1,1,1]], \"shape\": "
                      "{\"auto\": \"bending\", \"alpha\": 1}}",
     "/shape", NULL, NULL},
    {"{" MAKE("pipe") "\"radius\": 1, \"run\": [{\"from\": [0,0,0], \"to\": [1,0,0]}, "
                      "{\"point\": [3,3,0], \"direction\": [0,-0,0]}]}",
     "/run/1/direction", "value", "a vector that is not zero"},
    {"{" MAKE("plateau") BASES "\"curves\": {}, \"start\": 1}", "/start", NULL, NULL},
};

/* Read as models. */
static const refusal models[] = {
    {"[]", "", "type", "an object"},
    {"{}", "/taut", "missing", "1"},
    {"{\"taut\": 1, \"surface\": []}", "/surface", "unknown-member", "\"surfaces\""},
    {"{\"taut\": 1, \"construct\": \"dirichlet\"}", "/construct", "kind", NULL},
    {"{\"taut\": 1, \"surfaces\": {}}", "/surfaces", "type", "an array of surfaces"},
    {"{\"taut\": 1, \"surfaces\": [3]}", "/surfaces/0", "type",
     "an object with \"name\", \"u\", \"v\", \"points\" or \"weights\""},
    {"{\"taut\": 1, \"surfaces\": [" SURFACE ", {\"pionts\": 1}]}", "/surfaces/1/pionts",
     "unknown-member", "\"points\""},
    {"{\"taut\": 1, \"surfaces\": [{\"u\": " QUAD ", \"v\": " QUAD
     ", \"points\": [[[0,0,0],null],[[1,0,0],[1,1,0]]]}]}",
     "/surfaces/0/points/0/1", "type", "a point"},
    {"{\"taut\": 1, \"surfaces\": [{\"u\": " QUAD ", \"v\": {\"type\": \"x\"}, \"points\": " NET
     "}]}",
     "/surfaces/0/v/type", "name", NULL},
    {"{\"taut\": 1, \"surfaces\": [{\"u\": " QUAD ", \"v\": " QUAD ", \"points\": " NET
     ", \"weights\": [[1, 1], [0, 1]]}]}",
     "/surfaces/0/weights/1/0", "value", NULL},
    {"{\"taut\": 1, \"curves\": [{\"points\": [[0,0,0]]}]}", "/curves/0/t", "missing", NULL},
    {"{\"taut\": 1, \"curves\": [{\"t\": " QUAD "}]}", "/curves/0/points", "missing", NULL},
    {"{\"taut\": 1, \"curves\": [{\"t\": " QUAD ", \"points\": [[0,0,0]]}]}", "/curves/0/points",
     "size", NULL},
    {"{\"taut\": 1, \"curves\": [{\"t\": " QUAD ", \"points\": [[0,0,0],[1]]}]}",
     "/curves/0/points/1", "type", NULL},
    {"{\"taut\": 1, \"curves\": [{\"t\": " QUAD
     ", \"points\": [[0,0,0],[1,1,1]], \"weights\": [1]}]}",
     "/curves/0/weights", "size", "an array of 2 numbers"},
    {"{\"taut\": 1, \"curves\": [{\"t\": " QUAD
     ", \"points\": [[0,0,0],[1,1,1]], \"weights\": [1, -1]}]}",
     "/curves/0/weights/1", "value", NULL},
    {"{\"taut\": 1, \"details\": []}", "/details", "type", "an object"},
    {"{\"taut\": 1, \"certificate\": 1}", "/certificate", "type", "an object"},
    {"{\"taut\": 1, \"certificate\": {}}", "/certificate/construct", "missing", NULL},
    {"{\"taut\": 1, \"certificate\": {\"construct\": \"a\", \"claim\": []}}", "/certificate/claim",
     "unknown-member", "\"claims\""},
    {"{\"taut\": 1, \"certificate\": {\"construct\": \"a\", \"claims\": [{\"claim\": \"x\", "
     "\"at\": 1}]}}",
     "/certificate/claims/0/at", "unknown-member", NULL},
    {"{\"taut\": 1, \"certificate\": {\"construct\": \"a\", \"claims\": {}}}",
     "/certificate/claims", "type", "an array of claims"},
    {"{\"taut\": 1, \"certificate\": {\"construct\": \"a\", \"holds\": 1}}", "/certificate/holds",
     "type", "true, false or null"},
    {"{\"taut\": 1, \"certificate\": {\"construct\": \"a\", \"figures\": []}}",
     "/certificate/figures", "type", "an object"},
    {"{\"taut\": 1, \"certificate\": {\"construct\": \"a\", \"claims\": [{\"claim\": 1}]}}",
     "/certificate/claims/0/claim", "type", "a string"},
    {"{\"taut\": 1, \"certificate\": {\"construct\": \"a\", \"claims\": [{\"claim\": \"x\"}]}}",
     "/certificate/claims/0/residual", "missing", "a number"},
    {"{\"taut\": 1, \"certificate\": {\"construct\": \"a\", \"claims\": [{\"claim\": \"x\", "
     "\"residual\": 1, \"limit\": null}]}}",
     "/certificate/claims/0/holds", "missing", "true, false or null"},
};

static void check_refused(const refusal *row, taut_status status, const taut_error *error)
{
    CHECK(status == TAUT_BAD_INPUT && error->status == TAUT_BAD_INPUT, "status %d for %s", status,
          row->document);
    CHECK(strcmp(error->where, row->where) == 0, "where \"%s\", expected \"%s\", for %s",
          error->where, row->where, row->document);
    CHECK(error->reason[0] != '\0' &&
              (row->reason == NULL || strcmp(error->reason, row->reason) == 0),
          "\"%s\" in place of \"%s\", for %s", error->reason, row->reason, row->document);
    const char *said = error->expected[0] != '\0' ? error->expected : error->message;
    CHECK(row->says == NULL || strstr(said, row->says) != NULL, "\"%s\" without \"%s\", for %s",
          said, row->says, row->document);
}

static void test_problems(void)
{
    for (size_t i = 0; i < sizeof problems / sizeof problems[0]; i++) {
        const refusal *row = &problems[i];
        taut_problem *problem = NULL;
        taut_error error = {.status = TAUT_OK};
        const taut_status status =
            taut_problem_read_text(row->document, strlen(row->document), "doc", &problem, &error);
        check_refused(row, status, &error);
        CHECK(problem == NULL, "a problem was made of %s", row->document);
        CHECK(taut_problem_read_text(row->document, strlen(row->document), "doc", &problem, NULL) ==
                  TAUT_BAD_INPUT,
              "without an error, %s", row->document);
    }
}

static void test_models(void)
{
    for (size_t i = 0; i < sizeof models / sizeof models[0]; i++) {
        const refusal *row = &models[i];
        taut_model *model = NULL;
        taut_error error = {.status = TAUT_OK};
        const taut_status status =
            taut_model_read_text(row->document, strlen(row->document), "doc", &model, &error);
        check_refused(row, status, &error);
        CHECK(model == NULL, "a model was made of %s", row->document);
    }
}

/* What is well formed but does not exist has a status of its own, and its place all the same. */
static void test_no_solution(void)
{
    static const char text[] =
        "{\"taut\": 1, \"curves\": [{\"t\": {\"type\": \"c-bspline\", \"alpha\": "
        "3.2, \"segments\": 1}, \"points\": "
        "[[0,0,0],[1,1,1],[2,2,2],[3,3,3]]}]}";
    taut_model *model = NULL;
    taut_error error = {.status = TAUT_OK};
    CHECK(taut_model_read_text(text, sizeof text - 1, "doc", &model, &error) == TAUT_NO_SOLUTION,
          "alpha above pi: %s", error.message);
    CHECK(strcmp(error.where, "/curves/0/t/alpha") == 0 && error.found == 3.2, "where \"%s\"",
          error.where);
}

/* A 0 byte inside, found at its place although the text before it is whole. */
static void test_zero_byte(void)
{
    static const char text[] = "{\"taut\":\n 1\0}";
    taut_model *model = NULL;
    taut_error error = {.status = TAUT_OK};
    CHECK(taut_model_read_text(text, sizeof text - 1, "doc", &model, &error) == TAUT_BAD_INPUT,
          "a 0 byte");
    CHECK(strcmp(error.where, "doc:2:3") == 0, "where \"%s\"", error.where);
}

/* Depth that would overflow a stack is refused, for lists, objects and records alike. */
static void test_depth(void)
{
    enum { DEPTH = 200000 };
    char *text = malloc(DEPTH * 5 + 64);
    taut_model *model = NULL;
    taut_error error = {.status = TAUT_OK};

    memset(text, '[', DEPTH);
    CHECK(taut_model_read_text(text, DEPTH, "doc", &model, &error) == TAUT_BAD_INPUT, "lists");
    CHECK(strcmp(error.reason, "depth") == 0, "\"%s\"", error.message);
    for (size_t i = 0; i < DEPTH; i++) {
        memcpy(text + 5 * i, "{\"a\":", 5);
    }
    CHECK(taut_model_read_text(text, (size_t)DEPTH * 5, "doc", &model, &error) == TAUT_BAD_INPUT,
          "objects");
    CHECK(strcmp(error.reason, "depth") == 0, "\"%s\"", error.message);
    free(text);
}

/* A long name of a file keeps its line and column; a long key leaves a pointer that is whole
 * UTF-8. */
static void test_long_names(void)
{
    char name[1000], text[2200];
    taut_model *model = NULL;
    taut_error error = {.status = TAUT_OK};
    size_t n = 0;

    memset(name, 'x', sizeof name - 1);
    name[sizeof name - 1] = '\0';
    CHECK(taut_model_read_text("{\n x", 4, name, &model, &error) == TAUT_BAD_INPUT, "long name");
    CHECK(strstr(error.where, "x:2:2") != NULL && strncmp(error.where, "...x", 4) == 0,
          "where \"%s\"", error.where);
    n = (size_t)sprintf(text, "{\"");
    for (int i = 0; i < 1000; i++) {
        memcpy(text + n, "\xc3\xa9", 2);
        n += 2;
    }
    n += (size_t)sprintf(text + n, "\": 1}");
    CHECK(taut_model_read_text(text, n, "doc", &model, &error) == TAUT_BAD_INPUT, "long key");
    n = strlen(error.where);
    CHECK(n > 60 && n % 2 == 0 && strcmp(error.where + n - 3, "...") == 0, "where \"%s\"",
          error.where);
    memmove(text + 3, text + 2, strlen(text) - 1); /* now a character lies across the cut */
    text[2] = 'x';
    CHECK(taut_model_read_text(text, strlen(text), "doc", &model, &error) == TAUT_BAD_INPUT, "key");
    CHECK(strncmp(error.where, "/x\xc3\xa9", 4) == 0 && strlen(error.where) == n - 1 &&
              strcmp(error.where + n - 6, "\xc3\xa9...") == 0,
          "where \"%s\", %zu", error.where, n);
}

/* So deep that the way there is not kept whole: its beginning is, and cut as any that is long. */
static void test_deep_place(void)
{
    enum { DEPTH = 100 };
    char *text = malloc(20000), expected[512];
    taut_model *model = NULL;
    taut_error error = {.status = TAUT_OK};
    size_t n = (size_t)sprintf(text, "{\"taut\": 1, \"details\": {\"x\": "), m = 0;
    memset(text + n, '[', DEPTH);
    n += DEPTH;
    n += (size_t)sprintf(text + n, "{");
    for (int i = 0; i <= TAUT_MEMBERS_MAX; i++) {
        n += (size_t)sprintf(text + n, "%s\"%d\": 1", i > 0 ? "," : "", i);
    }
    n += (size_t)sprintf(text + n, "}");
    memset(text + n, ']', DEPTH);
    n += DEPTH;
    n += (size_t)sprintf(text + n, "}}");
    m = (size_t)sprintf(expected, "/details/x");
    for (int i = 0; i < DEPTH; i++) {
        m += (size_t)sprintf(expected + m, "/0");
    }
    CHECK(taut_model_read_text(text, n, "doc", &model, &error) == TAUT_BAD_INPUT, "members");
    CHECK(strlen(error.where) > 100 && strncmp(error.where, expected, strlen(error.where)) == 0,
          "where \"%s\"", error.where);
    CHECK(error.found == TAUT_MEMBERS_MAX + 1 && strcmp(error.reason, "size") == 0, "%s",
          error.message);
    free(text);
}

/* Of many members that are given twice the first in the text is told. */
static void test_twice(void)
{
    char text[600];
    size_t n = (size_t)sprintf(text, "{");
    taut_record *record = NULL;
    taut_error error = {.status = TAUT_OK};
    for (int i = 0; i < 40; i++) {
        n += (size_t)sprintf(text + n, "\"%d\": 1,\n", 100 - i);
    }
    n += (size_t)sprintf(text + n, "\"80\": 1,\n\"70\": 2, \"90\": 3}");
    CHECK(taut_record_read_text(text, n, "doc", &record, &error) == TAUT_BAD_INPUT &&
              record == NULL,
          "twice");
    CHECK(strcmp(error.where, "doc:41:1") == 0 && strcmp(error.reason, "twice") == 0, "%s: %s",
          error.where, error.message);
}

/* A record is an object or a list. */
static void test_records(void)
{
    static const char *const texts[] = {"3", "\"text\"", "null"};
    for (int i = 0; i < 3; i++) {
        taut_record *record = NULL;
        taut_error error = {.message = "x"};
        CHECK(taut_record_read_text(texts[i], strlen(texts[i]), "doc", &record, &error) ==
                      TAUT_BAD_INPUT &&
                  record == NULL,
              "%s", texts[i]);
        CHECK(error.where[0] == '\0' && strcmp(error.expected, "an object") == 0, "%s: %s: %s",
              texts[i], error.where, error.message);
    }
}

/* More members than a record looks up in reasonable time. */
static void test_many_members(void)
{
    char *text = malloc(40000);
    size_t n = (size_t)sprintf(text, "{\"taut\": 1, \"details\": {\"x\": {");
    taut_model *model = NULL;
    taut_error error = {.status = TAUT_OK};
    for (int i = 0; i <= TAUT_MEMBERS_MAX; i++) {
        n += (size_t)sprintf(text + n, "%s\"%d\": 1", i > 0 ? "," : "", i);
    }
    n += (size_t)sprintf(text + n, "}}}");
    CHECK(taut_model_read_text(text, n, "doc", &model, &error) == TAUT_BAD_INPUT, "members");
    CHECK(strcmp(error.where, "/details/x") == 0 && error.found == TAUT_MEMBERS_MAX + 1,
          "where \"%s\", %s", error.where, error.message);
    free(text);
}

/* Nothing to read, or no place for what is read. */
static void test_bad_arguments(void)
{
    taut_model *model = NULL;
    taut_problem *problem = NULL;
    taut_problem_list *list = NULL;
    taut_error e[13];
    memset(e, 0, sizeof e);
    const taut_status told[] = {
        taut_model_read_text(NULL, 3, "doc", &model, &e[0]),
        taut_model_read_text("{}", 2, "doc", NULL, &e[1]),
        taut_problem_read_text(NULL, 3, "doc", &problem, &e[2]),
        taut_problem_read_text("{}", 2, "doc", NULL, &e[3]),
        taut_problem_read(NULL, &problem, &e[4]),
        taut_model_read(NULL, &model, &e[5]),
        taut_problem_list_read_text(NULL, 3, "doc", &list, &e[6]),
        taut_problem_list_read_text("[]", 2, "doc", NULL, &e[7]),
        taut_problem_list_read(NULL, &list, &e[8]),
        taut_problem_list_read("none", NULL, &e[9]),
        taut_problem_or_model_read(NULL, &problem, &model, &e[10]),
        taut_problem_or_model_read("none", &problem, NULL, &e[11]),
        taut_problem_or_model_read_with("none", NULL, NULL, &model, &e[12]),
    };
    for (size_t i = 0; i < sizeof told / sizeof told[0]; i++) {
        CHECK(told[i] == TAUT_BAD_ARGUMENT && e[i].status == told[i] &&
                  strcmp(e[i].reason, "argument") == 0,
              "call %zu: %d, \"%s\"", i, (int)told[i], e[i].message);
    }
    CHECK(model == NULL && problem == NULL && list == NULL, "outputs are untouched");
    CHECK(taut_problem_or_model_read("none", NULL, &model, NULL) == TAUT_BAD_ARGUMENT, "no error");
}

int main(void)
{
    test_problems();
    test_models();
    test_no_solution();
    test_zero_byte();
    test_depth();
    test_long_names();
    test_many_members();
    test_deep_place();
    test_twice();
    test_records();
    test_bad_arguments();
    return check_failures != 0;
}
