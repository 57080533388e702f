#include "basis/blossom.h"

#include "core/memory.h"

#include <assert.h>
#include <stddef.h>
#include <string.h>

/* A window of old knots, and the coefficients over it as rows of the old coefficients. */
struct taut_blossom {
    int degree;
    int knot_count;  /* in the window now */
    int row_count;   /* knot_count - degree - 1 */
    int columns;     /* old coefficients the window sees: at most 2 p + 1 */
    double *knots;   /* [4 p + 2] */
    double *rows;    /* [3 p + 1][2 p + 1] */
    double *storage; /* the two */
};

taut_blossom *taut_blossom_new(int degree)
{
    const size_t p = (size_t)degree;
    taut_blossom *made = taut_alloc_zero(1, sizeof *made);
    if (made == NULL) {
        return NULL;
    }
    made->degree = degree;
    made->storage = taut_alloc((4 * p + 2) + (3 * p + 1) * (2 * p + 1), sizeof(double));
    if (made->storage == NULL) {
        taut_free(made);
        return NULL;
    }
    made->knots = made->storage;
    made->rows = made->storage + (4 * p + 2);
    return made;
}

void taut_blossom_free(taut_blossom *blossom)
{
    if (blossom != NULL) {
        taut_free(blossom->storage);
        taut_free(blossom);
    }
}

static double *row_at(taut_blossom *b, int i)
{
    return b->rows + (size_t)i * (size_t)b->columns;
}

/* The last index with knots[i] <= x and knots[i] < knots[last]. */
static int interval_of(const double *knots, int degree, int count, double x)
{
    int low = degree;
    int high = count; /* knots[low] <= x, and knots[high] > x or it is the end */
    while (high - low > 1) {
        const int middle = low + (high - low) / 2;
        if (knots[middle] <= x) {
            low = middle;
        } else {
            high = middle;
        }
    }
    return low; /* at the upper end count - 1, because clamped knots rise there */
}

/* How often x is among the window's knots. */
static int multiplicity_of(const taut_blossom *b, double x)
{
    int times = 0;
    for (int i = 0; i < b->knot_count; i++) {
        times += b->knots[i] == x;
    }
    return times;
}

/* d'_i = a_i d_i + (1 - a_i) d_{i-1}, a_i = (x - t_i) / (t_{i+p} - t_i) for q-p < i <= q-s, where
 * t_q <= x < t_{q+1} and x has multiplicity s already. */
static void insert_knot(taut_blossom *b, double x)
{
    const int p = b->degree;
    const int s = multiplicity_of(b, x);
    const size_t bytes = (size_t)b->columns * sizeof(double);
    int q = b->knot_count - 1;

    while (b->knots[q] > x) {
        q--;
    }
    for (int i = b->row_count; i > q - s; i--) {
        memcpy(row_at(b, i), row_at(b, i - 1), bytes);
    }
    for (int i = q - s; i > q - p; i--) {
        const double a = (x - b->knots[i]) / (b->knots[i + p] - b->knots[i]);
        double *row = row_at(b, i);
        const double *before = row_at(b, i - 1);
        for (int c = 0; c < b->columns; c++) {
            row[c] = a * row[c] + (1 - a) * before[c];
        }
    }
    memmove(b->knots + q + 2, b->knots + q + 1, (size_t)(b->knot_count - q - 1) * sizeof(double));
    b->knots[q + 1] = x;
    b->knot_count++;
    b->row_count++;
}

/* The first i with knots i+1 .. i+p of the window equal to x. */
static int find_row(const taut_blossom *b, const double *x)
{
    int i = 0, same = 0;
    for (; same < b->degree && i < b->row_count; i++) {
        same = 0;
        while (same < b->degree && b->knots[i + 1 + same] == x[same]) {
            same++;
        }
    }
    assert(same == b->degree); /* the knots asked for are in a row */
    return i - 1;
}

/* The window over knots low - p .. high + p, nothing inserted. */
static void open_window(taut_blossom *b, const double *knots, int low, int high)
{
    const int p = b->degree;
    b->columns = b->row_count = high - low + p;
    b->knot_count = b->row_count + p + 1;
    assert(b->columns <= 2 * p + 1);
    memcpy(b->knots, knots + low - p, (size_t)b->knot_count * sizeof(double));
    memset(b->rows, 0, (size_t)b->columns * (size_t)b->columns * sizeof(double));
    for (int i = 0; i < b->columns; i++) {
        row_at(b, i)[i] = 1;
    }
}

void taut_blossom_row(taut_blossom *b, const double *knots, int count, const double *x, int *first,
                      double *row)
{
    const int p = b->degree;
    const int low = interval_of(knots, p, count, x[0]);
    int high = low + 1;
    int start = 0;

    while (knots[high] < x[p - 1]) {
        high++;
    }
    open_window(b, knots, low, high);
    for (int i = 0, run = 0; i < p; i++) {
        run = i > 0 && x[i] == x[i - 1] ? run + 1 : 1;
        if (multiplicity_of(b, x[i]) < run) {
            insert_knot(b, x[i]);
        }
    }
    const double *found = row_at(b, find_row(b, x));
    while (start < b->columns - p - 1 && found[start] == 0) {
        start++;
    }
    memcpy(row, found + start, (size_t)(p + 1) * sizeof(double));
    *first = low - p + start;
}

void taut_blossom_piece(taut_blossom *b, const double *knots, int low, double *rows)
{
    const int p = b->degree;
    const double ends[2] = {knots[low], knots[low + 1]};
    int first = 0;

    open_window(b, knots, low, low + 1);
    for (int e = 0; e < 2; e++) {
        while (multiplicity_of(b, ends[e]) < p) {
            insert_knot(b, ends[e]);
        }
    }
    while (b->knots[first + p] != ends[0] || b->knots[first + p + 1] == ends[0]) {
        first++; /* until p times the lower end are the knots of row `first` */
    }
    memcpy(rows, row_at(b, first), (size_t)(p + 1) * (size_t)(p + 1) * sizeof(double));
}
