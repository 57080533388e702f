#include "construct/film/complex/strength.h"

#include "core/fail.h"
#include "core/vec3.h"

#include <math.h>
#include <stdio.h>

static const double rungs[4] = {0.5, 0.59460355750136051, 0.70710678118654757, 0.84089641525371461};
static const double digits_told = 5e-6; /* share: enough for a message of six digits */

static int can_one(const taut_film_drawn *given, double factor)
{
    switch (given->law) {
    case TAUT_FILM_FORCE:
        return 1;
    case TAUT_FILM_ELASTIC:
        return !given->is_closed &&
               given->length - (factor - 1) * given->ratio / given->stiffness > 0;
    case TAUT_FILM_LENGTH:
    case TAUT_FILM_SAG:
        return !given->is_closed && given->shy > 0;
    }
    return 0;
}

int taut_film_can_strengthen(const taut_film_layout *layout, const taut_film_drawn *given,
                             double factor)
{
    int can = layout->complex.rope_count > 0;
    for (int k = 0; k < layout->complex.rope_count; k++) {
        can &= can_one(&given[k], factor);
    }
    return can;
}

static taut_film_drawn strong_one(const taut_film_drawn *given, double factor)
{
    taut_film_drawn d = *given;

    if (factor == 1) {
        return d;
    }
    d.ratio *= factor;
    if (d.law == TAUT_FILM_ELASTIC) {
        d.length -= (factor - 1) * given->ratio / given->stiffness;
    } else if (d.law != TAUT_FILM_FORCE) {
        d.shy /= factor * factor;
        d.length = d.target = given->length - given->shy + d.shy;
    }
    return d;
}

void taut_film_strengthen(taut_film_energy *energy, taut_film_layout *layout,
                          const taut_film_drawn *given, double factor)
{
    const taut_film_complex *c = &layout->complex;

    for (int k = 0; k < c->rope_count; k++) {
        layout->drawn[k] = strong_one(&given[k], factor);
    }
    for (int k = 0; energy != NULL && k < c->strand_count; k++) {
        energy->cables[k].tension = layout->drawn[c->strands[k].rope].ratio;
    }
}

/* How strong the weakest cable is by itself. */
static double strength_of(const taut_film_layout *l, const taut_film_drawn *given)
{
    double least = INFINITY;

    for (int k = 0; k < l->complex.rope_count; k++) {
        const int *ends = l->complex.ropes[k].ends;
        const double chord = taut_distance(l->start + 3 * ends[0], l->start + 3 * ends[1]);
        if (chord > 0) {
            least = fmin(least, given[k].ratio / chord);
        }
    }
    return least > 0 && least < INFINITY ? least : 1;
}

double taut_film_rung(const taut_film_layout *layout, const taut_film_drawn *given, int k)
{
    const double strength = strength_of(layout, given);
    int power = 0, first = 0;
    const double share = frexp(strength, &power);

    while (first < 4 && rungs[first] <= share) {
        first++;
    }
    const int at = first + k - 1;
    return ldexp(rungs[at % 4] / strength, at / 4 + power);
}

taut_status taut_film_refuse_weak(const taut_film_complex *complex, const taut_film_drawn *given,
                                  double factor, taut_error *error)
{
    char where[TAUT_FILM_ROPE_WHERE], name[TAUT_FILM_NAME], told[64] = "";
    int k = 0;

    while (k < complex->rope_count - 1 && given[k].law != TAUT_FILM_FORCE) {
        k++;
    }
    k = given[k].law == TAUT_FILM_FORCE ? k : 0;
    factor *= 1 + digits_told;
    const taut_film_edge *law = complex->ropes[k].edge;
    const int is_force = law->law == TAUT_FILM_FORCE, is_length = law->law == TAUT_FILM_LENGTH;
    const double limit = is_force ? factor * law->force
                         : is_length
                             ? strong_one(&given[k], factor).length * law->length / given[k].length
                             : factor;
    static const char *const members[] = {
        [TAUT_FILM_FORCE] = "force",
        [TAUT_FILM_LENGTH] = "length",
        [TAUT_FILM_SAG] = "sag",
        [TAUT_FILM_ELASTIC] = "unstressed",
    };
    taut_film_rope_where(complex, k, members[law->law], where);
    taut_film_rope_name(complex, k, name);
    if (is_force || is_length) {
        snprintf(told, sizeof told,
                 is_force ? ": %.6g for cable " : ": a length of %.6g for cable ", limit);
    }
    return taut_fail(
        error, TAUT_NO_SOLUTION, "cable-too-weak", where,
        is_force    ? law->force
        : is_length ? law->length
                    : 1,
        limit,
        "the cables are too weak for this film: lowered together from stronger ones, the last "
        "film is found at %.6g times their forces%s%s; below that it draws a cable into another "
        "edge, folds, or gets thinner at a corner than its knots can resolve",
        factor, told, is_force || is_length ? name : "");
}
