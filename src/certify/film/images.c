#include "certify/film/images.h"

#include "certify/common/verdict.h"
#include "certify/film/edge.h"
#include "core/constants.h"
#include "core/elementary/elementary.h"
#include "core/fail.h"
#include "core/vec3.h"
#include "problem/film_images.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* x -> R x + t. */
typedef struct motion {
    double r[3][3], t[3];
    int maps;
} motion;

static void apply(const motion *m, const double x[3], double y[3])
{
    for (int c = 0; c < 3; c++) {
        y[c] = taut_dot(m->r[c], x) + m->t[c];
    }
}

/* The mirror in the plane through a point, with a unit normal, after m. */
static void reflect(motion *m, const double point[3], const double n[3])
{
    motion made = *m;
    double along = taut_dot(n, m->t) - taut_dot(n, point);

    for (int c = 0; c < 3; c++) {
        made.t[c] -= 2 * along * n[c];
    }
    for (int k = 0; k < 3; k++) {
        along = n[0] * m->r[0][k] + n[1] * m->r[1][k] + n[2] * m->r[2][k];
        for (int c = 0; c < 3; c++) {
            made.r[c][k] -= 2 * along * n[c];
        }
    }
    *m = made;
}

/* About a unit direction, by two planes through the axis. */
static void turn(motion *m, const double point[3], const double d[3], double angle)
{
    double p[3], q[3], axis[3] = {0, 0, 0};
    const double x = fabs(d[0]), y = fabs(d[1]), z = fabs(d[2]);

    axis[x <= y && x <= z ? 0 : y <= z ? 1 : 2] = 1;
    taut_cross(d, axis, p);
    const double size = taut_norm(p);
    for (int c = 0; c < 3; c++) {
        p[c] /= size;
    }
    taut_cross(d, p, q);
    reflect(m, point, p);
    for (int c = 0; c < 3; c++) {
        axis[c] = taut_cos(angle / 2) * p[c] + taut_sin(angle / 2) * q[c];
    }
    reflect(m, point, axis);
}

static void move_by(motion *m, const double v[3], int power)
{
    double n[3], middle[3] = {0, 0, 0};
    const double size = taut_norm(v);

    for (int c = 0; c < 3; c++) {
        n[c] = v[c] / size;
    }
    reflect(m, middle, n);
    for (int c = 0; c < 3; c++) {
        middle[c] = 0.5 * power * v[c];
    }
    reflect(m, middle, n);
}

static void add_map(motion *m, const taut_film_image *image, int power)
{
    double d[3] = {0, 0, 0};
    const double size = taut_norm(image->guide.direction);

    for (int c = 0; c < 3 && image->kind != TAUT_FILM_TRANSLATE; c++) {
        d[c] = image->guide.direction[c] / size;
    }
    if (image->kind == TAUT_FILM_MIRROR && power % 2 == 1) {
        reflect(m, image->guide.point, d);
    } else if (image->kind == TAUT_FILM_HALF_TURN && power % 2 == 1) {
        turn(m, image->guide.point, d, TAUT_PI);
    } else if (image->kind == TAUT_FILM_TURN) {
        turn(m, image->guide.point, d, power * image->angle);
    } else if (image->kind == TAUT_FILM_TRANSLATE) {
        move_by(m, image->vector, power);
    }
    m->maps++;
}

static motion motion_of(const taut_film_problem *problem, const taut_film_copies *copies, int copy)
{
    static const motion none = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {0, 0, 0}, 0};
    motion m = none;
    if (copy > 0) {
        m = motion_of(problem, copies, copies->copies[copy].of);
        add_map(&m, &problem->images[copies->copies[copy].image], copies->copies[copy].power);
    }
    return m;
}

/* Largest distance over the size, and that over what rounding of the maps may do. */
typedef struct worst {
    double residual, limit;
    char where[TAUT_FILM_COPY_NAME];
} worst;

/* film and copy: NULL where the model has none of that name. */
static void judge(const taut_surface *film, const taut_surface *copy, const char *name,
                  const motion *m, worst *w)
{
    const int same = film != NULL && copy != NULL && taut_surface_weights(copy) == NULL &&
                     taut_basis_equal(taut_surface_u(film), taut_surface_u(copy)) &&
                     taut_basis_equal(taut_surface_v(film), taut_surface_v(copy));
    const int count =
        same ? taut_basis_count(taut_surface_u(film)) * taut_basis_count(taut_surface_v(film)) : 0;
    double away = 0, size = taut_norm(m->t);

    for (int k = 0; same && k < count; k++) {
        const double *x = taut_surface_points(film) + 3 * k, *y = taut_surface_points(copy) + 3 * k;
        double image[3];
        apply(m, x, image);
        away = taut_certify_max(taut_distance(image, y), away);
        size = fmax(size, fmax(taut_norm(x), taut_norm(y)));
    }
    const double residual = same ? away / size : INFINITY;
    const double limit = 64 * m->maps * TAUT_UNIT_ROUNDOFF;
    if (!(residual / limit <= w->residual / w->limit)) {
        w->residual = residual;
        w->limit = limit;
        snprintf(w->where, sizeof w->where, "%s", name);
    }
}

taut_status taut_film_images_certify(const taut_model *model, const taut_film_problem *problem,
                                     int patches, const char *const *names,
                                     taut_certificate *certificate, taut_error *error)
{
    taut_film_copies copies;
    worst w = {.residual = 0, .limit = 64 * TAUT_UNIT_ROUNDOFF, .where = ""};

    if (problem->image_count == 0) {
        return TAUT_OK;
    }
    taut_arena *arena = taut_arena_new();
    taut_status status = taut_film_copies_new(problem, arena, &copies);
    for (int copy = 1; status == TAUT_OK && copy < copies.count; copy++) {
        const motion m = motion_of(problem, &copies, copy);
        for (int p = 0; p < patches; p++) {
            char name[TAUT_FILM_COPY_NAME];
            taut_film_copy_name(names[p], copy, name);
            judge(taut_film_find_surface(model, names[p]), taut_film_find_surface(model, name),
                  name, &m, &w);
        }
    }
    taut_arena_free(arena);
    const taut_claim claim = {.claim = "images",
                              .kind = TAUT_EXACT,
                              .residual = w.residual,
                              .limit = w.limit,
                              .holds = taut_certify_below(w.residual, w.limit),
                              .where = w.where};
    if (status == TAUT_OK) {
        status = taut_certificate_add(certificate, &claim);
    }
    return status == TAUT_OK ? TAUT_OK : taut_fail_memory(error);
}

void taut_film_images_identify(const taut_film_problem *problem, const char *name,
                               const taut_expected_basis *u, const taut_expected_basis *v,
                               taut_identity *identity)
{
    const int copies = taut_film_copies_count(problem, TAUT_FILM_IMAGES_MAX);

    for (int copy = 1; copy < copies && problem->image_count > 0; copy++) {
        char made[TAUT_FILM_COPY_NAME];
        taut_film_copy_name(name, copy, made);
        taut_identity_surface(identity, taut_identity_find_surface(identity, made), made, u, v);
    }
}
