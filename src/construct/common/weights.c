#include "construct/common/weights.h"

#include "core/memory.h"

#include <math.h>
#include <stddef.h>
#include <string.h>

void taut_weights_clear(taut_weights *split)
{
    taut_free(split->u);
    taut_free(split->v);
    taut_free(split->rest);
    memset(split, 0, sizeof *split);
}

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
            if (!(fabs(u[i] * v[j] - wij) <= 8 * 0x1p-53 * wij)) {
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
            const double x = log(w[(size_t)i * (size_t)nv + (size_t)j]);
            u[i] += x / nv;
            v[j] += x / nu;
        }
        mean += u[i] / nu;
    }
    for (int i = 0; i < nu; i++) {
        u[i] = exp(u[i]);
    }
    for (int j = 0; j < nv; j++) {
        v[j] = exp(v[j] - mean);
    }
}

/* Frees *factors when they are all the same; else divides them by the largest. */
static void tidy(int count, double **factors)
{
    double least = INFINITY, largest = 0;
    for (int i = 0; i < count; i++) {
        least = fmin(least, (*factors)[i]);
        largest = fmax(largest, (*factors)[i]);
    }
    for (int i = 0; i < count; i++) {
        (*factors)[i] /= largest;
    }
    if (least == largest) {
        taut_free(*factors);
        *factors = NULL;
    }
}

taut_status taut_weights_split(int nu, int nv, const double *weights, taut_weights *split)
{
    const size_t count = (size_t)nu * (size_t)nv;
    taut_weights made = {NULL, NULL, NULL};
    double largest = 0;

    *split = made;
    if (weights == NULL) {
        return TAUT_OK;
    }
    made.u = taut_alloc((size_t)nu, sizeof(double));
    made.v = taut_alloc((size_t)nv, sizeof(double));
    made.rest = taut_alloc(count, sizeof(double));
    if (made.u == NULL || made.v == NULL || made.rest == NULL) {
        taut_weights_clear(&made);
        return TAUT_NO_MEMORY;
    }
    for (size_t i = 0; i < count; i++) {
        largest = fmax(largest, weights[i]);
    }
    for (size_t i = 0; i < count; i++) {
        made.rest[i] = weights[i] / largest;
    }
    if (is_product(nu, nv, made.rest, made.u, made.v)) {
        taut_free(made.rest);
        made.rest = NULL;
    } else {
        geometric_means(nu, nv, weights, made.u, made.v);
    }
    tidy(nu, &made.u);
    tidy(nv, &made.v);
    *split = made;
    return TAUT_OK;
}
