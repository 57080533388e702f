#include "trace/carrier.h"

#include "basis/basis_ops.h"
#include "core/vec3.h"
#include "geometry/exponent.h"

#include <stdint.h>
#include <string.h>

enum { GRID = 33 };
/* How near the two lines of a seam have to be, over the size, and their normals. */
static const double same_line = 1e-12, same_normal = 1e-9;
/* Of |H|, and of 1 over the size: where R is smaller than a share of that which rounding explains, it is none. */
static const double least_share = 1e-4;

static const int order_u[TAUT_CARRIER_VECTORS] = {0, 1, 0, 2, 1, 0, 3, 2, 1, 0};
static const int order_v[TAUT_CARRIER_VECTORS] = {0, 0, 1, 0, 1, 2, 0, 1, 2, 3};

/* Homogeneous derivatives: of wx, wy, wz, and of w. `order` is a constant at each call, so that the loops over derivatives
 * unroll. */
static inline void sum_net(const taut_carrier *carrier, const int span[2], const double at[2],
                           const int order, double x[TAUT_CARRIER_VECTORS][3],
                           double weights[TAUT_CARRIER_VECTORS])
{
    const taut_basis *bu = carrier->basis[0], *bv = carrier->basis[1];
    const int local_u = bu->shape.local, local_v = bv->shape.local;
    const int count = (order + 1) * (order + 2) / 2;
    double nu[(TAUT_ORDER_MAX + 1) * (TAUT_DEGREE_MAX + 1)];
    double nv[(TAUT_ORDER_MAX + 1) * (TAUT_DEGREE_MAX + 1)];
    const int64_t columns = taut_basis_count(bv);
    double h[TAUT_CARRIER_VECTORS][4];

    bu->ops->eval(bu, span[0], at[0], order, nu);
    bv->ops->eval(bv, span[1], at[1], order, nv);
    memset(h, 0, (size_t)count * sizeof h[0]);
    for (int a = 0; a < local_u; a++) {
        const double *row =
            carrier->net + 4 * ((bu->first[span[0]] + a) * columns + bv->first[span[1]]);
        double sum[TAUT_ORDER_MAX + 1][4] = {{0}};
        for (int b = 0; b < local_v; b++) {
            for (int l = 0; l <= order; l++) {
                const double weight = nv[l * local_v + b];
                for (int c = 0; c < 4; c++) {
                    sum[l][c] += weight * row[4 * b + c];
                }
            }
        }
        for (int k = 0; k < count; k++) {
            const double weight = nu[order_u[k] * local_u + a];
            for (int c = 0; c < 4; c++) {
                h[k][c] += weight * sum[order_v[k]][c];
            }
        }
    }
    for (int k = 0; k < count; k++) {
        memcpy(x[k], h[k], sizeof x[k]);
        weights[k] = h[k][3];
    }
}

/* Of the quotient rule's sum of each derivative: which derivative of the weight, which of x, C(i, k) C(j, l). */
static const struct {
    signed char weight, x, factor;
} quotient[] = {
    /* clang-format off */
    {1, 0, 1}, /* 10 */
    {2, 0, 1}, /* 01 */
    {3, 0, 1}, {1, 1, 2}, /* 20 */
    {4, 0, 1}, {1, 2, 1}, {2, 1, 1}, /* 11 */
    {5, 0, 1}, {2, 2, 2}, /* 02 */
    {6, 0, 1}, {3, 1, 3}, {1, 3, 3}, /* 30 */
    {7, 0, 1}, {3, 2, 1}, {4, 1, 2}, {1, 4, 2}, {2, 3, 1}, /* 21 */
    {8, 0, 1}, {4, 2, 2}, {1, 5, 1}, {5, 1, 1}, {2, 4, 2}, /* 12 */
    {9, 0, 1}, {5, 2, 3}, {2, 5, 3}, /* 03 */
    /* clang-format on */
};
static const int quotient_first[TAUT_CARRIER_VECTORS + 1] = {0, 0, 1, 2, 4, 7, 9, 12, 17, 22, 25};

/* The quotient rule, in place: w x_ij = X_ij - sum over (k, l) < (i, j) of C(i, k) C(j, l) w_(i-k)(j-l) x_kl. */
static void project(int count, const double weights[TAUT_CARRIER_VECTORS],
                    double x[TAUT_CARRIER_VECTORS][3])
{
    for (int n = 0; n < count; n++) {
        for (int t = quotient_first[n]; t < quotient_first[n + 1]; t++) {
            taut_add_scaled(-quotient[t].factor * weights[quotient[t].weight], x[quotient[t].x],
                            x[n]);
        }
        for (int c = 0; c < 3; c++) {
            x[n][c] /= weights[0];
        }
    }
}

void taut_carrier_at(const taut_carrier *carrier, const int span[2], const double at[2], int order,
                     double x[TAUT_CARRIER_VECTORS][3])
{
    double weights[TAUT_CARRIER_VECTORS];

    if (carrier->cells != NULL) {
        taut_carrier_cells_at(carrier->cells, span, at, order, x, weights);
    } else if (order == 2) {
        sum_net(carrier, span, at, 2, x, weights);
    } else if (order == 3) {
        sum_net(carrier, span, at, 3, x, weights);
    } else {
        sum_net(carrier, span, at, order, x, weights);
    }
    if (carrier->is_rational) {
        project((order + 1) * (order + 2) / 2, weights, x);
    }
}

void taut_carrier_forms(const double x[TAUT_CARRIER_VECTORS][3], taut_form_pair *forms)
{
    double normal[3];
    taut_cross(x[1], x[2], normal);
    *forms = (taut_form_pair){.e = taut_dot(x[1], x[1]),
                              .f = taut_dot(x[1], x[2]),
                              .g = taut_dot(x[2], x[2]),
                              .w = taut_length(normal)};
    if (!(forms->w > 0)) {
        return;
    }
    for (int c = 0; c < 3; c++) {
        forms->normal[c] = normal[c] / forms->w;
    }
    forms->l = taut_dot(x[3], forms->normal);
    forms->m = taut_dot(x[4], forms->normal);
    forms->n = taut_dot(x[5], forms->normal);
}

/* Weingarten: n_u and n_v in x_u, x_v. */
static void normal_slopes(const double x[TAUT_CARRIER_VECTORS][3], const taut_form_pair *q,
                          double slopes[2][3])
{
    const double area = q->w * q->w;
    const double du[2] = {(q->m * q->f - q->l * q->g) / area, (q->l * q->f - q->m * q->e) / area};
    const double dv[2] = {(q->n * q->f - q->m * q->g) / area, (q->m * q->f - q->n * q->e) / area};
    for (int c = 0; c < 3; c++) {
        slopes[0][c] = du[0] * x[1][c] + du[1] * x[2][c];
        slopes[1][c] = dv[0] * x[1][c] + dv[1] * x[2][c];
    }
}

void taut_carrier_slopes(const double x[TAUT_CARRIER_VECTORS][3], const taut_form_pair *forms,
                         double slopes[6][2])
{
    double normal[2][3];

    normal_slopes(x, forms, normal);
    slopes[0][0] = 2 * taut_dot(x[1], x[3]);
    slopes[0][1] = 2 * taut_dot(x[1], x[4]);
    slopes[1][0] = taut_dot(x[3], x[2]) + taut_dot(x[1], x[4]);
    slopes[1][1] = taut_dot(x[4], x[2]) + taut_dot(x[1], x[5]);
    slopes[2][0] = 2 * taut_dot(x[2], x[4]);
    slopes[2][1] = 2 * taut_dot(x[2], x[5]);
    for (int k = 0; k < 3; k++) { /* l, m, n from x_uu, x_uv, x_vv */
        for (int d = 0; d < 2; d++) {
            slopes[3 + k][d] =
                taut_dot(x[6 + k + d], forms->normal) + taut_dot(x[3 + k], normal[d]);
        }
    }
}

double taut_form_pair_gauss(const taut_form_pair *q)
{
    return (q->l * q->n - q->m * q->m) / (q->w * q->w);
}

double taut_form_pair_mean(const taut_form_pair *q)
{
    return (q->e * q->n - 2 * q->f * q->m + q->g * q->l) / (2 * q->w * q->w);
}

/* The shape operator in the frame e1 = x_u/sqrt E, e2 = n x e1 is (p q; q r), R the half of its
 * difference. */
double taut_form_pair_radius(const taut_form_pair *q)
{
    const double p = q->l / q->e, s = (q->m * q->e - q->l * q->f) / (q->e * q->w);
    const double r =
        (q->n * q->e * q->e - 2 * q->m * q->e * q->f + q->l * q->f * q->f) / (q->e * q->w * q->w);
    return sqrt((p - r) * (p - r) / 4 + s * s);
}

void taut_carrier_point(const taut_carrier *carrier, const double x[3], double point[3])
{
    for (int c = 0; c < 3; c++) {
        point[c] = ldexp(x[c], carrier->scale) + carrier->origin[c];
    }
}

void taut_carrier_cell(const taut_carrier *carrier, const double at[2], const double *direction,
                       int span[2])
{
    for (int d = 0; d < 2; d++) {
        const double *breaks = taut_basis_breaks(carrier->basis[d]);
        span[d] = taut_basis_span(carrier->basis[d], at[d]);
        if (direction != NULL && direction[d] < 0 && span[d] > 0 && at[d] == breaks[span[d]]) {
            span[d]--;
        }
    }
}

int taut_carrier_is_crease(const taut_carrier *carrier, const double at[2])
{
    int span[2], count[2] = {1, 1};
    taut_form_pair first;

    taut_carrier_cell(carrier, at, NULL, span);
    for (int d = 0; d < 2; d++) {
        count[d] += span[d] > 0 && at[d] == taut_basis_breaks(carrier->basis[d])[span[d]];
    }
    for (int k = 0; k < count[0] * count[1]; k++) {
        const int cell[2] = {span[0] - k % count[0], span[1] - k / count[0]};
        double x[TAUT_CARRIER_VECTORS][3];
        taut_form_pair forms;
        taut_carrier_at(carrier, cell, at, 2, x);
        taut_carrier_forms((const double(*)[3])x, &forms);
        if (k == 0) {
            first = forms;
        } else if (first.w > 0 && forms.w > 0 &&
                   taut_length_between(first.normal, forms.normal) > same_normal) {
            return 1;
        }
    }
    return 0;
}

void taut_carrier_forms_at(const taut_carrier *carrier, const double at[2],
                           double x[TAUT_CARRIER_VECTORS][3], taut_form_pair *forms)
{
    int span[2];
    taut_carrier_cell(carrier, at, NULL, span);
    taut_carrier_at(carrier, span, at, 2, x);
    taut_carrier_forms((const double(*)[3])x, forms);
}

/* Half of the largest coordinate of a point from the first one of the first surface. */
static double half_size(int count, const taut_surface *const *surfaces)
{
    const double *origin = taut_surface_points(surfaces[0]);
    double half = taut_half_size(taut_point_count(surfaces[0]), origin);
    for (int i = 1; i < count; i++) {
        const double *points = taut_surface_points(surfaces[i]);
        for (size_t k = 0; k < 3 * taut_point_count(surfaces[i]); k++) {
            half = fmax(half, fabs(points[k] / 2 - origin[k % 3] / 2));
        }
    }
    return half;
}

static int make_net(taut_arena *arena, const double origin[3], double half, taut_carrier *carrier)
{
    const taut_surface *surface = carrier->surface;
    const double *points = taut_surface_points(surface), *weights = taut_surface_weights(surface);
    const size_t count = taut_point_count(surface);
    const double first = weights != NULL ? weights[0] : 1;
    double *net = taut_arena_take_raw(arena, count, 4 * sizeof(double));

    if (net == NULL) {
        return 0;
    }
    carrier->scale = taut_exponent(half) + 1;
    carrier->size = ldexp(half, 1 - carrier->scale);
    memcpy(carrier->origin, origin, sizeof carrier->origin);
    for (size_t k = 0; k < count; k++) {
        const double w = weights != NULL ? weights[k] / first : 1;
        for (int c = 0; c < 3; c++) {
            const double d = points[3 * k + (size_t)c] / 2 - carrier->origin[c] / 2;
            net[4 * k + (size_t)c] = w * ldexp(d, 1 - carrier->scale);
        }
        net[4 * k + 3] = w;
    }
    carrier->net = net;
    return 1;
}

/* How large |x_u x x_v| and R get, on a grid. On spheres and planes R is rounding: it counts as so large at least that
 * this is nothing. */
static void look(taut_carrier *carrier)
{
    carrier->roundest = least_share / carrier->size;
    for (int i = 0; i < GRID; i++) {
        for (int j = 0; j < GRID; j++) {
            const double at[2] = {
                carrier->lo[0] + (carrier->hi[0] - carrier->lo[0]) * (i + 0.5) / GRID,
                carrier->lo[1] + (carrier->hi[1] - carrier->lo[1]) * (j + 0.5) / GRID};
            double x[TAUT_CARRIER_VECTORS][3];
            taut_form_pair forms;
            taut_carrier_forms_at(carrier, at, x, &forms);
            if (forms.w > 0) {
                carrier->widest = fmax(carrier->widest, forms.w);
                carrier->roundest = fmax(carrier->roundest, taut_form_pair_radius(&forms));
                carrier->roundest =
                    fmax(carrier->roundest, least_share * fabs(taut_form_pair_mean(&forms)));
            }
        }
    }
}

/* Are the two borders of direction d one line in space, passed with one normal? */
static int is_seam(const taut_carrier *carrier, int d)
{
    for (int i = 0; i < GRID; i++) {
        double x[2][TAUT_CARRIER_VECTORS][3];
        taut_form_pair forms[2];
        for (int side = 0; side < 2; side++) {
            double at[2];
            at[d] = side == 0 ? carrier->lo[d] : carrier->hi[d];
            at[1 - d] =
                carrier->lo[1 - d] + (carrier->hi[1 - d] - carrier->lo[1 - d]) * (i + 0.5) / GRID;
            taut_carrier_forms_at(carrier, at, x[side], &forms[side]);
        }
        if (!(taut_length_between(x[0][0], x[1][0]) <= same_line * carrier->size) ||
            !(taut_length_between(forms[0].normal, forms[1].normal) <= same_normal) ||
            !(forms[0].w > 0) || !(forms[1].w > 0)) {
            return 0;
        }
    }
    return 1;
}

static taut_status carrier_in(taut_arena *arena, const taut_surface *surface,
                              const double origin[3], double half, taut_carrier **made)
{
    taut_carrier *carrier = taut_arena_take(arena, 1, sizeof *carrier);
    if (carrier == NULL) {
        return TAUT_NO_MEMORY;
    }
    carrier->surface = surface;
    carrier->basis[0] = taut_surface_u(surface);
    carrier->basis[1] = taut_surface_v(surface);
    carrier->is_rational = taut_surface_weights(surface) != NULL;
    for (int d = 0; d < 2; d++) {
        carrier->lo[d] = taut_basis_lo(carrier->basis[d]);
        carrier->hi[d] = taut_basis_hi(carrier->basis[d]);
    }
    if (!make_net(arena, origin, half, carrier) ||
        taut_carrier_cells_new(arena, carrier->basis, carrier->net, &carrier->cells) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    look(carrier);
    for (int d = 0; d < 2; d++) {
        carrier->wraps[d] = is_seam(carrier, d);
    }
    *made = carrier;
    return TAUT_OK;
}

taut_status taut_carrier_new(taut_arena *arena, const taut_surface *surface, taut_carrier **made)
{
    taut_carrier **one = NULL;
    const taut_status status = taut_carriers_new(arena, 1, &surface, &one);
    if (status == TAUT_OK) {
        *made = one[0];
    }
    return status;
}

taut_status taut_carriers_new(taut_arena *arena, int count, const taut_surface *const *surfaces,
                              taut_carrier ***made)
{
    const double *origin = taut_surface_points(surfaces[0]);
    const double half = half_size(count, surfaces);
    taut_carrier **carriers = taut_arena_take(arena, (size_t)count, sizeof *carriers);
    taut_status status = carriers != NULL ? TAUT_OK : TAUT_NO_MEMORY;
    double roundest = 0;

    for (int i = 0; status == TAUT_OK && i < count; i++) {
        status = carrier_in(arena, surfaces[i], origin, half, &carriers[i]);
        if (status == TAUT_OK) {
            roundest = fmax(roundest, carriers[i]->roundest);
        }
    }
    for (int i = 0; status == TAUT_OK && i < count; i++) {
        carriers[i]->roundest = roundest;
    }
    *made = carriers;
    return status;
}
