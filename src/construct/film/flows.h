/* flows.h -- fields whose flux no sail can have less energy than, as numbers to be chosen.
 *
 *     X   = (-psi_y, psi_x, w)            on Q x R,  |X| <= 1,      no divergence
 *     A_k = (a_0 + grad g_k, c_k - psi)   along cable k,  |A_k| <= R_k = T_k / s,   curl A_k = X
 *     D   = int over held edges (a_0.dr - psi dz) - sum over cables [g_k + c_k z]
 *
 * and s D is a bound (docs/film.md, film.md section 6), edges and cables as they run round the film. Q a
 * convex quadrilateral that all that is held lies in, r(s, t) = (x, y) its bilinear parameters over
 * [0, 1]^2, J = r_s x r_t > 0. In these
 *
 *     psi of degree (4, 4),   a_0 = B dt of degree (5, 4), w = B_s / J,   g_k of degree (5, 5)
 *
 * by Bernstein coefficients; psi and g_k are 0 at (0, 0) and B at s = 0, which changes no field. All
 * lengths are those of maps that are linear in the coefficients (film's, over its limit, and cable's):
 *
 *     (psi_s r_t - psi_t r_s, B_s) / J,      (g_s r_t - (B + g_t) r_s, J (c - psi)) / (J R)
 */
#ifndef TAUT_CONSTRUCT_FILM_FLOWS_H
#define TAUT_CONSTRUCT_FILM_FLOWS_H

#include "taut/film.h"

enum {
    TAUT_FLOWS_PSI = 4,
    TAUT_FLOWS_ALONG = 5, /* degree of B in s and of g_k */
    TAUT_FLOWS_SHARED = 25 - 1 + 25,
    TAUT_FLOWS_OWN = 36 - 1 + 1, /* g_k, then c_k */
    TAUT_FLOWS_ROW = TAUT_FLOWS_SHARED + TAUT_FLOWS_OWN,
    TAUT_FLOWS_MOST = TAUT_FLOWS_SHARED + 4 * TAUT_FLOWS_OWN,
    TAUT_FLOWS_LOOK = 65
};

typedef struct taut_flows {
    double origin[3];
    int exponent;         /* lengths are divided by 2^exponent */
    double frame[3][3];   /* rows: x, y, z; right-handed */
    double corners[4][2]; /* of Q as it runs round, counter-clockwise: (0,0), (1,0), (1,1), (0,1) */
    int cables;           /* how many */
    int edges[4];         /* which they are */
    double radii[4];      /* R_k, scaled */
    double objective[TAUT_FLOWS_MOST];
} taut_flows;

/* Frame, quadrilateral and objective of a film. radii: R of each edge that is a cable, in the user's
 * unit; 0: held. Returns 1, or 0 where no frame is found: the edges span no area. */
int taut_flows_new(const taut_surface *surface, const double radii[4], taut_flows *flows);

/* The map of block (a cable's number, or -1: the film) at (s, t): rows double[3][TAUT_FLOWS_ROW]. */
void taut_flows_map(const taut_flows *flows, int block, double s, double t, double *rows);

/* Lengths of a block's field over a grid: double[TAUT_FLOWS_LOOK][TAUT_FLOWS_LOOK], at the places of taut_flows_at both
 * ways. x: all numbers, double[TAUT_FLOWS_MOST]. */
void taut_flows_lengths(const taut_flows *flows, int block, const double *x, double *lengths);
/* k = 0..TAUT_FLOWS_LOOK - 1: Chebyshev's places, with the ends. */
double taut_flows_at(int k);

#endif /* TAUT_CONSTRUCT_FILM_FLOWS_H */
