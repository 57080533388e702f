/* test_helper.c -- taut-cad as a process: programs that are none, that die, that never end; hosts with threads, with signals
 * of their own, with standard files closed; and nothing is left of any of it.
 *
 * needs: posix
 */
#include "check.h"
#include "fake_cad.h"
#include "folder.h"
#include "monitors.h"
#include "shapes.h"

#include "platform/parallel.h"
#include "platform/system.h"
#include "taut/read.h"
#include "taut/write.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

static const char drawing[] = "ISO-10303-21;\nEND-ISO-10303-21;\n";
static char drawing_path[96], output_path[96];
static taut_model *model;

static int open_files(void)
{
    int count = 0;
    for (int file = 0; file < 1024; file++) {
        count += fcntl(file, F_GETFD) >= 0;
    }
    return count;
}

typedef struct outcome {
    taut_status status;
    taut_error error;
    int items;
} outcome;

static outcome read_drawing(void)
{
    outcome o = {.error = {.status = TAUT_OK}};
    taut_model *read = NULL;
    o.status = taut_model_read(drawing_path, &read, &o.error);
    CHECK((read != NULL) == (o.status == TAUT_OK), "a model or an error");
    o.items = read != NULL ? taut_model_surface_count(read) + taut_model_curve_count(read) : 0;
    taut_model_free(read);
    return o;
}

static outcome write_drawing(void)
{
    outcome o = {.error = {.status = TAUT_OK}};
    o.status = taut_model_write(model, output_path, NULL, &o.error);
    CHECK((access(output_path, F_OK) == 0) == (o.status == TAUT_OK), "a file or an error");
    unlink(output_path);
    return o;
}

/* Nothing is left: no child, dead or alive, no file of ours open, no file in the folder. */
static void check_nothing_left(int files, const char *role)
{
    CHECK(waitpid(-1, NULL, WNOHANG) == -1 && errno == ECHILD, "%s: a child is left", role);
    CHECK(open_files() == files, "%s: %d files are open, %d were", role, open_files(), files);
    CHECK(folder_entries() == 1, "%s: %d entries", role, folder_entries());
}

typedef struct row {
    const char *role;
    taut_status reading, writing;
    const char *word;
} row;

static const row rows[] = {
    {"silent", TAUT_IO, TAUT_IO, "helper"},
    {"stranger", TAUT_IO, TAUT_IO, "helper"},
    {"echo", TAUT_IO, TAUT_IO, "helper"},
    {"endless", TAUT_IO, TAUT_IO, "helper"},
    {"version", TAUT_IO, TAUT_IO, "helper"},
    {"layout", TAUT_IO, TAUT_IO, "helper"},
    {"no-load", TAUT_IO, TAUT_IO, "not-installed"},
    {"deaf", TAUT_BAD_INPUT, TAUT_INTERNAL, "library"},
    {"half", TAUT_BAD_INPUT, TAUT_BAD_INPUT, "library"}, /* items where a text is expected */
    {"nonsense", TAUT_BAD_INPUT, TAUT_BAD_INPUT, "library"},
    {"word-less", TAUT_BAD_INPUT, TAUT_INTERNAL, "library"},
    {"signal 24", TAUT_BAD_INPUT, TAUT_INTERNAL, "library"},
    {"signal 9", TAUT_BAD_INPUT, TAUT_INTERNAL, "library"},
    {"signal 8", TAUT_BAD_INPUT, TAUT_INTERNAL, "library"},
    {"signal 15", TAUT_INTERRUPTED, TAUT_INTERRUPTED, "interrupted"},
    {"signal 2", TAUT_INTERRUPTED, TAUT_INTERRUPTED, "interrupted"},
};

static void test_roles(void)
{
    const int files = open_files();
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        fake_cad_as(rows[i].role);
        for (int writing = 0; writing < 2; writing++) {
            const outcome o = writing ? write_drawing() : read_drawing();
            const taut_status expected = writing ? rows[i].writing : rows[i].reading;
            CHECK(o.status == expected && o.error.status == expected &&
                      strcmp(o.error.reason, rows[i].word) == 0 && o.error.message[0] != '\0',
                  "%s, writing %d: %d %s \"%s\"", rows[i].role, writing, (int)o.status,
                  o.error.reason, o.error.message);
            check_nothing_left(files, rows[i].role);
        }
    }
}

/* The version that was found and the one expected, and which program it is. */
static void test_version(void)
{
    fake_cad_as("version");
    const outcome o = read_drawing();
    CHECK(o.error.found == TAUT_CAD_VERSION + 1 && o.error.limit == TAUT_CAD_VERSION,
          "found %g, limit %g", o.error.found, o.error.limit);
    CHECK(strstr(o.error.message, "/proc/self/exe") != NULL, "\"%s\"", o.error.message);
}

/* $TAUT_CAD names what cannot be started; a word without a folder is not looked for in PATH. */
static void test_no_program(void)
{
    char text[96];
    snprintf(text, sizeof text, "%s", drawing_path);
    const char *const programs[] = {"/nowhere/taut-cad", "/tmp", text, "true"};
    for (size_t i = 0; i < sizeof programs / sizeof programs[0]; i++) {
        fake_cad_as(NULL);
        setenv("TAUT_CAD", programs[i], 1);
        const outcome o = read_drawing();
        CHECK(o.status == TAUT_IO && strcmp(o.error.reason, "helper") == 0 &&
                  strstr(o.error.message, programs[i]) != NULL,
              "%s: %s \"%s\"", programs[i], o.error.reason, o.error.message);
    }
    fake_cad_as(NULL);
}

static void check_reader(const char *host)
{
    const outcome o = read_drawing();
    CHECK(o.status == TAUT_OK && o.items == 2, "%s: %d \"%s\"", host, (int)o.status,
          o.error.message);
}

static void reap_all(int number)
{
    const int kept = errno;
    (void)number;
    while (waitpid(-1, NULL, WNOHANG) > 0) {
    }
    errno = kept;
}

/* Hosts that do not want to know how children end, or want to know it of all of them. */
static void test_children_of_the_host(void)
{
    void (*const handlers[])(int) = {SIG_IGN, reap_all};
    const int files = open_files();
    for (int k = 0; k < 2; k++) {
        struct sigaction own = {.sa_handler = handlers[k]}, before;
        sigaction(SIGCHLD, &own, &before);
        fake_cad_as("reader");
        check_reader(k == 0 ? "SIGCHLD ignored" : "SIGCHLD handled");
        fake_cad_as("signal 8");
        const outcome o = read_drawing();
        CHECK(o.status == TAUT_BAD_INPUT && strcmp(o.error.reason, "library") == 0, "\"%s\"",
              o.error.message);
        fake_cad_as("deaf");
        CHECK(read_drawing().status != TAUT_OK, "deaf");
        sigaction(SIGCHLD, &before, NULL);
        check_nothing_left(files, "SIGCHLD");
    }
}

/* What the host has open, blocks and ignores does not reach taut-cad, nor does its end reach the host. */
static void test_host(void)
{
    sigset_t some, before;
    const int files = open_files(), open_to_all = open("/dev/null", O_RDONLY);
    sigemptyset(&some);
    sigaddset(&some, SIGUSR1);
    sigaddset(&some, SIGXCPU);
    sigprocmask(SIG_BLOCK, &some, &before);
    signal(SIGHUP, SIG_IGN);
    fake_cad_as("host");
    const outcome o = write_drawing();
    CHECK(o.status == TAUT_OK, "%d \"%s\"", (int)o.status, o.error.reason);
    signal(SIGHUP, SIG_DFL);
    sigprocmask(SIG_SETMASK, &before, NULL);
    close(open_to_all);
    check_nothing_left(files, "host");
}

/* A host without standard files, or without a folder for passing files. */
static void test_bare_host(void)
{
    int kept[3];
    const int files = open_files();
    fake_cad_as("reader");
    for (int file = 0; file < 3; file++) {
        kept[file] = fcntl(file, F_DUPFD, 10);
        close(file);
    }
    const outcome o = read_drawing();
    for (int file = 0; file < 3; file++) {
        dup2(kept[file], file);
        close(kept[file]);
    }
    CHECK(o.status == TAUT_OK && o.items == 2, "no standard files: \"%s\"", o.error.message);
    setenv("TMPDIR", "/nowhere", 1);
    check_reader("no folder for passing files");
    unsetenv("TMPDIR");
    check_nothing_left(files, "a bare host");
}

static void read_some(void *context, int worker, long task)
{
    int *wrong = context;
    (void)task;
    for (int i = 0; i < 4; i++) {
        taut_model *read = NULL;
        wrong[worker] += taut_model_read(drawing_path, &read, NULL) != TAUT_OK ||
                         taut_model_surface_count(read) != 1 || taut_model_curve_count(read) != 1;
        taut_model_free(read);
    }
}

/* Several threads at once: each hears its own, and none keeps another's answer open. */
static void test_threads(void)
{
    enum { WORKERS = 8 };
    int wrong[WORKERS] = {0};
    const int files = open_files();
    fake_cad_as("reader");
    taut_parallel_run(WORKERS, WORKERS, read_some, wrong);
    for (int i = 0; i < WORKERS; i++) {
        CHECK(wrong[i] == 0, "worker %d: %d wrong", i, wrong[i]);
    }
    check_nothing_left(files, "threads");
}

static FILE *request_of(const void *bytes, size_t length)
{
    int reason = 0;
    FILE *request = taut_system_helper_request(&reason);
    CHECK(request != NULL && fwrite(bytes, 1, length, request) == length, "request: %d", reason);
    return request;
}

/* What never ends is stopped when its time is up, and gone. */
static void test_hang(void)
{
    taut_helper helper;
    char bytes[64];
    size_t count = 0, all = 0;
    int reason = 0, number = 0;
    const int files = open_files();
    FILE *request = request_of("", 0);

    fake_cad_as("hang");
    CHECK(taut_system_helper_start(&helper, "/proc/self/exe", request, 0.5) == 0, "start");
    fclose(request);
    while ((reason = taut_system_helper_read(&helper, bytes, sizeof bytes, &count)) == 0 &&
           count > 0) {
        all += count;
    }
    CHECK(reason == ETIMEDOUT && (all == 0 || all == sizeof(taut_cad_hello)), "%d after %zu bytes",
          reason, all);
    CHECK(taut_system_helper_end(&helper, &number) == TAUT_HELPER_OUT_OF_TIME && number == SIGKILL,
          "signal %d", number);
    check_nothing_left(files, "hang");
}

/* What never introduces itself is waited for no longer than a loader needs, however large the file. */
static void test_mute(void)
{
    const int files = open_files();
    fake_cad_as("mute");
    const outcome o = read_drawing();
    CHECK(o.status == TAUT_IO && strcmp(o.error.reason, "helper") == 0 &&
              strstr(o.error.message, "it does not answer as one") != NULL,
          "%d %s: %s", (int)o.status, o.error.reason, o.error.message);
    check_nothing_left(files, "mute");
}

/* While it is waited for the monitor is told; an end stops it, and nothing is left, the file neither. */
static void test_watched(void)
{
    const int files = open_files();

    fake_cad_as("hang");
    for (int k = 1; k <= 3; k++) {
        watch stop = {.stop_at = k, .answer = k == 2 ? TAUT_ENOUGH : TAUT_STOP};
        const taut_write_options options = {.monitor = monitor_of(&stop)};
        taut_error error = {.status = TAUT_OK};
        CHECK(taut_model_write(model, output_path, &options, &error) == TAUT_INTERRUPTED &&
                  strcmp(error.reason, "interrupted") == 0 && stop.reports == k,
              "stopped at %d: went on to %d, %s", k, stop.reports, error.message);
        check_nothing_left(files, "watched");
        watch end = {.stop_at = k, .answer = stop.answer};
        const taut_read_options read = {.monitor = monitor_of(&end)};
        taut_model *none = NULL;
        CHECK(taut_model_read_with(drawing_path, &read, &none, &error) == TAUT_INTERRUPTED &&
                  none == NULL && strcmp(error.reason, "interrupted") == 0 && end.reports == k,
              "reading stopped at %d: went on to %d, %s", k, end.reports, error.message);
        check_nothing_left(files, "watched");
    }
    watch all = {.stop_at = 0};
    const taut_write_options options = {.monitor = monitor_of(&all)};
    fake_cad_as("writer");
    CHECK(taut_model_write(model, output_path, &options, NULL) == TAUT_OK, "written");
    CHECK(unlink(output_path) == 0, "there");
}

/* What the taut-cad that is installed says to a request: the status it ends with; -1: none. */
static int said_to(const char *program, const void *bytes, size_t length)
{
    static char answer[1 << 16];
    taut_helper helper;
    size_t count = 0, all = 0;
    int number = 0, status = -1;
    FILE *request = request_of(bytes, length);

    CHECK(taut_system_helper_start(&helper, program, request, 60) == 0, "start");
    fclose(request);
    while (all < sizeof answer &&
           taut_system_helper_read(&helper, answer + all, sizeof answer - all, &count) == 0 &&
           count > 0) {
        all += count;
    }
    taut_system_helper_end(&helper, &number);
    const size_t end = 1 + sizeof status + sizeof(taut_error);
    if (all >= sizeof(taut_cad_hello) + end && answer[all - end] == 'E') {
        memcpy(&status, answer + all - end + 1, sizeof status);
    }
    return status;
}

/* Requests of another version, cut off anywhere, or with any byte changed: taut-cad refuses or does them, and never dies. */
static void test_requests(const char *program)
{
    static const char *const notes[] = {"made", "exact"};
    const taut_cad_job job = {.kind = TAUT_CAD_IGES,
                              .unit = "mm",
                              .name = "taut",
                              .notes = notes,
                              .note_count = 2,
                              .date = "1970-01-01T00:00:00",
                              .precision = 1e-7};
    char *bytes = NULL;
    size_t length = 0;
    FILE *file = open_memstream(&bytes, &length);

    CHECK(taut_cad_put_request(file, &job, 2, fake_cad_items), "request");
    fclose(file);
    CHECK(said_to(program, bytes, length) == TAUT_OK, "a whole request");
    CHECK(said_to(program, "what does it want?", 18) == TAUT_INTERNAL, "none");
    bytes[TAUT_CAD_MARK]++;
    CHECK(said_to(program, bytes, length) == TAUT_INTERNAL, "another version");
    bytes[TAUT_CAD_MARK]--;
    for (int k = 0; k < random_trials(24); k++) {
        const size_t cut = (size_t)random_in(0, (double)length);
        CHECK(said_to(program, bytes, cut) == TAUT_INTERNAL, "cut at %zu of %zu", cut, length);
    }
    for (int k = 0; k < random_trials(24); k++) {
        const size_t at = (size_t)random_in(0, (double)length);
        const char kept = bytes[at];
        bytes[at] = (char)random_int(0, 255);
        CHECK(said_to(program, bytes, length) >= TAUT_OK, "byte %zu is %d", at, bytes[at]);
        bytes[at] = kept;
    }
    free(bytes);
}

/* The soft and the hard limit of this name in /proc; -1: none. */
static void find_limit(const char *limits, const char *name, double found[2])
{
    const char *line = strstr(limits, name);
    found[0] = found[1] = -1;
    CHECK(line != NULL, "%s", name);
    if (line != NULL) {
        char soft[32] = "", hard[32] = "";
        CHECK(sscanf(line + strlen(name), "%31s %31s", soft, hard) == 2, "%s", name);
        found[0] = strcmp(soft, "unlimited") == 0 ? -1 : atof(soft);
        found[1] = strcmp(hard, "unlimited") == 0 ? -1 : atof(hard);
    }
}

/* What the taut-cad that is installed allows itself, seen while it waits for a file that never comes. */
static void test_limits(const char *program)
{
    const taut_cad_job job = {
        .kind = TAUT_CAD_STEP, .path = in_folder("pipe.step"), .precision = 1};
    const struct timespec pause = {0, 10000000};
    taut_helper helper;
    char proc[64], limits[4096] = "";
    double found[2] = {-1, -1};
    int reason = 0, number = 0;
    FILE *request = taut_system_helper_request(&reason);

    CHECK(mkfifo(job.path, 0600) == 0, "a pipe");
    CHECK(request != NULL && taut_cad_put_request(request, &job, 0, NULL), "request: %d", reason);
    CHECK(taut_system_helper_start(&helper, program, request, 60) == 0, "start");
    fclose(request);
    snprintf(proc, sizeof proc, "/proc/%lld/limits", (long long)helper.process);
    for (int i = 0; i < 1000 && found[1] != 21; i++) { /* the hard one comes last */
        FILE *file = fopen(proc, "r");
        limits[file != NULL ? fread(limits, 1, sizeof limits - 1, file) : 0] = '\0';
        if (file != NULL) {
            fclose(file);
        }
        find_limit(limits, "Max cpu time", found);
        nanosleep(&pause, NULL);
    }
    CHECK(found[0] == 20 && found[1] == 21, "processor: %g, %g", found[0], found[1]);
    nanosleep(&pause, NULL);
    find_limit(limits, "Max file size", found);
    CHECK(found[0] == 0 && found[1] == 0, "files: %g, %g", found[0], found[1]);
    find_limit(limits, "Max core file size", found);
    CHECK(found[0] == 0 && found[1] == 0, "core files: %g, %g", found[0], found[1]);
    taut_system_helper_end(&helper, &number);
    unlink(job.path);
}

/* Of memory as of time: in proportion to the file, and no end of it. */
static void test_proportion(void)
{
    CHECK(taut_cad_seconds(0) == 20 && taut_cad_seconds(1e6) == 40, "time");
    CHECK(taut_cad_memory(0) == 1e9 && taut_cad_memory(1e6) == 1.4e9, "memory");
}

int main(void)
{
    static const struct rlimit none = {0, 0};
    char program[TAUT_PATH_ROOM];

    fake_cad_play();
    random_seed(20261123);
    folder_make();
    CHECK(setrlimit(RLIMIT_CORE, &none) == 0, "no core files");
    snprintf(drawing_path, sizeof drawing_path, "%s", in_folder("drawing.step"));
    snprintf(output_path, sizeof output_path, "%s", in_folder("out.igs"));
    file_put_text(drawing_path, drawing);
    CHECK(taut_model_new(&model) == TAUT_OK &&
              taut_model_add_surface(model, shape_saddle(0.5)) == TAUT_OK,
          "model");
    test_roles();
    test_version();
    test_no_program();
    test_children_of_the_host();
    test_host();
    test_bare_host();
    test_threads();
    test_hang();
    test_mute();
    test_watched();
    test_proportion();
    fake_cad_as(NULL);
    if (taut_system_helper("taut-cad", "TAUT_CAD", program)) {
        test_requests(program);
        test_limits(program);
    }
    taut_model_free(model);
    folder_remove();
    return check_failures != 0;
}
