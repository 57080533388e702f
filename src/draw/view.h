/* view.h -- the view when nobody asked for one. */
#ifndef TAUT_DRAW_VIEW_H
#define TAUT_DRAW_VIEW_H

#include "draw/camera.h"
#include "draw/sheet.h"

/* Aims the settled camera, and says how in *view: from azimuth -60, elevation 35 degrees, or, where
 * the surfaces would mostly be seen edge on from there, from the first of some other directions
 * that shows them. */
void taut_view_choose(taut_camera *camera, int count, const taut_sheet *sheets, double view[2]);

#endif /* TAUT_DRAW_VIEW_H */
