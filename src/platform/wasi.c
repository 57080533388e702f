#define _DEFAULT_SOURCE /* getentropy */
/* wasi.c -- taut in WebAssembly: one thread, no modules, and files as far as the host opens its own.
 *
 * Every function of a host that opens no folder fails with that host's reason. A new file is written
 * under a passing name beside its target and renamed over it.
 */
#include "platform/system.h"

#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

enum { TRIES = 64 };

const char *taut_system_reason(int number, char *text, size_t size)
{
    return strerror_r(number, text, size) == 0 ? text : "unknown reason";
}

/* ---- threads and modules ---- */

void taut_system_threads(int count, void (*run)(void *context, int part), void *context)
{
    for (int p = 0; p < count; p++) {
        run(context, p);
    }
}

const void *taut_system_module(const char *name)
{
    (void)name;
    return NULL;
}

/* ---- a helper: there are no processes ---- */

int taut_system_helper(const char *name, const char *variable, char path[TAUT_PATH_ROOM])
{
    (void)name;
    (void)variable;
    (void)path;
    return 0;
}

FILE *taut_system_helper_request(int *reason)
{
    *reason = ENOSYS;
    return NULL;
}

int taut_system_helper_start(taut_helper *helper, const char *program, FILE *request,
                             double seconds)
{
    (void)helper;
    (void)program;
    (void)request;
    (void)seconds;
    return ENOSYS;
}

int taut_system_helper_read(const taut_helper *helper, void *to, size_t room, size_t *count)
{
    (void)helper;
    (void)to;
    (void)room;
    *count = 0;
    return ENOSYS;
}

taut_helper_fate taut_system_helper_end(const taut_helper *helper, int *number)
{
    (void)helper;
    *number = 0;
    return TAUT_HELPER_UNKNOWN;
}

/* ---- reading ---- */

int taut_system_open(const char *path, taut_source *source)
{
    struct stat about;

    source->file = strcmp(path, "-") == 0 ? STDIN_FILENO : open(path, O_RDONLY);
    if (source->file < 0 || fstat(source->file, &about) != 0) {
        return errno;
    }
    source->size = S_ISREG(about.st_mode) ? (double)about.st_size : -1;
    if (S_ISDIR(about.st_mode)) {
        taut_system_close(source);
        return EISDIR;
    }
    return 0;
}

int taut_system_read(taut_source *source, char *to, size_t room, size_t *count)
{
    const ssize_t got = read(source->file, to, room);
    *count = got > 0 ? (size_t)got : 0;
    return got < 0 ? errno : 0;
}

/* ---- what is there ---- */

/* Paths are the host's to resolve: they are taken as they are, with a folder in front. */
int taut_system_target(const char *path, taut_target_kind *kind, char target[TAUT_PATH_ROOM])
{
    const char *folder = strchr(path, '/') == NULL ? "./" : "";
    const taut_place place = taut_system_place_of(path);

    if (strcmp(path, "-") == 0) {
        *kind = TAUT_TARGET_STANDARD;
        target[0] = '\0';
        return 0;
    }
    if (path[0] == '\0' || strlen(folder) + strlen(path) >= TAUT_PATH_ROOM) {
        return path[0] == '\0' ? ENOENT : ENAMETOOLONG;
    }
    memcpy(target, folder, strlen(folder) + 1);
    strcat(target, path);
    *kind = place == TAUT_PLACE_OTHER ? TAUT_TARGET_DEVICE : TAUT_TARGET_FILE;
    return place == TAUT_PLACE_FOLDER ? EISDIR : 0;
}

/* ---- writing ---- */

int taut_system_create(taut_new_file *made)
{
    char *name = strrchr(made->temporary, '/') + 1;
    int file = -1, reason = EEXIST;

    for (int i = 0; i < TRIES && reason == EEXIST; i++) {
        unsigned char random[8];
        if (getentropy(random, sizeof random) != 0) {
            return errno;
        }
        snprintf(name, TAUT_SUFFIX_ROOM, ".taut-%02x%02x%02x%02x%02x%02x%02x%02x", random[0],
                 random[1], random[2], random[3], random[4], random[5], random[6], random[7]);
        file = open(made->temporary, O_WRONLY | O_CREAT | O_EXCL, 0666);
        reason = file < 0 ? errno : 0;
    }
    made->pending = reason == 0;
    made->stream = reason == 0 ? fdopen(file, "wb") : NULL;
    if (reason == 0 && made->stream == NULL) {
        close(file);
        taut_system_discard(made);
        return ENOMEM;
    }
    return reason;
}

const char *taut_system_own_path(const taut_new_file *file, char own[TAUT_OWN_ROOM])
{
    (void)own;
    return file->temporary;
}

int taut_system_place(taut_new_file *file)
{
    if (rename(file->temporary, file->target) != 0) {
        return errno;
    }
    file->pending = 0;
    return 0;
}

void taut_system_discard(taut_new_file *file)
{
    if (file->stream != NULL) {
        fclose(file->stream);
        file->stream = NULL;
    }
    taut_system_remove(file);
    file->pending = 0;
}

void taut_system_remove(const taut_new_file *file)
{
    if (file->pending) {
        unlink(file->temporary);
    }
}

int taut_system_open_device(const char *target, FILE **stream)
{
    *stream = fopen(target, "ab");
    return *stream == NULL ? errno : 0;
}

FILE *taut_system_spool(char **text, size_t *length)
{
    return open_memstream(text, length);
}

int taut_system_spooled(FILE *spool, char **text, size_t *length)
{
    (void)text;
    (void)length;
    return fclose(spool);
}
