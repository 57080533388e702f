/* helper.c -- one request, one process, one answer.
 *
 *     find taut-cad; write the request to a file without a name
 *     start it; read who it is, then what it found, as it comes
 *     end it, whatever it is doing; how it ended says the rest
 */
#include "io/cad/helper.h"

#include "core/fail.h"
#include "core/pulse.h"
#include "platform/module.h"
#include "platform/system.h"

#include <errno.h>

static const char package[] = "libocct-data-exchange-dev";

/* Where a machine is busy with other things, seconds on the clock are more than those of its processor. */
static const double clock_factor = 10;

/* Seconds on the clock in which it must say who it is: the system loads its libraries in that time. */
static const double greeting_seconds = 20;

/* What was in vain and whose fault it is, for all that is refused here. */
typedef struct attempt {
    const char *program;
    int is_reading;
    double seconds;
    int is_late; /* the time was up */
    taut_pulse pulse;
} attempt;

static const char *blamed(const attempt *a)
{
    return a->is_reading ? "file" : "model";
}

/* The system gave no file, no pipe or no process: too many of them are in use. */
static taut_status refuse_start(int reason, taut_error *error)
{
    char text[96];
    if (reason == ENOMEM) {
        return taut_fail_memory(error);
    }
    return taut_fail(error, TAUT_IO, "process", NULL, taut_none, taut_none,
                     "OpenCASCADE cannot be started in a process of its own: %s",
                     taut_system_reason(reason, text, sizeof text));
}

/* What is found under its name cannot be started. */
static taut_status refuse_program(const attempt *a, int reason, taut_error *error)
{
    char text[96];
    return taut_fail(error, TAUT_IO, "helper", NULL, taut_none, taut_none,
                     "%.300s cannot be started as taut-cad: %s", a->program,
                     taut_system_reason(reason, text, sizeof text));
}

static int is_about_program(int reason)
{
    return reason == ENOENT || reason == EACCES || reason == ENOEXEC || reason == ENOTDIR ||
           reason == ELOOP || reason == ENAMETOOLONG || reason == EISDIR;
}

static taut_status refuse_greeting(const attempt *a, taut_cad_greeting greeting,
                                   const taut_cad_hello *hello, taut_error *error)
{
    const taut_cad_hello own = taut_cad_hello_answer();
    if (greeting == TAUT_CAD_OTHER_VERSION && hello->version != own.version) {
        return taut_fail(error, TAUT_IO, "helper", NULL, hello->version, own.version,
                         "%.300s is the taut-cad of another version of taut: it speaks version %u, "
                         "expected %u",
                         a->program, hello->version, own.version);
    }
    if (greeting == TAUT_CAD_OTHER_VERSION) {
        return taut_fail(
            error, TAUT_IO, "helper", NULL, hello->layout, own.layout,
            "%.300s is a taut-cad for another processor or of another compiler: it lays "
            "numbers out as %u, expected %u",
            a->program, hello->layout, own.layout);
    }
    return taut_fail(error, TAUT_IO, "helper", NULL, taut_none, taut_none,
                     "%.300s is no taut-cad: it does not answer as one", a->program);
}

static taut_status refuse_time(const attempt *a, taut_error *error)
{
    return taut_fail(error, a->is_reading ? TAUT_BAD_INPUT : TAUT_INTERNAL, "library", NULL,
                     taut_none, taut_none,
                     "OpenCASCADE was stopped: the %s takes more time than its size explains",
                     blamed(a));
}

/* It ended before its work did. */
static taut_status refuse_death(const attempt *a, taut_helper_fate fate, int number,
                                taut_error *error)
{
    const taut_status status = a->is_reading ? TAUT_BAD_INPUT : TAUT_INTERNAL;
    switch (fate) {
    case TAUT_HELPER_OUT_OF_TIME:
        return refuse_time(a, error);
    case TAUT_HELPER_INTERRUPTED:
        return taut_fail(error, TAUT_INTERRUPTED, "interrupted", NULL, taut_none, taut_none,
                         "stopped on request");
    case TAUT_HELPER_BROKE:
        return taut_fail(error, status, "library", NULL, number, taut_none,
                         "OpenCASCADE broke down over the %s (signal %d)", blamed(a), number);
    case TAUT_HELPER_LEFT:
    case TAUT_HELPER_UNKNOWN:
        break;
    }
    return taut_fail(error, status, "library", NULL, taut_none, taut_none,
                     "OpenCASCADE gave up on the %s without a word", blamed(a));
}

/* It ended before it had said who it is: what loads programs ends one so whose libraries it does not find. */
static taut_status refuse_silence(const attempt *a, taut_helper_fate fate, int number,
                                  taut_error *error)
{
    enum { CANNOT_LOAD = 127 };
    if (fate == TAUT_HELPER_LEFT && number == CANNOT_LOAD) {
        return taut_fail(
            error, TAUT_IO, "not-installed", NULL, taut_none, taut_none,
            "%.300s does not start: libraries of OpenCASCADE are missing, or the memory "
            "to load them: install %s",
            a->program, package);
    }
    if (fate == TAUT_HELPER_LEFT || fate == TAUT_HELPER_UNKNOWN) {
        return refuse_greeting(a, TAUT_CAD_STRANGER, NULL, error);
    }
    return refuse_death(a, fate, number, error);
}

/* taut-cad had the memory that a file of this size may take. */
static taut_status refuse_claim(taut_error *error)
{
    return taut_fail(error, TAUT_BAD_INPUT, "claims", NULL, taut_none, taut_none,
                     "the file claims to hold more than its size explains");
}

/* As taut_cad_source.more. */
typedef struct ear {
    const taut_helper *helper;
    attempt *attempt;
} ear;

static size_t hear(void *context, void *to, size_t room)
{
    const ear *e = context;
    size_t count = 0;
    int reason = 0;
    do {
        reason = taut_system_helper_read(e->helper, to, room, &count);
    } while (reason == EAGAIN && !taut_pulse_report(&e->attempt->pulse));
    e->attempt->is_late = e->attempt->is_late || reason == ETIMEDOUT;
    return reason == 0 ? count : 0;
}

/* All that a process that has been started says, and how it ends. */
static taut_status hear_helper(attempt *a, taut_helper *helper, taut_cad_result *result,
                               taut_error *error)
{
    ear e = {helper, a};
    taut_cad_source source = {.more = hear, .context = &e};
    taut_cad_hello hello;
    taut_status status = TAUT_OK;
    int number = 0;

    const taut_cad_greeting greeting = taut_cad_get_hello(&source, &hello);
    if (greeting == TAUT_CAD_GREETED) {
        helper->deadline += a->seconds;
        status = taut_cad_get_all(&source, result, error);
    }
    const taut_helper_fate fate = taut_system_helper_end(helper, &number);
    if (taut_pulse_is_stopped(&a->pulse)) {
        return refuse_death(a, TAUT_HELPER_INTERRUPTED, 0, error);
    }
    if (greeting == TAUT_CAD_STRANGER || greeting == TAUT_CAD_OTHER_VERSION ||
        (greeting == TAUT_CAD_SILENT && a->is_late)) {
        return refuse_greeting(a, greeting, &hello, error);
    }
    if (a->is_late) {
        return refuse_time(a, error);
    }
    if (greeting == TAUT_CAD_SILENT) {
        return refuse_silence(a, fate, number, error);
    }
    if (status != TAUT_OK && !source.is_dry) {
        return status;
    }
    return result->has_ended ? result->status : refuse_death(a, fate, number, error);
}

/* The request as a file; NULL: *status says why. */
static FILE *write_request(const taut_cad_job *job, int count, const taut_cad_item *items,
                           taut_status *status, taut_error *error)
{
    int reason = 0;
    FILE *request = taut_system_helper_request(&reason);
    if (request == NULL) {
        *status = refuse_start(reason, error);
        return NULL;
    }
    errno = 0;
    if (!taut_cad_put_request(request, job, count, items)) {
        *status = refuse_start(errno != 0 ? errno : EIO, error);
        fclose(request);
        return NULL;
    }
    return request;
}

/* The seconds that a job may take on the clock: of a file to be read by its size, of items by theirs. */
static double time_for(const taut_cad_job *job, FILE *request)
{
    taut_source file;
    double size = (double)ftello(request);
    if (job->path != NULL && taut_system_open(job->path, &file) == 0) {
        size += file.size > 0 ? file.size : 0;
        taut_system_close(&file);
    }
    return clock_factor * taut_cad_seconds(size);
}

static taut_status start_and_hear(attempt *a, FILE *request, taut_cad_result *result,
                                  taut_error *error)
{
    taut_helper helper;
    const int reason = taut_system_helper_start(&helper, a->program, request, greeting_seconds);
    fclose(request);
    if (reason != 0) {
        return is_about_program(reason) ? refuse_program(a, reason, error)
                                        : refuse_start(reason, error);
    }
    helper.patience =
        a->pulse.monitor != NULL && a->pulse.monitor->progress != NULL ? TAUT_CAD_PATIENCE : 0;
    return hear_helper(a, &helper, result, error);
}

taut_status taut_cad_run(const taut_cad_job *job, int count, const taut_cad_item *items,
                         const taut_monitor *monitor, taut_cad_result *result, taut_error *error)
{
    char program[TAUT_PATH_ROOM];
    attempt a = {.program = program, .is_reading = count == 0};
    a.pulse = (taut_pulse){
        .monitor = monitor, .what = count == 0 ? "reading" : "writing", .done = taut_none};
    taut_status status = TAUT_OK;

    if (!taut_system_helper("taut-cad", "TAUT_CAD", program)) {
        return taut_module_missing("occt", package, error);
    }
    FILE *request = write_request(job, count, items, &status, error);
    if (request == NULL) {
        return status;
    }
    a.seconds = time_for(job, request);
    status = start_and_hear(&a, request, result, error);
    return status == TAUT_NO_MEMORY && result->has_ended && a.is_reading ? refuse_claim(error)
                                                                         : status;
}
