/* test_quadrature.c -- Gauss rules integrate monomials exactly. */
#include "check.h"

#include "numeric/quadrature.h"

int main(void)
{
    double nodes[TAUT_GAUSS_MAX], weights[TAUT_GAUSS_MAX];
    for (int n = 1; n <= TAUT_GAUSS_MAX; n++) {
        taut_gauss_rule(n, nodes, weights);
        for (int power = 0; power <= 2 * n - 1 && power < 40; power++) {
            double sum = 0;
            for (int i = 0; i < n; i++) {
                sum += weights[i] * pow(nodes[i], power);
            }
            CHECK_NEAR(sum, power % 2 == 0 ? 2.0 / (power + 1) : 0, 2e-14, "n=%d power=%d", n,
                       power);
        }
        for (int i = 1; i < n; i++) {
            CHECK(nodes[i] > nodes[i - 1] && weights[i] > 0, "n=%d i=%d", n, i);
        }
    }
    return check_failures != 0;
}
