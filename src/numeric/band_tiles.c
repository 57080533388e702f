/* band_tiles.c -- the factors of band.h for wide bands, with the matrix product kernel: columns are
 * taken in blocks K of DEPTH, and what is right of a block is mended by it at once,
 *
 *     u(i,j) = A(i,j) - sum_k u(i,k) L(j,k),    L(i,j) = u(i,j) / D(j),    j, k in K, k < j
 *     A(i,j) -= sum_k u(i,k) L(j,k),    k in K,    for all i >= j behind K
 *
 * ([GolubVanLoan2013] 4.2.9): the second line is a product of matrices, computed in tiles that stay
 * in registers.
 */
#include "numeric/band.h"

#include "core/constants.h"
#include "numeric/kernel/kernel.h"

#include <assert.h>
#include <string.h>

enum { DEPTH = 32, PAD = 64 }; /* PAD: more than a tile is wide, so that the last may stick out */

/* Of one block of columns first..end-1. Row r of the rest is row end + r of the matrix. */
typedef struct block {
    taut_band *band;
    const taut_kernel *kernel;
    int first, end;
    int rest;       /* rows behind the block that it reaches */
    size_t stride;  /* of u, over rows of the rest */
    double *u;      /* [DEPTH][stride]: u(i, k), zero outside the band */
    double *left;   /* tiles of -u: [tiles][DEPTH][tile_rows] */
    double *right;  /* tiles of L, columns the other way round: [tiles][DEPTH][tile_columns] */
    double *before; /* [n]: the diagonal as it was given */
} block;

static size_t stride_for(int width)
{
    return ((size_t)width + 2 * PAD) / PAD * PAD;
}

size_t taut_band_tiles_work(int n, int width)
{
    return 3 * DEPTH * stride_for(width) + (size_t)n;
}

/* The factors of the block's own rows and columns. */
static taut_status factor_corner(const block *b)
{
    for (int i = b->first; i < b->end; i++) {
        double *row = taut_band_row(b->band, i);
        const int reach = i - b->first;
        for (int d = reach - 1; d >= 1; d--) {
            const double *upper = taut_band_row(b->band, i - d);
            for (int e = reach; e > d; e--) {
                row[d] -= row[e] * upper[e - d];
            }
        }
        for (int d = reach; d >= 1; d--) {
            const double u = row[d];
            row[d] = u / taut_band_row(b->band, i - d)[0];
            row[0] -= u * row[d];
        }
        if (!(row[0] > 8.0 * b->band->n * TAUT_UNIT_ROUNDOFF * b->before[i])) {
            return TAUT_NO_SOLUTION;
        }
    }
    return TAUT_OK;
}

/* u of the rest, a column at a time; L goes back to the band. */
static void factor_panel(const block *b)
{
    const int width = b->band->width;
    const size_t rest = (size_t)b->rest;

    memset(b->u, 0, DEPTH * b->stride * sizeof(double));
    for (int r = 0; r < b->rest; r++) {
        const double *row = taut_band_row(b->band, b->end + r);
        for (int j = b->end - 1; j >= b->first && b->end + r - j <= width; j--) {
            b->u[(size_t)(j - b->first) * b->stride + (size_t)r] = row[b->end + r - j];
        }
    }
    for (int j = b->first; j < b->end; j++) {
        const double *row = taut_band_row(b->band, j);
        double *uj = b->u + (size_t)(j - b->first) * b->stride;
        for (int k = b->first; k < j; k++) {
            b->kernel->add_scaled(rest, -row[j - k], b->u + (size_t)(k - b->first) * b->stride, uj);
        }
    }
}

/* -u of column k of the block as tiles, the last of which may stick out. */
static void pack_left(const block *b, size_t k)
{
    const size_t rows = (size_t)b->kernel->tile_rows, depth = (size_t)(b->end - b->first);
    const double *u = b->u + k * b->stride;

    for (size_t r = 0; r < (size_t)b->rest + rows; r += rows) {
        double *tile = b->left + r * depth + k * rows;
        for (size_t c = 0; c < rows; c++) {
            tile[c] = -u[r + c];
        }
    }
}

/* The same of L = u / D, columns the other way round; L to the band as well. */
static void pack_right(const block *b, size_t k)
{
    const size_t columns = (size_t)b->kernel->tile_columns, depth = (size_t)(b->end - b->first);
    const size_t width = (size_t)b->band->width, column = (size_t)b->first + k;
    const size_t reach = width - ((size_t)b->end - column) + 1; /* rows within the band */
    const size_t rest = (size_t)b->rest < reach ? (size_t)b->rest : reach;
    const double *u = b->u + k * b->stride;
    const double pivot = taut_band_row(b->band, (int)column)[0];
    double *below = taut_band_row(b->band, b->end) + ((size_t)b->end - column);

    for (size_t q = 0; q < (size_t)b->rest + columns; q += columns) {
        double *tile = b->right + q * depth + k * columns;
        for (size_t c = 0; c < columns; c++) {
            tile[columns - 1 - c] = u[q + c] / pivot;
        }
        for (size_t c = 0; c < columns && q + c < rest; c++, below += width + 2) {
            *below = tile[columns - 1 - c];
        }
    }
}

/* u and L = u / D as tiles. */
static void pack_tiles(const block *b)
{
    for (size_t k = 0; b->rest > 0 && k < (size_t)(b->end - b->first); k++) {
        pack_left(b, k);
        pack_right(b, k);
    }
}

/* A(i, i - d) lies at i (width + 2) - (i - d): backwards along its row. What a tile has above the
 * diagonal or behind the last row is left out. */
static void update_tile(const block *b, int r, int q, const double *left, const double *right)
{
    const int rows = b->kernel->tile_rows, columns = b->kernel->tile_columns;
    const size_t depth = (size_t)(b->end - b->first), stride = (size_t)b->band->width + 1;
    const int last = q + columns - 1; /* the tile's first column: they run backwards */
    double edge[TAUT_TILE_ROWS_MAX * TAUT_TILE_COLUMNS_MAX];

    if (last <= r && r + rows <= b->rest) {
        double *c = taut_band_row(b->band, b->end + r) + (r - last);
        b->kernel->tile(depth, left, right, c, stride + 1);
        return;
    }
    memset(edge, 0, sizeof edge);
    for (int i = r; i < r + rows && i < b->rest; i++) {
        const double *row = taut_band_row(b->band, b->end + i);
        for (int j = i < last ? i : last; j >= q; j--) {
            edge[(i - r) * columns + (last - j)] = row[i - j];
        }
    }
    b->kernel->tile(depth, left, right, edge, (size_t)columns);
    for (int i = r; i < r + rows && i < b->rest; i++) {
        double *row = taut_band_row(b->band, b->end + i);
        for (int j = i < last ? i : last; j >= q; j--) {
            row[i - j] = edge[(i - r) * columns + (last - j)];
        }
    }
}

static taut_status update_rest(const block *b, taut_pulse *pulse)
{
    const int rows = b->kernel->tile_rows, columns = b->kernel->tile_columns;
    const size_t depth = (size_t)(b->end - b->first);

    for (int q = 0; q < b->rest; q += columns) {
        const double *right = b->right + (size_t)q * depth;
        if (taut_pulse_beat(pulse, 2.0 * columns * (double)depth * (b->rest - q))) {
            return TAUT_INTERRUPTED;
        }
        for (int r = q / rows * rows; r < b->rest; r += rows) {
            update_tile(b, r, q, b->left + (size_t)r * depth, right);
        }
    }
    return TAUT_OK;
}

taut_status taut_band_factor_tiled(taut_band *band, double *work, taut_pulse *pulse)
{
    const size_t stride = stride_for(band->width);
    block b = {.band = band, .kernel = taut_kernel_best(), .stride = stride, .u = work};

    assert(band->width >= TAUT_BAND_TILES_LEAST);
    b.left = b.u + DEPTH * stride;
    b.right = b.left + DEPTH * stride;
    b.before = b.right + DEPTH * stride;
    for (int i = 0; i < band->n; i++) {
        b.before[i] = taut_band_row(band, i)[0];
    }
    for (int first = 0; first < band->n; first = b.end) {
        const int left = band->n - first;
        b.first = first;
        b.end = first + (left < DEPTH ? left : DEPTH);
        b.rest = band->n - b.end < band->width ? band->n - b.end : band->width;
        if (factor_corner(&b) != TAUT_OK) {
            return TAUT_NO_SOLUTION;
        }
        factor_panel(&b);
        pack_tiles(&b);
        if (update_rest(&b, pulse) != TAUT_OK) {
            return TAUT_INTERRUPTED;
        }
    }
    return TAUT_OK;
}
