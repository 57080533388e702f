#include "construct/plateau/hessian_band.h"

#include "construct/plateau/elements.h"
#include "construct/plateau/small.h"
#include "core/arena.h"
#include "core/memory.h"
#include "numeric/band.h"

#include <math.h>
#include <string.h>

/* k dL dL^T of each cable that gives way, beside the band: with G their sqrt(k) dL,
 *
 *     (B + G G^T)^-1 = B^-1 - B^-1 G (I + G^T B^-1 G)^-1 G^T B^-1     ([GolubVanLoan2013] 2.1.4)
 *
 * A film may stand by the length of a cable alone: B has eigenvalues below 0 then, and B + G G^T has none exactly when
 * I + G^T B^-1 G has as many.
 */
typedef struct border {
    int count;
    int cable[TAUT_SMALL_MAX];                            /* which each is */
    double *pull[TAUT_SMALL_MAX], *image[TAUT_SMALL_MAX]; /* [unknowns][3]: of G, of B^-1 G */
    double small[TAUT_SMALL_MAX][TAUT_SMALL_MAX];         /* the factors of I + G^T B^-1 G */
    int is_signed;                                        /* are both factors those of any signs? */
} border;

/* What factors may cost; beyond it conjugate gradients serve. */
static const struct {
    double factor_flops;   /* of one factorisation: a second or so */
    double numbers;        /* in one of the three matrices: 160 MB */
    double assembly_flops; /* of one assembly, whose inner loop is short: a few seconds */
} limits = {3e9, 2e7, 1.3e10};

struct taut_area_hessian {
    taut_arena *arena; /* of the arrays */
    const taut_mask *mask;
    int unknowns;
    int *index;                       /* [nu][nv], or -1 at known points */
    int local;                        /* functions alive on one cell */
    taut_band second, metric, factor; /* H, L_g, what was made of both */
    taut_area_elements *elements;
    int *alive;    /* [local]: the unknowns of one cell, or -1 */
    double *right; /* [unknowns][3] */
    double *work;  /* of the factors of wide bands */
    const double **
        allowed; /* [unknowns]: the projector of each that is kept on a line or in a plane, else NULL; or
                             * NULL: none is */
    border border;
    taut_pulse *pulse; /* the functional's, or NULL */
};

static size_t net_size(const taut_area_hessian *hessian)
{
    return (size_t)hessian->mask->nu * (size_t)hessian->mask->nv;
}

/* Is point i unknown, and no copy? */
static int is_leader(const taut_area_hessian *hessian, size_t i)
{
    return !hessian->mask->known[i];
}

/* The a-th of `count` lines: one from each end in turn where the net goes around, so that lines
 * which meet across the seam stay near each other. */
static int line_of(int a, int count, int is_folded)
{
    return !is_folded ? a : a % 2 == 0 ? a / 2 : count - 1 - a / 2;
}

/* Numbers the unknown points, one line after another; returns how many. */
static int number_lines(const taut_mask *mask, int by_rows, int is_folded, int *index)
{
    const int outer = by_rows ? mask->nu : mask->nv;
    const int inner = by_rows ? mask->nv : mask->nu;
    int next = 0;

    for (int k = 0; k < outer; k++) {
        const int a = line_of(k, outer, is_folded);
        for (int b = 0; b < inner; b++) {
            const size_t at = by_rows ? (size_t)a * (size_t)mask->nv + (size_t)b
                                      : (size_t)b * (size_t)mask->nv + (size_t)a;
            index[at] = mask->known[at] ? -1 : next++;
        }
    }
    for (size_t i = 0; mask->leader != NULL && i < (size_t)outer * (size_t)inner; i++) {
        index[i] = index[mask->leader[i]];
    }
    return next;
}

/* The largest distance of two unknowns that meet: they are less than `local` apart both ways. */
static int half_width(const taut_area_functional *functional, const int *index)
{
    int widest = 0;
    for (int line = 0; line < functional->u.count; line += functional->u.nodes) {
        for (int k = 0; k < functional->v.count; k += functional->v.nodes) {
            int least = -1, most = -1;
            for (int a = 0; a < functional->u.local * functional->v.local; a++) {
                const int i = functional->u.first[line] + a / functional->v.local;
                const int j = functional->v.first[k] + a % functional->v.local;
                const int at = index[(size_t)i * (size_t)functional->nv + (size_t)j];
                least = at >= 0 && (least < 0 || at < least) ? at : least;
                most = at > most ? at : most;
            }
            widest = most - least > widest ? most - least : widest;
        }
    }
    return widest;
}

/* Numbers them so that the band is narrow. */
static int number_unknowns(const taut_area_functional *functional, const taut_mask *mask,
                           int *index)
{
    const int by_rows = mask->rows >= mask->columns;
    int best = 0, width = 0;

    for (int k = 0; mask->leader != NULL && k < 4; k++) {
        (void)number_lines(mask, k % 2, k / 2, index);
        const int found = half_width(functional, index);
        if (k == 0 || found < width) {
            best = k;
            width = found;
        }
    }
    return mask->leader != NULL ? number_lines(mask, best % 2, best / 2, index)
                                : number_lines(mask, by_rows, 0, index);
}

int taut_area_number(const taut_area_functional *functional, const taut_mask *mask, int *index,
                     int *width)
{
    const int count = number_unknowns(functional, mask, index);
    *width = half_width(functional, index);
    return count;
}

/* Of a banded matrix of three unknowns a point, numbered along the shorter side. */
static double half_band(const taut_area_functional *functional, const taut_mask *mask)
{
    return mask->rows < mask->columns ? 3.0 * functional->v.local * mask->rows
                                      : 3.0 * functional->u.local * mask->columns;
}

/* Of a Gauss point. */
static double point_cost(const taut_area_functional *functional)
{
    const double meeting = (double)functional->u.local * functional->v.local;
    return 13 * meeting * meeting; /* half of all pairs */
}

double taut_area_hessian_assembly_cost(const taut_area_functional *functional)
{
    return point_cost(functional) * functional->u.count * functional->v.count;
}

double taut_area_hessian_factor_cost(const taut_area_functional *functional, const taut_mask *mask)
{
    const double width = half_band(functional, mask);
    return 3.0 * (double)mask->unknowns * width * width;
}

int taut_area_hessian_pays(const taut_area_functional *functional, const taut_mask *mask)
{
    const double numbers = 3.0 * (double)mask->unknowns * half_band(functional, mask);

    return taut_area_hessian_factor_cost(functional, mask) <= limits.factor_flops &&
           numbers <= limits.numbers &&
           taut_area_hessian_assembly_cost(functional) <= limits.assembly_flops;
}

void taut_area_hessian_free(taut_area_hessian *hessian)
{
    if (hessian != NULL) {
        taut_band_clear(&hessian->second);
        taut_band_clear(&hessian->metric);
        taut_band_clear(&hessian->factor);
        taut_area_elements_free(hessian->elements);
        taut_arena_free(hessian->arena);
        taut_free(hessian);
    }
}

static taut_status take_arrays(const taut_area_functional *functional, taut_area_hessian *hessian)
{
    taut_arena *arena = hessian->arena = taut_arena_new();
    const size_t local = (size_t)hessian->local;

    hessian->index =
        taut_arena_take(arena, (size_t)functional->nu * (size_t)functional->nv, sizeof(int));
    hessian->alive = taut_arena_take(arena, local, sizeof(int));
    hessian->right = taut_arena_take(arena, hessian->mask->unknowns, 3 * sizeof(double));
    for (int k = 0; k < functional->cable_count; k++) {
        hessian->border.pull[k] =
            taut_arena_take(arena, hessian->mask->unknowns, 3 * sizeof(double));
        hessian->border.image[k] =
            taut_arena_take(arena, hessian->mask->unknowns, 3 * sizeof(double));
    }
    return taut_arena_status(arena);
}

static taut_status make_matrices(const taut_area_functional *functional, taut_area_hessian *hessian)
{
    taut_status status =
        taut_area_elements_new(1, &functional, functional->threads, &hessian->elements);
    int count = 0, width = 0;

    if (status == TAUT_OK) {
        status = take_arrays(functional, hessian);
    }
    if (status != TAUT_OK) {
        return status;
    }
    if (hessian->mask->allowed != NULL) {
        hessian->allowed =
            taut_arena_take(hessian->arena, hessian->mask->unknowns, sizeof *hessian->allowed);
        if (hessian->allowed == NULL) {
            return TAUT_NO_MEMORY;
        }
    }
    hessian->unknowns = taut_area_number(functional, hessian->mask, hessian->index, &width);
    for (size_t i = 0; hessian->allowed != NULL && i < net_size(hessian); i++) {
        const double *p = hessian->mask->allowed + 6 * i;
        if (is_leader(hessian, i) && p[0] + p[2] + p[5] < 2.5) { /* the trace is its rank */
            hessian->allowed[hessian->index[i]] = p;
        }
    }
    count = hessian->unknowns;
    hessian->work = taut_arena_take(hessian->arena, taut_band_tiles_work(3 * count, 3 * width + 2),
                                    sizeof(double));
    if (hessian->work == NULL ||
        taut_band_init(3 * count, 3 * width + 2, &hessian->second) != TAUT_OK ||
        taut_band_init(3 * count, 3 * width + 2, &hessian->factor) != TAUT_OK ||
        taut_band_init(count, width, &hessian->metric) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    return TAUT_OK;
}

taut_status taut_area_hessian_new(const taut_area_functional *functional, const taut_mask *mask,
                                  taut_area_hessian **hessian)
{
    taut_area_hessian *made = taut_alloc_zero(1, sizeof *made);
    taut_status status = TAUT_OK;

    if (made == NULL) {
        return TAUT_NO_MEMORY;
    }
    made->mask = mask;
    made->local = functional->u.local * functional->v.local;
    status = make_matrices(functional, made);
    if (status != TAUT_OK) {
        taut_area_hessian_free(made);
        return status;
    }
    *hessian = made;
    return TAUT_OK;
}

/* Adds a block to row a, column b of both matrices, a >= b. sign: -1 when a and b have changed
 * places, since H_qp is the transpose of H_pq. */
static void add_block(taut_area_hessian *hessian, int a, int b, double sign, const double *block,
                      size_t stride)
{
    const double x = sign * block[6 * stride], y = sign * block[7 * stride],
                 z = sign * block[8 * stride];
    double *const metric = taut_band_row(&hessian->metric, a) + (a - b);
    const int next = hessian->second.width + 2; /* from column 0 of a row to that of the next */
    double *const top = taut_band_row(&hessian->second, 3 * a) + 3 * (a - b);
    double *const middle = top + next, *const low = middle + next;

    top[0] += block[0];
    middle[0] += block[stride] + z;
    middle[-1] += block[2 * stride];
    low[0] += block[3 * stride] - y;
    low[-1] += block[4 * stride] + x;
    low[-2] += block[5 * stride];
    if (a > b) { /* else above the diagonal */
        top[-1] += block[stride] - z;
        top[-2] += block[3 * stride] + y;
        middle[-2] += block[4 * stride] - x;
    }
    metric[0] += block[9 * stride];
}

/* Adds the block of points a and b, numbers so far apart, in the order that the band keeps; of two points that are one, both
 * that they have. */
static void add_pair(taut_area_hessian *hessian, int a, int b, int are_two, const double *block,
                     size_t stride)
{
    if (b > a) {
        add_block(hessian, b, a, -1, block, stride);
    } else if (b >= 0) {
        add_block(hessian, a, b, 1, block, stride);
    }
    if (a == b && are_two) {
        add_block(hessian, a, b, -1, block, stride);
    }
}

/* Adds the element of the cells that begin at this node. */
static void add_element(taut_area_hessian *hessian, const taut_area_functional *functional,
                        int line, int k)
{
    const size_t wide = (size_t)taut_area_wide(functional);
    const double *element = taut_area_elements_next(hessian->elements);
    int *const alive = hessian->alive;

    for (int p = 0; p < hessian->local; p++) {
        const int i = functional->u.first[line] + p / functional->v.local;
        const int j = functional->v.first[k] + p % functional->v.local;
        alive[p] = hessian->index[(size_t)i * (size_t)functional->nv + (size_t)j];
    }
    for (int p = 0; p < hessian->local; p++) {
        const double *row = element + (size_t)p * TAUT_AREA_BLOCK * wide;
        for (int q = 0; alive[p] >= 0 && q <= p; q++) {
            add_pair(hessian, alive[p], alive[q], p != q, row + q, wide);
        }
    }
}

/* Adds r p' q' (I - t t^T) / |x_t| of a node, and r p' q' / |x_t| to the metric, for the points
 * that are alive there. */
static void add_cable_node(taut_area_hessian *hessian, const taut_area_cable *cable, int node)
{
    const double *slope = cable->slope + (size_t)node * (size_t)cable->local;
    const double *t = cable->state + (size_t)node * TAUT_AREA_CABLE_STATE;
    const double across[6] = {1 - t[0] * t[0], -t[1] * t[0], 1 - t[1] * t[1],
                              -t[2] * t[0],    -t[2] * t[1], 1 - t[2] * t[2]};
    const int *index = hessian->index + cable->first + (size_t)cable->alive[node] * cable->step;

    for (int p = 0; p < cable->local; p++) {
        const int a = index[(size_t)p * cable->step];
        for (int q = 0; a >= 0 && q <= p; q++) {
            const int b = index[(size_t)q * cable->step];
            double block[TAUT_AREA_BLOCK] = {0};
            block[9] = cable->tension * t[3] * slope[p] * slope[q];
            for (int c = 0; c < 6; c++) {
                block[c] = block[9] * across[c];
            }
            add_pair(hessian, a, b, p != q, block, 1);
        }
    }
}

/* sqrt(k) dL of a cable that gives way. */
static void add_border(taut_area_hessian *hessian, const taut_area_cable *cable, int which)
{
    double *pull = hessian->border.pull[hessian->border.count];
    hessian->border.cable[hessian->border.count++] = which;

    memset(pull, 0, 3 * hessian->mask->unknowns * sizeof(double));
    for (int k = 0; k < cable->count; k++) {
        const int at = hessian->index[cable->first + (size_t)k * cable->step];
        for (int c = 0; at >= 0 && c < 3; c++) {
            pull[3 * at + c] += sqrt(cable->stiffness) * cable->pull[3 * k + c];
        }
    }
    for (size_t i = 0; hessian->mask->allowed != NULL && i < net_size(hessian); i++) {
        if (is_leader(hessian, i)) {
            taut_mask_project(hessian->mask->allowed + 6 * i, pull + 3 * hessian->index[i]);
        }
    }
}

static void clear_band(taut_band *matrix)
{
    memset(matrix->a, 0, (size_t)matrix->n * ((size_t)matrix->width + 1) * sizeof(double));
}

void taut_area_hessian_assemble(taut_area_hessian *hessian, const taut_area_functional *functional)
{
    const int nodes = functional->u.nodes;

    const double cell = point_cost(functional) * nodes * functional->v.nodes;

    hessian->pulse = functional->pulse;
    clear_band(&hessian->second);
    clear_band(&hessian->metric);
    taut_area_elements_begin(hessian->elements, &functional, NULL, NULL);
    for (int line = 0; line < functional->u.count; line += nodes) {
        for (int k = 0; k < functional->v.count; k += functional->v.nodes) {
            add_element(hessian, functional, line, k);
            if (taut_pulse_beat(hessian->pulse, cell)) {
                return;
            }
        }
    }
    hessian->border.count = 0;
    for (int k = 0; k < functional->cable_count; k++) {
        if (functional->cables[k].stiffness > 0 && functional->cables[k].tension > 0) {
            add_border(hessian, functional->cables + k, k);
        }
        for (int node = 0; node < functional->cables[k].nodes; node++) {
            add_cable_node(hessian, functional->cables + k, node);
        }
    }
}

void taut_area_hessian_stiffen(taut_area_hessian *hessian, const double *directions, double weight)
{
    for (size_t i = 0; i < net_size(hessian); i++) {
        const double *p = directions + 9 * i, *q = p + 3, *r = p + 6;
        for (int c = 0; c < 3 && is_leader(hessian, i); c++) {
            double *row = taut_band_row(&hessian->second, 3 * hessian->index[i] + c);
            for (int d = 0; d <= c; d++) {
                row[c - d] += weight * ((c == d) - p[c] * p[d] - q[c] * q[d] - r[c] * r[d]);
            }
        }
    }
}

/* Where number k of a condition stands among the unknowns; -1: at a known point. */
static int index_of(const taut_area_hessian *hessian, const taut_conditions *all,
                    const taut_condition *c, int k)
{
    const size_t i = (size_t)(c->first[0] + k / all->local[1]);
    const size_t j = (size_t)(c->first[1] + k % all->local[1]);
    return hessian->index[i * (size_t)all->nv + j];
}

/* A hundred times the metric's largest number there, over c . c. */
static double weight_of(const taut_area_hessian *hessian, const taut_conditions *all,
                        const taut_condition *c)
{
    double largest = 0, square = 0;

    for (int k = 0; k < all->local[0] * all->local[1]; k++) {
        const int a = index_of(hessian, all, c, k);
        if (a >= 0) {
            largest = fmax(largest, taut_band_row(&hessian->metric, a)[0]);
            square += c->coefficients[k] * c->coefficients[k];
        }
    }
    return square > 0 ? 100 * largest / square : 0;
}

static void hold(taut_area_hessian *hessian, const taut_conditions *all, const taut_condition *c)
{
    const double weight = weight_of(hessian, all, c);

    for (int k = 0; k < all->local[0] * all->local[1]; k++) {
        const int a = index_of(hessian, all, c, k);
        for (int m = 0; a >= 0 && m < all->local[0] * all->local[1]; m++) {
            const int b = index_of(hessian, all, c, m);
            for (int e = 0; b >= 0 && b <= a && e < 3; e++) {
                taut_band_row(&hessian->second, 3 * a + e)[3 * (a - b)] +=
                    weight * c->coefficients[k] * c->coefficients[m];
            }
        }
    }
}

void taut_area_hessian_hold(taut_area_hessian *hessian, const taut_conditions *conditions)
{
    for (int k = 0; k < conditions->count; k++) {
        hold(hessian, conditions, &conditions->at[k]);
    }
}

/* factor = (1 - theta) hessian + theta metric (x) I. */
static void combine_matrices(taut_area_hessian *hessian, double theta)
{
    for (int i = 0; i < hessian->second.n; i++) {
        const double *h = taut_band_row(&hessian->second, i);
        const double *m = taut_band_row(&hessian->metric, i / 3);
        double *row = taut_band_row(&hessian->factor, i);
        for (int d = 0; d <= hessian->second.width; d++) {
            row[d] = (1 - theta) * h[d];
        }
        for (int d = 0; d <= hessian->metric.width; d++) {
            row[3 * d] += theta * m[d];
        }
    }
}

/* block = P block P', projectors as a mask has them, block [3][3]; NULL: all is allowed. */
static void restrict_block(const double *left, const double *right, double block[3][3])
{
    for (int c = 0; c < 3; c++) {
        taut_mask_project(right, block[c]);
    }
    for (int d = 0; d < 3; d++) {
        double x[3] = {block[0][d], block[1][d], block[2][d]};
        taut_mask_project(left, x);
        for (int c = 0; c < 3; c++) {
            block[c][d] = x[c];
        }
    }
}

/* Blocks (a, b) of the factor, a >= b, without what is not allowed; on the diagonal its mean size there in
 * the place of it. */
static void restrict_pair(taut_area_hessian *hessian, int a, int b, const double *left,
                          const double *right)
{
    double block[3][3], full[3][3];
    const double size = a == b ? taut_band_row(&hessian->factor, 3 * a)[0] : 0;

    for (int c = 0; c < 3; c++) {
        for (int d = 0; d < 3; d++) {
            const int below = 3 * (a - b) + c - d;
            full[c][d] = below >= 0 ? taut_band_row(&hessian->factor, 3 * a + c)[below]
                                    : taut_band_row(&hessian->factor, 3 * b + d)[-below];
        }
    }
    memcpy(block, full, sizeof block);
    restrict_block(left, right, block);
    for (int c = 0, at = 0; c < 3; c++) {
        for (int d = 0; d <= c && a == b; d++, at++) {
            block[c][d] += size * ((c == d) - left[at]);
        }
    }
    for (int c = 0; c < 3; c++) {
        for (int d = 0; d < 3; d++) {
            const int below = 3 * (a - b) + c - d;
            if (below >= 0) {
                taut_band_row(&hessian->factor, 3 * a + c)[below] = block[c][d];
            }
        }
    }
}

/* Takes moves that are not allowed out of the factor: P B P + size (I - P). */
static void restrict_moves(taut_area_hessian *hessian)
{
    const double **allowed = hessian->allowed;

    for (int a = 0; a < hessian->unknowns && allowed != NULL; a++) {
        for (int b = a - hessian->metric.width > 0 ? a - hessian->metric.width : 0; b <= a; b++) {
            if (allowed[a] != NULL || allowed[b] != NULL) {
                restrict_pair(hessian, a, b, allowed[a], allowed[b]);
            }
        }
    }
}

static double dot(size_t count, const double *a, const double *b)
{
    double sum = 0;
    for (size_t i = 0; i < count; i++) {
        sum += a[i] * b[i];
    }
    return sum;
}

/* The border by the factors at hand; `negative` of B's eigenvalues are below 0. */
static taut_status factor_border(taut_area_hessian *hessian, int negative)
{
    border *b = &hessian->border;
    const size_t size = 3 * (size_t)hessian->unknowns;

    for (int k = 0; k < b->count; k++) {
        memcpy(b->image[k], b->pull[k], size * sizeof(double));
        taut_band_solve(&hessian->factor, 1, b->image[k]);
        for (int m = 0; m <= k; m++) {
            b->small[k][m] = (k == m) + dot(size, b->pull[m], b->image[k]);
        }
    }
    if (b->is_signed) {
        return taut_small_factor_signed(b->count, b->small) == negative ? TAUT_OK
                                                                        : TAUT_NO_SOLUTION;
    }
    return taut_small_factor(b->count, b->small) ? TAUT_OK : TAUT_NO_SOLUTION;
}

/* Once more, where only the border can make it definite. */
static taut_status factor_signed(taut_area_hessian *hessian, double theta)
{
    int negative = 0;

    combine_matrices(hessian, theta);
    restrict_moves(hessian);
    hessian->border.is_signed = 1;
    const taut_status status = taut_band_factor_signed(&hessian->factor, &negative, hessian->pulse);
    if (status == TAUT_INTERRUPTED) {
        return status;
    }
    return status == TAUT_OK && negative <= hessian->border.count ? factor_border(hessian, negative)
                                                                  : TAUT_NO_SOLUTION;
}

taut_status taut_area_hessian_factor(taut_area_hessian *hessian, double theta)
{
    if (taut_pulse_is_stopped(hessian->pulse)) {
        return TAUT_INTERRUPTED;
    }
    combine_matrices(hessian, theta);
    restrict_moves(hessian);
    const taut_status status =
        hessian->factor.width >= TAUT_BAND_TILES_LEAST
            ? taut_band_factor_tiled(&hessian->factor, hessian->work, hessian->pulse)
            : taut_band_factor_watched(&hessian->factor, hessian->pulse);
    hessian->border.is_signed = 0;
    if (status == TAUT_NO_SOLUTION && hessian->border.count > 0 && hessian->mask->leader != NULL) {
        return factor_signed(hessian, theta);
    }
    return status == TAUT_OK ? factor_border(hessian, 0) : status;
}

int taut_area_hessian_is_definite(const taut_area_hessian *hessian)
{
    return !hessian->border.is_signed;
}

taut_status taut_area_hessian_factor_any(taut_area_hessian *hessian, double theta,
                                         const unsigned char *rigid, int *negative)
{
    border *b = &hessian->border;
    const size_t size = 3 * (size_t)hessian->unknowns;

    if (taut_pulse_is_stopped(hessian->pulse)) {
        return TAUT_INTERRUPTED;
    }
    combine_matrices(hessian, theta);
    restrict_moves(hessian);
    b->is_signed = 1;
    const taut_status status = taut_band_factor_signed(&hessian->factor, negative, hessian->pulse);
    if (status != TAUT_OK) {
        return status;
    }
    for (int k = 0; k < b->count; k++) {
        memcpy(b->image[k], b->pull[k], size * sizeof(double));
        taut_band_solve(&hessian->factor, 1, b->image[k]);
        for (int m = 0; m <= k; m++) {
            const double own = k == m && (rigid == NULL || !rigid[b->cable[k]]);
            b->small[k][m] = own + dot(size, b->pull[m], b->image[k]);
        }
    }
    const int more = taut_small_factor_signed(b->count, b->small);
    *negative -= more;
    return more >= 0 ? TAUT_OK : TAUT_NO_SOLUTION;
}

/* right = (B + G G^T)^-1 right, B^-1 right given. */
static void solve_border(taut_area_hessian *hessian)
{
    border *b = &hessian->border;
    const size_t size = 3 * (size_t)hessian->unknowns;
    double along[TAUT_SMALL_MAX];

    for (int k = 0; k < b->count; k++) {
        along[k] = dot(size, b->pull[k], hessian->right);
    }
    if (b->is_signed) {
        taut_small_solve_signed(b->count, b->small, along);
    } else {
        taut_small_solve(b->count, b->small, along);
    }
    for (int k = 0; k < b->count; k++) {
        for (size_t i = 0; i < size; i++) {
            hessian->right[i] -= along[k] * b->image[k][i];
        }
    }
}

void taut_area_hessian_solve(taut_area_hessian *hessian, double *net)
{
    const size_t count = (size_t)hessian->mask->nu * (size_t)hessian->mask->nv;

    for (size_t i = 0; i < count; i++) {
        if (is_leader(hessian, i)) {
            memcpy(hessian->right + 3 * (size_t)hessian->index[i], net + 3 * i, 3 * sizeof(double));
        }
    }
    taut_band_solve(&hessian->factor, 1, hessian->right);
    solve_border(hessian);
    for (size_t i = 0; i < count; i++) {
        if (hessian->index[i] >= 0) {
            memcpy(net + 3 * i, hessian->right + 3 * (size_t)hessian->index[i], 3 * sizeof(double));
        } else {
            memset(net + 3 * i, 0, 3 * sizeof(double));
        }
    }
}
