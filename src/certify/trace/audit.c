#include "certify/trace/audit.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* Of a coefficient, and how much of a residual this may explain at most. */
static const double roundings = 0x1p-50, most_blur = 1e-4;

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

/* By the shape operator in the frame e1 = x_u/sqrt E, e2 = n x e1, which is
 * (a b; b c) there, R^2 = (a - c)^2/4 + b^2 ([doCarmo1976] 3-3). */
double taut_net_radius(const taut_forms *f)
{
    const double along = f->l / f->e, twist = (f->m - f->f * along) / f->w;
    const double across = (f->e * f->n - 2 * f->f * f->m + f->f * f->f * along) / (f->w * f->w);
    const double half = (along - across) / 2;
    return sqrt(half * half + twist * twist);
}

/* Of a polynomial of degree n on a span of width h second derivatives are n (n - 1) / h^2 times differences of its
 * coefficients, which are rounded. */
double taut_net_blur(const taut_surface *surface, double size, const double at[2],
                     const taut_forms *f)
{
    const double squares[2] = {f->e, f->g};
    double sum = 0;
    for (int d = 0; d < 2; d++) {
        const taut_basis *basis = d == 0 ? taut_surface_u(surface) : taut_surface_v(surface);
        const double degree = taut_basis_degree(basis);
        const double *span = taut_basis_breaks(basis) + taut_basis_span(basis, at[d]);
        const double width = span[1] - span[0];
        sum += degree > 1 ? degree * (degree - 1) / (width * width * squares[d]) : 0;
    }
    return fmin(roundings * size * sum / taut_net_radius(f), most_blur);
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
