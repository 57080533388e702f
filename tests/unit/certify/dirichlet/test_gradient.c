/* test_gradient.c -- gradients of energies and of areas against sums over the same Gauss points, one point
 * and one function after another; and the same bits from every kernel and any number of threads. */
#include "check.h"
#include "shapes.h"

#include "certify/dirichlet/gradient.h"
#include "certify/dirichlet/gradient_kernel.h"
#include "core/constants.h"
#include "core/vec3.h"
#include "numeric/quadrature.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { LOCAL_MAX = 8, COUNT_MAX = 24, POINTS = COUNT_MAX * COUNT_MAX };

static taut_basis *random_spline(int most)
{
    const int degree = random_int(1, 6);
    double knots[64];
    int at = 0;

    for (int k = 0; k <= degree; k++) {
        knots[at++] = -0.5;
    }
    for (double t = -0.5;
         at < degree + 1 + most - degree - 1;) { /* inner knots, some of them repeated */
        t += random_int(0, 3) == 0 ? 0 : random_in(0.1, 0.4);
        int times = 1;
        while (times < at && knots[at - times] == t) {
            times++;
        }
        t += times > degree ? 0.1 : 0;
        knots[at++] = t > -0.5 ? t : -0.4;
    }
    const double end = knots[at - 1] + 0.25;
    for (int k = 0; k <= degree; k++) {
        knots[at++] = end;
    }
    const taut_basis_spec spec = {
        .type = "bspline", .degree = degree, .knots = knots, .knot_count = at};
    return shape_basis(&spec);
}

static taut_surface *random_net(int most, int rational)
{
    taut_basis *u = random_spline(random_int(8, most)), *v = random_spline(random_int(8, most));
    const int nu = taut_basis_count(u), nv = taut_basis_count(v);
    double points[POINTS][3], weights[POINTS];

    for (int i = 0; i < nu * nv; i++) {
        points[i][0] = (i / nv + random_in(-0.2, 0.2)) / nu;
        points[i][1] = (i % nv + random_in(-0.2, 0.2)) / nv;
        points[i][2] = random_in(-0.2, 0.2);
        weights[i] = random_in(1, 3);
    }
    return shape_surface(u, v, points[0], rational ? weights : NULL);
}

/* What is summed at one point. */
typedef struct place {
    double u[2 * LOCAL_MAX], v[2 * LOCAL_MAX]; /* functions and slopes */
    int first[2];
    double weight, f[3], x[3][3]; /* f: of |x_u|^2, 2 x_u.x_v, |x_v|^2 */
} place;

/* values += the place's, by the definition. */
static void add_place(const taut_surface *s, const place *p, double *values)
{
    const int lu = taut_basis_local(taut_surface_u(s)), lv = taut_basis_local(taut_surface_v(s));
    const int nv = taut_basis_count(taut_surface_v(s));
    const double *weights = taut_surface_weights(s);
    double w = 0, wu = 0, wv = 0;

    for (int pass = 0; pass < 2; pass++) {
        for (int k = 0; k < lu * lv; k++) {
            const int a = k / lv, b = k % lv, at = (p->first[0] + a) * nv + p->first[1] + b;
            const double weight = weights != NULL ? weights[at] : 1;
            const double n = weight * p->u[a] * p->v[b], nu = weight * p->u[lu + a] * p->v[b];
            const double slope_v = weight * p->u[a] * p->v[lv + b];
            if (pass == 0) {
                w += n;
                wu += nu;
                wv += slope_v;
                continue;
            }
            const double phi_u = nu / w - n * wu / (w * w), phi_v = slope_v / w - n * wv / (w * w);
            for (int c = 0; c < 3; c++) {
                values[3 * at + c] +=
                    p->weight * (phi_u * (p->f[0] * p->x[TAUT_XU][c] + p->f[1] * p->x[TAUT_XV][c]) +
                                 phi_v * (p->f[1] * p->x[TAUT_XU][c] + p->f[2] * p->x[TAUT_XV][c]));
            }
        }
    }
}

/* Functions and slopes at node k of a span; returns the node's weight. */
static double fill_node(const taut_basis *basis, int span, double node, double weight, double *t,
                        double *values, int *first)
{
    const double *breaks = taut_basis_breaks(basis);
    const double width = breaks[span + 1] - breaks[span];
    *t = breaks[span] + width * (0.5 + 0.5 * node);
    *first = taut_basis_first(basis, span);
    CHECK(taut_basis_eval(basis, span, *t, 1, values) == TAUT_OK, "basis");
    return 0.5 * weight * width;
}

static void find_plainly(const taut_surface *s, int is_area, int nodes, double *values)
{
    const taut_basis *u = taut_surface_u(s), *v = taut_surface_v(s);
    double node[TAUT_GAUSS_MAX], rule[TAUT_GAUSS_MAX];

    taut_gauss_rule(nodes, node, rule);
    for (int i = 0; i < taut_basis_span_count(u) * nodes; i++) {
        for (int j = 0; j < taut_basis_span_count(v) * nodes; j++) {
            place p = {.f = {1, 0, 1}};
            double at[2];
            p.weight =
                fill_node(u, i / nodes, node[i % nodes], rule[i % nodes], &at[0], p.u,
                          &p.first[0]) *
                fill_node(v, j / nodes, node[j % nodes], rule[j % nodes], &at[1], p.v, &p.first[1]);
            CHECK(taut_surface_eval(s, at[0], at[1], 1, p.x[0]) == TAUT_OK, "point");
            if (is_area) {
                double normal[3];
                taut_cross(p.x[TAUT_XU], p.x[TAUT_XV], normal);
                const double w = taut_length(normal);
                p.f[0] = taut_dot(p.x[TAUT_XV], p.x[TAUT_XV]) / w;
                p.f[1] = -taut_dot(p.x[TAUT_XU], p.x[TAUT_XV]) / w;
                p.f[2] = taut_dot(p.x[TAUT_XU], p.x[TAUT_XU]) / w;
            }
            add_place(s, &p, values);
        }
    }
}

static taut_status make(const taut_surface *s, int is_area, const taut_gradient_rule *rule,
                        taut_dirichlet_gradient *gradient)
{
    return is_area ? taut_area_gradient_new(s, rule, gradient)
                   : taut_dirichlet_gradient_new(s, 1, rule, gradient);
}

/* Rounding is what the gradient says of itself, and as much again for the plain sum. */
static void test_against_plain_sums(void)
{
    for (int trial = 0; trial < random_trials(24); trial++) {
        const int is_area = trial % 2;
        taut_surface *s = random_net(14, trial / 2 % 2);
        const int count = taut_basis_count(taut_surface_u(s)) * taut_basis_count(taut_surface_v(s));
        const double lu = taut_basis_hi(taut_surface_u(s)) - taut_basis_lo(taut_surface_u(s));
        const double lv = taut_basis_hi(taut_surface_v(s)) - taut_basis_lo(taut_surface_v(s));
        const taut_crew crew = {random_int(0, 3), NULL};
        const taut_gradient_rule rule = {.nodes = random_int(2, 19), .crew = &crew};
        double values[3 * POINTS] = {0};
        taut_dirichlet_gradient g = {.unit = 0};

        CHECK(make(s, is_area, &rule, &g) == TAUT_OK, "gradient");
        find_plainly(s, is_area, rule.nodes, values);
        for (int i = 0; g.values != NULL && i < 3 * count; i++) {
            const double scale = is_area ? 1 : fmin(lu / lv, lv / lu);
            CHECK_NEAR(g.values[i], ldexp(values[i], -g.unit) * scale,
                       TAUT_UNIT_ROUNDOFF * g.roundings * g.gross[i / 3], "%d of trial %d", i,
                       trial);
        }
        taut_dirichlet_gradient_clear(&g);
        taut_surface_free(s);
    }
}

static void check_same(const taut_dirichlet_gradient *a, const taut_dirichlet_gradient *b,
                       int count, const char *what)
{
    CHECK(memcmp(a->values, b->values, 3 * (size_t)count * sizeof(double)) == 0, "%s", what);
    CHECK(memcmp(a->gross, b->gross, (size_t)count * sizeof(double)) == 0, "%s: gross", what);
    CHECK(memcmp(a->halves, b->halves, sizeof a->halves) == 0, "%s: halves", what);
    CHECK(memcmp(a->halves_gross, b->halves_gross, sizeof a->halves) == 0, "%s: noise", what);
    CHECK(memcmp(&a->area, &b->area, sizeof a->area) == 0, "%s: area", what);
}

static void test_same_bits(void)
{
    static const char *const kernels[3] = {"baseline", "avx2", "avx512"};
    for (int trial = 0; trial < random_trials(12); trial++) {
        taut_surface *s = random_net(COUNT_MAX, trial / 2 % 2);
        const int count = taut_basis_count(taut_surface_u(s)) * taut_basis_count(taut_surface_v(s));
        taut_gradient_rule rule = {.nodes = random_int(2, 12)};
        taut_dirichlet_gradient first = {.unit = 0}, again = {.unit = 0};
        CHECK(make(s, trial % 2, &rule, &first) == TAUT_OK, "gradient");
        for (int k = 0; k < 3; k++) {
            setenv("TAUT_KERNEL", kernels[k], 1); /* one that is not there is passed over */
            const taut_crew crew = {k + 1, NULL};
            rule.crew = &crew;
            CHECK(make(s, trial % 2, &rule, &again) == TAUT_OK, "gradient");
            check_same(&first, &again, count, kernels[k]);
            taut_dirichlet_gradient_clear(&again);
        }
        unsetenv("TAUT_KERNEL");
        taut_dirichlet_gradient_clear(&first);
        taut_surface_free(s);
    }
}

int main(void)
{
    test_against_plain_sums();
    test_same_bits();
    return check_failures != 0;
}
