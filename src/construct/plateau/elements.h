/* elements.h -- what each cell of some nets gives to the second derivative of their areas: construct/plateau/area.h at the state of
 * the last gradients.
 *
 * Cells are numbered net by net, row by row, and asked for in order. With more threads than one a batch of them is made
 * ahead, side by side: what a cell gives does not depend on how many there are.
 */
#ifndef TAUT_CONSTRUCT_PLATEAU_ELEMENTS_H
#define TAUT_CONSTRUCT_PLATEAU_ELEMENTS_H

#include "construct/plateau/area.h"

typedef struct taut_area_elements taut_area_elements;

/* Adds what else there is at node k of v on line `line` of a net, several threads at once. */
typedef void taut_area_beside(const void *context, int net, int line, int k, double *element);

/* For `count` nets, or such of as many functions and nodes. TAUT_NO_MEMORY. */
taut_status taut_area_elements_new(int count, const taut_area_functional *const *nets, int threads,
                                   taut_area_elements **elements);
void taut_area_elements_free(taut_area_elements *elements); /* NULL is fine */

/* Another state, from the first cell on. The nets are borrowed until the last cell. beside: NULL is fine. */
void taut_area_elements_begin(taut_area_elements *elements, const taut_area_functional *const *nets,
                              taut_area_beside *beside, const void *context);

/* The next cell's: [local][TAUT_AREA_BLOCK][wide], for functions q <= p of local; until the next is asked for. */
const double *taut_area_elements_next(taut_area_elements *elements);

/* wide, of one net: its functions alive on a cell, rounded up to vectors. */
static inline int taut_area_wide(const taut_area_functional *net)
{
    const int local = net->u.local * net->v.local;
    return (local + TAUT_AREA_PAD - 1) / TAUT_AREA_PAD * TAUT_AREA_PAD;
}

#endif /* TAUT_CONSTRUCT_PLATEAU_ELEMENTS_H */
