/* taut/recognise.h -- is this net one of the minimal surfaces that c- and h- bases can hold?
 *
 * Every conformal harmonic net on {1, x, sin x, cos x} x {1, y, sinh y, cosh y} is, up to motion,
 * scale and a shift of its window, an associate r_theta of taut/bonnet.h with sign -: two numbers,
 * lambda and theta, say which. With zeta = x + i y, r = Re(const + A zeta + B e^(i zeta) +
 * D e^(-i zeta)),
 *
 *     -A.A = scale^2 e^(-2 i theta),    |B.D| / (|B| |D|) = w^2 = 1 - lambda^2,
 *     |A.conj(B)| |A.conj(D)| = 4 lambda^2 |B|^2 |D|^2
 *
 * A conformal harmonic bicubic net is Enneper's surface or a plane: its Gauss map is of degree one.
 * Source: [XuWang2006] section 10 (the relations), docs/papers/minimal-mesh.md (the recognition).
 */
#ifndef TAUT_RECOGNISE_H
#define TAUT_RECOGNISE_H

#include "taut/surface.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct taut_family_member {
    const char *name; /* "catenoid", "helicoid", "associate of the catenoid", "Bonnet's surface",
                         "Thomsen's surface", "associate of Bonnet's surface", "Enneper's surface";
                         static */
    double scale;     /* times the surface of taut/bonnet.h (Enneper's: of the normalised family) */
    double lambda;    /* 1 for Enneper's surface */
    double theta;     /* in (-pi, pi]; 0 for Enneper's surface, whose associates are itself */
    double residual;  /* largest distance from that surface over the size of the net; Enneper's: the
                         largest of |E-G|/E, |F|/E, |r_uu + r_vv|/|r_uu| */
    int turned;       /* nonzero: x runs along v and y along u */
    double shift[2];  /* zeta = x + shift[0] + i (y + shift[1]) */
    double motion[3][4]; /* (R | t): this net is R scale r_theta + t, R a rotation; zero for
                            Enneper's surface */
} taut_family_member;

/* TAUT_NO_SOLUTION where the net is none of them to 1e-9 (found: the residual): then *member is
 * untouched. No allocation. Near lambda = 1 what cancels in the plain family hides a net of the
 * normalised one from about 1 - lambda = 1e-7 on. */
TAUT_API taut_status taut_surface_recognise(const taut_surface *surface, taut_family_member *member,
                                            taut_error *error);

#ifdef __cplusplus
}
#endif
#endif /* TAUT_RECOGNISE_H */
