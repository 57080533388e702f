/* residuals.h -- how plane, conical and circular a mesh of quads is, from its vertices alone. */
#ifndef TAUT_PANELS_RESIDUALS_H
#define TAUT_PANELS_RESIDUALS_H

typedef struct taut_panels_residuals {
    double planarity; /* largest distance between the diagonals over their mean length */
    double balance;   /* largest |w1 - w2 + w3 - w4| around an inner vertex; NaN without any */
    double circle;    /* largest |sum of opposite angles - pi| */
    double distance;  /* filled by the caller */
} taut_panels_residuals;

/* vertices double[nu][nv][3] */
void taut_panels_measure(int nu, int nv, const double *vertices, taut_panels_residuals *residuals);

#endif /* TAUT_PANELS_RESIDUALS_H */
