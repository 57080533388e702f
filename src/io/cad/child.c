#include "io/cad/child.h"

#include "core/fail.h"
#include "platform/module.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

static const char package[] = "libocct-data-exchange-dev";

/* Beyond what the process has already: a library of its size, and what a file may be blown up to.
 */
static const double memory_base = 1e9, memory_per_byte = 400;
static const double seconds_base = 20, seconds_per_byte = 2e-5;

#if defined(__SANITIZE_ADDRESS__)
enum { HAS_SHADOW = 1 };
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
enum { HAS_SHADOW = 1 };
#else
enum { HAS_SHADOW = 0 };
#endif
#else
enum { HAS_SHADOW = 0 };
#endif

/* Bytes of address space in use. */
static double space_in_use(void)
{
    unsigned long pages = 0;
    int found = 0;
    FILE *file = fopen("/proc/self/statm", "r");
    if (file != NULL) {
        found = fscanf(file, "%lu", &pages);
        fclose(file);
    }
    return found == 1 ? (double)pages * (double)sysconf(_SC_PAGESIZE) : 0;
}

static void limit(int resource, double value)
{
    struct rlimit now;
    if (getrlimit(resource, &now) == 0 &&
        (now.rlim_max == RLIM_INFINITY || value < (double)now.rlim_max)) {
        now.rlim_cur = now.rlim_max = (rlim_t)value;
        setrlimit(resource, &now);
    }
}

/* How far a file may drive the child. An address sanitizer's shadow takes terabytes of its own. */
static void set_limits(const char *path)
{
    struct stat about;
    const double size = stat(path, &about) == 0 ? (double)about.st_size : 0;
    limit(RLIMIT_CORE, 0);
    limit(RLIMIT_CPU, seconds_base + seconds_per_byte * size);
    if (!HAS_SHADOW) {
        limit(RLIMIT_AS, space_in_use() + memory_base + memory_per_byte * size);
    }
}

/* Signals as they are by default; nothing to read from, and nowhere to print. */
static void settle(void)
{
    static const int signals[] = {SIGINT,  SIGTERM, SIGHUP, SIGSEGV,
                                  SIGABRT, SIGFPE,  SIGBUS, SIGILL};
    const int nowhere = open("/dev/null", O_RDWR);
    for (size_t i = 0; i < sizeof signals / sizeof signals[0]; i++) {
        signal(signals[i], SIG_DFL);
    }
    signal(SIGPIPE, SIG_IGN); /* the parent may stop listening */
    for (int standard = 0; standard < 3; standard++) {
        dup2(nowhere, standard);
    }
}

/* The child's whole life. */
static void work(int pipe_end, const taut_cad_job *job, int count, const taut_cad_item *items)
{
    taut_error error = {.status = TAUT_OK};
    const void *table = NULL;
    FILE *file = NULL;
    taut_status status = TAUT_OK;

    settle();
    file = fdopen(pipe_end, "wb");
    if (file == NULL) {
        _exit(1);
    }
    status = taut_module_load("occt", package, &table, &error);
    if (items == NULL) {
        set_limits(job->path);
    }
    if (status == TAUT_OK) {
        const taut_cad_ops *ops = table;
        const taut_cad_sink sink = {file, taut_cad_put_unit, taut_cad_put_item};
        status =
            items != NULL ? ops->write(job, count, items, &error) : ops->read(job, &sink, &error);
    }
    _exit(taut_cad_put_end(file, status, &error) ? 0 : 1);
}

/* How the child ended; -1 where nobody knows. */
static int wait_for(pid_t child)
{
    int how = 0;
    pid_t found = 0;
    do {
        found = waitpid(child, &how, 0);
    } while (found < 0 && errno == EINTR);
    return found == child ? how : -1;
}

static taut_status died(int how, int is_reading, taut_error *error)
{
    const taut_status status = is_reading ? TAUT_BAD_INPUT : TAUT_INTERNAL;
    const int number = how >= 0 && WIFSIGNALED(how) ? WTERMSIG(how) : 0;
    if (number == SIGXCPU || number == SIGKILL) {
        return taut_fail(error, status, "value", NULL, taut_none, taut_none,
                         "OpenCASCADE was stopped: the %s takes more time than its size explains",
                         is_reading ? "file" : "model");
    }
    if (number == SIGINT || number == SIGTERM || number == SIGHUP) {
        return taut_fail(error, TAUT_INTERRUPTED, "interrupted", NULL, taut_none, taut_none,
                         "stopped on request");
    }
    if (number == 0) {
        return taut_fail(error, status, "value", NULL, taut_none, taut_none,
                         "OpenCASCADE gave up on the %s without a word",
                         is_reading ? "file" : "model");
    }
    return taut_fail(error, status, "value", NULL, number, taut_none,
                     "OpenCASCADE broke down over the %s (signal %d)",
                     is_reading ? "file" : "model", number);
}

/* The child had the memory that a file of this size may take. */
static taut_status refuse_claim(taut_error *error)
{
    return taut_fail(error, TAUT_BAD_INPUT, "value", NULL, taut_none, taut_none,
                     "the file claims to hold more than its size explains");
}

/* The system gave no pipe or no process: too many of them are in use. */
static taut_status refuse_start(int reason, taut_error *error)
{
    char text[96];
    if (reason == ENOMEM) {
        return taut_fail_memory(error);
    }
    return taut_fail(error, TAUT_IO, "file", NULL, taut_none, taut_none,
                     "OpenCASCADE cannot be started in a process of its own: %s",
                     strerror_r(reason, text, sizeof text) == 0 ? text : "unknown reason");
}

taut_status taut_cad_run(const taut_cad_job *job, int count, const taut_cad_item *items,
                         taut_cad_result *result, taut_error *error)
{
    int ends[2], how = 0;
    FILE *file = NULL;
    pid_t child = 0;
    taut_status status = TAUT_OK;

    if (pipe(ends) != 0) {
        return refuse_start(errno, error);
    }
    child = fork();
    if (child == 0) {
        close(ends[0]);
        work(ends[1], job, count, items);
    }
    if (child < 0) {
        status = refuse_start(errno, error);
    }
    close(ends[1]);
    file = child > 0 ? fdopen(ends[0], "rb") : NULL;
    if (file == NULL) {
        close(ends[0]);
        status = status != TAUT_OK ? status : taut_fail_memory(error);
    } else {
        status = taut_cad_get_all(file, result, error);
        fclose(file);
    }
    if (child > 0) {
        how = wait_for(child);
    }
    if (status == TAUT_OK) {
        status = result->has_ended ? result->status : died(how, items == NULL, error);
        status = status == TAUT_NO_MEMORY && items == NULL ? refuse_claim(error) : status;
    }
    return status;
}
