/* fit.c -- the spline through given points: a system for each direction, one after the other ([PieglTiller1997] 9.2.5). Edges of
 * the net are splines through edges of the points, whatever is inside: what agrees along an edge goes on to agree. */
#include "core/memory.h"
#include "numeric/strip.h"
#include "shell/thick/parts.h"

#include <math.h>

void taut_thick_nodes(const taut_basis *basis, double *nodes)
{
    taut_basis_spec spec;
    taut_basis_spec_of(basis, &spec);
    for (int i = 0; i < taut_basis_count(basis); i++) {
        double sum = 0;
        for (int k = 1; k <= spec.degree; k++) {
            sum += spec.knots[i + k];
        }
        nodes[i] = fmin(sum / spec.degree, 1);
    }
}

/* The functions at the nodes, factored, [count][2 degree + 1]; NULL where memory runs out. */
static double *system_of(const taut_basis *basis)
{
    const int n = taut_basis_count(basis), degree = taut_basis_degree(basis);
    const size_t across = 2 * (size_t)degree + 1;
    double *nodes = taut_alloc((size_t)n, sizeof *nodes);
    double *a = taut_alloc_zero((size_t)n * across, sizeof *a);
    for (int i = 0; nodes != NULL && a != NULL && i < n; i++) {
        double values[TAUT_THICK_DEGREE + 1];
        i == 0 ? taut_thick_nodes(basis, nodes) : (void)0;
        const int span = taut_basis_span(basis, nodes[i]), first = taut_basis_first(basis, span);
        taut_basis_eval(basis, span, nodes[i], 0, values);
        for (int k = 0; k <= degree; k++) {
            const int at = degree + first + k -
                           i; /* what is outside the band is 0: a node is within its function */
            if (at >= 0 && at < (int)across) {
                a[(size_t)i * across + (size_t)at] = values[k];
            }
        }
    }
    if (nodes == NULL || a == NULL || !taut_strip_factor(n, degree, a)) {
        taut_free(a);
        a = NULL;
    }
    taut_free(nodes);
    return a;
}

taut_status taut_thick_fit(const taut_basis *u, const taut_basis *v, double *values)
{
    const int nu = taut_basis_count(u), nv = taut_basis_count(v);
    const size_t row = 3 * (size_t)nv;
    double *along_u = system_of(u), *along_v = system_of(v);
    const taut_status status = along_u != NULL && along_v != NULL ? TAUT_OK : TAUT_NO_MEMORY;
    if (status == TAUT_OK) {
        taut_strip_solve(nu, TAUT_THICK_DEGREE, along_u, row, row, values);
        for (int i = 0; i < nu; i++) {
            taut_strip_solve(nv, TAUT_THICK_DEGREE, along_v, 3, 3, values + (size_t)i * row);
        }
    }
    taut_free(along_u);
    taut_free(along_v);
    return status;
}
