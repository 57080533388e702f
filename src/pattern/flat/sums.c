#include "pattern/flat/sums.h"

#include "numeric/kernel/kernel.h"

#include <string.h>

enum { LOCAL = TAUT_FLAT_LOCAL, GAUSS = TAUT_FLAT_GAUSS, CELL = LOCAL * LOCAL };

/* The functions of t that share a span with function k: from .. to - 1. */
static int from_of(int k)
{
    return k < LOCAL - 1 ? 0 : k - (LOCAL - 1);
}

static int to_of(int k, int count)
{
    return k + LOCAL < count ? k + LOCAL : count;
}

static int pair_of(const taut_flat_sums *sums, int k, int l)
{
    return sums->row[k] + l - from_of(k);
}

/* S or T of a place: the slope, or the value. */
static double part_of(const taut_flat_line *l, int span, int q, int i, int is_slope)
{
    return is_slope ? l->slope[span][q][i] : l->value[span][q][i];
}

static double *folded_at(const taut_flat_sums *sums, int span, int q, int a, int b)
{
    return sums->folded +
           ((((size_t)span * GAUSS + (size_t)q) * 2 + (size_t)a) * 2 + (size_t)b) * CELL;
}

int taut_flat_sums_new(taut_arena *arena, const taut_flat_line *s, const taut_flat_line *t,
                       taut_flat_sums *sums)
{
    const size_t count = (size_t)t->count;
    *sums = (taut_flat_sums){.s = s, .t = t, .row = taut_arena_take(arena, count, sizeof(int))};
    for (int k = 0; sums->row != NULL && k < t->count; k++) {
        sums->row[k] = sums->pairs;
        sums->pairs += to_of(k, t->count) - from_of(k);
    }
    const size_t pairs = (size_t)sums->pairs;
    sums->across = taut_arena_take(arena, pairs, sizeof(int));
    sums->speed = taut_arena_take(arena, count, sizeof(double[4]));
    sums->pull = taut_arena_take(arena, count, sizeof(double[4]));
    sums->folded = taut_arena_take(arena, (size_t)t->spans * GAUSS, sizeof(double[2][2][CELL]));
    sums->moment = taut_arena_take(arena, 16 * pairs, sizeof(double));
    sums->half = taut_arena_take(arena, 8 * pairs, sizeof(double));
    sums->whole = taut_arena_take(arena, (size_t)CELL * 4 * pairs, sizeof(double));
    if (taut_arena_status(arena) != TAUT_OK) {
        return 0;
    }
    for (int k = 0; k < t->count; k++) {
        for (int l = from_of(k); l < to_of(k, t->count); l++) {
            sums->across[pair_of(sums, k, l)] = pair_of(sums, l, k);
        }
    }
    for (int place = 0; place < t->spans * GAUSS * 4; place++) {
        const int b = place / 4 / GAUSS, r = place / 4 % GAUSS;
        double *to = folded_at(sums, b, r, place / 2 % 2, place % 2);
        for (int k = 0; k < LOCAL; k++) { /* by t the second derivative of J's is the slope */
            for (int l = 0; l < LOCAL; l++) {
                to[k * LOCAL + l] =
                    part_of(t, b, r, k, place / 2 % 2) * part_of(t, b, r, l, place % 2);
            }
        }
    }
    return 1;
}

void taut_flat_sums_slopes(taut_flat_sums *sums, const double *y, int a, int q, double (*j)[2][2])
{
    const taut_flat_line *s = sums->s, *t = sums->t;
    const size_t count = (size_t)t->count;

    memset(sums->speed, 0, count * sizeof(double[4]));
    for (int i = 0; i < LOCAL; i++) {
        const double *from = y + (size_t)(a + i) * count * 2;
        const double slope = s->slope[a][q][i], value = s->value[a][q][i];
        for (size_t k = 0; k < count; k++) {
            double *to = sums->speed + 4 * k;
            for (int d = 0; d < 2; d++) {
                to[d] += slope * from[2 * k + (size_t)d];
                to[2 + d] += value * from[2 * k + (size_t)d];
            }
        }
    }
    for (int place = 0; place < t->spans * GAUSS; place++) {
        const int b = place / GAUSS, r = place % GAUSS;
        memset(j[place], 0, sizeof j[place]);
        for (int k = 0; k < LOCAL; k++) {
            const double *from = sums->speed + (size_t)(4 * (b + k));
            for (int d = 0; d < 2; d++) {
                j[place][d][0] += from[d] * t->value[b][r][k];
                j[place][d][1] += from[2 + d] * t->slope[b][r][k];
            }
        }
    }
}

void taut_flat_sums_begin(taut_flat_sums *sums)
{
    memset(sums->whole, 0, (size_t)CELL * 4 * (size_t)sums->pairs * sizeof(double));
}

static double *moment_at(const taut_flat_sums *sums, int x, int y)
{
    return sums->moment + (size_t)(4 * x + y) * (size_t)sums->pairs;
}

/* The form's derivatives by the entries of J, (11, 12, 21, 22), times the weight. */
static void by_slopes(const taut_flat_form *f, double weight, double first[4], double second[4][4])
{
    double half[4][4];
    for (int x = 0; x < 4; x++) {
        const double *in = f->inverse[x % 2];
        first[x] = weight * (f->first[x / 2 * 2] * in[0] + f->first[x / 2 * 2 + 1] * in[1]);
        for (int o = 0; o < 4; o++) {
            half[x][o] =
                weight * (f->second[x / 2 * 2][o] * in[0] + f->second[x / 2 * 2 + 1][o] * in[1]);
        }
    }
    for (int x = 0; x < 4; x++) {
        for (int y = x; y < 4; y++) {
            const double *in = f->inverse[y % 2];
            second[x][y] = half[x][y / 2 * 2] * in[0] + half[x][y / 2 * 2 + 1] * in[1];
        }
    }
}

/* Sums over the places of one span of t. */
static void sum_span(taut_flat_sums *sums, int b, double weight, const taut_flat_form *forms,
                     const char *is_there)
{
    const taut_kernel *kernel = taut_kernel_best();
    const taut_flat_line *t = sums->t;
    double cell[4][4][CELL], first[4], second[4][4];

    memset(cell, 0, sizeof cell);
    for (int r = 0; r < GAUSS; r++) {
        if (!is_there[r]) {
            continue;
        }
        by_slopes(&forms[r], weight * t->weight[b][r], first, second);
        for (int x = 0; x < 4; x++) {
            for (int y = x; y < 4; y++) {
                kernel->add_scaled(CELL, second[x][y], folded_at(sums, b, r, x % 2, y % 2),
                                   cell[x][y]);
            }
            for (int k = 0; k < LOCAL; k++) {
                sums->pull[4 * (b + k) + x] += first[x] * part_of(t, b, r, k, x % 2);
            }
        }
    }
    for (int x = 0; x < 4; x++) {
        for (int y = x; y < 4; y++) {
            double *to = moment_at(sums, x, y);
            for (int k = 0; k < LOCAL; k++) {
                for (int l = 0; l < LOCAL; l++) {
                    to[pair_of(sums, b + k, b + l)] += cell[x][y][k * LOCAL + l];
                }
            }
        }
    }
}

void taut_flat_sums_add(taut_flat_sums *sums, int a, int q, const taut_flat_form *forms,
                        const char *is_there, double *gradient)
{
    const taut_kernel *kernel = taut_kernel_best();
    const taut_flat_line *s = sums->s, *t = sums->t;
    const size_t pairs = (size_t)sums->pairs, count = (size_t)t->count;

    memset(sums->moment, 0, 16 * pairs * sizeof(double));
    memset(sums->pull, 0, count * sizeof(double[4]));
    for (int b = 0; b < t->spans; b++) {
        sum_span(sums, b, s->weight[a][q], forms + b * GAUSS, is_there + b * GAUSS);
    }
    for (int x = 0; x < 4; x++) { /* the form is symmetric */
        for (int y = 0; y < x; y++) {
            const double *from = moment_at(sums, y, x);
            double *to = moment_at(sums, x, y);
            for (size_t p = 0; p < pairs; p++) {
                to[p] = from[sums->across[p]];
            }
        }
    }
    for (int i = 0; i < LOCAL; i++) {
        const double part[2] = {s->slope[a][q][i], s->value[a][q][i]};
        double *of = gradient + (size_t)(a + i) * count * 2;
        for (size_t k = 0; k < count; k++) {
            for (size_t d = 0; d < 2; d++) {
                of[2 * k + d] +=
                    part[0] * sums->pull[4 * k + 2 * d] + part[1] * sums->pull[4 * k + 2 * d + 1];
            }
        }
        memset(sums->half, 0, 8 * pairs * sizeof(double));
        for (int x = 0; x < 16; x++) { /* (d, a, y) to (d, y) */
            kernel->add_scaled(pairs, part[x / 4 % 2], sums->moment + (size_t)x * pairs,
                               sums->half + (size_t)(x / 8 * 4 + x % 4) * pairs);
        }
        for (int l = 0; l <= i; l++) {
            const double other[2] = {s->slope[a][q][l], s->value[a][q][l]};
            double *to = sums->whole + (size_t)(i * LOCAL + l) * 4 * pairs;
            for (int x = 0; x < 8; x++) { /* (d, e, b) to (d, e) */
                kernel->add_scaled(pairs, other[x % 2], sums->half + (size_t)x * pairs,
                                   to + (size_t)(x / 2) * pairs);
            }
        }
    }
}

void taut_flat_sums_end(const taut_flat_sums *sums, int a, taut_band *hessian)
{
    const size_t pairs = (size_t)sums->pairs;
    const int count = sums->t->count;

    for (int i = 0; i < LOCAL; i++) {
        for (int l = 0; l <= i; l++) {
            const double *from = sums->whole + (size_t)(i * LOCAL + l) * 4 * pairs;
            for (int x = 0; x < 4; x++) {
                for (int k = 0; k < count; k++) {
                    const int row = ((a + i) * count + k) * 2 + x / 2;
                    for (int m = from_of(k); m < to_of(k, count); m++) {
                        const int column = ((a + l) * count + m) * 2 + x % 2;
                        if (column <= row) {
                            taut_band_row(hessian, row)[row - column] +=
                                from[(size_t)x * pairs + (size_t)pair_of(sums, k, m)];
                        }
                    }
                }
            }
        }
    }
}
