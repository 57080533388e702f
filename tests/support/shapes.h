/* shapes.h -- surfaces and curves with known figures, for tests. Each fails the test and returns
 * NULL if it cannot be made. */
#ifndef TAUT_TEST_SHAPES_H
#define TAUT_TEST_SHAPES_H

#include "taut/curve.h"
#include "taut/model.h"
#include "taut/surface.h"

/* A basis from a spec; bezier of a degree over [lo, hi]; clamped uniform bspline over [0, 1]. */
taut_basis *shape_basis(const taut_basis_spec *spec);
taut_basis *shape_bezier(int degree, double lo, double hi);
taut_basis *shape_bspline(int degree, int count);

/* A surface that takes over its bases. */
taut_surface *shape_surface(taut_basis *u, taut_basis *v, const double *points,
                            const double *weights);
taut_curve *shape_curve(taut_basis *t, const double *points, const double *weights);
/* A model that takes over a surface, or has none (NULL). */
taut_model *shape_model(taut_surface *surface);

/* Bernstein coefficients over [lo, hi], in `degree`, of sum_k c[k] t^k. */
void shape_bernstein(int degree, int terms, const double *c, double lo, double hi, double *b);

/* Enneper's surface (u - u^3/3 + u v^2, -v - u^2 v + v^3/3, u^2 - v^2), bicubic. */
taut_surface *shape_enneper(double u0, double u1, double v0, double v1);

/* A whole turn of a circle about the z axis: rational biquadratic B-splines, u around, v along the
 * profile. torus: centre circle `large`, tube `small`. sphere: v from pole to pole, both edges v0
 * and v1 collapsed. */
taut_surface *shape_torus(double large, double small);
taut_surface *shape_sphere(double radius);
/* The part of a sphere in the first octant, rational biquadratic Bezier; its edge v1 is the pole.
 */
taut_surface *shape_octant(double radius);
/* The square [-1, 1]^2, biquadratic, its middle point elsewhere with a weight of next to nothing.
 */
taut_surface *shape_far_net(const double middle[3]);
/* A cylinder about the z axis, u around, v from 0 to height, of any degree in v. */
taut_surface *shape_cylinder(double radius, double height, int degree);
/* (u, v, c u v) over [0, 1]^2, bilinear. */
taut_surface *shape_saddle(double c);

/* A band with a half twist, of bidegree (6, 1): its edges u0 and u1 are one, reversed. */
taut_surface *shape_strip(void);

/* Random net of size about 1. */
taut_surface *shape_random(int degree_u, int degree_v, int rational);

/* x -> scale * Q x + shift with a rotation Q; transposed (u and v change places); reversed in u. */
taut_surface *shape_moved(const taut_surface *surface, double scale, const double rotation[3][3],
                          const double shift[3]);
taut_surface *shape_transposed(const taut_surface *surface);
taut_surface *shape_reversed(const taut_surface *surface);
void shape_rotation(double rotation[3][3]); /* random */

/* The largest difference of two coordinates of nets of one size; *largest is a's largest one. */
double shape_apart(const taut_surface *a, const taut_surface *b, double *largest);

#endif /* TAUT_TEST_SHAPES_H */
