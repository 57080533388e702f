#include "trace/bending.h"

#include "core/vec3.h"

taut_bending taut_bending_at(const taut_carrier *carrier, taut_linefield_kind kind,
                             const taut_segment *segment, double t)
{
    double window[TAUT_QUINTIC][2], x[TAUT_CARRIER_VECTORS][3], at[2], way[2], ab[2], bend[2];
    double out[3], tangent[3], sideways[3];
    taut_form_pair forms;
    taut_bending b = {{0}};

    taut_segment_window(segment, window);
    taut_quintic_at(2, window[0], t, at, way, bend);
    taut_carrier_at(carrier, segment->start.span, at, 3, x);
    taut_carrier_forms((const double(*)[3])x, &forms);
    const double square =
        forms.e * way[0] * way[0] + 2 * forms.f * way[0] * way[1] + forms.g * way[1] * way[1];
    ab[0] = way[0] / sqrt(square);
    ab[1] = way[1] / sqrt(square);
    if (kind.net != TAUT_TRACE_GEODESIC) {
        double exact[2];
        if (taut_linefield_direction(carrier, kind, &forms, exact) != TAUT_LINEFIELD_FINE) {
            return b;
        }
        const double sign = exact[0] * (forms.e * ab[0] + forms.f * ab[1]) +
                                        exact[1] * (forms.f * ab[0] + forms.g * ab[1]) <
                                    0
                                ? -1
                                : 1;
        ab[0] = sign * exact[0];
        ab[1] = sign * exact[1];
    }
    b.value[TAUT_K_N] = taut_linefield_normal_curvature(&forms, ab);
    b.value[TAUT_TAU_G] = taut_linefield_torsion(&forms, ab);
    if (taut_linefield_bend(kind.net, (const double(*)[3])x, &forms, ab, bend)) {
        taut_linefield_tangent((const double(*)[3])x, ab, tangent);
        taut_linefield_acceleration((const double(*)[3])x, ab, bend, out);
        taut_cross(forms.normal, tangent, sideways);
        b.value[TAUT_K_G] = taut_dot(out, sideways);
    }
    return b;
}
