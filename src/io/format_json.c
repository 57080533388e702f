/* format_json.c -- the format `json`: the model itself. */
#include "core/fail.h"
#include "io/format.h"
#include "io/model_document.h"
#include "io/surface_document.h"

/* The lists of surfaces and curves. One surface that was asked for goes alone: what was decided and
 * proved is about the whole model. */
static void write_members(taut_json_out *out, const taut_model *model,
                          const taut_write_options *options)
{
    const int all = options->surface == NULL;
    taut_json_key(out, "surfaces");
    taut_json_open(out, '[');
    for (int i = 0; i < taut_model_surface_count(model); i++) {
        if (taut_format_wants(model, options, i)) {
            taut_surface_document_write(out, taut_model_surface(model, i));
        }
    }
    taut_json_close(out, ']');
    if (all && taut_model_curve_count(model) > 0) {
        taut_json_key(out, "curves");
        taut_json_open(out, '[');
        for (int i = 0; i < taut_model_curve_count(model); i++) {
            taut_curve_document_write(out, taut_model_curve(model, i));
        }
        taut_json_close(out, ']');
    }
    if (all && taut_model_details(model) != NULL) {
        taut_json_key(out, "details");
        taut_json_put_record(out, taut_model_details(model));
    }
    if (all && taut_model_certificate(model) != NULL) {
        taut_json_key(out, "certificate");
        taut_certificate_document_write(out, taut_model_certificate(model));
    }
}

static taut_status write_json(const taut_model *model, const taut_write_options *options, FILE *out,
                              taut_error *error)
{
    taut_json_out json = taut_json_out_to(out);
    taut_status status = TAUT_OK;

    json.short_knots = options->short_knots;
    taut_json_open(&json, '{');
    taut_json_key(&json, "taut");
    taut_json_put_number(&json, 1);
    taut_json_key(&json, "unit");
    taut_json_put_text(&json, taut_model_unit(model));
    write_members(&json, model, options);
    taut_json_close(&json, '}');
    status = taut_json_out_finish(&json);
    return status == TAUT_NO_MEMORY ? taut_fail_memory(error) : status;
}

const taut_format_ops taut_format_json = {.write = write_json};
