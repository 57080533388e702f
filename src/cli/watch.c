/* watch.c -- taut make --watch: the problem is made again whenever its file is saved.
 *
 *     look at the bytes of the file until they differ from those made last
 *     and were the same at two looks: an editor is done with them
 *     make; say what happened; begin again
 *
 * Bytes are compared and not times, which file systems keep to the second or not at all. */
#include "cli/make.h"

#include "cli/cli.h"
#include "platform/system.h"

#include <stdint.h>
#include <stdio.h>

static const double step = 0.1; /* seconds between two looks: a person does not notice */

/* FNV-1a over the bytes; 0 where there is no such file, as while an editor renames. */
static uint64_t fingerprint(const char *path)
{
    char room[1 << 14];
    taut_source source;
    uint64_t hash = 0xcbf29ce484222325u;
    size_t count = 0;

    if (taut_system_open(path, &source) != 0) {
        return 0;
    }
    while (taut_system_read(&source, room, sizeof room, &count) == 0 && count > 0) {
        for (size_t i = 0; i < count; i++) {
            hash = (hash ^ (unsigned char)room[i]) * 0x100000001b3u;
        }
    }
    taut_system_close(&source);
    return hash != 0 ? hash : 1;
}

/* The bytes that differ from `made` and have settled. */
static uint64_t wait_for_change(const char *path, uint64_t made)
{
    uint64_t before = made;
    for (;;) {
        const uint64_t now = fingerprint(path);
        if (now != 0 && now != made && now == before) {
            return now;
        }
        before = now;
        taut_system_pause(step);
    }
}

int cli_watch(const cli_options *options, int (*make)(const cli_options *options))
{
    const char *path = options->files[0];
    uint64_t made = fingerprint(path);
    int code = make(options);

    cli_catch_signals();
    while (code != 5 && code != 2 && code != 6) { /* else saving the file will not help */
        if (!options->quiet && !options->json) {
            fprintf(stderr, "taut: watching %s: it is made again when it is saved; Ctrl-C ends\n",
                    path);
        }
        made = wait_for_change(path, made);
        code = make(options);
    }
    return code;
}
