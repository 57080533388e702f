/* arrows.c -- reactions: the force of the cables on each support, the arrow's head at the corner that it
 * holds: outside, where the film hides nothing of it. */
#include "core/elementary/elementary.h"
#include "draw/parts.h"

#include <math.h>
#include <string.h>

static const char *const corner_names[4] = {"u0v0", "u1v0", "u0v1", "u1v1"};

/* The surface that a support is a corner of, and *corner, what it is called there: "u0v0" of a film of one patch, else "NAME.u0v0". NULL:
 * there is none. */
static const taut_surface *find_patch(const taut_model *model, const char *support,
                                      const char **corner)
{
    const char *dot = strrchr(support, '.');

    *corner = dot != NULL ? dot + 1 : support;
    for (int i = 0; i < taut_model_surface_count(model); i++) {
        const taut_surface *surface = taut_model_surface(model, i);
        const char *name = taut_surface_name(surface);
        if (dot == NULL || (strlen(name) == (size_t)(dot - support) &&
                            strncmp(name, support, (size_t)(dot - support)) == 0)) {
            return surface;
        }
    }
    return NULL;
}

/* Where the corner of this name is; 0 where none is called so. */
static int find_corner(const taut_surface *surface, const char *name, double corner[3])
{
    const size_t nu = (size_t)taut_basis_count(taut_surface_u(surface)),
                 nv = (size_t)taut_basis_count(taut_surface_v(surface));

    for (size_t k = 0; k < 4; k++) {
        if (strcmp(name, corner_names[k]) == 0) {
            const size_t at = (k % 2 == 1 ? nu - 1 : 0) * nv + (k >= 2 ? nv - 1 : 0);
            memcpy(corner, taut_surface_points(surface) + 3 * at, 3 * sizeof(double));
            return 1;
        }
    }
    return 0;
}

/* 0 where that is no force. */
static int read_force(const taut_record *numbers, double force[3])
{
    for (size_t c = 0; c < 3; c++) {
        force[c] = taut_record_number(taut_record_at(numbers, c));
    }
    return taut_record_count(numbers) == 3 &&
           isfinite(taut_hypot(taut_hypot(force[0], force[1]), force[2]));
}

void taut_arrows_fill(const taut_model *model, const taut_surface *alone, taut_arrows *arrows,
                      double *most)
{
    const taut_certificate *certificate = taut_model_certificate(model);
    const taut_record *supports = taut_record_get(taut_model_details(model), "supports");
    const taut_record *forces =
        certificate != NULL ? taut_record_get(taut_certificate_figures(certificate), "reactions")
                            : NULL;

    arrows->count = 0;
    for (size_t k = 0; k < taut_record_count(forces) && arrows->count < TAUT_ARROWS_MOST; k++) {
        double *corner = arrows->head[arrows->count], *force = arrows->force[arrows->count];
        const char *name = NULL;
        const taut_surface *patch =
            find_patch(model, taut_record_text(taut_record_at(supports, k)), &name);
        if (patch != NULL && (alone == NULL || patch == alone) &&
            find_corner(patch, name, corner) && read_force(taut_record_at(forces, k), force)) {
            *most = fmax(*most, taut_hypot(taut_hypot(force[0], force[1]), force[2]));
            arrows->count++;
        }
    }
}

void taut_arrows_scale(taut_arrows *arrows, double scale)
{
    for (int k = 0; k < arrows->count; k++) {
        for (int c = 0; c < 3; c++) {
            arrows->tail[k][c] = arrows->head[k][c] - scale * arrows->force[k][c];
        }
    }
}

/* Two barbs at the end of a line, of a length on the page, not longer than the line. */
static void add_head(const double line[2][3], taut_ink ink, taut_scene *scene)
{
    static const double barb = 9, across = 0.4;
    const double way[2] = {line[1][0] - line[0][0], line[1][1] - line[0][1]};
    const double length = taut_hypot(way[0], way[1]), size = fmin(barb, length) / length;
    double head[3][3];

    if (!(length > 0)) {
        return; /* it points at the eye */
    }
    for (int side = -1; side <= 1; side++) {
        double *x = head[side + 1];
        memcpy(x, line[1], sizeof head[0]);
        if (side != 0) {
            x[0] -= size * (way[0] - side * across * way[1]);
            x[1] -= size * (way[1] + side * across * way[0]);
        }
    }
    taut_scene_line(scene, 3, head[0], ink, 1.8);
}

taut_status taut_arrows_add(const taut_arrows *arrows, const taut_camera *camera, taut_scene *scene)
{
    static const taut_ink ink = {24, 104, 92};

    for (int k = 0; k < arrows->count; k++) {
        double line[2][3];
        taut_camera_project(camera, arrows->tail[k], line[0]);
        taut_camera_project(camera, arrows->head[k], line[1]);
        taut_scene_line(scene, 2, line[0], ink, 1.8);
        add_head((const double(*)[3])line, ink, scene);
    }
    return scene->status;
}
