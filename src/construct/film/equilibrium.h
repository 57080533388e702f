/* equilibrium.h -- a film at rest: one minimisation, with given forces, from a net that is given. */
#ifndef TAUT_CONSTRUCT_FILM_EQUILIBRIUM_H
#define TAUT_CONSTRUCT_FILM_EQUILIBRIUM_H

#include "construct/film/polish.h"
#include "construct/film/space.h"
#include "construct/plateau/density.h"
#include "construct/plateau/trust_region.h"
#include "taut/monitor.h"

/* What a cable does for now: a force, or more with its length (construct/plateau/cable.h). */
typedef struct taut_film_pull {
    double force, stiffness, target;
} taut_film_pull;

typedef struct taut_film_work {
    const taut_film_space *space;
    const taut_monitor *monitor;
    int threads;
    taut_pulse pulse;  /* tells it of factors, outside of minimisations, which have their own */
    taut_arena *arena; /* of a solve */
    taut_dirichlet_form form;
    taut_area_functional *functional;
    taut_area_density density; /* where threads are drawn */
    taut_surface *reference;   /* of the update at hand, or NULL */
    taut_area_cable cables[4];
    int edges[4];           /* of the cables */
    taut_film_pull laws[4]; /* of edges */
    double strength;        /* how much stronger than asked for they are now */
    taut_film_cable now[4]; /* what the cables are given, so strong */
    int rule;
    double *net;
    taut_trust_region region;
    int iterations; /* of all films on the way */
    int begun;      /* those that led to the net at hand, of the next of them */
    taut_film_memory memory;
    double any;      /* residual of all coordinates after the last steps along the moves */
    double enough;   /* residual along the moves that the last steps need not go below */
    int seeks;       /* do they go to any rest, minimum or not? */
    int is_definite; /* did the last step along the moves find no eigenvalue below 0? */
    int negative;    /* eigenvalues below 0 of the film; -1: not known */
    const char *method;
} taut_film_work;

/* What the cables do at the start, `strength` times as strong as they are: a force so often, a given length with its excess over
 * the chord so often smaller, squared, an elastic one so much shorter that the force of its arc is so often what it was. */
void taut_film_start_laws(taut_film_work *w, double strength);

/* Between the ends of edge e, where it starts, scaled. */
double taut_film_chord(const taut_film_space *space, int e);

/* The length of cable e of given length, so strong, scaled. */
double taut_film_strong_length(const taut_film_space *space, int e, double strength);

/* The functional of a rule, all forces `factor` times what they are. TAUT_NO_MEMORY. */
taut_status taut_film_take_rule(taut_film_work *w, int rule, double factor);
/* The same with so many nodes on a span beyond the functions alive there. */
taut_status taut_film_take_nodes(taut_film_work *w, int extra, double factor);
void taut_film_drop_rule(taut_film_work *w);

/* Between what is long, minimisations aside, which report by themselves. TAUT_INTERRUPTED as the monitor says. */
taut_status taut_film_report(taut_film_work *w, taut_error *error);

/* w->net: the film that it goes to with all cables `factor` times as strong as they are. TAUT_NOT_CONVERGED: folds,
 * not-converged; TAUT_NO_SOLUTION, TAUT_INTERRUPTED, TAUT_NO_MEMORY. */
taut_status taut_film_rest(taut_film_work *w, double factor, taut_error *error);

/* A few steps more along the moves, of a film that is nearly at rest: w->region.residual. TAUT_NOT_CONVERGED: folds, not-converged;
 * TAUT_INTERRUPTED, TAUT_NO_MEMORY. */
taut_status taut_film_polish_again(taut_film_work *w, taut_error *error);

/* w->net: the film at rest that Newton's steps lead to, at most so many, minimum or not, with the forces that are given.
 * TAUT_NOT_CONVERGED: they lead to none. *at: of it. TAUT_INTERRUPTED, TAUT_NO_MEMORY. */
taut_status taut_film_rest_any(taut_film_work *w, int steps, taut_film_rest_point *at,
                               taut_error *error);
/* Of w->net, lengths given. TAUT_INTERRUPTED, TAUT_NO_MEMORY. */
taut_status taut_film_judge(taut_film_work *w, taut_film_rest_point *at);

/* The error of an attempt becomes that of the whole. */
static inline taut_status taut_film_pass_on(const taut_error *inner, taut_error *error)
{
    if (error != NULL) {
        *error = *inner;
    }
    return inner->status;
}

/* A cable whose own length, so far as the film draws it (scaled), is more than that. */
taut_status taut_film_refuse_slack(const taut_film_space *space, int e, double length,
                                   taut_error *error);

#endif /* TAUT_CONSTRUCT_FILM_EQUILIBRIUM_H */
