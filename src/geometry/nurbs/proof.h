/* proof.h -- how far a quintic Hermite spline is from a curve or surface on c- and h- bases,
 * proved; and panels for which it is near enough. */
#ifndef TAUT_GEOMETRY_NURBS_PROOF_H
#define TAUT_GEOMETRY_NURBS_PROOF_H

#include "geometry/lattice.h"

/* What a panel does to the four points of a piece: the distance is at most
 * |sum rows[0][i] P_i| + |sum rows[1][i] P_i|. */
typedef struct taut_nurbs_panel {
    double rows[2][4];
} taut_nurbs_panel;

/* One direction of what is converted. */
typedef struct taut_side {
    const taut_basis *basis;  /* NULL for the missing direction of a curve */
    taut_change_list pieces;  /* one per span */
    int exact;                /* polynomial: nothing is lost, and there are no panels */
    int *first;               /* [pieces + 1]: panels first[p] .. first[p + 1] - 1 cut piece p */
    double *ends;             /* [first[pieces] + 1] */
    taut_nurbs_panel *panels; /* [first[pieces]] */
} taut_side;

/* On failure there is still something to free. */
taut_status taut_side_begin(const taut_basis *basis, taut_side *s, taut_error *error);
void taut_side_free(taut_side *s);

/* The panel [lo, hi] of piece p. */
taut_nurbs_panel taut_nurbs_panel_of(const taut_side *s, int p, double lo, double hi);

/* Its distance on `lines` lines of four points: points[l * line + i * step + c]. */
double taut_nurbs_along(const taut_nurbs_panel *panel, int lines, const double *points, size_t line,
                        size_t step);

/* Cuts a side that is not exact into as few panels as its distance alone, `share` at most, allows;
 * `direction` is the one it runs along. `whole` is without weights.
 * TAUT_NO_SOLUTION: more than TAUT_COUNT_MAX functions. */
taut_status taut_nurbs_cut(const taut_lattice *whole, int direction, taut_side *s,
                           const taut_side *other, double share, taut_error *error);

/* The proved distance for the panels the sides have now. */
taut_status taut_nurbs_prove(const taut_lattice *whole, const taut_side *u, const taut_side *v,
                             double *distance, taut_error *error);

#endif /* TAUT_GEOMETRY_NURBS_PROOF_H */
