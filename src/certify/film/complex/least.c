#include "certify/film/complex/least.h"

#include "certify/common/verdict.h"
#include "certify/plateau/given.h"
#include "core/constants.h"
#include "geometry/keep.h"
#include "problem/film_rim.h"
#include "taut/plateau.h"

#include <math.h>
#include <string.h>

static const double limit = 1e-6; /* of the gap: tight from there on */

typedef struct work {
    const taut_film_complex *complex;
    taut_film_rim rim;
    taut_flux_task *tasks; /* [patch_count] */
    taut_arena *arena;
} work;

/* A power of two above the largest distance of a coordinate from the first point. 0: no size. */
static int find_unit(const taut_film_complex *complex, const taut_surface *const *surfaces,
                     int *exponent)
{
    const double *origin = taut_surface_points(surfaces[0]);
    double largest = 0;

    for (int p = 0; p < complex->problem->patch_count; p++) {
        const double *points = taut_surface_points(surfaces[p]);
        for (int k = 0; k < 3 * (complex->first[p + 1] - complex->first[p]); k++) {
            largest = taut_certify_max(largest, fabs(0.5 * points[k] - 0.5 * origin[k % 3]));
        }
    }
    if (!(largest > 0) || !isfinite(largest)) {
        return 0;
    }
    (void)frexp(largest, exponent);
    *exponent += 1;
    return 1;
}

static const char *read_witness(work *w, const taut_surface *const *surfaces,
                                const taut_record *witness, const taut_crew *crew)
{
    const taut_record *patches = taut_record_get(witness, "patches");
    const int count = w->complex->problem->patch_count;
    int exponent = 0;

    if (taut_record_count(patches) != (size_t)count) {
        return "witness: it is not one of as many patches";
    }
    if (!find_unit(w->complex, surfaces, &exponent)) {
        return "range: the film has no size";
    }
    for (int p = 0; p < count; p++) {
        taut_flux_task *task = &w->tasks[p];
        *task = (taut_flux_task){
            .surface = surfaces[p], .crew = crew, .wanted = limit, .exponent = exponent};
        if (!taut_given_frame(taut_record_get(witness, "direction"), w->arena, task)) {
            return TAUT_GIVEN_NO_DIRECTION;
        }
        const char *why = taut_given_psi(taut_record_at(patches, (size_t)p), w->arena, task);
        if (why != NULL) {
            return why;
        }
    }
    return NULL;
}

/* ---- knots ---- */

/* The basis itself, or, where its breaks are evenly spread to rounding, the same on 0, 1, 2, ..: seams run either way on those
 * without rounding. NULL: memory. */
static const taut_basis *even_out(const taut_basis *basis, taut_arena *arena)
{
    const int spans = taut_basis_span_count(basis);
    const double *breaks = taut_basis_breaks(basis), lo = breaks[0], hi = breaks[spans];
    const double off = 0x1p-51 * (fabs(lo) + fabs(hi));
    taut_basis_spec spec;
    taut_basis *even = NULL;

    taut_basis_spec_of(basis, &spec);
    for (int k = 0; k <= spans; k++) {
        if (!(fabs(breaks[k] - (lo + (hi - lo) * k / spans)) <= off)) {
            return basis;
        }
    }
    double *knots = taut_arena_take(arena, (size_t)spec.knot_count, sizeof(double));
    if (knots == NULL) {
        return NULL;
    }
    for (int k = 0, span = 0; spec.knots != NULL && k < spec.knot_count; k++) {
        span += span < spans && spec.knots[k] >= breaks[span + 1];
        knots[k] = span;
    }
    spec.knots = spec.knots != NULL ? knots : NULL;
    spec.has_range = spec.knots == NULL;
    spec.range[0] = 0;
    spec.range[1] = 1;
    const taut_status status = taut_basis_new(&spec, 0, &even, NULL);
    if (status != TAUT_OK) {
        return status == TAUT_NO_MEMORY ? NULL : basis;
    }
    return taut_keep_basis(arena, even) ? even : NULL;
}

/* The film of a patch and its psi on such bases. */
static taut_status even_out_task(taut_flux_task *task, taut_arena *arena)
{
    const taut_basis *u = even_out(taut_surface_u(task->surface), arena);
    const taut_basis *v = even_out(taut_surface_v(task->surface), arena);
    taut_surface *even = NULL;

    task->u = even_out(task->u, arena);
    task->v = even_out(task->v, arena);
    if (u == NULL || v == NULL || task->u == NULL || task->v == NULL) {
        return TAUT_NO_MEMORY;
    }
    const taut_status status =
        taut_surface_new("", u, v, taut_surface_points(task->surface), NULL, &even, NULL);
    if (status == TAUT_OK && !taut_keep_surface(arena, even)) {
        return TAUT_NO_MEMORY;
    }
    task->surface = status == TAUT_OK ? even : task->surface;
    return status == TAUT_NO_MEMORY ? status : TAUT_OK;
}

/* ---- seams ---- */

static double knot_at(const taut_basis_spec *spec, const taut_basis *basis, int k)
{
    if (spec->knots != NULL) {
        return spec->knots[k];
    }
    return k <= spec->degree ? taut_basis_lo(basis) : taut_basis_hi(basis);
}

/* Is a + b the same as c + d, exactly? */
static int adds_up(double a, double b, double c, double d)
{
    const double sum = a + b, other = c + d;
    const double part = sum - a, other_part = other - c;
    const double rest = (a - (sum - part)) + (b - part);
    const double other_rest = (c - (other - other_part)) + (d - other_part);
    return sum == other && rest == other_rest;
}

/* Do both have the same functions, the second one's as it is run backwards if `reversed`? */
static int is_same_run(const taut_basis *a, const taut_basis *b, int reversed)
{
    taut_basis_spec one, other;
    const double lo = taut_basis_lo(a), hi = taut_basis_hi(a);
    const int count = taut_basis_count(a);

    taut_basis_spec_of(a, &one);
    taut_basis_spec_of(b, &other);
    if (one.degree != other.degree || count != taut_basis_count(b) || lo != taut_basis_lo(b) ||
        hi != taut_basis_hi(b)) {
        return 0;
    }
    const int last = count + one.degree;
    for (int k = 0; k <= last; k++) {
        const double t = knot_at(&one, a, k);
        const double s = knot_at(&other, b, reversed ? last - k : k);
        if (reversed ? !adds_up(t, s, lo, hi) : t != s) {
            return 0;
        }
    }
    return 1;
}

/* Where number k of an edge is among those of a net of nu x nv. */
static size_t place_of(int edge, int nu, int nv, int k)
{
    const int i = edge < 2 ? edge * (nu - 1) : k, j = edge < 2 ? k : (edge - 2) * (nv - 1);
    return (size_t)i * (size_t)nv + (size_t)j;
}

/* Numbers of two sides, `width` each, in the bases u, v of each: the same, bit for bit? */
static int are_same(const taut_film_side sides[2], const taut_basis *const bases[2][2],
                    const double *const numbers[2], size_t width)
{
    const int count = taut_basis_count(bases[0][sides[0].edge < 2]);

    for (int k = 0; k < count; k++) {
        const double *x[2];
        for (int s = 0; s < 2; s++) {
            const int nu = taut_basis_count(bases[s][0]), nv = taut_basis_count(bases[s][1]);
            const int at = sides[s].reversed ? count - 1 - k : k;
            x[s] = numbers[s] + width * place_of(sides[s].edge, nu, nv, at);
        }
        for (size_t c = 0; c < width; c++) {
            if (x[0][c] != x[1][c]) {
                return 0;
            }
        }
    }
    return 1;
}

static const char *check_seam(const work *w, const taut_film_seam *seam)
{
    const taut_film_side *sides = seam->sides;
    const taut_flux_task *one = &w->tasks[sides[0].patch], *other = &w->tasks[sides[1].patch];
    const int reversed = !sides[0].reversed != !sides[1].reversed;
    const taut_basis *const films[2][2] = {
        {taut_surface_u(one->surface), taut_surface_v(one->surface)},
        {taut_surface_u(other->surface), taut_surface_v(other->surface)}};
    const taut_basis *const psis[2][2] = {{one->u, one->v}, {other->u, other->v}};
    const double *const points[2] = {taut_surface_points(one->surface),
                                     taut_surface_points(other->surface)};
    const double *const coefficients[2] = {one->coefficients, other->coefficients};
    const int a = sides[0].edge < 2, b = sides[1].edge < 2;

    if (!is_same_run(films[0][a], films[1][b], reversed) ||
        !is_same_run(psis[0][a], psis[1][b], reversed)) {
        return "knots: those of the two sides of a seam differ, if by rounding";
    }
    return are_same(sides, films, points, 3) && are_same(sides, psis, coefficients, 1)
               ? NULL
               : "seams: the film or its witness differs on the two sides of one";
}

/* ---- the proof ---- */

/* Sums over patches. *view: what J times the sign of its patch is, 1 or -1. */
static taut_status add_patches(work *w, taut_flux_bound *all, int *view, const char **why)
{
    taut_status status = TAUT_OK;

    for (int p = 0; status == TAUT_OK && *why == NULL && p < w->complex->problem->patch_count;
         p++) {
        taut_flux_bound one = {.verdict = TAUT_FLUX_ADMITTED};
        status = taut_certify_flux(&w->tasks[p], &one);
        *why = taut_least_reason(one.verdict);
        const int seen = w->tasks[p].sign * w->rim.sign[p] > 0 ? 1 : -1;
        *view = p == 0 ? seen : *view;
        if (*why == NULL && seen != *view) {
            *why = taut_least_reason(TAUT_FLUX_FOLDS);
        }
        all->gap += one.gap;
        all->area_low += one.area_low;
        all->area_high += one.area_high;
        all->shadow += one.shadow;
    }
    all->gap *= 1 + 0x1p-40;
    all->area_low *= 1 - 0x1p-40;
    all->area_high *= 1 + 0x1p-40;
    all->shadow *= 1 - 0x1p-40;
    return status;
}

/* The boundary in turn: how far it turns back, and how far it turns. */
static taut_status run_outline(const work *w, int view, taut_outline_bound *all, double *turned)
{
    taut_outline_side *sides = taut_arena_take(w->arena, (size_t)w->rim.count, sizeof *sides);
    taut_status status = sides != NULL ? TAUT_OK : TAUT_NO_MEMORY;

    for (int k = 0; status == TAUT_OK && k < w->rim.count; k++) {
        const taut_film_side *side = &w->rim.sides[k];
        status = taut_certify_outline_side(&w->tasks[side->patch], side->edge, side->reversed,
                                           &sides[k]);
        all->turned_back += sides[k].bound.turned_back;
        all->length += sides[k].bound.length;
        *turned += sides[k].turned;
    }
    for (int k = 0; status == TAUT_OK && k < w->rim.count; k++) {
        all->turned_back +=
            taut_certify_outline_corner(&sides[k], &sides[(k + 1) % w->rim.count], view, turned);
    }
    all->turned_back *= 1 + 0x1p-40;
    all->length *= 1 + 0x1p-40;
    return status;
}

static taut_status find_bound(work *w, taut_least_finding *found)
{
    taut_flux_bound flux = {.verdict = TAUT_FLUX_ADMITTED};
    taut_outline_bound outline = {0, 0};
    double turned = 0;
    int view = 1;
    taut_status status = add_patches(w, &flux, &view, &found->why);

    if (status == TAUT_OK && found->why == NULL) {
        status = run_outline(w, view, &outline, &turned);
        if (!(fabs(view * turned - 2 * TAUT_PI) < 1)) {
            outline.turned_back = INFINITY; /* it goes round more than once */
        }
        taut_least_conclude(&flux, &outline, found);
    }
    return status;
}

taut_status taut_complex_least_of(const taut_film_complex *complex,
                                  const taut_surface *const *surfaces, const taut_record *witness,
                                  taut_pulse *pulse, taut_least_finding *found)
{
    const taut_film_problem *problem = complex->problem;
    const taut_crew crew = {.threads = 1, .pulse = pulse};
    work w = {.complex = complex, .arena = taut_arena_new()};
    taut_status status =
        w.arena != NULL ? taut_film_rim_find(complex, w.arena, &w.rim) : TAUT_NO_MEMORY;

    *found = (taut_least_finding){.why = w.rim.why};
    w.tasks = taut_arena_take(w.arena, (size_t)problem->patch_count, sizeof *w.tasks);
    if (status == TAUT_OK && w.tasks == NULL) {
        status = TAUT_NO_MEMORY;
    }
    if (found->why == NULL && complex->points > TAUT_PLATEAU_LEAST_MAX) {
        found->why = "size: more than 10000 points";
    }
    if (found->why == NULL && taut_record_kind_of(witness) != TAUT_RECORD_OBJECT) {
        found->why =
            "convex: no direction is known along which the film is a graph over a convex domain";
    }
    if (status == TAUT_OK && found->why == NULL) {
        found->why = read_witness(&w, surfaces, witness, &crew);
        status = taut_arena_status(w.arena);
    }
    for (int p = 0; status == TAUT_OK && found->why == NULL && p < problem->patch_count; p++) {
        status = even_out_task(&w.tasks[p], w.arena);
    }
    for (int s = 0; status == TAUT_OK && found->why == NULL && s < problem->seam_count; s++) {
        found->why = check_seam(&w, &problem->seams[s]);
    }
    if (status == TAUT_OK && found->why == NULL) {
        found->exponent = w.tasks[0].exponent;
        memcpy(found->direction, w.tasks[0].frame[2], sizeof found->direction);
        status = find_bound(&w, found);
    }
    taut_arena_free(w.arena);
    return status;
}
