#define _GNU_SOURCE /* posix_own.h, closing by posix_spawn */
#define _DARWIN_C_SOURCE
/* posix_helper.c -- a helper process on POSIX systems, in a host of which nothing is known.
 *
 * It is started by posix_spawn: between fork and exec a process with threads may do next to nothing. All that is opened
 * here closes by itself in other programs that the host starts meanwhile. What the helper is asked is a file, as a
 * pipe that nobody reads would bring the host SIGPIPE; what it answers is a pipe, which is waited at no longer than
 * until the deadline. The host may ignore SIGCHLD, or wait for all of its children: then how the helper ended is
 * not known, and all else goes on.
 */
#include "platform/posix_own.h"
#include "platform/system.h"

#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

enum { STANDARD = 3, WAIT_MAX = 1000000, PAUSES = 500 };

/* A descriptor that is none of the standard three, which a host may have closed: put on itself it would stay closed on exec in
 * some systems. -1 with errno. */
static int above_standard(int file)
{
    if (file < 0 || file >= STANDARD) {
        return file;
    }
    const int moved = fcntl(file, F_DUPFD_CLOEXEC, STANDARD);
    const int reason = errno;
    close(file);
    errno = reason;
    return moved;
}

static int open_without_name(void)
{
    const char *folder = own_getenv("TMPDIR");
    return above_standard(own_open_private(folder != NULL && folder[0] != '\0' ? folder : "/tmp"));
}

FILE *taut_system_helper_request(int *reason)
{
    const int file = open_without_name();
    FILE *stream = file >= 0 ? fdopen(file, "w+b") : NULL;
    *reason = stream == NULL ? errno : 0;
    if (stream == NULL && file >= 0) {
        close(file);
    }
    return stream;
}

static double seconds_now(void)
{
    struct timespec now;
    return clock_gettime(CLOCK_MONOTONIC, &now) == 0
               ? (double)now.tv_sec + 1e-9 * (double)now.tv_nsec
               : 0;
}

static const char nowhere[] = "/dev/null";

/* Its three standard files, and no other of the host's. */
static int set_files(posix_spawn_file_actions_t *files, int request, int answer)
{
    int reason = posix_spawn_file_actions_adddup2(files, request, STDIN_FILENO);
    if (reason == 0) {
        reason = posix_spawn_file_actions_adddup2(files, answer, STDOUT_FILENO);
    }
    if (reason == 0) {
        reason = posix_spawn_file_actions_addopen(files, STDERR_FILENO, nowhere, O_WRONLY, 0);
    }
#if defined(__GLIBC__)
#if __GLIBC_PREREQ(2, 34)
    if (reason == 0) {
        reason = posix_spawn_file_actions_addclosefrom_np(files, STANDARD);
    }
#endif
#endif
    return reason;
}

static int set_signals(posix_spawnattr_t *attributes)
{
    sigset_t none, all;
    sigemptyset(&none);
    sigfillset(&all);
    int reason = posix_spawnattr_setsigmask(attributes, &none);
    if (reason == 0) {
        reason = posix_spawnattr_setsigdefault(attributes, &all);
    }
    return reason == 0 ? posix_spawnattr_setflags(attributes,
                                                  POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF)
                       : reason;
}

static int spawn(const char *program, int request, int answer, pid_t *process)
{
    char *const arguments[] = {(char *)(size_t)program, NULL};
    posix_spawn_file_actions_t files;
    posix_spawnattr_t attributes;

    int reason = posix_spawn_file_actions_init(&files);
    if (reason != 0) {
        return reason;
    }
    reason = posix_spawnattr_init(&attributes);
    if (reason == 0) {
        reason = set_files(&files, request, answer);
        if (reason == 0) {
            reason = set_signals(&attributes);
        }
        if (reason == 0) {
            reason = posix_spawn(process, program, &files, &attributes, arguments, own_environ);
        }
        posix_spawnattr_destroy(&attributes);
    }
    posix_spawn_file_actions_destroy(&files);
    return reason;
}

int taut_system_helper_start(taut_helper *helper, const char *program, FILE *request,
                             double seconds)
{
    int ends[2];
    pid_t process = 0;

    if (fflush(request) != 0 || lseek(fileno(request), 0, SEEK_SET) != 0 || own_pipe(ends) != 0) {
        return errno;
    }
    ends[0] = above_standard(ends[0]);
    int reason = ends[0] < 0 ? errno : 0;
    ends[1] = above_standard(ends[1]);
    reason = ends[1] < 0 && reason == 0 ? errno : reason;
    if (reason == 0) {
        reason = spawn(program, fileno(request), ends[1], &process);
    }
    if (ends[1] >= 0) {
        close(ends[1]);
    }
    if (reason != 0) {
        if (ends[0] >= 0) {
            close(ends[0]);
        }
        return reason;
    }
    *helper = (taut_helper){process, ends[0], seconds_now() + seconds, 0};
    return 0;
}

/* Is there something to read, or the end, before the deadline and its patience is at an end? */
static int wait_for_answer(const taut_helper *helper)
{
    struct pollfd one = {.fd = (int)helper->answer, .events = POLLIN};
    const double asked = seconds_now() + helper->patience;
    const int is_patient = !(helper->patience > 0) || asked >= helper->deadline;
    for (;;) {
        const double left = 1000 * ((is_patient ? helper->deadline : asked) - seconds_now());
        if (!(left > 0)) {
            return is_patient ? ETIMEDOUT : EAGAIN;
        }
        const int ready = poll(&one, 1, left < WAIT_MAX ? (int)left + 1 : WAIT_MAX);
        if (ready > 0) {
            return 0;
        }
        if (ready < 0 && errno != EINTR && errno != EAGAIN) {
            return errno;
        }
    }
}

int taut_system_helper_read(const taut_helper *helper, void *to, size_t room, size_t *count)
{
    *count = 0;
    for (;;) {
        const int reason = wait_for_answer(helper);
        if (reason != 0) {
            return reason;
        }
        const ssize_t got = read((int)helper->answer, to, room);
        if (got >= 0) {
            *count = (size_t)got;
            return 0;
        }
        if (errno != EINTR) {
            return errno;
        }
    }
}

/* Has it ended within a moment? It is on its way out when its answer is whole. -1: it is no child of this process any
 * more, and its number may be another's. */
static int ends_soon(pid_t process)
{
    const struct timespec pause = {0, 200000};
    siginfo_t about = {.si_pid = 0};
    for (int i = 0; i < PAUSES; i++) {
        if (waitid(P_PID, (id_t)process, &about, WEXITED | WNOHANG | WNOWAIT) != 0) {
            return -1;
        }
        if (about.si_pid != 0) {
            return 1;
        }
        nanosleep(&pause, NULL);
    }
    return 0;
}

/* How it ended, after it was made to; -1 where nobody knows. */
static int wait_for_end(pid_t process)
{
    int how = 0;
    pid_t found = 0;
    const int has_ended = ends_soon(process);
    if (has_ended < 0) {
        return -1;
    }
    if (!has_ended) {
        kill(process, SIGKILL);
    }
    do {
        found = waitpid(process, &how, 0);
    } while (found < 0 && errno == EINTR);
    return found == process ? how : -1;
}

taut_helper_fate taut_system_helper_end(const taut_helper *helper, int *number)
{
    close((int)helper->answer);
    const int how = wait_for_end((pid_t)helper->process);
    *number = how < 0 ? 0 : WIFSIGNALED(how) ? WTERMSIG(how) : WEXITSTATUS(how);
    if (how < 0) {
        return TAUT_HELPER_UNKNOWN;
    }
    if (!WIFSIGNALED(how)) {
        return TAUT_HELPER_LEFT;
    }
    switch (*number) {
    case SIGXCPU:
    case SIGKILL:
        return TAUT_HELPER_OUT_OF_TIME;
    case SIGINT:
    case SIGTERM:
    case SIGHUP:
        return TAUT_HELPER_INTERRUPTED;
    default:
        return TAUT_HELPER_BROKE;
    }
}
