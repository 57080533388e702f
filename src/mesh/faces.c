/* faces.c -- room for a mesh; its faces, and normals where its surfaces have none. */
#include "core/fail.h"
#include "core/vec3.h"
#include "mesh/parts.h"

#include <math.h>
#include <string.h>

taut_status taut_mesh_take_arrays(taut_mesh *mesh, taut_error *error)
{
    mesh->positions = taut_arena_take(mesh->arena, mesh->vertex_count, 3 * sizeof(double));
    mesh->normals = taut_arena_take(mesh->arena, mesh->vertex_count, 3 * sizeof(double));
    mesh->parameters = taut_arena_take(mesh->arena, mesh->vertex_count, 2 * sizeof(double));
    mesh->quads = taut_arena_take(mesh->arena, mesh->quad_count, 4 * sizeof(uint32_t));
    mesh->triangles = taut_arena_take(mesh->arena, mesh->quad_count, 6 * sizeof(uint32_t));
    mesh->welded = taut_arena_take(mesh->arena, mesh->vertex_count, sizeof(uint32_t));
    if (taut_arena_status(mesh->arena) != TAUT_OK) {
        return taut_fail_memory(error);
    }
    return TAUT_OK;
}

static double distance(const double *positions, uint32_t a, uint32_t b)
{
    return taut_length_between(positions + 3 * (size_t)a, positions + 3 * (size_t)b);
}

/* quads uint32_t[(nu-1)(nv-1)][4], triangles [..][2][3] of a grid whose first vertex is `first`;
 * positions are those of the whole mesh. */
static void list_faces(int nu, int nv, uint32_t first, const double *positions, uint32_t *quads,
                       uint32_t *triangles)
{
    for (int i = 0; i + 1 < nu; i++) {
        for (int j = 0; j + 1 < nv; j++) {
            const uint32_t a = first + (uint32_t)i * (uint32_t)nv + (uint32_t)j;
            const uint32_t b = a + (uint32_t)nv, c = b + 1, d = a + 1;
            const int along_ac = distance(positions, a, c) <= distance(positions, b, d);
            const uint32_t quad[4] = {a, b, c, d};
            const uint32_t pair[2][6] = {{a, b, d, b, c, d}, {a, b, c, a, c, d}};
            memcpy(quads, quad, sizeof quad);
            memcpy(triangles, pair[along_ac], sizeof pair[0]);
            quads += 4;
            triangles += 6;
        }
    }
}

/* Adds the area vector of the quad whose lowest corner is (i, j): half the cross product of its
 * diagonals. */
static void add_face(int nv, int i, int j, const double *positions, double *sum)
{
    const double *a = positions + 3 * ((size_t)i * (size_t)nv + (size_t)j);
    const double *d = a + 3, *b = a + 3 * (size_t)nv, *c = b + 3;
    double ac[3], bd[3], n[3];
    taut_difference(c, a, ac);
    taut_difference(d, b, bd);
    taut_cross(ac, bd, n);
    for (int k = 0; k < 3; k++) {
        sum[k] += n[k] / 2;
    }
}

static void mend_normal(int nu, int nv, int i, int j, const double *positions, double *normal)
{
    double sum[3] = {0, 0, 0};
    for (int di = -1; di <= 0; di++) {
        for (int dj = -1; dj <= 0; dj++) {
            if (i + di >= 0 && i + di + 1 < nu && j + dj >= 0 && j + dj + 1 < nv) {
                add_face(nv, i + di, j + dj, positions, sum);
            }
        }
    }
    const double size = taut_length(sum);
    for (int k = 0; k < 3; k++) {
        normal[k] = size > 0 && isfinite(size) ? sum[k] / size : k == 2;
    }
}

/* Gives vertices without a normal the mean of the faces around them; (0, 0, 1) where these have
 * none either. */
static void mend_normals(int nu, int nv, const double *positions, double *normals)
{
    for (int i = 0; i < nu; i++) {
        for (int j = 0; j < nv; j++) {
            double *normal = normals + 3 * ((size_t)i * (size_t)nv + (size_t)j);
            if (normal[0] == 0 && normal[1] == 0 && normal[2] == 0) {
                mend_normal(nu, nv, i, j, positions, normal);
            }
        }
    }
}

void taut_mesh_fill_faces(taut_mesh *mesh, const taut_mesh_group *group)
{
    list_faces(group->nu, group->nv, (uint32_t)group->first_vertex, mesh->positions,
               mesh->quads + 4 * group->first_quad, mesh->triangles + 6 * group->first_quad);
    mend_normals(group->nu, group->nv, mesh->positions + 3 * group->first_vertex,
                 mesh->normals + 3 * group->first_vertex);
}
