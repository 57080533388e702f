/* in.c -- a whole file into memory, in as few reads as the system allows. */
#include "io/file/in.h"

#include "core/fail.h"
#include "core/memory.h"
#include "platform/system.h"
#include "taut/limits.h"

#include <string.h>

enum { FIRST_ROOM = 1 << 16 }; /* bytes taken at first where the size is not known */

/* What is printed to a terminal holds no control characters; the end of a long path says more than
 * its beginning. */
static void show_path(const char *path, char *shown, size_t size)
{
    const size_t length = strlen(path);
    const size_t skip = length >= size ? length - size + 4 : 0;
    size_t n = 0;
    if (skip > 0) {
        memcpy(shown, "...", 3);
        n = 3;
    }
    for (const char *from = path + skip; *from != '\0'; from++) {
        const unsigned char byte = (unsigned char)*from;
        shown[n++] = byte < 0x20 || byte == 0x7f ? '?' : *from;
    }
    shown[n] = '\0';
}

taut_status taut_fail_file(taut_error *error, const char *path, const char *reason, int number)
{
    char shown[160], text[96];
    show_path(strcmp(path, "-") == 0 ? "standard input or output" : path, shown, sizeof shown);
    return taut_fail(error, TAUT_IO, reason, NULL, taut_none, taut_none, "cannot %s %s: %s", reason,
                     shown, taut_system_reason(number, text, sizeof text));
}

static taut_status refuse_size(const char *path, double size, taut_error *error)
{
    char shown[160];
    show_path(path, shown, sizeof shown);
    return taut_fail(error, TAUT_IO, "large", NULL, size, TAUT_FILE_MAX,
                     "%s is larger than the %.0f bytes that a document may have", shown,
                     TAUT_FILE_MAX);
}

/* No format that is read begins as files of gzip do. */
static taut_status refuse_packed(const char *path, const char *text, size_t length,
                                 taut_error *error)
{
    char shown[160];
    if (length < 2 || memcmp(text, "\x1f\x8b", 2) != 0) {
        return TAUT_OK;
    }
    show_path(strcmp(path, "-") == 0 ? "standard input" : path, shown, sizeof shown);
    return taut_fail(error, TAUT_IO, "packed", NULL, taut_none, taut_none,
                     "%s is packed by gzip: unpack it first", shown);
}

/* All bytes up to the end, into a block that doubles. One byte more than the file says it has is
 * asked for, so that its end is seen without growing. */
static taut_status read_all(taut_source *source, const char *path, size_t room, char **text,
                            size_t *length, taut_error *error)
{
    taut_status status = TAUT_OK;
    char *block = taut_alloc(room, 1);
    size_t filled = 0;
    size_t got = 1;

    if (block == NULL) {
        return taut_fail_memory(error);
    }
    while (status == TAUT_OK && got != 0) {
        if (filled == room) {
            char *larger = taut_realloc(block, 2, room);
            status = larger != NULL ? TAUT_OK : taut_fail_memory(error);
            block = larger != NULL ? larger : block;
            room *= larger != NULL ? 2 : 1;
        } else {
            const int reason = taut_system_read(source, block + filled, room - filled, &got);
            if (reason != 0) {
                status = taut_fail_file(error, path, "read", reason);
            }
            filled += got;
            if (status == TAUT_OK && (double)filled > TAUT_FILE_MAX) {
                /* not reached: an endless file fills 4 GB of memory before it is too large */
                status = refuse_size(path, (double)filled, error);
            }
        }
    }
    if (status == TAUT_OK) {
        status = refuse_packed(path, block, filled, error);
    }
    if (status != TAUT_OK) {
        taut_free(block);
        return status;
    }
    block[filled] = '\0'; /* there is room: the end is only seen where some is left */
    *text = block;
    *length = filled;
    return TAUT_OK;
}

static taut_status read_open(taut_source *source, const char *path, char **text, size_t *length,
                             taut_error *error)
{
    if (source->size > TAUT_FILE_MAX) {
        return refuse_size(path, source->size, error);
    }
    const size_t room = source->size > 0 ? (size_t)source->size + 1 : FIRST_ROOM;
    return read_all(source, path, room, text, length, error);
}

taut_status taut_file_read(const char *path, char **text, size_t *length, taut_error *error)
{
    taut_source source;
    const int reason = taut_system_open(path, &source);

    if (reason != 0) {
        return taut_fail_file(error, path, "read", reason);
    }
    const taut_status status = read_open(&source, path, text, length, error);
    taut_system_close(&source);
    return status;
}
