/* taut/limits.h -- the largest sizes taut accepts. Each is refused by name, with the limit, before
 * any memory is taken. */
#ifndef TAUT_LIMITS_H
#define TAUT_LIMITS_H

#define TAUT_DEGREE_MAX 128        /* degree of one basis                                     */
#define TAUT_COUNT_MAX 1000000     /* basis functions in one direction                        */
#define TAUT_PARAMETER_MAX 1e60    /* absolute value of a parameter, such as a knot           */
#define TAUT_SPAN_MIN 1e-60        /* width of a span (least); third derivatives stay finite  */
#define TAUT_POINTS_MAX 50000000   /* control points of one curve or surface                  */
#define TAUT_NAME_MAX 255          /* bytes in the name of a curve or surface                 */
#define TAUT_OBJECTS_MAX 100000    /* curves, and surfaces, in one model                      */
#define TAUT_MEMBERS_MAX 1000      /* members of one object in details or figures             */
#define TAUT_FILE_MAX 4000000000.0 /* bytes in one document                                   */
#define TAUT_GRID_MAX 20000        /* parameters per direction of a grid asked for by a person */
#define TAUT_THREADS_MAX 256       /* threads of one command                                  */

/* Figures: isolines, mirrored lights, pixels across. */
enum { TAUT_ISOLINES_MAX = 100, TAUT_LIGHTS_MAX = 100, TAUT_WIDTH_MAX = 2400 };

#endif /* TAUT_LIMITS_H */
