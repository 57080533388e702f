/* vertices.h -- the vertices of the conical and the circular mesh, and the surface itself, in the
 * coordinates of the normalised family, where nothing cancels and lambda = 1 is no exception. */
#ifndef TAUT_PANELS_VERTICES_H
#define TAUT_PANELS_VERTICES_H

/* The window of a member of sign -, in p = u / w and q = v / w (for lambda = 1 of Enneper's
 * surface), and where its panels go: x^ of the normalised family becomes
 * matrix (factor x^ + (0, 0, lift)) + (last column of matrix). */
typedef struct taut_panels_window {
    double lambda, w;
    double middle[2]; /* of the window, p and q */
    double step[2];   /* of one panel */
    int count[2];     /* panels */
    double factor, lift;
    double matrix[3][4];
} taut_panels_window;

/* x[3] of vertex (i, j), 0 <= i <= count[0] and so on. For the conical mesh the result is the share
 * that is left of the angle at which neighbouring tangent planes meet: 1 for small steps; where it
 * is 0 or less there is no such vertex. */
double taut_panels_conical(const taut_panels_window *window, int i, int j, double x[3]);
void taut_panels_circular(const taut_panels_window *window, int i, int j, double x[3]);
void taut_panels_surface(const taut_panels_window *window, int i, int j, double x[3]);
/* matrix and factor. */
void taut_panels_place(const taut_panels_window *window, const double x[3], double placed[3]);

#endif /* TAUT_PANELS_VERTICES_H */
