#include "construct/asymptotic/details.h"

#include "construct/asymptotic/conditions.h"

#include <math.h>

static const char *const closing_names[] = {"none", "identity", "constraint"};

static void add_edge(const taut_asymptotic_story *story, int e, taut_record *edges)
{
    const taut_quad *const quad = story->quad;
    const double sigma[2] = {taut_quad_sigma(quad, e, 0), taut_quad_sigma(quad, e, 1)};
    taut_record *const edge = taut_record_add_object(edges, taut_asymptotic_edge_name(e));
    taut_record_add_bool(edge, "straight", quad->edges[e].straight);
    if (quad->edges[e].straight) {
        return;
    }
    taut_record_add_numbers(edge, "sigma", 2, sigma);
    if (story->ribbons != NULL) {
        const taut_ribbon *const ribbon = &story->ribbons[e];
        const double torsion[2] = {taut_quad_torsion(quad, e, 0), taut_quad_torsion(quad, e, 1)};
        const double singular = taut_ribbon_singular(ribbon);
        taut_record_add_numbers(edge, "alpha", 3 * quad->degree - 4, ribbon->alpha);
        taut_record_add_numbers(edge, "beta", 2, ribbon->beta);
        taut_record_add_numbers(edge, "torsion", 2, torsion);
        taut_record_add_numbers(edge, "inflections", ribbon->inflections, ribbon->inflection);
        if (isfinite(singular)) {
            taut_record_add_number(edge, "singular_at", singular);
        }
    }
}

static void add_branches(const taut_asymptotic_story *story, taut_record *details)
{
    taut_record *const list = taut_record_add_list(details, "branches");
    char text[5];
    for (int k = 0; story->branches != NULL && k < story->branches->count; k++) {
        taut_record *const item = taut_record_add_object(list, NULL);
        taut_branch_text(story->branches->list[k].signs, text);
        taut_record_add_text(item, "branch", text);
        taut_record_add_number(item, "energy", story->branches->list[k].energy);
    }
}

taut_record *taut_asymptotic_details(const taut_asymptotic_story *story)
{
    taut_record *const details = taut_record_new();
    taut_record *edges = NULL, *corners = NULL;
    char text[5];
    int signs[4];
    for (int e = 0; e < 4; e++) {
        signs[e] = taut_quad_side(story->quad, e, 0);
    }
    taut_branch_text(signs, text);
    taut_record_add_number(details, "curve_energy", story->curve_energy);
    taut_record_add_number(details, "plate_energy", story->patch_energy);
    taut_record_add_number(details, "degree", story->patch->m);
    taut_record_add_text(details, "branch", text);
    if (story->branches != NULL) {
        taut_record_add_number(details, "unknowns", story->branches->unknowns);
        taut_record_add_text(details, "closing", closing_names[story->branches->closing]);
    }
    add_branches(story, details);
    edges = taut_record_add_object(details, "edges");
    for (int e = 0; e < 4; e++) {
        add_edge(story, e, edges);
    }
    corners = taut_record_add_object(details, "corners");
    for (int c = 0; c < 4; c++) {
        taut_record *const corner = taut_record_add_object(corners, taut_asymptotic_corner_name(c));
        taut_record_add_numbers(corner, "twist", 3, story->patch->twist[c]);
        taut_record_add_number(corner, "weight", story->patch->weight[c]);
    }
    return details;
}
