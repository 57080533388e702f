/* test_parting.c -- films of many patches that part, slide away or burst, and those just below that do not: catenoids of three and four
 * patches, half of one on a plane, caps of five patches under pressure. */
#include "certificates.h"
#include "check.h"

#include "taut/taut.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const double pi = 3.14159265358979323846;

/* The catenoid between unit circles: the largest 2 / sinh t0 apart, t0 tanh t0 = 1; half of it on a plane. From where two discs are
 * less: their area is that of the film, 2 pi. */
static const double parted = 1.32548683869836, slid = 0.66274341934918, beaten = 1.05539479392514;

typedef struct text {
    char data[12000];
    size_t used;
} text;

#define SAY(t, ...)                                                                                \
    ((t)->used += (size_t)snprintf((t)->data + (t)->used, sizeof(t)->data - (t)->used, __VA_ARGS__))

#define BASIS(p, n) "{\"type\":\"bspline\",\"degree\":" #p ",\"count\":" #n "}"

static void say_point(text *t, double radius, double angle, double z)
{
    SAY(t, "[%.17g,%.17g,%.17g]", radius * cos(angle), radius * sin(angle), z);
}

/* Of n arcs of a circle at height z number k; the last ends where the first begins. */
static void say_arc(text *t, double radius, int n, int k, double z)
{
    SAY(t, "{\"fixed\":{\"arc\":[");
    say_point(t, radius, 2 * pi * k / n, z);
    SAY(t, ",");
    say_point(t, radius, 2 * pi * (k + 0.5) / n, z);
    SAY(t, ",");
    say_point(t, radius, 2 * pi * ((k + 1) % n) / n, z);
    SAY(t, "]}}");
}

/* n patches around, up to a circle or a plane at this height. */
static void say_tube(text *t, int n, double height, int slides)
{
    t->used = 0;
    SAY(t, "{\"taut\":1,\"construct\":\"film\",\"patches\":[");
    for (int k = 0; k < n; k++) {
        SAY(t, "%s{\"name\":\"p%d\",\"u\":" BASIS(4, 9) ",\"v\":" BASIS(4, 8) ",\"edges\":{\"v0\":",
            k > 0 ? "," : "", k);
        say_arc(t, 1, n, k, 0);
        SAY(t, ",\"v1\":");
        if (slides) {
            SAY(t,
                "{\"slide\":{\"point\":[0,0,%.17g],\"normal\":[0,0,1]}}},\"corners\":{\"u0v1\":{"
                "\"near\":",
                height);
            say_point(t, 1, 2 * pi * k / n, height);
            SAY(t, "},\"u1v1\":{\"near\":");
            say_point(t, 1, 2 * pi * (k + 1) / n, height);
            SAY(t, "}}}");
        } else {
            say_arc(t, 1, n, k, height);
            SAY(t, "}}");
        }
    }
    SAY(t, "],\"seams\":[");
    for (int k = 0; k < n; k++) {
        SAY(t, "%s[\"p%d.u1\",\"p%d.u0\"]", k > 0 ? "," : "", k, (k + 1) % n);
    }
    SAY(t, "]}");
}

/* Three patches of degree 3 around, from the unit circle up to another. */
static void say_neck(text *t, double radius, double height, int nu, int nv)
{
    t->used = 0;
    SAY(t, "{\"taut\":1,\"construct\":\"film\",\"patches\":[");
    for (int k = 0; k < 3; k++) {
        SAY(t,
            "%s{\"name\":\"p%d\",\"u\":{\"type\":\"bspline\",\"degree\":3,\"count\":%d},"
            "\"v\":{\"type\":\"bspline\",\"degree\":3,\"count\":%d},\"edges\":{\"v0\":",
            k > 0 ? "," : "", k, nu, nv);
        say_arc(t, 1, 3, k, 0);
        SAY(t, ",\"v1\":");
        say_arc(t, radius, 3, k, height);
        SAY(t, "}}");
    }
    SAY(t, "],\"seams\":[[\"p0.u1\",\"p1.u0\"],[\"p1.u1\",\"p2.u0\"],[\"p2.u1\",\"p0.u0\"]]}");
}

/* A square in four quads about it, over the unit circle. */
static void say_cap(text *t, double pressure)
{
    static const char *const middle[4] = {"m.v0", "m.u1", "-m.v1", "-m.u0"};
    static const char *const corners[4] = {"u0v0", "u1v0", "u1v1", "u0v1"};

    t->used = 0;
    SAY(t, "{\"taut\":1,\"construct\":\"film\",\"patches\":[{\"name\":\"m\",\"u\":" BASIS(
               4, 8) ",\"v\":" BASIS(4, 8) ",\"corners\":{");
    for (int k = 0; k < 4; k++) {
        const double angle = 0.5 * pi * k;
        SAY(t, "%s\"%s\":{\"near\":[%.17g,%.17g,0]}", k > 0 ? "," : "", corners[k],
            0.5 * cos(angle), 0.5 * sin(angle));
    }
    SAY(t, "}}");
    for (int k = 0; k < 4; k++) { /* u along the circle, v outwards: x_u x x_v points down */
        SAY(t,
            ",{\"name\":\"q%d\",\"u\":" BASIS(4, 8) ",\"v\":" BASIS(4, 8) ",\"edges\":{\"v1\":", k);
        say_arc(t, 1, 4, k, 0);
        SAY(t, "},\"corners\":{\"u0v0\":null,\"u1v0\":null}}");
    }
    SAY(t, "],\"seams\":[");
    for (int k = 0; k < 4; k++) {
        SAY(t, "%s[\"q%d.v0\",\"%s\"],[\"q%d.u1\",\"q%d.u0\"]", k > 0 ? "," : "", k, middle[k], k,
            (k + 1) % 4);
    }
    SAY(t, "],\"cells\":[{\"sides\":[\"m\",\"-q0\",\"-q1\",\"-q2\",\"-q3\"],\"pressure\":%.17g}]}",
        pressure);
}

/* The certificate of a film that holds, or NULL where it is refused as it has to be. */
static taut_certificate *make(const text *t, const char *reason, taut_model **model,
                              taut_error *error)
{
    taut_problem *problem = NULL;
    taut_certificate *proof = NULL;

    CHECK(taut_problem_read_text(t->data, t->used, "text", &problem, error) == TAUT_OK, "%s",
          error->message);
    const taut_status status = taut_make(problem, NULL, model, error);
    if (reason != NULL) {
        CHECK(status == TAUT_NO_SOLUTION && strcmp(error->reason, reason) == 0, "%s: %s: %s",
              reason, error->reason, error->message);
    } else {
        CHECK(status == TAUT_OK, "%s: %s", error->reason, error->message);
        CHECK(taut_certify(*model, problem, NULL, &proof, error) == TAUT_OK, "%s", error->message);
        CHECK(taut_certificate_holds(proof) == TAUT_TRUE, "it holds");
    }
    taut_problem_free(problem);
    return proof;
}

static void check_refused(const text *t, const char *reason, const char *says, double least,
                          double most)
{
    taut_model *model = NULL;
    taut_error error = {.status = TAUT_OK};
    taut_certificate_free(make(t, reason, &model, &error));
    CHECK(strstr(error.message, says) != NULL, "%s: %s", says, error.message);
    CHECK(error.limit >= least && error.limit <= most, "%s: %.9g: %s", reason, error.limit,
          error.message);
    taut_model_free(model);
}

/* Are two discs less? */
static void check_made(const text *t, double energy, double off, int is_beaten)
{
    taut_model *model = NULL;
    taut_error error = {.status = TAUT_OK};
    taut_certificate *proof = make(t, NULL, &model, &error);
    const taut_record *rivals = taut_record_get(taut_model_details(model), "rivals");

    if (energy > 0) {
        CHECK_NEAR(figure_of(proof, "energy"), energy, off, "energy");
    }
    CHECK((taut_record_count(rivals) == 1) == is_beaten, "rivals");
    taut_certificate_free(proof);
    taut_model_free(model);
}

/* pi c^2 (sinh(h/c) + h/c) of the wider catenoid, c cosh(h / 2c) = 1. */
static double catenoid(double h)
{
    double c = 1;
    for (int k = 0; k < 100; k++) {
        c -= (c * cosh(0.5 * h / c) - 1) / (cosh(0.5 * h / c) - 0.5 * h / c * sinh(0.5 * h / c));
    }
    return pi * c * c * (sinh(h / c) + h / c);
}

static void test_parted(void)
{
    text t;
    const double below = parted * (1 - 1e-4);

    say_tube(&t, 4, below, 0);
    check_made(&t, catenoid(below), 2e-6, 1);
    say_tube(&t, 3, parted * (1 + 1e-4), 0);
    check_refused(&t, "collapses", "proved", parted, parted * (1 + 1e-4));
    say_tube(&t, 3, beaten * (1 - 1e-3), 0);
    check_made(&t, catenoid(beaten * (1 - 1e-3)), 2e-6, 0);
    say_tube(&t, 3, beaten * (1 + 1e-3), 0);
    check_made(&t, catenoid(beaten * (1 + 1e-3)), 2e-6, 1);
}

/* The limit of the refusal is the share of the distance that the last film was found at, by steps of 3e-5. */
static void test_slides_away(void)
{
    text t;

    say_tube(&t, 4, slid * (1 - 1e-4), 1);
    check_made(&t, 0.5 * catenoid(2 * slid * (1 - 1e-4)), 1e-6, 0);
    say_tube(&t, 4, slid * (1 + 1e-3), 1);
    check_refused(&t, "slides-away", "moved apart", (1 - 2e-4) / (1 + 1e-3),
                  (1 + 2e-4) / (1 + 1e-3));
}

/* The largest distance of circles of radius 1 and r that a catenoid joins: the largest c (arcosh(1/c) + arcosh(r/c)). */
static double farthest(double r)
{
    double low = 0, high = r;

    for (int k = 0; k < 200; k++) {
        double c[2], d[2];
        for (int i = 0; i < 2; i++) {
            c[i] = low + (high - low) * (1 + i) / 3;
            d[i] = c[i] * (acosh(1 / c[i]) + acosh(r / c[i]));
        }
        *(d[0] < d[1] ? &low : &high) = c[d[0] < d[1] ? 0 : 1];
    }
    return low * (acosh(1 / low) + acosh(r / low));
}

/* `found`, or "" where nothing is said. */
static const char *existence(const text *t)
{
    static char word[16];
    taut_model *model = NULL;
    taut_error error = {.status = TAUT_OK};

    taut_certificate_free(make(t, NULL, &model, &error));
    const taut_record *details = taut_model_details(model);
    const char *says =
        taut_record_text(taut_record_get(taut_record_get(details, "verdict"), "exists"));
    snprintf(word, sizeof word, "%s", says != NULL ? says : "");
    CHECK((word[0] == 0) == (taut_record_count(taut_record_get(details, "notes")) == 1), "notes");
    taut_model_free(model);
    return word;
}

/* A spline has films for a little longer than the continuous problem. Beyond it finer spaces have none, or leave the doubt. */
static void test_doubt(void)
{
    text t;

    say_neck(&t, 0.1, farthest(0.1) * (1 - 1e-3), 8, 6);
    CHECK(strcmp(existence(&t), "found") == 0, "a thin neck below the end");
    say_neck(&t, 0.1, farthest(0.1) * (1 + 1e-2), 8, 6); /* only a finer space refuses */
    check_refused(&t, "collapses", "moved apart", 0.98, 1 / (1 + 1e-2));
    say_neck(&t, 0.1, farthest(0.1) * (1 + 5e-4), 5, 5); /* by the method `normal` */
    CHECK(strcmp(existence(&t), "") == 0, "a thin neck beyond the end");
    say_neck(&t, 1, farthest(1) * (1 - 1e-3), 5, 5);
    CHECK(strcmp(existence(&t), "found") == 0, "a wide neck below the end");
    say_neck(&t, 1, farthest(1) * (1 + 1e-4), 5, 5); /* by all coordinates */
    CHECK(strcmp(existence(&t), "") == 0, "a wide neck beyond the end");
}

/* A cap of radius 2 / p: its area less p times its volume; half of a sphere is the last. */
static void test_burst(void)
{
    text t;
    const double p = 1.99, r = 2 / p, z = sqrt(r * r - 1), high = r - z;

    say_cap(&t, p);
    check_made(&t, 2 * pi * r * high - p * pi * high * high * (r - high / 3), 1e-6, 0);
    say_cap(&t, 2.01);
    check_refused(&t, "pressure-too-high", "2", 2 * (1 - 1e-5), 2 * (1 + 1e-5));
}

int main(void)
{
    test_parted();
    test_slides_away();
    test_doubt();
    test_burst();
    return check_failures != 0;
}
