#include "meshes.h"

#include "check.h"

#include <stdlib.h>

taut_mesh *mesh_of(const taut_model *model, double tolerance, int divide)
{
    const taut_mesh_options options = {.tolerance = tolerance, .divide = divide};
    taut_mesh *mesh = NULL;
    taut_error error = {.status = TAUT_OK};
    CHECK(taut_mesh_new(model, &options, &mesh, &error) == TAUT_OK, "%s", error.message);
    return mesh;
}

/* A run from one place to another: from, to, and how often. */
typedef struct run {
    uint32_t from, to;
} run;

static int by_ends(const void *a, const void *b)
{
    const run *x = a, *y = b;
    if (x->from != y->from) {
        return x->from < y->from ? -1 : 1;
    }
    return x->to < y->to ? -1 : x->to > y->to;
}

static double triple(const double *a, const double *b, const double *c)
{
    return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
           a[2] * (b[0] * c[1] - b[1] * c[0]);
}

static size_t collect(const taut_mesh *mesh, run *runs, double *volume)
{
    const uint32_t *welded = taut_mesh_welded(mesh);
    const double *x = taut_mesh_positions(mesh);
    size_t n = 0;
    for (int g = 0; g < taut_mesh_group_count(mesh); g++) {
        const taut_mesh_group *group = taut_mesh_group_at(mesh, g);
        const uint32_t *triangles = taut_mesh_triangles(mesh) + 6 * group->first_quad;
        for (int t = 0; t < 2 * (group->nu - 1) * (group->nv - 1); t++) {
            uint32_t p[3];
            for (int c = 0; c < 3; c++) {
                p[c] = welded[triangles[3 * t + (group->turned ? 2 - c : c)]];
            }
            if (p[0] == p[1] || p[1] == p[2] || p[2] == p[0]) {
                continue;
            }
            *volume += triple(x + 3 * (size_t)p[0], x + 3 * (size_t)p[1], x + 3 * (size_t)p[2]) / 6;
            for (int c = 0; c < 3; c++) {
                runs[n++] = (run){p[c], p[(c + 1) % 3]};
            }
        }
    }
    return n;
}

mesh_body mesh_look_at(const taut_mesh *mesh)
{
    run *runs = malloc(6 * taut_mesh_quad_count(mesh) * sizeof *runs);
    mesh_body found = {0, 0};
    const size_t n = collect(mesh, runs, &found.volume);
    qsort(runs, n, sizeof *runs, by_ends);
    for (size_t i = 0; i < n; i++) {
        const run back = {runs[i].to, runs[i].from};
        const run *partner = bsearch(&back, runs, n, sizeof *runs, by_ends);
        const int twice = i + 1 < n && by_ends(&runs[i], &runs[i + 1]) == 0;
        found.open += partner == NULL || twice;
    }
    free(runs);
    return found;
}
