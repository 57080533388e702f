/* through.h -- points that a surface passes through, as linear conditions on its net.
 *
 *     sum_ij c_ij P_ij = X,    c_ij = R_ij(u, v),    S = sum_ij R_ij P_ij
 */
#ifndef TAUT_CONSTRUCT_COMMON_THROUGH_H
#define TAUT_CONSTRUCT_COMMON_THROUGH_H

#include "core/arena.h"
#include "taut/dirichlet.h"
#include "taut/record.h"

typedef struct taut_condition {
    int first[2];         /* of the points with a share */
    double *coefficients; /* [local of u][local of v] */
    double point[3];      /* X, in the units of the nets it is held against */
} taut_condition;

typedef struct taut_conditions {
    int count, nv, local[2];
    taut_condition *at;
} taut_conditions;

/* What is wrong with through[count]: not finite, out of range, only one of u and v. */
taut_status taut_through_check(const taut_basis *u, const taut_basis *v,
                               const taut_through *through, int count, taut_error *error);

/* weights double[nu][nv] or NULL; all in the arena. Parameters must be there and in range.
 * TAUT_NO_MEMORY. */
taut_status taut_conditions_new(const taut_basis *u, const taut_basis *v, const double *weights,
                                const taut_through *through, int count, taut_arena *arena,
                                taut_conditions *conditions);

/* The member `through` of details: u and v of each. */
void taut_through_describe(const taut_through *through, int count, taut_record *details);

/* sum c_ij of component `component` of net double[nu][nv][3]. */
double taut_condition_sum(const taut_conditions *all, int k, const double *net, int component);
/* component `component` of net += factor c. */
void taut_condition_add(const taut_conditions *all, int k, double factor, double *net,
                        int component);

#endif /* TAUT_CONSTRUCT_COMMON_THROUGH_H */
