/* test_pipe.c -- every claim about a pipe fails on a model perturbed by ten times its limit, and
 * figures come from the model alone. */
#include "certificates.h"
#include "check.h"

#include "certify/pipe/parts.h"
#include "core/vec3.h"
#include "taut/taut.h"

#include <stdlib.h>
#include <string.h>

/* What is changed in a copy of a model: point `index` of surface or curve `name` by `move`. */
typedef struct change {
    const char *name;
    int index; /* of the point; -1: none */
    double move[3];
    double shape[3]; /* added to the shape numbers of the axis */
} change;

static void add_surface(const taut_surface *surface, const change *c, taut_model *model)
{
    const int count =
        taut_basis_count(taut_surface_u(surface)) * taut_basis_count(taut_surface_v(surface));
    double *points = malloc(3 * (size_t)count * sizeof *points);
    taut_surface *copy = NULL;
    memcpy(points, taut_surface_points(surface), 3 * (size_t)count * sizeof *points);
    if (strcmp(c->name, taut_surface_name(surface)) == 0) {
        for (int k = 0; k < 3; k++) {
            points[3 * (c->index < 0 ? count + c->index : c->index) + k] += c->move[k];
        }
    }
    CHECK(taut_surface_new(taut_surface_name(surface), taut_surface_u(surface),
                           taut_surface_v(surface), points, taut_surface_weights(surface), &copy,
                           NULL) == TAUT_OK &&
              taut_model_add_surface(model, copy) == TAUT_OK,
          "copy");
    free(points);
}

static taut_model *changed(const taut_model *model, const change *c)
{
    const taut_curve *axis = taut_model_curve(model, 0);
    taut_model *copy = NULL;
    taut_curve *curve = NULL;
    taut_basis *basis = NULL;
    taut_basis_spec spec;
    double points[12];
    CHECK(taut_model_new(&copy) == TAUT_OK, "model");
    for (int i = 0; i < taut_model_surface_count(model); i++) {
        add_surface(taut_model_surface(model, i), c, copy);
    }
    taut_basis_spec_of(taut_curve_t(axis), &spec);
    spec.alpha += c->shape[0];
    spec.beta += c->shape[1];
    spec.gamma += c->shape[2];
    memcpy(points, taut_curve_points(axis), sizeof points);
    for (int k = 0; k < 3 && strcmp(c->name, "axis") == 0; k++) {
        points[3 * c->index + k] += c->move[k];
    }
    CHECK(taut_basis_new(&spec, 4, &basis, NULL) == TAUT_OK &&
              taut_curve_new("axis", basis, points, NULL, &curve, NULL) == TAUT_OK &&
              taut_model_add_curve(copy, curve) == TAUT_OK,
          "axis");
    taut_basis_free(basis);
    return copy;
}

/* The claim holds on the model, and not on the changed one. */
static void must_fail(const taut_model *model, const taut_pipe_problem *problem, const change *c,
                      const char *name)
{
    taut_certificate *before = NULL, *after = NULL;
    taut_model *other = changed(model, c);
    CHECK(taut_pipe_certify(model, problem, NULL, &before, NULL) == TAUT_OK, "%s", name);
    CHECK(taut_pipe_certify(other, problem, NULL, &after, NULL) == TAUT_OK, "%s", name);
    const taut_claim *good = claim_of(before, name), *bad = claim_of(after, name);
    CHECK(good->holds == TAUT_TRUE, "%s holds: %g, limit %g", name, good->residual, good->limit);
    CHECK(bad->holds == TAUT_FALSE, "%s fails: %g, limit %g", name, bad->residual, bad->limit);
    taut_certificate_free(before);
    taut_certificate_free(after);
    taut_model_free(other);
}

static taut_pipe_problem skew(void)
{
    const taut_pipe_problem problem = {
        .axis = {.kind = TAUT_PIPE_ENDS,
                 .ends = {{{0.1, 0.2, 0.3}, {1, 2, 3}, 5}, {{9, 3, 1}, {1, -1, 0.5}, 6}}},
        .section = {.radius = 1},
        .shape = {.kind = TAUT_PIPE_LEAST_BENDING},
    };
    return problem;
}

static void test_claims(void)
{
    const taut_pipe_problem problem = skew();
    taut_model *model = NULL;
    taut_certificate *certificate = NULL;
    CHECK(taut_pipe_make(&problem, NULL, &model, NULL) == TAUT_OK, "made");
    CHECK(taut_pipe_certify(model, &problem, NULL, &certificate, NULL) == TAUT_OK, "proved");
    const double joint1 = 10 * claim_of(certificate, "joint1")->limit;
    const double joint2 = 10 * claim_of(certificate, "joint2")->limit;
    const double ends = 10 * claim_of(certificate, "ends")->limit;
    const change gap1 = {.name = "pipe1", .index = 9 + 3, .move = {joint1, joint1, joint1}};
    const change gap2 = {.name = "pipe2", .index = 6, .move = {joint2, joint2, joint2}};
    const change tilt = {.name = "blend", .index = 9 + 2, .move = {joint1, -joint1, joint1}};
    const change bulge = {.name = "blend", .index = 9 * 40 + 4, .move = {2e-5, 2e-5, 2e-5}};
    const change narrow = {.name = "pipe2", .index = -2, .move = {2e-5, -2e-5, 2e-5}};
    const change start = {.name = "axis", .index = 0, .move = {ends, -ends, ends}};
    const change shape = {.name = "", .index = 0, .shape = {-0.02, 0.05, 0}};
    must_fail(model, &problem, &gap1, "joint1");
    must_fail(model, &problem, &gap2, "joint2");
    must_fail(model, &problem, &tilt, "joint1");
    must_fail(model, &problem, &bulge, "tube");
    must_fail(model, &problem, &narrow, "tube");
    must_fail(model, &problem, &start, "ends");
    must_fail(model, &problem, &shape, "optimal");
    taut_certificate_free(certificate);
    taut_model_free(model);
}

/* The verdict turns at the largest radius, and is told as a ratio. */
static void test_embedded(void)
{
    taut_pipe_problem problem = skew();
    taut_model *model = NULL;
    taut_certificate *certificate = NULL;
    problem.shape.kind = TAUT_PIPE_SHAPE_GIVEN;
    CHECK(taut_pipe_make(&problem, NULL, &model, NULL) == TAUT_OK, "made");
    CHECK(taut_pipe_certify(model, &problem, NULL, &certificate, NULL) == TAUT_OK, "proved");
    const double rho = figure_of(certificate, "largest_radius");
    CHECK_NEAR(claim_of(certificate, "embedded")->residual, 1 / rho, 1e-15, "ratio");
    taut_certificate_free(certificate);
    for (int above = 0; above < 2; above++) {
        problem.section.radius = above ? rho * (1 + 1e-9) : rho * (1 - 1e-9);
        certificate = NULL;
        CHECK(taut_pipe_certify(model, &problem, NULL, &certificate, NULL) == TAUT_OK, "proved");
        CHECK(claim_of(certificate, "embedded")->holds == (above ? TAUT_FALSE : TAUT_TRUE), "%d",
              above);
        CHECK(claim_of(certificate, "tube")->holds == TAUT_FALSE, "another radius");
        taut_certificate_free(certificate);
    }
    taut_model_free(model);
}

/* Total torsion from the closed forms of docs/papers/pipe.md section 2.3 in rational arithmetic, at
 * Gauss's points: where beta = 3 (-3) there is no curvature at the start (end), and the general one
 * beside them. Nearly none is nobody's: the figure is null. */
static void test_torsion(void)
{
    static const struct {
        taut_pipe_end ends[2];
        double shape[3], torsion;
    } cases[] = {
        {{{{1, -2, 0.5}, {1, 2, 2}, 3}, {{6, 3, 4}, {2, -3, 6}, 3.5}},
         {0.5, 3, -0.2},
         -2.447570080025},
        {{{{-3, 1, 2 / 3.0}, {2, -1, 2}, 2.5}, {{4, 3.5, -5}, {6, 2, 3}, 2.25}},
         {-0.25, -3, 0.6},
         2.617270228535},
        {{{{1 / 3.0, 5, -2}, {4, 4, 7}, 2}, {{3, -1 / 7.0, 6}, {-2, 6, 9}, 3}},
         {0.4, 3, 1 / 3.0},
         -2.560755023637},
        {{{{1 / 3.0, 5, -2}, {4, 4, 7}, 2}, {{3, -1 / 7.0, 6}, {-2, 6, 9}, 3}},
         {0.4, 0.5, 1 / 3.0},
         -2.574447178305},
        {{{{1 / 3.0, 5, -2}, {4, 4, 7}, 2}, {{3, -1 / 7.0, 6}, {-2, 6, 9}, 3}},
         {0.4, 3 - 4.5e-16, 1 / 3.0},
         NAN},
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        const double *shape = cases[i].shape;
        taut_pipe_problem problem = {
            .axis = {.kind = TAUT_PIPE_ENDS},
            .section = {.radius = 0.01},
            .shape = {.alpha = shape[0], .beta = shape[1], .gamma = shape[2]}};
        memcpy(problem.axis.ends, cases[i].ends, sizeof cases[i].ends);
        taut_model *model = NULL;
        taut_certificate *certificate = NULL;
        const taut_make_options coarse = {.tolerance = 1e-2};
        CHECK(taut_pipe_make(&problem, &coarse, &model, NULL) == TAUT_OK, "case %zu", i);
        CHECK(taut_pipe_certify(model, &problem, NULL, &certificate, NULL) == TAUT_OK, "proved");
        const double torsion = figure_of(certificate, "total_torsion");
        CHECK(isnan(cases[i].torsion) ? isnan(torsion) : fabs(torsion - cases[i].torsion) < 1e-11,
              "case %zu: %.15g", i, torsion);
        CHECK((isnan(torsion) != 0) == (taut_record_get(taut_certificate_figures(certificate),
                                                        "total_torsion_open") != NULL),
              "case %zu: the reason", i);
        taut_certificate_free(certificate);
        taut_model_free(model);
    }
}

/* The proofs turn where the figures say: the curvature of a blend, the distance of loops from
 * themselves, between the straight pipes and inside the blend. */
static void test_proofs(void)
{
    static const double axes[3][4][3] = {{{0, 0, 0}, {3, 0, 0}, {3, 2, 1}, {1, 4, 2}},
                                         {{0, 0, 0}, {5, 0, 0}, {0, 5, 0.3}, {0, 0, 0.3}},
                                         {{0, 0, 0}, {10, 10, 0}, {-6, 10, 0.1}, {4, 0, 0.3}}};
    for (int i = 0; i < 3; i++) {
        const taut_basis_spec spec = {.type = "ce-bezier", .alpha = 0.5, .gamma = 0.5};
        taut_arena *arena = taut_arena_new();
        taut_basis *basis = NULL;
        taut_curve *curve = NULL;
        taut_pipe_parts parts = {.axis_count = 1};
        taut_pipe_apart apart = {.proved = 0};
        CHECK(taut_basis_new(&spec, 4, &basis, NULL) == TAUT_OK &&
                  taut_curve_new("axis", basis, &axes[i][0][0], NULL, &curve, NULL) == TAUT_OK &&
                  taut_pipe_line_of(curve, arena, &parts.line, NULL) == TAUT_OK,
              "the axis");
        const taut_curve *axis = curve;
        parts.axes = &axis;
        taut_pipe_bound_curvature(&parts.line, &parts.figures);
        CHECK(taut_pipe_bound_reach(&parts.line, &parts.figures) == TAUT_OK, "the reach");
        for (int above = 0; above < 2; above++) {
            const double part = above ? 1 + 1e-6 : 1 - 1e-6;
            int proved = 0;
            CHECK(taut_pipe_prove_bend(&parts, part * parts.figures.curvature, &proved) ==
                          TAUT_OK &&
                      proved == above,
                  "curve %d, bend: %d", i, proved);
            CHECK(i == 0 || (taut_pipe_prove_apart(&parts.line, part * parts.figures.rho, &apart) ==
                                 TAUT_OK &&
                             apart.proved == !above),
                  "curve %d, distance: %d", i, apart.proved);
        }
        CHECK(i == 0 || parts.figures.by_distance, "the loop is bound by distance");
        taut_curve_free(curve);
        taut_basis_free(basis);
        taut_arena_free(arena);
    }
}

/* The model, `factor` times as large; its radius is told by nothing but itself. */
static taut_model *scaled(const taut_model *model, double factor)
{
    const double matrix[12] = {factor, 0, 0, 0, 0, factor, 0, 0, 0, 0, factor, 0};
    taut_model *out = NULL;
    CHECK(taut_model_new(&out) == TAUT_OK, "a model");
    for (int i = 0; i < 3; i++) {
        taut_surface *s = NULL;
        CHECK(taut_surface_transform(taut_model_surface(model, i), matrix, &s, NULL) == TAUT_OK &&
                  taut_model_add_surface(out, s) == TAUT_OK,
              "a surface");
    }
    taut_curve *axis = NULL;
    CHECK(taut_curve_transform(taut_model_curve(model, 0), matrix, &axis, NULL) == TAUT_OK &&
              taut_model_add_curve(out, axis) == TAUT_OK,
          "the axis");
    return out;
}

/* At any size that has an inverse the same; beyond, a document that is wrong. */
static void test_sizes(void)
{
    static const double sizes[] = {0x1p-990, 0x1p-500, 0x1p-1, 0x1p500, 0x1p990, 0x1p-1040};
    taut_pipe_problem problem = skew();
    taut_model *model = NULL;
    problem.shape.kind = TAUT_PIPE_SHAPE_GIVEN;
    CHECK(taut_pipe_make(&problem, NULL, &model, NULL) == TAUT_OK, "made");
    for (size_t i = 0; i < sizeof sizes / sizeof sizes[0]; i++) {
        taut_model *other = scaled(model, sizes[i]);
        taut_certificate *certificate = NULL;
        taut_error error = {.where = ""};
        const taut_status status = taut_pipe_certify(other, NULL, NULL, &certificate, &error);
        if (sizes[i] < 0x1p-1000) {
            CHECK(status == TAUT_BAD_INPUT && strcmp(error.where, "/surfaces") == 0 &&
                      strcmp(error.reason, "value") == 0,
                  "%s %s", error.where, error.message);
        } else {
            CHECK(status == TAUT_OK, "size %g: %s", sizes[i], error.message);
            for (int k = 0; k < taut_certificate_claim_count(certificate); k++) {
                const taut_claim *claim = taut_certificate_claim(certificate, k);
                CHECK(claim->holds == TAUT_TRUE, "size %g: %s, %d, %g, limit %g, %s", sizes[i],
                      claim->claim, (int)claim->holds, claim->residual, claim->limit, claim->where);
            }
        }
        taut_certificate_free(certificate);
        taut_model_free(other);
    }
    taut_model_free(model);
}

static void test_refusals(void)
{
    taut_model *model = NULL;
    taut_certificate *certificate = NULL;
    CHECK(taut_model_new(&model) == TAUT_OK, "model");
    CHECK(taut_pipe_certify(model, NULL, NULL, &certificate, NULL) == TAUT_BAD_INPUT, "no pipe");
    CHECK(taut_pipe_certify(NULL, NULL, NULL, &certificate, NULL) == TAUT_BAD_ARGUMENT, "NULL");
    CHECK(certificate == NULL, "untouched");
    taut_model_free(model);
}

int main(void)
{
    test_claims();
    test_embedded();
    test_torsion();
    test_proofs();
    test_sizes();
    test_refusals();
    return check_failures != 0;
}
