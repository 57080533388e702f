/* polish.h -- the last steps of a film, along the moves that its energy sees.
 *
 * Where the whole net has come to rest to what moves within the surface let it, those are held and
 * Newton's steps go on in the others: an inner point and a pole along iint N x_u x x_v du dv, a
 * point of a cable or a slide across the tangent at its Greville abscissa, a corner in every way, and so every point where threads
 * are drawn, whose energy sees all moves; all of them as far as they are allowed. They converge to rounding.
 */
#ifndef TAUT_CONSTRUCT_FILM_POLISH_H
#define TAUT_CONSTRUCT_FILM_POLISH_H

#include "construct/film/space.h"
#include "construct/plateau/area.h"
#include "construct/plateau/hessian_band.h"

/* What the last steps of one net leave for those of the next, nearly the same: by another Gauss rule, or other forces. */
typedef struct taut_film_memory {
    taut_area_hessian *factors; /* or NULL */
    double *directions;         /* [nu][nv][3][3], or NULL */
    double scale;               /* the largest derivative of the film alone, without cables */
} taut_film_memory;

void taut_film_memory_clear(taut_film_memory *memory);

typedef struct taut_film_polished {
    double first,
        residual; /* the largest derivative along those moves over the largest in the net, before and after */
    double any;  /* the largest in any way that is allowed, after */
    double area; /* of the functional, after */
} taut_film_polished;

/* Improves net double[nu][nv][3] in place, until a residual of `least` or rounding, by the factors in memory for as long as they
 * serve. *is_definite: without what cables store the second derivative has been seen to be positive definite along the moves; else as
 * it was. Of at most TAUT_FILM_POINTS_MAX points factors pay, here and below. TAUT_NO_MEMORY; TAUT_INTERRUPTED by the functional's
 * pulse. */
taut_status taut_film_polish(taut_area_functional *functional, const taut_film_space *space,
                             double *net, double least, taut_film_memory *memory,
                             taut_film_polished *found, int *is_definite);

/* How lengths answer to forces: response[k][l] = dL_k . B^-1 dL_l over those moves, B the second
 * derivative of all, for the cables that give way (others 0). TAUT_NO_SOLUTION: B is not positive
 * definite; TAUT_NO_MEMORY. */
taut_status taut_film_respond(taut_area_functional *functional, const taut_film_space *space,
                              double *net, double response[4][4]);

/* A film at rest near a net, be it a minimum or not. */
typedef struct taut_film_rest_point {
    double first, residual,
        any;      /* as taut_film_polish has them, along the moves before, and after */
    double moved; /* the farthest that a point went */
    int negative; /* eigenvalues below 0 over those moves; -1: not known */
    double
        eigenvalue; /* where some are: about the lowest, scaled, over the tension; of a film alone */
    int waves;      /* of a ring, where some are: how often it goes up and down around; else -1 */
} taut_film_rest_point;

/* Goes to it by Newton's steps of any signs, at most so many, each to a smaller residual; by `all` more over all coordinates
 * unless the method is `normal`. With 0 steps it only looks. Cables with rigid[k] (NULL: none) keep their lengths where
 * eigenvalues are counted. TAUT_NO_MEMORY. */
taut_status taut_film_seek(taut_area_functional *functional, const taut_film_space *space,
                           double *net, const unsigned char rigid[4], int steps, int all,
                           taut_film_rest_point *at);

#endif /* TAUT_CONSTRUCT_FILM_POLISH_H */
