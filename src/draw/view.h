/* view.h -- the view when nobody asked for one. */
#ifndef TAUT_DRAW_VIEW_H
#define TAUT_DRAW_VIEW_H

#include "draw/camera.h"
#include "draw/sheet.h"

/* Aims the settled camera from azimuth -60, elevation 35 degrees, or, where the surfaces would
 * mostly be seen edge on from there, from the first of some other directions that shows them. */
void taut_view_aim(taut_camera *camera, int count, const taut_sheet *sheets);

#endif /* TAUT_DRAW_VIEW_H */
