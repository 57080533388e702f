/* vector_body.h -- loops over long vectors of any length and alignment. */

/* The last count % V_SIZE entries, filled up with zeros. */
INLINE v_double v_load_some(const double *from, size_t count)
{
    v_double v = v_all(0.0);
    memcpy(&v, from, count * sizeof *from);
    return v;
}

INLINE void v_store_some(double *to, v_double v, size_t count)
{
    memcpy(to, &v, count * sizeof *to);
}

TARGET static double dot(size_t count, const double *x, const double *y)
{
    v_double sum[4] = {v_all(0.0), v_all(0.0), v_all(0.0), v_all(0.0)};
    size_t i = 0;
    for (; i + 4 * V_SIZE <= count; i += 4 * V_SIZE) {
        for (int g = 0; g < 4; g++) {
            sum[g] = v_fma(v_load(x + i + g * V_SIZE), v_load(y + i + g * V_SIZE), sum[g]);
        }
    }
    for (; i < count; i += V_SIZE) {
        const size_t some = count - i < V_SIZE ? count - i : V_SIZE;
        sum[0] = v_fma(v_load_some(x + i, some), v_load_some(y + i, some), sum[0]);
    }
    double part[V_SIZE], total = 0.0;
    v_store(part, (sum[0] + sum[1]) + (sum[2] + sum[3]));
    for (int l = 0; l < V_SIZE; l++) {
        total += part[l];
    }
    return total;
}

/* Row i of the product; what lies outside the matrix is left out. */
INLINE double diagonals_row(size_t n, size_t width, const double *a, const double *x, size_t i)
{
    double sum = a[i] * x[i];
    for (size_t d = 1; d <= width && d <= i; d++) {
        sum += a[d * n + i] * x[i - d];
    }
    for (size_t d = 1; d <= width && d < n - i; d++) {
        sum += a[d * n + i + d] * x[i + d];
    }
    return sum;
}

TARGET static void diagonals_multiply(size_t n, size_t width, const double *a, const double *x,
                                      double *y)
{
    size_t i = 0;
    for (; i < n && i < width; i++) {
        y[i] = diagonals_row(n, width, a, x, i);
    }
    for (; i + V_SIZE + width <= n; i += V_SIZE) {
        v_double sum = v_load(a + i) * v_load(x + i);
        for (size_t d = 1; d <= width; d++) {
            sum = v_fma(v_load(a + d * n + i), v_load(x + i - d), sum);
            sum = v_fma(v_load(a + d * n + i + d), v_load(x + i + d), sum);
        }
        v_store(y + i, sum);
    }
    for (; i < n; i++) {
        y[i] = diagonals_row(n, width, a, x, i);
    }
}

TARGET static void add_scaled(size_t count, double factor, const double *x, double *y)
{
    const v_double f = v_all(factor);
    size_t i = 0;
    for (; i + V_SIZE <= count; i += V_SIZE) {
        v_store(y + i, v_fma(f, v_load(x + i), v_load(y + i)));
    }
    const v_double last = v_fma(f, v_load_some(x + i, count - i), v_load_some(y + i, count - i));
    v_store_some(y + i, last, count - i);
}

TARGET static void add_products(size_t count, const double *c, const double *x, double *y)
{
    size_t i = 0;
    for (; i + V_SIZE <= count; i += V_SIZE) {
        v_store(y + i, v_fma(v_load(c + i), v_load(x + i), v_load(y + i)));
    }
    const v_double last = v_fma(v_load_some(c + i, count - i), v_load_some(x + i, count - i),
                                v_load_some(y + i, count - i));
    v_store_some(y + i, last, count - i);
}

/* high + low += a b + extra: the product and the sum are taken with their rounding errors
 * ([Dekker1971], [Knuth1998] 4.2.2), which go to low. */
INLINE void add_exactly(v_double a, v_double b, v_double extra, v_double *high, v_double *low)
{
    const v_double product = a * b;
    const v_double sum = *high + product;
    const v_double moved = sum - *high;
    const v_double error = (*high - (sum - moved)) + (product - moved);
    *low += (error + v_product_error(a, b, product)) + extra;
    *high = sum;
}

TARGET static void add_scaled_exactly(size_t count, double factor, const double *x,
                                      const double *x_low, double *high, double *low)
{
    const v_double f = v_all(factor);
    size_t i = 0;
    for (; i + V_SIZE <= count; i += V_SIZE) {
        v_double h = v_load(high + i), l = v_load(low + i);
        add_exactly(f, v_load(x + i), f * v_load(x_low + i), &h, &l);
        v_store(high + i, h);
        v_store(low + i, l);
    }
    v_double h = v_load_some(high + i, count - i), l = v_load_some(low + i, count - i);
    const v_double tail = f * v_load_some(x_low + i, count - i);
    add_exactly(f, v_load_some(x + i, count - i), tail, &h, &l);
    v_store_some(high + i, h, count - i);
    v_store_some(low + i, l, count - i);
}

TARGET static void add_products_exactly(size_t count, const double *c, const double *x,
                                        double *high, double *low)
{
    const v_double none = v_all(0.0);
    size_t i = 0;
    for (; i + V_SIZE <= count; i += V_SIZE) {
        v_double h = v_load(high + i), l = v_load(low + i);
        add_exactly(v_load(c + i), v_load(x + i), none, &h, &l);
        v_store(high + i, h);
        v_store(low + i, l);
    }
    v_double h = v_load_some(high + i, count - i), l = v_load_some(low + i, count - i);
    add_exactly(v_load_some(c + i, count - i), v_load_some(x + i, count - i), none, &h, &l);
    v_store_some(high + i, h, count - i);
    v_store_some(low + i, l, count - i);
}
