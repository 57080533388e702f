/* test_sparse.c -- fronts against dense meaning: products, inertia, nodes of all sizes. */
#include "check.h"

#include "numeric/sparse.h"

#include <string.h>

enum { NODES = 14, ROWS = 3 * NODES, TRIALS = 200 };

typedef struct matrix {
    const taut_sparse *sparse;
    unsigned char sizes[NODES];
    double a[ROWS][ROWS];
} matrix;

static void block(const void *context, int a, int b, double *entries)
{
    const matrix *m = context;
    for (int i = 0; i < m->sizes[a]; i++) {
        for (int j = 0; j < m->sizes[b]; j++) {
            entries[i * m->sizes[b] + j] =
                m->a[taut_sparse_row(m->sparse, a) + i][taut_sparse_row(m->sparse, b) + j];
        }
    }
}

/* Cliques of three to five nodes at random, and one of all that are in none. */
static int make_cliques(int *first, int *members)
{
    unsigned char seen[NODES] = {0};
    int n = 0, count = 0;

    for (; count < 8; count++) {
        const int start = random_int(0, NODES - 1), size = random_int(3, 5);
        first[count] = n;
        for (int k = 0; k < size; k++) {
            members[n++] = (start + 2 * k) % NODES;
            seen[(start + 2 * k) % NODES] = 1;
        }
    }
    first[count++] = n;
    for (int a = 0; a < NODES; a++) {
        if (!seen[a]) {
            members[n++] = a;
        }
    }
    first[count] = n;
    return count;
}

/* Symmetric, with `lift` on the diagonal, zero where no clique has both nodes. */
static void fill(matrix *m, int cliques, const int *first, const int *members, double lift)
{
    memset(m->a, 0, sizeof m->a);
    for (int k = 0; k < cliques; k++) {
        for (int p = first[k]; p < first[k + 1]; p++) {
            for (int q = first[k]; q <= p; q++) {
                const int a = members[p], b = members[q];
                for (int i = 0; i < m->sizes[a]; i++) {
                    for (int j = 0; j < m->sizes[b]; j++) {
                        const int r = taut_sparse_row(m->sparse, a) + i,
                                  c = taut_sparse_row(m->sparse, b) + j;
                        m->a[r][c] = m->a[c][r] = random_in(-1, 1) + (r == c ? lift : 0);
                    }
                }
            }
        }
    }
}

/* How many negative pivots the dense matrix has: the same inertia, by its own elimination. */
static int dense_negative(const matrix *m, int rows)
{
    double a[ROWS][ROWS];
    int negative = 0;

    memcpy(a, m->a, sizeof a);
    for (int k = 0; k < rows; k++) {
        negative += a[k][k] < 0;
        for (int i = k + 1; i < rows; i++) {
            for (int j = k + 1; j < rows; j++) {
                a[i][j] -= a[i][k] * a[k][j] / a[k][k];
            }
        }
    }
    return negative;
}

static void test_random(double lift, double error)
{
    for (int trial = 0; trial < TRIALS; trial++) {
        static matrix m;
        int first[16], members[64], negative = -1;
        taut_sparse *sparse = NULL;
        double x[ROWS], y[ROWS];

        for (int a = 0; a < NODES; a++) {
            m.sizes[a] = (unsigned char)random_int(0, 3);
        }
        const int cliques = make_cliques(first, members);
        CHECK(taut_sparse_new(NODES, m.sizes, cliques, first, members, &sparse) == TAUT_OK, "%d",
              trial);
        m.sparse = sparse;
        const int rows = taut_sparse_rows(sparse);
        fill(&m, cliques, first, members, lift);
        CHECK(taut_sparse_factor(sparse, block, &m, NULL, &negative) == TAUT_OK, "%d", trial);
        CHECK(negative == dense_negative(&m, rows), "trial %d: %d", trial, negative);
        for (int i = 0; i < rows; i++) {
            x[i] = random_in(-1, 1);
        }
        for (int i = 0; i < rows; i++) {
            y[i] = 0;
            for (int j = 0; j < rows; j++) {
                y[i] += m.a[i][j] * x[j];
            }
        }
        taut_sparse_solve(sparse, y);
        for (int i = 0; lift > 10 && i < rows; i++) {
            CHECK_NEAR(y[i], x[i], error, "trial %d, row %d", trial, i);
        }
        taut_sparse_free(sparse);
    }
}

int main(void)
{
    test_random(30,
                1e-13); /* at most 24 entries of a row beside the diagonal: condition below 10 */
    test_random(-30, 1e-13);
    test_random(0, 0); /* indefinite: inertia alone */
    return check_failures != 0;
}
