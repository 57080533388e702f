/* target.c -- where a path leads: through links, to a file, a device or standard output. */
#include "io/file/target.h"

#include "core/fail.h"
#include "io/file/in.h"

#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

enum { LINKS_MAX = 40 };

static int is_standard(const char *path)
{
    return strcmp(path, "-") == 0 || strcmp(path, "/dev/stdout") == 0 ||
           strcmp(path, "/dev/fd/1") == 0 || strcmp(path, "/proc/self/fd/1") == 0;
}

/* Joins the folder of `path` and a name: "a/b" and "c" give "a/c". 0 if it does not fit. */
static int join_path(const char *path, const char *name, char joined[TAUT_PATH_ROOM])
{
    const char *slash = strrchr(path, '/');
    const size_t folder = slash != NULL ? (size_t)(slash - path) + 1 : 0;
    if (folder + strlen(name) >= TAUT_PATH_ROOM) {
        return 0;
    }
    memmove(joined, path, folder);
    memmove(joined + folder, name, strlen(name) + 1);
    return 1;
}

/* Follows the links of the last part, also one that leads nowhere yet. Returns errno, or 0. */
static int follow_links(char path[TAUT_PATH_ROOM])
{
    char link[TAUT_PATH_ROOM];
    char joined[TAUT_PATH_ROOM];
    for (int i = 0; i < LINKS_MAX; i++) {
        const ssize_t length = readlink(path, link, sizeof link - 1);
        if (length < 0) {
            return 0; /* not a link: other troubles are found when it is used */
        }
        link[length] = '\0';
        if (!join_path(link[0] == '/' ? "" : path, link, joined)) {
            return ENAMETOOLONG;
        }
        memcpy(path, joined, strlen(joined) + 1);
    }
    return ELOOP;
}

/* Spells the folder in full, so that two names of one file are told to be one. Returns errno, or
 * 0. */
static int spell_folder(char path[TAUT_PATH_ROOM])
{
    char folder[TAUT_PATH_ROOM];
    char full[TAUT_PATH_ROOM];
    const char *slash = strrchr(path, '/');
    const char *name = slash != NULL ? slash + 1 : path;
    const size_t length = strlen(name);
    size_t used = 0;

    if (slash == NULL) {
        memcpy(folder, ".", 2);
    } else {
        memcpy(folder, path, (size_t)(slash - path) + 1);
        folder[slash - path + 1] = '\0';
    }
    if (realpath(folder, full) == NULL) {
        return errno;
    }
    used = strlen(full);
    if (used + 1 + length >= TAUT_PATH_ROOM) {
        return ENAMETOOLONG;
    }
    memmove(path + used + 1, name, length + 1);
    memcpy(path, full, used);
    path[used] = '/';
    return length > 0 ? 0 : ENOENT;
}

/* A file that is there must be one that may be written: renaming over it would not ask. */
static int check_file(const char *target, const struct stat *about)
{
    if (S_ISDIR(about->st_mode)) {
        return EISDIR;
    }
    return faccessat(AT_FDCWD, target, W_OK, AT_EACCESS) == 0 ? 0 : errno;
}

taut_status taut_target_find(const char *path, taut_target_kind *kind, char target[TAUT_PATH_ROOM],
                             taut_error *error)
{
    struct stat about;
    int is_there = 0, reason = 0;

    if (is_standard(path)) {
        *kind = TAUT_TARGET_STANDARD;
        target[0] = '\0';
        return TAUT_OK;
    }
    if (path[0] == '\0' || strlen(path) >= TAUT_PATH_ROOM) {
        return taut_fail_file(error, path, "write", path[0] == '\0' ? ENOENT : ENAMETOOLONG);
    }
    memcpy(target, path, strlen(path) + 1);
    is_there = stat(path, &about) == 0;
    if (strncmp(path, "/dev/fd/", 8) == 0 || strncmp(path, "/proc/", 6) == 0 ||
        strcmp(path, "/dev/stderr") == 0 ||
        (is_there && !S_ISREG(about.st_mode) && !S_ISDIR(about.st_mode))) {
        *kind = TAUT_TARGET_DEVICE;
        return TAUT_OK;
    }
    *kind = TAUT_TARGET_FILE;
    reason = follow_links(target);
    if (reason == 0) {
        reason = spell_folder(target);
    }
    if (reason == 0 && is_there) {
        reason = check_file(target, &about);
    }
    return reason == 0 ? TAUT_OK : taut_fail_file(error, path, "write", reason);
}
