#include "construct/greville.h"

#include "core/memory.h"
#include "geometry/table.h"
#include "numeric/quadrature.h"

#include <math.h>
#include <string.h>

enum { NODES = 12 };

/* Knots in the full form, count + degree + 1 of them, or the form without the outermost two. */
static void mean_knots(const taut_basis_spec *spec, int count, double *t)
{
    const int dropped = spec->knot_count == count + spec->degree - 1;
    for (int i = 0; i < count; i++) {
        const double *inner = spec->knots + i + 1 - dropped;
        t[i] = 0;
        for (int k = 0; k < spec->degree; k++) {
            t[i] += inner[k] / spec->degree;
        }
    }
}

static taut_status centroids(const taut_basis *basis, double *t)
{
    const int count = taut_basis_count(basis), spans = taut_basis_span_count(basis);
    const double *breaks = taut_basis_breaks(basis);
    double node[NODES], weight[NODES];
    double *at = taut_alloc((size_t)spans * NODES, sizeof(double));
    double *mass = taut_alloc_zero((size_t)count, sizeof(double));
    taut_table *table = NULL;
    taut_status status = at != NULL && mass != NULL ? TAUT_OK : TAUT_NO_MEMORY;

    taut_gauss_rule(NODES, node, weight);
    for (int k = 0; status == TAUT_OK && k < spans * NODES; k++) {
        const double lo = breaks[k / NODES], hi = breaks[k / NODES + 1];
        at[k] = lo + (hi - lo) * (0.5 + 0.5 * node[k % NODES]);
    }
    if (status == TAUT_OK) {
        status = taut_table_new(basis, spans * NODES, at, NULL, 0, &table);
    }
    memset(t, 0, (size_t)count * sizeof *t);
    for (int k = 0; status == TAUT_OK && k < spans * NODES; k++) {
        const double width = breaks[k / NODES + 1] - breaks[k / NODES];
        for (int a = 0; a < table->local; a++) {
            const double share = taut_table_row(table, k, 0)[a] * weight[k % NODES] * width;
            t[table->first[k] + a] += share * at[k];
            mass[table->first[k] + a] += share;
        }
    }
    for (int i = 0; status == TAUT_OK && i < count; i++) {
        t[i] /= mass[i];
    }
    taut_table_free(table);
    taut_free(at);
    taut_free(mass);
    return status;
}

taut_status taut_greville(const taut_basis *basis, double *t)
{
    const int count = taut_basis_count(basis);
    const double lo = taut_basis_lo(basis), hi = taut_basis_hi(basis);
    taut_basis_spec spec;
    taut_status status = TAUT_OK;

    taut_basis_spec_of(basis, &spec);
    if (strcmp(spec.type, "bezier") == 0) {
        for (int i = 0; i < count; i++) {
            t[i] = lo + (hi - lo) * i / spec.degree;
        }
    } else if (strcmp(spec.type, "bspline") == 0 && spec.knots != NULL) {
        mean_knots(&spec, count, t);
    } else {
        status = centroids(basis, t);
    }
    for (int i = 0; status == TAUT_OK && i < count; i++) {
        t[i] = fmin(hi, fmax(lo, t[i]));
    }
    return status;
}
