#include "construct/dirichlet_form.h"

#include "construct/weights.h"
#include "core/fail.h"
#include "core/memory.h"
#include "numeric/sum.h"

#include <math.h>
#include <string.h>

void taut_dirichlet_form_clear(taut_dirichlet_form *form)
{
    taut_gram_clear(&form->u);
    taut_gram_clear(&form->v);
    taut_dirichlet_rational_free(form->rational);
    taut_free(form->scratch);
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

static taut_status alloc(taut_dirichlet_form *form)
{
    const size_t lines = (size_t)form->nu + (size_t)form->nv;
    form->scratch = taut_alloc_aligned(6 * (size_t)form->nv, sizeof(double));
    form->row_sums = taut_alloc_zero(2 * lines, sizeof(double));
    return form->scratch != NULL && form->row_sums != NULL ? TAUT_OK : TAUT_NO_MEMORY;
}

taut_status taut_dirichlet_form_new(const taut_basis *u, const taut_basis *v, const double *weights,
                                    taut_dirichlet_form *form, taut_error *error)
{
    taut_dirichlet_form made;
    taut_weights split = {NULL, NULL, NULL};
    taut_status status = TAUT_OK;

    memset(&made, 0, sizeof made);
    made.nu = taut_basis_count(u);
    made.nv = taut_basis_count(v);
    status = taut_weights_split(made.nu, made.nv, weights, &split);
    if (status == TAUT_OK) {
        status = alloc(&made);
    }
    if (status == TAUT_NO_MEMORY) {
        taut_fail_memory(error);
    }
    if (status == TAUT_OK) {
        status = taut_gram_new(u, split.u, &made.u, error);
    }
    if (status == TAUT_OK) {
        status = taut_gram_new(v, split.v, &made.v, error);
    }
    if (status == TAUT_OK && split.rest != NULL) {
        status = taut_dirichlet_rational_new(u, v, split.rest, &made.rational, error);
    }
    taut_weights_clear(&split);
    if (status != TAUT_OK) {
        taut_dirichlet_form_clear(&made);
        return status;
    }
    made.ratio = made.v.length / made.u.length;
    absolute_row_sums(&made.u.stiffness, made.row_sums);
    absolute_row_sums(&made.v.stiffness, made.row_sums + made.nu);
    absolute_row_sums(&made.u.mass, made.row_sums + made.nu + made.nv);
    absolute_row_sums(&made.v.mass, made.row_sums + 2 * made.nu + made.nv);
    *form = made;
    return TAUT_OK;
}

/* out = sum_s A(i,s) x[s], rows of `length` numbers. */
static void combine_rows(const taut_band *band, int i, size_t length, const double *x, double *out)
{
    const int n = band->n, width = band->width;
    const int from = i - width > 0 ? i - width : 0, to = i + width < n - 1 ? i + width : n - 1;

    memset(out, 0, length * sizeof(double));
    for (int s = from; s <= to; s++) {
        const double a = s <= i ? taut_band_row(band, i)[i - s] : taut_band_row(band, s)[s - i];
        const double *row = x + (size_t)s * length;
        for (size_t c = 0; c < length; c++) {
            out[c] += a * row[c];
        }
    }
}

/* y[j] += factor sum_t A(j,t) x[t], points of three numbers. */
static void add_along_row(const taut_band *band, double factor, const double *x, double *y)
{
    for (int j = 0; j < band->n; j++) {
        const double *row = taut_band_row(band, j);
        const int reach = band->width < j ? band->width : j;
        double *yj = y + 3 * (size_t)j;
        for (int d = 0; d <= reach; d++) {
            const double a = factor * row[d];
            const double *xt = x + 3 * (size_t)(j - d);
            yj[0] += a * xt[0];
            yj[1] += a * xt[1];
            yj[2] += a * xt[2];
        }
        for (int d = 1; d <= reach; d++) {
            const double a = factor * row[d];
            double *yt = y + 3 * (size_t)(j - d);
            const double *xj = x + 3 * (size_t)j;
            yt[0] += a * xj[0];
            yt[1] += a * xj[1];
            yt[2] += a * xj[2];
        }
    }
}

void taut_dirichlet_form_apply(const taut_dirichlet_form *form, double fu, double fv,
                               const double *x, double *y)
{
    const size_t length = 3 * (size_t)form->nv;
    double *sloped = form->scratch, *massed = form->scratch + length;

    if (form->rational != NULL) {
        taut_dirichlet_rational_apply(form->rational, fu, fv, x, y);
        return;
    }
    for (int i = 0; i < form->nu; i++) {
        double *row = y + (size_t)i * length;
        combine_rows(&form->u.stiffness, i, length, x, sloped);
        combine_rows(&form->u.mass, i, length, x, massed);
        memset(row, 0, length * sizeof(double));
        add_along_row(&form->v.mass, fu, sloped, row);
        add_along_row(&form->v.stiffness, fv, massed, row);
    }
}

double taut_dirichlet_form_row_sum(const taut_dirichlet_form *form, double fu, double fv, int i,
                                   int j)
{
    const double *ku = form->row_sums, *kv = ku + form->nu;
    const double *mu = kv + form->nv, *mv = mu + form->nu;
    return fu * (ku[i] * mv[j]) + fv * (mu[i] * kv[j]);
}

void taut_dirichlet_form_energies(const taut_dirichlet_form *form, const double *x, double *y,
                                  double halves[2])
{
    const size_t count = 3 * (size_t)form->nu * (size_t)form->nv;
    for (int k = 0; k < 2; k++) {
        taut_sum sum = {0, 0};
        taut_dirichlet_form_apply(form, k == 0, k == 1, x, y);
        for (size_t i = 0; i < count; i++) {
            taut_sum_add(&sum, x[i] * y[i]);
        }
        halves[k] = 0.5 * fmax(taut_sum_total(&sum), 0);
        halves[k] = k == 0 ? halves[k] * form->ratio : halves[k] / form->ratio;
    }
}
