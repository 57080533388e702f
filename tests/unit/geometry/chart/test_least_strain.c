/* test_least_strain.c -- proved strains of gores of the sphere and strips of the catenoid, beside the closed forms of what their curvature
 * makes unavoidable: below them, and not by much. */
#include "check.h"
#include "geometry/chart/least_strain.h"

static const double sphere[4][4][3] = {
    {{0.5, 0.0, -0.8660254037844386},
     {1.2091995761561452, 0.0, -0.45656883758151967},
     {1.2091995761561452, 0.0, 0.45656883758151967},
     {0.5, 0.0, 0.8660254037844386}},
    {{0.5, 0.28539816339744833, -0.8660254037844386},
     {1.2091995761561452, 0.6902066764318736, -0.45656883758151967},
     {1.2091995761561452, 0.6902066764318736, 0.45656883758151967},
     {0.5, 0.28539816339744833, 0.8660254037844386}},
    {{0.28539816339744833, 0.5, -0.8660254037844386},
     {0.6902066764318736, 1.2091995761561452, -0.45656883758151967},
     {0.6902066764318736, 1.2091995761561452, 0.45656883758151967},
     {0.28539816339744833, 0.5, 0.8660254037844386}},
    {{0.0, 0.5, -0.8660254037844386},
     {0.0, 1.2091995761561452, -0.45656883758151967},
     {0.0, 1.2091995761561452, 0.45656883758151967},
     {0.0, 0.5, 0.8660254037844386}}};
static const double catenoid[4][4][3] = {
    {{1.5430806348152437, 0.0, -1.0},
     {0.7996330890615981, 0.0, -0.3673870059231905},
     {0.8557506998338412, 0.0, 0.5673870059231906},
     {1.8106555673243747, 0.0, 1.2}},
    {{1.5430806348152437, 0.8807847583008784, -1.0},
     {0.7996330890615981, 0.4564276300200167, -0.3673870059231905},
     {0.8557506998338412, 0.4884593561173187, 0.5673870059231906},
     {1.8106555673243747, 1.0335155469194828, 1.2}},
    {{0.8807847583008784, 1.5430806348152437, -1.0},
     {0.4564276300200167, 0.7996330890615981, -0.3673870059231905},
     {0.4884593561173187, 0.8557506998338412, 0.5673870059231906},
     {1.0335155469194828, 1.8106555673243747, 1.2}},
    {{0.0, 1.5430806348152437, -1.0},
     {0.0, 0.7996330890615981, -0.3673870059231905},
     {0.0, 0.8557506998338412, 0.5673870059231906},
     {0.0, 1.8106555673243747, 1.2}}};

static taut_surface *surface_of(const taut_basis_spec specs[2], const double *points)
{
    taut_basis *bases[2] = {NULL, NULL};
    taut_surface *surface = NULL;
    for (int d = 0; d < 2; d++) {
        CHECK(taut_basis_new(&specs[d], 4, &bases[d], NULL) == TAUT_OK, "basis");
    }
    CHECK(taut_surface_new("s", bases[0], bases[1], points, NULL, &surface, NULL) == TAUT_OK, "%s",
          "surface");
    taut_basis_free(bases[0]);
    taut_basis_free(bases[1]);
    return surface;
}

/* The line u = value of the window, from v0 to v1. */
static taut_curve *line_of(const taut_surface *surface, double value)
{
    static const taut_basis_spec spec = {.type = "bezier", .degree = 1};
    const taut_basis *v = taut_surface_v(surface);
    const double points[2][3] = {{value, taut_basis_lo(v), 0}, {value, taut_basis_hi(v), 0}};
    taut_basis *basis = NULL;
    taut_curve *curve = NULL;
    CHECK(taut_basis_new(&spec, 2, &basis, NULL) == TAUT_OK, "basis");
    CHECK(taut_curve_new("c", basis, points[0], NULL, &curve, NULL) == TAUT_OK, "curve");
    taut_basis_free(basis);
    return curve;
}

static taut_least_strain strip_of(const taut_surface *surface, double from, double to)
{
    taut_curve *right = line_of(surface, to), *left = line_of(surface, from);
    const taut_chart chart = {.surface = surface,
                              .edges = {right, NULL, left, NULL},
                              .part = {{0, 1}, {0, 1}, {0, 1}, {0, 1}}};
    const taut_least_strain least = taut_chart_least_strain(&chart, NULL);
    taut_curve_free(right);
    taut_curve_free(left);
    return least;
}

int main(void)
{
    static const double turn = 1.5707963267948966;
    static const taut_basis_spec specs[2][2] = {
        {{.type = "c-bezier", .alpha = 1.5707963267948966},
         {.type = "c-bezier", .alpha = 2.0943951023931957}},
        {{.type = "c-bezier", .alpha = 1.5707963267948966}, {.type = "h-bezier", .beta = 2.2}}};
    /* what the theorems give where all is known: papers print no more than these */
    static const struct {
        int surface, strips;
        double unavoidable, share;
    } rows[] = {
        {0, 3, 0.00986775245379, 0.9}, {0, 6, 0.00288934850503, 0.9}, {1, 4, 0.002743168, 0.85}};
    for (size_t k = 0; k < sizeof rows / sizeof rows[0]; k++) {
        taut_surface *surface = surface_of(specs[rows[k].surface],
                                           rows[k].surface == 0 ? sphere[0][0] : catenoid[0][0]);
        const taut_least_strain least = strip_of(surface, 0, turn / rows[k].strips);
        CHECK(least.strain > rows[k].share * rows[k].unavoidable &&
                  least.strain < rows[k].unavoidable,
              "row %d: %.10g of %.10g at %g, l %g, r %g", (int)k, least.strain, rows[k].unavoidable,
              least.at, least.length, least.radius);
        taut_surface_free(surface);
    }
    return check_failures != 0;
}
