/* witness.c -- the function that shows how near a film is to the least area of all.
 *
 *     surface = scaled to about unit size (construct/common/scaling.h)
 *     e       = a direction in which it is a graph (construct/plateau/direction.h)
 *     psi     = the one of least gap (construct/plateau/climb.h), rounded to as many decimals as count
 */
#include "construct/plateau/witness.h"

#include "construct/common/scaling.h"
#include "construct/plateau/climb.h"
#include "construct/plateau/direction.h"
#include "construct/plateau/dual.h"
#include "core/arena.h"
#include "core/fail.h"
#include "core/memory.h"
#include "taut/plateau.h"

#include <math.h>
#include <string.h>

enum {
    POINTS_LARGE = 40 * 40, /* from here on psi is one degree above it, not two */
    DEGREE_MAX = 24,        /* of a film: the certificate multiplies polynomials of many degrees */
};

/* On the way. */
typedef struct work {
    taut_arena *arena;
    taut_scaling scaling;
    taut_surface *scaled;
    taut_dual dual;
    taut_dual_value value;
    double *psi, *step, *next;
    taut_plateau_witness *made;
    taut_pulse pulse;
} work;

void taut_plateau_witness_free(taut_plateau_witness *witness)
{
    if (witness != NULL) {
        taut_basis_free(witness->u);
        taut_basis_free(witness->v);
        taut_free(witness->coefficients);
        taut_free(witness->density);
        taut_free(witness);
    }
}

/* Is it a film that a witness is looked for? */
static int is_fit(const taut_surface *surface)
{
    const taut_basis *u = taut_surface_u(surface), *v = taut_surface_v(surface);
    return taut_basis_local(u) <= DEGREE_MAX + 1 && taut_basis_local(v) <= DEGREE_MAX + 1 &&
           (double)taut_basis_count(u) * taut_basis_count(v) <= TAUT_PLATEAU_LEAST_MAX;
}

/* On the breaks of a c- or h- basis: so many degrees above cubics, as smooth as they are. */
static taut_status raise_quasi(const taut_basis *basis, int more, taut_basis **raised)
{
    const int spans = taut_basis_span_count(basis), degree = 3 + more;
    const double *breaks = taut_basis_breaks(basis);
    double *knots = taut_alloc((size_t)(spans + 1) * (size_t)(degree + 1), sizeof(double));
    int count = 0;

    if (knots == NULL) {
        return TAUT_NO_MEMORY;
    }
    for (int k = 0; k <= spans; k++) {
        for (int m = 0; m < (k == 0 || k == spans ? degree + 1 : 1 + more); m++) {
            knots[count++] = breaks[k];
        }
    }
    const taut_basis_spec spec = {
        .type = "bspline", .degree = degree, .knot_count = count, .knots = knots};
    const taut_status status = taut_basis_new(&spec, 0, raised, NULL);
    taut_free(knots);
    return status;
}

taut_status taut_plateau_raise(const taut_basis *basis, int more, taut_basis **raised)
{
    taut_basis_spec spec;
    double *knots = NULL;
    int count = 0;
    taut_status status = TAUT_OK;

    if (taut_basis_degree(basis) < 0) {
        return raise_quasi(basis, more, raised);
    }
    taut_basis_spec_of(basis, &spec);
    if (spec.knots == NULL) {
        spec.degree += more;
        return taut_basis_new(&spec, 0, raised, NULL);
    }
    knots = taut_alloc((size_t)spec.knot_count * (size_t)(1 + more), sizeof(double));
    if (knots == NULL) {
        return TAUT_NO_MEMORY;
    }
    for (int k = 0; k < spec.knot_count; k++) {
        knots[count++] = spec.knots[k];
        for (int m = 0; m < more && (k + 1 == spec.knot_count || spec.knots[k + 1] > spec.knots[k]);
             m++) {
            knots[count++] = spec.knots[k];
        }
    }
    spec = (taut_basis_spec){
        .type = "bspline", .degree = spec.degree + more, .knot_count = count, .knots = knots};
    status = taut_basis_new(&spec, 0, raised, NULL);
    taut_free(knots);
    return status;
}

static taut_status scale_surface(const taut_surface *surface, work *w)
{
    const taut_basis *u = taut_surface_u(surface), *v = taut_surface_v(surface);
    const size_t count = (size_t)taut_basis_count(u) * (size_t)taut_basis_count(v);
    const double *given = taut_surface_points(surface);
    double *points = taut_arena_take(w->arena, count, 3 * sizeof(double));
    unsigned char *known = taut_arena_take(w->arena, count, 1);

    if (known == NULL) {
        return TAUT_NO_MEMORY;
    }
    memset(known, 1, count);
    w->scaling = taut_scaling_of(count, given, known);
    taut_scaling_apply(&w->scaling, count, given, NULL, points);
    return taut_surface_new("", u, v, points, taut_surface_weights(surface), &w->scaled, NULL);
}

static taut_status prepare(const taut_surface *surface, work *w)
{
    taut_plateau_witness *made = w->made;
    const int points =
        taut_basis_count(taut_surface_u(surface)) * taut_basis_count(taut_surface_v(surface));
    const int more = points < POINTS_LARGE ? 2 : 1;
    double frame[3][3];
    taut_status status = scale_surface(surface, w);

    if (status != TAUT_OK) {
        return status;
    }
    status = taut_plateau_direction(w->scaled, made->direction);
    if (status != TAUT_OK) {
        return status;
    }
    taut_plateau_frame(made->direction, frame);
    status = taut_plateau_raise(taut_surface_u(surface), more, &made->u);
    if (status == TAUT_OK) {
        status = taut_plateau_raise(taut_surface_v(surface), more, &made->v);
    }
    w->dual.pulse = &w->pulse;
    if (status == TAUT_OK) {
        status = taut_dual_new(w->scaled, made->u, made->v, frame, w->arena, &w->dual);
    }
    if (status != TAUT_OK) {
        return status;
    }
    const size_t count = (size_t)w->dual.u.count * (size_t)w->dual.v.count;
    w->psi = taut_arena_take(w->arena, count, sizeof(double));
    w->step = taut_arena_take(w->arena, count, sizeof(double));
    w->next = taut_arena_take(w->arena, count, sizeof(double));
    made->coefficients = taut_alloc(count, sizeof(double));
    made->density = taut_alloc((size_t)w->dual.u.spans * (size_t)w->dual.v.spans, sizeof(double));
    return w->next != NULL && made->coefficients != NULL && made->density != NULL ? TAUT_OK
                                                                                  : TAUT_NO_MEMORY;
}

static taut_dual_value evaluate(void *context, const double *psi)
{
    work *w = context;
    return taut_dual_evaluate(&w->dual, psi, NULL);
}

static taut_status solve(void *context, const double *psi, double *step)
{
    work *w = context;
    const taut_status status =
        psi != NULL ? taut_dual_newton(&w->dual, psi) : taut_dual_start(&w->dual, step);

    if (status == TAUT_OK && psi != NULL) {
        memcpy(step, w->dual.step, (size_t)w->dual.matrix.n * sizeof(double));
    }
    return status;
}

static taut_status find_psi(work *w)
{
    const taut_dual_climb climb = {.count = (size_t)w->dual.matrix.n,
                                   .area = w->dual.area,
                                   .flops = taut_dual_cost(&w->dual),
                                   .evaluate = evaluate,
                                   .solve = solve,
                                   .context = w,
                                   .pulse = &w->pulse};
    return taut_dual_climb_up(&climb, w->psi, w->step, w->next, &w->value);
}

/* The coefficients in the surface's unit, to the decimals that count. */
static int tell(work *w)
{
    const size_t count = (size_t)w->dual.matrix.n;
    const int exponent = w->scaling.outer + w->scaling.inner;
    const double steep = fmax(w->dual.u.spans * w->dual.u.local, w->dual.v.spans * w->dual.v.local);
    const double power = taut_dual_decimals(w->value.gap / w->dual.area, steep, exponent);

    for (size_t i = 0; i < count; i++) {
        w->made->coefficients[i] = taut_dual_round(ldexp(w->psi[i], exponent), power);
        w->next[i] = ldexp(w->made->coefficients[i], -exponent);
        if (!isfinite(w->made->coefficients[i])) {
            return 0;
        }
    }
    w->value = taut_dual_evaluate(&w->dual, w->next, w->made->density);
    w->made->gap = w->value.gap / w->dual.area;
    return w->value.steepest < 1 && isfinite(w->made->gap);
}

taut_status taut_plateau_witness_new(const taut_surface *surface, const taut_monitor *monitor,
                                     taut_plateau_witness **witness)
{
    work w = {.pulse = {.monitor = monitor, .what = "witness", .done = NAN}};
    taut_status status = TAUT_OK;

    *witness = NULL;
    if (!is_fit(surface)) {
        return TAUT_OK;
    }
    if (taut_pulse_report(&w.pulse)) {
        return TAUT_INTERRUPTED;
    }
    w.arena = taut_arena_new();
    w.made = taut_alloc_zero(1, sizeof *w.made);
    status = w.arena != NULL && w.made != NULL ? prepare(surface, &w) : TAUT_NO_MEMORY;
    if (status == TAUT_OK) {
        status = find_psi(&w);
    }
    const int is_told = status == TAUT_OK && tell(&w);
    if (status == TAUT_OK && taut_pulse_report(&w.pulse)) { /* to free the dual is work as well */
        status = TAUT_INTERRUPTED;
    }
    if (status == TAUT_OK && is_told) {
        *witness = w.made;
        w.made = NULL;
    }
    taut_dual_clear(&w.dual);
    taut_surface_free(w.scaled);
    taut_arena_free(w.arena);
    taut_plateau_witness_free(w.made);
    return status == TAUT_NO_MEMORY || status == TAUT_INTERRUPTED ? status : TAUT_OK;
}

taut_status taut_plateau_witness_fail(taut_status status, taut_error *error)
{
    return status == TAUT_INTERRUPTED
               ? taut_fail(error, TAUT_INTERRUPTED, "interrupted", NULL, taut_none, taut_none,
                           "stopped before there was a witness")
               : taut_fail_memory(error);
}

static void describe_basis(const taut_basis *basis, const char *key, taut_record *least)
{
    taut_basis_spec spec;
    taut_record *one = taut_record_add_object(least, key);

    taut_basis_spec_of(basis, &spec);
    taut_record_add_text(one, "type", spec.type);
    taut_record_add_number(one, "degree", spec.degree);
    if (spec.knots != NULL) {
        taut_record_add_numbers(one, "knots", spec.knot_count, spec.knots);
    } else if (spec.has_range) {
        taut_record_add_numbers(one, "range", 2, spec.range);
    }
}

void taut_plateau_describe_psi(const taut_basis *u, const taut_basis *v, const double *coefficients,
                               taut_record *record)
{
    const int nu = taut_basis_count(u), nv = taut_basis_count(v);

    describe_basis(u, "u", record);
    describe_basis(v, "v", record);
    taut_record *rows = taut_record_add_list(record, "coefficients");
    for (int i = 0; i < nu; i++) {
        taut_record_add_numbers(rows, NULL, nv, coefficients + (size_t)i * (size_t)nv);
    }
}

void taut_plateau_witness_describe(const taut_plateau_witness *witness, taut_record *details)
{
    taut_record *least = taut_record_add_object(details, "least");

    taut_record_add_numbers(least, "direction", 3, witness->direction);
    taut_plateau_describe_psi(witness->u, witness->v, witness->coefficients, least);
}
