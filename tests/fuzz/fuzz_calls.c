/* fuzz_calls.c -- public functions that take counts and numbers, called with any.
 *
 * The input says a small surface, then calls with their arguments. Every call must come back with a
 * status it documents, its output made on success and left alone on failure.
 */
#include "outcome.h"

#include "taut/join.h"
#include "taut/measure.h"
#include "taut/mesh.h"
#include "taut/operations.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

enum { CALLS_MAX = 6, POINTS_MAX = 200, LINES_MAX = 16 };

typedef struct input {
    const uint8_t *data;
    size_t size;
} input;

static int byte(input *in)
{
    if (in->size == 0) {
        return 0;
    }
    in->size--;
    return *in->data++;
}

static void take(input *in, void *to, size_t size)
{
    const size_t n = in->size < size ? in->size : size;
    memset(to, 0, size);
    memcpy(to, in->data, n);
    in->data += n;
    in->size -= n;
}

/* Mostly small, sometimes any. */
static int integer(input *in)
{
    const int b = byte(in);
    int32_t any = 0;
    if (b < 200) {
        return b % 20 - 3;
    }
    take(in, &any, sizeof any);
    return any;
}

/* Mostly in [-1, 2], sometimes any, NaN and infinities included. */
static double number(input *in)
{
    const int b = byte(in);
    double any = 0;
    if (b < 200) {
        return (double)(b % 97) / 32 - 1;
    }
    take(in, &any, sizeof any);
    return any;
}

static double finite(input *in)
{
    const double x = number(in);
    return isfinite(x) && fabs(x) < 1e30 ? x : 0.5;
}

static taut_basis *make_basis(input *in)
{
    const taut_basis_spec specs[] = {
        {.type = "bezier", .degree = 1 + byte(in) % 6},
        {.type = "bspline", .degree = 2, .count = 3 + byte(in) % 6},
        {.type = "bspline", .degree = 3, .count = 4 + byte(in) % 6},
        {.type = "c-bezier", .alpha = 0.1 + byte(in) % 30 * 0.1},
        {.type = "c-bspline", .alpha = 0.1 + byte(in) % 30 * 0.1, .segments = 1 + byte(in) % 4},
        {.type = "h-bezier", .beta = 0.1 + byte(in) % 30 * 0.2},
        {.type = "h-bspline", .beta = 0.1 + byte(in) % 30 * 0.2, .segments = 1 + byte(in) % 4},
        {.type = "ce-bezier", .alpha = 1, .beta = 1, .gamma = -0.5}};
    taut_basis *basis = NULL;
    require(taut_basis_new(&specs[(size_t)byte(in) % (sizeof specs / sizeof specs[0])], 0, &basis,
                           NULL) == TAUT_OK);
    return basis;
}

static taut_surface *make_surface(input *in)
{
    static double points[3 * POINTS_MAX], weights[POINTS_MAX];
    taut_basis *u = make_basis(in), *v = make_basis(in);
    const int count = taut_basis_count(u) * taut_basis_count(v);
    const int rational =
        taut_basis_allows_weights(u) && taut_basis_allows_weights(v) && byte(in) % 2;
    taut_surface *surface = NULL;
    require(count <= POINTS_MAX);
    for (int i = 0; i < count; i++) {
        for (int c = 0; c < 3; c++) {
            points[3 * i + c] = finite(in);
        }
        weights[i] = 0.25 + byte(in) % 8;
    }
    require(taut_surface_new("s", u, v, points, rational ? weights : NULL, &surface, NULL) ==
            TAUT_OK);
    taut_basis_free(u);
    taut_basis_free(v);
    return surface;
}

/* Takes the place of the surface when one was made. */
static void exchange(taut_surface **surface, taut_status status, taut_surface *made,
                     const taut_error *error)
{
    require((status == TAUT_OK) == (made != NULL));
    if (status != TAUT_OK) {
        require_error(status, error);
        require(status != TAUT_INTERNAL && status != TAUT_IO);
        return;
    }
    const int count =
        taut_basis_count(taut_surface_u(made)) * taut_basis_count(taut_surface_v(made));
    if (count <= POINTS_MAX) { /* it may grow, but not past what the next calls can do quickly */
        taut_surface_free(*surface);
        *surface = made;
    } else {
        taut_surface_free(made);
    }
}

static void operate(input *in, taut_surface **surface)
{
    taut_surface *made = NULL;
    taut_error error = {.status = TAUT_OK};
    taut_status status = TAUT_OK;
    const int direction = byte(in) % 3, times = integer(in), kind = byte(in) % 7;
    const double a = number(in), b = number(in);
    double matrix[12];
    switch (kind) {
    case 0:
        status = taut_surface_insert(*surface, direction, a, times, &made, &error);
        break;
    case 1:
        status = taut_surface_elevate(*surface, direction, times, &made, &error);
        break;
    case 2:
        status = taut_surface_rerange(*surface, direction, a, b, &made, &error);
        break;
    case 3:
        status = taut_surface_reverse(*surface, direction, &made, &error);
        break;
    case 4:
        status = taut_surface_refine(*surface, direction, &made, &error);
        break;
    case 5:
        status = taut_surface_to_nurbs(*surface, a > 0 && a < 1e-9 ? 1e-9 : a, &made, NULL, &error);
        break;
    default:
        for (int i = 0; i < 12; i++) {
            matrix[i] = number(in);
        }
        status = taut_surface_transform(*surface, matrix, &made, &error);
        break;
    }
    exchange(surface, status, made, &error);
}

static void split(input *in, const taut_surface *surface)
{
    taut_model *pieces = NULL;
    taut_error error = {.status = TAUT_OK};
    const int direction = byte(in) % 3;
    const taut_status status = taut_surface_split(surface, direction, number(in), &pieces, &error);
    require((status == TAUT_OK) == (pieces != NULL));
    if (status == TAUT_OK) {
        require_model(pieces);
    }
    taut_model_free(pieces);
}

/* A grid inside and outside of the range; nothing is written on refusal. */
static void evaluate(input *in, const taut_surface *surface)
{
    static double values[LINES_MAX * LINES_MAX * 6 * 3];
    double t[2][LINES_MAX];
    const int nu = integer(in), nv = integer(in), order = integer(in), threads = byte(in) % 4;
    for (int i = 0; i < LINES_MAX; i++) {
        t[0][i] = number(in);
        t[1][i] = number(in);
    }
    if (nu <= LINES_MAX && nv <= LINES_MAX) { /* more would be the caller's lie */
        values[0] = 12345;
        const taut_status status =
            taut_surface_eval_grid(surface, nu, t[0], nv, t[1], order, threads, values);
        require(status == TAUT_OK || values[0] == 12345);
    }
}

static void mesh(input *in, const taut_surface *surface)
{
    taut_mesh_options options = {.tolerance = number(in), .divide = integer(in)};
    taut_model *model = NULL;
    taut_surface *copy = NULL;
    taut_mesh *made = NULL;
    taut_error error = {.status = TAUT_OK};
    options.threads = integer(in);
    if (options.threads > 4 && options.threads <= TAUT_THREADS_MAX) {
        options.threads = 4;
    }
    if (options.divide > 30 && options.divide < 10000000) {
        options.divide = 30;
    }
    if (options.divide == 0 && options.tolerance > 0 && options.tolerance < 1e-3) {
        options.tolerance = 1e-3;
    }
    options.monitor = patient_monitor(1);
    require(taut_model_new(&model) == TAUT_OK && taut_surface_copy(surface, &copy) == TAUT_OK &&
            taut_model_add_surface(model, copy) == TAUT_OK);
    const taut_status status = taut_mesh_new(model, &options, &made, &error);
    require((status == TAUT_OK) == (made != NULL));
    if (status == TAUT_OK) {
        for (size_t i = 0; i < 3 * taut_mesh_vertex_count(made); i++) {
            require(isfinite(taut_mesh_positions(made)[i]) && isfinite(taut_mesh_normals(made)[i]));
        }
    } else {
        require_error(status, &error);
    }
    taut_mesh_free(made);
    taut_model_free(model);
}

/* The join seldom: it looks for the nearest point of every point, a hundred times what others cost.
 */
static void measure(input *in, const taut_surface *surface)
{
    const taut_edge a = (taut_edge)(byte(in) % 6), b = (taut_edge)(byte(in) % 6);
    double energy = -1;
    if (taut_surface_dirichlet_energy(surface, &energy) == TAUT_OK) {
        require(isnan(energy) || energy >= 0); /* NaN: above the range of doubles */
    }
    if (byte(in) % 64 == 0) {
        taut_join join = {.max_gap = -1};
        const taut_status status = taut_join_measure(surface, a, surface, b, &join, NULL);
        require(status == TAUT_OK ? join.max_gap >= 0 : join.max_gap == -1);
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    input in = {data, size};
    taut_surface *surface = make_surface(&in);
    for (int i = 0; i < CALLS_MAX && in.size > 0; i++) {
        switch (byte(&in) % 6) {
        case 0:
        case 1:
            operate(&in, &surface);
            break;
        case 2:
            split(&in, surface);
            break;
        case 3:
            evaluate(&in, surface);
            break;
        case 4:
            mesh(&in, surface);
            break;
        default:
            measure(&in, surface);
            break;
        }
    }
    taut_surface_free(surface);
    return 0;
}
