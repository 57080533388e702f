/* posix_own.h -- what Linux has beyond POSIX, and what other POSIX systems (macOS) have in its place.
 *
 * The other branch compiles on Linux with -DTAUT_PLAIN_POSIX, where the tests of files pass, but for those that break Linux's own calls
 * and for what a killed program leaves behind; it never ran on another system. Read by posix.c and posix_helper.c, which define _GNU_SOURCE before anything else. */
#ifndef TAUT_PLATFORM_POSIX_OWN_H
#define TAUT_PLATFORM_POSIX_OWN_H

#include "platform/system.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#if defined(__APPLE__)
#include <crt_externs.h> /* where a library has no `environ` of its own */
#define own_environ (*_NSGetEnviron())
#else
extern char **environ;
#define own_environ environ
#endif

#if defined(__linux__) && !defined(TAUT_PLAIN_POSIX)
#include <sys/mman.h>
#include <sys/random.h>

/* A file without a name in `folder`, to be named through /proc; -1 where there is no such thing. */
static inline int own_open_nameless(const char *folder)
{
    return access("/proc/self/fd", X_OK) == 0 ? open(folder, O_TMPFILE | O_WRONLY | O_CLOEXEC, 0666)
                                              : -1;
}

/* A file to write and read that nobody else sees, on disk, where there may be more room than in memory; where the folder takes no
 * such files, in memory. -1 with errno. */
static inline int own_open_private(const char *folder)
{
    const int file = open(folder, O_TMPFILE | O_RDWR | O_CLOEXEC, 0600);
    return file >= 0 ? file : memfd_create("taut-private", MFD_CLOEXEC);
}

/* A pipe whose ends close in other programs. 0, or -1 with errno. */
static inline int own_pipe(int ends[2])
{
    return pipe2(ends, O_CLOEXEC);
}

/* A variable of the environment, NULL in programs that run with another's rights. */
static inline const char *own_getenv(const char *name)
{
    return secure_getenv(name);
}

/* Fills `random`; returns whether it could. */
static inline int own_random(void *random, size_t size)
{
    return getrandom(random, size, 0) == (ssize_t)size;
}

/* What a stream into memory keeps. */
typedef struct own_kept {
    char **text;
    size_t *length, room;
} own_kept;

static inline ssize_t own_keep(void *cookie, const char *bytes, size_t count)
{
    own_kept *kept = cookie;
    const size_t length = *kept->length, free = kept->room - length;
    if (count >= free) { /* one byte for the 0 */
        const size_t room = 2 * kept->room + count;
        char *larger = room > count ? taut_system_resize(*kept->text, room) : NULL;
        if (larger == NULL) {
            errno = ENOMEM;
            return 0;
        }
        *kept->text = larger;
        kept->room = room;
    }
    memcpy(*kept->text + length, bytes, count);
    (*kept->text)[length + count] = '\0';
    *kept->length = length + count;
    return (ssize_t)count;
}

static inline int own_drop(void *cookie)
{
    free(cookie);
    return 0;
}

/* As open_memstream, of which glibc's copies all that there is whenever it grows: large blocks of realloc move by their pages. */
static inline FILE *own_memory_stream(char **text, size_t *length)
{
    enum { FIRST_ROOM = 1 << 12 };
    own_kept *kept = malloc(sizeof *kept);
    FILE *stream = NULL;

    *length = 0;
    *text = taut_system_take(FIRST_ROOM);
    if (kept != NULL && *text != NULL) {
        **text = '\0';
        *kept = (own_kept){text, length, FIRST_ROOM};
        stream =
            fopencookie(kept, "wb", (cookie_io_functions_t){.write = own_keep, .close = own_drop});
    }
    if (stream == NULL) {
        free(kept);
        taut_system_release(*text);
        *text = NULL;
    }
    return stream;
}

#else
#if defined(__APPLE__)
#include <sys/random.h>
#endif

static inline int own_open_nameless(const char *folder)
{
    (void)folder;
    errno = EOPNOTSUPP;
    return -1;
}

static inline int own_open_private(const char *folder)
{
    char path[1024];
    const char name[] = "/taut-XXXXXX";
    if (strlen(folder) + sizeof name > sizeof path) {
        errno = ENAMETOOLONG;
        return -1;
    }
    memcpy(path, folder, strlen(folder));
    memcpy(path + strlen(folder), name, sizeof name);
    const int file = mkstemp(path);
    if (file >= 0) {
        unlink(path);
        fcntl(file, F_SETFD, FD_CLOEXEC);
    }
    return file;
}

static inline int own_pipe(int ends[2])
{
    if (pipe(ends) != 0) {
        return -1;
    }
    fcntl(ends[0], F_SETFD, FD_CLOEXEC);
    fcntl(ends[1], F_SETFD, FD_CLOEXEC);
    return 0;
}

static inline const char *own_getenv(const char *name)
{
    return getuid() == geteuid() && getgid() == getegid() ? getenv(name) : NULL;
}

static inline int own_random(void *random, size_t size)
{
    return getentropy(random, size) == 0;
}

static inline FILE *own_memory_stream(char **text, size_t *length)
{
    return open_memstream(text, length);
}
#endif

#endif /* TAUT_PLATFORM_POSIX_OWN_H */
