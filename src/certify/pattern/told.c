/* told.c
 *
 *   details   what is told of each piece and seam against the certificate's own numbers: lengths, flat areas and widths, which are
 *             those of the model to rounding; areas and energies, which both sum by quadrature, times 1e-6, curvature times 1e-8,
 *             lengths of edges on the surface and least and largest strains times 1e-3; the largest difference, over the model's
 *             size (check)
 */
#include "certify/pattern/allowance.h"
#include "certify/pattern/asked.h"
#include "certify/pattern/seams.h"
#include "certify/pattern/worst.h"
#include "core/elementary/elementary.h"
#include "core/vec3.h"
#include "numeric/quadrature.h"

#include <string.h>

enum { NODES = 8 };
static const double details_limit = 1e-9, of_quadrature = 1e-6, of_kinks = 1e-8, of_places = 1e-3;

/* A number that is told, in the model's unit to the power of `power`. */
static void compare(const taut_cloth *cloth, const taut_record *at, const char *key, int power,
                    double own, double weight, const char *name, taut_worst *w)
{
    const taut_record *told = taut_record_get(at, key);
    double whole = 1;
    for (int k = 0; k < power; k++) {
        whole *= cloth->size;
    }
    if (told != NULL) {
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

static void compare_piece(const taut_cloth *cloth, const taut_cloth_piece *piece,
                          const taut_cloth_state *state, const taut_record *at, taut_worst *w)
{
    static const char *const names[] = {"right", "end", "left", "start"};
    const taut_record *edges = taut_record_get(at, "edges");
    double from[3], to[3];
    taut_surface_eval(piece->flat, 0.5, 0, 0, from);
    taut_surface_eval(piece->flat, 0.5, 1, 0, to);
    compare(cloth, at, "flat_area", 2, state->flat_area, 1, piece->name, w);
    compare(cloth, at, "cut_area", 2, taut_cloth_cut_area(cloth, piece), 1, piece->name, w);
    compare(cloth, at, "width_middle", 1, taut_hypot(to[0] - from[0], to[1] - from[1]), 1,
            piece->name, w);
    compare(cloth, at, "area", 2, state->area, of_quadrature, piece->name, w);
    compare(cloth, at, "curvature", 0, state->curvature, of_kinks, piece->name, w);
    compare(cloth, at, "energy", 2, state->energy, of_quadrature, piece->name, w);
    const taut_record *strain = taut_record_get(at, "strain");
    compare(cloth, strain, "min", 0, state->strain[0], of_places, piece->name, w);
    compare(cloth, strain, "max", 0, state->strain[1], of_places, piece->name, w);
    for (int e = 0; e < TAUT_CLOTH_EDGES; e++) {
        compare(cloth, taut_record_get(edges, names[e]), "length", 1, piece->lengths[e], of_places,
                piece->name, w);
        compare(cloth, taut_record_get(edges, names[e]), "flat_length", 1, piece->flat_lengths[e],
                1, piece->name, w);
    }
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
            const taut_record *at = item_named(taut_record_get(details, "seams"), side->seam);
            compare(cloth, at, "length", 1, length_in_space(cloth, side->space), 1, side->seam, &w);
        }
    }
    return taut_worst_add(&w, "details", TAUT_CHECK, details_limit, certificate);
}
