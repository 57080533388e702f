#include "construct/dirichlet/form.h"

#include "construct/common/weights.h"
#include "core/fail.h"
#include "core/memory.h"
#include "numeric/sum.h"
#include "numeric/tensor/apply.h"

#include <math.h>
#include <string.h>

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

taut_status taut_dirichlet_form_new(const taut_basis *u, const taut_basis *v, const double *weights,
                                    taut_dirichlet_form *form, taut_error *error)
{
    taut_dirichlet_form made;
    taut_weights split = {NULL, NULL, NULL};
    taut_status (*gram_new)(const taut_basis *, const double *, taut_gram *, taut_error *) =
        taut_gram_new;
    taut_status status = TAUT_OK;

    memset(&made, 0, sizeof made);
    made.nu = taut_basis_count(u);
    made.nv = taut_basis_count(v);
    status = taut_weights_split(made.nu, made.nv, weights, &split);
    if (status == TAUT_OK) {
        made.row_sums = taut_alloc_zero(2 * ((size_t)made.nu + (size_t)made.nv), sizeof(double));
        status = made.row_sums != NULL ? TAUT_OK : TAUT_NO_MEMORY;
    }
    if (status == TAUT_NO_MEMORY) {
        taut_fail_memory(error);
    }
    gram_new = split.rest != NULL ? taut_gram_new_rough : taut_gram_new;
    if (status == TAUT_OK) {
        status = gram_new(u, split.u, &made.u, error);
    }
    if (status == TAUT_OK) {
        status = gram_new(v, split.v, &made.v, error);
    }
    if (status == TAUT_OK && split.rest != NULL) {
        status = taut_dirichlet_rational_new(u, v, split.rest, &made.rational, error);
    }
    taut_weights_clear(&split);
    if (status != TAUT_OK) {
        taut_dirichlet_form_clear(&made);
        return status;
    }
    made.fu = made.fv = 1;
    made.ratio = made.v.length / made.u.length;
    absolute_row_sums(&made.u.stiffness, made.row_sums);
    absolute_row_sums(&made.v.stiffness, made.row_sums + made.nu);
    absolute_row_sums(&made.u.mass, made.row_sums + made.nu + made.nv);
    absolute_row_sums(&made.v.mass, made.row_sums + 2 * made.nu + made.nv);
    *form = made;
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
    return (taut_tensor){&form->u.stiffness, &form->u.mass, &form->v.stiffness,
                         &form->v.mass,      form->fu,      form->fv};
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
static double quadratic(const taut_band *band, const double *x, const double *y, size_t stride)
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
            taut_sum_add(&sum,
                         -taut_band_row(k, i)[e] * quadratic(m, x + (size_t)i * step,
                                                             x + (size_t)(i - e) * step, stride));
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
