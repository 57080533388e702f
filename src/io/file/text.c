/* text.c -- a model in memory, in any format that is written as a stream. */
#include "core/fail.h"
#include "core/memory.h"
#include "io/file/in.h"
#include "io/format.h"
#include "platform/system.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The bytes of a spool as the library's own, ended by a 0. */
static char *own_text(const char *bytes, size_t length)
{
    char *text = taut_alloc(length + 1, 1);
    if (text != NULL) {
        memcpy(text, bytes, length);
        text[length] = '\0';
    }
    return text;
}

static taut_status write_stream(const taut_format_ops *ops, const taut_model *model,
                                const taut_write_options *options, char **bytes, size_t *length,
                                taut_error *error)
{
    FILE *stream = taut_system_spool(bytes, length);
    if (stream == NULL) {
        return taut_fail_memory(error);
    }
    const taut_status status = ops->write(model, options, stream, error);
    const int failed = ferror(stream);
    if ((taut_system_spooled(stream, bytes, length) != 0 || failed) &&
        (status == TAUT_OK || status == TAUT_IO)) {
        return taut_fail_memory(error); /* nothing else ends a stream into memory */
    }
    return status == TAUT_INTERRUPTED ? taut_fail_status(error, status) : status;
}

taut_status taut_model_write_text(const taut_model *model, const char *format,
                                  const taut_write_options *options, char **text, size_t *length,
                                  taut_error *error)
{
    static const taut_write_options none;
    char name[32] = ".", *bytes = NULL;
    size_t count = 0;

    if (model == NULL || format == NULL || text == NULL || length == NULL) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, "argument", NULL, taut_none, taut_none,
                         "a text needs a model, a format and a place to go");
    }
    options = options != NULL ? options : &none;
    strncat(name, format, sizeof name - 2);
    const taut_format_row *row = taut_format_find(options->formats, name, error);
    if (row == NULL) {
        return TAUT_BAD_ARGUMENT;
    }
    const taut_format_ops *ops = row->ops;
    if (ops->write == NULL) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, "not-a-file", NULL, taut_none, taut_none,
                         "the format %.20s can be written to files only", format);
    }
    taut_status status = taut_format_check(model, options, error);
    if (status == TAUT_OK) {
        status = write_stream(ops, model, options, &bytes, &count, error);
    }
    char *made = status == TAUT_OK ? own_text(bytes, count) : NULL;
    free(bytes); /* malloc's */
    if (status != TAUT_OK) {
        return status;
    }
    if (made == NULL) {
        return taut_fail_memory(error);
    }
    *text = made;
    *length = count;
    return TAUT_OK;
}
