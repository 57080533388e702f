/* target.c -- what sides interpolate.
 *
 *     inside       x and n
 *     along an edge shared with another surface: the means x' and n' of both, of all surfaces at a corner, n' longer by so much
 *                  that both sides are at T/2 from each tangent plane, but for the square of the angle
 *     the differences x' - x and n' - n, which are small, are shared out inside by the surface of Coons of the four edges
 *                  ([Farin2002] 22)
 */
#include "core/fail.h"
#include "core/vec3.h"
#include "shell/thick/parts.h"
#include "taut/measure.h"

#include <math.h>
#include <string.h>

/* Normals nearer than this cosine (2.6 degrees) are those of one tangent plane, as in mesh/thicken.c. */
static const double alike = 0.999;
static const double degrees_of_radian = 57.29577951308232;
static const double rounding = 1e-9; /* of a curvature: what is within that of folding folds */

/* x and n, or what is to be added to them. */
typedef struct spot {
    double x[3], n[3];
} spot;

static double parameter_of(const taut_basis *basis, double share)
{
    const double lo = taut_basis_lo(basis), hi = taut_basis_hi(basis);
    const double t = lo + share * (hi - lo);
    return share >= 1 || t > hi ? hi : t;
}

static taut_status fail_normal(const taut_surface *surface, taut_error *error)
{
    return taut_fail(error, TAUT_NO_SOLUTION, "sheet", NULL, taut_none, taut_none,
                     "\"%.60s\" cannot be given a thickness: it has no normal at a point that its "
                     "sides go through",
                     taut_surface_name(surface));
}

/* The surface at shares of its own. */
static taut_status find_spot(const taut_thick_work *work, int face, double u, double v, spot *at,
                             taut_error *error)
{
    const taut_surface *surface = work->surfaces[face];
    const double tu = parameter_of(taut_surface_u(surface), u);
    const double tv = parameter_of(taut_surface_v(surface), v);
    taut_forms forms;
    taut_surface_eval(surface, tu, tv, 0, at->x);
    taut_surface_forms_points(surface, 1, &tu, &tv, 1, &forms);
    for (int c = 0; c < 3; c++) {
        at->n[c] = work->shells->faces[face].turned ? -forms.normal[c] : forms.normal[c];
    }
    return forms.regular ? TAUT_OK : fail_normal(surface, error);
}

static taut_status find_on_edge(const taut_thick_work *work, int edge, double share, spot *at,
                                taut_error *error)
{
    const double end = edge % 2;
    return edge % 4 < 2 ? find_spot(work, edge / 4, end, share, at, error)
                        : find_spot(work, edge / 4, share, end, at, error);
}

/* The mean of spots, the normal long enough to be at distance 1 from each plane, less `own`. */
static taut_status mean_of(const taut_thick_work *work, int face, int count, const spot *sum,
                           double along, const spot *own, spot *mean, taut_error *error)
{
    const double length = taut_length(sum->n);
    const double cosine = taut_dot(sum->n, own->n) / length;
    /* half the angle, when there are two */
    if (!(2 * cosine * cosine - 1 > alike)) {
        const double degrees = 2 * taut_acos(cosine) * degrees_of_radian;
        return taut_fail(error, TAUT_NO_SOLUTION, "sheet", NULL, degrees, taut_none,
                         "\"%.60s\" cannot be given a thickness: it meets a neighbour at an edge "
                         "with an angle of %.3g degrees, expected at most 2.5 (meshes take it: "
                         "write .3mf, .stl or .obj)",
                         taut_surface_name(work->surfaces[face]), degrees);
    }
    for (int c = 0; c < 3; c++) {
        mean->x[c] = sum->x[c] / count - own->x[c];
        mean->n[c] = sum->n[c] * count / along - own->n[c];
    }
    return TAUT_OK;
}

static void add_spot(const spot *at, spot *sum)
{
    taut_add_scaled(1, at->x, sum->x);
    taut_add_scaled(1, at->n, sum->n);
}

/* What corner c of a face is to be moved by, so that all surfaces there agree. */
static taut_status find_corner(const taut_thick_work *work, int corner, spot *difference,
                               taut_error *error)
{
    spot own = {{0}, {0}}, sum = {{0}, {0}}, at;
    double along = 0;
    int count = 0;
    taut_status status = TAUT_OK;
    for (int pass = 0; pass < 2; pass++) {
        for (int k = work->first[work->vertex[corner]]; k >= 0; k = work->next[k]) {
            status = find_spot(work, k / 4, (k % 4) / 2, k % 2, &at, error);
            if (status != TAUT_OK) {
                return status;
            }
            if (pass == 1) {
                along += taut_dot(sum.n, at.n);
                continue;
            }
            add_spot(&at, &sum);
            own = k == corner ? at : own;
            count++;
        }
    }
    return mean_of(work, corner / 4, count, &sum, along, &own, difference, error);
}

/* What a place of an edge is to be moved by, for itself: 0 where nothing meets it. */
static taut_status find_difference(const taut_thick_work *work, int edge, double share,
                                   spot *difference, taut_error *error)
{
    const int other = work->partner[edge];
    spot own, at, sum = {{0}, {0}};
    memset(difference, 0, sizeof *difference);
    if (other < 0) {
        return TAUT_OK;
    }
    taut_status status = find_on_edge(work, edge, share, &own, error);
    if (status == TAUT_OK) {
        status = find_on_edge(work, other, work->reversed[edge] ? 1 - share : share, &at, error);
    }
    if (status != TAUT_OK) {
        return status;
    }
    add_spot(&own, &sum);
    add_spot(&at, &sum);
    return mean_of(work, edge / 4, 2, &sum, taut_dot(sum.n, sum.n), &own, difference, error);
}

/* Of one edge: its places, and what its ends lack to be those of the corners, which goes along it in proportion. */
static taut_status find_edge(const taut_thick_work *work, int edge, int count, const double *shares,
                             const spot *corners, spot *differences, taut_error *error)
{
    spot lacks[2];
    for (int end = 0; end < 2; end++) {
        const spot *corner = &corners[taut_shell_corner(edge, end) % 4];
        const taut_status status = find_difference(work, edge, end, &lacks[end], error);
        if (status != TAUT_OK) {
            return status;
        }
        for (int c = 0; c < 3; c++) {
            lacks[end].x[c] = corner->x[c] - lacks[end].x[c];
            lacks[end].n[c] = corner->n[c] - lacks[end].n[c];
        }
    }
    for (int k = 0; k < count; k++) {
        const taut_status status = find_difference(work, edge, shares[k], &differences[k], error);
        if (status != TAUT_OK) {
            return status;
        }
        for (int end = 0; end < 2; end++) {
            const double part = end == 0 ? 1 - shares[k] : shares[k];
            taut_add_scaled(part, lacks[end].x, differences[k].x);
            taut_add_scaled(part, lacks[end].n, differences[k].n);
        }
    }
    return TAUT_OK;
}

/* The surface of Coons between the differences of four edges and corners, added. */
static void blend(const spot *const edges[4], const spot corners[4], taut_thick_grid *grid)
{
    for (int i = 0; i < grid->nu; i++) {
        for (int j = 0; j < grid->nv; j++) {
            const double u[2] = {1 - grid->u[i], grid->u[i]}, v[2] = {1 - grid->v[j], grid->v[j]};
            const size_t at = 3 * ((size_t)i * (size_t)grid->nv + (size_t)j);
            for (int end = 0; end < 2; end++) {
                taut_add_scaled(u[end], edges[end][j].x, grid->places + at);
                taut_add_scaled(u[end], edges[end][j].n, grid->moves + at);
                taut_add_scaled(v[end], edges[2 + end][i].x, grid->places + at);
                taut_add_scaled(v[end], edges[2 + end][i].n, grid->moves + at);
            }
            for (int c = 0; c < 4; c++) {
                const double part = u[c / 2] * v[c % 2];
                taut_add_scaled(-part, corners[c].x, grid->places + at);
                taut_add_scaled(-part, corners[c].n, grid->moves + at);
            }
        }
    }
}

static taut_status add_differences(const taut_thick_work *work, int face, taut_arena *arena,
                                   taut_thick_grid *grid, taut_error *error)
{
    spot corners[4], *edges[4];
    int meets = 0;
    for (int e = 4 * face; e < 4 * face + 4; e++) {
        const int corner = work->first[work->vertex[e]];
        meets |= work->partner[e] >= 0 || work->next[corner] >= 0;
    }
    if (!meets) {
        return TAUT_OK;
    }
    for (int c = 0; c < 4; c++) {
        const taut_status status = find_corner(work, 4 * face + c, &corners[c], error);
        if (status != TAUT_OK) {
            return status;
        }
    }
    for (int e = 0; e < 4; e++) {
        const int count = e < 2 ? grid->nv : grid->nu;
        edges[e] = taut_arena_take(arena, (size_t)count, sizeof **edges);
        const taut_status status =
            edges[e] == NULL ? taut_fail_memory(error)
                             : find_edge(work, 4 * face + e, count, e < 2 ? grid->v : grid->u,
                                         corners, edges[e], error);
        if (status != TAUT_OK) {
            return status;
        }
    }
    blend((const spot *const[4]){edges[0], edges[1], edges[2], edges[3]}, corners, grid);
    return TAUT_OK;
}

/* The largest principal curvature, without its sign. */
static double curvature_of(const taut_forms *forms)
{
    const double h = fabs(forms->mean);
    return h + sqrt(fmax(h * h - forms->gaussian, 0));
}

static taut_status take_forms(const taut_thick_work *work, int face, const taut_forms *forms,
                              taut_thick_grid *grid, taut_error *error)
{
    const size_t count = (size_t)grid->nu * (size_t)grid->nv;
    const taut_surface *surface = work->surfaces[face];
    double most = 0;
    for (size_t i = 0; i < count; i++) {
        if (!forms[i].regular) {
            return fail_normal(surface, error);
        }
        most = fmax(most, curvature_of(&forms[i]));
        for (int c = 0; c < 3; c++) {
            const double n = forms[i].normal[c];
            grid->normals[3 * i + (size_t)c] = work->shells->faces[face].turned ? -n : n;
        }
    }
    return work->half * most < 1 - rounding
               ? TAUT_OK
               : taut_fail(error, TAUT_NO_SOLUTION, "fold", NULL, 2 * work->half, 2 / most,
                           "a thickness of %.6g folds \"%.60s\" over: its least radius of "
                           "curvature is %.6g, expected a thickness below %.6g",
                           2 * work->half, taut_surface_name(surface), 1 / most, 2 / most);
}

taut_status taut_thick_fill_grid(const taut_thick_work *work, int face, taut_arena *arena,
                                 taut_thick_grid *grid, taut_error *error)
{
    const taut_surface *surface = work->surfaces[face];
    const size_t nu = (size_t)grid->nu, nv = (size_t)grid->nv, count = nu * nv;
    double *u = taut_arena_take(arena, nu, sizeof *u), *v = taut_arena_take(arena, nv, sizeof *v);
    taut_forms *forms = taut_arena_take(arena, count, sizeof *forms);
    grid->places = taut_arena_take(arena, count, 3 * sizeof(double));
    grid->moves = taut_arena_take(arena, count, 3 * sizeof(double));
    grid->surface = taut_arena_take(arena, count, 3 * sizeof(double));
    grid->normals = taut_arena_take(arena, count, 3 * sizeof(double));
    if (taut_arena_status(arena) != TAUT_OK) {
        return taut_fail_memory(error);
    }
    for (size_t i = 0; i < nu; i++) {
        u[i] = parameter_of(taut_surface_u(surface), grid->u[i]);
    }
    for (size_t j = 0; j < nv; j++) {
        v[j] = parameter_of(taut_surface_v(surface), grid->v[j]);
    }
    if (taut_surface_eval_grid(surface, grid->nu, u, grid->nv, v, 0, work->threads,
                               grid->surface) != TAUT_OK ||
        taut_surface_forms_grid(surface, grid->nu, u, grid->nv, v, work->threads, forms) !=
            TAUT_OK) {
        return taut_fail_memory(error);
    }
    const taut_status status = take_forms(work, face, forms, grid, error);
    if (status != TAUT_OK) {
        return status;
    }
    memcpy(grid->places, grid->surface, count * 3 * sizeof(double));
    memcpy(grid->moves, grid->normals, count * 3 * sizeof(double));
    return add_differences(work, face, arena, grid, error);
}
