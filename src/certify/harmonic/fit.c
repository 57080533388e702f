/* fit.c -- is this the harmonic surface nearest to four boundary rows? Among a linear
 * space of surfaces the nearest is the one whose distance to the rows is orthogonal to the space,
 * on the boundary: here to the powers of z themselves, Re and Im of ((z - z0) / rho)^k, one after
 * the other ([NiWang2015] sections 2.3, 8.3). */
#include "certify/common/verdict.h"
#include "certify/harmonic/claims.h"
#include "core/constants.h"
#include "core/elementary/elementary.h"
#include "numeric/quadrature.h"
#include "taut/limits.h"

#include <math.h>
#include <stdio.h>

enum {
    SAMPLES = 257,
    POINT_WORK =
        9 /* operations by the square of the degree, of two points in space, as pulses count them */
};

/* The surface, its rows as they were given, and the half sides of its rectangle over the larger. */
typedef struct fit {
    const taut_surface *surface;
    const taut_harmonic_problem *problem;
    int n, m;
    double half[2];
} fit;

/* Point on side 0..3 (u0, u1, v0, v1) of a net at share t, by de Casteljau's triangle: shares have
 * their digits wherever the range lies. */
static void side_at(const fit *f, const double *points, int side, double t, double x[3])
{
    const int d = side < 2 ? f->m : f->n, columns = f->m + 1;
    const int first = side == 1 ? f->n * columns : side == 3 ? f->m : 0;
    const int stride = side < 2 ? 1 : columns;
    double line[TAUT_DEGREE_MAX + 1];

    for (int c = 0; c < 3; c++) {
        for (int i = 0; i <= d; i++) {
            line[i] = points[3 * (first + i * stride) + c];
        }
        for (int k = d; k > 0; k--) {
            for (int i = 0; i < k; i++) {
                line[i] = (1 - t) * line[i] + t * line[i + 1];
            }
        }
        x[c] = line[0];
    }
}

/* The surface there less the rows. */
static void apart_at(const fit *f, int side, double t, double d[3])
{
    double x[3];

    side_at(f, f->problem->boundary.points, side, t, d);
    side_at(f, taut_surface_points(f->surface), side, t, x);
    for (int c = 0; c < 3; c++) {
        d[c] = x[c] - d[c];
    }
}

/* Sums over the boundary of distance times function, and of the function squared. */
typedef struct product {
    double with[3], squared;
} product;

static void add_node(product *p, double weight, double h, const double d[3])
{
    for (int c = 0; c < 3; c++) {
        p->with[c] += weight * h * d[c];
    }
    p->squared += weight * h * h;
}

static double share(const product *p)
{
    const double most = fmax(fabs(p->with[0]), fmax(fabs(p->with[1]), fabs(p->with[2])));
    return p->squared > 0 ? most / sqrt(p->squared) : 0;
}

/* (x + i y)^k by multiplying k times: in a thin rectangle one of the parts is small beside the other, and
 * keeps its digits, which the sine of an angle near a multiple of pi does not. */
static void raise_power(double x, double y, int k, double *re, double *im)
{
    double a = 1, b = 0;
    for (int i = 0; i < k; i++) {
        const double c = a * x - b * y;
        b = a * y + b * x;
        a = c;
    }
    *re = a;
    *im = b;
}

/* The largest of the products with Re and Im of the k-th power, of those that the bidegree has: the
 * pure power of u is in Re, that of v in the one where i^k is. */
static double power_product(const fit *f, int k, int nodes, const double *t, const double *w)
{
    const int real = k <= f->n && (k <= f->m || k % 2 != 0);
    const int imaginary = k > 0 && (k <= f->m || k % 2 == 0);
    const double diagonal = taut_hypot(f->half[0], f->half[1]);
    product re = {{0, 0, 0}, 0}, im = {{0, 0, 0}, 0};

    for (int side = 0; side < 4; side++) {
        for (int s = 0; s < nodes; s++) {
            const double end = side % 2 == 0 ? -1 : 1;
            const double x = f->half[0] / diagonal * (side < 2 ? end : t[s]);
            const double y = f->half[1] / diagonal * (side < 2 ? t[s] : end);
            double d[3], real_part = 0, imaginary_part = 0;
            raise_power(x, y, k, &real_part, &imaginary_part);
            apart_at(f, side, 0.5 + 0.5 * t[s], d);
            add_node(&re, w[s], real_part, d);
            add_node(&im, w[s], imaginary_part, d);
        }
    }
    return fmax(real ? share(&re) : 0, imaginary ? share(&im) : 0);
}

/* Half the largest extent of the four rows, and their largest coordinate. */
static double size_of_rows(const fit *f, double *reach)
{
    double size = 0;
    *reach = 0;
    for (int c = 0; c < 3; c++) {
        double low = INFINITY, high = -INFINITY;
        for (int k = 0; k < (f->n + 1) * (f->m + 1); k++) {
            if (f->problem->boundary.known[k]) {
                low = fmin(low, f->problem->boundary.points[3 * k + c]);
                high = fmax(high, f->problem->boundary.points[3 * k + c]);
            }
        }
        size = fmax(size, 0.5 * high - 0.5 * low);
        *reach = fmax(*reach, fmax(fabs(low), fabs(high)));
    }
    return size > 0 ? size : 1;
}

void taut_harmonic_fit_gap(const taut_surface *surface, const taut_harmonic_problem *problem,
                           double *gap, double at[2])
{
    const fit f = {surface,
                   problem,
                   taut_basis_degree(taut_surface_u(surface)),
                   taut_basis_degree(taut_surface_v(surface)),
                   {0, 0}};
    const taut_basis *basis[2] = {taut_surface_u(surface), taut_surface_v(surface)};

    *gap = -1;
    for (int side = 0; side < 4; side++) {
        for (int s = 0; s < SAMPLES; s++) {
            const double t = s / (SAMPLES - 1.0);
            double d[3];
            apart_at(&f, side, t, d);
            const double apart = taut_hypot(taut_hypot(d[0], d[1]), d[2]);
            if (apart > *gap) {
                const int along = side < 2 ? 1 : 0;
                *gap = apart;
                at[along] = taut_basis_lo(basis[along]) +
                            t * (taut_basis_hi(basis[along]) - taut_basis_lo(basis[along]));
                at[1 - along] = side % 2 == 0 ? taut_basis_lo(basis[1 - along])
                                              : taut_basis_hi(basis[1 - along]);
            }
        }
    }
}

taut_status taut_harmonic_add_nearest(const taut_surface *surface,
                                      const taut_harmonic_problem *problem, const taut_crew *crew,
                                      taut_certificate *certificate)
{
    const taut_basis *u = taut_surface_u(surface), *v = taut_surface_v(surface);
    fit f = {surface, problem, taut_basis_degree(u), taut_basis_degree(v), {0, 0}};
    const double sides[2] = {taut_basis_hi(u) - taut_basis_lo(u),
                             taut_basis_hi(v) - taut_basis_lo(v)};
    const int least = f.n < f.m ? f.n : f.m, nodes = (f.n > f.m ? f.n : f.m) + 2;
    double t[TAUT_GAUSS_MAX], w[TAUT_GAUSS_MAX], most = 0, reach = 0;
    const double size = size_of_rows(&f, &reach);
    int worst = 0;
    char where[64];

    f.half[0] = sides[0] / fmax(sides[0], sides[1]);
    f.half[1] = sides[1] / fmax(sides[0], sides[1]);
    taut_gauss_rule(nodes, t, w);
    for (int k = 0; k <= least + 1; k++) {
        if (taut_crew_beat(crew, 4 * nodes * POINT_WORK * (double)nodes * nodes)) {
            return TAUT_INTERRUPTED;
        }
        const double found = power_product(&f, k, nodes, t, w) / size;
        worst = found > most ? k : worst;
        most = taut_certify_max(most, found);
    }
    for (int k = 0; k < 3 * (f.n + 1) * (f.m + 1); k++) {
        reach = fmax(reach, fabs(taut_surface_points(surface)[k]));
    }
    const double limit = 8 * (f.n + f.m) * TAUT_UNIT_ROUNDOFF * fmax(1, reach / size);
    snprintf(where, sizeof where, "against the power %d of z", worst);
    return taut_harmonic_add_claim("nearest", TAUT_EXACT, most, limit, where, certificate);
}
