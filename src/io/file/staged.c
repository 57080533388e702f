#include "io/file/staged.h"

#include "core/fail.h"
#include "core/memory.h"
#include "io/file/in.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

static char *text_copy(const char *text, size_t room)
{
    char *copy = taut_alloc(strlen(text) + 1 + room, 1);
    if (copy != NULL) {
        memcpy(copy, text, strlen(text) + 1);
    }
    return copy;
}

taut_status taut_staged_new(const char *path, taut_staged **staged, taut_error *error)
{
    char target[TAUT_PATH_ROOM];
    taut_target_kind kind = TAUT_TARGET_FILE;
    taut_staged *made = NULL;
    const int reason = taut_system_target(path, &kind, target);

    if (reason != 0) {
        return taut_fail_file(error, path, "write", reason);
    }
    made = taut_alloc_zero(1, sizeof *made);
    if (made == NULL) {
        return taut_fail_memory(error);
    }
    made->kind = kind;
    made->path = text_copy(path, 0);
    made->target = text_copy(target, 0);
    made->made.target = made->target;
    made->made.temporary = kind == TAUT_TARGET_FILE ? text_copy(target, TAUT_SUFFIX_ROOM) : NULL;
    if (made->path == NULL || made->target == NULL ||
        (kind == TAUT_TARGET_FILE && made->made.temporary == NULL)) {
        taut_staged_free(made);
        return taut_fail_memory(error);
    }
    *staged = made;
    return TAUT_OK;
}

const char *taut_staged_path(const taut_staged *staged, char own[TAUT_OWN_ROOM])
{
    return taut_system_own_path(&staged->made, own);
}

taut_status taut_staged_open(taut_staged *staged, taut_error *error)
{
    if (staged->kind == TAUT_TARGET_FILE) {
        const int reason = taut_system_create(&staged->made);
        staged->file = staged->made.stream;
        staged->made.stream = NULL;
        return reason == 0        ? TAUT_OK
               : reason == ENOMEM ? taut_fail_memory(error)
                                  : taut_fail_file(error, staged->path, "write", reason);
    }
    staged->file = taut_system_spool(&staged->spool, &staged->spool_length);
    return staged->file != NULL ? TAUT_OK : taut_fail_memory(error);
}

taut_status taut_staged_close(taut_staged *staged, taut_error *error)
{
    FILE *file = staged->file;
    int failed = 0;

    staged->file = NULL;
    errno = 0;
    failed = ferror(file) != 0;
    failed |= (staged->kind == TAUT_TARGET_FILE
                   ? fclose(file)
                   : taut_system_spooled(file, &staged->spool, &staged->spool_length)) != 0;
    if (failed) {
        const int reason = errno != 0 ? errno : EIO;
        taut_staged_drop(staged);
        if (staged->kind != TAUT_TARGET_FILE) {
            return taut_fail_memory(error);
        }
        return taut_fail_file(error, staged->path, "write", reason);
    }
    staged->is_ready = 1;
    return TAUT_OK;
}

/* Sends the spool through a stream. Returns errno, or 0. */
static int send_spool(const taut_staged *staged, FILE *out)
{
    errno = 0;
    if (fwrite(staged->spool, 1, staged->spool_length, out) != staged->spool_length ||
        fflush(out) != 0) {
        return errno != 0 ? errno : EIO;
    }
    return 0;
}

static int send_to_device(const taut_staged *staged)
{
    FILE *out = NULL;
    int reason = taut_system_open_device(staged->target, &out);
    if (reason != 0) {
        return reason;
    }
    reason = send_spool(staged, out);
    if (fclose(out) != 0 && reason == 0) {
        reason = errno;
    }
    return reason;
}

taut_status taut_staged_place(taut_staged *staged, taut_error *error)
{
    int reason = 0;
    if (staged->kind == TAUT_TARGET_FILE) {
        reason = taut_system_place(&staged->made);
    } else if (staged->kind == TAUT_TARGET_STANDARD) {
        reason = send_spool(staged, stdout);
    } else {
        reason = send_to_device(staged);
    }
    staged->is_ready = reason != 0;
    return reason == 0 ? TAUT_OK : taut_fail_file(error, staged->path, "write", reason);
}

void taut_staged_drop(taut_staged *staged)
{
    if (staged->file != NULL) {
        fclose(staged->file);
        staged->file = NULL;
    }
    taut_system_discard(&staged->made);
    staged->is_ready = 0;
}

void taut_staged_free(taut_staged *staged)
{
    if (staged != NULL) {
        taut_staged_drop(staged);
        taut_system_release(staged->spool);
        taut_free(staged->path);
        taut_free(staged->target);
        taut_free(staged->made.temporary);
        taut_free(staged);
    }
}
