/* bonnet.c -- the problem `bonnet`: minimal surfaces with planar curvature lines
 * (docs/format.md). */
#include "taut/bonnet.h"
#include "core/fail.h"
#include "io/problem/document_ops.h"

static const char *const members[] = {"lambda", "sign",      "alpha", "beta",   "mesh", "segments",
                                      "theta",  "normalize", "start", "frames", NULL};

/* A number, or with "frames" the first and the last. */
static void read_lambda(taut_reader *document, taut_bonnet_problem *data)
{
    const taut_json at = taut_json_member(document->object, "lambda");

    if (taut_reader_has(document, "frames")) {
        taut_reader_integer(document, "frames", 2, TAUT_OBJECTS_MAX, &data->frames);
        taut_reader_numbers(document, "lambda", 2, data->lambda);
    } else if (taut_json_kind_at(&at) == TAUT_JSON_ARRAY) {
        document->status =
            taut_json_fail(&at, document->error, "size", 2, 1,
                           "found two numbers, expected one, or \"frames\": how many surfaces");
    } else {
        taut_reader_number(document, "lambda", &data->lambda[0]);
        data->lambda[1] = data->lambda[0];
    }
}

static taut_status read_count(const taut_json *at, void *count, taut_error *error)
{
    return taut_json_integer(at, 1, TAUT_COUNT_MAX / 2, count, error);
}

static void bonnet_read(taut_reader *document, taut_problem *problem, void *into)
{
    static const char *const signs[] = {"+", "-", NULL};
    static const char *const meshes[] = {"bezier", "bspline", NULL};
    taut_bonnet_problem *const data = into;
    int minus = 0;

    (void)problem;
    read_lambda(document, data);
    taut_reader_word(document, "sign", signs, &minus);
    data->sign = minus ? -1 : 1;
    taut_reader_number(document, "alpha", &data->alpha);
    taut_reader_number(document, "beta", &data->beta);
    taut_reader_optional_word(document, "mesh", meshes, &data->bspline);
    if (taut_reader_has(document, "segments")) {
        taut_reader_items(document, "segments", 2, "numbers", read_count, data->segments,
                          sizeof data->segments[0]);
    }
    taut_reader_optional_number(document, "theta", &data->theta);
    taut_reader_flag(document, "normalize", &data->normalize);
    if (taut_reader_has(document, "start")) {
        taut_reader_numbers(document, "start", 2, data->start);
    }
}

const taut_document_ops taut_document_bonnet = {
    .members = members,
    .size = sizeof(taut_bonnet_problem),
    .read = bonnet_read,
};
