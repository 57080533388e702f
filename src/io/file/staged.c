#define _GNU_SOURCE /* O_TMPFILE */
#include "io/file/staged.h"

#include "core/fail.h"
#include "core/memory.h"
#include "io/file/in.h"
#include "io/file/target.h"

#include <errno.h>
#include <fcntl.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <sys/random.h>
#include <sys/stat.h>
#include <unistd.h>

enum { TRIES = 64, SUFFIX_ROOM = 32 };

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
    taut_status status = taut_target_find(path, &kind, target, error);

    if (status != TAUT_OK) {
        return status;
    }
    made = taut_alloc_zero(1, sizeof *made);
    if (made == NULL) {
        return taut_fail_memory(error);
    }
    made->kind = kind;
    made->path = text_copy(path, 0);
    made->target = text_copy(target, 0);
    made->temporary = kind == TAUT_TARGET_FILE ? text_copy(target, SUFFIX_ROOM) : NULL;
    if (made->path == NULL || made->target == NULL ||
        (kind == TAUT_TARGET_FILE && made->temporary == NULL)) {
        taut_staged_free(made);
        return taut_fail_memory(error);
    }
    *staged = made;
    return TAUT_OK;
}

/* A name in the same folder that nobody can guess: ".taut-" and 16 hexadecimal digits. Returns
 * errno, or 0. */
static int name_temporary(char *temporary)
{
    static const char hex[] = "0123456789abcdef";
    char *name = strrchr(temporary, '/') + 1; /* the target is spelled in full */
    unsigned char random[8];

    if (getrandom(random, sizeof random, 0) != (ssize_t)sizeof random) {
        return errno;
    }
    memcpy(name, ".taut-", 6);
    for (size_t i = 0; i < sizeof random; i++) {
        name[6 + 2 * i] = hex[random[i] >> 4];
        name[7 + 2 * i] = hex[random[i] & 15];
    }
    name[6 + 2 * sizeof random] = '\0';
    return 0;
}

/* The new file gets what the old one had, as far as that is allowed. */
static void take_mode(int file, const char *target)
{
    struct stat old;
    if (stat(target, &old) == 0) {
        if (fchown(file, old.st_uid, old.st_gid) != 0) {
            errno = 0; /* somebody else's file, written by its group: it becomes ours */
        }
        if (fchmod(file, old.st_mode & 0777) != 0) {
            errno = 0;
        }
    }
}

/* A file without a name in the folder of `temporary`; -1 where there is no such thing. It gets its
 * name through /proc. */
static int open_nameless(char *temporary)
{
    char *slash = strrchr(temporary, '/');
    const char first = slash[1];
    int file = -1;
    if (access("/proc/self/fd", X_OK) == 0) {
        slash[1] = '\0';
        file = open(temporary, O_TMPFILE | O_WRONLY | O_CLOEXEC, 0666);
        slash[1] = first;
    }
    return file;
}

/* A new file named `temporary`. Returns it, or -1 with *reason set. */
static int open_named(taut_staged *staged, int *reason)
{
    int file = -1;
    *reason = EEXIST;
    for (int i = 0; i < TRIES && file < 0 && *reason == EEXIST; i++) {
        *reason = name_temporary(staged->temporary);
        if (*reason == 0) {
            staged->pending = 1; /* first, so that a signal never finds a file not known */
            file = open(staged->temporary, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
            *reason = file < 0 ? errno : 0;
            staged->pending = file >= 0;
        }
    }
    return file;
}

static taut_status open_temporary(taut_staged *staged, taut_error *error)
{
    int reason = 0;
    int file = open_nameless(staged->temporary);
    /* kept open past the stream, as without a name nothing else holds the file */
    const int kept = file >= 0 ? fcntl(file, F_DUPFD_CLOEXEC, 3) : -1;

    if (kept >= 0) {
        staged->nameless = kept;
    } else {
        if (file >= 0) {
            close(file);
        }
        file = open_named(staged, &reason);
    }
    if (file < 0) {
        return taut_fail_file(error, staged->path, "write", reason);
    }
    take_mode(file, staged->target);
    staged->file = fdopen(file, "wb");
    if (staged->file == NULL) {
        close(file);
        taut_staged_drop(staged);
        return taut_fail_memory(error);
    }
    return TAUT_OK;
}

const char *taut_staged_path(const taut_staged *staged, char own[TAUT_STAGED_ROOM])
{
    if (staged->nameless <= 0) {
        return staged->temporary;
    }
    snprintf(own, TAUT_STAGED_ROOM, "/proc/self/fd/%d", staged->nameless);
    return own;
}

/* Names the file that has none `temporary`. Returns errno, or 0. */
static int give_name(taut_staged *staged)
{
    char room[TAUT_STAGED_ROOM];
    const char *own = taut_staged_path(staged, room);
    int reason = EEXIST;
    for (int i = 0; i < TRIES && reason == EEXIST; i++) {
        reason = name_temporary(staged->temporary);
        if (reason == 0) {
            staged->pending = 1;
            reason = linkat(AT_FDCWD, own, AT_FDCWD, staged->temporary, AT_SYMLINK_FOLLOW) == 0
                         ? 0
                         : errno;
            staged->pending = reason == 0;
        }
    }
    return reason;
}

taut_status taut_staged_open(taut_staged *staged, taut_error *error)
{
    if (staged->kind == TAUT_TARGET_FILE) {
        return open_temporary(staged, error);
    }
    staged->file = open_memstream(&staged->spool, &staged->spool_length);
    return staged->file != NULL ? TAUT_OK : taut_fail_memory(error);
}

taut_status taut_staged_close(taut_staged *staged, taut_error *error)
{
    FILE *file = staged->file;
    int failed = 0;

    staged->file = NULL;
    errno = 0;
    failed = ferror(file) != 0;
    failed |= fclose(file) != 0;
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
    const int file = open(staged->target, O_WRONLY | O_APPEND | O_CLOEXEC | O_NOCTTY);
    FILE *out = file >= 0 ? fdopen(file, "wb") : NULL;
    int reason = errno;
    if (out == NULL) {
        if (file >= 0) {
            close(file);
        }
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
        reason = staged->nameless > 0 ? give_name(staged) : 0;
        if (reason == 0) {
            reason = rename(staged->temporary, staged->target) == 0 ? 0 : errno;
            staged->pending = reason != 0;
        }
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
    if (staged->nameless > 0) {
        close(staged->nameless);
        staged->nameless = 0;
    }
    if (staged->pending) {
        unlink(staged->temporary);
        staged->pending = 0;
    }
    staged->is_ready = 0;
}

void taut_staged_free(taut_staged *staged)
{
    if (staged != NULL) {
        taut_staged_drop(staged);
        free(staged->spool); /* malloc's, through open_memstream */
        taut_free(staged->path);
        taut_free(staged->target);
        taut_free(staged->temporary);
        taut_free(staged);
    }
}
