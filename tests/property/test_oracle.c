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

    if (!oracle_line_of(curve, &line)) {
        CHECK(0, "%s", name);
        return;
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
                CHECK_NEAR(theirs[d][k], (double)own[d][k], 1e-11 * size, "%s at %g, vector %d",
                           name, t, d);
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

int main(void)
{
    random_seed(1);
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
