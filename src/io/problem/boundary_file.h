/* boundary_file.h -- what the file gives that the member "boundary" names: a net, or four Bezier curves
 * (io/problem/boundary_document.h), or its curves as they are. */
#ifndef TAUT_IO_PROBLEM_BOUNDARY_FILE_H
#define TAUT_IO_PROBLEM_BOUNDARY_FILE_H

#include "geometry/boundary/boundary.h"
#include "io/problem/member.h"
#include "io/problem/net_document.h"
#include "problem/problem.h"

/* Of a document that has the member; the problem's arena owns the net. */
void taut_boundary_file_net(taut_reader *document, taut_problem *problem, taut_net_document *net);

/* The same of four curves of the document itself: with points to find where they alone leave none, which is noted. */
void taut_boundary_curves_net(taut_reader *document, taut_problem *problem,
                              const taut_curve *const curves[TAUT_SIDES], taut_net_document *net);

void taut_boundary_file_bezier(taut_reader *document, taut_problem *problem,
                               const char *const *others, int agree,
                               const taut_curve *sides[TAUT_SIDES]);
/* All curves of the file, or those that "edges" picks, in no order: `least` to `most` of them, in the document's unit, and their
 * numbers in the list of `taut boundary`; the arena owns them. */
void taut_boundary_file_curves(taut_reader *document, taut_problem *problem, int least, int most,
                               const taut_curve **curves, int *numbers, int *count);

#endif /* TAUT_IO_PROBLEM_BOUNDARY_FILE_H */
