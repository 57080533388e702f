#include "geometry/grid/table.h"

#include "core/memory.h"

void taut_table_free(taut_table *table)
{
    if (table != NULL) {
        taut_free(table->first);
        taut_free(table->values);
        taut_free(table);
    }
}

static taut_table *table_alloc(int count, int order, int local)
{
    const size_t rows = (size_t)count * (size_t)(order + 1);
    taut_table *table = taut_alloc_zero(1, sizeof *table);
    if (table == NULL) {
        return NULL;
    }
    *table = (taut_table){count, order, local, NULL, NULL};
    table->first = taut_alloc((size_t)count, sizeof(int));
    table->values = taut_alloc_aligned(rows * (size_t)local, sizeof(double));
    if (table->first == NULL || table->values == NULL) {
        taut_table_free(table);
        return NULL;
    }
    return table;
}

taut_status taut_table_new(const taut_basis *basis, int count, const double *t, const int *spans,
                           int order, taut_table **table)
{
    const int local = taut_basis_local(basis);
    taut_table *made = NULL;

    if (count < 0 || order < 0 || order > TAUT_ORDER_MAX) {
        return TAUT_BAD_ARGUMENT;
    }
    made = table_alloc(count, order, local);
    if (made == NULL) {
        return TAUT_NO_MEMORY;
    }
    for (int i = 0; i < count; i++) {
        const int span = spans != NULL ? spans[i] : taut_basis_span(basis, t[i]);
        double *values = made->values + (size_t)i * (size_t)(order + 1) * (size_t)local;
        if (taut_basis_eval(basis, span, t[i], order, values) != TAUT_OK) {
            taut_table_free(made);
            return TAUT_BAD_ARGUMENT;
        }
        made->first[i] = taut_basis_first(basis, span);
    }
    *table = made;
    return TAUT_OK;
}
