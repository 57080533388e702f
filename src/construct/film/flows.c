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

/* Edges as they run round the film, with the corner each begins in, and whether it runs as its points do. */
static const struct {
    int edge, from, to, is_forward;
} rounds[ROUND] = {{2, 0, 1, 1}, {1, 1, 3, 1}, {3, 3, 2, 0}, {0, 2, 0, 0}};

/* ---- numbers and what they stand for ---- */

static int psi_at(int i, int j)
{
    return (P + 1) * i + j - 1; /* -1: the one that is 0 */
}

static int along_at(int i, int j) /* of B; i = 0: 0 */
{
    return (P + 1) * (P + 1) - 1 + (P + 1) * (i - 1) + j;
}

static int own_at(int i, int j) /* of g; -1 below the own ones: the one that is 0 */
{
    return TAUT_FLOWS_SHARED + (M + 1) * i + j - 1;
}

enum { HEIGHT = TAUT_FLOWS_ROW - 1 };

/* Bernstein polynomials and their first derivatives at an abscissa, of the degrees in use. */
typedef struct line_values {
    double p[2][P + 1], m[2][M + 1]; /* [derivative][] */
} line_values;

/* The same of a place: [s, t]. */
typedef struct basis_values {
    line_values of[2];
} basis_values;

static void find_line(double t, line_values *values)
{
    taut_bernstein_eval(P, 1, t, values->p[0]);
    taut_bernstein_eval(M, 1, t, values->m[0]);
}

static void find_values(double s, double t, basis_values *values)
{
    find_line(s, &values->of[0]);
    find_line(t, &values->of[1]);
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

/* What is added for int (B dt - psi dz) over a piece dt, dz at (s, t). */
static void add_piece(double s, double t, double dt, double dz, double *objective)
{
    basis_values v;

    find_values(s, t, &v);
    for (int i = 0; i <= P; i++) {
        for (int j = 0; j <= P; j++) {
            if (i + j > 0) {
                objective[psi_at(i, j)] -= dz * v.of[0].p[0][i] * v.of[1].p[0][j];
            }
        }
    }
    for (int i = 1; i <= M; i++) {
        for (int j = 0; j <= P; j++) {
            objective[along_at(i, j)] += dt * v.of[0].m[0][i] * v.of[1].p[0][j];
        }
    }
}

static void add_held(const taut_surface *surface, int e, double sign, taut_flows *flows)
{
    const taut_basis *basis = e < 2 ? taut_surface_v(surface) : taut_surface_u(surface);
    const double *breaks = taut_basis_breaks(basis);
    double nodes[NODES], weights[NODES], st[2] = {0.5, 0.5};

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
            add_piece(st[0], st[1], cross2(rs, d) / cross2(rs, rt), d[2], flows->objective);
        }
    }
}

/* -[g + c z] over cable k, from one end to the other. */
static void add_cable(const taut_surface *surface, int from, int to, int k, taut_flows *flows)
{
    double *own = flows->objective + k * TAUT_FLOWS_OWN; /* own_at begins after what is shared */

    for (int end = 0; end < 2; end++) {
        const double sign = end == 0 ? 1 : -1;
        double x[3], st[2] = {0.5, 0.5};
        basis_values v;
        find_point(flows, corner_of(surface, end == 0 ? from : to), x);
        find_parameters(flows, x, st);
        find_values(st[0], st[1], &v);
        for (int i = 0; i <= M; i++) {
            for (int j = 0; j <= M; j++) {
                if (i + j > 0) {
                    own[own_at(i, j)] += sign * v.of[0].m[0][i] * v.of[1].m[0][j];
                }
            }
        }
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
            add_cable(surface, rounds[k].from, rounds[k].to, flows->cables++, flows);
        } else {
            add_held(surface, e, rounds[k].is_forward ? 1 : -1, flows);
        }
    }
    return 1;
}

/* ---- lengths ---- */

/* (B_s, psi_s r_t - psi_t r_s) / J. */
static void map_film(const basis_values *v, const double rs[2], const double rt[2], double j,
                     double *rows)
{
    for (int a = 0; a <= P; a++) {
        for (int b = 0; b <= P; b++) {
            const double in_s = v->of[0].p[1][a] * v->of[1].p[0][b],
                         in_t = v->of[0].p[0][a] * v->of[1].p[1][b];
            for (int c = 0; c < 2 && a + b > 0; c++) {
                rows[(c + 1) * TAUT_FLOWS_ROW + psi_at(a, b)] = (in_s * rt[c] - in_t * rs[c]) / j;
            }
        }
    }
    for (int a = 1; a <= M; a++) {
        for (int b = 0; b <= P; b++) {
            rows[along_at(a, b)] = v->of[0].m[1][a] * v->of[1].p[0][b] / j;
        }
    }
}

/* (g_s r_t - (B + g_t) r_s, J (c - psi)) / (J R). */
static void map_cable(const basis_values *v, const double rs[2], const double rt[2], double j,
                      double radius, double *rows)
{
    for (int a = 0; a <= M; a++) {
        for (int b = 0; b <= M; b++) {
            const double in_s = v->of[0].m[1][a] * v->of[1].m[0][b],
                         in_t = v->of[0].m[0][a] * v->of[1].m[1][b];
            for (int c = 0; c < 2; c++) {
                double *row = rows + c * TAUT_FLOWS_ROW;
                if (a + b > 0) {
                    row[own_at(a, b)] = (in_s * rt[c] - in_t * rs[c]) / (j * radius);
                }
                if (a > 0 && b <= P) {
                    row[along_at(a, b)] =
                        -v->of[0].m[0][a] * v->of[1].p[0][b] * rs[c] / (j * radius);
                }
            }
        }
    }
    for (int a = 0; a <= P; a++) {
        for (int b = 0; b <= P; b++) {
            if (a + b > 0) {
                rows[2 * TAUT_FLOWS_ROW + psi_at(a, b)] =
                    -v->of[0].p[0][a] * v->of[1].p[0][b] / radius;
            }
        }
    }
    rows[2 * TAUT_FLOWS_ROW + HEIGHT] = 1 / radius;
}

void taut_flows_map(const taut_flows *flows, int block, double s, double t, double *rows)
{
    double r[2], rs[2], rt[2];
    basis_values v;

    memset(rows, 0, 3 * TAUT_FLOWS_ROW * sizeof(double));
    find_values(s, t, &v);
    find_place(flows, s, t, r, rs, rt);
    if (block < 0) {
        map_film(&v, rs, rt, cross2(rs, rt), rows);
    } else {
        map_cable(&v, rs, rt, cross2(rs, rt), flows->radii[block], rows);
    }
}

/* ---- lengths over a grid ---- */

double taut_flows_at(int k)
{
    return 0.5 - 0.5 * taut_cos(TAUT_PI * k / (LOOK - 1));
}

/* The coefficients of a block, with those that are 0. */
typedef struct nets {
    double psi[P + 1][P + 1], along[M + 1][P + 1], g[M + 1][M + 1], height;
} nets;

static void unpack(int block, const double *x, nets *n)
{
    memset(n, 0, sizeof *n);
    memcpy(n->psi[0] + 1, x, ((P + 1) * (P + 1) - 1) * sizeof(double));
    memcpy(n->along[1], x + along_at(1, 0), M * (P + 1) * sizeof(double));
    if (block >= 0) {
        const double *own = x + TAUT_FLOWS_SHARED + block * TAUT_FLOWS_OWN;
        memcpy(n->g[0] + 1, own, ((M + 1) * (M + 1) - 1) * sizeof(double));
        n->height = own[TAUT_FLOWS_OWN - 1];
    }
}

/* out[columns] = sum over rows of values[row] net[row][]. */
static void reduce(int rows, int columns, const double *values, const double *net, double *out)
{
    memset(out, 0, (size_t)columns * sizeof(double));
    for (int i = 0; i < rows; i++) {
        for (int j = 0; j < columns; j++) {
            out[j] += values[i] * net[i * columns + j];
        }
    }
}

static double sum_of(int count, const double *values, const double *line)
{
    double sum = 0;
    for (int k = 0; k < count; k++) {
        sum += values[k] * line[k];
    }
    return sum;
}

/* The polynomials of a block on a line of constant s, by t. */
typedef struct lines {
    double psi[2][P + 1], along[2][P + 1], g[2][M + 1]; /* [derivative in s][] */
} lines;

static void find_lines(const nets *n, const line_values *at, lines *l)
{
    for (int d = 0; d < 2; d++) {
        reduce(P + 1, P + 1, at->p[d], n->psi[0], l->psi[d]);
        reduce(M + 1, P + 1, at->m[d], n->along[0], l->along[d]);
        reduce(M + 1, M + 1, at->m[d], n->g[0], l->g[d]);
    }
}

/* The square of the length at a place. */
static double square_at(const taut_flows *flows, int block, const nets *n, const lines *l,
                        const line_values *t, const double rs[2], const double rt[2])
{
    const double j = cross2(rs, rt);
    double in_s = 0, in_t = 0, third = 0;

    if (block < 0) {
        in_s = sum_of(P + 1, t->p[0], l->psi[1]);
        in_t = sum_of(P + 1, t->p[1], l->psi[0]);
        third = sum_of(P + 1, t->p[0], l->along[1]);
    } else {
        in_s = sum_of(M + 1, t->m[0], l->g[1]);
        in_t = sum_of(M + 1, t->m[1], l->g[0]) + sum_of(P + 1, t->p[0], l->along[0]);
        third = j * (n->height - sum_of(P + 1, t->p[0], l->psi[0]));
    }
    const double x = in_s * rt[0] - in_t * rs[0], y = in_s * rt[1] - in_t * rs[1];
    const double limit = block < 0 ? j : j * flows->radii[block];
    return (x * x + y * y + third * third) / (limit * limit);
}

void taut_flows_lengths(const taut_flows *flows, int block, const double *x, double *lengths)
{
    double places[LOOK];
    line_values at[LOOK];
    lines l;
    nets n;

    unpack(block, x, &n);
    for (int k = 0; k < LOOK; k++) {
        places[k] = taut_flows_at(k);
        find_line(places[k], &at[k]);
    }
    for (int a = 0; a < LOOK; a++) {
        find_lines(&n, &at[a], &l);
        for (int b = 0; b < LOOK; b++) {
            double r[2], rs[2], rt[2];
            find_place(flows, places[a], places[b], r, rs, rt);
            lengths[a * LOOK + b] = sqrt(square_at(flows, block, &n, &l, &at[b], rs, rt));
        }
    }
}
