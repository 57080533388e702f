/* model_pieces.c -- every span of every surface and curve of a model on its own. */
#include "taut/operations.h"

#include "geometry/operate/change.h"
#include "geometry/operate/model.h"
#include "geometry/operate/points.h"

#include <string.h>

static taut_status surface_pieces(const taut_model *model, int i, taut_model *to, taut_error *error)
{
    const taut_surface *surface = taut_model_surface(model, i);
    taut_model *pieces = NULL;
    taut_status status = taut_surface_pieces(surface, &pieces, error);
    const int count = status == TAUT_OK ? taut_model_surface_count(pieces) : 0;
    const int dashes = taut_operate_dashes(model, i, count, to);

    for (int n = 0; status == TAUT_OK && n < count; n++) {
        const taut_surface *piece = taut_model_surface(pieces, n);
        char name[TAUT_NAME_MAX + 1];
        taut_surface *named = NULL;
        taut_operate_piece_name(taut_surface_name(surface), dashes, n, name);
        status = taut_surface_new(name, taut_surface_u(piece), taut_surface_v(piece),
                                  taut_surface_points(piece), taut_surface_weights(piece), &named,
                                  error);
        if (status == TAUT_OK) {
            status = taut_operate_add_surface(to, named, error);
        }
    }
    taut_model_free(pieces);
    return taut_operate_placed(status, "surfaces", i, error);
}

static taut_status curve_pieces(const taut_model *model, int i, taut_model *to, taut_error *error)
{
    const taut_curve *curve = taut_model_curve(model, i);
    taut_model *pieces = NULL;
    taut_status status = taut_curve_pieces(curve, &pieces, error);
    const int count = status == TAUT_OK ? taut_model_curve_count(pieces) : 0;
    const int dashes = taut_operate_dashes(model, taut_model_surface_count(model) + i, count, to);

    for (int n = 0; status == TAUT_OK && n < count; n++) {
        const taut_curve *piece = taut_model_curve(pieces, n);
        char name[TAUT_NAME_MAX + 1];
        taut_curve *named = NULL;
        taut_operate_piece_name(taut_curve_name(curve), dashes, n, name);
        status = taut_curve_new(name, taut_curve_t(piece), taut_curve_points(piece),
                                taut_curve_weights(piece), &named, error);
        if (status == TAUT_OK) {
            status = taut_operate_add_curve(to, named, error);
        }
    }
    taut_model_free(pieces);
    return taut_operate_placed(status, "curves", i, error);
}

taut_status taut_model_pieces(const taut_model *model, const char *name, taut_model **pieces,
                              taut_error *error)
{
    taut_model *made = NULL;
    taut_status status = TAUT_OK;

    if (model == NULL || pieces == NULL) {
        return taut_operate_null(error);
    }
    status = taut_operate_named(model, name, error);
    if (status == TAUT_OK) {
        status = taut_operate_begin(model, &made, error);
    }
    for (int i = 0; status == TAUT_OK && i < taut_model_surface_count(model); i++) {
        const taut_surface *surface = taut_model_surface(model, i);
        const int asked = name == NULL || strcmp(taut_surface_name(surface), name) == 0;
        status = asked ? surface_pieces(model, i, made, error)
                       : taut_operate_copy_surface(surface, made, error);
    }
    for (int i = 0; status == TAUT_OK && i < taut_model_curve_count(model); i++) {
        const taut_curve *curve = taut_model_curve(model, i);
        const int asked = name == NULL || strcmp(taut_curve_name(curve), name) == 0;
        status = asked ? curve_pieces(model, i, made, error)
                       : taut_operate_copy_curve(curve, made, error);
    }
    return taut_operate_end(status, made, pieces);
}
