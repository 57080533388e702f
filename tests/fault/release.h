/* release.h -- how fault tests free what a call made: the `release` of a fault_call. */
#ifndef TAUT_TEST_RELEASE_H
#define TAUT_TEST_RELEASE_H

void release_certificate(void *certificate);
void release_curve(void *curve);
void release_model(void *model);
void release_problem(void *problem);
void release_record(void *record);
void release_surface(void *surface);

#endif /* TAUT_TEST_RELEASE_H */
