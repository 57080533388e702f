/* monitor.c -- a progress line for a person who waits: on a terminal, after one second, ten times a
 * second. A pipe sees none. */
#include "cli.h"

#include <math.h>
#include <stdio.h>
#include <time.h>
#include <unistd.h>

static double started, shown; /* seconds; shown 0: no line is on the screen */

double cli_seconds(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
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
    if (!quiet && isatty(STDERR_FILENO)) {
        monitor.progress = show;
    }
    return monitor;
}

void cli_monitor_done(void)
{
    if (shown > 0) {
        fputs("\r\033[K", stderr);
        shown = 0;
    }
}
