/* cameras.h -- a camera on a sheet, as figures have it. */
#ifndef TAUT_TEST_CAMERAS_H
#define TAUT_TEST_CAMERAS_H

#include "draw/camera.h"
#include "draw/sheet.h"

/* From azimuth and elevation in degrees, on a page of this size with a margin of 50. */
void camera_on(const taut_sheet *sheet, double azimuth, double elevation, double width,
               double height, taut_camera *camera);

#endif /* TAUT_TEST_CAMERAS_H */
