#include "certify/trace/side.h"

#include "measure/curvature/spot.h"

#include <math.h>

/* Over the window's side: places that differ by rounding alone. */
static const double same = 1e-12;

void taut_net_side_forms(const taut_surface *surface, const int span[2], const double at[2],
                         taut_forms *forms)
{
    static const int no_shift[2] = {0, 0};
    static const int power[6][2] = {{0, 0}, {1, 0}, {0, 1}, {2, 0}, {1, 1}, {0, 2}};
    double values[6][3],
        place[2]; /* in the span, which ends at a break that rounding may put it beyond */
    taut_spot spot;

    for (int d = 0; d < 2; d++) {
        const double *breaks =
            taut_basis_breaks(d == 0 ? taut_surface_u(surface) : taut_surface_v(surface));
        place[d] = fmin(fmax(at[d], breaks[span[d]]), breaks[span[d] + 1]);
    }
    taut_spot_at(surface, span[0], span[1], place[0], place[1], 2, 0, no_shift, &spot);
    for (int k = 0; k < 6; k++) {
        const double factorial = power[k][0] == 2 || power[k][1] == 2 ? 2 : 1;
        for (int c = 0; c < 3; c++) {
            values[k][c] = factorial * spot.x[c].c[taut_jet_index(power[k][0], power[k][1])];
        }
    }
    taut_forms_of((const double(*)[3])values, forms);
}

int taut_net_on_break(const taut_surface *surface, int d, const double at[2], int *span)
{
    const taut_basis *basis = d == 0 ? taut_surface_u(surface) : taut_surface_v(surface);
    const double *breaks = taut_basis_breaks(basis);
    const double room = same * (taut_basis_hi(basis) - taut_basis_lo(basis));
    *span = taut_basis_span(basis, at[d]);
    *span += *span + 1 < taut_basis_span_count(basis) && breaks[*span + 1] - at[d] <= room;
    return *span > 0 && fabs(at[d] - breaks[*span]) <= room;
}
