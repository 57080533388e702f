/* monitor.c -- for a person who waits: on a terminal a progress line, after one second, ten times a
 * second; everywhere one line, after five seconds of work, that it may be long. */
#include "cli/cli.h"

#include <math.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <sys/time.h>
#include <time.h>
#include <unistd.h>

enum { PATIENCE = 5 }; /* seconds of processor time: a busy machine is no news of ours */

static char notice[160]; /* what the alarm says; written before it is set */

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

static void ring(int number)
{
    ssize_t done = write(STDERR_FILENO, notice, strlen(notice));
    (void)done; /* there is nobody else to tell */
    (void)number;
}

void cli_announce(const char *command)
{
    const struct itimerval once = {{0, 0}, {PATIENCE, 0}};
    struct sigaction action;
    snprintf(notice, sizeof notice,
             "%staut: `taut %s` has worked for %d s and may work for minutes: Ctrl-C stops it, and "
             "leaves nothing behind\n",
             isatty(STDERR_FILENO) ? "\r\033[K" : "", command, (int)PATIENCE);
    memset(&action, 0, sizeof action);
    action.sa_handler = ring;
    action.sa_flags = SA_RESTART; /* reading and writing go on */
    sigaction(SIGPROF, &action, NULL);
    setitimer(ITIMER_PROF, &once, NULL);
}

void cli_monitor_done(void)
{
    if (shown > 0) {
        fputs("\r\033[K", stderr);
        shown = 0;
    }
}
