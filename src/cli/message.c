/* message.c -- what a person is told when something went wrong: one message, one line. */
#include "cli/cli.h"

#include <ctype.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

/* One line, whatever the names and words in it are: what would move the cursor is a "?". */
static void say(char *line)
{
    for (char *at = line; *at != '\0'; at++) {
        if (iscntrl((unsigned char)*at)) {
            *at = '?';
        }
    }
    fprintf(stderr, "taut: %s\n", line);
}

int cli_fail(const taut_error *error)
{
    char line[sizeof error->where + sizeof error->message + 2];
    cli_monitor_done();
    snprintf(line, sizeof line, "%s%s%s", error->where, error->where[0] != '\0' ? ": " : "",
             error->message[0] != '\0' ? error->message : taut_status_text(error->status));
    say(line);
    return taut_status_exit_code(error->status);
}

int cli_fail_in(const char *file, const taut_error *error)
{
    const char *name = strcmp(file, "-") == 0 ? "standard input" : file;
    const size_t length = strlen(name);
    taut_error placed = *error;
    /* a pointer begins like the name of a file that is absolute */
    const int names_file = strncmp(error->where, name, length) == 0 && error->where[length] == ':';
    if (error->where[0] == '\0' || (error->where[0] == '/' && !names_file)) {
        snprintf(placed.where, sizeof placed.where, "%.100s%s%.80s", name,
                 error->where[0] != '\0' ? ": " : "", error->where);
    }
    return cli_fail(&placed);
}

int cli_misuse(const char *format, ...)
{
    char line[2 * sizeof((taut_error *)0)->message];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(line, sizeof line, format, arguments);
    va_end(arguments);
    say(line);
    return 2;
}

/* Edit distance of two short words (insertions, deletions, changes). */
static int distance(const char *a, const char *b)
{
    enum { LONGEST = 40 };
    int row[LONGEST + 1];
    const int n = (int)strlen(b);
    if (n > LONGEST || strlen(a) > LONGEST) {
        return LONGEST;
    }
    for (int j = 0; j <= n; j++) {
        row[j] = j;
    }
    for (int i = 1; a[i - 1] != '\0'; i++) {
        int corner = row[0];
        row[0] = i;
        for (int j = 1; j <= n; j++) {
            const int change = corner + (a[i - 1] != b[j - 1]);
            const int gap = (row[j] < row[j - 1] ? row[j] : row[j - 1]) + 1;
            corner = row[j];
            row[j] = change < gap ? change : gap;
        }
    }
    return row[n];
}

const char *cli_nearest(const char *word, const char *const *words)
{
    const char *best = NULL;
    int least = (int)strlen(word) / 3 + 1;
    for (; *words != NULL; words++) {
        const int d = distance(word, *words);
        if (d <= least) {
            least = d - 1;
            best = *words;
        }
    }
    return best;
}
