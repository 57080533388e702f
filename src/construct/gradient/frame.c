/* frame.c -- what all derivatives share: arguments, the number's own derivative, the way out. */
#include "construct/gradient/gradient.h"
#include "core/fail.h"

#include <math.h>
#include <string.h>

taut_status taut_gradient_refuse(const char *why, taut_error *error)
{
    return taut_fail(error, TAUT_BAD_ARGUMENT, "no-gradient", NULL, taut_none, taut_none, "%s",
                     why);
}

static taut_status check_request(const taut_gradient_request *request, size_t size,
                                 taut_error *error)
{
    if (request->of != TAUT_GRADIENT_AREA && request->of != TAUT_GRADIENT_DIRICHLET_ENERGY &&
        request->of != TAUT_GRADIENT_POINTS) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, "argument", NULL, taut_none, taut_none,
                         "a gradient is of the area, the Dirichlet energy or the points");
    }
    if ((request->of == TAUT_GRADIENT_POINTS) != (request->factors != NULL)) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, "argument", NULL, taut_none, taut_none,
                         "factors go with a gradient of points, and with no other");
    }
    for (size_t i = 0; request->factors != NULL && i < size; i++) {
        if (!isfinite(request->factors[i])) {
            return taut_fail_expected(error, TAUT_BAD_ARGUMENT, "argument", NULL,
                                      request->factors[i], "finite factors", "found %.17g",
                                      request->factors[i]);
        }
    }
    return TAUT_OK;
}

static taut_status refuse_model(const char *why, taut_error *error)
{
    return taut_fail(error, TAUT_BAD_ARGUMENT, "other-model", NULL, taut_none, taut_none,
                     "the model is not the one of this problem: %s", why);
}

/* Its surface is on the net, and goes through what is known, bit for bit. */
static taut_status check_model(const taut_gradient_net *net, const taut_model *model,
                               taut_error *error)
{
    const int nu = taut_basis_count(net->u), nv = taut_basis_count(net->v);
    const taut_surface *surface = taut_model_surface(model, 0);

    if (surface == NULL || taut_basis_count(taut_surface_u(surface)) != nu ||
        taut_basis_count(taut_surface_v(surface)) != nv) {
        return refuse_model("its net is of another size", error);
    }
    for (size_t i = 0; i < (size_t)nu * (size_t)nv; i++) {
        if (!net->is_near && net->known[i] &&
            memcmp(net->points + 3 * i, taut_surface_points(surface) + 3 * i, 3 * sizeof(double)) !=
                0) {
            return refuse_model("a known point is elsewhere", error);
        }
    }
    return TAUT_OK;
}

/* Writes the gradient, where every number is one. */
static taut_status hand_over(size_t size, const double *seed, double *gradient, taut_error *error)
{
    for (size_t i = 0; i < size; i++) {
        if (!isfinite(seed[i])) {
            return taut_gradient_refuse("a derivative is beyond the range of double precision",
                                        error);
        }
    }
    memcpy(gradient, seed, size * sizeof(double));
    return TAUT_OK;
}

taut_status taut_gradient_run(const taut_gradient_net *net, const taut_model *model,
                              const taut_gradient_request *request, taut_gradient_pull *pull,
                              const void *context, double *gradient, taut_error *error)
{
    static const taut_gradient_request none;
    const taut_gradient_request *asked = request != NULL ? request : &none;
    taut_arena *arena = NULL;
    double *seed = NULL;
    taut_status status = TAUT_OK;

    if (model == NULL || gradient == NULL || net->u == NULL || net->v == NULL ||
        net->points == NULL || net->known == NULL) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, "argument", NULL, taut_none, taut_none,
                         "a gradient needs a problem with its net, its model and a place");
    }
    const size_t size = 3 * (size_t)taut_basis_count(net->u) * (size_t)taut_basis_count(net->v);
    status = check_request(asked, size, error);
    status = status == TAUT_OK ? check_model(net, model, error) : status;
    if (status != TAUT_OK) {
        return status;
    }
    arena = taut_arena_new();
    seed = taut_arena_take(arena, size, sizeof(double));
    if (seed == NULL) {
        taut_arena_free(arena);
        return taut_fail_memory(error);
    }
    status = taut_gradient_of_surface(taut_model_surface(model, 0), asked, arena, seed, error);
    status = status == TAUT_OK
                 ? pull(context, taut_model_surface(model, 0), asked, arena, seed, error)
                 : status;
    status = status == TAUT_OK ? hand_over(size, seed, gradient, error) : status;
    taut_arena_free(arena);
    return status;
}
