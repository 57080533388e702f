/* test_oracle.c -- the judge from outside is itself right: its bases and surfaces against the
 * library's on random places of the worked examples, its integrals where they are known, and that
 * it finds what is put there.
 */
#include "check.h"
#include "cli/embedded_files.h"
#include "edit.h"
#include "oracle/oracle.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static void compare_surface(const taut_surface *surface, const char *name)
{
    oracle_sheet sheet;

    if (!oracle_sheet_of(surface, &sheet)) {
        CHECK(0, "%s", name);
        return;
    }
    for (int i = 0; i < 20; i++) {
        const double u = random_in(sheet.u.lo, sheet.u.hi), v = random_in(sheet.v.lo, sheet.v.hi);
        double theirs[6][3], scale[6] = {0};
        oracle_real own[6][3];
        CHECK(taut_surface_eval(surface, u, v, 2, theirs[0]) == TAUT_OK, "%s", name);
        oracle_sheet_eval(&sheet, u, v, 2, own);
        for (int d = 0; d < 6; d++) {
            /* a span's width makes derivatives large: the bound is of the sums of their terms */
            const double width = fmin(sheet.u.hi - sheet.u.lo, sheet.v.hi - sheet.v.lo) /
                                 fmax(sheet.u.spans, sheet.v.spans);
            scale[d] = 200 * (double)(sheet.size + oracle_norm(sheet.middle)) *
                       pow((1 + sheet.u.degree + sheet.v.degree) / width, d == 0  ? 0
                                                                          : d < 3 ? 1
                                                                                  : 2);
            for (int k = 0; k < 3; k++) {
                const double found = (double)(own[d][k] + (d == 0 ? sheet.middle[k] : 0));
                CHECK_NEAR(theirs[d][k], found, 1e-13 * scale[d], "%s at (%g, %g), vector %d", name,
                           u, v, d);
            }
        }
    }
    oracle_sheet_free(&sheet);
}

static void compare_curve(const taut_curve *curve, const char *name)
{
    oracle_line line;
    const taut_basis *basis = taut_curve_t(curve);
    const double *breaks = taut_basis_breaks(basis);
    double narrow =
        INFINITY; /* the narrowest span: derivative d of rounded points is good to u / narrow^d */

    if (!oracle_line_of(curve, &line)) {
        CHECK(0, "%s", name);
        return;
    }
    for (int i = 0; i < taut_basis_span_count(basis); i++) {
        narrow = fmin(narrow, breaks[i + 1] - breaks[i]);
    }
    for (int i = 0; i < 20; i++) {
        const double t = random_in(line.t.lo, line.t.hi);
        double theirs[3][3];
        oracle_real own[3][3];
        CHECK(taut_curve_eval(curve, t, 2, theirs[0]) == TAUT_OK, "%s", name);
        oracle_line_eval(&line, t, own);
        for (int d = 0; d < 3; d++) {
            for (int k = 0; k < 3; k++) {
                const double size =
                    1 + (double)(oracle_norm(own[0]) + oracle_norm(own[1]) + oracle_norm(own[2]));
                const double noise = 64 * 0x1p-53 * (double)oracle_norm(own[0]) / pow(narrow, d);
                CHECK_NEAR(theirs[d][k], (double)own[d][k], 1e-11 * size + noise,
                           "%s at %g, vector %d", name, t, d);
            }
        }
    }
    oracle_line_free(&line);
}

/* A plane of 2 by 3 with any parameters, and a saddle z = x y over the unit square. */
static void known_integrals(void)
{
    const taut_basis_spec spec = {.type = "bezier", .degree = 1};
    const double saddle[] = {0, 0, 0, 0, 1, 0, 1, 0, 0, 1, 1, 1};
    const double weights[] = {1, 3, 2, 6};
    const double plane[] = {0, 0, 0, 0, 3, 0, 2, 0, 0, 2, 3, 0};
    taut_basis *basis = NULL;
    taut_surface *surface = NULL;
    oracle_sheet sheet;
    oracle_integrals found;

    CHECK(taut_basis_new(&spec, 2, &basis, NULL) == TAUT_OK, "basis");
    CHECK(taut_surface_new("", basis, basis, plane, weights, &surface, NULL) == TAUT_OK, "plane");
    CHECK(oracle_sheet_of(surface, &sheet), "plane");
    oracle_integrate(&sheet, 1e-14L, 3, &found);
    CHECK_NEAR((double)found.area, 6, 1e-13, "a plane");
    oracle_sheet_free(&sheet);
    taut_surface_free(surface);
    CHECK(taut_surface_new("", basis, basis, saddle, NULL, &surface, NULL) == TAUT_OK, "saddle");
    CHECK(oracle_sheet_of(surface, &sheet), "saddle");
    oracle_integrate(&sheet, 1e-14L, 3, &found);
    CHECK_NEAR((double)found.dirichlet, 1 + 1.0 / 3, 1e-14, "half of 1 + v^2 + 1 + u^2");
    /* iint sqrt(1 + u^2 + v^2): sqrt(3)/3 - pi/18 + 2/3 log(2 + sqrt 3) ... by its closed form */
    CHECK_NEAR((double)found.area,
               sqrt(3) / 3 + 2.0 / 3 * log((1 + sqrt(3)) * (1 + sqrt(3)) / 2) - acos(-1) / 18,
               1e-13, "the saddle");
    oracle_sheet_free(&sheet);
    taut_surface_free(surface);
    taut_basis_free(basis);
}

/* A judge of films by what it finds of one with point (or number of a curve) `at` moved by `by`. */
static double judge_found(double (*judge)(const oracle_case *), const forge_base *base, int at,
                          int curve, double by)
{
    forge_pool pool = {malloc(1 << 16), 1 << 16, 0};
    edit_model *edit = malloc(sizeof *edit);
    double found = NAN;

    if (pool.bytes != NULL && edit != NULL) {
        edit_open(base->model, base->construct, &pool, edit);
        (curve ? edit->curve[0].points : edit->surface[0].points)[3 * at + 2] += by;
        taut_model *model = edit_close(edit);
        const oracle_case about = {base->construct, model, base->document, base->model, NAN, 0};
        found = judge(&about);
        taut_model_free(model);
    }
    free(edit);
    free(pool.bytes);
    return found;
}

/* A sail with two cables, and a flat film of side 2, whose lowest eigenvalue is pi^2 / 2. */
static void film_judges(void)
{
    static const char sail[] =
        "{\"taut\":1,\"construct\":\"film\",\"u\":{\"type\":\"bspline\",\"degree\":3,\"count\":5},"
        "\"v\":{\"type\":\"bspline\",\"degree\":3,\"count\":6},\"tension\":3,\"corners\":{"
        "\"u0v0\":[-1,-1,0.5],\"u1v0\":[1,-1,-0.5],\"u0v1\":[-1,1,-0.5],\"u1v1\":[1,1,0.5]},"
        "\"edges\":{\"u1\":{\"cable\":{\"force\":9}},\"v1\":{\"cable\":{\"force\":700}}}}";
    static const char flat[] =
        "{\"taut\":1,\"construct\":\"film\",\"u\":{\"type\":\"bspline\",\"degree\":3,\"count\":6},"
        "\"v\":{\"type\":\"bspline\",\"degree\":3,\"count\":6},\"corners\":{\"u0v0\":[0,0,0],"
        "\"u1v0\":[2,0,0],\"u0v1\":[0,2,0],\"u1v1\":[2,2,0]}}";
    enum { CORNER = 0, HELD_EDGE = 2, INSIDE = 14, CABLE = 26 /* of 5 by 6 points */ };
    forge_base base;

    CHECK(base_open("sail", sail, strlen(sail), &base), "the sail is made");
    CHECK(judge_found(oracle_film_stationary, &base, 0, 0, 0) < 1e-10, "it rests");
    CHECK(judge_found(oracle_film_stationary, &base, INSIDE, 0, 1e-7) > 1e-9, "inside");
    CHECK(judge_found(oracle_film_stationary, &base, CABLE, 0, 1e-7) > 1e-9, "at a cable");
    CHECK(judge_found(oracle_film_lowest, &base, 0, 0, 0) > 1, "it is stable");
    CHECK(judge_found(oracle_film_held, &base, 0, 0, 0) == 0, "corners");
    CHECK(judge_found(oracle_film_held, &base, CORNER, 0, 1e-12) > 0, "a corner moved");
    CHECK(judge_found(oracle_film_cables, &base, 0, 0, 0) == 0, "cables");
    CHECK(judge_found(oracle_film_cables, &base, 1, 1, 1e-12) == 1, "a cable moved");
    CHECK(judge_found(oracle_film_boundary, &base, 0, 0, 0) < 1e-15, "chords");
    CHECK(judge_found(oracle_film_boundary, &base, HELD_EDGE, 0, 1e-8) > 1e-9, "an edge moved");
    base_close(&base);
    CHECK(base_open("flat", flat, strlen(flat), &base), "the flat film is made");
    const double lowest = judge_found(oracle_film_lowest, &base, 0, 0, 0);
    CHECK(lowest > 2 * acos(-1) * acos(-1) && lowest < 24, "%g", lowest); /* of a wave near sines */
    base_close(&base);
}

/* Runs: the judges see what the certificate says of the made one, a piece that left its axis, and a run
 * that is too thick for its bends or for its other parts. */
static void run_judges(void)
{
    static const char *const names[] = {"pipe-run", "pipe-run-coil", "pipe-run-harness",
                                        "pipe-run-closed", "pipe-run-arcs"};
    enum { MOVED = 5 };

    for (const taut_embedded *file = taut_examples; file->name != NULL; file++) {
        forge_base base;
        size_t i = 0;
        while (i < sizeof names / sizeof names[0] && strcmp(file->name, names[i]) != 0) {
            i++;
        }
        if (i == sizeof names / sizeof names[0]) {
            continue;
        }
        CHECK(base_open(file->name, file->text, file->length, &base), "%s", file->name);
        const taut_certificate *said = taut_model_certificate(base.model);
        for (int k = 0; k < taut_certificate_claim_count(said); k++) {
            const taut_claim *claim = taut_certificate_claim(said, k);
            const double radius = taut_record_number(taut_record_get(base.document, "radius"));
            if (strcmp(claim->claim, "embedded") == 0) {
                const double found = judge_found(oracle_run_embedded, &base, 0, 0, 0);
                CHECK(found <= claim->residual * (1 + 1e-9) && found > 0.99 * claim->residual,
                      "%s: embedded %.10g, by the judge %.10g", file->name, claim->residual, found);
            }
            if (strcmp(claim->claim, "tube") == 0) {
                const double found = judge_found(oracle_run_tube, &base, 0, 0, 0);
                CHECK(found <= claim->residual + 1e-14 && found > 0.1 * claim->residual - 1e-14,
                      "%s: tube %.10g, by the judge %.10g", file->name, claim->residual, found);
                CHECK(judge_found(oracle_run_tube, &base, MOVED, 0, 0.1 * radius) > 1e-3,
                      "%s: a point moved", file->name);
            }
        }
        base_close(&base);
    }
}

int main(void)
{
    random_seed(1);
    film_judges();
    run_judges();
    for (const taut_embedded *file = taut_examples; file->name != NULL; file++) {
        forge_base base;
        if (!base_open(file->name, file->text, file->length, &base)) {
            CHECK(0, "%s is not made", file->name);
            continue;
        }
        for (int i = 0; i < taut_model_surface_count(base.model); i++) {
            compare_surface(taut_model_surface(base.model, i), file->name);
        }
        for (int i = 0; i < taut_model_curve_count(base.model); i++) {
            compare_curve(taut_model_curve(base.model, i), file->name);
        }
        base_close(&base);
    }
    known_integrals();
    return check_failures != 0;
}
