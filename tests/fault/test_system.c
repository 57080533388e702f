/* test_system.c -- calls of the system that fail, and processes that die: each is told with its
 * reason, leaves no file and no process behind, and what can go on without it does.
 *
 * Functions of the C library are put before its own here; each fails once when it is asked to.
 *
 * needs: posix, and a C library that is loaded
 */
#define _GNU_SOURCE /* RTLD_NEXT, getrandom */
#include "calls.h"
#include "check.h"
#include "fake_cad.h"
#include "fault.h"
#include "folder.h"
#include "shapes.h"

#include "taut/read.h"
#include "taut/write.h"

#include <dlfcn.h>
#include <errno.h>
#include <signal.h>
#include <spawn.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/random.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

typedef enum system_call {
    CALL_NONE,
    CALL_FDOPEN,
    CALL_FCLOSE,
    CALL_GETRANDOM,
    CALL_FCHOWN,
    CALL_FCHMOD,
    CALL_PIPE,
    CALL_SPAWN
} system_call;

static system_call failing; /* the next such call fails... */
static int failing_reason;  /* ...with this errno */

static int fails(system_call call)
{
    const int now = failing == call;
    if (now) {
        failing = CALL_NONE;
        errno = failing_reason;
    }
    return now;
}

/* The C library's own function of this name, as a pointer of the type of *function. */
static void find_own(const char *name, void *function, size_t size)
{
    void *const symbol = dlsym(RTLD_NEXT, name);
    if (symbol == NULL || size != sizeof symbol) {
        abort();
    }
    memcpy(function, &symbol, size);
}

FILE *fdopen(int file, const char *mode)
{
    FILE *(*own)(int, const char *) = NULL;
    find_own("fdopen", &own, sizeof own);
    return fails(CALL_FDOPEN) ? NULL : own(file, mode);
}

int fclose(FILE *stream)
{
    int (*own)(FILE *) = NULL;
    find_own("fclose", &own, sizeof own);
    const int failed = fails(CALL_FCLOSE), result = own(stream);
    errno = failed ? failing_reason : errno;
    return failed ? EOF : result;
}

ssize_t getrandom(void *bytes, size_t length, unsigned flags)
{
    ssize_t (*own)(void *, size_t, unsigned) = NULL;
    find_own("getrandom", &own, sizeof own);
    return fails(CALL_GETRANDOM) ? -1 : own(bytes, length, flags);
}

int fchown(int file, uid_t user, gid_t group)
{
    int (*own)(int, uid_t, gid_t) = NULL;
    find_own("fchown", &own, sizeof own);
    return fails(CALL_FCHOWN) ? -1 : own(file, user, group);
}

int fchmod(int file, mode_t mode)
{
    int (*own)(int, mode_t) = NULL;
    find_own("fchmod", &own, sizeof own);
    return fails(CALL_FCHMOD) ? -1 : own(file, mode);
}

int pipe2(int ends[2], int flags)
{
    int (*own)(int *, int) = NULL;
    find_own("pipe2", &own, sizeof own);
    return fails(CALL_PIPE) ? -1 : own(ends, flags);
}

int posix_spawn(pid_t *process, const char *path, const posix_spawn_file_actions_t *files,
                const posix_spawnattr_t *attributes, char *const words[], char *const environment[])
{
    int (*own)(pid_t *, const char *, const posix_spawn_file_actions_t *, const posix_spawnattr_t *,
               char *const *, char *const *) = NULL;
    find_own("posix_spawn", &own, sizeof own);
    return fails(CALL_SPAWN) ? failing_reason
                             : own(process, path, files, attributes, words, environment);
}

/* The text on its way to the path, with a call failing: from its staging on, or only while it is
 * put in place. */
static taut_status put(const char *path, system_call staging, system_call placing, int reason,
                       taut_error *error)
{
    taut_outputs *outputs = NULL;
    CHECK(taut_outputs_new(&outputs) == TAUT_OK, "outputs");
    failing_reason = reason;
    failing = staging;
    taut_status status = taut_outputs_text(outputs, "text", 4, path, error);
    if (status == TAUT_OK) {
        failing = placing != CALL_NONE ? placing : failing;
        status = taut_outputs_commit(outputs, error);
    }
    CHECK(failing == CALL_NONE, "call %d is not made", (int)failing);
    failing = CALL_NONE;
    taut_outputs_free(outputs);
    return status;
}

static void test_outputs(void)
{
    static const struct {
        const char *name; /* NULL: a device */
        system_call staging, placing;
        int reason;
        taut_status expected;
        const char *word;
    } rows[] = {
        {"a", CALL_FDOPEN, CALL_NONE, ENOMEM, TAUT_NO_MEMORY, "memory"},
        {"a", CALL_FCLOSE, CALL_NONE, ENOSPC, TAUT_IO, "write"},
        {"a", CALL_FCLOSE, CALL_NONE, 0, TAUT_IO, "write"},
        {"a", CALL_GETRANDOM, CALL_NONE, ENOSYS, TAUT_IO, "write"},
        {NULL, CALL_FCLOSE, CALL_NONE, ENOMEM, TAUT_NO_MEMORY, "memory"},
        {NULL, CALL_NONE, CALL_FDOPEN, ENOMEM, TAUT_IO, "write"},
        {NULL, CALL_NONE, CALL_FCLOSE, ENOSPC, TAUT_IO, "write"},
    };
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        const char *const path = rows[i].name != NULL ? in_folder(rows[i].name) : "/dev/null";
        taut_error error = {.status = TAUT_OK};
        const taut_status status =
            put(path, rows[i].staging, rows[i].placing, rows[i].reason, &error);
        CHECK(status == rows[i].expected && error.status == status &&
                  strcmp(error.reason, rows[i].word) == 0,
              "row %zu: %d, \"%s\"", i, (int)status, error.message);
        CHECK(status != TAUT_IO || strstr(error.message, path) != NULL, "row %zu: \"%s\"", i,
              error.message);
        CHECK(folder_entries() == 0, "row %zu: %d entries", i, folder_entries());
    }
}

/* A file that may be written but not given its old owner or mode is replaced all the same. */
static void test_owner_and_mode(void)
{
    static const system_call calls[] = {CALL_NONE, CALL_FCHOWN, CALL_FCHMOD};
    for (int k = 0; k < 3; k++) {
        const char *const path = in_folder("old");
        char *found = NULL;
        struct stat about;
        taut_error error = {.status = TAUT_OK};
        file_put_text(path, "");
        CHECK(chmod(path, 0604) == 0, "%s", path);
        CHECK(put(path, calls[k], CALL_NONE, EPERM, &error) == TAUT_OK, "%s", error.message);
        found = file_bytes(path, NULL);
        CHECK(found != NULL && strcmp(found, "text") == 0, "what is written is there");
        free(found);
        CHECK(stat(path, &about) == 0 &&
                  ((about.st_mode & 0777) == 0604) == (calls[k] != CALL_FCHMOD),
              "mode %o", about.st_mode & 0777U);
        unlink(path);
    }
}

/* No child is left, dead or alive. */
static void check_no_child(size_t row)
{
    CHECK(waitpid(-1, NULL, WNOHANG) == -1 && errno == ECHILD, "row %zu: a child is left", row);
}

typedef struct start {
    system_call call; /* that fails */
    int reason;
    taut_status status;
    const char *word;
} start;

static const start starts[] = {
    {CALL_PIPE, EMFILE, TAUT_IO, "process"},  {CALL_PIPE, ENOMEM, TAUT_NO_MEMORY, "memory"},
    {CALL_SPAWN, EAGAIN, TAUT_IO, "process"}, {CALL_SPAWN, ENOMEM, TAUT_NO_MEMORY, "memory"},
    {CALL_SPAWN, ENOEXEC, TAUT_IO, "helper"},
};

/* OpenCASCADE's process is not to be had: the file or the model is refused. How it dies is in
 * unit/io/cad/helper. */
static void test_processes(const taut_model *model, const char *path)
{
    fake_cad_as("reader");
    for (size_t i = 0; i < sizeof starts / sizeof starts[0]; i++) {
        for (int writing = 0; writing < 2; writing++) {
            taut_error error = {.status = TAUT_OK};
            taut_model *read = NULL;
            failing = starts[i].call;
            failing_reason = starts[i].reason;
            const taut_status status =
                writing ? taut_model_write(model, in_folder("out.igs"), NULL, &error)
                        : taut_model_read(path, &read, &error);
            CHECK(failing == CALL_NONE, "row %zu: the call is not made", i);
            CHECK(status == starts[i].status && error.status == status &&
                      strcmp(error.reason, starts[i].word) == 0,
                  "row %zu: %d, \"%s\"", i, (int)status, error.message);
            CHECK(read == NULL && folder_entries() == 1, "row %zu: %d entries", i,
                  folder_entries());
            check_no_child(i);
        }
    }
}

/* There is no stream for the request. */
static void test_no_stream(const char *path)
{
    taut_error error = {.status = TAUT_OK};
    taut_model *read = NULL;
    failing = CALL_FDOPEN;
    failing_reason = ENOMEM;
    CHECK(taut_model_read(path, &read, &error) == TAUT_NO_MEMORY && read == NULL, "%s",
          error.message);
    check_no_child(0);
}

static taut_status read_either(const void *context, void **result, taut_error *error)
{
    taut_model *model = *result;
    taut_problem *problem = NULL;
    const taut_status status = taut_problem_or_model_read(context, &problem, &model, error);
    CHECK(problem == NULL, "a problem of a drawing");
    *result = model;
    return status;
}

static taut_status write_iges(const void *context, void **result, taut_error *error)
{
    const char *const path = in_folder("out.igs");
    const taut_status status = taut_model_write(context, path, NULL, error);
    (void)result;
    CHECK((unlink(path) == 0) == (status == TAUT_OK), "a file that is there after all, or not");
    return status;
}

/* A drawing read and written when memory runs out, with a taut-cad that says the same each time. */
static void test_memory(const taut_model *model, const char *path)
{
    const fault_call calls[] = {{"read", read_model, release_model, path},
                                {"read either", read_either, release_model, path},
                                {"write", write_iges, NULL, model}};
    for (int i = 0; i < 3; i++) {
        fake_cad_as(calls[i].call == write_iges ? "writer" : "reader");
        const long count = fault_loop(&calls[i]);
        CHECK(count > 15, "%s: %ld allocations", calls[i].name, count);
    }
    check_no_child(0);
}

/* What is to be said of what was read stands in the model's details. */
static void test_notes(const char *path)
{
    taut_model *model = NULL;
    taut_error error = {.status = TAUT_OK};
    fake_cad_as("reader");
    CHECK(taut_model_read(path, &model, &error) == TAUT_OK, "%s", error.message);
    if (model == NULL) {
        return;
    }
    const taut_record *details = taut_model_details(model);
    const taut_record *notes = taut_record_get(details, "notes");
    CHECK(strcmp(taut_model_unit(model), "in") == 0 && taut_model_surface_count(model) == 1 &&
              taut_model_curve_count(model) == 1,
          "items");
    CHECK(strcmp(taut_record_text(taut_record_get(details, "read_from")), "STEP") == 0, "STEP");
    CHECK(taut_record_count(notes) == 2 &&
              strcmp(taut_record_text(taut_record_at(notes, 0)),
                     "surface 1 \"face\": the original is no NURBS; this comes near it") == 0 &&
              strcmp(taut_record_text(taut_record_at(notes, 1)),
                     "curve 1 \"edge\": the original is no NURBS; this comes near it") == 0,
          "notes");
    taut_model_free(model);
}

int main(void)
{
    static const double points[12] = {0, 0, 0, 0, 1, 0, 1, 0, 0, 1, 1, 1};
    static const char drawing[] = "ISO-10303-21;\nEND-ISO-10303-21;\n";
    const struct rlimit none = {0, 0};
    taut_model *model = NULL;
    char path[96];

    fake_cad_play();
    folder_make();
    CHECK(setrlimit(RLIMIT_CORE, &none) == 0, "no core files");
    CHECK(taut_model_new(&model) == TAUT_OK &&
              taut_model_add_surface(model, shape_saddle(0.5)) == TAUT_OK &&
              taut_model_add_curve(model, shape_curve(shape_bezier(1, 0, 1), points, NULL)) ==
                  TAUT_OK,
          "model");
    test_outputs();
    test_owner_and_mode();

    snprintf(path, sizeof path, "%s", in_folder("drawing.step"));
    file_put_text(path, drawing);
    test_processes(model, path);
    test_no_stream(path);
    test_memory(model, path);
    test_notes(path);

    taut_model_free(model);
    CHECK(fault_live() == 0, "%ld blocks left", fault_live());
    CHECK(unlink(path) == 0 && folder_entries() == 0, "something is left");
    folder_remove();
    return check_failures != 0;
}
