/* weld.c -- vertices along seams become one place, and surfaces that meet are turned alike. */
#include "core/vec3.h"
#include "mesh/run.h"
#include "mesh/seams.h"

#include <float.h>
#include <math.h>
#include <string.h>

static uint32_t root_of(uint32_t *welded, uint32_t vertex)
{
    while (welded[vertex] != vertex) {
        welded[vertex] = welded[welded[vertex]];
        vertex = welded[vertex];
    }
    return vertex;
}

static void unite_vertices(uint32_t *welded, size_t a, size_t b)
{
    const uint32_t root_a = root_of(welded, (uint32_t)a), root_b = root_of(welded, (uint32_t)b);
    if (root_a < root_b) {
        welded[root_b] = root_a;
    } else {
        welded[root_a] = root_b;
    }
}

static double distance(const taut_weld *weld, size_t a, size_t b)
{
    return taut_length_between(weld->positions + 3 * a, weld->positions + 3 * b);
}

static int are_near(const taut_weld *weld, size_t a, size_t b)
{
    return distance(weld, a, b) <= weld->tolerance;
}

/* Vertices of a collapsed edge: control points are one only where they are to rounding, however
 * small the edge is beside the whole. */
static int are_one(const taut_weld *weld, size_t a, size_t b)
{
    double size = 0;
    for (size_t c = 0; c < 3; c++) {
        size = fmax(size, fabs(weld->positions[3 * a + c]));
    }
    return are_near(weld, a, b) && (!weld->own || distance(weld, a, b) <= 16 * DBL_EPSILON * size);
}

/* Vertex k of b, the other edge of a seam. */
static size_t partner_at(const taut_seam *seam, const taut_edge_run *b, int k)
{
    return taut_edge_run_at(b, seam->reversed ? b->count - 1 - k : k);
}

/* Do opposite edges of one net of control points meet beside its extent in each coordinate? Where
 * one extent is 1e15 times another, edges may be near beside the whole and yet at either end. */
static int meets_itself(const taut_weld *weld, const taut_seam *seam)
{
    const taut_edge_run a = taut_edge_run_of(weld->groups, seam->a),
                        b = taut_edge_run_of(weld->groups, seam->b);
    const taut_mesh_group *group = &weld->groups[seam->a / 4];
    const double *points = weld->positions + 3 * group->first_vertex;
    double apart[3] = {0, 0, 0}, size[3] = {0, 0, 0};

    for (size_t k = 0; k < 3 * (size_t)group->nu * (size_t)group->nv; k++) {
        size[k % 3] = fmax(size[k % 3], fabs(points[k]));
    }
    for (size_t k = 0; k < 3 * (size_t)a.count; k++) {
        const size_t i = taut_edge_run_at(&a, (int)(k / 3)), j = partner_at(seam, &b, (int)(k / 3));
        apart[k % 3] = fmax(apart[k % 3],
                            fabs(weld->positions[3 * i + k % 3] - weld->positions[3 * j + k % 3]));
    }
    return apart[0] <= 1e-6 * size[0] && apart[1] <= 1e-6 * size[1] && apart[2] <= 1e-6 * size[2];
}

/* Are the edges of a seam cut alike, vertex by vertex? */
static int is_closed(const taut_weld *weld, const taut_seam *seam)
{
    const taut_edge_run a = taut_edge_run_of(weld->groups, seam->a),
                        b = taut_edge_run_of(weld->groups, seam->b);
    int k = 0;
    while (k < a.count && a.count == b.count &&
           are_near(weld, taut_edge_run_at(&a, k), partner_at(seam, &b, k))) {
        k++;
    }
    return k == a.count && (!weld->own || seam->a / 4 != seam->b / 4 || meets_itself(weld, seam));
}

/* Two neighbours are turned alike if they run along their seam in opposite senses. */
static int are_opposed(const taut_seam *seam)
{
    return taut_edge_run_is_along(seam->a) ^ taut_edge_run_is_along(seam->b) ^ seam->reversed;
}

/* Does an edge come back to where it begins, as the end of a tube does? */
static int is_ring(const taut_weld *weld, int edge)
{
    const taut_edge_run run = taut_edge_run_of(weld->groups, edge);
    return weld->welded[taut_edge_run_at(&run, 0)] ==
           weld->welded[taut_edge_run_at(&run, run.count - 1)];
}

/* 24 times the signed volume between `at` and a lid on a ring: the fan of triangles from the mean of
 * its vertices, turned as the surface is. */
static double volume_of_lid(const taut_weld *weld, int edge, const double *at)
{
    const taut_edge_run run = taut_edge_run_of(weld->groups, edge);
    double mean[3] = {0, 0, 0}, sum = 0;

    for (int k = 1; k < run.count; k++) {
        for (int c = 0; c < 3; c++) {
            mean[c] += weld->positions[3 * taut_edge_run_at(&run, k) + (size_t)c] / (run.count - 1);
        }
    }
    for (int k = 1; k < run.count; k++) {
        const double *x =
            weld->positions + 3 * taut_edge_run_at(&run, k - taut_edge_run_is_along(edge));
        const double *y =
            weld->positions + 3 * taut_edge_run_at(&run, k - !taut_edge_run_is_along(edge));
        double p[3], q[3], n[3], r[3];
        taut_difference(y, mean, p);
        taut_difference(x, mean, q);
        taut_cross(p, q, n);
        for (int c = 0; c < 3; c++) {
            r[c] = mean[c] + x[c] + y[c] - 3 * at[c];
        }
        sum += taut_dot(r, n) * 4 / 3;
    }
    return sum;
}

/* 24 times the signed volume between a group and the origin `at`. */
static double volume_below(const taut_weld *weld, const taut_mesh_group *group, const double *at)
{
    double sum = 0;
    for (int i = 0; i + 1 < group->nu; i++) {
        for (int j = 0; j + 1 < group->nv; j++) {
            const double *a = weld->positions +
                              3 * (group->first_vertex + (size_t)i * (size_t)group->nv + (size_t)j);
            const double *d = a + 3, *b = a + 3 * (size_t)group->nv, *c = b + 3;
            double p[3], q[3], r[3];
            for (int k = 0; k < 3; k++) {
                p[k] = c[k] - a[k];
                q[k] = d[k] - b[k];
                r[k] = a[k] + b[k] + c[k] + d[k] - 4 * at[k];
            }
            sum += r[0] * (p[1] * q[2] - p[2] * q[1]) + r[1] * (p[2] * q[0] - p[0] * q[2]) +
                   r[2] * (p[0] * q[1] - p[1] * q[0]);
        }
    }
    return sum;
}

/* What becomes of one body: surfaces that hang together. */
typedef struct body {
    double volume, size; /* signed, and without the signs of its parts */
    const double *at;    /* a point of it */
    int is_open;         /* at an edge that is no ring */
    int is_tube;         /* open at rings */
} body;

/* A tube that holds less than this share of what its parts add up to has no inside: a flat ring. */
static const double least_share = 1e-6;

static void add_volume(body *whole, double volume)
{
    whole->volume += volume;
    whole->size += fabs(volume);
}

static int is_inside_out(const body *whole)
{
    return !whole->is_open && whole->volume < -(whole->is_tube ? least_share * whole->size : 0);
}

/* Which groups to turn so that neighbours agree, and closed bodies and tubes show their outside. */
static void turn_groups(const taut_weld *weld, taut_mirror_sets *sets, const unsigned char *shut,
                        body *bodies)
{
    for (int g = 0; g < weld->group_count; g++) {
        taut_mesh_group *group = &weld->groups[g];
        const int root = taut_mirror_root(sets, g, &group->turned);
        body *whole = &bodies[root];
        if (whole->at == NULL) {
            whole->at = weld->positions + 3 * group->first_vertex;
        }
        const int sign = group->turned ? -1 : 1;
        add_volume(whole, sign * volume_below(weld, group, whole->at));
        for (int e = 4 * g; e < 4 * g + 4; e++) {
            const int lid = !shut[e] && is_ring(weld, e);
            whole->is_open |= !shut[e] && !lid;
            whole->is_tube |= lid;
            if (lid) {
                add_volume(whole, sign * volume_of_lid(weld, e, whole->at));
            }
        }
    }
    for (int g = 0; g < weld->group_count; g++) {
        int flip = 0;
        if (is_inside_out(&bodies[taut_mirror_root(sets, g, &flip)])) {
            weld->groups[g].turned ^= 1;
        }
    }
}

static void weld_collapsed(const taut_weld *weld, unsigned char *shut)
{
    for (int e = 0; e < 4 * weld->group_count; e++) {
        if (weld->collapsed[e]) {
            const taut_edge_run run = taut_edge_run_of(weld->groups, e);
            shut[e] = 1;
            for (int k = 1; k < run.count; k++) {
                if (are_one(weld, run.first, taut_edge_run_at(&run, k))) {
                    unite_vertices(weld->welded, run.first, taut_edge_run_at(&run, k));
                } else {
                    shut[e] &= !weld->own;
                }
            }
        }
    }
}

static void weld_seam(const taut_weld *weld, const taut_seam *seam)
{
    const taut_edge_run a = taut_edge_run_of(weld->groups, seam->a),
                        b = taut_edge_run_of(weld->groups, seam->b);
    for (int k = 0; k < a.count; k++) {
        unite_vertices(weld->welded, taut_edge_run_at(&a, k), partner_at(seam, &b, k));
    }
}

taut_status taut_weld_vertices(const taut_weld *weld)
{
    taut_arena *scratch = taut_arena_new();
    const size_t groups = (size_t)weld->group_count;
    unsigned char *shut = taut_arena_take(scratch, 4 * groups, 1);
    body *bodies = taut_arena_take(scratch, groups, sizeof *bodies);
    taut_mirror_sets sets;

    if (!taut_mirror_sets_new(weld->group_count, scratch, &sets)) {
        taut_arena_free(scratch);
        return TAUT_NO_MEMORY;
    }
    for (size_t i = 0; i < weld->vertex_count; i++) {
        weld->welded[i] = (uint32_t)i;
    }
    weld_collapsed(weld, shut);
    for (int s = 0; s < weld->seam_count; s++) {
        const taut_seam *seam = &weld->seams[s];
        if (is_closed(weld, seam)) {
            weld_seam(weld, seam);
            shut[seam->a] = shut[seam->b] = 1;
            taut_mirror_unite(&sets, seam->a / 4, seam->b / 4, !are_opposed(seam));
        }
    }
    for (size_t i = 0; i < weld->vertex_count; i++) {
        weld->welded[i] = root_of(weld->welded, (uint32_t)i);
        memmove(weld->positions + 3 * i, weld->positions + 3 * (size_t)weld->welded[i],
                3 * sizeof(double));
    }
    turn_groups(weld, &sets, shut, bodies);
    taut_arena_free(scratch);
    return TAUT_OK;
}
