/* test_regular.c -- the claim `regular`: surfaces whose smallest sine is known, ones that are singular
 * at one inner point, and what may change without changing it.
 */
#include "certificates.h"
#include "check.h"

#include "certify/common/directions.h"
#include "certify/common/regular.h"
#include "certify/common/tangents.h"
#include "core/memory.h"
#include "core/vec3.h"
#include "taut/construct.h"
#include "taut/dirichlet.h"
#include "taut/read.h"

#include <string.h>

enum { MOST = 8 };

static taut_surface *surface_on(const taut_basis_spec *u, const taut_basis_spec *v,
                                const double *points, const double *weights)
{
    taut_basis *bases[2] = {NULL, NULL};
    taut_surface *surface = NULL;
    CHECK(taut_basis_new(u, 0, &bases[0], NULL) == TAUT_OK, "u");
    CHECK(taut_basis_new(v, 0, &bases[1], NULL) == TAUT_OK, "v");
    CHECK(taut_surface_new("", bases[0], bases[1], points, weights, &surface, NULL) == TAUT_OK,
          "surface");
    taut_basis_free(bases[0]);
    taut_basis_free(bases[1]);
    return surface;
}

static taut_surface *bezier(int p, int q, const double *points, const double *weights)
{
    const taut_basis_spec u = {.type = "bezier", .degree = p}, v = {.type = "bezier", .degree = q};
    return surface_on(&u, &v, points, weights);
}

static taut_regular judged(taut_surface *surface)
{
    taut_regular found;
    CHECK(taut_certify_regular(surface, NULL, &found) == TAUT_OK, "judged");
    taut_surface_free(surface);
    return found;
}

/* A sheared square: the sine is 1 / sqrt(1 + k^2) everywhere. */
static taut_surface *sheared(double k, double size)
{
    const double points[2][2][3] = {{{0, 0, 0}, {size * k, size, 0}},
                                    {{size, 0, 0}, {size + size * k, size, 0}}};
    return bezier(1, 1, &points[0][0][0], NULL);
}

static void test_known_sines(void)
{
    for (int k = -4; k <= 4; k++) {
        const double sizes[5] = {1e-300, 1e-90, 1, 1e153, 1e300};
        for (int s = 0; s < 5; s++) {
            const taut_regular found = judged(sheared(k, sizes[s]));
            const double exact = 1 / sqrt(1.0 + k * k);
            CHECK(found.holds == TAUT_TRUE, "k=%d: %s", k, found.where);
            CHECK_NEAR(found.sine, exact, 1e-14, "k=%d size %g", k, sizes[s]);
            CHECK(found.bound <= exact && found.bound >= exact * (1 - 1e-9), "k=%d: bound %g of %g",
                  k, found.bound, exact);
        }
    }
}

/* The limit, 1e-6: a thousandth above it holds, below it is false. */
static void test_limit(void)
{
    taut_regular found = judged(sheared(1e6 * (1 - 1e-3), 1));
    CHECK(found.holds == TAUT_TRUE && found.bound > 1e-6, "%g: %s", found.bound, found.where);
    found = judged(sheared(1e6 * (1 + 1e-3), 1));
    CHECK(found.holds == TAUT_FALSE && found.sine < 1e-6, "%g: %s", found.sine, found.where);
}

/* S_ij = (2i, 2j, 0) with four inner points moved so that R_u(1/3, 1/3) = 0 in rational arithmetic;
 * the sine is 0.88 to 1 around. The weights c^i d^j leave that, R_u = 0 being elsewhere then. */
static taut_surface *cusp(double c, double d)
{
    double points[4][4][3], weights[4][4];
    const double inner[2][2][3] = {{{2, 2, 6}, {2, 4, 6}}, {{-5, 2, 1}, {-5, 4, -2}}};
    for (int i = 0; i < 4; i++) {
        for (int j = 0; j < 4; j++) {
            const double plain[3] = {2 * i, 2 * j, 0};
            const int inside = i % 3 != 0 && j % 3 != 0;
            memcpy(points[i][j], inside ? inner[i - 1][j - 1] : plain, sizeof plain);
            weights[i][j] = pow(c, i) * pow(d, j);
        }
    }
    return bezier(3, 3, &points[0][0][0], c == 1 && d == 1 ? NULL : &weights[0][0]);
}

static void test_cusp(void)
{
    const double factors[6][2] = {{1, 1}, {2, 1}, {30, 30}, {200, 0.005}, {1000, 1000}, {1000, 1}};
    for (int k = 0; k < 6; k++) {
        const double c = factors[k][0], d = factors[k][1];
        const taut_regular found = judged(cusp(c, d));
        double u = 0, v = 0;
        CHECK(found.holds != TAUT_TRUE && found.bound == 0, "%g %g: bound %g", c, d, found.bound);
        CHECK(sscanf(found.where, "R_u is 0 to rounding, and there is no sine, at u = %lf, v = %lf",
                     &u, &v) == 2,
              "%g %g: %s", c, d, found.where);
        CHECK_NEAR(u, 1 / (1 + 2 * c), 1e-6, "%g", c); /* t with c t / (1 - t + c t) = 1/3 */
        CHECK_NEAR(v, 1 / (1 + 2 * d), 1e-6, "%g", d);
        CHECK(found.sine > 0.4, "%g %g: %g", c, d, found.sine);
    }
}

/* Whitney's umbrella (u, v) -> (u^2, u v, v) about the middle: R_u = 0 at a point that a small change
 * moves, but does not take away: then R_u and R_v are parallel there, and only there. */
static void test_umbrella(void)
{
    for (int trial = 0; trial < 40; trial++) {
        double points[3][3][3];
        const double tilt = trial == 0 ? 0 : random_in(-0.3, 0.3);
        taut_regular found;
        for (int i = 0; i < 3; i++) {
            for (int j = 0; j < 3; j++) {
                const double u = i - 1, v = j - 1; /* blossom of u^2: u1 u2 */
                points[i][j][0] = (i == 1 ? -1 : 1) + tilt * v;
                points[i][j][1] = u * v + tilt * u;
                points[i][j][2] = v;
                for (int k = 0; k < 3 && trial > 0; k++) {
                    points[i][j][k] += random_in(-0.05, 0.05);
                }
            }
        }
        found = judged(bezier(2, 2, &points[0][0][0], NULL));
        CHECK(trial == 0 ? found.holds != TAUT_TRUE : found.holds == TAUT_FALSE, "%d: %g, %s",
              trial, found.bound, found.where);
    }
}

/* An edge that is one point: R_v = 0 along it, and nothing is said of the rest. */
static void test_pole(void)
{
    const double points[2][3][3] = {{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}},
                                    {{1, 0, 0}, {1, 1, 0}, {1, 2, 1}}};
    const taut_regular found = judged(bezier(1, 2, &points[0][0][0], NULL));
    CHECK(found.holds == TAUT_UNDECIDED && strncmp(found.where, "R_v is 0", 8) == 0, "%s",
          found.where);
}

/* Splines: a graph holds, and its bound is below the sines at places; a fold beside a knot is seen. */
static void test_splines(void)
{
    double points[MOST][MOST][3];
    for (int trial = 0; trial < 20; trial++) {
        const taut_basis_spec u = {.type = "bspline", .degree = 3, .count = MOST};
        const taut_basis_spec v = {.type = "bspline", .degree = 1 + trial % 3, .count = MOST};
        taut_surface *surface = NULL;
        taut_regular found;
        double least = 1;
        for (int i = 0; i < MOST; i++) {
            for (int j = 0; j < MOST; j++) {
                points[i][j][0] = 1e6 + i + random_in(-0.2, 0.2);
                points[i][j][1] = j + random_in(-0.2, 0.2);
                points[i][j][2] = random_in(-1, 1);
            }
        }
        surface = surface_on(&u, &v, &points[0][0][0], NULL);
        for (int k = 0; k < 41 * 41; k++) {
            double x[3][3], normal[3];
            CHECK(taut_surface_eval(surface, (k / 41) / 40.0, (k % 41) / 40.0, 1, &x[0][0]) ==
                      TAUT_OK,
                  "eval");
            taut_cross(x[TAUT_XU], x[TAUT_XV], normal);
            least = fmin(least, taut_norm(normal) / taut_norm(x[TAUT_XU]) / taut_norm(x[TAUT_XV]));
        }
        found = judged(surface);
        CHECK(found.holds == TAUT_TRUE && found.bound <= least && found.sine <= least * (1 + 1e-9),
              "%d: %g to %g, at places %g; %s", trial, found.bound, found.sine, least, found.where);
        points[4][4][0] -= 6; /* back over its neighbours */
        points[4][4][2] = 0;
        found = judged(surface_on(&u, &v, &points[0][0][0], NULL));
        CHECK(found.holds != TAUT_TRUE, "%d folded: %g", trial, found.bound);
    }
}

/* On c- and h- bases: bent nets, whose bound no sine of a grid is below; pinched ones, which are
 * never regular; and spans too wide. */
static void test_quasi(void)
{
    static const char *const types[] = {"c-bezier", "h-bezier"};
    for (int trial = 0; trial < 20; trial++) {
        const taut_basis_spec circular = {.type = types[0], .alpha = random_in(0.2, 3.1)};
        const taut_basis_spec hyperbolic = {.type = types[1], .beta = random_in(0.2, 3.9)};
        const taut_basis_spec u = trial % 2 == 0 ? circular : hyperbolic;
        const taut_basis_spec v = {.type = "bezier", .degree = 2};
        double points[4][3][3];
        for (int k = 0; k < 36; k++) {
            const double plain[3] = {k / 9, k / 3 % 3, 0};
            points[k / 9][k / 3 % 3][k % 3] = plain[k % 3] + random_in(-0.2, 0.2);
        }
        taut_surface *const surface = surface_on(&u, &v, &points[0][0][0], NULL);
        taut_regular found;
        double least = 1;
        CHECK(taut_certify_regular(surface, NULL, &found) == TAUT_OK, "regular");
        for (int k = 0; k < 21 * 21; k++) {
            double x[3][3], n[3];
            CHECK(taut_surface_eval(surface, k / 21 / 20.0 * taut_basis_hi(taut_surface_u(surface)),
                                    k % 21 / 20.0, 1, x[0]) == TAUT_OK,
                  "place");
            taut_cross(x[1], x[2], n);
            least = fmin(least, taut_norm(n) / taut_norm(x[1]) / taut_norm(x[2]));
        }
        CHECK(found.holds == TAUT_TRUE && found.bound <= least && found.sine <= least * 1.001 &&
                  found.bound > 0.3 * least,
              "%s: %g, bound %g, least %g: %s", u.type, found.sine, found.bound, least,
              found.where);
        taut_surface_free(surface);
        memcpy(points[1], points[0], sizeof points[1]); /* R_u = 0 on an edge */
        const taut_regular pinched = judged(surface_on(&u, &v, &points[0][0][0], NULL));
        CHECK(pinched.holds != TAUT_TRUE, "%s: pinched, %g", u.type, pinched.bound);
    }
}

static void test_other_bases(void)
{
    const taut_basis_spec c = {.type = "h-bezier", .beta = 4.5},
                          v = {.type = "bezier", .degree = 1};
    const double points[4][2][3] = {{{0, 0, 0}, {0, 1, 0}},
                                    {{1, 0, 0}, {1, 1, 0}},
                                    {{2, 0, 0}, {2, 1, 0}},
                                    {{3, 0, 1}, {3, 1, 0}}};
    const taut_regular found = judged(surface_on(&c, &v, &points[0][0][0], NULL));
    CHECK(found.holds == TAUT_UNDECIDED && found.bound == 0 && strstr(found.where, "bases") != NULL,
          "%s", found.where);
}

/* The bound of one piece, against the sines of a grid: of patches bent until it says nothing. */
static void test_piece(void)
{
    int separated = 0;
    for (int trial = 0; trial < 3000; trial++) {
        const double origin[3] = {0, 0, 0}, bend = random_in(0, 0.6);
        double points[3][3][3], weights[3][3], lines[17], sines[17 * 17], bound = 0, least = 1;
        taut_arena *const arena = taut_arena_new();
        taut_surface *surface = NULL;
        taut_field piece[4];
        taut_tangents t;
        int direction = 0;
        for (int i = 0; i < 3; i++) {
            for (int j = 0; j < 3; j++) {
                const double plain[3] = {i, j + 0.5 * i, 0};
                for (int k = 0; k < 3; k++) {
                    points[i][j][k] = plain[k] + bend * random_in(-1, 1);
                }
                weights[i][j] = random_log(0.5, 2);
            }
        }
        surface = bezier(2, 2, &points[0][0][0], trial % 2 == 0 ? &weights[0][0] : NULL);
        CHECK(taut_field_of_surface(arena, surface, 0, 0, origin, 0, piece, NULL), "piece");
        CHECK(taut_tangents_of(arena, piece, &t), "tangents");
        bound = taut_tangents_bound(&t, &direction);
        for (int k = 0; k < 17; k++) {
            lines[k] = k / 16.0;
        }
        taut_tangents_grid(&t, 17, lines, lines, sines);
        for (int k = 0; k < 17 * 17; k++) {
            least = fmin(least, sines[k]);
        }
        separated += bound > 0;
        CHECK(bound <= least, "trial %d, bent by %g: %g above %g", trial, bend, bound, least);
        taut_surface_free(surface);
        taut_arena_free(arena);
    }
    CHECK(separated > 500, "%d separated", separated);
}

/* Directions in twice the precision: along the derivatives, w^2 times as long. */
static void test_directions(void)
{
    const double origin[3] = {0.25, 1, -3};
    const int exponent[2] = {1, -2};
    for (int trial = 0; trial < 200; trial++) {
        const taut_basis_spec u = {.type = "bspline", .degree = 1 + trial % 4, .count = MOST};
        const taut_basis_spec v = {.type = "bezier", .degree = MOST - 1};
        double points[MOST * MOST][3], weights[MOST * MOST], x[2][3], error[2], r[3][3];
        taut_surface *surface = NULL;
        int span[2] = {0, 0};
        const double s = random_in(0, 1), t = random_in(0, 1);
        for (int k = 0; k < MOST * MOST; k++) {
            weights[k] = random_log(0.25, 4);
            for (int c = 0; c < 3; c++) {
                points[k][c] = random_in(-2, 2);
            }
        }
        surface = surface_on(&u, &v, &points[0][0], trial % 2 == 0 ? weights : NULL);
        span[0] = taut_basis_span(taut_surface_u(surface), s);
        CHECK(taut_certify_directions(surface, span, s, t, origin, exponent, x, error), "told");
        CHECK(taut_surface_eval(surface, s, t, 1, &r[0][0]) == TAUT_OK, "eval");
        for (int k = 0; k < 2; k++) {
            const double ratio = taut_dot(x[k], r[1 + k]) / taut_dot(r[1 + k], r[1 + k]);
            CHECK(ratio > 0 && error[k] < 1e-13 * (1 + taut_norm(x[k])), "error %g", error[k]);
            for (int c = 0; c < 3; c++) {
                CHECK_NEAR(x[k][c], ratio * r[1 + k][c], 1e-10 * (1 + taut_norm(x[k])),
                           "trial %d, %d", trial, k);
            }
        }
        taut_surface_free(surface);
    }
}

/* A patch between asymptotic edges under an affine map, as it is made: a pinch point near
 * (0.96213, 0.49989) and three more, between which a grid sees 0.0455. */
static const char pinched[] =
    ""
    "{\"taut\":1,\"construct\":\"asymptotic\",\"curves\":{\"v0\":{\"t\":{\"type\":\"bezier\","
    "\"degree\":4},"
    "\"points\":[[1.0,-5.0,-0.5],[1.0,-4.8,-1.1],[1.6,-7.5,-0.5],"
    "[1.0,-4.2,0.09999999999999998],[1.0,-4.0,-0.5]],"
    "\"weights\":[1.0,0.599733645450177,0.16986520618670636,0.599733645450177,1.0]},"
    "\"v1\":{\"t\":{\"type\":\"bezier\",\"degree\":4},\"points\":[[0.0,0.0,0.0],"
    "[0.0,0.2,0.4],[-0.6000000000000001,3.5000000000000004,-0.5000000000000003],"
    "[0.0,0.8,-1.4],[0.0,1.0,-1.0]],"
    "\"weights\":[1.0,0.5997336454501769,0.16986520618670628,0.5997336454501767,1.0]},"
    "\"u0\":{\"t\":{\"type\":\"bezier\",\"degree\":4},\"points\":[[1.0,-5.0,-0.5],"
    "[0.8,-4.0,-1.0],[0.5000000000000002,-3.100000000000001,0.050000000000000266],"
    "[0.2,-1.0,0.5],[0.0,0.0,0.0]],"
    "\"weights\":[1.0,0.599733645450177,0.16986520618670636,0.599733645450177,1.0]},"
    "\"u1\":{\"t\":{\"type\":\"bezier\",\"degree\":4},\"points\":[[1.0,-4.0,-0.5],"
    "[0.8,-3.0,0.0],[0.5,-0.8999999999999999,-1.0500000000000003],[0.2,0.0,-1.5],"
    "[0.0,1.0,-1.0]],"
    "\"weights\":[1.0,0.5997336454501769,0.16986520618670628,0.5997336454501767,1.0]}},"
    "\"surface\":\"n+3\",\"singular\":\"report\"}";

static void test_pinched_patch(void)
{
    taut_problem *problem = NULL;
    taut_model *model = NULL;
    taut_certificate *certificate = NULL;
    const taut_claim *claim = NULL;
    CHECK(taut_problem_read_text(pinched, strlen(pinched), "pinched", &problem, NULL) == TAUT_OK,
          "read");
    CHECK(taut_make(problem, NULL, &model, NULL) == TAUT_OK, "made");
    CHECK(taut_certify(model, problem, NULL, &certificate, NULL) == TAUT_OK, "judged");
    claim = claim_of(certificate, "regular");
    CHECK(claim->holds == TAUT_FALSE && claim->residual < 1e-9 && claim->kind == TAUT_BOUND,
          "%g: %s", claim->residual, claim->where);
    CHECK(isnan(figure_of(certificate, "regular_bound")), "no bound");
    taut_certificate_free(certificate);
    taut_model_free(model);
    taut_problem_free(problem);
}

/* A net asks for the claim: with a hole in it, and with a fold in its plane. */
static void test_asked_for(void)
{
    static const char text[] =
        "{\"taut\":1,\"construct\":\"%s\",\"u\":{\"type\":\"bezier\",\"degree\":2},"
        "\"v\":{\"type\":\"bezier\",\"degree\":2},\"points\":[[[0,0,0],[0,1,%d],[0,2,0]],"
        "[[1,0,0],%s,[1,2,0]],[[2,0,0],[2,1,%d],[2,2,0]]]%s}";
    const char *const constructs[2] = {"dirichlet", "plateau"};
    for (int k = 0; k < 8; k++) {
        const int asks = k & 1, folds = k & 2;
        char document[512];
        taut_problem *problem = NULL;
        taut_model *model = NULL;
        taut_certificate *certificate = NULL;
        (void)snprintf(document, sizeof document, text, constructs[k / 4], folds ? 0 : 1,
                       folds ? "[9,5,0]" : "null", folds ? 0 : 1, asks ? ",\"regular\":true" : "");
        CHECK(taut_problem_read_text(document, strlen(document), "", &problem, NULL) == TAUT_OK,
              "%s", document);
        CHECK(taut_make(problem, NULL, &model, NULL) == TAUT_OK, "%s", document);
        CHECK(taut_certify(model, problem, NULL, &certificate, NULL) == TAUT_OK, "%s", document);
        CHECK(has_claim(certificate, "regular") == asks, "%s", document);
        if (asks) {
            const taut_claim *const claim = claim_of(certificate, "regular");
            CHECK(claim->holds == (folds ? TAUT_FALSE : TAUT_TRUE), "%s: %g, %s", document,
                  claim->residual, claim->where);
            CHECK(folds || figure_of(certificate, "regular_bound") > 0.1, "%s", document);
        }
        taut_certificate_free(certificate);
        taut_model_free(model);
        taut_problem_free(problem);
    }
}

int main(void)
{
    random_seed(19);
    test_known_sines();
    test_limit();
    test_cusp();
    test_umbrella();
    test_pole();
    test_splines();
    test_quasi();
    test_other_bases();
    test_piece();
    test_directions();
    test_pinched_patch();
    test_asked_for();
    return check_failures != 0;
}
