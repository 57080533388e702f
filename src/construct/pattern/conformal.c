/* conformal.c
 *
 *     int grad phi . grad psi dA = - int K psi dA   for all splines psi that are 0 on the border
 *
 * grad phi . grad psi = phi_a g^ab psi_b. Sums are over the places of quadrature that the flat piece has.
 */
#include "construct/pattern/conformal.h"

#include "core/elementary/elementary.h"
#include "numeric/band.h"
#include "pattern/flat/line.h"

#include <math.h>

enum { DEGREE = TAUT_FLAT_DEGREE, LOCAL = TAUT_FLAT_LOCAL, GAUSS = TAUT_FLAT_GAUSS };
/* Operations, about, of a place of quadrature. */
static const double work_of_place = 5e3;

typedef struct sums {
    const taut_pattern_piece *piece;
    taut_flat_line lines[2];
    taut_band matrix;
    double *right;
} sums;

static int unknown(const sums *w, int i, int k)
{
    return i * w->lines[1].count + k;
}

/* A place of quadrature of cell (a, b): values and slopes of the functions alive are products. */
static void add_place(sums *w, int a, int q, int b, int r, const double g[3], double gauss)
{
    const taut_flat_line *s = &w->lines[0], *t = &w->lines[1];
    const double area = sqrt(g[0] * g[2] - g[1] * g[1]), weight = s->weight[a][q] * t->weight[b][r];
    const double inverse[3] = {g[2] / area, -g[1] / area, g[0] / area};
    double slope[LOCAL * LOCAL][2];

    for (int x = 0; x < LOCAL * LOCAL; x++) {
        const int i = x / LOCAL, k = x % LOCAL;
        slope[x][0] = s->slope[a][q][i] * t->value[b][r][k];
        slope[x][1] = s->value[a][q][i] * t->slope[b][r][k];
        w->right[unknown(w, a + i, b + k)] -=
            weight * area * gauss * s->value[a][q][i] * t->value[b][r][k];
    }
    for (int x = 0; x < LOCAL * LOCAL; x++) {
        const int i = unknown(w, a + x / LOCAL, b + x % LOCAL);
        const double flow[2] = {weight * (inverse[0] * slope[x][0] + inverse[1] * slope[x][1]),
                                weight * (inverse[1] * slope[x][0] + inverse[2] * slope[x][1])};
        double *row = taut_band_row(&w->matrix, i);
        for (int z = 0; z <= x; z++) { /* of functions in their order */
            const int k = unknown(w, a + z / LOCAL, b + z % LOCAL);
            row[i - k] += flow[0] * slope[z][0] + flow[1] * slope[z][1];
        }
    }
}

static void add_all(sums *w, taut_pulse *pulse)
{
    const taut_flat_line *s = &w->lines[0], *t = &w->lines[1];
    taut_pattern_kept kept = {.s = NAN};
    const taut_pattern_across across = {w->piece, &kept};
    for (int m = 0;
         m < s->spans * GAUSS && !taut_pulse_beat(pulse, t->spans * GAUSS * work_of_place); m++) {
        for (int n = 0; n < t->spans * GAUSS; n++) {
            const double x = s->at[m / GAUSS][m % GAUSS], y = t->at[n / GAUSS][n % GAUSS];
            double g[3], bend[2], gauss;
            taut_pattern_across_metric(&across, x, y, g);
            taut_pattern_piece_bends(w->piece, x, y, bend, &gauss);
            add_place(w, m / GAUSS, m % GAUSS, n / GAUSS, n % GAUSS, g, gauss);
        }
    }
}

/* Functions that are not 0 on the border are none. */
static void pin_border(sums *w)
{
    const int count[2] = {w->lines[0].count, w->lines[1].count};
    for (int i = 0; i < w->matrix.n; i++) {
        double *row = taut_band_row(&w->matrix, i);
        for (int d = 0; d <= w->matrix.width && d <= i; d++) {
            const int own[2] = {i / count[1], i % count[1]},
                      other[2] = {(i - d) / count[1], (i - d) % count[1]};
            int is_pinned = 0;
            for (int k = 0; k < 2; k++) {
                is_pinned |= own[k] == 0 || own[k] == count[k] - 1 || other[k] == 0 ||
                             other[k] == count[k] - 1;
            }
            if (is_pinned) {
                row[d] = d == 0;
                w->right[i] = d == 0 ? 0 : w->right[i];
            }
        }
    }
}

taut_status taut_pattern_find_scale(taut_pattern_piece *piece, taut_pulse *pulse, taut_arena *arena)
{
    sums w = {.piece = piece};
    taut_arena *scratch = taut_arena_new();
    taut_status status = TAUT_NO_MEMORY;

    piece->log_scale = NULL;
    if (scratch != NULL && taut_flat_line_fill(scratch, piece->spans[0], 0, &w.lines[0]) &&
        taut_flat_line_fill(scratch, piece->spans[1], 0, &w.lines[1])) {
        const int n = w.lines[0].count * w.lines[1].count;
        w.right = taut_arena_take(arena, (size_t)n, sizeof *w.right);
        status = w.right != NULL ? taut_band_init(n, DEGREE * w.lines[1].count + DEGREE, &w.matrix)
                                 : TAUT_NO_MEMORY;
    }
    if (status == TAUT_OK) {
        add_all(&w, pulse);
        pin_border(&w);
        status = taut_band_factor_watched(&w.matrix, pulse);
        if (status == TAUT_OK) {
            taut_band_solve(&w.matrix, 1, w.right);
            piece->log_scale = w.right;
        }
        taut_band_clear(&w.matrix);
    }
    taut_arena_free(scratch);
    return status;
}

static double log_scale_at(const taut_pattern_piece *piece, double s, double t)
{
    const int *spans = piece->spans, count = spans[1] + DEGREE;
    const int a = taut_flat_span(spans[0], 0, s), b = taut_flat_span(spans[1], 0, t);
    double value[2][LOCAL], sum = 0;
    taut_flat_basis(spans[0], 0, DEGREE, a, s, value[0], NULL);
    taut_flat_basis(spans[1], 0, DEGREE, b, t, value[1], NULL);
    for (int x = 0; x < LOCAL * LOCAL; x++) {
        sum += value[0][x / LOCAL] * value[1][x % LOCAL] *
               piece->log_scale[(a + x / LOCAL) * count + b + x % LOCAL];
    }
    return sum;
}

void taut_pattern_scaled_metric(const void *across, double s, double t, double g[3])
{
    const taut_pattern_across *on = across;
    taut_pattern_across_metric(across, s, t, g);
    const double share = taut_exp(2 * log_scale_at(on->piece, s, t));
    for (int k = 0; k < 3; k++) {
        g[k] *= share;
    }
}
