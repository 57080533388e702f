/* quasi_change.h -- splitting and refining the c- and h- bases; the members of taut_change_ops. */
#ifndef TAUT_BASIS_QUASI_CHANGE_H
#define TAUT_BASIS_QUASI_CHANGE_H

#include "basis/change.h"
#include "basis/quasi.h"

taut_status taut_quasi_bezier_split(const taut_quasi_kind *kind, const taut_basis *basis, double t,
                                    taut_change_list *list, taut_error *error);
taut_status taut_quasi_bspline_split(const taut_quasi_kind *kind, const taut_basis *basis, double t,
                                     taut_change_list *list, taut_error *error);
taut_status taut_quasi_bezier_halve(const taut_quasi_kind *kind, const taut_basis *basis,
                                    taut_change **change, taut_error *error);
taut_status taut_quasi_bspline_halve(const taut_quasi_kind *kind, const taut_basis *basis,
                                     taut_change **change, taut_error *error);
taut_status taut_quasi_bspline_pieces(const taut_quasi_kind *kind, const taut_basis *basis,
                                      taut_change_list *list, taut_error *error);

/* The same for all four types: they know their own ops. */
taut_status taut_quasi_bezier_pieces(const taut_basis *basis, taut_change_list *list,
                                     taut_error *error);
taut_status taut_quasi_reverse(const taut_basis *basis, taut_change **change, taut_error *error);
taut_status taut_quasi_rerange(const taut_basis *basis, double lo, double hi, taut_change **change,
                               taut_error *error);
taut_status taut_quasi_to_bspline(const taut_basis *basis, int panels, const double *ends,
                                  taut_change **change, taut_error *error);

/* y'' = -y, or y'' = y: |y(t)| <= at |y(m)| + slope |y'(m)| for |t - m| <= reach. */
void taut_quasi_c_growth(double reach, double *at, double *slope);
void taut_quasi_h_growth(double reach, double *at, double *slope);

#endif /* TAUT_BASIS_QUASI_CHANGE_H */
