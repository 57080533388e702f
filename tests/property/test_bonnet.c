/* test_bonnet.c -- random legal problems: each surface is the one of the formula, evaluated to 400
 * bits, its certificate never says that it is not, and a net moved by ten times a limit is told.
 * links: flint flint-arb gmp */
#include "certificates.h"
#include "check.h"

#include "core/constants.h"
#include "taut/bonnet.h"
#include "taut/operations.h"

#include <arb.h>
#include <string.h>

enum { BITS = 400 };

static double random_lambda(int normalize)
{
    switch (random_int(0, 3)) {
    case 0:
        return 0;
    case 1:
        return normalize ? 1 : 0.999;
    case 2:
        return 1 - random_log(1e-12, 1);
    default:
        return random_in(0, 1);
    }
}

/* Lengths over their whole range, starts as far off as the window is long. */
static taut_bonnet_problem random_problem(void)
{
    taut_bonnet_problem p = {.sign = random_int(0, 1) ? 1 : -1};
    p.normalize = random_int(0, 2) == 0;
    p.bspline = !p.normalize && random_int(0, 1);
    p.lambda[0] = p.lambda[1] = random_lambda(p.normalize);
    p.alpha = random_log(1e-5, p.bspline ? 2.5 : TAUT_PI);
    p.beta = random_log(1e-5, p.bspline ? 8 : p.normalize ? 10 : 100);
    if (p.bspline) {
        p.segments[0] = random_int(1, 6);
        p.segments[1] = random_int(1, 6);
    }
    if (p.normalize) {
        p.sign = -1;
    }
    if (random_int(0, 1)) {
        p.theta = random_in(-4, 4);
    }
    if (random_int(0, 1)) {
        p.start[0] = random_in(-2, 1) * p.alpha;
        p.start[1] = random_in(-1, 0) * p.beta;
    }
    return p;
}

static void say(const taut_bonnet_problem *p)
{
    check_say("lambda %.17g sign %d alpha %.17g beta %.17g bspline %d segments %d %d normalize %d "
              "theta %.17g start %.17g %.17g\n",
              p->lambda[0], p->sign, p->alpha, p->beta, p->bspline, p->segments[0], p->segments[1],
              p->normalize, p->theta, p->start[0], p->start[1]);
}

/* x = cos(theta) re + sin(theta) im, component by component; scratch t[2]. */
static double mixed(arb_ptr t, const arb_t re, const arb_t im, const arb_t c, const arb_t s)
{
    arb_mul(t, re, c, BITS);
    arb_addmul(t, im, s, BITS);
    return arf_get_d(arb_midref(t), ARF_RND_NEAR);
}

/* Phi of [XuWang2006] section 1 at (u, v) into re[3], im[3], w times its first two components. */
static void phi(double lambda, int sign, double u, double v, arb_ptr re, arb_ptr im)
{
    arb_ptr t = _arb_vec_init(8);
    arb_set_d(t, u), arb_set_d(t + 1, v), arb_set_d(t + 2, lambda);
    arb_sin_cos(t + 3, t + 4, t, BITS);
    arb_sinh_cosh(t + 5, t + 6, t + 1, BITS);
    arb_mul(re + 2, t + 4, t + 6, BITS);
    arb_mul_si(re + 2, re + 2, sign, BITS);
    arb_mul(im + 2, t + 3, t + 5, BITS);
    arb_mul_si(im + 2, im + 2, -sign, BITS);
    arb_mul(re, t + 3, t + 6, BITS); /* sin zeta */
    arb_mul_si(re, re, sign, BITS);
    arb_mul(im, t + 4, t + 5, BITS);
    arb_mul_si(im, im, sign, BITS);
    arb_mul(re + 1, im, t + 2, BITS); /* -i (zeta + sign lambda sin zeta) */
    arb_add(re + 1, re + 1, t + 1, BITS);
    arb_mul(im + 1, re, t + 2, BITS);
    arb_add(im + 1, im + 1, t, BITS);
    arb_neg(im + 1, im + 1);
    arb_addmul(re, t, t + 2, BITS);
    arb_addmul(im, t + 1, t + 2, BITS);
    _arb_vec_clear(t, 8);
}

/* The point of a problem with lambda < 1 at the surface's own parameters. */
static void exact(const taut_bonnet_problem *p, double u, double v, double x[3])
{
    arb_ptr re = _arb_vec_init(3), im = _arb_vec_init(3), t = _arb_vec_init(5);
    phi(p->lambda[0], p->sign, u, v, re, im);
    arb_set_d(t, p->lambda[0]); /* w */
    arb_mul(t, t, t, BITS);
    arb_sub_ui(t, t, 1, BITS);
    arb_neg(t, t);
    if (p->normalize) { /* minus Phi(0), whose only component is the third; 2 / w^2 */
        arb_add_ui(re + 2, re + 2, 1, BITS);
    }
    for (int k = 0; k < 3; k++) {
        for (int part = 0; part < 2; part++) {
            arb_ptr y = (part == 0 ? re : im) + k;
            if (p->normalize) {
                arb_mul_ui(y, y, 2, BITS);
                arb_div(y, y, t, BITS);
            }
            if (k < 2) {
                arb_sqrt(t + 1, t, BITS);
                arb_div(y, y, t + 1, BITS);
            }
        }
    }
    arb_set_d(t + 2, p->theta);
    arb_sin_cos(t + 3, t + 4, t + 2, BITS);
    for (int k = 0; k < 3; k++) {
        x[k] = mixed(t + 1, re + k, im + k, t + 4, t + 3);
    }
    _arb_vec_clear(re, 3);
    _arb_vec_clear(im, 3);
    _arb_vec_clear(t, 5);
}

/* Largest distance: a few roundings of the largest coordinate, or of the largest term (those of
 * the first two cancel near lambda = 1); and a parameter is known to 2^-53 of its distance from
 * zero, which moves the point by |r_u| of it. */
static double worst_distance;
static void against_formula(const taut_bonnet_problem *p, const taut_surface *surface)
{
    const taut_basis *u = taut_surface_u(surface), *v = taut_surface_v(surface);
    const double w = sqrt((1 - p->lambda[0]) * (1 + p->lambda[0]));
    double apart = 0, size = 0, moved = 0;
    for (int k = 0; k < 12; k++) {
        const double a = random_in(taut_basis_lo(u), taut_basis_hi(u));
        const double b = random_in(taut_basis_lo(v), taut_basis_hi(v));
        double x[3][3], y[3];
        CHECK(taut_surface_eval(surface, a, b, 1, &x[0][0]) == TAUT_OK, "evaluates");
        exact(p, a, b, y);
        for (int c = 0; c < 3; c++) {
            apart = fmax(apart, fabs(x[0][c] - y[c]));
            size = fmax(size, fmax(fabs(y[c]), p->normalize ? 0 : fmax(fabs(a), fabs(b)) / w));
            moved = fmax(moved, fabs(x[1][c] * fmax(fabs(taut_basis_lo(u)), fabs(a))) +
                                    fabs(x[2][c] * fmax(fabs(taut_basis_lo(v)), fabs(b))));
        }
    }
    const double limit = TAUT_UNIT_ROUNDOFF * (24 * size + 6 * moved);
    if (apart / limit > worst_distance) {
        worst_distance = apart / limit;
    }
    CHECK(apart <= limit, "%g over %g: ", apart, limit);
    if (apart > limit) {
        say(p);
    }
}

static void certify(const taut_bonnet_problem *p)
{
    taut_model *model = NULL;
    taut_certificate *certificate = NULL;
    taut_error error = {.message = ""};
    CHECK(taut_bonnet_make(p, NULL, &model, &error) == TAUT_OK, "%s", error.message);
    CHECK(taut_bonnet_certify(model, p, NULL, &certificate, &error) == TAUT_OK, "%s",
          error.message);
    for (int i = 0; i < taut_certificate_claim_count(certificate); i++) {
        const taut_claim *c = taut_certificate_claim(certificate, i);
        CHECK(c->holds != TAUT_FALSE, "%s: %g over %g: ", c->claim, c->residual, c->limit);
        if (c->holds == TAUT_FALSE) {
            say(p);
        }
    }
    if (p->lambda[0] < 1) {
        against_formula(p, taut_model_surface(model, 0));
    }
    taut_certificate_free(certificate);
    taut_model_free(model);
}

/* One point moved by a part of the size far above any limit: every claim that can see it fails. */
static void test_perturbed(void)
{
    static const char *const names[] = {"isothermal", "harmonic", "minimal", "algebraic",
                                        "formula"};
    for (int trial = 0; trial < random_trials(40); trial++) {
        const taut_bonnet_problem p = {.lambda = {0.5, 0.5},
                                       .sign = random_int(0, 1) ? 1 : -1,
                                       .alpha = random_in(0.5, 3),
                                       .beta = random_in(0.5, 2),
                                       .theta = random_in(-4, 4)};
        taut_model *model = NULL, *moved = NULL;
        taut_surface *surface = NULL;
        taut_certificate *certificate = NULL;
        double points[48];
        CHECK(taut_bonnet_make(&p, NULL, &model, NULL) == TAUT_OK, "makes");
        const taut_surface *s = taut_model_surface(model, 0);
        memcpy(points, taut_surface_points(s), sizeof points);
        for (int c = 0; c < 3; c++) {
            points[3 * random_int(0, 15) + c] += random_in(1e-9, 1e-8);
        }
        CHECK(taut_surface_new("bonnet", taut_surface_u(s), taut_surface_v(s), points, NULL,
                               &surface, NULL) == TAUT_OK &&
                  taut_model_new(&moved) == TAUT_OK &&
                  taut_model_add_surface(moved, surface) == TAUT_OK &&
                  taut_bonnet_certify(moved, &p, NULL, &certificate, NULL) == TAUT_OK,
              "trial %d", trial);
        for (size_t i = 0; i < sizeof names / sizeof names[0]; i++) {
            CHECK(claim_of(certificate, names[i])->holds == TAUT_FALSE,
                  "%s on a moved net: ", names[i]);
        }
        taut_certificate_free(certificate);
        taut_model_free(moved);
        taut_model_free(model);
    }
}

/* The pieces of a split and the refined net are the same surface (and still certified). */
static void test_same_surface(void)
{
    for (int trial = 0; trial < random_trials(60); trial++) {
        taut_bonnet_problem p = random_problem();
        taut_model *model = NULL, *cut = NULL;
        p.normalize = 0;
        p.lambda[0] = p.lambda[1] = fmin(p.lambda[0], 0.999);
        p.alpha = random_in(0.2, 2.5);
        p.beta = random_in(0.2, 4);
        CHECK(taut_bonnet_make(&p, NULL, &model, NULL) == TAUT_OK, "makes");
        const taut_surface *s = taut_model_surface(model, 0);
        const int along = random_int(0, 1);
        const taut_basis *basis = along ? taut_surface_v(s) : taut_surface_u(s);
        const double t = random_in(taut_basis_lo(basis), taut_basis_hi(basis));
        CHECK((trial % 2 ? taut_model_refine(model, NULL, 1, 1, &cut, NULL)
                         : taut_model_split(model, NULL, along, t, &cut, NULL)) == TAUT_OK,
              "cuts");
        for (int i = 0; i < taut_model_surface_count(cut); i++) {
            against_formula(&p, taut_model_surface(cut, i));
        }
        taut_model_free(cut);
        taut_model_free(model);
    }
}

int main(void)
{
    random_seed(20261121);
    for (int i = 0; i < random_trials(200); i++) {
        const taut_bonnet_problem p = random_problem();
        certify(&p);
    }
    test_perturbed();
    test_same_surface();
    if (check_failures != 0) {
        check_say("largest distance over its limit %g\n", worst_distance);
    }
    flint_cleanup();
    return check_failures != 0;
}
