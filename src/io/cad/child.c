#include "io/cad/child.h"

#include "core/arena.h"
#include "core/fail.h"
#include "geometry/keep.h"
#include "io/json/utf8.h"
#include "platform/module.h"

#include <errno.h>
#include <fcntl.h>
#include <inttypes.h>
#include <signal.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

enum { UNIT_BYTES = 4, NOTES_MAX = 100 };

/* What stands before the numbers of an item. */
typedef struct item_head {
    int degree[2], count[2], is_rational, notes;
    int name_length;
} item_head;

static int put_bytes(FILE *file, const void *bytes, size_t size, size_t count)
{
    return count == 0 || fwrite(bytes, size, count, file) == count;
}

static int get_bytes(FILE *file, void *bytes, size_t size, size_t count)
{
    return count == 0 || fread(bytes, size, count, file) == count;
}

int taut_cad_put_unit(void *file, const char *unit)
{
    char bytes[UNIT_BYTES] = "";
    memcpy(bytes, unit, strlen(unit) < UNIT_BYTES ? strlen(unit) : UNIT_BYTES - 1);
    return put_bytes(file, "U", 1, 1) && put_bytes(file, bytes, 1, UNIT_BYTES);
}

static size_t point_count(const int count[2])
{
    return (size_t)count[0] * (count[1] > 0 ? (size_t)count[1] : 1);
}

static size_t knot_count(const int degree[2], const int count[2], int d)
{
    return count[d] > 0 ? (size_t)count[d] + (size_t)degree[d] + 1 : 0;
}

int taut_cad_put_item(void *file, const taut_cad_item *item)
{
    const size_t length = strlen(item->name), n = point_count(item->count);
    item_head head = {{item->degree[0], item->degree[1]},
                      {item->count[0], item->count[1]},
                      item->weights != NULL,
                      item->notes,
                      length < TAUT_NAME_MAX ? (int)length : TAUT_NAME_MAX};
    return put_bytes(file, "I", 1, 1) && put_bytes(file, &head, sizeof head, 1) &&
           put_bytes(file, item->name, 1, (size_t)head.name_length) &&
           put_bytes(file, item->knots[0], sizeof(double),
                     knot_count(head.degree, head.count, 0)) &&
           put_bytes(file, item->knots[1], sizeof(double),
                     knot_count(head.degree, head.count, 1)) &&
           put_bytes(file, item->points, 3 * sizeof(double), n) &&
           put_bytes(file, item->weights, sizeof(double), head.is_rational ? n : 0);
}

int taut_cad_put_end(FILE *file, taut_status status, const taut_error *error)
{
    const int number = (int)status;
    return put_bytes(file, "E", 1, 1) && put_bytes(file, &number, sizeof number, 1) &&
           put_bytes(file, error, sizeof *error, 1) && fflush(file) == 0;
}

/* Cut to whole characters; what is no UTF-8 becomes '?'. */
static void mend_name(char *name, size_t length)
{
    size_t i = 0;
    while (i < length) {
        const size_t step = name[i] != '\0' ? taut_utf8_length(name + i, length - i) : 0;
        if (step == 0 && length == TAUT_NAME_MAX && length - i < 4) {
            length = i;
        } else if (step == 0) {
            name[i] = '?';
        }
        i += step > 0 ? step : 1;
    }
    name[length] = '\0';
}

static taut_status refuse_stream(taut_error *error)
{
    return taut_fail(error, TAUT_BAD_INPUT, "library", NULL, taut_none, taut_none,
                     "OpenCASCADE gave nothing that can be read");
}

/* Are these numbers that taut takes, before memory is taken for them? */
static taut_status check_head(const item_head *head, taut_error *error)
{
    const int directions = head->count[1] > 0 ? 2 : 1;
    if (head->name_length < 0 || head->name_length > TAUT_NAME_MAX) {
        return refuse_stream(error);
    }
    for (int d = 0; d < directions; d++) {
        if (head->degree[d] < 1 || head->degree[d] > TAUT_DEGREE_MAX ||
            head->count[d] <= head->degree[d] || head->count[d] > TAUT_COUNT_MAX) {
            return taut_fail(error, TAUT_BAD_INPUT, "size", NULL, head->count[d], TAUT_COUNT_MAX,
                             "found degree %d with %d points, expected a degree of 1 to %d and at "
                             "most %d points",
                             head->degree[d], head->count[d], TAUT_DEGREE_MAX, TAUT_COUNT_MAX);
        }
    }
    if (point_count(head->count) > TAUT_POINTS_MAX) {
        return taut_fail(error, TAUT_BAD_INPUT, "size", NULL, (double)point_count(head->count),
                         TAUT_POINTS_MAX, "found a net of %d x %d points, expected at most %d",
                         head->count[0], head->count[1], TAUT_POINTS_MAX);
    }
    return TAUT_OK;
}

/* An item as it came; the arena owns its numbers. */
typedef struct item_read {
    item_head head;
    char name[TAUT_NAME_MAX + 1];
    double *knots[2], *points, *weights;
    taut_arena *arena;
} item_read;

static taut_status new_basis(const item_read *item, int d, taut_basis **basis, taut_error *error)
{
    const taut_basis_spec spec = {.type = "bspline",
                                  .degree = item->head.degree[d],
                                  .knot_count =
                                      (int)knot_count(item->head.degree, item->head.count, d),
                                  .knots = item->knots[d]};
    const taut_status status = taut_basis_new(&spec, item->head.count[d], basis, error);
    if (status == TAUT_OK && !taut_keep_basis(item->arena, *basis)) {
        return taut_fail_memory(error);
    }
    return status;
}

static taut_status add_curve(const item_read *item, taut_model *model, taut_error *error)
{
    taut_basis *t = NULL;
    taut_curve *curve = NULL;
    taut_status status = new_basis(item, 0, &t, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = taut_curve_new(item->name, t, item->points, item->weights, &curve, error);
    if (status == TAUT_OK && taut_model_add_curve(model, curve) != TAUT_OK) {
        taut_curve_free(curve);
        return taut_fail_memory(error);
    }
    return status;
}

static taut_status add_surface(const item_read *item, taut_model *model, taut_error *error)
{
    taut_basis *u = NULL, *v = NULL;
    taut_surface *surface = NULL;
    taut_status status = new_basis(item, 0, &u, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = new_basis(item, 1, &v, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = taut_surface_new(item->name, u, v, item->points, item->weights, &surface, error);
    if (status == TAUT_OK && taut_model_add_surface(model, surface) != TAUT_OK) {
        taut_surface_free(surface);
        return taut_fail_memory(error);
    }
    return status;
}

/* Says of an item what is to be said. */
static void add_notes(const item_head *head, const char *name, int index, taut_record *notes)
{
    const char *what = head->count[1] > 0 ? "surface" : "curve";
    char text[TAUT_NAME_MAX + 160];
    for (int note = TAUT_CAD_TRIMMED; note <= TAUT_CAD_APPROXIMATE; note *= 2) {
        if ((head->notes & note) != 0 && taut_record_count(notes) < NOTES_MAX) {
            snprintf(text, sizeof text, "%s %d \"%s\": %s", what, index, name,
                     note == TAUT_CAD_TRIMMED
                         ? "the face is trimmed; this is the whole surface under it"
                         : "the original is no NURBS; this comes near it");
            taut_record_add_text(notes, NULL, text);
        }
    }
}

static taut_status get_numbers(FILE *file, item_read *item, taut_error *error)
{
    const item_head *head = &item->head;
    const size_t ku = knot_count(head->degree, head->count, 0);
    const size_t kv = knot_count(head->degree, head->count, 1);
    const size_t n = point_count(head->count);
    item->knots[0] = taut_arena_take(item->arena, ku, sizeof(double));
    item->knots[1] = taut_arena_take(item->arena, kv, sizeof(double));
    item->points = taut_arena_take(item->arena, n, 3 * sizeof(double));
    item->weights = head->is_rational ? taut_arena_take(item->arena, n, sizeof(double)) : NULL;
    if (taut_arena_status(item->arena) != TAUT_OK) {
        return taut_fail_memory(error);
    }
    return get_bytes(file, item->knots[0], sizeof(double), ku) &&
                   get_bytes(file, item->knots[1], sizeof(double), kv) &&
                   get_bytes(file, item->points, 3 * sizeof(double), n) &&
                   get_bytes(file, item->weights, sizeof(double), head->is_rational ? n : 0)
               ? TAUT_OK
               : refuse_stream(error);
}

static taut_status get_item_into(FILE *file, item_read *item, taut_cad_result *result,
                                 taut_error *error)
{
    taut_status status = TAUT_OK;
    if (result->model == NULL || !get_bytes(file, &item->head, sizeof item->head, 1)) {
        return refuse_stream(error);
    }
    status = check_head(&item->head, error);
    if (status != TAUT_OK) {
        return status;
    }
    if (!get_bytes(file, item->name, 1, (size_t)item->head.name_length)) {
        return refuse_stream(error);
    }
    mend_name(item->name, (size_t)item->head.name_length);
    const int is_surface = item->head.count[1] > 0;
    const int index = is_surface ? taut_model_surface_count(result->model)
                                 : taut_model_curve_count(result->model);
    status = get_numbers(file, item, error);
    if (status == TAUT_OK && index >= TAUT_OBJECTS_MAX) {
        status = taut_fail(error, TAUT_BAD_INPUT, "size", NULL, index, TAUT_OBJECTS_MAX,
                           "found more than %d %s", TAUT_OBJECTS_MAX,
                           is_surface ? "surfaces" : "curves");
    } else if (status == TAUT_OK) {
        status = (is_surface ? add_surface : add_curve)(item, result->model, error);
    }
    if (status == TAUT_BAD_INPUT) {
        char prefix[48];
        snprintf(prefix, sizeof prefix, "/%s/%d", is_surface ? "surfaces" : "curves", index);
        taut_error_prefix(error, prefix);
    }
    if (status != TAUT_OK) {
        return status;
    }
    add_notes(&item->head, item->name, index, result->notes);
    return TAUT_OK;
}

static taut_status get_item(FILE *file, taut_cad_result *result, taut_error *error)
{
    item_read item = {.arena = taut_arena_new()};
    const taut_status status = get_item_into(file, &item, result, error);
    taut_arena_free(item.arena);
    return status;
}

static taut_status get_unit(FILE *file, taut_cad_result *result, taut_error *error)
{
    char unit[UNIT_BYTES];
    if (result->model == NULL || !get_bytes(file, unit, 1, UNIT_BYTES) ||
        unit[UNIT_BYTES - 1] != '\0' || taut_model_set_unit(result->model, unit) != TAUT_OK) {
        return refuse_stream(error);
    }
    return TAUT_OK;
}

/* What came through a pipe may be anything. */
static void end_text(char *text, size_t size)
{
    text[size - 1] = '\0';
}

static taut_status get_end(FILE *file, taut_cad_result *result, taut_error *error)
{
    taut_error found;
    int status = 0;
    if (!get_bytes(file, &status, sizeof status, 1) || !get_bytes(file, &found, sizeof found, 1)) {
        return TAUT_OK; /* died while saying so */
    }
    end_text(found.reason, sizeof found.reason);
    end_text(found.expected, sizeof found.expected);
    end_text(found.where, sizeof found.where);
    end_text(found.message, sizeof found.message);
    result->has_ended = 1;
    result->status = (taut_status)status;
    if (status != TAUT_OK && error != NULL) {
        *error = found;
    }
    return TAUT_OK;
}

taut_status taut_cad_get_all(FILE *file, taut_cad_result *result, taut_error *error)
{
    taut_status status = TAUT_OK;
    int tag = 0;
    while (status == TAUT_OK && !result->has_ended && (tag = fgetc(file)) != EOF) {
        if (tag == 'U') {
            status = get_unit(file, result, error);
        } else if (tag == 'I') {
            status = get_item(file, result, error);
        } else if (tag == 'E') {
            status = get_end(file, result, error);
            if (!result->has_ended) {
                break;
            }
        } else {
            status = refuse_stream(error);
        }
    }
    return status;
}

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
    uint64_t pages = 0;
    int found = 0;
    FILE *file = fopen("/proc/self/statm", "r");
    if (file != NULL) {
        found = fscanf(file, "%" SCNu64, &pages);
        fclose(file);
    }
    return found == 1 ? (double)pages * (double)sysconf(_SC_PAGESIZE) : 0;
}

static void set_limit(int resource, double value)
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
    set_limit(RLIMIT_CORE, 0);
    set_limit(RLIMIT_CPU, seconds_base + seconds_per_byte * size);
    if (!HAS_SHADOW) {
        set_limit(RLIMIT_AS, space_in_use() + memory_base + memory_per_byte * size);
    }
}

/* Signals as they are by default; nothing to read from, and nowhere to print. */
static void settle_child(void)
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
static void run_child(int pipe_end, const taut_cad_job *job, int count, const taut_cad_item *items)
{
    taut_error error = {.status = TAUT_OK};
    const void *table = NULL;
    FILE *file = NULL;
    taut_status status = TAUT_OK;

    settle_child();
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

static taut_status refuse_death(int how, int is_reading, taut_error *error)
{
    const taut_status status = is_reading ? TAUT_BAD_INPUT : TAUT_INTERNAL;
    const int number = how >= 0 && WIFSIGNALED(how) ? WTERMSIG(how) : 0;
    if (number == SIGXCPU || number == SIGKILL) {
        return taut_fail(error, status, "library", NULL, taut_none, taut_none,
                         "OpenCASCADE was stopped: the %s takes more time than its size explains",
                         is_reading ? "file" : "model");
    }
    if (number == SIGINT || number == SIGTERM || number == SIGHUP) {
        return taut_fail(error, TAUT_INTERRUPTED, "interrupted", NULL, taut_none, taut_none,
                         "stopped on request");
    }
    if (number == 0) {
        return taut_fail(error, status, "library", NULL, taut_none, taut_none,
                         "OpenCASCADE gave up on the %s without a word",
                         is_reading ? "file" : "model");
    }
    return taut_fail(error, status, "library", NULL, number, taut_none,
                     "OpenCASCADE broke down over the %s (signal %d)",
                     is_reading ? "file" : "model", number);
}

/* The child had the memory that a file of this size may take. */
static taut_status refuse_claim(taut_error *error)
{
    return taut_fail(error, TAUT_BAD_INPUT, "claims", NULL, taut_none, taut_none,
                     "the file claims to hold more than its size explains");
}

/* The system gave no pipe or no process: too many of them are in use. */
static taut_status refuse_start(int reason, taut_error *error)
{
    char text[96];
    if (reason == ENOMEM) {
        return taut_fail_memory(error);
    }
    return taut_fail(error, TAUT_IO, "process", NULL, taut_none, taut_none,
                     "OpenCASCADE cannot be started in a process of its own: %s",
                     strerror_r(reason, text, sizeof text) == 0 ? text : "unknown reason");
}

/* The parent's side of it. */
static taut_status hear_child(int pipe_end, taut_cad_result *result, taut_error *error)
{
    FILE *file = fdopen(pipe_end, "rb");
    taut_status status = TAUT_OK;
    if (file == NULL) {
        close(pipe_end);
        return taut_fail_memory(error);
    }
    status = taut_cad_get_all(file, result, error);
    fclose(file);
    return status;
}

taut_status taut_cad_run(const taut_cad_job *job, int count, const taut_cad_item *items,
                         taut_cad_result *result, taut_error *error)
{
    int ends[2], how = 0, reason = 0;
    pid_t child = 0;
    taut_status status = TAUT_OK;

    if (pipe(ends) != 0) {
        return refuse_start(errno, error);
    }
    child = fork();
    if (child == 0) {
        close(ends[0]);
        run_child(ends[1], job, count, items);
    }
    reason = errno;
    close(ends[1]);
    if (child < 0) {
        close(ends[0]);
        return refuse_start(reason, error);
    }
    status = hear_child(ends[0], result, error);
    how = wait_for(child);
    if (status != TAUT_OK) {
        return status;
    }
    if (!result->has_ended) {
        return refuse_death(how, items == NULL, error);
    }
    return result->status == TAUT_NO_MEMORY && items == NULL ? refuse_claim(error) : result->status;
}
