/* band_body.h -- banded L D L^T and products, LANES problems at once, a BLOCK of GROUPS vectors of
 * V_SIZE lanes after the other.
 *
 * The chain pivot -> 1/pivot -> next pivot is long; GROUPS independent ones run side by side to
 * fill it. The loops are inlined once per small width with the width a constant, so that the
 * compiler unrolls them and keeps a row in registers, and once for any width. */

/* Row by row, u(i,j) = L(i,j) D(j) (compare band.c), with D(i) by way of u^2 / D, so that the next
 * pivot waits for one product less:
 *     u(i,j) = A(i,j) - sum_k u(i,k) L(j,k),    L(i,j) = u(i,j) / D(j),
 *     D(i)   = A(i,i) - sum_j u(i,j)^2 / D(j)
 * `width` is a constant here. */
INLINE void factor_rows(int first, int end, const int width, const double *k, const double *m,
                        double scale, const double *shift, double tiny, double *factor,
                        double *negative)
{
    const ptrdiff_t slots = width + 1;
    const v_double none = v_all(0.0), one = v_all(1.0), limit = v_all(tiny);
    v_double sigma[GROUPS], below[GROUPS], last[GROUPS]; /* last: 1/D(i-1) */
    for (int g = 0; g < GROUPS; g++) {
        sigma[g] = v_load(shift + g * V_SIZE);
        below[g] = v_load(negative + g * V_SIZE);
        last[g] = v_load(factor + (width - 1) * slots * LANES + g * V_SIZE);
    }
    for (int i = first; i < end; i++) {
        const double *ki = k + (ptrdiff_t)i * slots;
        const double *mi = m + (ptrdiff_t)i * slots;
        double *row = factor + (ptrdiff_t)(i - first + width) * slots * LANES;
        v_double u[WIDTH_FIXED + 1][GROUPS], pivot[GROUPS];
        for (int g = 0; g < GROUPS; g++) {
            pivot[g] = v_add_product(sigma[g], v_all(mi[0]), v_all(scale * ki[0]));
        }
#pragma GCC unroll 8
        for (int d = width; d >= 1; d--) {
            const double *upper = row - d * slots * LANES;
            const v_double kd = v_all(scale * ki[d]), md = v_all(mi[d]);
            for (int g = 0; g < GROUPS; g++) {
                u[d][g] = v_add_product(sigma[g], md, kd);
#pragma GCC unroll 8
                for (int e = width; e > d; e--) {
                    u[d][g] = v_less_product(u[e][g], v_load(upper + (e - d) * LANES + g * V_SIZE),
                                             u[d][g]);
                }
            }
        }
#pragma GCC unroll 8
        for (int d = width; d >= 1; d--) {
            for (int g = 0; g < GROUPS; g++) {
                const v_double over =
                    d == 1 ? last[g] : v_load(row - d * slots * LANES + g * V_SIZE);
                v_store(row + d * LANES + g * V_SIZE, u[d][g] * over);
                pivot[g] = v_less_product(u[d][g] * u[d][g], over, pivot[g]);
            }
        }
        for (int g = 0; g < GROUPS; g++) {
            pivot[g] = v_away_from_zero(pivot[g], limit);
            below[g] += v_select(pivot[g] < none, one, none);
            last[g] = one / pivot[g];
            v_store(row + g * V_SIZE, last[g]);
        }
    }
    for (int g = 0; g < GROUPS; g++) {
        v_store(negative + g * V_SIZE, below[g]);
    }
}

/* The same for any width; u is kept in the place of L until its last use. */
INLINE void factor_any(int first, int end, int width, const double *k, const double *m,
                       double scale, const double *shift, double tiny, double *factor,
                       double *negative)
{
    const ptrdiff_t slots = (ptrdiff_t)width + 1;
    for (int i = first; i < end; i++) {
        const double *ki = k + i * slots, *mi = m + i * slots;
        double *row = factor + (i - first + width) * slots * LANES;
        v_double pivot[GROUPS];
        for (int g = 0; g < GROUPS; g++) {
            pivot[g] =
                v_add_product(v_load(shift + g * V_SIZE), v_all(mi[0]), v_all(scale * ki[0]));
        }
        for (int d = width; d >= 1; d--) {
            const double *upper = row - d * slots * LANES;
            const v_double kd = v_all(scale * ki[d]), md = v_all(mi[d]);
            v_double u[GROUPS];
            for (int g = 0; g < GROUPS; g++) {
                u[g] = v_add_product(v_load(shift + g * V_SIZE), md, kd);
            }
            for (int e = width; e > d; e--) {
                for (int g = 0; g < GROUPS; g++) {
                    u[g] = v_less_product(v_load(row + e * LANES + g * V_SIZE),
                                          v_load(upper + (e - d) * LANES + g * V_SIZE), u[g]);
                }
            }
            for (int g = 0; g < GROUPS; g++) {
                v_store(row + d * LANES + g * V_SIZE, u[g]);
            }
        }
        for (int d = width; d >= 1; d--) {
            for (int g = 0; g < GROUPS; g++) {
                double *at = row + d * LANES + g * V_SIZE;
                const v_double over = v_load(row - d * slots * LANES + g * V_SIZE), u = v_load(at);
                v_store(at, u * over);
                pivot[g] = v_less_product(u * u, over, pivot[g]);
            }
        }
        for (int g = 0; g < GROUPS; g++) {
            double *count = negative + g * V_SIZE;
            pivot[g] = v_away_from_zero(pivot[g], v_all(tiny));
            v_store(count, v_load(count) + v_select(pivot[g] < v_all(0.0), v_all(1.0), v_all(0.0)));
            v_store(row + g * V_SIZE, v_all(1.0) / pivot[g]);
        }
    }
}

/* z = L^-1 b, then x = L^-T D^-1 z, in place, for one right-hand side of `count`; `width` is a
 * constant here. Both ways the last `width` entries stay in registers: going down as they are,
 * going up as the entries that still wait for their share of those below. */
INLINE void substitute_column(int n, const int width, int count, const double *factor, double *x)
{
    const ptrdiff_t slots = width + 1, step = (ptrdiff_t)count * LANES;
    const double *row = factor + (ptrdiff_t)width * slots * LANES;
    v_double near[WIDTH_FIXED][GROUPS];
#pragma GCC unroll 8
    for (int d = 0; d < width; d++) {
        for (int g = 0; g < GROUPS; g++) {
            near[d][g] = v_all(0.0);
        }
    }
    for (int i = 0; i < n; i++, row += slots * LANES) {
        double *xi = x + (ptrdiff_t)i * step;
        for (int g = 0; g < GROUPS; g++) {
            v_double z = v_load(xi + g * V_SIZE);
#pragma GCC unroll 8
            for (int d = width; d >= 1; d--) {
                z = v_less_product(v_load(row + d * LANES + g * V_SIZE), near[d - 1][g], z);
            }
#pragma GCC unroll 8
            for (int d = width - 1; d >= 1; d--) {
                near[d][g] = near[d - 1][g];
            }
            near[0][g] = z;
            v_store(xi + g * V_SIZE, z);
        }
    }
    /* near[d] = z(i-d) / D(i-d), from i = n-1 on */
    row -= slots * LANES;
#pragma GCC unroll 8
    for (int d = 0; d < width; d++) {
        for (int g = 0; g < GROUPS && d < n; g++) {
            near[d][g] *= v_load(row - d * slots * LANES + g * V_SIZE);
        }
    }
    for (int i = n - 1; i >= 0; i--, row -= slots * LANES) {
        double *xi = x + (ptrdiff_t)i * step;
        for (int g = 0; g < GROUPS; g++) {
            const v_double y = near[0][g];
            v_store(xi + g * V_SIZE, y);
#pragma GCC unroll 8
            for (int d = 1; d < width; d++) {
                near[d - 1][g] =
                    v_less_product(v_load(row + d * LANES + g * V_SIZE), y, near[d][g]);
            }
            if (i >= width) {
                const v_double far = v_load(xi - width * step + g * V_SIZE) *
                                     v_load(row - width * slots * LANES + g * V_SIZE);
                near[width - 1][g] =
                    v_less_product(v_load(row + width * LANES + g * V_SIZE), y, far);
            }
        }
    }
}

INLINE void substitute_rows(int n, const int width, int count, const double *factor, double *x)
{
    for (int c = 0; c < count; c++) {
        substitute_column(n, width, count, factor, x + c * LANES);
    }
}

/* The same for any width, entries in memory. */
INLINE void substitute_any(int n, int width, int count, const double *factor, double *x)
{
    const ptrdiff_t slots = (ptrdiff_t)width + 1, step = (ptrdiff_t)count * LANES;
    for (int i = 1; i < n; i++) {
        const double *row = factor + (width + i) * slots * LANES;
        const int reach = i < width ? i : width;
        for (int c = 0; c < count * (LANES / V_SIZE); c++) {
            double *xi = x + i * step + c * V_SIZE;
            const double *l = row + c % (LANES / V_SIZE) * V_SIZE;
            v_double z = v_load(xi);
            for (int d = reach; d >= 1; d--) {
                z = v_less_product(v_load(l + d * LANES), v_load(xi - d * step), z);
            }
            v_store(xi, z);
        }
    }
    for (int i = n - 1; i >= 0; i--) {
        const double *row = factor + (width + i) * slots * LANES;
        const int reach = n - 1 - i < width ? n - 1 - i : width;
        for (int c = 0; c < count * (LANES / V_SIZE); c++) {
            double *xi = x + i * step + c * V_SIZE;
            const double *l = row + c % (LANES / V_SIZE) * V_SIZE;
            v_double y = v_load(l) * v_load(xi);
            for (int d = reach; d >= 1; d--) {
                y = v_less_product(v_load(l + (d * slots + d) * LANES), v_load(xi + d * step), y);
            }
            v_store(xi, y);
        }
    }
}

/* Where code is to be small, rows of pencils have one loop for any width. */
#ifdef TAUT_SMALL_KERNEL
#define PENCIL static TARGET __attribute__((noinline))
#else
#define PENCIL INLINE
#endif

/* r = K x - lambda M x and mx = M x on rows first..end-1, where all of row i reaches `up` rows up
 * and `down` rows down; adds to the dots. */
PENCIL void pencil_rows(int first, int end, int width, int up, int down, const double *k,
                        const double *m, const double *lambda, const double *x, double *r,
                        double *mx, v_double (*dots)[GROUPS])
{
    const ptrdiff_t slots = (ptrdiff_t)width + 1;
    for (int i = first; i < end; i++) {
        const double *ki = k + i * slots, *mi = m + i * slots;
        const double *xi = x + (ptrdiff_t)i * LANES;
        v_double by_k[GROUPS], by_m[GROUPS];
        for (int g = 0; g < GROUPS; g++) {
            by_k[g] = v_all(ki[0]) * v_load(xi + g * V_SIZE);
            by_m[g] = v_all(mi[0]) * v_load(xi + g * V_SIZE);
        }
#pragma GCC unroll 8
        for (int d = 1; d <= up; d++) {
            const v_double kd = v_all(ki[d]), md = v_all(mi[d]);
            for (int g = 0; g < GROUPS; g++) {
                const v_double above = v_load(xi - d * LANES + g * V_SIZE);
                by_k[g] = v_add_product(kd, above, by_k[g]);
                by_m[g] = v_add_product(md, above, by_m[g]);
            }
        }
#pragma GCC unroll 8
        for (int d = 1; d <= down; d++) {
            const v_double kd = v_all(ki[d * slots + d]), md = v_all(mi[d * slots + d]);
            for (int g = 0; g < GROUPS; g++) {
                const v_double below = v_load(xi + d * LANES + g * V_SIZE);
                by_k[g] = v_add_product(kd, below, by_k[g]);
                by_m[g] = v_add_product(md, below, by_m[g]);
            }
        }
        for (int g = 0; g < GROUPS; g++) {
            const v_double here = v_load(xi + g * V_SIZE);
            by_k[g] = v_less_product(v_load(lambda + g * V_SIZE), by_m[g], by_k[g]);
            v_store(r + (ptrdiff_t)i * LANES + g * V_SIZE, by_k[g]);
            v_store(mx + (ptrdiff_t)i * LANES + g * V_SIZE, by_m[g]);
            dots[0][g] = v_add_product(here, by_m[g], dots[0][g]);
            dots[1][g] = v_add_product(here, by_k[g], dots[1][g]);
            dots[2][g] = v_add_product(by_k[g], by_k[g], dots[2][g]);
        }
    }
}

INLINE void pencil_all(int n, const int width, const double *k, const double *m,
                       const double *lambda, const double *x, double *r, double *mx, double *dot)
{
    v_double dots[3][GROUPS];
    for (int g = 0; g < GROUPS; g++) {
        dots[0][g] = dots[1][g] = dots[2][g] = v_all(0.0);
    }
    const int inner = width < n ? width : n, last = n - width > inner ? n - width : inner;
    for (int i = 0; i < inner; i++) {
        pencil_rows(i, i + 1, width, i, n - 1 - i < width ? n - 1 - i : width, k, m, lambda, x, r,
                    mx, dots);
    }
    pencil_rows(inner, last, width, width, width, k, m, lambda, x, r, mx, dots);
    for (int i = last; i < n; i++) {
        pencil_rows(i, i + 1, width, width, n - 1 - i, k, m, lambda, x, r, mx, dots);
    }
    for (int g = 0; g < 3 * GROUPS; g++) {
        v_store(dot + g / GROUPS * LANES + g % GROUPS * V_SIZE, dots[g / GROUPS][g % GROUPS]);
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
    }                                                                                              \
    TARGET static void pencil_##width(int n, const double *k, const double *m,                     \
                                      const double *lambda, const double *x, double *r,            \
                                      double *mx, double *dot)                                     \
    {                                                                                              \
        pencil_all(n, width, k, m, lambda, x, r, mx, dot);                                         \
    }
FACTOR_FIXED(1)
FACTOR_FIXED(2)
FACTOR_FIXED(3)
FACTOR_FIXED(4)
FACTOR_FIXED(5)
#undef FACTOR_FIXED

static const struct fixed_width {
    void (*factor)(int, int, const double *, const double *, double, const double *, double,
                   double *, double *);
    void (*substitute)(int, int, const double *, double *);
    void (*pencil)(int, const double *, const double *, const double *, const double *, double *,
                   double *, double *);
} fixed_width[WIDTH_FIXED] = {{factor_1, substitute_1, pencil_1},
                              {factor_2, substitute_2, pencil_2},
                              {factor_3, substitute_3, pencil_3},
                              {factor_4, substitute_4, pencil_4},
                              {factor_5, substitute_5, pencil_5}};

TARGET static void band_factor(int first, int end, int width, const double *k, const double *m,
                               double scale, const double *shift, double tiny, double *factor,
                               double *negative)
{
    const int is_fixed = width >= 1 && width <= WIDTH_FIXED;
    for (int b = 0; b < LANES; b += BLOCK) {
        if (is_fixed) {
            fixed_width[width - 1].factor(first, end, k, m, scale, shift + b, tiny, factor + b,
                                          negative + b);
        } else {
            factor_any(first, end, width, k, m, scale, shift + b, tiny, factor + b, negative + b);
        }
    }
}

TARGET static void band_substitute(int n, int width, int count, const double *factor, double *x)
{
    if (width < 1 || width > WIDTH_FIXED) {
        substitute_any(n, width, count, factor, x);
        return;
    }
    for (int b = 0; b < LANES; b += BLOCK) {
        fixed_width[width - 1].substitute(n, count, factor + b, x + b);
    }
}

TARGET static void band_pencil(int n, int width, const double *k, const double *m,
                               const double *lambda, const double *x, double *r, double *mx,
                               double *dot)
{
    const int is_fixed = width >= 1 && width <= WIDTH_FIXED;
    for (int b = 0; b < LANES; b += BLOCK) {
        if (is_fixed) {
            fixed_width[width - 1].pencil(n, k, m, lambda + b, x + b, r + b, mx + b, dot + b);
        } else {
            pencil_all(n, width, k, m, lambda + b, x + b, r + b, mx + b, dot + b);
        }
    }
}

TARGET static void lane_dot(int n, const double *x, const double *y, double *xy, double *xx)
{
    for (int g = 0; g < LANES / V_SIZE; g++) {
        v_double s = v_all(0.0), t = v_all(0.0);
        for (int i = 0; i < n; i++) {
            const v_double xi = v_load(x + (ptrdiff_t)i * LANES + g * V_SIZE);
            s = v_add_product(xi, v_load(y + (ptrdiff_t)i * LANES + g * V_SIZE), s);
            t = v_add_product(xi, xi, t);
        }
        v_store(xy + g * V_SIZE, s);
        v_store(xx + g * V_SIZE, t);
    }
}

TARGET static void lane_product(int n, size_t stride, const double *x, double *mantissa,
                                int64_t *exponent)
{
    const v_mask bias = v_all_bits(1023), field = v_all_bits(0x7ff);
    const v_mask fraction = ~(field << 52), one = bias << 52;
    for (int g = 0; g < LANES; g += V_SIZE) {
        v_double product = v_load(mantissa + g);
        v_mask power;
        memcpy(&power, exponent + g, sizeof power);
        for (int i = 0; i < n; i++) {
            product *= v_load(x + (size_t)i * stride + (size_t)g);
            if (i % 4 == 3 || i == n - 1) {
                const v_mask bits = (v_mask)product;
                power += ((bits >> 52) & field) - bias;
                product = (v_double)((bits & fraction) | one);
            }
        }
        v_store(mantissa + g, product);
        memcpy(exponent + g, &power, sizeof power);
    }
}
