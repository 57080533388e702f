/* gradient_kernel_body.h -- the loops behind gradient_kernel.h, compiled once per instruction set.
 *
 * Columns of the net come and go with the cells of v: only those alive are kept, column t at place t
 * mod local. The including file defines SHEAF_LANES (doubles in a vector, 2, 4 or 8) and
 * SHEAF_SQRT(vector). Vectors are gcc's and clang's vector extension.
 */
#include "certify/dirichlet/gradient_kernel.h"

#include <math.h>
#include <stdint.h>
#include <string.h>

typedef double lanes __attribute__((vector_size(8 * SHEAF_LANES), aligned(8), may_alias));
typedef int64_t bits __attribute__((vector_size(8 * SHEAF_LANES), aligned(8), may_alias));

#define AT(pointer) (*(lanes *)(void *)(pointer))
#define OF(pointer) (*(const lanes *)(const void *)(pointer))
#define INLINE static inline __attribute__((always_inline))

INLINE lanes chosen(bits where, lanes a, lanes b)
{
    return (lanes)((where & (bits)a) | (~where & (bits)b));
}

INLINE lanes positive(lanes x)
{
    return (lanes)((bits)x & INT64_MAX);
}

INLINE lanes larger(lanes a, lanes b)
{
    return chosen((bits)(a > b), a, b);
}

typedef struct vector {
    lanes of[3];
} vector;

INLINE lanes dot(vector a, vector b)
{
    return a.of[0] * b.of[0] + a.of[1] * b.of[1] + a.of[2] * b.of[2];
}

INLINE lanes size_of_cross(vector a, vector b)
{
    const lanes x = a.of[1] * b.of[2] - a.of[2] * b.of[1];
    const lanes y = a.of[2] * b.of[0] - a.of[0] * b.of[2];
    const lanes z = a.of[0] * b.of[1] - a.of[1] * b.of[0];
    return SHEAF_SQRT(x * x + y * y + z * z);
}

/* What is at hand: scratch dealt out. */
typedef struct window {
    const taut_gradient_net *net;
    const taut_gradient_sheaf *sheaf;
    double *polygons; /* [local][TAUT_POLYGONS][8] */
    double *spread;   /* [local][2][TAUT_CHANNELS][8]: what goes back with N_i, and with N_i' */
    double *nodes;    /* [nodes][3][TAUT_CHANNELS][8] */
} window;

enum { STILL = 0, ALONG = 3, WEIGHT = 6, WEIGHT_ALONG = 7, GROSS = 8, GROSS_ALONG = 9 };

/* The place of the function b of a cell whose first one is at `slot`. */
INLINE size_t place_of(const window *w, size_t slot, size_t b)
{
    const size_t local = (size_t)w->net->local;
    return slot + b < local ? slot + b : slot + b - local;
}

/* Polygons of column t: sums over the rows alive. */
INLINE void load_column(const window *w, int t)
{
    const taut_gradient_net *net = w->net;
    const int slot = t % net->local;
    double *out = w->polygons + (size_t)slot * TAUT_POLYGONS * TAUT_SHEAF;

    for (size_t q = 0; q < TAUT_SHEAF; q += SHEAF_LANES) {
        lanes p[TAUT_POLYGONS];
        memset(p, 0, sizeof p);
        for (int a = 0; a < w->sheaf->alive; a++) {
            const size_t at = (size_t)(w->sheaf->first + a) * (size_t)net->nv + (size_t)t;
            const double *x = net->points + 3 * at;
            lanes n = OF(w->sheaf->n + (size_t)a * TAUT_SHEAF + q);
            lanes d = OF(w->sheaf->slopes + (size_t)a * TAUT_SHEAF + q);
            if (net->weights != NULL) {
                n *= net->weights[at];
                d *= net->weights[at];
                p[WEIGHT] += n;
                p[WEIGHT_ALONG] += d;
            }
            for (int c = 0; c < 3; c++) {
                p[STILL + c] += n * x[c];
                p[ALONG + c] += d * x[c];
            }
            p[GROSS] += n * net->sizes[at];
            p[GROSS_ALONG] += positive(d) * net->sizes[at];
        }
        for (size_t k = 0; k < TAUT_POLYGONS; k++) {
            AT(out + k * TAUT_SHEAF + q) = p[k];
        }
    }
    memset(w->spread + (size_t)slot * 2 * TAUT_CHANNELS * TAUT_SHEAF, 0,
           2 * TAUT_CHANNELS * TAUT_SHEAF * sizeof(double));
}

static double sum_of_lanes(const double *x)
{
    return ((x[0] + x[4]) + (x[2] + x[6])) + ((x[1] + x[5]) + (x[3] + x[7]));
}

/* rows += w_ij (N_i spread[0] + N_i' spread[1]) of column t, over the lines. */
INLINE void end_column(const window *w, int t, double *rows)
{
    const taut_gradient_net *net = w->net;
    const double *still = w->spread + (size_t)(t % net->local) * 2 * TAUT_CHANNELS * TAUT_SHEAF;
    const double *along = still + TAUT_CHANNELS * TAUT_SHEAF;

    for (int a = 0; a < w->sheaf->alive; a++) {
        const double *n = w->sheaf->n + (size_t)a * TAUT_SHEAF;
        const double *d = w->sheaf->slopes + (size_t)a * TAUT_SHEAF;
        const size_t at = (size_t)(w->sheaf->first + a) * (size_t)net->nv + (size_t)t;
        const double weight = net->weights != NULL ? net->weights[at] : 1;
        double *out = rows + TAUT_CHANNELS * ((size_t)a * (size_t)net->nv + (size_t)t);
        for (size_t c = 0; c < TAUT_CHANNELS; c++) {
            double both[TAUT_SHEAF];
            for (size_t q = 0; q < TAUT_SHEAF; q += SHEAF_LANES) {
                const lanes slope = c < 3 ? OF(d + q) : positive(OF(d + q));
                AT(both + q) = OF(n + q) * OF(still + c * TAUT_SHEAF + q) +
                               slope * OF(along + c * TAUT_SHEAF + q);
            }
            out[c] += weight * sum_of_lanes(both);
        }
    }
}

/* At one node: x_u, x_v, w, w_u / w, w_v / w, and the gross of x, x_u and x_v over w. */
typedef struct spot {
    vector u, v;
    lanes inverse, wu, wv, gross, gross_u, gross_v;
} spot;

INLINE void find_spot(const window *w, int k, size_t slot, size_t q, spot *s)
{
    const taut_gradient_net *net = w->net;
    const double *n = net->values + 2 * (size_t)k * (size_t)net->local, *d = n + net->local;
    lanes weight = {0};
    vector x = {{{0}, {0}, {0}}};

    memset(s, 0, sizeof *s);
    for (int b = 0; b < net->local; b++) {
        const double *p =
            w->polygons + place_of(w, slot, (size_t)b) * TAUT_POLYGONS * TAUT_SHEAF + q;
        for (int c = 0; c < 3; c++) {
            s->u.of[c] += OF(p + (ALONG + c) * TAUT_SHEAF) * n[b];
            s->v.of[c] += OF(p + (STILL + c) * TAUT_SHEAF) * d[b];
        }
        s->gross_u += OF(p + GROSS_ALONG * TAUT_SHEAF) * n[b];
        s->gross_v += OF(p + GROSS * TAUT_SHEAF) * fabs(d[b]);
        if (net->weights != NULL) {
            for (int c = 0; c < 3; c++) {
                x.of[c] += OF(p + (STILL + c) * TAUT_SHEAF) * n[b];
            }
            weight += OF(p + WEIGHT * TAUT_SHEAF) * n[b];
            s->wu += OF(p + WEIGHT_ALONG * TAUT_SHEAF) * n[b];
            s->wv += OF(p + WEIGHT * TAUT_SHEAF) * d[b];
            s->gross += OF(p + GROSS * TAUT_SHEAF) * n[b];
        }
    }
    s->inverse = (lanes){0} + 1;
    if (net->weights != NULL) {
        s->inverse = s->inverse / weight;
        s->wu *= s->inverse;
        s->wv *= s->inverse;
        for (int c = 0; c < 3; c++) { /* x_u = ((wx)_u - (w_u / w) (wx)) / w */
            s->u.of[c] = (s->u.of[c] - s->wu * x.of[c]) * s->inverse;
            s->v.of[c] = (s->v.of[c] - s->wv * x.of[c]) * s->inverse;
        }
    }
}

/* The quadratic form in x_u, x_v that the gradient is of: the constant one of the Dirichlet energy, or for the
 * area (G, -F, E) / W of the surface itself, 0 where W is. Returns W, or 0. */
INLINE lanes find_form(const taut_gradient_net *net, const spot *s, lanes form[3])
{
    lanes element = {0};
    form[0] = element + net->fu;
    form[1] = element;
    form[2] = element + net->fv;
    if (net->is_area) {
        const lanes one = element + 1;
        element = size_of_cross(s->u, s->v);
        const lanes inverse = (lanes)((bits)(one / element) & (bits)(element > 0x1p-400));
        form[0] = dot(s->v, s->v) * inverse;
        form[1] = -(dot(s->u, s->v) * inverse);
        form[2] = dot(s->u, s->u) * inverse;
    }
    return element;
}

INLINE void add_sums(const spot *s, lanes weight, lanes gross_u, lanes gross_v, lanes area,
                     lanes sums[TAUT_GRADIENT_SUMS])
{
    lanes sizes[2] = {{0}, {0}};
    for (int c = 0; c < 3; c++) {
        sizes[0] += positive(s->u.of[c]);
        sizes[1] += positive(s->v.of[c]);
    }
    sums[TAUT_AREA_SUM] += weight * area;
    sums[TAUT_HALVES] += weight * dot(s->u, s->u);
    sums[TAUT_HALVES + 1] += weight * dot(s->v, s->v);
    sums[TAUT_HALVES_GROSS] += weight * sizes[0] * gross_u;
    sums[TAUT_HALVES_GROSS + 1] += weight * sizes[1] * gross_v;
}

/* What multiplies N_i' N_j (out[0]), N_i N_j' (out[1]) and -N_i N_j (out[2]) at node k, in each
 * channel. In the gross one every sign is positive, and the slopes of the surface times what a
 * rounding of (u, v) is to basis and w are added. */
INLINE void find_integrands(const window *w, int k, size_t slot, size_t q, double *out,
                            lanes sums[TAUT_GRADIENT_SUMS])
{
    const taut_gradient_net *net = w->net;
    const lanes weight = OF(w->sheaf->rule + q) * net->rule[k];
    lanes form[3], most_u = {0}, most_v = {0};
    spot s;

    find_spot(w, k, slot, q, &s);
    const lanes area = find_form(net, &s, form), scale = weight * s.inverse;
    const lanes fu = scale * form[0], mixed = scale * form[1], fv = scale * form[2];
    const lanes wu = positive(s.wu), wv = positive(s.wv);
    const lanes all =
        OF(w->sheaf->roundings + q) + net->roundings[k] + wu * net->reach_u + wv * net->reach_v;
    double *still = out + TAUT_CHANNELS * TAUT_SHEAF, *back = still + TAUT_CHANNELS * TAUT_SHEAF;
    for (size_t c = 0; c < 3; c++) {
        const lanes u = fu * s.u.of[c] + mixed * s.v.of[c], v = mixed * s.u.of[c] + fv * s.v.of[c];
        AT(out + c * TAUT_SHEAF + q) = u;
        AT(still + c * TAUT_SHEAF + q) = v;
        if (net->weights != NULL) {
            AT(back + c * TAUT_SHEAF + q) = u * s.wu + v * s.wv;
        }
        most_u = larger(most_u, positive(s.u.of[c]));
        most_v = larger(most_v, positive(s.v.of[c]));
    }
    const lanes gross_u = all * most_u + (s.gross_u + wu * s.gross) * s.inverse;
    const lanes gross_v = all * most_v + (s.gross_v + wv * s.gross) * s.inverse;
    const lanes u = fu * gross_u + positive(mixed) * gross_v;
    const lanes v = positive(mixed) * gross_u + fv * gross_v;
    AT(out + 3 * TAUT_SHEAF + q) = u;
    AT(still + 3 * TAUT_SHEAF + q) = v;
    if (net->weights != NULL) {
        AT(back + 3 * TAUT_SHEAF + q) = -(u * wu + v * wv);
    }
    add_sums(&s, weight, gross_u, gross_v, area, sums);
}

/* spread[0] += N_j' out[1] - N_j out[2],  spread[1] += N_j out[0], over the nodes from k on. */
INLINE void gather_cell(const window *w, int k, size_t slot)
{
    const taut_gradient_net *net = w->net;
    const size_t local = (size_t)net->local, step = TAUT_CHANNELS * TAUT_SHEAF;

    for (size_t b = 0; b < local; b++) {
        double *spread = w->spread + 2 * place_of(w, slot, b) * step;
        for (size_t at = 0; at < step; at += SHEAF_LANES) {
            const int is_gross = at >= 3 * TAUT_SHEAF;
            const double *n = net->values + 2 * (size_t)k * local + b, *from = w->nodes + at;
            lanes still = {0}, along = {0};
            for (int g = 0; g < net->nodes; g++, n += 2 * local, from += 3 * step) {
                still += OF(from + step) * (is_gross ? fabs(n[local]) : n[local]);
                along += OF(from) * n[0];
                if (net->weights != NULL) {
                    still -= OF(from + 2 * step) * n[0];
                }
            }
            AT(spread + at) += still;
            AT(spread + step + at) += along;
        }
    }
}

INLINE void add_sheaf(const taut_gradient_net *net, const taut_gradient_sheaf *sheaf,
                      double *scratch, double *rows, double *sums)
{
    const size_t local = (size_t)net->local;
    window w = {.net = net, .sheaf = sheaf, .polygons = scratch};
    int from = 0, to = 0; /* columns at hand */
    double totals[TAUT_GRADIENT_SUMS][TAUT_SHEAF];

    w.spread = w.polygons + local * TAUT_POLYGONS * TAUT_SHEAF;
    w.nodes = w.spread + 2 * local * TAUT_CHANNELS * TAUT_SHEAF;
    memset(totals, 0, sizeof totals);
    for (int k = 0; k < net->count; k += net->nodes) {
        for (; from < net->first[k]; from++) {
            end_column(&w, from, rows);
        }
        for (; to < net->first[k] + net->local; to++) {
            load_column(&w, to);
        }
        const size_t slot = (size_t)net->first[k] % local;
        for (size_t q = 0; q < TAUT_SHEAF; q += SHEAF_LANES) {
            lanes t[TAUT_GRADIENT_SUMS];
            memset(t, 0, sizeof t);
            for (int g = 0; g < net->nodes; g++) {
                find_integrands(&w, k + g, slot, q,
                                w.nodes + 3 * (size_t)g * TAUT_CHANNELS * TAUT_SHEAF, t);
            }
            for (int i = 0; i < TAUT_GRADIENT_SUMS; i++) {
                AT(totals[i] + q) += t[i];
            }
        }
        gather_cell(&w, k, slot);
    }
    for (; from < to; from++) {
        end_column(&w, from, rows);
    }
    for (int i = 0; i < TAUT_GRADIENT_SUMS; i++) {
        sums[i] += sum_of_lanes(totals[i]);
    }
}

static void gradient_add(const taut_gradient_net *net, const taut_gradient_sheaf *sheaf,
                         double *scratch, double *rows, double *sums)
{
    taut_gradient_net known = *net;
    if (SHEAF_LANES > 2 && net->local == 4 && net->weights == NULL && !net->is_area) {
        known.local = 4; /* cubics: told to the compiler, which unrolls */
        known.weights = NULL;
        known.is_area = 0;
        add_sheaf(&known, sheaf, scratch, rows, sums);
    } else {
        add_sheaf(net, sheaf, scratch, rows, sums);
    }
}

#define GRADIENT_OPS(title)                                                                        \
    {                                                                                              \
        .name = (title), .add = gradient_add                                                       \
    }
