#include "construct/plateau/trust_region_step.h"

#include "core/memory.h"

#include <math.h>
#include <string.h>

double taut_largest(size_t count, const double *x)
{
    double largest = 0;
    for (size_t i = 0; i < count; i++) {
        largest = fmax(largest, fabs(x[i]));
    }
    return largest;
}

void taut_walk_look(taut_walk *w, taut_place *at)
{
    at->value = taut_film_gradient(w->film, at->net, at->gradient);
    taut_film_solver_reduce(w->solver, at->gradient, w->image);
    const double all = taut_largest(3 * w->count, at->gradient);
    at->residual = all > 0 ? taut_largest(w->size, w->image) / all : 0;
}

void taut_walk_clear(taut_walk *w)
{
    taut_free(w->here.gradient);
    taut_free(w->there.gradient);
    taut_free(w->there.net);
    taut_free(w->right);
    taut_free(w->step);
    taut_free(w->image);
    taut_free(w->turn);
    taut_free(w->move);
    taut_free(w->bend);
}

taut_status taut_walk_new(taut_film *film, taut_film_solver *solver, taut_descent *descent,
                          double *net, taut_walk *w)
{
    memset(w, 0, sizeof *w);
    w->film = film;
    w->solver = solver;
    w->descent = descent;
    w->count = (size_t)film->nu * (size_t)film->nv;
    w->size = (size_t)taut_film_solver_parts(solver) * w->count;
    w->here.net = net;
    w->here.gradient = taut_alloc_aligned(3 * w->count, sizeof(double));
    w->there.gradient = taut_alloc_aligned(3 * w->count, sizeof(double));
    w->there.net = taut_alloc_aligned(3 * w->count, sizeof(double));
    w->right = taut_alloc_aligned(w->size, sizeof(double));
    w->step = taut_alloc_aligned(w->size, sizeof(double));
    w->image = taut_alloc_aligned(w->size, sizeof(double));
    w->turn = taut_alloc_aligned(w->size, sizeof(double));
    w->move = taut_alloc_aligned(3 * w->count, sizeof(double));
    w->bend = taut_alloc_aligned(3 * w->count, sizeof(double));
    w->theta = taut_film_solver_parts(solver) == 1 ? 0 : 1e-2;
    return w->here.gradient != NULL && w->there.gradient != NULL && w->there.net != NULL &&
                   w->right != NULL && w->step != NULL && w->image != NULL && w->turn != NULL &&
                   w->move != NULL && w->bend != NULL
               ? TAUT_OK
               : TAUT_NO_MEMORY;
}

void taut_walk_try(taut_walk *w, double factor)
{
    taut_film_solver_expand(w->solver, w->step, w->move);
    for (size_t i = 0; i < 3 * w->count; i++) {
        w->there.net[i] = w->here.net[i] + factor * w->move[i];
    }
    taut_walk_look(w, &w->there);
}

/* The nets stay where they are, since here's is the caller's; the rest changes hands. */
void taut_walk_accept(taut_walk *w)
{
    double *const gradient = w->here.gradient;
    w->past[w->steps++ % TAUT_WALK_PAST] = w->here.value.area;
    memcpy(w->here.net, w->there.net, 3 * w->count * sizeof(double));
    w->here.gradient = w->there.gradient;
    w->there.gradient = gradient;
    w->here.value = w->there.value;
    w->here.residual = w->there.residual;
    taut_film_solver_renew(w->solver);
}
