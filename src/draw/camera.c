#include "draw/camera.h"

#include "core/constants.h"
#include "core/elementary/elementary.h"
#include "core/vec3.h"

#include <assert.h>
#include <float.h>
#include <math.h>
#include <string.h>

void taut_camera_init(taut_camera *camera)
{
    memset(camera, 0, sizeof *camera);
    for (int c = 0; c < 3; c++) {
        camera->low[c] = DBL_MAX;
        camera->high[c] = -DBL_MAX;
    }
}

void taut_camera_include(taut_camera *camera, size_t count, const double *points)
{
    for (size_t i = 0; i < count; i++) {
        const double *p = points + 3 * i;
        if (isfinite(p[0]) && isfinite(p[1]) && isfinite(p[2])) {
            for (int c = 0; c < 3; c++) {
                camera->low[c] = fmin(camera->low[c], p[c]);
                camera->high[c] = fmax(camera->high[c], p[c]);
            }
        }
    }
}

int taut_camera_settle(taut_camera *camera)
{
    camera->half = 0;
    if (camera->low[0] > camera->high[0]) {
        return 0;
    }
    for (int c = 0; c < 3; c++) {
        camera->centre[c] = camera->low[c] / 2 + camera->high[c] / 2;
        camera->half = fmax(camera->half, camera->high[c] / 2 - camera->low[c] / 2);
    }
    if (!(camera->half > 0)) {
        camera->half = 1; /* one point: any unit will do */
    }
    return 1;
}

void taut_camera_aim(taut_camera *camera, double azimuth, double elevation)
{
    const double degree = TAUT_PI / 180;
    const double ca = taut_cos(azimuth * degree), sa = taut_sin(azimuth * degree);
    const double ce = taut_cos(elevation * degree), se = taut_sin(elevation * degree);
    const double eye[3] = {ce * ca, ce * sa, se};
    const double right[3] = {-sa, ca, 0};
    const double up[3] = {-se * ca, -se * sa, ce};

    memcpy(camera->eye, eye, sizeof eye);
    memcpy(camera->right, right, sizeof right);
    memcpy(camera->up, up, sizeof up);
    for (int c = 0; c < 2; c++) {
        camera->seen[0][c] = DBL_MAX;
        camera->seen[1][c] = -DBL_MAX;
    }
}

void taut_camera_normalise(const taut_camera *camera, const double point[3], double normal[3])
{
    for (int c = 0; c < 3; c++) {
        normal[c] = (point[c] - camera->centre[c]) / camera->half;
    }
}

int taut_camera_is_far(const taut_camera *camera, size_t count, const double *points)
{
    static const double far = 3 + 1e-9; /* the polygon of a symmetric parabola reaches 3 */
    for (size_t i = 0; i < count; i++) {
        const double *p = points + 3 * i;
        double at[3];
        taut_camera_normalise(camera, p, at);
        if (isfinite(p[0]) && isfinite(p[1]) && isfinite(p[2]) &&
            !(fabs(at[0]) <= far && fabs(at[1]) <= far && fabs(at[2]) <= far)) {
            return 1;
        }
    }
    return 0;
}

void taut_camera_see(taut_camera *camera, size_t count, const double *points)
{
    for (size_t i = 0; i < count; i++) {
        double p[3];
        taut_camera_normalise(camera, points + 3 * i, p);
        const double at[2] = {taut_dot(p, camera->right), taut_dot(p, camera->up)};
        if (isfinite(at[0]) && isfinite(at[1])) {
            for (int c = 0; c < 2; c++) {
                camera->seen[0][c] = fmin(camera->seen[0][c], at[c]);
                camera->seen[1][c] = fmax(camera->seen[1][c], at[c]);
            }
        }
    }
}

void taut_camera_fit(taut_camera *camera, const double place[4])
{
    taut_camera_fit_within(camera, place, INFINITY);
}

void taut_camera_fit_within(taut_camera *camera, const double place[4], double most)
{
    const double room[2] = {place[2] - place[0], place[3] - place[1]};
    double centre[2] = {0, 0};
    double side = 0; /* the larger part of the room that a scale of 1 takes */

    assert(camera->seen[0][0] <= camera->seen[1][0]);
    for (int c = 0; c < 2; c++) {
        side = fmax(side, (camera->seen[1][c] - camera->seen[0][c]) / room[c]);
        centre[c] = (camera->seen[0][c] + camera->seen[1][c]) / 2;
    }
    /* Seen end on, a line is a point: a hundredth of the room is the smallest it is blown up. */
    camera->scale = fmin(1 / fmax(side, 0.01 / fmax(room[0], room[1])), most);
    camera->origin[0] = (place[0] + place[2]) / 2 - camera->scale * centre[0];
    camera->origin[1] = (place[1] + place[3]) / 2 + camera->scale * centre[1];
}

void taut_camera_project(const taut_camera *camera, const double point[3], double page[3])
{
    double p[3];
    taut_camera_normalise(camera, point, p);
    page[0] = camera->origin[0] + camera->scale * taut_dot(p, camera->right);
    page[1] = camera->origin[1] - camera->scale * taut_dot(p, camera->up);
    page[2] = camera->scale * taut_dot(p, camera->eye);
}
