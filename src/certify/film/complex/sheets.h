/* sheets.h -- a film of many patches at Gauss nodes of the certificate's own: its derivatives by nodes of the
 * complex (problem/film_complex.h), the moves that it sees, and the second variation over these.
 *
 *     E / s    = sum (s_i / s) A_i, or P_i / s of threads, + sum C_k,          s the tension of the first patch; C_k of cables of given length 0
 *     V        = 1/3 iint (x - from) . (x_u x x_v),    by parts dV = iint d . (x_u x x_v) along all that is free, since cells
 *                are closed or their rims held or in planes through `from` (problem/film_cells.h)
 *     pressure given, or that which leaves the least of the derivatives of E along moves; so are forces of given lengths
 *     gradient of E + sum r L - sum p V over given lengths and all cells
 *     inside   one move, along sum over sheets of n_a = iint N_a x_u x x_v, each sheet's turned to the side of the first one's
 *     line     across the tangent at the Greville abscissa, as far as planes leave it
 *     vertex   all that planes leave, as of all points of patches of threads
 *     K, M     as certify/film/moves.h, over all sheets and cables; M over all lines
 *
 * All in scaled coordinates: the first point at 0, about size 1.
 */
#ifndef TAUT_CERTIFY_FILM_COMPLEX_SHEETS_H
#define TAUT_CERTIFY_FILM_COMPLEX_SHEETS_H

#include "core/pulse.h"
#include "geometry/grid/table.h"
#include "problem/film_complex.h"

typedef struct taut_sheet_axis {
    taut_table *table; /* order 1 */
    double *weights;
    double *at; /* parameters */
} taut_sheet_axis;

typedef struct taut_sheets {
    taut_arena *arena;
    const taut_film_complex *complex;
    const taut_surface *const *surfaces; /* [patch_count] */
    int unit;                            /* points were divided by 2^unit */
    double half;                         /* half the size, unscaled */
    double *points;                      /* [points][3], scaled, patch by patch */
    double *shares;                      /* [patch_count] */
    double *ratios;                      /* [rope_count]: what cables draw with */
    double *forces;                      /* [rope_count]: the same in the user's unit */
    double *springs;         /* [rope_count]: k of elastic cables that are drawn, scaled; else 0 */
    double **stretches;      /* [rope_count]: [nodes][3], dL; NULL of given forces */
    double tension;          /* of the first patch */
    taut_sheet_axis *axes;   /* [patch_count][2] */
    double *gradient;        /* [nodes][3] */
    double *swells;          /* [cell_count][nodes][3]: dV */
    double *volumes;         /* [cell_count], unscaled */
    double *pressures;       /* [cell_count], over s, scaled */
    double *pull;            /* [patch_count]: sum of +-p, the same */
    double *moments;         /* [nodes][3] */
    double *stored;          /* [patch_count]: of threads P over their tension, unscaled; else 0 */
    unsigned char *threads;  /* [nodes]: of a patch of threads, all of whose moves are seen */
    double *areas, *lengths; /* [patch_count], [rope_count], unscaled */
    double *
        scales; /* [nodes]: the largest coordinate of a derivative of the sheets that meet in a node, each
                                          * alone, or the force of a cable along it */
    int moves;
    int *first;  /* [nodes + 1]: the moves of a node */
    double *way; /* [moves][3], unit */
} taut_sheets;

/* extra nodes a span. All of the arena. TAUT_NO_MEMORY. */
taut_status taut_sheets_new(const taut_film_complex *complex, const taut_surface *const *surfaces,
                            int extra, taut_arena *arena, taut_sheets *sheets);

/* The lowest eigenvalue of K x = lambda M x where given volumes and lengths stay, in tension over length squared times size^2, and how many are not above `limit`.
 * TAUT_NO_MEMORY; TAUT_INTERRUPTED; TAUT_NOT_CONVERGED: too large, or no eigenvalue is found: *below is -1. */
taut_status taut_sheets_lowest(const taut_sheets *sheets, double limit, taut_pulse *pulse,
                               double *lowest, int *below);

#endif /* TAUT_CERTIFY_FILM_COMPLEX_SHEETS_H */
