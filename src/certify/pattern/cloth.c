#include "certify/pattern/cloth.h"

#include "certify/common/unit.h"
#include "certify/pattern/fade.h"
#include "core/fail.h"
#include "core/vec3.h"
#include "geometry/exponent.h"
#include "geometry/keep.h"
#include "geometry/stretch.h"

#include <stdio.h>
#include <string.h>

/* Of lengths of one line, found twice. */
static const double same_length = 1e-10;
/* Of an edge that is none, over the size. */
static const double no_length = 1e-9;
enum { POINT_PLACES = 16 };

static const char *const edge_names[TAUT_CLOTH_EDGES] = {"right", "end", "left", "start"};

static void miss(taut_cloth *cloth, const char *what)
{
    if (cloth->missing++ == 0) {
        snprintf(cloth->where, sizeof cloth->where, "%.80s", what);
    }
}

static const taut_curve *curve_named(const taut_model *model, const char *name)
{
    for (int i = 0; i < taut_model_curve_count(model); i++) {
        if (strcmp(taut_curve_name(taut_model_curve(model, i)), name) == 0) {
            return taut_model_curve(model, i);
        }
    }
    return NULL;
}

/* A line of a piece: plane, and over [0, 1] or [0, 4]. */
static const taut_curve *line_of(taut_cloth *cloth, const char *piece, const char *what, double hi)
{
    char name[TAUT_NAME_MAX + 16];
    snprintf(name, sizeof name, "%s.%s", piece, what);
    const taut_curve *curve = curve_named(cloth->model, name);
    const taut_basis *basis = curve != NULL ? taut_curve_t(curve) : NULL;
    int is_fine = basis != NULL && taut_curve_weights(curve) == NULL &&
                  strcmp(taut_basis_type(basis), "bspline") == 0 && taut_basis_lo(basis) == 0 &&
                  taut_basis_hi(basis) == hi;
    for (int k = 0; is_fine && k < taut_basis_count(basis); k++) {
        is_fine = taut_curve_points(curve)[3 * k + 2] == 0;
    }
    if (!is_fine) {
        miss(cloth, name);
    }
    return is_fine ? curve : NULL;
}

/* ---- sides ---- */

/* The scaled surface that an object of details says it belongs to, or the only one; NULL. */
static const taut_surface *surface_of(const taut_cloth *cloth, const taut_record *object)
{
    const char *name = taut_record_text(taut_record_get(object, "surface"));
    for (int k = 0; k < cloth->surface_count; k++) {
        if (!cloth->is_several ||
            strcmp(taut_surface_name(taut_model_surface(cloth->model, k)), name) == 0) {
            return cloth->surfaces[k];
        }
    }
    return NULL;
}

static int side_named(const taut_cloth *cloth, const taut_surface *on, const char *name)
{
    for (int k = 0; k < cloth->side_count; k++) {
        if (cloth->sides[k].on == on && strcmp(cloth->sides[k].name, name) == 0) {
            return k;
        }
    }
    return -1;
}

static const taut_record *object_named(const taut_record *list, const char *name)
{
    for (size_t k = 0; k < taut_record_count(list); k++) {
        if (strcmp(taut_record_text(taut_record_get(taut_record_at(list, k), "name")), name) == 0) {
            return taut_record_at(list, k);
        }
    }
    return NULL;
}

static taut_status read_sides(taut_cloth *cloth, const taut_record *details, taut_arena *arena)
{
    const taut_record *domain = taut_record_get(details, "domain");
    const size_t count = taut_record_count(domain);

    cloth->sides = taut_arena_take(arena, count + 1, sizeof *cloth->sides);
    if (cloth->sides == NULL) {
        return TAUT_NO_MEMORY;
    }
    for (size_t k = 0; k < count; k++) {
        const taut_record *item = taut_record_at(domain, k);
        const char *name = taut_record_text(taut_record_get(item, "name"));
        taut_cloth_side *side = &cloth->sides[cloth->side_count];
        taut_curve *window = NULL;
        const taut_status status = taut_stretch_read(item, arena, &window);
        if (status != TAUT_OK) {
            return status;
        }
        const taut_surface *on = surface_of(cloth, item);
        if (window == NULL || on == NULL || side_named(cloth, on, name) >= 0) {
            miss(cloth, name);
            continue;
        }
        *side = (taut_cloth_side){.name = name,
                                  .on = on,
                                  .mate = -1,
                                  .window = window,
                                  .share = (double)NAN,
                                  .length = ldexp(taut_basis_hi(taut_curve_t(window)) -
                                                      taut_basis_lo(taut_curve_t(window)),
                                                  -cloth->unit)};
        cloth->side_count++;
    }
    return TAUT_OK;
}

/* ---- pieces ---- */

/* The flat surface of a name: polynomial, over [0, 1]^2, in the plane. */
static taut_status take_flat(taut_cloth *cloth, taut_cloth_piece *piece, taut_arena *arena)
{
    for (int i = cloth->surface_count; i < taut_model_surface_count(cloth->model); i++) {
        const taut_surface *one = taut_model_surface(cloth->model, i);
        const taut_basis *bases[2] = {taut_surface_u(one), taut_surface_v(one)};
        taut_surface *scaled = NULL;
        int is_fine = strcmp(taut_surface_name(one), piece->name) == 0;
        for (int d = 0; is_fine && d < 2; d++) {
            is_fine = strcmp(taut_basis_type(bases[d]), "bspline") == 0 &&
                      taut_basis_lo(bases[d]) == 0 && taut_basis_hi(bases[d]) == 1 &&
                      taut_basis_degree(bases[d]) == 5;
        }
        const int count = is_fine ? taut_basis_count(bases[0]) * taut_basis_count(bases[1]) : 0;
        for (int k = 0; k < count; k++) {
            is_fine &= taut_surface_points(one)[3 * k + 2] == 0;
        }
        if (!is_fine || taut_surface_weights(one) != NULL) {
            continue;
        }
        piece->index = i;
        if (taut_certify_scaled(one, cloth->unit, &scaled) != TAUT_OK ||
            !taut_keep_surface(arena, scaled)) {
            return TAUT_NO_MEMORY;
        }
        piece->flat = scaled;
        return TAUT_OK;
    }
    return TAUT_OK;
}

/* The seam that a side is: its curve in space over the same range. */
static void take_seam(taut_cloth *cloth, taut_cloth_side *side, const char *name)
{
    const taut_record *seams = taut_record_get(taut_model_details(cloth->model), "seams");
    const taut_record *seam = object_named(seams, name);
    const taut_record *share = taut_record_get(seam, "compensation");
    const taut_basis *window = taut_curve_t(side->window), *space = NULL;
    if (side->seam != NULL) {
        if (strcmp(side->seam, name) != 0) {
            miss(cloth, name);
        }
        return;
    }
    side->seam = name;
    side->kind = taut_record_text(taut_record_get(seam, "kind"));
    side->share = share != NULL ? 1 - taut_record_number(share) : (double)NAN;
    side->space = curve_named(cloth->model, name);
    space = side->space != NULL ? taut_curve_t(side->space) : NULL;
    /* of the other border of a ring it is that one's, which is as long up to rounding */
    const double length = space != NULL ? taut_basis_hi(space) - taut_basis_lo(space) : (double)NAN;
    const double own = taut_basis_hi(window) - taut_basis_lo(window);
    const int is_own = strcmp(side->name, name) == 0;
    if (seam == NULL || space == NULL ||
        !(fabs(length - own) <= (is_own ? 0 : same_length * own))) {
        miss(cloth, name);
        side->space = NULL;
    }
}

/* What an edge is part of. Right and left are part of a side; the others too where they are sewn. */
static void take_side(taut_cloth *cloth, taut_cloth_piece *piece, int e, const taut_record *edge)
{
    const taut_record *seam = taut_record_get(edge, "seam");
    const taut_record *border = taut_record_get(edge, "edge");
    const taut_record *part = taut_record_get(edge, "part");
    const int side = side_named(cloth, piece->on, taut_record_text(border != NULL ? border : seam));
    piece->sides[e] = side;
    const taut_record *share = taut_record_get(edge, "compensation");
    piece->is_sewn[e] = seam != NULL;
    piece->held[e] = seam == NULL && share != NULL ? 1 - taut_record_number(share) : (double)NAN;
    piece->part[e][0] = part != NULL ? taut_record_number(taut_record_at(part, 0)) : 0;
    piece->part[e][1] = part != NULL ? taut_record_number(taut_record_at(part, 1)) : 1;
    const int needs_one = seam != NULL || e == TAUT_CLOTH_RIGHT || e == TAUT_CLOTH_LEFT;
    if ((needs_one && side < 0) || !(piece->part[e][0] >= 0) || !(piece->part[e][1] <= 1) ||
        !(piece->part[e][0] < piece->part[e][1])) {
        miss(cloth, piece->name);
        return;
    }
    if (seam != NULL) {
        const int is_turned = taut_record_get(edge, "turned") != NULL;
        if (cloth->sides[side].seam != NULL && cloth->sides[side].is_turned != is_turned) {
            miss(cloth, piece->name);
        }
        cloth->sides[side].is_turned = is_turned;
        take_seam(cloth, &cloth->sides[side], taut_record_text(seam));
    }
}

/* What is told of an edge's cloth beyond it. */
static void take_allowance(taut_cloth_piece *piece, int e, const taut_record *edge)
{
    static const char *const borders[] = {"u0", "u1", "v0", "v1"};
    const taut_record *left = taut_record_get(edge, "allowance");
    const char *name = taut_record_text(taut_record_get(edge, "edge"));
    piece->allowance[e] = left != NULL ? taut_record_number(left) : 0;
    piece->border[e] = -1;
    for (int k = 0; k < 4 && taut_record_get(edge, "seam") == NULL; k++) {
        piece->border[e] = strcmp(name, borders[k]) == 0 ? k : piece->border[e];
    }
}

static taut_status read_piece(taut_cloth *cloth, const taut_record *item, const taut_record *roll,
                              taut_arena *arena)
{
    taut_cloth_piece *piece = &cloth->pieces[cloth->piece_count];
    const taut_record *edges = taut_record_get(item, "edges");
    const int before = cloth->missing;

    *piece = (taut_cloth_piece){.name = taut_record_text(taut_record_get(item, "name")),
                                .on = surface_of(cloth, item)};
    if (piece->on == NULL) {
        miss(cloth, piece->name);
        piece->on = cloth->surfaces[0];
    }
    const taut_status status = take_flat(cloth, piece, arena);
    if (status != TAUT_OK) {
        return status;
    }
    if (piece->flat == NULL) {
        miss(cloth, piece->name);
    }
    for (int k = 0; k < cloth->piece_count; k++) {
        if (strcmp(cloth->pieces[k].name, piece->name) == 0) { /* one flat piece for two */
            miss(cloth, piece->name);
        }
    }
    for (int e = 0; e < TAUT_CLOTH_EDGES; e++) {
        take_side(cloth, piece, e, taut_record_get(edges, edge_names[e]));
        piece->edges[e] = line_of(cloth, piece->name, edge_names[e], 1);
        take_allowance(piece, e, taut_record_get(edges, edge_names[e]));
    }
    piece->cut = line_of(cloth, piece->name, "cut", 4);
    const taut_record *developed = taut_record_get(item, "developed");
    piece->is_developed = developed != NULL && taut_record_kind_of(developed) == TAUT_RECORD_BOOL &&
                          taut_record_bool(developed);
    const taut_record *on = object_named(roll, piece->name), *at = taut_record_get(on, "at");
    const taut_record *turned = taut_record_get(on, "turned");
    piece->is_turned = turned != NULL && taut_record_kind_of(turned) == TAUT_RECORD_BOOL &&
                       taut_record_bool(turned);
    piece->is_placed = taut_record_count(at) == 2;
    for (size_t d = 0; piece->is_placed && d < 2; d++) {
        piece->at[d] = taut_record_number(taut_record_at(at, d));
    }
    cloth->piece_count += cloth->missing == before;
    return TAUT_OK;
}

/* ---- what was asked for ---- */

static double number_of(const taut_record *object, const char *key)
{
    const taut_record *found = taut_record_get(object, key);
    return found != NULL ? taut_record_number(found) : 0;
}

/* What a prestress s makes of warp and weft: (e_w, e_f) solves s = D e. */
static void take_prestress(taut_cloth *cloth, const taut_pattern_material *m)
{
    const double s[2] = {cloth->problem->prestress.warp, cloth->problem->prestress.weft};
    const double d = 1 - m->nu * m->nu * m->e[1] / m->e[0];
    const double d11 = m->e[0] / d, d22 = m->e[1] / d, d12 = m->nu * m->e[1] / d;
    const double det = d11 * d22 - d12 * d12;
    const double e[2] = {(d22 * s[0] - d12 * s[1]) / det, (d11 * s[1] - d12 * s[0]) / det};
    cloth->warp = 1 - 1 / (1 + e[0]);
    cloth->weft = 1 - 1 / (1 + e[1]);
}

static void take_asked(taut_cloth *cloth, const taut_record *details)
{
    const taut_record *told = taut_record_get(details, "cloth");
    const taut_record *material = taut_record_get(told, "material");
    const taut_record *share = taut_record_get(details, "compensation");
    const taut_record *moduli = taut_record_get(material, "E");
    taut_pattern_material m = {{taut_record_number(taut_record_at(moduli, 0)),
                                taut_record_number(taut_record_at(moduli, 1))},
                               number_of(material, "nu"),
                               number_of(material, "G")};

    cloth->is_true = strcmp(taut_record_text(taut_record_get(details, "seam_length")), "true") == 0;
    cloth->is_straight =
        strcmp(taut_record_text(taut_record_get(details, "ends")), "straight") == 0;
    cloth->is_conformal =
        strcmp(taut_record_text(taut_record_get(details, "flatten")), "conformal") == 0;
    cloth->has_seam = taut_record_get(share, "seam") != NULL;
    cloth->seam = number_of(share, "seam");
    cloth->warp = number_of(share, "warp");
    cloth->weft = number_of(share, "weft");
    cloth->thread = number_of(told, "thread");
    cloth->strain = number_of(details, "strain");
    cloth->has_law = material != NULL;
    if (cloth->problem != NULL) {
        m = cloth->problem->cloth.material;
        cloth->has_law = m.g > 0;
        cloth->is_conformal = cloth->problem->flatten == TAUT_PATTERN_CONFORMAL;
        cloth->is_true = cloth->problem->seam_length == TAUT_PATTERN_TRUE || cloth->is_conformal;
        cloth->is_straight = cloth->problem->ends == TAUT_PATTERN_ENDS_STRAIGHT;
        cloth->has_seam = cloth->problem->compensation.has_seam;
        cloth->seam = cloth->problem->compensation.seam;
        cloth->warp = cloth->problem->compensation.warp;
        cloth->weft = cloth->problem->compensation.weft;
        cloth->thread = cloth->problem->cloth.thread;
        cloth->strain = cloth->problem->strain;
        for (int k = 0; !(cloth->problem->strain > 0) && k < cloth->problem->rule_count; k++) {
            cloth->strain = fmax(cloth->strain, cloth->problem->rules[k].strain);
        }
    }
    if (cloth->problem != NULL && cloth->problem->has_prestress) {
        take_prestress(cloth, &m);
    }
    const double plain[4] = {1, 1, 0, 0.5};
    memcpy(cloth->law, plain, sizeof plain);
    if (cloth->has_law) {
        const double d = m.e[0] - m.nu * m.nu * m.e[1]; /* D times d/E_w, over E_w */
        cloth->law[0] = m.e[0] / d;
        cloth->law[1] = m.e[1] / d;
        cloth->law[2] = m.nu * m.e[1] / d;
        cloth->law[3] = m.g / m.e[0];
    }
}

/* Start and end whose coefficients are one and which have no length on the surface: the piece has three sides. */
static void find_points(taut_cloth *cloth, taut_cloth_piece *piece)
{
    const int count[2] = {taut_basis_count(taut_surface_u(piece->flat)),
                          taut_basis_count(taut_surface_v(piece->flat))};
    const double *net = taut_surface_points(piece->flat);
    for (int end = 0; end < 2; end++) {
        const double *row = net + (end == 0 ? 0 : 3 * (count[0] - 1) * count[1]);
        int all = 1;
        for (int k = 1; k < count[1]; k++) {
            all &= row[3 * k] == row[0] && row[3 * k + 1] == row[1];
        }
        for (int k = 0; all && k <= POINT_PLACES; k++) {
            double g[3] = {0, 0, 0};
            taut_cloth_metric(cloth, piece, end, (double)k / POINT_PLACES, g);
            all = g[2] <= no_length * no_length * cloth->size * cloth->size;
        }
        piece->is_point[end == 0 ? TAUT_CLOTH_START : TAUT_CLOTH_END] = all;
    }
}

/* Those that are cut: the first one, or where pieces say which they are part of all but the flat ones. In one unit. */
static taut_status read_surfaces(taut_cloth *cloth, const taut_record *pieces, taut_arena *arena)
{
    const int all = taut_model_surface_count(cloth->model);
    const int count = all - (int)taut_record_count(pieces);
    taut_surface **surfaces = NULL;
    cloth->is_several = taut_record_get(taut_record_at(pieces, 0), "surface") != NULL;
    cloth->surface_count = cloth->is_several && count > 1 ? count : 1;
    cloth->surfaces = surfaces =
        taut_arena_take(arena, (size_t)cloth->surface_count, sizeof *surfaces);
    if (surfaces == NULL) {
        return TAUT_NO_MEMORY;
    }
    cloth->unit = taut_certify_unit_of(taut_model_surface(cloth->model, 0));
    for (int k = 1; k < cloth->surface_count; k++) {
        const int unit = taut_certify_unit_of(taut_model_surface(cloth->model, k));
        cloth->unit = unit > cloth->unit ? unit : cloth->unit;
    }
    cloth->size = 0;
    for (int k = 0; k < cloth->surface_count; k++) {
        if (taut_certify_scaled(taut_model_surface(cloth->model, k), cloth->unit, &surfaces[k]) !=
                TAUT_OK ||
            !taut_keep_surface(arena, surfaces[k])) {
            return TAUT_NO_MEMORY;
        }
        const double size =
            2 * taut_half_size(taut_point_count(surfaces[k]), taut_surface_points(surfaces[k]));
        cloth->size = size > cloth->size ? size : cloth->size;
    }
    return TAUT_OK;
}

/* Caps: a tip on a border, and a circle opposite to it. */
static void find_caps(const taut_cloth *cloth, taut_cloth_piece *piece)
{
    static const int ends[2] = {TAUT_CLOTH_START, TAUT_CLOTH_END};
    for (int k = 0; k < 2; k++) {
        const int side = piece->sides[ends[k]], tip = ends[1 - k];
        const char *kind = side >= 0 ? cloth->sides[side].kind : NULL;
        const int is_cap = kind != NULL && strcmp(kind, "circle") == 0 && piece->is_point[tip] &&
                           piece->border[tip] >= 0;
        piece->kept[k] = is_cap ? 2 - piece->border[tip] / 2 : 0;
    }
}

/* Where two surfaces are sewn to each other. */
static void find_mates(taut_cloth *cloth)
{
    for (int i = 0; i < cloth->side_count; i++) {
        for (int k = 0; k < cloth->side_count; k++) {
            const taut_cloth_side *a = &cloth->sides[i], *b = &cloth->sides[k];
            if (a->on == b->on || a->seam == NULL || b->seam == NULL ||
                strcmp(a->seam, b->seam) != 0) {
                continue;
            }
            if (a->mate >= 0) { /* three of them */
                miss(cloth, a->seam);
            }
            cloth->sides[i].mate = k;
        }
    }
}

int taut_cloth_is_first(const taut_cloth *cloth, const taut_cloth_piece *piece, int edge)
{
    const int side = piece->sides[edge], mate = cloth->sides[side].mate;
    return mate < 0 ? taut_cloth_hand(edge) == 0 : side < mate;
}

taut_status taut_cloth_read(taut_arena *arena, const taut_model *model,
                            const taut_pattern_problem *problem, taut_cloth *cloth,
                            taut_error *error)
{
    const taut_record *details = taut_model_details(model);
    const taut_record *list = taut_record_get(details, "pieces");
    const taut_record *roll = taut_record_get(taut_record_get(details, "roll"), "pieces");
    const size_t count = taut_record_count(list);

    cloth->model = model;
    cloth->problem = problem;
    if (taut_model_surface_count(model) == 0) {
        return taut_fail(error, TAUT_BAD_INPUT, "model", "/surfaces", taut_none, taut_none,
                         "the model has no surface, and so no pattern");
    }
    if (count == 0) {
        return taut_fail(error, TAUT_BAD_INPUT, "details", "/details/pieces", taut_none, taut_none,
                         "the model does not say which its pieces are");
    }
    if (read_surfaces(cloth, list, arena) != TAUT_OK) {
        return taut_fail_memory(error);
    }
    take_asked(cloth, details);
    cloth->pieces = taut_arena_take(arena, count, sizeof *cloth->pieces);
    taut_status status = cloth->pieces != NULL ? read_sides(cloth, details, arena) : TAUT_NO_MEMORY;
    for (size_t k = 0; status == TAUT_OK && k < count; k++) {
        status = read_piece(cloth, taut_record_at(list, k), roll, arena);
    }
    if (status == TAUT_OK) {
        find_mates(cloth);
    }
    for (int k = 0; status == TAUT_OK && k < cloth->piece_count; k++) {
        find_points(cloth, &cloth->pieces[k]);
        find_caps(cloth, &cloth->pieces[k]);
    }
    if (status == TAUT_OK) {
        status = taut_cloth_read_fades(cloth, arena);
    }
    return status == TAUT_OK ? TAUT_OK : taut_fail_memory(error);
}

/* ---- places ---- */

void taut_cloth_side_at(const taut_cloth_side *side, double share, double at[2])
{
    const taut_basis *basis = taut_curve_t(side->window);
    const double lo = taut_basis_lo(basis), hi = taut_basis_hi(basis);
    const double *points = taut_curve_points(side->window);
    double x[3];
    if (share > 0 && share < 1) {
        taut_curve_eval(side->window, lo + share * (hi - lo), 0, x);
    } else { /* exactly */
        memcpy(x, points + (share > 0 ? 3 * (taut_basis_count(basis) - 1) : 0), sizeof x);
    }
    memcpy(at, x, 2 * sizeof(double));
}

/* An edge at x, and its derivatives by x up to `order`, at most 2. */
static void edge_at(const taut_cloth *cloth, const taut_cloth_piece *piece, int e, double x,
                    int order, double w[3][2])
{
    const taut_curve *side = cloth->sides[piece->sides[e]].window;
    const double *part = piece->part[e];
    const double lo = taut_basis_lo(taut_curve_t(side)), hi = taut_basis_hi(taut_curve_t(side));
    const double share = x < 1 ? part[0] + x * (part[1] - part[0]) : part[1];
    const double range = (part[1] - part[0]) * (hi - lo);
    double c[3][3] = {{0}};
    taut_curve_eval(side, share < 1 ? lo + share * (hi - lo) : hi, order, c[0]);
    for (int d = 0; d < 2; d++) {
        w[0][d] = c[0][d];
        w[1][d] = range * c[1][d];
        w[2][d] = range * range * c[2][d];
    }
}

void taut_cloth_across_at(const taut_cloth *cloth, const taut_cloth_piece *piece, double s,
                          int order, taut_cloth_across *across)
{
    across->piece = piece;
    across->s = s;
    edge_at(cloth, piece, TAUT_CLOTH_RIGHT, s, order, across->sides[0]);
    edge_at(cloth, piece, TAUT_CLOTH_LEFT, s, order, across->sides[1]);
    for (int end = 0; end < 2; end++) {
        if (piece->sides[end == 0 ? TAUT_CLOTH_START : TAUT_CLOTH_END] >= 0) {
            double at[3][2];
            edge_at(cloth, piece, TAUT_CLOTH_RIGHT, end, 0, at);
            memcpy(across->corners[end][0], at[0], sizeof at[0]);
            edge_at(cloth, piece, TAUT_CLOTH_LEFT, end, 0, at);
            memcpy(across->corners[end][1], at[0], sizeof at[0]);
        }
    }
}

/* The patch of Coons: w, w_s, w_t, w_ss, w_st, w_tt; the last three of order 2. */
static void patch_on(const taut_cloth *cloth, const taut_cloth_across *across, double t, int order,
                     double w[6][2])
{
    const double(*right)[2] = across->sides[0], (*left)[2] = across->sides[1];
    for (int d = 0; d < 2; d++) {
        w[0][d] = (1 - t) * right[0][d] + t * left[0][d];
        w[1][d] = (1 - t) * right[1][d] + t * left[1][d];
        w[2][d] = left[0][d] - right[0][d];
        w[3][d] = (1 - t) * right[2][d] + t * left[2][d];
        w[4][d] = left[1][d] - right[1][d];
        w[5][d] = 0;
    }
    for (int end = 0; end < 2; end++) {
        const int e = end == 0 ? TAUT_CLOTH_START : TAUT_CLOTH_END;
        const double fade = end == 0 ? 1 - across->s : across->s, slope = end == 0 ? -1 : 1;
        const double(*corners)[2] = across->corners[end];
        double at[3][2];
        if (across->piece->sides[e] < 0) {
            continue;
        }
        edge_at(cloth, across->piece, e, t, order, at);
        for (int d = 0; d < 2; d++) {
            const int is_kept = across->piece->kept[end] == 1 + d;
            const double share = is_kept ? 1 : fade, change = is_kept ? 0 : slope;
            const double chord = corners[1][d] - corners[0][d];
            const double off = at[0][d] - corners[0][d] - t * chord;
            w[0][d] += share * off;
            w[1][d] += change * off;
            w[2][d] += share * (at[1][d] - chord);
            w[4][d] += change * (at[1][d] - chord);
            w[5][d] += share * at[2][d];
        }
    }
}

/* Is a place in the window? Rounding is taken off. */
static int is_in_window(const taut_surface *on, double at[2])
{
    const taut_basis *bases[2] = {taut_surface_u(on), taut_surface_v(on)};
    for (int d = 0; d < 2; d++) {
        const double lo = taut_basis_lo(bases[d]), hi = taut_basis_hi(bases[d]);
        const double room = 1e-9 * (hi - lo);
        if (!(at[d] >= lo - room) || !(at[d] <= hi + room)) {
            return 0;
        }
        at[d] = fmin(fmax(at[d], lo), hi);
    }
    return 1;
}

int taut_cloth_window_on(const taut_cloth *cloth, const taut_cloth_across *across, double t,
                         double w[3][2])
{
    double all[6][2];
    patch_on(cloth, across, t, 1, all);
    memcpy(w, all, 3 * sizeof all[0]);
    return is_in_window(across->piece->on, w[0]);
}

int taut_cloth_bend_on(const taut_cloth *cloth, const taut_cloth_across *across, double t,
                       double w[6][2])
{
    patch_on(cloth, across, t, 2, w);
    return is_in_window(across->piece->on, w[0]);
}

int taut_cloth_metric_on(const taut_cloth *cloth, const taut_cloth_across *across, double t,
                         double g[3])
{
    double w[3][2], x[3][3], along[2][3];
    if (!taut_cloth_window_on(cloth, across, t, w) ||
        taut_surface_eval(across->piece->on, w[0][0], w[0][1], 1, x[0]) != TAUT_OK) {
        return 0;
    }
    for (int k = 0; k < 2; k++) {
        for (int c = 0; c < 3; c++) {
            along[k][c] = x[1][c] * w[1 + k][0] + x[2][c] * w[1 + k][1];
        }
    }
    g[0] = taut_dot(along[0], along[0]);
    g[1] = taut_dot(along[0], along[1]);
    g[2] = taut_dot(along[1], along[1]);
    return g[0] * g[2] - g[1] * g[1] > 0;
}

int taut_cloth_metric(const taut_cloth *cloth, const taut_cloth_piece *piece, double s, double t,
                      double g[3])
{
    taut_cloth_across across;
    taut_cloth_across_at(cloth, piece, s, 1, &across);
    return taut_cloth_metric_on(cloth, &across, t, g);
}

void taut_cloth_line(const taut_cloth *cloth, const taut_curve *curve, double t, int order,
                     double y[][3])
{
    taut_curve_eval(curve, t, order, y[0]);
    for (int k = 0; k <= order; k++) {
        for (int c = 0; c < 3; c++) {
            y[k][c] = ldexp(y[k][c], -cloth->unit);
        }
    }
}

taut_chart taut_cloth_chart(const taut_cloth *cloth, const taut_cloth_piece *piece)
{
    taut_chart chart = {.surface = piece->on, .kept = {piece->kept[0], piece->kept[1]}};
    for (int e = 0; e < TAUT_CLOTH_EDGES; e++) {
        chart.edges[e] = piece->sides[e] >= 0 ? cloth->sides[piece->sides[e]].window : NULL;
        memcpy(chart.part[e], piece->part[e], sizeof chart.part[e]);
    }
    return chart;
}
