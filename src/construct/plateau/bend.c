#include "construct/plateau/bend.h"

#include "core/fail.h"
#include "core/memory.h"
#include "core/vec3.h"
#include "numeric/quadrature.h"
#include "taut/operations.h"

#include <math.h>
#include <string.h>

enum { NODES = 4 };
static const double share = 0.7; /* of the bending, in the spans that are cut */
static const int many = 4;       /* times as many as there are: all are cut */

/* Nodes and weights over all spans. */
typedef struct line {
    int spans;
    double *t, *weight; /* [spans * NODES] */
    double *bending;    /* [spans] */
} line;

static void line_clear(line *l)
{
    taut_free(l->t);
    taut_free(l->weight);
    taut_free(l->bending);
}

static taut_status line_new(const taut_basis *basis, line *l)
{
    const double *breaks = taut_basis_breaks(basis);
    const double range = taut_basis_hi(basis) - taut_basis_lo(basis);
    double node[NODES], weight[NODES];

    l->spans = taut_basis_span_count(basis);
    l->t = taut_alloc((size_t)l->spans * NODES, sizeof(double));
    l->weight = taut_alloc((size_t)l->spans * NODES, sizeof(double));
    l->bending = taut_alloc_zero((size_t)l->spans, sizeof(double));
    if (l->t == NULL || l->weight == NULL || l->bending == NULL) {
        return TAUT_NO_MEMORY;
    }
    taut_gauss_rule(NODES, node, weight);
    for (int k = 0; k < l->spans * NODES; k++) {
        const double lo = breaks[k / NODES], hi = breaks[k / NODES + 1];
        l->t[k] = lo + (hi - lo) * (0.5 + 0.5 * node[k % NODES]);
        l->weight[k] = weight[k % NODES] * ((hi - lo) / range);
    }
    return TAUT_OK;
}

/* |H|^2 W from x, x_u, x_v, x_uu, x_uv, x_vv; 0 where there is no normal. */
static double bending_of(const double *jet)
{
    const double *xu = jet + 3, *xv = jet + 6;
    const double e = taut_dot(xu, xu), f = taut_dot(xu, xv), g = taut_dot(xv, xv);
    double normal[3];

    taut_cross(xu, xv, normal);
    const double w = taut_norm(normal);
    const double twice = (taut_dot(jet + 9, normal) * g - 2 * taut_dot(jet + 12, normal) * f +
                          taut_dot(jet + 15, normal) * e) /
                         (w * w * w); /* 2 H */
    return isfinite(twice) && w > 1e-12 * sqrt(e * g) ? 0.25 * twice * twice * w : 0;
}

static taut_status measure(const taut_surface *surface, line *u, line *v)
{
    const size_t count = (size_t)v->spans * NODES;
    double *jets = taut_alloc_aligned(count, 18 * sizeof(double));
    taut_status status = jets != NULL ? TAUT_OK : TAUT_NO_MEMORY;

    for (int i = 0; status == TAUT_OK && i < u->spans * NODES; i++) {
        status = taut_surface_eval_grid(surface, 1, u->t + i, v->spans * NODES, v->t, 2, 1, jets);
        for (size_t j = 0; status == TAUT_OK && j < count; j++) {
            const double part = u->weight[i] * v->weight[j] * bending_of(jets + 18 * j);
            u->bending[i / NODES] += part;
            v->bending[j / NODES] += part;
        }
    }
    taut_free(jets);
    return status;
}

/* How few spans hold the share; their places in bending become -1. */
static int choose(line *l)
{
    double left = 0;
    int chosen = 0;

    for (int s = 0; s < l->spans; s++) {
        left += share * l->bending[s];
    }
    for (; chosen < l->spans && (chosen == 0 || left > 0); chosen++) {
        int most = 0;
        for (int s = 1; s < l->spans; s++) {
            most = l->bending[s] > l->bending[most] ? s : most;
        }
        left -= l->bending[most];
        l->bending[most] = -1;
    }
    return chosen;
}

/* Cuts the spans chosen; all of them where those are many, since even knots serve better. */
static taut_status cut(const taut_basis *basis, line *l, int direction, taut_surface **surface,
                       taut_error *error)
{
    const double *breaks = taut_basis_breaks(basis);
    const int all = many * choose(l) > l->spans;
    taut_status status = TAUT_OK;

    for (int s = 0; status == TAUT_OK && s < l->spans; s++) {
        taut_surface *next = NULL;
        if (!all && l->bending[s] >= 0) {
            continue;
        }
        status = taut_surface_insert(*surface, direction, 0.5 * breaks[s] + 0.5 * breaks[s + 1], 1,
                                     &next, error);
        if (status == TAUT_OK) {
            taut_surface_free(*surface);
            *surface = next;
        }
    }
    return status;
}

taut_status taut_plateau_insert(const taut_surface *surface, taut_surface **finer,
                                taut_error *error)
{
    line u = {0, NULL, NULL, NULL}, v = {0, NULL, NULL, NULL};
    taut_surface *made = NULL;
    taut_status status = line_new(taut_surface_u(surface), &u);

    if (status == TAUT_OK) {
        status = line_new(taut_surface_v(surface), &v);
    }
    if (status == TAUT_OK) {
        status = measure(surface, &u, &v);
    }
    if (status == TAUT_OK) {
        status = taut_surface_copy(surface, &made);
    }
    if (status != TAUT_OK) {
        status = taut_fail_memory(error);
    } else {
        status = cut(taut_surface_u(surface), &u, TAUT_ALONG_U, &made, error);
    }
    if (status == TAUT_OK) {
        status = cut(taut_surface_v(surface), &v, TAUT_ALONG_V, &made, error);
    }
    line_clear(&u);
    line_clear(&v);
    if (status != TAUT_OK) {
        taut_surface_free(made);
        return status;
    }
    *finer = made;
    return TAUT_OK;
}
