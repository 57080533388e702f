/* of_document.h -- the member "of" of a net and of a pattern: the surface they are on, as a model, as a problem that
 * makes it, or as the name of a file that holds either. */
#ifndef TAUT_IO_PROBLEM_OF_DOCUMENT_H
#define TAUT_IO_PROBLEM_OF_DOCUMENT_H

#include "io/json/in.h"
#include "problem/problem.h"
#include "taut/model.h"

/* One of *model and *of, the problem's own; the problem's unit becomes that of its surface. The member "untrim" says how trimmed faces
 * are read. */
void taut_of_document_read(taut_reader *document, taut_problem *problem, const taut_model **model,
                           const taut_problem **of);

#endif /* TAUT_IO_PROBLEM_OF_DOCUMENT_H */
