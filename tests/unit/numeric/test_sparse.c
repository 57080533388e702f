/* test_sparse.c -- fronts against dense meaning: products, inertia, nodes of all sizes. */
#include "check.h"

#include "monitors.h"
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

/* Twice the identity where a node meets itself, ones elsewhere, scaled: definite. */
static void plain_block(const void *context, int a, int b, double *entries)
{
    (void)context;
    for (int i = 0; i < 9; i++) {
        entries[i] = 1e-4 + (a == b && i % 4 == 0 ? 2 : 0);
    }
}

/* Two cliques of 2 n rows that have n in common: of one the others go first, then all of the second. Eliminating k of m rows takes
 * m^2 + ... + (m - k + 1)^2 multiplications and additions, about. It is told, and ended, on the way. */
static void test_told(void)
{
    enum { SHARE = 100, COUNT = 3 * SHARE };
    static int members[4 * SHARE];
    static unsigned char sizes[COUNT];
    const int first[] = {0, 2 * SHARE, 4 * SHARE};
    const double n = 3 * SHARE, operations = 7 * n * n * n / 3 + 8 * n * n * n / 3;
    int negative = 0;
    taut_sparse *sparse = NULL;
    watch all = {.stop_at = 0};
    taut_monitor monitor = monitor_of(&all);
    taut_pulse pulse = {.monitor = &monitor, .what = "factors"};

    for (int i = 0; i < 4 * SHARE; i++) {
        members[i] = i < 2 * SHARE ? i : i - SHARE;
    }
    memset(sizes, 3, sizeof sizes);
    CHECK(taut_sparse_new(COUNT, sizes, 2, first, members, &sparse) == TAUT_OK, "new");
    CHECK(taut_sparse_factor(sparse, plain_block, NULL, &pulse, &negative) == TAUT_OK &&
              negative == 0,
          "factors");
    CHECK(all.reports >= 0.9 * operations / TAUT_PULSE_WORK, "%d reports of %.3g operations",
          all.reports, operations);
    for (int k = 1; k <= all.reports; k++) {
        watch stop = {.stop_at = k};
        monitor = monitor_of(&stop);
        pulse = (taut_pulse){.monitor = &monitor, .what = "factors"};
        CHECK(taut_sparse_factor(sparse, plain_block, NULL, &pulse, &negative) ==
                      TAUT_INTERRUPTED &&
                  stop.reports == k,
              "stopped at %d of %d: went on to %d", k, all.reports, stop.reports);
    }
    CHECK(taut_sparse_factor(sparse, plain_block, NULL, NULL, &negative) == TAUT_OK, "again");
    taut_sparse_free(sparse);
}

int main(void)
{
    test_random(30,
                1e-13); /* at most 24 entries of a row beside the diagonal: condition below 10 */
    test_random(-30, 1e-13);
    test_random(0, 0); /* indefinite: inertia alone */
    test_told();
    return check_failures != 0;
}
