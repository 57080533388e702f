/* bends.c -- from the elbows of a run to lengths, rotations and angles (LRA).
 *
 * Corners c_1 .. c_n between the run's two ends c_0 and c_n+1, d_k the direction from c_k-1 to c_k:
 *
 *     angle A_k       between d_k and d_k+1
 *     tangent T_k     R_k tan(A_k / 2), what an arc of radius R_k takes of each leg
 *     length L_k      |c_k - c_k-1| - T_k-1 - T_k
 *     rotation        from d_k-1 x d_k to d_k x d_k+1, about d_k
 */
#include "io/csv/bends.h"

#include "core/vec3.h"

#include <math.h>
#include <string.h>

static const double degree = 57.295779513082320877; /* 180 / pi */
static const double no_length = 1e-6;               /* over the radius: a run has no such pipe */

static double number_of(const taut_record *object, const char *member)
{
    const taut_record *found = taut_record_get(object, member);
    return found != NULL && taut_record_kind_of(found) == TAUT_RECORD_NUMBER
               ? taut_record_number(found)
               : nan("");
}

/* Point k of a list of points; 0 where it is none. */
static int point_at(const taut_record *list, size_t k, double point[3])
{
    const taut_record *item =
        list != NULL && taut_record_kind_of(list) == TAUT_RECORD_LIST && k < taut_record_count(list)
            ? taut_record_at(list, k)
            : NULL;
    if (item == NULL || taut_record_kind_of(item) != TAUT_RECORD_LIST ||
        taut_record_count(item) != 3) {
        return 0;
    }
    for (size_t c = 0; c < 3; c++) {
        const taut_record *x = taut_record_at(item, c);
        if (taut_record_kind_of(x) != TAUT_RECORD_NUMBER) {
            return 0;
        }
        point[c] = taut_record_number(x);
    }
    return 1;
}

/* The corner and the radius of a blend; 0 where it is no elbow at one. */
static int read_elbow(const taut_record *blend, double radius, taut_bend *bend)
{
    double again[3];
    if (taut_record_kind_of(blend) != TAUT_RECORD_OBJECT) {
        return 0;
    }
    const taut_record *polygon = taut_record_get(blend, "polygon");
    bend->radius = isnan(radius) ? number_of(blend, "least_bend_radius") : radius;
    return point_at(polygon, 1, bend->point) && point_at(polygon, 2, again) &&
           memcmp(bend->point, again, sizeof again) == 0 && bend->radius > 0;
}

/* The point at an end of the run: where its first curve begins, or its last one ends. */
static void end_of(const taut_model *model, int last, double point[3])
{
    const taut_curve *curve = taut_model_curve(model, last ? taut_model_curve_count(model) - 1 : 0);
    const size_t k = last ? (size_t)taut_basis_count(taut_curve_t(curve)) - 1 : 0;
    memcpy(point, taut_curve_points(curve) + 3 * k, 3 * sizeof *point);
}

static void direction_of(const taut_bend *from, const taut_bend *to, double d[3])
{
    taut_difference(to->point, from->point, d);
    const double length = taut_norm(d);
    for (int c = 0; c < 3; c++) {
        d[c] = length > 0 ? d[c] / length : 0;
    }
}

static double angle_of(const double a[3], const double b[3])
{
    double n[3];
    taut_cross(a, b, n);
    return taut_atan2(taut_norm(n), taut_dot(a, b));
}

/* From the plane of a and b to that of b and c, about the unit vector b. */
static double rotation_of(const double a[3], const double b[3], const double c[3])
{
    double n[3], m[3];
    taut_cross(a, b, n);
    taut_cross(b, c, m);
    return taut_atan2(taut_det(n, m, b), taut_dot(n, m));
}

/* What an arc takes of each of its legs: R tan(A / 2), by sin A / (1 + cos A). */
static double tangent_of(const taut_bend *bend, const double a[3], const double b[3])
{
    double n[3];
    taut_cross(a, b, n);
    return bend->radius * taut_norm(n) / (1 + taut_dot(a, b));
}

/* Lengths below `least` are no straight pipes: there two bends meet. */
static void fill_angles(taut_bend *bends, size_t count, double least)
{
    double taken = 0; /* of the leg by the bend before it */
    for (size_t k = 1; k < count; k++) {
        double before[3], here[3], next[3], tangent = 0;
        direction_of(&bends[k - 1], &bends[k], here);
        if (k + 1 < count) {
            direction_of(&bends[k], &bends[k + 1], next);
            bends[k].angle = angle_of(here, next) * degree;
            tangent = tangent_of(&bends[k], here, next);
            bends[k].rotation = 0;
        }
        if (k > 1 && k + 1 < count) {
            direction_of(&bends[k - 2], &bends[k - 1], before);
            bends[k].rotation = rotation_of(before, here, next) * degree;
        }
        bends[k].length = taut_distance(bends[k].point, bends[k - 1].point) - taken - tangent;
        bends[k].length = fabs(bends[k].length) < least ? 0 : bends[k].length;
        taken = tangent;
    }
}

taut_bend *taut_bends_of(const taut_model *model, taut_arena *arena, size_t *count)
{
    const taut_record *details = taut_model_details(model);
    const taut_record *blends = details != NULL ? taut_record_get(details, "blends") : NULL;
    if (blends == NULL || taut_record_kind_of(blends) != TAUT_RECORD_LIST ||
        taut_record_count(blends) == 0 || taut_model_curve_count(model) == 0) {
        return NULL;
    }
    *count = taut_record_count(blends) + 2;
    taut_bend *bends = taut_arena_take(arena, *count, sizeof *bends);
    for (size_t k = 0; bends != NULL && k < *count; k++) {
        bends[k] = (taut_bend){{0, 0, 0}, nan(""), nan(""), nan(""), nan("")};
        if (k > 0 && k + 1 < *count &&
            !read_elbow(taut_record_at(blends, k - 1), number_of(details, "bend_radius"),
                        &bends[k])) {
            return NULL;
        }
    }
    if (bends != NULL) {
        end_of(model, 0, bends[0].point);
        end_of(model, 1, bends[*count - 1].point);
        fill_angles(bends, *count, no_length * number_of(details, "radius"));
    }
    return bends;
}
