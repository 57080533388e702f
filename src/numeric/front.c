#include "numeric/front.h"

#include "numeric/kernel/kernel.h"

#include <math.h>
#include <string.h>

enum {
    DEPTH = 16, /* columns of a panel */
    PAD = 64    /* more than a tile is wide or high: it may stick out */
};

static const double pivot_least = 0x1p-45;

/* A panel: columns first .. first + depth - 1, of rows from first on. */
typedef struct panel {
    const taut_kernel *kernel;
    size_t rows, stride; /* of the front */
    double *front;
    size_t first, depth;
    size_t length; /* numbers from a column of the panel to the next */
    double *u;     /* [DEPTH][length]: the columns, L D */
    double *l;     /* [DEPTH][length]: L */
    double *left;  /* [DEPTH][tile_rows]: -u of some rows */
    double *right; /* tiles of L: [tiles][DEPTH][tile_columns] */
    double *began; /* [rows]: the diagonal as it was given */
} panel;

static size_t padded(size_t rows)
{
    return (rows + 2 * PAD) / PAD * PAD;
}

size_t taut_front_stride(size_t rows)
{
    return padded(rows);
}

size_t taut_front_size(size_t rows)
{
    return (rows + PAD) * padded(rows);
}

size_t taut_front_scratch(size_t rows)
{
    return 3 * DEPTH * padded(rows) + DEPTH * PAD + padded(rows);
}

void taut_front_clear(size_t rows, double *front)
{
    const size_t stride = taut_front_stride(rows), high = TAUT_TILE_ROWS_MAX,
                 wide = TAUT_TILE_COLUMNS_MAX;

    for (size_t i = 0; i < rows + high; i++) {
        memset(front + i * stride, 0,
               (i + high + wide < stride ? i + high + wide : stride) * sizeof(double));
    }
}

/* The panel's columns side by side, so that a row is no step away from the next. */
static void load(const panel *p)
{
    const size_t count = p->rows - p->first;

    for (size_t k = 0; k < p->depth; k++) {
        double *u = p->u + k * p->length;
        memset(u, 0, k * sizeof(double));
        for (size_t i = k; i < count; i++) {
            u[i] = p->front[(p->first + i) * p->stride + p->first + k];
        }
        memset(u + count, 0, (p->length - count) * sizeof(double));
    }
}

/* The panel's own columns: how many pivots are not positive. */
static int eliminate(const panel *p)
{
    const size_t count = p->rows - p->first;
    int negative = 0;

    for (size_t k = 0; k < p->depth; k++) {
        double *u = p->u + k * p->length, *l = p->l + k * p->length;
        const double began = p->began[p->first + k];
        if (!(fabs(u[k]) > pivot_least * began)) {
            u[k] = -pivot_least * (began > 0 ? began : 1);
        }
        negative += !(u[k] > 0);
        memset(l, 0, (k + 1) * sizeof(double));
        for (size_t i = k + 1; i < p->length; i++) {
            l[i] = u[i] / u[k];
        }
        for (size_t m = k + 1; m < p->depth; m++) {
            p->kernel->add_scaled(count - m, -l[m], u + m, p->u + m * p->length + m);
        }
    }
    return negative;
}

static void store(const panel *p)
{
    for (size_t i = 0; i < p->rows - p->first; i++) {
        double *row = p->front + (p->first + i) * p->stride + p->first;
        for (size_t k = 0; k < p->depth && k <= i; k++) {
            row[k] = k == i ? p->u[k * p->length + k] : p->l[k * p->length + i];
        }
    }
}

/* Of all rows and columns behind the panel: A(i, j) -= sum_k u(i, k) L(j, k). Nonzero once the pulse says stop. */
static int mend(const panel *p, taut_pulse *pulse)
{
    const size_t high = (size_t)p->kernel->tile_rows, wide = (size_t)p->kernel->tile_columns;
    const size_t behind = p->rows - p->first - p->depth, next = p->first + p->depth;
    const size_t tiles = (behind + wide - 1) / wide;

    for (size_t k = 0; k < p->depth; k++) {
        p->kernel->pack(tiles, p->l + k * p->length + p->depth, p->depth * wide,
                        p->right + k * wide);
    }
    for (size_t i = 0; i < behind; i += high) {
        for (size_t k = 0; k < p->depth; k++) {
            const double *u = p->u + k * p->length + p->depth + i;
            for (size_t r = 0; r < high; r++) {
                p->left[k * high + r] = -u[r];
            }
        }
        for (size_t t = 0; t * wide < i + high && t < tiles; t++) {
            p->kernel->tile(p->depth, p->left, p->right + t * p->depth * wide,
                            p->front + (next + i) * p->stride + next + t * wide, p->stride);
        }
        if (taut_pulse_beat(pulse, 2.0 * (double)(p->depth * high * (i + high)))) {
            return 1;
        }
    }
    return 0;
}

int taut_front_factor(size_t rows, size_t own, double *front, double *scratch, taut_pulse *pulse)
{
    const size_t length = padded(rows);
    panel p = {.kernel = taut_kernel_best(),
               .rows = rows,
               .stride = taut_front_stride(rows),
               .front = front,
               .length = length,
               .u = scratch,
               .l = scratch + DEPTH * length,
               .right = scratch + 2 * DEPTH * length,
               .left = scratch + 3 * DEPTH * length,
               .began = scratch + 3 * DEPTH * length + DEPTH * PAD};
    int negative = 0;

    for (size_t k = 0; k < own; k++) {
        p.began[k] = fabs(front[k * p.stride + k]);
    }
    for (; p.first < own; p.first += DEPTH) {
        p.depth = own - p.first < DEPTH ? own - p.first : DEPTH;
        load(&p);
        negative += eliminate(&p);
        store(&p);
        if (taut_pulse_beat(pulse, 2.0 * (double)(p.depth * p.depth * (rows - p.first))) ||
            mend(&p, pulse)) {
            break;
        }
    }
    return negative;
}
