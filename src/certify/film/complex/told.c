#include "certify/film/complex/told.h"

#include "certify/film/sheet.h"
#include "problem/film_cells.h"
#include "problem/film_ropes.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const double limit = 1e-8;
/* Of forces that follow from a film at rest so much less is known: a cable that is nearly straight hardly moves it. */
static const double follows = 10;
static const char *const edge_names[4] = {"u0", "u1", "v0", "v1"};
static const char *const corner_names[4] = {"u0v0", "u1v0", "u0v1", "u1v1"};

/* What is looked at: a list of the details, and what differs most so far. */
typedef struct look {
    const taut_film_problem *problem;
    const taut_film_complex *complex;
    const taut_record *details, *figures;
    double worst;
    char where[160];
} look;

/* off: over the size; what is missing is off by all of it. */
static void take(look *l, double off, const char *list, int k, const char *member)
{
    off = isfinite(off) ? off : 1;
    if (off > l->worst) {
        l->worst = off;
        if (k < 0) {
            snprintf(l->where, sizeof l->where, "details.%s", list);
        } else {
            snprintf(l->where, sizeof l->where, "details.%s.%d%s%s", list, k, *member ? "." : "",
                     member);
        }
    }
}

static void compare_number(look *l, const taut_record *told, double found, double scale,
                           const char *list, int k, const char *member)
{
    const double at = taut_record_number(told);
    take(l, at == found ? 0 : fabs(at - found) / scale, list, k, member);
}

static void compare_text(look *l, const taut_record *told, const char *found, const char *list,
                         int k, const char *member)
{
    take(l, strcmp(taut_record_text(told), found) != 0, list, k, member);
}

static void compare_count(look *l, const taut_record *told, int count, const char *list)
{
    take(l, taut_record_count(told) != (size_t)count, list, -1, "");
}

/* ---- cables ---- */

static int cable_count(const look *l)
{
    int count = 0;
    for (int e = 0; l->complex == NULL && e < 4; e++) {
        count += l->problem->edges[e].kind == TAUT_FILM_CABLE;
    }
    return l->complex != NULL ? l->complex->rope_count : count;
}

/* The law of cable k, and its name. */
static const taut_film_edge *cable_at(const look *l, int k, char name[TAUT_FILM_NAME])
{
    int e = -1;
    if (l->complex != NULL) {
        taut_film_rope_name(l->complex, k, name);
        return taut_film_rope_law(l->complex, k);
    }
    while (k >= 0) {
        e++;
        k -= l->problem->edges[e].kind == TAUT_FILM_CABLE;
    }
    memcpy(name, edge_names[e], sizeof "u0");
    return &l->problem->edges[e];
}

static void look_along(look *l, int k, const taut_record *cable)
{
    const int which = l->complex != NULL ? l->complex->ropes[k].along : -1;
    const taut_film_along *along = which >= 0 ? &l->complex->problem->along[which] : NULL;
    const taut_record *told = taut_record_get(cable, "along");
    char name[TAUT_FILM_NAME];

    take(l, taut_record_count(told) != (size_t)(along != NULL ? along->count : 0), "cables", k,
         "along");
    for (int i = 0; along != NULL && i < along->count; i++) {
        taut_film_complex_name(l->complex->problem, along->sides[i].patch,
                               edge_names[along->sides[i].edge], name);
        compare_text(l, taut_record_at(told, (size_t)i), name, "cables", k, "along");
    }
}

static void look_at_cables(look *l)
{
    const taut_record *told = taut_record_get(l->details, "cables"),
                      *forces = taut_record_get(l->figures, "tensions"),
                      *lengths = taut_record_get(l->figures, "lengths");
    const int count = cable_count(l);
    char name[TAUT_FILM_NAME];
    double most = 0;

    compare_count(l, told, count, "cables");
    for (int k = 0; k < count; k++) {
        most = fmax(most, fabs(taut_record_number(taut_record_at(forces, (size_t)k))));
    }
    for (int k = 0; k < count; k++) {
        const taut_record *cable = taut_record_at(told, (size_t)k);
        const taut_film_edge *law = cable_at(l, k, name);
        const double force = taut_record_number(taut_record_at(forces, (size_t)k)),
                     length = taut_record_number(taut_record_at(lengths, (size_t)k));
        compare_text(l, taut_record_get(cable, "edge"), name, "cables", k, "edge");
        look_along(l, k, cable);
        compare_number(l, taut_record_get(cable, "force"), force,
                       law->law == TAUT_FILM_FORCE ? most : follows * most, "cables", k, "force");
        compare_number(l, taut_record_get(cable, "length"), length, length, "cables", k, "length");
        if (law->law == TAUT_FILM_ELASTIC || taut_record_get(cable, "unstressed") != NULL) {
            compare_number(l, taut_record_get(cable, "unstressed"), law->unstressed, length,
                           "cables", k, "unstressed");
        }
    }
}

/* ---- supports ---- */

/* Is corner k % 4 of patch k / 4 the first of its node, and held? */
static int is_support(const look *l, int k)
{
    if (l->complex == NULL) {
        return l->problem->ring == TAUT_FILM_OPEN && l->problem->corner_kinds[k] == TAUT_FILM_HELD;
    }
    const int node = taut_film_complex_corner(l->complex, k / 4, k % 4);
    for (int before = 0; before < k; before++) {
        if (taut_film_complex_corner(l->complex, before / 4, before % 4) == node) {
            return 0;
        }
    }
    return l->complex->holds[node].count == 3;
}

static void look_at_supports(look *l)
{
    const taut_record *told = taut_record_get(l->details, "supports");
    const int corners = 4 * (l->complex != NULL ? l->complex->problem->patch_count : 1);
    char name[TAUT_FILM_NAME];
    int count = 0;

    for (int k = 0; k < corners; k++) {
        if (is_support(l, k)) {
            if (l->complex != NULL) {
                taut_film_complex_name(l->complex->problem, k / 4, corner_names[k % 4], name);
            } else {
                memcpy(name, corner_names[k], sizeof "u0v0");
            }
            compare_text(l, taut_record_at(told, (size_t)count), name, "supports", count, "");
            count++;
        }
    }
    compare_count(l, told, count, "supports");
}

static void look_at_straight(look *l)
{
    const taut_record *told = taut_record_get(l->details, "held_straight");
    int count = 0;

    for (int e = 0; e < 4 && l->complex == NULL && l->problem->ring == TAUT_FILM_OPEN; e++) {
        if (l->problem->edges[e].kind == TAUT_FILM_FIXED && l->problem->edges[e].curve == NULL) {
            compare_text(l, taut_record_at(told, (size_t)count), edge_names[e], "held_straight",
                         count, "");
            count++;
        }
    }
    compare_count(l, told, count, "held_straight");
}

/* ---- what is inside ---- */

static void look_at_cells(look *l)
{
    const taut_record *told = taut_record_get(l->details, "cells"),
                      *pressures = taut_record_get(l->figures, "pressures");
    const int count = l->complex != NULL ? l->complex->problem->cell_count : 0;
    char name[TAUT_FILM_NAME];
    double most = 0;

    compare_count(l, told, count, "cells");
    for (int k = 0; k < count; k++) {
        most = fmax(most, fabs(taut_record_number(taut_record_at(pressures, (size_t)k))));
    }
    for (int k = 0; k < count; k++) {
        const taut_record *cell = taut_record_at(told, (size_t)k);
        taut_film_cell_name(l->complex->problem, k, name);
        compare_text(l, taut_record_get(cell, "name"), name, "cells", k, "name");
        compare_number(l, taut_record_get(cell, "pressure"),
                       taut_record_number(taut_record_at(pressures, (size_t)k)), most, "cells", k,
                       "pressure");
    }
}

/* Of all patches, where they have one. */
static void look_at_tension(look *l)
{
    const int many = l->complex != NULL;
    const taut_film_problem *first = many ? l->complex->problem->patches : l->problem;
    const double tension = first->tension > 0 ? first->tension : 1;
    int is_one = 1;

    for (int p = 0; p < (many ? l->complex->problem->patch_count : 1); p++) {
        is_one = is_one && !taut_film_sheet_has_threads(first + p) &&
                 (first[p].tension > 0 ? first[p].tension : 1) == tension;
    }
    compare_number(l, taut_record_get(l->details, "tension"), is_one ? tension : NAN, tension,
                   "tension", -1, "");
}

taut_status taut_film_told(const taut_model *model, const taut_film_problem *problem,
                           const taut_film_complex *complex, taut_certificate *certificate)
{
    static const struct {
        const char *name;
        void (*at)(look *);
    } looks[] = {{"tension", look_at_tension},
                 {"cables", look_at_cables},
                 {"supports", look_at_supports},
                 {"held_straight", look_at_straight},
                 {"cells", look_at_cells}};
    look l = {.problem = problem,
              .complex = complex,
              .details = taut_model_details(model),
              .figures = taut_certificate_figures(certificate)};

    for (size_t k = 0; k < sizeof looks / sizeof *looks; k++) {
        if (taut_record_get(l.details, looks[k].name) != NULL) {
            looks[k].at(&l);
        }
    }
    const taut_claim claim = {.claim = "details",
                              .kind = TAUT_CHECK,
                              .residual = l.worst,
                              .limit = limit,
                              .holds = TAUT_FALSE,
                              .where = l.where};
    return l.worst <= limit ? TAUT_OK : taut_certificate_add(certificate, &claim);
}
