#include "problem/film_ropes.h"

#include "core/elementary/elementary.h"
#include "core/fail.h"
#include "core/vec3.h"

#include <stdio.h>

static const char *const edge_names[4] = {"u0", "u1", "v0", "v1"};

void taut_film_rope_name(const taut_film_complex *complex, int rope, char name[TAUT_FILM_NAME])
{
    const taut_film_rope *r = &complex->ropes[rope];

    if (r->along < 0) {
        const taut_film_side *side = &complex->strands[r->strand].side;
        taut_film_complex_name(complex->problem, side->patch, edge_names[side->edge], name);
    } else if (complex->problem->along[r->along].name != NULL) {
        snprintf(name, TAUT_FILM_NAME, "%.95s", complex->problem->along[r->along].name);
    } else {
        snprintf(name, TAUT_FILM_NAME, "cable-%d", r->along);
    }
}

void taut_film_rope_where(const taut_film_complex *complex, int rope, const char *member,
                          char where[TAUT_FILM_ROPE_WHERE])
{
    const taut_film_rope *r = &complex->ropes[rope];

    if (r->along >= 0) {
        snprintf(where, TAUT_FILM_ROPE_WHERE, "/cables/%d/%s", r->along, member);
        return;
    }
    const taut_film_strand *strand = &complex->strands[r->strand];
    if (strand->seam >= 0) {
        snprintf(where, TAUT_FILM_ROPE_WHERE, "/seams/%d/cable/%s", strand->seam, member);
    } else {
        snprintf(where, TAUT_FILM_ROPE_WHERE, "/patches/%d/edges/%s/cable/%s", strand->side.patch,
                 edge_names[strand->side.edge], member);
    }
}

double taut_film_rope_chord(const taut_film_complex *complex, int rope)
{
    const int *ends = complex->ropes[rope].ends;
    double x[2][3] = {{0, 0, 0}, {0, 0, 0}};

    if (ends[0] == ends[1]) {
        return 0;
    }
    for (int k = 0; k < 2; k++) {
        if (complex->holds[ends[k]].count < 3) {
            return 0;
        }
        taut_film_hold_onto(&complex->holds[ends[k]], x[k]);
    }
    return taut_distance(x[0], x[1]);
}

double taut_film_rope_length(const taut_film_complex *complex, int rope)
{
    const taut_film_edge *law = taut_film_rope_law(complex, rope);

    if (law->law != TAUT_FILM_SAG) {
        return law->law == TAUT_FILM_LENGTH ? law->length : 0;
    }
    /* the arc that rises by f of its chord c: tan(a / 2) = 2 f, L = c a / sin a */
    const double a = 2 * taut_atan(2 * law->sag);
    return taut_film_rope_chord(complex, rope) * a / taut_sin(a);
}

/* The nodes that a side begins and ends at, as it is run. */
static int end_of(const taut_film_complex *c, const taut_film_side *side, int end)
{
    const int last = taut_film_complex_along(&c->problem->patches[side->patch], side->edge) - 1;
    return taut_film_complex_node(c, side, end * last);
}

/* The strand that an edge, or the seam it is in, is; -1: none. */
static int strand_of(const taut_film_complex *c, const taut_film_side *side)
{
    const int seam = taut_film_complex_seam(c->problem, side->patch, side->edge);

    for (int k = 0; k < c->strand_count; k++) {
        const taut_film_strand *strand = &c->strands[k];
        if (seam >= 0 ? strand->seam == seam
                      : strand->seam < 0 && strand->side.patch == side->patch &&
                            strand->side.edge == side->edge) {
            return k;
        }
    }
    return -1;
}

/* The strands of a cable along several edges, which go on one from another. */
static taut_status take_along(taut_film_complex *c, int a, taut_error *error)
{
    const taut_film_along *along = &c->problem->along[a];
    const int rope = c->rope_count;
    char where[48];

    if (along->count < 1 || along->sides == NULL || along->edge.kind != TAUT_FILM_CABLE) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, "argument", NULL, along->count, 1,
                         "cable %d along several edges has none, or no law", a);
    }
    for (int k = 0; k < along->count; k++) {
        const taut_film_side *side = &along->sides[k];
        const int strand = strand_of(c, side);
        snprintf(where, sizeof where, "/cables/%d/along/%d", a, k);
        if (strand < 0 || c->strands[strand].edge->along != a + 1 || c->strands[strand].rope >= 0) {
            return taut_fail(error, TAUT_BAD_INPUT, "edge-conflict", where, k, taut_none,
                             "edge %.80s.%s is held, or drawn by another cable, or named twice: "
                             "leave out one of them",
                             c->problem->patches[side->patch].name, edge_names[side->edge]);
        }
        c->strands[strand].rope = rope;
        if (k > 0 && end_of(c, side, 0) != end_of(c, &along->sides[k - 1], 1)) {
            return taut_fail(error, TAUT_BAD_INPUT, "curve-ends", where, k, taut_none,
                             "edge %.80s.%s does not begin where the one before it ends: name the "
                             "edges as the cable runs, with a minus sign where it runs backwards",
                             c->problem->patches[side->patch].name, edge_names[side->edge]);
        }
    }
    c->ropes[c->rope_count++] = (taut_film_rope){
        .edge = &along->edge,
        .along = a,
        .strand = strand_of(c, &along->sides[0]),
        .ends = {end_of(c, &along->sides[0], 0), end_of(c, &along->sides[along->count - 1], 1)}};
    return TAUT_OK;
}

taut_status taut_film_ropes_find(taut_film_complex *complex, taut_arena *arena, taut_error *error)
{
    taut_film_complex *const c = complex;
    const int along = c->problem->along_count;
    taut_status status = TAUT_OK;

    c->ropes =
        taut_arena_take(arena, (size_t)c->strand_count + (size_t)along + 1, sizeof *c->ropes);
    if (c->ropes == NULL) {
        return taut_fail_memory(error);
    }
    for (int k = 0; k < c->strand_count; k++) {
        taut_film_strand *strand = &c->strands[k];
        strand->rope = -1;
        if (strand->edge->along == 0) {
            strand->rope = c->rope_count;
            c->ropes[c->rope_count++] = (taut_film_rope){
                .edge = strand->edge,
                .along = -1,
                .strand = k,
                .ends = {end_of(c, &strand->side, 0), end_of(c, &strand->side, 1)}};
        }
    }
    for (int a = 0; status == TAUT_OK && a < along; a++) {
        status = take_along(c, a, error);
    }
    for (int k = 0; status == TAUT_OK && k < c->strand_count; k++) {
        if (c->strands[k].rope < 0) {
            status =
                taut_fail(error, TAUT_BAD_ARGUMENT, "argument", NULL, c->strands[k].edge->along,
                          along, "an edge is part of a cable that does not name it");
        }
    }
    return status;
}

taut_status taut_film_ropes_check(const taut_film_complex *complex, taut_error *error)
{
    for (int k = 0; k < complex->rope_count; k++) {
        const taut_film_edge *law = taut_film_rope_law(complex, k);
        const double chord = taut_film_rope_chord(complex, k),
                     length = taut_film_rope_length(complex, k);
        char where[TAUT_FILM_ROPE_WHERE], name[TAUT_FILM_NAME];

        taut_film_rope_name(complex, k, name);
        if (taut_film_rope_is_given(law) && chord > 0 && !(length > chord)) {
            taut_film_rope_where(complex, k, law->law == TAUT_FILM_SAG ? "sag" : "length", where);
            return taut_fail(error, TAUT_NO_SOLUTION, "cable-too-short", where, length, chord,
                             "cable %s is %.17g long, expected more than the distance of its "
                             "ends, %.17g: give it more length",
                             name, length, chord);
        }
    }
    return TAUT_OK;
}
