/* judge_pipes.c -- judges of round pipes between two straight ones, and of identity.
 *
 *     joint     gap over radius, sine between normals, around the ring
 *     tube      |distance from the axis - radius| at places of every span around and along; and the
 *               other side: rings that close and go once around, from one end of the axis to the other
 *     embedded  the largest curvature sampled; nearest pairs at right angles to both tangents, found
 *               by going from one to the other's nearest point in turn
 */
#include "oracle/route.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static double radius_of(const oracle_case *about)
{
    const taut_record *from =
        about->problem != NULL ? about->problem : taut_model_details(about->model);
    const double radius = taut_record_number(taut_record_get(from, "radius"));

    if (taut_record_get(about->problem, "sections") != NULL ||
        taut_record_get(about->problem, "radii") != NULL ||
        taut_record_get(taut_model_details(about->model), "sections") != NULL ||
        taut_record_get(taut_model_details(about->model), "radii") != NULL ||
        oracle_curve(about->model, "axis") == NULL) {
        return NAN;
    }
    return radius;
}

static double joint_of(const oracle_case *about, const char *before, const char *after)
{
    return oracle_joint_between(oracle_surface(about->model, before),
                                oracle_surface(about->model, after), radius_of(about));
}

double oracle_joint1(const oracle_case *about)
{
    return joint_of(about, "pipe1", "blend");
}

double oracle_joint2(const oracle_case *about)
{
    return joint_of(about, "blend", "pipe2");
}

/* Of a straight pipe: worst distance from its line; how far it reaches from the joint in *reach. */
static oracle_real tube_of_straight(const oracle_sheet *sheet, const oracle_route *route, int end,
                                    double radius, oracle_real *reach)
{
    oracle_real worst = 0, near = INFINITY;

    *reach = 0;
    for (int i = 0; i <= 6; i++) {
        const oracle_real u = sheet->u.lo + ((oracle_real)sheet->u.hi - sheet->u.lo) * i / 6;
        for (int j = 0; j <= sheet->v.spans * 3; j++) {
            const oracle_real v =
                sheet->v.lo + ((oracle_real)sheet->v.hi - sheet->v.lo) * j / (sheet->v.spans * 3);
            oracle_real x[6][3], d[3], c[3];
            oracle_sheet_eval(sheet, u, v, 0, x);
            for (int k = 0; k < 3; k++) {
                d[k] = x[0][k] + sheet->middle[k] - route->end[end][k];
            }
            oracle_cross(d, route->way[end], c);
            worst = fmaxl(worst, fabsl(oracle_norm(c) - radius) / radius);
            const oracle_real along = oracle_dot(d, route->way[end]) * (end ? 1 : -1);
            *reach = fmaxl(*reach, along);
            near = fminl(near, along);
        }
    }
    return fabsl(near) > 1e-5L * radius ? fmaxl(worst, fabsl(near) / radius) : worst;
}

static double tube_of(const oracle_case *about, oracle_real reach[2], int straight)
{
    const double radius = radius_of(about);
    oracle_route route;
    oracle_sheet sheet;
    oracle_real worst = 0;

    /* a run has no one axis, whatever curve of that name is added to it */
    if (isnan(radius) || oracle_surface(about->model, "blend") == NULL ||
        !oracle_route_of(oracle_curve(about->model, "axis"), &route)) {
        return NAN;
    }
    for (int e = 0; e < 2; e++) {
        if (oracle_sheet_of(oracle_surface(about->model, e ? "pipe2" : "pipe1"), &sheet)) {
            worst = fmaxl(worst, tube_of_straight(&sheet, &route, e, radius, &reach[e]));
            oracle_sheet_free(&sheet);
        }
    }
    if (!straight && oracle_sheet_of(oracle_surface(about->model, "blend"), &sheet)) {
        worst = fmaxl(worst, oracle_tube_along(&sheet, &route, radius));
        oracle_sheet_free(&sheet);
    }
    oracle_line_free(&route.line);
    return (double)worst;
}

double oracle_tube(const oracle_case *about)
{
    oracle_real reach[2];

    return oracle_curve(about->model, "axis") == NULL ? oracle_run_tube(about)
                                                      : tube_of(about, reach, 0);
}

static oracle_real curve_distance(const taut_curve *a, const taut_curve *b)
{
    oracle_line own, other;
    oracle_real worst = 0, size = 0;

    if (!oracle_line_of(a, &own)) {
        return INFINITY;
    }
    if (!oracle_line_of(b, &other)) {
        oracle_line_free(&own);
        return INFINITY;
    }
    for (int i = 0; i <= 16; i++) {
        const oracle_real s = (oracle_real)i / 16;
        oracle_real x[3][3], y[3][3];
        oracle_line_eval(&own, own.t.lo * (1 - s) + own.t.hi * s, x);
        oracle_line_eval(&other, other.t.lo * (1 - s) + other.t.hi * s, y);
        for (int k = 0; k < 3; k++) {
            worst = fmaxl(worst, fabsl(x[0][k] - y[0][k]));
            size = fmaxl(size, fabsl(y[0][k]));
        }
    }
    oracle_line_free(&own);
    oracle_line_free(&other);
    return worst / size;
}

double oracle_pipe_distance(const oracle_case *about)
{
    const double radius = radius_of(about);
    const oracle_case honest = {about->construct, about->honest, about->problem, NULL, NAN, 0};
    oracle_real worst = 0, reach[2] = {0, 0}, own[2] = {0, 0};

    for (int i = 0; i < taut_model_curve_count(about->honest); i++) {
        const taut_curve *curve = taut_model_curve(about->honest, i);
        worst =
            fmaxl(worst, curve_distance(oracle_curve(about->model, taut_curve_name(curve)), curve));
    }
    if (!isnan(tube_of(about, reach, 1)) && !isnan(tube_of(&honest, own, 1))) {
        worst = fmaxl(worst, fabsl(reach[0] - own[0]) / (radius + own[0]));
        worst = fmaxl(worst, fabsl(reach[1] - own[1]) / (radius + own[1]));
    }
    return (double)worst;
}

static oracle_real largest_radius(oracle_route *route, double radius)
{
    enum { PLACES = 360, PAIRS = 8 };
    static _Thread_local oracle_place place[PLACES];
    struct {
        double d;
        int i, j;
    } pair[PAIRS];
    oracle_real best = oracle_sharpest(route), x[3], way[3], speed;

    for (int i = 0; i < PLACES; i++) {
        const int part = i < 60 ? 0 : i < 300 ? 1 : 2;
        const oracle_real f = part == 0   ? (oracle_real)i / 60
                              : part == 1 ? (i - 60) / 239.0L
                                          : (i - 299) / 60.0L;
        place[i].s = (double)(part == 0   ? route->lo - route->reach[0] * (1 - f)
                              : part == 1 ? route->lo + (route->hi - route->lo) * f
                                          : route->hi + route->reach[1] * f);
        oracle_route_at(route, place[i].s, x, way, &speed);
        for (int k = 0; k < 3; k++) {
            place[i].x[k] = (double)x[k];
            place[i].way[k] = (double)way[k];
        }
    }
    for (int k = 0; k < PAIRS; k++) {
        pair[k].d = INFINITY;
        pair[k].i = pair[k].j = 0;
    }
    for (int i = 0; i < PLACES; i++) {
        for (int j = i + 8; j < PLACES; j++) {
            double d = 0, a = 0, b = 0;
            for (int k = 0; k < 3; k++) {
                const double e = place[i].x[k] - place[j].x[k];
                d += e * e;
                a += e * place[i].way[k];
                b += e * place[j].way[k];
            }
            if (a * a > 0.1 * d || b * b > 0.1 * d || d >= pair[PAIRS - 1].d) {
                continue;
            }
            int k = PAIRS - 1;
            for (; k > 0 && pair[k - 1].d > d; k--) {
                pair[k] = pair[k - 1];
            }
            pair[k].d = d;
            pair[k].i = i;
            pair[k].j = j;
        }
    }
    for (int k = 0; k < PAIRS; k++) {
        if (pair[k].d < INFINITY) {
            best = fminl(
                best, oracle_settle(route, place[pair[k].i].s, route, place[pair[k].j].s, radius));
        }
    }
    return best;
}

double oracle_embedded(const oracle_case *about)
{
    const double radius = radius_of(about);
    oracle_route route;
    oracle_real reach[2] = {0, 0}, largest;

    if (oracle_curve(about->model, "axis") == NULL) {
        return oracle_run_embedded(about);
    }
    if (isnan(radius) || isnan(tube_of(about, reach, 1)) ||
        !oracle_route_of(oracle_curve(about->model, "axis"), &route)) {
        return NAN;
    }
    route.reach[0] = reach[0];
    route.reach[1] = reach[1];
    largest = largest_radius(&route, radius);
    oracle_line_free(&route.line);
    return (double)(radius / largest);
}

double oracle_ends(const oracle_case *about)
{
    const double radius = radius_of(about);
    const taut_record *polygon = taut_record_get(about->problem, "polygon");
    oracle_route route;
    oracle_real worst = 0;

    if (isnan(radius) || about->problem == NULL ||
        !oracle_route_of(oracle_curve(about->model, "axis"), &route)) {
        return NAN;
    }
    for (int e = 0; e < 2; e++) {
        const taut_record *end = taut_record_get(about->problem, e ? "to" : "from");
        double p[3];
        if (oracle_point(polygon != NULL ? taut_record_at(polygon, e ? 3 : 0)
                                         : taut_record_get(end, "point"),
                         p)) {
            for (int k = 0; k < 3; k++) {
                worst = fmaxl(worst, fabsl(p[k] - route.end[e][k]) / radius);
            }
        }
    }
    oracle_line_free(&route.line);
    return (double)worst;
}

/* Type, functions, degree. Ranges and shapes come out of the making, rounded; who moves them moves
 * the surface, which other judges see. */
static int same_basis(const taut_basis *a, const taut_basis *b, int loose)
{
    if (strcmp(taut_basis_type(a), taut_basis_type(b)) != 0) {
        return 0;
    }
    return loose || (taut_basis_count(a) == taut_basis_count(b) &&
                     taut_basis_degree(a) == taut_basis_degree(b));
}

static int names_twice(const taut_model *model)
{
    int twice = 0;

    for (int i = 0; i < taut_model_surface_count(model); i++) {
        const taut_surface *surface = taut_model_surface(model, i);
        twice += oracle_surface(model, taut_surface_name(surface)) != surface;
    }
    for (int i = 0; i < taut_model_curve_count(model); i++) {
        const taut_curve *curve = taut_model_curve(model, i);
        twice += oracle_curve(model, taut_curve_name(curve)) != curve;
    }
    return twice;
}

double oracle_identity(const oracle_case *about)
{
    const int loose = strcmp(about->construct, "pipe") == 0;
    const taut_model *a = about->model, *b = about->honest;
    int differ = names_twice(a);

    if (about->problem == NULL || b == NULL) {
        return differ;
    }
    differ += strcmp(taut_model_unit(a), taut_model_unit(b)) != 0;
    differ += taut_model_surface_count(a) != taut_model_surface_count(b);
    differ += taut_model_curve_count(a) != taut_model_curve_count(b);
    for (int i = 0; i < taut_model_surface_count(b); i++) {
        const taut_surface *own = taut_model_surface(b, i);
        const taut_surface *other = oracle_surface(a, taut_surface_name(own));
        differ += other == NULL || !same_basis(taut_surface_u(own), taut_surface_u(other), loose) ||
                  !same_basis(taut_surface_v(own), taut_surface_v(other), loose);
    }
    for (int i = 0; i < taut_model_curve_count(b); i++) {
        const taut_curve *own = taut_model_curve(b, i);
        const taut_curve *other = oracle_curve(a, taut_curve_name(own));
        differ += other == NULL || !same_basis(taut_curve_t(own), taut_curve_t(other), loose);
    }
    return differ;
}
