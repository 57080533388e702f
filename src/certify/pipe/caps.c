/* caps.c -- discs over the free ends: surface "cap1" over u0 of the first surface, "cap2" over
 * u1 of the last; that edge is u1 of cap1 and u0 of cap2, as u runs along the flow everywhere, and
 * all of a cap lies in the plane across it.
 *
 * The larger of the distance of the rims and that from the plane of three points of the rim, over
 * the radius.
 */
#include "certify/pipe/parts.h"
#include "core/vec3.h"

#include <float.h>
#include <math.h>
#include <stdio.h>

enum { AROUND = 48, ALONG = 4 };

static double miss_of(const taut_surface *cap, const taut_surface *end, int side)
{
    const taut_basis *u = taut_surface_u(end), *v = taut_surface_v(end);
    const double edge = side == 0 ? taut_basis_lo(u) : taut_basis_hi(u);
    const double rim = 1 - side;
    double corner[3][3], a[3], b[3], normal[3], size = 0, worst = 0;
    for (int k = 0; k < 3; k++) {
        taut_surface_eval(cap, rim, k / 3.0, 0, corner[k]);
    }
    taut_difference(corner[1], corner[0], a);
    taut_difference(corner[2], corner[0], b);
    taut_cross(a, b, normal);
    size = taut_norm(normal);
    for (int n = 0; n <= ALONG * AROUND; n++) {
        const double part = (double)(n % AROUND) / AROUND;
        double x[3], y[3], d[3];
        taut_surface_eval(cap, (double)(n / AROUND) / ALONG, part, 0, x);
        taut_difference(x, corner[0], d);
        worst = fmax(worst, size > 0 ? fabs(taut_dot(d, normal)) / size : INFINITY);
        if (n < AROUND) {
            taut_surface_eval(cap, rim, part, 0, x);
            taut_surface_eval(
                end, edge, taut_basis_lo(v) + (taut_basis_hi(v) - taut_basis_lo(v)) * part, 0, y);
            worst = fmax(worst, taut_distance(x, y));
        }
    }
    return worst;
}

taut_status taut_pipe_claim_caps(const taut_model *model, const taut_pipe_parts *parts,
                                 const taut_surface *const ends[2], taut_certificate *certificate)
{
    double worst = 0;
    char where[8] = "";
    int found = 0;
    for (int side = 0; side < 2; side++) {
        const taut_surface *cap = taut_pipe_find_surface(model, side == 0 ? "cap1" : "cap2");
        const double miss = cap != NULL ? miss_of(cap, ends[side], side) : 0;
        found += cap != NULL;
        if (!(miss <= worst)) {
            worst = miss;
            snprintf(where, sizeof where, "cap%d", side + 1);
        }
    }
    if (found == 0) {
        return TAUT_OK;
    }
    return taut_pipe_add_claim("caps", found == 2 ? worst / parts->radius : 1, 0,
                               (8 * DBL_EPSILON * parts->size / parts->radius + 16 * DBL_EPSILON) *
                                   parts->flatness,
                               where, certificate);
}
