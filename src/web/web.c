/* web.c -- taut for a host that has it as a WebAssembly module: documents and flat arrays.
 *
 *     room = taut_web_alloc(n); write a document's n bytes there; w = taut_web_open(room, n)
 *     taut_web_make(w); taut_web_certify(w)          unless the document is a model
 *     taut_web_grid(w, s, nu, nv)                    positions and normals to draw
 *     taut_web_write(w, "json"), taut_web_length(w)  the model with its certificate
 *     taut_web_set(w, "/points/0/3", value, n)       another problem, to be made anew
 *     taut_web_close(w); taut_web_free(room)
 *
 * What goes wrong is a status above 0, and a sentence in taut_web_error. Nothing here is kept between
 * two documents but that sentence.
 */
#include "core/elementary/elementary.h"
#include "measure/dual/density.h"
#include "taut/taut.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

typedef struct taut_web {
    taut_problem *problem; /* or NULL: a model was opened */
    taut_model *model;
    float *grid;
    char *text;
    size_t length;
} taut_web;

static taut_error last;

enum { LINES_MAX = 4096 };

void *taut_web_alloc(size_t size);
void taut_web_free(void *room);
taut_web *taut_web_open(const char *text, size_t length);
void taut_web_close(taut_web *web);
int taut_web_set(taut_web *web, const char *pointer, const char *value, size_t length);
const char *taut_web_problem(const taut_web *web);
int taut_web_make(taut_web *web);
int taut_web_draft(taut_web *web, const taut_web *before, int steps);
int taut_web_certify(taut_web *web);
int taut_web_holds(const taut_web *web);
int taut_web_surfaces(const taut_web *web);
const char *taut_web_name(const taut_web *web, int s);
const float *taut_web_grid(taut_web *web, int s, int nu, int nv);
const float *taut_web_curvatures(taut_web *web, int s, int nu, int nv);
const float *taut_web_gaps(taut_web *web, int s, int nu, int nv);
int taut_web_curves(const taut_web *web);
const float *taut_web_curve(taut_web *web, int c, int count);
int taut_web_count(const taut_web *web, int s, int direction);
const double *taut_web_points(const taut_web *web, int s);
const char *taut_web_write(taut_web *web, const char *format);
size_t taut_web_length(const taut_web *web);
const char *taut_web_error(void);
const char *taut_web_where(void);
const char *taut_web_reason(void);

void *taut_web_alloc(size_t size)
{
    return malloc(size > 0 ? size : 1);
}

void taut_web_free(void *room)
{
    free(room);
}

/* The document of a problem or of a model; NULL: see taut_web_error. */
taut_web *taut_web_open(const char *text, size_t length)
{
    taut_web *web = calloc(1, sizeof *web);

    if (web == NULL) {
        return NULL;
    }
    taut_status status = taut_problem_read_text(text, length, "document", &web->problem, &last);
    if (status != TAUT_OK && status != TAUT_NO_MEMORY) {
        taut_error second;
        if (taut_model_read_text(text, length, "document", &web->model, &second) == TAUT_OK) {
            return web;
        }
    }
    if (status != TAUT_OK) {
        taut_web_close(web);
        return NULL;
    }
    return web;
}

void taut_web_close(taut_web *web)
{
    if (web != NULL) {
        taut_problem_free(web->problem);
        taut_model_free(web->model);
        free(web->grid);
        taut_text_free(web->text);
        free(web);
    }
}

/* Another value in one place of the problem: JSON text at a JSON pointer. What cannot be read leaves the
 * problem as it was; the model stays that of the problem before until the next make. */
int taut_web_set(taut_web *web, const char *pointer, const char *value, size_t length)
{
    taut_problem *changed = NULL;
    const taut_status status =
        taut_problem_change(web->problem, pointer, value, length, &changed, &last);

    if (status == TAUT_OK) {
        taut_problem_free(web->problem);
        web->problem = changed;
    }
    return (int)status;
}

/* The document of the problem as it is now, ended by a 0; borrowed until it is set. NULL: a model was
 * opened. */
const char *taut_web_problem(const taut_web *web)
{
    return web->problem != NULL ? taut_problem_text(web->problem, NULL) : NULL;
}

/* Makes the model of a problem. */
int taut_web_make(taut_web *web)
{
    taut_model *made = NULL;
    const taut_status status = taut_make(web->problem, NULL, &made, &last);

    if (status == TAUT_OK) {
        taut_model_free(web->model);
        web->model = made;
    }
    return (int)status;
}

/* The model as a draft of so many steps from another's; -1: there is no way from there. */
int taut_web_draft(taut_web *web, const taut_web *before, int steps)
{
    taut_model *made = NULL;
    const taut_status status = taut_draft(web->problem, before->model, steps, &made, &last);

    if (made == NULL) {
        return status == TAUT_OK ? -1 : (int)status;
    }
    taut_model_free(web->model);
    web->model = made;
    return 0;
}

/* Proves the model, with its problem where that was opened. */
int taut_web_certify(taut_web *web)
{
    taut_certificate *certificate = NULL;
    const taut_status status = taut_certify(web->model, web->problem, NULL, &certificate, &last);

    if (status == TAUT_OK) {
        taut_model_set_certificate(web->model, certificate);
    }
    return (int)status;
}

/* 1: all claims hold; 0: one does not; -1: undecided, or none was made. */
int taut_web_holds(const taut_web *web)
{
    const taut_certificate *certificate =
        web->model != NULL ? taut_model_certificate(web->model) : NULL;
    const taut_verdict verdict =
        certificate != NULL ? taut_certificate_holds(certificate) : TAUT_UNDECIDED;
    return verdict == TAUT_TRUE ? 1 : verdict == TAUT_FALSE ? 0 : -1;
}

int taut_web_surfaces(const taut_web *web)
{
    return web->model != NULL ? taut_model_surface_count(web->model) : 0;
}

/* Surface s, or NULL. */
static const taut_surface *surface_at(const taut_web *web, int s)
{
    return web->model != NULL ? taut_model_surface(web->model, s) : NULL;
}

const char *taut_web_name(const taut_web *web, int s)
{
    const taut_surface *surface = surface_at(web, s);
    return surface != NULL ? taut_surface_name(surface) : NULL;
}

/* Control points of surface s along u (0) or v (1). */
int taut_web_count(const taut_web *web, int s, int direction)
{
    const taut_surface *surface = surface_at(web, s);
    return surface == NULL  ? 0
           : direction == 0 ? taut_basis_count(taut_surface_u(surface))
                            : taut_basis_count(taut_surface_v(surface));
}

/* double[count of u][count of v][3], borrowed. */
const double *taut_web_points(const taut_web *web, int s)
{
    const taut_surface *surface = surface_at(web, s);
    return surface != NULL ? taut_surface_points(surface) : NULL;
}

static void fill_parameters(const taut_basis *basis, int count, double *t)
{
    const double lo = taut_basis_lo(basis), hi = taut_basis_hi(basis);
    for (int i = 0; i < count; i++) {
        const double part = (double)i / (count - 1);
        t[i] = i == 0 ? lo : i + 1 == count ? hi : fmin(hi, lo + part * (hi - lo));
    }
}

static double larger(double a, double b)
{
    return a > b ? a : b;
}

/* x, x_u, x_v to the position and the unit normal, 0 where there is none. Over its largest part, the length is in range
 * whatever the unit. */
static void take_point(const double x[9], float position[3], float normal[3])
{
    double n[3], size = 0, length = 0;

    for (int c = 0; c < 3; c++) {
        const int a = (c + 1) % 3, b = (c + 2) % 3;
        n[c] = x[3 + a] * x[6 + b] - x[3 + b] * x[6 + a];
        size = larger(size, fabs(n[c]));
    }
    const double part = size > 0 ? 1 / size : 0;
    for (int c = 0; c < 3; c++) {
        n[c] = isfinite(part) ? n[c] * part : n[c] / size;
        length += n[c] * n[c];
    }
    const double unit = length > 0 ? 1 / sqrt(length) : 0;
    for (int c = 0; c < 3; c++) {
        position[c] = (float)x[c];
        normal[c] = size > 0 ? (float)(n[c] * unit) : 0;
    }
}

/* Room for `width` floats at each of nu by nv parameters, in *u and *v with `wide` bytes beside them at each; NULL: no such
 * surface, fewer than 2 lines or more than 4096, or no memory. The last is the caller's to free. */
static void *take_grid(taut_web *web, const taut_surface *surface, int nu, int nv, size_t width,
                       size_t wide, double **u, double **v)
{
    if (surface == NULL || nu < 2 || nv < 2 || nu > LINES_MAX || nv > LINES_MAX) {
        return NULL;
    }
    const size_t count = (size_t)nu * (size_t)nv;
    double *room = malloc(((size_t)nu + (size_t)nv) * sizeof *room + count * wide);
    float *grid = realloc(web->grid, count * width * sizeof *grid);
    web->grid = grid != NULL ? grid : web->grid;
    if (room == NULL || grid == NULL) {
        free(room);
        return NULL;
    }
    *u = room;
    *v = room + nu;
    fill_parameters(taut_surface_u(surface), nu, *u);
    fill_parameters(taut_surface_v(surface), nv, *v);
    return room;
}

/* float[2][nu][nv][3]: positions, then unit normals, at nu by nv parameters from end to end;
 * borrowed until the next call. NULL: no such surface, fewer than 2 lines or more than 4096, or no
 * memory. */
const float *taut_web_grid(taut_web *web, int s, int nu, int nv)
{
    const taut_surface *surface = surface_at(web, s);
    double *u, *v;
    void *room = take_grid(web, surface, nu, nv, 6, 9 * sizeof(double), &u, &v);

    if (room == NULL) {
        return NULL;
    }
    const size_t count = (size_t)nu * (size_t)nv;
    double *x = v + nv;
    const taut_status status = taut_surface_eval_grid(surface, nu, u, nv, v, 1, 1, x);
    for (size_t k = 0; status == TAUT_OK && k < count; k++) {
        take_point(x + 9 * k, web->grid + 3 * k, web->grid + 3 * (count + k));
    }
    free(room);
    return status == TAUT_OK ? web->grid : NULL;
}

/* float[3][nu][nv]: mean, then Gaussian curvature at the same parameters, NaN where there is no normal, then how far the
 * parameters are from isothermal, as figures have it; else as taut_web_grid. */
const float *taut_web_curvatures(taut_web *web, int s, int nu, int nv)
{
    const taut_surface *surface = surface_at(web, s);
    double *u, *v;
    void *room = take_grid(web, surface, nu, nv, 3, sizeof(taut_forms), &u, &v);

    if (room == NULL) {
        return NULL;
    }
    const size_t count = (size_t)nu * (size_t)nv;
    taut_forms *forms = (taut_forms *)(void *)(v + nv);
    const taut_status status = taut_surface_forms_grid(surface, nu, u, nv, v, 1, forms);
    for (size_t k = 0; status == TAUT_OK && k < count; k++) {
        web->grid[k] = (float)forms[k].mean;
        web->grid[count + k] = (float)forms[k].gaussian;
        web->grid[2 * count + k] = (float)(taut_hypot(forms[k].e - forms[k].g, 2 * forms[k].f) /
                                           (forms[k].e + forms[k].g));
    }
    free(room);
    return status == TAUT_OK ? web->grid : NULL;
}

/* float[nu][nv]: how much area there is above what the witness in the model's details proves to be the least, per area of what
 * it flows through, at the same parameters (measure/dual/density.h). NULL too where there is no witness. */
const float *taut_web_gaps(taut_web *web, int s, int nu, int nv)
{
    const taut_surface *surface = surface_at(web, s);
    taut_dual_density *density = NULL;
    double *u, *v;
    void *room = take_grid(web, surface, nu, nv, 1, 0, &u, &v);

    if (room == NULL ||
        taut_dual_density_new(surface, taut_model_details(web->model), &density) != TAUT_OK ||
        density == NULL) {
        free(room);
        return NULL;
    }
    for (int k = 0; k < nu * nv; k++) {
        web->grid[k] = (float)taut_dual_density_at(density, u[k / nv], v[k % nv]);
    }
    taut_dual_density_free(density);
    free(room);
    return web->grid;
}

/* The curves of the model; 0 before it is made. */
int taut_web_curves(const taut_web *web)
{
    return web->model != NULL ? taut_model_curve_count(web->model) : 0;
}

/* float[count][3]: points of a curve at as many parameters from end to end, 2 to 4096; else as taut_web_grid. */
const float *taut_web_curve(taut_web *web, int c, int count)
{
    if (c < 0 || c >= taut_web_curves(web) || count < 2 || count > LINES_MAX) {
        return NULL;
    }
    const taut_curve *curve = taut_model_curve(web->model, c);
    double *room = malloc(4 * (size_t)count * sizeof *room);
    float *points = realloc(web->grid, 3 * (size_t)count * sizeof *points);
    web->grid = points != NULL ? points : web->grid;
    taut_status status = TAUT_NO_MEMORY;
    if (room != NULL && points != NULL) {
        double *x = room + count;
        fill_parameters(taut_curve_t(curve), count, room);
        status = taut_curve_eval_points(curve, count, room, 0, 1, x);
        for (int k = 0; status == TAUT_OK && k < 3 * count; k++) {
            points[k] = (float)x[k];
        }
    }
    free(room);
    return status == TAUT_OK ? points : NULL;
}

/* The model in the format of an ending, ended by a 0; borrowed until the next call. */
const char *taut_web_write(taut_web *web, const char *format)
{
    const taut_write_options options = {.formats = taut_draw_formats()};
    char *text = NULL;
    size_t length = 0;

    if (web->model == NULL ||
        taut_model_write_text(web->model, format, &options, &text, &length, &last) != TAUT_OK) {
        return NULL;
    }
    taut_text_free(web->text);
    web->text = text;
    web->length = length;
    return text;
}

size_t taut_web_length(const taut_web *web)
{
    return web->length;
}

/* What went wrong last, where in the document (a JSON pointer), and its reason in a word. */
const char *taut_web_error(void)
{
    return last.message;
}

const char *taut_web_where(void)
{
    return last.where;
}

const char *taut_web_reason(void)
{
    return last.reason;
}
