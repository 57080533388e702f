/* shell.c -- from surfaces to shells.
 *
 *     join edges; turn faces, parting what cannot be turned      (edges.c, turn.c)
 *     closed shells: volume V, area A                            (volume.c)
 *         |V| <= thin A: sheets on top of each other, no body: its faces are parted, and turned anew
 *         V < 0: all its faces are turned
 *     tubes, open at loops only: V with a lid on each; V < -thin A: all its faces are turned
 *     number edges, by their first sides, and vertices: corners that poles, closed edges and joined
 *     edges make one
 */
#include "shell/shell.h"

#include "geometry/exponent.h"
#include "shell/parts.h"

#include <math.h>

/* What CAD systems take for one point, of the size: a body is thicker. */
static const double thin_of_size = 1e-7;

typedef struct finding {
    const taut_surface *const *surfaces;
    int count;
    taut_shell_joints joints;
    unsigned char *turned, *closed, *tube, *solid; /* [count]: of faces; of shells */
    int *shell, *queue;
    int shells;
    int *corner; /* [4 count]: the same corner, or a lower one of the same vertex */
    int *vertex; /* [4 count] */
    int scale;   /* 2^scale is about the size of the largest surface */
    taut_shell_content *contents; /* [shells] */
    double *room;
} finding;

static taut_status take_room(finding *f, taut_arena *arena)
{
    const size_t faces = (size_t)f->count;
    size_t most = 0;
    double half = 0;
    for (int i = 0; i < f->count; i++) {
        const size_t room = taut_shell_volume_room(f->surfaces[i]);
        most = room > most ? room : most;
        half = fmax(half, taut_half_size(taut_point_count(f->surfaces[i]),
                                         taut_surface_points(f->surfaces[i])));
    }
    f->scale = taut_exponent(half) + 1;
    f->turned = taut_arena_take(arena, faces, 1);
    f->closed = taut_arena_take(arena, faces, 1);
    f->tube = taut_arena_take(arena, faces, 1);
    f->solid = taut_arena_take(arena, faces, 1);
    f->shell = taut_arena_take(arena, faces, sizeof *f->shell);
    f->queue = taut_arena_take(arena, faces, sizeof *f->queue);
    f->corner = taut_arena_take(arena, 4 * faces, sizeof *f->corner);
    f->vertex = taut_arena_take(arena, 4 * faces, sizeof *f->vertex);
    f->contents = taut_arena_take(arena, faces, sizeof *f->contents);
    f->room = taut_arena_take_raw(arena, most, sizeof *f->room);
    return taut_arena_status(arena);
}

/* Has edge 4 f + e one use only? */
static int is_open(const finding *f, int e)
{
    return f->joints.partner[e] < 0 && !f->joints.pole[e];
}

/* Turns faces, and sees which shells have no edge with one use, or loops only. */
static void turn_faces(finding *f)
{
    f->shells = taut_shell_turn(f->count, &f->joints, f->turned, f->shell, f->queue);
    for (int s = 0; s < f->shells; s++) {
        f->closed[s] = f->tube[s] = 1;
    }
    for (int e = 0; e < 4 * f->count; e++) {
        if (is_open(f, e)) {
            f->closed[f->shell[e / 4]] = 0;
            f->tube[f->shell[e / 4]] &= f->joints.loop[e];
        }
    }
}

/* Parts a face from others, not from itself. */
static int stand_alone(finding *f, int face)
{
    int parted = 0;
    for (int e = 4 * face; e < 4 * face + 4; e++) {
        const int other = f->joints.partner[e];
        if (other >= 0 && other / 4 != face) {
            f->joints.partner[other] = f->joints.partner[e] = -1;
            parted = 1;
        }
    }
    return parted;
}

/* Adds a face, and the lids on its open edges. */
static taut_status weigh_face(finding *f, int face, const double *origin,
                              taut_shell_content *content)
{
    const taut_surface *surface = f->surfaces[face];
    const double sign = f->turned[face] ? -1 : 1;
    taut_status status = taut_shell_add_volume(surface, origin, f->scale, sign, f->room, content);
    for (int e = 4 * face; e < 4 * face + 4 && status == TAUT_OK; e++) {
        if (is_open(f, e)) {
            status = taut_shell_add_lid(surface, e, origin, f->scale, sign, f->room, content);
        }
    }
    return status;
}

/* Volume and area of each closed shell and each tube; its origin is its first face's first point. */
static taut_status weigh_shells(finding *f)
{
    for (int s = 0; s < f->shells; s++) {
        f->contents[s] = (taut_shell_content){0, 0};
        f->queue[s] = -1;
    }
    for (int i = 0; i < f->count; i++) {
        const int s = f->shell[i];
        taut_status status = TAUT_OK;
        f->queue[s] = f->queue[s] < 0 ? i : f->queue[s];
        if (f->tube[s]) {
            status =
                weigh_face(f, i, taut_surface_points(f->surfaces[f->queue[s]]), &f->contents[s]);
        }
        if (status != TAUT_OK) {
            return status;
        }
    }
    return TAUT_OK;
}

/* A closed shell or a tube that is thinner than one point, as a flat ring is, has no inside. */
static int holds_volume(const finding *f, int shell)
{
    const taut_shell_content *content = &f->contents[shell];
    return f->tube[shell] && fabs(content->volume) > thin_of_size * content->area;
}

/* Which closed shells are bodies; these and tubes are turned outwards; *parted if one that is none has lost joints. */
static taut_status judge_bodies(finding *f, int *parted)
{
    const taut_status status = weigh_shells(f);
    *parted = 0;
    for (int i = 0; i < f->count && status == TAUT_OK; i++) {
        const int s = f->shell[i];
        f->solid[s] = (unsigned char)(f->closed[s] && holds_volume(f, s));
        if (f->closed[s] && !f->solid[s]) {
            *parted |= stand_alone(f, i);
        } else if (holds_volume(f, s) && f->contents[s].volume < 0) {
            f->turned[i] = !f->turned[i];
        }
    }
    return status;
}

static int root_of(int *up, int i)
{
    while (up[i] != i) {
        i = up[i] = up[up[i]];
    }
    return i;
}

static void unite(int *up, int i, int j)
{
    const int a = root_of(up, i), b = root_of(up, j);
    up[a > b ? a : b] = a > b ? b : a;
}

static void unite_corners(finding *f)
{
    for (int c = 0; c < 4 * f->count; c++) {
        f->corner[c] = c;
    }
    for (int e = 0; e < 4 * f->count; e++) {
        const int other = f->joints.partner[e];
        if (f->joints.pole[e] || f->joints.loop[e]) {
            unite(f->corner, taut_shell_corner(e, 0), taut_shell_corner(e, 1));
        }
        for (int end = 0; end < 2 && other > e; end++) {
            unite(f->corner, taut_shell_corner(e, end),
                  taut_shell_corner(other, f->joints.reversed[e] ? 1 - end : end));
        }
    }
}

static void number_vertices(finding *f, taut_shells *shells)
{
    unite_corners(f);
    for (int c = 0; c < 4 * f->count; c++) {
        const int root = root_of(f->corner, c);
        if (root == c) {
            f->vertex[c] = shells->vertex_count;
            shells->vertices[shells->vertex_count++] = c;
        } else {
            f->vertex[c] = f->vertex[root]; /* root < c */
        }
    }
}

static void number_edges(const finding *f, taut_shells *shells)
{
    for (int e = 0; e < 4 * f->count; e++) {
        const int other = f->joints.partner[e];
        taut_shell_face *face = &shells->faces[e / 4];
        if (f->joints.pole[e]) {
            face->edge[e % 4] = -1;
            face->pole = f->vertex[taut_shell_corner(e, 0)];
        } else if (other >= 0 && other < e) {
            face->edge[e % 4] = shells->faces[other / 4].edge[other % 4];
        } else {
            face->edge[e % 4] = shells->edge_count;
            shells->edges[shells->edge_count++] = (taut_shell_edge){
                {e, other},
                other >= 0 && f->joints.reversed[e],
                {f->vertex[taut_shell_corner(e, 0)], f->vertex[taut_shell_corner(e, 1)]}};
            shells->gap = other >= 0 ? fmax(shells->gap, f->joints.gap[e]) : shells->gap;
        }
    }
}

/* The faces of each shell, in order. */
static void list_faces(const finding *f, int *room, taut_shells *shells)
{
    int next = 0;
    for (int i = 0; i < f->count; i++) {
        shells->shells[f->shell[i]].face_count++;
    }
    for (int s = 0; s < shells->shell_count; s++) {
        taut_shell *shell = &shells->shells[s];
        shell->faces = room + next;
        next += shell->face_count;
        shell->face_count = 0;
        shell->closed = f->closed[s];
        shell->solid = f->solid[s];
    }
    for (int i = 0; i < f->count; i++) {
        taut_shell *shell = &shells->shells[f->shell[i]];
        shell->faces[shell->face_count++] = i;
        shells->faces[i].shell = f->shell[i];
        shells->faces[i].turned = f->turned[i];
        shells->faces[i].pole = -1;
    }
}

static taut_status fill_shells(finding *f, taut_arena *arena, taut_shells *shells)
{
    const size_t faces = (size_t)f->count;
    int *listed = taut_arena_take(arena, faces, sizeof *listed);
    shells->faces = taut_arena_take(arena, faces, sizeof *shells->faces);
    shells->edges = taut_arena_take(arena, 4 * faces, sizeof *shells->edges);
    shells->vertices = taut_arena_take(arena, 4 * faces, sizeof *shells->vertices);
    shells->shells = taut_arena_take(arena, faces, sizeof *shells->shells);
    if (taut_arena_status(arena) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    shells->face_count = f->count;
    shells->shell_count = f->shells;
    list_faces(f, listed, shells);
    number_vertices(f, shells);
    number_edges(f, shells);
    return TAUT_OK;
}

taut_status taut_shells_find(const taut_surface *const *surfaces, int count, double moved,
                             taut_arena *arena, taut_shells *shells)
{
    finding f = {.surfaces = surfaces, .count = count};
    int parted = 0;
    taut_status status = take_room(&f, arena);

    *shells = (taut_shells){.gap = 0};
    if (status == TAUT_OK) {
        status = taut_shell_join_edges(surfaces, count, moved, arena, &f.joints);
    }
    if (status == TAUT_OK) {
        turn_faces(&f);
        status = judge_bodies(&f, &parted);
    }
    if (status == TAUT_OK && parted) { /* what is alone now has nothing left to part */
        turn_faces(&f);
        status = judge_bodies(&f, &parted);
    }
    return status == TAUT_OK ? fill_shells(&f, arena, shells) : status;
}
