#include "certify/trace/audit.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

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

double taut_net_number(const taut_record *at, const char *member)
{
    return taut_record_number(taut_record_get(at, member));
}

const char *taut_net_text(const taut_record *at, const char *member)
{
    return taut_record_text(taut_record_get(at, member));
}

int taut_net_surface_of(const taut_net_audit *audit, const taut_record *at)
{
    const char *name = taut_net_text(at, "surface");
    int on = 0;
    for (int k = 1; k < audit->lines->surface_count; k++) {
        on = strcmp(taut_surface_name(audit->cells->surfaces[k]), name) == 0 ? k : on;
    }
    return on;
}
