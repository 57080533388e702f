/* quasi.h -- what the c- and h- bases share: legality, spans, functions out of the kernel's half.
 *
 *     quasi-Bezier      4 functions on one segment, U_0..U_3 (quasi_kernel.h)
 *     quasi-B-spline    k + 3 functions on k segments of one length, C^2, not clamped
 *
 * The four types are the rows of the table in quasi.c.
 */
#ifndef TAUT_BASIS_QUASI_H
#define TAUT_BASIS_QUASI_H

#include "basis/change.h"
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

/* Splitting and refining (quasi_change.c). */
extern const taut_change_ops taut_quasi_bezier_changes;
extern const taut_change_ops taut_quasi_bspline_changes;

/* The constants that fill put into basis->data. */
taut_quasi_segment taut_quasi_segment_of(const taut_basis *basis);

/* The shortest segment so far from zero, per distance: 8 numbers fit in. */
#define TAUT_QUASI_APART 0x1p-49

/* u[d][i] = U_i^(d)(t), d = 0..order <= 3, on a segment that runs from lo to hi, t in between, seen
 * from both ends so that each is met exactly. */
void taut_quasi_four(const taut_quasi_kernel *kernel, const taut_quasi_segment *segment, double lo,
                     double hi, double t, int order, double (*u)[4]);

#endif /* TAUT_BASIS_QUASI_H */
