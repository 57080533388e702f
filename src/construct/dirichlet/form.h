/* form.h -- the Dirichlet energy of a net as a quadratic form.
 *
 *     D = 1/2 sum_c x_c^T A x_c,     A = fu Ku (x) Mv + fv Mu (x) Kv         ([WuWang2011] 2.4)
 *
 * with Gram matrices over the unit square (geometry/nurbs/gram.h), fu = lambda Lv/Lu, fv = 1/fu for
 * the aspect lambda. Weights that are products w_ij = a_i b_j only change the Gram matrices; with
 * other weights A is made by quadrature (rational.h), and the Gram matrices of the nearest product
 * stand in for it as the preconditioner.
 */
#ifndef TAUT_CONSTRUCT_DIRICHLET_FORM_H
#define TAUT_CONSTRUCT_DIRICHLET_FORM_H

#include "construct/common/mask.h"
#include "construct/dirichlet/rational.h"
#include "core/crew.h"
#include "geometry/nurbs/gram.h"

typedef struct taut_dirichlet_form {
    int nu, nv;
    double ratio;  /* Lv / Lu */
    double fu, fv; /* 1, 1 at first */
    taut_gram u, v;
    taut_dirichlet_rational *rational; /* NULL where the tensor form is exact */
    const taut_crew *crew;             /* of products; or NULL */
    double *row_sums;                  /* [2][nu + nv]: of |K|, then of |M|, u first */
} taut_dirichlet_form;

/* weights double[nu][nv], positive, or NULL. TAUT_NO_MEMORY; as taut_gram_new. */
taut_status taut_dirichlet_form_new(const taut_basis *u, const taut_basis *v, const double *weights,
                                    taut_dirichlet_form *form, taut_error *error);
void taut_dirichlet_form_clear(taut_dirichlet_form *form);

/* u, v: the Gram matrices of the mask's hull. Where that is the whole net its operator has the
 * constants as kernel: the mass on top of the stiffness makes it definite, for a preconditioner.
 * TAUT_NO_MEMORY; the caller clears both. */
taut_status taut_dirichlet_form_select(const taut_dirichlet_form *form, const taut_mask *mask,
                                       taut_gram *u, taut_gram *v);

/* The factors of A from here on. */
void taut_dirichlet_form_scale(taut_dirichlet_form *form, double fu, double fv);

/* y = A x, nets double[nu][nv][3], apart. Cost O(nu nv (local_u + local_v)) in tensor form.
 * TAUT_OK or TAUT_NO_MEMORY. */
taut_status taut_dirichlet_form_apply(const taut_dirichlet_form *form, const double *x, double *y);
/* y = -A x, summed in twice the precision where the tensor form is exact. */
taut_status taut_dirichlet_form_residual(const taut_dirichlet_form *form, const double *x,
                                         double *y);

/* The sum of |A(ij,st)| over s, t, or an upper bound of it. */
double taut_dirichlet_form_row_sum(const taut_dirichlet_form *form, int i, int j);

/* How many times its rounding an entry of A may be off: 1 in tensor form, whose entries are what
 * they are; with quadrature, what rounding of parameters does at worst. */
double taut_dirichlet_form_roundings(const taut_dirichlet_form *form);

/* The parts of the energy: halves[0] = 1/2 iint |x_u|^2, halves[1] = 1/2 iint |x_v|^2 over the
 * bases' own ranges, each good to rounding of its own size, however small beside the other. */
void taut_dirichlet_form_energies(const taut_dirichlet_form *form, const double *x,
                                  double halves[2]);

#endif /* TAUT_CONSTRUCT_DIRICHLET_FORM_H */
