#include "certify/trace/audit.h"

#include <math.h>
#include <stdio.h>

void taut_net_off_take(taut_net_off *off, double residual, const char *name, const char *member)
{
    const double found = isnan(residual) ? INFINITY : residual;
    if (off->where[0] == '\0' || found > off->residual) {
        snprintf(off->where, sizeof off->where, "%.40s %.40s", name, member);
        off->residual = found;
    }
}

int taut_net_is_on_knot(const taut_surface *surface, const double at[2])
{
    int is_on = 0;
    for (int d = 0; d < 2; d++) {
        const taut_basis *basis = d == 0 ? taut_surface_u(surface) : taut_surface_v(surface);
        const double *breaks = taut_basis_breaks(basis);
        const double room = TAUT_NET_AT_KNOT * (taut_basis_hi(basis) - taut_basis_lo(basis));
        for (int k = 1; k < taut_basis_span_count(basis); k++) {
            is_on |= fabs(at[d] - breaks[k]) <= room;
        }
    }
    return is_on;
}
