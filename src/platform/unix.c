/* unix.c -- what systems with the files, the memory and the clock of POSIX share: those of posix.c and of wasi.c. */
#include "platform/system.h"
#include "taut/limits.h"

#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

double taut_system_seconds(void)
{
    struct timespec now;
    return clock_gettime(CLOCK_MONOTONIC, &now) == 0
               ? (double)now.tv_sec + 1e-9 * (double)now.tv_nsec
               : 0;
}

int64_t taut_system_date(void)
{
    const time_t now = time(NULL);
    return now > 0 ? (int64_t)now : 0;
}

int taut_system_processors(void)
{
    const int64_t count = sysconf(_SC_NPROCESSORS_ONLN);
    return count < 1 ? 1 : count > TAUT_THREADS_MAX ? TAUT_THREADS_MAX : (int)count;
}

/* ---- memory ---- */

void *taut_system_take(size_t bytes)
{
    return malloc(bytes);
}

void *taut_system_take_aligned(size_t bytes)
{
    return aligned_alloc(64, bytes);
}

void *taut_system_take_zero(size_t bytes)
{
    return calloc(1, bytes);
}

void *taut_system_resize(void *block, size_t bytes)
{
    return realloc(block, bytes);
}

void taut_system_release(void *block)
{
    free(block);
}

/* ---- modules and paths ---- */

const char *taut_system_lacks_modules(void)
{
    return NULL;
}

const char *taut_system_last_part(const char *path)
{
    const char *slash = strrchr(path, '/');
    return slash != NULL ? slash + 1 : path;
}

int taut_system_is_rooted(const char *path)
{
    return path[0] == '/';
}

int taut_system_same_target(const char *a, const char *b)
{
    return strcmp(a, b) == 0;
}
