/* test_forged_bonnet.c -- nets that are isothermal, harmonic or minimal in places: flat in the middle of
 * spans, true up to one point, true but for a crease; random surfaces of the family turned, scaled
 * and mirrored stay what they are. */
#include "attack.h"
#include "certificates.h"
#include "check.h"
#include "shapes.h"

#include "taut/bonnet.h"

#include <string.h>

enum { SPANS = 48 };

static taut_verdict verdict_of(const taut_model *model)
{
    taut_certificate *certificate = prove(model, NULL, "bonnet");
    const taut_verdict holds = taut_certificate_holds(certificate);
    taut_certificate_free(certificate);
    return holds;
}

/* A staircase: spans of a cubic with triple knots, each a cubic through random heights that has no
 * slope and no curvature in its middle, or is flat. */
static void test_stairs(void)
{
    for (int trial = 0; trial < random_trials(40); trial++) {
        const int spans = random_int(1, SPANS);
        double knots[3 * SPANS + 6], points[3 * SPANS + 1][2][3], height = 0;
        const double width = random_log(0.01, 10);
        int count = 0;
        knots[count++] = 0;
        for (int i = 0; i <= spans; i++) {
            for (int k = 0; k < 3; k++) {
                knots[count++] = i * width;
            }
        }
        knots[count++] = spans * width;
        for (int i = 0; i <= 3 * spans; i++) {
            const double jump = i % 3 == 0 ? 0 : random_in(-1, 1) * random_log(1e-3, 1e3);
            height += i % 3 == 0 ? 0 : jump;
            for (int j = 0; j < 2; j++) {
                const double x[3] = {i * width / 3, j * width, height};
                memcpy(points[i][j], x, sizeof x);
            }
        }
        const taut_basis_spec spec = {
            .type = "bspline", .degree = 3, .knot_count = count, .knots = knots};
        taut_model *model = shape_model(
            shape_surface(shape_basis(&spec), shape_bezier(1, 0, width), &points[0][0][0], NULL));
        CHECK(verdict_of(model) != TAUT_TRUE, "%d spans", spans);
        taut_model_free(model);
    }
}

/* One point of a true net of many spans moved by little. */
static void test_moved(void)
{
    for (int trial = 0; trial < random_trials(30); trial++) {
        taut_bonnet_problem p = {.sign = random_int(0, 1) ? 1 : -1,
                                 .bspline = 1,
                                 .alpha = random_in(0.1, 1),
                                 .beta = random_in(0.1, 1),
                                 .segments = {random_int(1, 30), random_int(1, 5)},
                                 .theta = random_in(-4, 4)};
        taut_model *model = NULL, *moved = NULL;
        const double size = random_log(1e-7, 1), by[3] = {0, size, -size};
        p.lambda[0] = p.lambda[1] = random_in(0, 0.9);
        CHECK(taut_bonnet_make(&p, NULL, &model, NULL) == TAUT_OK, "makes");
        const taut_surface *s = taut_model_surface(model, 0);
        const int nu = taut_basis_count(taut_surface_u(s)),
                  nv = taut_basis_count(taut_surface_v(s));
        moved = model_moved(model, 0, random_int(0, nu * nv - 1), by);
        CHECK(verdict_of(model) != TAUT_FALSE, "honest");
        CHECK(verdict_of(moved) == TAUT_FALSE, "moved by %g", size);
        taut_model_free(moved);
        taut_model_free(model);
    }
}

/* What a motion, a size or a mirror leaves as it is. */
static void test_motions(void)
{
    for (int trial = 0; trial < random_trials(30); trial++) {
        taut_bonnet_problem p = {.sign = 1,
                                 .alpha = random_in(0.5, 3),
                                 .beta = random_in(0.5, 2),
                                 .theta = random_in(-4, 4)};
        double rotation[3][3];
        const double shift[3] = {random_in(-1, 1), random_in(-1, 1), random_in(-1, 1)};
        taut_model *model = NULL;
        p.lambda[0] = p.lambda[1] = random_in(0, 0.9);
        CHECK(taut_bonnet_make(&p, NULL, &model, NULL) == TAUT_OK, "makes");
        shape_rotation(rotation);
        taut_surface *turned = shape_moved(taut_model_surface(model, 0), random_log(1e-3, 1e3),
                                           (const double(*)[3])rotation, shift);
        taut_surface *other = shape_transposed(turned);
        taut_model *first = shape_model(turned), *second = shape_model(other);
        CHECK(verdict_of(first) == TAUT_TRUE, "moved");
        CHECK(verdict_of(second) == TAUT_TRUE, "u and v changed");
        taut_model_free(first);
        taut_model_free(second);
        taut_model_free(model);
    }
}

int main(void)
{
    random_seed(20261215);
    test_stairs();
    test_moved();
    test_motions();
    return check_failures != 0;
}
