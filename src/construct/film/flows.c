#include "construct/film/flows.h"

#include "core/constants.h"
#include "core/elementary/elementary.h"
#include "core/vec3.h"
#include "geometry/exponent.h"
#include "numeric/bernstein.h"
#include "numeric/quadrature.h"

#include <math.h>
#include <string.h>

enum {
    P = TAUT_FLOWS_PSI,
    M = TAUT_FLOWS_ALONG,
    LOOK = TAUT_FLOWS_LOOK,
    NODES = 12, /* of Gauss, a span */
    NEWTON = 30,
    ROUND = 4
};
static const double wider = 0x1p-30; /* of its size: what Q reaches beyond what it is to hold */
static const double straight = 1e-9; /* sines below are no corner */

/* Edges as they run round the film, with the corners that each runs between, and whether it runs as its points do. */
static const struct {
    int edge, ends[2], is_forward;
} rounds[ROUND] = {{2, {0, 1}, 1}, {1, {1, 3}, 1}, {3, {3, 2}, 0}, {0, {2, 0}, 0}};

/* ---- numbers and what they stand for ---- */

/* The coefficients of a polynomial among the numbers, by rows; the first of them are 0 and no numbers. */
typedef struct net {
    int first, rows, columns, zeros;
} net;

static const net psi_net = {0, P + 1, P + 1, 1},
                 along_net = {(P + 1) * (P + 1) - 1, M + 1, P + 1, P + 1},
                 own_net = {TAUT_FLOWS_SHARED, M + 1, M + 1, 1};

enum { HEIGHT = TAUT_FLOWS_ROW - 1 };

/* Bernstein polynomials at an abscissa: [degree P, M][derivative][]. */
typedef struct line_values {
    double of[2][2][M + 1];
} line_values;

static void find_line(double t, line_values *values)
{
    double found[2 * (M + 1)];

    for (int degree = P; degree <= M; degree++) {
        taut_bernstein_eval(degree, 1, t, found);
        memcpy(values->of[degree - P][0], found, (size_t)(degree + 1) * sizeof(double));
        memcpy(values->of[degree - P][1], found + degree + 1,
               (size_t)(degree + 1) * sizeof(double));
    }
}

static const double *values_of(const line_values *values, int count, int derivative)
{
    return values->of[count - 1 - P][derivative];
}

/* Adds factor times what each number of a net is multiplied with, in a derivative at (s, t). */
static void add_net(const net *n, const line_values st[2], int in_s, int in_t, double factor,
                    double *row)
{
    const double *s = values_of(&st[0], n->rows, in_s), *t = values_of(&st[1], n->columns, in_t);

    for (int k = n->zeros; k < n->rows * n->columns; k++) {
        row[n->first + k - n->zeros] += factor * s[k / n->columns] * t[k % n->columns];
    }
}

/* ---- the quadrilateral ---- */

/* r, r_s, r_t of its bilinear parameters. */
static void find_place(const taut_flows *flows, double s, double t, double r[2], double rs[2],
                       double rt[2])
{
    for (int c = 0; c < 2; c++) {
        const double a = flows->corners[0][c], b = flows->corners[1][c], d = flows->corners[2][c],
                     e = flows->corners[3][c];
        rs[c] = (1 - t) * (b - a) + t * (d - e);
        rt[c] = (1 - s) * (e - a) + s * (d - b);
        r[c] = (1 - s) * ((1 - t) * a + t * e) + s * ((1 - t) * b + t * d);
    }
}

static double cross2(const double a[2], const double b[2])
{
    return a[0] * b[1] - a[1] * b[0];
}

/* (s, t) of a place of it, by Newton's steps from where it is given. */
static void find_parameters(const taut_flows *flows, const double at[2], double st[2])
{
    for (int k = 0; k < NEWTON; k++) {
        double r[2], rs[2], rt[2];
        find_place(flows, st[0], st[1], r, rs, rt);
        const double off[2] = {at[0] - r[0], at[1] - r[1]}, j = cross2(rs, rt);
        const double ds = cross2(off, rt) / j, dt = cross2(rs, off) / j;
        st[0] = fmin(fmax(st[0] + ds, 0), 1);
        st[1] = fmin(fmax(st[1] + dt, 0), 1);
        if (fabs(ds) + fabs(dt) < 1e-15) {
            return;
        }
    }
}

/* A point of the net, scaled, in the frame. */
static void find_point(const taut_flows *flows, const double *point, double out[3])
{
    double from[3];

    for (int c = 0; c < 3; c++) {
        from[c] = ldexp(point[c] - flows->origin[c], -flows->exponent);
    }
    for (int c = 0; c < 3; c++) {
        out[c] = taut_dot(flows->frame[c], from);
    }
}

/* Points of edge e: the first, from one to the next, how many. */
static const double *edge_points(const taut_surface *surface, int e, size_t *step, int *count)
{
    const int nu = taut_basis_count(taut_surface_u(surface)),
              nv = taut_basis_count(taut_surface_v(surface));
    const size_t first = e == 1 ? (size_t)(nu - 1) * (size_t)nv : e == 3 ? (size_t)nv - 1 : 0;

    *step = e < 2 ? 1 : (size_t)nv;
    *count = e < 2 ? nv : nu;
    return taut_surface_points(surface) + 3 * first;
}

static const double *corner_of(const taut_surface *surface, int c)
{
    size_t step = 0;
    int count = 0;
    const double *points = edge_points(surface, c % 2 == 0 ? 0 : 1, &step, &count);
    return points + (c / 2 == 0 ? 0 : 3 * step * (size_t)(count - 1));
}

/* Goes over what is held: corners, and all points of held edges, in the frame. see(context, x). */
static void each_held(const taut_surface *surface, const double radii[4], const taut_flows *flows,
                      void (*see)(void *context, const double x[3]), void *context)
{
    double x[3];

    for (int k = 0; k < ROUND; k++) {
        const int e = rounds[k].edge;
        size_t step = 0;
        int count = 0;
        const double *points = edge_points(surface, e, &step, &count);
        const int stride = radii[e] > 0 ? count - 1 : 1;
        for (int i = 0; i < count; i += stride) {
            find_point(flows, points + 3 * step * (size_t)i, x);
            see(context, x);
        }
    }
}

/* Twice the vector area of the boundary, cables by their chords. */
static void find_normal(const taut_surface *surface, const double radii[4], double normal[3])
{
    const double *origin = corner_of(surface, 0);

    memset(normal, 0, 3 * sizeof(double));
    for (int k = 0; k < ROUND; k++) {
        const int e = rounds[k].edge;
        size_t step = 0;
        int count = 0;
        const double *points = edge_points(surface, e, &step, &count);
        const int stride = radii[e] > 0 ? count - 1 : 1;
        for (int i = 0; i + stride < count; i += stride) {
            double a[3], b[3], part[3];
            taut_difference(points + 3 * step * (size_t)i, origin, a);
            taut_difference(points + 3 * step * (size_t)(i + stride), origin, b);
            taut_cross(a, b, part);
            taut_add_scaled(rounds[k].is_forward ? 1 : -1, part, normal);
        }
    }
}

/* z along the vector area, x along what leads from u0 to u1. */
static int make_frame(const taut_surface *surface, const double radii[4], taut_flows *flows)
{
    double x[3] = {0, 0, 0}, z[3];

    find_normal(surface, radii, z);
    const double size = taut_norm(z);
    for (int c = 0; c < 4; c++) {
        taut_add_scaled(c % 2 == 0 ? -1 : 1, corner_of(surface, c), x);
    }
    for (int c = 0; c < 3; c++) {
        z[c] /= size;
    }
    taut_add_scaled(-taut_dot(x, z), z, x);
    const double across = taut_norm(x);
    for (int c = 0; c < 3; c++) {
        flows->frame[2][c] = z[c];
        flows->frame[0][c] = x[c] / across;
    }
    taut_cross(flows->frame[2], flows->frame[0], flows->frame[1]);
    return isfinite(flows->frame[1][0]) && across > straight * ldexp(1, flows->exponent);
}

typedef struct box {
    const taut_flows *flows;
    double least[2], most[2];
    int is_within; /* of the corners of flows, so far */
} box;

static void extend_box(void *context, const double x[3])
{
    box *b = context;
    for (int c = 0; c < 2; c++) {
        b->least[c] = fmin(b->least[c], x[c]);
        b->most[c] = fmax(b->most[c], x[c]);
    }
}

static void see_within(void *context, const double x[3])
{
    box *b = context;
    for (int k = 0; k < ROUND; k++) {
        const double *a = b->flows->corners[k], *next = b->flows->corners[(k + 1) % ROUND];
        const double side[2] = {next[0] - a[0], next[1] - a[1]}, to[2] = {x[0] - a[0], x[1] - a[1]};
        b->is_within = b->is_within && cross2(side, to) > 0;
    }
}

/* The corners' quadrilateral, a little wider, where it is convex and holds all. */
static int lay_corners(const taut_surface *surface, const double radii[4], taut_flows *flows)
{
    static const int round[ROUND] = {0, 1, 3, 2};
    double middle[2] = {0, 0};
    box b = {.flows = flows, .is_within = 1};

    for (int k = 0; k < ROUND; k++) {
        double x[3];
        find_point(flows, corner_of(surface, round[k]), x);
        memcpy(flows->corners[k], x, 2 * sizeof(double));
        middle[0] += 0.25 * x[0];
        middle[1] += 0.25 * x[1];
    }
    for (int k = 0; k < ROUND; k++) {
        for (int c = 0; c < 2; c++) {
            flows->corners[k][c] += wider * (flows->corners[k][c] - middle[c]);
        }
    }
    for (int k = 0; k < ROUND; k++) {
        const double *a = flows->corners[k], *at = flows->corners[(k + 1) % ROUND],
                     *next = flows->corners[(k + 2) % ROUND];
        const double in[2] = {at[0] - a[0], at[1] - a[1]},
                     out[2] = {next[0] - at[0], next[1] - at[1]};
        const double size =
            sqrt((in[0] * in[0] + in[1] * in[1]) * (out[0] * out[0] + out[1] * out[1]));
        if (!(cross2(in, out) > straight * size)) {
            return 0;
        }
    }
    each_held(surface, radii, flows, see_within, &b);
    return b.is_within;
}

/* A rectangle around all. */
static void lay_box(const taut_surface *surface, const double radii[4], taut_flows *flows)
{
    box b = {.least = {INFINITY, INFINITY}, .most = {-INFINITY, -INFINITY}};

    each_held(surface, radii, flows, extend_box, &b);
    const double more = wider * (b.most[0] - b.least[0] + b.most[1] - b.least[1]);
    for (int k = 0; k < ROUND; k++) {
        flows->corners[k][0] = k == 0 || k == 3 ? b.least[0] - more : b.most[0] + more;
        flows->corners[k][1] = k < 2 ? b.least[1] - more : b.most[1] + more;
    }
}

/* ---- what is to be as large as it gets ---- */

/* int (B dt - psi dz) along edge e. */
static void add_held(const taut_surface *surface, int e, double sign, taut_flows *flows)
{
    const taut_basis *basis = e < 2 ? taut_surface_v(surface) : taut_surface_u(surface);
    const double *breaks = taut_basis_breaks(basis);
    double nodes[NODES], weights[NODES], st[2] = {0.5, 0.5};
    line_values v[2];

    taut_gauss_rule(NODES, nodes, weights);
    for (int k = 0; k < taut_basis_span_count(basis); k++) {
        const double half = 0.5 * (breaks[k + 1] - breaks[k]);
        for (int n = 0; n < NODES; n++) {
            const double at = breaks[k] + half * (1 + nodes[n]);
            const double along =
                e == 0 || e == 2
                    ? taut_basis_lo(e == 0 ? taut_surface_u(surface) : taut_surface_v(surface))
                    : taut_basis_hi(e == 1 ? taut_surface_u(surface) : taut_surface_v(surface));
            double values[TAUT_SURFACE_VECTORS(1)][3], x[3], d[3], r[2], rs[2], rt[2];
            (void)taut_surface_eval(surface, e < 2 ? along : at, e < 2 ? at : along, 1, values[0]);
            find_point(flows, values[0], x);
            const double *slope = values[e < 2 ? TAUT_XV : TAUT_XU];
            for (int c = 0; c < 3; c++) {
                d[c] = ldexp(taut_dot(flows->frame[c], slope), -flows->exponent) * sign * half *
                       weights[n];
            }
            find_parameters(flows, x, st);
            find_place(flows, st[0], st[1], r, rs, rt);
            find_line(st[0], &v[0]);
            find_line(st[1], &v[1]);
            add_net(&psi_net, v, 0, 0, -d[2], flows->objective);
            add_net(&along_net, v, 0, 0, cross2(rs, d) / cross2(rs, rt), flows->objective);
        }
    }
}

/* -[g + c z] over cable k, from one end to the other. */
static void add_cable(const taut_surface *surface, const int ends[2], int k, taut_flows *flows)
{
    double *own = flows->objective + k * TAUT_FLOWS_OWN; /* its net begins after what is shared */

    for (int end = 0; end < 2; end++) {
        const double sign = end == 0 ? 1 : -1;
        double x[3], st[2] = {0.5, 0.5};
        line_values v[2];
        find_point(flows, corner_of(surface, ends[end]), x);
        find_parameters(flows, x, st);
        find_line(st[0], &v[0]);
        find_line(st[1], &v[1]);
        add_net(&own_net, v, 0, 0, sign, own);
        own[HEIGHT] += sign * x[2];
    }
}

int taut_flows_new(const taut_surface *surface, const double radii[4], taut_flows *flows)
{
    const double *points = taut_surface_points(surface);

    memset(flows, 0, sizeof *flows);
    memcpy(flows->origin, points, sizeof flows->origin);
    flows->exponent = taut_exponent(2 * taut_half_size(taut_point_count(surface), points));
    if (!make_frame(surface, radii, flows)) {
        return 0;
    }
    if (!lay_corners(surface, radii, flows)) {
        lay_box(surface, radii, flows);
    }
    for (int k = 0; k < ROUND; k++) {
        const int e = rounds[k].edge;
        if (radii[e] > 0) {
            flows->edges[flows->cables] = e;
            flows->radii[flows->cables] = ldexp(radii[e], -flows->exponent);
            add_cable(surface, rounds[k].ends, flows->cables++, flows);
        } else {
            add_held(surface, e, rounds[k].is_forward ? 1 : -1, flows);
        }
    }
    return 1;
}

/* ---- lengths ---- */

void taut_flows_map(const taut_flows *flows, int block, double s, double t, double *rows)
{
    const net *n = block < 0 ? &psi_net : &own_net;
    const double radius = block < 0 ? 1 : flows->radii[block];
    double r[2], rs[2], rt[2], *third = rows + 2 * TAUT_FLOWS_ROW;
    line_values v[2];

    memset(rows, 0, 3 * TAUT_FLOWS_ROW * sizeof(double));
    find_line(s, &v[0]);
    find_line(t, &v[1]);
    find_place(flows, s, t, r, rs, rt);
    const double limit = cross2(rs, rt) * radius;
    for (int c = 0; c < 2; c++) {
        double *row = rows + c * TAUT_FLOWS_ROW;
        add_net(n, v, 1, 0, rt[c] / limit, row);
        add_net(n, v, 0, 1, -rs[c] / limit, row);
        if (block >= 0) {
            add_net(&along_net, v, 0, 0, -rs[c] / limit, row);
        }
    }
    if (block < 0) {
        add_net(&along_net, v, 1, 0, 1 / limit, third);
    } else {
        add_net(&psi_net, v, 0, 0, -1 / radius, third);
        third[HEIGHT] = 1 / radius;
    }
}

/* ---- lengths over a grid ---- */

double taut_flows_at(int k)
{
    return 0.5 - 0.5 * taut_cos(TAUT_PI * k / (LOOK - 1));
}

/* A polynomial on a line of constant s, by t: its value and its derivative in s. */
typedef struct line {
    double of[2][M + 1];
} line;

/* x: the numbers, those of the net at first. */
static void find_on_line(const net *n, const double *x, const line_values *at, line *l)
{
    for (int d = 0; d < 2; d++) {
        const double *values = values_of(at, n->rows, d);
        memset(l->of[d], 0, sizeof l->of[d]);
        for (int k = n->zeros; k < n->rows * n->columns; k++) {
            l->of[d][k % n->columns] += values[k / n->columns] * x[n->first + k - n->zeros];
        }
    }
}

static double value_on(const line *l, const net *n, const line_values *t, int in_s, int in_t)
{
    const double *values = values_of(t, n->columns, in_t);
    double sum = 0;

    for (int k = 0; k < n->columns; k++) {
        sum += values[k] * l->of[in_s][k];
    }
    return sum;
}

void taut_flows_lengths(const taut_flows *flows, int block, const double *x, double *lengths)
{
    const net *n = block < 0 ? &psi_net : &own_net;
    const double *own = x + (block < 0 ? 0 : block * TAUT_FLOWS_OWN);
    const double radius = block < 0 ? 1 : flows->radii[block];
    double places[LOOK];
    line_values at[LOOK];
    line main, along, psi;

    for (int k = 0; k < LOOK; k++) {
        places[k] = taut_flows_at(k);
        find_line(places[k], &at[k]);
    }
    for (int k = 0; k < LOOK * LOOK; k++) {
        const line_values *t = &at[k % LOOK];
        double r[2], rs[2], rt[2];
        if (k % LOOK == 0) {
            find_on_line(n, own, &at[k / LOOK], &main);
            find_on_line(&along_net, x, &at[k / LOOK], &along);
            find_on_line(&psi_net, x, &at[k / LOOK], &psi);
        }
        find_place(flows, places[k / LOOK], places[k % LOOK], r, rs, rt);
        const double j = cross2(rs, rt), in_s = value_on(&main, n, t, 1, 0),
                     in_t = value_on(&main, n, t, 0, 1) +
                            (block < 0 ? 0 : value_on(&along, &along_net, t, 0, 0));
        const double up = block < 0 ? value_on(&along, &along_net, t, 1, 0)
                                    : j * (own[HEIGHT] - value_on(&psi, &psi_net, t, 0, 0));
        const double out[3] = {in_s * rt[0] - in_t * rs[0], in_s * rt[1] - in_t * rs[1], up};
        lengths[k] = taut_length(out) / (j * radius);
    }
}
