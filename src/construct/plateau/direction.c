/* direction.c -- a direction in which a film is a graph over a convex domain.
 *
 * Samples: unit normals n_k of the film, of one sheet or many, and unit tangents t_k of its boundary, run through so that
 * the film lies on the left seen from its normals. Along e,
 *
 *     the film is a graph                n_k . e > 0 for all k
 *     the boundary does not turn back    (t_k x t_k+1) . e >= 0 for all k, over |t_k| |t_k+1| of the
 *                                        projections: the angle turned, its negative part summed
 *
 * All of it is linear in e: a cone, often a thin one, as each edge in a plane that is not straight
 * wants e in that plane or on one side of it. Candidates: the vector area of the film, the axes, the
 * directions in which planes of edges meet, and, if all those are steep, directions all over the
 * sphere. Of those allowed the one whose least n . e is largest; simple ones first.
 */
#include "construct/plateau/direction.h"

#include "core/arena.h"
#include "core/elementary/elementary.h"
#include "core/vec3.h"

#include <math.h>
#include <string.h>

enum {
    LINES_MAX = 48,     /* of normals, each way */
    LINES_OF_MANY = 12, /* the same of each of many sheets */
    MANY = 4,
    PLANES_MAX = 16,
    ON_SPAN = 5,  /* tangents */
    SPHERE = 600, /* directions */
    MOVES = 200,  /* of the best of them */
};

static const struct {
    double turned_back; /* angle: rounding */
    double good_enough; /* least n . e of a simple candidate that ends the search */
    double planar;      /* sine: of tangents out of the plane of their edge */
    double first_move;  /* on the unit sphere, halved from there */
    double last_move;
} limits = {
    .turned_back = 1e-10,
    .good_enough = 0.3,
    .planar = 1e-9,
    .first_move = 0.1,
    .last_move = 1e-3,
};

typedef struct samples {
    int normals, tangents; /* how many */
    double *normal;        /* [normals][3], unit */
    double *tangent;       /* [tangents][3], unit, once around; the first follows the last */
    int sides, *side;      /* where each side ends in tangents, in the order run through */
    double area[3];        /* the vector area, in some unit */
} samples;

typedef struct best {
    double e[3], least;
} best;

void taut_plateau_frame(const double e[3], double frame[3][3])
{
    int flat = 0;

    for (int c = 1; c < 3; c++) {
        flat = fabs(e[c]) < fabs(e[flat]) ? c : flat;
    }
    double axis[3] = {0, 0, 0};
    axis[flat] = 1;
    taut_cross(e, axis, frame[1]);
    const double length = taut_norm(frame[1]);
    for (int c = 0; c < 3; c++) {
        frame[1][c] /= length;
        frame[2][c] = e[c];
    }
    taut_cross(frame[1], e, frame[0]);
}

static int make_unit(double x[3])
{
    const double length = taut_norm(x);
    for (int c = 0; c < 3; c++) {
        x[c] /= length;
    }
    return isfinite(length) && length > 0;
}

/* ---- samples ---- */

/* `count` parameters inside the spans of a direction: some of each span, or of every so many. */
static int place_lines(const taut_basis *basis, int most, double *t)
{
    static const double at[3] = {1e-3, 0.5, 1 - 1e-3};
    const double *breaks = taut_basis_breaks(basis);
    const int spans = taut_basis_span_count(basis);
    int count = 0;

    for (int k = 0; k < most; k++) {
        const int all = 3 * spans <= most ? 3 * spans : most;
        const int which = (int)((double)k * (3 * spans - 1) / (all - 1) + 0.5);
        if (k < all) {
            const double lo = breaks[which / 3], hi = breaks[which / 3 + 1];
            t[count++] = lo + (hi - lo) * at[which % 3];
        }
    }
    return count;
}

static taut_status sample_normals(const taut_direction_sheet *sheet, int most, taut_arena *arena,
                                  samples *s)
{
    double u[LINES_MAX], v[LINES_MAX];
    const int nu = place_lines(taut_surface_u(sheet->surface), most, u);
    const int nv = place_lines(taut_surface_v(sheet->surface), most, v);
    double *jets = taut_arena_take(arena, (size_t)nu * (size_t)nv, 9 * sizeof(double));
    double *normal = s->normal + 3 * (size_t)s->normals;
    taut_status status = jets != NULL ? TAUT_OK : TAUT_NO_MEMORY;

    if (status == TAUT_OK) {
        status = taut_surface_eval_grid(sheet->surface, nu, u, nv, v, 1, 1, jets);
    }
    for (int k = 0; status == TAUT_OK && k < nu * nv; k++, normal += 3) {
        const double *xu = jets + 9 * (size_t)k + 3, *xv = xu + 3;
        taut_cross(sheet->sign > 0 ? xu : xv, sheet->sign > 0 ? xv : xu, normal);
        status = make_unit(normal) ? TAUT_OK : TAUT_NO_SOLUTION;
    }
    s->normals += nu * nv;
    return status;
}

/* A side, run through as it is said. */
static taut_status sample_side(const taut_surface *surface, const taut_direction_side *side,
                               taut_arena *arena, samples *s)
{
    static const double at[ON_SPAN] = {1e-6, 0.25, 0.5, 0.75, 1 - 1e-6};
    const int along_u = side->edge >= 2, backward = side->is_backward;
    const taut_basis *along = along_u ? taut_surface_u(surface) : taut_surface_v(surface);
    const taut_basis *across = along_u ? taut_surface_v(surface) : taut_surface_u(surface);
    const double held = side->edge % 2 == 1 ? taut_basis_hi(across) : taut_basis_lo(across);
    const double *breaks = taut_basis_breaks(along);
    const int count = ON_SPAN * taut_basis_span_count(along);
    double *t = taut_arena_take(arena, (size_t)count, sizeof(double));
    double *jets = taut_arena_take(arena, (size_t)count, 9 * sizeof(double));
    taut_status status = jets != NULL ? TAUT_OK : TAUT_NO_MEMORY;

    for (int g = 0; status == TAUT_OK && g < count; g++) {
        const double lo = breaks[g / ON_SPAN], hi = breaks[g / ON_SPAN + 1];
        t[g] = lo + (hi - lo) * at[g % ON_SPAN];
    }
    if (status == TAUT_OK) {
        status = along_u ? taut_surface_eval_grid(surface, count, t, 1, &held, 1, 1, jets)
                         : taut_surface_eval_grid(surface, 1, &held, count, t, 1, 1, jets);
    }
    for (int g = 0; status == TAUT_OK && g < count; g++) {
        const double *from = jets + 9 * (size_t)(backward ? count - 1 - g : g) + (along_u ? 3 : 6);
        double *tangent = s->tangent + 3 * (size_t)(s->tangents + g);
        for (int c = 0; c < 3; c++) {
            tangent[c] = backward ? -from[c] : from[c];
        }
        status = make_unit(tangent) ? TAUT_OK : TAUT_NO_SOLUTION;
    }
    s->tangents += count;
    s->side[s->sides++] = s->tangents;
    return status;
}

/* (1/2) sum of r_k x r_k+1 around the net's outermost points: of the polygon, which is as good. */
static void add_area(const taut_direction_sheet *sheet, double area[3])
{
    const taut_surface *surface = sheet->surface;
    const int nu = taut_basis_count(taut_surface_u(surface));
    const int nv = taut_basis_count(taut_surface_v(surface));
    const double *points = taut_surface_points(surface);
    const int around = 2 * (nu - 1) + 2 * (nv - 1);
    double last[3] = {0, 0, 0};

    for (int k = 0; k <= around; k++) {
        const int m = k % around;
        const int i = m < nu                ? m
                      : m < nu + nv - 1     ? nu - 1
                      : m < 2 * nu + nv - 2 ? 2 * nu + nv - 3 - m
                                            : 0;
        const int j = m < nu                ? 0
                      : m < nu + nv - 1     ? m - nu + 1
                      : m < 2 * nu + nv - 2 ? nv - 1
                                            : around - m;
        double r[3], turned[3];
        taut_difference(points + 3 * ((size_t)i * (size_t)nv + (size_t)j), points, r);
        taut_cross(last, r, turned);
        taut_add_scaled(sheet->sign, turned, area);
        memcpy(last, r, sizeof last);
    }
}

static taut_status take_samples(const taut_direction_film *film, taut_arena *arena, samples *s)
{
    const int most = film->sheet_count <= MANY ? LINES_MAX : LINES_OF_MANY;
    size_t tangents = 0;
    taut_status status = TAUT_OK;

    for (int k = 0; k < film->side_count; k++) {
        const taut_surface *surface = film->sheets[film->sides[k].sheet].surface;
        tangents += (size_t)taut_basis_span_count(
            film->sides[k].edge >= 2 ? taut_surface_u(surface) : taut_surface_v(surface));
    }
    s->side = taut_arena_take(arena, (size_t)film->side_count, sizeof(int));
    s->tangent = taut_arena_take(arena, tangents * ON_SPAN, 3 * sizeof(double));
    s->normal = taut_arena_take(arena, (size_t)film->sheet_count * (size_t)(most * most),
                                3 * sizeof(double));
    status = taut_arena_status(arena);
    for (int p = 0; status == TAUT_OK && p < film->sheet_count; p++) {
        status = sample_normals(&film->sheets[p], most, arena, s);
        add_area(&film->sheets[p], s->area);
    }
    for (int k = 0; status == TAUT_OK && k < film->side_count; k++) {
        const taut_direction_side *side = &film->sides[k];
        status = sample_side(film->sheets[side->sheet].surface, side, arena, s);
    }
    return status;
}

/* ---- candidates ---- */

/* The angle that the boundary turns back along e; corners may turn by any angle to the left. */
static double turned_back(const samples *s, const double e[3])
{
    double back = 0;

    for (int k = 0; k < s->tangents; k++) {
        const double *t = s->tangent + 3 * (size_t)k;
        const double *next = s->tangent + 3 * (size_t)((k + 1) % s->tangents);
        const double up = taut_dot(t, e), next_up = taut_dot(next, e);
        const double turn = taut_det(t, next, e);
        if (turn < 0) {
            back -= turn / sqrt((1 - up * up) * (1 - next_up * next_up));
        }
    }
    return back;
}

/* Takes e, or where it points down -e, if it is allowed and `better` times better. */
static void try_direction(const samples *s, const double given[3], double better, best *b)
{
    double e[3] = {given[0], given[1], given[2]}, least = 1;

    if (!make_unit(e)) {
        return;
    }
    if (taut_dot(s->normal, e) < 0) {
        for (int c = 0; c < 3; c++) {
            e[c] = 0 - e[c];
        }
    }
    for (int k = 0; k < s->normals && least > better * b->least; k++) {
        least = fmin(least, taut_dot(s->normal + 3 * (size_t)k, e));
    }
    if (least > better * b->least && turned_back(s, e) <= limits.turned_back) {
        memcpy(b->e, e, sizeof b->e);
        b->least = least;
    }
}

/* The normal of the plane of a side that lies in one and is not straight. */
static int find_plane(const samples *s, int side, double normal[3])
{
    const int first = side > 0 ? s->side[side - 1] : 0;
    const double *t = s->tangent + 3 * (size_t)first;
    double most = 0;

    for (int k = first + 1; k < s->side[side]; k++) {
        double turned[3];
        taut_cross(t, s->tangent + 3 * (size_t)k, turned);
        if (taut_length(turned) > most) {
            most = taut_length(turned);
            memcpy(normal, turned, sizeof turned);
        }
    }
    if (!(most > 1e-6) || !make_unit(normal)) {
        return 0;
    }
    for (int k = first; k < s->side[side]; k++) {
        if (fabs(taut_dot(normal, s->tangent + 3 * (size_t)k)) > limits.planar) {
            return 0;
        }
    }
    return 1;
}

/* Along planes of edges: the vector area put into each, and where two of them meet. */
static void try_planes(const samples *s, best *b)
{
    double plane[PLANES_MAX][3];
    int count = 0;

    for (int k = 0; k < s->sides && count < PLANES_MAX; k++) {
        count += find_plane(s, k, plane[count]);
    }
    for (int k = 0; k < count; k++) {
        double e[3] = {s->area[0], s->area[1], s->area[2]};
        taut_add_scaled(-taut_dot(e, plane[k]), plane[k], e);
        try_direction(s, e, 1.05, b);
        for (int m = 0; m < k; m++) {
            taut_cross(plane[k], plane[m], e);
            if (taut_length(e) > 1e-6) {
                try_direction(s, e, 1.05, b);
            }
        }
    }
}

/* Points evenly on the half sphere: the golden angle. */
static void try_sphere(const samples *s, best *b)
{
    for (int k = 0; k < SPHERE; k++) {
        const double z = (k + 0.5) / SPHERE, r = sqrt(1 - z * z), angle = 2.399963229728653 * k;
        const double e[3] = {r * taut_cos(angle), r * taut_sin(angle), z};
        try_direction(s, e, 1, b);
    }
}

/* Moves the best one about by smaller and smaller steps. */
static void improve(const samples *s, best *b)
{
    double step = limits.first_move;

    for (int k = 0; k < MOVES && step > limits.last_move; k++) {
        const double before = b->least;
        double frame[3][3];
        taut_plateau_frame(b->e, frame);
        for (int way = 0; way < 4; way++) {
            double e[3];
            memcpy(e, frame[2], sizeof e);
            taut_add_scaled(way < 2 ? step : -step, frame[way % 2], e);
            try_direction(s, e, 1, b);
        }
        step = b->least > before ? step : 0.5 * step;
    }
}

static void search(const samples *s, best *b)
{
    static const double axes[3][3] = {{0, 0, 1}, {0, 1, 0}, {1, 0, 0}};

    for (int k = 0; k < 3; k++) {
        try_direction(s, axes[k], 1, b);
    }
    try_direction(s, s->area, 1.05, b);
    if (b->least < limits.good_enough) {
        try_planes(s, b);
    }
    if (b->least < limits.good_enough) {
        best other = *b;
        try_sphere(s, &other);
        if (other.least > 0) {
            improve(s, &other);
        }
        *b = other.least > 1.05 * b->least ? other : *b;
    }
}

taut_status taut_plateau_direction_of(const taut_direction_film *film, double e[3])
{
    taut_arena *arena = taut_arena_new();
    samples s = {.normals = 0};
    best found = {{0, 0, 0}, 0};
    taut_status status = arena != NULL ? take_samples(film, arena, &s) : TAUT_NO_MEMORY;

    if (status == TAUT_OK) {
        search(&s, &found);
        status = found.least > 0 ? TAUT_OK : TAUT_NO_SOLUTION;
    }
    taut_arena_free(arena);
    if (status != TAUT_OK) {
        return status;
    }
    memcpy(e, found.e, sizeof found.e);
    return TAUT_OK;
}

taut_status taut_plateau_direction(const taut_surface *surface, double e[3])
{
    static const taut_direction_side round[4] = {{0, 2, 0}, {0, 1, 0}, {0, 3, 1}, {0, 0, 1}};
    const taut_direction_sheet sheet = {surface, 1};
    const taut_direction_film film = {1, &sheet, 4, round};
    return taut_plateau_direction_of(&film, e);
}
