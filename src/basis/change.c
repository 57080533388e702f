#include "basis/change.h"

#include "core/fail.h"
#include "core/memory.h"

#include <string.h>

static taut_status fill_change(const taut_basis_spec *to, int functions, int width,
                               taut_change *change, taut_error *error)
{
    const taut_status status = taut_basis_new(to, functions, &change->to, error);
    if (status != TAUT_OK) {
        return status;
    }
    const size_t count = (size_t)taut_basis_count(change->to);
    change->width = width;
    change->first = taut_alloc_zero(count, sizeof(int));
    change->rows = taut_alloc_zero(count * (size_t)width, sizeof(double));
    return change->first != NULL && change->rows != NULL ? TAUT_OK : taut_fail_memory(error);
}

taut_status taut_change_new(const taut_basis_spec *to, int functions, int width,
                            taut_change **change, taut_error *error)
{
    taut_change *made = taut_alloc_zero(1, sizeof *made);
    if (made == NULL) {
        return taut_fail_memory(error);
    }
    const taut_status status = fill_change(to, functions, width, made, error);
    if (status != TAUT_OK) {
        taut_change_free(made);
        return status;
    }
    *change = made;
    return TAUT_OK;
}

void taut_change_free(taut_change *change)
{
    if (change != NULL) {
        taut_basis_free(change->to);
        taut_free(change->first);
        taut_free(change->rows);
        taut_free(change);
    }
}

double *taut_change_row(const taut_change *change, int i)
{
    return change->rows + (size_t)i * (size_t)change->width;
}

taut_status taut_change_select(const taut_basis_spec *to, int functions, int from, int reversed,
                               taut_change **change, taut_error *error)
{
    const taut_status status = taut_change_new(to, functions, 1, change, error);
    if (status != TAUT_OK) {
        return status;
    }
    const int count = taut_basis_count((*change)->to);
    for (int i = 0; i < count; i++) {
        (*change)->first[i] = from + (reversed ? count - 1 - i : i);
        (*change)->rows[i] = 1;
    }
    return TAUT_OK;
}

/* The old coefficients that row i of b, through a, takes: [*low, *high). */
static void reach_of_row(const taut_change *a, const taut_change *b, int i, int *low, int *high)
{
    const double *row = taut_change_row(b, i);
    *low = -1;
    *high = 0;
    for (int m = 0; m < b->width; m++) {
        if (row[m] != 0) {
            const int first = a->first[b->first[i] + m];
            *low = *low < 0 || first < *low ? first : *low;
            *high = first + a->width > *high ? first + a->width : *high;
        }
    }
    *low = *low < 0 ? 0 : *low;
}

taut_status taut_change_compose(const taut_change *a, const taut_change *b, taut_change **change,
                                taut_error *error)
{
    const int count = taut_basis_count(b->to);
    taut_basis_spec spec;
    taut_status status = TAUT_OK;
    int width = 1;

    for (int i = 0; i < count; i++) {
        int low = 0, high = 0;
        reach_of_row(a, b, i, &low, &high);
        width = high - low > width ? high - low : width;
    }
    taut_basis_spec_of(b->to, &spec);
    status = taut_change_new(&spec, count, width, change, error);
    for (int i = 0; status == TAUT_OK && i < count; i++) {
        const double *row = taut_change_row(b, i);
        double *sum = taut_change_row(*change, i);
        int low = 0, high = 0;
        reach_of_row(a, b, i, &low, &high);
        (*change)->first[i] = low;
        for (int m = 0; m < b->width; m++) {
            const int middle = b->first[i] + m;
            for (int c = 0; row[m] != 0 && c < a->width; c++) {
                sum[a->first[middle] + c - low] += row[m] * taut_change_row(a, middle)[c];
            }
        }
    }
    return status;
}

taut_status taut_change_list_new(int count, taut_change_list *list, taut_error *error)
{
    taut_change **items = taut_alloc_zero((size_t)count, sizeof *items);
    if (items == NULL) {
        return taut_fail_memory(error);
    }
    *list = (taut_change_list){count, items};
    return TAUT_OK;
}

void taut_change_list_free(taut_change_list *list)
{
    for (int i = 0; i < list->count; i++) {
        taut_change_free(list->items[i]);
    }
    taut_free(list->items);
    *list = (taut_change_list){0, NULL};
}

taut_status taut_change_list_done(taut_status status, taut_change_list *list)
{
    if (status != TAUT_OK) {
        taut_change_list_free(list);
    }
    return status;
}

taut_status taut_change_whole(const taut_basis *basis, taut_change_list *list, taut_error *error)
{
    taut_status status = taut_change_list_new(1, list, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = taut_change_select(&basis->spec, 0, 0, 0, &list->items[0], error);
    return taut_change_list_done(status, list);
}

taut_status taut_change_reverse(const taut_basis *basis, taut_change **change, taut_error *error)
{
    return taut_change_select(&basis->spec, 0, 0, 1, change, error);
}

taut_status taut_change_rerange(const taut_basis *basis, double lo, double hi, taut_change **change,
                                taut_error *error)
{
    taut_basis_spec spec = basis->spec;
    spec.has_range = 1;
    spec.range[0] = lo;
    spec.range[1] = hi;
    return taut_change_select(&spec, 0, 0, 0, change, error);
}

void taut_change_apply(const taut_change *change, size_t blocks, int old_count, size_t inner,
                       const double *in, double *out)
{
    const size_t count = (size_t)taut_basis_count(change->to);
    for (size_t b = 0; b < blocks; b++) {
        for (size_t i = 0; i < count; i++) {
            const double *row = change->rows + i * (size_t)change->width;
            const double *from = in + (b * (size_t)old_count + (size_t)change->first[i]) * inner;
            double *to = out + (b * count + i) * inner;
            memset(to, 0, inner * sizeof(double));
            for (int a = 0; a < change->width; a++) {
                for (size_t c = 0; row[a] != 0 && c < inner; c++) {
                    to[c] += row[a] * from[(size_t)a * inner + c];
                }
            }
        }
    }
}
