/* test_reference.c -- the figures worked out for the surfaces of two papers.
 *
 * Energies are exact rationals; areas, means and extremes are printed to the digits given, and held
 * to half a unit of the last one.
 */
#include "check.h"
#include "papers.h"
#include "shapes.h"

#include "taut/measure.h"

/* What [WuWang2011] section 4 says of its Examples 1 to 4. */
typedef struct dirichlet_example {
    const char *name;
    double energy, area, area_tolerance;
    double max_mean, max_mean_tolerance, at[2]; /* and images under the symmetries */
    double mean_mean;
} dirichlet_example;

static const dirichlet_example examples[4] = {
    {"Example 1", 38.0 / 9, 4.1997155355182, 5e-14, 0.39921311, 5e-9, {0, 0.3371}, 0.174553},
    {"Example 2", 38.0 / 9, 4.1997155355182, 5e-14, 0.39921311, 5e-9, {0, 0.3371}, 0.174553},
    {"Example 3", 4307.0 / 1040, 4.1071898980869, 5e-14, 0.27494852, 5e-9, {0.1926, 1}, 0.118517},
    {"Example 4",
     346241839241.0 / 78187029830.0,
     4.2939345417597,
     5e-14,
     1.96740403,
     5e-9,
     {0, 0.5},
     0.156776},
};

/* |H| at one point. */
static double mean_at(const taut_surface *surface, const double at[2])
{
    double values[6][3];
    taut_forms forms;
    CHECK(taut_surface_eval(surface, at[0], at[1], 2, &values[0][0]) == TAUT_OK, "eval");
    taut_forms_of((const double(*)[3])values, &forms);
    return fabs(forms.mean);
}

static void test_dirichlet_examples(void)
{
    for (int i = 0; i < 4; i++) {
        const dirichlet_example *x = &examples[i];
        const paper_net *net = &wuwang2011[i];
        taut_surface *s = shape_surface(shape_bspline(net->degree, net->nu),
                                        shape_bspline(net->degree, net->nv), net->points[0], NULL);
        taut_surface_measure m;
        CHECK(taut_measure_surface(s, NULL, &m, NULL) == TAUT_OK, "%s", x->name);
        CHECK_NEAR(m.dirichlet_energy, x->energy, 1e-14, "%s", x->name);
        CHECK_NEAR(m.area, x->area, x->area_tolerance, "%s", x->name);
        CHECK_NEAR(m.mean_abs_mean, x->mean_mean, 5e-7, "%s", x->name);
        /* the place is printed to 1e-4, and |H| is stationary along the edge: 1e-8 off at most */
        CHECK_NEAR(mean_at(s, x->at), x->max_mean, x->max_mean_tolerance + 1e-8, "%s", x->name);
        /* on the grid of 101 the largest value is at most that, and half a cell away */
        CHECK(m.max_abs_mean <= x->max_mean + x->max_mean_tolerance, "%s: %.17g", x->name,
              m.max_abs_mean);
        CHECK_NEAR(m.max_abs_mean, x->max_mean, 2e-4, "%s", x->name);
        CHECK(m.area <= m.dirichlet_energy, "%s", x->name);
        taut_surface_free(s);
    }
}

/* [NiWang2015] section 4: P, its extension Q and both merged, H over the unit square. */
typedef struct harmonic_example {
    const char *name;
    const double (*points)[3];
    double energy;                  /* NaN: not given */
    double area, e_minus_g, four_f; /* iint (E-G)^2, iint 4 F^2 */
} harmonic_example;

static const harmonic_example harmonic[3] = {
    {"P", niwang2015_p, 397961. / 168000, 2.21140219258, 1.70680531569, 1.83434929463},
    {"Q", niwang2015_q, 391493. / 168000, 1.84846471642, 6.95223858409, 2.45843256303},
    {"H", niwang2015_h, NAN, 4.05986690901, NAN, NAN},
};

static void test_harmonic_example(void)
{
    for (int i = 0; i < 3; i++) {
        const harmonic_example *x = &harmonic[i];
        taut_surface *s =
            shape_surface(shape_bezier(3, 0, 1), shape_bezier(3, 0, 1), x->points[0], NULL);
        taut_surface_measure m;
        CHECK(taut_measure_surface(s, NULL, &m, NULL) == TAUT_OK, "%s", x->name);
        /* a whole unit: P is 2.21140219258684127 (mpmath), the last digit printed is cut */
        CHECK_NEAR(m.area, x->area, 1e-11, "%s", x->name);
        if (!isnan(x->energy)) {
            const double iota = sqrt(x->e_minus_g + x->four_f) / (2 * x->energy);
            CHECK_NEAR(m.dirichlet_energy, x->energy, 1e-14, "%s", x->name);
            CHECK_NEAR(m.isothermality, iota, 5e-12, "%s", x->name);
            /* harmonic: x_uu + x_vv = 0 up to rounding of second derivatives of size 20 */
            CHECK_NEAR(m.max_laplacian, 0, 5e-14, "%s", x->name);
        }
        taut_surface_free(s);
    }
}

int main(void)
{
    test_dirichlet_examples();
    test_harmonic_example();
    return check_failures != 0;
}
