/* gaps.c -- how long the library works between two calls of a monitor: processor time of one thread, and after which call.
 *
 * Calls go by the work that is done, so that they are the same in every run: of each gap the least of ROUNDS runs is its
 * time, which other work on the machine cannot make longer for long. Before the first call and after the last count too.
 *
 *     bench-gaps [--least MS] [--only PART[,PART...]] [--rounds N] [NAME or FILE...]
 *
 * All examples and nets of 100 to 800 points a side, if none is named; only gaps of MS milliseconds and more (0); only these
 * parts of the work, and `make`, which comes before them all (all); runs (ROUNDS).
 */
#include "machine.h"
#include "task.h"

#include "cli/embedded_files.h"
#include "taut/taut.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { ROUNDS = 5, WORD = 24, PANELS_MAX = 400 };

typedef struct gap {
    double seconds; /* least so far */
    char after[WORD];
    int number; /* of the call before it, 0: none */
} gap;

typedef struct recorder {
    gap *gaps;
    size_t count, room, next;
    double since;
} recorder;

static void fail(const char *what)
{
    fprintf(stderr, "bench-gaps: %s\n", what);
    exit(6);
}

static void *need(void *memory)
{
    if (memory == NULL) {
        fail("no memory");
    }
    return memory;
}

/* What follows the call that ends the gap is not known yet: its word is said by the call before. */
static void end_gap(recorder *r)
{
    const double seconds = bench_cpu_seconds() - r->since;
    if (r->next == r->count) {
        fail("another number of calls in another run");
    }
    r->gaps[r->next].seconds = fmin(r->gaps[r->next].seconds, seconds);
    r->next++;
}

static void begin_gap(recorder *r, const char *after)
{
    if (r->next == r->count) {
        if (r->count == r->room) {
            r->room = 2 * r->room + 64;
            r->gaps = need(realloc(r->gaps, r->room * sizeof *r->gaps));
        }
        r->gaps[r->count] = (gap){.seconds = INFINITY, .number = (int)r->count};
        snprintf(r->gaps[r->count++].after, WORD, "%s", after);
    }
    r->since = bench_cpu_seconds();
}

static int record(void *context, double done, const char *what)
{
    (void)done;
    end_gap(context);
    begin_gap(context, what);
    return TAUT_GO_ON;
}

typedef enum part { MAKE, PROVE, MEASURE, MESH, GRADIENT, PANELS, FILES } part;
/* From FILES on they are the formats of files. */
static const char *const part_names[] = {
    "make", "prove", "measure", "mesh", "gradient", "panels", "3mf", "geomdl.json", "glb", "json",
    "obj",  "ply",   "step",    "stl",  "vtu",      "html",   "pdf", "png",         "svg"};
enum { PARTS = sizeof part_names / sizeof *part_names };

/* What is asked for. */
typedef struct wishes {
    double least;
    const char *only; /* or NULL: all */
    int rounds;
} wishes;

static int is_wished(const wishes *wish, int which)
{
    const size_t length = strlen(part_names[which]);
    const char *at = wish->only;
    while (at != NULL && *at != '\0') {
        const size_t word = strcspn(at, ",");
        if (word == length && memcmp(at, part_names[which], length) == 0) {
            return 1;
        }
        at += word + (at[word] == ',');
    }
    return at == NULL || which == MAKE;
}

/* The area's derivatives by what was given; of films these take a system that is solved. */
static taut_status derive(const taut_problem *problem, const taut_model *model,
                          taut_monitor monitor, taut_error *error)
{
    const taut_film_gradient_request of_film = {.of = TAUT_FILM_GRADIENT_AREA, .monitor = monitor};
    const taut_gradient_request request = {.monitor = monitor};
    taut_film_slopes slopes = {.points = NULL};
    const taut_surface *surface = taut_model_surface(model, 0);
    taut_status status = TAUT_OK;
    if (strcmp(taut_problem_construction(problem), "film") == 0) {
        return taut_gradient_of_film(problem, model, &of_film, &slopes, error);
    }
    if (surface == NULL) {
        return TAUT_BAD_ARGUMENT;
    }
    const size_t room = (size_t)taut_basis_count(taut_surface_u(surface)) *
                        (size_t)taut_basis_count(taut_surface_v(surface));
    double *gradient = need(calloc(room, 3 * sizeof(double)));
    status = taut_gradient(problem, model, &request, gradient, error);
    free(gradient);
    return status;
}

static taut_status measure_all(const taut_model *model, taut_monitor monitor, taut_error *error)
{
    const taut_measure_options options = {.monitor = monitor};
    taut_surface_measure measure;
    taut_status status = TAUT_OK;
    for (int i = 0; i < taut_model_surface_count(model) && status == TAUT_OK; i++) {
        status = taut_measure_surface(taut_model_surface(model, i), &options, &measure, error);
    }
    return status;
}

/* One part of the work, its calls recorded. */
static taut_status run(int which, const taut_problem *problem, taut_model **model, recorder *r,
                       taut_error *error)
{
    const taut_monitor monitor = {record, r};
    const taut_make_options make = {.monitor = monitor};
    const taut_certify_options prove = {.monitor = monitor};
    const taut_mesh_options mesh = {.monitor = monitor};
    const taut_panels_options panels = {.monitor = monitor, .divide = {PANELS_MAX, PANELS_MAX}};
    const taut_write_options write = {.monitor = monitor, .formats = taut_draw_formats()};
    taut_certificate *certificate = NULL;
    taut_mesh *made = NULL;
    taut_model *flat = NULL;
    char *text = NULL;
    size_t length = 0;
    taut_status status = TAUT_OK;

    r->next = 0;
    begin_gap(r, "the beginning");
    switch (which) {
    case MAKE:
        status = taut_make(problem, &make, model, error);
        break;
    case PROVE:
        status = taut_certify(*model, problem, &prove, &certificate, error);
        break;
    case MEASURE:
        status = measure_all(*model, monitor, error);
        break;
    case MESH:
        status = taut_mesh_new(*model, &mesh, &made, error);
        break;
    case GRADIENT:
        status = derive(problem, *model, monitor, error);
        break;
    case PANELS:
        status = taut_panels_of_model(*model, &panels, &flat, error);
        break;
    default:
        status = taut_model_write_text(*model, part_names[which], &write, &text, &length, error);
        break;
    }
    end_gap(r);
    taut_model_free(flat);
    taut_text_free(text);
    taut_certificate_free(certificate);
    taut_mesh_free(made);
    return status;
}

static void print(const char *name, int which, const recorder *r, double least)
{
    size_t worst = 0;
    double sum = 0.0;
    for (size_t i = 0; i < r->count; i++) {
        sum += r->gaps[i].seconds;
        worst = r->gaps[i].seconds > r->gaps[worst].seconds ? i : worst;
    }
    for (size_t i = 0; i < r->count; i++) {
        if (i == worst ? 1e3 * r->gaps[i].seconds >= least
                       : least > 0 && 1e3 * r->gaps[i].seconds >= least) {
            printf("%-28s %-11s %8.1f ms  after %s (%d of %zu; %.0f ms in all)\n", name,
                   part_names[which], 1e3 * r->gaps[i].seconds, r->gaps[i].after, r->gaps[i].number,
                   r->count - 1, 1e3 * sum);
        }
    }
    fflush(stdout);
}

static void run_document(const char *name, const char *text, size_t length, const wishes *wish)
{
    recorder recorders[PARTS] = {{0}};
    taut_problem *problem = NULL;
    taut_error error = {0};
    taut_status status = taut_problem_read_text(text, length, name, &problem, &error);

    for (int round = 0; round < wish->rounds && status == TAUT_OK; round++) {
        taut_model *model = NULL;
        for (int p = 0; p < PARTS && status == TAUT_OK; p++) {
            status = is_wished(wish, p) ? run(p, problem, &model, &recorders[p], &error) : TAUT_OK;
            if (p >= GRADIENT && status != TAUT_OK && status != TAUT_NO_MEMORY) {
                status = TAUT_OK; /* there is no such thing of it, or cairo is not here */
            }
        }
        taut_model_free(model);
    }
    for (int p = 0; p < PARTS; p++) {
        if (recorders[p].count > 0 && isfinite(recorders[p].gaps[recorders[p].count - 1].seconds)) {
            print(name, p, &recorders[p], wish->least);
        }
        free(recorders[p].gaps);
    }
    if (status != TAUT_OK) {
        printf("%-28s %s\n", name, error.message);
    }
    taut_problem_free(problem);
}

/* A bicubic net of m x m points inside a frame. */
static void run_net(int m, const wishes *wish)
{
    const size_t room = 256 + (size_t)m * (size_t)m * 80;
    char *text = need(malloc(room)), name[32];
    size_t at = (size_t)snprintf(
        text, room,
        "{\"taut\": 1, \"construct\": \"dirichlet\",\n\"u\": {\"type\": \"bspline\", \"degree\": "
        "3, \"count\": "
        "%d},\n\"v\": {\"type\": \"bspline\", \"degree\": 3, \"count\": %d},\n\"points\": [",
        m, m);
    for (int i = 0; i < m; i++) {
        at += (size_t)snprintf(text + at, room - at, i > 0 ? ",\n[" : "[");
        for (int j = 0; j < m; j++) {
            const int inside = i > 0 && j > 0 && i < m - 1 && j < m - 1;
            double p[3];
            bench_frame_point(m, i, j, p);
            at += (size_t)(inside ? snprintf(text + at, room - at, "%snull", j > 0 ? ", " : "")
                                  : snprintf(text + at, room - at, "%s[%.17g, %.17g, %.17g]",
                                             j > 0 ? ", " : "", p[0], p[1], p[2]));
        }
        at += (size_t)snprintf(text + at, room - at, "]");
    }
    at += (size_t)snprintf(text + at, room - at, "]}\n");
    snprintf(name, sizeof name, "net of %d x %d", m, m);
    run_document(name, text, at, wish);
    free(text);
}

static void run_file(const char *path, const wishes *wish)
{
    FILE *file = fopen(path, "rb");
    char *text = NULL;
    size_t length = 0, room = 0, got = 0;
    if (file == NULL) {
        fail(path);
    }
    do {
        room = 2 * room + 4096;
        text = need(realloc(text, room));
        got = fread(text + length, 1, room - length, file);
        length += got;
    } while (length == room);
    fclose(file);
    run_document(path, text, length, wish);
    free(text);
}

static const taut_embedded *find_example(const char *name)
{
    for (const taut_embedded *file = taut_examples; file->name != NULL; file++) {
        const size_t length = strcspn(file->name, ".");
        if (strlen(name) == length && memcmp(name, file->name, length) == 0) {
            return file;
        }
    }
    return NULL;
}

int main(int argc, char **argv)
{
    static const int nets[] = {100, 200, 400, 800};
    wishes wish = {.rounds = ROUNDS};
    int first = 1;
    for (; first + 1 < argc && strncmp(argv[first], "--", 2) == 0; first += 2) {
        if (strcmp(argv[first], "--least") == 0) {
            wish.least = atof(argv[first + 1]);
        } else if (strcmp(argv[first], "--only") == 0) {
            wish.only = argv[first + 1];
        } else if (strcmp(argv[first], "--rounds") == 0) {
            wish.rounds = atoi(argv[first + 1]);
        } else {
            fail(argv[first]);
        }
    }
    for (int i = first; i < argc; i++) {
        const taut_embedded *example = find_example(argv[i]);
        if (example != NULL) {
            run_document(argv[i], example->text, example->length, &wish);
        } else if (strncmp(argv[i], "net-", 4) == 0) {
            run_net(atoi(argv[i] + 4), &wish);
        } else {
            run_file(argv[i], &wish);
        }
    }
    for (const taut_embedded *file = taut_examples; first == argc && file->name != NULL; file++) {
        char name[64];
        snprintf(name, sizeof name, "%.*s", (int)strcspn(file->name, "."), file->name);
        run_document(name, file->text, file->length, &wish);
    }
    for (size_t k = 0; first == argc && k < sizeof nets / sizeof *nets; k++) {
        run_net(nets[k], &wish);
    }
    return 0;
}
