/* boundary_document.h -- "boundary": a file of four curves in place of a net with holes. */
#ifndef TAUT_IO_PROBLEM_BOUNDARY_DOCUMENT_H
#define TAUT_IO_PROBLEM_BOUNDARY_DOCUMENT_H

#include "geometry/boundary/boundary.h"
#include "io/json/in.h"
#include "problem/problem.h"
#include "taut/dirichlet.h"

/* The members that go with it, for a list of members. */
#define TAUT_BOUNDARY_MEMBERS "boundary", "degree", "refine"

/* Has the document the member "boundary"? */
int taut_boundary_document_is(const taut_reader *document);

/* The net of a document: of its members u, v, points and weights, or, with "boundary", where these
 * must not be there, the one between the four curves of the file that it names (any that taut reads,
 * beside the problem's own document), its inside unknown, on common bases: with at least the degrees
 * of "degree": [p, q], and spans halved as often as "refine": [k, l] says. The problem's arena owns
 * it; net->name stays as it is. */
void taut_boundary_document_net(taut_reader *document, taut_problem *problem,
                                taut_dirichlet_problem *net);

/* The net between four curves that the document itself has, as "boundary" gives it: u0, u1, v0 and v1, which meet. */
void taut_boundary_document_curves(taut_reader *document, taut_problem *problem,
                                   const taut_curve *const curves[TAUT_SIDES],
                                   taut_dirichlet_problem *net);

/* The four sides as Bezier curves over [0, 1], in order, their weights made to agree at the corners
 * where that is asked for; the arena owns them. The document must not have any of the members
 * `others` (ends with NULL). */
void taut_boundary_document_bezier(taut_reader *document, taut_problem *problem,
                                   const char *const *others, int agree,
                                   const taut_curve *sides[TAUT_SIDES]);

#endif /* TAUT_IO_PROBLEM_BOUNDARY_DOCUMENT_H */
