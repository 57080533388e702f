/* panes.h -- the panes of a figure: which there are, where they stand, how large. */
#ifndef TAUT_DRAW_PANES_H
#define TAUT_DRAW_PANES_H

#include "draw/pane.h"

enum { TAUT_PANES_MAX = TAUT_MODELS_MAX };

enum { TAUT_PANES_MARGIN = 40 }; /* page units around a single pane */

typedef struct taut_panes {
    int count;
    int of;          /* so many surfaces there are to show; more than count: some are left out */
    int is_one_size; /* all of one model, at one scale of length */
    int columns;     /* 0 until they are placed, then kept */
    taut_pane pane[TAUT_PANES_MAX];
    double place[TAUT_PANES_MAX][4]; /* x0 y0 x1 y1 on the page */
} taut_panes;

/* A pane a model, or a surface where options say side_by_side: of more than TAUT_PANES_MAX so many,
 * evenly, the first and the last among them. TAUT_BAD_ARGUMENT: no surface of options->surface. */
taut_status taut_panes_new(int count, const taut_model *const *models,
                           const taut_write_options *options, taut_arena *arena, taut_panes *panes,
                           taut_error *error);
/* The surfaces of all panes. */
int taut_panes_sheets(const taut_panes *panes, const taut_write_options *options);
/* Places the sampled panes on the page x0 y0 x1 y1 and aims their cameras, all alike. 0 where
 * nothing of a model is finite. */
int taut_panes_aim(taut_panes *panes, const taut_write_options *options, const double page[4]);
/* What the aimed panes take of the page with what is around them: a page of no more is cropped to
 * its content, and aimed at again gives the same picture. */
void taut_panes_used(const taut_panes *panes, double size[2]);
/* What must be said below: steps of isolines, lengths of combs and arrows, what is left out. */
void taut_panes_note(const taut_panes *panes, const taut_write_options *options, double limit,
                     char *note, size_t size);

#endif /* TAUT_DRAW_PANES_H */
