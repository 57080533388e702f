/* test_front.c -- fronts against elimination by the book in long double: L, D, what is left, inertia, for every width of tiles. */
#include "check.h"

#include "core/memory.h"
#include "numeric/front.h"

#include <math.h>
#include <string.h>

enum { ROWS = 150 };

static long double a[ROWS][ROWS];

/* Symmetric with a diagonal that outweighs its row, of signs at random where `signs`. */
static void fill(size_t rows, int signs, double *front)
{
    const size_t stride = taut_front_stride(rows);

    taut_front_clear(rows, front);
    for (size_t i = 0; i < rows; i++) {
        for (size_t j = 0; j <= i; j++) {
            const double sign = signs && random_int(0, 1) ? -1 : 1;
            const double x = i == j ? sign * (double)rows * random_in(1, 2) : random_in(-1, 1);
            front[i * stride + j] = x;
            a[i][j] = a[j][i] = x;
        }
    }
}

/* Column by column: how many pivots are below 0. */
static int eliminate(size_t rows, size_t own)
{
    int negative = 0;

    for (size_t k = 0; k < own; k++) {
        negative += a[k][k] < 0;
        for (size_t i = k + 1; i < rows; i++) {
            const long double l = a[i][k] / a[k][k];
            for (size_t j = k + 1; j <= i; j++) {
                a[i][j] -= l * a[j][k];
            }
        }
        for (size_t i = k + 1; i < rows; i++) {
            a[i][k] /= a[k][k];
        }
    }
    return negative;
}

static void test_by_the_book(void)
{
    double largest = 0;

    for (int trial = 0; trial < 60; trial++) {
        const size_t rows = (size_t)random_int(1, ROWS), own = (size_t)random_int(0, (int)rows);
        const size_t stride = taut_front_stride(rows);
        double *front = taut_alloc_aligned(taut_front_size(rows), sizeof(double));
        double *scratch = taut_alloc_aligned(taut_front_scratch(rows), sizeof(double));
        CHECK(front != NULL && scratch != NULL, "memory");
        fill(rows, trial % 2, front);
        const int negative = taut_front_factor(rows, own, front, scratch, NULL);
        CHECK(negative == eliminate(rows, own), "inertia of %zu of %zu rows", own, rows);
        for (size_t i = 0; i < rows; i++) {
            for (size_t j = 0; j <= i; j++) {
                const double scale = i >= own && j >= own ? (double)rows
                                     : i == j             ? (double)rows
                                                          : 1;
                largest = fmax(largest, fabs((double)(front[i * stride + j] - a[i][j])) / scale);
            }
        }
        taut_free(front);
        taut_free(scratch);
    }
    CHECK(largest < 5e-15, "the largest difference is %.3g", largest);
}

/* A pivot that is nothing beside what it began as counts as negative, and makes no NaN. */
static void test_no_pivot(void)
{
    enum { FEW = 3 };
    double *front = taut_alloc_aligned(taut_front_size(FEW), sizeof(double));
    double *scratch = taut_alloc_aligned(taut_front_scratch(FEW), sizeof(double));
    const size_t stride = taut_front_stride(FEW);

    CHECK(front != NULL && scratch != NULL, "memory");
    taut_front_clear(FEW, front);
    front[0] = front[stride] = front[stride + 1] = 1; /* ones: of rank 1 */
    front[2 * stride] = front[2 * stride + 1] = front[2 * stride + 2] = 1;
    CHECK(taut_front_factor(FEW, FEW, front, scratch, NULL) == 2, "two pivots are none");
    for (size_t i = 0; i < FEW; i++) {
        for (size_t j = 0; j <= i; j++) {
            CHECK(isfinite(front[i * stride + j]), "entry %zu, %zu", i, j);
        }
    }
    taut_free(front);
    taut_free(scratch);
}

int main(void)
{
    test_by_the_book();
    test_no_pivot();
    return check_failures != 0;
}
