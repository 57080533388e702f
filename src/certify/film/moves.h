/* moves.h -- the moves of a film that its energy sees, and the second variation over them.
 *
 * Area does not see moves within the surface. What it sees of a net are
 *
 *     a point inside      one move, along n_a = iint N_a x_u x x_v du dv; a pole too
 *     a point of a cable  two, across the tangent at the Greville abscissa of its function; one where the
 *     or a slide          edge is kept in a plane
 *     a corner            all that its line or its planes leave, where it is not held
 *
 * Where threads are drawn every point that moves has all moves that its planes leave, and K is that of the threads,
 * iint alpha |d_u|^2 + beta |d_v|^2 du dv.
 *
 * On them, with a = n . d_u, b = n . d_v, in units of the film's tension (docs/film.md):
 *
 *     K(d, d) = iint (G a^2 - 2 F a b + E b^2) / W + 2 n . (d_u x d_v) du dv
 *               + sum r_k int |d_t - (t . d_t) t|^2 / |x_t| dt
 *     M(d, d) = iint (n . d)^2 W du dv + sum size_k int |d - (t . d) t|^2 ds
 */
#ifndef TAUT_CERTIFY_FILM_MOVES_H
#define TAUT_CERTIFY_FILM_MOVES_H

#include "certify/film/sheet.h"
#include "core/pulse.h"

typedef struct taut_film_moves {
    int count;
    int *point;        /* [count], not decreasing */
    double *direction; /* [count][3], unit */
    int *first;        /* [nu nv + 1]: the moves of a point */
} taut_film_moves;

/* moments double[nu][nv][3]. In the sheet's arena: TAUT_NO_MEMORY. A point whose moment vanishes
 * has no move. */
taut_status taut_film_moves_new(const taut_film_sheet *sheet, const double *moments,
                                taut_film_moves *moves);

/* The largest |g . move|, and at which point. */
double taut_film_moves_largest(const taut_film_moves *moves, const double *gradient, int *point);

/* The lowest eigenvalue of K x = lambda M x, scaled, and how many are not above `limit`: by the
 * inertia of K - limit M. size: scaled. TAUT_NO_MEMORY; TAUT_NOT_CONVERGED: no eigenvalue is found,
 * *below is -1; TAUT_INTERRUPTED. */
taut_status taut_film_moves_lowest(const taut_film_sheet *sheet, const taut_film_moves *moves,
                                   double size, double limit, taut_pulse *pulse, double *lowest,
                                   int *below);

/* What a film whose threads are drawn can gain at most in its space, 1/2 g . K^-1 g with K that of the threads alone: their energy is
 * quadratic, that of cables of force or elasticity convex. gradient at the points that own, scaled; over the tension.
 * TAUT_NOT_CONVERGED: K is not positive definite. TAUT_NO_MEMORY, TAUT_INTERRUPTED. */
taut_status taut_film_moves_bound(const taut_film_sheet *sheet, const taut_film_moves *moves,
                                  const double *gradient, taut_pulse *pulse, double *gain);

#endif /* TAUT_CERTIFY_FILM_MOVES_H */
