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
    check_io(in_folder("none.json"), "No such file");
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
    check_io(path, "No such file");
    CHECK(mkdir(path, 0700) == 0, "%s", path);
    check_io(path, "directory");
    CHECK(rmdir(path) == 0, "%s", path);
    CHECK(mkfifo(path, 0600) == 0, "%s", path);
    CHECK(taut_model_read(path, &model, &error) == TAUT_IO && model == NULL &&
              strstr(error.message, "Illegal seek") != NULL,
          "\"%s\"", error.message);
}

/* Files that open and then give nothing: memory that is not there, standard input that is closed.
 */
static void test_unreadable(void)
{
    const int kept = dup(STDIN_FILENO);
    if (access("/proc/self/mem", R_OK) == 0) {
        check_io("/proc/self/mem", "nput/output error");
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

int main(void)
{
    folder_make();
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
