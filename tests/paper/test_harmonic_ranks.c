/* test_harmonic_ranks.c -- the tables of [NiWang2015]: dimensions (section 2.3), amplification
 * (section 7) and free parameters (section 8.4), by exact rank and exact solution of relation (2),
 * which shares nothing with the closed forms and bases of the constructions. links: flint gmp
 */
#include "check.h"

#include "construct/harmonic/complete.h"
#include "construct/harmonic/rim.h"

#include <flint/fmpq_mat.h>
#include <flint/fmpz_mat.h>

/* The coefficient of point i + shift in line i of the second derivative, degree n (section 2.2). */
static long factor(int n, int i, int shift)
{
    const long a0 = (long)(n - i) * (n - i - 1), a1 = 2L * i * (n - i), a2 = (long)i * (i - 1);
    const long f[5] = {a2, a1 - 2 * a2, a0 - 2 * a1 + a2, a1 - 2 * a0, a0};
    return f[shift + 2];
}

/* Relation (2) as a matrix, one row a control point of wu P_uu + wv P_vv. */
static void laplacian(int n, int m, long wu, long wv, fmpz_mat_t matrix)
{
    fmpz_mat_init(matrix, (n + 1) * (m + 1), (n + 1) * (m + 1));
    for (int i = 0; i <= n; i++) {
        for (int j = 0; j <= m; j++) {
            for (int s = -2; s <= 2; s++) {
                const int line = i * (m + 1) + j;
                if (i + s >= 0 && i + s <= n) {
                    fmpz *at = fmpz_mat_entry(matrix, line, (i + s) * (m + 1) + j);
                    fmpz_set_si(at, fmpz_get_si(at) + wu * factor(n, i, s));
                }
                if (j + s >= 0 && j + s <= m) {
                    fmpz *at = fmpz_mat_entry(matrix, line, i * (m + 1) + j + s);
                    fmpz_set_si(at, fmpz_get_si(at) + wv * factor(m, j, s));
                }
            }
        }
    }
}

/* The rank with rows appended that hold the points where `held` says so. */
static long rank_with(const fmpz_mat_t relation, int count, const unsigned char *held)
{
    fmpz_mat_t all;
    long rank = 0;
    int rows = count;
    fmpz_mat_init(all, 2 * count, count);
    for (int r = 0; r < count; r++) {
        for (int c = 0; c < count; c++) {
            fmpz_set(fmpz_mat_entry(all, r, c), fmpz_mat_entry(relation, r, c));
        }
    }
    for (int c = 0; c < count; c++) {
        if (held[c]) {
            fmpz_one(fmpz_mat_entry(all, rows++, c));
        }
    }
    rank = fmpz_mat_rank(all);
    fmpz_mat_clear(all);
    return rank;
}

/* Section 2.3, and that the space of the construction has as many functions. */
static void test_dimensions(void)
{
    unsigned char none[64] = {0};
    for (int n = 1; n <= 7; n++) {
        for (int m = 1; m <= 7; m++) {
            const long wanted =
                n == m ? (n % 2 != 0 ? 2 * n + 2 : 2 * n + 1) : 2 * (n < m ? n : m) + 2;
            const int count = (n + 1) * (m + 1);
            taut_arena *arena = taut_arena_new();
            taut_space space;
            fmpz_mat_t relation;
            laplacian(n, m, 4, 9, relation);
            CHECK(count - rank_with(relation, count, none) == wanted, "n=%d m=%d", n, m);
            CHECK(taut_space_harmonic(n, m, 3, 2, arena, NULL, &space) && space.count == wanted,
                  "n=%d m=%d: %d functions, %ld wanted", n, m, space.count, wanted);
            fmpz_mat_clear(relation);
            taut_arena_free(arena);
        }
    }
}

/* Section 8.4: the table as printed there, and the formulas for it. Held are rows 0..r. */
static void test_free_parameters(void)
{
    static const int table[7][5] = {{2, 5, 2, 0, 0},  {3, 8, 4, 2, 0},   {4, 11, 6, 2, 0},
                                    {5, 14, 8, 4, 0}, {6, 17, 10, 4, 0}, {7, 20, 12, 6, 0},
                                    {8, 23, 14, 6, 0}};
    for (int t = 0; t < 7; t++) {
        const int n = table[t][0], count = (n + 1) * (n + 1);
        unsigned char held[81] = {0};
        fmpz_mat_t once, relation;
        taut_arena *arena = taut_arena_new();
        taut_space space;
        laplacian(n, n, 1, 1, once);
        fmpz_mat_init(relation, count, count);
        fmpz_mat_mul(relation, once, once);
        CHECK(count - rank_with(relation, count, held) == 4 * n, "n=%d: kernel", n);
        CHECK(taut_space_biharmonic(n, 1, 1, arena, NULL, &space) && space.count == 4 * n, "n=%d",
              n);
        for (int i = 0; i <= n; i++) {
            for (int j = 0; j <= n; j++) {
                held[i * (n + 1) + j] = i == 0 || j == 0 || i == n || j == n;
            }
        }
        CHECK(rank_with(relation, count, held) == count, "n=%d: four rows determine it", n);
        for (int k = 0; k < count; k++) {
            held[k] = 0;
        }
        for (int r = 0; r < 4; r++) {
            const int formula[4] = {3 * n - 1, 2 * (n - 1), 2 * ((n - 1) / 2), 0};
            for (int j = 0; j <= n && r <= n; j++) {
                held[r * (n + 1) + j] = 1;
            }
            const long found = count - rank_with(relation, count, held);
            CHECK(found == table[t][r + 1] && found == formula[r], "n=%d C^%d: %ld", n, r, found);
        }
        fmpz_mat_clear(once);
        fmpz_mat_clear(relation);
        taut_arena_free(arena);
    }
}

/* The largest row sum of sizes of the exact map from held points to net: relation (2) and the held
 * points solved in rationals. The relation has weights wu = 1, wv = mu. */
static double growth(const fmpz_mat_t relation, int count, const int *held, int given)
{
    fmpz_mat_t left, square, right, x;
    fmpz_t denominator;
    double most = 0;

    fmpz_mat_init(left, count + given, count);
    fmpz_mat_init(square, count, count);
    fmpz_mat_init(right, count, given);
    fmpz_mat_init(x, count, given);
    fmpz_init(denominator);
    for (int r = 0; r < count; r++) {
        for (int c = 0; c < count; c++) {
            fmpz_set(fmpz_mat_entry(left, r, c), fmpz_mat_entry(relation, r, c));
        }
    }
    for (int k = 0; k < given; k++) {
        fmpz_one(fmpz_mat_entry(left, count + k, held[k]));
    }
    fmpz_mat_t turned; /* normal equations: left' left x = left' (0; e_k) */
    fmpz_mat_init(turned, count, count + given);
    fmpz_mat_transpose(turned, left);
    fmpz_mat_mul(square, turned, left);
    for (int k = 0; k < given; k++) {
        fmpz_one(fmpz_mat_entry(right, held[k], k));
    }
    CHECK(fmpz_mat_solve(x, denominator, square, right), "the rows determine the net");
    for (int r = 0; r < count; r++) {
        fmpz_t sum, size;
        fmpq_t ratio;
        fmpz_init(sum);
        fmpz_init(size);
        fmpq_init(ratio);
        for (int k = 0; k < given; k++) {
            fmpz_abs(size, fmpz_mat_entry(x, r, k));
            fmpz_add(sum, sum, size);
        }
        fmpz_abs(size, denominator);
        fmpq_set_fmpz_frac(ratio, sum, size);
        most = fmax(most, fmpq_get_d(ratio));
        fmpz_clear(sum);
        fmpz_clear(size);
        fmpq_clear(ratio);
    }
    fmpz_mat_clear(turned);
    fmpz_mat_clear(left);
    fmpz_mat_clear(square);
    fmpz_mat_clear(right);
    fmpz_mat_clear(x);
    fmpz_clear(denominator);
    return most;
}

/* Two rows, and a row with the next, of bidegree (n, n), n odd, or (m + 1, m), m even. Printed in
 * section 7: 5, 45, 745 and 11, 81, 491. */
static void test_amplification(void)
{
    static const double rows_printed[8] = {0, 0, 0, 5, 0, 45, 0, 745},
                        next_printed[8] = {0, 0, 0, 11, 0, 81, 0, 491};
    for (int m = 1; m <= 7; m++) {
        const int n = m % 2 != 0 ? m : m + 1, count = (n + 1) * (m + 1);
        int rows[16], next[16];
        taut_twice scratch[3 * 64];
        double sum[64];
        fmpz_mat_t relation;
        laplacian(n, m, 1, 1, relation);
        for (int j = 0; j <= m; j++) {
            rows[j] = next[j] = j;
            rows[m + 1 + j] = n * (m + 1) + j;
            next[m + 1 + j] = m + 1 + j;
        }
        const double two = growth(relation, count, rows, 2 * (m + 1));
        const double cauchy = growth(relation, count, next, 2 * (m + 1));
        CHECK_NEAR(taut_harmonic_rows_amplification(n, m, 1, NULL), two, 1e-12 * two, "n=%d m=%d",
                   n, m);
        CHECK_NEAR(
            taut_harmonic_derivative_amplification(n, m, taut_twice_of(1), scratch, sum, NULL),
            cauchy, 1e-12 * cauchy, "n=%d m=%d", n, m);
        if (rows_printed[m] > 0) {
            CHECK_NEAR(two, rows_printed[m], 0.5, "n=%d", n);
            CHECK_NEAR(cauchy, next_printed[m], 0.5, "n=%d", n);
        }
        fmpz_mat_clear(relation);
    }
}

/* Four rows of a biharmonic surface: the amplification that is reported. */
static void test_biharmonic_amplification(void)
{
    for (int n = 2; n <= 6; n++) {
        const int count = (n + 1) * (n + 1);
        int held[24];
        fmpz_mat_t once, relation;
        taut_arena *arena = taut_arena_new();
        taut_space space;
        taut_rim boundary;
        laplacian(n, n, 1, 1, once);
        fmpz_mat_init(relation, count, count);
        fmpz_mat_mul(relation, once, once);
        for (int k = 0, at = 0; at < count; at++) {
            const int i = at / (n + 1), j = at % (n + 1);
            if (i == 0 || i == n || j == 0 || j == n) {
                held[k++] = at;
            }
        }
        const double exact = growth(relation, count, held, 4 * n);
        CHECK(taut_space_biharmonic(n, 2, 2, arena, NULL, &space) &&
                  taut_rim_solve(&space, arena, &boundary),
              "n=%d", n);
        CHECK_NEAR(taut_rim_amplification(&boundary), exact, 1e-12 * exact, "n=%d", n);
        fmpz_mat_clear(once);
        fmpz_mat_clear(relation);
        taut_arena_free(arena);
    }
}

int main(void)
{
    test_dimensions();
    test_free_parameters();
    test_amplification();
    test_biharmonic_amplification();
    flint_cleanup();
    return check_failures != 0;
}
