/* problems.h -- bases and Dirichlet problems for tests: the worked examples, and random legal ones.
 */
#ifndef TAUT_TEST_PROBLEMS_H
#define TAUT_TEST_PROBLEMS_H

#include "taut/dirichlet.h"

#include <stddef.h>

/* A problem with everything it points at; free with problem_free. */
typedef struct test_problem {
    taut_dirichlet_problem data;
    taut_basis *u, *v;
    double *points;
    unsigned char *known;
    double *weights;
} test_problem;

/* Clamped B-splines, uniform on [0, 1]. */
taut_basis *basis_uniform(int degree, int count);
/* Random degree up to `degree_max`, count degree+1 .. count_max, range anywhere; knots uniform, or
 * random, or graded over six decades, or with repeated ones. */
taut_basis *basis_random(int degree_max, int count_max);

/* Of `count` uniform cubic functions on [0, 1]: the mean of the knots of function i, where a line
 * has its points. */
double greville_uniform(int count, int i);

/* Takes the bases over; points zero, all unknown, no weights. */
test_problem problem_new(taut_basis *u, taut_basis *v);
void problem_free(test_problem *problem);
/* Point (i, j) is here, and known. */
void problem_know(test_problem *problem, int i, int j, double x, double y, double z);

/* The four boundary rows known and random in [-1, 1]^3; the rest unknown. */
void problem_random_boundary(test_problem *problem);
/* Random weights in [1/limit, limit]. */
void problem_random_weights(test_problem *problem, double limit);

/* Four edges of a tetrahedron over the unit square, n x n cubic points. */
test_problem problem_tetrahedron(int n);

/* Examples 1 to 4 of [WuWang2011] section 4. */
test_problem problem_example(int number);

/* The surface of a problem, checked to be made: the model (free it) and its control points. */
taut_model *problem_make(const test_problem *problem, const double **points);

#endif /* TAUT_TEST_PROBLEMS_H */
