/* judge_runs.c -- judges of runs of pipes and of what round pipes have besides.
 *
 *     joints       gap over radius and sine between normals around the ring, of each surface and the
 *                  next one in the order of the model; and of the last and the first where it is closed
 *     bend_radius  the radius asked for times the largest curvature seen on the axes
 *     tube         each piece around its own axis
 *     embedded     curvature and nearest pairs at right angles, over all axes of the run
 *     caps         rims against the free ends, and how far all of a cap is from the plane of its end
 */
#include "oracle/route.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const taut_record *data_of(const oracle_case *about)
{
    return about->problem != NULL ? about->problem : taut_model_details(about->model);
}

static int is_piece(const taut_surface *surface)
{
    const char *name = taut_surface_name(surface);

    return strncmp(name, "pipe", 4) == 0 || strncmp(name, "blend", 5) == 0;
}

/* Piece i of the run in the order of the model; NULL beyond. */
static const taut_surface *piece(const taut_model *model, int i)
{
    for (int k = 0; k < taut_model_surface_count(model); k++) {
        if (is_piece(taut_model_surface(model, k)) && i-- == 0) {
            return taut_model_surface(model, k);
        }
    }
    return NULL;
}

double oracle_joint_between(const taut_surface *before, const taut_surface *after, double radius)
{
    oracle_sheet a, b;
    oracle_real worst = 0;

    if (isnan(radius) || !oracle_sheet_of(before, &a)) {
        return NAN;
    }
    if (!oracle_sheet_of(after, &b)) {
        oracle_sheet_free(&a);
        return NAN;
    }
    /* what the wider format leaves of coordinates about two middles */
    const oracle_real noise =
        4e-18L * (oracle_norm(a.middle) + oracle_norm(b.middle) + a.size + b.size);
    for (int i = 0; i < 64; i++) {
        const oracle_real s = (i + 0.29L) / 64;
        oracle_real x[6][3], y[6][3], n[2][3], gap[3], cross[3];
        oracle_sheet_eval(&a, a.u.hi, a.v.lo * (1 - s) + a.v.hi * s, 1, x);
        oracle_sheet_eval(&b, b.u.lo, b.v.lo * (1 - s) + b.v.hi * s, 1, y);
        for (int k = 0; k < 3; k++) {
            gap[k] = x[0][k] + a.middle[k] - y[0][k] - b.middle[k];
        }
        oracle_cross(x[1], x[2], n[0]);
        oracle_cross(y[1], y[2], n[1]);
        oracle_cross(n[0], n[1], cross);
        worst = fmaxl(worst, (oracle_norm(gap) - noise) / radius);
        worst = fmaxl(worst, oracle_norm(cross) / (oracle_norm(n[0]) * oracle_norm(n[1])));
    }
    oracle_sheet_free(&a);
    oracle_sheet_free(&b);
    return (double)worst;
}

/* The least distance of the ring at an end of a surface from the next one. */
static oracle_real leg_of(const taut_surface *surface, int last)
{
    const int nu = taut_basis_count(taut_surface_u(surface));
    const int nv = taut_basis_count(taut_surface_v(surface));
    const double *points = taut_surface_points(surface);
    const int row = last ? nu - 1 : 0, next = last ? nu - 2 : 1;
    oracle_real least = INFINITY;

    for (int j = 0; j < nv; j++) {
        oracle_real d[3];
        for (int k = 0; k < 3; k++) {
            d[k] = (oracle_real)points[3 * (row * nv + j) + k] - points[3 * (next * nv + j) + k];
        }
        least = fminl(least, oracle_norm(d));
    }
    return least;
}

static double largest_coordinate(const taut_surface *surface)
{
    const int n =
        3 * taut_basis_count(taut_surface_u(surface)) * taut_basis_count(taut_surface_v(surface));
    double most = 0;

    for (int i = 0; i < n; i++) {
        most = fmax(most, fabs(taut_surface_points(surface)[i]));
    }
    return most;
}

/* The claim is about the joint that is worst against its own limit, and tells the limit of that one.
 * So what is found at another joint counts where it is above all that rounding of coordinates may do
 * there, 32 u over the radius and over the legs that make normals, and 0 below that. */
static double joint_beyond_rounding(const taut_surface *a, const taut_surface *b, double radius)
{
    const double found = oracle_joint_between(a, b, radius);
    const double size = fmax(largest_coordinate(a), largest_coordinate(b));
    const oracle_real leg = fminl(leg_of(a, 1), leg_of(b, 0));

    return found > 0x1p-48 * (double)(1 + size / radius + size / leg) ? found : 0;
}

double oracle_joints(const oracle_case *about)
{
    const double radius = taut_record_number(taut_record_get(data_of(about), "radius"));
    const taut_record *closed = taut_record_get(data_of(about), "closed");
    double worst = 0;
    int i = 1;

    for (; piece(about->model, i) != NULL; i++) {
        worst = fmax(worst, joint_beyond_rounding(piece(about->model, i - 1),
                                                  piece(about->model, i), radius));
    }
    if (taut_record_kind_of(closed) == TAUT_RECORD_BOOL && taut_record_bool(closed)) {
        worst = fmax(worst, joint_beyond_rounding(piece(about->model, i - 1),
                                                  piece(about->model, 0), radius));
    }
    return i > 1 && !isnan(radius) ? worst : NAN;
}

static oracle_real sharpest(const taut_curve *curve)
{
    oracle_line line;
    oracle_real most = 0;

    if (!oracle_line_of(curve, &line)) {
        return 0;
    }
    for (int i = 0; i < 400; i++) {
        const oracle_real s = (i + 0.37L) / 400;
        oracle_real x[3][3], c[3];
        oracle_line_eval(&line, line.t.lo * (1 - s) + line.t.hi * s, x);
        oracle_cross(x[1], x[2], c);
        const oracle_real speed = oracle_norm(x[1]);
        const oracle_real found = oracle_norm(c) / (speed * speed * speed);
        most = found > most ? found : most;
    }
    oracle_line_free(&line);
    return most;
}

double oracle_bend(const oracle_case *about)
{
    const double asked = taut_record_number(taut_record_get(data_of(about), "bend_radius"));
    oracle_real most = 0;

    if (isnan(asked)) {
        return NAN; /* a run of corners has a default, which `details` tells of the model alone */
    }
    for (int i = 0; i < taut_model_curve_count(about->model); i++) {
        const taut_curve *curve = taut_model_curve(about->model, i);
        const char *name = taut_curve_name(curve);
        if (strcmp(name, "axis") == 0 || strncmp(name, "axis-blend", 10) == 0) {
            most = fmaxl(most, sharpest(curve));
        }
    }
    return (double)(asked * most);
}

/* The rim of the cap from the end of the pipe, and all of it from the plane of that end. */
static oracle_real cap_off(const oracle_sheet *cap, const oracle_sheet *end, int side)
{
    const oracle_real rim = side ? cap->u.lo : cap->u.hi, ring = side ? end->u.hi : end->u.lo;
    oracle_real on[3][3], normal[3], ab[2][3], worst = 0;
    const oracle_real noise =
        4e-18L * (oracle_norm(cap->middle) + oracle_norm(end->middle) + cap->size + end->size);

    for (int i = 0; i < 3; i++) {
        oracle_real x[6][3];
        oracle_sheet_eval(end, ring, end->v.lo + ((oracle_real)end->v.hi - end->v.lo) * i / 3, 0,
                          x);
        for (int k = 0; k < 3; k++) {
            on[i][k] = x[0][k] + end->middle[k];
        }
    }
    for (int i = 0; i < 6; i++) {
        ab[i / 3][i % 3] = on[1 + i / 3][i % 3] - on[0][i % 3];
    }
    oracle_cross(ab[0], ab[1], normal);
    const oracle_real length = oracle_norm(normal);
    for (int i = 0; i < 5 * 33; i++) {
        const oracle_real s = (oracle_real)(i % 5) / 4, t = (oracle_real)(i / 5) / 32;
        const oracle_real v = cap->v.lo * (1 - t) + cap->v.hi * t;
        oracle_real x[6][3], y[6][3], d[3];
        oracle_sheet_eval(cap, cap->u.lo * (1 - s) + cap->u.hi * s, v, 0, x);
        for (int k = 0; k < 3; k++) {
            d[k] = x[0][k] + cap->middle[k] - on[0][k];
        }
        worst = fmaxl(worst, fabsl(oracle_dot(d, normal)) / length - 4 * noise);
        oracle_sheet_eval(cap, rim, v, 0, x);
        oracle_sheet_eval(end, ring, end->v.lo * (1 - t) + end->v.hi * t, 0, y);
        for (int k = 0; k < 3; k++) {
            d[k] = x[0][k] + cap->middle[k] - y[0][k] - end->middle[k];
        }
        worst = fmaxl(worst, oracle_norm(d) - noise);
    }
    return worst;
}

double oracle_caps(const oracle_case *about)
{
    const double radius = taut_record_number(taut_record_get(data_of(about), "radius"));
    const int is_run = taut_record_get(about->problem, "run") != NULL || /* whatever was added */
                       oracle_curve(about->model, "axis") == NULL;
    double worst = 0;
    int last = 0;

    while (piece(about->model, last + 1) != NULL) {
        last++;
    }
    for (int side = 0; side < 2; side++) {
        const taut_surface *end = is_run ? piece(about->model, side ? last : 0)
                                         : oracle_surface(about->model, side ? "pipe2" : "pipe1");
        oracle_sheet a, b;
        if (!oracle_sheet_of(oracle_surface(about->model, side ? "cap2" : "cap1"), &a)) {
            return NAN;
        }
        if (!oracle_sheet_of(end, &b)) {
            oracle_sheet_free(&a);
            return NAN;
        }
        worst = fmax(worst, (double)cap_off(&a, &b, side));
        oracle_sheet_free(&a);
        oracle_sheet_free(&b);
    }
    return worst / radius;
}

/* ---- tube and embedded ---- */

/* The radius of a round run; NaN where it is none. */
static double round_radius(const oracle_case *about)
{
    const taut_record *from[2] = {about->problem, taut_model_details(about->model)};

    for (int i = 0; i < 2; i++) {
        if (taut_record_get(from[i], "sections") != NULL ||
            taut_record_get(from[i], "radii") != NULL || taut_record_get(from[i], "wall") != NULL) {
            return NAN;
        }
    }
    return taut_record_number(taut_record_get(data_of(about), "radius"));
}

static const taut_curve *axis_of(const taut_model *model, const taut_surface *surface)
{
    char name[80];

    snprintf(name, sizeof name, "axis-%.60s", taut_surface_name(surface));
    return oracle_curve(model, name);
}

double oracle_run_tube(const oracle_case *about)
{
    const double radius = round_radius(about);
    oracle_real worst = 0;
    int i = 0;

    for (; piece(about->model, i) != NULL && !isnan(radius); i++) {
        oracle_route route;
        oracle_sheet sheet;
        if (!oracle_route_of(axis_of(about->model, piece(about->model, i)), &route)) {
            return NAN;
        }
        if (oracle_sheet_of(piece(about->model, i), &sheet)) {
            worst = fmaxl(worst, oracle_tube_along(&sheet, &route, radius));
            oracle_sheet_free(&sheet);
        }
        oracle_line_free(&route.line);
    }
    return i > 0 ? (double)worst : NAN;
}

enum { PLACES_A_PIECE = 40, PIECES_MOST = 40 };

static void places_of(const oracle_route *route, oracle_place *place)
{
    for (int i = 0; i < PLACES_A_PIECE; i++) {
        oracle_real x[3], way[3], speed;
        place[i].s = (double)(route->lo + (route->hi - route->lo) * (i + 0.5L) / PLACES_A_PIECE);
        oracle_route_at(route, place[i].s, x, way, &speed);
        for (int k = 0; k < 3; k++) {
            place[i].x[k] = (double)x[k];
            place[i].way[k] = (double)way[k];
        }
    }
}

/* Half the distance of the nearest pair at right angles between two pieces of the axis, from those pairs
 * of places that are the nearest for both. */
static oracle_real nearest_pair(const oracle_route *one, const oracle_place *a,
                                const oracle_route *other, const oracle_place *b, double radius)
{
    oracle_real best = INFINITY;

    for (int i = 0; i < PLACES_A_PIECE; i++) {
        double least = INFINITY;
        int at = -1;
        for (int j = one == other ? i + 4 : 0; j < PLACES_A_PIECE; j++) {
            double d = 0, along[2] = {0, 0};
            for (int k = 0; k < 3; k++) {
                const double e = a[i].x[k] - b[j].x[k];
                d += e * e;
                along[0] += e * a[i].way[k];
                along[1] += e * b[j].way[k];
            }
            if (d < least && along[0] * along[0] < 0.1 * d && along[1] * along[1] < 0.1 * d) {
                least = d;
                at = j;
            }
        }
        if (at >= 0 && least < 16 * radius * radius) {
            best = fminl(best, oracle_settle(one, a[i].s, other, b[at].s, radius));
        }
    }
    return best;
}

double oracle_run_embedded(const oracle_case *about)
{
    const double radius = round_radius(about);
    oracle_route *route = calloc(PIECES_MOST, sizeof *route);
    oracle_place *place = calloc((size_t)PIECES_MOST * PLACES_A_PIECE, sizeof *place);
    oracle_real largest = INFINITY;
    int count = 0;

    while (route != NULL && place != NULL && count < PIECES_MOST &&
           piece(about->model, count) != NULL &&
           oracle_route_of(axis_of(about->model, piece(about->model, count)), &route[count])) {
        places_of(&route[count], place + (size_t)count * PLACES_A_PIECE);
        count++;
    }
    const int whole = piece(about->model, count) == NULL && count > 0;
    for (int i = 0; i < count; i++) {
        largest = fminl(largest, oracle_sharpest(&route[i]));
        for (int j = i; j < count; j++) {
            largest =
                fminl(largest, nearest_pair(&route[i], place + (size_t)i * PLACES_A_PIECE,
                                            &route[j], place + (size_t)j * PLACES_A_PIECE, radius));
        }
    }
    for (int i = 0; i < count; i++) {
        oracle_line_free(&route[i].line);
    }
    free(route);
    free(place);
    return whole && !isnan(radius) ? (double)(radius / largest) : NAN;
}
