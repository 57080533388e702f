/* monitor.c -- for a person who waits: on a terminal a progress line, after one second, ten times a
 * second; everywhere one line, after five seconds of work, that it may be long. */
#include "cli/cli.h"
#include "platform/system.h"

#include <math.h>
#include <stdio.h>

enum { PATIENCE = 5 }; /* seconds of processor time: a busy machine is no news of ours */

static char notice[160]; /* what the alarm says; written before it is set */

static double started, shown; /* seconds; shown 0: no line is on the screen */

double cli_seconds(void)
{
    return taut_system_seconds();
}

static int show(void *context, double done, const char *what)
{
    const double now = cli_seconds();
    (void)context;
    if (now - started > 1 && now - shown > 0.1) {
        shown = now;
        if (isfinite(done)) {
            fprintf(stderr, "\r\033[K%s  %3.0f %%", what, 100 * done);
        } else {
            fprintf(stderr, "\r\033[K%s  %.0f s", what, now - started);
        }
        fflush(stderr);
    }
    return 0;
}

taut_monitor cli_monitor(int quiet)
{
    taut_monitor monitor = {NULL, NULL};
    started = cli_seconds();
    if (!quiet && taut_system_is_terminal(TAUT_STANDARD_ERROR)) {
        monitor.progress = show;
    }
    return monitor;
}

void cli_announce(const char *command)
{
    snprintf(notice, sizeof notice,
             "%staut: `taut %s` has worked for %d s and may work for minutes: Ctrl-C stops it, and "
             "leaves nothing behind\n",
             taut_system_is_terminal(TAUT_STANDARD_ERROR) ? "\r\033[K" : "", command,
             (int)PATIENCE);
    taut_system_alarm(PATIENCE, notice);
}

void cli_monitor_done(void)
{
    if (shown > 0) {
        fputs("\r\033[K", stderr);
        shown = 0;
    }
}
