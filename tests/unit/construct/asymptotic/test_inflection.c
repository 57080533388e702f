/* test_inflection.c -- inflections taken out of a polynomial, and the bubble basis, against values. */
#include "check.h"

#include "construct/asymptotic/bubble.h"
#include "construct/asymptotic/inflection.h"
#include "numeric/bernstein.h"
#include "numeric/quadrature.h"

#include <float.h>
#include <string.h>

enum { SUM = 13 };

static void fill(int count, double *a)
{
    for (int i = 0; i < count; i++) {
        a[i] = random_in(-1, 1);
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
            taut_bernstein_scale(1, factor, degree, 3, &q[0][0], &work[0][0]);
            degree++;
            memcpy(q, work, sizeof work);
        }
        found = taut_inflections_remove(degree, DBL_EPSILON, q, at);
        CHECK(found == zeros, "trial %d: found %d of %d", trial, found, zeros);
        for (int k = 0; k < found; k++) {
            CHECK_NEAR(at[k], roots[k], 1e-13, "trial %d zero %d", trial, k);
        }
        taut_bernstein_raise(3, 3, &start[0][0], zeros, &work[0][0]);
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
    test_inflections();
    test_bubbles();
    return check_failures != 0;
}
