/* system.h -- all that taut asks of an operating system: nothing else in the library does. One file
 * for each: posix.c, windows.c, wasi.c; unix.c is what the first and the last share.
 *
 * Functions that return a reason return a number of errno.h, 0 where all went well. Paths are as the
 * user wrote them unless they are said to be spelled in full. A stream and a descriptor that are
 * opened here stay with this process.
 */
#ifndef TAUT_PLATFORM_SYSTEM_H
#define TAUT_PLATFORM_SYSTEM_H

#include <signal.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

enum { TAUT_PATH_ROOM = 4096, TAUT_OWN_ROOM = 32, TAUT_SUFFIX_ROOM = 32 };

/* What a number of errno.h means, in `text`. */
const char *taut_system_reason(int number, char *text, size_t size);

/* Seconds since 1970-01-01T00:00:00 UTC; 0 where no clock says. */
int64_t taut_system_date(void);

/* Seconds of a clock that only goes forward, from anywhere. */
double taut_system_seconds(void);

/* Processors that this process may use, 1 at least. */
int taut_system_processors(void);

/* ---- memory: what core/memory.h stands on ---- */

/* As malloc, calloc, realloc and free; the second at a multiple of 64, which `bytes` is too. */
void *taut_system_take(size_t bytes);
void *taut_system_take_aligned(size_t bytes);
void *taut_system_take_zero(size_t bytes);
void *taut_system_resize(void *block, size_t bytes);
void taut_system_release(void *block);

/* ---- threads and modules ---- */

/* Calls run(context, 0 .. count-1), each on a thread of its own, part 0 on this one; a part whose
 * thread the system does not grant is done here. Returns when all are done. count is at most
 * TAUT_THREADS_MAX. */
void taut_system_threads(int count, void (*run)(void *context, int part), void *context);

/* The symbol `taut_module_table` of the module `taut-<name>` (platform/module.h), which stays loaded;
 * NULL where there is none. */
const void *taut_system_module(const char *name);
/* NULL where modules can be installed; else what is to be said of one: "is not there ...". */
const char *taut_system_lacks_modules(void);

/* ---- paths ---- */

/* What stands after the last separator of folders: a part of `path`. */
const char *taut_system_last_part(const char *path);
/* Does the path begin at a root, so that no folder can go before it? */
int taut_system_is_rooted(const char *path);

/* ---- a helper: a program of ours in a process of its own ---- */

/* Where the helper `name` is: what `variable` of the environment says, where it says anything (and this process has no more
 * rights than its user); else beside the library, in libexec/taut of where the library is installed or was to be,
 * where it was built. It is never looked for in PATH. 0: nowhere. */
int taut_system_helper(const char *name, const char *variable, char path[TAUT_PATH_ROOM]);

/* A new file without a name, to be filled with what the helper is asked; NULL: *reason. fclose it. */
FILE *taut_system_helper_request(int *reason);

typedef struct taut_helper {
    int64_t process, answer; /* as the system numbers them */
    double deadline;         /* on a clock of the system's own */
    double patience; /* seconds that one read waits at most; 0 at first: until the deadline */
} taut_helper;

/* Starts `program`, without arguments: its standard input is `request` from its begin, which has been flushed and
 * may be closed then; its standard error is dropped; it has no other file of this process, no signal blocked and none
 * ignored. `seconds` from now its time is up. */
int taut_system_helper_start(taut_helper *helper, const char *program, FILE *request,
                             double seconds);
/* Reads at most `room` bytes of its standard output: *count, 0 at the end. ETIMEDOUT; EAGAIN: its patience is at an end, not yet
 * its time. */
int taut_system_helper_read(const taut_helper *helper, void *to, size_t room, size_t *count);

typedef enum taut_helper_fate {
    TAUT_HELPER_LEFT,        /* of its own accord: *number is what it returned */
    TAUT_HELPER_BROKE,       /* *number is the signal */
    TAUT_HELPER_OUT_OF_TIME, /* stopped by the limits that it has set itself, or by force */
    TAUT_HELPER_INTERRUPTED, /* by the person at the keyboard */
    TAUT_HELPER_UNKNOWN      /* the rest of this process has seen to it that nobody knows */
} taut_helper_fate;
/* Stops it where it has not ended, and leaves nothing of it. Once for each that was started. */
taut_helper_fate taut_system_helper_end(const taut_helper *helper, int *number);

/* ---- reading ---- */

typedef struct taut_source {
    int file;
    double size; /* bytes that a regular file has; else -1 */
} taut_source;

/* "-" is standard input. A folder is none: EISDIR. */
int taut_system_open(const char *path, taut_source *source);
/* Reads at most `room` bytes: *count, 0 at the end. */
int taut_system_read(taut_source *source, char *to, size_t room, size_t *count);
void taut_system_close(taut_source *source); /* standard input stays open */

/* ---- what is there ---- */

typedef enum taut_target_kind {
    TAUT_TARGET_FILE,
    TAUT_TARGET_DEVICE,
    TAUT_TARGET_STANDARD
} taut_target_kind;

/* What kind of place `path` names, and its full name with links resolved ("" for standard output),
 * so that two names of one file are told to be one. EISDIR, EACCES, ENOENT (the folder) ...: nothing
 * can be written there. */
int taut_system_target(const char *path, taut_target_kind *kind, char target[TAUT_PATH_ROOM]);

/* Do two full names of targets mean one file? */
int taut_system_same_target(const char *a, const char *b);

typedef enum taut_place {
    TAUT_PLACE_NONE,
    TAUT_PLACE_FILE,
    TAUT_PLACE_FOLDER,
    TAUT_PLACE_OTHER
} taut_place;
taut_place taut_system_place_of(const char *path);

/* ---- writing: a new file is whole before it is seen ---- */

typedef struct taut_new_file {
    const char *target;            /* a regular file, there or not, spelled in full */
    char *temporary;               /* the target's name with TAUT_SUFFIX_ROOM bytes of room */
    volatile sig_atomic_t pending; /* nonzero: `temporary` may be there and is to be removed */
    int nameless;                  /* descriptor that keeps a file without a name; 0: none */
    FILE *stream;                  /* while it is written: closed by whoever writes */
} taut_new_file;

/* A new file in the target's folder, without a name where the system has such files (nothing is left
 * of it even when the process is killed); `stream` is open. ENOMEM where there is none for it. */
int taut_system_create(taut_new_file *file);
/* Where somebody else may open the new file: its temporary name, or a path in `own`. */
const char *taut_system_own_path(const taut_new_file *file, char own[TAUT_OWN_ROOM]);
/* Puts the file, closed, in the target's place, with what it allowed whom. */
int taut_system_place(taut_new_file *file);
/* Closes and removes what is not in its place. */
void taut_system_discard(taut_new_file *file);
/* The same in a signal handler, of a file with a name. */
void taut_system_remove(const taut_new_file *file);

/* A stream that appends to a device. */
int taut_system_open_device(const char *target, FILE **stream);

/* A stream that keeps what is written; both calls get the same *text and *length. NULL: no memory. */
FILE *taut_system_spool(char **text, size_t *length);
/* Closes it: *text, ended by a 0 and to be freed as by taut_system_release, is there. EOF, with errno: it could not be kept. */
int taut_system_spooled(FILE *spool, char **text, size_t *length);

/* A file that grows in place, open for reading from its begin and for writing, made where there is none; EISDIR, and EINVAL
 * where it is no regular file. */
int taut_system_open_growing(const char *path, FILE **stream);
/* Cuts it after so many bytes, and goes to its end. */
int taut_system_cut(FILE *stream, double length);

/* ---- the program: nothing of this in wasi.c, where there is none ---- */

/* Once, first of all: words in UTF-8, standard streams that pass bytes on as they are, a write that
 * cannot be done an error and not the end; memory that is freed is kept for what comes, where the C library can. */
int taut_system_begin(int *count, char ***words);

/* Is this stream a terminal that a person sees, which understands "\r\033[K"? */
typedef enum taut_standard { TAUT_STANDARD_OUTPUT = 1, TAUT_STANDARD_ERROR } taut_standard;
int taut_system_is_terminal(taut_standard stream);

/* Sleeps for so many seconds, or until a signal comes. */
void taut_system_pause(double seconds);

/* Writes `text`, which stays, on standard error once the process has worked so many seconds: those
 * of the processor, as a busy machine is no news of ours. */
void taut_system_alarm(int seconds, const char *text);

/* From now on an interrupt calls `tidy`, which may do what a signal handler may, and ends the process: `code`, 130 where a
 * person asked, is its exit status. The second and later calls only change `tidy`. */
void taut_system_on_interrupt(void (*tidy)(int code));
/* On standard error, also in a signal handler. */
void taut_system_say(const char *text);

#endif /* TAUT_PLATFORM_SYSTEM_H */
