/* told.c
 *
 *   details   what is told of each piece and seam against the certificate's own numbers: lengths, flat areas, widths and extents, which
 *             are those of the model to rounding; areas and energies, which both sum by quadrature, times 1e-3, curvature times
 *             1e-7, beside a tip 1e-8, lengths of edges on the surface, extents and strains times 1e-3, stretches times 1e-5; the largest difference, over the model's
 *             size (check). Energies and torques besides to 1e-4 of the energy. Words and numbers that repeat the document are its own; numbers
 *             of the roll, marks and hems follow from the rest. `alone`, `disagreement` and `steps` are of the way that led here: no
 *             more energy than with seams, and none below 0
 */
#include "certify/pattern/allowance.h"
#include "certify/pattern/asked.h"
#include "certify/pattern/repeats.h"
#include "certify/pattern/seams.h"
#include "certify/pattern/worst.h"
#include "core/elementary/elementary.h"
#include "core/vec3.h"
#include "numeric/quadrature.h"

#include <string.h>

enum { NODES = 8, LOOK = 16, ROUNDS = 60, PARTS = 4 /* of a span */ };
static const double details_limit = 1e-9, of_quadrature = 1e-3, of_kinks = 1e-7, of_tips = 1e-8,
                    of_places = 1e-3;
/* Of energies: to so much of themselves, and of what a strain of 1e-6 all over would cost; and how much less one may be than it is
 * where nothing is held. */
static const double of_energy = 1e-5, no_energy = 1e-12, no_torque = 1e-10, lower = 1e-6;
/* The areas of two such pieces are at most 2 sqrt 2 strains apart, but for their squares. */
static const double far = 4;
/* Of stretches, as they change between places; marks, of a seam's length: where they are, and that are one. */
static const double of_stretch = 1e-5, mark_room = 1e-9, one_mark = 2e-6;

/* A number that is told, in the model's unit to the power of `power`. */
static void compare(const taut_cloth *cloth, const taut_record *at, const char *key, int power,
                    double own, double weight, const char *name, taut_worst *w)
{
    const taut_record *told = taut_record_get(at, key);
    double whole = 1;
    for (int k = 0; k < power; k++) {
        whole *= cloth->size;
    }
    if (told == NULL) {
        taut_worst_take(w, INFINITY, key, 0);
    } else {
        const double found = ldexp(taut_record_number(told), -power * cloth->unit);
        char place[64];
        snprintf(place, sizeof place, "%.24s/%.24s", name, key);
        taut_worst_take(w, isnan(found) ? INFINITY : weight * fabs(found - own) / whole, place, 0);
    }
}

/* Of a seam in space. */
static double length_in_space(const taut_cloth *cloth, const taut_curve *line)
{
    const taut_basis *basis = taut_curve_t(line);
    const double *breaks = taut_basis_breaks(basis);
    double nodes[NODES], weights[NODES], sum = 0;
    taut_gauss_rule(NODES, nodes, weights);
    for (int i = 0; i < taut_basis_span_count(basis); i++) {
        const double half = (breaks[i + 1] - breaks[i]) / 2;
        for (int q = 0; q < NODES; q++) {
            double x[2][3];
            taut_curve_eval(line, breaks[i] + half * (1 + nodes[q]), 1, x[0]);
            sum += weights[q] * half * taut_norm(x[1]);
        }
    }
    return ldexp(sum, -cloth->unit);
}

/* The same of a number whose own size it is compared with, where that is more than `least`. */
static void compare_to_itself(const taut_cloth *cloth, const taut_record *at, const char *key,
                              int power, double own, double least, const char *name, taut_worst *w)
{
    const taut_record *told = taut_record_get(at, key);
    const double found = told != NULL ? ldexp(taut_record_number(told), -power * cloth->unit) : NAN;
    const double off = fabs(found - own) / fmax(fabs(own), least);
    char place[64];
    snprintf(place, sizeof place, "%.24s/%.24s", name, key);
    taut_worst_take(w, isnan(off) ? INFINITY : of_energy * off, place, 0);
}

static double number_at(const taut_record *list, size_t k)
{
    return taut_record_number(taut_record_at(list, k));
}

/* Two numbers of a list. */
static void compare_pair(const taut_cloth *cloth, const taut_record *at, const char *key, int power,
                         const double own[2], double weight, const char *name, taut_worst *w)
{
    const taut_record *list = taut_record_get(at, key);
    double off = taut_record_count(list) == 2 ? 0 : (double)INFINITY;
    char place[64];
    for (size_t k = 0; k < taut_record_count(list) && k < 2; k++) {
        const double away = fabs(ldexp(number_at(list, k), -power * cloth->unit) - own[k]);
        off = isnan(away) ? INFINITY : fmax(off, away / (power == 1 ? cloth->size : 1));
    }
    snprintf(place, sizeof place, "%.24s/%.24s", name, key);
    taut_worst_take(w, weight * off, place, 0);
}

static void wrong(taut_worst *w, int is_so, const char *name, const char *member)
{
    char place[64];
    snprintf(place, sizeof place, "%.24s/%.24s", name, member);
    taut_worst_take(w, is_so ? 0 : INFINITY, place, 0);
}

static const taut_record *item_named(const taut_record *list, const char *name)
{
    for (size_t k = 0; k < taut_record_count(list); k++) {
        if (strcmp(taut_record_text(taut_record_get(taut_record_at(list, k), "name")), name) == 0) {
            return taut_record_at(list, k);
        }
    }
    return NULL;
}

/* ---- extents ---- */

/* The largest of sign times coordinate d along the line that is cut, near the largest of some places. */
static double reach_of(const taut_cloth *cloth, const taut_curve *cut, int d, double sign)
{
    const taut_basis *basis = taut_curve_t(cut);
    const double *breaks = taut_basis_breaks(basis);
    double best = -INFINITY, low = 0, high = 0, y[1][3], before = taut_basis_lo(basis);
    for (int i = 0; i < taut_basis_span_count(basis) * LOOK; i++) {
        const double a = breaks[i / LOOK], b = breaks[i / LOOK + 1], step = (b - a) / LOOK;
        const double t = a + step * (i % LOOK);
        taut_cloth_line(cloth, cut, t, 0, y);
        if (sign * y[0][d] > best) {
            best = sign * y[0][d];
            low = before;
            high = fmin(t + step, taut_basis_hi(basis));
        }
        before = t;
    }
    for (int round = 0; round < ROUNDS; round++) { /* one hill between its neighbours */
        const double third[2] = {low + (high - low) / 3, high - (high - low) / 3};
        double value[2];
        for (int k = 0; k < 2; k++) {
            taut_cloth_line(cloth, cut, third[k], 0, y);
            value[k] = sign * y[0][d];
            best = fmax(best, value[k]);
        }
        *(value[0] < value[1] ? &low : &high) = third[value[0] < value[1] ? 0 : 1];
    }
    return sign * best;
}

static void compare_extent(const taut_cloth *cloth, const taut_cloth_piece *piece,
                           const taut_record *at, taut_worst *w)
{
    double own[2];
    for (int d = 0; d < 2; d++) {
        own[d] = reach_of(cloth, piece->cut, d, 1) - reach_of(cloth, piece->cut, d, -1);
    }
    compare_pair(cloth, at, "extent", 1, own, of_places, piece->name, w);
}

/* ---- pieces ---- */

static const char *const edge_names[] = {"right", "end", "left", "start"};

static int is_count(const taut_record *at)
{
    const double told = at != NULL ? taut_record_number(at) : NAN;
    return told >= 0 && told == floor(told) && told <= 1e9;
}

/* The least stiffness of the law: energies are at least half of it times the squares of the strains. */
static double softest(const double law[4])
{
    const double half = (law[0] + law[1]) / 2, apart = (law[0] - law[1]) / 2;
    return fmin(half - taut_hypot(apart, law[2]), 2 * law[3]);
}

/* What the piece was without its seams, which is not in the model: then it has no more energy; so little energy lets its area
 * change by no more than the root of both. */
static void compare_way(const taut_cloth *cloth, const taut_cloth_piece *piece,
                        const taut_cloth_state *state, const taut_record *at, taut_worst *w)
{
    const taut_record *alone = taut_record_get(at, "alone");
    const double energy =
        ldexp(taut_record_number(taut_record_get(alone, "energy")), -2 * cloth->unit);
    const double area =
        ldexp(taut_record_number(taut_record_get(alone, "flat_area")), -2 * cloth->unit);
    const double room = lower * state->energy + no_energy * state->area;
    const double strain = sqrt(2 * (state->energy + room) / (softest(cloth->law) * state->area));
    wrong(w, is_count(taut_record_get(at, "steps")), piece->name, "steps");
    wrong(w, taut_record_get(at, "developed") != NULL, piece->name, "developed");
    wrong(w, energy >= 0 && energy <= state->energy + room, piece->name, "alone/energy");
    wrong(w,
          cloth->is_conformal || fabs(area - state->flat_area) <= far * strain * state->flat_area,
          piece->name, "alone/flat_area");
    for (int e = 0; e < TAUT_CLOTH_EDGES; e++) {
        const taut_record *told = taut_record_get(alone, edge_names[e]);
        wrong(w, taut_record_number(told) >= 0, piece->name, "alone");
    }
}

static void compare_strain(const taut_cloth *cloth, const taut_cloth_piece *piece,
                           const taut_cloth_state *state, const taut_record *strain, taut_worst *w)
{
    const taut_record *place = taut_record_get(strain, "at");
    const double there =
        taut_cloth_strain_at(cloth, piece, number_at(place, 0), number_at(place, 1));
    const double largest = fmax(fabs(state->strain[0]), fabs(state->strain[1]));
    compare(cloth, strain, "min", 0, state->strain[0], of_places, piece->name, w);
    compare(cloth, strain, "max", 0, state->strain[1], of_places, piece->name, w);
    compare_pair(cloth, strain, "warp", 0, state->warp, of_places, piece->name, w);
    compare_pair(cloth, strain, "weft", 0, state->weft, of_places, piece->name, w);
    compare(cloth, strain, "shear", 0, state->shear, of_places, piece->name, w);
    const double off = largest - fabs(there);
    taut_worst_take(w, isnan(off) ? INFINITY : of_places * fabs(off), piece->name, 0);
}

static void compare_piece(const taut_cloth *cloth, const taut_cloth_piece *piece,
                          const taut_cloth_state *state, const taut_record *at, taut_worst *w)
{
    const taut_record *edges = taut_record_get(at, "edges");
    double from[3], to[3];
    taut_surface_eval(piece->flat, 0.5, 0, 0, from);
    taut_surface_eval(piece->flat, 0.5, 1, 0, to);
    compare(cloth, at, "flat_area", 2, state->flat_area, 1, piece->name, w);
    compare(cloth, at, "cut_area", 2, taut_cloth_cut_area(cloth, piece), 1, piece->name, w);
    compare(cloth, at, "width_middle", 1, taut_hypot(to[0] - from[0], to[1] - from[1]), 1,
            piece->name, w);
    compare(cloth, at, "area", 2, state->area, of_quadrature, piece->name, w);
    const int has_tip = piece->is_point[TAUT_CLOTH_START] || piece->is_point[TAUT_CLOTH_END];
    compare(cloth, at, "curvature", 0, state->curvature, has_tip ? of_tips : of_kinks, piece->name,
            w);
    compare(cloth, at, "energy", 2, state->energy, of_quadrature, piece->name, w);
    compare_to_itself(cloth, at, "energy", 2, state->energy, no_energy * state->area, piece->name,
                      w);
    compare_extent(cloth, piece, at, w);
    compare_strain(cloth, piece, state, taut_record_get(at, "strain"), w);
    compare_way(cloth, piece, state, at, w);
    if (!isnan(state->torque)) {
        compare_to_itself(cloth, at, "torque", 2, state->torque,
                          state->energy + no_torque * state->area, piece->name, w);
    }
    for (int e = 0; e < TAUT_CLOTH_EDGES; e++) {
        compare(cloth, taut_record_get(edges, edge_names[e]), "length", 1, piece->lengths[e],
                of_places, piece->name, w);
        compare(cloth, taut_record_get(edges, edge_names[e]), "flat_length", 1,
                piece->flat_lengths[e], 1, piece->name, w);
    }
}

/* ---- seams ---- */

/* Does a piece lie along a seam with this edge? */
static int is_along(const taut_cloth *cloth, const taut_cloth_piece *piece, int e, const char *seam)
{
    return piece->is_sewn[e] && strcmp(cloth->sides[piece->sides[e]].seam, seam) == 0;
}

static void widen(double range[2], double x)
{
    range[0] = taut_certify_min(range[0], x);
    range[1] = taut_certify_max(range[1], x);
}

/* Of the pieces on both sides: lengths flat, and least and largest of flat over true. */
static void look_along(const taut_cloth *cloth, const taut_cloth_side *side, double flat[2],
                       double stretch[2][2])
{
    for (int k = 0; k < 2; k++) {
        flat[k] = 0;
        stretch[k][0] = INFINITY;
        stretch[k][1] = -INFINITY;
    }
    for (int i = 0; i < cloth->piece_count * TAUT_CLOTH_EDGES; i++) {
        const taut_cloth_piece *piece = &cloth->pieces[i / TAUT_CLOTH_EDGES];
        const int e = i % TAUT_CLOTH_EDGES;
        if (!is_along(cloth, piece, e, side->seam)) {
            continue;
        }
        const int hand = !taut_cloth_is_first(cloth, piece, e);
        const int count = PARTS * taut_basis_span_count(taut_surface_u(piece->flat));
        const double part = fabs(piece->part[e][1] - piece->part[e][0]) * side->length;
        flat[hand] += piece->flat_lengths[e];
        for (int k = 0; k <= count; k++) {
            double y[2][3];
            taut_cloth_line(cloth, piece->edges[e], (double)k / count, 1, y);
            widen(stretch[hand], taut_hypot(y[1][0], y[1][1]) / part);
        }
    }
}

static double pair_off(const taut_record *list, const double own[2])
{
    return taut_record_count(list) == 2
               ? fmax(fabs(number_at(list, 0) - own[0]), fabs(number_at(list, 1) - own[1]))
               : INFINITY;
}

/* Is a mark where pieces meet on the seam, or at a multiple of the spacing? */
static int is_mark(const taut_cloth *cloth, const taut_cloth_side *side, double spacing,
                   double share)
{
    const double step = spacing / side->length;
    int is_so = step > 0 && fabs(share - step * floor(share / step + 0.5)) <= mark_room;
    for (int i = 0; i < 2 * cloth->piece_count * TAUT_CLOTH_EDGES; i++) {
        const taut_cloth_piece *piece = &cloth->pieces[i / 2 / TAUT_CLOTH_EDGES];
        const int e = i / 2 % TAUT_CLOTH_EDGES;
        const double at = piece->part[e][i % 2];
        is_so |= is_along(cloth, piece, e, side->seam) &&
                 fmin(fabs(share - at), fabs(share - (1 - at))) <= mark_room;
    }
    return is_so;
}

/* All of them in order, none missing. */
static void look_at_marks(const taut_cloth *cloth, const taut_cloth_side *side,
                          const taut_record *marks, taut_worst *w)
{
    const taut_record *told = taut_record_get(taut_model_details(cloth->model), "marks");
    const double spacing =
        told != NULL ? ldexp(taut_record_number(taut_record_get(told, "spacing")), -cloth->unit)
                     : 0;
    double last = 0;
    int is_so = 1;
    for (size_t k = 0; is_so && k <= taut_record_count(marks); k++) {
        const int is_end = k == taut_record_count(marks);
        const double share = is_end ? 1 : ldexp(number_at(marks, k), -cloth->unit) / side->length;
        is_so = share > last && share <= 1 && (is_end || is_mark(cloth, side, spacing, share)) &&
                !(spacing > 0 && share - last > spacing / side->length + one_mark);
        last = share;
    }
    wrong(w, is_so, side->seam, "marks");
}

/* The pieces beside a seam, in their order. */
static void look_at_pieces(const taut_cloth *cloth, const taut_cloth_side *side,
                           const taut_record *names, taut_worst *w)
{
    size_t found = 0;
    int is_so = 1;
    for (int k = 0; k < cloth->piece_count; k++) {
        int along = 0;
        for (int e = 0; e < TAUT_CLOTH_EDGES; e++) {
            along |= is_along(cloth, &cloth->pieces[k], e, side->seam);
        }
        if (along) {
            is_so &=
                strcmp(taut_record_text(taut_record_at(names, found)), cloth->pieces[k].name) == 0;
            found++;
        }
    }
    wrong(w, is_so && found == taut_record_count(names), side->seam, "pieces");
}

/* Between two pieces all along, of lengths that are shared: as long as both were alone, on the average; and the stretches of both
 * differ somewhere by no less than they do on the average. */
static void look_at_halves(const taut_cloth *cloth, const taut_cloth_side *side,
                           const taut_record *at, double flat_length, taut_worst *w)
{
    const taut_record *pieces = taut_record_get(taut_model_details(cloth->model), "pieces");
    const double apart = taut_record_number(taut_record_get(at, "disagreement"));
    double alone[2] = {0, 0};
    int count[2] = {0, 0};
    for (int i = 0; i < cloth->piece_count * TAUT_CLOTH_EDGES; i++) {
        const taut_cloth_piece *piece = &cloth->pieces[i / TAUT_CLOTH_EDGES];
        const int e = i % TAUT_CLOTH_EDGES;
        if (is_along(cloth, piece, e, side->seam)) {
            const int hand = !taut_cloth_is_first(cloth, piece, e);
            const taut_record *own = taut_record_get(item_named(pieces, piece->name), "alone");
            alone[hand] +=
                ldexp(taut_record_number(taut_record_get(own, edge_names[e])), -cloth->unit);
            count[hand] += fabs(piece->part[e][1] - piece->part[e][0]) == 1 ? 1 : 2;
        }
    }
    wrong(w, apart >= 0, side->seam, "disagreement");
    if (count[0] == 1 && count[1] == 1 && !cloth->is_true && !cloth->is_straight) {
        const double off = fabs((alone[0] + alone[1]) / 2 - flat_length) / cloth->size;
        taut_worst_take(w, isnan(off) ? INFINITY : of_places * off, side->seam, 2);
        wrong(w, apart >= (1 - lower) * fabs(alone[1] - alone[0]) / side->length - lower,
              side->seam, "disagreement");
    }
}

static void compare_seam(const taut_cloth *cloth, const taut_cloth_side *side,
                         const taut_record *at, taut_worst *w)
{
    const double flat_length =
        ldexp(taut_record_number(taut_record_get(at, "flat_length")), -cloth->unit);
    const taut_record *told = taut_record_get(at, "stretch");
    const double closure = ldexp(taut_record_number(taut_record_get(at, "closure")), -cloth->unit);
    double flat[2], stretch[2][2];
    look_along(cloth, side, flat, stretch);
    /* where two surfaces meet the seam is told as either of them has it */
    const double off = fmin(fabs(flat_length - flat[0]), fabs(flat_length - flat[1]));
    taut_worst_take(w, isnan(flat_length) ? INFINITY : off / cloth->size, side->seam, 0);
    const double apart = fmin(pair_off(told, stretch[0]), pair_off(told, stretch[1]));
    taut_worst_take(w, isnan(apart) ? INFINITY : of_stretch * apart, side->seam, 1);
    wrong(w, closure >= 0 && closure <= details_limit * cloth->size, side->seam, "closure");
    look_at_pieces(cloth, side, taut_record_get(at, "pieces"), w);
    look_at_halves(cloth, side, at, flat_length, w);
    look_at_marks(cloth, side, taut_record_get(at, "marks"), w);
    compare(cloth, at, "length", 1, length_in_space(cloth, side->space), 1, side->seam, w);
}

taut_status taut_cloth_add_told(const taut_cloth *cloth, const taut_cloth_state *states,
                                taut_certificate *certificate)
{
    const taut_record *details = taut_model_details(cloth->model);
    taut_worst w = {0, ""};
    for (int k = 0; k < cloth->piece_count; k++) {
        const taut_cloth_piece *piece = &cloth->pieces[k];
        compare_piece(cloth, piece, &states[k],
                      item_named(taut_record_get(details, "pieces"), piece->name), &w);
    }
    for (int k = 0; k < cloth->side_count; k++) {
        const taut_cloth_side *side = &cloth->sides[k];
        if (side->space != NULL) {
            compare_seam(cloth, side, item_named(taut_record_get(details, "seams"), side->seam),
                         &w);
        }
    }
    taut_cloth_look_at_repeats(cloth, &w);
    return taut_worst_add(&w, "details", TAUT_CHECK, details_limit, certificate);
}
