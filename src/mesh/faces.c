#include "mesh/faces.h"

#include "core/memory.h"
#include "core/vec3.h"

#include <math.h>
#include <string.h>

enum { ROWS_AT_ONCE = 32 };

static double length(const double *a)
{
    return sqrt(taut_dot(a, a));
}

/* Position and unit normal out of x, x_u, x_v. */
static void take_vertex(const double *x, double speeds, double *position, double *normal)
{
    double n[3];
    taut_cross(x + 3 * TAUT_XU, x + 3 * TAUT_XV, n);
    const double size = length(n);
    const int regular = size > 0x1p-40 * speeds && isfinite(size);
    memcpy(position, x, 3 * sizeof(double));
    for (int c = 0; c < 3; c++) {
        normal[c] = regular ? n[c] / size : 0;
    }
}

taut_status taut_vertices_fill(const taut_surface *surface, int nu, const double *u, int nv,
                               const double *v, double speeds, int threads, double *positions,
                               double *normals, double *parameters)
{
    const size_t row = (size_t)nv;
    double *x = taut_alloc_aligned(ROWS_AT_ONCE * row, 9 * sizeof(double));
    taut_status status = x != NULL ? TAUT_OK : TAUT_NO_MEMORY;

    for (int i = 0; status == TAUT_OK && i < nu; i += ROWS_AT_ONCE) {
        const int rows = nu - i < ROWS_AT_ONCE ? nu - i : ROWS_AT_ONCE;
        const size_t base = (size_t)i * row;
        status = taut_surface_eval_grid(surface, rows, u + i, nv, v, 1, threads, x);
        for (size_t k = 0; status == TAUT_OK && k < (size_t)rows * row; k++) {
            take_vertex(x + 9 * k, speeds, positions + 3 * (base + k), normals + 3 * (base + k));
            parameters[2 * (base + k)] = u[(size_t)i + k / row];
            parameters[2 * (base + k) + 1] = v[k % row];
        }
    }
    taut_free(x);
    return status;
}

static double distance(const double *positions, uint32_t a, uint32_t b)
{
    double d[3];
    for (int c = 0; c < 3; c++) {
        d[c] = positions[3 * (size_t)a + (size_t)c] - positions[3 * (size_t)b + (size_t)c];
    }
    return length(d);
}

void taut_faces_fill(int nu, int nv, uint32_t first, const double *positions, uint32_t *quads,
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
    for (int k = 0; k < 3; k++) {
        ac[k] = c[k] - a[k];
        bd[k] = d[k] - b[k];
    }
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
    const double size = length(sum);
    for (int k = 0; k < 3; k++) {
        normal[k] = size > 0 && isfinite(size) ? sum[k] / size : k == 2;
    }
}

void taut_normals_mend(int nu, int nv, const double *positions, double *normals)
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
