/* bends.h -- the bend table of a pipe, as tube benders read it. */
#ifndef TAUT_IO_CSV_BENDS_H
#define TAUT_IO_CSV_BENDS_H

#include "core/arena.h"
#include "taut/model.h"

/* One line of the table: a point of the polygon that the tube follows, and what the bender does to come there. Angles in degrees;
 * NaN where a line has no such number. */
typedef struct taut_bend {
    double point[3];
    double length; /* straight tube before the bend, or to the end */
    double
        rotation; /* of the tube about itself before the bend, by the right hand along the flow; 0 for the first */
    double angle;  /* by which it is bent */
    double radius; /* of the middle line */
} taut_bend;

/* The lines of a run of elbows, from its beginning to its end, taken from an arena; NULL where the model is none, has a blend that is no
 * elbow at a corner, or memory ran out (which the arena knows). */
taut_bend *taut_bends_of(const taut_model *model, taut_arena *arena, size_t *count);

#endif /* TAUT_IO_CSV_BENDS_H */
