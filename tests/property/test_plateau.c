/* test_plateau.c -- identities of the area and of its minimum over random nets. */
#include "check.h"
#include "problems.h"
#include "shapes.h"

#include "certify/common/curve_distance.h"
#include "construct/common/curve_fit.h"
#include "construct/plateau/area.h"
#include "taut/measure.h"
#include "taut/plateau.h"

#include <stdlib.h>
#include <string.h>

static double dot(size_t count, const double *a, const double *b)
{
    double sum = 0;
    for (size_t i = 0; i < count; i++) {
        sum += a[i] * b[i];
    }
    return sum;
}

static void fill(size_t count, double size, double *x)
{
    for (size_t i = 0; i < count; i++) {
        x[i] = random_in(-size, size);
    }
}

/* A random net over a plane, so that W stays away from 0. */
static void random_net(const taut_basis *u, const taut_basis *v, double *net)
{
    const int nu = taut_basis_count(u), nv = taut_basis_count(v);
    fill(3 * (size_t)(nu * nv), 0.2, net);
    for (int i = 0; i < nu * nv; i++) {
        net[3 * i] += 2.0 * (i / nv);
        net[3 * i + 1] += 2.0 * (i % nv);
    }
}

/* Vectors on one random net. */
typedef struct nets {
    taut_basis *u, *v;
    size_t size;
    double *x, *g, *a, *b, *ha, *hb, *moved, *far;
    taut_area_functional *functional;
} nets;

static nets nets_new(int rational)
{
    nets n;
    double weights[400];
    n.u = basis_uniform(random_int(2, 4), random_int(5, 8));
    n.v = basis_uniform(random_int(2, 4), random_int(5, 8));
    n.size = 3 * (size_t)taut_basis_count(n.u) * (size_t)taut_basis_count(n.v);
    double **const all[8] = {&n.x, &n.g, &n.a, &n.b, &n.ha, &n.hb, &n.moved, &n.far};
    for (int k = 0; k < 8; k++) {
        *all[k] = malloc(n.size * sizeof(double));
    }
    for (size_t i = 0; i < n.size / 3; i++) {
        weights[i] = random_in(0.7, 1.4);
    }
    random_net(n.u, n.v, n.x);
    n.functional = NULL;
    CHECK(taut_area_functional_new(n.u, n.v, rational ? weights : NULL, 6, &n.functional) ==
              TAUT_OK,
          "film");
    return n;
}

static void nets_free(nets *n)
{
    double *const all[8] = {n->x, n->g, n->a, n->b, n->ha, n->hb, n->moved, n->far};
    for (int k = 0; k < 8; k++) {
        free(all[k]);
    }
    taut_area_functional_free(n->functional);
    taut_basis_free(n->u);
    taut_basis_free(n->v);
}

static void move(const nets *n, double step)
{
    for (size_t i = 0; i < n->size; i++) {
        n->moved[i] = n->x[i] + step * n->a[i];
    }
}

/* Central differences of fourth order: error O(step^4) plus rounding over the step, both below 1e-9
 * of the size at step 1e-3. */
static void test_derivatives(void)
{
    const double h = 1e-3;
    for (int trial = 0; trial < 20; trial++) {
        nets n = nets_new(trial % 2);
        double area[4];
        fill(n.size, 1, n.a);
        fill(n.size, 1, n.b);
        for (int k = 0; k < 4; k++) {
            move(&n, h * (k < 2 ? k - 2 : k - 1));
            area[k] = taut_area_functional_value(n.functional, n.moved).area;
        }
        const double slope = (area[0] - 8 * area[1] + 8 * area[2] - area[3]) / (12 * h);
        memset(n.hb, 0, n.size * sizeof(double));
        for (int k = 0; k < 4; k++) {
            static const double factor[4] = {1, -8, 8, -1};
            move(&n, h * (k < 2 ? k - 2 : k - 1));
            taut_area_functional_gradient(n.functional, n.moved, n.far);
            for (size_t i = 0; i < n.size; i++) {
                n.hb[i] += factor[k] / (12 * h) * n.far[i];
            }
        }
        const double found = taut_area_functional_gradient(n.functional, n.x, n.g).area;
        CHECK_NEAR(dot(n.size, n.g, n.a), slope, 1e-8 * found, "slope");
        taut_area_functional_product(n.functional, 0, n.a, n.ha);
        const double size = sqrt(dot(n.size, n.ha, n.ha));
        for (size_t i = 0; i < n.size; i++) {
            n.hb[i] -= n.ha[i];
        }
        CHECK_NEAR(sqrt(dot(n.size, n.hb, n.hb)), 0, 1e-7 * size, "Hessian");
        nets_free(&n);
    }
}

/* The operators are symmetric; the metric one gives the gradient at the surface itself, and a bound
 * of the area everywhere ([WuWang2011] 7.1). */
static void test_operators(void)
{
    for (int trial = 0; trial < 40; trial++) {
        nets n = nets_new(trial % 2);
        const double theta = random_in(0, 1);
        const double area = taut_area_functional_gradient(n.functional, n.x, n.g).area;
        fill(n.size, 1, n.a);
        fill(n.size, 1, n.b);
        taut_area_functional_product(n.functional, theta, n.a, n.ha);
        taut_area_functional_product(n.functional, theta, n.b, n.hb);
        const double size = sqrt(dot(n.size, n.ha, n.ha) * dot(n.size, n.b, n.b));
        CHECK_NEAR(dot(n.size, n.ha, n.b), dot(n.size, n.hb, n.a), 1e-13 * size, "symmetry");
        taut_area_functional_product(n.functional, 1, n.x, n.ha);
        for (size_t i = 0; i < n.size; i++) {
            n.ha[i] -= n.g[i];
        }
        CHECK_NEAR(sqrt(dot(n.size, n.ha, n.ha)), 0, 1e-13 * sqrt(dot(n.size, n.g, n.g)), "L x");
        taut_area_functional_product(n.functional, 1, n.a, n.ha);
        move(&n, 1);
        const double bound = area + dot(n.size, n.g, n.a) + 0.5 * dot(n.size, n.a, n.ha);
        CHECK(taut_area_functional_value(n.functional, n.moved).area <= bound * (1 + 1e-14),
              "bound");
        nets_free(&n);
    }
}

static double least_area(const test_problem *net)
{
    taut_plateau_problem problem;
    taut_model *model = NULL;
    taut_error error = {0};
    double area = nan("");
    memset(&problem, 0, sizeof problem);
    problem.net = net->data;
    CHECK(taut_plateau_make(&problem, NULL, &model, &error) == TAUT_OK, "%s", error.message);
    if (model != NULL) {
        taut_surface_area(taut_model_surface(model, 0), &area, NULL);
    }
    taut_model_free(model);
    return area;
}

/* Moved, turned and scaled boundaries have moved, turned and scaled films. */
static void test_motion(void)
{
    for (int trial = 0; trial < 6; trial++) {
        test_problem net = problem_new(basis_uniform(2, 5), basis_uniform(3, 5));
        const double scale = random_log(1e-6, 1e6);
        double rotation[3][3], before = 0;
        shape_rotation(rotation);
        random_net(net.u, net.v, net.points);
        for (int i = 0; i < 25; i++) {
            net.known[i] = i < 5 || i >= 20 || i % 5 == 0 || i % 5 == 4;
        }
        before = least_area(&net);
        for (int i = 0; i < 25; i++) {
            double p[3];
            memcpy(p, net.points + 3 * i, sizeof p);
            for (int c = 0; c < 3; c++) {
                net.points[3 * i + c] = scale * (dot(3, rotation[c], p) + 3.0 * (c + 1));
            }
        }
        CHECK_NEAR(least_area(&net), before * scale * scale, 1e-11 * before * scale * scale,
                   "scale %.3g", scale);
        problem_free(&net);
    }
}

/* A random curve of degree 7, rational if limit > 1: weights in [1/limit, limit]. */
static taut_curve *random_curve(double limit)
{
    const taut_basis_spec spec = {.type = "bezier", .degree = 7};
    double points[24], weights[8];
    taut_basis *basis = NULL;
    taut_curve *curve = NULL;
    fill(24, 1, points);
    for (int i = 0; i < 8; i++) {
        weights[i] = random_log(1 / limit, limit);
    }
    CHECK(taut_basis_new(&spec, 0, &basis, NULL) == TAUT_OK &&
              taut_curve_new("", basis, points, limit > 1 ? weights : NULL, &curve, NULL) ==
                  TAUT_OK,
          "curve");
    taut_basis_free(basis);
    return curve;
}

/* The curve fitted to n cubic points. */
static taut_curve *fitted(const taut_curve *curve, int n, double *deviation)
{
    double ends[2][3], points[3 * 64];
    taut_basis *basis = basis_uniform(3, n);
    taut_curve *fit = NULL;
    taut_curve_eval(curve, 0, 0, ends[0]);
    taut_curve_eval(curve, 1, 0, ends[1]);
    CHECK(taut_curve_fit(curve, basis, (const double(*)[3])ends, points, deviation) == TAUT_OK,
          "fit");
    CHECK(taut_curve_new("", basis, points, NULL, &fit, NULL) == TAUT_OK, "fit");
    taut_basis_free(basis);
    return fit;
}

/* The integral of cos(3 t) times the error, first coordinate; and the largest error of all. */
static double moment(const taut_curve *curve, const taut_curve *fit, double *largest)
{
    enum { STEPS = 4000 };
    double sum = 0;
    *largest = 0;
    for (int k = 0; k < STEPS; k++) { /* midpoints: good to 1e-8 of the error itself */
        const double t = (k + 0.5) / STEPS;
        double x[3], y[3], apart = 0;
        taut_curve_eval(curve, t, 0, x);
        taut_curve_eval(fit, t, 0, y);
        sum += cos(3 * t) * (x[0] - y[0]) / STEPS;
        for (int c = 0; c < 3; c++) {
            apart += (x[c] - y[c]) * (x[c] - y[c]);
        }
        *largest = fmax(*largest, sqrt(apart));
    }
    return fabs(sum);
}

/* Moments of the error against smooth functions fall like h^6 and more, the error itself like h^4;
 * and the proved distance is above what samples find, though not by half. */
static void test_fit(void)
{
    for (int trial = 0; trial < 12; trial++) {
        taut_curve *curve = random_curve(trial % 2 == 1 ? 1.4 : 1);
        double deviation = 0, coarse = 0, fine = 0, bound = 0;
        taut_curve *few = fitted(curve, 19, &deviation), *many = fitted(curve, 35, &deviation);
        const double moments[2] = {moment(curve, few, &coarse), moment(curve, many, &fine)};
        CHECK(fine < coarse / 8, "h^4: %.3g after %.3g", fine, coarse);
        CHECK(moments[1] < 1e-3 * fine && moments[0] < 2e-2 * coarse,
              "moments %.3g, %.3g of errors %.3g, %.3g", moments[0], moments[1], coarse, fine);
        CHECK(taut_certify_distance(many, curve, &bound, NULL) == TAUT_OK && bound >= fine &&
                  bound <= 1.5 * fine + 1e-13 && bound >= deviation && bound <= 1.25 * deviation,
              "proved %.4g, sampled %.4g, told %.4g", bound, fine, deviation);
        taut_curve_free(few);
        taut_curve_free(many);
        taut_curve_free(curve);
    }
}

/* A space too poor for its curve, whose weights differ much: the proof follows them piece by piece,
 * so that the claim of the fit holds here too. */
static void test_poor_fit(void)
{
    for (int trial = 0; trial < 40; trial++) {
        taut_curve *curve = random_curve(5);
        double deviation = 0, seen = 0, bound = 0;
        taut_curve *fit = fitted(curve, random_int(4, 12), &deviation);
        (void)moment(curve, fit, &seen);
        CHECK(taut_certify_distance(fit, curve, &bound, NULL) == TAUT_OK && bound >= seen &&
                  bound <= 1.25 * deviation,
              "proved %.4g, sampled %.4g, told %.4g", bound, seen, deviation);
        taut_curve_free(fit);
        taut_curve_free(curve);
    }
}

int main(void)
{
    random_seed(20260115);
    test_derivatives();
    test_operators();
    test_motion();
    test_fit();
    test_poor_fit();
    return check_failures != 0;
}
