/* Which of several surfaces a claim is about: see certify/harmonic/claims.h. */
#include "certify/harmonic/claims.h"

#include "check.h"

#include <math.h>

int main(void)
{
    const double is_false = taut_harmonic_rank(2e-14, 1e-14);
    const double is_open = taut_harmonic_rank(1.2e-6, 1e-4);
    const double holds = taut_harmonic_rank(6.5e-7, 1e-6);

    CHECK(taut_harmonic_rank(NAN, 1) == INFINITY && taut_harmonic_rank(1, NAN) == INFINITY, "NaN");
    CHECK(is_false > is_open && is_false < INFINITY, "%g %g", is_false, is_open);
    CHECK(is_false > taut_harmonic_rank(9e-5, 1e-4), "false before open");
    CHECK(is_open > 1 && holds < 1, "%g %g", is_open, holds);
    CHECK(taut_harmonic_rank(5e-15, 1e-14) > taut_harmonic_rank(2e-15, 1e-14), "by the limit");
    CHECK(taut_harmonic_rank(0, 0) == 0, "a point");
    return check_failures != 0;
}
