/* elementary.h -- the elementary functions, the same bits on every processor, compiler and system.
 *
 * A C library rounds as it likes, and glibc as the processor has it: with fused operations the sine
 * of one machine is not that of another. These use + - * / and sqrt, which IEEE 754 fixes, and
 * integers. All are computed with 10 bits or more to spare and rounded once: errors are below 0.52
 * of a unit in the last place, those of taut_pow below 0.55. Special values are those of C17,
 * Annex F; no flags are promised. Rounding is to nearest.
 *
 * What is exact in every C library (sqrt, fabs, floor, ceil, rint, fmin, fmax, frexp, ldexp, fmod) is taken from
 * there.
 */
#ifndef TAUT_CORE_ELEMENTARY_H
#define TAUT_CORE_ELEMENTARY_H

double taut_exp(double x);
double taut_exp2(double x);
double taut_expm1(double x);
double taut_log(double x);
double taut_log2(double x);
double taut_log10(double x);
double taut_pow(double x, double y);

double taut_sin(double x);
double taut_cos(double x);
/* Both, with the bits of each, for the work of one. */
void taut_sin_cos(double x, double *sine, double *cosine);
double taut_tan(double x);
double taut_asin(double x);
double taut_acos(double x);
double taut_atan(double x);
double taut_atan2(double y, double x);

double taut_sinh(double x);
double taut_cosh(double x);
/* Both, with the bits of each. */
void taut_sinh_cosh(double x, double *sinh, double *cosh);
double taut_tanh(double x);

double taut_hypot(double x, double y);

#endif /* TAUT_CORE_ELEMENTARY_H */
