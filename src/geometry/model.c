/* model.c -- the container of what came out. */
#include "taut/model.h"

#include "core/memory.h"

#include <string.h>

struct taut_model {
    char unit[4];
    taut_surface **surfaces;
    taut_curve **curves;
    int surface_count, curve_count;
    taut_record *details;
    taut_certificate *certificate;
};

taut_status taut_model_new(taut_model **model)
{
    taut_model *made = NULL;
    if (model == NULL) {
        return TAUT_BAD_ARGUMENT;
    }
    made = taut_alloc_zero(1, sizeof *made);
    if (made == NULL) {
        return TAUT_NO_MEMORY;
    }
    memcpy(made->unit, "mm", 3);
    *model = made;
    return TAUT_OK;
}

void taut_model_free(taut_model *model)
{
    if (model == NULL) {
        return;
    }
    for (int i = 0; i < model->surface_count; i++) {
        taut_surface_free(model->surfaces[i]);
    }
    for (int i = 0; i < model->curve_count; i++) {
        taut_curve_free(model->curves[i]);
    }
    taut_free(model->surfaces);
    taut_free(model->curves);
    taut_record_free(model->details);
    taut_certificate_free(model->certificate);
    taut_free(model);
}

/* An array with room for count + 1, doubling at powers of two; NULL when memory runs out. */
static void *with_room(void *array, int count, size_t size)
{
    if (count > 0 && (count & (count - 1)) != 0) {
        return array;
    }
    return taut_realloc(array, count > 0 ? 2 * (size_t)count : 1, size);
}

taut_status taut_model_add_surface(taut_model *model, taut_surface *surface)
{
    taut_surface **surfaces = NULL;
    if (model == NULL || surface == NULL || model->surface_count >= TAUT_OBJECTS_MAX) {
        return TAUT_BAD_ARGUMENT;
    }
    surfaces = with_room(model->surfaces, model->surface_count, sizeof(taut_surface *));
    if (surfaces == NULL) {
        return TAUT_NO_MEMORY;
    }
    model->surfaces = surfaces;
    model->surfaces[model->surface_count++] = surface;
    return TAUT_OK;
}

taut_status taut_model_add_curve(taut_model *model, taut_curve *curve)
{
    taut_curve **curves = NULL;
    if (model == NULL || curve == NULL || model->curve_count >= TAUT_OBJECTS_MAX) {
        return TAUT_BAD_ARGUMENT;
    }
    curves = with_room(model->curves, model->curve_count, sizeof(taut_curve *));
    if (curves == NULL) {
        return TAUT_NO_MEMORY;
    }
    model->curves = curves;
    model->curves[model->curve_count++] = curve;
    return TAUT_OK;
}

static taut_status copy_objects(const taut_model *model, taut_model *made)
{
    for (int i = 0; i < model->surface_count; i++) {
        taut_surface *surface = NULL;
        if (taut_surface_copy(model->surfaces[i], &surface) != TAUT_OK ||
            taut_model_add_surface(made, surface) != TAUT_OK) {
            taut_surface_free(surface);
            return TAUT_NO_MEMORY;
        }
    }
    for (int i = 0; i < model->curve_count; i++) {
        taut_curve *curve = NULL;
        if (taut_curve_copy(model->curves[i], &curve) != TAUT_OK ||
            taut_model_add_curve(made, curve) != TAUT_OK) {
            taut_curve_free(curve);
            return TAUT_NO_MEMORY;
        }
    }
    return TAUT_OK;
}

static taut_status copy_notes(const taut_model *model, taut_model *made)
{
    if (model->details != NULL) {
        made->details = taut_record_copy(model->details);
        if (made->details == NULL) {
            return TAUT_NO_MEMORY;
        }
    }
    return model->certificate != NULL
               ? taut_certificate_copy(model->certificate, &made->certificate)
               : TAUT_OK;
}

taut_status taut_model_copy(const taut_model *model, taut_model **copy)
{
    taut_model *made = NULL;
    if (model == NULL || copy == NULL) {
        return TAUT_BAD_ARGUMENT;
    }
    if (taut_model_new(&made) != TAUT_OK || copy_objects(model, made) != TAUT_OK ||
        copy_notes(model, made) != TAUT_OK) {
        taut_model_free(made);
        return TAUT_NO_MEMORY;
    }
    memcpy(made->unit, model->unit, sizeof made->unit);
    *copy = made;
    return TAUT_OK;
}

void taut_model_set_details(taut_model *model, taut_record *details)
{
    if (model->details != details) {
        taut_record_free(model->details);
    }
    model->details = details;
}

void taut_model_set_certificate(taut_model *model, taut_certificate *certificate)
{
    if (model->certificate != certificate) {
        taut_certificate_free(model->certificate);
    }
    model->certificate = certificate;
}

taut_status taut_model_set_unit(taut_model *model, const char *unit)
{
    static const char *const units[] = {"mm", "m", "cm", "in", "ft"};
    if (model == NULL || unit == NULL) {
        return TAUT_BAD_ARGUMENT;
    }
    for (int i = 0; i < 5; i++) {
        if (strcmp(unit, units[i]) == 0) {
            memcpy(model->unit, units[i], strlen(units[i]) + 1);
            return TAUT_OK;
        }
    }
    return TAUT_BAD_INPUT;
}

int taut_model_surface_count(const taut_model *model)
{
    return model->surface_count;
}

const taut_surface *taut_model_surface(const taut_model *model, int i)
{
    return i >= 0 && i < model->surface_count ? model->surfaces[i] : NULL;
}

int taut_model_curve_count(const taut_model *model)
{
    return model->curve_count;
}

const taut_curve *taut_model_curve(const taut_model *model, int i)
{
    return i >= 0 && i < model->curve_count ? model->curves[i] : NULL;
}

const taut_record *taut_model_details(const taut_model *model)
{
    return model->details;
}

const taut_certificate *taut_model_certificate(const taut_model *model)
{
    return model->certificate;
}

const char *taut_model_unit(const taut_model *model)
{
    return model->unit;
}
