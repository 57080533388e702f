#include "certify/common/through.h"

#include "certify/common/field.h"
#include "certify/common/verdict.h"
#include "core/constants.h"
#include "core/fail.h"
#include "core/vec3.h"
#include "geometry/exponent.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { ROUNDINGS = 64, PASSES = 3 };
/* A place whose functions are, to this share of their square, those of places before. */
static const double dependent = 1e-12;
/* More than all values too small for doubles lose. */
static const double underflow = 1e-290;

/* The share of every control point in S at a place; 0 at known ones. */
typedef struct share {
    int first[2];
    double *values; /* [local of u][local of v] */
} share;

typedef struct release {
    const taut_surface *surface;
    int count, nv,
        local[2]; /* count: of shares, three of a place where points move along directions */
    int parts;    /* numbers of a point: 3, or 1 along its direction */
    share *at;
    double *gram;          /* [count][count], then its factor in the lower triangle */
    unsigned char *is_out; /* [count]: a combination of those before */
    double *mu, *part;     /* [count][parts] */
} release;

/* ---- the places ---- */

static int is_in_range(const taut_basis *basis, double t)
{
    return t >= taut_basis_lo(basis) && t <= taut_basis_hi(basis);
}

taut_status taut_certify_through_places(const taut_model *model,
                                        const taut_dirichlet_problem *problem, taut_arena *arena,
                                        taut_through **places, taut_error *error)
{
    const taut_record *list = taut_record_get(taut_model_details(model), "through");
    const size_t count = (size_t)problem->through_count;
    taut_through *made = taut_arena_take(arena, count, sizeof *made);

    if (made == NULL) {
        return taut_fail_memory(error);
    }
    for (size_t k = 0; k < count; k++) {
        const taut_record *told = k < taut_record_count(list) ? taut_record_at(list, k) : NULL;
        made[k] = problem->through[k];
        if (isnan(made[k].u)) {
            made[k].u = taut_record_number(taut_record_get(told, "u"));
            made[k].v = taut_record_number(taut_record_get(told, "v"));
        }
        if (!is_in_range(problem->u, made[k].u) || !is_in_range(problem->v, made[k].v)) {
            char where[64];
            snprintf(where, sizeof where, "/details/through/%zu", k);
            return taut_fail(error, TAUT_BAD_INPUT, "details", where, taut_none, taut_none,
                             "the model has no u and v of this point");
        }
    }
    *places = made;
    return TAUT_OK;
}

/* ---- the claim ---- */

/* Half the largest coordinate that the problem tells, and half the largest difference of one from the
 * first point to pass through: what the surface says of itself is no measure of it. */
static void find_halves(const taut_dirichlet_problem *problem, double *largest, double *size)
{
    const size_t count =
        (size_t)taut_basis_count(problem->u) * (size_t)taut_basis_count(problem->v);
    const double *origin = problem->through[0].point;

    *largest = *size = 0;
    for (size_t i = 0; i < count + (size_t)problem->through_count; i++) {
        const double *p = i < count ? problem->points + 3 * i : problem->through[i - count].point;
        for (int c = 0; (i >= count || problem->known[i]) && c < 3; c++) {
            *largest = taut_certify_max(*largest, fabs(p[c] / 2));
            *size = taut_certify_max(*size, fabs(p[c] / 2 - origin[c] / 2));
        }
    }
}

/* What the surface is at most away from a place's point, in coordinates times 2^-exponent: by its Bernstein coefficients about
 * that point, whose errors are known, and de Casteljau's algorithm, which rounds three times a level; at the place's
 * parameters to three roundings. *bound becomes it where it is larger, no number where nothing is proved. TAUT_NO_MEMORY. */
static taut_status find_bound(const taut_surface *surface, const taut_through *place, int exponent,
                              double *bound)
{
    taut_arena *arena = taut_arena_new();
    const taut_basis *const basis[2] = {taut_surface_u(surface), taut_surface_v(surface)};
    const double t[2] = {place->u, place->v};
    double weight = NAN, most = 0, s[2];
    taut_field f[4];
    int span[2], count = 0;

    for (int d = 0; d < 2; d++) {
        span[d] = taut_basis_span(basis[d], t[d]);
        const double *ends = taut_basis_breaks(basis[d]) + span[d];
        s[d] = (t[d] - ends[0]) / (ends[1] - ends[0]);
    }
    if (taut_field_of_surface(arena, surface, span[0], span[1], place->point, exponent, f, NULL) &&
        taut_arena_status(arena) == TAUT_OK) {
        count = 4;
    }
    while (count > 0) {
        const taut_field *own = &f[--count];
        const double value = taut_field_value(own, s[0], s[1]);
        const double rounding = (4 * (own->p + own->q) + 9) * TAUT_UNIT_ROUNDOFF;
        for (int k = 0; k < (own->p + 1) * (own->q + 1); k++) {
            own->a[k] = own->e[k] + rounding * fabs(own->a[k]) + underflow;
        }
        const double slip = taut_field_value(own, s[0], s[1]) * (1 + 1e-9); /* its own rounding */
        if (count == 3) {
            weight = value - slip;
        } else {
            most = taut_certify_max(most, fabs(value) + slip);
        }
    }
    const taut_status status = taut_arena_status(arena);
    taut_arena_free(arena);
    *bound = taut_certify_max(*bound, weight > 0 ? most / weight : NAN);
    return status;
}

taut_status taut_certify_add_through(const taut_surface *surface,
                                     const taut_dirichlet_problem *problem,
                                     const taut_through *places, taut_certificate *certificate)
{
    char where[64] = "";
    double largest, size, worst = 0, bound = 0;
    taut_claim claim = {.claim = "through", .kind = TAUT_CHECK, .where = where};
    taut_status status = TAUT_OK;

    find_halves(problem, &largest, &size);
    const int exponent = taut_exponent(size);
    for (int k = 0; status == TAUT_OK && k < problem->through_count; k++) {
        double x[3] = {NAN, NAN, NAN}, apart = 0;
        taut_surface_eval(surface, places[k].u, places[k].v, 0, x);
        for (int c = 0; c < 3; c++) {
            apart = taut_certify_max(apart, fabs(x[c] / 2 - places[k].point[c] / 2));
        }
        if (k == 0 || (!isnan(worst) && !(apart <= worst))) { /* what cannot be told is the worst */
            worst = apart;
            snprintf(where, sizeof where, "/through/%d", k);
        }
        status = find_bound(surface, &places[k], exponent, &bound);
    }
    const int local =
        taut_basis_local(taut_surface_u(surface)) + taut_basis_local(taut_surface_v(surface));
    claim.residual = worst == 0 ? 0 : worst / size;
    claim.limit = fmin(ROUNDINGS * local * TAUT_UNIT_ROUNDOFF * fmax(1, largest / size), 1e-6);
    claim.holds = taut_certify_below(claim.residual, claim.limit);
    bound /= 2 * ldexp(size, -exponent);
    if (taut_certify_below(bound, claim.limit) == TAUT_TRUE) {
        claim.kind = TAUT_BOUND;
        claim.holds = TAUT_TRUE;
        claim.residual = bound;
    }
    return status != TAUT_OK ? status : taut_certificate_add(certificate, &claim);
}

/* ---- the multipliers ---- */

static void fill_share(const release *r, const unsigned char *known, const taut_through *place,
                       double *const functions[2], share *to)
{
    const taut_basis *const basis[2] = {taut_surface_u(r->surface), taut_surface_v(r->surface)};
    const double *weights = taut_surface_weights(r->surface);
    const double t[2] = {place->u, place->v};
    double weight = 0;

    for (int d = 0; d < 2; d++) {
        const int span = taut_basis_span(basis[d], t[d]);
        taut_basis_eval(basis[d], span, t[d], 0, functions[d]);
        to->first[d] = taut_basis_first(basis[d], span);
    }
    for (int k = 0; k < r->local[0] * r->local[1]; k++) {
        const int a = k / r->local[1], b = k % r->local[1];
        const size_t at = (size_t)(to->first[0] + a) * (size_t)r->nv + (size_t)(to->first[1] + b);
        const double own = functions[0][a] * functions[1][b] * (weights != NULL ? weights[at] : 1);
        weight += own;
        to->values[k] = known[at] ? 0 : own;
    }
    for (int k = 0; weights != NULL && k < r->local[0] * r->local[1]; k++) {
        to->values[k] /= weight;
    }
}

/* Where number k of a share stands in the net. */
static size_t at_of(const release *r, const share *s, int k)
{
    return (size_t)(s->first[0] + k / r->local[1]) * (size_t)r->nv +
           (size_t)(s->first[1] + k % r->local[1]);
}

static double product(const release *r, const share *x, const share *y)
{
    double sum = 0;
    for (int k = 0; k < r->local[0] * r->local[1]; k++) {
        const int a = x->first[0] + k / r->local[1] - y->first[0];
        const int b = x->first[1] + k % r->local[1] - y->first[1];
        if (a >= 0 && a < r->local[0] && b >= 0 && b < r->local[1]) {
            sum += x->values[k] * y->values[a * r->local[1] + b];
        }
    }
    return sum;
}

/* Cholesky's factor, row by row, without the places that bring nothing new. */
static void factorise(release *r)
{
    const size_t n = (size_t)r->count;
    for (size_t k = 0; k < n; k++) {
        double *row = r->gram + k * n;
        const double own = row[k];
        for (size_t i = 0; i < k; i++) {
            const double *other = r->gram + i * n;
            for (size_t j = 0; j < i; j++) {
                row[i] -= row[j] * other[j];
            }
            row[i] = r->is_out[i] ? 0 : row[i] / other[i];
            row[k] -= row[i] * row[i];
        }
        r->is_out[k] = !(row[k] > dependent * own);
        row[k] = r->is_out[k] ? 1 : sqrt(row[k]);
    }
}

/* part = the multipliers of least squares for what is left of the gradient, [nu][nv][parts]. */
static void solve(release *r, const double *gradient)
{
    const size_t n = (size_t)r->count, parts = (size_t)r->parts;
    for (size_t c = 0; c < parts; c++) {
        for (size_t k = 0; k < n; k++) {
            double sum = 0;
            for (int i = 0; i < r->local[0] * r->local[1]; i++) {
                sum += r->at[k].values[i] * gradient[parts * at_of(r, &r->at[k], i) + c];
            }
            for (size_t j = 0; j < k; j++) {
                sum -= r->gram[k * n + j] * r->part[parts * j + c];
            }
            r->part[parts * k + c] = r->is_out[k] ? 0 : sum / r->gram[k * n + k];
        }
        for (size_t k = n; k-- > 0;) {
            double sum = r->part[parts * k + c];
            for (size_t j = k + 1; j < n; j++) {
                sum -= r->gram[j * n + k] * r->part[parts * j + c];
            }
            r->part[parts * k + c] = r->is_out[k] ? 0 : sum / r->gram[k * n + k];
        }
    }
}

static void take_away(release *r, double *gradient)
{
    const size_t parts = (size_t)r->parts;

    for (size_t k = 0; k < (size_t)r->count; k++) {
        for (int i = 0; i < r->local[0] * r->local[1]; i++) {
            double *g = gradient + parts * at_of(r, &r->at[k], i);
            for (size_t c = 0; c < parts; c++) {
                g[c] -= r->part[parts * k + c] * r->at[k].values[i];
            }
        }
        for (size_t c = 0; c < parts; c++) {
            r->mu[parts * k + c] += r->part[parts * k + c];
        }
    }
}

/* Each term of the sums rounds a few times, and so do the functions in it. */
static void count_roundings(const release *r, double *gross, double *held)
{
    const double times = r->count + ROUNDINGS * (r->local[0] + r->local[1]);

    *held = 0;
    for (int k = 0; k < r->count; k++) {
        double most = 0;
        for (int c = 0; c < r->parts; c++) {
            most = taut_certify_max(most, fabs(r->mu[r->parts * k + c]));
        }
        for (int i = 0; i < r->local[0] * r->local[1]; i++) {
            const double taken = most * fabs(r->at[k].values[i]);
            gross[at_of(r, &r->at[k], i)] += times * taken;
            *held = taut_certify_max(*held, taken);
        }
    }
}

/* shares[count], of place k or, along directions, of coordinate k % 3 of place k / 3. */
static void fill_shares(release *r, const unsigned char *known, const double *directions,
                        const taut_through *places, double *const functions[2], double *values)
{
    const int alive = r->local[0] * r->local[1], each = directions != NULL ? 3 : 1;

    for (int k = 0; k < r->count; k++) {
        share *to = &r->at[k];
        to->values = values + (size_t)k * (size_t)alive;
        fill_share(r, known, &places[k / each], functions, to);
        for (int i = 0; directions != NULL && i < alive; i++) {
            to->values[i] *= directions[3 * at_of(r, to, i) + (size_t)(k % 3)];
        }
        for (int j = 0; j <= k; j++) {
            r->gram[(size_t)k * (size_t)r->count + (size_t)j] = product(r, to, &r->at[j]);
        }
    }
}

static taut_status take_release(release *r, taut_arena *arena)
{
    const size_t n = (size_t)r->count;

    r->at = taut_arena_take(arena, n, sizeof *r->at);
    r->gram = taut_arena_take(arena, n * n, sizeof(double));
    r->is_out = taut_arena_take(arena, n, 1);
    r->mu = taut_arena_take(arena, n * (size_t)r->parts, sizeof(double));
    r->part = taut_arena_take(arena, n * (size_t)r->parts, sizeof(double));
    return taut_arena_status(arena);
}

static void free_gradient(release *r, double *gradient, double *gross, double *held)
{
    factorise(r);
    for (int pass = 0; pass < PASSES; pass++) {
        solve(r, gradient);
        take_away(r, gradient);
    }
    count_roundings(r, gross, held);
}

/* The parts of the gradient along directions, 0 at known points; or what is left of them put back. */
static void go_along(size_t count, const unsigned char *known, const double *directions, int back,
                     double *along, double *gradient)
{
    for (size_t i = 0; i < count; i++) {
        const double *d = directions + 3 * i;
        double *g = gradient + 3 * i;
        if (!back) {
            along[i] = known[i] ? 0 : taut_dot(d, g);
        }
        for (int c = 0; back && !known[i] && c < 3; c++) {
            g[c] = along[i] * d[c];
        }
    }
}

taut_status taut_certify_release(const taut_surface *surface, const unsigned char *known,
                                 const double *directions, const taut_through *places, int count,
                                 double *gradient, double *gross, double *held)
{
    taut_arena *arena = taut_arena_new();
    const size_t points = taut_point_count(surface);
    release r = {.surface = surface,
                 .count = directions != NULL ? 3 * count : count,
                 .parts = directions != NULL ? 1 : 3,
                 .nv = taut_basis_count(taut_surface_v(surface)),
                 .local = {taut_basis_local(taut_surface_u(surface)),
                           taut_basis_local(taut_surface_v(surface))}};
    const size_t alive = (size_t)r.local[0] * (size_t)r.local[1];
    double *const functions[2] = {taut_arena_take(arena, (size_t)r.local[0], sizeof(double)),
                                  taut_arena_take(arena, (size_t)r.local[1], sizeof(double))};
    double *values = taut_arena_take(arena, (size_t)r.count * alive, sizeof(double));
    double *along = directions != NULL ? taut_arena_take(arena, points, sizeof(double)) : gradient;
    const taut_status status = take_release(&r, arena);

    if (status == TAUT_OK) {
        fill_shares(&r, known, directions, places, functions, values);
        if (directions != NULL) {
            go_along(points, known, directions, 0, along, gradient);
        }
        free_gradient(&r, along, gross, held);
        if (directions != NULL) {
            go_along(points, known, directions, 1, along, gradient);
        }
    }
    taut_arena_free(arena);
    return status;
}
