/* jacobian.c -- does a planar patch fold? J = x_u y_v - x_v y_u over the whole of it.
 *
 * On each knot rectangle J is a polynomial of bidegree (2n-1, 2m-1), and it lies between its least
 * and largest Bernstein coefficient ([NiWang2015] section 8.8). Rounding is bounded along with the
 * coefficients, so that one sign of all of them is a proof. Where they do not have it, the
 * rectangle whose lowest coefficient is worst is halved both ways, and so on. The corner
 * coefficients are values of J: one of the other sign proves a fold.
 */
#include "core/arena.h"
#include "core/fail.h"
#include "core/vec3.h"
#include "measure/integrate/jacobian_cell.h"
#include "taut/limits.h"
#include "taut/measure.h"
#include "taut/operations.h"

#include <float.h>
#include <math.h>
#include <string.h>

enum { CELLS = 4096, CELLS_LEAST = 64, POLISH = 256 };

/* Points this near to a plane, over their size, are in it. */
static const double flatness = 0x1p-40;

typedef struct search {
    const taut_surface *surface;
    taut_arena *arena;
    int axes[2];  /* the coordinates that are kept */
    int scale;    /* points are divided by 2^scale */
    double apart; /* rounding in the points of pieces, scaled */
    int du, dv;
    double sign;
    taut_jacobian_cell *cells; /* those to look at; their values are slots of the pool */
    long count, limit, made;
    double *scratch;
    double bound;  /* the least `low` of the cells that are done with */
    double lowest; /* the least sign J at a corner of any cell */
    double lowest_at[2];
    int folds; /* nonzero: J of the other sign is proved at `lowest_at` */
} search;

static size_t numbers_of(const search *s)
{
    return (size_t)(s->du + 1) * (size_t)(s->dv + 1);
}

/* The coordinate to drop, 0..2, of points that are in one plane; -1 where they are not, 3 where
 * they are on one line. The scaled points are at most 1 in size. */
static int plane_of(size_t count, const double *points, int scale)
{
    double a[3] = {0, 0, 0}, normal[3] = {0, 0, 0}, size = 0, area = 0, off = 0;

    for (size_t k = 1; k < count; k++) {
        double d[3];
        for (int c = 0; c < 3; c++) {
            d[c] = ldexp(points[3 * k + (size_t)c], -scale) - ldexp(points[c], -scale);
        }
        if (taut_norm(d) > size) {
            size = taut_norm(d);
            memcpy(a, d, sizeof a);
        }
    }
    for (int pass = 0; pass < 2; pass++) {
        for (size_t k = 1; k < count; k++) {
            double d[3], n[3];
            for (int c = 0; c < 3; c++) {
                d[c] = ldexp(points[3 * k + (size_t)c], -scale) - ldexp(points[c], -scale);
            }
            taut_cross(a, d, n);
            if (pass == 0 && taut_norm(n) > area) {
                area = taut_norm(n);
                memcpy(normal, n, sizeof normal);
            }
            off = pass == 1 ? fmax(off, fabs(taut_dot(normal, d))) : off;
        }
        if (area <= flatness * size * size) {
            return 3;
        }
    }
    if (off > flatness * size * area) {
        return -1;
    }
    const int first = fabs(normal[1]) > fabs(normal[0]) ? 1 : 0;
    return fabs(normal[2]) >= fabs(normal[first]) ? 2 : first;
}

/* Takes a cell into account: its corners, and whether it must be looked at again. */
static void settle(search *s, const taut_jacobian_cell *given)
{
    const int corners[4] = {0, s->dv, s->du * (s->dv + 1), s->du * (s->dv + 1) + s->dv};
    const size_t count = numbers_of(s);
    taut_jacobian_cell cell = *given;
    int vanishes = 1;

    cell.low = INFINITY;
    for (size_t i = 0; i < count; i++) {
        vanishes = vanishes && cell.values[i] == 0 && cell.values[count + i] == 0;
        cell.low = fmin(cell.low, s->sign * cell.values[i] - cell.values[count + i]);
    }
    for (int k = 0; k < 4; k++) {
        const double value = s->sign * cell.values[corners[k]];
        if (value < s->lowest) {
            s->lowest = value;
            s->lowest_at[0] = k / 2 ? cell.hi[0] : cell.lo[0];
            s->lowest_at[1] = k % 2 ? cell.hi[1] : cell.lo[1];
        }
        s->folds = s->folds || value < -cell.values[count + (size_t)corners[k]];
    }
    s->folds = s->folds || vanishes;
    s->cells[s->count++] = cell;
}

/* Halves the cell of the least bound; 0 when there is nothing to gain, or no room. */
static int step(search *s)
{
    const size_t count = numbers_of(s);
    taut_jacobian_cell cell, children[4];
    double *pool = NULL;
    long worst = 0;

    for (long k = 1; k < s->count; k++) {
        worst = s->cells[k].low < s->cells[worst].low ? k : worst;
    }
    cell = s->cells[worst];
    s->bound = cell.low;
    const int decided = s->folds || cell.low >= 0;
    const double gap = s->lowest - cell.low;
    if (s->made + 4 > s->limit || (decided && gap <= 0.01 * fabs(s->lowest)) ||
        (decided && s->made > POLISH)) {
        return 0;
    }
    pool = taut_arena_take(s->arena, 4 * 2 * count, sizeof(double));
    if (pool == NULL) {
        return -1;
    }
    for (int k = 0; k < 4; k++) {
        children[k].values = pool + 2 * count * (size_t)k;
    }
    taut_jacobian_quarter(s->du, s->dv, &cell, s->scratch, children);
    s->cells[worst] = s->cells[--s->count];
    for (int k = 0; k < 4; k++) {
        settle(s, &children[k]);
    }
    s->made += 4;
    return 1;
}

/* The first cell of a piece, in the parameters of the whole. */
static taut_status open_cell(search *s, const taut_surface *piece, taut_jacobian_cell *cell)
{
    const taut_basis *basis[2] = {taut_surface_u(piece), taut_surface_v(piece)};
    const double *points = taut_surface_points(piece);
    const int n = taut_basis_degree(basis[0]), m = taut_basis_degree(basis[1]);
    const size_t count = (size_t)(n + 1) * (size_t)(m + 1);
    double *x = taut_arena_take(s->arena, 2 * count, sizeof(double));
    double scale = 1;

    cell->values = taut_arena_take(s->arena, 2 * numbers_of(s), sizeof(double));
    if (x == NULL || cell->values == NULL) {
        return TAUT_NO_MEMORY;
    }
    for (size_t k = 0; k < count; k++) {
        for (size_t d = 0; d < 2; d++) {
            x[2 * k + d] = ldexp(points[3 * k + (size_t)s->axes[d]], -s->scale);
        }
    }
    for (int d = 0; d < 2; d++) {
        const taut_basis *whole = d == 0 ? taut_surface_u(s->surface) : taut_surface_v(s->surface);
        cell->lo[d] = taut_basis_lo(basis[d]);
        cell->hi[d] = taut_basis_hi(basis[d]);
        scale *= (taut_basis_hi(whole) - taut_basis_lo(whole)) / (cell->hi[d] - cell->lo[d]);
    }
    const taut_planar patch = {n, m, x, s->apart};
    taut_jacobian_coefficients(&patch, scale, cell->values);
    return TAUT_OK;
}

/* A first cell for every piece, and the sign of the whole: that of the integral of J. */
static taut_status open_all(search *s, const taut_model *pieces)
{
    const int count = taut_model_surface_count(pieces);
    const size_t numbers = numbers_of(s);
    taut_jacobian_cell *first = taut_arena_take(s->arena, (size_t)count, sizeof *first);
    double integral = 0;
    taut_status status = first != NULL ? TAUT_OK : TAUT_NO_MEMORY;

    for (int k = 0; status == TAUT_OK && k < count; k++) {
        double sum = 0;
        status = open_cell(s, taut_model_surface(pieces, k), &first[k]);
        for (size_t i = 0; status == TAUT_OK && i < numbers; i++) {
            sum += first[k].values[i];
        }
        integral += sum * (first[k].hi[0] - first[k].lo[0]) * (first[k].hi[1] - first[k].lo[1]);
    }
    s->sign = integral < 0 ? -1 : 1;
    for (int k = 0; status == TAUT_OK && k < count; k++) {
        settle(s, &first[k]);
    }
    s->made = count;
    return status;
}

static void report(const search *s, taut_jacobian *jacobian)
{
    const taut_basis *u = taut_surface_u(s->surface), *v = taut_surface_v(s->surface);
    const double area =
        (taut_basis_hi(u) - taut_basis_lo(u)) * (taut_basis_hi(v) - taut_basis_lo(v));
    const double found = s->folds || s->bound < 0 ? s->lowest : s->bound;

    jacobian->state = s->folds        ? TAUT_JACOBIAN_FOLDS
                      : s->bound >= 0 ? TAUT_JACOBIAN_ONE_SIGN
                                      : TAUT_JACOBIAN_UNDECIDED;
    jacobian->sign = (int)s->sign;
    jacobian->lowest = ldexp(found / area, 2 * s->scale);
    memcpy(jacobian->at, s->lowest_at, sizeof jacobian->at);
    jacobian->cells = s->made;
}

static taut_status prove(search *s, const taut_model *pieces, taut_jacobian *jacobian)
{
    const double work = (double)numbers_of(s) * (s->du + s->dv + 2);
    taut_status status = TAUT_OK;
    int more = 1;

    s->limit = (long)fmin(CELLS, fmax(CELLS_LEAST, 1e9 / work)) + taut_model_surface_count(pieces);
    s->cells = taut_arena_take(s->arena, (size_t)s->limit + 4, sizeof *s->cells);
    s->scratch = taut_arena_take(s->arena, 2 * numbers_of(s), sizeof(double));
    status = s->cells != NULL && s->scratch != NULL ? open_all(s, pieces) : TAUT_NO_MEMORY;
    while (status == TAUT_OK && more > 0) {
        more = step(s);
        status = more < 0 ? TAUT_NO_MEMORY : TAUT_OK;
    }
    if (status == TAUT_OK) {
        report(s, jacobian);
    }
    return status;
}

static int exponent_of(size_t count, const double *points)
{
    double most = 0;
    int exponent = 0;
    for (size_t i = 0; i < 3 * count; i++) {
        most = fmax(most, fabs(points[i]));
    }
    (void)frexp(most, &exponent);
    return exponent;
}

taut_status taut_surface_jacobian(const taut_surface *surface, taut_jacobian *jacobian)
{
    const taut_basis *u = surface != NULL ? taut_surface_u(surface) : NULL;
    const taut_basis *v = surface != NULL ? taut_surface_v(surface) : NULL;
    search s = {.surface = surface, .lowest = INFINITY};
    taut_jacobian found = {TAUT_JACOBIAN_NONE, 0, taut_none, {taut_none, taut_none}, 0};
    taut_model *pieces = NULL;
    taut_status status = TAUT_OK;

    if (surface == NULL || jacobian == NULL) {
        return TAUT_BAD_ARGUMENT;
    }
    const size_t count = (size_t)taut_basis_count(u) * (size_t)taut_basis_count(v);
    s.scale = exponent_of(count, taut_surface_points(surface));
    const int dropped = plane_of(count, taut_surface_points(surface), s.scale);
    if (dropped == 3) {
        found.state = TAUT_JACOBIAN_FOLDS;
        found.lowest = 0;
    } else if (dropped >= 0 && (taut_basis_degree(u) < 0 || taut_basis_degree(v) < 0 ||
                                taut_surface_weights(surface) != NULL)) {
        found.state = TAUT_JACOBIAN_UNSUPPORTED;
    } else if (dropped >= 0) {
        const int exact =
            strcmp(taut_basis_type(u), "bezier") == 0 && strcmp(taut_basis_type(v), "bezier") == 0;
        s.axes[0] = (dropped + 1) % 3;
        s.axes[1] = (dropped + 2) % 3;
        s.du = 2 * taut_basis_degree(u) - 1;
        s.dv = 2 * taut_basis_degree(v) - 1;
        /* a piece is reached by at most 2 degree insertions along each direction, means of points
         */
        s.apart = exact ? 0 : 8.0 * (s.du + s.dv + 2) * 0x1p-53;
        s.arena = taut_arena_new();
        status = s.arena != NULL ? taut_surface_pieces(surface, &pieces, NULL) : TAUT_NO_MEMORY;
        if (status == TAUT_OK) {
            status = prove(&s, pieces, &found);
        }
        taut_model_free(pieces);
        taut_arena_free(s.arena);
    }
    if (status == TAUT_OK) {
        *jacobian = found;
    }
    return status;
}
