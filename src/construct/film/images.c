/* images.c -- points of copies, from those of the copies before:
 *
 *     mirror       x - 2 ((x - p) . n) n
 *     turn by a    p + along + cos(a) across + sin(a) d x across,   along = ((x - p) . d) d, across = x - p - along
 *     half-turn    p + along - across
 *     translation  x + v
 */
#include "construct/film/images.h"

#include "construct/common/build.h"
#include "core/elementary/elementary.h"
#include "core/fail.h"
#include "core/vec3.h"
#include "problem/film_images.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const double alike = 1e-9; /* of the size: surfaces no further apart are one */

static taut_status check_image(const taut_film_problem *problem, int k, taut_error *error)
{
    const taut_film_image *image = &problem->images[k];
    const int moves = image->kind == TAUT_FILM_TRANSLATE;
    const double length = taut_norm(moves ? image->vector : image->guide.direction);
    char where[48];

    snprintf(where, sizeof where, "/images/%d", k);
    if (!(length > 0 && isfinite(length)) || (!moves && !isfinite(taut_norm(image->guide.point)))) {
        return taut_fail_expected(error, TAUT_BAD_INPUT, "value", where, length,
                                  "a finite point, and a direction of a length above 0",
                                  "found a direction of length %.3g", length);
    }
    if (image->count < 0 || (image->kind == TAUT_FILM_TURN && !isfinite(image->angle))) {
        return taut_fail(error, TAUT_BAD_INPUT, "value", where, image->count, 1,
                         "found an angle of %.3g and a count of %d, expected a finite angle and 1 "
                         "or more",
                         image->angle, image->count);
    }
    return TAUT_OK;
}

taut_status taut_film_images_check(const taut_film_problem *problem, double points,
                                   taut_error *error)
{
    const int patches = problem->patch_count > 0 ? problem->patch_count : 1;
    taut_status status = TAUT_OK;

    for (int k = 0; status == TAUT_OK && k < problem->image_count; k++) {
        status = check_image(problem, k, error);
    }
    if (status != TAUT_OK) {
        return status;
    }
    const int copies = taut_film_copies_count(problem, TAUT_FILM_IMAGES_MAX);
    if ((double)copies * patches > TAUT_FILM_IMAGES_MAX) {
        return taut_fail(error, TAUT_BAD_INPUT, "size", "/images", (double)copies * patches,
                         TAUT_FILM_IMAGES_MAX,
                         "the film with its images has %s%.0f surfaces, expected at most %d",
                         copies > TAUT_FILM_IMAGES_MAX ? "more than " : "",
                         (double)copies * patches, TAUT_FILM_IMAGES_MAX);
    }
    return copies * points > TAUT_FILM_IMAGES_POINTS_MAX
               ? taut_fail(error, TAUT_BAD_INPUT, "size", "/images", copies * points,
                           TAUT_FILM_IMAGES_POINTS_MAX,
                           "the film with its images has %.0f control points, expected at most %d",
                           copies * points, TAUT_FILM_IMAGES_POINTS_MAX)
               : TAUT_OK;
}

static void map_point(const taut_film_image *image, int power, const double x[3], double y[3])
{
    double d[3], along[3], across[3], beside[3];

    if (image->kind == TAUT_FILM_TRANSLATE) {
        for (int c = 0; c < 3; c++) {
            y[c] = x[c] + power * image->vector[c];
        }
        return;
    }
    if (power % 2 == 0 && image->kind != TAUT_FILM_TURN) {
        memcpy(y, x, 3 * sizeof(double));
        return;
    }
    const double length = taut_norm(image->guide.direction);
    for (int c = 0; c < 3; c++) {
        d[c] = image->guide.direction[c] / length;
        across[c] = x[c] - image->guide.point[c];
    }
    const double size = taut_dot(across, d);
    for (int c = 0; c < 3; c++) {
        along[c] = size * d[c];
        across[c] -= along[c];
    }
    taut_cross(d, across, beside);
    const double angle = power * image->angle;
    const double cosine = image->kind == TAUT_FILM_TURN ? taut_cos(angle) : -1;
    const double sine = image->kind == TAUT_FILM_TURN ? taut_sin(angle) : 0;
    for (int c = 0; c < 3; c++) {
        y[c] = image->kind == TAUT_FILM_MIRROR
                   ? x[c] - 2 * along[c]
                   : image->guide.point[c] + (along[c] + (cosine * across[c] + sine * beside[c]));
    }
}

/* Mean of the points, and the sum of their squared distances from it over their number: the same of a surface that is run another way. */
typedef struct shape {
    double mean[3], spread;
} shape;

static shape shape_of(const double *points, int count)
{
    shape s = {{0, 0, 0}, 0};

    for (int k = 0; k < count; k++) {
        taut_add_scaled(1.0 / count, points + 3 * k, s.mean);
    }
    for (int k = 0; k < count; k++) {
        const double away = taut_distance(points + 3 * k, s.mean);
        s.spread += away * away / count;
    }
    return s;
}

/* The copy of a surface, after those before it. */
static taut_status add_copy(const taut_film_problem *problem, const taut_film_copy *copy,
                            int number, int patch, int patches, taut_arena *arena,
                            taut_model *model, taut_error *error)
{
    const taut_surface *of = taut_model_surface(model, copy->of * patches + patch);
    const taut_surface *film = taut_model_surface(model, patch);
    const int count = taut_basis_count(taut_surface_u(of)) * taut_basis_count(taut_surface_v(of));
    double *points = taut_arena_take(arena, (size_t)count, 3 * sizeof(double));
    char name[TAUT_FILM_COPY_NAME];
    taut_surface *surface = NULL;

    if (points == NULL) {
        return taut_fail_memory(error);
    }
    for (int k = 0; k < count; k++) {
        map_point(&problem->images[copy->image], copy->power, taut_surface_points(of) + 3 * k,
                  points + 3 * k);
        if (!isfinite(taut_norm(points + 3 * k))) {
            return taut_fail(error, TAUT_NO_SOLUTION, "overflow", "/images", taut_none, taut_none,
                             "a point of an image is beyond the range of double precision");
        }
    }
    taut_film_copy_name(taut_surface_name(film), number, name);
    const taut_status status = taut_surface_new(name, taut_surface_u(of), taut_surface_v(of),
                                                points, NULL, &surface, error);
    return status == TAUT_OK ? taut_construct_add_surface(model, surface, error) : status;
}

/* No two surfaces in one place. */
static taut_status check_apart(const taut_model *model, int patches, taut_arena *arena,
                               taut_error *error)
{
    const int all = taut_model_surface_count(model);
    shape *shapes = taut_arena_take(arena, (size_t)all, sizeof *shapes);

    if (shapes == NULL) {
        return taut_fail_memory(error);
    }
    for (int k = 0; k < all; k++) {
        const taut_surface *s = taut_model_surface(model, k);
        const int count = taut_basis_count(taut_surface_u(s)) * taut_basis_count(taut_surface_v(s));
        shapes[k] = shape_of(taut_surface_points(s), count);
        for (int other = 0; k >= patches && other < k; other++) {
            const double size = sqrt(shapes[k].spread);
            if (taut_distance(shapes[k].mean, shapes[other].mean) <= alike * size &&
                fabs(shapes[k].spread - shapes[other].spread) <= alike * shapes[k].spread) {
                return taut_fail(error, TAUT_BAD_INPUT, "image-twice", "/images", k, other,
                                 "surface %.80s lies where %.80s lies already: give each image "
                                 "once, of a film that it does not map to itself",
                                 taut_surface_name(s),
                                 taut_surface_name(taut_model_surface(model, other)));
            }
        }
    }
    return TAUT_OK;
}

taut_status taut_film_images_add(const taut_film_problem *problem, taut_arena *arena,
                                 taut_model *model, taut_error *error)
{
    const int patches = taut_model_surface_count(model);
    taut_film_copies copies;

    if (problem->image_count == 0) {
        return TAUT_OK;
    }
    taut_status status = taut_film_copies_new(problem, arena, &copies);
    if (status != TAUT_OK) {
        return taut_fail_memory(error);
    }
    for (int k = patches; status == TAUT_OK && k < copies.count * patches; k++) {
        status = add_copy(problem, &copies.copies[k / patches], k / patches, k % patches, patches,
                          arena, model, error);
    }
    return status == TAUT_OK ? check_apart(model, patches, arena, error) : status;
}
