#include "construct/dirichlet/form.h"

#include "core/arena.h"
#include "core/constants.h"
#include "core/elementary/elementary.h"
#include "core/fail.h"
#include "core/memory.h"
#include "numeric/sum.h"
#include "numeric/tensor/apply.h"

#include <math.h>
#include <string.h>

/* ---- is a table of weights a product w_ij = a_i b_j? ---- */

typedef struct split {
    double *u;    /* [nu], the factors a_i; NULL where they are all the same */
    double *v;    /* [nv], the factors b_j; NULL where they are all the same */
    double *rest; /* [nu][nv], the weights over their largest; NULL where the product is exact */
} split;

/* Puts the first row and column into v and u; do they make all of w to rounding? */
static int is_product(int nu, int nv, const double *w, double *u, double *v)
{
    for (int i = 0; i < nu; i++) {
        u[i] = w[(size_t)i * (size_t)nv];
    }
    for (int j = 0; j < nv; j++) {
        v[j] = w[j] / w[0];
    }
    for (int i = 0; i < nu; i++) {
        for (int j = 0; j < nv; j++) {
            const double wij = w[(size_t)i * (size_t)nv + (size_t)j];
            if (!(fabs(u[i] * v[j] - wij) <= 8 * TAUT_UNIT_ROUNDOFF * wij)) {
                return 0;
            }
        }
    }
    return 1;
}

/* log u_i = mean_j log w_ij, log v_j = mean_i log w_ij - mean_ij log w_ij. */
static void geometric_means(int nu, int nv, const double *w, double *u, double *v)
{
    double mean = 0;
    memset(u, 0, (size_t)nu * sizeof *u);
    memset(v, 0, (size_t)nv * sizeof *v);
    for (int i = 0; i < nu; i++) {
        for (int j = 0; j < nv; j++) {
            const double x = taut_log(w[(size_t)i * (size_t)nv + (size_t)j]);
            u[i] += x / nv;
            v[j] += x / nu;
        }
        mean += u[i] / nu;
    }
    for (int i = 0; i < nu; i++) {
        u[i] = taut_exp(u[i]);
    }
    for (int j = 0; j < nv; j++) {
        v[j] = taut_exp(v[j] - mean);
    }
}

/* NULL when the factors are all the same; else they are divided by the largest. */
static double *divide_by_largest(int count, double *factors)
{
    double least = INFINITY, largest = 0;
    for (int i = 0; i < count; i++) {
        least = fmin(least, factors[i]);
        largest = fmax(largest, factors[i]);
    }
    for (int i = 0; i < count; i++) {
        factors[i] /= largest;
    }
    return least == largest ? NULL : factors;
}

/* Exact means to within 8 units of rounding of each weight. Otherwise u and v are the geometric
 * means of the rows and columns, the nearest product in the logarithms. weights NULL: all NULL.
 * TAUT_NO_MEMORY. */
static taut_status split_weights(int nu, int nv, const double *weights, taut_arena *arena,
                                 split *made)
{
    const size_t count = (size_t)nu * (size_t)nv;
    double largest = 0;

    memset(made, 0, sizeof *made);
    if (weights == NULL) {
        return TAUT_OK;
    }
    made->u = taut_arena_take(arena, (size_t)nu, sizeof(double));
    made->v = taut_arena_take(arena, (size_t)nv, sizeof(double));
    made->rest = taut_arena_take(arena, count, sizeof(double));
    if (taut_arena_status(arena) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    for (size_t i = 0; i < count; i++) {
        largest = fmax(largest, weights[i]);
    }
    for (size_t i = 0; i < count; i++) {
        made->rest[i] = weights[i] / largest;
    }
    if (is_product(nu, nv, made->rest, made->u, made->v)) {
        made->rest = NULL;
    } else {
        geometric_means(nu, nv, weights, made->u, made->v);
    }
    made->u = divide_by_largest(nu, made->u);
    made->v = divide_by_largest(nv, made->v);
    return TAUT_OK;
}

/* ---- the form ---- */

void taut_dirichlet_form_clear(taut_dirichlet_form *form)
{
    taut_gram_clear(&form->u);
    taut_gram_clear(&form->v);
    taut_dirichlet_rational_free(form->rational);
    taut_free(form->row_sums);
    memset(form, 0, sizeof *form);
}

/* sums[i] = sum_s |A(i,s)|. */
static void absolute_row_sums(const taut_band *band, double *sums)
{
    for (int i = 0; i < band->n; i++) {
        const double *row = taut_band_row(band, i);
        sums[i] += fabs(row[0]);
        for (int d = 1; d <= band->width && d <= i; d++) {
            sums[i] += fabs(row[d]);
            sums[i - d] += fabs(row[d]);
        }
    }
}

static taut_status fill_form(const taut_basis *u, const taut_basis *v, const double *weights,
                             taut_arena *arena, taut_dirichlet_form *form, taut_error *error)
{
    taut_status (*gram_new)(const taut_basis *, const double *, taut_gram *, taut_error *) = NULL;
    split factors;
    taut_status status = TAUT_OK;

    form->nu = taut_basis_count(u);
    form->nv = taut_basis_count(v);
    form->row_sums = taut_alloc_zero(2 * ((size_t)form->nu + (size_t)form->nv), sizeof(double));
    if (form->row_sums == NULL || taut_arena_status(arena) != TAUT_OK ||
        split_weights(form->nu, form->nv, weights, arena, &factors) != TAUT_OK) {
        return taut_fail_memory(error);
    }
    gram_new = factors.rest != NULL ? taut_gram_new_rough : taut_gram_new;
    status = gram_new(u, factors.u, &form->u, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = gram_new(v, factors.v, &form->v, error);
    if (status != TAUT_OK) {
        return status;
    }
    form->fu = form->fv = 1;
    form->ratio = form->v.length / form->u.length;
    absolute_row_sums(&form->u.stiffness, form->row_sums);
    absolute_row_sums(&form->v.stiffness, form->row_sums + form->nu);
    absolute_row_sums(&form->u.mass, form->row_sums + form->nu + form->nv);
    absolute_row_sums(&form->v.mass, form->row_sums + 2 * form->nu + form->nv);
    return factors.rest != NULL
               ? taut_dirichlet_rational_new(u, v, factors.rest, &form->rational, error)
               : TAUT_OK;
}

taut_status taut_dirichlet_form_new(const taut_basis *u, const taut_basis *v, const double *weights,
                                    taut_dirichlet_form *form, taut_error *error)
{
    taut_arena *arena = taut_arena_new();
    taut_dirichlet_form made = {0};
    const taut_status status = fill_form(u, v, weights, arena, &made, error);

    taut_arena_free(arena);
    if (status != TAUT_OK) {
        taut_dirichlet_form_clear(&made);
        return status;
    }
    *form = made;
    return TAUT_OK;
}

static void add_mass(taut_gram *gram)
{
    const size_t size = (size_t)gram->mass.n * ((size_t)gram->mass.width + 1);
    for (size_t i = 0; i < size; i++) {
        gram->stiffness.a[i] += gram->mass.a[i];
    }
}

taut_status taut_dirichlet_form_select(const taut_dirichlet_form *form, const taut_mask *mask,
                                       taut_gram *u, taut_gram *v)
{
    if (taut_gram_select(&form->u, mask->rows, mask->row, u) != TAUT_OK ||
        taut_gram_select(&form->v, mask->columns, mask->column, v) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    if (mask->rows == mask->nu && mask->columns == mask->nv) {
        add_mass(u);
        add_mass(v);
    }
    return TAUT_OK;
}

void taut_dirichlet_form_scale(taut_dirichlet_form *form, double fu, double fv)
{
    form->fu = fu;
    form->fv = fv;
    if (form->rational != NULL) {
        taut_dirichlet_rational_scale(form->rational, fu, fv);
    }
}

static taut_tensor tensor_of(const taut_dirichlet_form *form)
{
    return (taut_tensor){&form->u.stiffness, &form->u.mass, &form->v.stiffness, &form->v.mass,
                         form->fu,           form->fv,      form->crew};
}

taut_status taut_dirichlet_form_apply(const taut_dirichlet_form *form, const double *x, double *y)
{
    const taut_tensor tensor = tensor_of(form);
    if (form->rational != NULL) {
        taut_dirichlet_rational_apply(form->rational, x, y);
        return TAUT_OK;
    }
    return taut_tensor_apply(&tensor, 3, x, y);
}

taut_status taut_dirichlet_form_residual(const taut_dirichlet_form *form, const double *x,
                                         double *y)
{
    const size_t size = 3 * (size_t)form->nu * (size_t)form->nv;
    const taut_tensor tensor = tensor_of(form);
    if (form->rational == NULL) {
        memset(y, 0, size * sizeof(double));
        return taut_tensor_residual(&tensor, 3, y, x, y, NULL);
    }
    taut_dirichlet_rational_apply(form->rational, x, y);
    for (size_t i = 0; i < size; i++) {
        y[i] = -y[i];
    }
    return TAUT_OK;
}

double taut_dirichlet_form_row_sum(const taut_dirichlet_form *form, int i, int j)
{
    const double *ku = form->row_sums, *kv = ku + form->nu;
    const double *mu = kv + form->nv, *mv = mu + form->nu;
    if (form->rational != NULL) {
        return taut_dirichlet_rational_row_sum(form->rational, i, j);
    }
    return form->fu * (ku[i] * mv[j]) + form->fv * (mu[i] * kv[j]);
}

double taut_dirichlet_form_roundings(const taut_dirichlet_form *form)
{
    return form->rational != NULL ? taut_dirichlet_rational_roundings(form->rational) : 1;
}

/* sum_is A(i,s) d_i . d_s over d[i] = x[i * stride] - y[i * stride], points of three numbers. */
static double quadratic_form(const taut_band *band, const double *x, const double *y, size_t stride)
{
    double sum = 0;
    for (int i = 0; i < band->n; i++) {
        const double *row = taut_band_row(band, i);
        for (int e = 0; e <= band->width && e <= i; e++) {
            const size_t at = (size_t)i * stride, before = (size_t)(i - e) * stride;
            double product = 0;
            for (size_t c = 0; c < 3; c++) {
                product += (x[at + c] - y[at + c]) * (x[before + c] - y[before + c]);
            }
            sum += (e > 0 ? 2 : 1) * row[e] * product;
        }
    }
    return sum;
}

/* x^T (K (x) M) x, lines of the first direction `step` numbers apart, points of the second
 * `stride`. The rows of K sum to 0, so x^T K x = - sum_{i>s} K(i,s) |x_i - x_s|^2: no cancellation
 * where x hardly changes. */
static double half_energy(const taut_band *k, size_t step, const taut_band *m, size_t stride,
                          const double *x)
{
    taut_sum sum = {0, 0};
    for (int i = 0; i < k->n; i++) {
        for (int e = 1; e <= k->width && e <= i; e++) {
            taut_sum_add(&sum, -taut_band_row(k, i)[e] * quadratic_form(m, x + (size_t)i * step,
                                                                        x + (size_t)(i - e) * step,
                                                                        stride));
        }
    }
    return 0.5 * fmax(taut_sum_total(&sum), 0);
}

void taut_dirichlet_form_energies(const taut_dirichlet_form *form, const double *x,
                                  double halves[2])
{
    const size_t row = 3 * (size_t)form->nv;
    if (form->rational != NULL) {
        taut_dirichlet_rational_energies(form->rational, x, halves);
    } else {
        halves[0] = half_energy(&form->u.stiffness, row, &form->v.mass, 3, x);
        halves[1] = half_energy(&form->v.stiffness, 3, &form->u.mass, row, x);
    }
    halves[0] *= form->ratio;
    halves[1] /= form->ratio;
}
