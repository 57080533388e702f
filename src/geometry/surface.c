/* surface.c -- the surface object. Evaluation is in surface_eval.c and surface_grid.c. */
#include "taut/surface.h"

#include "core/fail.h"
#include "core/memory.h"
#include "geometry/net.h"

#include <string.h>

struct taut_surface {
    char name[TAUT_NAME_MAX + 1];
    taut_basis *u, *v;
    double *points;
    double *weights;    /* or NULL */
    const char **exact; /* texts of the points, in one block with them; or NULL */
};

static size_t point_count(const taut_basis *u, const taut_basis *v)
{
    return (size_t)taut_basis_count(u) * (size_t)taut_basis_count(v);
}

/* A copy of the texts: the pointers, and behind them the characters. */
static const char **copy_texts(size_t count, const char *const *texts)
{
    const char **copy = NULL;
    char *to = NULL;
    size_t length = 0;
    for (size_t i = 0; i < count; i++) {
        length += texts[i] != NULL ? strlen(texts[i]) + 1 : 0;
    }
    copy = taut_alloc(count * sizeof *copy + length, 1);
    if (copy != NULL) {
        to = (char *)(copy + count);
        for (size_t i = 0; i < count; i++) {
            const size_t size = texts[i] != NULL ? strlen(texts[i]) + 1 : 0;
            copy[i] = size > 0 ? memcpy(to, texts[i], size) : NULL;
            to += size;
        }
    }
    return copy;
}

taut_status taut_surface_new(const char *name, const taut_basis *u, const taut_basis *v,
                             const double *points, const double *weights, taut_surface **surface,
                             taut_error *error)
{
    taut_status status = TAUT_OK;
    taut_surface *made = NULL;

    if (u == NULL || v == NULL || points == NULL) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, "argument", NULL, taut_none, taut_none,
                         "a surface needs two bases and points");
    }
    const size_t count = point_count(u, v);
    const taut_basis *plain = !taut_basis_allows_weights(u)   ? u
                              : !taut_basis_allows_weights(v) ? v
                                                              : NULL;
    status = taut_net_check(name, count, taut_basis_count(v), points, weights, plain, error);
    if (status != TAUT_OK) {
        return status;
    }
    made = taut_alloc_zero(1, sizeof *made);
    if (made == NULL) {
        return taut_fail_memory(error);
    }
    memcpy(made->name, name != NULL ? name : "", name != NULL ? strlen(name) : 0);
    made->points = taut_alloc_aligned(3 * count, sizeof(double));
    made->weights = weights != NULL ? taut_alloc_aligned(count, sizeof(double)) : NULL;
    if (made->points == NULL || (weights != NULL && made->weights == NULL) ||
        taut_basis_copy(u, &made->u) != TAUT_OK || taut_basis_copy(v, &made->v) != TAUT_OK) {
        taut_surface_free(made);
        return taut_fail_memory(error);
    }
    memcpy(made->points, points, 3 * count * sizeof(double));
    if (weights != NULL) {
        memcpy(made->weights, weights, count * sizeof(double));
    }
    *surface = made;
    return TAUT_OK;
}

/* The exact points of a surface that has none yet. */
static taut_status take_texts(taut_surface *surface, const char *const *texts, taut_error *error)
{
    const size_t count = point_count(surface->u, surface->v);
    const taut_status status =
        taut_net_check_exact(count, taut_basis_count(surface->v), texts, error);
    if (status != TAUT_OK) {
        return status;
    }
    surface->exact = copy_texts(3 * count, texts);
    return surface->exact != NULL ? TAUT_OK : taut_fail_memory(error);
}

taut_status taut_surface_new_exact(const char *name, const taut_basis *u, const taut_basis *v,
                                   const double *points, const double *weights,
                                   const char *const *exact, taut_surface **surface,
                                   taut_error *error)
{
    taut_surface *made = NULL;
    taut_status status = taut_surface_new(name, u, v, points, weights, &made, error);
    if (status != TAUT_OK) {
        return status;
    }
    if (exact != NULL) {
        status = take_texts(made, exact, error);
    }
    if (status != TAUT_OK) {
        taut_surface_free(made);
        return status;
    }
    *surface = made;
    return TAUT_OK;
}

taut_status taut_surface_copy(const taut_surface *surface, taut_surface **copy)
{
    if (surface == NULL || copy == NULL) {
        return TAUT_BAD_ARGUMENT;
    }
    return taut_surface_new_exact(surface->name, surface->u, surface->v, surface->points,
                                  surface->weights, surface->exact, copy, NULL);
}

void taut_surface_free(taut_surface *surface)
{
    if (surface != NULL) {
        taut_basis_free(surface->u);
        taut_basis_free(surface->v);
        taut_free(surface->points);
        taut_free(surface->weights);
        taut_free(surface->exact);
        taut_free(surface);
    }
}

const char *taut_surface_name(const taut_surface *surface)
{
    return surface->name;
}

const taut_basis *taut_surface_u(const taut_surface *surface)
{
    return surface->u;
}

const taut_basis *taut_surface_v(const taut_surface *surface)
{
    return surface->v;
}

const double *taut_surface_points(const taut_surface *surface)
{
    return surface->points;
}

const double *taut_surface_weights(const taut_surface *surface)
{
    return surface->weights;
}

const char *const *taut_surface_exact(const taut_surface *surface)
{
    return surface->exact;
}
