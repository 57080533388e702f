#include "trace/curve.h"

#include "core/fail.h"
#include "core/vec3.h"
#include "geometry/keep.h"

#include <string.h>

enum { DEGREE = TAUT_QUINTIC - 1 };
/* Pieces shorter than this, over the size, become part of their neighbour; those that lath.c cuts are longer. */
static const double shortest = 2e-9;
/* Jumps, over what they are of, below which the curve counts as continuous there. */
static const double same_tangent = 1e-10, same_bend = 1e-8;

typedef struct stretch {
    taut_station from, to;
    double space[TAUT_QUINTIC][3], window[TAUT_QUINTIC][2];
} stretch;

static double jump(int dim, const double *a, const double *b)
{
    double largest = 0;
    for (int c = 0; c < dim; c++) {
        largest = fmax(largest, fabs(a[c] - b[c]));
    }
    return largest;
}

/* How often the knot between two stretches has to stand there. */
static int multiplicity(const taut_carrier *carrier, const taut_station *a, const taut_station *b,
                        int with_window)
{
    const double ab = taut_hypot(a->ab[0], a->ab[1]);
    const double bend = taut_hypot(a->bend[0], a->bend[1]) + ab / carrier->size;
    if (jump(3, a->tangent, b->tangent) > same_tangent ||
        (with_window && jump(2, a->ab, b->ab) > same_tangent * ab)) {
        return DEGREE;
    }
    if (jump(3, a->acceleration, b->acceleration) * carrier->size >
            same_bend * (1 + taut_length(a->acceleration) * carrier->size) ||
        (with_window && jump(2, a->bend, b->bend) > same_bend * bend)) {
        return DEGREE - 1;
    }
    return 3;
}

/* The blossom of a quintic on [a, b] at five arguments. */
static void blossom(int dim, const double *points, double a, double b, const double *at,
                    double *value)
{
    double work[TAUT_QUINTIC * 3];
    memcpy(work, points, (size_t)(TAUT_QUINTIC * dim) * sizeof(double));
    for (int level = 0; level < DEGREE; level++) {
        const double t = (at[level] - a) / (b - a);
        for (int k = 0; k < (DEGREE - level) * dim; k++) {
            work[k] = (1 - t) * work[k] + t * work[k + dim];
        }
    }
    memcpy(value, work, (size_t)dim * sizeof(double));
}

/* The stretches [first, last) as one spline. */
static taut_status make_part(const taut_carrier *carrier, const stretch *stretches, int first,
                             int last, int with_window, taut_arena *arena, taut_lath_part *part,
                             taut_error *error)
{
    const int pieces = last - first;
    double *knots = taut_arena_take(arena, (size_t)(DEGREE * pieces + 2 * DEGREE), sizeof *knots);
    int *piece_of = taut_arena_take(arena, (size_t)(DEGREE * pieces + 2 * DEGREE), sizeof(int));
    int count = 0;

    if (knots == NULL || piece_of == NULL) {
        return taut_fail_memory(error);
    }
    for (int k = 0; k <= pieces; k++) {
        const stretch *before = k > 0 ? &stretches[first + k - 1] : NULL;
        const stretch *after = k < pieces ? &stretches[first + k] : NULL;
        const int times = before == NULL || after == NULL
                              ? DEGREE + 1
                              : multiplicity(carrier, &before->to, &after->from, with_window);
        for (int m = 0; m < times; m++) {
            piece_of[count] = k < pieces ? k : pieces - 1; /* the piece behind the last of them */
            knots[count++] = before != NULL ? before->to.s : after->from.s;
        }
    }
    part->on = stretches[first].from.on;
    part->count = count - DEGREE - 1;
    part->space = taut_arena_take(arena, (size_t)part->count, 3 * sizeof(double));
    part->window =
        with_window ? taut_arena_take(arena, (size_t)part->count, 2 * sizeof(double)) : NULL;
    if (taut_arena_status(arena) != TAUT_OK) {
        return taut_fail_memory(error);
    }
    for (int i = 0; i < part->count; i++) {
        int j = i + DEGREE / 2; /* a knot interval that is not empty, near the middle */
        while (j < i + DEGREE && knots[j] == knots[j + 1]) {
            j++;
        }
        for (int k = i + DEGREE / 2; knots[j] == knots[j + 1] && k >= i; k--) {
            j = k;
        }
        const stretch *piece = &stretches[first + piece_of[j]];
        double point[3];
        blossom(3, piece->space[0], piece->from.s, piece->to.s, knots + i + 1, point);
        taut_carrier_point(carrier, point, part->space + 3 * (size_t)i);
        if (with_window) {
            blossom(2, piece->window[0], piece->from.s, piece->to.s, knots + i + 1,
                    part->window + 2 * (size_t)i);
        }
    }
    for (int k = 0; k < count; k++) {
        knots[k] = ldexp(knots[k], carrier->scale);
    }
    const taut_basis_spec spec = {
        .type = "bspline", .degree = DEGREE, .knot_count = count, .knots = knots};
    const taut_status status = taut_basis_new(&spec, part->count, &part->basis, error);
    if (status != TAUT_OK) {
        return status;
    }
    return taut_keep_basis(arena, part->basis) ? TAUT_OK : taut_fail_memory(error);
}

/* The segments without those too short to count, as their quintics. */
static int collect(const taut_carrier *carrier, const taut_lath *lath, stretch *stretches)
{
    const double room = shortest * carrier->size;
    int count = 0;
    const taut_station *from = NULL;
    for (int k = 0; k < lath->count; k++) {
        const taut_segment *segment = &lath->segments[k];
        from = from != NULL ? from : &segment->from;
        const int is_last = k == lath->count - 1;
        const int parts =
            !is_last && taut_station_passes_seam(&segment->to, &lath->segments[k + 1].from);
        if (segment->to.s - from->s < room && parts) { /* what goes on is on another one */
            if (count > 0 && !taut_station_passes_seam(&stretches[count - 1].to, &segment->from)) {
                stretches[count - 1].to = segment->to;
            }
            from = NULL;
            continue;
        }
        if (segment->to.s - from->s < room && !is_last) {
            continue;
        }
        if (segment->to.s - from->s < room && count > 0 &&
            !taut_station_passes_seam(&stretches[count - 1].to, &segment->from)) {
            stretches[count - 1].to = segment->to;
            from = NULL;
            continue;
        }
        stretches[count++] = (stretch){.from = *from, .to = segment->to};
        from = NULL;
    }
    for (int k = 0; k < count; k++) {
        if (k > 0) { /* between them a step may lie that was too short to count */
            stretches[k].from.s = stretches[k - 1].to.s;
        }
        const taut_segment whole = {.from = stretches[k].from, .to = stretches[k].to};
        taut_segment_space(&whole, stretches[k].space);
        taut_segment_window(&whole, stretches[k].window);
    }
    return count;
}

taut_status taut_lath_parts(const taut_carrier *carrier, const taut_lath *lath, taut_arena *arena,
                            taut_lath_part **parts, int *count, taut_error *error)
{
    stretch *stretches = taut_arena_take(arena, (size_t)lath->count + 1, sizeof *stretches);
    int seams = 0, made = 0;

    if (stretches == NULL) {
        return taut_fail_memory(error);
    }
    const int pieces = collect(carrier, lath, stretches);
    for (int k = 1; k < pieces; k++) {
        seams += taut_station_passes_seam(&stretches[k - 1].to, &stretches[k].from);
    }
    *parts = taut_arena_take(arena, (size_t)seams + 2, sizeof **parts);
    if (*parts == NULL) {
        return taut_fail_memory(error);
    }
    taut_status status =
        make_part(carrier, stretches, 0, pieces, seams == 0, arena, &(*parts)[made++], error);
    for (int k = 1, first = 0; status == TAUT_OK && seams > 0 && k <= pieces; k++) {
        if (k == pieces || taut_station_passes_seam(&stretches[k - 1].to, &stretches[k].from)) {
            status = make_part(carrier, stretches, first, k, 1, arena, &(*parts)[made++], error);
            first = k;
        }
    }
    *count = made;
    return status;
}
