/* test_boundary_files.c -- problems whose boundary is a file of four curves: which file, how large
 * a net it may give, and two curves of unlike degrees as the rows of one net. */
#include "check.h"

#include "core/fail.h"
#include "problem/problem.h"
#include "taut/harmonic.h"
#include "taut/limits.h"
#include "taut/read.h"

#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static char folder[] = "/tmp/taut-test-XXXXXX";

/* A square with its side v0 a parabola: v0 and v1 are of degrees 2 and 1. */
static const char frame[] =
    "{\"taut\": 1, \"curves\": ["
    "{\"t\": {\"type\": \"bezier\", \"degree\": 2}, \"points\": [[0,0,0],[1,0,3],[2,0,0]]}, "
    "{\"t\": {\"type\": \"bezier\", \"degree\": 1}, \"points\": [[2,0,0],[2,2,0]]}, "
    "{\"t\": {\"type\": \"bezier\", \"degree\": 1}, \"points\": [[2,2,0],[0,2,1]]}, "
    "{\"t\": {\"type\": \"bezier\", \"degree\": 1}, \"points\": [[0,2,1],[0,0,0]]}]}";

static const char *in_folder(const char *name)
{
    static char path[96];
    snprintf(path, sizeof path, "%s/%s", folder, name);
    return path;
}

static void put_text(const char *name, const char *text)
{
    FILE *file = fopen(in_folder(name), "w");
    CHECK(file != NULL && fputs(text, file) >= 0 && fclose(file) == 0, "%s", name);
}

static taut_problem *read_problem(const char *text, taut_error *error)
{
    taut_problem *problem = NULL;
    put_text("problem.json", text);
    const taut_status status = taut_problem_read(in_folder("problem.json"), &problem, error);
    CHECK((status == TAUT_OK) == (problem != NULL), "%s: %s", error->where, error->message);
    return problem;
}

/* v1, a line, takes its middle for a third point; the row between is not known. */
static void test_rows(void)
{
    static const double v0[3][3] = {{0, 0, 0}, {1, 0, 3}, {2, 0, 0}};
    static const double v1[3][3] = {{0, 2, 1}, {1, 2, 0.5}, {2, 2, 0}};
    taut_error error = {.status = TAUT_OK};
    taut_problem *problem =
        read_problem("{\"taut\": 1, \"construct\": \"harmonic\", \"boundary\": \"frame.json\", "
                     "\"known\": \"v\", \"widths\": [1, 2]}",
                     &error);
    CHECK(problem != NULL, "%s: %s", error.where, error.message);
    if (problem == NULL) {
        return;
    }
    const taut_harmonic_problem *data = problem->data;
    CHECK(taut_basis_count(data->u) == 3 && taut_basis_count(data->v) == 3, "degree 2 both ways");
    CHECK(taut_basis_hi(data->u) == 1 && taut_basis_hi(data->v) == 2, "widths");
    for (int i = 0; i < 3; i++) {
        const double *row = data->rows.points + 9 * (size_t)i;
        CHECK(memcmp(row, v0[i], sizeof v0[i]) == 0, "v0, point %d", i);
        CHECK(memcmp(row + 6, v1[i], sizeof v1[i]) == 0, "v1, point %d: %g %g %g", i, row[6],
              row[7], row[8]);
        CHECK(data->rows.known[3 * i] && !data->rows.known[3 * i + 1] &&
                  data->rows.known[3 * i + 2],
              "row %d", i);
    }
    taut_problem_free(problem);
}

static void check_refused(const char *text, double found, double limit, const char *message)
{
    taut_error error = {.status = TAUT_OK};
    taut_problem *problem = read_problem(text, &error);
    CHECK(problem == NULL && error.status == TAUT_BAD_INPUT, "%.80s is taken", text);
    CHECK(strcmp(error.where, "/boundary") == 0 && strstr(error.message, message) != NULL, "%s: %s",
          error.where, error.message);
    CHECK(isnan(found) ? isnan(error.found) : error.found == found && error.limit == limit,
          "%g, %g", error.found, error.limit);
    taut_problem_free(problem);
}

static void test_refused(void)
{
    char long_name[5100];
    size_t n = (size_t)sprintf(long_name, "{\"taut\": 1, \"construct\": \"plateau\", "
                                          "\"boundary\": \"");
    memset(long_name + n, 'x', 5000);
    memcpy(long_name + n + 5000, "\"}", 3);
    check_refused("{\"taut\": 1, \"construct\": \"dirichlet\", \"boundary\": \"\"}", taut_none, 0,
                  "found \"\", expected the name of a file");
    check_refused("{\"taut\": 1, \"construct\": \"dirichlet\", \"boundary\": \"-\"}", taut_none, 0,
                  "found \"-\", expected the name of a file");
    check_refused(long_name, taut_none, 0, "expected a shorter name");
    check_refused("{\"taut\": 1, \"construct\": \"dirichlet\", \"boundary\": \"frame.json\", "
                  "\"refine\": [13, 13]}",
                  8194.0 * 8193, TAUT_POINTS_MAX, "a net of 8194 x 8193 points, expected at most");
}

int main(void)
{
    char command[96];
    if (mkdtemp(folder) == NULL) {
        return 1;
    }
    put_text("frame.json", frame);
    test_rows();
    test_refused();
    snprintf(command, sizeof command, "rm -r %s", folder);
    return system(command) != 0 || check_failures != 0;
}
