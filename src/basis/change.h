/* change.h -- exact changes of one direction's basis: the new coefficients out of the old ones.
 *
 * Splitting, refining, raising the degree, reversing, turning into another type: along one
 * direction each is a linear map with few entries per row,
 *
 *     new[i] = sum_a rows[i][a] old[first[i] + a],   a = 0..width-1
 *
 * so a basis type gives the map, and curves and surfaces of any dimension share its use. Rows sum
 * to 1; those of knot insertion, splitting and degree elevation have no negative entries, so
 * weights stay positive and nothing cancels.
 */
#ifndef TAUT_BASIS_CHANGE_H
#define TAUT_BASIS_CHANGE_H

#include "basis/basis_ops.h"

#include <stddef.h>

typedef struct taut_change {
    taut_basis *to; /* the new basis */
    int width;
    int *first;   /* [count of to] */
    double *rows; /* [count of to][width] */
} taut_change;

typedef struct taut_change_list {
    int count;
    taut_change **items; /* owned */
} taut_change_list;

/* What a basis type can do. Pieces come low ones first and keep the parameters of the whole. All
 * return TAUT_NO_MEMORY, or why not. A NULL member is what the type does not have. */
typedef struct taut_change_ops {
    /* Cuts at t, lo < t < hi. */
    taut_status (*split)(const taut_basis *basis, double t, taut_change_list *list,
                         taut_error *error);
    /* One basis of the simplest type (bezier, c-bezier, h-bezier) per span. */
    taut_status (*pieces)(const taut_basis *basis, taut_change_list *list, taut_error *error);
    /* Halves every span. */
    taut_status (*halve)(const taut_basis *basis, taut_change **change, taut_error *error);
    /* Puts the knot t in, `times` more. */
    taut_status (*insert)(const taut_basis *basis, double t, int times, taut_change **change,
                          taut_error *error);
    /* Raises the degree by one. */
    taut_status (*elevate)(const taut_basis *basis, taut_change **change, taut_error *error);
    /* The parameter t becomes lo + hi - t. */
    taut_status (*reverse)(const taut_basis *basis, taut_change **change, taut_error *error);
    /* Another range, by an affine map of the parameter. */
    taut_status (*rerange)(const taut_basis *basis, double lo, double hi, taut_change **change,
                           taut_error *error);
    /* A bspline basis: exact for polynomials, whatever the pieces; else quintic Hermite
     * interpolants, C^2, on the pieces [ends[k], ends[k + 1]], k < pieces. All breaks are ends. */
    taut_status (*to_bspline)(const taut_basis *basis, int pieces, const double *ends,
                              taut_change **change, taut_error *error);
    /* Only where to_bspline is not exact. The sixth derivative of such functions is the second one,
     * y; within `reach` of m, |y(t)| <= at |y(m)| + slope |y'(m)|. */
    void (*growth)(const taut_basis *basis, double reach, double *at, double *slope);
} taut_change_ops;

/* A change to the basis of this spec, all rows zero. */
taut_status taut_change_new(const taut_basis_spec *to, int functions, int width,
                            taut_change **change, taut_error *error);
void taut_change_free(taut_change *change); /* NULL is fine */
/* Row i. */
double *taut_change_row(const taut_change *change, int i);

/* new[i] = old[from + i], or old[from + count - 1 - i] when reversed. */
taut_status taut_change_select(const taut_basis_spec *to, int functions, int from, int reversed,
                               taut_change **change, taut_error *error);
/* As taut_change_ops.pieces of a basis that is its own only piece; as reverse and rerange where the
 * range is a member of the spec and the functions are symmetric. */
taut_status taut_change_whole(const taut_basis *basis, taut_change_list *list, taut_error *error);
taut_status taut_change_reverse(const taut_basis *basis, taut_change **change, taut_error *error);
taut_status taut_change_rerange(const taut_basis *basis, double lo, double hi, taut_change **change,
                                taut_error *error);

/* First `a`, then `b`. */
taut_status taut_change_compose(const taut_change *a, const taut_change *b, taut_change **change,
                                taut_error *error);

/* A list of `count` places, NULL yet; and its end. Freeing leaves it empty. */
taut_status taut_change_list_new(int count, taut_change_list *list, taut_error *error);
void taut_change_list_free(taut_change_list *list);
/* Ends the filling of a list: one that failed is freed. Returns `status`. */
taut_status taut_change_list_done(taut_status status, taut_change_list *list);

/* out[b][i][c] = sum_a rows[i][a] in[b][first[i] + a][c], b < blocks, c < inner, `old_count` the
 * number of old coefficients. */
void taut_change_apply(const taut_change *change, size_t blocks, int old_count, size_t inner,
                       const double *in, double *out);

/* ---- B-splines, which other types turn into ---- */

extern const taut_change_ops taut_bspline_changes;

/* The bspline basis of one span that is this bezier basis, with the same coefficients. */
taut_status taut_bspline_of_bezier(const taut_basis *bezier, taut_basis **bspline,
                                   taut_error *error);

#endif /* TAUT_BASIS_CHANGE_H */
