/* camera.h -- from the world to the page: an orthographic view, z up.
 *
 *     eye   = ( cos e cos a,  cos e sin a, sin e)      toward the viewer, a azimuth, e elevation
 *     right = (-sin a,        cos a,       0    )
 *     up    = (-sin e cos a, -sin e sin a, cos e)
 * The three are orthonormal for every a and e. World points are first brought into [-1, 1]^3 by
 * the box of all that is drawn, so that no finite coordinate is too large or too small.
 */
#ifndef TAUT_DRAW_CAMERA_H
#define TAUT_DRAW_CAMERA_H

#include <stddef.h>

typedef struct taut_camera {
    double low[3], high[3]; /* the box of the world; low > high while empty */
    double centre[3], half; /* half the longest side of the box, or 1 */
    double right[3], up[3], eye[3];
    double scale;      /* page units to half a box */
    double origin[2];  /* where the centre of the box falls */
    double seen[2][2]; /* the box of what is seen, before scale and origin: low, high */
} taut_camera;

/* Starts with an empty box. */
void taut_camera_init(taut_camera *camera);
/* Widens the box; points that are not finite are passed over. */
void taut_camera_include(taut_camera *camera, size_t count, const double *points);
/* Ends the widening. 0 if there was no finite point. */
int taut_camera_settle(taut_camera *camera);
/* Does a point lie outside the cube three times as large as the settled box, about its centre? A
 * net that does would leave the surface a corner of the page. Points that are not finite do not. */
int taut_camera_is_far(const taut_camera *camera, size_t count, const double *points);
/* Angles in degrees. Forgets what was seen. */
void taut_camera_aim(taut_camera *camera, double azimuth, double elevation);
/* Widens what is to be seen on the page. */
void taut_camera_see(taut_camera *camera, size_t count, const double *points);
/* Fits all that is seen into the place x0 y0 x1 y1 of the page. */
void taut_camera_fit(taut_camera *camera, const double place[4]);
/* The same, but no larger than at `most` page units to half a box. */
void taut_camera_fit_within(taut_camera *camera, const double place[4], double most);

/* (x, y) on the page and the depth in the same unit, larger is nearer; NaN for points that are
 * not finite. */
void taut_camera_project(const taut_camera *camera, const double point[3], double page[3]);
/* The point in [-1, 1]^3. */
void taut_camera_normalise(const taut_camera *camera, const double point[3], double normal[3]);

#endif /* TAUT_DRAW_CAMERA_H */
