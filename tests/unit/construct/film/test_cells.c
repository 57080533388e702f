/* test_cells.c -- films under pressure against closed forms: caps, an unduloid, a lens, two bubbles; what is refused. */
#include "check.h"
#include "refused.h"

#include "taut/taut.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

enum { TEXT = 20000 };
static const double pi = 3.14159265358979323846;

typedef struct text {
    char at[TEXT];
    size_t length;
} text;

static void put(text *t, const char *format, ...)
{
    va_list values;
    va_start(values, format);
    t->length += (size_t)vsnprintf(t->at + t->length, TEXT - t->length, format, values);
    va_end(values);
    CHECK(t->length < TEXT, "the document is longer than %d", TEXT);
}

/* What a film is found to be. */
typedef struct found {
    double energy, area, volumes[2], pressures[2], lowest;
    int holds;
} found;

static double figure(const taut_certificate *certificate, const char *name, int k)
{
    const taut_record *at = taut_record_get(taut_certificate_figures(certificate), name);
    return taut_record_number(k < 0 ? at : taut_record_at(at, (size_t)k));
}

static found find(const char *document, int cells, const char *what)
{
    taut_problem *problem = NULL;
    taut_model *model = NULL;
    taut_certificate *certificate = NULL;
    taut_error error = {.status = TAUT_OK};
    found f = {.energy = NAN};

    CHECK(taut_problem_read_text(document, strlen(document), "text", &problem, &error) == TAUT_OK,
          "%s: %s: %s", what, error.where, error.message);
    CHECK(taut_make(problem, NULL, &model, &error) == TAUT_OK, "%s: %s", what, error.message);
    CHECK(taut_certify(model, problem, NULL, &certificate, &error) == TAUT_OK, "%s: %s", what,
          error.message);
    if (certificate != NULL) {
        f = (found){.energy = figure(certificate, "energy", -1),
                    .area = figure(certificate, "area", -1),
                    .lowest = figure(certificate, "lowest_eigenvalue", -1),
                    .holds = taut_certificate_holds(certificate) == TAUT_TRUE};
        for (int k = 0; k < cells; k++) {
            f.volumes[k] = figure(certificate, "volumes", k);
            f.pressures[k] = figure(certificate, "pressures", k);
        }
    }
    CHECK(f.holds == TAUT_TRUE, "%s does not hold", what);
    taut_certificate_free(certificate);
    taut_model_free(model);
    taut_problem_free(problem);
    return f;
}

/* ---- caps and an unduloid, of one patch that goes around ---- */

static void put_ring(text *t, double radius, double height, const char *end, const char *cell)
{
    t->length = 0;
    put(t,
        "{\"taut\":1,\"construct\":\"film\",\"u\":{\"type\":\"bspline\",\"degree\":4,\"count\":20},"
        "\"v\":{\"type\":\"bspline\",\"degree\":4,\"count\":10},\"seams\":[[\"u0\",\"u1\"]],"
        "\"edges\":{\"v0\":{\"fixed\":{\"circle\":{\"center\":[0,0,0],\"normal\":[0,0,1],"
        "\"radius\":%.17g}}},\"v1\":",
        radius);
    put(t, end, height, radius);
    put(t, "},\"cells\":[{\"name\":\"air\",\"sides\":[\"film\"],%s}]}", cell);
}

static const char pole[] = "{\"pole\":null}";
static const char circle[] =
    "{\"fixed\":{\"circle\":{\"center\":[0,0,%.17g],\"normal\":[0,0,1],\"radius\":%.17g}}}";

/* h (3 + h^2) pi / 6 = V over the unit circle: area pi (1 + h^2), pressure 2 / R, R = (1 + h^2) / (2 h). */
static double height_of(double volume)
{
    double h = 0.5;
    for (int k = 0; k < 100; k++) {
        h -= (pi / 6 * h * (3 + h * h) - volume) / (pi / 2 * (1 + h * h));
    }
    return h;
}

/* Second variation of a cap of curvature 1 / R and half angle a, of a given pressure: radial moves f with f'' + cot f' + (2 + R^2
 * lambda) f = 0 vanish at a; the page has the numbers. */
static void test_caps(void)
{
    static text t;
    const double h = height_of(1);
    put_ring(&t, 1, 0, pole, "\"volume\":1");
    found f = find(t.at, 1, "cap of volume 1");
    CHECK_NEAR(f.area, pi * (1 + h * h), 1e-8, "cap of volume 1");
    CHECK_NEAR(f.pressures[0], 4 * h / (1 + h * h), 1e-7, "its pressure");
    CHECK_NEAR(f.volumes[0], 1, 1e-12, "its volume");
    CHECK_NEAR(f.lowest, 8.60713245271602, 3e-5, "its lowest eigenvalue");

    /* dE/dV = p */
    double energies[2];
    for (int k = 0; k < 2; k++) {
        char cell[48];
        snprintf(cell, sizeof cell, "\"volume\":%.17g", k == 0 ? 0.999 : 1.001);
        put_ring(&t, 1, 0, pole, cell);
        energies[k] = find(t.at, 1, "cap nearby").energy;
    }
    CHECK_NEAR((energies[1] - energies[0]) / 0.002, f.pressures[0], 1e-6, "dE / dV");

    put_ring(&t, 1, 0, pole, "\"pressure\":1.5");
    f = find(t.at, 1, "cap of pressure 1.5");
    CHECK_NEAR(f.area, 3.781775762038303389, 1e-9, "cap of pressure 1.5");
    CHECK_NEAR(f.volumes[0], 0.757247796231903546, 1e-9, "its volume");
    CHECK_NEAR(f.energy, f.area - 1.5 * f.volumes[0], 1e-12, "its energy");
    CHECK_NEAR(f.lowest, 3.20904687538203, 2e-5, "its lowest eigenvalue");

    /* More than half a sphere is held by its volume. */
    const double high = height_of(4);
    put_ring(&t, 1, 0, pole, "\"volume\":4");
    f = find(t.at, 1, "cap of volume 4");
    CHECK_NEAR(f.area, pi * (1 + high * high), 1e-5, "cap of volume 4");
    CHECK_NEAR(f.pressures[0], 4 * high / (1 + high * high), 1e-5, "its pressure");
}

/* In other units, and with the cell on the other side. */
static void test_units(void)
{
    static text t;
    put_ring(&t, 1000, 0, pole, "\"volume\":-1e9,\"from\":[3,4,0]");
    const found f = find(t.at, 1, "cap in other units");
    const double h = height_of(1);
    CHECK_NEAR(f.area, 1e6 * pi * (1 + h * h), 1e-2, "cap in other units");
    CHECK_NEAR(f.pressures[0], -4e-3 * h / (1 + h * h), 1e-10, "its pressure");
}

/* The film of one volume is none of another, and not at rest under another pressure. */
static void test_moved(void)
{
    static text t;
    static const struct {
        const char *made, *asked, *claim;
    } rows[] = {{"\"volume\":1", "\"volume\":1.000000001", "volume"},
                {"\"pressure\":1.5", "\"pressure\":1.50000001", "stationary"}};

    for (size_t k = 0; k < 2; k++) {
        taut_problem *made = NULL, *asked = NULL;
        taut_model *model = NULL;
        taut_certificate *certificate = NULL;
        int fails = 0;
        put_ring(&t, 1, 0, pole, rows[k].made);
        CHECK(taut_problem_read_text(t.at, t.length, "text", &made, NULL) == TAUT_OK, "made");
        put_ring(&t, 1, 0, pole, rows[k].asked);
        CHECK(taut_problem_read_text(t.at, t.length, "text", &asked, NULL) == TAUT_OK, "asked");
        CHECK(taut_make(made, NULL, &model, NULL) == TAUT_OK, "model");
        CHECK(taut_certify(model, asked, NULL, &certificate, NULL) == TAUT_OK, "certificate");
        for (int c = 0; c < taut_certificate_claim_count(certificate); c++) {
            const taut_claim *claim = taut_certificate_claim(certificate, c);
            fails |= strcmp(claim->claim, rows[k].claim) == 0 && claim->holds == TAUT_FALSE;
        }
        CHECK(fails, "%s holds of another cell", rows[k].claim);
        taut_certificate_free(certificate);
        taut_model_free(model);
        taut_problem_free(made);
        taut_problem_free(asked);
    }
}

static void test_unduloid(void)
{
    static text t;
    char cell[64];
    snprintf(cell, sizeof cell, "\"volume\":%.17g,\"from\":[0,0,0]", 4.07837266924860460 - pi / 3);
    put_ring(&t, 1, 1, circle, cell);
    const found f = find(t.at, 1, "unduloid");
    CHECK_NEAR(f.area, 7.85471151275085688, 2e-9, "unduloid");
    CHECK_NEAR(f.pressures[0], 2.19538004102530206, 1e-8, "its pressure");
}

/* ---- bubbles: a quarter by mirrors, caps of three quads about their tops ---- */

#define PLANE_X "{\"point\":[0,0,0],\"normal\":[1,0,0]}"
#define PLANE_Y "{\"point\":[0,0,0],\"normal\":[0,1,0]}"

/* One cap over the quarter circle of radius r at z = 0, its top at z. corner: of the rim on the x axis. */
static void put_cap(text *t, int count, char name, double r, double z, const char *corner)
{
    const double a = 0.52 * r, b = 0.36 * r, d = sqrt(0.5) * r;
    char basis[64];
    snprintf(basis, sizeof basis, "{\"type\":\"bspline\",\"degree\":4,\"count\":%d}", count);
#define HEAD "{\"name\":\"%c%d\",\"u\":%s,\"v\":%s,\"corners\":{"
    put(t,
        HEAD "\"u0v0\":{\"near\":[0,0,%g]},\"u1v0\":{\"near\":[%g,0,%g]},\"u0v1\":{\"near\":[0,%g,"
             "%g]},\"u1v1\":{\"near\":[%g,%g,%g]}},\"edges\":{\"v0\":{\"mirror\":" PLANE_Y
             "},\"u0\":{\"mirror\":" PLANE_X "}}},",
        name, 0, basis, basis, z, a, 0.75 * z, a, 0.75 * z, b, b, 0.75 * z);
    put(t,
        HEAD "\"u0v0\":{\"near\":[%g,0,%g]},\"u1v0\":{%s\"near\":[%g,0,0]},\"u0v1\":{\"near\":[%g,%"
             "g,%g]},\"u1v1\":{\"near\":[%g,%g,0]}},\"edges\":{\"v0\":{\"mirror\":" PLANE_Y "}}},",
        name, 1, basis, basis, a, 0.75 * z, corner, r, b, b, 0.75 * z, d, d);
    put(t,
        HEAD "\"u0v0\":{\"near\":[0,%g,%g]},\"u1v0\":{\"near\":[%g,%g,%g]},\"u0v1\":{\"near\":[0,%"
             "g,0]},\"u1v1\":{\"near\":[%g,%g,0]}},\"edges\":{\"u0\":{\"mirror\":" PLANE_X "}}}",
        name, 2, basis, basis, a, 0.75 * z, b, b, 0.75 * z, r, d, d);
#undef HEAD
}

static void put_cap_seams(text *t, char n)
{
    put(t, "[\"%c0.u1\",\"%c1.u0\"],[\"%c0.v1\",\"%c2.v0\"],[\"%c1.v1\",\"%c2.u1\"],", n, n, n, n,
        n, n);
}

static const char volume[] = "\"volume\":0.25", little[] = "\"volume\":0.1";

/* Bubbles of volumes V and v in one another's side: the page has the closed form. */
static void put_double(text *t, int count, const char *small, const char *V, const char *v)
{
    static const char on[] = "\"plane\":{\"point\":[0,0,0],\"normal\":[0,0,1]},";
    t->length = 0;
    put(t, "{\"taut\":1,\"construct\":\"film\",\"patches\":[");
    put_cap(t, count, 'l', 0.5, -0.9, on);
    put(t, ",");
    put_cap(t, count, 'm', 0.5, 0.1, on);
    put(t, ",");
    put_cap(t, count, 's', 0.5, 0.6, on);
    put(t, "],\"seams\":[");
    put_cap_seams(t, 'l');
    put_cap_seams(t, 'm');
    put_cap_seams(t, 's');
    put(t,
        "[\"l1.u1\",\"m1.u1\",\"s1.u1\"],[\"l2.v1\",\"m2.v1\",\"s2.v1\"]],\"cells\":[{\"sides\":["
        "\"m0\",\"m1\",\"m2\",\"-l0\",\"-l1\",\"-l2\"],%s},{\"name\":\"small\","
        "\"sides\":[\"s0\",\"s1\",\"s2\",%s],%s}]}",
        V, small, v);
}

static void test_bubbles(void)
{
    static text t;
    const double degrees[2][3] = {{6, 2e-9, 2e-8}, {8, 2e-10, 3e-9}};
    for (int k = 0; k < 2; k++) {
        put_double(&t, (int)degrees[k][0], "\"-m0\",\"-m1\",\"-m2\"", volume, little);
        const found f = find(t.at, 2, "double bubble");
        CHECK_NEAR(f.energy, 1.77043418650916306, degrees[k][1], "double bubble");
        CHECK_NEAR(f.pressures[0], 3.12456246147921699, degrees[k][2], "its large one");
        CHECK_NEAR(f.pressures[1], 3.99148842302971126, degrees[k][2], "its small one");
    }
}

/* An eighth of a ball under a pressure, which is no minimum: it shrinks or grows. */
static const char ball[] =
    "{\"taut\":1,\"construct\":\"film\",\"patches\":"
    "[{\"name\":\"a\",\"u\":{\"type\":\"bspline\",\"degree\":4,\"count\":7},\"v\":{\"type"
    "\":\"bspline\",\"degree\":4,\"count\":7},\"corners\":{\"u0v0\":{\"near\":[0.6,0,0]},"
    "\"u1v0\":{\"near\":[0.42,0.42,0]},\"u0v1\":{\"near\":[0.42,0,0.42]},\"u1v1\":{\"near"
    "\":[0.34,0.34,0.34]}},\"edges\":{\"v0\":{\"mirror\":{\"point\":[0,0,0],\"normal\":[0"
    ",0,1]}},\"u0\":{\"mirror\":{\"point\":[0,0,0],\"normal\":[0,1,0]}}}},{\"name\":\"b\""
    ",\"u\":{\"type\":\"bspline\",\"degree\":4,\"count\":7},\"v\":{\"type\":\"bspline\","
    "\"degree\":4,\"count\":7},\"corners\":{\"u0v0\":{\"near\":[0,0.6,0]},\"u1v0\":{\"nea"
    "r\":[0,0.42,0.42]},\"u0v1\":{\"near\":[0.42,0.42,0]},\"u1v1\":{\"near\":[0.34,0.34,0"
    ".34]}},\"edges\":{\"v0\":{\"mirror\":{\"point\":[0,0,0],\"normal\":[1,0,0]}},\"u0\":"
    "{\"mirror\":{\"point\":[0,0,0],\"normal\":[0,0,1]}}}},{\"name\":\"c\",\"u\":{\"type"
    "\":\"bspline\",\"degree\":4,\"count\":7},\"v\":{\"type\":\"bspline\",\"degree\":4,\""
    "count\":7},\"corners\":{\"u0v0\":{\"near\":[0,0,0.6]},\"u1v0\":{\"near\":[0.42,0,0.4"
    "2]},\"u0v1\":{\"near\":[0,0.42,0.42]},\"u1v1\":{\"near\":[0.34,0.34,0.34]}},\"edges"
    "\":{\"v0\":{\"mirror\":{\"point\":[0,0,0],\"normal\":[0,1,0]}},\"u0\":{\"mirror\":{"
    "\"point\":[0,0,0],\"normal\":[1,0,0]}}}}],\"seams\":[[\"a.u1\",\"b.v1\"],[\"a.v1\","
    "\"c.u1\"],[\"b.u1\",\"c.v1\"]]"
    ",\"cells\":[{\"name\":\"air\",\"sides\":[\"a\",\"b\",\"c\"],\"pressure\":3}]";

/* What is proved of a film that is no minimum: E - p V, and volumes. */
static void find_stationary(const char *document, int cells, const char *what, found *f)
{
    taut_problem *problem = NULL;
    taut_model *model = NULL;
    taut_certificate *proof = NULL;
    taut_error error = {.status = TAUT_OK};

    CHECK(taut_problem_read_text(document, strlen(document), "text", &problem, &error) == TAUT_OK &&
              taut_make(problem, NULL, &model, &error) == TAUT_OK &&
              taut_certify(model, problem, NULL, &proof, &error) == TAUT_OK,
          "%s: %s", what, error.message);
    if (proof != NULL) {
        CHECK(taut_certificate_holds(proof) != TAUT_FALSE, "%s: a claim is false", what);
        f->energy = figure(proof, "energy", -1);
        f->area = figure(proof, "area", -1);
        f->lowest = figure(proof, "lowest_eigenvalue", -1);
        for (int k = 0; k < cells; k++) {
            f->volumes[k] = figure(proof, "volumes", k);
        }
    }
    taut_certificate_free(proof);
    taut_model_free(model);
    taut_problem_free(problem);
}

/* Bubbles of pressures: those of the closed form, and others, whose scaled film has the volumes of the scale. */
static void test_pressures(void)
{
    static text t;
    const double p[2] = {3.12456246147921699, 3.99148842302971126};
    for (int k = 0; k < 2; k++) {
        const double scale = k == 0 ? 1 : 1.02; /* of lengths */
        char laws[2][64];
        found f = {.energy = NAN};
        for (int i = 0; i < 2; i++) {
            snprintf(laws[i], sizeof laws[i], "\"pressure\":%.17g", p[i] / scale);
        }
        put_double(&t, 6, "\"-m0\",\"-m1\",\"-m2\"", laws[0], laws[1]);
        t.length--; /* the last brace */
        put(&t, ",\"accept\":\"stationary\"}");
        find_stationary(t.at, 2, "double bubble of two pressures", &f);
        CHECK_NEAR(f.energy, scale * scale * (1.77043418650916306 - 0.25 * p[0] - 0.1 * p[1]), 1e-9,
                   "E - p V");
        CHECK_NEAR(f.volumes[0], 0.25 * scale * scale * scale, 1e-8, "the large one");
        CHECK_NEAR(f.volumes[1], 0.1 * scale * scale * scale, 1e-8, "the small one");
        CHECK(f.lowest < 0, "it is no minimum");
    }
}

static void test_stationary(void)
{
    static text t;
    found f = {.energy = NAN};

    put(&t, "%s,\"accept\":\"stationary\"}", ball);
    find_stationary(t.at, 1, "ball of radius 2/3", &f);
    CHECK_NEAR(f.area, pi * 4 * 4 / 9 / 8, 1e-8, "ball of radius 2/3");
    CHECK_NEAR(f.volumes[0], pi * 4 / 3 * 8 / 27 / 8, 1e-8, "its volume");
    CHECK(f.lowest < 0, "it is no minimum");
    t.length = 0;
    put(&t, "%s}", ball);
    const taut_error error =
        check_document_refused(t.at, TAUT_NO_SOLUTION, "unstable", "/cells/0/pressure");
    CHECK(error.found == 1, "%s", error.message);
}

/* ---- what is refused ---- */

static void test_refused(void)
{
    static const struct {
        const char *end, *cell;
        taut_status status;
        const char *reason, *where;
    } rows[] = {
        {pole, "\"pressure\":2.01", TAUT_NO_SOLUTION, "pressure-too-high", "/cells/0/pressure"},
        {pole, "\"pressure\":-2.01", TAUT_NO_SOLUTION, "pressure-too-high", "/cells/0/pressure"},
        {pole, "\"pressure\":1,\"volume\":1", TAUT_BAD_INPUT, "conflict", "/cells/0"},
        {pole, "\"from\":[0,0,0]", TAUT_BAD_INPUT, "missing", "/cells/0"},
        {pole, "\"volume\":0", TAUT_BAD_INPUT, "value", "/cells/0/volume"},
        {pole, "\"volume\":1e30", TAUT_BAD_INPUT, "value", "/cells/0/volume"},
        {"{\"slide\":{\"point\":[0,0,0.3],\"normal\":[0,0,1]}}", "\"pressure\":0.1",
         TAUT_NO_SOLUTION, "open-cell", "/cells/0/from"},
    };
    static text t;

    for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
        put_ring(&t, 1, 1, rows[k].end, rows[k].cell);
        const taut_error error =
            check_document_refused(t.at, rows[k].status, rows[k].reason, rows[k].where);
        if (strcmp(rows[k].reason, "pressure-too-high") == 0) { /* proved, not found */
            CHECK_NEAR(error.limit, 2, 1e-6, "the pressure that the unit circle holds");
        }
    }
    put_double(&t, 6, "\"-m0\",\"-m1\",\"-l2\"", volume, little);
    check_document_refused(t.at, TAUT_BAD_INPUT, "cell-sides", "/cells/1/sides/5");
    put_double(&t, 6, "\"-m0\",\"-m1\"", volume, little);
    check_document_refused(t.at, TAUT_NO_SOLUTION, "open-cell", "/cells/1/from");
    put_double(&t, 6, "\"-m0\",\"-m1\",\"-n2\"", volume, little);
    check_document_refused(t.at, TAUT_BAD_INPUT, "name", "/cells/1/sides/5");
}

/* A tube between unit circles at distance 1: surfaces of revolution of one mean curvature end at 2.58697. However far beyond is
 * asked for, the last film that was found is near it. */
static void test_led(void)
{
    static const double asked[] = {4, 100};
    for (int k = 0; k < 2; k++) {
        static char tube[2000];
        snprintf(tube, sizeof tube,
                 "{\"taut\":1,\"construct\":\"film\",\"u\":{\"type\":\"bspline\",\"degree\":4,"
                 "\"count\":12},\"v\":{\"type\":\"bspline\",\"degree\":4,\"count\":6},"
                 "\"seams\":[[\"u0\",\"u1\"]],\"edges\":{\"v0\":{\"fixed\":{\"circle\":"
                 "{\"center\":[0,0,0],\"normal\":[0,0,1],\"radius\":1}}},\"v1\":{\"fixed\":"
                 "{\"circle\":{\"center\":[0,0,1],\"normal\":[0,0,1],\"radius\":1}}}},"
                 "\"cells\":[{\"name\":\"air\",\"sides\":[\"film\"],\"pressure\":%g}]}",
                 asked[k]);
        const taut_error error = check_document_refused(tube, TAUT_NO_SOLUTION, "pressure-too-high",
                                                        "/cells/0/pressure");
        CHECK(error.limit > 2.58697 * (1 - 1.0 / 512) && error.limit < 2.5871, "%g: %.17g",
              asked[k], error.limit);
    }
}

int main(void)
{
    test_caps();
    test_units();
    test_moved();
    test_unduloid();
    test_bubbles();
    test_stationary();
    test_pressures();
    test_refused();
    test_led();
    return check_failures != 0;
}
