/* test_problems.c -- what is read of a good problem, number by number; files that cannot be read.
 *
 * needs: posix
 */
#include "check.h"
#include "folder.h"

#include "problem/problem.h"
#include "taut/biharmonic.h"
#include "taut/dirichlet.h"
#include "taut/harmonic.h"
#include "taut/read.h"

#include <errno.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static const char text[] =
    "{\"taut\": 1, \"construct\": \"dirichlet\", \"unit\": \"in\", \"name\": \"lid\",\n"
    " \"u\": {\"type\": \"bezier\", \"degree\": 2, \"range\": [-1, 3]},\n"
    " \"v\": {\"type\": \"bspline\", \"degree\": 2, \"knots\": [0, 0, 0.25, 1, 1]},\n"
    " \"points\": [[[1, 2, 3], [4, 5, 6], [7, 8, 9], [10, 11, 12]],\n"
    "              [[0.1, -0, 1e-310], null, null, [1, 1, 1]],\n"
    "              [[1, 0, 0], null, [2, 0, 0], [3, 0, 0]]],\n"
    " \"weights\": [[1, 2, 3, 4], [5, 6, 7, 8], [9, 10, 11, 12]], \"aspect\": 2.5}";

static void test_members(void)
{
    static const unsigned char known[12] = {1, 1, 1, 1, 1, 0, 0, 1, 1, 0, 1, 1};
    taut_problem *problem = NULL;
    taut_error error = {.status = TAUT_OK};
    CHECK(taut_problem_read_text(text, sizeof text - 1, "text", &problem, &error) == TAUT_OK,
          "%s %s", error.where, error.message);
    if (problem == NULL) {
        return;
    }
    const taut_dirichlet_problem *data = problem->data;
    CHECK(strcmp(taut_problem_construction(problem), "dirichlet") == 0, "construct");
    CHECK(strcmp(problem->unit, "in") == 0 && strcmp(data->name, "lid") == 0, "unit and name");
    CHECK(data->aspect == 2.5 && !data->aspect_auto, "aspect");
    CHECK(taut_basis_lo(data->u) == -1 && taut_basis_hi(data->u) == 3, "range of u");
    CHECK(taut_basis_count(data->v) == 4 && taut_basis_breaks(data->v)[1] == 0.25, "knots of v");
    CHECK(memcmp(data->known, known, 12) == 0, "known");
    for (int i = 0; i < 12; i++) {
        CHECK(data->weights[i] == i + 1, "weight %d", i);
        CHECK(data->points[i] == i + 1, "coordinate %d", i);
    }
    CHECK(data->points[12] == 0.1 && signbit(data->points[13]) && data->points[14] == 1e-310,
          "point 1 0");
    CHECK(data->points[3 * 5] == 0 && data->points[3 * 10] == 2, "points of row 1 and 2");
    taut_problem_free(problem);
}

static void test_defaults(void)
{
    static const char least[] =
        "{\"taut\": 1, \"construct\": \"dirichlet\", \"u\": {\"type\": \"bezier\", \"degree\": 1}, "
        "\"v\": {\"type\": \"bezier\", \"degree\": 1}, "
        "\"points\": [[null, null], [null, null]], \"aspect\": \"auto\"}";
    taut_problem *problem = NULL;
    CHECK(taut_problem_read_text(least, sizeof least - 1, "least", &problem, NULL) == TAUT_OK,
          "least: a net without known points is well formed");
    if (problem == NULL) {
        return;
    }
    const taut_dirichlet_problem *data = problem->data;
    CHECK(data->name == NULL && data->weights == NULL && data->aspect == 0 && data->aspect_auto,
          "defaults");
    CHECK(strcmp(problem->unit, "mm") == 0, "unit");
    taut_problem_free(problem);
}

/* Four rows of a biharmonic surface, with a name for it. */
static void test_rows(void)
{
    static const char rows[] =
        "{\"taut\": 1, \"construct\": \"biharmonic\", \"name\": \"bridge\", \"u\": {\"type\": "
        "\"bezier\", \"degree\": 1}, \"v\": {\"type\": \"bezier\", \"degree\": 2}, "
        "\"points\": [[null, [1, 2, 3], null], [null, null, [4, 5, 6]]]}";
    static const unsigned char known[6] = {0, 1, 0, 0, 0, 1};
    taut_problem *problem = NULL;
    CHECK(taut_problem_read_text(rows, sizeof rows - 1, "rows", &problem, NULL) == TAUT_OK, "rows");
    if (problem == NULL) {
        return;
    }
    const taut_biharmonic_problem *data = problem->data;
    CHECK(data->rows.name != NULL && strcmp(data->rows.name, "bridge") == 0, "name");
    CHECK(memcmp(data->rows.known, known, 6) == 0 && data->rows.points[4] == 2 &&
              data->rows.points[17] == 6,
          "points");
    taut_problem_free(problem);
}

/* "allow_ill_conditioned" by its name, by the old one, and by both at once. */
static void test_allowed(void)
{
    static const struct {
        const char *members;
        int allowed; /* -1: refused */
    } cases[] = {{"", 0},
                 {", \"allow_ill_conditioned\": true", 1},
                 {", \"insist\": true", 1},
                 {", \"insist\": false", 0},
                 {", \"insist\": true, \"allow_ill_conditioned\": true", -1}};
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        char document[512];
        taut_problem *problem = NULL;
        taut_error error = {.status = TAUT_OK};
        const int length =
            snprintf(document, sizeof document,
                     "{\"taut\": 1, \"construct\": \"harmonic\", \"u\": {\"type\": \"bezier\", "
                     "\"degree\": 1}, "
                     "\"v\": {\"type\": \"bezier\", \"degree\": 1}, "
                     "\"points\": [[[0, 0, 0], [1, 2, 3]], [[4, 5, 6], [7, 8, 9]]]%s}",
                     cases[i].members);
        const taut_status status =
            taut_problem_read_text(document, (size_t)length, "rows", &problem, &error);
        if (cases[i].allowed < 0) {
            CHECK(status == TAUT_BAD_INPUT && strcmp(error.reason, "conflict") == 0 &&
                      strcmp(error.where, "/insist") == 0,
                  "%s: %s", error.where, error.message);
            continue;
        }
        CHECK(status == TAUT_OK, "%s: %s", error.where, error.message);
        if (problem != NULL) {
            const taut_harmonic_problem *data = problem->data;
            CHECK(data->rows.allow_ill_conditioned == cases[i].allowed, "%s", cases[i].members);
        }
        taut_problem_free(problem);
    }
}

static void check_io(const char *path, const char *reason)
{
    taut_problem *problem = NULL;
    taut_model *model = NULL;
    taut_error error = {.status = TAUT_OK};
    CHECK(taut_problem_read(path, &problem, &error) == TAUT_IO, "problem %s", path);
    CHECK(strcmp(error.reason, "read") == 0, "%s", error.reason);
    CHECK(strstr(error.message, path) != NULL && strstr(error.message, reason) != NULL,
          "\"%s\" does not say %s and %s", error.message, path, reason);
    error.message[0] = '\0';
    CHECK(taut_model_read(path, &model, &error) == TAUT_IO, "model %s", path);
    CHECK(strstr(error.message, path) != NULL && strstr(error.message, reason) != NULL,
          "\"%s\" does not say %s and %s", error.message, path, reason);
    CHECK(problem == NULL && model == NULL, "outputs are untouched");
}

static void test_files(void)
{
    const char *const path = in_folder("problem.json");
    taut_problem *problem = NULL;
    taut_error error = {.status = TAUT_OK};

    check_io(in_folder(""), "directory");
    check_io(in_folder("none.json"), strerror(ENOENT));
    file_put_text(path, text);
    CHECK(taut_problem_read(path, &problem, &error) == TAUT_OK, "%s %s", error.where,
          error.message);
    taut_problem_free(problem);
    if (geteuid() != 0) {
        chmod(path, 0);
        check_io(path, "denied");
    }
    chmod(path, 0600);
    file_put_text(path, "{\n  oops");
    CHECK(taut_problem_read(path, &problem, &error) == TAUT_BAD_INPUT, "oops");
    CHECK(strncmp(error.where, path, strlen(path)) == 0 && strstr(error.where, ":2:3") != NULL,
          "where \"%s\"", error.where);
}

/* What another library is to read must be a file: not a folder, nor a pipe, which is not waited
 * for.
 */
static void test_no_file(void)
{
    const char *const path = in_folder("none.step");
    taut_model *model = NULL;
    taut_error error = {.status = TAUT_OK};
    check_io(path, strerror(ENOENT));
    CHECK(mkdir(path, 0700) == 0, "%s", path);
    check_io(path, "directory");
    CHECK(rmdir(path) == 0, "%s", path);
    CHECK(mkfifo(path, 0600) == 0, "%s", path);
    CHECK(taut_model_read(path, &model, &error) == TAUT_IO && model == NULL &&
              strstr(error.message, strerror(ESPIPE)) != NULL,
          "\"%s\"", error.message);
}

/* Files that open and then give nothing: memory that is not there, standard input that is closed.
 */
static void test_unreadable(void)
{
    const int kept = dup(STDIN_FILENO);
    if (access("/proc/self/mem", R_OK) == 0) {
        check_io("/proc/self/mem", strerror(EIO));
    }
    close(STDIN_FILENO);
    taut_problem *problem = NULL;
    taut_error error = {.status = TAUT_OK};
    CHECK(taut_problem_read("-", &problem, &error) == TAUT_IO && problem == NULL, "no input");
    CHECK(strcmp(error.reason, "read") == 0 && strstr(error.message, "Bad file descriptor") != NULL,
          "\"%s\"", error.message);
    if (kept >= 0) {
        dup2(kept, STDIN_FILENO);
        close(kept);
    }
}

/* A pipe has no size to be known beforehand. */
static void test_pipe(void)
{
    char command[64];
    int ends[2];
    taut_problem *problem = NULL;
    taut_error error = {.status = TAUT_OK};
    CHECK(pipe(ends) == 0, "pipe");
    CHECK(write(ends[1], text, sizeof text - 1) == (ssize_t)sizeof text - 1, "write");
    close(ends[1]);
    snprintf(command, sizeof command, "/dev/fd/%d", ends[0]);
    CHECK(taut_problem_read(command, &problem, &error) == TAUT_OK, "%s %s", error.where,
          error.message);
    taut_problem_free(problem);
    close(ends[0]);
}

/* What taut_problem_text gives of a problem, against what was read. */
static void check_text(const taut_problem *problem, const char *expected, const char *what)
{
    size_t length = 0;
    const char *kept = taut_problem_text(problem, &length);
    CHECK(strcmp(kept, expected) == 0, "%s: %s", what, kept);
    CHECK(length == strlen(expected) && taut_problem_text(problem, NULL) == kept, "%s", what);
}

#define LEAST                                                                                      \
    "{\"taut\": 1, \"construct\": \"dirichlet\", \"u\": {\"type\": \"bezier\", \"degree\": 1}, "   \
    "\"v\": "                                                                                      \
    "{\"type\": \"bezier\", \"degree\": 1}, \"points\": [[[0,0,0], null], [null, null]]"

/* Byte for byte: of a text, a file, either way a file may be read, and of the items of a list alone. */
static void test_text(void)
{
    static const char list_text[] =
        " [ " LEAST ", \"name\": \"a, ]}\\\"[\"} ,\n" LEAST "}\t," LEAST ",\"unit\": \"m\"}]\n";
    const char *path = in_folder("kept.json");
    taut_problem *problem = NULL;
    taut_problem_list *list = NULL;
    taut_model *model = NULL;

    CHECK(taut_problem_read_text(text, sizeof text - 1, "text", &problem, NULL) == TAUT_OK, "text");
    check_text(problem, text, "text");
    taut_problem_free(problem);
    file_put_text(path, text);
    CHECK(taut_problem_read(path, &problem, NULL) == TAUT_OK, "file");
    check_text(problem, text, "file");
    taut_problem_free(problem);
    CHECK(taut_problem_or_model_read(path, &problem, &model, NULL) == TAUT_OK, "either");
    check_text(problem, text, "either");
    taut_problem_free(problem);

    file_put_text(path, list_text);
    for (int k = 0; k < 2; k++) {
        CHECK((k == 0 ? taut_problem_list_read(path, &list, NULL)
                      : taut_problem_list_read_text(list_text, sizeof list_text - 1, "list", &list,
                                                    NULL)) == TAUT_OK,
              "list");
        CHECK(taut_problem_list_count(list) == 3, "%d", taut_problem_list_count(list));
        check_text(taut_problem_list_at(list, 0), LEAST ", \"name\": \"a, ]}\\\"[\"}", "item 0");
        check_text(taut_problem_list_at(list, 1), LEAST "}", "item 1");
        check_text(taut_problem_list_at(list, 2), LEAST ",\"unit\": \"m\"}", "item 2");
        taut_problem_list_free(list);
    }
    CHECK(taut_problem_list_read_text(text, sizeof text - 1, "one", &list, NULL) == TAUT_OK, "one");
    check_text(taut_problem_list_at(list, 0), text, "a list that is one problem");
    taut_problem_list_free(list);
}

/* A value in the place of another, a member that was not there, and the text that comes of it. */
static void test_change(void)
{
    static const struct {
        const char *before, *pointer, *value, *after;
    } rows[] = {
        {LEAST "}", "/points/0/0/2", "-7e1",
         "{\"taut\": 1, \"construct\": \"dirichlet\", \"u\": {\"type\": \"bezier\", \"degree\": "
         "1}, "
         "\"v\": {\"type\": \"bezier\", \"degree\": 1}, \"points\": [[[0,0,-7e1], null], [null, "
         "null]]}"},
        {LEAST "}", "/points/1/1", " [1,2,3]",
         "{\"taut\": 1, \"construct\": \"dirichlet\", \"u\": {\"type\": \"bezier\", \"degree\": "
         "1}, "
         "\"v\": {\"type\": \"bezier\", \"degree\": 1}, \"points\": [[[0,0,0], null], [null,  "
         "[1,2,3]]]}"},
        {LEAST "}", "/name", "\"lid\"", LEAST ", \"name\": \"lid\"}"},
        {LEAST ", \"na\\u006de\": \"x\" }", "/name", "\"lid\"",
         LEAST ", \"na\\u006de\": \"lid\" }"},
        {LEAST "}", "", " " LEAST ", \"unit\": \"m\"}", " " LEAST ", \"unit\": \"m\"}"},
        {LEAST ",\"v\\u002f\": 1}", "/points", "0", NULL}, /* the document itself is refused */
    };
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        taut_problem *problem = NULL, *changed = NULL;
        if (taut_problem_read_text(rows[i].before, strlen(rows[i].before), "before", &problem,
                                   NULL) != TAUT_OK) {
            CHECK(rows[i].after == NULL, "row %zu", i);
            continue;
        }
        CHECK(taut_problem_change(problem, rows[i].pointer, rows[i].value, strlen(rows[i].value),
                                  &changed, NULL) == TAUT_OK,
              "row %zu", i);
        check_text(changed, rows[i].after, rows[i].pointer);
        check_text(problem, rows[i].before, "the first one stays");
        taut_problem_free(problem);
        taut_problem_free(changed);
    }
}

/* What leads nowhere, is no JSON, or makes a document that would not be read. */
static void test_change_refused(void)
{
    static const struct {
        const char *pointer, *value, *reason, *where;
    } rows[] = {
        {"/points/2", "1", "missing", "/points/2"},
        {"/points/00", "1", "missing", "/points/00"},
        {"/points/-", "1", "missing", "/points/-"},
        {"/points/", "1", "missing", "/points/"},
        {"/points/0/9999999999", "1", "missing", "/points/0/9999999999"},
        {"/points/0/1/0", "1", "missing", "/points/0/1/0"},
        {"/taut/0", "1", "missing", "/taut/0"},
        {"/gone/here", "1", "missing", "/gone/here"},
        {"points", "1", "missing", "points"},
        {"/points/0/0/0", "", "syntax", "value:1:1"},
        {"/points/0/0/0", "1, 2", "syntax", "value:1:2"},
        {"/points/0/0/0", "1], [2", "syntax", "value:1:2"},
        {"/points/0/0/0", "\"x\"", "value", "/points/0/0/0"},
        {"/u/degree", "0", "value", "/u/degree"},
        {"/u/degree", "2", "size", "/points"},
        {"/pionts", "1", "unknown-member", "/pionts"},
        {"/a~1b~0", "1", "unknown-member", "/a~1b~0"},
        {"/~1", "1", "unknown-member", "/~1"},
        {"/~0", "1", "unknown-member", "/~0"},
        {"/a\"b\\", "1", "unknown-member", "/a\"b\\"},
        {"/u/~", "1", "unknown-member", "/u/~0"},
    };
    taut_problem *problem = NULL, *changed = NULL;
    taut_error error;
    CHECK(taut_problem_read_text(LEAST "}", strlen(LEAST "}"), "least", &problem, NULL) == TAUT_OK,
          "least");
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        CHECK(taut_problem_change(problem, rows[i].pointer, rows[i].value, strlen(rows[i].value),
                                  &changed, &error) == TAUT_BAD_INPUT,
              "%s", rows[i].pointer);
        CHECK(strcmp(error.reason, rows[i].reason) == 0 && strcmp(error.where, rows[i].where) == 0,
              "%s = %s: %s at %s: %s", rows[i].pointer, rows[i].value, error.reason, error.where,
              error.message);
        CHECK(changed == NULL, "nothing is made");
    }
    CHECK(taut_problem_change(NULL, "", "1", 1, &changed, NULL) == TAUT_BAD_ARGUMENT, "NULL");
    CHECK(taut_problem_change(problem, NULL, "1", 1, &changed, NULL) == TAUT_BAD_ARGUMENT, "NULL");
    CHECK(taut_problem_change(problem, "", NULL, 0, &changed, NULL) == TAUT_BAD_ARGUMENT, "NULL");
    CHECK(taut_problem_change(problem, "", "1", 1, NULL, NULL) == TAUT_BAD_ARGUMENT, "NULL");
    taut_problem_free(problem);
}

int main(void)
{
    folder_make();
    test_text();
    test_change();
    test_change_refused();
    test_members();
    test_defaults();
    test_rows();
    test_allowed();
    test_files();
    test_no_file();
    test_unreadable();
    test_pipe();
    folder_remove();
    return check_failures != 0;
}
