/* outputs.c -- several outputs that appear together or not at all. */
#include "core/fail.h"
#include "core/memory.h"
#include "io/file/in.h"
#include "io/file/staged.h"
#include "io/format.h"
#include "io/json/out.h"
#include "taut/write.h"

#include <errno.h>
#include <stdatomic.h>
#include <string.h>

/* The list only grows until it is freed, and an item is whole before it is in it: so a signal
 * handler may walk it at any time. */
struct taut_outputs {
    _Atomic(taut_staged *) first;
};

taut_status taut_outputs_new(taut_outputs **outputs)
{
    taut_outputs *made = NULL;
    if (outputs == NULL) {
        return TAUT_BAD_ARGUMENT;
    }
    made = taut_alloc_zero(1, sizeof *made);
    if (made == NULL) {
        return TAUT_NO_MEMORY;
    }
    atomic_init(&made->first, NULL);
    *outputs = made;
    return TAUT_OK;
}

void taut_outputs_free(taut_outputs *outputs)
{
    taut_staged *staged = NULL;
    if (outputs == NULL) {
        return;
    }
    staged = atomic_exchange(&outputs->first, NULL);
    while (staged != NULL) {
        taut_staged *next = staged->next;
        taut_staged_free(staged);
        staged = next;
    }
    taut_free(outputs);
}

void taut_outputs_abandon(const taut_outputs *outputs)
{
    const taut_staged *staged = NULL;
    if (outputs == NULL) {
        return;
    }
    for (staged = atomic_load(&outputs->first); staged != NULL; staged = staged->next) {
        taut_system_remove(&staged->made);
    }
}

/* Is there an output already that goes to the same place? */
static int is_taken(const taut_outputs *outputs, const taut_staged *staged)
{
    const taut_staged *other = atomic_load(&outputs->first);
    while (other != NULL && !(other->is_ready && other->kind == staged->kind &&
                              taut_system_same_target(other->target, staged->target))) {
        other = other->next;
    }
    return other != NULL && staged->kind != TAUT_TARGET_DEVICE;
}

/* A new output, in the list and open. */
static taut_status stage_output(taut_outputs *outputs, const char *path, taut_staged **staged,
                                taut_error *error)
{
    taut_staged *made = NULL;
    taut_status status = taut_staged_new(path, &made, error);

    if (status == TAUT_OK && is_taken(outputs, made)) {
        status = taut_fail(error, TAUT_BAD_ARGUMENT, "same-place", NULL, taut_none, taut_none,
                           "two outputs go to %.200s",
                           made->kind == TAUT_TARGET_STANDARD ? "standard output" : path);
    }
    if (status != TAUT_OK) {
        taut_staged_free(made);
        return status;
    }
    made->next = atomic_load(&outputs->first);
    atomic_store(&outputs->first, made);
    *staged = made;
    return taut_staged_open(made, error);
}

/* Ends the writing of an output: `status` is the writer's, who may have left it to us to say what
 * the file's trouble was. */
static taut_status finish_output(taut_staged *staged, taut_status status, taut_error *error)
{
    const int reason = errno != 0 ? errno : EIO;
    if (status == TAUT_OK) {
        return taut_staged_close(staged, error);
    }
    if (status == TAUT_INTERRUPTED) {
        (void)taut_fail_status(error, status);
    }
    if (staged->file != NULL && ferror(staged->file)) {
        status = staged->kind == TAUT_TARGET_FILE
                     ? taut_fail_file(error, staged->path, "write", reason)
                     : taut_fail_memory(error);
    }
    taut_staged_drop(staged);
    return status;
}

/* By a library that opens the file itself. */
static taut_status write_by_path(taut_staged *staged, const taut_format_ops *ops,
                                 const taut_model *model, const taut_write_options *options,
                                 taut_error *error)
{
    char own[TAUT_OWN_ROOM];
    if (staged->kind != TAUT_TARGET_FILE) {
        return taut_fail(error, TAUT_IO, "not-a-file", NULL, taut_none, taut_none,
                         "%.200s is no regular file: this format can be written to nothing else",
                         staged->path);
    }
    return ops->write_path(model, options, taut_staged_path(staged, own), error);
}

/* The format of the path; NULL, and then *error says so. */
static const taut_format_ops *format_of(const char *path, const taut_write_options *options,
                                        taut_error *error)
{
    taut_error reason = {.status = TAUT_OK};
    const char *ending = options->format;
    char name[32] = ".";

    if (ending != NULL) {
        strncat(name, ending, sizeof name - 2);
        path = name;
    }
    const taut_format_row *row = taut_format_find(options->formats, path, &reason);
    if (row == NULL && error != NULL) {
        *error = reason;
    }
    return row != NULL ? row->ops : NULL;
}

static taut_status write_one(taut_staged *staged, const taut_format_ops *ops,
                             const taut_model *model, const taut_write_options *options,
                             taut_error *error)
{
    return ops->write != NULL ? ops->write(model, options, staged->file, error)
                              : write_by_path(staged, ops, model, options, error);
}

/* One model, or several together. */
static taut_status write_models(taut_outputs *outputs, int count, const taut_model *const *models,
                                int together, const char *path, const taut_write_options *options,
                                taut_error *error)
{
    const taut_format_ops *ops = format_of(path, options, error);
    taut_staged *staged = NULL;
    taut_status status = TAUT_OK;

    if (ops == NULL) {
        return TAUT_BAD_ARGUMENT;
    }
    if (together && ops->write_many == NULL) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, "several", NULL, count, 1,
                         "the format of %.200s holds one model a file; several go into .json, or "
                         "side by side into .svg, .pdf and .png",
                         path);
    }
    if (together && count > ops->models_max) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, "several", NULL, count, ops->models_max,
                         "%.200s would hold %d models, %d at most", path, count, ops->models_max);
    }
    for (int i = 0; i < count; i++) {
        status = taut_format_check(models[i], options, error);
        if (status != TAUT_OK) {
            return status;
        }
    }
    status = stage_output(outputs, path, &staged, error);
    if (status != TAUT_OK) {
        return status;
    }
    errno = 0;
    status = together ? ops->write_many(count, models, options, staged->file, error)
                      : write_one(staged, ops, models[0], options, error);
    return finish_output(staged, status, error);
}

taut_status taut_outputs_model(taut_outputs *outputs, const taut_model *model, const char *path,
                               const taut_write_options *options, taut_error *error)
{
    static const taut_write_options none;
    if (outputs == NULL || model == NULL || path == NULL) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, "argument", NULL, taut_none, taut_none,
                         "an output needs a model and a path");
    }
    return write_models(outputs, 1, &model, 0, path, options != NULL ? options : &none, error);
}

taut_status taut_outputs_models(taut_outputs *outputs, int count, const taut_model *const *models,
                                const char *path, const taut_write_options *options,
                                taut_error *error)
{
    static const taut_write_options none;
    int whole = outputs != NULL && path != NULL && count >= 1 && models != NULL;
    for (int i = 0; whole && i < count; i++) {
        whole = models[i] != NULL;
    }
    if (!whole) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, "argument", NULL, taut_none, taut_none,
                         "an output of several models needs them all and a path");
    }
    return write_models(outputs, count, models, 1, path, options != NULL ? options : &none, error);
}

taut_status taut_outputs_record(taut_outputs *outputs, const taut_record *record, const char *path,
                                taut_error *error)
{
    taut_json_out out;
    taut_staged *staged = NULL;
    taut_status status = TAUT_OK;

    if (outputs == NULL || record == NULL || path == NULL) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, "argument", NULL, taut_none, taut_none,
                         "an output needs a record and a path");
    }
    status = stage_output(outputs, path, &staged, error);
    if (status != TAUT_OK) {
        return status;
    }
    out = taut_json_out_to(staged->file);
    taut_json_put_record(&out, record);
    status = taut_json_out_finish(&out);
    return finish_output(staged, status == TAUT_NO_MEMORY ? taut_fail_memory(error) : status,
                         error);
}

taut_status taut_outputs_text(taut_outputs *outputs, const char *text, size_t length,
                              const char *path, taut_error *error)
{
    taut_staged *staged = NULL;
    taut_status status = TAUT_OK;

    if (outputs == NULL || (text == NULL && length > 0) || path == NULL) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, "argument", NULL, taut_none, taut_none,
                         "an output needs a text and a path");
    }
    status = stage_output(outputs, path, &staged, error);
    if (status != TAUT_OK) {
        return status;
    }
    errno = 0;
    if (length > 0 && fwrite(text, 1, length, staged->file) != length) {
        status = TAUT_IO;
    }
    return finish_output(staged, status, error);
}

/* Places what is ready of one kind of target. */
static taut_status place_all(taut_outputs *outputs, int files, taut_error *error)
{
    taut_status status = TAUT_OK;
    taut_staged *staged = atomic_load(&outputs->first);
    for (; status == TAUT_OK && staged != NULL; staged = staged->next) {
        if (staged->is_ready && (staged->kind == TAUT_TARGET_FILE) == files) {
            status = taut_staged_place(staged, error);
        }
    }
    return status;
}

taut_status taut_outputs_commit(taut_outputs *outputs, taut_error *error)
{
    taut_status status = TAUT_OK;
    if (outputs == NULL) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, "argument", NULL, taut_none, taut_none,
                         "there are no outputs to put in place");
    }
    status = place_all(outputs, 0, error); /* a full device or a closed pipe is found here... */
    if (status == TAUT_OK) {
        status = place_all(outputs, 1, error); /* ...before any file appears */
    }
    if (status != TAUT_OK) {
        for (taut_staged *s = atomic_load(&outputs->first); s != NULL; s = s->next) {
            taut_staged_drop(s);
        }
    }
    return status;
}

taut_status taut_model_write(const taut_model *model, const char *path,
                             const taut_write_options *options, taut_error *error)
{
    taut_outputs *outputs = NULL;
    taut_status status = TAUT_OK;
    if (taut_outputs_new(&outputs) != TAUT_OK) {
        return taut_fail_memory(error);
    }
    status = taut_outputs_model(outputs, model, path, options, error);
    if (status == TAUT_OK) {
        status = taut_outputs_commit(outputs, error);
    }
    taut_outputs_free(outputs);
    return status;
}

taut_status taut_record_write(const taut_record *record, char **text, size_t *length)
{
    taut_json_out out;
    if (record == NULL || text == NULL || length == NULL) {
        return TAUT_BAD_ARGUMENT;
    }
    out = taut_json_out_to(NULL);
    taut_json_put_record(&out, record);
    if (taut_json_out_finish(&out) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    *text = out.sink.text;
    *length = out.sink.length;
    return TAUT_OK;
}

void taut_text_free(char *text)
{
    taut_free(text);
}
