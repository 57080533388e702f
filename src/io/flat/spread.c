#include "io/flat/spread.h"

#include "core/memory.h"
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

/* Below the box of the surfaces, in y, and at its foot: where the upper left corner of the roll goes. */
static void corner_of(const taut_model *model, double corner[3])
{
    double low[3] = {INFINITY, INFINITY, INFINITY}, high[3] = {-INFINITY, -INFINITY, -INFINITY};
    for (int i = 0; i < cut_count(model); i++) {
        const taut_surface *surface = taut_model_surface(model, i);
        const int count =
            taut_basis_count(taut_surface_u(surface)) * taut_basis_count(taut_surface_v(surface));
        for (int k = 0; k < 3 * count; k++) {
            low[k % 3] = fmin(low[k % 3], taut_surface_points(surface)[k]);
            high[k % 3] = fmax(high[k % 3], taut_surface_points(surface)[k]);
        }
    }
    corner[0] = low[0];
    corner[1] = low[1] - aside * fmax(high[0] - low[0], high[1] - low[1]);
    corner[2] = low[2];
}

/* How far a piece is moved, once x and y are times *sign (-1: it is turned by half a turn); 0 where the roll does not have it. */
static int shift_of(const taut_model *model, const double corner[3], const char *piece,
                    size_t length, double shift[3], double *sign)
{
    const taut_record *roll = taut_record_get(taut_model_details(model), "roll");
    const taut_record *places = taut_record_get(roll, "pieces");
    for (size_t k = 0; k < taut_record_count(places); k++) {
        const taut_record *place = taut_record_at(places, k), *at = taut_record_get(place, "at");
        const char *name = taut_record_text(taut_record_get(place, "name"));
        if (strlen(name) == length && strncmp(name, piece, length) == 0) {
            const double width = taut_record_number(taut_record_get(roll, "width"));
            shift[0] = corner[0] + taut_record_number(taut_record_at(at, 0));
            shift[1] = corner[1] - width + taut_record_number(taut_record_at(at, 1));
            shift[2] = corner[2];
            *sign = taut_record_get(place, "turned") != NULL ? -1 : 1;
            return isfinite(shift[0] + shift[1]);
        }
    }
    return 0;
}

static double *moved(const double *points, int count, const double shift[3], double sign)
{
    double *own = taut_alloc((size_t)count, 3 * sizeof(double));
    for (int k = 0; own != NULL && k < 3 * count; k++) {
        own[k] = (k % 3 < 2 ? sign : 1) * points[k] + shift[k % 3];
    }
    return own;
}

static taut_status add_surface(const taut_model *model, int i, const double corner[3],
                               taut_model *to)
{
    const taut_surface *from = taut_model_surface(model, i);
    const int count =
        taut_basis_count(taut_surface_u(from)) * taut_basis_count(taut_surface_v(from));
    double shift[3] = {0, 0, 0}, sign = 1;
    taut_surface *made = NULL;

    if (i >= cut_count(model)) {
        const char *name = taut_surface_name(from);
        shift_of(model, corner, name, strlen(name), shift, &sign);
    }
    double *points = moved(taut_surface_points(from), count, shift, sign);
    taut_status status =
        points != NULL
            ? taut_surface_new(taut_surface_name(from), taut_surface_u(from), taut_surface_v(from),
                               points, taut_surface_weights(from), &made, NULL)
            : TAUT_NO_MEMORY;
    taut_free(points);
    if (status == TAUT_OK) {
        status = taut_model_add_surface(to, made);
        if (status != TAUT_OK) {
            taut_surface_free(made);
        }
    }
    return status;
}

static taut_status add_curve(const taut_model *model, int i, const double corner[3], taut_model *to)
{
    const taut_curve *from = taut_model_curve(model, i);
    const char *name = taut_curve_name(from), *dot = strchr(name, '.');
    double shift[3] = {0, 0, 0}, sign = 1;
    taut_curve *made = NULL;

    if (dot != NULL && shift_of(model, corner, name, (size_t)(dot - name), shift, &sign) &&
        strcmp(dot, ".cut") != 0) {
        return TAUT_OK;
    }
    double *points =
        moved(taut_curve_points(from), taut_basis_count(taut_curve_t(from)), shift, sign);
    taut_status status = points != NULL ? taut_curve_new(name, taut_curve_t(from), points,
                                                         taut_curve_weights(from), &made, NULL)
                                        : TAUT_NO_MEMORY;
    taut_free(points);
    if (status == TAUT_OK) {
        status = taut_model_add_curve(to, made);
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

taut_status taut_flat_spread(const taut_model *model, taut_model **spread)
{
    taut_model *made = NULL;
    double corner[3];

    *spread = NULL;
    if (!taut_flat_is_cloth(model) || taut_model_surface_count(model) == 0) {
        return TAUT_OK;
    }
    corner_of(model, corner);
    taut_status status = taut_model_new(&made);
    for (int i = 0; status == TAUT_OK && i < taut_model_surface_count(model); i++) {
        status = add_surface(model, i, corner, made);
    }
    for (int i = 0; status == TAUT_OK && i < taut_model_curve_count(model); i++) {
        status = add_curve(model, i, corner, made);
    }
    if (status == TAUT_OK) {
        status = copy_told(model, made);
    }
    if (status != TAUT_OK) {
        taut_model_free(made);
        return status;
    }
    *spread = made;
    return TAUT_OK;
}
