/* model.c -- taut/operations.h for whole models: what is named is worked on, the rest copied.
 */
#include "taut/operations.h"

#include "core/fail.h"
#include "geometry/lattice.h"
#include "geometry/operate/change.h"
#include "geometry/operate/model.h"
#include "geometry/operate/points.h"

#include <string.h>

/* The objects of a model, surfaces first. */
static int object_count(const taut_model *model)
{
    return taut_model_surface_count(model) + taut_model_curve_count(model);
}

static const char *object_name(const taut_model *model, int i)
{
    const int surfaces = taut_model_surface_count(model);
    return i < surfaces ? taut_surface_name(taut_model_surface(model, i))
                        : taut_curve_name(taut_model_curve(model, i - surfaces));
}

static int has_name(const taut_model *model, const char *name, int but)
{
    for (int i = 0; i < object_count(model); i++) {
        if (i != but && strcmp(object_name(model, i), name) == 0) {
            return 1;
        }
    }
    return 0;
}

int taut_operate_dashes(const taut_model *from, int i, int pieces, const taut_model *so_far)
{
    int dashes = 1;
    for (int n = 0; n < pieces && dashes < 32; n++) {
        char name[TAUT_NAME_MAX + 1];
        taut_operate_piece_name(object_name(from, i), dashes, n, name);
        if (has_name(from, name, i) || has_name(so_far, name, -1)) {
            dashes++;
            n = -1; /* begin again */
        }
    }
    return dashes;
}

taut_status taut_operate_copy_surface(const taut_surface *surface, taut_model *to,
                                      taut_error *error)
{
    taut_surface *copy = NULL;
    if (taut_surface_copy(surface, &copy) != TAUT_OK) {
        return taut_fail_memory(error);
    }
    return taut_operate_add_surface(to, copy, error);
}

taut_status taut_operate_copy_curve(const taut_curve *curve, taut_model *to, taut_error *error)
{
    taut_curve *copy = NULL;
    if (taut_curve_copy(curve, &copy) != TAUT_OK) {
        return taut_fail_memory(error);
    }
    return taut_operate_add_curve(to, copy, error);
}

static taut_status split_surface(const taut_model *model, int i, int direction, double t,
                                 taut_model *to, taut_error *error)
{
    const taut_surface *surface = taut_model_surface(model, i);
    taut_change_list list = {0, NULL};
    taut_status status =
        taut_operate_split(taut_surface_along(surface, direction), t, &list, error);
    const int dashes = taut_operate_dashes(model, i, list.count, to);

    for (int n = 0; status == TAUT_OK && n < list.count; n++) {
        char name[TAUT_NAME_MAX + 1];
        taut_surface *piece = NULL;
        taut_operate_piece_name(taut_surface_name(surface), dashes, n, name);
        status = taut_surface_changed(surface, direction, list.items[n], name, &piece, error);
        if (status == TAUT_OK) {
            status = taut_operate_add_surface(to, piece, error);
        }
    }
    taut_change_list_free(&list);
    return taut_operate_placed(status, "surfaces", i, error);
}

static taut_status split_curve(const taut_model *model, int i, double t, taut_model *to,
                               taut_error *error)
{
    const taut_curve *curve = taut_model_curve(model, i);
    taut_change_list list = {0, NULL};
    taut_status status = taut_operate_split(taut_curve_t(curve), t, &list, error);
    const int dashes =
        taut_operate_dashes(model, taut_model_surface_count(model) + i, list.count, to);

    for (int n = 0; status == TAUT_OK && n < list.count; n++) {
        char name[TAUT_NAME_MAX + 1];
        taut_curve *piece = NULL;
        taut_operate_piece_name(taut_curve_name(curve), dashes, n, name);
        status = taut_curve_changed(curve, list.items[n], name, &piece, error);
        if (status == TAUT_OK) {
            status = taut_operate_add_curve(to, piece, error);
        }
    }
    taut_change_list_free(&list);
    return taut_operate_placed(status, "curves", i, error);
}

taut_status taut_operate_named(const taut_model *model, const char *name, taut_error *error)
{
    if (name != NULL && !has_name(model, name, -1)) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, "argument", NULL, taut_none, taut_none,
                         "nothing in the model has the name \"%.80s\"", name);
    }
    if (object_count(model) == 0) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, "argument", NULL, taut_none, taut_none,
                         "the model holds no surface and no curve");
    }
    return TAUT_OK;
}

static int is_inside(const taut_basis *basis, double t)
{
    return t > taut_basis_lo(basis) && t < taut_basis_hi(basis);
}

/* Is this curve to be cut: by name; alone; or along with surfaces cut across u. */
static int curve_is_cut(const taut_model *model, const taut_curve *curve, const char *name,
                        int direction, double t)
{
    if (name != NULL) {
        return strcmp(taut_curve_name(curve), name) == 0;
    }
    return taut_model_surface_count(model) == 0 ||
           (direction == TAUT_ALONG_U && is_inside(taut_curve_t(curve), t));
}

taut_status taut_model_split(const taut_model *model, const char *name, int direction, double t,
                             taut_model **split, taut_error *error)
{
    taut_model *made = NULL;
    taut_status status = TAUT_OK;

    if (model == NULL || split == NULL ||
        (direction != TAUT_ALONG_U && direction != TAUT_ALONG_V)) {
        return taut_operate_null(error);
    }
    status = taut_operate_named(model, name, error);
    if (status == TAUT_OK) {
        status = taut_operate_begin(model, &made, error);
    }
    for (int i = 0; status == TAUT_OK && i < taut_model_surface_count(model); i++) {
        const taut_surface *surface = taut_model_surface(model, i);
        const int cut = name == NULL || strcmp(taut_surface_name(surface), name) == 0;
        status = cut ? split_surface(model, i, direction, t, made, error)
                     : taut_operate_copy_surface(surface, made, error);
    }
    for (int i = 0; status == TAUT_OK && i < taut_model_curve_count(model); i++) {
        const taut_curve *curve = taut_model_curve(model, i);
        const int cut = curve_is_cut(model, curve, name, direction, t);
        status = cut ? split_curve(model, i, t, made, error)
                     : taut_operate_copy_curve(curve, made, error);
    }
    return taut_operate_end(status, made, split);
}

static taut_status refine_surface(const taut_surface *surface, int along_u, int along_v,
                                  taut_model *to, taut_error *error)
{
    const int wanted[2] = {along_u || !along_v, along_v || !along_u};
    taut_surface *now = NULL;
    taut_status status = TAUT_OK;

    for (int d = 0; status == TAUT_OK && d < 2; d++) {
        taut_surface *next = NULL;
        if (wanted[d]) {
            status = taut_surface_refine(now != NULL ? now : surface, d, &next, error);
        }
        if (next != NULL) {
            taut_surface_free(now);
            now = next;
        }
    }
    if (status != TAUT_OK) {
        taut_surface_free(now);
        return status;
    }
    return taut_operate_add_surface(to, now, error);
}

static taut_status refine_curve(const taut_curve *curve, taut_model *to, taut_error *error)
{
    taut_curve *refined = NULL;
    const taut_status status = taut_curve_refine(curve, &refined, error);
    return status == TAUT_OK ? taut_operate_add_curve(to, refined, error) : status;
}

taut_status taut_model_refine(const taut_model *model, const char *name, int along_u, int along_v,
                              taut_model **refined, taut_error *error)
{
    taut_model *made = NULL;
    taut_status status = TAUT_OK;

    if (model == NULL || refined == NULL) {
        return taut_operate_null(error);
    }
    status = taut_operate_named(model, name, error);
    if (status == TAUT_OK) {
        status = taut_operate_begin(model, &made, error);
    }
    for (int i = 0; status == TAUT_OK && i < taut_model_surface_count(model); i++) {
        const taut_surface *surface = taut_model_surface(model, i);
        const int asked = name == NULL || strcmp(taut_surface_name(surface), name) == 0;
        status = asked ? refine_surface(surface, along_u, along_v, made, error)
                       : taut_operate_copy_surface(surface, made, error);
        status = taut_operate_placed(status, "surfaces", i, error);
    }
    for (int i = 0; status == TAUT_OK && i < taut_model_curve_count(model); i++) {
        const taut_curve *curve = taut_model_curve(model, i);
        const int asked = name != NULL ? strcmp(taut_curve_name(curve), name) == 0
                                       : taut_model_surface_count(model) == 0;
        status =
            asked ? refine_curve(curve, made, error) : taut_operate_copy_curve(curve, made, error);
        status = taut_operate_placed(status, "curves", i, error);
    }
    return taut_operate_end(status, made, refined);
}
