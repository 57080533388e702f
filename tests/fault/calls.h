/* calls.h -- calls that several fault tests make, and how they free what a call made: members of a
 * fault_call. */
#ifndef TAUT_TEST_CALLS_H
#define TAUT_TEST_CALLS_H

#include "taut/status.h"

/* The context is a path, or a text. */
taut_status read_model(const void *context, void **result, taut_error *error);
taut_status read_model_text(const void *context, void **result, taut_error *error);
taut_status read_problem(const void *context, void **result, taut_error *error);
taut_status read_problem_text(const void *context, void **result, taut_error *error);

void release_certificate(void *certificate);
void release_curve(void *curve);
void release_model(void *model);
void release_problem(void *problem);
void release_record(void *record);
void release_surface(void *surface);

#endif /* TAUT_TEST_CALLS_H */
