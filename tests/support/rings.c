#include "rings.h"

#include "check.h"
#include "geometry/arc.h"

#include <math.h>
#include <string.h>

static taut_basis *spline(int degree, int count)
{
    const taut_basis_spec spec = {.type = "bspline", .degree = degree, .count = count};
    taut_basis *basis = NULL;
    CHECK(taut_basis_new(&spec, count, &basis, NULL) == TAUT_OK, "degree %d", degree);
    return basis;
}

ring ring_new(int p, int n, int q, int m)
{
    ring r = {.u = spline(p, n), .v = spline(q, m)};
    r.problem = (taut_film_problem){.u = r.u, .v = r.v, .ring = TAUT_FILM_RING_U};
    return r;
}

void ring_free(ring *r)
{
    taut_basis_free(r->u);
    taut_basis_free(r->v);
    taut_curve_free(r->rims[0]);
    taut_curve_free(r->rims[1]);
}

void ring_circle(ring *r, int k, double z, double radius)
{
    const double center[3] = {0, 0, z}, normal[3] = {0, 0, 1};
    CHECK(taut_circle_new(center, normal, radius, NULL, &r->rims[k]) == TAUT_OK, "%g", radius);
    r->problem.edges[2 + k] = (taut_film_edge){.kind = TAUT_FILM_FIXED, .curve = r->rims[k]};
}

void ring_cable(ring *r, int k, double z, double force)
{
    r->problem.edges[2 + k] = (taut_film_edge){
        .kind = TAUT_FILM_CABLE, .force = force, .has_plane = 1, .plane = {{0, 0, z}, {0, 0, 1}}};
}

void ring_slide(ring *r, int k, double z)
{
    r->problem.edges[2 + k] =
        (taut_film_edge){.kind = TAUT_FILM_SLIDE, .plane = {{0, 0, z}, {0, 0, 2}}};
}

static void turn_about(double turn[3][3], const double d[3], const double x[3], double y[3])
{
    for (int c = 0; c < 3; c++) {
        y[c] = turn[c][0] * x[0] + turn[c][1] * x[1] + turn[c][2] * x[2] + d[c];
    }
}

void ring_move(ring *r, double turn[3][3], const double d[3])
{
    static const double none[3] = {0, 0, 0};

    for (int k = 0; k < 2; k++) {
        taut_film_edge *edge = &r->problem.edges[2 + k];
        const taut_film_guide plane = edge->plane;
        turn_about(turn, d, plane.point, edge->plane.point);
        turn_about(turn, none, plane.direction, edge->plane.direction);
        if (r->rims[k] != NULL) {
            double points[64][3];
            taut_curve *moved = NULL;
            const taut_basis *t = taut_curve_t(r->rims[k]);
            for (int i = 0; i < taut_basis_count(t); i++) {
                turn_about(turn, d, taut_curve_points(r->rims[k]) + 3 * i, points[i]);
            }
            CHECK(taut_curve_new(NULL, t, points[0], NULL, &moved, NULL) == TAUT_OK, "k %d", k);
            taut_curve_free(r->rims[k]);
            edge->curve = r->rims[k] = moved;
        }
    }
}

/* a cosh(h / 2a) = 1, the larger a: bisection above where the two meet, h / 2a = 1.19967864025773. */
double ring_neck(double h)
{
    double low = 0.5 * h / 1.19967864025773, high = 1;
    for (int k = 0; k < 200; k++) {
        const double a = 0.5 * (low + high);
        *(a * cosh(0.5 * h / a) < 1 ? &low : &high) = a;
    }
    return low;
}

double ring_area(double h)
{
    const double a = ring_neck(h), pi = 3.14159265358979324;
    return pi * a * (h + a * sinh(h / a));
}
