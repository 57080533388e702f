/* taut/measure.h -- lengths, areas, energies, curvatures of what was made.
 *
 * The fundamental forms, with the unit normal n = x_u x x_v / W, and mean and Gaussian curvature:
 *
 *     E = x_u.x_u   F = x_u.x_v   G = x_v.x_v   W = |x_u x x_v| = sqrt(E G - F^2)
 *     L = x_uu.n    M = x_uv.n    N = x_vv.n
 *     H = (L G - 2 M F + N E) / (2 W^2)        K = (L N - M^2) / W^2
 *
 * Source: [WuWang2011] sections 2.3 and 2.6. Where W = 0 there is no normal: such points are left
 * out of extremes and counted.
 */
#ifndef TAUT_MEASURE_H
#define TAUT_MEASURE_H

#include "taut/curve.h"
#include "taut/monitor.h"
#include "taut/record.h"
#include "taut/surface.h"

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The forms and curvatures at one point. Where the normal vanishes `regular` is 0 and normal, L, M,
 * N, H, K are NaN. */
typedef struct taut_forms {
    double e, f, g;   /* first fundamental form */
    double w;         /* area element */
    double normal[3]; /* unit */
    double l, m, n;   /* second fundamental form */
    double mean;      /* H */
    double gaussian;  /* K */
    int regular;
} taut_forms;

/* From the six vectors that taut_surface_eval gives at order 2. A normal is taken to vanish when
 * W <= 2^-40 of what its factors and the rounding of the derivatives allow to be told from 0. */
TAUT_API void taut_forms_of(const double values[6][3], taut_forms *forms);

/* The forms at every point of a grid, forms[nu][nv] at (u[i], v[j]), the same for any number of
 * threads; arguments and statuses as taut_surface_eval_grid, from the right at inner knots.
 * Derivatives are sums of differences of points, so that H and K keep their digits far from the
 * origin. */
TAUT_API taut_status taut_surface_forms_grid(const taut_surface *surface, int nu, const double *u,
                                             int nv, const double *v, int threads,
                                             taut_forms *forms);

/* The forms at `count` places in no order, forms[count] at (u[i], v[i]): normals and curvatures where
 * rays hit, say. Arguments and statuses as taut_surface_eval_points; digits as
 * taut_surface_forms_grid, though not the same bits. No allocation. */
TAUT_API taut_status taut_surface_forms_points(const taut_surface *surface, int count,
                                               const double *u, const double *v, int threads,
                                               taut_forms *forms);

/* Zero means default everywhere. */
typedef struct taut_measure_options {
    int grid;    /* extremes over grid x grid parameters; 0: 101; 2..TAUT_GRID_MAX */
    int threads; /* 0: 1; the result is the same for any number */
    taut_monitor monitor;
} taut_measure_options;

typedef struct taut_edge_measure {
    double length;
    double max_abs_normal_curvature;  /* NaN where undefined all along */
    double max_angle_normal_binormal; /* in [0, pi/2]; NaN on straight edges */
} taut_edge_measure;

/* What is known of the sign of the Jacobian of a planar surface. */
typedef enum taut_jacobian_state {
    TAUT_JACOBIAN_NONE = 0,   /* the points are not in one plane */
    TAUT_JACOBIAN_ONE_SIGN,   /* proved: of one sign inside (it may vanish on collapsed edges) */
    TAUT_JACOBIAN_FOLDS,      /* proved: of the other sign at `at`, or zero on an open part */
    TAUT_JACOBIAN_UNDECIDED,  /* too near to zero for the subdivision, or for rounding */
    TAUT_JACOBIAN_UNSUPPORTED /* rational, or not on polynomial bases: no such proof here */
} taut_jacobian_state;

typedef struct taut_jacobian {
    taut_jacobian_state state;
    int sign;      /* of its integral, in the coordinates kept, in cyclic order */
    double lowest; /* of sign J by the surface's parameters: one sign: a proved lower bound; else
                      the lowest value found; NaN where there is none */
    double at[2];  /* parameters of the lowest value found */
    int64_t cells; /* rectangles looked at */
} taut_jacobian;

/* J = x_u y_v - x_v y_u in the coordinates of the plane of the points (the one of x, y, z that
 * varies least is left out), for validity as a parameterisation: [NiWang2015] section 8.8.
 * Bernstein coefficients with bounds of their rounding, subdivided: what is said to be proved is
 * proved, the points taken as they are. Points within 2^-40 of their size of one plane count as
 * planar. TAUT_BAD_ARGUMENT, TAUT_NO_MEMORY. */
TAUT_API taut_status taut_surface_jacobian(const taut_surface *surface, taut_jacobian *jacobian);

/* Integrals beyond the range of doubles are NaN, and so are those of a rational surface where weights of one span are
 * more than 2^43 apart along a line of the net: the layers they make are thinner than any cell, and their errors are NaN
 * too. */
typedef struct taut_surface_measure {
    double area;
    double area_error; /* 0 when area is good to 1e-10 relative; else its error; so the others */
    double dirichlet_energy, dirichlet_energy_error;
    double bending_energy; /* iint |x_uu|^2 + 2 |x_uv|^2 + |x_vv|^2; infinity where a crease makes
                              it so */
    double bending_energy_error;
    double box[2][3];                   /* lowest and highest x, y, z of the whole surface */
    double max_abs_mean, mean_abs_mean; /* of |H|: largest on the grid, mean over the area */
    double min_gaussian, max_gaussian;  /* of K on the grid */
    double max_e_minus_g, max_f;        /* of |E - G| and |F| on the grid */
    double isothermality;               /* sqrt(iint (E-G)^2 + 4F^2) / iint (E+G); 0 for a point */
    double isothermality_error;
    double max_laplacian;       /* of |x_uu + x_vv| on the grid */
    double max_abs_mean_at[2];  /* parameters (u, v) of the largest |H| on the grid */
    taut_edge_measure edges[4]; /* u0, u1, v0, v1 */
    int64_t singular_points;    /* of the grid: those without a normal */
    taut_jacobian jacobian;     /* of planar surfaces */
} taut_surface_measure;

/* All of the above at once. TAUT_BAD_ARGUMENT (NULL, an option out of range), TAUT_NO_MEMORY,
 * TAUT_INTERRUPTED where the monitor says stop, or enough. */
TAUT_API taut_status taut_measure_surface(const taut_surface *surface,
                                          const taut_measure_options *options,
                                          taut_surface_measure *measure, taut_error *error);

typedef struct taut_curve_measure {
    double length;
    double max_curvature; /* NaN where undefined everywhere */
    double max_torsion;   /* of the absolute value; NaN where undefined everywhere */
} taut_curve_measure;

/* Errors as taut_measure_surface. The grid has so many parameters along the curve. */
TAUT_API taut_status taut_measure_curve(const taut_curve *curve,
                                        const taut_measure_options *options,
                                        taut_curve_measure *measure, taut_error *error);

/* The integrals alone, each good to 1e-10 relative or better (adaptive Gauss quadrature, or exact
 * where the integrand is polynomial); NaN where one is above the range of doubles, or where weights are too far apart, as
 * above. *error_estimate may be NULL. */
TAUT_API taut_status taut_surface_area(const taut_surface *surface, double *area,
                                       double *error_estimate);
TAUT_API taut_status taut_surface_dirichlet_energy(const taut_surface *surface, double *energy);
TAUT_API taut_status taut_surface_bending_energy(const taut_surface *surface, double *energy);
TAUT_API taut_status taut_surface_isothermality(const taut_surface *surface, double *isothermality);

/* The documents of `taut measure --json`, one surface or curve: adds the members that
 * docs/format.md lists (name first) to `record`. */
TAUT_API void taut_measure_surface_record(const taut_surface *surface,
                                          const taut_surface_measure *measure, taut_record *record);
TAUT_API void taut_measure_curve_record(const taut_curve *curve, const taut_curve_measure *measure,
                                        taut_record *record);

#ifdef __cplusplus
}
#endif
#endif /* TAUT_MEASURE_H */
