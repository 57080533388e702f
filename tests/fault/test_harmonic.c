/* test_harmonic.c -- harmonic and biharmonic surfaces when memory runs out: each way of making
 * them, in doubles and in rationals, and their certificates.
 *
 * needs: exact
 */
#include "calls.h"
#include "check.h"
#include "fault.h"
#include "shapes.h"

#include "problem/problem.h"
#include "taut/biharmonic.h"
#include "taut/harmonic.h"
#include "taut/operations.h"

#include <string.h>

/* A problem of one of the three constructions, and how it is made. */
typedef struct request {
    const char *name;
    int construct;
    const void *data;
    taut_make_options options;
    const taut_model *model; /* for its certificate */
} request;

static taut_status make(const void *context, void **result, taut_error *error)
{
    const request *r = context;
    taut_model *model = *result;
    taut_status status = TAUT_OK;
    if (r->construct == TAUT_CONSTRUCT_INDEX_harmonic) {
        status = taut_harmonic_make(r->data, &r->options, &model, error);
    } else if (r->construct == TAUT_CONSTRUCT_INDEX_harmonic_extension) {
        status = taut_harmonic_extension_make(r->data, &r->options, &model, error);
    } else {
        status = taut_biharmonic_make(r->data, &r->options, &model, error);
    }
    *result = model;
    return status;
}

static taut_status prove(const void *context, void **result, taut_error *error)
{
    const request *r = context;
    const taut_certify_options options = {.exact = r->options.exact};
    taut_certificate *certificate = *result;
    taut_problem *problem = NULL;
    taut_status status = taut_problem_new(r->construct, &problem);
    if (status != TAUT_OK) { /* the problem is the test's own */
        error->status = status;
        strcpy(error->message, "memory");
        return status;
    }
    problem->data = r->data;
    status = taut_certify(r->model, problem, &options, &certificate, error);
    taut_problem_free(problem);
    *result = certificate;
    return status;
}

static taut_status split(const void *context, void **result, taut_error *error)
{
    taut_model *pieces = *result;
    const taut_status status =
        taut_model_split_exact(context, NULL, TAUT_ALONG_U, 0.5, &pieces, error);
    *result = pieces;
    return status;
}

/* The surface "one" alone is cut. */
static taut_status split_one(const void *context, void **result, taut_error *error)
{
    taut_model *pieces = *result;
    const taut_status status =
        taut_model_split_exact(context, "one", TAUT_ALONG_U, 0.5, &pieces, error);
    *result = pieces;
    return status;
}

/* A surface with a name, another one and a curve, that a cut of the first copies. */
static taut_model *company(const taut_surface *surface)
{
    static const double ends[6] = {0, 0, 0, 1, 0, 0};
    taut_model *model = NULL;
    taut_surface *one = NULL, *other = NULL;
    CHECK(taut_surface_new("one", taut_surface_u(surface), taut_surface_v(surface),
                           taut_surface_points(surface), NULL, &one, NULL) == TAUT_OK &&
              taut_surface_copy(surface, &other) == TAUT_OK,
          "surfaces");
    CHECK(taut_model_new(&model) == TAUT_OK && taut_model_add_surface(model, one) == TAUT_OK &&
              taut_model_add_surface(model, other) == TAUT_OK &&
              taut_model_add_curve(model, shape_curve(shape_bezier(1, 0, 1), ends, NULL)) ==
                  TAUT_OK,
          "model");
    return model;
}

static void try_company(const taut_surface *surface)
{
    taut_model *model = company(surface);
    void *pieces = NULL;
    const fault_call cut = {"a cut of one in rationals", split_one, release_model, model};
    CHECK(fault_loop(&cut) > 5, "a cut of one takes memory");
    CHECK(split_one(model, &pieces, NULL) == TAUT_OK, "cut");
    CHECK(pieces != NULL && taut_model_surface_count(pieces) == 3 &&
              taut_model_curve_count(pieces) == 1,
          "two pieces, the other one and the curve");
    taut_model_free(pieces);
    taut_model_free(model);
}

/* Made under fire, then made once and proved under fire. */
static void try(request *r)
{
    taut_model *model = NULL;
    void *made = NULL;
    taut_error error;
    const fault_call making = {r->name, make, release_model, r};
    CHECK(fault_loop(&making) > 5, "%s takes memory", r->name);
    CHECK(make(r, &made, &error) == TAUT_OK, "%s", r->name);
    model = made;
    r->model = model;
    const fault_call proving = {r->name, prove, release_certificate, r};
    CHECK(model == NULL || fault_loop(&proving) > 2, "the proof of %s takes memory", r->name);
    taut_model_free(model);
}

int main(void)
{
    static const double exactly[9][3] = {{0, 0, 0},     {0, 0.5, 0},  {0, 1, -1}, {0.5, 0, 0},
                                         {0.5, 0.5, 0}, {0.5, 1, -1}, {1, 0, 1},  {1, 0.5, 1},
                                         {1, 1, 0}}; /* u, v, u^2 - v^2 */
    static const double below[9][3] = {{0, -1, -1},    {0, -0.5, 0}, {0, 0, 0},  {0.5, -1, -1},
                                       {0.5, -0.5, 0}, {0.5, 0, 0},  {1, -1, 0}, {1, -0.5, 1},
                                       {1, 0, 1}}; /* v from -1 to 0 */
    static const char *const texts[12] = {"1/3", NULL, "2/7", "5", "-1/9"};
    double points[48];
    unsigned char rows[16], four[16];
    taut_basis *u = shape_bezier(3, 0, 1), *v = shape_bezier(3, 0, 2);
    taut_surface *enneper = shape_enneper(0, 1, 0, 1);
    taut_model *whole = NULL;
    taut_harmonic_problem two, derivative, fit;
    taut_surface *saddle =
        shape_surface(shape_bezier(2, 0, 1), shape_bezier(2, 0, 1), &exactly[0][0], NULL);
    taut_surface *under =
        shape_surface(shape_bezier(2, 0, 1), shape_bezier(2, -1, 0), &below[0][0], NULL);
    taut_harmonic_extension_problem c1, g1, rational, pieces;
    taut_biharmonic_problem boundary, neighbour;

    random_seed(20261125);
    for (int k = 0; k < 48; k++) {
        points[k] = random_in(-1, 1);
        rows[k / 3] = k / 12 == 0 || k / 12 == 3;
        four[k / 3] = rows[k / 3] || k / 3 % 4 == 0 || k / 3 % 4 == 3;
    }
    memset(&two, 0, sizeof two);
    two.u = u;
    two.v = v;
    fit = derivative = two;
    two.rows = (taut_harmonic_rows){.points = points, .known = rows};
    fit.given = TAUT_HARMONIC_BOUNDARY;
    fit.boundary = (taut_harmonic_boundary){points, four};
    derivative.given = TAUT_HARMONIC_DERIVATIVE;
    derivative.derivative =
        (taut_harmonic_derivative){.edge = points, .cross = points + 12, .exact_edge = texts};
    memset(&c1, 0, sizeof c1);
    c1.surface = enneper;
    c1.edge = TAUT_EDGE_V0;
    g1 = rational = c1;
    rational.surface = saddle;
    pieces = rational;
    pieces.given = TAUT_EXTENSION_MERGE;
    pieces.merge.neighbour = under;
    g1.given = TAUT_EXTENSION_G1;
    g1.g1 = (taut_extension_g1){.c = 2};
    memset(&boundary, 0, sizeof boundary);
    boundary.rows = (taut_biharmonic_rows){NULL, u, v, points, four};
    memset(&neighbour, 0, sizeof neighbour);
    neighbour.given = TAUT_BIHARMONIC_NEIGHBOUR;
    neighbour.neighbour.surface = enneper;
    neighbour.neighbour.contact = 2;

    request requests[] = {
        {"two rows", TAUT_CONSTRUCT_INDEX_harmonic, &two, {.exact = 0}, NULL},
        {"a derivative", TAUT_CONSTRUCT_INDEX_harmonic, &derivative, {.exact = 0}, NULL},
        {"a fit", TAUT_CONSTRUCT_INDEX_harmonic, &fit, {.exact = 0}, NULL},
        {"two rows in rationals", TAUT_CONSTRUCT_INDEX_harmonic, &two, {.exact = 1}, NULL},
        {"a derivative in rationals",
         TAUT_CONSTRUCT_INDEX_harmonic,
         &derivative,
         {.exact = 1},
         NULL},
        {"an extension", TAUT_CONSTRUCT_INDEX_harmonic_extension, &c1, {.exact = 0}, NULL},
        {"an extension in rationals",
         TAUT_CONSTRUCT_INDEX_harmonic_extension,
         &rational,
         {.exact = 1},
         NULL},
        {"two pieces", TAUT_CONSTRUCT_INDEX_harmonic_extension, &pieces, {.exact = 0}, NULL},
        {"two pieces in rationals",
         TAUT_CONSTRUCT_INDEX_harmonic_extension,
         &pieces,
         {.exact = 1},
         NULL},
        {"a neighbour", TAUT_CONSTRUCT_INDEX_harmonic_extension, &g1, {.exact = 0}, NULL},
        {"four rows", TAUT_CONSTRUCT_INDEX_biharmonic, &boundary, {.exact = 0}, NULL},
        {"a biharmonic neighbour",
         TAUT_CONSTRUCT_INDEX_biharmonic,
         &neighbour,
         {.exact = 0},
         NULL}};
    for (size_t k = 0; k < sizeof requests / sizeof requests[0]; k++) {
        try(&requests[k]);
    }
    CHECK(taut_harmonic_make(&two, &requests[3].options, &whole, NULL) == TAUT_OK, "model");
    const fault_call cut = {"a cut in rationals", split, release_model, whole};
    CHECK(fault_loop(&cut) > 5, "a cut takes memory");
    taut_model_free(whole);
    try_company(saddle);
    taut_surface_free(under);
    taut_surface_free(enneper);
    taut_surface_free(saddle);
    taut_basis_free(u);
    taut_basis_free(v);
    CHECK(fault_live() == 0, "%ld blocks left", fault_live());
    return check_failures != 0;
}
