#define _GNU_SOURCE /* posix_own.h, dladdr */
#define _DARWIN_C_SOURCE
/* posix.c -- taut on POSIX systems; files without a name, and modules, as Linux has them.
 *
 * A new file has no name until it is whole, where the system allows that, and else one that nobody
 * can guess; then it is renamed over what was there.
 */
#include "platform/posix_own.h"
#include "platform/system.h"

#include "taut/limits.h"

#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <math.h>
#include <pthread.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/time.h>
#include <time.h>
#include <unistd.h>
#if defined(__GLIBC__)
#include <malloc.h>
#endif

enum { TRIES = 64, LINKS_MAX = 40, STACK = 4 << 20 /* musl gives 128 KiB */ };

/* strerror_r, whichever of its two kinds the C library has. */
static const char *text_filled(int failed, const char *text)
{
    return failed == 0 ? text : "unknown reason";
}

static const char *text_returned(const char *returned, const char *text)
{
    (void)text;
    return returned;
}

const char *taut_system_reason(int number, char *text, size_t size)
{
    return _Generic(strerror_r(number, text, size), int: text_filled, char *: text_returned)(
        strerror_r(number, text, size), text);
}

/* ---- threads and modules ---- */

typedef struct job {
    void (*run)(void *context, int part);
    void *context;
    int part;
} job;

static void *run_job(void *argument)
{
    const job *j = argument;
    j->run(j->context, j->part);
    return NULL;
}

void taut_system_threads(int count, void (*run)(void *context, int part), void *context)
{
    job jobs[TAUT_THREADS_MAX];
    pthread_t handles[TAUT_THREADS_MAX];
    int started[TAUT_THREADS_MAX];
    pthread_attr_t attributes;
    const int is_sized =
        pthread_attr_init(&attributes) == 0 && pthread_attr_setstacksize(&attributes, STACK) == 0;

    for (int p = count - 1; p >= 0; p--) {
        jobs[p] = (job){run, context, p};
        started[p] =
            p > 0 && is_sized && pthread_create(&handles[p], &attributes, run_job, &jobs[p]) == 0;
        if (!started[p]) {
            run_job(&jobs[p]);
        }
    }
    for (int p = 1; p < count; p++) {
        if (started[p]) {
            pthread_join(handles[p], NULL);
        }
    }
    if (is_sized) {
        pthread_attr_destroy(&attributes);
    }
}

/* The path of the object this code is in, "" if unknown. A program that was found by PATH is known there by a bare name
 * only. */
static void own_path(char *path, size_t size)
{
    static const char here;
    Dl_info info;
    path[0] = '\0';
    if (dladdr(&here, &info) == 0 || info.dli_fname == NULL) {
        return;
    }
    snprintf(path, size, "%s", info.dli_fname);
    if (strchr(path, '/') == NULL) {
        const ssize_t length = readlink("/proc/self/exe", path, size - 1);
        path[length > 0 ? length : 0] = '\0';
    }
}

/* The folder of that object, "" if unknown. */
static void own_folder(char *folder, size_t size)
{
    own_path(folder, size);
    char *slash = strrchr(folder, '/');
    folder[slash != NULL ? slash - folder : 0] = '\0';
}

const void *taut_system_module(const char *name)
{
    static const char *const places[] = {"taut", "../lib/taut", "../modules"};
    static const char *const others[] = {TAUT_MODULE_INSTALL_DIR, TAUT_MODULE_BUILD_DIR};
    char folder[1024];
    char path[1280];
    void *handle = NULL;

    own_folder(folder, sizeof folder);
    for (size_t i = 0; handle == NULL && folder[0] != '\0' && i < 3; i++) {
        snprintf(path, sizeof path, "%s/%s/taut-%s.so", folder, places[i], name);
        handle = dlopen(path, RTLD_NOW | RTLD_LOCAL);
    }
    for (size_t i = 0; handle == NULL && i < 2; i++) {
        snprintf(path, sizeof path, "%s/taut-%s.so", others[i], name);
        handle = dlopen(path, RTLD_NOW | RTLD_LOCAL);
    }
    return handle != NULL ? dlsym(handle, "taut_module_table") : NULL;
}

/* ---- a helper ---- */

static int is_program(const char *path)
{
    return taut_system_place_of(path) == TAUT_PLACE_FILE && access(path, X_OK) == 0;
}

/* Ends `folder` with `tail`, the folder of an installation, and in *prefix where that begins? */
static int find_prefix(const char *folder, const char *tail, size_t *prefix)
{
    const size_t length = strlen(folder), end = strlen(tail);
    if (length <= end + 1 || folder[length - end - 1] != '/' ||
        strcmp(folder + length - end, tail) != 0) {
        return 0;
    }
    *prefix = length - end - 1;
    return 1;
}

/* Beside the library, or where an installation puts it that was moved as a whole. */
static int find_near(const char *folder, const char *name, char path[TAUT_PATH_ROOM])
{
    static const char *const tails[] = {TAUT_LIBRARY_FOLDER, TAUT_PROGRAM_FOLDER};
    size_t prefix = 0;
    snprintf(path, TAUT_PATH_ROOM, "%s/%s", folder, name);
    if (is_program(path)) {
        return 1;
    }
    for (size_t i = 0; i < sizeof tails / sizeof tails[0]; i++) {
        if (find_prefix(folder, tails[i], &prefix)) {
            snprintf(path, TAUT_PATH_ROOM, "%.*s/" TAUT_HELPER_FOLDER "/%s", (int)prefix, folder,
                     name);
            if (is_program(path)) {
                return 1;
            }
        }
    }
    return 0;
}

int taut_system_helper(const char *name, const char *variable, char path[TAUT_PATH_ROOM])
{
    static const char *const others[] = {TAUT_HELPER_INSTALL_DIR, TAUT_HELPER_BUILD_DIR};
    const char *said = own_getenv(variable);
    char folder[1024];

    if (said != NULL && said[0] != '\0') {
        snprintf(path, TAUT_PATH_ROOM, "%s", said);
        return 1;
    }
    own_folder(folder, sizeof folder);
    if (folder[0] != '\0' && find_near(folder, name, path)) {
        return 1;
    }
    for (size_t i = 0; i < sizeof others / sizeof others[0]; i++) {
        snprintf(path, TAUT_PATH_ROOM, "%s/%s", others[i], name);
        if (is_program(path)) {
            return 1;
        }
    }
    return 0;
}

/* ---- reading ---- */

/* What the system says of a source that is open. */
static int look_at(taut_source *source)
{
    struct stat about;
    if (fstat(source->file, &about) != 0) {
        return errno;
    }
    source->size = S_ISREG(about.st_mode) ? (double)about.st_size : -1;
    return S_ISDIR(about.st_mode) ? EISDIR : 0;
}

void taut_system_close(taut_source *source)
{
    if (source->file != STDIN_FILENO) {
        close(source->file);
    }
}

taut_place taut_system_place_of(const char *path)
{
    struct stat about;
    if (stat(path, &about) != 0) {
        return TAUT_PLACE_NONE;
    }
    return S_ISREG(about.st_mode)   ? TAUT_PLACE_FILE
           : S_ISDIR(about.st_mode) ? TAUT_PLACE_FOLDER
                                    : TAUT_PLACE_OTHER;
}

int taut_system_open(const char *path, taut_source *source)
{
    const int is_standard = strcmp(path, "-") == 0;
    int reason = 0;

    source->file = is_standard ? STDIN_FILENO : open(path, O_RDONLY | O_CLOEXEC | O_NOCTTY);
    if (source->file < 0) {
        return errno;
    }
    reason = look_at(source);
    if (reason != 0) {
        taut_system_close(source);
    }
    return reason;
}

int taut_system_read(taut_source *source, char *to, size_t room, size_t *count)
{
    ssize_t got = -1;

    do {
        got = read(source->file, to, room);
    } while (got < 0 && errno == EINTR);
    *count = got > 0 ? (size_t)got : 0;
    return got < 0 ? errno : 0;
}

/* ---- what is there ---- */

static int is_standard_output(const char *path)
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

/* Follows the links of the last part, also one that leads nowhere yet. */
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

/* Spells the folder in full, so that two names of one file are told to be one. */
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
static int check_file(const char *target, taut_place place)
{
    if (place == TAUT_PLACE_FOLDER) {
        return EISDIR;
    }
    return faccessat(AT_FDCWD, target, W_OK, AT_EACCESS) == 0 ? 0 : errno;
}

int taut_system_target(const char *path, taut_target_kind *kind, char target[TAUT_PATH_ROOM])
{
    taut_place place = TAUT_PLACE_NONE;
    int reason = 0;

    if (is_standard_output(path)) {
        *kind = TAUT_TARGET_STANDARD;
        target[0] = '\0';
        return 0;
    }
    if (path[0] == '\0' || strlen(path) >= TAUT_PATH_ROOM) {
        return path[0] == '\0' ? ENOENT : ENAMETOOLONG;
    }
    memcpy(target, path, strlen(path) + 1);
    place = taut_system_place_of(path);
    if (strncmp(path, "/dev/fd/", 8) == 0 || strncmp(path, "/proc/", 6) == 0 ||
        strcmp(path, "/dev/stderr") == 0 || place == TAUT_PLACE_OTHER) {
        *kind = TAUT_TARGET_DEVICE;
        return 0;
    }
    *kind = TAUT_TARGET_FILE;
    reason = follow_links(target);
    if (reason == 0) {
        reason = spell_folder(target);
    }
    if (reason == 0 && place != TAUT_PLACE_NONE) {
        reason = check_file(target, place);
    }
    return reason;
}

/* ---- writing ---- */

/* A name in the same folder that nobody can guess: ".taut-" and 16 hexadecimal digits. */
static int name_temporary(char *temporary)
{
    static const char hex[] = "0123456789abcdef";
    char *name = strrchr(temporary, '/') + 1; /* the target is spelled in full */
    unsigned char random[8];

    if (!own_random(random, sizeof random)) {
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
    slash[1] = '\0';
    const int file = own_open_nameless(temporary);
    slash[1] = first;
    return file;
}

/* A new file named `temporary`. Returns it, or -1 with *reason set. */
static int open_named(taut_new_file *made, int *reason)
{
    int file = -1;
    *reason = EEXIST;
    for (int i = 0; i < TRIES && file < 0 && *reason == EEXIST; i++) {
        *reason = name_temporary(made->temporary);
        if (*reason == 0) {
            made->pending = 1; /* first, so that a signal never finds a file not known */
            file = open(made->temporary, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
            *reason = file < 0 ? errno : 0;
            made->pending = file >= 0;
        }
    }
    return file;
}

int taut_system_create(taut_new_file *made)
{
    int reason = 0;
    int file = open_nameless(made->temporary);
    /* kept open past the stream, as without a name nothing else holds the file */
    const int kept = file >= 0 ? fcntl(file, F_DUPFD_CLOEXEC, 3) : -1;

    if (kept >= 0) {
        made->nameless = kept;
    } else {
        if (file >= 0) {
            close(file);
        }
        file = open_named(made, &reason);
    }
    if (file < 0) {
        return reason;
    }
    take_mode(file, made->target);
    made->stream = fdopen(file, "wb");
    if (made->stream == NULL) {
        close(file);
        taut_system_discard(made);
        return ENOMEM;
    }
    return 0;
}

const char *taut_system_own_path(const taut_new_file *file, char own[TAUT_OWN_ROOM])
{
    if (file->nameless <= 0) {
        return file->temporary;
    }
    snprintf(own, TAUT_OWN_ROOM, "/proc/self/fd/%d", file->nameless);
    return own;
}

/* Names the file that has none `temporary`. */
static int give_name(taut_new_file *file)
{
    char room[TAUT_OWN_ROOM];
    const char *own = taut_system_own_path(file, room);
    int reason = EEXIST;
    for (int i = 0; i < TRIES && reason == EEXIST; i++) {
        reason = name_temporary(file->temporary);
        if (reason == 0) {
            file->pending = 1;
            reason = linkat(AT_FDCWD, own, AT_FDCWD, file->temporary, AT_SYMLINK_FOLLOW) == 0
                         ? 0
                         : errno;
            file->pending = reason == 0;
        }
    }
    return reason;
}

int taut_system_place(taut_new_file *file)
{
    int reason = file->nameless > 0 ? give_name(file) : 0;
    if (reason == 0) {
        reason = rename(file->temporary, file->target) == 0 ? 0 : errno;
        file->pending = reason != 0;
    }
    return reason;
}

void taut_system_discard(taut_new_file *file)
{
    if (file->stream != NULL) {
        fclose(file->stream);
        file->stream = NULL;
    }
    if (file->nameless > 0) {
        close(file->nameless);
        file->nameless = 0;
    }
    if (file->pending) {
        unlink(file->temporary);
        file->pending = 0;
    }
}

void taut_system_remove(const taut_new_file *file)
{
    if (file->pending) {
        unlink(file->temporary);
    }
}

int taut_system_open_device(const char *target, FILE **stream)
{
    const int file = open(target, O_WRONLY | O_APPEND | O_CLOEXEC | O_NOCTTY);
    int reason = 0;

    *stream = file >= 0 ? fdopen(file, "wb") : NULL;
    if (*stream == NULL) {
        reason = errno;
        if (file >= 0) {
            close(file);
        }
    }
    return reason;
}

int taut_system_open_growing(const char *path, FILE **stream)
{
    const int file = open(path, O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    struct stat about;
    int reason = 0;
    if (file < 0 || fstat(file, &about) != 0) {
        reason = errno;
    } else if (!S_ISREG(about.st_mode)) {
        reason = S_ISDIR(about.st_mode) ? EISDIR : EINVAL;
    } else {
        *stream = fdopen(file, "r+");
        reason = *stream != NULL ? 0 : ENOMEM;
    }
    if (reason != 0 && file >= 0) {
        close(file);
    }
    return reason;
}

int taut_system_cut(FILE *stream, double length)
{
    if (fflush(stream) != 0 || ftruncate(fileno(stream), (off_t)length) != 0 ||
        fseeko(stream, 0, SEEK_END) != 0) {
        return errno;
    }
    return 0;
}

FILE *taut_system_spool(char **text, size_t *length)
{
    return own_memory_stream(text, length);
}

int taut_system_spooled(FILE *spool, char **text, size_t *length)
{
    (void)text;
    (void)length;
    return fclose(spool);
}

/* ---- the program ---- */

/* What is freed stays with the process, which soon takes it again: a proof takes and frees megabytes for each span, and pages that
 * are given back to the system are faulted in anew. */
static void keep_memory(void)
{
#if defined(__GLIBC__)
    mallopt(M_MMAP_THRESHOLD, 32 << 20); /* 32 MB: the most that it knows */
    mallopt(M_TRIM_THRESHOLD, 256 << 20);
#endif
}

int taut_system_begin(int *count, char ***words)
{
    (void)count;
    (void)words;
    keep_memory();
    signal(SIGPIPE, SIG_IGN); /* a closed pipe is a write error, told once, */
    signal(SIGXFSZ, SIG_IGN); /* and so is a file that grows past its limit */
    return 0;
}

int taut_system_is_terminal(taut_standard stream)
{
    return isatty((int)stream);
}

static const char *notice; /* what the alarm says */

static void ring(int number)
{
    const ssize_t done = write(STDERR_FILENO, notice, strlen(notice));
    (void)done; /* there is nobody else to tell */
    (void)number;
}

void taut_system_pause(double seconds)
{
    const struct timespec span = {.tv_sec = (time_t)seconds,
                                  .tv_nsec = (int)(1e9 * (seconds - floor(seconds)))};
    nanosleep(&span, NULL);
}

void taut_system_alarm(int seconds, const char *text)
{
    const struct itimerval once = {{0, 0}, {seconds, 0}};
    struct sigaction action;
    notice = text;
    memset(&action, 0, sizeof action);
    action.sa_handler = ring;
    action.sa_flags = SA_RESTART; /* reading and writing go on */
    sigaction(SIGPROF, &action, NULL);
    setitimer(ITIMER_PROF, &once, NULL);
}

void taut_system_say(const char *text)
{
    (void)!write(STDERR_FILENO, text, strlen(text));
}

static void (*volatile tidy_up)(int code);

static void interrupted(int number)
{
    tidy_up(128 + number);
    _exit(128 + number); /* 130 for an interrupt */
}

void taut_system_on_interrupt(void (*tidy)(int code))
{
    const int signals[] = {SIGINT, SIGTERM, SIGHUP};
    tidy_up = tidy;
    for (size_t i = 0; i < sizeof signals / sizeof signals[0]; i++) {
        struct sigaction action, before;
        memset(&action, 0, sizeof action);
        action.sa_handler = interrupted;
        if (sigaction(signals[i], NULL, &before) == 0 && signals[i] == SIGHUP &&
            before.sa_handler == SIG_IGN) {
            continue; /* nohup: whoever started us wants us to outlive the terminal */
        }
        sigaction(signals[i], &action, NULL);
    }
}
