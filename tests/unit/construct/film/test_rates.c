/* test_rates.c -- how films of three patches between unit circles come near to closed forms as spans are halved: catenoid and
 * unduloid, degrees 3 to 6. */
#include "certificates.h"
#include "check.h"

#include "taut/taut.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { PATCHES = 3, TEXT = 8192 };
static const double area_catenoid = 5.99179697580228191, area_unduloid = 7.85471151275085688,
                    pressure_unduloid = 2.19538004102530206,
                    volume_unduloid = 4.07837266924860460; /* between the discs */
static const double ended = 1e-11;      /* of the energy: what the last step gains */
static const double ended_first = 3e-9; /* of a pressure, which is off as the net is */

/* What is off, over what it is. */
typedef struct off {
    double energy, pressure, angle;
} off;

static void write_film(char text[TEXT], int degree, int spans, int is_unduloid)
{
    int used = snprintf(text, TEXT,
                        "{\"taut\":1,\"construct\":\"film\",\"least\":false,\"seams\":[[\"c0.u1\","
                        "\"c1.u0\"],[\"c1.u1\",\"c2.u0\"],[\"c2.u1\",\"c0.u0\"]],\"patches\":[");
    for (int k = 0; k < PATCHES; k++) {
        const double step = acos(-1) / PATCHES, a = 2 * k * step, b = a + step, c = b + step;
        used +=
            snprintf(text + used, (size_t)(TEXT - used),
                     "%s{\"name\":\"c%d\",\"u\":{\"type\":\"bspline\",\"degree\":%d,\"count\":%d},"
                     "\"v\":{\"type\":\"bspline\",\"degree\":%d,\"count\":%d},\"edges\":{",
                     k > 0 ? "," : "", k, degree, degree + spans, degree, degree + spans);
        for (int z = 0; z < 2; z++) {
            used += snprintf(text + used, (size_t)(TEXT - used),
                             "%s\"v%d\":{\"fixed\":{\"arc\":[[%.17g,%.17g,%d],[%.17g,%.17g,%d],"
                             "[%.17g,%.17g,%d]]}}",
                             z > 0 ? "," : "", z, cos(a), sin(a), z, cos(b), sin(b), z, cos(c),
                             sin(c), z);
        }
        used += snprintf(text + used, (size_t)(TEXT - used), "}}");
    }
    used += snprintf(text + used, (size_t)(TEXT - used), "]");
    if (is_unduloid) { /* over cones to the middle of one disc */
        used += snprintf(text + used, (size_t)(TEXT - used),
                         ",\"cells\":[{\"sides\":[\"c0\",\"c1\",\"c2\"],\"volume\":%.17g}]",
                         volume_unduloid - acos(-1) / 3);
    }
    (void)snprintf(text + used, (size_t)(TEXT - used), "}");
}

static off measure(int degree, int spans, int is_unduloid)
{
    static char text[TEXT];
    taut_problem *problem = NULL;
    taut_model *model = NULL;
    taut_certificate *proof = NULL;
    taut_error error = {.status = TAUT_OK};
    off found = {NAN, NAN, NAN};

    write_film(text, degree, spans, is_unduloid);
    if (taut_problem_read_text(text, strlen(text), "text", &problem, &error) == TAUT_OK &&
        taut_make(problem, NULL, &model, &error) == TAUT_OK &&
        taut_certify(model, problem, NULL, &proof, &error) == TAUT_OK) {
        const taut_record *pressures =
            taut_record_get(taut_certificate_figures(proof), "pressures");
        found.energy =
            fabs(figure_of(proof, "energy") / (is_unduloid ? area_unduloid : area_catenoid) - 1);
        found.pressure =
            is_unduloid
                ? fabs(taut_record_number(taut_record_at(pressures, 0)) / pressure_unduloid - 1)
                : 0;
        found.angle = figure_of(proof, "seam_angle");
        CHECK(taut_certificate_holds(proof) != TAUT_FALSE, "degree %d, %d spans", degree, spans);
    }
    CHECK(error.status == TAUT_OK, "%s", error.message);
    taut_certificate_free(proof);
    taut_model_free(model);
    taut_problem_free(problem);
    return found;
}

/* The energy as h^(2 p) and the pressure alike, down to where steps end; the angle, which is no more than a tangent's, as h^3. */
static void test_rates(int degree, int is_unduloid, int spans)
{
    const off coarse = measure(degree, 2, is_unduloid), fine = measure(degree, spans, is_unduloid);
    const double halvings = log2(spans / 2.0), fall = pow(2, 2 * degree * halvings);

    CHECK(fine.energy <= fmax(coarse.energy / fall, ended), "degree %d: energy %g, then %g", degree,
          coarse.energy, fine.energy);
    CHECK(fine.pressure <= fmax(coarse.pressure / fall, ended_first),
          "degree %d: pressure %g, then %g", degree, coarse.pressure, fine.pressure);
    CHECK(fine.angle <= coarse.angle / pow(8, halvings), "degree %d: angle %g, then %g", degree,
          coarse.angle, fine.angle);
}

int main(void)
{
    for (int degree = 3; degree <= 6; degree++) {
        test_rates(degree, 0, 8);
        test_rates(degree, 1, 4);
    }
    return check_failures != 0;
}
