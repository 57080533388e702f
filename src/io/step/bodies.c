/* bodies.c -- sheets as bodies, with or without a hollow; what no body may have. */
#include "core/fail.h"
#include "core/unit.h"
#include "core/vec3.h"
#include "io/step/assembly.h"
#include "taut/join.h"

#include <math.h>

/* In mm: readers take what is nearer for one point (OpenCASCADE's Precision::Confusion), and a body that hangs together there alone
 * falls apart. */
static const double confusion = 1e-7;

taut_status taut_step_check_bodies(const taut_model *nurbs, const taut_shells *shells,
                                   taut_error *error)
{
    int i = 0;
    while (i < shells->shell_count && shells->shells[i].solid) {
        i++;
    }
    return i == shells->shell_count
               ? TAUT_OK
               : taut_fail(
                     error, TAUT_NO_SOLUTION, "sheet", NULL, taut_none, taut_none,
                     "the sheet around \"%.60s\" does not close: surfaces meet three at an "
                     "edge, or at a corner only, or their sides touch",
                     taut_surface_name(taut_model_surface(nurbs, shells->shells[i].faces[0])));
}

/* Of the control polygon along edge 0..3: no curve is longer. */
static double length_of(const taut_surface *surface, int edge)
{
    const int nu = taut_basis_count(taut_surface_u(surface));
    const int nv = taut_basis_count(taut_surface_v(surface));
    const int along_v = edge < 2, count = along_v ? nv : nu, step = along_v ? 1 : nv;
    const int first = edge == TAUT_EDGE_U1 ? (nu - 1) * nv : edge == TAUT_EDGE_V1 ? nv - 1 : 0;
    const double *points = taut_surface_points(surface) + 3 * first;
    double length = 0;
    for (int k = 0; k + 1 < count; k++) {
        length += taut_distance(points + 3 * k * step, points + 3 * (k + 1) * step);
    }
    return length;
}

taut_status taut_step_check_edges(const taut_model *nurbs, const taut_shells *shells,
                                  taut_error *error)
{
    const double least = confusion * taut_unit_ratio("mm", taut_model_unit(nurbs));
    for (int f = 0; f < shells->face_count; f++) {
        const taut_shell_face *face = &shells->faces[f];
        const taut_surface *surface = taut_model_surface(nurbs, f);
        for (int e = 0; e < 4 && shells->shells[face->shell].solid; e++) {
            const double length = face->edge[e] >= 0 ? length_of(surface, e) : INFINITY;
            if (!(length >= least)) {
                return taut_fail(
                    error, TAUT_NO_SOLUTION, "single-point", NULL, length, least,
                    "\"%.60s\" is a sliver: an edge of it is %.3g %s long, and readers "
                    "of STEP take what is shorter than %.3g for one point",
                    taut_surface_name(surface), length, taut_model_unit(nurbs), least);
            }
        }
    }
    return TAUT_OK;
}

/* The face that is the other side of a body's, for each face of a hollow's inside; -1 for all else. Sides come one after the
 * other; those of a sheet with an outline are in one shell. */
taut_status taut_step_find_hollows(const taut_cad_facts *facts, const taut_shells *shells,
                                   taut_arena *arena, int **outside)
{
    *outside = taut_arena_take(arena, (size_t)shells->face_count, sizeof **outside);
    for (int f = 0; *outside != NULL && f < shells->face_count; f++) {
        const int apart = facts->from != NULL && f > 0 && facts->from[f] == facts->from[f - 1] &&
                          shells->faces[f].shell != shells->faces[f - 1].shell;
        (*outside)[f] = apart ? f - 1 : -1;
    }
    return *outside != NULL ? TAUT_OK : TAUT_NO_MEMORY;
}
