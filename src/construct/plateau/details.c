/* details.c -- what a film tells of how it was found. */
#include "construct/plateau/work.h"

static void add_directions(const taut_plateau_work *w, taut_record *details)
{
    taut_record *rows = taut_record_add_list(details, "directions");
    for (int i = 0; i < w->mask.nu; i++) {
        taut_record *row = taut_record_add_list(rows, NULL);
        for (int j = 0; j < w->mask.nv; j++) {
            const size_t at = (size_t)i * (size_t)w->mask.nv + (size_t)j;
            taut_record_add_numbers(row, NULL, 3, w->directions + 3 * at);
        }
    }
}

taut_record *taut_plateau_details(const taut_plateau_work *w)
{
    const taut_mask *p = &w->mask;
    taut_record *details = taut_record_new();
    const int is_normal = w->problem->method == TAUT_PLATEAU_NORMAL;

    taut_record_add_number(details, "iterations", w->descent.iterations);
    taut_record_add_number(details, "dirichlet_area",
                           taut_scaling_undo_square(&w->scaling, w->dirichlet_area));
    taut_record_add_number(details, "unknowns", (double)p->unknowns);
    taut_record_add_text(details, "known",
                         p->unknowns == 0 ? "all"
                         : p->is_interior ? "boundary"
                                          : "pattern");
    taut_record_add_text(details, "method", is_normal ? "normal" : "full");
    taut_record_add_text(details, "solver", w->solver);
    taut_record_add_number(details, "products", w->products);
    taut_record_add_number(details, "residual", w->descent.residual);
    taut_record_add_number(details, "tolerance", w->descent.tolerance);
    if (is_normal && p->unknowns > 0) {
        add_directions(w, details);
    }
    taut_record *areas = taut_record_add_list(details, "areas");
    for (int k = 0; k < w->descent.areas_count; k++) {
        taut_record_add_number(areas, NULL,
                               taut_scaling_undo_square(&w->scaling, w->descent.areas[k]));
    }
    return details;
}
