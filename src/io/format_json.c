/* format_json.c -- the format `json`: the model itself. */
#include "core/fail.h"
#include "io/format.h"
#include "io/model/model.h"
#include "io/model/surface.h"

/* The lists of surfaces and curves. One surface that was asked for goes alone: what was decided and
 * proved is about the whole model. */
static void write_members(taut_json_out *out, const taut_model *model,
                          const taut_write_options *options)
{
    const int all = options->surface == NULL;
    taut_json_open_pair(out, "surfaces", '[');
    for (int i = 0; i < taut_model_surface_count(model); i++) {
        if (all || taut_format_wants(model, options, i)) {
            taut_surface_document_write(out, taut_model_surface(model, i));
        }
    }
    taut_json_close(out, ']');
    if (all && taut_model_curve_count(model) > 0) {
        taut_json_open_pair(out, "curves", '[');
        for (int i = 0; i < taut_model_curve_count(model); i++) {
            taut_curve_document_write(out, taut_model_curve(model, i));
        }
        taut_json_close(out, ']');
    }
    if (all && taut_model_details(model) != NULL) {
        taut_json_pair_record(out, "details", taut_model_details(model));
    }
    if (all && taut_model_certificate(model) != NULL) {
        taut_json_key(out, "certificate");
        taut_certificate_document_write(out, taut_model_certificate(model));
    }
}

static void write_model(taut_json_out *out, const taut_model *model,
                        const taut_write_options *options)
{
    taut_json_open(out, '{');
    taut_json_pair_number(out, "taut", 1);
    taut_json_pair_text(out, "unit", taut_model_unit(model));
    write_members(out, model, options);
    taut_json_close(out, '}');
}

static taut_status finish(taut_json_out *out, taut_error *error)
{
    const taut_status status = taut_json_out_finish(out);
    return status == TAUT_NO_MEMORY ? taut_fail_memory(error) : status;
}

static taut_status write_json(const taut_model *model, const taut_write_options *options, FILE *out,
                              taut_error *error)
{
    taut_json_out json = taut_json_out_to(out);
    taut_sink_watch(&json.sink, &options->monitor);
    json.short_knots = options->short_knots;
    json.threads = options->threads;
    write_model(&json, model, options);
    return finish(&json, error);
}

static taut_status write_list(int count, const taut_model *const *models,
                              const taut_write_options *options, FILE *out, taut_error *error)
{
    taut_json_out json = taut_json_out_to(out);
    taut_sink_watch(&json.sink, &options->monitor);
    json.short_knots = options->short_knots;
    json.threads = options->threads;
    taut_json_open(&json, '[');
    for (int i = 0; i < count; i++) {
        write_model(&json, models[i], options);
    }
    taut_json_close(&json, ']');
    return finish(&json, error);
}

const taut_format_ops taut_format_json = {
    .write = write_json, .write_many = write_list, .models_max = TAUT_OBJECTS_MAX};
