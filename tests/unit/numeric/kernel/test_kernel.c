/* Every instruction set this processor has, against plain loops. */
#include "check.h"

#include "core/memory.h"
#include "numeric/kernel/kernel.h"

#include <stdlib.h>
#include <string.h>

enum { N = 41, WIDTH_MAX = 8, RHS = 3, DEPTH_MAX = 70, LENGTH_MAX = 100 };

static const char *const names[] = {"baseline", "avx2", "avx512"};

static double *numbers(size_t count)
{
    double *x = taut_alloc_aligned(count, sizeof *x);
    for (size_t i = 0; x != NULL && i < count; i++) {
        x[i] = random_in(-1.0, 1.0);
    }
    return x;
}

static void test_tile(const taut_kernel *kernel)
{
    const size_t rows = (size_t)kernel->tile_rows, columns = (size_t)kernel->tile_columns;
    CHECK(rows <= TAUT_TILE_ROWS_MAX && columns <= TAUT_TILE_COLUMNS_MAX, "%s", kernel->name);
    for (size_t depth = 0; depth <= DEPTH_MAX; depth += 1 + depth / 3) {
        const size_t stride = columns + 5;
        double *a = numbers(depth * rows), *b = numbers(depth * columns),
               *c = numbers(rows * stride);
        double *before = numbers(rows * stride);
        memcpy(before, c, rows * stride * sizeof *c);
        kernel->tile(depth, a, b, c, stride);
        for (size_t r = 0; r < rows; r++) {
            for (size_t q = 0; q < stride; q++) {
                double sum = before[r * stride + q];
                for (size_t k = 0; k < depth && q < columns; k++) {
                    sum += a[k * rows + r] * b[k * columns + q];
                }
                /* one term after the other, on top of what is there: any cut of the depth is the same */
                CHECK(c[r * stride + q] == sum, "%s depth=%zu r=%zu q=%zu", kernel->name, depth, r,
                      q);
            }
        }
        taut_free(a);
        taut_free(b);
        taut_free(c);
        taut_free(before);
    }
}

/* Diagonally dominant K, so that  scale K + shift M  is definite for the positive shifts and has
 * `lane` negative pivots for the negative ones. */
static void fill_bands(int width, double *k, double *m)
{
    for (int i = 0; i < N; i++) {
        for (int d = 0; d <= width; d++) {
            k[i * (width + 1) + d] = d == 0   ? 2.0 * width + 1.0 + i
                                     : d <= i ? random_in(-1.0, 1.0)
                                              : 0.0;
            m[i * (width + 1) + d] = d == 0 ? 1.0 : d <= i ? random_in(-0.1, 0.1) : 0.0;
        }
    }
}

/* sum_j A(i, j) x[j * lanes] by the definition of band.h; *size gains the sum of the absolute
 * terms. */
static double row_times(int width, const double *a, int i, const double *x, int lanes, double *size)
{
    double sum = 0.0;
    for (int j = 0; j < N; j++) {
        const int d = i > j ? i - j : j - i;
        if (d <= width) {
            const double term = a[(i > j ? i : j) * (width + 1) + d] * x[j * lanes];
            sum += term;
            *size += fabs(term);
        }
    }
    return sum;
}

/* r, M x and the three dots against their definitions. */
static void test_pencil(const taut_kernel *kernel, int width)
{
    const int lanes = TAUT_LANES;
    const size_t vector = (size_t)N * (size_t)lanes;
    double k[N * (WIDTH_MAX + 1)], m[N * (WIDTH_MAX + 1)], lambda[TAUT_LANES];
    double dot[3 * TAUT_LANES];
    double *x = numbers(vector), *r = numbers(vector), *mx = numbers(vector);

    fill_bands(width, k, m);
    for (int l = 0; l < lanes; l++) {
        lambda[l] = random_in(-2.0, 2.0);
    }
    kernel->band_pencil(N, width, k, m, lambda, x, r, mx, dot);
    for (int l = 0; l < lanes; l++) {
        double sum[3] = {0}, size[3] = {0};
        for (int i = 0; i < N; i++) {
            double terms = 0.0;
            const double mass = row_times(width, m, i, x + l, lanes, &terms);
            CHECK_NEAR(mx[i * lanes + l], mass, 24 * terms * 0x1p-53, "%s width=%d i=%d",
                       kernel->name, width, i);
            terms *= fabs(lambda[l]);
            const double rest = row_times(width, k, i, x + l, lanes, &terms) - lambda[l] * mass;
            CHECK_NEAR(r[i * lanes + l], rest, 24 * terms * 0x1p-53, "%s width=%d i=%d",
                       kernel->name, width, i);
            const double here[3] = {x[i * lanes + l] * mass, x[i * lanes + l] * rest, rest * rest};
            for (int q = 0; q < 3; q++) {
                sum[q] += here[q];
                size[q] += (q == 2 ? fabs(rest) : 1.0) * terms + fabs(mass);
            }
        }
        for (int q = 0; q < 3; q++) {
            CHECK_NEAR(dot[q * lanes + l], sum[q], 4 * N * size[q] * 0x1p-53, "%s width=%d q=%d",
                       kernel->name, width, q);
        }
    }
    taut_free(x);
    taut_free(r);
    taut_free(mx);
}

/* Factors made in two pieces solve A x = b. */
static void test_band(const taut_kernel *kernel, int width)
{
    const int lanes = TAUT_LANES;
    const size_t row = ((size_t)width + 1) * (size_t)lanes, vector = (size_t)N * (size_t)lanes;
    double k[N * (WIDTH_MAX + 1)], m[N * (WIDTH_MAX + 1)], a[N * (WIDTH_MAX + 1)];
    double shift[TAUT_LANES], negative[TAUT_LANES] = {0}, unused = 0.0;
    double *factor = numbers(((size_t)N + (size_t)width) * row);
    double *x = numbers(vector), *z = numbers(vector * RHS);

    fill_bands(width, k, m);
    memset(factor, 0, (size_t)width * row * sizeof *factor);
    for (int l = 0; l < lanes; l++) {
        shift[l] = random_in(0.0, 3.0);
    }
    kernel->band_factor(0, 17, width, k, m, 0.5, shift, 1e-300, factor, negative);
    kernel->band_factor(17, N, width, k, m, 0.5, shift, 1e-300, factor + 17 * row, negative);
    for (int l = 0; l < lanes; l++) {
        CHECK(negative[l] == 0.0, "%s width=%d lane=%d", kernel->name, width, l);
        for (int i = 0; i < N * (width + 1); i++) {
            a[i] = 0.5 * k[i] + shift[l] * m[i];
        }
        for (int i = 0; i < N; i++) {
            const double image = row_times(width, a, i, x + l, lanes, &unused);
            for (int c = 0; c < RHS; c++) {
                z[(i * RHS + c) * lanes + l] = (c + 1) * image;
            }
        }
    }
    kernel->band_substitute(N, width, RHS, factor, z);
    for (int i = 0; i < N * RHS * lanes; i++) {
        const int l = i % lanes, c = i / lanes % RHS, at = i / lanes / RHS;
        /* cond(A) < 400 by Gershgorin; backward error below 3 (width + 1) u */
        CHECK_NEAR(z[i], (c + 1) * x[at * lanes + l], 3 * 400 * 27 * 0x1p-53, "%s width=%d",
                   kernel->name, width);
    }
    taut_free(factor);
    taut_free(x);
    taut_free(z);
}

/* K = diag(i), M = 1: exactly s eigenvalues lie below s - 1/2. */
static void test_counts(const taut_kernel *kernel)
{
    double k[N], m[N], shift[TAUT_LANES], negative[TAUT_LANES] = {0};
    double *factor = numbers((size_t)N * (size_t)TAUT_LANES);
    for (int i = 0; i < N; i++) {
        k[i] = i;
        m[i] = 1.0;
    }
    for (int l = 0; l < TAUT_LANES; l++) {
        shift[l] = 0.5 - l;
    }
    kernel->band_factor(0, N, 0, k, m, 1.0, shift, 1e-300, factor, negative);
    for (int l = 0; l < TAUT_LANES; l++) {
        CHECK(negative[l] == l, "%s lane=%d found %g", kernel->name, l, negative[l]);
    }
    taut_free(factor);
}

/* Sums that cancel to about 2^-70 of their terms keep their leading digits when taken exactly. */
static void test_vectors(const taut_kernel *kernel)
{
    for (size_t count = 0; count <= LENGTH_MAX; count++) {
        double *x = numbers(count + 1), *c = numbers(count + 1), *y = numbers(count + 1),
               *old = numbers(count + 1);
        double *high = numbers(count + 1), *low = numbers(count + 1);
        memcpy(old, y, (count + 1) * sizeof *y);
        kernel->add_scaled(count, 0.3, x, y);
        kernel->add_products(count, c, x, y);
        memset(high, 0, (count + 1) * sizeof *high);
        memset(low, 0, (count + 1) * sizeof *low);
        kernel->add_products_exactly(count, c, x, high, low);
        for (size_t i = 0; i <= count; i++) {
            const double sum = i < count ? old[i] + 0.3 * x[i] + c[i] * x[i] : old[i];
            CHECK_NEAR(y[i], sum, 8 * 0x1p-53, "%s count=%zu i=%zu", kernel->name, count, i);
            CHECK(i == count || high[i] == c[i] * x[i], "%s count=%zu i=%zu", kernel->name, count,
                  i);
            CHECK(i == count || low[i] == fma(c[i], x[i], -high[i]), "%s count=%zu i=%zu",
                  kernel->name, count, i);
        }
        /* - 2 (high + low) / 2 by a scaled addition leaves nothing */
        double *negated = numbers(count + 1), *negated_low = numbers(count + 1);
        memcpy(negated, high, (count + 1) * sizeof *high);
        memcpy(negated_low, low, (count + 1) * sizeof *low);
        kernel->add_scaled_exactly(count, -1.0, negated, negated_low, high, low);
        for (size_t i = 0; i < count; i++) {
            CHECK(high[i] + low[i] == 0.0, "%s count=%zu i=%zu", kernel->name, count, i);
        }
        double *const all[] = {x, c, y, old, high, low, negated, negated_low};
        for (size_t i = 0; i < sizeof all / sizeof *all; i++) {
            taut_free(all[i]);
        }
    }
}

static void test_dot(const taut_kernel *kernel)
{
    double xy[TAUT_LANES], xx[TAUT_LANES];
    double *x = numbers((size_t)N * (size_t)TAUT_LANES),
           *y = numbers((size_t)N * (size_t)TAUT_LANES);
    kernel->lane_dot(N, x, y, xy, xx);
    for (int l = 0; l < TAUT_LANES; l++) {
        double by = 0.0, self = 0.0;
        for (int i = 0; i < N; i++) {
            by += x[i * TAUT_LANES + l] * y[i * TAUT_LANES + l];
            self += x[i * TAUT_LANES + l] * x[i * TAUT_LANES + l];
        }
        CHECK_NEAR(xy[l], by, N * N * 0x1p-53, "%s lane=%d", kernel->name, l);
        CHECK_NEAR(xx[l], self, N * N * 0x1p-53, "%s lane=%d", kernel->name, l);
    }
    taut_free(x);
    taut_free(y);
}

/* Products of powers of two are exact, whatever their size; others are good to a few units. */
static void test_product(const taut_kernel *kernel)
{
    double mantissa[TAUT_LANES], *x = numbers((size_t)N * (size_t)TAUT_LANES * 2);
    int64_t exponent[TAUT_LANES];
    double expected[TAUT_LANES];
    int power[TAUT_LANES];
    for (int l = 0; l < TAUT_LANES; l++) {
        mantissa[l] = expected[l] = 1.0;
        exponent[l] = power[l] = 0;
        for (int i = 0; i < N; i++) {
            int shift = 0;
            const double value = random_in(1.0, 2.0) * (random_int(0, 1) == 0 ? -1.0 : 1.0);
            const int scale = random_int(-240, 240);
            x[(i * 2) * TAUT_LANES + l] = ldexp(value, scale);
            expected[l] = frexp(expected[l] * value, &shift);
            power[l] += shift + scale;
        }
    }
    kernel->lane_product(13, 2 * (size_t)TAUT_LANES, x, mantissa, exponent);
    kernel->lane_product(N - 13, 2 * (size_t)TAUT_LANES, x + (size_t)26 * (size_t)TAUT_LANES,
                         mantissa, exponent);
    for (int l = 0; l < TAUT_LANES; l++) {
        const double ratio = ldexp(mantissa[l] / expected[l], (int)exponent[l] - power[l]);
        CHECK_NEAR(ratio, 1.0, 2 * N * 0x1p-53, "%s lane=%d", kernel->name, l);
        CHECK(fabs(mantissa[l]) >= 1.0 && fabs(mantissa[l]) < 2.0, "%s lane=%d", kernel->name, l);
    }
    taut_free(x);
}

static void test_long_dot(const taut_kernel *kernel)
{
    for (size_t count = 0; count <= LENGTH_MAX; count++) {
        double *x = numbers(count + 1), *y = numbers(count + 1), sum = 0.0;
        for (size_t i = 0; i < count; i++) {
            sum += x[i] * y[i];
        }
        CHECK_NEAR(kernel->dot(count, x, y), sum, (double)(count * count) * 0x1p-53, "%s count=%zu",
                   kernel->name, count);
        taut_free(x);
        taut_free(y);
    }
}

/* M x by diagonals against the definition, for any length and width. */
static void test_diagonals(const taut_kernel *kernel)
{
    for (size_t n = 1; n <= LENGTH_MAX; n += 1 + n / 5) {
        for (size_t width = 0; width <= WIDTH_MAX; width++) {
            double *a = numbers(n * (width + 1)), *x = numbers(n), *y = numbers(n);
            kernel->diagonals_multiply(n, width, a, x, y);
            for (size_t i = 0; i < n; i++) {
                double sum = 0.0;
                for (size_t j = 0; j < n; j++) {
                    const size_t d = i > j ? i - j : j - i;
                    sum += d <= width ? a[d * n + (i > j ? i : j)] * x[j] : 0.0;
                }
                CHECK_NEAR(y[i], sum, 17 * 17 * 0x1p-53, "%s n=%zu width=%zu i=%zu", kernel->name,
                           n, width, i);
            }
            taut_free(a);
            taut_free(x);
            taut_free(y);
        }
    }
}

static void test_pack(const taut_kernel *kernel)
{
    const size_t unit = (size_t)kernel->tile_columns, stride = 3 * unit;
    double *from = numbers(4 * unit), *to = numbers(4 * stride), *before = numbers(4 * stride);
    memcpy(before, to, 4 * stride * sizeof *to);
    kernel->pack(4, from, stride, to);
    for (size_t i = 0; i < 4 * stride; i++) {
        const double expected =
            i % stride < unit ? from[i / stride * unit + i % stride] : before[i];
        CHECK(to[i] == expected, "%s i=%zu", kernel->name, i);
    }
    taut_free(from);
    taut_free(to);
    taut_free(before);
}

/* What the kernel makes of numbers that depend on the seed alone, one result after the other. */
typedef struct transcript {
    size_t count;
    double at[60000];
} transcript;

static void keep(const double *numbers_made, size_t count, transcript *all)
{
    CHECK(all->count + count <= sizeof all->at / sizeof *all->at, "%zu", all->count + count);
    if (all->count + count <= sizeof all->at / sizeof *all->at) {
        memcpy(all->at + all->count, numbers_made, count * sizeof *numbers_made);
        all->count += count;
    }
}

static void keep_band(const taut_kernel *kernel, int width, transcript *all)
{
    const size_t row = ((size_t)width + 1) * TAUT_LANES, vector = (size_t)N * TAUT_LANES;
    double k[N * (WIDTH_MAX + 1)], m[N * (WIDTH_MAX + 1)];
    double shift[TAUT_LANES], negative[TAUT_LANES] = {0}, dot[3 * TAUT_LANES];
    double *factor = numbers(((size_t)N + (size_t)width) * row), *z = numbers(vector * RHS);
    double *x = numbers(vector), *r = numbers(vector), *mx = numbers(vector);

    fill_bands(width, k, m);
    memset(factor, 0, (size_t)width * row * sizeof *factor);
    for (int l = 0; l < TAUT_LANES; l++) {
        shift[l] = random_in(-9.0, 3.0);
    }
    kernel->band_factor(0, N, width, k, m, 0.7, shift, 1e-300, factor, negative);
    kernel->band_substitute(N, width, RHS, factor, z);
    kernel->band_pencil(N, width, k, m, shift, x, r, mx, dot);
    keep(factor, (size_t)N * row, all);
    keep(negative, TAUT_LANES, all);
    keep(z, vector * RHS, all);
    keep(r, vector, all);
    keep(mx, vector, all);
    keep(dot, sizeof dot / sizeof *dot, all);
    double *const made[] = {factor, z, x, r, mx};
    for (size_t i = 0; i < sizeof made / sizeof *made; i++) {
        taut_free(made[i]);
    }
}

static void keep_lanes(const taut_kernel *kernel, transcript *all)
{
    double *x = numbers((size_t)N * TAUT_LANES), *y = numbers((size_t)N * TAUT_LANES);
    double xy[TAUT_LANES], xx[TAUT_LANES], mantissa[TAUT_LANES], power[TAUT_LANES];
    int64_t exponent[TAUT_LANES] = {0};
    for (int l = 0; l < TAUT_LANES; l++) {
        mantissa[l] = 1.0;
    }
    kernel->lane_dot(N, x, y, xy, xx);
    kernel->lane_product(N, TAUT_LANES, x, mantissa, exponent);
    for (int l = 0; l < TAUT_LANES; l++) {
        power[l] = (double)exponent[l];
    }
    keep(xy, TAUT_LANES, all);
    keep(xx, TAUT_LANES, all);
    keep(mantissa, TAUT_LANES, all);
    keep(power, TAUT_LANES, all);
    taut_free(x);
    taut_free(y);
}

static void keep_vectors(const taut_kernel *kernel, size_t count, transcript *all)
{
    double *x = numbers(count), *c = numbers(count), *y = numbers(count), *a = numbers(4 * count);
    double *high = numbers(count), *low = numbers(count);
    const double dot = kernel->dot(count, x, y);
    kernel->add_scaled(count, 0.3, x, y);
    kernel->add_products(count, c, x, y);
    kernel->add_products_exactly(count, c, x, high, low);
    kernel->add_scaled_exactly(count, 1.1, x, c, high, low);
    keep(&dot, 1, all);
    keep(y, count, all);
    keep(high, count, all);
    keep(low, count, all);
    kernel->diagonals_multiply(count, 3, a, x, y);
    keep(y, count, all);
    double *const made[] = {x, c, y, a, high, low};
    for (size_t i = 0; i < sizeof made / sizeof *made; i++) {
        taut_free(made[i]);
    }
}

/* Every set makes the same numbers, bit for bit. */
static void test_same(const taut_kernel *kernel)
{
    static transcript first, other;
    for (int k = 0; k < 2; k++) {
        transcript *all = k == 0 ? &first : &other;
        const taut_kernel *set = k == 0 ? taut_kernel_find("baseline") : kernel;
        all->count = 0;
        random_seed(34);
        keep_band(set, 3, all);
        keep_band(set, WIDTH_MAX, all);
        keep_lanes(set, all);
        for (size_t count = 1; count <= LENGTH_MAX; count += 3) {
            keep_vectors(set, count, all);
        }
    }
    CHECK(first.count > 25000 && first.count == other.count, "%zu %zu", first.count, other.count);
    for (size_t i = 0; i < first.count; i++) {
        if (memcmp(&first.at[i], &other.at[i], sizeof first.at[i]) != 0) {
            CHECK(0, "%s: number %zu is %.17g, baseline's %.17g", kernel->name, i, other.at[i],
                  first.at[i]);
            return;
        }
    }
}

static void test_choice(void)
{
    CHECK(taut_kernel_find("baseline") != NULL, "the baseline is always there");
    CHECK(taut_kernel_find("sse9") == NULL, "no such kernel");
    setenv("TAUT_KERNEL", "baseline", 1);
    CHECK(strcmp(taut_kernel_name(), "baseline") == 0, "%s", taut_kernel_name());
    setenv("TAUT_KERNEL", "sse9", 1);
    const char *fallback = taut_kernel_name();
    unsetenv("TAUT_KERNEL");
    CHECK(strcmp(taut_kernel_name(), fallback) == 0, "an unknown name means the best");
}

int main(void)
{
    random_seed(12);
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        const taut_kernel *kernel = taut_kernel_find(names[i]);
        if (kernel == NULL) {
            continue;
        }
        test_same(kernel);
        test_tile(kernel);
        test_counts(kernel);
        for (int width = 0; width <= WIDTH_MAX; width++) {
            test_band(kernel, width);
            test_pencil(kernel, width);
        }
        test_vectors(kernel);
        test_dot(kernel);
        test_product(kernel);
        test_long_dot(kernel);
        test_diagonals(kernel);
        test_pack(kernel);
    }
    test_choice();
    return check_failures != 0;
}
