/* asymptotic.h -- asymptotic problems for tests: the worked examples, random ones, and
 * quadrilaterals of curves that are known to be asymptotic on a known surface.
 */
#ifndef TAUT_TEST_ASYMPTOTIC_H
#define TAUT_TEST_ASYMPTOTIC_H

#include "taut/asymptotic.h"

/* Examples 1 to 6 of [WangZhuLi2017]; branch as in documents, or NULL for the lowest. */
taut_asymptotic_problem asymptotic_example(int number, const char *branch);

/* Example 1 with legs, corners, curvatures and end weights moved by up to `amount`, each relative
 * to itself: in general position. */
taut_asymptotic_problem asymptotic_random(int degree, double amount);

/* Makes the model and checks that it is made: NULL if not. */
taut_model *asymptotic_make(const taut_asymptotic_problem *problem, const char *what);

/* Certifies, checks that it can, and returns the certificate; the caller frees it. */
taut_certificate *asymptotic_certify(const taut_model *model,
                                     const taut_asymptotic_problem *problem, const char *what);
/* CHECKs that all claims hold. */
void asymptotic_check_claims(const taut_model *model, const taut_asymptotic_problem *problem,
                             const char *what);
/* The same where the inside may fold: then `regular` is false, at a place without a normal, or
 * undecided, where R_u or R_v is 0; and where edges may be so flat that rounding hides b: then
 * `osculating` is undecided. */
void asymptotic_check_claims_or_fold(const taut_model *model,
                                     const taut_asymptotic_problem *problem, const char *what);

/* A bezier curve of degree n from control points and weights (or NULL). */
taut_curve *asymptotic_curve(const char *name, int n, const double *points, const double *weights);
void asymptotic_free_curves(taut_asymptotic_problem *problem);

/* A Lelieuvre net ([docs/papers/asymptotic.md] 10.4) of degree 2p - 1: for a(u), b(v) of degree p,
 *     R = int a x a' du - int b x b' dv + b x a,   normal a + b,
 * every parameter line is asymptotic. */
enum { LELIEUVRE_DEGREE = 3 };
typedef struct lelieuvre {
    int p;
    double a[LELIEUVRE_DEGREE + 1][3], b[LELIEUVRE_DEGREE + 1][3]; /* Bernstein coefficients */
} lelieuvre;

/* Random, with a + b within some 50 degrees of the z axis so that the net is regular. */
lelieuvre lelieuvre_random(int p);
int lelieuvre_is_regular(const lelieuvre *net);
/* a + b at (u, v), not unit. */
void lelieuvre_normal(const lelieuvre *net, double u, double v, double normal[3]);
/* The problem of its four boundary curves; free the curves. */
taut_asymptotic_problem lelieuvre_problem(const lelieuvre *net);

/* The image of the problem's curves under x -> (A x + t) / (c.x + 1). */
typedef struct projective {
    double a[3][3], t[3], c[3];
} projective;
taut_asymptotic_problem projective_image(const taut_asymptotic_problem *problem,
                                         const projective *map);

#endif /* TAUT_TEST_ASYMPTOTIC_H */
