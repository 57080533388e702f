/* film.c -- derivatives of a film by its corners, its held points and the laws of its cables.
 *
 *     R(x, r) = A_x + sum r_k L_k,x = 0     along every move x of the net that is allowed,
 *     c_k(L_k, r_k) = 0                     force r - f, length L - l, elastic r - k (L - l)
 *
 * r the forces of cables over the tension, and so for F(x, r) with the adjoints l and m_k
 *
 *     H l + sum_k m_k c_k,L L_k,x = F_x,    L_k,x . l + m_k c_k,r = F_r,
 *     dF/dq = F_q - R_q . l - sum_k m_k c_k,q,      R_q = H_xq at held points q
 *
 * Nets that go around are on periodic functions, whose copies are one unknown, or one held point.
 *
 * H is solved with, the 4 x 4 system of the m_k is what is left. Along the film H is as small as the
 * discretisation lets it be: F_x is as small there, and steps by factors of a little more than H are
 * repeated until they change nothing.
 */
#include "construct/film/equilibrium.h"
#include "construct/film/freedom.h"
#include "construct/gradient/gradient.h"
#include "construct/plateau/hessian_band.h"
#include "core/elementary/elementary.h"
#include "core/fail.h"
#include "core/vec3.h"
#include "problem/film_complex.h"
#include "problem/problem.h"

#include <math.h>
#include <string.h>

enum { CABLES = 4, RULES = 6, REPEATS = 200 };

/* What decides: shares. */
static const struct {
    double elsewhere; /* of the size: a held point is where the problem has it */
    double rest;      /* of the largest derivative in the net: what may be left along a move */
    double settled;   /* two rules agree on the energy */
    double solved;    /* what a solve may leave of its right side */
    double theta;     /* of the metric: in the factors of H */
    double theta_most;
} limits = {.elsewhere = 1e-9,
            .rest = 1e-6,
            .settled = 1e-13,
            .solved = 1e-11,
            .theta = 1e-9,
            .theta_most = 1e-3};

/* A law as its problem has it, in the unit of the scaled net. */
typedef struct law {
    double by_length, by_force; /* c_L, c_r */
} law;

typedef struct pulling {
    const taut_film_gradient_request *request;
    taut_film_problem problem; /* on the bases of the model */
    taut_film_space space;
    taut_film_work work;
    taut_area_hessian *hessian;
    size_t count;
    double unit; /* of the net, in the user's */
    double *net, *slope,
        *area;            /* [nu][nv][3]: the film; derivatives of energy and area at every point */
    double *pull[CABLES]; /* dL of cables, at every point */
    double *answer[CABLES]; /* H^-1 dL */
    double *right, *rest;   /* F_x, then l; scratch */
    int edges[CABLES], cables;
    law laws[CABLES];
    double ratios[CABLES], lengths[CABLES];
    double adjoint[CABLES]; /* m_k */
} pulling;

static double dot(size_t size, const double *a, const double *b)
{
    double sum = 0;
    for (size_t i = 0; i < size; i++) {
        sum += a[i] * b[i];
    }
    return sum;
}

static double largest(size_t size, const double *a)
{
    double most = 0;
    for (size_t i = 0; i < size; i++) {
        most = fmax(most, fabs(a[i]));
    }
    return most;
}

/* ---- the film at rest ---- */

/* The cables' dL and lengths at the net. */
static void find_pulls(pulling *p)
{
    for (int k = 0; k < p->cables; k++) {
        taut_area_cable *cable = &p->work.cables[k];
        memset(p->pull[k], 0, 3 * p->count * sizeof(double));
        cable->tension = 1;
        cable->stiffness = 0;
        p->lengths[k] = taut_area_cable_gradient(cable, p->net, p->pull[k]);
    }
}

/* A_x, of the area and of what counts in its place. */
static void find_areas(pulling *p)
{
    taut_area_functional *f = p->work.functional;
    taut_area_density *const density = f->density;

    f->cable_count = 0;
    f->density = NULL;
    taut_area_functional_gradient(f, p->net, p->area);
    f->density = density;
    taut_area_functional_gradient(f, p->net, p->slope);
    f->cable_count = p->cables;
}

/* Gaussian elimination with the largest pivot: x = a^-1 x. 0 where a is singular. */
static int solve_small(int n, double a[CABLES][CABLES], double *x)
{
    for (int k = 0; k < n; k++) {
        int pivot = k;
        for (int i = k + 1; i < n; i++) {
            pivot = fabs(a[i][k]) > fabs(a[pivot][k]) ? i : pivot;
        }
        if (!(fabs(a[pivot][k]) > 0)) {
            return 0;
        }
        for (int j = 0; j < n; j++) {
            const double held = a[k][j];
            a[k][j] = a[pivot][j];
            a[pivot][j] = held;
        }
        const double held = x[k];
        x[k] = x[pivot];
        x[pivot] = held;
        for (int i = k + 1; i < n; i++) {
            const double share = a[i][k] / a[k][k];
            for (int j = k; j < n; j++) {
                a[i][j] -= share * a[k][j];
            }
            x[i] -= share * x[k];
        }
    }
    for (int k = n - 1; k >= 0; k--) {
        for (int j = k + 1; j < n; j++) {
            x[k] -= a[k][j] * x[j];
        }
        x[k] /= a[k][k];
    }
    return 1;
}

/* Forces that are multipliers: those that leave least of the derivative along the moves. */
static int find_multipliers(pulling *p)
{
    double small[CABLES][CABLES], x[CABLES], *rows[CABLES];
    int which[CABLES], found = 0;

    for (int k = 0; k < p->cables; k++) {
        if (p->problem.edges[p->edges[k]].law == TAUT_FILM_LENGTH ||
            p->problem.edges[p->edges[k]].law == TAUT_FILM_SAG) {
            rows[found] = p->answer[k];
            memcpy(rows[found], p->pull[k], 3 * p->count * sizeof(double));
            taut_mask_reduce(&p->space.mask, rows[found]);
            which[found++] = k;
        }
    }
    memcpy(p->rest, p->slope, 3 * p->count * sizeof(double));
    for (int k = 0; k < p->cables; k++) {
        for (size_t i = 0; i < 3 * p->count; i++) {
            p->rest[i] += p->ratios[k] * p->pull[k][i];
        }
    }
    taut_mask_reduce(&p->space.mask, p->rest);
    for (int k = 0; k < found; k++) {
        x[k] = -dot(3 * p->count, rows[k], p->rest);
        for (int m = 0; m < found; m++) {
            small[k][m] = dot(3 * p->count, rows[k], rows[m]);
        }
    }
    if (found > 0 && !solve_small(found, small, x)) {
        return 0;
    }
    for (int k = 0; k < found; k++) {
        p->ratios[which[k]] = x[k];
    }
    return 1;
}

/* Forces and laws, and the state of the functional at the net under them. */
static int find_laws(pulling *p)
{
    for (int k = 0; k < p->cables; k++) {
        const taut_film_edge *edge = &p->problem.edges[p->edges[k]];
        const taut_film_cable *cable = &p->space.cables[p->edges[k]];
        p->ratios[k] = 0;
        p->laws[k] = (law){.by_length = 1};
        if (edge->law == TAUT_FILM_FORCE) {
            p->ratios[k] = p->space.ratios[p->edges[k]];
            p->laws[k] = (law){.by_force = 1};
        } else if (edge->law == TAUT_FILM_ELASTIC) {
            p->ratios[k] = fmax(0, cable->stiffness * (p->lengths[k] - cable->target));
            p->laws[k] = (law){.by_length = -cable->stiffness, .by_force = 1};
        }
    }
    if (!find_multipliers(p)) {
        return 0;
    }
    for (int k = 0; k < p->cables; k++) {
        p->work.cables[k].tension = p->ratios[k];
    }
    taut_area_functional_gradient(p->work.functional, p->net, p->slope);
    return 1;
}

static taut_status check_rest(pulling *p, taut_error *error)
{
    memcpy(p->rest, p->slope, 3 * p->count * sizeof(double));
    taut_mask_reduce(&p->space.mask, p->rest);
    const double all = largest(3 * p->count, p->slope), left = largest(3 * p->count, p->rest);

    if (left <= limits.rest * all) {
        return TAUT_OK;
    }
    return taut_fail(error, TAUT_NO_SOLUTION, "not-at-rest", NULL, left / all, limits.rest,
                     "the film is not at rest: what is left of its derivative is %.3g of the "
                     "largest, expected at most %.3g",
                     left / all, limits.rest);
}

static taut_status take_memory(pulling *p, taut_arena *arena, taut_error *error)
{
    double **nets[] = {&p->net, &p->slope, &p->area, &p->right, &p->rest};

    for (size_t k = 0; k < sizeof nets / sizeof *nets; k++) {
        *nets[k] = taut_arena_take(arena, p->count, 3 * sizeof(double));
    }
    for (int k = 0; k < CABLES; k++) {
        p->pull[k] = taut_arena_take(arena, p->count, 3 * sizeof(double));
        p->answer[k] = taut_arena_take(arena, p->count, 3 * sizeof(double));
    }
    return taut_arena_status(arena) == TAUT_OK ? TAUT_OK : taut_fail_memory(error);
}

static int is_held(const pulling *p, size_t i)
{
    return p->space.known[i] && (p->space.leader == NULL || p->space.leader[i] == (int)i);
}

/* Line by line along which the net goes around. */
static void go_around(const pulling *p, void (*turn)(const taut_loop *, size_t, double *),
                      double *net)
{
    const int along_u = p->problem.ring == TAUT_FILM_RING_U;
    const size_t nv = (size_t)p->space.nv, lines = (size_t)(along_u ? p->space.nv : p->space.nu);

    for (size_t k = 0; p->space.around != NULL && k < lines; k++) {
        turn(p->space.around, along_u ? nv : 1, net + 3 * (along_u ? k : k * nv));
    }
}

/* right at what is held, with what its copies have, 0 elsewhere. */
static void keep_held(const pulling *p, double *right)
{
    for (size_t i = 0; p->space.leader != NULL && i < p->count; i++) {
        if (p->space.leader[i] != (int)i) {
            taut_add_scaled(1, right + 3 * i, right + 3 * p->space.leader[i]);
        }
    }
    for (size_t i = 0; i < p->count; i++) {
        if (!is_held(p, i)) {
            memset(right + 3 * i, 0, 3 * sizeof(double));
        }
    }
}

/* The net of the model, which is held where the problem holds it. */
static taut_status take_net(pulling *p, const taut_surface *surface, taut_error *error)
{
    const double *given = taut_surface_points(surface);
    double *points = p->rest;

    memcpy(points, p->space.points, 3 * p->count * sizeof(double));
    go_around(p, taut_loop_clamp, points);
    for (size_t i = 0; i < p->count; i++) {
        const size_t of = p->space.leader != NULL ? (size_t)p->space.leader[i] : i;
        if (is_held(p, of) &&
            !(taut_distance(points + 3 * i, given + 3 * i) <= limits.elsewhere * p->space.size)) {
            return taut_fail(error, TAUT_BAD_ARGUMENT, "other-model", NULL, taut_none, taut_none,
                             "the model is not the one of this problem: a held point is elsewhere");
        }
    }
    memcpy(points, given, 3 * p->count * sizeof(double));
    go_around(p, taut_loop_unclamp, points);
    taut_scaling_apply(&p->space.scaling, p->count, points, NULL, p->net);
    return TAUT_OK;
}

/* A rule that the next agrees with, and the film at rest by it. */
static taut_status settle_rule(pulling *p, taut_error *error)
{
    double before = INFINITY, after = 0;

    for (int rule = 0; rule < RULES; rule++) {
        if (taut_film_take_rule(&p->work, rule, 1) != TAUT_OK) {
            return taut_fail_memory(error);
        }
        after = taut_area_functional_value(p->work.functional, p->net).area;
        if (fabs(after - before) <= limits.settled * after) {
            break;
        }
        before = after;
    }
    p->cables = p->work.functional->cable_count;
    memcpy(p->edges, p->work.edges, sizeof p->edges);
    find_pulls(p);
    find_areas(p);
    if (!find_laws(p)) {
        return taut_gradient_refuse("cables of given length can do nothing here", error);
    }
    return check_rest(p, error);
}

/* ---- the adjoint ---- */

static taut_status factor(pulling *p, taut_error *error)
{
    int negative = 0;

    if (taut_area_hessian_new(p->work.functional, &p->space.mask, &p->hessian) != TAUT_OK) {
        return taut_fail_memory(error);
    }
    taut_area_hessian_assemble(p->hessian, p->work.functional);
    for (double theta = limits.theta; theta <= limits.theta_most; theta *= 10) {
        const taut_status status = taut_area_hessian_factor_any(p->hessian, theta, NULL, &negative);
        if (status == TAUT_INTERRUPTED) {
            return taut_fail_status(error, status);
        }
        if (status == TAUT_OK && negative == 0) {
            return TAUT_OK;
        }
    }
    return taut_fail(error, TAUT_NO_SOLUTION, "saddle", NULL, negative, 0,
                     "the second derivative of the energy is not positive");
}

/* x = H^-1 x along the moves, by the factors of a little more than H. */
static void solve(pulling *p, double *x, double *right, double *image)
{
    taut_area_functional *f = p->work.functional;
    double before = INFINITY;

    taut_mask_reduce(&p->space.mask, x);
    memcpy(right, x, 3 * p->count * sizeof(double));
    const double all = largest(3 * p->count, right);
    memset(x, 0, 3 * p->count * sizeof(double));
    memcpy(image, right, 3 * p->count * sizeof(double));
    for (int k = 0; k < REPEATS; k++) { /* image: what is left */
        const double left = largest(3 * p->count, image);
        if (!(left > limits.solved * all) || !(left < before)) {
            break;
        }
        before = left;
        taut_area_hessian_solve(p->hessian, image);
        taut_mask_follow(&p->space.mask, image);
        for (size_t i = 0; i < 3 * p->count; i++) {
            x[i] += image[i];
        }
        memset(image, 0, 3 * p->count * sizeof(double));
        taut_area_functional_product(f, 0, x, image);
        taut_mask_reduce(&p->space.mask, image);
        for (size_t i = 0; i < 3 * p->count; i++) {
            image[i] = right[i] - image[i];
        }
    }
}

/* l and m_k of the number whose derivatives are in `right` and by_force. */
static taut_status find_adjoint(pulling *p, const double *by_force, double *image, double *kept,
                                taut_error *error)
{
    double small[CABLES][CABLES];

    solve(p, p->right, kept, image);
    for (int k = 0; k < p->cables; k++) {
        memcpy(p->answer[k], p->pull[k], 3 * p->count * sizeof(double));
        solve(p, p->answer[k], kept, image);
    }
    for (int k = 0; k < p->cables; k++) {
        p->adjoint[k] = by_force[k] - dot(3 * p->count, p->pull[k], p->right);
        for (int m = 0; m < p->cables; m++) {
            small[k][m] = (k == m ? p->laws[k].by_force : 0) -
                          p->laws[m].by_length * dot(3 * p->count, p->pull[k], p->answer[m]);
        }
    }
    if (!solve_small(p->cables, small, p->adjoint)) {
        return taut_fail(error, TAUT_NO_SOLUTION, "saddle", NULL, taut_none, taut_none,
                         "the laws of the cables leave their forces open");
    }
    for (int k = 0; k < p->cables; k++) {
        for (size_t i = 0; i < 3 * p->count; i++) {
            p->right[i] -= p->adjoint[k] * p->laws[k].by_length * p->answer[k][i];
        }
    }
    return TAUT_OK;
}

/* ---- the numbers ---- */

static size_t corner_at(const pulling *p, int c)
{
    return (size_t)(c % 2 * (p->space.nu - 1)) * (size_t)p->space.nv +
           (size_t)(c / 2 * (p->space.nv - 1));
}

/* A reaction is what the energy changes by with its corner, the other way: right = -H d, by_force = -L_k,x . d. */
static void begin_reaction(pulling *p, double *by_force)
{
    const size_t at = corner_at(p, p->request->corner);

    memset(p->rest, 0, 3 * p->count * sizeof(double));
    p->rest[3 * at + (size_t)p->request->axis] = -1;
    taut_area_functional_product(p->work.functional, 0, p->rest, p->right);
    for (int k = 0; k < p->cables; k++) {
        by_force[k] = -p->pull[k][3 * at + (size_t)p->request->axis];
    }
}

/* right = F_x at every point, by_force = F_r, of all but the energy, in the unit of the scaled net. */
static void begin_number(pulling *p, double *by_force)
{
    const taut_film_gradient_request *request = p->request;

    memset(by_force, 0, CABLES * sizeof(double));
    memset(p->right, 0, 3 * p->count * sizeof(double));
    if (request->of == TAUT_FILM_GRADIENT_AREA) {
        memcpy(p->right, p->area, 3 * p->count * sizeof(double));
    }
    for (int k = 0; k < p->cables; k++) {
        if (request->of == TAUT_FILM_GRADIENT_LENGTH && p->edges[k] == request->edge) {
            memcpy(p->right, p->pull[k], 3 * p->count * sizeof(double));
        } else if (request->of == TAUT_FILM_GRADIENT_TENSION && p->edges[k] == request->edge) {
            by_force[k] = 1;
        }
    }
    if (request->of == TAUT_FILM_GRADIENT_REACTION) {
        begin_reaction(p, by_force);
    }
}

/* What the number is worth in the user's unit: lengths by p->unit, forces by s p->unit. */
static double worth(const pulling *p)
{
    const double s = taut_film_tension(&p->problem);

    switch (p->request->of) {
    case TAUT_FILM_GRADIENT_AREA:
        return p->unit * p->unit;
    case TAUT_FILM_GRADIENT_LENGTH:
        return p->unit;
    case TAUT_FILM_GRADIENT_ENERGY:
        return s * p->unit * p->unit;
    case TAUT_FILM_GRADIENT_TENSION:
    case TAUT_FILM_GRADIENT_REACTION:
        break;
    }
    return s * p->unit;
}

/* right = dF/dq at held points q, 0 elsewhere. */
static void find_points(pulling *p, const double *given, double *image)
{
    memset(image, 0, 3 * p->count * sizeof(double));
    taut_area_functional_product(p->work.functional, 0, p->right, image);
    for (int k = 0; k < p->cables; k++) {
        for (size_t i = 0; i < 3 * p->count; i++) {
            image[i] += p->adjoint[k] * p->laws[k].by_length * p->pull[k][i];
        }
    }
    for (size_t i = 0; i < 3 * p->count; i++) {
        p->right[i] = given[i] - image[i];
    }
    keep_held(p, p->right);
}

/* ---- what a user gave ---- */

/* L over the chord of an arc that rises by sag times it, and its derivative. */
static void arc_by_sag(double sag, double *length, double *slope)
{
    const double a = 2 * taut_atan(2 * sag), by_sag = 4 / (1 + 4 * sag * sag);
    const double s = taut_sin(a), c = taut_cos(a);
    *length = a / s;
    *slope = by_sag * (s - a * c) / (s * s);
}

/* Of law k: what is given of it. m = dF/d(-c). A sag moves its corners' derivatives too: the chord is part of its law. */
static void add_law(const pulling *p, int k, double m, taut_film_slopes *slopes)
{
    const int e = p->edges[k];
    const taut_film_edge *edge = &p->problem.edges[e];
    const taut_film_cable *cable = &p->space.cables[e];
    const double s = taut_film_tension(&p->problem), longer = p->lengths[k] / cable->target - 1;
    double length, slope, along[3];

    switch (edge->law) {
    case TAUT_FILM_FORCE:
        slopes->laws[e] = m / (s * p->unit);
        return;
    case TAUT_FILM_LENGTH:
        slopes->laws[e] = m / p->unit;
        return;
    case TAUT_FILM_ELASTIC: /* the force is EA (L / L_0 - 1) */
        slopes->laws[e] = -m * edge->stiffness / s * p->lengths[k] /
                          (cable->target * cable->target) / p->unit / p->unit;
        slopes->stiffness[e] = m * longer / (s * p->unit);
        return;
    case TAUT_FILM_SAG:
        break;
    }
    const int from = taut_film_corner_of(e, 0), to = taut_film_corner_of(e, 1);
    taut_difference(p->space.corners[to], p->space.corners[from], along);
    const double chord = taut_norm(along);
    arc_by_sag(edge->sag, &length, &slope);
    slopes->laws[e] = m * chord / p->unit * slope;
    taut_add_scaled(m / p->unit * length / chord, along, slopes->corners[to]);
    taut_add_scaled(-m / p->unit * length / chord, along, slopes->corners[from]);
}

/* Corners by what their points and those of straight edges do. */
static void add_corners(const pulling *p, const double *points, taut_film_slopes *slopes)
{
    const int nu = p->space.nu, nv = p->space.nv;

    for (int c = 0; c < 4; c++) {
        taut_add_scaled(1, points + 3 * corner_at(p, c), slopes->corners[c]);
    }
    for (int e = 0; e < 4; e++) {
        const taut_film_edge *edge = &p->problem.edges[e];
        size_t first = 0, step = 0;
        int count = 0;
        taut_film_edge_points(nu, nv, e, &first, &step, &count);
        for (int k = 1; k < count - 1 && edge->kind == TAUT_FILM_FIXED && edge->curve == NULL;
             k++) {
            const double *x = points + 3 * (first + (size_t)k * step);
            const double share = p->space.greville[e < 2][k];
            taut_add_scaled(1 - share, x, slopes->corners[taut_film_corner_of(e, 0)]);
            taut_add_scaled(share, x, slopes->corners[taut_film_corner_of(e, 1)]);
        }
    }
    for (int c = 0; c < 4; c++) {
        const int is_given =
            p->problem.has_corner[c] && p->problem.corner_kinds[c] == TAUT_FILM_HELD;
        for (int k = 0; k < 3 && !is_given; k++) {
            slopes->corners[c][k] = 0;
        }
    }
}

/* right: dF/dq in the unit of the scaled net; m: dF / -dc. */
static taut_status hand_over(const pulling *p, const double m[CABLES], taut_film_slopes *slopes,
                             taut_error *error)
{
    taut_film_slopes found = {.points = slopes->points};
    const double w = worth(p);

    for (size_t i = 0; i < 3 * p->count; i++) {
        p->rest[i] = w / p->unit * p->right[i];
    }
    if (p->space.around == NULL) {
        add_corners(p, p->rest, &found);
    }
    go_around(p, taut_loop_unclamp_slopes, p->rest);
    for (int k = 0; k < p->cables; k++) {
        add_law(p, k, w * m[k], &found);
    }
    int finite = isfinite(dot(3 * p->count, p->rest, p->rest));
    for (int c = 0; c < 4; c++) {
        finite =
            finite && isfinite(taut_norm(found.corners[c]) + found.laws[c] + found.stiffness[c]);
    }
    if (!finite) {
        return taut_gradient_refuse("a derivative is beyond the range of double precision", error);
    }
    if (slopes->points != NULL) {
        memcpy(slopes->points, p->rest, 3 * p->count * sizeof(double));
    }
    *slopes = found;
    return TAUT_OK;
}

/* The energy at rest changes with what is given alone; m: by lengths -r, by forces L. */
static taut_status pull_energy(pulling *p, taut_film_slopes *slopes, taut_error *error)
{
    double m[CABLES];

    memcpy(p->right, p->slope, 3 * p->count * sizeof(double));
    keep_held(p, p->right);
    for (int k = 0; k < p->cables; k++) {
        const taut_film_edge *edge = &p->problem.edges[p->edges[k]];
        m[k] = edge->law == TAUT_FILM_FORCE ? p->lengths[k] : -p->ratios[k];
    }
    taut_status status = hand_over(p, m, slopes, error);
    for (int k = 0; k < p->cables && status == TAUT_OK; k++) { /* EA (L - L_0)^2 / (2 L_0) */
        const int e = p->edges[k];
        const taut_film_edge *edge = &p->problem.edges[e];
        if (edge->law == TAUT_FILM_ELASTIC) {
            const double longer = fmax(0, p->lengths[k] * p->unit / edge->unstressed - 1);
            slopes->laws[e] = -edge->stiffness * longer * (1 + longer / 2);
            slopes->stiffness[e] = longer * longer * edge->unstressed / 2;
        }
    }
    return status;
}

static taut_status pull(pulling *p, taut_arena *arena, taut_film_slopes *slopes, taut_error *error)
{
    double *image = taut_arena_take(arena, p->count, 3 * sizeof(double));
    double *kept = taut_arena_take(arena, p->count, 3 * sizeof(double));
    double *given = taut_arena_take(arena, p->count, 3 * sizeof(double));
    double by_force[CABLES];

    if (p->request->of == TAUT_FILM_GRADIENT_ENERGY) {
        return pull_energy(p, slopes, error);
    }
    if (taut_arena_status(arena) != TAUT_OK) {
        return taut_fail_memory(error);
    }
    begin_number(p, by_force);
    memcpy(given, p->right, 3 * p->count * sizeof(double));
    taut_status status = factor(p, error);
    status = status == TAUT_OK ? find_adjoint(p, by_force, image, kept, error) : status;
    if (status != TAUT_OK) {
        return status;
    }
    find_points(p, given, image);
    return hand_over(p, p->adjoint, slopes, error);
}

/* ---- the request ---- */

static taut_status check_request(const taut_film_problem *problem,
                                 const taut_film_gradient_request *request, taut_error *error)
{
    const int of_cable =
        request->of == TAUT_FILM_GRADIENT_LENGTH || request->of == TAUT_FILM_GRADIENT_TENSION;

    if (request->of < TAUT_FILM_GRADIENT_ENERGY || request->of > TAUT_FILM_GRADIENT_REACTION ||
        request->edge < 0 || request->edge > 3 || request->corner < 0 || request->corner > 3 ||
        request->axis < 0 || request->axis > 2) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, "argument", NULL, taut_none, taut_none,
                         "a film has no such number, edge, corner or axis");
    }
    if (of_cable && problem->edges[request->edge].kind != TAUT_FILM_CABLE) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, "argument", NULL, taut_none, taut_none,
                         "edge %s has no cable", taut_film_edge_names[request->edge]);
    }
    if (request->of == TAUT_FILM_GRADIENT_REACTION &&
        (problem->ring != TAUT_FILM_OPEN ||
         problem->corner_kinds[request->corner] != TAUT_FILM_HELD)) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, "argument", NULL, taut_none, taut_none,
                         "corner %s is not held", taut_film_corner_names[request->corner]);
    }
    return TAUT_OK;
}

static taut_status check_kind(const taut_film_problem *problem, taut_error *error)
{
    if (taut_film_is_complex(problem)) {
        return taut_gradient_refuse(
            "films of many patches or with cells have no derivatives yet: give "
            "one patch, open or a ring",
            error);
    }
    if (problem->updates > 0) {
        return taut_gradient_refuse(
            "a reference that is updated moves with the film: leave updates out, "
            "and give the last reference",
            error);
    }
    if (problem->method != TAUT_FILM_FULL) {
        return taut_gradient_refuse("with the method \"normal\" the film is not at rest in all "
                                    "coordinates of its net: take \"full\"",
                                    error);
    }
    return TAUT_OK;
}

static taut_status open_space(pulling *p, const taut_surface *surface, taut_arena *arena,
                              taut_error *error)
{
    taut_status status = TAUT_OK;

    p->problem.u = taut_surface_u(surface); /* finer, where it was refined */
    p->problem.v = taut_surface_v(surface);
    p->problem.refine = 0;
    p->problem.start = NULL;
    status = taut_film_space_new(&p->problem, arena, &p->space, error);
    if (status != TAUT_OK) {
        return status;
    }
    p->count = p->space.count;
    p->unit = ldexp(1, p->space.scaling.outer + p->space.scaling.inner);
    p->work = (taut_film_work){.space = &p->space, .monitor = &p->request->monitor};
    taut_film_start_laws(&p->work, 1);
    status = take_memory(p, arena, error);
    return status == TAUT_OK ? take_net(p, surface, error) : status;
}

static int is_of(const taut_film_problem *problem, const taut_surface *surface)
{
    return surface != NULL && taut_surface_weights(surface) == NULL &&
           (problem->refine > 0 || (taut_basis_equal(problem->u, taut_surface_u(surface)) &&
                                    taut_basis_equal(problem->v, taut_surface_v(surface))));
}

taut_status taut_film_gradient(const taut_film_problem *problem, const taut_model *model,
                               const taut_film_gradient_request *request, taut_film_slopes *slopes,
                               taut_error *error)
{
    static const taut_film_gradient_request none;

    if (problem == NULL || model == NULL || slopes == NULL) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, "argument", NULL, taut_none, taut_none,
                         "a gradient needs a problem, its model and a place");
    }
    pulling p = {.request = request != NULL ? request : &none, .problem = *problem};
    const taut_surface *surface = taut_model_surface(model, 0);
    taut_status status = check_kind(problem, error);

    status = status == TAUT_OK ? check_request(problem, p.request, error) : status;
    if (status != TAUT_OK) {
        return status;
    }
    if (!is_of(problem, surface)) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, "other-model", NULL, taut_none, taut_none,
                         "the model is not the one of this problem: its net is another");
    }
    taut_arena *arena = taut_arena_new();
    status = open_space(&p, surface, arena, error);
    status = status == TAUT_OK ? settle_rule(&p, error) : status;
    status = status == TAUT_OK ? pull(&p, arena, slopes, error) : status;
    taut_area_hessian_free(p.hessian);
    taut_film_drop_rule(&p.work);
    taut_arena_free(arena);
    return status;
}

taut_status taut_gradient_of_film(const taut_problem *problem, const taut_model *model,
                                  const taut_film_gradient_request *request,
                                  taut_film_slopes *slopes, taut_error *error)
{
    if (problem == NULL || problem->construct != TAUT_CONSTRUCT_INDEX_film) {
        return taut_gradient_refuse("this is a gradient of films, and the problem is no film: call "
                                    "taut_gradient (Python: taut.gradient)",
                                    error);
    }
    return taut_film_gradient(problem->data, model, request, slopes, error);
}
