#include "construct/plateau/hessian_band.h"

#include "core/memory.h"
#include "numeric/band_tiles.h"

#include <string.h>

enum { BLOCK = 10 }; /* s n n^T in six numbers, t n in three, s */

struct taut_film_band {
    const taut_mask *mask;
    int unknowns;
    int *index; /* [nu][nv], or -1 at known points */
    int local;  /* functions alive on one panel */
    taut_band hessian, metric, factor;
    double *element; /* [local][local][BLOCK], the lower half used */
    double *slope_u; /* [local], at one Gauss point */
    double *slope_v; /* [local] */
    double *right;   /* [unknowns][3] */
    double *work;    /* of the factors of wide bands */
};

/* Numbers the unknown points; returns how many. */
static int number(const taut_mask *mask, int *index)
{
    const int by_rows = mask->rows >= mask->columns;
    const int outer = by_rows ? mask->nu : mask->nv;
    const int inner = by_rows ? mask->nv : mask->nu;
    int next = 0;

    for (int a = 0; a < outer; a++) {
        for (int b = 0; b < inner; b++) {
            const size_t at = by_rows ? (size_t)a * (size_t)mask->nv + (size_t)b
                                      : (size_t)b * (size_t)mask->nv + (size_t)a;
            index[at] = mask->known[at] ? -1 : next++;
        }
    }
    return next;
}

/* The largest distance of two unknowns that meet: they are less than `local` apart both ways. */
static int half_width(const taut_film *film, const int *index)
{
    int widest = 0;
    for (int line = 0; line < film->u.count; line += film->u.nodes) {
        for (int k = 0; k < film->v.count; k += film->v.nodes) {
            int least = -1, most = -1;
            for (int a = 0; a < film->u.local * film->v.local; a++) {
                const int i = film->u.first[line] + a / film->v.local;
                const int j = film->v.first[k] + a % film->v.local;
                const int at = index[(size_t)i * (size_t)film->nv + (size_t)j];
                least = at >= 0 && (least < 0 || at < least) ? at : least;
                most = at > most ? at : most;
            }
            widest = most - least > widest ? most - least : widest;
        }
    }
    return widest;
}

/* Of a banded matrix of three unknowns a point, numbered along the shorter side. */
static double half_band(const taut_film *film, const taut_mask *mask)
{
    return mask->rows < mask->columns ? 3.0 * film->v.local * mask->rows
                                      : 3.0 * film->u.local * mask->columns;
}

double taut_film_band_assembly_cost(const taut_film *film)
{
    const double meeting = (double)film->u.local * film->v.local;
    return 13 * meeting * meeting * film->u.count * film->v.count; /* half of all pairs */
}

double taut_film_band_factor_cost(const taut_film *film, const taut_mask *mask)
{
    const double width = half_band(film, mask);
    return 3.0 * (double)mask->unknowns * width * width;
}

int taut_film_band_pays(const taut_film *film, const taut_mask *mask)
{
    const double numbers = 3.0 * (double)mask->unknowns * half_band(film, mask);

    return taut_film_band_factor_cost(film, mask) <= 3e9 && numbers <= 2e7 &&
           taut_film_band_assembly_cost(film) <= 1.3e10;
}

void taut_film_band_free(taut_film_band *band)
{
    if (band != NULL) {
        taut_free(band->index);
        taut_band_clear(&band->hessian);
        taut_band_clear(&band->metric);
        taut_band_clear(&band->factor);
        taut_free(band->element);
        taut_free(band->slope_u);
        taut_free(band->slope_v);
        taut_free(band->right);
        taut_free(band->work);
        taut_free(band);
    }
}

static taut_status alloc_matrices(const taut_film *film, taut_film_band *band)
{
    const size_t local = (size_t)band->local;
    const int width = half_width(film, band->index);
    taut_status status = taut_band_init(3 * band->unknowns, 3 * width + 2, &band->hessian);

    if (status == TAUT_OK) {
        status = taut_band_init(3 * band->unknowns, 3 * width + 2, &band->factor);
    }
    if (status == TAUT_OK) {
        status = taut_band_init(band->unknowns, width, &band->metric);
    }
    band->element = taut_alloc_aligned(local * local, BLOCK * sizeof(double));
    band->slope_u = taut_alloc_aligned(local, sizeof(double));
    band->slope_v = taut_alloc_aligned(local, sizeof(double));
    band->right = taut_alloc_aligned((size_t)band->unknowns, 3 * sizeof(double));
    band->work =
        taut_alloc_aligned(taut_band_tiles_work(3 * band->unknowns, 3 * width + 2), sizeof(double));
    if (status != TAUT_OK || band->element == NULL || band->slope_u == NULL ||
        band->slope_v == NULL || band->right == NULL || band->work == NULL) {
        return TAUT_NO_MEMORY;
    }
    return TAUT_OK;
}

taut_status taut_film_band_new(const taut_film *film, const taut_mask *mask, taut_film_band **band)
{
    taut_film_band *made = taut_alloc_zero(1, sizeof *made);
    taut_status status = TAUT_NO_MEMORY;

    if (made == NULL) {
        return TAUT_NO_MEMORY;
    }
    made->mask = mask;
    made->local = film->u.local * film->v.local;
    made->index = taut_alloc((size_t)film->nu * (size_t)film->nv, sizeof(int));
    if (made->index != NULL) {
        made->unknowns = number(mask, made->index);
        status = alloc_matrices(film, made);
    }
    if (status != TAUT_OK) {
        taut_film_band_free(made);
        return status;
    }
    *band = made;
    return TAUT_OK;
}

/* The slopes of x in each point alive: N_i' N_j and N_i N_j', or with weights
 * w_ij (N_i' N_j - N_i N_j w_u / w) / w. */
static void slopes_at(taut_film_band *band, const taut_film *film, int line, int k)
{
    const size_t local_u = (size_t)film->u.local, local_v = (size_t)film->v.local;
    const double *n = film->u.value + (size_t)line * local_u;
    const double *d = film->u.slope + (size_t)line * local_u;
    const double *m = film->v.value + (size_t)k * local_v;
    const double *e = film->v.slope + (size_t)k * local_v;
    const int is_rational = film->quotient != NULL;
    double q[3] = {1, 0, 0};
    size_t p = 0;

    if (is_rational) {
        taut_film_quotient_at(film, line, k, q);
    }

    for (size_t a = 0; a < local_u; a++) {
        for (size_t b = 0; b < local_v; b++, p++) {
            band->slope_u[p] = d[a] * m[b];
            band->slope_v[p] = n[a] * e[b];
            if (is_rational) {
                const size_t i = (size_t)film->u.first[line] + a;
                const size_t j = (size_t)film->v.first[k] + b;
                const double w = film->weights[i * (size_t)film->nv + j] * q[0];
                band->slope_u[p] = w * (band->slope_u[p] - n[a] * m[b] * q[1]);
                band->slope_v[p] = w * (band->slope_v[p] - n[a] * m[b] * q[2]);
            }
        }
    }
}

/* Adds one Gauss point to the element. */
static void add_point(taut_film_band *band, const double *state)
{
    const double *n = state, e = state[3], f = state[4], g = state[5];
    const double square[6] = {n[0] * n[0], n[1] * n[0], n[1] * n[1],
                              n[2] * n[0], n[2] * n[1], n[2] * n[2]};
    const double normal[3] = {state[6] * n[0], state[6] * n[1], state[6] * n[2]};

    for (int p = 0; p < band->local; p++) {
        const double pu = band->slope_u[p], pv = band->slope_v[p];
        const double along_u = g * pu - f * pv, along_v = e * pv - f * pu;
        double *block = band->element + (size_t)p * (size_t)band->local * BLOCK;
        for (int q = 0; q <= p; q++, block += BLOCK) {
            const double qu = band->slope_u[q], qv = band->slope_v[q];
            const double s = along_u * qu + along_v * qv, t = pv * qu - pu * qv;
            for (int c = 0; c < 6; c++) {
                block[c] += s * square[c];
            }
            for (int c = 0; c < 3; c++) {
                block[6 + c] += t * normal[c];
            }
            block[9] += s;
        }
    }
}

/* Adds a block to row a, column b of both matrices, a >= b. sign: -1 when a and b have changed
 * places, since H_qp is the transpose of H_pq. */
static void add_block(taut_film_band *band, int a, int b, double sign, const double *block)
{
    const double x = sign * block[6], y = sign * block[7], z = sign * block[8];
    const double full[3][3] = {{block[0], block[1] - z, block[3] + y},
                               {block[1] + z, block[2], block[4] - x},
                               {block[3] - y, block[4] + x, block[5]}};

    for (int c = 0; c < 3; c++) {
        double *row = taut_band_row(&band->hessian, 3 * a + c);
        for (int d = 0; d < 3; d++) {
            const int below = 3 * a + c - (3 * b + d);
            if (below >= 0) {
                row[below] += full[c][d];
            }
        }
    }
    taut_band_row(&band->metric, a)[a - b] += block[9];
}

/* Adds the element of the panels that begin at this node. */
static void add_element(taut_film_band *band, const taut_film *film, int line, int k)
{
    for (int p = 0; p < band->local; p++) {
        const int ip = film->u.first[line] + p / film->v.local;
        const int jp = film->v.first[k] + p % film->v.local;
        const int a = band->index[(size_t)ip * (size_t)film->nv + (size_t)jp];
        for (int q = 0; a >= 0 && q <= p; q++) {
            const int iq = film->u.first[line] + q / film->v.local;
            const int jq = film->v.first[k] + q % film->v.local;
            const int b = band->index[(size_t)iq * (size_t)film->nv + (size_t)jq];
            const double *block =
                band->element + ((size_t)p * (size_t)band->local + (size_t)q) * BLOCK;
            if (b > a) {
                add_block(band, b, a, -1, block);
            } else if (b >= 0) {
                add_block(band, a, b, 1, block);
            }
        }
    }
}

static void clear(taut_band *matrix)
{
    memset(matrix->a, 0, (size_t)matrix->n * ((size_t)matrix->width + 1) * sizeof(double));
}

void taut_film_band_assemble(taut_film_band *band, const taut_film *film)
{
    const size_t local = (size_t)band->local;

    clear(&band->hessian);
    clear(&band->metric);
    for (int line = 0; line < film->u.count; line += film->u.nodes) {
        for (int k = 0; k < film->v.count; k += film->v.nodes) {
            memset(band->element, 0, local * local * BLOCK * sizeof(double));
            for (int g = 0; g < film->u.nodes * film->v.nodes; g++) {
                const int at_u = line + g / film->v.nodes, at_v = k + g % film->v.nodes;
                double state[TAUT_FILM_STATE];
                taut_film_state_at(film, at_u, at_v, state);
                slopes_at(band, film, at_u, at_v);
                add_point(band, state);
            }
            add_element(band, film, line, k);
        }
    }
}

/* factor = (1 - theta) hessian + theta metric (x) I. */
static void combine(taut_film_band *band, double theta)
{
    for (int i = 0; i < band->hessian.n; i++) {
        const double *h = taut_band_row(&band->hessian, i);
        const double *m = taut_band_row(&band->metric, i / 3);
        double *row = taut_band_row(&band->factor, i);
        for (int d = 0; d <= band->hessian.width; d++) {
            row[d] = (1 - theta) * h[d];
        }
        for (int d = 0; d <= band->metric.width; d++) {
            row[3 * d] += theta * m[d];
        }
    }
}

taut_status taut_film_band_factor(taut_film_band *band, double theta)
{
    combine(band, theta);
    return band->factor.width >= TAUT_BAND_TILES_LEAST
               ? taut_band_factor_tiled(&band->factor, band->work)
               : taut_band_factor(&band->factor);
}

void taut_film_band_solve(taut_film_band *band, double *net)
{
    const size_t count = (size_t)band->mask->nu * (size_t)band->mask->nv;

    for (size_t i = 0; i < count; i++) {
        if (band->index[i] >= 0) {
            memcpy(band->right + 3 * (size_t)band->index[i], net + 3 * i, 3 * sizeof(double));
        }
    }
    taut_band_solve(&band->factor, 1, band->right);
    for (size_t i = 0; i < count; i++) {
        if (band->index[i] >= 0) {
            memcpy(net + 3 * i, band->right + 3 * (size_t)band->index[i], 3 * sizeof(double));
        } else {
            memset(net + 3 * i, 0, 3 * sizeof(double));
        }
    }
}
