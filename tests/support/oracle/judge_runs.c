/* judge_runs.c -- judges of runs of pipes and of what round pipes have besides.
 *
 *     joints       gap over radius and sine between normals around the ring, of each surface and the
 *                  next one in the order of the model; and of the last and the first where it is closed
 *     bend_radius  the radius asked for times the largest curvature seen on the axes
 *     caps         rims against the free ends, and how far all of a cap is from the plane of its end
 */
#include "oracle/oracle.h"

#include <math.h>
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
    const int is_run = oracle_curve(about->model, "axis") == NULL;
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
