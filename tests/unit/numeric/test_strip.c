/* test_strip.c -- systems solved against products with the solution; what has no pivot is refused. */
#include "check.h"

#include "numeric/strip.h"

#include <string.h>

enum { N = 40, WIDTH = 5, ACROSS = 2 * WIDTH + 1, COLUMNS = 3 };

static void test_random(void)
{
    for (int trial = 0; trial < 50; trial++) {
        const int n = random_int(1, N), width = random_int(0, WIDTH), across = 2 * width + 1;
        double a[N * ACROSS] = {0}, x[N][COLUMNS], b[N][COLUMNS] = {{0}};
        for (int i = 0; i < n; i++) {
            for (int c = 0; c < COLUMNS; c++) {
                x[i][c] = random_in(-1, 1);
            }
        }
        for (int i = 0; i < n; i++) {
            for (int j = i > width ? i - width : 0; j < n && j <= i + width; j++) {
                const double value = i == j ? 2 + 2 * width : random_in(-1, 1);
                a[i * across + width + j - i] = value;
                for (int c = 0; c < COLUMNS; c++) {
                    b[i][c] += value * x[j][c];
                }
            }
        }
        CHECK(taut_strip_factor(n, width, a), "n %d width %d", n, width);
        taut_strip_solve(n, width, a, COLUMNS, COLUMNS, &b[0][0]);
        for (int i = 0; i < n; i++) {
            for (int c = 0; c < COLUMNS; c++) {
                CHECK_NEAR(b[i][c], x[i][c], 1e-14, "n %d width %d row %d", n, width, i);
            }
        }
    }
}

static void test_no_pivot(void)
{
    double equal_rows[2][3] = {{0, 1, 1}, {1, 1, 0}};
    double nothing[1] = {0};
    CHECK(!taut_strip_factor(2, 1, &equal_rows[0][0]), "two rows that are one");
    CHECK(!taut_strip_factor(1, 0, nothing), "nothing");
}

int main(void)
{
    test_random();
    test_no_pivot();
    return check_failures != 0;
}
