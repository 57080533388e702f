/* quasi.h -- what the c- and h- bases share: legality, spans, functions out of the kernel's half.
 *
 *     quasi-Bezier      4 functions on one segment, U_0..U_3 (quasi_kernel.h)
 *     quasi-B-spline    k + 3 functions on k segments of one length, C^2, not clamped
 */
#ifndef TAUT_BASIS_QUASI_H
#define TAUT_BASIS_QUASI_H

#include "basis/basis_ops.h"
#include "basis/quasi_kernel.h"

/* Which member of the spec is the length, and its kernel. */
typedef struct taut_quasi_kind {
    const taut_quasi_kernel *kernel;
    double (*length)(const taut_basis_spec *spec); /* of one segment */
    void (*set_length)(taut_basis_spec *spec, double length);
    const char *where;   /* "/alpha" or "/beta" */
    double longest;      /* of a segment */
    int longest_bspline; /* a quasi-B-spline's may be as long; else it must be shorter */
    const char *bezier;  /* names of the two types */
    const char *bspline;
} taut_quasi_kind;

extern const taut_quasi_kind taut_quasi_c;
extern const taut_quasi_kind taut_quasi_h;

/* Is the spec legal? As taut_basis_ops.plan; `bspline` is 0 for a quasi-Bezier basis. */
taut_status taut_quasi_plan(const taut_quasi_kind *kind, const taut_basis_spec *spec, int bspline,
                            taut_basis_shape *shape, taut_error *error);
void taut_quasi_fill(const taut_quasi_kind *kind, taut_basis *basis);

/* The constants that fill put into basis->data. */
taut_quasi_segment taut_quasi_segment_of(const taut_basis *basis);

/* The shortest segment so far from zero, per distance: 8 numbers fit in. */
#define TAUT_QUASI_APART 0x1p-49

/* u[d][i] = U_i^(d)(t), d = 0..order <= 3, on a segment that runs from lo to hi, t in between, seen
 * from both ends so that each is met exactly. */
void taut_quasi_four(const taut_quasi_kind *kind, const taut_quasi_segment *segment, double lo,
                     double hi, double t, int order, double (*u)[4]);

/* As taut_basis_ops.eval. */
void taut_quasi_bezier_eval(const taut_quasi_kind *kind, const taut_basis *basis, int span,
                            double t, int order, double *values);
void taut_quasi_bspline_eval(const taut_quasi_kind *kind, const taut_basis *basis, int span,
                             double t, int order, double *values);

/* As taut_basis_ops.linear. */
void taut_quasi_bezier_linear(const taut_basis *basis, double *t);
void taut_quasi_bspline_linear(const taut_basis *basis, double *t);

#endif /* TAUT_BASIS_QUASI_H */
