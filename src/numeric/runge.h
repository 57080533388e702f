/* runge.h -- one step of a system of ordinary differential equations, of order 8.
 *
 * The method of Dormand and Prince with twelve stages and the error estimates of orders 5 and 3
 * ([HairerNorsettWanner1993] section II.5, II.10). The system does not name its variable.
 */
#ifndef TAUT_NUMERIC_RUNGE_H
#define TAUT_NUMERIC_RUNGE_H

enum { TAUT_RUNGE_STAGES = 12, TAUT_RUNGE_MAX = 8 /* unknowns */ };

typedef struct taut_runge {
    int count; /* of unknowns */
    /* slope[count] at y; 0 where the system says nothing there. */
    int (*slope)(void *context, const double *y, double *slope);
    void *context;
} taut_runge;

/* The step h from y, where the slope is `first`: out[count]; errors[2][count], the differences to the
 * results of orders 5 and 3. 0 where a stage has no slope: then nothing is written. */
int taut_runge_step(const taut_runge *system, const double *y, const double *first, double h,
                    double *out, double errors[2][TAUT_RUNGE_MAX]);

/* What two norms of errors make of a step of h: of order 8. */
double taut_runge_error(double fifth, double third);

#endif /* TAUT_NUMERIC_RUNGE_H */
