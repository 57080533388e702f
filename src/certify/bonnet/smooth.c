/* smooth.c -- is a net of several spans one surface? On c- and h-bsplines, and where a knot of a
 * bspline is repeated degree - 1 times or less, it is C^1 by construction. Elsewhere the derivatives
 * across are compared from both sides, as coefficients along the break: two pieces that are harmonic
 * and isothermal are one analytic surface where they agree in r_u along a line.
 */
#include "certify/bonnet/proof.h"
#include "core/vec3.h"

#include <math.h>
#include <string.h>

static const double largest_limit = 1e-6;

/* Is the basis C^1 at its inner break k, 1 .. spans - 1? */
static int is_smooth_at(const taut_basis *basis, int k)
{
    taut_basis_spec spec;
    int found = 0;

    taut_basis_spec_of(basis, &spec);
    if (strcmp(spec.type, "bspline") != 0) {
        return 1;
    }
    for (int i = 0; i < spec.knot_count; i++) {
        found += spec.knots[i] == taut_basis_breaks(basis)[k];
    }
    return found < spec.degree;
}

/* A stretch of a break: its direction, the piece below it and the one above. */
typedef struct seam {
    int across;
    taut_bonnet_local side[2];
    double at[2];
} seam;

static const double *coefficient(const taut_bonnet_local *l, int across, int e)
{
    return across == 0 ? l->x[1][e] : l->x[e][1];
}

static double error_of(const taut_bonnet_local *l, int across, int e, int points)
{
    const double own = across == 0 ? l->own[1][e] : l->own[e][1];
    return own + (points ? (across == 0 ? l->points[1][e] : l->points[e][1]) : 0);
}

static void judge_seam(const seam *s, taut_bonnet_proof *proof)
{
    const double *along = s->side[0].bound[1 - s->across];
    double jump = 0, noise = 0, size = 0, seen = 0;

    for (int e = 0; e < 4; e++) {
        double apart[3];
        taut_difference(coefficient(&s->side[1], s->across, e),
                        coefficient(&s->side[0], s->across, e), apart);
        const double own = 1.75 * (error_of(&s->side[0], s->across, e, 0) +
                                   error_of(&s->side[1], s->across, e, 0));
        jump += (taut_length(apart) + own) * along[e];
        noise += 2 * 1.75 * along[e] *
                 (error_of(&s->side[0], s->across, e, 1) + error_of(&s->side[1], s->across, e, 1));
        size += (e == 0 ? 1 : -1) * taut_length(coefficient(&s->side[0], s->across, e)) * along[e];
        seen = e == 0 ? taut_length(apart) : seen;
    }
    const double large = taut_length(coefficient(&s->side[0], s->across, 0));
    const double limit = size > 0 ? fmin(noise / size, largest_limit) : largest_limit;
    const double residual = size > 0 ? jump / size : INFINITY;
    const taut_verdict holds = residual <= limit                   ? TAUT_TRUE
                               : seen > fmax(noise, limit * large) ? TAUT_FALSE
                                                                   : TAUT_UNDECIDED;
    const int worse = holds == TAUT_FALSE ? proof->holds != TAUT_FALSE || residual > proof->residual
                      : holds == TAUT_UNDECIDED
                          ? proof->holds == TAUT_TRUE
                          : proof->holds == TAUT_TRUE && !(residual <= proof->residual);
    if (worse) {
        *proof = (taut_bonnet_proof){holds, residual, limit, {s->at[0], s->at[1]}, NULL};
        proof->why = holds == TAUT_UNDECIDED
                         ? "the derivatives across a knot cannot be distinguished"
                         : NULL;
    }
}

void taut_bonnet_smooth(const taut_surface *surface, const taut_bonnet_scale *scale, int unit,
                        taut_bonnet_proof *proof)
{
    const taut_basis *bases[2] = {taut_surface_u(surface), taut_surface_v(surface)};
    const taut_bonnet_cuts cuts = taut_bonnet_cuts_of(surface);

    for (int d = 0; d < 2; d++) {
        for (int k = 1; k < taut_basis_span_count(bases[d]); k++) {
            for (int j = 0; !is_smooth_at(bases[d], k) && j < cuts.count[1 - d]; j++) {
                seam s = {.across = d};
                for (int side = 0; side < 2; side++) {
                    const int first = (k - 1 + side) * cuts.each[d];
                    taut_bonnet_piece piece = taut_bonnet_piece_at(
                        surface, &cuts, d == 0 ? first : j, d == 0 ? j : first);
                    piece.middle[d] = taut_basis_breaks(bases[d])[k];
                    piece.half[d] = 0;
                    taut_bonnet_local_of(surface, scale, unit, &piece, &s.side[side]);
                    memcpy(s.at, piece.middle, sizeof s.at);
                }
                judge_seam(&s, proof);
            }
        }
    }
}
