/* work.h -- what is at hand while a film is made. Private to solve.c and what tells
 * of it. */
#ifndef TAUT_CONSTRUCT_PLATEAU_WORK_H
#define TAUT_CONSTRUCT_PLATEAU_WORK_H

#include "construct/common/scaling.h"
#include "construct/plateau/trust_region.h"
#include "core/arena.h"
#include "taut/plateau.h"
#include "taut/record.h"

enum { TAUT_PLATEAU_AREAS_MAX = 64 }; /* areas of iterations that are told */

/* What is being made. */
typedef struct taut_plateau_work {
    const taut_plateau_problem *problem;
    const taut_make_options *options;
    taut_model *first; /* the Dirichlet surface */
    const taut_surface *surface;
    taut_arena *arena;
    taut_mask mask;
    taut_scaling scaling;
    taut_dirichlet_form form;
    taut_film *film;
    size_t count;
    double *net;        /* scaled */
    double *directions; /* or NULL */
    double dirichlet_area, aspect;
    taut_descent descent;
    const char *solver;
    int rule, products;
    int is_rough;  /* no rule settles on the first net */
    double change; /* of the area from one of the last rules to the next, over the area */
} taut_plateau_work;

/* The member `details`; taut_record_status tells whether memory ran out. */
taut_record *taut_plateau_details(const taut_plateau_work *work);

#endif /* TAUT_CONSTRUCT_PLATEAU_WORK_H */
