#include "io/flat/spread.h"

#include "core/memory.h"
#include "core/vec3.h"
#include "io/flat/cloth.h"

#include <math.h>
#include <string.h>

/* Between the surface and the roll, over the surface's size. */
static const double aside = 0.15;

/* Surfaces that are cut, before the flat ones: one, or as many as there are beside the pieces. */
static int cut_count(const taut_model *model)
{
    const taut_record *pieces = taut_record_get(taut_model_details(model), "pieces");
    const int count = taut_model_surface_count(model) - (int)taut_record_count(pieces);
    return count > 1 ? count : 1;
}

/* Where pieces go: (corner[0] + x) right + (corner[1] + y) up, from where their row of the roll begins, so far down. */
typedef struct layout {
    const taut_model *model;
    double right[3], up[3], corner[3];
    double size[2];       /* of the surfaces, to the right and up */
    size_t count;         /* of places on the roll */
    double (*extents)[2]; /* from where to where each piece is along the roll */
    double row, down;     /* how long a row may be, and how far one is below the other */
} layout;

/* Below the box of the surfaces where the upper left corner of the roll goes, as deep as the least of the box; on the ground, at its foot. */
static void find_corner(layout *to)
{
    double low[3] = {INFINITY, INFINITY, INFINITY}, high[3] = {-INFINITY, -INFINITY, -INFINITY};
    double deep[3], axes[3][3];
    taut_cross(to->right, to->up, deep);
    memcpy(axes[0], to->right, sizeof axes[0]);
    memcpy(axes[1], to->up, sizeof axes[1]);
    memcpy(axes[2], deep, sizeof axes[2]);
    for (int i = 0; i < cut_count(to->model); i++) {
        const taut_surface *surface = taut_model_surface(to->model, i);
        const int count =
            taut_basis_count(taut_surface_u(surface)) * taut_basis_count(taut_surface_v(surface));
        for (int k = 0; k < 3 * count; k++) {
            const double at = taut_dot(taut_surface_points(surface) + 3 * (k / 3), axes[k % 3]);
            low[k % 3] = fmin(low[k % 3], at);
            high[k % 3] = fmax(high[k % 3], at);
        }
    }
    to->size[0] = high[0] - low[0];
    to->size[1] = high[1] - low[1];
    to->corner[0] = low[0];
    to->corner[1] = low[1] - aside * fmax(to->size[0], to->size[1]);
    to->corner[2] = low[2];
}

static const taut_record *roll_of(const taut_model *model)
{
    return taut_record_get(taut_model_details(model), "roll");
}

static const taut_record *place_of(const layout *to, size_t k)
{
    return taut_record_at(taut_record_get(roll_of(to->model), "pieces"), k);
}

static double sign_of(const taut_record *place)
{
    return taut_record_get(place, "turned") != NULL ? -1 : 1;
}

/* From where to where piece k is along the roll, by the control points of its outline; nowhere, where the model has none. */
static void find_extent(const layout *to, size_t k, double extent[2])
{
    const taut_record *place = place_of(to, k);
    const char *name = taut_record_text(taut_record_get(place, "name"));
    const double at = taut_record_number(taut_record_at(taut_record_get(place, "at"), 0));
    extent[0] = INFINITY;
    extent[1] = -INFINITY;
    for (int i = 0; i < taut_model_curve_count(to->model); i++) {
        const taut_curve *curve = taut_model_curve(to->model, i);
        const char *dot = strchr(taut_curve_name(curve), '.');
        if (dot == NULL || strcmp(dot, ".cut") != 0 ||
            (size_t)(dot - taut_curve_name(curve)) != strlen(name) ||
            strncmp(taut_curve_name(curve), name, strlen(name)) != 0) {
            continue;
        }
        for (int p = 0; p < taut_basis_count(taut_curve_t(curve)); p++) {
            const double x = at + sign_of(place) * taut_curve_points(curve)[3 * p];
            extent[0] = fmin(extent[0], x);
            extent[1] = fmax(extent[1], x);
        }
    }
}

/* Where the next row begins: at the first piece that ends beyond this one; INFINITY where there is none. */
static double next_row(const layout *to, double start, double row)
{
    double next = INFINITY;
    for (size_t k = 0; k < to->count; k++) {
        if (to->extents[k][0] > start && to->extents[k][1] > start + row) {
            next = fmin(next, to->extents[k][0]);
        }
    }
    return next;
}

static double first_row(const layout *to)
{
    double start = INFINITY;
    for (size_t k = 0; k < to->count; k++) {
        start = fmin(start, to->extents[k][0]);
    }
    return start;
}

/* Such rows that the picture, 4 by 3, is largest. */
static void choose_rows(layout *to)
{
    enum { MOST = 12 };
    const double width = taut_record_number(taut_record_get(roll_of(to->model), "width"));
    double best = INFINITY, length = 0;

    to->down = (1 + aside) * width;
    for (size_t k = 0; k < to->count; k++) {
        length = fmax(length, to->extents[k][1] - first_row(to));
    }
    for (int parts = 1; parts <= MOST; parts++) {
        int rows = 0;
        double wide = to->size[0];
        for (double start = first_row(to); isfinite(start); rows++) {
            const double next = next_row(to, start, length / parts);
            for (size_t k = 0; k < to->count; k++) {
                const int is_here = to->extents[k][0] >= start && to->extents[k][0] < next;
                wide = is_here ? fmax(wide, to->extents[k][1] - start) : wide;
            }
            start = next;
        }
        const double size = fmax(wide / 4, (to->size[1] + rows * to->down) / 3);
        if (size < best) {
            best = size;
            to->row = length / parts;
        }
    }
}

/* 0 without memory. */
static int lay_out(const taut_model *model, const double plane[2][3], layout *to)
{
    static const double ground[2][3] = {{1, 0, 0}, {0, 1, 0}};
    const double(*axes)[3] = plane != NULL ? plane : ground;

    *to = (layout){.model = model, .row = INFINITY};
    memcpy(to->right, axes[0], sizeof to->right);
    memcpy(to->up, axes[1], sizeof to->up);
    find_corner(to);
    to->count = taut_record_count(taut_record_get(roll_of(model), "pieces"));
    to->extents = taut_alloc(to->count, sizeof *to->extents);
    for (size_t k = 0; to->extents != NULL && k < to->count; k++) {
        find_extent(to, k, to->extents[k]);
    }
    if (to->extents != NULL && plane != NULL) {
        choose_rows(to);
    }
    return to->extents != NULL;
}

/* How a piece lies: x and y times `sign` (-1: it is turned by half a turn), and moved. */
typedef struct pose {
    double sign, at[2];
} pose;

/* 0 where the roll does not have the piece. */
static int find_pose(const layout *to, const char *piece, size_t length, pose *found)
{
    const double width = taut_record_number(taut_record_get(roll_of(to->model), "width"));
    for (size_t k = 0; k < to->count; k++) {
        const taut_record *place = place_of(to, k), *at = taut_record_get(place, "at");
        const char *name = taut_record_text(taut_record_get(place, "name"));
        if (strlen(name) != length || strncmp(name, piece, length) != 0) {
            continue;
        }
        double begin = 0;
        int rows = 0;
        for (double start = first_row(to); isfinite(to->row) && start <= to->extents[k][0];
             start = next_row(to, start, to->row)) {
            begin = start;
            rows++;
        }
        found->sign = sign_of(place);
        found->at[0] = to->corner[0] + taut_record_number(taut_record_at(at, 0)) - begin;
        found->at[1] = to->corner[1] - width + taut_record_number(taut_record_at(at, 1)) -
                       fmax(rows - 1, 0) * to->down;
        return isfinite(found->at[0] + found->at[1]);
    }
    return 0;
}

/* Points of a piece where it lies; as they are where `how` is NULL. */
static double *posed(const layout *to, const double *points, int count, const pose *how)
{
    double *own = taut_alloc((size_t)count, 3 * sizeof(double)), deep[3];
    taut_cross(to->right, to->up, deep);
    for (int k = 0; own != NULL && k < count; k++) {
        const double *p = points + 3 * k;
        for (int c = 0; c < 3; c++) {
            own[3 * k + c] = how == NULL ? p[c]
                                         : (how->at[0] + how->sign * p[0]) * to->right[c] +
                                               (how->at[1] + how->sign * p[1]) * to->up[c] +
                                               (to->corner[2] + p[2]) * deep[c];
        }
    }
    return own;
}

static taut_status add_surface(const layout *to, int i, taut_model *made_of)
{
    const taut_surface *from = taut_model_surface(to->model, i);
    const char *name = taut_surface_name(from);
    const int count =
        taut_basis_count(taut_surface_u(from)) * taut_basis_count(taut_surface_v(from));
    taut_surface *made = NULL;
    pose how;

    const int is_piece = i >= cut_count(to->model) && find_pose(to, name, strlen(name), &how);
    double *points = posed(to, taut_surface_points(from), count, is_piece ? &how : NULL);
    taut_status status = points != NULL
                             ? taut_surface_new(name, taut_surface_u(from), taut_surface_v(from),
                                                points, taut_surface_weights(from), &made, NULL)
                             : TAUT_NO_MEMORY;
    taut_free(points);
    if (status == TAUT_OK) {
        status = taut_model_add_surface(made_of, made);
        if (status != TAUT_OK) {
            taut_surface_free(made);
        }
    }
    return status;
}

static taut_status add_curve(const layout *to, int i, taut_model *made_of)
{
    const taut_curve *from = taut_model_curve(to->model, i);
    const char *name = taut_curve_name(from), *dot = strchr(name, '.');
    taut_curve *made = NULL;
    pose how;

    const int is_piece = dot != NULL && find_pose(to, name, (size_t)(dot - name), &how);
    if (is_piece && strcmp(dot, ".cut") != 0) {
        return TAUT_OK;
    }
    double *points = posed(to, taut_curve_points(from), taut_basis_count(taut_curve_t(from)),
                           is_piece ? &how : NULL);
    taut_status status = points != NULL ? taut_curve_new(name, taut_curve_t(from), points,
                                                         taut_curve_weights(from), &made, NULL)
                                        : TAUT_NO_MEMORY;
    taut_free(points);
    if (status == TAUT_OK) {
        status = taut_model_add_curve(made_of, made);
        if (status != TAUT_OK) {
            taut_curve_free(made);
        }
    }
    return status;
}

static taut_status copy_told(const taut_model *model, taut_model *to)
{
    taut_record *details = taut_record_copy(taut_model_details(model));
    taut_certificate *certificate = NULL;
    if (details == NULL) {
        return TAUT_NO_MEMORY;
    }
    taut_model_set_details(to, details);
    if (taut_model_certificate(model) != NULL) {
        if (taut_certificate_copy(taut_model_certificate(model), &certificate) != TAUT_OK) {
            return TAUT_NO_MEMORY;
        }
        taut_model_set_certificate(to, certificate);
    }
    return taut_model_set_unit(to, taut_model_unit(model));
}

taut_status taut_flat_spread(const taut_model *model, const double plane[2][3], taut_model **spread)
{
    taut_model *made = NULL;
    layout to;

    *spread = NULL;
    if (!taut_flat_is_cloth(model) || taut_model_surface_count(model) == 0) {
        return TAUT_OK;
    }
    if (!lay_out(model, plane, &to)) {
        return TAUT_NO_MEMORY;
    }
    taut_status status = taut_model_new(&made);
    for (int i = 0; status == TAUT_OK && i < taut_model_surface_count(model); i++) {
        status = add_surface(&to, i, made);
    }
    for (int i = 0; status == TAUT_OK && i < taut_model_curve_count(model); i++) {
        status = add_curve(&to, i, made);
    }
    if (status == TAUT_OK) {
        status = copy_told(model, made);
    }
    taut_free(to.extents);
    if (status != TAUT_OK) {
        taut_model_free(made);
        return status;
    }
    *spread = made;
    return TAUT_OK;
}
