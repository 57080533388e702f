#include "construct/film/witness.h"

#include "construct/film/flows.h"
#include "core/constants.h"
#include "core/elementary/elementary.h"
#include "core/vec3.h"
#include "numeric/cone.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum {
    PLACES = 9, /* each way, to begin with */
    LOOK = TAUT_FLOWS_LOOK,
    ROUNDS = 16,
    STEPS = 30,         /* of Newton's, a round */
    ROOM = 2000,        /* of places */
    EXPONENT_MOST = 500 /* beyond it the squares of lengths leave the range of doubles */
};
static const double mu_first = 1e-2, mu_falls = 0.3, mu_least = 1e-7;
static const double slack = 100;         /* times mu: what lengths lack of 1 where a round begins */
static const double near_one = 1 - 1e-6; /* lengths from which a place stands in the way */
static const double flat_share = 1e-12;  /* of the size: as certify/film/least.c has it */
static const char *const edge_names[4] = {"u0", "u1", "v0", "v1"};

typedef struct work {
    taut_flows flows;
    taut_cone cone;
    taut_pulse pulse;
    double x[TAUT_FLOWS_MOST], best[TAUT_FLOWS_MOST], best_flux;
    double lengths[LOOK][LOOK];
} work;

static int corners_lie_flat(const taut_surface *surface)
{
    const size_t nu = (size_t)taut_basis_count(taut_surface_u(surface)),
                 nv = (size_t)taut_basis_count(taut_surface_v(surface));
    const double *p = taut_surface_points(surface);
    double a[3], b[3], c[3];

    taut_difference(p + 3 * (nu - 1) * nv, p, a);
    taut_difference(p + 3 * (nv - 1), p, b);
    taut_difference(p + 3 * (nu * nv - 1), p, c);
    const double size = fmax(taut_norm(a), fmax(taut_norm(b), taut_norm(c)));
    return !(fabs(taut_det(a, b, c)) > flat_share * size * size * size);
}

static int is_fit(const taut_film_problem *problem, const taut_surface *surface)
{
    int curved = 0;

    if (problem->without_least || problem->ring != TAUT_FILM_OPEN ||
        problem->force_density[0] > 0 || problem->prestress[0] > 0) {
        return 0;
    }
    for (int e = 0; e < 4; e++) {
        if (problem->edges[e].kind == TAUT_FILM_SLIDE ||
            problem->corner_kinds[e] != TAUT_FILM_HELD) {
            return 0;
        }
        curved = curved || problem->edges[e].curve != NULL;
    }
    return curved || !corners_lie_flat(surface);
}

static void add_place(work *w, int block, double s, double t)
{
    double *rows = taut_cone_add(&w->cone, block);
    if (rows != NULL) {
        taut_flows_map(&w->flows, block, s, t, rows);
    }
}

/* Chebyshev's, with the ends. */
static void add_first(work *w)
{
    for (int block = -1; block < w->flows.cables; block++) {
        for (int k = 0; k < PLACES * PLACES; k++) {
            add_place(w, block, 0.5 - 0.5 * taut_cos(TAUT_PI * (k / PLACES) / (PLACES - 1)),
                      0.5 - 0.5 * taut_cos(TAUT_PI * (k % PLACES) / (PLACES - 1)));
        }
    }
}

/* Is it as large as all beside it? */
static int is_peak(const work *w, int a, int b)
{
    for (int i = a > 0 ? a - 1 : 0; i <= a + 1 && i < LOOK; i++) {
        for (int j = b > 0 ? b - 1 : 0; j <= b + 1 && j < LOOK; j++) {
            if (w->lengths[i][j] > w->lengths[a][b]) {
                return 0;
            }
        }
    }
    return 1;
}

/* Puts places where lengths peak; returns the largest length. */
static double add_peaks(work *w)
{
    double largest = 0;

    for (int block = -1; block < w->flows.cables; block++) {
        taut_flows_lengths(&w->flows, block, w->x, w->lengths[0]);
        for (int k = 0; k < LOOK * LOOK; k++) {
            const int a = k / LOOK, b = k % LOOK;
            largest = fmax(largest, w->lengths[a][b]);
            if (w->lengths[a][b] > near_one && is_peak(w, a, b)) {
                add_place(w, block, taut_flows_at(a), taut_flows_at(b));
            }
        }
    }
    return largest;
}

/* Keeps x, made as short as all fields allow, where it is the best so far. */
static void keep_best(work *w, double longest)
{
    double d = 0;

    for (int i = 0; i < TAUT_FLOWS_MOST; i++) {
        d += w->flows.objective[i] * w->x[i];
    }
    if (d / longest > w->best_flux) {
        w->best_flux = d / longest;
        memcpy(w->best, w->x, sizeof w->best);
    }
}

static taut_status climb(work *w)
{
    taut_status status = TAUT_OK;
    double mu = mu_first;

    add_first(w);
    for (int round = 0; status == TAUT_OK && round < ROUNDS; round++) {
        const int before = w->cone.count, is_last = mu <= mu_least;
        status = taut_cone_climb(&w->cone, w->flows.objective, mu, STEPS, w->x, &w->pulse);
        const double longest = add_peaks(w);
        keep_best(w, longest);
        if (is_last && w->cone.count == before) {
            break; /* no length is above 1 any more */
        }
        for (int i = 0; i < TAUT_FLOWS_MOST; i++) {
            w->x[i] *= (1 - fmin(slack * mu, 0.01)) / fmax(longest, 1);
        }
        mu = fmax(mu * mu_falls, mu_least);
    }
    return status == TAUT_NO_SOLUTION ? TAUT_OK : status;
}

/* ---- as the model has it: in the user's unit, over the tension ---- */

static void add_rows(taut_record *owner, const char *key, int degree_s, int degree_t,
                     const double *numbers, double unit)
{
    taut_record *rows = taut_record_add_list(owner, key);
    double row[TAUT_FLOWS_ALONG + 1];

    for (int i = 0; i <= degree_s; i++) {
        for (int j = 0; j <= degree_t; j++) {
            row[j] = numbers[(degree_t + 1) * i + j] * unit;
        }
        taut_record_add_numbers(rows, NULL, degree_t + 1, row);
    }
}

static void describe(const work *w, taut_record *details)
{
    enum { P = TAUT_FLOWS_PSI, M = TAUT_FLOWS_ALONG };
    const double unit = ldexp(1, w->flows.exponent);
    double numbers[(M + 1) * (M + 1)] = {0};
    taut_record *least = taut_record_add_object(details, "least");

    taut_record_add_numbers(least, "origin", 3, w->flows.origin);
    taut_record *frame = taut_record_add_list(least, "frame");
    for (int k = 0; k < 3; k++) {
        taut_record_add_numbers(frame, NULL, 3, w->flows.frame[k]);
    }
    add_rows(least, "quadrilateral", 3, 1, w->flows.corners[0], unit);
    memcpy(numbers + 1, w->best, ((P + 1) * (P + 1) - 1) * sizeof(double));
    add_rows(least, "psi", P, P, numbers, unit);
    memset(numbers, 0, sizeof numbers);
    memcpy(numbers + P + 1, w->best + (P + 1) * (P + 1) - 1, M * (P + 1) * sizeof(double));
    add_rows(least, "potential", M, P, numbers, unit * unit);
    taut_record *cables = taut_record_add_list(least, "cables");
    for (int k = 0; k < w->flows.cables; k++) {
        const double *own = w->best + TAUT_FLOWS_SHARED + k * TAUT_FLOWS_OWN;
        taut_record *cable = taut_record_add_object(cables, NULL);
        taut_record_add_text(cable, "edge", edge_names[w->flows.edges[k]]);
        taut_record_add_number(cable, "height", own[TAUT_FLOWS_OWN - 1] * unit);
        numbers[0] = 0;
        memcpy(numbers + 1, own, (TAUT_FLOWS_OWN - 1) * sizeof(double));
        add_rows(cable, "potential", M, M, numbers, unit * unit);
    }
}

taut_status taut_film_witness_add(const taut_film_problem *problem, const taut_surface *surface,
                                  const double radii[4], const taut_monitor *monitor,
                                  taut_record *details)
{
    taut_status status = TAUT_OK;

    if (!is_fit(problem, surface)) {
        return TAUT_OK;
    }
    taut_arena *arena = taut_arena_new();
    work *w = taut_arena_take(arena, 1, sizeof *w);
    if (w == NULL) {
        status = TAUT_NO_MEMORY;
    } else if (taut_flows_new(surface, radii, &w->flows) &&
               abs(w->flows.exponent) < EXPONENT_MOST) {
        w->pulse = (taut_pulse){.monitor = monitor, .what = "witness", .done = NAN};
        status = taut_pulse_report(&w->pulse)
                     ? TAUT_INTERRUPTED
                     : taut_cone_new(TAUT_FLOWS_SHARED, TAUT_FLOWS_OWN, w->flows.cables, ROOM,
                                     arena, &w->cone);
        if (status == TAUT_OK) {
            status = climb(w);
        }
        if (status == TAUT_OK) {
            describe(w, details);
        }
    }
    taut_arena_free(arena);
    return status;
}
