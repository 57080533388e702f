/* text.c -- a model in memory, in any format that is written as a stream. */
#include "core/fail.h"
#include "core/memory.h"
#include "core/pulse.h"
#include "io/file/in.h"
#include "io/format.h"
#include "platform/system.h"

#include <stdio.h>
#include <string.h>

/* The bytes of a spool as the library's own, ended by a 0. */
static taut_status own_text(const char *bytes, size_t length, const taut_monitor *monitor,
                            char **text)
{
    enum { PART = 1 << 20, BYTE_WORK = 5 }; /* operations, as pulses count them */
    taut_pulse pulse = {.monitor = monitor, .what = "writing", .done = taut_none};
    char *made = taut_alloc(length + 1, 1);

    if (made == NULL) {
        return TAUT_NO_MEMORY;
    }
    for (size_t at = 0; at < length; at += PART) {
        const size_t count = length - at < PART ? length - at : PART;
        memcpy(made + at, bytes + at, count);
        if (taut_pulse_beat(&pulse, (double)BYTE_WORK * (double)count)) {
            taut_free(made);
            return TAUT_INTERRUPTED;
        }
    }
    made[length] = '\0';
    *text = made;
    return TAUT_OK;
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
    char *made = NULL;
    if (status == TAUT_OK) {
        status = taut_fail_status(error, own_text(bytes, count, &options->monitor, &made));
    }
    taut_system_release(bytes);
    if (status != TAUT_OK) {
        return status;
    }
    *text = made;
    *length = count;
    return TAUT_OK;
}
