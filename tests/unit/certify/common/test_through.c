/* test_through.c -- the claim `through` as a bound: of surfaces on all bases it is at least the distance that an evaluation in wider
 * numbers, which shares no code, finds; it holds of what passes through, and is a bound of polynomials and quotients of them. */
#include "bases.h"
#include "certificates.h"
#include "check.h"
#include "oracle/oracle.h"
#include "shapes.h"

#include "certify/common/through.h"

#include <math.h>
#include <string.h>

enum { MOST = 16, PLACES = 3, KNOTS = 64 };

static const char *const types[] = {"bezier",    "bspline",  "c-bezier", "c-bspline",
                                    "h-bspline", "h-bezier", "ce-bezier"};

static taut_basis *random_basis(int type)
{
    double knots[KNOTS];
    taut_basis_spec spec = {.type = types[type]};
    if (type < 2) {
        spec.degree = random_int(1, type == 0 ? MOST - 1 : 4);
        if (type == 1) {
            spec.knot_count = random_knots(spec.degree, 3, random_in(-1, 1), knots);
            spec.knots = knots;
        }
    } else if (type < 6) {
        spec = spec_of_spans(types[type], random_in(0.1, 3), 3, 0);
    } else {
        spec.alpha = spec.beta = spec.gamma = 1;
    }
    return shape_basis(&spec);
}

/* The largest difference of a coordinate from a place's point. */
static double distance_of(const taut_surface *surface, const taut_through *place)
{
    oracle_sheet sheet;
    oracle_real x[6][3], most = 0;
    CHECK(oracle_sheet_of(surface, &sheet), "the oracle's own");
    oracle_sheet_eval(&sheet, place->u, place->v, 0, x);
    for (int c = 0; c < 3; c++) {
        const oracle_real apart = x[0][c] + sheet.middle[c] - place->point[c];
        most = apart > most ? apart : -apart > most ? -apart : most;
    }
    oracle_sheet_free(&sheet);
    return (double)most;
}

static void check_surface(const taut_surface *surface, int is_polynomial, double scale, int trial)
{
    const taut_basis *u = taut_surface_u(surface), *v = taut_surface_v(surface);
    const int count = taut_basis_count(u) * taut_basis_count(v);
    unsigned char known[MOST * MOST] = {0};
    taut_through through[PLACES];
    taut_certificate *proof = NULL;
    double most = 0, size = 0;

    memset(known, 1, (size_t)count);
    for (int k = 0; k < PLACES; k++) {
        through[k].u = random_in(taut_basis_lo(u), taut_basis_hi(u));
        through[k].v = k == 0 ? taut_basis_lo(v) : random_in(taut_basis_lo(v), taut_basis_hi(v));
        taut_surface_eval(surface, through[k].u, through[k].v, 0, through[k].point);
        through[k].point[trial % 3] += scale * random_log(1e-17, 1e-15);
        most = fmax(most, distance_of(surface, &through[k]));
    }
    const taut_dirichlet_problem problem = {.u = u,
                                            .v = v,
                                            .points = taut_surface_points(surface),
                                            .known = known,
                                            .through = through,
                                            .through_count = PLACES};
    for (int k = 0; k < 3 * (count + PLACES); k++) {
        const double x = k < 3 * count ? problem.points[k] : through[k / 3 - count].point[k % 3];
        size = fmax(size, fabs(x - through[0].point[k % 3]));
    }
    CHECK(taut_certificate_new("dirichlet", &proof) == TAUT_OK &&
              taut_certify_add_through(surface, &problem, through, proof) == TAUT_OK,
          "trial %d", trial);
    const taut_claim *claim = claim_of(proof, "through");
    CHECK(claim->holds == TAUT_TRUE, "trial %d: %g, limit %g", trial, claim->residual,
          claim->limit);
    CHECK(!is_polynomial || claim->kind == TAUT_BOUND, "trial %d: kind %d", trial,
          (int)claim->kind);
    CHECK(claim->kind != TAUT_BOUND || claim->residual >= most / size * (1 - 1e-15),
          "trial %d: %g is below %g", trial, claim->residual, most / size);
    taut_certificate_free(proof);
}

static void test_bound(void)
{
    for (int trial = 0; trial < random_trials(400); trial++) {
        const int a = trial % 7, b = trial / 7 % 7;
        taut_basis *u = random_basis(a), *v = random_basis(b);
        const int count = taut_basis_count(u) * taut_basis_count(v),
                  is_rational = a < 2 && b < 2 && trial % 2;
        const double scale = random_log(1e-200, 1e200), away = random_in(-2, 2);
        const double heavy = random_log(1e-4, 1e4);
        double points[MOST * MOST][3], weights[MOST * MOST];
        for (int k = 0; k < count; k++) {
            for (int c = 0; c < 3; c++) {
                points[k][c] = scale * (away + random_in(-1, 1));
            }
            weights[k] = heavy * random_log(0.1, 10);
        }
        taut_surface *surface = shape_surface(u, v, points[0], is_rational ? weights : NULL);
        check_surface(surface, a < 2 && b < 2, scale, trial);
        taut_surface_free(surface);
    }
}

int main(void)
{
    random_seed(20261128);
    test_bound();
    return check_failures != 0;
}
