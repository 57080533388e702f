#include "certify/dirichlet/remainder.h"

#include "core/constants.h"
#include "core/elementary/elementary.h"
#include "core/vec3.h"

#include <math.h>
#include <string.h>

enum {
    RHOS = 11,
    REAL = 0,       /* the first: the interval itself */
    CELL_WORK = 400 /* operations of a cell and function alive, as pulses count them */
};
const int taut_remainder_nodes[TAUT_REMAINDER_RULES] = {4,  6,  8,  10, 12, 14,
                                                        16, 20, 24, 32, 40, 48};
static const double rhos[RHOS] = {1, 1.3, 1.6, 2, 2.5, 3, 4, 5.5, 8, 12, 20};

/* What rounding may take off a coefficient, of the largest number it was summed from. */
static const double slack = 0x1p-46;
/* More than the root of a sum of squares loses where they vanish: points are of unit size. A weight
 * is above it too, so that its inverse is a number. */
static const double tiny = 0x1p-500;

/* One cell of one direction: the functions alive as coefficients, and what bounds multiply them. */
typedef struct slice {
    const double *c; /* [local][local]: coefficient j of function a */
    double *e;       /* [RHOS][2][local]: of terms, and of their derivatives by t */
    double *f;       /* [RHOS][2][local]: bounds of the functions and their derivatives */
    double first;    /* the derivative's constant part is coefficient 1 times this */
    double half;     /* half the width of the cell over the range */
} slice;

/* A rational vector field on the cell at hand. */
typedef struct expansion {
    double *net;  /* [local u][local v][4]: coefficients of (wx, wy, wz, w) */
    double *size; /* [local u][local v]: |(wx, wy, wz)| of them */
    double *part; /* [4][local]: the net with the real direction summed */
} expansion;

typedef struct work {
    const taut_remainder_request *in;
    int local[2], nv;
    double length[2];
    double *coefficients[2]; /* [cells][local][local] */
    double *row;             /* [local u][local v][4] */
    expansion surface, moves;
    double *sums;                             /* [RULES + 1][nu][nv] */
    double *values[2];                        /* [local][local]: scratch */
    double power[RHOS][TAUT_REMAINDER_RULES]; /* what multiplies M */
    double *terms[2]; /* [RHOS][2][local]: of Chebyshev's on [-1, 1], and of their derivatives */
    double middle[3]; /* |x_u|, |x_v| and |x_u x x_v| of the constant parts, times w^2 */
    double *along;    /* [local v]: scratch */
} work;

static int is_polynomial(const taut_basis *basis)
{
    return taut_basis_degree(basis) >= 0;
}

/* cosines[j][k] = cos(j pi (k + 1/2) / n): row 1 is where the nodes are. */
static void fill_cosines(int n, double *cosines)
{
    for (int j = 0; j < n; j++) {
        for (int k = 0; k < n; k++) {
            cosines[j * n + k] = taut_cos(TAUT_PI * j * (k + 0.5) / n);
        }
    }
}

/* c[a][j] = (2 or 1)/n sum_k f_a(x_k) cos(j pi (k + 1/2) / n), x_k = cos(pi (k + 1/2) / n). */
static void find_chebyshev(const taut_basis *basis, int span, double lo, double hi,
                           const double *cosines, double *values, double *c)
{
    const int n = taut_basis_local(basis);
    for (int k = 0; k < n; k++) {
        const double x = n > 1 ? cosines[n + k] : 0, t = lo + (hi - lo) * (0.5 + 0.5 * x);
        (void)taut_basis_eval(basis, span, fmin(hi, fmax(lo, t)), 0, values + k * n);
    }
    for (int a = 0; a < n; a++) {
        for (int j = 0; j < n; j++) {
            double sum = 0;
            for (int k = 0; k < n; k++) {
                sum += values[k * n + a] * cosines[j * n + k];
            }
            c[a * n + j] = (j == 0 ? 1 : 2) * sum / n;
        }
    }
}

/* c[a][j]: derivative j of function a in the middle, j = 0..3. */
static void find_taylor(const taut_basis *basis, int span, double lo, double hi, double *c)
{
    double values[4][4];
    (void)taut_basis_eval(basis, span, lo + 0.5 * (hi - lo), 3, values[0]);
    for (int a = 0; a < 4; a++) {
        for (int j = 0; j < 4; j++) {
            c[a * 4 + j] = values[j][a];
        }
    }
}

static taut_status find_coefficients(work *w, int d, taut_arena *arena)
{
    const taut_basis *basis = w->in->basis[d];
    const taut_cells *cells = w->in->cells[d];
    const size_t n = (size_t)taut_basis_local(basis);
    double *cosines = taut_arena_take(arena, n * n, sizeof(double));

    if (cosines != NULL) {
        fill_cosines((int)n, cosines);
    }
    w->coefficients[d] = taut_arena_take(arena, (size_t)cells->count, n * n * sizeof(double));
    w->values[d] = taut_arena_take(arena, n * n, sizeof(double));
    for (int k = 0; k < cells->count && taut_arena_status(arena) == TAUT_OK; k++) {
        double *c = w->coefficients[d] + (size_t)k * n * n;
        if (is_polynomial(basis)) {
            find_chebyshev(basis, cells->span[k], cells->lo[k], cells->hi[k], cosines, w->values[d],
                           c);
        } else {
            find_taylor(basis, cells->span[k], cells->lo[k], cells->hi[k], c);
        }
    }
    return taut_arena_status(arena);
}

static double size_of_function(const double *c, int n, const double *e)
{
    double sum = 0;
    for (int j = 0; j < n; j++) {
        sum += (fabs(c[j]) + slack) * e[j];
    }
    return sum;
}

/* What |T_j| and |T_j'| are at most on every ellipse. */
static void fill_terms(int n, double *terms)
{
    for (int r = 0; r < RHOS; r++) {
        const double rho = rhos[r];
        double *e = terms + 2 * r * n, *slope = e + n;
        for (int j = 0; j < n; j++) {
            const double high = taut_pow(rho, j), low = taut_pow(rho, -j);
            e[j] = 0.5 * (high + low);
            slope[j] = r == REAL ? (double)j * j : j * (high - low) / (rho - 1 / rho);
        }
    }
}

static void fill_slice(const work *w, int d, int cell, slice *s)
{
    const taut_basis *basis = w->in->basis[d];
    const int n = w->local[d];
    const double half = 0.5 * (w->in->cells[d]->hi[cell] - w->in->cells[d]->lo[cell]);

    s->c = w->coefficients[d] + (size_t)cell * (size_t)n * (size_t)n;
    s->half = half / w->length[d];
    s->first = is_polynomial(basis) ? 1 / half : 1;
    for (int r = 0; r < RHOS; r++) {
        const double rho = rhos[r], reach = half * 0.5 * (rho + 1 / rho);
        double *e = s->e + 2 * r * n, *slope = e + n;
        if (is_polynomial(basis)) {
            const double *known = w->terms[d] + 2 * r * n;
            memcpy(e, known, (size_t)n * sizeof *e);
            for (int j = 0; j < n; j++) {
                slope[j] = known[n + j] / half;
            }
        } else {
            const double terms[4] = {1, reach, taut_cosh(reach) - 1, taut_sinh(reach) - reach};
            const double slopes[4] = {0, 1, taut_sinh(reach), taut_cosh(reach) - 1};
            memcpy(e, terms, sizeof terms);
            memcpy(slope, slopes, sizeof slopes);
        }
        for (int a = 0; a < n; a++) {
            s->f[2 * r * n + a] = size_of_function(s->c + a * n, n, e);
            s->f[(2 * r + 1) * n + a] = size_of_function(s->c + a * n, n, slope);
        }
    }
}

static double larger(double a, double b)
{
    return a > b ? a : b;
}

/* net[j][l] = sum_ab c_u[a][j] c_v[b][l] (w x, w y, w z, w)_ab, the points taken from one of their
 * own such that net[0][0] has none. */
static void find_net(work *w, const slice *u, const slice *v, const double *points, size_t first,
                     expansion *x, double *unit)
{
    const int nu = w->local[0], nv = w->local[1];
    const double *weights = w->in->weights;
    double largest = 0, middle[3] = {0, 0, 0};

    memset(w->row, 0, 4 * (size_t)(nu * nv) * sizeof(double));
    memset(x->net, 0, 4 * (size_t)(nu * nv) * sizeof(double));
    *unit = weights != NULL ? weights[first] : 1;
    for (int a = 0; a < nu; a++) {
        for (int b = 0; b < nv; b++) {
            const size_t at = first + (size_t)a * (size_t)w->nv + (size_t)b;
            const double weight = weights != NULL ? weights[at] / *unit : 1;
            double heavy[4];
            for (int c = 0; c < 3; c++) {
                heavy[c] = weight * (points[3 * at + (size_t)c] - points[3 * first + (size_t)c]);
                largest = larger(largest, fabs(heavy[c]));
            }
            heavy[3] = weight;
            largest = larger(largest, weights != NULL ? weight : 0);
            for (int j = 0; j < nu; j++) {
                for (int c = 0; c < 4; c++) {
                    w->row[4 * (j * nv + b) + c] += u->c[a * nu + j] * heavy[c];
                }
            }
        }
    }
    for (int j = 0; j < nu; j++) {
        for (int l = 0; l < nv; l++) {
            double *out = x->net + 4 * (j * nv + l);
            for (int b = 0; b < nv; b++) {
                for (int c = 0; c < 4; c++) {
                    out[c] += v->c[b * nv + l] * w->row[4 * (j * nv + b) + c];
                }
            }
        }
    }
    for (int c = 0; c < 3; c++) {
        middle[c] = x->net[c] / x->net[3];
    }
    for (int k = 0; k < nu * nv; k++) {
        double *out = x->net + 4 * k;
        for (int c = 0; c < 3; c++) {
            out[c] -= middle[c] * out[3];
        }
        x->size[k] = taut_length(out) + slack * largest + tiny;
        out[3] = fabs(out[3]) + (weights != NULL ? slack * largest : 0);
        if (weights == NULL) {
            out[3] = k == 0; /* partition of unity */
        }
    }
}

/* Bounds over one ellipse by one interval. */
typedef struct bounds {
    double x, xu, xv;        /* of |wx| and its derivatives */
    double w, wu, wv, least; /* of w, its derivatives, and from below */
} bounds;

/* part[0..3][j]: |(wx, wy, wz)| summed over the real direction, the same of derivatives by it, and
 * both of w; j runs along direction d, whose ellipse is to come. */
static void contract_real(const work *w, const expansion *x, const slice *real, int d)
{
    const int n = w->local[d], m = w->local[1 - d], nv = w->local[1];
    const double *e = real->e, *slope = e + m;
    memset(x->part, 0, 4 * (size_t)n * sizeof(double));
    for (int j = 0; j < n; j++) {
        for (int l = 0; l < m; l++) {
            const int at = d == 0 ? j * nv + l : l * nv + j;
            x->part[j] += x->size[at] * e[l];
            x->part[n + j] += x->size[at] * slope[l];
            x->part[2 * n + j] += x->net[4 * at + 3] * e[l];
            x->part[3 * n + j] += x->net[4 * at + 3] * slope[l];
        }
    }
}

static void find_bounds(const work *w, const expansion *x, const slice *ellipse, int d, int r,
                        bounds *b)
{
    const int n = w->local[d];
    const double *e = ellipse->e + 2 * r * n, *slope = e + n, *p = x->part;
    double along[4] = {0, 0, 0, 0}, across[2] = {0, 0};

    for (int j = 0; j < n; j++) {
        along[0] += p[j] * e[j];
        along[1] += p[j] * slope[j];
        across[0] += p[n + j] * e[j];
        along[2] += p[2 * n + j] * e[j];
        along[3] += p[2 * n + j] * slope[j];
        across[1] += p[3 * n + j] * e[j];
    }
    b->x = along[0];
    b->w = along[2];
    b->xu = d == 0 ? along[1] : across[0];
    b->xv = d == 0 ? across[0] : along[1];
    b->wu = d == 0 ? along[3] : across[1];
    b->wv = d == 0 ? across[1] : along[3];
    b->least = 2 * x->net[3] - b->w;
}

/* The lengths of the middle of a cell, which no ellipse changes. */
static void find_middle(work *w, const slice *u, const slice *v)
{
    const double *net = w->surface.net;
    double middle_u[3], middle_v[3], normal[3];

    for (int c = 0; c < 3; c++) {
        middle_u[c] = w->local[0] > 1 ? net[4 * w->local[1] + c] * u->first * net[3] : 0;
        middle_v[c] = w->local[1] > 1 ? net[4 + c] * v->first * net[3] : 0;
    }
    taut_cross(middle_u, middle_v, normal);
    w->middle[0] = taut_length(middle_u);
    w->middle[1] = taut_length(middle_v);
    w->middle[2] = taut_length(normal);
}

/* The area element times w^4: *most as a vector, *least as the root of its square. 0: no bound. */
static int find_element(const work *w, double xu, double xv, double *most, double *least)
{
    const double mu = w->middle[0], mv = w->middle[1], n = w->middle[2];
    const double du = larger(0, xu - mu) + slack * xu, dv = larger(0, xv - mv) + slack * xv;
    const double apart = mu * dv + mv * du + du * dv;
    const double square = n * n - 2 * n * apart - apart * apart;

    *most = n + apart;
    *least = square > 0 ? sqrt(square) : 0;
    return square > 0 && n > 0;
}

/* What multiplies phi_u and phi_v: bounds of the form's x_u and x_v, over the unit square. 0: none.
 */
static int find_factors(const work *w, const bounds *b, double *pu, double *pv)
{
    const double lu = w->length[0], lv = w->length[1], least = b->least;
    const double xu = b->xu * b->w + b->x * b->wu, xv = b->xv * b->w + b->x * b->wv;
    double element = 0, least_element = 0;

    if (!(least > tiny)) {
        return 0;
    }
    if (!w->in->is_area) {
        *pu = w->in->fu * lu * lu * xu / (least * least);
        *pv = w->in->fv * lv * lv * xv / (least * least);
        return isfinite(*pu) && isfinite(*pv);
    }
    if (!find_element(w, xu, xv, &element, &least_element)) {
        return 0;
    }
    const double factor = lu * lv * element / (least_element * least * least);
    *pu = factor * xv;
    *pv = factor * xu;
    return isfinite(*pu) && isfinite(*pv);
}

/* The largest |phi_u| pu + |phi_v| pv of the points alive: phi = w_ab N_a N_b / w; fu, fv: bounds of
 * the functions. */
static double find_largest(const work *w, const double *fu, const double *fv, const bounds *b,
                           size_t first, double unit, double pu, double pv)
{
    const int nu = w->local[0], nv = w->local[1];
    const double inverse = 1 / b->least, both = (b->wu * pu + b->wv * pv) * inverse;
    double largest = 0;

    for (int l = 0; l < nv; l++) {
        w->along[l] = fv[nv + l] * pv + fv[l] * both;
    }
    for (int a = 0; a < nu; a++) {
        const double still = fu[a], slope = fu[nu + a] * pu;
        const size_t row = first + (size_t)a * (size_t)w->nv;
        for (int l = 0; l < nv; l++) {
            const double weight = w->in->weights != NULL ? w->in->weights[row + (size_t)l] : 1;
            largest = larger(largest, weight * (slope * fv[l] + still * w->along[l]));
        }
    }
    return largest / unit * inverse;
}

/* M of the second derivative of the area along the moves d,
 *
 *     |x_v (N.d_u) - x_u (N.d_v)|^2 / W^3 + 2 N.(d_u x d_v) / W,    N = x_u x x_v, W = |N|
 *
 * by x_u, x_v, d_u, d_v as bounds of w^2 times them; INFINITY where there is none. On the interval
 * itself times what a relative error of all of them makes of it at most. */
static double find_second(const work *w, const slice *ellipse, int d, int r, const bounds *b)
{
    const double xu = b->xu * b->w + b->x * b->wu, xv = b->xv * b->w + b->x * b->wv;
    double element = 0, least_element = 0;
    bounds m;

    find_bounds(w, &w->moves, ellipse, d, r, &m);
    const double du = m.xu * m.w + m.x * m.wu, dv = m.xv * m.w + m.x * m.wv;
    if (!(b->least > tiny) || !find_element(w, xu, xv, &element, &least_element)) {
        return INFINITY;
    }
    const double mixed = element * (xv * du + xu * dv) / least_element,
                 weight = b->least * b->least;
    const double most = w->length[0] * w->length[1] * (mixed * mixed + 2 * element * du * dv) /
                        (least_element * weight * weight);
    return r == REAL ? most * (32 + 16 * xu * xv / least_element + 8 * b->w / b->least) : most;
}

/* M on ellipse r of direction d, INFINITY where none is known; the part is contracted for d. */
static double find_maximum(const work *w, const slice *u, const slice *v, int d, int r,
                           size_t first, double unit)
{
    const double *fu = u->f + 2 * (d == 0 ? r : REAL) * w->local[0];
    const double *fv = v->f + 2 * (d == 1 ? r : REAL) * w->local[1];
    double pu = 0, pv = 0, found = INFINITY;
    bounds b;

    find_bounds(w, &w->surface, d == 0 ? u : v, d, r, &b);
    if (w->in->moves != NULL) {
        found = find_second(w, d == 0 ? u : v, d, r, &b);
    } else if (find_factors(w, &b, &pu, &pv)) {
        found = find_largest(w, fu, fv, &b, first, unit, pu, pv);
    }
    return isfinite(found) ? found : INFINITY;
}

/* To all points alive on a cell; of a second derivative there is one number for all. */
static void add_to_points(work *w, const double *added, size_t first, size_t count)
{
    const int is_one = w->in->moves != NULL;
    for (int k = 0; k <= TAUT_REMAINDER_RULES; k++) {
        for (int a = 0; a < (is_one ? 1 : w->local[0]); a++) {
            double *row =
                w->sums + (size_t)k * count + (is_one ? 0 : first + (size_t)a * (size_t)w->nv);
            for (int b = 0; b < (is_one ? 1 : w->local[1]); b++) {
                row[b] += added[k];
            }
        }
    }
}

/* Adds what the rules may miss on one cell to all points alive. missed[2] as in the request, or NULL.
 */
static void add_cell(work *w, const slice *u, const slice *v, size_t first, size_t count,
                     double *missed)
{
    const double area = u->half * v->half;
    double added[TAUT_REMAINDER_RULES + 1] = {0}, unit = 1;

    find_net(w, u, v, w->in->points, first, &w->surface, &unit);
    find_middle(w, u, v);
    if (w->in->moves != NULL) {
        double same = 1;
        find_net(w, u, v, w->in->moves, first, &w->moves, &same);
    }
    for (int d = 0; d < 2; d++) {
        double least[TAUT_REMAINDER_RULES];
        contract_real(w, &w->surface, d == 0 ? v : u, d);
        if (w->in->moves != NULL) {
            contract_real(w, &w->moves, d == 0 ? v : u, d);
        }
        for (int k = 0; k < TAUT_REMAINDER_RULES; k++) {
            least[k] = INFINITY;
        }
        for (int r = REAL + 1; r < RHOS; r++) {
            const double most = find_maximum(w, u, v, d, r, first, unit);
            if (!isfinite(most)) {
                break; /* nor on any larger one */
            }
            for (int k = 0; k < TAUT_REMAINDER_RULES; k++) {
                const double bound = most * w->power[r][k];
                least[k] = bound < least[k] ? bound : least[k];
            }
        }
        for (int k = 0; k < TAUT_REMAINDER_RULES; k++) {
            added[k] += 2 * area * least[k];
        }
        if (missed != NULL) {
            missed[d] = 2 * area * least[TAUT_REMAINDER_FEW];
        }
    }
    added[TAUT_REMAINDER_RULES] = 4 * area * find_maximum(w, u, v, 1, REAL, first, unit);
    add_to_points(w, added, first, count);
}

static taut_status begin(work *w, taut_arena *arena, size_t count)
{
    for (int d = 0; d < 2; d++) {
        const taut_basis *basis = w->in->basis[d];
        w->local[d] = taut_basis_local(basis);
        w->length[d] = taut_basis_hi(basis) - taut_basis_lo(basis);
        w->terms[d] = taut_arena_take(arena, 2 * RHOS * (size_t)w->local[d], sizeof(double));
        if (find_coefficients(w, d, arena) != TAUT_OK) {
            return TAUT_NO_MEMORY;
        }
        fill_terms(w->local[d], w->terms[d]);
    }
    for (int r = REAL + 1; r < RHOS; r++) {
        for (int k = 0; k < TAUT_REMAINDER_RULES; k++) {
            w->power[r][k] = 64.0 / 15 * taut_pow(rhos[r], 2 - 2 * taut_remainder_nodes[k]) /
                             (1 - 1 / (rhos[r] * rhos[r]));
        }
    }
    const size_t alive = (size_t)w->local[0] * (size_t)w->local[1];
    w->row = taut_arena_take(arena, 4 * alive, sizeof(double));
    for (int k = 0; k < (w->in->moves != NULL ? 2 : 1); k++) {
        expansion *x = k == 0 ? &w->surface : &w->moves;
        x->net = taut_arena_take(arena, 4 * alive, sizeof(double));
        x->size = taut_arena_take(arena, alive, sizeof(double));
        x->part = taut_arena_take(arena, 4 * (size_t)(w->local[0] + w->local[1]), sizeof(double));
    }
    w->along = taut_arena_take(arena, (size_t)w->local[1], sizeof(double));
    w->sums = taut_arena_take(arena, (TAUT_REMAINDER_RULES + 1) * count, sizeof(double));
    if (taut_arena_status(arena) == TAUT_OK) {
        memset(w->sums, 0, (TAUT_REMAINDER_RULES + 1) * count * sizeof(double));
    }
    return taut_arena_status(arena);
}

taut_status taut_gradient_remainder(const taut_remainder_request *request, taut_arena *arena,
                                    double remainder[TAUT_REMAINDER_RULES], double *scale)
{
    const size_t nv = (size_t)taut_basis_count(request->basis[1]);
    const size_t count = (size_t)taut_basis_count(request->basis[0]) * nv;
    const taut_cells *cu = request->cells[0], *cv = request->cells[1];
    work *w = taut_arena_take(arena, 1, sizeof *w);
    slice *slices = taut_arena_take(arena, 1 + (size_t)cv->count, sizeof *slices);
    const size_t local[2] = {(size_t)taut_basis_local(request->basis[0]),
                             (size_t)taut_basis_local(request->basis[1])};
    double *e =
        taut_arena_take(arena, local[0] + (size_t)cv->count * local[1], 4 * RHOS * sizeof(double));

    if (taut_arena_status(arena) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    memset(w, 0, sizeof *w);
    w->in = request;
    w->nv = (int)nv;
    if (begin(w, arena, count) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    slices[0].e = e;
    slices[0].f = e + 2 * RHOS * local[0];
    for (int l = 0; l < cv->count; l++) {
        slices[1 + l].e = e + 4 * RHOS * (local[0] + (size_t)l * local[1]);
        slices[1 + l].f = slices[1 + l].e + 2 * RHOS * local[1];
        fill_slice(w, 1, l, &slices[1 + l]);
    }
    for (int k = 0; k < cu->count; k++) {
        const int first_u = taut_basis_first(request->basis[0], cu->span[k]);
        fill_slice(w, 0, k, &slices[0]);
        for (int l = 0; l < cv->count; l++) {
            const int first_v = taut_basis_first(request->basis[1], cv->span[l]);
            double *missed = request->missed;
            missed =
                missed != NULL ? missed + 2 * ((size_t)k * (size_t)cv->count + (size_t)l) : NULL;
            add_cell(w, &slices[0], &slices[1 + l], (size_t)first_u * nv + (size_t)first_v, count,
                     missed);
        }
        if (taut_crew_beat(request->crew, CELL_WORK * (double)(local[0] * local[1]) * cv->count)) {
            return TAUT_INTERRUPTED;
        }
    }
    for (int k = 0; k <= TAUT_REMAINDER_RULES; k++) {
        double largest = 0;
        for (size_t i = 0; i < count; i++) {
            largest = fmax(largest, w->sums[(size_t)k * count + i]);
        }
        *(k < TAUT_REMAINDER_RULES ? &remainder[k] : scale) = 1.01 * largest;
    }
    return TAUT_OK;
}
