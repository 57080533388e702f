/* tube.c -- are the surfaces the tube?
 *
 *   tube  over all surfaces: | distance from the axis - radius | / radius, where the axis is the curve
 *         and its tangent lines at the ends: a bound, for circles of one radius and of two (cover.c).
 *         With elliptic sections a check: their frame is a solution of a differential equation, not
 *         a polynomial, and what they are held against is known at places. These are eight of every
 *         span both ways; what lies between them is estimated by second differences.
 */
#include "certify/common/verdict.h"
#include "certify/pipe/sweep.h"
#include "core/vec3.h"

#include <float.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

enum {
    PER_SPAN = 8,
    DEGREE_SEEN = 5 /* of what is made, round as along; a nine-fold zero takes more */
};

/* The largest deviation gathered while surfaces are gone over. */
typedef struct deviation {
    double worst;
    char where[80];
} deviation;

static void record(deviation *d, double residual, const char *name, double u, double v)
{
    if (!(residual <= d->worst)) {
        d->worst = residual;
        snprintf(d->where, sizeof d->where, "%s, u = %.6g, v = %.6g", name, u, v);
    }
}

/* What the blend misses by at one place. */
static double blend_miss(const taut_pipe_parts *parts, double u, double v)
{
    double x[3], local[3], offset[3], foot = 0;
    int piece = 0;
    taut_surface_eval(parts->blend, u, v, 0, x);
    taut_pipe_to_local(&parts->line, x, local);
    taut_pipe_find_foot(&parts->line, local, u, &piece, &foot, offset);
    return taut_pipe_section_miss(parts, piece, foot, offset);
}

/* |a - 2 b + c|, the second difference. */
static double bend_of(double a, double b, double c)
{
    return fabs((a - b) + (c - b));
}

/* An upper estimate of |f| within half a step of sample (k, j): with its largest value there at x
 * and a Hessian H that has one sign, f(x) exceeds the sample by at most d.H d / 2, |d| at most half
 * a step each way, and |H_uv| <= sqrt(H_uu H_vv):
 *     |f| <= |f_kj| + (sqrt(a) + sqrt(b))^2 / 8,   a, b the second differences along u and along v,
 * here each the largest of the sample's and its neighbours' in its line. */
static double upper_estimate(const double *const f[PER_SPAN + 1], int around, int k, int j)
{
    double a = 0, b = 0;
    for (int i = k - 1; i <= k + 1; i++) {
        const int inner = i < 1 ? 1 : i > PER_SPAN - 1 ? PER_SPAN - 1 : i;
        a = fmax(a, bend_of(f[inner - 1][j], f[inner][j], f[inner + 1][j]));
    }
    for (int i = j + around - 1; i <= j + around + 1; i++) {
        b = fmax(b, bend_of(f[k][(i - 1) % around], f[k][i % around], f[k][(i + 1) % around]));
    }
    return fabs(f[k][j]) + (a + b + 2 * sqrt(a * b)) / 8;
}

/* Place k of those over all spans of a basis, PER_SPAN of each. */
static double place_of(const taut_basis *basis, int k)
{
    const double *breaks = taut_basis_breaks(basis) + k / PER_SPAN;
    return k == PER_SPAN * taut_basis_span_count(basis)
               ? taut_basis_hi(basis)
               : breaks[0] + (breaks[1] - breaks[0]) * (k % PER_SPAN) / PER_SPAN;
}

static taut_status record_blend(deviation *d, const taut_pipe_parts *parts)
{
    const taut_basis *u = taut_surface_u(parts->blend), *v = taut_surface_v(parts->blend);
    const int around = PER_SPAN * taut_basis_span_count(v);
    double *rows[PER_SPAN + 1];
    for (int k = 0; k <= PER_SPAN; k++) {
        rows[k] = taut_arena_take(parts->line.arena, (size_t)around, sizeof(double));
        if (rows[k] == NULL) {
            return TAUT_NO_MEMORY;
        }
    }
    for (int i = 0; i < taut_basis_span_count(u); i++) {
        for (int n = 0; n < (PER_SPAN + 1) * around; n++) {
            rows[n / around][n % around] =
                blend_miss(parts, place_of(u, PER_SPAN * i + n / around), place_of(v, n % around));
        }
        for (int n = 0; n < (PER_SPAN + 1) * around; n++) {
            record(d, upper_estimate((const double *const *)rows, around, n / around, n % around),
                   "blend", place_of(u, PER_SPAN * i + n / around), place_of(v, n % around));
        }
    }
    return TAUT_OK;
}

/* Has a surface waves that vanish at all places of a span? */
static int has_hidden_waves(const taut_surface *surface)
{
    return taut_basis_degree(taut_surface_u(surface)) > DEGREE_SEEN ||
           taut_basis_degree(taut_surface_v(surface)) > DEGREE_SEEN;
}

/* A straight pipe: distances from the tangent line, and of each ring from its place along it. */
static void record_pipe(deviation *d, const taut_pipe_parts *parts, int side)
{
    const taut_pipe_line *line = &parts->line;
    const taut_surface *pipe = parts->pipes[side];
    const taut_basis *u = taut_surface_u(pipe), *v = taut_surface_v(pipe);
    const taut_pipe_piece *piece = &line->pieces[side == 0 ? 0 : line->count - 1];
    const double *joint = piece->points[side == 0 ? 0 : piece->degree];
    const double radius = parts->radius / line->scale;
    const int around = PER_SPAN * taut_basis_span_count(v);
    for (int n = 0; n < (PER_SPAN * taut_basis_span_count(u) + 1) * around; n++) {
        const double at = place_of(u, n / around), phi = place_of(v, n % around);
        const double part = (at - taut_basis_lo(u)) / (taut_basis_hi(u) - taut_basis_lo(u));
        double x[3], local[3], foot[3], along = 0;
        taut_surface_eval(pipe, at, phi, 0, x);
        taut_pipe_to_local(line, x, local);
        taut_difference(local, joint, foot);
        along = taut_dot(foot, line->tangent[side]);
        taut_add_scaled(-along, line->tangent[side], foot);
        along -= side == 0 ? (part - 1) * parts->drawn[0] : part * parts->drawn[1];
        record(d,
               taut_certify_max(fabs(along) / radius,
                                fabs(taut_pipe_section_miss(parts, side == 0 ? 0 : line->count - 1,
                                                            side, foot))),
               side == 0 ? "pipe1" : "pipe2", at, phi);
    }
}

/* Do the rings of all three close, and go around once? */
static taut_status record_rings(deviation *d, const taut_pipe_parts *parts, double tolerance)
{
    const taut_surface *const surfaces[3] = {parts->pipes[0], parts->blend, parts->pipes[1]};
    taut_arena *const arena = taut_arena_new();
    taut_status status = TAUT_OK;
    for (int i = 0; i < 3; i++) {
        taut_pipe_sweep sweep = {.parts = parts,
                                 .surface = surfaces[i],
                                 .name = taut_surface_name(surfaces[i]),
                                 .radius = parts->radius / parts->line.scale,
                                 .tolerance = tolerance};
        taut_pipe_cover cover = {.bound = INFINITY};
        if (i == 1) {
            taut_pipe_sweep_curve(arena, parts->axis, &sweep);
        } else {
            taut_pipe_sweep_line(arena, i / 2, parts->drawn[i / 2], &sweep);
        }
        if (taut_pipe_sweep_derive(arena, &sweep)) {
            taut_pipe_cover_rings(arena, &sweep, &cover);
        }
        if (cover.fault != NULL || cover.open != NULL) {
            d->worst = taut_certify_max(d->worst, 1);
            snprintf(d->where, sizeof d->where, "%.20s: %.40s", sweep.name,
                     cover.fault != NULL ? cover.fault : cover.open);
        }
    }
    status = taut_arena_status(arena);
    taut_arena_free(arena);
    return status;
}

/* The verdict over several surfaces. */
typedef struct tube_verdict {
    taut_pipe_cover worst; /* the largest bound, the first fault, the first that is open */
    char name[32];         /* what the fault is of */
} tube_verdict;

static void add_cover(tube_verdict *all, const taut_pipe_cover *cover, const char *name)
{
    taut_pipe_cover *const worst = &all->worst;
    if (worst->fault != NULL) {
        return;
    }
    if (cover->fault != NULL || !(cover->found <= worst->found)) {
        memcpy(worst->where, cover->where, sizeof worst->where);
        worst->found = cover->found;
    }
    worst->bound = taut_certify_max(worst->bound, cover->bound);
    worst->fault = cover->fault;
    if ((cover->fault != NULL && cover->fault[0] != '\0') || worst->open == NULL) {
        snprintf(all->name, sizeof all->name, "%.31s", name);
    }
    worst->open = worst->open != NULL ? worst->open : cover->open;
}

/* False where a fault is seen, true where all is bounded, else open. */
static taut_status claim_cover(const char *name, const tube_verdict *all, double tolerance,
                               double noise, taut_certificate *certificate)
{
    const taut_pipe_cover *c = &all->worst;
    const double residual = c->fault != NULL ? taut_certify_max(c->found, 0) : c->bound;
    taut_verdict holds = taut_certify_below(c->bound, tolerance);
    char where[200];
    snprintf(where, sizeof where, "%s", c->where);
    if (c->fault != NULL) {
        holds = TAUT_FALSE;
        if (c->fault[0] != '\0') {
            snprintf(where, sizeof where, "%s: %s", c->where, c->fault);
        }
    } else if (c->open != NULL) {
        holds = TAUT_UNDECIDED;
        snprintf(where, sizeof where, "%s: %s", all->name, c->open);
    } else if (holds == TAUT_FALSE) { /* nothing beyond it was seen */
        holds = TAUT_UNDECIDED;
        snprintf(where, sizeof where, "%s",
                 c->bound <= tolerance + noise ? "rounding of the coordinates"
                                               : "the bound does not come near what is seen");
    } else if (holds == TAUT_UNDECIDED) {
        snprintf(where, sizeof where, TAUT_CERTIFY_OUT_OF_RANGE);
    }
    const taut_claim claim = {.claim = name,
                              .kind = TAUT_BOUND,
                              .residual = residual,
                              .limit = tolerance,
                              .holds = holds,
                              .where = where};
    return taut_certificate_add(certificate, &claim);
}

/* One surface about a piece of the line: piece `from` to piece `to` of it. */
static taut_status add_sweep(const taut_pipe_parts *parts, const taut_surface *surface,
                             const taut_curve *curve, double tolerance, taut_pipe_sweep *sweep,
                             taut_arena *arena, tube_verdict *all)
{
    taut_pipe_cover cover = {.bound = 0};
    taut_status status = TAUT_OK;
    taut_pipe_circle circle;
    sweep->parts = parts;
    sweep->surface = surface;
    sweep->name = taut_surface_name(surface);
    if (curve != NULL && taut_pipe_circle_of(curve, &circle)) {
        taut_pipe_cover_torus(parts, surface, &circle, tolerance, &cover);
        add_cover(all, &cover, sweep->name);
        return TAUT_OK;
    }
    sweep->radius = sweep->radius > 0 ? sweep->radius : parts->radius / parts->line.scale;
    sweep->tolerance = tolerance;
    if (curve != NULL) {
        taut_pipe_sweep_curve(arena, curve, sweep);
    }
    if (curve != NULL && parts->unlike) {
        taut_pipe_sweep_radii(arena, sweep);
    }
    if (taut_pipe_sweep_derive(arena, sweep)) {
        status = taut_pipe_cover_round(sweep, &cover);
    } else {
        cover = (taut_pipe_cover){.bound = INFINITY, .open = "its axis is out of range"};
        status = taut_arena_status(arena);
    }
    add_cover(all, &cover, sweep->name);
    return status;
}

static double tube_noise(const taut_pipe_parts *parts)
{
    return 8 * DBL_EPSILON * parts->size / parts->radius;
}

static taut_status claim_round(const taut_pipe_parts *parts, double tolerance, double *fit_error,
                               taut_certificate *certificate)
{
    const taut_pipe_line *line = &parts->line;
    taut_arena *const arena = taut_arena_new();
    tube_verdict all = {.worst = {.bound = 0}};
    taut_pipe_sweep sweep = {.from = line->pieces[0].lo, .to = line->pieces[line->count - 1].hi};
    taut_status status =
        add_sweep(parts, parts->blend, parts->axis, tolerance, &sweep, arena, &all);
    *fit_error = all.worst.fault != NULL ? all.worst.found : all.worst.bound;
    for (int side = 0; side < 2 && status == TAUT_OK; side++) {
        sweep = (taut_pipe_sweep){.parts = parts, .straight = 1};
        sweep.radius = parts->unlike ? parts->ellipses[side].a / line->scale : 0;
        taut_pipe_sweep_line(arena, side, parts->drawn[side], &sweep);
        status = add_sweep(parts, parts->pipes[side], NULL, tolerance, &sweep, arena, &all);
    }
    status = status == TAUT_OK ? taut_arena_status(arena) : status;
    taut_arena_free(arena);
    return status == TAUT_OK ? claim_cover("tube", &all, tolerance, tube_noise(parts), certificate)
                             : status;
}

taut_status taut_pipe_claim_run_tube(const char *name, const taut_pipe_parts *parts, int count,
                                     const taut_surface *const *surfaces,
                                     const taut_curve *const *curves, double tolerance,
                                     double *fit_error, taut_certificate *certificate)
{
    taut_arena *const arena = taut_arena_new();
    tube_verdict all = {.worst = {.bound = 0}};
    taut_status status = TAUT_OK;
    *fit_error = 0;
    for (int i = 0; i < count && status == TAUT_OK; i++) {
        const int is_blend = strncmp(taut_curve_name(curves[i]), "axis-blend", 10) == 0;
        taut_pipe_sweep sweep = {.from = i, .to = i + 1, .straight = !is_blend};
        const double before = all.worst.bound;
        all.worst.bound = 0;
        status = add_sweep(parts, surfaces[i], curves[i], tolerance, &sweep, arena, &all);
        *fit_error = is_blend ? taut_certify_max(*fit_error, all.worst.bound) : *fit_error;
        all.worst.bound = taut_certify_max(before, all.worst.bound);
        if (taut_crew_beat(parts->crew, TAUT_PULSE_WORK)) {
            status = TAUT_INTERRUPTED;
        }
    }
    status = status == TAUT_OK ? taut_arena_status(arena) : status;
    taut_arena_free(arena);
    return status == TAUT_OK ? claim_cover(name, &all, tolerance, tube_noise(parts), certificate)
                             : status;
}

taut_status taut_pipe_claim_tube(const taut_pipe_parts *parts, double tolerance, double *fit_error,
                                 taut_certificate *certificate)
{
    /* rounding of the control points, and of the tangent over the length of a straight pipe */
    const double noise = tube_noise(parts);
    deviation d = {.worst = 0, .where = ""};
    taut_status status = TAUT_OK;
    if (!(parts->ellipses[0].a > 0) || parts->unlike) {
        return claim_round(parts, tolerance, fit_error, certificate);
    }
    status = record_blend(&d, parts);
    *fit_error = d.worst;
    record_pipe(&d, parts, 0);
    record_pipe(&d, parts, 1);
    if (status == TAUT_OK) {
        status = record_rings(&d, parts, tolerance);
    }
    if (status != TAUT_OK) {
        return status;
    }
    if (d.worst <= tolerance &&
        (has_hidden_waves(parts->blend) || has_hidden_waves(parts->pipes[0]) ||
         has_hidden_waves(parts->pipes[1]))) {
        d.worst = INFINITY;
        snprintf(d.where, sizeof d.where, "the degree lets more than the places looked at show");
    }
    return taut_pipe_add_claim("tube", TAUT_CHECK, d.worst, tolerance, tolerance + noise, d.where,
                               certificate);
}
