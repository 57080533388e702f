/* run_ends.c -- does a run go where it was asked to?
 *
 *     legs      each blend begins and ends at the ends of its straight pipes, along them
 *     corners   each blend begins and ends on the legs of its corner, along them; the corners that
 *               turn are as many as the blends
 *
 * the largest distance, over the radius, and difference of unit tangents; an open run begins and
 * ends where the first and last are.
 */
#include "certify/pipe/run.h"
#include "core/vec3.h"

#include <float.h>
#include <math.h>
#include <stdio.h>

static const double turns_not = 1e-9;

/* One straight pipe asked for: a line, and where on it, if that is said. */
typedef struct leg {
    const double *from, *to;
    double direction[3];
} leg;

static void unit(const double v[3], double out[3])
{
    const double length = taut_norm(v);
    for (int k = 0; k < 3; k++) {
        out[k] = length > 0 ? v[k] / length : 0;
    }
}

/* The next leg of the problem at or after *i; corners without a turn are passed over. */
static leg next_leg(const taut_pipe_problem *p, int *i)
{
    leg out = {.from = p->legs[*i % p->leg_count].from};
    double d[3];
    if (p->axis == TAUT_PIPE_LEGS) {
        out.to = p->legs[*i % p->leg_count].to;
        taut_difference(out.to, out.from, d);
        unit(taut_norm(d) > 0 ? d : p->legs[*i % p->leg_count].direction, out.direction);
        *i += 1;
        return out;
    }
    out.to = p->legs[(*i + 1) % p->leg_count].from;
    taut_difference(out.to, out.from, d);
    unit(d, out.direction);
    for (*i += 1; p->closed ? *i < 2 * p->leg_count : *i + 1 < p->leg_count; *i += 1) {
        double on[3], across[3];
        taut_difference(p->legs[(*i + 1) % p->leg_count].from, out.to, d);
        unit(d, on);
        taut_cross(out.direction, on, across);
        if (taut_norm(across) > turns_not || taut_dot(out.direction, on) < 0) {
            break;
        }
        out.to = p->legs[(*i + 1) % p->leg_count].from;
    }
    return out;
}

static void absolute(const taut_pipe_line *line, const double local[3], double x[3])
{
    for (int k = 0; k < 3; k++) {
        x[k] = line->origin[k] + line->scale * local[k];
    }
}

/* How far end `t` of a piece is from what was asked of it. */
static double miss(const taut_pipe_run_parts *run, int piece, int t, const leg *asked)
{
    const taut_pipe_problem *p = run->parts.problem;
    const taut_pipe_piece *b = &run->parts.line.pieces[piece];
    double x[3], d[3], tangent[3];
    absolute(&run->parts.line, b->points[t == 0 ? 0 : b->degree], x);
    taut_difference(x, t == 0 ? asked->to : asked->from, d);
    if (p->axis == TAUT_PIPE_CORNERS) {
        taut_add_scaled(-taut_dot(d, asked->direction), asked->direction, d);
    }
    taut_pipe_run_tangent(run, piece, t, tangent);
    return fmax(taut_norm(d) / run->parts.radius, taut_distance(tangent, asked->direction));
}

/* Where the run as a whole begins or ends. */
static double miss_free(const taut_pipe_run_parts *run, int side)
{
    const taut_pipe_problem *p = run->parts.problem;
    const taut_pipe_leg *last = &p->legs[p->leg_count - 1];
    const int i = side == 0 ? 0 : run->count - 1;
    const taut_pipe_piece *b = &run->parts.line.pieces[i];
    double x[3];
    absolute(&run->parts.line, b->points[side == 0 ? 0 : b->degree], x);
    return taut_distance(x, side == 0                   ? p->legs[0].from
                            : p->axis == TAUT_PIPE_LEGS ? last->to
                                                        : last->from) /
           run->parts.radius;
}

taut_status taut_pipe_claim_run_ends(const taut_pipe_run_parts *run, taut_certificate *certificate)
{
    const taut_pipe_problem *p = run->parts.problem;
    const int single = p->axis != TAUT_PIPE_LEGS && p->axis != TAUT_PIPE_CORNERS;
    double worst = single ? 1 : 0, shortest = INFINITY;
    int i = 0, blends = 0;
    char where[48] = "";

    leg before = {.from = NULL}, after = {.from = NULL};
    for (int k = 0; k < run->count && !single; k++) {
        if (!taut_pipe_is_blend(run, k)) {
            continue;
        }
        before = blends == 0 ? next_leg(p, &i) : after;
        after = next_leg(p, &i);
        blends++;
        const double found = fmax(miss(run, k, 0, &before), miss(run, k, 1, &after));
        const taut_pipe_piece *piece = &run->parts.line.pieces[k];
        shortest = fmin(shortest, fmin(taut_distance(piece->points[0], piece->points[1]),
                                       taut_distance(piece->points[piece->degree],
                                                     piece->points[piece->degree - 1])));
        if (!(found <= worst)) {
            worst = found;
            snprintf(where, sizeof where, "%.32s", taut_surface_name(run->surfaces[k]));
        }
    }
    for (int side = 0; side < 2 && !p->closed && !single; side++) {
        worst = fmax(worst, miss_free(run, side));
    }
    /* rounding of each coordinate, over the radius and over the legs that make the tangents */
    const double noise = 4 * DBL_EPSILON + 4 * DBL_EPSILON * run->parts.size / run->parts.radius +
                         8 * DBL_EPSILON * run->parts.size / (shortest * run->parts.line.scale);
    return taut_pipe_add_claim("ends", worst, 0, noise, where, certificate);
}
