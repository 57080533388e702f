/* harmonic_boundary.h -- the known rows of a harmonic surface out of a file of four curves. */
#ifndef TAUT_IO_PROBLEM_HARMONIC_BOUNDARY_H
#define TAUT_IO_PROBLEM_HARMONIC_BOUNDARY_H

#include "io/json/in.h"
#include "problem/problem.h"
#include "taut/harmonic.h"

#define TAUT_HARMONIC_BOUNDARY_MEMBERS "boundary", "known", "widths"

/* Two opposite curves of the file "boundary", those that "known" names, become the known rows of
 * bidegree (n, n) over [0, a] x [0, b], "widths": [a, b]; the other two only say which ends face
 * each other. The problem's arena owns what data points at. */
taut_status taut_harmonic_boundary_read(const taut_json *document, taut_problem *problem,
                                        taut_harmonic_problem *data, taut_error *error);

#endif /* TAUT_IO_PROBLEM_HARMONIC_BOUNDARY_H */
