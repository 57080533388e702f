/* test_skyline.c -- the factor of a matrix kept by rows: solutions, what is not positive, and how often a monitor hears of it. */
#include "certify/pattern/skyline.h"
#include "check.h"
#include "monitors.h"

#include <math.h>

enum { N = 600 };

/* a_ik = 1 + min(i, k) in rows that begin at column `from` of i, less `off` on the last diagonal entry. */
static void fill(taut_skyline *matrix, double off)
{
    for (int i = 0; i < matrix->n; i++) {
        for (int k = matrix->first[i]; k <= i; k++) {
            matrix->rows[i][k - matrix->first[i]] = 1.0 + k;
        }
    }
    matrix->rows[matrix->n - 1][matrix->n - 1 - matrix->first[matrix->n - 1]] -= off;
}

/* All of the rows are kept: n^3/3 operations, of which every TAUT_PULSE_WORK are a report, and the factor is of ones. */
static void test_watched(void)
{
    static const int first[N] = {0};
    double operations = 0, x[N];
    taut_arena *arena = taut_arena_new();
    taut_skyline matrix;
    for (int i = 0; i < N; i++) {
        operations += (double)i * (i - 1);
    }
    CHECK(taut_skyline_new(arena, N, first, &matrix) == TAUT_OK, "memory");
    CHECK_NEAR(taut_skyline_room(&matrix), N * (N + 1) / 2.0, 0, "entries");
    int most = 0;
    for (int stop_at = 0; stop_at <= 2; stop_at += 2) {
        watch seen = {.stop_at = stop_at};
        const taut_monitor monitor = monitor_of(&seen);
        taut_pulse pulse = {.monitor = &monitor, .what = "factor", .done = NAN};
        fill(&matrix, 0);
        const int is_done = taut_skyline_factor(&matrix, &pulse);
        most = stop_at == 0 ? seen.reports : most;
        CHECK(is_done == (stop_at == 0), "stopped at %d: %d", stop_at, is_done);
        CHECK(stop_at == 0 || seen.reports == stop_at, "%d reports", seen.reports);
        if (is_done) {
            CHECK_NEAR(matrix.rows[N - 1][N / 2], 1, 1e-12, "the factor");
            for (int i = 0; i < N; i++) {
                x[i] = i == 0; /* a e_0 is all ones; the solution of e_0 is 2 e_0 - e_1 */
            }
            taut_skyline_solve(&matrix, x);
            CHECK_NEAR(x[0], 2, 1e-12, "first");
            CHECK_NEAR(x[1], -1, 1e-12, "second");
            CHECK_NEAR(x[N - 1], 0, 1e-12, "last");
        }
    }
    CHECK(most >= 0.8 * operations / TAUT_PULSE_WORK && most <= operations / TAUT_PULSE_WORK,
          "%d reports of %g operations", most, operations);
    taut_arena_free(arena);
}

/* Rows that begin where they like; the last pivot, 1, falls below 0. */
static void test_pivot(void)
{
    static const int first[] = {0, 1, 1, 2};
    for (int k = 0; k < 3; k++) {
        taut_arena *arena = taut_arena_new();
        taut_skyline matrix;
        CHECK(taut_skyline_new(arena, 4, first, &matrix) == TAUT_OK, "memory");
        /* 1; 2; 2 3; 3 4: pivots 1, 2, 1, 4 - 9 and what is added */
        fill(&matrix, -6 + 0.75 * k);
        CHECK(taut_skyline_factor(&matrix, NULL) == (k < 2), "last pivot %g", 1 - 0.75 * k);
        taut_arena_free(arena);
    }
}

int main(void)
{
    test_watched();
    test_pivot();
    return check_failures != 0;
}
