/* Exact eigenvectors are M-orthogonal; computed ones are so up to the rounding error of K x -
 * lambda M x over the distance of their values ([Parlett1998] 11.7.1). Pairs nearer than that
 * allows are orthogonalised by Gram-Schmidt: x_j loses its parts along the earlier vectors of its
 * neighbourhood. */
#include "numeric/eigen/internal.h"

#include "core/memory.h"

#include <math.h>
#include <string.h>

/* Largest loss of orthogonality left to itself, as bounded by the worst case; rounding errors have
 * random signs, so what is seen is smaller by about sqrt(n). */
static const double tolerated = 0x1p-46;

static const double unit_roundoff = 0x1p-53;

taut_status taut_diagonals_init(const taut_pencil *pencil, taut_diagonals *out)
{
    const size_t n = (size_t)pencil->m.n, slots = (size_t)pencil->m.width + 1;
    double *a = taut_alloc(n * slots, sizeof *a);
    *out = (taut_diagonals){pencil->kernel, n, slots - 1, a};
    for (size_t i = 0; a != NULL && i < n * slots; i++) {
        a[i % slots * n + i / slots] = pencil->m.a[i];
    }
    return a == NULL ? TAUT_NO_MEMORY : TAUT_OK;
}

double taut_eigen_purge(const taut_diagonals *m, const taut_eigenpairs *pairs, int first, int j,
                        double *x, double *mx)
{
    const taut_kernel *kernel = m->kernel;
    kernel->diagonals_multiply(m->n, m->width, m->a, x, mx);
    const double before = sqrt(kernel->dot(m->n, x, mx));
    int changed = 0;
    for (int i = first; i < j; i++) {
        const double *xi = taut_eigen_vector(pairs, i);
        const double part = kernel->dot(m->n, xi, mx);
        if (fabs(part) > 4.0 * unit_roundoff * before) {
            changed = 1;
            kernel->add_scaled(m->n, -part, xi, x);
        }
    }
    double after = before;
    if (changed) {
        kernel->diagonals_multiply(m->n, m->width, m->a, x, mx);
        after = sqrt(kernel->dot(m->n, x, mx));
    }
    for (size_t i = 0; i < m->n; i++) {
        x[i] /= after;
    }
    return after / before;
}

/* The first vector that x_j has to be orthogonalised against; j when none. */
static int neighbourhood(const taut_eigenpairs *pairs, int j)
{
    int first = j;
    const double noise = unit_roundoff * pairs->noise[j];
    while (first > 0 && pairs->values[j] - pairs->values[first - 1] <=
                            (noise + unit_roundoff * pairs->noise[first - 1]) / tolerated) {
        first--;
    }
    return first;
}

taut_status taut_eigen_orthogonalise(const taut_pencil *pencil, taut_eigenpairs *pairs)
{
    taut_diagonals m = {NULL, 0, 0, NULL};
    double *mx = taut_alloc((size_t)pairs->n, sizeof *mx);
    taut_status status = taut_diagonals_init(pencil, &m);
    if (mx == NULL) {
        status = TAUT_NO_MEMORY;
    }
    for (int j = 1; j < pairs->n && status == TAUT_OK; j++) {
        const int first = neighbourhood(pairs, j);
        if (first == j) {
            continue;
        }
        double left = taut_eigen_purge(&m, pairs, first, j, taut_eigen_vector(pairs, j), mx);
        if (!(left > 0.5)) {
            status = taut_eigen_mend(pencil, &m, first, j, pairs);
        } else if (left < 1.0 - 0x1p-20) {
            taut_eigen_purge(&m, pairs, first, j, taut_eigen_vector(pairs, j), mx);
        }
    }
    taut_free(m.a);
    taut_free(mx);
    return status;
}
