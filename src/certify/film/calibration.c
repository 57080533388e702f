#include "certify/film/calibration.h"

#include "certify/common/field.h"
#include "certify/common/verdict.h"
#include "certify/film/circulation.h"
#include "core/vec3.h"
#include "taut/limits.h"

#include <math.h>
#include <string.h>

enum {
    P = 4,         /* degree of psi, and of B in t */
    M = 5,         /* of g, and of B in s */
    PIECES = 4000, /* of all held edges: beyond it the witness is too sharp for them */
    LOOK = 17,     /* places each way where lengths are looked at before they are proved */
    DEPTH = 6,     /* halvings, both ways each */
    ROUND = 4
};
static const double frame_defect =
    0x1p-48;                            /* of products of rows: what rounding leaves, and more */
static const double rounding = 0x1p-40; /* of what is added up, by the frame too */
static const double tight = 1e-8; /* of m^2: so much above what is seen is all there is to prove */
static const double inside = 1e-12; /* of the size of Q: what is held lies deeper */
static const char *const edge_names[4] = {"u0", "u1", "v0", "v1"};

/* Edges and corners as they run round the film. */
static const struct {
    int edge, from, to;
    double sign;
} rounds[ROUND] = {{2, 0, 1, 1}, {1, 1, 3, 1}, {3, 3, 2, -1}, {0, 2, 0, -1}};

/* The witness, over [0, 1]^2; lengths in the sheet's unit. */
typedef struct flows {
    const taut_film_sheet *sheet;
    taut_arena *arena;
    double origin[3], frame[3][3];
    double corners[4][2];
    taut_field r[2], rs[2], rt[2], j;
    taut_field psi, b;
    taut_field g[4]; /* by edges */
    double height[4];
} flows;

/* ---- as it was written, by whoever ---- */

/* rows x columns numbers over 2^exponent; 0 where they are not there. */
static int read_rows(const taut_record *list, size_t rows, size_t columns, int exponent,
                     double *numbers)
{
    double largest = 0;

    if (taut_record_count(list) != rows) {
        return 0;
    }
    for (size_t i = 0; i < rows; i++) {
        const taut_record *row = taut_record_at(list, i);
        if (taut_record_count(row) != columns) {
            return 0;
        }
        for (size_t k = 0; k < columns; k++) {
            const double x = ldexp(taut_record_number(taut_record_at(row, k)), -exponent);
            numbers[i * columns + k] = x;
            largest = taut_certify_max(largest, fabs(x));
        }
    }
    return isfinite(largest);
}

static int read_origin(const taut_record *list, double origin[3])
{
    if (taut_record_count(list) != 3) {
        return 0;
    }
    for (size_t k = 0; k < 3; k++) {
        origin[k] = taut_record_number(taut_record_at(list, k));
    }
    return isfinite(origin[0]) && isfinite(origin[1]) && isfinite(origin[2]);
}

static int is_frame(const double frame[3][3])
{
    for (int a = 0; a < 3; a++) {
        for (int b = 0; b <= a; b++) {
            if (!(fabs(taut_dot(frame[a], frame[b]) - (a == b)) <= frame_defect)) {
                return 0;
            }
        }
    }
    return taut_det(frame[0], frame[1], frame[2]) > 0;
}

static taut_field field_of(taut_arena *arena, int p, int q, const double *numbers)
{
    taut_field f = taut_field_new(arena, p, q);
    if (f.a != NULL) {
        memcpy(f.a, numbers, (size_t)(p + 1) * (size_t)(q + 1) * sizeof(double));
    }
    return f;
}

/* Why the cables' part is none, or NULL. */
static const char *read_cables(const taut_record *list, flows *w)
{
    double numbers[(M + 1) * (M + 1)];

    for (int e = 0; e < 4; e++) {
        const taut_record *found = NULL;
        for (size_t k = 0; k < taut_record_count(list); k++) {
            const taut_record *one = taut_record_at(list, k);
            found = strcmp(taut_record_text(taut_record_get(one, "edge")), edge_names[e]) == 0
                        ? one
                        : found;
        }
        if (!taut_film_sheet_is_cable(w->sheet, e)) {
            continue;
        }
        w->height[e] = ldexp(taut_record_number(taut_record_get(found, "height")), -w->sheet->unit);
        if (!isfinite(w->height[e]) || !read_rows(taut_record_get(found, "potential"), M + 1, M + 1,
                                                  2 * w->sheet->unit, numbers)) {
            return "witness: a cable has no field in it";
        }
        w->g[e] = field_of(w->arena, M, M, numbers);
    }
    return NULL;
}

/* r over the quadrilateral, and what is made of it. */
static void lay_quadrilateral(flows *w)
{
    taut_arena *arena = w->arena;

    for (int c = 0; c < 2; c++) {
        const double net[4] = {w->corners[0][c], w->corners[3][c], w->corners[1][c],
                               w->corners[2][c]};
        w->r[c] = field_of(arena, 1, 1, net);
        w->rs[c] = taut_field_du(arena, &w->r[c]);
        w->rt[c] = taut_field_dv(arena, &w->r[c]);
    }
    const taut_field a = taut_field_product(arena, &w->rs[0], &w->rt[1]),
                     b = taut_field_product(arena, &w->rs[1], &w->rt[0]);
    w->j = taut_field_difference(arena, &a, &b);
}

static const char *read_witness(const taut_record *witness, flows *w)
{
    const int unit = w->sheet->unit;
    double numbers[(M + 1) * (M + 1)];

    if (!read_origin(taut_record_get(witness, "origin"), w->origin) ||
        !read_rows(taut_record_get(witness, "frame"), 3, 3, 0, w->frame[0]) ||
        !is_frame((const double(*)[3])w->frame)) {
        return "witness: invalid frame";
    }
    if (!read_rows(taut_record_get(witness, "quadrilateral"), 4, 2, unit, w->corners[0])) {
        return "witness: invalid quadrilateral";
    }
    lay_quadrilateral(w);
    if (!read_rows(taut_record_get(witness, "psi"), P + 1, P + 1, unit, numbers)) {
        return "witness: its \"psi\" has not 5 x 5 numbers";
    }
    w->psi = field_of(w->arena, P, P, numbers);
    if (!read_rows(taut_record_get(witness, "potential"), M + 1, P + 1, 2 * unit, numbers)) {
        return "witness: its \"potential\" has not 6 x 5 numbers";
    }
    w->b = field_of(w->arena, M, P, numbers);
    return read_cables(taut_record_get(witness, "cables"), w);
}

/* ---- what it holds ---- */

/* A point of the model in the frame. */
static void find_point(const flows *w, const double *point, double x[3])
{
    double from[3];

    for (int c = 0; c < 3; c++) {
        from[c] = ldexp(point[c] - w->origin[c], -w->sheet->unit);
    }
    for (int c = 0; c < 3; c++) {
        x[c] = taut_dot(w->frame[c], from);
    }
}

static const double *corner_of(const flows *w, int c)
{
    const size_t i = (size_t)(c % 2 * (w->sheet->nu - 1)), j = (size_t)(c / 2 * (w->sheet->nv - 1));
    return taut_surface_points(w->sheet->surface) + 3 * (i * (size_t)w->sheet->nv + j);
}

static int is_inside(const flows *w, const double *point)
{
    double x[3];

    find_point(w, point, x);
    for (int k = 0; k < ROUND; k++) {
        const double *a = w->corners[k], *b = w->corners[(k + 1) % ROUND];
        const double side[2] = {b[0] - a[0], b[1] - a[1]};
        const double in = side[0] * (x[1] - a[1]) - side[1] * (x[0] - a[0]);
        if (!(in > inside * (side[0] * side[0] + side[1] * side[1]))) {
            return 0;
        }
    }
    return 1;
}

/* Held edges lie in the hull of their points. */
static int holds_all(const flows *w)
{
    for (int k = 0; k < ROUND; k++) {
        size_t first = 0, step = 0;
        int count = 0;
        taut_film_sheet_edge(w->sheet, rounds[k].edge, &first, &step, &count);
        const int stride = taut_film_sheet_is_cable(w->sheet, rounds[k].edge) ? count - 1 : 1;
        for (int i = 0; i < count; i += stride) {
            if (!is_inside(w, taut_surface_points(w->sheet->surface) +
                                  3 * (first + (size_t)i * step))) {
                return 0;
            }
        }
    }
    return 1;
}

/* ---- the largest length ---- */

/* |N|^2 over 1 or R^2, N times J what X or A_k is. */
static taut_field square_of(const flows *w, int edge)
{
    taut_arena *arena = w->arena;
    taut_field n[3];

    const taut_field s =
        edge < 0 ? taut_field_du(arena, &w->psi) : taut_field_du(arena, &w->g[edge]);
    taut_field t = edge < 0 ? taut_field_dv(arena, &w->psi) : taut_field_dv(arena, &w->g[edge]);
    if (edge >= 0) {
        t = taut_field_sum(arena, &w->b, &t);
        const taut_field height = taut_field_constant(arena, w->height[edge]),
                         left = taut_field_difference(arena, &height, &w->psi);
        n[2] = taut_field_product(arena, &w->j, &left);
    } else {
        n[2] = taut_field_du(arena, &w->b);
    }
    for (int c = 0; c < 2; c++) {
        const taut_field a = taut_field_product(arena, &s, &w->rt[c]),
                         b = taut_field_product(arena, &t, &w->rs[c]);
        n[c] = taut_field_difference(arena, &a, &b);
    }
    return taut_field_dot(arena, n, n);
}

/* Raises *most to where square <= *most limit is proved over a cell. */
static taut_status search_cell(const taut_field *square, const taut_field *limit, int depth,
                               double *most)
{
    taut_field half[2][2], quarter[2][4];
    const taut_field *whole[2] = {square, limit};
    taut_arena *arena = taut_arena_new();
    const taut_field over = taut_field_combine(arena, 1, square, -*most, limit);
    const double high = taut_field_high(&over);
    const int is_whole = depth == 0 || !isfinite(high);

    if (high > 0 && !is_whole) {
        for (int k = 0; k < 2; k++) {
            taut_field_halve(arena, whole[k], 0, &half[k][0], &half[k][1]);
            taut_field_halve(arena, &half[k][0], 1, &quarter[k][0], &quarter[k][1]);
            taut_field_halve(arena, &half[k][1], 1, &quarter[k][2], &quarter[k][3]);
        }
    } else if (!(high <= 0)) {
        *most += high / taut_field_low(limit) * (1 + 0x1p-40); /* NaN stays */
    }
    taut_status status = taut_arena_status(arena);
    for (int k = 0; status == TAUT_OK && high > 0 && !is_whole && k < 4; k++) {
        status = search_cell(&quarter[0][k], &quarter[1][k], depth - 1, most);
    }
    taut_arena_free(arena);
    return status;
}

/* The largest that is seen, by which the search begins: no proof. */
static double look(const taut_field *square, const taut_field *limit)
{
    double most = 0;

    for (int k = 0; k < LOOK * LOOK; k++) {
        const double s = (double)(k / LOOK) / (LOOK - 1), t = (double)(k % LOOK) / (LOOK - 1);
        most =
            taut_certify_max(most, taut_field_value(square, s, t) / taut_field_value(limit, s, t));
    }
    return most;
}

/* m^2 over all fields; infinite or NaN where it is not found. */
static taut_status find_longest(const flows *w, double *most)
{
    const taut_field jj = taut_field_product(w->arena, &w->j, &w->j);
    taut_status status = TAUT_OK;

    *most = 0;
    for (int e = -1; status == TAUT_OK && e < 4; e++) {
        if (e >= 0 && !taut_film_sheet_is_cable(w->sheet, e)) {
            continue;
        }
        const double r = e < 0 ? 1 : w->sheet->ratios[e];
        const taut_field square = square_of(w, e), zero = taut_field_constant(w->arena, 0),
                         limit = taut_field_combine(w->arena, r * r, &jj, 0, &zero);
        status = taut_arena_status(w->arena);
        if (status == TAUT_OK) {
            *most = taut_certify_max(*most, look(&square, &limit) * (1 + tight));
            status = search_cell(&square, &limit, DEPTH, most);
        }
    }
    return status;
}

/* ---- the flux ---- */

/* Along held edge e, as its points run; span by span, by Bernstein coefficients. */
static taut_status add_edge(const flows *w, int e, double sign, int *pieces, taut_film_total *flux)
{
    const taut_surface *surface = w->sheet->surface;
    const taut_basis *basis = e < 2 ? taut_surface_v(surface) : taut_surface_u(surface);
    const taut_film_flow flow = {(const double(*)[2])w->corners, &w->b, &w->psi};
    taut_status status = TAUT_OK;

    for (int k = 0; status == TAUT_OK && k < taut_basis_span_count(basis); k++) {
        double points[3 * (TAUT_DEGREE_MAX + 1)];
        taut_field x[4];
        if (!taut_field_of_edge(w->arena, surface, e, k, w->origin, w->sheet->unit, x) ||
            x[0].p > TAUT_DEGREE_MAX || x[3].p > 0) {
            flux->off = INFINITY;
            return TAUT_OK;
        }
        for (int i = 0; taut_arena_status(w->arena) == TAUT_OK && i <= x[0].p; i++) {
            const double from[3] = {x[0].a[i], x[1].a[i], x[2].a[i]};
            for (int c = 0; c < 3; c++) {
                points[3 * i + c] = taut_dot(w->frame[c], from);
            }
        }
        status = taut_arena_status(w->arena) == TAUT_OK
                     ? taut_film_circulate(&flow, x[0].p, points, sign, pieces, flux)
                     : TAUT_NO_MEMORY;
    }
    return status;
}

/* What the ends of cables add. */
static void add_ends(const flows *w, taut_film_total *flux)
{
    const taut_film_flow flow = {(const double(*)[2])w->corners, &w->b, &w->psi};

    for (int k = 0; k < ROUND; k++) {
        const int e = rounds[k].edge;
        for (int end = 0; end < 2 && taut_film_sheet_is_cable(w->sheet, e); end++) {
            const double sign = end == 0 ? 1 : -1;
            double x[3], st[2], g = 0;
            find_point(w, corner_of(w, end == 0 ? rounds[k].from : rounds[k].to), x);
            const double doubt = taut_film_locate(&flow, x, st);
            flux->off += taut_film_flow_value(&w->g[e], st, doubt, &g) +
                         rounding * fabs(w->height[e] * x[2]);
            flux->sum += sign * g;
            flux->sum += sign * w->height[e] * x[2];
        }
    }
}

static taut_status find_flux(const flows *w, double *flux, double *off)
{
    taut_film_total total = {0, 0};
    taut_status status = TAUT_OK;
    int pieces = PIECES;

    for (int k = 0; status == TAUT_OK && k < ROUND; k++) {
        const int e = rounds[k].edge;
        if (!taut_film_sheet_is_cable(w->sheet, e)) {
            status = add_edge(w, e, rounds[k].sign, &pieces, &total);
        }
    }
    add_ends(w, &total);
    *flux = total.sum;
    *off = total.off + rounding * fabs(total.sum);
    return status;
}

static taut_status judge(const flows *w, taut_film_calibration *calibration)
{
    double most = NAN;

    if (!(taut_field_low(&w->j) > 0)) {
        calibration->why = "witness: its quadrilateral is not convex";
        return TAUT_OK;
    }
    if (!holds_all(w)) {
        calibration->why = "outside: what is held reaches beyond the witness";
        return TAUT_OK;
    }
    taut_status status = find_longest(w, &most);
    if (status == TAUT_OK) {
        status = find_flux(w, &calibration->flux, &calibration->off);
    }
    if (status != TAUT_OK) {
        return status;
    }
    calibration->flux /= sqrt(most);
    calibration->off /= sqrt(most);
    calibration->why =
        !(most > 0) || !isfinite(calibration->flux) ? "range: " TAUT_CERTIFY_OUT_OF_RANGE
        : !isfinite(calibration->off)
            ? "sharp: the witness bends too sharply along a held edge for a bound of its flux"
            : NULL;
    return TAUT_OK;
}

taut_status taut_film_calibrate(const taut_film_sheet *sheet, const taut_record *witness,
                                taut_film_calibration *calibration)
{
    flows w = {.sheet = sheet, .arena = taut_arena_new()};
    taut_status status = TAUT_OK;

    *calibration = (taut_film_calibration){.why = read_witness(witness, &w)};
    status = taut_arena_status(w.arena);
    if (status == TAUT_OK && calibration->why == NULL) {
        status = judge(&w, calibration);
    }
    if (status == TAUT_OK) {
        status = taut_arena_status(w.arena);
    }
    taut_arena_free(w.arena);
    return status;
}
