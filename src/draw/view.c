#include "draw/view.h"
#include "core/vec3.h"

#include <math.h>

enum { COARSE = 10 };

/* The area vector of a coarse cell, in the box [-1, 1]^3. */
static void area_vector(const taut_camera *camera, const taut_sheet *sheet, int i, int j, int du,
                        int dv, double area[3])
{
    const size_t columns = (size_t)sheet->v.count;
    const size_t corner[4] = {
        (size_t)i * columns + (size_t)j, (size_t)(i + du) * columns + (size_t)(j + dv),
        (size_t)(i + du) * columns + (size_t)j, (size_t)i * columns + (size_t)(j + dv)};
    double p[4][3];

    for (int k = 0; k < 4; k++) {
        taut_camera_normalise(camera, sheet->points + 3 * corner[k], p[k]);
    }
    for (int c = 0; c < 3; c++) {
        const int e = (c + 1) % 3, f = (c + 2) % 3;
        area[c] =
            (p[1][e] - p[0][e]) * (p[3][f] - p[2][f]) - (p[1][f] - p[0][f]) * (p[3][e] - p[2][e]);
    }
}

/* Adds |A.eye| and |A| over the coarse cells of a sheet. */
static void add_seen(const taut_camera *camera, const taut_sheet *sheet, double *seen, double *all)
{
    const int du = (sheet->u.count + COARSE - 1) / COARSE;
    const int dv = (sheet->v.count + COARSE - 1) / COARSE;
    for (int i = 0; i + du < sheet->u.count; i += du) {
        for (int j = 0; j + dv < sheet->v.count; j += dv) {
            double a[3];
            area_vector(camera, sheet, i, j, du, dv, a);
            const double along = taut_dot(a, camera->eye);
            const double size = taut_length(a);
            if (isfinite(along) && isfinite(size)) {
                *seen += fabs(along);
                *all += size;
            }
        }
    }
}

static double part_seen(const taut_camera *camera, int count, const taut_sheet *sheets)
{
    double seen = 0, all = 0;
    for (int i = 0; i < count; i++) {
        add_seen(camera, &sheets[i], &seen, &all);
    }
    return all > 0 ? seen / all : 1;
}

void taut_view_choose(taut_camera *camera, int count, const taut_sheet *sheets, double view[2])
{
    static const double views[][2] = {{-60, 35}, {-60, 55}, {-30, 35}, {-120, 35},
                                      {30, 35},  {120, 35}, {-80, 15}, {-10, 15}};
    const int tried = (int)(sizeof views / sizeof views[0]);
    const double enough = 0.45;
    double best = -1;
    int chosen = 0;

    for (int i = 0; i < tried && best < enough; i++) {
        taut_camera_aim(camera, views[i][0], views[i][1]);
        const double part = part_seen(camera, count, sheets);
        if (part > best) {
            best = part;
            chosen = i;
        }
    }
    view[0] = views[chosen][0];
    view[1] = views[chosen][1];
    taut_camera_aim(camera, view[0], view[1]);
}
