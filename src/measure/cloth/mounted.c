#include "measure/cloth/mounted.h"

#include "core/elementary/elementary.h"
#include "core/vec3.h"
#include "geometry/stretch.h"

#include <math.h>
#include <string.h>

/* Of a pole, in s. */
static const double next_to = 1e-6;

/* The object of this name; NULL. */
static const taut_record *named(const taut_record *list, const char *name)
{
    for (size_t k = 0; k < taut_record_count(list); k++) {
        const taut_record *one = taut_record_at(list, k);
        if (strcmp(taut_record_text(taut_record_get(one, "name")), name) == 0) {
            return one;
        }
    }
    return NULL;
}

/* The side of this name, of a surface or of the only one. */
static const taut_record *side_named(const taut_record *list, const char *name, const char *surface)
{
    for (size_t k = 0; k < taut_record_count(list); k++) {
        const taut_record *one = taut_record_at(list, k);
        if (strcmp(taut_record_text(taut_record_get(one, "name")), name) == 0 &&
            strcmp(taut_record_text(taut_record_get(one, "surface")), surface) == 0) {
            return one;
        }
    }
    return NULL;
}

static taut_status read_side(const taut_record *details, const taut_record *edge,
                             const char *surface, taut_arena *arena, const taut_curve **side)
{
    const taut_record *border = taut_record_get(edge, "edge");
    const char *name = taut_record_text(border != NULL ? border : taut_record_get(edge, "seam"));
    taut_curve *made = NULL;
    const taut_status status = taut_stretch_read(
        side_named(taut_record_get(details, "domain"), name, surface), arena, &made);
    *side = made;
    return status;
}

/* Does a piece of the surface start or end on an edge of the window? */
static int runs_across(const taut_record *details, const char *surface, const char *edge)
{
    static const char *const ends[2] = {"start", "end"};
    const taut_record *pieces = taut_record_get(details, "pieces");
    int any = 0;
    for (size_t k = 0; k < 2 * taut_record_count(pieces); k++) {
        const taut_record *piece = taut_record_at(pieces, k / 2);
        const taut_record *end = taut_record_get(taut_record_get(piece, "edges"), ends[k % 2]);
        any |= strcmp(taut_record_text(taut_record_get(piece, "surface")), surface) == 0 &&
               strcmp(taut_record_text(taut_record_get(end, "edge")), edge) == 0;
    }
    return any;
}

/* Edges near which compensation fades out. */
static taut_status read_fades(const taut_record *details, const char *surface, taut_arena *arena,
                              taut_mounted *m)
{
    static const char *const edges[4] = {"u0", "u1", "v0", "v1"};
    const taut_record *list = taut_record_get(details, "decompensate");
    const double thread =
        taut_record_number(taut_record_get(taut_record_get(details, "cloth"), "thread"));
    for (size_t k = 0; k < taut_record_count(list) && k < 4; k++) {
        const taut_record *one = taut_record_at(list, k);
        const char *name = taut_record_text(taut_record_get(one, "edge"));
        const int is_both =
            strcmp(taut_record_text(taut_record_get(one, "component")), "both") == 0;
        const double along = fabs(taut_cos(thread)), across = fabs(taut_sin(thread));
        const int is_warp = runs_across(details, surface, name) ? across > along : along >= across;
        for (int e = 0; e < 4; e++) {
            if (strcmp(name, edges[e]) != 0) {
                continue;
            }
            const int n = m->fade_count++;
            m->lengths[n] = taut_record_number(taut_record_get(one, "length"));
            m->is_faded[n][0] = is_both || is_warp;
            m->is_faded[n][1] = is_both || !is_warp;
            if (taut_border_new(arena, m->surface, e, &m->borders[n]) != TAUT_OK) {
                return TAUT_NO_MEMORY;
            }
        }
    }
    return TAUT_OK;
}

/* 1 / F0 at a place in space. */
static void shrink_at(const taut_mounted *m, const double x[3], double shrink[2])
{
    for (int d = 0; d < 2; d++) {
        shrink[d] = m->shrink[d];
    }
    for (int k = 0; k < m->fade_count; k++) {
        const double z = fmin(1, taut_border_distance(&m->borders[k], x) / m->lengths[k]);
        for (int d = 0; d < 2; d++) {
            shrink[d] = m->is_faded[k][d] ? 1 - (1 - shrink[d]) * z * z * (3 - 2 * z) : shrink[d];
        }
    }
}

/* Is start (3) or end (1) of a flat piece one place? */
static int is_tip(const taut_surface *flat, int e)
{
    const int count[2] = {taut_basis_count(taut_surface_u(flat)),
                          taut_basis_count(taut_surface_v(flat))};
    const double *row = taut_surface_points(flat) + (e == 3 ? 0 : 3 * (count[0] - 1) * count[1]);
    int all = 1;
    for (int k = 3; k < 3 * count[1]; k++) {
        all &= row[k] == row[k % 3];
    }
    return all;
}

/* A cap has a circle on one end and a tip, on an edge of the window, on the other one. */
static int kept_of(const taut_record *details, const taut_record *edges, const taut_surface *flat,
                   int e)
{
    static const char *const ends[4] = {"right", "end", "left", "start"};
    const taut_record *edge = taut_record_get(edges, ends[e]),
                      *other = taut_record_get(edges, ends[4 - e]);
    const taut_record *seam =
        named(taut_record_get(details, "seams"), taut_record_text(taut_record_get(edge, "seam")));
    const char *border = taut_record_text(taut_record_get(other, "edge"));
    const int is_cap = strcmp(taut_record_text(taut_record_get(seam, "kind")), "circle") == 0 &&
                       border[0] != '\0' && is_tip(flat, 4 - e);
    return !is_cap ? 0 : border[0] == 'u' ? 2 : 1;
}

taut_status taut_mounted_new(const taut_model *model, const taut_surface *flat, taut_arena *arena,
                             taut_mounted *mounted)
{
    static const char *const edges[4] = {"right", "end", "left", "start"};
    static const char *const ways[2] = {"warp", "weft"};
    const taut_record *details = taut_model_details(model);
    const char *pattern = taut_record_text(taut_record_get(details, "pattern"));
    const taut_record *piece = named(taut_record_get(details, "pieces"), taut_surface_name(flat));
    const taut_record *shares = taut_record_get(details, "compensation");

    *mounted = (taut_mounted){.surface = taut_model_surface(model, 0)};
    if (strcmp(pattern, "cloth") != 0 || piece == NULL || mounted->surface == flat) {
        return TAUT_OK;
    }
    const char *surface = taut_record_text(taut_record_get(piece, "surface"));
    for (int k = 0; surface[0] != '\0' && k < taut_model_surface_count(model); k++) {
        const taut_surface *one = taut_model_surface(model, k);
        mounted->surface = strcmp(taut_surface_name(one), surface) == 0 ? one : mounted->surface;
    }
    for (int e = 0; e < 4; e++) {
        const taut_record *edge = taut_record_get(taut_record_get(piece, "edges"), edges[e]);
        const taut_record *part = taut_record_get(edge, "part");
        for (int k = 0; k < 2; k++) {
            mounted->parts[e][k] =
                part != NULL ? taut_record_number(taut_record_at(part, (size_t)k)) : k;
        }
        if (e % 2 == 1 && taut_record_get(edge, "seam") == NULL &&
            side_named(taut_record_get(details, "domain"),
                       taut_record_text(taut_record_get(edge, "edge")), surface) == NULL) {
            continue; /* straight */
        }
        const taut_status status = read_side(details, edge, surface, arena, &mounted->sides[e]);
        if (e % 2 == 1) {
            mounted->kept[e] = kept_of(details, taut_record_get(piece, "edges"), flat, e);
        }
        if (status != TAUT_OK || mounted->sides[e] == NULL) {
            return status;
        }
    }
    for (int k = 0; k < 2; k++) {
        const taut_record *share = taut_record_get(shares, ways[k]);
        mounted->shrink[k] = 1 - (share != NULL ? taut_record_number(share) : 0);
    }
    mounted->flat = flat;
    return read_fades(details, surface, arena, mounted);
}

/* An edge at x in [0, 1], and its derivative. */
static void edge_at(const taut_mounted *m, int e, double x, double w[2][2])
{
    const taut_basis *basis = taut_curve_t(m->sides[e]);
    const double lo = taut_basis_lo(basis), hi = taut_basis_hi(basis);
    const double range = m->parts[e][1] - m->parts[e][0];
    const double share = x < 1 ? m->parts[e][0] + x * range : m->parts[e][1];
    double c[2][3];
    taut_curve_eval(m->sides[e], share < 1 ? lo + share * (hi - lo) : hi, 1, c[0]);
    for (int d = 0; d < 2; d++) {
        w[0][d] = c[0][d];
        w[1][d] = range * (hi - lo) * c[1][d];
    }
}

/* w, w_s and w_t, in the window: the patch of Coons between right and left, and ends that are not straight. */
static void window_at(const taut_mounted *m, double s, double t, double w[3][2])
{
    const taut_basis *bases[2] = {taut_surface_u(m->surface), taut_surface_v(m->surface)};
    double right[2][2], left[2][2], corners[2][2][2], across[2][2];
    edge_at(m, 0, s, right);
    edge_at(m, 2, s, left);
    for (int d = 0; d < 2; d++) {
        w[0][d] = (1 - t) * right[0][d] + t * left[0][d];
        w[1][d] = (1 - t) * right[1][d] + t * left[1][d];
        w[2][d] = left[0][d] - right[0][d];
    }
    for (int e = 1; e < 4; e += 2) {
        const double end = e == 1, fade = e == 1 ? s : 1 - s, slope = e == 1 ? 1 : -1;
        if (m->sides[e] == NULL) {
            continue;
        }
        edge_at(m, 0, end, corners[0]);
        edge_at(m, 2, end, corners[1]);
        edge_at(m, e, t, across);
        for (int d = 0; d < 2; d++) {
            const int is_kept = m->kept[e] == 1 + d;
            const double share = is_kept ? 1 : fade, change = is_kept ? 0 : slope;
            const double chord = corners[1][0][d] - corners[0][0][d];
            const double off = across[0][d] - corners[0][0][d] - t * chord;
            w[0][d] += share * off;
            w[1][d] += change * off;
            w[2][d] += share * (across[1][d] - chord);
        }
    }
    for (int d = 0; d < 2; d++) {
        w[0][d] = fmin(fmax(w[0][d], taut_basis_lo(bases[d])), taut_basis_hi(bases[d]));
    }
}

/* The principal strain that is larger in size, of the metric and y_s, y_t. */
static double strain_of(const double g[3], const double y[3][3], const double shrink[2])
{
    const double det = y[1][0] * y[2][1] - y[2][0] * y[1][1];
    const double inverse[2][2] = {{y[2][1] / det, -y[2][0] / det}, {-y[1][1] / det, y[1][0] / det}};
    double c[2][2];
    if (!(det > 0)) {
        return (double)NAN;
    }
    for (int i = 0; i < 2; i++) {
        for (int k = 0; k < 2; k++) {
            c[i][k] = shrink[i] * shrink[k] *
                      (inverse[0][i] * (g[0] * inverse[0][k] + g[1] * inverse[1][k]) +
                       inverse[1][i] * (g[1] * inverse[0][k] + g[2] * inverse[1][k]));
        }
    }
    const double half = (c[0][0] + c[1][1]) / 2;
    const double radius = taut_hypot((c[0][0] - c[1][1]) / 2, c[0][1]);
    const double high = sqrt(half + radius) - 1, low = sqrt(half - radius) - 1;
    return fabs(high) >= fabs(low) ? high : low;
}

void taut_mounted_at(const taut_mounted *mounted, double s, double t, double point[3],
                     double normal[3], double *strain)
{
    double w[3][2], x[3][3], y[3][3], along[2][3];

    *strain = (double)NAN;
    window_at(mounted, s, t, w);
    if (taut_surface_eval(mounted->surface, w[0][0], w[0][1], 1, x[0]) != TAUT_OK ||
        taut_surface_eval(mounted->flat, s, t, 1, y[0]) != TAUT_OK) {
        memset(point, 0, 3 * sizeof(double));
        memset(normal, 0, 3 * sizeof(double));
        return;
    }
    for (int k = 0; k < 2; k++) {
        for (int c = 0; c < 3; c++) {
            along[k][c] = x[1][c] * w[1 + k][0] + x[2][c] * w[1 + k][1];
        }
    }
    const double g[3] = {taut_dot(along[0], along[0]), taut_dot(along[0], along[1]),
                         taut_dot(along[1], along[1])};
    memcpy(point, x[0], sizeof x[0]);
    taut_cross(along[0], along[1], normal);
    const double area = taut_norm(normal);
    if (!(area > 0) && (s == 0 || s == 1)) { /* a pole: as next to it */
        double near[3];
        taut_mounted_at(mounted, s == 0 ? next_to : 1 - next_to, t, near, normal, strain);
        return;
    }
    for (int c = 0; c < 3; c++) {
        normal[c] = area > 0 ? normal[c] / area : (double)NAN;
    }
    double shrink[2];
    shrink_at(mounted, point, shrink);
    *strain = area > 0 ? strain_of(g, (const double(*)[3])y, shrink) : (double)NAN;
}
