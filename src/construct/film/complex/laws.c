#include "construct/film/complex/laws.h"

#include "construct/film/arc.h"
#include "core/constants.h"
#include "core/elementary/elementary.h"
#include "core/fail.h"
#include "core/vec3.h"

#include <math.h>

static const double soft_open = 2, soft_closed = 20, /* stiffness times length over force */
    stiffer = 5;                                     /* where that is not the first try */
static const double half_turn_most = 0.999;          /* of an arc that is begun with */

/* k of the spring that it begins with; 0: it begins as it is. */
static double soft_stiffness(const taut_film_drawn *d, double soft)
{
    if (!(soft > 0) || !(d->target > 0)) {
        return 0;
    }
    const double ratio = soft * d->ratio, more = soft > 1 ? stiffer : 1;
    const double stiffness = more * (d->is_closed ? soft_closed : soft_open) * ratio / d->target;
    const double k = d->shy > 0 ? fmin(stiffness, 0.5 * ratio / d->shy) : stiffness;
    return d->law == TAUT_FILM_ELASTIC && d->stiffness <= k ? 0 : k;
}

double taut_film_law_stiffness(const taut_film_drawn *drawn, double soft)
{
    const double k = soft_stiffness(drawn, soft);
    return k > 0 ? k : drawn->stiffness;
}

double taut_film_law_force(const taut_film_drawn *drawn, double soft, double length)
{
    const double k = soft_stiffness(drawn, soft);
    return k > 0 ? fmax(0, soft * drawn->ratio + k * (length - drawn->target))
                 : fmax(0, drawn->stiffness * (length - drawn->length));
}

double taut_film_law_energy(const taut_film_drawn *drawn, double soft, double length)
{
    const double p = taut_film_law_force(drawn, soft, length);
    return 0.5 * p * p / taut_film_law_stiffness(drawn, soft);
}

/* The distance of the ends where they start, scaled. */
static double chord_of(const taut_film_complex *c, const taut_scaling *scaling,
                       const double *points, int rope)
{
    const int *ends = c->ropes[rope].ends;
    return ldexp(taut_distance(points + 3 * ends[0], points + 3 * ends[1]),
                 -(scaling->outer + scaling->inner));
}

static double share_of(const taut_film_complex *c, const double *tensions, int rope)
{
    return tensions[c->strands[c->ropes[rope].strand].side.patch] / tensions[0];
}

/* The radius of an arc so long over a chord, of cables inside a film no more than the chord. */
static double radius_of(double chord, double length, int inside)
{
    if (chord == 0) {
        return length / (2 * TAUT_PI);
    }
    const double a =
        length > chord ? fmin(half_turn_most * TAUT_PI, taut_film_arc_angle(chord, length)) : 0;
    const double radius = a > 0 ? chord / (2 * taut_sin(a)) : INFINITY;
    return inside || !isfinite(radius) ? fmin(radius, chord) : radius;
}

static taut_status check_ratio(const taut_film_complex *c, int rope, const char *member,
                               double ratio, double given, taut_error *error)
{
    char where[TAUT_FILM_ROPE_WHERE];

    if (ratio >= TAUT_FILM_FORCE_MIN && ratio <= TAUT_FILM_FORCE_MAX) {
        return TAUT_OK;
    }
    taut_film_rope_where(c, rope, member, where);
    return taut_fail(error, TAUT_BAD_INPUT, "value", where, given, taut_none,
                     "the %s of a cable is %.3g of the film's tension times its size, expected "
                     "%.0e to %.0e",
                     member, ratio, TAUT_FILM_FORCE_MIN, TAUT_FILM_FORCE_MAX);
}

static taut_status refuse_sag(const taut_film_complex *c, int rope, double sag, taut_error *error)
{
    char where[TAUT_FILM_ROPE_WHERE], name[TAUT_FILM_NAME];

    taut_film_rope_where(c, rope, "sag", where);
    taut_film_rope_name(c, rope, name);
    return taut_fail(error, TAUT_BAD_INPUT, "value", where, sag, taut_none,
                     "cable %s has no chord to sag from, for its ends are not held, or it closes: "
                     "give its length or force",
                     name);
}

/* What it begins with. */
static void soften(taut_film_drawn *d, double chord, double length)
{
    d->target = length;
    d->is_closed = chord == 0;
    d->shy = chord > 0 ? fmax(0, length - chord) : 0;
}

static taut_status find_one(const taut_film_complex *c, const taut_scaling *scaling,
                            const double *points, const double *tensions, int rope,
                            taut_film_drawn *d, taut_error *error)
{
    const taut_film_edge *law = taut_film_rope_law(c, rope);
    const int unit = scaling->outer + scaling->inner;
    const int inside = c->strands[c->ropes[rope].strand].seam >= 0;
    const double chord = chord_of(c, scaling, points, rope), share = share_of(c, tensions, rope);
    taut_status status = TAUT_OK;

    *d = (taut_film_drawn){.law = law->law};
    if (law->law == TAUT_FILM_FORCE) {
        d->ratio = ldexp(law->force / tensions[0], -unit);
        return check_ratio(c, rope, "force", d->ratio, law->force, error);
    }
    if (law->law == TAUT_FILM_SAG && !(taut_film_rope_chord(c, rope) > 0)) {
        return refuse_sag(c, rope, law->sag, error);
    }
    if (taut_film_rope_is_given(law)) {
        d->length = ldexp(taut_film_rope_length(c, rope), -unit);
        status = check_ratio(c, rope, law->law == TAUT_FILM_SAG ? "sag" : "length", d->length,
                             law->law == TAUT_FILM_SAG ? law->sag : law->length, error);
        d->ratio = share * radius_of(chord, d->length, inside);
        if (status == TAUT_OK) {
            status = check_ratio(c, rope, law->law == TAUT_FILM_SAG ? "sag" : "length", d->ratio,
                                 law->law == TAUT_FILM_SAG ? law->sag : law->length, error);
        }
        soften(d, chord, d->length);
        return status;
    }
    const double stiff = ldexp(law->stiffness / tensions[0], -unit);
    d->length = ldexp(law->unstressed, -unit);
    status = check_ratio(c, rope, "stiffness", stiff, law->stiffness, error);
    if (status == TAUT_OK) {
        status = check_ratio(c, rope, "unstressed", d->length, law->unstressed, error);
    }
    if (status != TAUT_OK) {
        return status;
    }
    d->stiffness = stiff / d->length;
    const double k = d->stiffness / share, turn = 2 * TAUT_PI;
    const double radius = chord > 0      ? taut_film_arc_elastic(chord, d->length, k)
                          : turn * k > 2 ? k * d->length / (turn * k - 1)
                                         : d->length;
    d->ratio = share * (radius > 0 ? radius : 0.5 * chord);
    if (inside && chord > 0) {
        d->ratio = fmin(d->ratio, share * chord);
    }
    soften(d, chord, d->length + d->ratio / d->stiffness);
    return TAUT_OK;
}

taut_status taut_film_laws_find(const taut_film_complex *complex, const taut_scaling *scaling,
                                const double *points, const double *tensions,
                                taut_film_drawn *drawn, taut_error *error)
{
    taut_status status = TAUT_OK;

    for (int k = 0; status == TAUT_OK && k < complex->rope_count; k++) {
        status = find_one(complex, scaling, points, tensions, k, &drawn[k], error);
    }
    return status;
}
