/* test_outputs.c -- outputs that appear together or not at all.
 *
 * needs: posix
 */
#include "check.h"
#include "folder.h"
#include "models.h"

#include "io/format.h"
#include "taut/certify.h"
#include "taut/construct.h"
#include "taut/draw.h"
#include "taut/read.h"
#include "taut/write.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

static const char *folder;

static int file_is(const char *path, const char *expected)
{
    char *found = file_bytes(path, NULL);
    const int is = found != NULL && strcmp(found, expected) == 0;
    free(found);
    return is;
}

static taut_outputs *new_outputs(void)
{
    taut_outputs *outputs = NULL;
    CHECK(taut_outputs_new(&outputs) == TAUT_OK, "outputs");
    return outputs;
}

static taut_status put(taut_outputs *outputs, const char *text, const char *path)
{
    return taut_outputs_text(outputs, text, strlen(text), path, NULL);
}

static void test_together(void)
{
    taut_outputs *outputs = new_outputs();
    file_put_text(in_folder("b"), "old");
    CHECK(put(outputs, "one", in_folder("a")) == TAUT_OK, "a");
    CHECK(put(outputs, "two", in_folder("b")) == TAUT_OK, "b");
    CHECK(access(in_folder("a"), F_OK) != 0 && file_is(in_folder("b"), "old"),
          "nothing is visible before the commit");
    CHECK(taut_outputs_commit(outputs, NULL) == TAUT_OK, "commit");
    CHECK(file_is(in_folder("a"), "one") && file_is(in_folder("b"), "two"), "all is in place");
    CHECK(taut_outputs_commit(outputs, NULL) == TAUT_OK, "a second commit has nothing to do");
    taut_outputs_abandon(outputs);
    taut_outputs_free(outputs);
    CHECK(folder_entries() == 2, "%d entries", folder_entries());
    folder_empty();
}

/* A pipe of a cubic axis, with details, curves and certificate. */
static taut_model *new_pipe(void)
{
    static const char text[] = "{\"taut\": 1, \"construct\": \"pipe\", \"radius\": 1,"
                               " \"polygon\": [[5, 0, 0], [5, 2, 0], [0, 6, 0], [0, 6, 3]],"
                               " \"shape\": {\"alpha\": 0, \"beta\": 0, \"gamma\": 0}}";
    taut_error error = {.message = ""};
    taut_problem *problem = NULL;
    taut_model *model = NULL;
    taut_certificate *certificate = NULL;
    CHECK(taut_problem_read_text(text, strlen(text), "pipe", &problem, &error) == TAUT_OK, "%s",
          error.message);
    CHECK(taut_make(problem, NULL, &model, &error) == TAUT_OK, "%s", error.message);
    CHECK(taut_certify(model, problem, NULL, &certificate, &error) == TAUT_OK, "%s", error.message);
    taut_model_set_certificate(model, certificate);
    taut_problem_free(problem);
    return model;
}

/* What is written to memory is what is written to a file. */
static void test_text(void)
{
    taut_model *model = new_pipe();
    taut_error error = {.message = ""};
    const char *const formats[] = {"json", "svg", "obj", "stl", "vtu"};
    const taut_write_options options = {.formats = taut_draw_formats()};
    for (int i = 0; i < 5; i++) {
        char name[16], *text = NULL, *bytes = NULL;
        size_t length = 0, size = 0;
        snprintf(name, sizeof name, "a.%s", formats[i]);
        CHECK(taut_model_write(model, in_folder(name), &options, &error) == TAUT_OK, "%s",
              error.message);
        CHECK(taut_model_write_text(model, formats[i], &options, &text, &length, &error) == TAUT_OK,
              "%s", error.message);
        bytes = file_bytes(in_folder(name), &size);
        CHECK(bytes != NULL && text != NULL && size == length && text[length] == '\0' &&
                  memcmp(bytes, text, size) == 0,
              "%s: %zu bytes, %zu in memory", formats[i], size, length);
        free(bytes);
        taut_text_free(text);
    }
    char *text = NULL;
    size_t length = 0;
    CHECK(taut_model_write_text(model, "nonsense", NULL, &text, &length, &error) ==
              TAUT_BAD_ARGUMENT,
          "no such format");
    CHECK(taut_model_write_text(model, "igs", NULL, &text, &length, &error) == TAUT_BAD_ARGUMENT &&
              strcmp(error.reason, "not-a-file") == 0,
          "%s", error.message);
    CHECK(taut_model_write_text(NULL, "json", NULL, &text, &length, &error) == TAUT_BAD_ARGUMENT,
          "no model");
    CHECK(taut_model_write_text(model, "obj", &(taut_write_options){.surface = "none"}, &text,
                                &length, &error) == TAUT_BAD_ARGUMENT &&
              text == NULL,
          "no such surface");
    taut_model_free(model);
    folder_empty();
}

/* A copy says the same, and lives on without what it was copied from. */
static void test_copy(void)
{
    taut_model *model = new_pipe(), *copy = NULL;
    char *before = NULL, *after = NULL;
    size_t length = 0;
    CHECK(taut_model_copy(NULL, &copy) == TAUT_BAD_ARGUMENT &&
              taut_model_copy(model, NULL) == TAUT_BAD_ARGUMENT,
          "arguments");
    CHECK(taut_model_set_unit(model, "ft") == TAUT_OK, "unit");
    CHECK(taut_model_write_text(model, "json", NULL, &before, &length, NULL) == TAUT_OK, "before");
    CHECK(taut_model_copy(model, &copy) == TAUT_OK, "copy");
    taut_model_free(model);
    CHECK(taut_model_write_text(copy, "json", NULL, &after, &length, NULL) == TAUT_OK, "after");
    CHECK(strcmp(before, after) == 0, "a copy differs");
    taut_text_free(before);
    taut_text_free(after);
    taut_model_free(copy);
}

static void test_never_committed(void)
{
    taut_outputs *outputs = new_outputs();
    file_put_text(in_folder("b"), "old");
    CHECK(put(outputs, "one", in_folder("a")) == TAUT_OK, "a");
    CHECK(put(outputs, "two", in_folder("b")) == TAUT_OK, "b");
    taut_outputs_free(outputs);
    CHECK(folder_entries() == 1 && file_is(in_folder("b"), "old"), "all is as it was");
    outputs = new_outputs();
    CHECK(put(outputs, "one", in_folder("a")) == TAUT_OK, "a");
    taut_outputs_abandon(outputs);
    CHECK(folder_entries() == 1, "abandoned: %d entries", folder_entries());
    taut_outputs_free(outputs);
    taut_outputs_free(NULL);
    taut_outputs_abandon(NULL);
    folder_empty();
}

/* Where files without a name cannot be had (here: no second descriptor is left for one) they have a
 * passing one, and all is as with the others. */
static void test_passing_name(void)
{
    struct rlimit old = {256, 1024};
    taut_outputs *outputs = new_outputs();
    taut_outputs *dropped = new_outputs();
    const int next = open("/dev/null", O_RDONLY);
    close(next);
    CHECK(getrlimit(RLIMIT_NOFILE, &old) == 0, "limit");
    CHECK(setrlimit(RLIMIT_NOFILE, &(struct rlimit){(rlim_t)next + 1, old.rlim_max}) == 0, "limit");
    CHECK(put(dropped, "none", in_folder("b")) == TAUT_OK, "b");
    CHECK(put(outputs, "one", in_folder("a")) == TAUT_OK, "a");
    CHECK(setrlimit(RLIMIT_NOFILE, &old) == 0, "limit");
    CHECK(folder_entries() == 2, "%d entries", folder_entries());
    taut_outputs_abandon(dropped);
    CHECK(folder_entries() == 1, "abandoned: %d entries", folder_entries());
    taut_outputs_free(dropped);
    CHECK(taut_outputs_commit(outputs, NULL) == TAUT_OK, "commit");
    taut_outputs_free(outputs);
    CHECK(folder_entries() == 1 && file_is(in_folder("a"), "one"), "%d entries", folder_entries());
    folder_empty();
}

/* The model as IGES where files without a name cannot be had, nor a pipe to a process: refused, and
 * nothing is left of the passing name. */
static taut_status write_iges(const taut_model *model, taut_error *error)
{
    return taut_model_write(model, in_folder("a.igs"), NULL, error);
}

static taut_status write_text(const taut_model *model, taut_error *error)
{
    taut_outputs *outputs = new_outputs();
    const taut_status status = taut_outputs_text(outputs, "one", 3, in_folder("a"), error);
    (void)model;
    taut_outputs_free(outputs);
    return status;
}

/* No descriptor is left but `few`. */
static void check_descriptors(const char *what, int few,
                              taut_status (*call)(const taut_model *, taut_error *))
{
    struct rlimit old = {256, 1024};
    taut_error error = {.status = TAUT_OK};
    taut_model *model = NULL;
    const int next = open("/dev/null", O_RDONLY);
    close(next);
    CHECK(taut_model_new(&model) == TAUT_OK, "model");
    add_any_curve(model, "one");
    CHECK(getrlimit(RLIMIT_NOFILE, &old) == 0, "limit");
    CHECK(setrlimit(RLIMIT_NOFILE, &(struct rlimit){(rlim_t)(next + few), old.rlim_max}) == 0,
          "limit");
    const taut_status status = call(model, &error);
    CHECK(setrlimit(RLIMIT_NOFILE, &old) == 0, "limit");
    CHECK(status == TAUT_IO && strstr(error.message, strerror(EMFILE)) != NULL, "%s: %d %s", what,
          (int)status, error.message);
    CHECK(folder_entries() == 0, "%s: %d entries", what, folder_entries());
    taut_model_free(model);
}

static void test_no_descriptor(void)
{
    check_descriptors("text", 0, write_text);
    check_descriptors("iges, one descriptor", 1, write_iges);
    check_descriptors("iges, two descriptors", 2, write_iges);
}

/* A target that turned into a folder cannot be replaced: the file has its passing name by then, and
 * loses it again. */
static void test_target_became_folder(void)
{
    taut_outputs *outputs = new_outputs();
    taut_error error = {.status = TAUT_OK};
    CHECK(put(outputs, "one", in_folder("a")) == TAUT_OK, "a");
    CHECK(mkdir(in_folder("a"), 0700) == 0, "mkdir");
    CHECK(taut_outputs_commit(outputs, &error) == TAUT_IO, "commit");
    CHECK(strstr(error.message, in_folder("a")) != NULL, "\"%s\"", error.message);
    taut_outputs_free(outputs);
    CHECK(folder_entries() == 1, "%d entries", folder_entries());
    CHECK(rmdir(in_folder("a")) == 0, "rmdir");
}

/* A device that is full is found before any file appears. */
static void test_full_device(void)
{
    taut_outputs *outputs = new_outputs();
    taut_error error = {.status = TAUT_OK};
    CHECK(put(outputs, "one", in_folder("a")) == TAUT_OK, "a");
    CHECK(put(outputs, "two", "/dev/full") == TAUT_OK, "full");
    CHECK(taut_outputs_commit(outputs, &error) == TAUT_IO, "commit");
    CHECK(strstr(error.message, "/dev/full") != NULL && strstr(error.message, "space") != NULL,
          "\"%s\"", error.message);
    CHECK(folder_entries() == 0, "%d entries", folder_entries());
    taut_outputs_free(outputs);
}

/* A file system that fills up while writing: here, a limit on the size of files. A large text meets
 * it at once, a small one when its file is closed. */
static void test_no_space(void)
{
    static const size_t sizes[] = {1 << 20, 4000};
    char *text = calloc(1, 1 << 20);
    void (*const old_signal)(int) = signal(SIGXFSZ, SIG_IGN);
    for (int k = 0; k < 2; k++) {
        struct rlimit old = {RLIM_INFINITY, RLIM_INFINITY};
        taut_outputs *outputs = new_outputs();
        taut_error error = {.status = TAUT_OK};
        CHECK(getrlimit(RLIMIT_FSIZE, &old) == 0 &&
                  setrlimit(RLIMIT_FSIZE, &(struct rlimit){1024, old.rlim_max}) == 0,
              "limit");
        const taut_status status =
            taut_outputs_text(outputs, text, sizes[k], in_folder("x.json"), &error);
        CHECK(setrlimit(RLIMIT_FSIZE, &old) == 0, "limit");
        CHECK(status == TAUT_IO && strstr(error.message, strerror(EFBIG)) != NULL, "%zu: %d %s",
              sizes[k], (int)status, error.message);
        CHECK(taut_outputs_commit(outputs, &error) == TAUT_OK, "nothing is to be put in place");
        taut_outputs_free(outputs);
        CHECK(folder_entries() == 0, "%zu: %d entries", sizes[k], folder_entries());
    }
    signal(SIGXFSZ, old_signal);
    free(text);
}

static void check_refused(const char *path, const char *reason)
{
    taut_outputs *outputs = new_outputs();
    taut_error error = {.status = TAUT_OK};
    CHECK(taut_outputs_text(outputs, "x", 1, path, &error) == TAUT_IO, "%s", path);
    CHECK(strstr(error.message, reason) != NULL, "%s: \"%s\"", path, error.message);
    taut_outputs_free(outputs);
}

static void test_refused_paths(void)
{
    char path[5000];
    check_refused(folder, "directory");
    check_refused(in_folder("none/a.json"), strerror(ENOENT));
    file_put_text(in_folder("file"), "x");
    check_refused(in_folder("file/a.json"), strerror(ENOTDIR));
    check_refused("", strerror(ENOENT));
    memset(path, 'x', sizeof path - 1);
    path[sizeof path - 1] = '\0';
    check_refused(path, strerror(ENAMETOOLONG));
    CHECK(symlink("loop", in_folder("loop")) == 0, "link");
    check_refused(in_folder("loop"), strerror(ELOOP));
    if (geteuid() != 0) {
        chmod(in_folder("file"), 0400);
        check_refused(in_folder("file"), strerror(EACCES));
        chmod(folder, 0500);
        check_refused(in_folder("new"), strerror(EACCES));
        chmod(folder, 0700);
    }
    folder_empty();
}

/* Links are followed, also one that leads nowhere yet; modes stay. */
static void test_links_and_modes(void)
{
    taut_outputs *outputs = new_outputs();
    struct stat about;
    const mode_t mask = umask(027);

    file_put_text(in_folder("real"), "old");
    chmod(in_folder("real"), 0606);
    CHECK(symlink("real", in_folder("link")) == 0, "link");
    CHECK(symlink("later", in_folder("early")) == 0, "link");
    CHECK(put(outputs, "one", in_folder("link")) == TAUT_OK, "link");
    CHECK(put(outputs, "two", in_folder("early")) == TAUT_OK, "early");
    CHECK(taut_outputs_commit(outputs, NULL) == TAUT_OK, "commit");
    CHECK(file_is(in_folder("real"), "one") && file_is(in_folder("later"), "two"), "places");
    CHECK(lstat(in_folder("link"), &about) == 0 && S_ISLNK(about.st_mode), "still a link");
    CHECK(stat(in_folder("real"), &about) == 0 && (about.st_mode & 0777) == 0606, "mode %o",
          about.st_mode);
    CHECK(stat(in_folder("later"), &about) == 0 && (about.st_mode & 0777) == 0640, "mode %o",
          about.st_mode);
    umask(mask);
    taut_outputs_free(outputs);
    folder_empty();
}

static void test_same_place(void)
{
    taut_outputs *outputs = new_outputs();
    char other[128];
    snprintf(other, sizeof other, "%s/../%s/a", folder, strrchr(folder, '/') + 1);
    CHECK(put(outputs, "one", in_folder("a")) == TAUT_OK, "a");
    CHECK(put(outputs, "two", other) == TAUT_BAD_ARGUMENT, "the same file by another name");
    CHECK(put(outputs, "one", "-") == TAUT_OK, "standard output");
    CHECK(put(outputs, "two", "/dev/stdout") == TAUT_BAD_ARGUMENT, "standard output again");
    taut_outputs_free(outputs);
    CHECK(folder_entries() == 0, "%d entries", folder_entries());
}

/* Standard output is sent at the commit, not before. */
static void test_standard_output(void)
{
    const int before = dup(1);
    const int file = open(in_folder("stdout"), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    taut_outputs *outputs = new_outputs();

    fflush(stdout);
    dup2(file, 1);
    CHECK(put(outputs, "lost", "-") == TAUT_OK, "put");
    taut_outputs_free(outputs);
    outputs = new_outputs();
    CHECK(put(outputs, "sent", "-") == TAUT_OK, "put");
    CHECK(taut_outputs_commit(outputs, NULL) == TAUT_OK, "commit");
    taut_outputs_free(outputs);
    dup2(before, 1);
    close(before);
    close(file);
    CHECK(file_is(in_folder("stdout"), "sent"), "what was committed, once");
    folder_empty();
}

/* Open at both ends and never waiting, so that a fifo nothing is written to fails at once. */
static void test_fifo(void)
{
    char found[16] = "";
    taut_outputs *outputs = new_outputs();
    int file = -1;
    CHECK(mkfifo(in_folder("fifo"), 0600) == 0, "fifo");
    file = open(in_folder("fifo"), O_RDWR | O_NONBLOCK | O_CLOEXEC);
    CHECK(file >= 0 && put(outputs, "through", in_folder("fifo")) == TAUT_OK, "put");
    CHECK(taut_outputs_commit(outputs, NULL) == TAUT_OK, "commit");
    CHECK(read(file, found, sizeof found - 1) == 7 && strcmp(found, "through") == 0, "\"%s\"",
          found);
    taut_outputs_free(outputs);
    close(file);
    folder_empty();
}

static void test_formats(void)
{
    taut_error error = {.status = TAUT_OK};
    CHECK(taut_format_count() >= 5, "formats");
    for (int i = 0; i < taut_format_count(); i++) {
        char path[32];
        snprintf(path, sizeof path, "x.y/z.%s", taut_format_ending(i));
        CHECK(taut_format_of(path, &error) == i && taut_format_text(i) != NULL, "%s", path);
        CHECK(i == 0 || strcmp(taut_format_ending(i - 1), taut_format_ending(i)) < 0, "sorted %d",
              i);
    }
    CHECK(taut_format_ending(-1) == NULL && taut_format_text(taut_format_count()) == NULL, "ends");
    CHECK(strcmp(taut_format_ending(taut_format_of("-", NULL)), "json") == 0, "-");
    CHECK(strcmp(taut_format_ending(taut_format_of("A.JSON", NULL)), "json") == 0, "capitals");
    CHECK(strcmp(taut_format_ending(taut_format_of("/dev/full", NULL)), "json") == 0, "device");
    CHECK(taut_format_of("json", &error) == -1 && error.status == TAUT_BAD_ARGUMENT &&
              strcmp(error.reason, "format") == 0,
          "\"%s\"", error.message);
    CHECK(taut_format_of("a.json/b", NULL) == -1 && taut_format_of("", NULL) == -1, "no ending");
    CHECK(taut_format_of(folder, &error) == -1 && error.status == TAUT_IO, "a folder");
}

/* What another library brings stands beside the library's own, in order, and with it only; of another version it is refused. */
static void test_more_formats(void)
{
    static const char *const drawn[] = {"html", "pdf", "png", "svg"};
    const taut_formats *more = taut_draw_formats();
    const taut_formats newer = {"99.0.0", more->count, more->rows};
    taut_error error = {.status = TAUT_OK};
    for (int i = 0; i < 4; i++) {
        char path[32];
        snprintf(path, sizeof path, "a.obj/b.%s", drawn[i]);
        const char *ending = taut_formats_ending(more, path, &error);
        CHECK(ending != NULL && strcmp(ending, drawn[i]) == 0, "%s", path);
        CHECK(taut_format_of(path, &error) == -1 && strcmp(error.reason, "format") == 0 &&
                  strstr(error.message, drawn[i]) != NULL &&
                  strstr(error.message, ".obj, .ply, .step") != NULL,
              "\"%s\"", error.message);
        CHECK(i == 0 || strcmp(more->rows[i - 1].ending, more->rows[i].ending) < 0, "sorted %d", i);
    }
    CHECK(strcmp(taut_formats_ending(more, "-", NULL), "json") == 0, "-");
    CHECK(strcmp(taut_formats_ending(more, "a.geomdl.json", NULL), "geomdl.json") == 0, "longer");
    CHECK(taut_formats_ending(more, "a.b", &error) == NULL, "none");
    CHECK(strcmp(error.message,
                 "the ending of a.b is not one of .3mf, .csv, .dxf, .geomdl.json, .glb, .html, "
                 ".iges, .igs, "
                 ".json, .obj, .pdf, .ply, .png, .step, .stl, .stp, .svg, .vtu") == 0,
          "\"%s\"", error.message);
    CHECK(taut_formats_ending(&newer, "a.svg", &error) == NULL &&
              error.status == TAUT_BAD_ARGUMENT && strstr(error.message, "99.0.0") != NULL,
          "\"%s\"", error.message);
}

static taut_status write_with(const taut_model *model, const taut_write_options *options,
                              taut_error *error)
{
    return taut_model_write(model, in_folder("m.json"), options, error);
}

/* One surface by its name; options out of their range. */
static void test_options(void)
{
    taut_model *model = NULL, *back = NULL;
    taut_error error = {.status = TAUT_OK};
    CHECK(taut_model_new(&model) == TAUT_OK, "model");
    add_any_surface(model, "one");
    add_any_surface(model, "two");
    add_any_surface(model, "two");
    add_any_curve(model, "one");
    CHECK(write_with(model, &(taut_write_options){.surface = "one"}, &error) == TAUT_OK, "%s",
          error.message);
    CHECK(taut_model_read(in_folder("m.json"), &back, NULL) == TAUT_OK, "read");
    CHECK(back != NULL && taut_model_surface_count(back) == 1 &&
              taut_model_curve_count(back) == 0 &&
              same_surface(taut_model_surface(model, 0), taut_model_surface(back, 0)),
          "only one");
    CHECK(write_with(model, &(taut_write_options){.surface = "two"}, &error) == TAUT_BAD_ARGUMENT &&
              strcmp(error.reason, "surface") == 0 && error.found == 2,
          "\"%s\"", error.message);
    CHECK(write_with(model, &(taut_write_options){.surface = "on"}, &error) == TAUT_BAD_ARGUMENT &&
              strcmp(error.reason, "surface") == 0 && strstr(error.message, "\"one\"") != NULL,
          "\"%s\"", error.message);
    CHECK(write_with(model, &(taut_write_options){.tolerance = nan("")}, NULL) == TAUT_BAD_ARGUMENT,
          "tolerance");
    CHECK(write_with(model, &(taut_write_options){.divide = -1}, NULL) == TAUT_BAD_ARGUMENT,
          "divide");
    CHECK(write_with(model, &(taut_write_options){.threads = -1}, NULL) == TAUT_BAD_ARGUMENT,
          "threads");
    CHECK(taut_model_write(model, in_folder("m.xyz"), NULL, NULL) == TAUT_BAD_ARGUMENT, "ending");
    CHECK(taut_model_write(NULL, "-", NULL, NULL) == TAUT_BAD_ARGUMENT, "NULL");
    taut_model_free(model);
    taut_model_free(back);
    folder_empty();
}

int main(void)
{
    folder = folder_make();
    test_together();
    test_text();
    test_copy();
    test_never_committed();
    test_passing_name();
    test_no_descriptor();
    test_target_became_folder();
    test_full_device();
    test_no_space();
    test_refused_paths();
    test_links_and_modes();
    test_same_place();
    test_standard_output();
    test_fifo();
    test_formats();
    test_more_formats();
    test_options();
    CHECK(folder_entries() == 0, "something was left behind");
    folder_remove();
    return check_failures != 0;
}
