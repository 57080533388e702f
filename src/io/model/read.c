/* read.c -- models from documents. */
#include "taut/read.h"
#include "core/fail.h"
#include "io/format.h"
#include "io/geomdl/geomdl.h"
#include "io/model/model.h"
#include "io/model/surface.h"
#include "taut/limits.h"

#include <string.h>

static const char *const model_members[] = {"taut",    "unit",        "surfaces", "curves",
                                            "details", "certificate", NULL};

taut_status taut_version_document_check(const taut_json *document, taut_error *error)
{
    const taut_json at = taut_json_member(document, "taut");
    const int is_number = taut_json_kind_at(&at) == TAUT_JSON_NUMBER;
    if (!is_number || taut_json_number_at(&at) != 1) {
        return taut_json_refuse(&at, error, is_number ? "version" : "type",
                                "1, the version of the format");
    }
    return TAUT_OK;
}

taut_status taut_unit_document_read(const taut_json *document, const char **unit, taut_error *error)
{
    static const char *const units[] = {"mm", "m", "cm", "in", "ft", NULL};
    const taut_json at = taut_json_member(document, "unit");
    int word = 0;
    const taut_status status =
        at.value != NULL ? taut_json_word(&at, units, &word, error) : TAUT_OK;
    *unit = units[word];
    return status;
}

/* Ownership goes to the model, or is given up with the object. */
static taut_status add_surface(const taut_json *at, void *model, taut_error *error)
{
    taut_surface *surface = NULL;
    const taut_status status = taut_surface_document_read(at, &surface, error);
    if (status == TAUT_OK && taut_model_add_surface(model, surface) != TAUT_OK) {
        taut_surface_free(surface);
        return taut_fail_memory(error);
    }
    return status;
}

static taut_status add_curve(const taut_json *at, void *model, taut_error *error)
{
    taut_curve *curve = NULL;
    const taut_status status = taut_curve_document_read(at, &curve, error);
    if (status == TAUT_OK && taut_model_add_curve(model, curve) != TAUT_OK) {
        taut_curve_free(curve);
        return taut_fail_memory(error);
    }
    return status;
}

static taut_status add_surfaces(const taut_json *at, void *model, taut_error *error)
{
    return taut_json_each(at, 0, TAUT_OBJECTS_MAX, "surfaces", add_surface, model, error);
}

static taut_status add_curves(const taut_json *at, void *model, taut_error *error)
{
    return taut_json_each(at, 0, TAUT_OBJECTS_MAX, "curves", add_curve, model, error);
}

static taut_status add_details(const taut_json *at, void *model, taut_error *error)
{
    taut_record *details = NULL;
    const taut_status status = taut_json_record_object(at, &details, error);
    if (status == TAUT_OK) {
        taut_model_set_details(model, details);
    }
    return status;
}

static taut_status add_certificate(const taut_json *at, void *model, taut_error *error)
{
    taut_certificate *certificate = NULL;
    const taut_status status = taut_certificate_document_read(at, &certificate, error);
    if (status == TAUT_OK) {
        taut_model_set_certificate(model, certificate);
    }
    return status;
}

static taut_status read_members(taut_model *model, const taut_json *document, taut_error *error)
{
    const char *unit = "mm";
    taut_reader in = taut_reader_of(document, NULL, error);

    in.status = taut_unit_document_read(document, &unit, error);
    taut_model_set_unit(model, unit);
    taut_reader_optional(&in, "surfaces", add_surfaces, model);
    taut_reader_optional(&in, "curves", add_curves, model);
    taut_reader_optional(&in, "details", add_details, model);
    taut_reader_optional(&in, "certificate", add_certificate, model);
    return in.status;
}

taut_status taut_model_document_read(const taut_json *document, taut_model **model,
                                     taut_error *error)
{
    taut_model *made = NULL;
    taut_status status = TAUT_OK;

    if (taut_json_find(document->value, "construct") != NULL &&
        taut_json_find(document->value, "surfaces") == NULL) {
        const taut_json at = taut_json_member(document, "construct");
        return taut_json_fail(&at, error, "kind", taut_none, taut_none,
                              "this is a problem, expected a model: `taut make` makes one from it");
    }
    if (taut_geomdl_is(document)) {
        return taut_geomdl_read(document, model, error);
    }
    status = taut_json_object(document, model_members, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = taut_version_document_check(document, error);
    if (status != TAUT_OK) {
        return status;
    }
    if (taut_model_new(&made) != TAUT_OK) {
        return taut_fail_memory(error);
    }
    status = read_members(made, document, error);
    if (status != TAUT_OK) {
        taut_model_free(made);
        return status;
    }
    *model = made;
    return TAUT_OK;
}

taut_pulse taut_read_pulse(const taut_read_options *options)
{
    return (taut_pulse){.monitor = options != NULL ? &options->monitor : NULL,
                        .what = "reading",
                        .done = taut_none};
}

static taut_status read_root(const taut_json *document, void *model, taut_error *error)
{
    return taut_model_document_read(document, model, error);
}

taut_status taut_model_read_text_with(const char *text, size_t length, const char *name,
                                      const taut_read_options *options, taut_model **model,
                                      taut_error *error)
{
    taut_pulse pulse = taut_read_pulse(options);
    if ((text == NULL && length > 0) || model == NULL) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, "argument", NULL, taut_none, taut_none,
                         "taut_model_read_text needs a text and a place for the model");
    }
    return taut_json_read_text(text, length, name != NULL ? name : "text", &pulse, read_root, model,
                               error);
}

taut_status taut_model_read_text(const char *text, size_t length, const char *name,
                                 taut_model **model, taut_error *error)
{
    return taut_model_read_text_with(text, length, name, NULL, model, error);
}

/* What is cut by curves is not to be taken for the whole surface in silence. */
static taut_status refuse_trimmed(const taut_model *model, taut_error *error)
{
    const taut_record *details = taut_model_details(model);
    const double trimmed = taut_record_number(taut_record_get(details, "trimmed"));

    if (!(trimmed > 0)) {
        return TAUT_OK;
    }
    return taut_fail(error, TAUT_NO_SOLUTION, "trimmed", NULL, trimmed, 0,
                     "%.0f of %d faces are trimmed by curves within their surfaces: --untrim reads "
                     "the whole surfaces",
                     trimmed, taut_model_surface_count(model));
}

taut_status taut_model_format_read(const taut_format_ops *ops, const char *path,
                                   const taut_read_options *options, taut_model **model,
                                   taut_error *error)
{
    static const taut_read_options plain = {.untrim = 0};
    const taut_read_options *chosen = options != NULL ? options : &plain;
    taut_model *made = NULL;
    taut_status status = ops->read(path, chosen, &made, error);

    if (status != TAUT_OK) {
        return status;
    }
    status = chosen->untrim ? TAUT_OK : refuse_trimmed(made, error);
    if (status != TAUT_OK) {
        taut_model_free(made);
        return status;
    }
    *model = made;
    return TAUT_OK;
}

taut_status taut_model_read_with(const char *path, const taut_read_options *options,
                                 taut_model **model, taut_error *error)
{
    const taut_format_ops *ops = NULL;
    taut_pulse pulse = taut_read_pulse(options);
    if (path == NULL || model == NULL) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, "argument", NULL, taut_none, taut_none,
                         "taut_model_read needs a path and a place for the model");
    }
    ops = taut_format_ops_at(taut_format_of(path, NULL));
    return ops != NULL && ops->read != NULL
               ? taut_model_format_read(ops, path, options, model, error)
               : taut_json_read_file(path, &pulse, read_root, model, error);
}

taut_status taut_model_read(const char *path, taut_model **model, taut_error *error)
{
    return taut_model_read_with(path, NULL, model, error);
}
