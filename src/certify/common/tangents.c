/* tangents.c -- how far R_u and R_v stay from being parallel.
 *
 * For any two vectors p, q
 *
 *     (A x B) . (p x q) = (A.p) (B.q) - (A.q) (B.p),
 *
 * so that wherever A.p > 0 and B.q > 0
 *
 *     sin = |A x B| / (|A| |B|) >= (1 - a b) / (|p x q| c d),
 *     a = A.q / A.p,   b = B.p / B.q,   c = |A| / A.p,   d = |B| / B.q.
 *
 * Each of the four is a quotient of Bernstein polynomials with a positive denominator (|A| at most
 * the sum of |A_ij| B[i] B[j]), hence between the least and the largest quotient of coefficients.
 * p and q are taken dual to the middle directions of A and B: then a and b are near 0 however small
 * the angle between them is, and an affine map that squeezes the surface costs nothing.
 *
 * Errors. A coefficient is right to `error` times its majorant M. Halving takes means: of M too, and
 * each rounds by one unit roundoff at most, so that p levels add 2 p of them to `error`
 * (one for the coordinate, one for M).
 */
#include "certify/common/tangents.h"

#include "core/constants.h"
#include "core/vec3.h"

#include <float.h>
#include <string.h>

static const double first_error = 8 * TAUT_UNIT_ROUNDOFF;
static const double floor_of_majorant = 1e-280; /* covers what underflows */
static const double floor_of_length = 1e-153;   /* the same, of squares */
static const double slack = 1 + 0x1p-40;        /* over the rounding of a formula here */

enum { PLANES = 4, MAJORANT = 3 };

static size_t row_of(const taut_tangents *t, int k)
{
    return (size_t)PLANES * (size_t)(t->q[k] + 1);
}

size_t taut_tangents_size(const taut_tangents *t)
{
    return (size_t)(t->p[0] + 1) * row_of(t, 0) + (size_t)(t->p[1] + 1) * row_of(t, 1);
}

void taut_tangents_place(taut_tangents *t, double *block)
{
    t->a[0] = block;
    t->a[1] = block + (size_t)(t->p[0] + 1) * row_of(t, 0);
}

/* ---- from a piece ---- */

/* A or B: components of w X' - w' X, each with its running error. The terms of highest degree cancel,
 * as X = (1-t) lo + t up and X' = p (up - lo) of degree p - 1:  w X' - w' X = p (lo_w up - up_w lo). */
static void take_part(const taut_field *f, int direction, int up, taut_arena *arena,
                      taut_field *out)
{
    const int p = f->p - (direction == 0 && f->p > 0), q = f->q - (direction == 1 && f->q > 0);
    *out = f->a != NULL ? taut_field_new(arena, p, q) : *f;
    for (int i = 0; out->a != NULL && i <= p; i++) {
        const size_t from = (size_t)(i + (direction == 0 && up && f->p > 0)) * (size_t)(f->q + 1) +
                            (size_t)(direction == 1 && up && f->q > 0);
        memcpy(out->a + (size_t)i * (size_t)(q + 1), f->a + from, (size_t)(q + 1) * sizeof(double));
        memcpy(out->e + (size_t)i * (size_t)(q + 1), f->e + from, (size_t)(q + 1) * sizeof(double));
    }
}

static void fill_direction(taut_arena *arena, const taut_field piece[4], int direction,
                           taut_field out[3])
{
    taut_field low[4], high[4];
    if (piece[3].p == 0 && piece[3].q == 0) {
        for (int k = 0; k < 3; k++) {
            out[k] =
                direction == 0 ? taut_field_du(arena, &piece[k]) : taut_field_dv(arena, &piece[k]);
        }
        return;
    }
    for (int k = 0; k < 4; k++) {
        take_part(&piece[k], direction, 0, arena, &low[k]);
        take_part(&piece[k], direction, 1, arena, &high[k]);
    }
    for (int k = 0; k < 3; k++) {
        const taut_field gain = taut_field_product(arena, &low[3], &high[k]);
        const taut_field loss = taut_field_product(arena, &high[3], &low[k]);
        out[k] = taut_field_difference(arena, &gain, &loss);
    }
}

/* One of them, and its majorants. 0 where a number is not finite. */
static int pack(const taut_field from[3], int q, double *to)
{
    const int p = from[0].p;
    int finite = 1;
    for (int i = 0; i <= p; i++) {
        double *const row = to + (size_t)i * PLANES * (size_t)(q + 1);
        for (int j = 0; j <= q; j++) {
            const size_t at = (size_t)i * (size_t)(q + 1) + (size_t)j;
            double majorant = floor_of_majorant;
            for (int k = 0; k < 3; k++) {
                row[k * (q + 1) + j] = from[k].a[at];
                majorant += fabs(from[k].a[at]) + from[k].e[at] / first_error;
            }
            row[MAJORANT * (q + 1) + j] = slack * majorant;
            finite = finite && isfinite(majorant);
        }
    }
    return finite;
}

int taut_tangents_of(taut_arena *arena, const taut_field piece[4], taut_tangents *t)
{
    taut_field f[2][3];
    double *block = NULL;
    int finite = 1;
    for (int k = 0; k < 2; k++) {
        fill_direction(arena, piece, k, f[k]);
        t->p[k] = f[k][0].p;
        t->q[k] = f[k][0].q;
    }
    t->error = first_error;
    block = taut_arena_take_raw(arena, taut_tangents_size(t), sizeof *block);
    if (block == NULL || taut_arena_status(arena) != TAUT_OK) {
        return 0;
    }
    taut_tangents_place(t, block);
    for (int k = 0; k < 2; k++) {
        if (f[k][0].a == NULL || f[k][1].a == NULL || f[k][2].a == NULL ||
            !pack(f[k], t->q[k], t->a[k])) {
            finite = 0;
        }
    }
    return finite;
}

/* ---- halves ---- */

/* De Casteljau's algorithm on rows of `width` numbers, `count` of them. */
static void halve_rows(int count, size_t width, double *a, double *low)
{
    for (int level = 0; level < count; level++) {
        memcpy(low + (size_t)level * width, a, width * sizeof *a);
        for (int i = 0; i + 1 < count - level; i++) {
            double *const x = a + (size_t)i * width;
            const double *const next = x + width;
            for (size_t k = 0; k < width; k++) {
                x[k] = 0.5 * x[k] + 0.5 * next[k];
            }
        }
    }
}

/* The same along lines of consecutive numbers. */
static void halve_lines(size_t lines, int count, double *a, double *low)
{
    for (size_t k = 0; k < lines; k++) {
        double *const x = a + k * (size_t)count, *const out = low + k * (size_t)count;
        for (int level = 0; level < count; level++) {
            out[level] = x[0];
            for (int i = 0; i + 1 < count - level; i++) {
                x[i] = 0.5 * x[i] + 0.5 * x[i + 1];
            }
        }
    }
}

void taut_tangents_halve(taut_tangents *t, int direction, double *block, taut_tangents *low)
{
    int degree = 0;
    *low = *t;
    taut_tangents_place(low, block);
    for (int k = 0; k < 2; k++) {
        if (direction == 0) {
            halve_rows(t->p[k] + 1, row_of(t, k), t->a[k], low->a[k]);
        } else {
            halve_lines((size_t)PLANES * (size_t)(t->p[k] + 1), t->q[k] + 1, t->a[k], low->a[k]);
        }
        degree = (direction == 0 ? t->p[k] : t->q[k]) > degree ? direction == 0 ? t->p[k] : t->q[k]
                                                               : degree;
    }
    t->error += 2 * degree * TAUT_UNIT_ROUNDOFF;
    low->error = t->error;
}

/* ---- the bound ---- */

static void take_coefficient(const taut_tangents *t, int k, int i, int j, double x[3])
{
    const double *const at = t->a[k] + (size_t)i * row_of(t, k) + j;
    for (int c = 0; c < 3; c++) {
        x[c] = at[(size_t)c * (size_t)(t->q[k] + 1)];
    }
}

/* The sum of the directions of the coefficients of A (or B), as one direction; 0 where it has none. */
static void middle_direction(const taut_tangents *t, int k, double middle[3])
{
    double length = 0;
    memset(middle, 0, 3 * sizeof *middle);
    for (int i = 0; i <= t->p[k]; i++) {
        for (int j = 0; j <= t->q[k]; j++) {
            double x[3];
            take_coefficient(t, k, i, j, x);
            length = taut_length(x);
            if (length > 0) {
                taut_add_scaled(1 / length, x, middle);
            }
        }
    }
    length = taut_length(middle);
    for (int c = 0; c < 3; c++) {
        middle[c] = length > 0 ? middle[c] / length : 0;
    }
}

/* Of A: least and largest x.q / x.p over its coefficients, and the largest |x| / x.p; of B with p and
 * q for each other. */
typedef struct quotients {
    double least, most, length;
} quotients;

/* 0 where x.p may vanish. */
static int take_quotients(const taut_tangents *t, int k, const double p[3], const double q[3],
                          quotients *found)
{
    const int columns = t->q[k] + 1;
    const double p_size = fabs(p[0]) + fabs(p[1]) + fabs(p[2]);
    const double q_size = fabs(q[0]) + fabs(q[1]) + fabs(q[2]);
    const double share = slack * (t->error + 8 * TAUT_UNIT_ROUNDOFF);
    quotients f = {INFINITY, -INFINITY, 0};
    for (int i = 0; i <= t->p[k]; i++) {
        const double *const x = t->a[k] + (size_t)i * row_of(t, k);
        const double *const y = x + columns, *const z = y + columns, *const m = z + columns;
        for (int j = 0; j < columns; j++) {
            const double error = share * m[j];
            const double along = x[j] * p[0] + y[j] * p[1] + z[j] * p[2];
            const double beside = x[j] * q[0] + y[j] * q[1] + z[j] * q[2];
            const double length = sqrt(x[j] * x[j] + y[j] * y[j] + z[j] * z[j]);
            const double least = along - error * p_size;
            const double over = 1 / least, low = beside - error * q_size;
            const double high = beside + error * q_size;
            if (!(least > 0)) {
                return 0;
            }
            /* where beside has the other sign the larger denominator is the nearer bound; the
             * smaller one is right too */
            f.least =
                low < 0 ? fmin(f.least, low * over) : fmin(f.least, low / (along + error * p_size));
            f.most = high > 0 ? fmax(f.most, high * over)
                              : fmax(f.most, high / (along + error * p_size));
            f.length = fmax(f.length, (length + 2 * error + floor_of_length) * over);
        }
    }
    *found = f;
    return isfinite(f.least) && isfinite(f.most) && isfinite(f.length);
}

/* How much the direction of A (or B) changes from one end to the other over u and over v, along the
 * outermost lines and the middle one; p, q not both 0: in their plane too. */
static void add_turning(const taut_tangents *t, int k, const double p[3], const double q[3],
                        double turning[2])
{
    double d[3][3][5];
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            double x[3];
            take_coefficient(t, k, i * t->p[k] / 2, j * t->q[k] / 2, x);
            const double along = taut_dot(x, p), beside = taut_dot(x, q);
            const double length = taut_length(x), size = sqrt(along * along + beside * beside);
            for (int c = 0; c < 3; c++) {
                d[i][j][c] = length > 0 ? x[c] / length : 0;
            }
            d[i][j][3] = size > 0 ? along / size : 0;
            d[i][j][4] = size > 0 ? beside / size : 0;
        }
    }
    for (int line = 0; line < 3; line++) {
        for (int step = 0; step < 2; step++) {
            for (int c = 0; c < 5; c++) {
                turning[0] += fabs(d[step + 1][line][c] - d[step][line][c]);
                turning[1] += fabs(d[line][step + 1][c] - d[line][step][c]);
            }
        }
    }
}

double taut_tangents_bound(const taut_tangents *t, int *direction)
{
    double a[3], b[3], normal[3], p[3], q[3], area[3], turning[2] = {0, 0}, product = 0;
    double square = 0;
    quotients of[2];
    middle_direction(t, 0, a);
    middle_direction(t, 1, b);
    taut_cross(a, b, normal);
    taut_cross(b, normal, p);
    taut_cross(normal, a, q);
    square = taut_dot(normal, normal);
    for (int c = 0; c < 3; c++) {
        p[c] = square > 0 ? p[c] / square : 0;
        q[c] = square > 0 ? q[c] / square : 0;
    }
    add_turning(t, 0, p, q, turning);
    add_turning(t, 1, p, q, turning);
    *direction = turning[1] > turning[0];
    if (!(square > 0) || !take_quotients(t, 0, p, q, &of[0]) ||
        !take_quotients(t, 1, q, p, &of[1])) {
        return 0;
    }
    product = fmax(fmax(of[0].least * of[1].least, of[0].most * of[1].most),
                   fmax(of[0].least * of[1].most, of[0].most * of[1].least));
    taut_cross(p, q, area);
    /* 64 roundings at most, and those of p x q relative to |p| |q| */
    product =
        (1 - product - 64 * TAUT_UNIT_ROUNDOFF * (1 + fabs(product))) /
        (slack * (taut_length(area) + 8 * TAUT_UNIT_ROUNDOFF * taut_length(p) * taut_length(q)) *
         of[0].length * of[1].length);
    return product > 0 ? fmin(product, 1) : 0; /* NaN is 0 */
}

/* ---- at a point ---- */

double taut_tangents_sine(double x[2][3], const double error[2], double *most)
{
    double unit[2][3], share[2], normal[3], area = 0;
    *most = 1;
    for (int k = 0; k < 2; k++) {
        const double length = taut_norm(x[k]);
        if (!(length > 0) || !isfinite(length)) {
            return NAN;
        }
        for (int c = 0; c < 3; c++) {
            unit[k][c] = x[k][c] / length;
        }
        share[k] = 2 * error[k] / length + 4 * TAUT_UNIT_ROUNDOFF;
    }
    taut_cross(unit[0], unit[1], normal);
    area = taut_length(normal);
    if (share[0] < 0.5 && share[1] < 0.5) {
        *most =
            fmin(1, slack * (area + 8 * TAUT_UNIT_ROUNDOFF + share[0] * (1 + share[1]) + share[1]) /
                        ((1 - share[0]) * (1 - share[1])));
    }
    return area;
}

double taut_tangents_corner(const taut_tangents *t, int i, int j, double *sine_most)
{
    double x[2][3], error[2];
    for (int k = 0; k < 2; k++) {
        const int row = i == 0 ? 0 : t->p[k], column = j == 0 ? 0 : t->q[k];
        take_coefficient(t, k, row, column, x[k]);
        error[k] =
            slack * t->error *
            t->a[k][(size_t)row * row_of(t, k) + MAJORANT * (size_t)(t->q[k] + 1) + (size_t)column];
    }
    return taut_tangents_sine(x, error, sine_most);
}

/* b[order][i], order 0 and 1, each to 4 degree roundings of the sum of what it is made from. */
static void fill_values(int degree, double t, double *b, double *slope)
{
    b[0] = 1;
    slope[0] = 0;
    for (int m = 1; m <= degree; m++) {
        double carried = 0;
        if (m == degree) {
            for (int i = 0; i <= degree; i++) {
                slope[i] = degree * ((i > 0 ? b[i - 1] : 0) - (i < degree ? b[i] : 0));
            }
        }
        for (int i = 0; i < m; i++) {
            const double lower = b[i];
            b[i] = (1 - t) * lower + carried;
            carried = t * lower;
        }
        b[m] = carried;
    }
}

void taut_tangents_grid(const taut_tangents *t, int count, const double *u, const double *v,
                        double *sines)
{
    double b[2][2 * TAUT_FIELD_DEGREE + 1], line[2][PLANES * (2 * TAUT_FIELD_DEGREE + 1)];
    for (int i = 0; i < count; i++) {
        for (int k = 0; k < 2; k++) {
            fill_values(t->p[k], u[i], b[0], b[1]);
            memset(line[k], 0, row_of(t, k) * sizeof(double));
            for (int r = 0; r <= t->p[k]; r++) {
                const double *const row = t->a[k] + (size_t)r * row_of(t, k);
                for (size_t c = 0; c < row_of(t, k); c++) {
                    line[k][c] += b[0][r] * row[c];
                }
            }
        }
        for (int j = 0; j < count; j++) {
            const double none[2] = {0, 0};
            double x[2][3], most = 0;
            for (int k = 0; k < 2; k++) {
                const int columns = t->q[k] + 1;
                fill_values(t->q[k], v[j], b[0], b[1]);
                for (int c = 0; c < 3; c++) {
                    x[k][c] = 0;
                    for (int l = 0; l < columns; l++) {
                        x[k][c] += b[0][l] * line[k][c * columns + l];
                    }
                }
            }
            sines[i * count + j] = taut_tangents_sine(x, none, &most);
        }
    }
}

void taut_tangents_at(const taut_tangents *t, double u, double v, taut_tangent_pair *pair)
{
    double b[4][2 * TAUT_FIELD_DEGREE + 1];
    memset(pair, 0, sizeof *pair);
    for (int k = 0; k < 2; k++) {
        const int columns = t->q[k] + 1;
        double majorant = 0;
        fill_values(t->p[k], u, b[0], b[1]);
        fill_values(t->q[k], v, b[2], b[3]);
        for (int i = 0; i <= t->p[k]; i++) {
            const double *const row = t->a[k] + (size_t)i * row_of(t, k);
            for (int c = 0; c < PLANES; c++) {
                double value = 0, change = 0;
                for (int j = 0; j < columns; j++) {
                    value += b[2][j] * row[c * columns + j];
                    change += b[3][j] * row[c * columns + j];
                }
                if (c == MAJORANT) {
                    majorant += b[0][i] * value;
                } else {
                    pair->x[k][c] += b[0][i] * value;
                    pair->du[k][c] += b[1][i] * value;
                    pair->dv[k][c] += b[0][i] * change;
                }
            }
        }
        pair->error[k] =
            slack * majorant * (t->error + TAUT_UNIT_ROUNDOFF * (5.0 * (t->p[k] + t->q[k]) + 8));
    }
    pair->sine = taut_tangents_sine(pair->x, pair->error, &pair->sine_most);
}
