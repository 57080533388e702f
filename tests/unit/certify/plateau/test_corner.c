/* test_corner.c -- films two of whose edges leave a corner in nearly one direction: that they are at rest is a bound there too. */
#include "attack.h"
#include "certificates.h"
#include "check.h"
#include "logistic.h"

#include "taut/certify.h"

#include <math.h>
#include <stdio.h>

/* The sine between the edges at the corner is about `sine`. */
static subject film(double sine)
{
    char text[512];
    (void)snprintf(text, sizeof text,
                   "{\"taut\":1,\"construct\":\"plateau\",\"u\":{\"type\":\"bezier\",\"degree\":2},"
                   "\"v\":{\"type\":\"bezier\",\"degree\":2},\"points\":[[[0,0,0],[1,1,0],[2,0,1]],"
                   "[[%.17g,%.17g,0],null,[2.5,1,1]],[[0,2,1],[1,2.5,1],[2,2,0]]]}",
                   1 - sine, 1 + sine);
    return subject_of(text);
}

static double area_of(const taut_model *model)
{
    double figures[LOGISTIC_FIGURES];
    logistic_integrals(taut_model_surface(model, 0), 38, 0.125, figures);
    return figures[LOGISTIC_AREA];
}

/* No small move of the one free point changes the area, to first order, as another quadrature has it. */
static void check_rest(const taut_model *model, double sine)
{
    const double h = 1e-4, size = area_of(model);
    for (int c = 0; c < 3; c++) {
        double by[3] = {0, 0, 0}, area[2];
        for (int k = 0; k < 2; k++) {
            by[c] = k == 0 ? h : -h;
            taut_model *moved = model_moved(model, 0, 4, by);
            area[k] = area_of(moved);
            taut_model_free(moved);
        }
        CHECK(fabs(area[0] - area[1]) / (2 * h) < 1e-8 * size, "sine %g: %g", sine,
              (area[0] - area[1]) / (2 * h));
    }
}

int main(void)
{
    static const double sines[] = {0.2, 0.1, 0.03};
    for (size_t k = 0; k < sizeof sines / sizeof sines[0]; k++) {
        subject s = film(sines[k]);
        taut_certificate *certificate = prove(s.model, s.problem, NULL);
        const taut_claim *claim = claim_of(certificate, "stationary");
        CHECK(claim->kind == TAUT_BOUND && claim->holds == TAUT_TRUE, "sine %g: %g", sines[k],
              claim->residual);
        check_rest(s.model, sines[k]);
        taut_certificate_free(certificate);
        const double by[3] = {1e-4, 0, 1e-4};
        taut_model *moved = model_moved(s.model, 0, 4, by);
        certificate = prove(moved, s.problem, NULL);
        CHECK(claim_of(certificate, "stationary")->holds == TAUT_FALSE, "sine %g: moved", sines[k]);
        taut_certificate_free(certificate);
        taut_model_free(moved);
        subject_free(&s);
    }
    return check_failures != 0;
}
