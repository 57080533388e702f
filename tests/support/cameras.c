#include "cameras.h"

#include "check.h"

void camera_on(const taut_sheet *sheet, double azimuth, double elevation, double width,
               double height, taut_camera *camera)
{
    const double frame[4] = {50, 50, width - 50, height - 50};
    const size_t count = (size_t)sheet->u.count * (size_t)sheet->v.count;
    taut_camera_init(camera);
    taut_camera_include(camera, count, sheet->points);
    CHECK(taut_camera_settle(camera), "points");
    taut_camera_aim(camera, azimuth, elevation);
    taut_camera_see(camera, count, sheet->points);
    taut_camera_fit(camera, frame);
}
