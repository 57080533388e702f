/* energy.h -- is a flat piece one of least strain? And how it is strained. */
#ifndef TAUT_CERTIFY_PATTERN_ENERGY_H
#define TAUT_CERTIFY_PATTERN_ENERGY_H

#include "certify/pattern/cloth.h"

typedef struct taut_cloth_state {
    double area, flat_area; /* times 4^-unit, as energies are */
    double curvature;       /* iint K dA */
    double energy,
        plain; /* W of the law asked for, and of the one that makes all strains' squares least */
    double
        strain[2]; /* least and largest principal ones of places on a grid, the border among them */
    double warp[2], weft[2],
        shear;        /* along and across the thread at these places, and the angle between them */
    double inner[2];  /* of those not within 0.05 of a corner in s and in t */
    double largest;   /* |strain| of all of them, and of the places of quadrature */
    double angle;     /* the largest ratio of the two stretches at one of these places, less 1 */
    double conformal; /* what angles cost: Dirichlet's integral of the flat piece less its area */
    double torque;    /* energy over the angle that the thread is turned by; NaN: not looked at */
    double residual;  /* gradient of the Lagrangian over the largest that strains of 1 would give */
    double
        stiffness; /* lowest eigenvalue on the constraints over the largest of the diagonal; NaN: not looked at;
                              * -1: there is none above 0 */
    int is_folded; /* det J <= 0 somewhere, or the surface has no metric there */
} taut_cloth_state;

/* `solved`: nonzero: residual and stiffness too. pulse: NULL is fine; once it says stop the state has no meaning. TAUT_NO_MEMORY. */
taut_status taut_cloth_look_at(const taut_cloth *cloth, const taut_cloth_piece *piece, int solved,
                               taut_pulse *pulse, taut_cloth_state *state);

/* The principal strain that is larger in size at (s, t); NaN where there is none. */
double taut_cloth_strain_at(const taut_cloth *cloth, const taut_cloth_piece *piece, double s,
                            double t);

#endif /* TAUT_CERTIFY_PATTERN_ENERGY_H */
