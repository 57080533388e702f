/* wasi.c -- taut in WebAssembly: one thread, no modules, no files.
 */
#include "platform/system.h"

#include <errno.h>

const char *taut_system_reason(int number, char *text, size_t size)
{
    (void)number;
    (void)text;
    (void)size;
    return "there are no files and no programs here";
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

/* ---- files: there are none; documents come and go as texts ---- */

int taut_system_open(const char *path, taut_source *source)
{
    (void)path;
    source->file = -1;
    return ENOSYS;
}

void taut_system_close(taut_source *source)
{
    (void)source;
}

int taut_system_read(taut_source *source, char *to, size_t room, size_t *count)
{
    (void)source;
    (void)to;
    (void)room;
    *count = 0;
    return ENOSYS;
}

taut_place taut_system_place_of(const char *path)
{
    (void)path;
    return TAUT_PLACE_NONE;
}

int taut_system_target(const char *path, taut_target_kind *kind, char target[TAUT_PATH_ROOM])
{
    (void)path;
    *kind = TAUT_TARGET_FILE;
    target[0] = '\0';
    return ENOSYS;
}

int taut_system_create(taut_new_file *made)
{
    made->pending = 0;
    made->stream = NULL;
    return ENOSYS;
}

const char *taut_system_own_path(const taut_new_file *file, char own[TAUT_OWN_ROOM])
{
    (void)own;
    return file->temporary;
}

int taut_system_place(taut_new_file *file)
{
    (void)file;
    return ENOSYS;
}

void taut_system_discard(taut_new_file *file)
{
    (void)file;
}

void taut_system_remove(const taut_new_file *file)
{
    (void)file;
}

int taut_system_open_device(const char *target, FILE **stream)
{
    (void)target;
    *stream = NULL;
    return ENOSYS;
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
