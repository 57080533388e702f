/* carrier.h -- the surface that curves are traced on: its derivatives from the polynomial of a cell
 * of choice, continued past its border, and the forms that directions come from.
 *
 * The points are moved to the first one and scaled by a power of two, so that the surface is of size
 * 1; lengths here are those times 2^carrier->scale in the surface's own unit.
 */
#ifndef TAUT_TRACE_CARRIER_H
#define TAUT_TRACE_CARRIER_H

#include "core/arena.h"
#include "taut/surface.h"
#include "trace/carrier_cells.h"

/* The derivatives of a surface up to the third, in the order of taut_jet_power: x, x_u, x_v, x_uu,
 * x_uv, x_vv, x_uuu, x_uuv, x_uvv, x_vvv. */
enum { TAUT_CARRIER_VECTORS = 10, TAUT_CARRIER_RULE = 10 };

typedef struct taut_carrier {
    const taut_surface *surface;
    const taut_basis *basis[2];
    const double *net;               /* [nu][nv][4]: (wx, wy, wz, w) */
    const taut_carrier_cells *cells; /* the same cell by cell, or NULL */
    int is_rational;
    int scale;             /* an exponent */
    double origin[3];      /* of the surface's own points */
    double size;           /* largest coordinate of a point from the first, times 2^-scale */
    double lo[2], hi[2];   /* the window */
    double widest;         /* the largest |x_u x x_v| of a grid */
    double roundest;       /* the largest R of it */
    int is_straight[2][2]; /* asymptotic, principal; first and second family (trace/straight.h) */
    double way[2][2][2];
    double rule[2][TAUT_CARRIER_RULE]; /* Gauss's nodes and weights along them */
    int wraps[2];               /* u0 and u1 (v0 and v1) are one line in space, with one normal */
    struct taut_seam *seams[4]; /* of u0, u1, v0, v1: where curves go on (trace/seam.h), or NULL */
} taut_carrier;

/* First and second fundamental form and the unit normal. */
typedef struct taut_form_pair {
    double e, f, g, l, m, n;
    double w; /* |x_u x x_v| */
    double normal[3];
} taut_form_pair;

/* In the arena; the surface must outlive it. TAUT_NO_MEMORY. */
taut_status taut_carrier_new(taut_arena *arena, const taut_surface *surface,
                             taut_carrier **carrier);
/* One a surface, all in one frame: origin, scale, size and roundest are those of all of them. */
taut_status taut_carriers_new(taut_arena *arena, int count, const taut_surface *const *surfaces,
                              taut_carrier ***carriers);

/* The derivatives up to `order` (0..3) at `at` from the polynomial of the cell (span[0], span[1]),
 * inside it or not. */
void taut_carrier_at(const taut_carrier *carrier, const int span[2], const double at[2], int order,
                     double x[TAUT_CARRIER_VECTORS][3]);
/* Of derivatives up to the second. w = 0 and a normal of zeros where there is none. */
void taut_carrier_forms(const double x[TAUT_CARRIER_VECTORS][3], taut_form_pair *forms);
/* Derivatives of the six coefficients e, f, g, l, m, n along u and v; of derivatives up to the
 * third. w must not be 0. */
void taut_carrier_slopes(const double x[TAUT_CARRIER_VECTORS][3], const taut_form_pair *forms,
                         double slopes[6][2]);

/* Gauss curvature, mean curvature and R = (k1 - k2) / 2 = sqrt(H^2 - K), without cancellation. */
double taut_form_pair_gauss(const taut_form_pair *forms);
double taut_form_pair_mean(const taut_form_pair *forms);
double taut_form_pair_radius(const taut_form_pair *forms);

/* x in the surface's own unit. */
void taut_carrier_point(const taut_carrier *carrier, const double x[3], double point[3]);

/* The cell of a place; at a break the one that lies on the side of `direction` ([2], or NULL). */
void taut_carrier_cell(const taut_carrier *carrier, const double at[2], const double *direction,
                       int span[2]);

/* Does the normal jump at a place, from one cell to the next? */
int taut_carrier_is_crease(const taut_carrier *carrier, const double at[2]);

/* The derivatives up to the second and the forms at `at`, of the cell of the place. */
void taut_carrier_forms_at(const taut_carrier *carrier, const double at[2],
                           double x[TAUT_CARRIER_VECTORS][3], taut_form_pair *forms);

#endif /* TAUT_TRACE_CARRIER_H */
