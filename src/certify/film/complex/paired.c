#include "certify/film/complex/paired.h"

#include "certify/film/sheet.h"
#include "core/elementary/elementary.h"
#include "core/vec3.h"

#include <math.h>
#include <string.h>

enum { PLACES = 3, SIDES_MOST = 8 };
static const double rounding = 1e-13; /* of the areas in all: of sums of doubles */

/* [2 patch_count]: the side that x_u x x_v points to, the other one; the region of each as a root. */
typedef struct regions {
    int *root;
    double (*field)[3]; /* of roots */
    unsigned char *known;
} regions;

static int find_root(int *root, int k)
{
    while (root[k] != k) {
        k = root[k] = root[root[k]];
    }
    return k;
}

static void look(const taut_sheets *s, int p, double at_u, double at_v, double (*x)[3])
{
    const taut_basis *u = taut_surface_u(s->surfaces[p]), *v = taut_surface_v(s->surfaces[p]);
    const double *origin = taut_surface_points(s->surfaces[0]);

    (void)taut_surface_eval(
        s->surfaces[p], taut_basis_lo(u) + at_u * (taut_basis_hi(u) - taut_basis_lo(u)),
        taut_basis_lo(v) + at_v * (taut_basis_hi(v) - taut_basis_lo(v)), 1, x[0]);
    for (int d = 0; d < 3; d++) {
        x[0][d] = ldexp(x[0][d] - origin[d], -s->unit);
        x[TAUT_XU][d] = ldexp(x[TAUT_XU][d], -s->unit);
        x[TAUT_XV][d] = ldexp(x[TAUT_XV][d], -s->unit);
    }
}

/* Is every edge held, a slide, a point or in a seam without a cable, and the tension one? */
static int is_plain(const taut_sheets *s)
{
    const taut_film_problem *problem = s->complex->problem;

    for (int k = 0; k < 4 * problem->patch_count; k++) {
        if (s->shares[k / 4] != s->shares[0] ||
            taut_film_sheet_has_threads(&problem->patches[k / 4])) {
            return 0;
        }
    }
    return problem->cell_count == 0 && s->complex->rope_count == 0;
}

/* A sheet at a place of a seam. */
typedef struct leaf {
    double angle; /* of where it goes from there, about the seam */
    int left;     /* its side to where angles grow */
} leaf;

static int find_leaf(const taut_sheets *s, const taut_film_side *side, double part,
                     double frame[3][3], leaf *to)
{
    const int e = side->edge;
    const double along = side->reversed ? 1 - part : part, sign = e % 2 == 0 ? 1 : -1;
    double x[TAUT_SURFACE_VECTORS(1)][3], n[3], in[3], across[3];

    look(s, side->patch, e < 2 ? e : along, e < 2 ? along : e - 2, x);
    const double *t = x[e < 2 ? TAUT_XV : TAUT_XU], *out = x[e < 2 ? TAUT_XU : TAUT_XV];
    taut_cross(x[TAUT_XU], x[TAUT_XV], n);
    for (int d = 0; d < 3; d++) {
        in[d] = sign * (out[d] - taut_dot(out, t) / taut_dot(t, t) * t[d]);
    }
    if (!(taut_length(n) > 0 && taut_length(in) > 0)) {
        return 0;
    }
    if (isnan(frame[0][0])) { /* along the seam as it is run, along the first sheet, across both */
        const double turn = side->reversed ? -1 : 1;
        for (int d = 0; d < 3; d++) {
            frame[0][d] = turn * t[d] / taut_length(t);
            frame[1][d] = in[d] / taut_length(in);
        }
        taut_cross(frame[0], frame[1], frame[2]);
    }
    taut_cross(frame[0], in, across);
    to->angle = taut_atan2(taut_dot(in, frame[2]), taut_dot(in, frame[1]));
    to->left = 2 * side->patch + (taut_dot(n, across) > 0 ? 0 : 1);
    return 1;
}

/* The sheets of a seam about it, in the order of their angles; 0: they cannot be told apart. */
static int sort_leaves(const taut_sheets *s, const taut_film_seam *seam, double part,
                       leaf leaves[SIDES_MOST])
{
    double frame[3][3] = {{NAN, NAN, NAN}};

    for (int k = 0; k < seam->count; k++) {
        leaf next;
        int i = k;
        if (!find_leaf(s, &seam->sides[k], part, frame, &next)) {
            return 0;
        }
        for (; i > 0 && leaves[i - 1].angle > next.angle; i--) {
            leaves[i] = leaves[i - 1];
        }
        leaves[i] = next;
    }
    for (int k = 1; k < seam->count; k++) {
        if (!(leaves[k].angle - leaves[k - 1].angle > 1e-3)) {
            return 0;
        }
    }
    return 1;
}

/* Sides that face each other across a wedge of a seam are of one region. 0: the order of sheets changes along it. */
static int join_sides(const taut_sheets *s, const taut_film_seam *seam, int *root)
{
    for (int place = 0; place < PLACES; place++) {
        leaf leaves[SIDES_MOST];
        if (seam->count > SIDES_MOST || !sort_leaves(s, seam, (place + 0.5) / PLACES, leaves)) {
            return 0;
        }
        for (int k = 0; k < seam->count; k++) {
            const int one = find_root(root, leaves[k].left),
                      other = find_root(root, leaves[(k + 1) % seam->count].left ^ 1);
            if (place > 0 && one != other) {
                return 0;
            }
            root[one] = other;
        }
    }
    return 1;
}

/* iint x_u x x_v = 1/2 oint x x dx. */
static void find_vector(const taut_sheets *s, int p, double vector[3])
{
    memset(vector, 0, 3 * sizeof *vector);
    for (int e = 0; e < 4; e++) {
        const taut_sheet_axis *axis = &s->axes[2 * p + (e < 2)];
        const taut_basis *basis =
            e < 2 ? taut_surface_v(s->surfaces[p]) : taut_surface_u(s->surfaces[p]);
        const double lo = taut_basis_lo(basis), range = taut_basis_hi(basis) - lo;
        for (int k = 0; k < axis->table->count; k++) {
            const double t = (axis->at[k] - lo) / range;
            double x[TAUT_SURFACE_VECTORS(1)][3], area[3];
            look(s, p, e < 2 ? e : t, e < 2 ? t : e - 2, x);
            taut_cross(x[0], x[e < 2 ? TAUT_XV : TAUT_XU], area);
            taut_add_scaled((e == 1 || e == 2 ? 0.5 : -0.5) * axis->weights[k], area, vector);
        }
    }
}

/* Without what crosses the planes that edges slide in. */
static void keep_in_planes(const taut_film_problem *problem, double x[3])
{
    taut_film_hold planes = {.count = 0};

    for (int k = 0; k < 4 * problem->patch_count; k++) {
        const taut_film_edge *edge = &problem->patches[k / 4].edges[k % 4];
        if (edge->kind == TAUT_FILM_SLIDE) {
            (void)taut_film_hold_add(&planes, edge->plane.direction, 0, INFINITY);
        }
    }
    for (int k = 0; k < planes.count; k++) {
        taut_add_scaled(-taut_dot(x, planes.normals[k]), planes.normals[k], x);
    }
}

/* Fields of regions that are reached from the first one, sheet by sheet. */
static void spread(const taut_sheets *s, const double (*vectors)[3], regions *r)
{
    const int patches = s->complex->problem->patch_count;

    r->known[find_root(r->root, 0)] = 1;
    for (int k = 0; k < patches * patches; k++) {
        const int p = k % patches;
        const int ahead = find_root(r->root, 2 * p), behind = find_root(r->root, 2 * p + 1);
        if (r->known[ahead] != r->known[behind]) {
            const int from = r->known[ahead] ? ahead : behind, to = ahead + behind - from;
            double step[3] = {vectors[p][0], vectors[p][1], vectors[p][2]};
            keep_in_planes(s->complex->problem, step);
            memcpy(r->field[to], r->field[from], sizeof r->field[to]);
            taut_add_scaled((to == behind ? 1 : -1) / taut_length(vectors[p]), step, r->field[to]);
            r->known[to] = 1;
        }
    }
}

static double bound_of(const taut_sheets *s, const double (*vectors)[3], regions *r)
{
    const int patches = s->complex->problem->patch_count;
    double sum = 0, size = 0, most = 0;

    spread(s, vectors, r);
    for (int p = 0; p < patches; p++) {
        const int ahead = find_root(r->root, 2 * p), behind = find_root(r->root, 2 * p + 1);
        double step[3];
        if (!r->known[ahead] || !r->known[behind]) {
            return NAN;
        }
        taut_difference(r->field[behind], r->field[ahead], step);
        sum += taut_dot(step, vectors[p]);
        size += taut_length(vectors[p]);
    }
    for (int a = 0; a < 2 * patches; a++) {
        for (int b = 0; b < a; b++) {
            if (r->root[a] == a && r->root[b] == b) {
                most = fmax(most, taut_distance(r->field[a], r->field[b]));
            }
        }
    }
    const double bound = sum / (most * (1 + 0x1p-48)) - rounding * size;
    return s->shares[0] * s->tension * ldexp(bound, 2 * s->unit);
}

taut_status taut_complex_paired(const taut_sheets *sheets, double *bound)
{
    const taut_film_problem *problem = sheets->complex->problem;
    const size_t sides = 2 * (size_t)problem->patch_count;
    taut_arena *arena = taut_arena_new();
    regions r = {.root = taut_arena_take(arena, sides, sizeof(int)),
                 .field = taut_arena_take(arena, sides, sizeof *r.field),
                 .known = taut_arena_take(arena, sides, 1)};
    double(*vectors)[3] = taut_arena_take(arena, sides / 2, sizeof *vectors);
    const taut_status status = taut_arena_status(arena);
    int told = status == TAUT_OK && is_plain(sheets);

    *bound = NAN;
    for (int k = 0; told && k < (int)sides; k++) {
        r.root[k] = k;
    }
    for (int k = 0; told && k < problem->seam_count; k++) {
        told = join_sides(sheets, &problem->seams[k], r.root);
    }
    for (int p = 0; told && p < problem->patch_count; p++) {
        find_vector(sheets, p, vectors[p]);
        r.root[2 * p] = find_root(r.root, 2 * p);
        r.root[2 * p + 1] = find_root(r.root, 2 * p + 1);
    }
    if (told) {
        *bound = bound_of(sheets, (const double(*)[3])vectors, &r);
    }
    taut_arena_free(arena);
    return status;
}
