/* models.h -- random models, surfaces and curves by name, and whether two are the same bit for bit. */
#ifndef TAUT_TEST_MODELS_H
#define TAUT_TEST_MODELS_H

#include "taut/model.h"

/* Any finite number: a third of them coordinates, the rest of all sizes, denormals included. */
double any_number(void);
/* A surface or curve of such numbers, on bezier or bspline, with weights or without. */
void add_any_surface(taut_model *model, const char *name);
void add_any_curve(taut_model *model, const char *name);

/* The same with coordinates of one size, for what has a size to compute; knots of every
 * multiplicity up to the degree. */
void add_some_surface(taut_model *model, const char *name);
void add_some_curve(taut_model *model, const char *name);
double *numbers_in(int count, double lo, double hi); /* free() them */

/* Names, bases, points and weights. */
int same_surface(const taut_surface *a, const taut_surface *b);
int same_curve(const taut_curve *a, const taut_curve *b);

/* The one of this name, or NULL. */
const taut_surface *surface_named(const taut_model *model, const char *name);
const taut_curve *curve_named(const taut_model *model, const char *name);

#endif /* TAUT_TEST_MODELS_H */
