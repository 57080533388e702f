/* bezier_net.h -- a net of Bezier points of which some are known: what harmonic and biharmonic
 * problems are made of. */
#ifndef TAUT_TEST_BEZIER_NET_H
#define TAUT_TEST_BEZIER_NET_H

#include "taut/basis.h"

enum { BEZIER_NET_SIZE = 32 };

typedef struct bezier_net {
    taut_basis *u, *v;
    int n, m;                                             /* their degrees */
    double points[3 * BEZIER_NET_SIZE * BEZIER_NET_SIZE]; /* double[n + 1][m + 1][3] */
    unsigned char known[BEZIER_NET_SIZE * BEZIER_NET_SIZE];
} bezier_net;

typedef enum bezier_net_part {
    BEZIER_NET_ROWS, /* of the edges u0 and u1 */
    BEZIER_NET_FRAME /* of all four edges */
} bezier_net_part;

/* Points zero, none known; end it to free the bases. */
void bezier_net_start(bezier_net *net, int n, int m, const double u[2], const double v[2]);
void bezier_net_end(bezier_net *net);
/* These points are known, and no others. */
void bezier_net_know(bezier_net *net, bezier_net_part part);
/* All points random, within `size` of the offset in each coordinate. */
void bezier_net_fill(bezier_net *net, double offset, double size);

#endif /* TAUT_TEST_BEZIER_NET_H */
