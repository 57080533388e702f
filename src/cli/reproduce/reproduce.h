/* reproduce.h -- what the rows of data/papers/ may ask for, worked out from the public API.
 *
 * A row is { "source", "problem", "quantity", "printed", "expected", "tolerance", "because",
 * "erratum" }: `printed` is what the paper prints, digit for
 * digit (text), `expected` what is right (left out where the
 * paper is). Without an erratum ours must be within tolerance of what is printed; with one, of what
 * is expected.
 */
#ifndef TAUT_CLI_REPRODUCE_REPRODUCE_H
#define TAUT_CLI_REPRODUCE_REPRODUCE_H

#include "cli/cli.h"

/* One problem made and certified, for all the rows that speak of it. */
typedef struct cli_subject {
    taut_problem *problem;
    taut_model *model;
    taut_certificate *certificate;
} cli_subject;

/* The number a quantity stands for, in words split at blanks; NaN if there is none. */
double cli_quantity(const cli_subject *subject, const char *quantity);

/* The area of the triangles between cells x cells samples of the surface. */
double cli_triangulated_area(const taut_surface *surface, int cells);
/* |H| W, which is what comes out when the normal is not made unit, over samples x samples points:
 * the largest, or the sum over (samples - 1)^2. */
double cli_unnormalised_curvature(const taut_surface *surface, int samples, int mean);
/* Coordinate c of point (i, j) when the boundary rows of a polynomial surface are kept and the
 * others solved for with Gram matrices from the composite 5-point Newton-Cotes rule of `panels`
 * panels; NaN where that is not possible. */
double cli_cotes_point(const taut_surface *surface, int panels, int i, int j, int c);

/* The judged rows as a page of Markdown on standard output. */
void cli_reproduction_page(const taut_record *list);

/* k and m of a c- or h-bezier basis. */
double cli_basis_k(const taut_basis *basis);
double cli_basis_m(const taut_basis *basis);
/* How far formulas of [XuWang2006] miss the surface as printed: the index of h_2, the sign in h_42,
 * the second component of r_v. */
double cli_literal_index(const taut_surface *surface, double lambda);
double cli_literal_h42(const taut_surface *surface, double lambda);
double cli_literal_slope(const taut_surface *surface, double lambda);

#endif /* TAUT_CLI_REPRODUCE_REPRODUCE_H */
