/* pipes.h -- what tests of pipes share: making and proving them, areas and volumes by
 * quadrature, random blends. */
#ifndef TAUT_TEST_PIPES_H
#define TAUT_TEST_PIPES_H

#include "taut/taut.h"

/* Made and proved, or a failure of the test and NULL. */
taut_model *pipe_made(const taut_pipe_problem *problem, double tolerance);
taut_certificate *pipe_proved(const taut_model *model, const taut_pipe_problem *problem,
                              double tolerance);
/* Is it refused with this status and reason? Returns what was told. */
taut_error pipe_refused(const taut_pipe_problem *problem, taut_status status, const char *reason);

/* Of a model made to 1e-6; TAUT_UNDECIDED where there is no such claim. */
taut_verdict pipe_verdict(const taut_model *model, const taut_pipe_problem *problem,
                          const char *name);

/* Two directed ends some six units apart, handles and shape numbers given, round but of no
 * radius. */
taut_pipe_problem pipe_random_ends(void);

/* Added to *area and *volume: the integrals of 1 and of X . n / 3 over a surface, n the normal that
 * looks away from the axis, by Gauss's rule on every span. */
void pipe_integrate(const taut_surface *surface, double *area, double *volume);
/* The integral of X . n / 3 over a plane end of some area at a point, n the way of flow. */
double pipe_end_volume(const double point[3], const double direction[3], double area);
/* The volume inside a blend between plane ends of these areas, and *area, that of the blend. */
double pipe_volume(const taut_model *model, const taut_pipe_problem *problem,
                   const double end_areas[2], double *area);

#endif /* TAUT_TEST_PIPES_H */
