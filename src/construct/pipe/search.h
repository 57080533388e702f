/* search.h -- the least value of a function of a few variables in a box, without derivatives. */
#ifndef TAUT_PIPE_SEARCH_H
#define TAUT_PIPE_SEARCH_H

enum { TAUT_PIPE_SEARCH_MAX = 5 };

typedef double (*taut_pipe_objective)(void *context, const double *x);

/* Polls 2 count neighbours along orthonormal directions that turn from round to round, projected
 * into the box; steps grow on success and halve on failure until below 1e-9 of the box. Because the
 * directions become dense, limits are stationary also for functions with creases, such as a largest
 * curvature ([AudetDennis2006]).
 *     lo, hi  double[count], the box       x  the start on entry, the best point on return
 *     is_creased  f has creases: a step is tried longer before it is halved, also on along what was
 *                 gained before, since a valley's floor may be a crease
 * Returns the value there; *evaluations is added to. Values may be as large as they like where a
 * point is bad, but not NaN. */
double taut_pipe_search(int count, const double *lo, const double *hi, int is_creased,
                        taut_pipe_objective f, void *context, double *x, int *evaluations);

#endif /* TAUT_PIPE_SEARCH_H */
