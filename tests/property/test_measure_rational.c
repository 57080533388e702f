/* test_measure_rational.c -- integrals of rational patches whose weights are far apart, against the
 * trapezoidal rule of logistic.h: they are to the digits that are printed, or come with an error
 * that is true. */
#include "check.h"
#include "logistic.h"
#include "shapes.h"

#include "taut/measure.h"

#include <string.h>

enum { LOCAL_MAX = 6 };

typedef enum weight_kind { CORNERED, INNER, RIDGED, SCATTERED, WEIGHT_KINDS } weight_kind;

/* Weights from 1 to `spread`: one corner; one point inside; one row; anywhere. */
static void fill_weights(weight_kind kind, int nu, int nv, double spread, double *w)
{
    const int at_u = kind == CORNERED ? (nu - 1) * random_int(0, 1) : random_int(0, nu - 1);
    const int at_v = kind == CORNERED ? (nv - 1) * random_int(0, 1) : random_int(0, nv - 1);
    for (int i = 0; i < nu; i++) {
        for (int j = 0; j < nv; j++) {
            const int chosen = kind == RIDGED ? i == at_u : i == at_u && j == at_v;
            w[i * nv + j] = kind == SCATTERED ? random_log(1, spread) : chosen ? spread : 1;
        }
    }
}

static taut_surface *random_patch(weight_kind kind, double spread)
{
    const int nu = random_int(2, LOCAL_MAX), nv = random_int(2, LOCAL_MAX);
    double points[LOCAL_MAX * LOCAL_MAX][3], w[LOCAL_MAX * LOCAL_MAX];
    for (int i = 0; i < nu; i++) {
        for (int j = 0; j < nv; j++) {
            double *p = points[i * nv + j];
            p[0] = i + random_in(-0.3, 0.3);
            p[1] = j + random_in(-0.3, 0.3);
            p[2] = random_in(-1, 1);
        }
    }
    fill_weights(kind, nu, nv, spread, w);
    return shape_surface(shape_bezier(nu - 1, 0, 1), shape_bezier(nv - 1, 0, 1), points[0], w);
}

/* Twice the change of the rule when its step is halved is far above its error; 1e-13 is rounding.
 * What the measure says of its own error must cover the rest, and where it says nothing 1e-10 does.
 */
static int compare(const taut_surface *s, const char *what, int trial)
{
    double coarse[LOGISTIC_FIGURES], fine[LOGISTIC_FIGURES];
    taut_surface_measure m;
    int sharp = 0;

    memset(&m, 0, sizeof m);
    CHECK(taut_measure_surface(s, NULL, &m, NULL) == TAUT_OK, "%s %d", what, trial);
    logistic_integrals(s, 48, 0.25, coarse);
    logistic_integrals(s, 48, 0.125, fine);
    const double found[LOGISTIC_FIGURES] = {m.area, m.dirichlet_energy, m.bending_energy,
                                            m.isothermality};
    const double told[LOGISTIC_FIGURES] = {m.area_error, m.dirichlet_energy_error,
                                           m.bending_energy_error, 0};
    for (int f = 0; f < LOGISTIC_FIGURES; f++) {
        const double own = fabs(fine[f] - coarse[f]) + 1e-13 * fine[f];
        const double allowed = told[f] > 0 ? told[f] : 1e-10 * fine[f];
        CHECK_NEAR(found[f], fine[f], allowed + own, "%s %d, figure %d, degrees %d %d, told %g",
                   what, trial, f, taut_basis_count(taut_surface_u(s)) - 1,
                   taut_basis_count(taut_surface_v(s)) - 1, told[f]);
        sharp += own < 1e-10 * fine[f];
    }
    return sharp;
}

static void test_random_weights(void)
{
    static const char *const names[WEIGHT_KINDS] = {"cornered", "inner", "ridged", "scattered"};
    const int trials = random_trials(12);
    int sharp = 0;
    for (int trial = 0; trial < trials; trial++) {
        const weight_kind kind = (weight_kind)(trial % WEIGHT_KINDS);
        taut_surface *s = random_patch(kind, random_log(10, 1e8));
        sharp += compare(s, names[kind], trial);
        taut_surface_free(s);
    }
    CHECK(sharp >= trials, "the trapezoidal rule was sharp for %d figures of %d", sharp,
          LOGISTIC_FIGURES * trials);
}

int main(void)
{
    random_seed(20261122);
    test_random_weights();
    return check_failures != 0;
}
