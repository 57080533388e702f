#include "construct/plateau/space.h"

#include "construct/common/curve_fit.h"
#include "core/fail.h"
#include "core/memory.h"
#include "core/vec3.h"
#include "geometry/keep.h"

#include <math.h>
#include <string.h>

static const double value_clamped = 1e-12; /* of a function that is 1 at its end */
/* Corners of two curves are one when they are this close, over the size of the boundary. */
static const double gap_meeting = 1e-9;
static const char *const edge_names[4] = {"u0", "u1", "v0", "v1"};

void taut_plateau_space_free(taut_plateau_space *space)
{
    if (space != NULL) {
        taut_arena_free(space->arena);
        taut_free(space);
    }
}

/* A copy of the basis that lives as long as the space. */
static taut_status own_basis(taut_plateau_space *space, const taut_basis *basis,
                             const taut_basis **own)
{
    taut_basis *copy = NULL;

    if (taut_basis_copy(basis, &copy) != TAUT_OK || !taut_keep_basis(space->arena, copy)) {
        return TAUT_NO_MEMORY;
    }
    *own = copy;
    return TAUT_OK;
}

int taut_plateau_knows_boundary(const taut_dirichlet_problem *net)
{
    const int nu = taut_basis_count(net->u), nv = taut_basis_count(net->v);
    int is_so = 1;
    for (int i = 0; i < nu; i++) {
        for (int j = 0; j < nv; j++) {
            const int on_edge = i == 0 || j == 0 || i == nu - 1 || j == nv - 1;
            is_so &= (net->known[(size_t)i * (size_t)nv + (size_t)j] != 0) == on_edge;
        }
    }
    return is_so;
}

/* Where the ends of edge e lie among the corners u0v0, u1v0, u0v1, u1v1. */
static int corner_of(int e, int end)
{
    return e < 2 ? e + 2 * end : end + 2 * (e - 2);
}

static void evaluate_end(const taut_curve *curve, int end, double x[3])
{
    const taut_basis *t = taut_curve_t(curve);
    (void)taut_curve_eval(curve, end == 0 ? taut_basis_lo(t) : taut_basis_hi(t), 0, x);
}

/* The corners, halfway between the ends that meet there. */
static taut_status find_corners(const taut_plateau_problem *given, double corner[4][3],
                                taut_error *error)
{
    double ends[4][2][3], size = 0;
    int seen[4] = {-1, -1, -1, -1};

    for (int k = 0; k < 8; k++) {
        evaluate_end(given->curves[k / 2], k % 2, ends[k / 2][k % 2]);
        size = fmax(size, taut_distance(ends[k / 2][k % 2], ends[0][0]));
    }
    for (int e = 0; e < 4; e++) {
        const double *points = taut_curve_points(given->curves[e]);
        for (int i = 0; i < taut_basis_count(taut_curve_t(given->curves[e])); i++) {
            size = fmax(size, taut_distance(points + 3 * i, ends[0][0]));
        }
    }
    for (int k = 0; k < 8; k++) {
        const int e = k / 2, c = corner_of(e, k % 2);
        const double *x = ends[e][k % 2];
        char where[16] = "/curves/u0";
        if (seen[c] < 0) {
            memcpy(corner[c], x, sizeof corner[c]);
            seen[c] = e;
            continue;
        }
        memcpy(where + 8, edge_names[e], 2);
        const double gap = taut_distance(x, corner[c]);
        if (!(gap <= gap_meeting * size)) {
            return taut_fail(error, TAUT_BAD_INPUT, "corners", where, gap, gap_meeting * size,
                             "curve %s misses %s by %.3g where they should meet, expected at most "
                             "%.3g: u0 and u1 run with v, v0 and v1 with u",
                             edge_names[e], edge_names[seen[c]], gap, gap_meeting * size);
        }
        for (int a = 0; a < 3; a++) {
            corner[c][a] = 0.5 * corner[c][a] + 0.5 * x[a];
        }
    }
    return TAUT_OK;
}

/* Is the net's outermost row the surface's edge? Not where the basis is no clamped one. */
static int is_clamped(const taut_basis *basis)
{
    double values[TAUT_DEGREE_MAX + 1];
    const int last = taut_basis_span_count(basis) - 1, local = taut_basis_local(basis);

    return taut_basis_eval(basis, 0, taut_basis_lo(basis), 0, values) == TAUT_OK &&
           fabs(values[0] - 1) <= value_clamped &&
           taut_basis_eval(basis, last, taut_basis_hi(basis), 0, values) == TAUT_OK &&
           fabs(values[local - 1] - 1) <= value_clamped;
}

static taut_status check_bases(const taut_dirichlet_problem *net, taut_error *error)
{
    for (int k = 0; k < 2; k++) {
        const taut_basis *basis = k == 0 ? net->u : net->v;
        if (!is_clamped(basis)) {
            return taut_fail(error, TAUT_NO_SOLUTION, "unclamped", k == 0 ? "/u" : "/v", taut_none,
                             taut_none,
                             "curves cannot be the edges of a surface on this %s: its edges do not "
                             "end in its outermost points; take a bezier, c-bezier, h-bezier or "
                             "bspline basis",
                             taut_basis_type(basis));
        }
    }
    return TAUT_OK;
}

/* row: curve e in the space of its edge, between the corners. */
static taut_status fit_edge(taut_plateau_space *space, const taut_plateau_problem *given, int e,
                            const double corner[4][3], double *row, taut_error *error)
{
    const taut_dirichlet_problem *net = &space->problem.net;
    double ends[2][3], deviation = 0;
    taut_status status = TAUT_OK;

    memcpy(ends[0], corner[corner_of(e, 0)], sizeof ends[0]);
    memcpy(ends[1], corner[corner_of(e, 1)], sizeof ends[1]);
    status = taut_curve_fit(given->curves[e], e < 2 ? net->v : net->u, (const double(*)[3])ends,
                            row, &deviation);
    if (status == TAUT_NOT_CONVERGED) {
        return taut_fail(error, status, "curve-fit", "/curves", taut_none, taut_none,
                         "curve %s cannot be fitted to the basis of its edge: the knots, "
                         "the degree or the points are too extreme",
                         edge_names[e]);
    }
    if (status != TAUT_OK) {
        return taut_fail_memory(error);
    }
    space->deviation = fmax(space->deviation, deviation);
    return TAUT_OK;
}

/* points and known: the fitted curves around a hole. */
static taut_status lay_curves(taut_plateau_space *space, const taut_plateau_problem *given,
                              double *points, unsigned char *known, taut_error *error)
{
    const taut_dirichlet_problem *net = &space->problem.net;
    const int nu = taut_basis_count(net->u), nv = taut_basis_count(net->v);
    double corner[4][3];
    double *row = taut_arena_take(space->arena, (size_t)(nu > nv ? nu : nv), 3 * sizeof(double));
    taut_status status = row != NULL ? find_corners(given, corner, error) : taut_fail_memory(error);

    for (int e = 0; status == TAUT_OK && e < 4; e++) {
        status = fit_edge(space, given, e, (const double(*)[3])corner, row, error);
        for (int k = 0; status == TAUT_OK && k < (e < 2 ? nv : nu); k++) {
            const size_t i = e < 2 ? (size_t)(e == 0 ? 0 : nu - 1) : (size_t)k;
            const size_t j = e < 2 ? (size_t)k : (size_t)(e == 2 ? 0 : nv - 1);
            memcpy(points + 3 * (i * (size_t)nv + j), row + 3 * k, 3 * sizeof(double));
            known[i * (size_t)nv + j] = 1;
        }
    }
    return status;
}

/* The net: from the surface if there is one, else the problem's own points. */
static taut_status fill_net(taut_plateau_space *space, const taut_plateau_problem *given,
                            const taut_surface *finer, taut_error *error)
{
    taut_dirichlet_problem *net = &space->problem.net;
    const size_t nu = (size_t)taut_basis_count(net->u), nv = (size_t)taut_basis_count(net->v);
    double *points = taut_arena_take(space->arena, 3 * nu * nv, sizeof(double));
    unsigned char *known = taut_arena_take(space->arena, nu * nv, 1);
    taut_status status = TAUT_OK;

    if (known == NULL) {
        return taut_fail_memory(error);
    }
    for (size_t i = 0; i < nu * nv; i++) {
        known[i] = i / nv == 0 || i / nv == nu - 1 || i % nv == 0 || i % nv == nv - 1;
    }
    if (finer != NULL) {
        memcpy(points, taut_surface_points(finer), 3 * nu * nv * sizeof(double));
    }
    net->points = points;
    net->known = known;
    space->problem.start = NULL;
    if (space->has_curves) {
        status = check_bases(net, error);
        if (status != TAUT_OK) {
            return status;
        }
        status = lay_curves(space, given, points, known, error);
        if (status != TAUT_OK) {
            return status;
        }
    }
    if (finer == NULL) {
        return TAUT_OK;
    }
    space->problem.start = taut_arena_copy(space->arena, points, 3 * nu * nv, sizeof(double));
    return space->problem.start != NULL ? TAUT_OK : taut_fail_memory(error);
}

/* The bases and weights of the finer surface, copied. */
static taut_status take_bases(taut_plateau_space *space, const taut_surface *finer)
{
    taut_dirichlet_problem *net = &space->problem.net;
    const double *weights = taut_surface_weights(finer);

    if (own_basis(space, taut_surface_u(finer), &net->u) != TAUT_OK ||
        own_basis(space, taut_surface_v(finer), &net->v) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    net->weights = taut_arena_copy(
        space->arena, weights, (size_t)taut_basis_count(net->u) * (size_t)taut_basis_count(net->v),
        sizeof(double));
    return net->weights != NULL || weights == NULL ? TAUT_OK : TAUT_NO_MEMORY;
}

static taut_status make_space(taut_plateau_space *space, const taut_plateau_problem *given,
                              const taut_surface *finer, taut_error *error)
{
    const int is_refined =
        finer != NULL || given->refine > 0 || given->tolerance_area > 0 || given->gap > 0;

    if (space->arena == NULL) {
        return taut_fail_memory(error);
    }
    if (space->has_curves && given->net.weights != NULL) {
        return taut_fail(error, TAUT_BAD_INPUT, "conflict", "/weights", taut_none, taut_none,
                         "found weights beside curves, expected none: curves are fitted without");
    }
    if (is_refined && !space->has_curves && !taut_plateau_knows_boundary(&given->net)) {
        return taut_fail(error, TAUT_BAD_INPUT, "conflict", "/points", taut_none, taut_none,
                         "finer spaces need a net whose boundary is known and whose inside is "
                         "not: leave refine, tolerance_area and gap out");
    }
    if (finer == NULL && !space->has_curves) {
        return TAUT_OK;
    }
    if (finer != NULL && take_bases(space, finer) != TAUT_OK) {
        return taut_fail_memory(error);
    }
    return fill_net(space, given, finer, error);
}

taut_status taut_plateau_space_new(const taut_plateau_problem *given, const taut_surface *finer,
                                   taut_plateau_space **space, taut_error *error)
{
    taut_plateau_space *made = taut_alloc_zero(1, sizeof *made);
    taut_status status = TAUT_OK;

    if (made == NULL) {
        return taut_fail_memory(error);
    }
    made->problem = *given;
    made->has_curves = given->curves[0] != NULL;
    made->arena = taut_arena_new();
    status = make_space(made, given, finer, error);
    if (status != TAUT_OK) {
        taut_plateau_space_free(made);
        return status;
    }
    *space = made;
    return TAUT_OK;
}

void taut_plateau_space_describe(const taut_plateau_space *space, taut_record *details)
{
    if (space->has_curves) {
        taut_record_add_number(details, "deviation", space->deviation);
    }
}
