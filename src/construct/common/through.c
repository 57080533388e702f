#include "construct/common/through.h"

#include "core/constants.h"
#include "core/fail.h"

#include <math.h>
#include <stdio.h>

static taut_status refuse(int k, const char *member, double found, const char *expected,
                          taut_error *error)
{
    char where[64];
    snprintf(where, sizeof where, "/through/%d/%s", k, member);
    return taut_fail_expected(error, TAUT_BAD_INPUT, "value", where, found, expected, "found %.17g",
                              found);
}

static int is_within(const taut_basis *basis, double t)
{
    return t >= taut_basis_lo(basis) && t <= taut_basis_hi(basis);
}

taut_status taut_through_check(const taut_basis *u, const taut_basis *v,
                               const taut_through *through, int count, taut_error *error)
{
    if (count < 0 || count > TAUT_THROUGH_MAX || (count > 0 && through == NULL)) {
        return taut_fail(error, TAUT_BAD_INPUT, "size", "/through", count, TAUT_THROUGH_MAX,
                         "%d points to pass through, expected at most %d", count, TAUT_THROUGH_MAX);
    }
    for (int k = 0; k < count; k++) {
        const taut_through *at = &through[k];
        const int is_free = isnan(at->u) && isnan(at->v);
        for (int c = 0; c < 3; c++) {
            if (!isfinite(at->point[c])) {
                return refuse(k, "point", at->point[c], "a finite number", error);
            }
        }
        if (!is_free && !is_within(u, at->u)) {
            return refuse(k, "u", at->u, "a parameter in the range of u", error);
        }
        if (!is_free && !is_within(v, at->v)) {
            return refuse(k, "v", at->v, "a parameter in the range of v", error);
        }
    }
    return TAUT_OK;
}

static void fill_condition(const taut_basis *const basis[2], const double *weights,
                           const double t[2], double *const values[2], const int local[2],
                           taut_condition *to)
{
    const size_t nv = (size_t)taut_basis_count(basis[1]);
    double sum = 0;

    for (int d = 0; d < 2; d++) {
        const int span = taut_basis_span(basis[d], t[d]);
        taut_basis_eval(basis[d], span, t[d], 0, values[d]);
        to->first[d] = taut_basis_first(basis[d], span);
    }
    for (int a = 0; a < local[0]; a++) {
        for (int b = 0; b < local[1]; b++) {
            const size_t at = (size_t)(to->first[0] + a) * nv + (size_t)(to->first[1] + b);
            const double weight = weights != NULL ? weights[at] : 1;
            to->coefficients[a * local[1] + b] = values[0][a] * values[1][b] * weight;
            sum += to->coefficients[a * local[1] + b];
        }
    }
    for (int k = 0; weights != NULL && k < local[0] * local[1]; k++) {
        to->coefficients[k] /= sum;
    }
}

taut_status taut_conditions_new(const taut_basis *u, const taut_basis *v, const double *weights,
                                const taut_through *through, int count, taut_arena *arena,
                                taut_conditions *conditions)
{
    const taut_basis *const basis[2] = {u, v};
    const int local[2] = {taut_basis_local(u), taut_basis_local(v)};
    double *const values[2] = {taut_arena_take(arena, (size_t)local[0], sizeof(double)),
                               taut_arena_take(arena, (size_t)local[1], sizeof(double))};

    *conditions = (taut_conditions){count, taut_basis_count(v), {local[0], local[1]}, NULL};
    conditions->at = taut_arena_take(arena, (size_t)count, sizeof *conditions->at);
    for (int k = 0; k < count && taut_arena_status(arena) == TAUT_OK; k++) {
        taut_condition *to = &conditions->at[k];
        to->coefficients =
            taut_arena_take(arena, (size_t)local[0] * (size_t)local[1], sizeof(double));
        if (to->coefficients == NULL) {
            return TAUT_NO_MEMORY;
        }
        for (int c = 0; c < 3; c++) {
            to->point[c] = through[k].point[c];
        }
        fill_condition(basis, weights, (const double[2]){through[k].u, through[k].v}, values, local,
                       to);
    }
    return taut_arena_status(arena);
}

double taut_condition_sum(const taut_conditions *all, int k, const double *net, int component)
{
    const taut_condition *at = &all->at[k];
    double sum = 0;
    for (int a = 0; a < all->local[0]; a++) {
        const double *row =
            net + 3 * ((size_t)(at->first[0] + a) * (size_t)all->nv + (size_t)at->first[1]);
        for (int b = 0; b < all->local[1]; b++) {
            sum += at->coefficients[a * all->local[1] + b] * row[3 * b + component];
        }
    }
    return sum;
}

void taut_condition_add(const taut_conditions *all, int k, double factor, double *net,
                        int component)
{
    const taut_condition *at = &all->at[k];
    for (int a = 0; a < all->local[0]; a++) {
        double *row =
            net + 3 * ((size_t)(at->first[0] + a) * (size_t)all->nv + (size_t)at->first[1]);
        for (int b = 0; b < all->local[1]; b++) {
            row[3 * b + component] += factor * at->coefficients[a * all->local[1] + b];
        }
    }
}

void taut_through_describe(const taut_through *through, int count, taut_record *details)
{
    taut_record *list = taut_record_add_list(details, "through");

    for (int k = 0; k < count; k++) {
        taut_record *at = taut_record_add_object(list, NULL);
        taut_record_add_number(at, "u", through[k].u);
        taut_record_add_number(at, "v", through[k].v);
    }
}
