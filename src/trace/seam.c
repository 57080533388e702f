/* seam.c
 *
 * The place beyond a seam: by the affine map of one edge's range to the other's, then by Gauss-Newton on the
 * other edge to the nearest point of it in space.
 */
#include "trace/seam.h"

#include "core/vec3.h"

#include <string.h>

enum { ROUNDS = 20 };
/* Sine of the angle with a border below which a curve runs along it. */
static const double along_border = 1e-9;
/* Over the size: how far a curve may jump; of a range: a step that is rounding. Normals nearer than the last
 * are one. */
static const double same_place = 1e-9, settled = 4e-16, same_normal = 1e-9;

/* The place at t in [0, 1] of an edge. */
static void edge_at(const taut_carrier *carrier, int edge, double t, double at[2])
{
    const int held = edge / 2, along = 1 - held;
    const double lo = carrier->lo[along], hi = carrier->hi[along];
    at[held] = edge % 2 == 0 ? carrier->lo[held] : carrier->hi[held];
    at[along] = t <= 0 ? lo : t >= 1 ? hi : lo + t * (hi - lo);
}

static void space_at(const taut_carrier *carrier, const double at[2], int order,
                     double x[TAUT_CARRIER_VECTORS][3])
{
    int span[2];
    taut_carrier_cell(carrier, at, NULL, span);
    taut_carrier_at(carrier, span, at, order, x);
}

int taut_seam_ends_meet(const taut_carrier *a, int edge_a, const taut_carrier *b, int edge_b,
                        double room)
{
    double x[4][TAUT_CARRIER_VECTORS][3], at[2];
    const double near = room * a->size;

    for (int end = 0; end < 2; end++) {
        edge_at(a, edge_a, end, at);
        space_at(a, at, 0, x[end]);
        edge_at(b, edge_b, end, at);
        space_at(b, at, 0, x[2 + end]);
    }
    if (taut_length_between(x[0][0], x[1][0]) <= 2 * near) {
        return 0;
    }
    return taut_length_between(x[0][0], x[2][0]) <= near &&
                   taut_length_between(x[1][0], x[3][0]) <= near
               ? 1
           : taut_length_between(x[0][0], x[3][0]) <= near &&
                   taut_length_between(x[1][0], x[2][0]) <= near
               ? -1
               : 0;
}

int taut_seam_agrees(const taut_carrier *a, int edge_a, const taut_seam *seam)
{
    double x[TAUT_CARRIER_VECTORS][3], at[2], there[2];
    taut_form_pair forms[2];
    taut_carrier one = *a;

    one.seams[edge_a] = (taut_seam *)seam;
    edge_at(a, edge_a, 0.5, at);
    taut_carrier_forms_at(a, at, x, &forms[0]);
    if (taut_seam_cross(&one, edge_a, at, there) == NULL) {
        return 0;
    }
    taut_carrier_forms_at(seam->to, there, x, &forms[1]);
    return forms[0].w > 0 && forms[1].w > 0 &&
           taut_length_between(forms[0].normal, forms[1].normal) <= same_normal;
}

int taut_seam_out(const taut_carrier *carrier, const double at[2], const double ab[2])
{
    double x[TAUT_CARRIER_VECTORS][3], most = along_border;
    int edge = -1;

    space_at(carrier, at, 1, x);
    for (int d = 0; d < 2; d++) {
        const int side = at[d] == carrier->hi[d];
        const double out = (side ? 1 : -1) * ab[d] * taut_length(x[1 + d]);
        if ((at[d] == carrier->lo[d] || side) && !carrier->wraps[d] && out > most) {
            most = out;
            edge = 2 * d + side;
        }
    }
    return edge;
}

const taut_carrier *taut_seam_cross(const taut_carrier *carrier, int edge, const double at[2],
                                    double there[2])
{
    const taut_seam *seam = carrier->seams[edge];
    const int along = 1 - edge / 2;
    double x[TAUT_CARRIER_VECTORS][3], y[TAUT_CARRIER_VECTORS][3], away[3];

    if (seam == NULL) {
        return NULL;
    }
    const int far = 1 - seam->edge / 2;
    const double width = seam->to->hi[far] - seam->to->lo[far];
    double t = (at[along] - carrier->lo[along]) / (carrier->hi[along] - carrier->lo[along]);

    t = seam->is_reversed ? 1 - t : t;
    space_at(carrier, at, 0, x);
    for (int round = 0; round < ROUNDS && t > 0 && t < 1; round++) {
        edge_at(seam->to, seam->edge, t, there);
        space_at(seam->to, there, 1, y);
        taut_difference(x[0], y[0], away);
        const double *slope = y[1 + far];
        const double step = taut_dot(away, slope) / taut_dot(slope, slope) / width;
        t = fmin(fmax(t + step, 0), 1);
        if (!(fabs(step) > settled)) {
            break;
        }
    }
    edge_at(seam->to, seam->edge, t, there);
    space_at(seam->to, there, 0, y);
    return taut_length_between(x[0], y[0]) <= same_place * carrier->size ? seam->to : NULL;
}
