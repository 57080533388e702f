/* evolver.h -- Surface Evolver and other programs, run and timed. */
#ifndef TAUT_BENCH_EVOLVER_H
#define TAUT_BENCH_EVOLVER_H

/* Runs a program, its output to `output` ("/dev/null" if none is wanted); CPU seconds of it and its
 * children, or -1. */
double bench_run(const char *const *arguments, const char *output);

/* The area that Evolver finds for a surface file after `levels` refinements, with Newton steps, on
 * quadratic elements and at last on Lagrange elements of the degree given where it is above 2;
 * CPU seconds in *seconds. NaN if it does not say. */
double bench_evolver(const char *file, int degree, int levels, double *seconds);

#endif /* TAUT_BENCH_EVOLVER_H */
