#include "numeric/cone.h"

#include "core/elementary/elementary.h"
#include "core/vec3.h"

#include <math.h>
#include <string.h>

enum { HALVINGS = 60 };
static const double ridge = 1e-11;   /* near the top the matrix is singular to rounding */
static const double near_top = 0.02; /* of the decrement: what is left is less than its square */

static void clear_matrix(void *matrix)
{
    taut_band_clear(matrix);
}

taut_status taut_cone_new(int shared, int own, int blocks, int room, taut_arena *arena,
                          taut_cone *cone)
{
    const size_t seen = (size_t)shared + (size_t)own, count = (size_t)room;
    const int n = shared + blocks * own;

    *cone = (taut_cone){.shared = shared, .own = own, .blocks = blocks, .room = room};
    cone->rows = taut_arena_take(arena, count, 3 * seen * sizeof(double));
    cone->block = taut_arena_take(arena, count, sizeof(int));
    cone->at = taut_arena_take(arena, count, 6 * sizeof(double));
    cone->gram = taut_arena_take(arena, seen, seen * sizeof(double));
    cone->scratch = taut_arena_take(arena, seen, 4 * sizeof(double));
    cone->slope = taut_arena_take(arena, (size_t)n, sizeof(double));
    cone->step = taut_arena_take(arena, (size_t)n, sizeof(double));
    if (n - 1 >= TAUT_BAND_TILES_LEAST) {
        cone->tiles = taut_arena_take(arena, taut_band_tiles_work(n, n - 1), sizeof(double));
    }
    taut_band *kept = taut_arena_take(arena, 1, sizeof *kept);
    if (taut_arena_status(arena) != TAUT_OK || taut_band_init(n, n - 1, kept) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    cone->matrix = *kept;
    return taut_arena_keep(arena, kept, clear_matrix) ? TAUT_OK : TAUT_NO_MEMORY;
}

double *taut_cone_add(taut_cone *cone, int block)
{
    if (cone->count == cone->room) {
        return NULL;
    }
    cone->block[cone->count] = block;
    return cone->rows + 3 * (size_t)(cone->shared + cone->own) * (size_t)cone->count++;
}

/* How many numbers places of a block see. */
static int seen_by(const taut_cone *cone, int block)
{
    return cone->shared + (block < 0 ? 0 : cone->own);
}

/* Where number i that a block sees stands in x. */
static int place_of(const taut_cone *cone, int block, int i)
{
    return i < cone->shared ? i : i + block * cone->own;
}

void taut_cone_apply(const taut_cone *cone, const double *rows, int block, const double *x,
                     double y[3])
{
    const int length = cone->shared + cone->own;

    for (int r = 0; r < 3; r++) {
        const double *row = rows + (size_t)r * (size_t)length;
        double sum = 0;
        for (int i = 0; i < cone->shared; i++) {
            sum += row[i] * x[i];
        }
        const double *own = x + cone->shared + (block < 0 ? 0 : block * cone->own);
        for (int i = 0; block >= 0 && i < cone->own; i++) {
            sum += row[cone->shared + i] * own[i];
        }
        y[r] = sum;
    }
}

static const double *rows_of(const taut_cone *cone, int place)
{
    return cone->rows + 3 * (size_t)(cone->shared + cone->own) * (size_t)place;
}

static void apply_all(const taut_cone *cone, const double *x, double *at)
{
    for (int k = 0; k < cone->count; k++) {
        taut_cone_apply(cone, rows_of(cone, k), cone->block[k], x, at + 3 * (size_t)k);
    }
}

/* The barrier at x + share step beside b.x / mu, or -infinity outside. */
static double height_at(const taut_cone *cone, double share, double along)
{
    const double *y = cone->at, *d = cone->at + 3 * (size_t)cone->room;
    double sum = 0, product = 1;

    for (int k = 0; k < cone->count; k++) {
        double to[3];
        for (int c = 0; c < 3; c++) {
            to[c] = y[3 * k + c] + share * d[3 * k + c];
        }
        const double left = 1 - taut_dot(to, to);
        if (!(left > 0x1p-50)) {
            return -INFINITY;
        }
        product *= left;
        if (product < 0x1p-500) {
            sum += taut_log(product);
            product = 1;
        }
    }
    return sum + taut_log(product) + share * along;
}

/* gram += R'R for three rows R, lower triangle. */
static void add_rows(int length, const double *restrict r0, const double *restrict r1,
                     const double *restrict r2, double *restrict gram)
{
    for (int i = 0; i < length; i++) {
        const double a = r0[i], b = r1[i], c = r2[i];
        double *restrict row = gram + (size_t)i * (size_t)length;
        for (int j = 0; j <= i; j++) {
            row[j] += a * r0[j] + b * r1[j] + c * r2[j];
        }
    }
}

/* What a place adds to the slope and to minus the second derivative, A' (2/d + 4/d^2 y y') A with d = 1 - y.y:
 * the matrix in the middle is the square of sqrt(2/d) (1 + k y y'), k = (sqrt(1 + 2 y.y / d) - 1) / y.y. */
static void add_place(taut_cone *cone, int k, int length, double *slope)
{
    const size_t stride = (size_t)(cone->shared + cone->own);
    const double *rows = rows_of(cone, k), *y = cone->at + 3 * (size_t)k;
    const double square = taut_dot(y, y), left = 1 - square, root = sqrt(2 / left);
    const double more = 2 / left / (1 + sqrt(1 + 2 * square / left)); /* k */
    double *restrict along = cone->scratch;

    for (int i = 0; i < length; i++) {
        along[i] =
            y[0] * rows[i] + y[1] * rows[stride + (size_t)i] + y[2] * rows[2 * stride + (size_t)i];
        slope[i] -= 2 / left * along[i];
    }
    for (int r = 0; r < 3; r++) {
        double *restrict out = cone->scratch + (size_t)(r + 1) * stride;
        const double *row = rows + (size_t)r * stride;
        for (int i = 0; i < length; i++) {
            out[i] = root * (row[i] + more * y[r] * along[i]);
        }
    }
    add_rows(length, cone->scratch + stride, cone->scratch + 2 * stride, cone->scratch + 3 * stride,
             cone->gram);
}

/* All places of a block, into the slope and the matrix. */
static void add_block(taut_cone *cone, int block, double *slope)
{
    const int length = seen_by(cone, block);

    memset(cone->gram, 0, (size_t)length * (size_t)length * sizeof(double));
    memset(slope, 0, (size_t)length * sizeof(double));
    for (int k = 0; k < cone->count; k++) {
        if (cone->block[k] == block) {
            add_place(cone, k, length, slope);
        }
    }
    for (int i = 0; i < length; i++) {
        const int at = place_of(cone, block, i);
        double *row = taut_band_row(&cone->matrix, at);
        cone->slope[at] += slope[i];
        for (int j = 0; j <= i; j++) {
            row[at - place_of(cone, block, j)] +=
                cone->gram[(size_t)i * (size_t)length + (size_t)j];
        }
    }
}

/* Newton's step, and the decrement. */
static taut_status find_step(taut_cone *cone, const double *b, double mu, taut_pulse *pulse,
                             double *decrement)
{
    const size_t n = (size_t)cone->matrix.n;
    double square = 0;

    memset(cone->matrix.a, 0, n * n * sizeof(double));
    for (size_t i = 0; i < n; i++) {
        cone->slope[i] = b[i] / mu;
    }
    for (int block = -1; block < cone->blocks; block++) {
        add_block(cone, block, cone->step);
    }
    for (int i = 0; i < cone->matrix.n; i++) {
        taut_band_row(&cone->matrix, i)[0] *= 1 + ridge;
    }
    const taut_status status = cone->tiles != NULL
                                   ? taut_band_factor_tiled(&cone->matrix, cone->tiles, pulse)
                                   : taut_band_factor(&cone->matrix);
    if (status != TAUT_OK) {
        return status;
    }
    memcpy(cone->step, cone->slope, n * sizeof(double));
    taut_band_solve(&cone->matrix, 1, cone->step);
    for (size_t i = 0; i < n; i++) {
        square += cone->slope[i] * cone->step[i];
    }
    *decrement = sqrt(square);
    return isfinite(square) ? TAUT_OK : TAUT_NO_SOLUTION;
}

/* As much of the step as leads upwards; 0: none does. */
static double share_of(const taut_cone *cone, const double *b, double mu)
{
    double along = 0, share = 1;

    for (int i = 0; i < cone->matrix.n; i++) {
        along += b[i] * cone->step[i] / mu;
    }
    const double before = height_at(cone, 0, along);
    for (int k = 0; k < HALVINGS; k++, share *= 0.5) {
        if (height_at(cone, share, along) > before) {
            return share;
        }
    }
    return 0;
}

taut_status taut_cone_climb(taut_cone *cone, const double *b, double mu, int steps, double *x,
                            taut_pulse *pulse)
{
    const double seen = cone->shared + cone->own;
    double decrement = INFINITY;

    apply_all(cone, x, cone->at);
    for (int k = 0; k < steps && decrement > near_top; k++) {
        if (taut_pulse_beat(pulse, 3 * cone->count * seen * seen)) {
            return TAUT_INTERRUPTED;
        }
        const taut_status status = find_step(cone, b, mu, pulse, &decrement);
        if (status != TAUT_OK) {
            return status;
        }
        apply_all(cone, cone->step, cone->at + 3 * (size_t)cone->room);
        const double share = share_of(cone, b, mu);
        if (!(share > 0)) {
            break; /* rounding is all that is left */
        }
        for (int i = 0; i < cone->matrix.n; i++) {
            x[i] += share * cone->step[i];
        }
        for (int i = 0; i < 3 * cone->count; i++) {
            cone->at[i] += share * cone->at[3 * (size_t)cone->room + (size_t)i];
        }
    }
    return TAUT_OK;
}
