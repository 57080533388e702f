/* band_body.h -- banded L D L^T and products, LANES problems at once, GROUPS vectors of V_SIZE
 * lanes.
 *
 * The chain pivot -> 1/pivot -> next pivot is long; GROUPS independent ones run side by side to
 * fill it. The loops are inlined once per small width with the width a constant, so that the
 * compiler unrolls them and keeps a row in registers, and once for any width. */

/* Row by row, u(i,j) = L(i,j) D(j) (compare band.c), kept in the place of L(i,j) until its last
 * use: u(i,j) = A(i,j) - sum_k u(i,k) L(j,k),   L(i,j) = u(i,j) / D(j),   D(i) = A(i,i) - sum_j
 * u(i,j) L(i,j) */
INLINE void factor_rows(int first, int end, const int width, const double *k, const double *m,
                        double scale, const double *shift, double tiny, double *factor,
                        double *negative)
{
    const ptrdiff_t slots = width + 1;
    const v_double none = v_all(0.0), one = v_all(1.0), limit = v_all(tiny);
    v_double sigma[GROUPS], below[GROUPS];
    for (int g = 0; g < GROUPS; g++) {
        sigma[g] = v_load(shift + g * V_SIZE);
        below[g] = v_load(negative + g * V_SIZE);
    }
    for (int i = first; i < end; i++) {
        const double *ki = k + (ptrdiff_t)i * slots;
        const double *mi = m + (ptrdiff_t)i * slots;
        double *row = factor + (ptrdiff_t)(i - first + width) * slots * LANES;
        v_double pivot[GROUPS];
        for (int g = 0; g < GROUPS; g++) {
            pivot[g] = v_fma(sigma[g], v_all(mi[0]), v_all(scale * ki[0]));
        }
#pragma GCC unroll 8
        for (int d = width; d >= 1; d--) {
            const double *upper = row - d * slots * LANES;
            const v_double kd = v_all(scale * ki[d]), md = v_all(mi[d]);
            for (int g = 0; g < GROUPS; g++) {
                v_double u = v_fma(sigma[g], md, kd);
#pragma GCC unroll 8
                for (int e = width; e > d; e--) {
                    u = v_fnma(v_load(row + e * LANES + g * V_SIZE),
                               v_load(upper + (e - d) * LANES + g * V_SIZE), u);
                }
                v_store(row + d * LANES + g * V_SIZE, u);
            }
        }
#pragma GCC unroll 8
        for (int d = width; d >= 1; d--) {
            const double *inverse = row - d * slots * LANES;
            for (int g = 0; g < GROUPS; g++) {
                double *at = row + d * LANES + g * V_SIZE;
                const v_double u = v_load(at);
                const v_double l = u * v_load(inverse + g * V_SIZE);
                v_store(at, l);
                pivot[g] = v_fnma(u, l, pivot[g]);
            }
        }
        for (int g = 0; g < GROUPS; g++) {
            pivot[g] = v_select((pivot[g] < limit) & (pivot[g] > -limit), -limit, pivot[g]);
            below[g] += v_select(pivot[g] < none, one, none);
            v_store(row + g * V_SIZE, one / pivot[g]);
        }
    }
    for (int g = 0; g < GROUPS; g++) {
        v_store(negative + g * V_SIZE, below[g]);
    }
}

/* z = L^-1 b, then x = L^-T D^-1 z, in place, GROUPS vectors of one right-hand side at a time. */
INLINE void substitute_rows(int n, const int width, int count, const double *factor, double *x)
{
    const ptrdiff_t slots = width + 1, step = (ptrdiff_t)count * LANES;
    for (int i = 1; i < n; i++) {
        const double *row = factor + (ptrdiff_t)(width + i) * slots * LANES;
        const int reach = i < width ? i : width;
        for (int c = 0; c < count; c++) {
            double *xi = x + (ptrdiff_t)i * step + c * LANES;
            for (int g = 0; g < GROUPS; g++) {
                v_double z = v_load(xi + g * V_SIZE);
                for (int d = reach; d >= 1; d--) {
                    z = v_fnma(v_load(row + d * LANES + g * V_SIZE),
                               v_load(xi - d * step + g * V_SIZE), z);
                }
                v_store(xi + g * V_SIZE, z);
            }
        }
    }
    for (int i = n - 1; i >= 0; i--) {
        const double *row = factor + (ptrdiff_t)(width + i) * slots * LANES;
        const int reach = n - 1 - i < width ? n - 1 - i : width;
        for (int c = 0; c < count; c++) {
            double *xi = x + (ptrdiff_t)i * step + c * LANES;
            for (int g = 0; g < GROUPS; g++) {
                v_double y = v_load(row + g * V_SIZE) * v_load(xi + g * V_SIZE);
                for (int d = reach; d >= 1; d--) {
                    y = v_fnma(v_load(row + (d * slots + d) * LANES + g * V_SIZE),
                               v_load(xi + d * step + g * V_SIZE), y);
                }
                v_store(xi + g * V_SIZE, y);
            }
        }
    }
}

#define FACTOR_FIXED(width)                                                                        \
    TARGET static void factor_##width(int first, int end, const double *k, const double *m,        \
                                      double scale, const double *shift, double tiny,              \
                                      double *factor, double *negative)                            \
    {                                                                                              \
        factor_rows(first, end, width, k, m, scale, shift, tiny, factor, negative);                \
    }                                                                                              \
    TARGET static void substitute_##width(int n, int count, const double *factor, double *x)       \
    {                                                                                              \
        substitute_rows(n, width, count, factor, x);                                               \
    }
FACTOR_FIXED(1)
FACTOR_FIXED(2)
FACTOR_FIXED(3)
FACTOR_FIXED(4)
FACTOR_FIXED(5)
#undef FACTOR_FIXED

static const struct {
    void (*factor)(int, int, const double *, const double *, double, const double *, double,
                   double *, double *);
    void (*substitute)(int, int, const double *, double *);
} fixed_width[] = {{factor_1, substitute_1},
                   {factor_2, substitute_2},
                   {factor_3, substitute_3},
                   {factor_4, substitute_4},
                   {factor_5, substitute_5}};
enum { WIDTH_FIXED = sizeof fixed_width / sizeof *fixed_width };

TARGET static void band_factor(int first, int end, int width, const double *k, const double *m,
                               double scale, const double *shift, double tiny, double *factor,
                               double *negative)
{
    if (width >= 1 && width <= WIDTH_FIXED) {
        fixed_width[width - 1].factor(first, end, k, m, scale, shift, tiny, factor, negative);
    } else {
        factor_rows(first, end, width, k, m, scale, shift, tiny, factor, negative);
    }
}

TARGET static void band_substitute(int n, int width, int count, const double *factor, double *x)
{
    if (width >= 1 && width <= WIDTH_FIXED) {
        fixed_width[width - 1].substitute(n, count, factor, x);
    } else {
        substitute_rows(n, width, count, factor, x);
    }
}

TARGET static void band_multiply(int n, int width, const double *a, const double *x, double *y)
{
    const ptrdiff_t slots = (ptrdiff_t)width + 1;
    for (int i = 0; i < n; i++) {
        const double *row = a + i * slots;
        const int up = i < width ? i : width, down = n - 1 - i < width ? n - 1 - i : width;
        const double *xi = x + (ptrdiff_t)i * LANES;
        v_double sum[GROUPS];
        for (int g = 0; g < GROUPS; g++) {
            sum[g] = v_all(row[0]) * v_load(xi + g * V_SIZE);
        }
        for (int d = 1; d <= up; d++) {
            for (int g = 0; g < GROUPS; g++) {
                sum[g] = v_fma(v_all(row[d]), v_load(xi - d * LANES + g * V_SIZE), sum[g]);
            }
        }
        for (int d = 1; d <= down; d++) {
            const v_double ad = v_all(row[d * slots + d]);
            for (int g = 0; g < GROUPS; g++) {
                sum[g] = v_fma(ad, v_load(xi + d * LANES + g * V_SIZE), sum[g]);
            }
        }
        for (int g = 0; g < GROUPS; g++) {
            v_store(y + (ptrdiff_t)i * LANES + g * V_SIZE, sum[g]);
        }
    }
}

TARGET static void dot(int n, const double *x, const double *y, double *xy, double *xx)
{
    for (int g = 0; g < GROUPS; g++) {
        v_double s = v_all(0.0), t = v_all(0.0);
        for (int i = 0; i < n; i++) {
            const v_double xi = v_load(x + (ptrdiff_t)i * LANES + g * V_SIZE);
            s = v_fma(xi, v_load(y + (ptrdiff_t)i * LANES + g * V_SIZE), s);
            t = v_fma(xi, xi, t);
        }
        v_store(xy + g * V_SIZE, s);
        v_store(xx + g * V_SIZE, t);
    }
}
