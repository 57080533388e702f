#include "construct/pipe/arc.h"

#include "core/vec3.h"
#include "numeric/bernstein.h"

#include <assert.h>
#include <string.h>

/* With P' = u p + t q, p and q the polynomials of its first and of its last n - 1 coefficients,
 * P'' = (n-1)(q - p) and so P' x P'' = (n-1) p x q: a product of Bernstein polynomials. */
void taut_pipe_arc_finish(taut_pipe_arc *arc)
{
    const int n = arc->degree, m = n - 2;

    assert(n >= 2 && n <= TAUT_PIPE_DEGREE_MAX);
    taut_bernstein_derivative(n, 3, &arc->points[0][0], &arc->velocity[0][0]);
    memset(arc->cross, 0, sizeof arc->cross);
    for (int i = 0; i <= m; i++) {
        for (int j = 0; j <= m; j++) {
            double product[3];
            taut_cross(arc->velocity[i], arc->velocity[j + 1], product);
            taut_add_scaled((n - 1) * taut_binomial(m, i) * taut_binomial(m, j) /
                                taut_binomial(2 * m, i + j),
                            product, arc->cross[i + j]);
        }
    }
}

/* out = the sum of three vectors, v double[3][3], times numbers, over d. */
static void combine_vectors(const double *v, double a, double b, double c, double d, double out[3])
{
    for (int k = 0; k < 3; k++) {
        out[k] = (a * v[k] + b * v[3 + k] + c * v[6 + k]) / d;
    }
}

void taut_pipe_arc_quasi(const double edges[3][3], const double shape[3], taut_pipe_arc *arc)
{
    const double A = 3 + shape[0], B = 3 * (1 - shape[0]), C = 3 - shape[1], D = 3 + shape[1],
                 E = 3 * (1 - shape[2]), F = 3 + shape[2];
    double products[3][3]; /* e1 x e2, e1 x e3, e2 x e3 */

    arc->degree = 4;
    taut_cross(edges[0], edges[1], products[0]);
    taut_cross(edges[0], edges[2], products[1]);
    taut_cross(edges[1], edges[2], products[2]);
    combine_vectors(edges[0], 0, 0, 0, 1, arc->points[0]);
    combine_vectors(edges[0], A, 0, 0, 4, arc->points[1]);
    combine_vectors(edges[0], 6, C, 0, 6, arc->points[2]);
    combine_vectors(edges[0], 4, 4, 1 - shape[2], 4, arc->points[3]);
    combine_vectors(edges[0], 1, 1, 1, 1, arc->points[4]);
    /* f1 = u^2 (Au + Bt), f2 = 2ut (Cu + Dt), f3 = t^2 (Eu + Ft) as cubics */
    combine_vectors(edges[0], A, 0, 0, 1, arc->velocity[0]);
    combine_vectors(edges[0], B, 2 * C, 0, 3, arc->velocity[1]);
    combine_vectors(edges[0], 0, 2 * D, E, 3, arc->velocity[2]);
    combine_vectors(edges[0], 0, 0, F, 1, arc->velocity[3]);
    combine_vectors(products[0], 2 * A * C, 0, 0, 1, arc->cross[0]);
    combine_vectors(products[0], 4 * A * D, 2 * A * E, 0, 4, arc->cross[1]);
    combine_vectors(products[0], 2 * B * D, 3 * A * F + B * E, 2 * C * E, 6, arc->cross[2]);
    combine_vectors(products[0], 0, 2 * B * F, 4 * C * F, 4, arc->cross[3]);
    combine_vectors(products[0], 0, 0, 2 * D * F, 1, arc->cross[4]);
}

void taut_pipe_arc_quintic(const double edges[3][3], const double shape[3], taut_pipe_arc *arc)
{
    const double first = (3 + shape[0]) / 4, last = (3 + shape[2]) / 4;
    /* P' by the edges, and the points */
    const double legs[5][3] = {{5 * first, 0, 0},
                               {5 * (1 - first), 0, 0},
                               {0, 5, 0},
                               {0, 0, 5 * (1 - last)},
                               {0, 0, 5 * last}};
    const double places[6][3] = {{0, 0, 0}, {first, 0, 0},    {1, 0, 0},
                                 {1, 1, 0}, {1, 1, 1 - last}, {1, 1, 1}};
    double products[3][3]; /* e1 x e2, e1 x e3, e2 x e3 */

    arc->degree = 5;
    taut_cross(edges[0], edges[1], products[0]);
    taut_cross(edges[0], edges[2], products[1]);
    taut_cross(edges[1], edges[2], products[2]);
    for (int i = 0; i <= 5; i++) {
        combine_vectors(edges[0], places[i][0], places[i][1], places[i][2], 1, arc->points[i]);
    }
    memset(arc->cross, 0, sizeof arc->cross);
    for (int i = 0; i < 5; i++) {
        combine_vectors(edges[0], legs[i][0], legs[i][1], legs[i][2], 1, arc->velocity[i]);
    }
    for (int i = 0; i < 4; i++) {
        for (int j = 0; j < 4; j++) {
            const double *a = legs[i], *b = legs[j + 1];
            const double weight =
                4 * taut_binomial(3, i) * taut_binomial(3, j) / taut_binomial(6, i + j);
            double product[3];
            combine_vectors(products[0], a[0] * b[1] - a[1] * b[0], a[0] * b[2] - a[2] * b[0],
                            a[1] * b[2] - a[2] * b[1], 1, product);
            taut_add_scaled(weight, product, arc->cross[i + j]);
        }
    }
}

void taut_pipe_arc_point(const taut_pipe_arc *arc, double t, double point[3])
{
    taut_bernstein_point(arc->degree, 3, &arc->points[0][0], t, point, NULL);
}

void taut_pipe_arc_jet(const taut_pipe_arc *arc, double t, taut_pipe_jet *jet)
{
    double cross1[3], more[3];

    taut_bernstein_point(arc->degree, 3, &arc->points[0][0], t, jet->point, NULL);
    taut_bernstein_point(arc->degree - 1, 3, &arc->velocity[0][0], t, jet->d1, jet->d2);
    taut_bernstein_point(2 * arc->degree - 4, 3, &arc->cross[0][0], t, jet->cross, cross1);
    jet->speed = taut_length(jet->d1);
    memset(jet->tangent, 0, sizeof jet->tangent);
    memset(jet->turn, 0, sizeof jet->turn);
    memset(jet->bent, 0, sizeof jet->bent);
    jet->curvature = 0;
    if (jet->speed > 0) {
        taut_add_scaled(1 / jet->speed, jet->d1, jet->tangent);
        /* T' = (P' x P'') x P' / |P'|^3: no cancellation of what is parallel */
        taut_cross(jet->cross, jet->d1, jet->turn);
        for (int k = 0; k < 3; k++) {
            jet->turn[k] /= jet->speed * jet->speed * jet->speed;
        }
        /* T'' = (K' x P' + K x P'') / |P'|^3 - 3 (P' . P'') / |P'|^2 T', K = P' x P'' */
        taut_cross(cross1, jet->d1, jet->bent);
        taut_cross(jet->cross, jet->d2, more);
        for (int k = 0; k < 3; k++) {
            jet->bent[k] =
                (jet->bent[k] + more[k]) / (jet->speed * jet->speed * jet->speed) -
                3 * taut_dot(jet->d1, jet->d2) / (jet->speed * jet->speed) * jet->turn[k];
        }
        jet->curvature = taut_length(jet->cross) / (jet->speed * jet->speed * jet->speed);
    }
}

/* First [0, hi] is cut off, then what is left of lo/hi from that. */
void taut_pipe_arc_piece(const taut_pipe_arc *arc, double lo, double hi, double (*points)[3])
{
    taut_bernstein_split(arc->degree, 3, &arc->points[0][0], hi, &points[0][0], NULL);
    taut_bernstein_split(arc->degree, 3, &points[0][0], lo / hi, NULL, &points[0][0]);
}
