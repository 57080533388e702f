#include "sails.h"

#include "certificates.h"
#include "check.h"

#include <math.h>
#include <string.h>

const double sail_square[4][3] = {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {2, 2, 0}};
const double sail_saddle[4][3] = {{-1, -1, 0.5}, {1, -1, -0.5}, {-1, 1, -0.5}, {1, 1, 0.5}};

static taut_basis *spline(int degree, int count)
{
    const taut_basis_spec spec = {.type = "bspline", .degree = degree, .count = count};
    taut_basis *basis = NULL;
    CHECK(taut_basis_new(&spec, count, &basis, NULL) == TAUT_OK, "degree %d", degree);
    return basis;
}

sail sail_new(int degree, int count, const double corners[4][3], double force)
{
    sail made = {.u = spline(degree, count), .v = spline(degree, count)};
    made.problem.u = made.u;
    made.problem.v = made.v;
    memcpy(made.problem.corners, corners, sizeof made.problem.corners);
    memset(made.problem.has_corner, 1, 4);
    for (int e = 0; e < 4; e++) {
        made.problem.edges[e].kind = force > 0 ? TAUT_FILM_CABLE : TAUT_FILM_FIXED;
        made.problem.edges[e].force = force;
    }
    return made;
}

/* (b cos t, b sin t, t) over [0, h] lies in the space of a c-bezier of length h: its four control
 * points from the values at four places, by Gauss elimination. */
static taut_curve *helix(double b, double h)
{
    const taut_basis_spec spec = {.type = "c-bezier", .alpha = h};
    double m[4][7];
    taut_basis *basis = NULL;
    taut_curve *curve = NULL;

    CHECK(taut_basis_new(&spec, 4, &basis, NULL) == TAUT_OK, "h %g", h);
    for (int i = 0; i < 4; i++) {
        const double t = h * i / 3;
        (void)taut_basis_eval(basis, 0, t, 0, m[i]);
        m[i][4] = b * cos(t);
        m[i][5] = b * sin(t);
        m[i][6] = t;
    }
    for (int k = 0; k < 4; k++) {
        for (int i = 0; i < 4; i++) {
            const double factor = i == k ? 0 : m[i][k] / m[k][k];
            for (int j = 0; j < 7; j++) {
                m[i][j] -= factor * m[k][j];
            }
        }
    }
    double points[4][3];
    for (int i = 0; i < 4; i++) {
        for (int c = 0; c < 3; c++) {
            points[i][c] = m[i][4 + c] / m[i][i];
        }
    }
    CHECK(taut_curve_new("helix", basis, points[0], NULL, &curve, NULL) == TAUT_OK, "h %g", h);
    taut_basis_free(basis);
    return curve;
}

sail sail_helicoid(int degree, int count, double a, double h)
{
    const double corners[4][3] = {{a, 0, 0}, {0}, {a * cos(h), a * sin(h), h}, {0}};
    sail made = sail_new(degree, count, corners, 0);
    made.curve = helix(2, h);
    made.problem.has_corner[1] = made.problem.has_corner[3] = 0;
    made.problem.edges[0] = (taut_film_edge){.kind = TAUT_FILM_CABLE, .force = (1 + a * a) / a};
    made.problem.edges[1].curve = made.curve;
    return made;
}

void sail_free(sail *s)
{
    taut_basis_free(s->u);
    taut_basis_free(s->v);
    taut_curve_free(s->curve);
}

taut_model *sail_make(const sail *s, taut_certificate **certificate)
{
    taut_model *model = NULL;
    taut_error error = {.status = TAUT_OK};

    *certificate = NULL;
    CHECK(taut_film_make(&s->problem, NULL, &model, &error) == TAUT_OK, "%s: %s", error.reason,
          error.message);
    if (model == NULL) {
        return NULL;
    }
    CHECK(taut_film_certify(model, &s->problem, NULL, certificate, &error) == TAUT_OK, "%s",
          error.message);
    for (int k = 0; *certificate != NULL && k < taut_certificate_claim_count(*certificate); k++) {
        const taut_claim *claim = taut_certificate_claim(*certificate, k);
        CHECK(claim->holds == TAUT_TRUE || strcmp(claim->claim, "least") == 0, "%s: %g, limit %g",
              claim->claim, claim->residual, claim->limit);
    }
    return model;
}

double sail_figure(const taut_certificate *certificate, const char *name, size_t at)
{
    const taut_record *list = taut_record_get(taut_certificate_figures(certificate), name);
    return taut_record_number(taut_record_at(list, at));
}

taut_model *film_made(const taut_film_problem *problem, taut_certificate **certificate,
                      const char *what)
{
    taut_error error = {.status = TAUT_OK};
    taut_model *model = NULL;
    const taut_status status = taut_film_make(problem, NULL, &model, &error);

    *certificate = NULL;
    CHECK(status == TAUT_OK, "%s: %s: %s", what, error.reason, error.message);
    if (status == TAUT_OK) {
        CHECK(taut_film_certify(model, problem, NULL, certificate, NULL) == TAUT_OK, "%s", what);
    }
    return model;
}

void film_holds(const taut_certificate *certificate, size_t count, const char *const *claims,
                const char *what)
{
    for (size_t k = 0; k < count; k++) {
        const taut_claim *claim = claim_of(certificate, claims[k]);
        CHECK(claim->holds == TAUT_TRUE, "%s: %s: %g at %s", what, claims[k], claim->residual,
              claim->where);
    }
}
