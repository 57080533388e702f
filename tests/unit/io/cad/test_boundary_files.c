/* test_boundary_files.c -- problems whose boundary is a file of four curves: which file, how large
 * a net it may give, and two curves of unlike degrees as the rows of one net. */
#include "check.h"
#include "folder.h"

#include "core/fail.h"
#include "problem/problem.h"
#include "taut/harmonic.h"
#include "taut/limits.h"
#include "taut/read.h"

#include <string.h>
#include <unistd.h>

/* A square with its side v0 a parabola: v0 and v1 are of degrees 2 and 1. */
static const char frame[] =
    "{\"taut\": 1, \"curves\": ["
    "{\"t\": {\"type\": \"bezier\", \"degree\": 2}, \"points\": [[0,0,0],[1,0,3],[2,0,0]]}, "
    "{\"t\": {\"type\": \"bezier\", \"degree\": 1}, \"points\": [[2,0,0],[2,2,0]]}, "
    "{\"t\": {\"type\": \"bezier\", \"degree\": 1}, \"points\": [[2,2,0],[0,2,1]]}, "
    "{\"t\": {\"type\": \"bezier\", \"degree\": 1}, \"points\": [[0,2,1],[0,0,0]]}]}";

static taut_problem *read_problem(const char *text, taut_error *error)
{
    taut_problem *problem = NULL;
    file_put_text(in_folder("problem.json"), text);
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

static void check_refused(const char *text, double found, double limit, const char *reason)
{
    taut_error error = {.status = TAUT_OK};
    taut_problem *problem = read_problem(text, &error);
    CHECK(problem == NULL && error.status == TAUT_BAD_INPUT, "%.80s is taken", text);
    CHECK(strcmp(error.where, "/boundary") == 0 && strcmp(error.reason, reason) == 0, "%s: %s, %s",
          error.where, error.reason, error.message);
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
                  "value");
    check_refused("{\"taut\": 1, \"construct\": \"dirichlet\", \"boundary\": \"-\"}", taut_none, 0,
                  "value");
    check_refused(long_name, taut_none, 0, "value");
    check_refused("{\"taut\": 1, \"construct\": \"dirichlet\", \"boundary\": \"frame.json\", "
                  "\"refine\": [13, 13]}",
                  8194.0 * 8193, TAUT_POINTS_MAX, "size");
}

int main(void)
{
    folder_make();
    file_put_text(in_folder("frame.json"), frame);
    test_rows();
    test_refused();
    folder_remove();
    return check_failures != 0;
}
