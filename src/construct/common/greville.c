#include "construct/common/greville.h"

#include "basis/basis_ops.h"

#include <math.h>
#include <stddef.h>

void taut_greville(const taut_basis *basis, double *t)
{
    const int count = taut_basis_count(basis);
    const double lo = taut_basis_lo(basis), hi = taut_basis_hi(basis);

    if (basis->ops->linear != NULL) {
        basis->ops->linear(basis, t);
    }
    for (int i = 0; i < count; i++) {
        const double even = lo + (hi - lo) * i / (count - 1);
        t[i] = fmin(hi, fmax(lo, basis->ops->linear != NULL ? t[i] : even));
    }
}
