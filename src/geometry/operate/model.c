/* model.c -- taut/operations.h for whole models: what is asked for is worked on, the rest copied. */
#include "taut/operations.h"

#include "core/fail.h"
#include "core/vec3.h"
#include "geometry/lattice.h"
#include "geometry/operate/change.h"
#include "geometry/operate/points.h"

#include <math.h>
#include <string.h>

/* The objects of a model, surfaces first. */
static int object_count(const taut_model *model)
{
    return taut_model_surface_count(model) + taut_model_curve_count(model);
}

static const char *object_name(const taut_model *model, int i)
{
    const int surfaces = taut_model_surface_count(model);
    return i < surfaces ? taut_surface_name(taut_model_surface(model, i))
                        : taut_curve_name(taut_model_curve(model, i - surfaces));
}

static int has_name(const taut_model *model, const char *name, int but)
{
    for (int i = 0; i < object_count(model); i++) {
        if (i != but && strcmp(object_name(model, i), name) == 0) {
            return 1;
        }
    }
    return 0;
}

/* How many dashes keep the names of `pieces` pieces of object i of a model (surfaces first, then
 * curves) apart from all others, those made so far included. */
static int dashes_for(const taut_model *from, int i, int pieces, const taut_model *so_far)
{
    int dashes = 1;
    for (int n = 0; n < pieces && dashes < 32; n++) {
        char name[TAUT_NAME_MAX + 1];
        taut_operate_piece_name(object_name(from, i), dashes, n, name);
        if (has_name(from, name, i) || has_name(so_far, name, -1)) {
            dashes++;
            n = -1; /* begin again */
        }
    }
    return dashes;
}

/* Is there anything to work on: an object, and one of this name unless it is NULL? */
static taut_status check_named(const taut_model *model, const char *name, taut_error *error)
{
    if (name != NULL && !has_name(model, name, -1)) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, "no-such-object", NULL, taut_none, taut_none,
                         "nothing in the model has the name \"%.80s\"", name);
    }
    if (object_count(model) == 0) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, "empty", NULL, taut_none, taut_none,
                         "the model holds no surface and no curve");
    }
    return TAUT_OK;
}

/* An operation on a model: what it is asked for, and what it does to object i, whose result goes
 * to a model. */
typedef struct operation {
    const taut_model *model;
    const char *name; /* of the objects asked for; NULL: all that the operation takes */
    taut_status (*surface)(const struct operation *o, int i, taut_model *to, taut_error *error);
    taut_status (*curve)(const struct operation *o, int i, taut_model *to, taut_error *error);
    int (*takes_curve)(const struct operation *o, const taut_curve *curve); /* where name is NULL */
    int direction;                                                          /* split */
    double t;
    int along_u, along_v; /* refine */
    double tolerance;     /* to NURBS, over the size */
    double *bound;
} operation;

static int takes_all(const operation *o, const taut_curve *curve)
{
    (void)o;
    (void)curve;
    return 1;
}

static taut_status fill_model(const operation *o, taut_model *to, taut_error *error)
{
    taut_status status = TAUT_OK;

    for (int i = 0; status == TAUT_OK && i < taut_model_surface_count(o->model); i++) {
        const taut_surface *surface = taut_model_surface(o->model, i);
        const int asked = o->name == NULL || strcmp(taut_surface_name(surface), o->name) == 0;
        status = asked ? taut_operate_placed(o->surface(o, i, to, error), "surfaces", i, error)
                       : taut_operate_copy_surface(surface, to, error);
    }
    for (int i = 0; status == TAUT_OK && i < taut_model_curve_count(o->model); i++) {
        const taut_curve *curve = taut_model_curve(o->model, i);
        const int asked = o->name != NULL ? strcmp(taut_curve_name(curve), o->name) == 0
                                          : o->takes_curve(o, curve);
        status = asked ? taut_operate_placed(o->curve(o, i, to, error), "curves", i, error)
                       : taut_operate_copy_curve(curve, to, error);
    }
    return status;
}

/* A new model, object by object. */
static taut_status run_operation(const operation *o, taut_model **result, taut_error *error)
{
    taut_model *made = NULL;
    taut_status status = taut_operate_begin(o->model, &made, error);

    if (status != TAUT_OK) {
        return status;
    }
    status = fill_model(o, made, error);
    return taut_operate_end(status, made, result);
}

static taut_status split_surface(const operation *o, int i, taut_model *to, taut_error *error)
{
    const taut_surface *surface = taut_model_surface(o->model, i);
    taut_change_list list = {0, NULL};
    taut_status status =
        taut_operate_split(taut_surface_along(surface, o->direction), o->t, &list, error);

    if (status != TAUT_OK) {
        return status;
    }
    status = taut_operate_add_surface_parts(surface, o->direction, &list,
                                            dashes_for(o->model, i, list.count, to), to, error);
    taut_change_list_free(&list);
    return status;
}

/* Adds the parts of curve i, unless the status is a failure; the list is freed. */
static taut_status add_curve_parts(taut_status status, const operation *o, int i,
                                   taut_change_list *list, taut_model *to, taut_error *error)
{
    const int object = taut_model_surface_count(o->model) + i;
    if (status != TAUT_OK) {
        return status;
    }
    status = taut_operate_add_curve_parts(taut_model_curve(o->model, i), list,
                                          dashes_for(o->model, object, list->count, to), to, error);
    taut_change_list_free(list);
    return status;
}

static taut_status split_curve(const operation *o, int i, taut_model *to, taut_error *error)
{
    const taut_basis *basis = taut_curve_t(taut_model_curve(o->model, i));
    taut_change_list list = {0, NULL};
    return add_curve_parts(taut_operate_split(basis, o->t, &list, error), o, i, &list, to, error);
}

/* Alone, or along with surfaces cut across u where t is inside. */
static int split_takes_curve(const operation *o, const taut_curve *curve)
{
    const taut_basis *basis = taut_curve_t(curve);
    return taut_model_surface_count(o->model) == 0 ||
           (o->direction == TAUT_ALONG_U && o->t > taut_basis_lo(basis) &&
            o->t < taut_basis_hi(basis));
}

taut_status taut_model_split(const taut_model *model, const char *name, int direction, double t,
                             taut_model **split, taut_error *error)
{
    const operation o = {.model = model,
                         .name = name,
                         .surface = split_surface,
                         .curve = split_curve,
                         .takes_curve = split_takes_curve,
                         .direction = direction,
                         .t = t};
    taut_status status = TAUT_OK;

    if (model == NULL || split == NULL ||
        (direction != TAUT_ALONG_U && direction != TAUT_ALONG_V)) {
        return taut_operate_null(error);
    }
    status = check_named(model, name, error);
    return status == TAUT_OK ? run_operation(&o, split, error) : status;
}

static taut_status refine_surface(const operation *o, int i, taut_model *to, taut_error *error)
{
    const taut_surface *surface = taut_model_surface(o->model, i);
    const int wanted[2] = {o->along_u || !o->along_v, o->along_v || !o->along_u};
    taut_surface *now = NULL;

    for (int d = 0; d < 2; d++) {
        if (wanted[d]) {
            taut_surface *next = NULL;
            const taut_status status =
                taut_surface_refine(now != NULL ? now : surface, d, &next, error);
            taut_surface_free(now);
            if (status != TAUT_OK) {
                return status;
            }
            now = next;
        }
    }
    return taut_operate_add_surface(to, now, error);
}

static taut_status refine_curve(const operation *o, int i, taut_model *to, taut_error *error)
{
    taut_curve *refined = NULL;
    const taut_status status = taut_curve_refine(taut_model_curve(o->model, i), &refined, error);
    return status == TAUT_OK ? taut_operate_add_curve(to, refined, error) : status;
}

static int refine_takes_curve(const operation *o, const taut_curve *curve)
{
    (void)curve;
    return taut_model_surface_count(o->model) == 0;
}

taut_status taut_model_refine(const taut_model *model, const char *name, int along_u, int along_v,
                              taut_model **refined, taut_error *error)
{
    const operation o = {.model = model,
                         .name = name,
                         .surface = refine_surface,
                         .curve = refine_curve,
                         .takes_curve = refine_takes_curve,
                         .along_u = along_u,
                         .along_v = along_v};
    taut_status status = TAUT_OK;

    if (model == NULL || refined == NULL) {
        return taut_operate_null(error);
    }
    status = check_named(model, name, error);
    return status == TAUT_OK ? run_operation(&o, refined, error) : status;
}

static taut_status surface_pieces(const operation *o, int i, taut_model *to, taut_error *error)
{
    const taut_surface *surface = taut_model_surface(o->model, i);
    const double patches = (double)taut_basis_span_count(taut_surface_u(surface)) *
                           taut_basis_span_count(taut_surface_v(surface));
    const int pieces = patches <= TAUT_OBJECTS_MAX ? (int)patches : 0; /* more are refused */
    return taut_operate_add_patches(surface, dashes_for(o->model, i, pieces, to), NULL, to, error);
}

static taut_status curve_pieces(const operation *o, int i, taut_model *to, taut_error *error)
{
    const taut_basis *basis = taut_curve_t(taut_model_curve(o->model, i));
    taut_change_list list = {0, NULL};
    return add_curve_parts(basis->ops->changes->pieces(basis, &list, error), o, i, &list, to,
                           error);
}

taut_status taut_model_pieces(const taut_model *model, const char *name, taut_model **pieces,
                              taut_error *error)
{
    const operation o = {.model = model,
                         .name = name,
                         .surface = surface_pieces,
                         .curve = curve_pieces,
                         .takes_curve = takes_all};
    taut_status status = TAUT_OK;

    if (model == NULL || pieces == NULL) {
        return taut_operate_null(error);
    }
    status = check_named(model, name, error);
    return status == TAUT_OK ? run_operation(&o, pieces, error) : status;
}

/* Grows a box {low, high} by a point. */
static void grow_box(double box[2][3], const double *x)
{
    for (int c = 0; c < 3; c++) {
        box[0][c] = fmin(box[0][c], x[c]);
        box[1][c] = fmax(box[1][c], x[c]);
    }
}

/* The diagonal of a box; 1 for a single point, whose size says nothing. */
static double diagonal_of(double box[2][3])
{
    const double diagonal = taut_distance(box[1], box[0]);
    return diagonal > 0 ? diagonal : 1;
}

enum { SAMPLES = 17 };

/* Sample i of a range, the ends exactly. */
static double sample_at(const taut_basis *basis, int i)
{
    const double lo = taut_basis_lo(basis), hi = taut_basis_hi(basis);
    return i == SAMPLES - 1 ? hi : lo + (hi - lo) * i / (SAMPLES - 1);
}

/* The diagonal of the box around sampled points. */
static double surface_size(const taut_surface *surface)
{
    double box[2][3] = {{HUGE_VAL, HUGE_VAL, HUGE_VAL}, {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL}};
    for (int i = 0; i < SAMPLES * SAMPLES; i++) {
        double x[3] = {0, 0, 0};
        taut_surface_eval(surface, sample_at(taut_surface_u(surface), i / SAMPLES),
                          sample_at(taut_surface_v(surface), i % SAMPLES), 0, x);
        grow_box(box, x);
    }
    return diagonal_of(box);
}

static double curve_size(const taut_curve *curve)
{
    double box[2][3] = {{HUGE_VAL, HUGE_VAL, HUGE_VAL}, {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL}};
    for (int i = 0; i < SAMPLES; i++) {
        double x[3] = {0, 0, 0};
        taut_curve_eval(curve, sample_at(taut_curve_t(curve), i), 0, x);
        grow_box(box, x);
    }
    return diagonal_of(box);
}

/* A tolerance that rounding forbids was told as a length; here it is asked for over the size. */
static taut_status over_size(taut_status status, double tolerance, double size, taut_error *error)
{
    if (status == TAUT_BAD_ARGUMENT && error != NULL && error->limit > 0) {
        return taut_fail(error, status, "tolerance", NULL, tolerance, error->limit / size,
                         "tolerance %g (over the size, %g) is below what rounding leaves; ask for "
                         "%g at least",
                         tolerance, size, error->limit / size);
    }
    return status;
}

static taut_status surface_to_nurbs(const operation *o, int i, taut_model *to, taut_error *error)
{
    const taut_surface *surface = taut_model_surface(o->model, i);
    const double size = surface_size(surface);
    taut_surface *converted = NULL;
    double bound = 0;
    const taut_status status =
        taut_surface_to_nurbs(surface, o->tolerance * size, &converted, &bound, error);

    if (status != TAUT_OK) {
        return over_size(status, o->tolerance, size, error);
    }
    *o->bound = fmax(*o->bound, bound);
    return taut_operate_add_surface(to, converted, error);
}

static taut_status curve_to_nurbs(const operation *o, int i, taut_model *to, taut_error *error)
{
    const taut_curve *curve = taut_model_curve(o->model, i);
    const double size = curve_size(curve);
    taut_curve *converted = NULL;
    double bound = 0;
    const taut_status status =
        taut_curve_to_nurbs(curve, o->tolerance * size, &converted, &bound, error);

    if (status != TAUT_OK) {
        return over_size(status, o->tolerance, size, error);
    }
    *o->bound = fmax(*o->bound, bound);
    return taut_operate_add_curve(to, converted, error);
}

taut_status taut_model_to_nurbs(const taut_model *model, double tolerance, taut_model **nurbs,
                                double *bound, taut_error *error)
{
    double largest = 0;
    const operation o = {.model = model,
                         .surface = surface_to_nurbs,
                         .curve = curve_to_nurbs,
                         .takes_curve = takes_all,
                         .tolerance = tolerance,
                         .bound = &largest};

    if (model == NULL || nurbs == NULL) {
        return taut_operate_null(error);
    }
    const taut_status status = run_operation(&o, nurbs, error);
    if (status == TAUT_OK && bound != NULL) {
        *bound = largest;
    }
    return status;
}
