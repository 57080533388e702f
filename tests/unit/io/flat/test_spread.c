/* test_spread.c -- pieces of a pattern beside their surface: each as it is, moved; in the plane of a page below what the surface takes of
 * it, in rows, apart; or on the ground where they are on the roll. */
#include "check.h"
#include "cloths.h"
#include "core/vec3.h"
#include "io/flat/spread.h"
#include "models.h"

#include <math.h>
#include <stdio.h>

enum { PIECES = 4 };
static const double half = 0.5, root = 0.86602540378443865; /* of three quarters */

/* The least and the largest of control points along a direction. */
static void range_of(int count, const double *points, const double way[3], double range[2])
{
    range[0] = INFINITY;
    range[1] = -INFINITY;
    for (int k = 0; k < count; k++) {
        range[0] = fmin(range[0], taut_dot(points + 3 * k, way));
        range[1] = fmax(range[1], taut_dot(points + 3 * k, way));
    }
}

static int count_of(const taut_surface *s)
{
    return taut_basis_count(taut_surface_u(s)) * taut_basis_count(taut_surface_v(s));
}

/* The same distances from the first point to all others. */
static void check_moved(const taut_surface *from, const taut_surface *to)
{
    const double *p = taut_surface_points(from), *q = taut_surface_points(to);
    for (int k = 1; k < count_of(from); k++) {
        double a[3], b[3];
        taut_difference(p + 3 * k, p, a);
        taut_difference(q + 3 * k, q, b);
        CHECK_NEAR(taut_norm(b), taut_norm(a), 1e-13 * 4, "point %d", k);
    }
}

static void check_page(const taut_model *model, const taut_model *spread, const double plane[2][3])
{
    double deep[3], boxes[PIECES][2][2], all[2], surface[2], level[2];
    double left = INFINITY, right = -INFINITY;
    taut_cross(plane[0], plane[1], deep);
    const taut_surface *sail = surface_named(spread, "sail");
    range_of(count_of(sail), taut_surface_points(sail), plane[1], surface);
    for (int k = 0; k < PIECES; k++) {
        char name[16], cut[16];
        snprintf(name, sizeof name, "P%d", k + 1);
        snprintf(cut, sizeof cut, "P%d.cut", k + 1);
        const taut_surface *piece = surface_named(spread, name);
        const taut_curve *outline = curve_named(spread, cut);
        CHECK(piece != NULL && outline != NULL, "%s", name);
        check_moved(surface_named(model, name), piece);
        range_of(count_of(piece), taut_surface_points(piece), deep, level);
        CHECK_NEAR(level[1], level[0], 1e-13, "%s lies in the page", name);
        for (int d = 0; d < 2; d++) {
            range_of(taut_basis_count(taut_curve_t(outline)), taut_curve_points(outline), plane[d],
                     boxes[k][d]);
        }
        CHECK(boxes[k][1][1] < surface[0], "%s is below the surface", name);
        left = fmin(left, boxes[k][0][0]);
        right = fmax(right, boxes[k][0][1]);
        for (int other = 0; other < k; other++) {
            int apart = 0;
            for (int d = 0; d < 2; d++) {
                apart |= boxes[k][d][0] > boxes[other][d][1] || boxes[other][d][0] > boxes[k][d][1];
            }
            CHECK(apart, "%s and P%d are apart", name, other + 1);
        }
    }
    const double length = taut_record_number(
        taut_record_get(taut_record_get(taut_model_details(model), "roll"), "length"));
    CHECK(length > 8, "four pieces, each longer than 2, one after the other: %g", length);
    CHECK(right - left < length / 2 + 0.1, "rows of half the roll or less: %g of %g", right - left,
          length);
    range_of(count_of(sail), taut_surface_points(sail), plane[0], all);
    CHECK_NEAR(left, all[0], 1e-12, "from the left of the surface");
}

int main(void)
{
    static const double plane[2][3] = {{root, half, 0}, {half * half, -half * root, root}};
    made_cloth made = cloth_make(SADDLE, "\"seams\": [{ \"across\": [\"v0\", \"v1\"], \"count\": 4 "
                                         "}], \"allowance\": { \"seam\": 0.02 }");
    taut_model *spread = NULL;

    CHECK(made.status == TAUT_OK, "%s", made.error.message);
    CHECK(taut_flat_spread(made.model, plane, &spread) == TAUT_OK && spread != NULL, "spread");
    check_page(made.model, spread, plane);
    taut_model_free(spread);

    /* on the ground: at the foot of the surface, each where the roll has it */
    CHECK(taut_flat_spread(made.model, NULL, &spread) == TAUT_OK && spread != NULL, "spread");
    const taut_surface *first = surface_named(spread, "P1"), *own = surface_named(made.model, "P1");
    check_moved(own, first);
    CHECK_NEAR(taut_surface_points(first)[2], -0.6, 1e-15, "at the foot");
    taut_model_free(spread);
    cloth_free(&made);
    return check_failures != 0;
}
