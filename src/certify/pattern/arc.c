#include "certify/pattern/arc.h"

#include "certify/common/bernstein.h"

#include <string.h>

enum { P = TAUT_CLOTH_ARC - 1 };

void taut_cloth_arc_of(const taut_basis *basis, int span, const double *alive, size_t stride,
                       double out[TAUT_CLOTH_ARC][2])
{
    taut_basis_spec spec;
    taut_basis_spec_of(basis, &spec);
    const int first = taut_basis_first(basis, span);
    const double a = taut_basis_breaks(basis)[span], b = taut_basis_breaks(basis)[span + 1];
    for (int i = 0; i <= P; i++) {
        double work[P + 1][2] = {{0}};
        for (int k = 0; k <= P; k++) {
            memcpy(work[k], alive + (size_t)k * stride, sizeof work[k]);
        }
        for (int level = 1; level <= P; level++) {
            const double x = level > P - i ? b : a; /* i of the arguments are b */
            for (int k = 0; k <= P - level; k++) {
                const double lo = spec.knots[first + k + level], hi = spec.knots[first + k + P + 1];
                const double t = (x - lo) / (hi - lo);
                for (int d = 0; d < 2; d++) {
                    work[k][d] = (1 - t) * work[k][d] + t * work[k + 1][d];
                }
            }
        }
        memcpy(out[i], work[0], sizeof work[0]);
    }
}

void taut_cloth_arc_halve(const taut_cloth_arc *whole, taut_cloth_arc *low, taut_cloth_arc *high)
{
    taut_certify_halve(P, 2, whole->p[0], low->p[0], high->p[0]);
}
