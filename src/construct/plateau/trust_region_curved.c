/* trust_region_curved.c -- steps along the valley of least area.
 *
 * Moves within the surface hardly change its area, but a straight one of length d leaves the
 * surface by d^2 along the normal, where the area is stiff: straight steps have to be short, and
 * the net creeps. A curve keeps to the surface. With z the step, B z = -g, and g(.) the gradient,
 *
 *     x(t) = x + t z + t^2 c,     B c = -(g(x + z) - g - H z)
 *
 * c undoes the second-order part of the gradient at x + z ([NocedalWright2006] 18.3, second-order
 * correction), so the error along the normal is d^3. t is doubled while the area falls; then steps
 * with the same factors, -B^-1 g, take away what error is left. Each costs a look at the film,
 * where another Newton step costs factors. */
#include "construct/plateau/trust_region_step.h"

#include <math.h>

enum { CORRECTIONS = 3, POLISHES = 6 };
static const double longest = 65536, worth = 0.1;

static taut_film_value value_at(taut_walk *w, double t)
{
    for (size_t i = 0; i < 3 * w->count; i++) {
        w->there.net[i] = w->here.net[i] + t * (w->move[i] + t * w->bend[i]);
    }
    return taut_film_area(w->film, w->there.net);
}

/* bend = c, move = z as nets. The film's state must be here's: it is that of x + z afterwards. */
static void find_curve(taut_walk *w)
{
    taut_film_solver_product(w->solver, 0, w->step, w->turn);
    taut_walk_try(w, 1);
    taut_film_solver_reduce(w->solver, w->there.gradient, w->image);
    for (size_t i = 0; i < w->size; i++) {
        w->turn[i] -= w->image[i] + w->right[i]; /* right = -g */
    }
    taut_film_solver_again(w->solver, w->turn);
    taut_film_solver_expand(w->solver, w->step, w->move);
    taut_film_solver_expand(w->solver, w->turn, w->bend);
}

/* place.net -= B^-1 gradient; the move that was made is in w->bend. */
static void correct(taut_walk *w, taut_place *place)
{
    taut_film_solver_reduce(w->solver, place->gradient, w->turn);
    taut_film_solver_again(w->solver, w->turn);
    taut_film_solver_expand(w->solver, w->turn, w->bend);
    for (size_t i = 0; i < 3 * w->count; i++) {
        place->net[i] -= w->bend[i];
    }
}

static void undo(taut_walk *w, taut_place *place)
{
    for (size_t i = 0; i < 3 * w->count; i++) {
        place->net[i] += w->bend[i];
    }
    taut_walk_look(w, place);
}

int taut_walk_bend(taut_walk *w)
{
    double best = w->here.value.area, t = 0;

    if (!taut_film_solver_has_factors(w->solver)) {
        taut_walk_try(w, 1);
        return 0;
    }
    find_curve(w);
    for (double longer = 1; longer <= longest; longer *= 2) {
        const taut_film_value value = value_at(w, longer);
        if (!(value.area < best) || value.least < w->barrier) {
            break;
        }
        best = value.area;
        t = longer;
    }
    value_at(w, t);
    if (t == 0) {
        taut_walk_try(w, 1);
        return 0;
    }
    taut_walk_look(w, &w->there);
    for (int k = 0; k < CORRECTIONS; k++) {
        const double before = w->there.value.area;
        correct(w, &w->there);
        taut_walk_look(w, &w->there);
        if (!(w->there.value.area < before) || w->there.value.least < w->barrier) {
            undo(w, &w->there);
            break;
        }
        if (before - w->there.value.area < worth * (w->here.value.area - w->there.value.area)) {
            break;
        }
    }
    return 1;
}

void taut_walk_polish(taut_walk *w)
{
    int goes_on = taut_film_solver_has_factors(w->solver);

    for (int k = 0; goes_on && k < POLISHES; k++) {
        const double before = w->here.residual, area = w->here.value.area;
        correct(w, &w->here);
        taut_walk_look(w, &w->here);
        goes_on = w->here.residual < 0.5 * before;
        if (!(w->here.residual < before) || !(w->here.value.area <= area * (1 + 0x1p-50))) {
            undo(w, &w->here);
            goes_on = 0;
        }
    }
    taut_film_solver_renew(w->solver);
}
