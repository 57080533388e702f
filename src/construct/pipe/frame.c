#include "construct/pipe/frame.h"

#include "core/vec3.h"

#include <math.h>
#include <string.h>

enum { SAMPLES = 512, GOLDEN_STEPS = 60 };

static void normalise(double v[3])
{
    const double length = sqrt(taut_dot(v, v));
    for (int k = 0; k < 3 && length > 0; k++) {
        v[k] /= length;
    }
}

void taut_pipe_first_normal(const double tangent[3], double u[3])
{
    int least = 0;
    for (int k = 1; k < 3; k++) {
        least = fabs(tangent[k]) < fabs(tangent[least]) ? k : least;
    }
    for (int k = 0; k < 3; k++) {
        u[k] = (k == least ? 1.0 : 0.0) - tangent[least] * tangent[k];
    }
    normalise(u);
}

/* v - 2 (m . v) m / (m . m) */
static void mirror(const double m[3], double square, double v[3])
{
    taut_add_scaled(-2 * taut_dot(m, v) / square, m, v);
}

int taut_pipe_reflect(const double x0[3], const double t0[3], const double r0[3],
                      const double x1[3], const double t1[3], double r1[3])
{
    double v1[3], v2[3], r[3], t[3];
    double c1 = 0, c2 = 0;

    memcpy(r, r0, sizeof r);
    memcpy(t, t0, sizeof t);
    taut_difference(x1, x0, v1);
    c1 = taut_dot(v1, v1);
    if (!(c1 > 0)) {
        return 0;
    }
    mirror(v1, c1, r);
    mirror(v1, c1, t);
    taut_difference(t1, t, v2);
    c2 = taut_dot(v2, v2);
    if (!(c2 > 0.01)) { /* it is near 4 for short steps */
        return 0;
    }
    mirror(v2, c2, r);
    memcpy(r1, r, sizeof r);
    return 1;
}

/* Are the three points one? At a cusp, in double precision, they can be, and no halves help. */
static int stands(const taut_pipe_jet *a, const taut_pipe_jet *b, const taut_pipe_jet *c)
{
    return memcmp(a->point, b->point, sizeof a->point) == 0 &&
           memcmp(b->point, c->point, sizeof b->point) == 0;
}

/* One step, in halves where it is too long; at the bottom the vector is only made normal. */
static void step(const taut_pipe_arc *arc, const taut_pipe_jet *from, double t0, double t1,
                 int depth, double u[3], taut_pipe_jet *to)
{
    taut_pipe_jet middle;
    taut_pipe_arc_jet(arc, t1, to);
    if (taut_pipe_reflect(from->point, from->tangent, u, to->point, to->tangent, u)) {
        return;
    }
    taut_pipe_arc_jet(arc, 0.5 * (t0 + t1), &middle);
    if (depth > 0 && !stands(from, &middle, to)) {
        step(arc, from, t0, 0.5 * (t0 + t1), depth - 1, u, &middle);
        step(arc, &middle, 0.5 * (t0 + t1), t1, depth - 1, u, to);
        return;
    }
    taut_add_scaled(-taut_dot(u, to->tangent), to->tangent, u);
    normalise(u);
}

void taut_pipe_carry(const taut_pipe_arc *arc, double from, double to, int steps, double u[3])
{
    taut_pipe_jet here, there;
    taut_pipe_arc_jet(arc, from, &here);
    for (int i = 0; i < steps; i++) {
        const double t0 = from + (to - from) * i / steps;
        const double t1 = i + 1 == steps ? to : from + (to - from) * (i + 1) / steps;
        step(arc, &here, t0, t1, 20, u, &there);
        here = there;
    }
}

void taut_pipe_bishop(const taut_pipe_arc *arc, double t, const double u[3],
                      taut_pipe_normals *normals)
{
    taut_pipe_jet jet;
    taut_pipe_arc_jet(arc, t, &jet);
    memcpy(normals->u, u, sizeof normals->u);
    taut_cross(jet.tangent, u, normals->w);
    for (int k = 0; k < 3; k++) {
        normals->du[k] = -taut_dot(normals->u, jet.turn) * jet.tangent[k];
        normals->dw[k] = -taut_dot(normals->w, jet.turn) * jet.tangent[k];
        normals->ddu[k] = -taut_dot(normals->u, jet.bent) * jet.tangent[k] -
                          taut_dot(normals->u, jet.turn) * jet.turn[k];
        normals->ddw[k] = -taut_dot(normals->w, jet.bent) * jet.tangent[k] -
                          taut_dot(normals->w, jet.turn) * jet.turn[k];
    }
}

static double binomial(int n, int k)
{
    double value = 1;
    for (int i = 1; i <= k; i++) {
        value = value * (n - k + i) / i;
    }
    return value;
}

static double size_at(const taut_pipe_binormal *b, double t)
{
    double value[3];
    taut_pipe_bernstein(b->degree, (const double(*)[3])b->k, t, value, NULL);
    return sqrt(taut_dot(value, value));
}

/* The smallest |K|: samples, then golden section beside the smallest of them. */
static void find_least(taut_pipe_binormal *b, double largest)
{
    const double ratio = 0.61803398874989485;
    double lo = 0, hi = 0;
    b->least = INFINITY;
    for (int i = 0; i <= SAMPLES; i++) {
        const double size = size_at(b, (double)i / SAMPLES);
        if (size < b->least) {
            b->least = size;
            b->least_at = (double)i / SAMPLES;
        }
    }
    lo = fmax(0, b->least_at - 1.0 / SAMPLES);
    hi = fmin(1, b->least_at + 1.0 / SAMPLES);
    for (int i = 0; i < GOLDEN_STEPS; i++) {
        const double left = hi - ratio * (hi - lo), right = lo + ratio * (hi - lo);
        *(size_at(b, left) <= size_at(b, right) ? &hi : &lo) =
            size_at(b, left) <= size_at(b, right) ? right : left;
    }
    if (size_at(b, 0.5 * (lo + hi)) < b->least) {
        b->least_at = 0.5 * (lo + hi);
        b->least = size_at(b, b->least_at);
    }
    b->least /= largest;
}

void taut_pipe_binormal_of(const taut_pipe_arc *arc, taut_pipe_binormal *b)
{
    const double zero = 1e-14; /* of the largest: the rounding of the products */
    const int degree = 2 * arc->degree - 4;
    double largest = 0;
    int p = 0, q = 0;

    *b = (taut_pipe_binormal){.degree = 0};
    for (int i = 0; i <= degree; i++) {
        largest = fmax(largest, taut_norm(arc->cross[i]));
    }
    if (!(largest > 0)) {
        return;
    }
    while (taut_norm(arc->cross[p]) <= zero * largest) {
        p++;
    }
    while (taut_norm(arc->cross[degree - q]) <= zero * largest) {
        q++;
    }
    b->degree = degree - p - q;
    largest = 0;
    for (int i = 0; i <= b->degree; i++) {
        const double ratio = binomial(degree, i + p) / binomial(b->degree, i);
        for (int k = 0; k < 3; k++) {
            b->k[i][k] = ratio * arc->cross[i + p][k];
        }
        largest = fmax(largest, taut_norm(b->k[i]));
    }
    find_least(b, largest);
}

/* B = K / |K|, B' = (K' - (B . K') B) / |K|, N = B x T. */
void taut_pipe_frenet(const taut_pipe_arc *arc, const taut_pipe_binormal *binormal, double t,
                      taut_pipe_normals *normals)
{
    taut_pipe_jet jet;
    double k1[3], part[3], size = 0;

    taut_pipe_arc_jet(arc, t, &jet);
    taut_pipe_bernstein(binormal->degree, (const double(*)[3])binormal->k, t, normals->w, k1);
    size = sqrt(taut_dot(normals->w, normals->w));
    for (int k = 0; k < 3; k++) {
        normals->w[k] /= size;
    }
    for (int k = 0; k < 3; k++) {
        normals->dw[k] = (k1[k] - taut_dot(normals->w, k1) * normals->w[k]) / size;
    }
    taut_cross(normals->w, jet.tangent, normals->u);
    taut_cross(normals->dw, jet.tangent, normals->du);
    taut_cross(normals->w, jet.turn, part);
    taut_add_scaled(1, part, normals->du);
}
