/* test_poly.c -- polynomials in Bernstein form, inflections, and the bubble basis, each
 * against values. */
#include "check.h"

#include "construct/asymptotic/bubble.h"
#include "construct/asymptotic/inflection.h"
#include "construct/asymptotic/poly.h"
#include "core/vec3.h"
#include "numeric/bernstein.h"
#include "numeric/quadrature.h"

#include <float.h>
#include <string.h>

enum { P = 6, Q = 7, SUM = P + Q };

static void fill(int count, double *a)
{
    for (int i = 0; i < count; i++) {
        a[i] = random_in(-1, 1);
    }
}

static void test_products(void)
{
    for (int trial = 0; trial < 100; trial++) {
        double s[P + 1], a[P + 1][3], b[Q + 1][3], sb[SUM + 1][3], ab[SUM + 1][3], up[SUM + 1][3];
        const double t = random_in(0, 1);
        double vs = 0.0, va[3], vb[3], vsb[3], vab[3], cross[3], vup[3];
        fill(P + 1, s);
        fill(3 * (P + 1), &a[0][0]);
        fill(3 * (Q + 1), &b[0][0]);
        taut_poly_scale(P, s, Q, 3, &b[0][0], &sb[0][0]);
        taut_poly_cross(P, &a[0][0], Q, &b[0][0], &ab[0][0]);
        taut_poly_elevate(P, 3, &a[0][0], Q, &up[0][0]);
        taut_poly_eval(P, 1, s, t, &vs);
        taut_poly_eval(P, 3, &a[0][0], t, va);
        taut_poly_eval(Q, 3, &b[0][0], t, vb);
        taut_poly_eval(SUM, 3, &sb[0][0], t, vsb);
        taut_poly_eval(SUM, 3, &ab[0][0], t, vab);
        taut_poly_eval(SUM, 3, &up[0][0], t, vup);
        taut_cross(va, vb, cross);
        for (int k = 0; k < 3; k++) {
            CHECK_NEAR(vsb[k], vs * vb[k], 1e-14, "t=%a", t);
            CHECK_NEAR(vab[k], cross[k], 1e-14, "t=%a", t);
            CHECK_NEAR(vup[k], va[k], 1e-14, "t=%a", t);
        }
    }
}

/* (t - root) q divided by (t - root) is q, for roots all over [0, 1] and its ends. */
static void test_deflate(void)
{
    for (int trial = 0; trial < 500; trial++) {
        const double root = trial % 10 == 0 ? trial % 20 / 10.0 : random_in(0, 1);
        const double factor[2] = {-root, 1.0 - root};
        double q[Q + 1][3], product[Q + 2][3], back[Q + 1][3];
        fill(3 * (Q + 1), &q[0][0]);
        taut_poly_scale(1, factor, Q, 3, &q[0][0], &product[0][0]);
        taut_poly_deflate(Q + 1, 3, &product[0][0], root, &back[0][0]);
        for (int j = 0; j <= Q; j++) {
            for (int k = 0; k < 3; k++) {
                CHECK_NEAR(back[j][k], q[j][k], 1e-12, "root %a coefficient %d", root, j);
            }
        }
    }
}

/* A vector polynomial with given zeros loses them all, and is the quotient raised again. */
static void test_inflections(void)
{
    for (int trial = 0; trial < 200; trial++) {
        const int zeros = trial % 4;
        double roots[3] = {random_in(0.02, 0.3), random_in(0.36, 0.64), random_in(0.7, 0.98)};
        double q[SUM + 1][3], work[SUM + 1][3], start[4][3], at[SUM];
        int degree = 3, found = 0;
        fill(9, &start[0][0]);
        start[0][2] += 2; /* the quotient itself has no zero */
        start[1][2] += 2;
        start[2][2] += 2;
        fill(2, start[3]);
        start[3][2] = 1.5;
        memcpy(q, start, sizeof start);
        for (int k = 0; k < zeros; k++) {
            const double factor[2] = {-roots[k], 1.0 - roots[k]};
            taut_poly_scale(1, factor, degree, 3, &q[0][0], &work[0][0]);
            degree++;
            memcpy(q, work, sizeof work);
        }
        found = taut_inflections_remove(degree, DBL_EPSILON, q, at);
        CHECK(found == zeros, "trial %d: found %d of %d", trial, found, zeros);
        for (int k = 0; k < found; k++) {
            CHECK_NEAR(at[k], roots[k], 1e-13, "trial %d zero %d", trial, k);
        }
        taut_poly_elevate(3, 3, &start[0][0], zeros, &work[0][0]);
        for (int j = 0; j <= degree; j++) {
            for (int k = 0; k < 3; k++) {
                CHECK_NEAR(q[j][k], work[j][k], 1e-12, "trial %d", trial);
            }
        }
    }
}

/* int q_k'' q_l'' = delta_kl; value and slope vanish at the ends; the Bernstein form is the same
 * polynomial. */
static void test_bubbles(void)
{
    enum { M = 18, PER = M - 3, NODES = 40 };
    double node[NODES], weight[NODES], gram[PER][PER] = {{0}}, coefficients[PER * (M + 1)];
    taut_bubble_bernstein(M, coefficients);
    taut_gauss_rule(NODES, node, weight);
    for (int a = 0; a < NODES; a++) {
        const double t = 0.5 + 0.5 * node[a];
        double values[3 * PER], bernstein[3 * (M + 1)];
        taut_bubble_eval(M, t, values);
        taut_bernstein_eval(M, 2, t, bernstein);
        for (int k = 0; k < PER; k++) {
            double sum[3] = {0};
            for (int l = 0; l < PER; l++) {
                gram[k][l] += 0.5 * weight[a] * values[2 * PER + k] * values[2 * PER + l];
            }
            for (int d = 0; d < 3; d++) {
                for (int j = 0; j <= M; j++) {
                    sum[d] += coefficients[k * (M + 1) + j] * bernstein[d * (M + 1) + j];
                }
            }
            /* Bernstein coefficients of Legendre's polynomials reach C(16, 8) = 12870 */
            CHECK_NEAR(sum[0], values[k], 1e-13, "q_%d(%g)", k + 2, t);
            CHECK_NEAR(sum[2], values[2 * PER + k], 1e-9, "q_%d''(%g)", k + 2, t);
        }
    }
    for (int k = 0; k < PER; k++) {
        for (int l = 0; l < PER; l++) {
            CHECK_NEAR(gram[k][l], k == l, 1e-13, "%d %d", k, l);
        }
    }
    for (int end = 0; end < 2; end++) {
        double values[3 * PER];
        taut_bubble_eval(M, end, values);
        for (int k = 0; k < 2 * PER; k++) {
            CHECK_NEAR(values[k], 0.0, 1e-15, "end %d", end);
        }
    }
}

int main(void)
{
    random_seed(17);
    test_products();
    test_deflate();
    test_inflections();
    test_bubbles();
    return check_failures != 0;
}
