/* oracle.h -- the judge from outside: what a model is, found again by formulas that share no code
 * with the library.
 *
 * Nothing but include/taut is used, and of it only what hands out numbers: knots, points, weights,
 * records (tools/check_layers.sh keeps it so). Bases, derivatives, integrals and searches are
 * written here anew, the plain way and in `long double`, whose range also holds the squares of
 * coordinates of 1e300.
 *
 *     what a claim says   ->   a lower bound of its true residual, by dense sampling and search
 *     a claim that holds although that bound is clearly above its limit is a false `holds`
 *
 * A lower bound can be too low, never too high: the oracle misses some lies, but accuses none that
 * tells the truth.
 */
#ifndef TAUT_TEST_ORACLE_H
#define TAUT_TEST_ORACLE_H

#include "taut/certify.h"
#include "taut/model.h"
#include "taut/record.h"

typedef long double oracle_real;

/* ---- numbers: bases, curves, surfaces ---- */

enum { ORACLE_LOCAL_MAX = 40, ORACLE_ORDER_MAX = 4 };

typedef struct oracle_basis {
    char type; /* 'p' piecewise polynomial, 'c' and 'h' single, 'C' and 'H' of segments, 'e' */
    int degree, count, local, spans;
    double lo, hi, length;  /* length: of a segment of a c-, h- basis */
    double shape[3];        /* alpha, beta, gamma of a ce-bezier */
    double *knots, *breaks; /* own; knots of 'p' only */
    int *first;             /* of the functions alive on a span */
} oracle_basis;

/* The functions alive at one parameter and their derivatives. */
typedef struct oracle_row {
    int first, local;
    oracle_real n[ORACLE_ORDER_MAX + 1][ORACLE_LOCAL_MAX];
} oracle_row;

/* 0 where the basis is none that the oracle knows, or memory is out. */
int oracle_basis_of(const taut_basis *basis, oracle_basis *own);
void oracle_basis_free(oracle_basis *own);
/* At t of the closed span; order 0..4 on polynomials, 0..3 on others. */
void oracle_basis_row(const oracle_basis *basis, int span, oracle_real t, int order,
                      oracle_row *row);
int oracle_basis_span(const oracle_basis *basis, oracle_real t);

typedef struct oracle_sheet {
    oracle_basis u, v;
    const double *points, *weights; /* borrowed; weights may be NULL */
    oracle_real size;               /* largest distance of two coordinates of one kind */
    oracle_real middle[3];          /* of the box around the points */
    oracle_real extent;             /* and the size of that box */
    oracle_real *net;               /* own: [nu][nv][4], w (x - middle), w */
} oracle_sheet;

int oracle_sheet_of(const taut_surface *surface, oracle_sheet *sheet);
void oracle_sheet_free(oracle_sheet *sheet);
/* From now on about the middle of these rows and columns: where only they decide, what lies far
 * from them costs no digits. */
void oracle_sheet_about(oracle_sheet *sheet, int from_u, int to_u, int from_v, int to_v);
/* x, and with order 1 x_u, x_v, and with order 2 x_uu, x_uv, x_vv; about the middle of the net. */
void oracle_sheet_at(const oracle_sheet *sheet, const oracle_row *u, const oracle_row *v, int order,
                     oracle_real out[6][3]);
void oracle_sheet_eval(const oracle_sheet *sheet, oracle_real u, oracle_real v, int order,
                       oracle_real out[6][3]);
/* d^(i+j) x / du^i dv^j of a polynomial surface, i, j <= 4. */
void oracle_sheet_mixed(const oracle_sheet *sheet, oracle_real u, oracle_real v, int i, int j,
                        oracle_real out[3]);

typedef struct oracle_line {
    oracle_basis t;
    const double *points, *weights;
} oracle_line;

int oracle_line_of(const taut_curve *curve, oracle_line *line);
void oracle_line_free(oracle_line *line);
/* x, x', x''. */
void oracle_line_eval(const oracle_line *line, oracle_real t, oracle_real out[3][3]);

oracle_real oracle_dot(const oracle_real a[3], const oracle_real b[3]);
void oracle_cross(const oracle_real a[3], const oracle_real b[3], oracle_real out[3]);
oracle_real oracle_norm(const oracle_real a[3]);

/* Nodes and weights of the Gauss rule of so many nodes on [0, 1]. */
int oracle_gauss(int count, oracle_real *nodes, oracle_real *weights);

/* ---- integrals: tanh-sinh in both directions of every cell ---- */

typedef struct oracle_integrals {
    oracle_real area, dirichlet, isothermality, bending;
    oracle_real area_error, dirichlet_error; /* between the last two steps */
} oracle_integrals;

/* Steps are halved until both errors are below `relative`, or `levels` times. */
void oracle_integrate(const oracle_sheet *sheet, oracle_real relative, int levels,
                      oracle_integrals *out);
/* Derivatives of the energy lambda |x_u|^2 + |x_v|^2 / lambda over 2 (area nonzero: of the area) by
 * the points, [nu][nv][3], the caller's; *error: their largest change by the last step. */
int oracle_gradient(const oracle_sheet *sheet, int area, oracle_real lambda, oracle_real *gradient,
                    oracle_real *error);

/* ---- judgement ---- */

typedef struct oracle_case {
    const char *construct;
    const taut_model *model;
    const taut_record *problem; /* its document, or NULL: the model alone */
    const taut_model *honest;   /* what `make` gives for the problem, or NULL */
    double honest_area;         /* of its first surface by oracle_integrate, or NaN */
    int by_place;               /* surfaces are those at the honest model's places, not its names */
} oracle_case;

typedef struct oracle_finding {
    const char *claim; /* that holds and should not; "whole": all of them together */
    double found, limit;
    const char *why;
    int judged, unjudged; /* claims that hold and were looked at, and that no judge is for */
} oracle_finding;

/* Nonzero: a false `holds`, told in *finding. */
int oracle_judge(const oracle_case *about, const taut_certificate *certificate,
                 oracle_finding *finding);
/* Is there a judge for this claim? */
int oracle_knows(const char *construct, const char *claim);

/* Judges; each gives a lower bound of the claim's residual (`regular`, `positive-weights`, `stable`:
 * an upper bound of the smallest value), NaN where it cannot say. */
double oracle_stationary(const oracle_case *about);
double oracle_known(const oracle_case *about);
double oracle_laplace(const oracle_case *about);
double oracle_bilaplace(const oracle_case *about);
double oracle_rows(const oracle_case *about);
double oracle_contact(const oracle_case *about);
double oracle_isothermal(const oracle_case *about);
double oracle_harmonic_net(const oracle_case *about);
double oracle_minimal(const oracle_case *about);
double oracle_formula(const oracle_case *about);
double oracle_edges(const oracle_case *about);
double oracle_normal_curvature(const oracle_case *about);
double oracle_osculating(const oracle_case *about);
double oracle_smallest_sine(const oracle_case *about);
double oracle_smallest_weight(const oracle_case *about);
double oracle_joint1(const oracle_case *about);
double oracle_joint2(const oracle_case *about);
double oracle_tube(const oracle_case *about);
double oracle_embedded(const oracle_case *about);
double oracle_run_tube(const oracle_case *about); /* of runs, piece by piece around its own axis */
double oracle_run_embedded(const oracle_case *about);
double oracle_ends(const oracle_case *about);
double oracle_identity(const oracle_case *about);
double oracle_joints(const oracle_case *about);
double oracle_bend(const oracle_case *about);
double oracle_caps(const oracle_case *about);
double oracle_merged(const oracle_case *about);
double oracle_tangent(const oracle_case *about);
double oracle_smooth(const oracle_case *about);
double oracle_closed(const oracle_case *about);
double oracle_least(const oracle_case *about);
double oracle_aspect(const oracle_case *about);
double oracle_film_held(const oracle_case *about);
double oracle_film_cables(const oracle_case *about);
double oracle_film_boundary(const oracle_case *about);
double oracle_film_stationary(const oracle_case *about);
double oracle_film_lowest(const oracle_case *about);
/* Of a film of this problem, over its tension; *error (NULL: not wanted): how far another rule is. */
double oracle_film_energy(const oracle_case *about, const taut_model *model, double *error);
/* Gap over radius and sine between normals, from u1 of one surface to u0 of the next. */
double oracle_joint_between(const taut_surface *before, const taut_surface *after, double radius);
/* Largest distance of the model from the honest one at equal parameters, over its size. */
double oracle_distance(const taut_model *a, const taut_model *b);
/* The same of the axes of a pipe, and of the lengths of its straight pipes, whatever the parameters
 * of its surfaces. */
double oracle_pipe_distance(const oracle_case *about);

/* A number of a document, "3/4" included; NaN where it is none. */
double oracle_number(const taut_record *record);
/* Three of them; 0 where they are not. */
int oracle_point(const taut_record *record, double point[3]);
const taut_surface *oracle_surface(const taut_model *model, const char *name);
/* Surface i of those the claims are about: by the honest model's names, else (and by_place) by
 * number. NULL beyond and where it is not there. */
const taut_surface *oracle_subject(const oracle_case *about, int i);
int oracle_subject_count(const oracle_case *about);
const taut_curve *oracle_curve(const taut_model *model, const char *name);

#endif /* TAUT_TEST_ORACLE_H */
