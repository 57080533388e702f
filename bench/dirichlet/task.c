#include "task.h"

#include "geometry/nurbs/gram.h"
#include "numeric/tensor/apply.h"
#include "taut/taut.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { DEGREE = 3 };

static void fail(const char *what)
{
    fprintf(stderr, "bench: %s\n", what);
    exit(6);
}

void bench_frame_point(int m, int i, int j, double point[3])
{
    const double u = i / (m - 1.0), v = j / (m - 1.0);
    point[0] = u;
    point[1] = v;
    point[2] = 0.3 * sin(9.0 * u + 1.0) * cos(7.0 * v) + u * v;
}

double *bench_numbers(size_t count)
{
    double *x = malloc(count * sizeof *x);
    if (x == NULL) {
        fail("no memory");
    }
    return memset(x, 0, count * sizeof *x);
}

static size_t entries(int n)
{
    return 3 * (size_t)n * (size_t)n;
}

/* R = - A B, B the boundary points alone, a wavy frame over the unit square. */
static double *make_right(const taut_gram *gram, int n)
{
    const int m = n + 2;
    const taut_tensor tensor = {
        &gram->stiffness, &gram->mass, &gram->stiffness, &gram->mass, 1.0, 1.0, NULL};
    double *boundary = bench_numbers(entries(m)), *image = bench_numbers(entries(m)),
           *right = bench_numbers(entries(n));
    for (int i = 0; i < m; i++) {
        for (int j = 0; j < m; j++) {
            if (i == 0 || j == 0 || i == m - 1 || j == m - 1) {
                bench_frame_point(m, i, j, boundary + 3 * ((size_t)i * (size_t)m + (size_t)j));
            }
        }
    }
    if (taut_tensor_apply(&tensor, 3, boundary, image) != TAUT_OK) {
        fail("no memory");
    }
    for (size_t i = 0; i < (size_t)n; i++) {
        for (size_t j = 0; j < 3 * (size_t)n; j++) {
            right[i * 3 * (size_t)n + j] = -image[(i + 1) * 3 * (size_t)m + 3 + j];
        }
    }
    free(boundary);
    free(image);
    return right;
}

peer_task bench_task_new(int n)
{
    const int count = n + 2, last = count - DEGREE;
    double *knots = bench_numbers((size_t)count + DEGREE + 1);
    int *index = malloc((size_t)n * sizeof *index);
    for (int i = 0; i <= count + DEGREE; i++) {
        knots[i] = i <= DEGREE ? 0.0 : i >= count ? 1.0 : (i - DEGREE) / (double)last;
    }
    for (int i = 0; i < n && index != NULL; i++) {
        index[i] = i + 1;
    }
    const taut_basis_spec spec = {
        .type = "bspline", .degree = DEGREE, .knots = knots, .knot_count = count + DEGREE + 1};
    taut_basis *basis = NULL;
    taut_gram gram, inner;
    if (index == NULL || taut_basis_new(&spec, count, &basis, NULL) != TAUT_OK ||
        taut_gram_new(basis, NULL, &gram, NULL) != TAUT_OK ||
        taut_gram_select(&gram, n, index, &inner) != TAUT_OK) {
        fail("no Gram matrices");
    }
    const peer_task task = {n, inner.stiffness, inner.mass, make_right(&gram, n)};
    taut_gram_clear(&gram);
    taut_basis_free(basis);
    free(index);
    free(knots);
    return task;
}

void bench_task_free(peer_task *task)
{
    taut_band_clear(&task->k);
    taut_band_clear(&task->m);
    free((void *)(size_t)task->right);
}
