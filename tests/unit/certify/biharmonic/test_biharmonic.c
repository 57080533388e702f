/* test_biharmonic.c -- the certificate of biharmonic attacked: points moved by ten times each limit and
 * by a tenth, rectangles that do not meet, sizes. */
#include "attack.h"
#include "certificates.h"
#include "check.h"
#include "shapes.h"

static void test_attacked(void)
{
    static const attack rows[] = {
        {"biharmonic-rows", "biharmonic", TAUT_BOUND, 0, 0, 24, 2e-14},
        {"biharmonic-rows", "boundary", TAUT_EXACT, 0, 0, 4, 2e-14},
        {"biharmonic-c1", "biharmonic", TAUT_BOUND, 1, 0, 15, 2e-14},
        {"biharmonic-c1", "boundary", TAUT_EXACT, 0, 0, 24, 2e-14},
        {"biharmonic-c1", "continuity", TAUT_BOUND, 1, 0, 7, 2e-14},
        {"biharmonic-c1", "least-bending", TAUT_EXACT, 1, 8, 15, 2e-14},
        {"biharmonic-c2", "continuity", TAUT_BOUND, 1, 0, 11, 2e-14},
        {"biharmonic-c2", "least-bending", TAUT_EXACT, 1, 0, 6, 2e-14},
    };
    for (size_t k = 0; k < sizeof rows / sizeof rows[0]; k++) {
        attack_claim(&rows[k], 4);
    }
}

static taut_verdict verdict_of(const taut_model *model, const char *name)
{
    taut_certificate *certificate = prove(model, NULL, "biharmonic");
    const taut_verdict holds = claim_of(certificate, name)->holds;
    taut_certificate_free(certificate);
    return holds;
}

static void test_sizes(void)
{
    static const int exponents[] = {-1010, -600, 0, 600, 1010};
    static const char *const names[] = {"biharmonic", "continuity", "least-bending"};
    subject s = subject_example("biharmonic-c1");
    for (size_t k = 0; k < sizeof exponents / sizeof exponents[0]; k++) {
        const double by[3] = {0, ldexp(1e-6, exponents[k]), 0};
        taut_model *scaled = model_scaled(s.model, exponents[k]);
        taut_model *moved = model_moved(scaled, 1, 6, by);
        for (int i = 0; i < 3; i++) {
            CHECK(verdict_of(scaled, names[i]) == TAUT_TRUE, "%s at 2^%d", names[i], exponents[k]);
            CHECK(verdict_of(moved, names[i]) == TAUT_FALSE, "%s moved at 2^%d", names[i],
                  exponents[k]);
        }
        taut_model_free(scaled);
        taut_model_free(moved);
    }
    subject_free(&s);
}

/* The neighbour's rectangle moved along its own parameter: the edges still meet, the parameters do
 * not. */
static void test_apart(void)
{
    subject s = subject_example("biharmonic-c1");
    const taut_surface *q = taut_model_surface(s.model, 1);
    const taut_basis *u = taut_surface_u(q), *v = taut_surface_v(q);
    const double lo = taut_basis_lo(u), hi = taut_basis_hi(u);
    taut_surface *away =
        shape_surface(shape_bezier(taut_basis_degree(u), lo + 1, hi + 1),
                      shape_bezier(taut_basis_degree(v), taut_basis_lo(v), taut_basis_hi(v)),
                      taut_surface_points(q), NULL);
    taut_model *model = model_with(s.model, 1, away);
    taut_certificate *certificate = prove(model, s.problem, NULL);
    CHECK(claim_of(certificate, "continuity")->holds == TAUT_FALSE, "rectangles apart");
    CHECK(claim_of(certificate, "biharmonic")->holds == TAUT_TRUE, "as biharmonic as before");
    taut_certificate_free(certificate);
    taut_model_free(model);
    subject_free(&s);
}

int main(void)
{
    random_seed(20261213);
    test_attacked();
    test_sizes();
    test_apart();
    return check_failures != 0;
}
