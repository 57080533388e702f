/* system.h -- all that taut asks of an operating system: nothing else in the library does. One file
 * for each: posix.c, wasi.c.
 *
 * Functions that return a reason return a number of errno.h, 0 where all went well. Paths are as the
 * user wrote them unless they are said to be spelled in full. A stream and a descriptor that are
 * opened here stay with this process.
 */
#ifndef TAUT_PLATFORM_SYSTEM_H
#define TAUT_PLATFORM_SYSTEM_H

#include <signal.h>
#include <stddef.h>
#include <stdio.h>

enum { TAUT_PATH_ROOM = 4096, TAUT_OWN_ROOM = 32, TAUT_SUFFIX_ROOM = 32 };

/* What a number of errno.h means, in `text`. */
const char *taut_system_reason(int number, char *text, size_t size);

/* ---- threads and modules ---- */

/* Calls run(context, 0 .. count-1), each on a thread of its own, part 0 on this one; a part whose
 * thread the system does not grant is done here. Returns when all are done. count is at most
 * TAUT_THREADS_MAX. */
void taut_system_threads(int count, void (*run)(void *context, int part), void *context);

/* The symbol `taut_module_table` of the module `taut-<name>` (platform/module.h), which stays loaded;
 * NULL where there is none. */
const void *taut_system_module(const char *name);

/* ---- paths and numbers ---- */

/* What stands after the last separator of folders: a part of `path`. */
const char *taut_system_last_part(const char *path);
/* Does the path begin at a root, so that no folder can go before it? */
int taut_system_is_rooted(const char *path);

/* A place for the "C" locale, made when it is first needed. Zero-initialise. */
typedef struct taut_plain_locale {
    void *made;
} taut_plain_locale;
/* strtod in the "C" locale. 0: no memory. `text` may be written to and is as it was afterwards. */
int taut_system_number(char *text, taut_plain_locale *plain, double *value);
void taut_plain_locale_free(taut_plain_locale *plain);

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
/* Closes it: *text, malloc's, is there. EOF, with errno: it could not be kept. */
int taut_system_spooled(FILE *spool, char **text, size_t *length);

/* A file that grows in place, open for reading from its begin and for writing, made where there is none; EISDIR, and EINVAL
 * where it is no regular file. */
int taut_system_open_growing(const char *path, FILE **stream);
/* Cuts it after so many bytes, and goes to its end. */
int taut_system_cut(FILE *stream, double length);

/* ---- the program: nothing of this in wasi.c, where there is none ---- */

/* Once, first of all: words in UTF-8, standard streams that pass bytes on as they are, a write that
 * cannot be done an error and not the end. */
int taut_system_begin(int *count, char ***words);

/* Is this stream a terminal that a person sees, which understands "\r\033[K"? */
typedef enum taut_standard { TAUT_STANDARD_OUTPUT = 1, TAUT_STANDARD_ERROR } taut_standard;
int taut_system_is_terminal(taut_standard stream);

/* A clock that only goes forward, in seconds. */
double taut_system_clock(void);

/* Writes `text`, which stays, on standard error once the process has worked so many seconds: those
 * of the processor, as a busy machine is no news of ours. */
void taut_system_alarm(int seconds, const char *text);

/* From now on an interrupt calls `tidy`, which may do what a signal handler may, and ends the process:
 * status 130. The second and later calls only change `tidy`. */
void taut_system_on_interrupt(void (*tidy)(void));

#endif /* TAUT_PLATFORM_SYSTEM_H */
