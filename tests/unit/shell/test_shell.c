/* test_shell.c -- which faces, edges and vertices there are, on shapes where that is known: counted by
 * hand, whichever way the parameters of each face run. */
#include "check.h"
#include "shapes.h"

#include "shell/shell.h"
#include "taut/operations.h"

#include <stdlib.h>
#include <string.h>

enum { MOST = 16 };

/* Faces that are freed together, and what was found. */
typedef struct body {
    taut_surface *faces[MOST];
    int count;
    taut_arena *arena;
    taut_shells shells;
} body;

static void add_face(body *b, taut_surface *face)
{
    CHECK(face != NULL && b->count < MOST, "face %d", b->count);
    b->faces[b->count++] = face;
}

static void find_shells(body *b, double moved)
{
    b->arena = taut_arena_new();
    CHECK(taut_shells_find((const taut_surface *const *)b->faces, b->count, moved, b->arena,
                           &b->shells) == TAUT_OK,
          "shells");
}

static void drop(body *b)
{
    for (int i = 0; i < b->count; i++) {
        taut_surface_free(b->faces[i]);
    }
    taut_arena_free(b->arena);
    *b = (body){.count = 0};
}

/* The same surface, u and v changed and both perhaps reversed: 8 ways. */
static taut_surface *turned(taut_surface *surface, int way)
{
    taut_surface *made = NULL;
    for (int d = 0; d < 2; d++) {
        if ((way & (1 << d)) != 0) {
            CHECK(taut_surface_reverse(surface, d, &made, NULL) == TAUT_OK, "reverse");
            taut_surface_free(surface);
            surface = made;
        }
    }
    if ((way & 4) != 0) {
        CHECK(taut_surface_transpose(surface, &made, NULL) == TAUT_OK, "transpose");
        taut_surface_free(surface);
        surface = made;
    }
    return surface;
}

/* The bilinear patch with these corners. */
static taut_surface *patch(const double *a, const double *b, const double *c, const double *d)
{
    double points[12];
    memcpy(points, a, 24);
    memcpy(points + 3, b, 24);
    memcpy(points + 6, c, 24);
    memcpy(points + 9, d, 24);
    return shape_surface(shape_bezier(1, 0, 1), shape_bezier(1, 0, 1), points, NULL);
}

static void check_counts(const body *b, int shells, int edges, int vertices, const char *what)
{
    CHECK(b->shells.face_count == b->count && b->shells.shell_count == shells &&
              b->shells.edge_count == edges && b->shells.vertex_count == vertices,
          "%s: %d shells, %d edges, %d vertices, expected %d, %d, %d", what, b->shells.shell_count,
          b->shells.edge_count, b->shells.vertex_count, shells, edges, vertices);
}

static void check_first(const body *b, int closed, int solid, const char *what)
{
    CHECK(b->shells.shells[0].closed == closed && b->shells.shells[0].solid == solid,
          "%s: closed %d, solid %d", what, b->shells.shells[0].closed, b->shells.shells[0].solid);
}

/* Each face looks away from `middle`, which it is to do where the body is star-shaped about it. */
static void check_outwards(const body *b, const double middle[3], const char *what)
{
    for (int f = 0; f < b->count; f++) {
        const taut_basis *u = taut_surface_u(b->faces[f]), *v = taut_surface_v(b->faces[f]);
        double x[9], n[3], dot = 0;
        CHECK(taut_surface_eval(b->faces[f], 0.4 * taut_basis_lo(u) + 0.6 * taut_basis_hi(u),
                                0.7 * taut_basis_lo(v) + 0.3 * taut_basis_hi(v), 1, x) == TAUT_OK,
              "%s", what);
        n[0] = x[4] * x[8] - x[5] * x[7];
        n[1] = x[5] * x[6] - x[3] * x[8];
        n[2] = x[3] * x[7] - x[4] * x[6];
        for (int c = 0; c < 3; c++) {
            dot += n[c] * (x[c] - middle[c]);
        }
        CHECK((dot > 0) != b->shells.faces[f].turned, "%s: face %d looks inwards", what, f);
    }
}

static void test_one_face(void)
{
    const double origin[3] = {0, 0, 0};
    for (int way = 0; way < 8; way++) {
        body b = {.count = 0};
        add_face(&b, turned(shape_saddle(0.5), way));
        find_shells(&b, 0);
        check_counts(&b, 1, 4, 4, "saddle");
        check_first(&b, 0, 0, "saddle");
        CHECK(!b.shells.faces[0].turned, "an open shell is as it is");
        drop(&b);
        add_face(&b, turned(shape_cylinder(2, 3, 1), way));
        find_shells(&b, 0);
        check_counts(&b, 1, 3, 2, "cylinder");
        check_first(&b, 0, 0, "cylinder");
        drop(&b);
        add_face(&b, turned(shape_octant(2), way));
        find_shells(&b, 0);
        check_counts(&b, 1, 3, 3, "octant");
        drop(&b);
        add_face(&b, turned(shape_sphere(2), way));
        find_shells(&b, 0);
        check_counts(&b, 1, 1, 2, "sphere");
        check_first(&b, 1, 1, "sphere");
        check_outwards(&b, origin, "sphere");
        drop(&b);
        add_face(&b, turned(shape_torus(3, 1), way));
        find_shells(&b, 0);
        check_counts(&b, 1, 2, 1, "torus");
        check_first(&b, 1, 1, "torus");
        drop(&b);
    }
}

/* A box with its corners moved a little; each face however it likes. Without one face it is open. */
static void test_box(void)
{
    static const int faces[6][4] = {{0, 1, 2, 3}, {4, 5, 6, 7}, {0, 1, 4, 5},
                                    {2, 3, 6, 7}, {0, 2, 4, 6}, {1, 3, 5, 7}};
    for (int trial = 0; trial < 50; trial++) {
        const double size = random_log(1e-3, 1e6);
        const int left_out = trial % 2 == 0 ? 6 : random_int(0, 5);
        double corner[8][3], middle[3];
        body b = {.count = 0};
        for (int i = 0; i < 8; i++) {
            for (int c = 0; c < 3; c++) {
                corner[i][c] = size * ((i >> c & 1) + random_in(-0.2, 0.2) + 5);
            }
        }
        for (int c = 0; c < 3; c++) {
            middle[c] = size * 5.5;
        }
        for (int f = 0; f < 6; f++) {
            const int *at = faces[f];
            if (f != left_out) {
                add_face(&b,
                         turned(patch(corner[at[0]], corner[at[1]], corner[at[2]], corner[at[3]]),
                                random_int(0, 7)));
            }
        }
        find_shells(&b, 0);
        check_counts(&b, 1, 12, 8, "box");
        check_first(&b, left_out == 6, left_out == 6, "box");
        if (left_out == 6) {
            check_outwards(&b, middle, "box");
        }
        CHECK(b.shells.gap < 1e-9 * size, "gap %g of %g", b.shells.gap, size);
        drop(&b);
    }
}

/* Two patches a gap apart: one shell below the limit, two above; what they stand for may be near. */
static void test_gap(void)
{
    static const struct {
        double gap, moved;
        int shells;
    } rows[] = {{0, 0, 1}, {1e-10, 0, 1}, {1e-8, 0, 2}, {1e-8, 1e-7, 1}, {1e-6, 1e-7, 2}};
    for (int r = 0; r < (int)(sizeof rows / sizeof rows[0]); r++) {
        const double corner[8][3] = {{0, 0, 0}, {0, 1, 0},   {1, 0, 0}, {1, 1, 0.5},
                                     {1, 0, 0}, {1, 1, 0.5}, {2, 0, 0}, {2, 1, 0}};
        double moved[3];
        body b = {.count = 0};
        memcpy(moved, corner[5], sizeof moved);
        moved[2] += rows[r].gap;
        add_face(&b, patch(corner[0], corner[1], corner[2], corner[3]));
        add_face(&b, patch(corner[4], moved, corner[6], corner[7]));
        find_shells(&b, rows[r].moved);
        check_counts(&b, rows[r].shells, rows[r].shells == 1 ? 7 : 8, rows[r].shells == 1 ? 6 : 8,
                     "gap");
        drop(&b);
    }
}

/* Two quarters of a cylinder whose common edge has a weight that differs by a share: one shell while
 * what that moves at most, by the bound, is below the limit. */
static void test_weights(void)
{
    static const double shares[] = {0, 1e-12, 1e-8, 1e-6, 1e-3};
    for (int r = 0; r < 5; r++) {
        const double a[18] = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 0, 1, 1, 0, 1, 1, 1, 1};
        const double b[18] = {0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 0, 3, 1, 0, 3, 1, 1, 3};
        const double wa[6] = {1, 0.7, 1, 1, 0.7, 1};
        const double wb[6] = {2, 1.4 * (1 + shares[r]), 2, 1, 0.7, 1};
        body k = {.count = 0};
        add_face(&k, shape_surface(shape_bezier(1, 0, 1), shape_bezier(2, 0, 1), a, wa));
        add_face(&k, shape_surface(shape_bezier(1, 0, 1), shape_bezier(2, 0, 1), b, wb));
        find_shells(&k, 0);
        CHECK(k.shells.shell_count == (r < 2 ? 1 : 2), "share %g: %d shells", shares[r],
              k.shells.shell_count);
        drop(&k);
    }
}

/* A leaf whose lower edge is a loop of its own: it begins and ends at one vertex. */
static void test_loop(void)
{
    const double points[24] = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 0, 0,
                               0, 0, 1, 2, 0, 1, 2, 2, 1, 0, 2, 1};
    body b = {.count = 0};
    add_face(&b, shape_surface(shape_bezier(1, 0, 1), shape_bezier(3, 0, 1), points, NULL));
    find_shells(&b, 0);
    check_counts(&b, 1, 4, 3, "a loop");
    drop(&b);
}

/* A band with a half twist, of two patches: joined at one edge, not at the other. */
static void test_twisted(void)
{
    const double a[2][3] = {{-1, 0, 0}, {1, 0, 0}}, c[2][3] = {{-1, 4, 0.5}, {1, 4, -0.5}};
    const double p[2][3] = {{0, 2, 2}, {0, 2, 4}};
    body b = {.count = 0};
    add_face(&b, patch(a[0], a[1], p[0], p[1]));
    add_face(&b, patch(p[0], p[1], c[0], c[1]));
    add_face(&b, patch(c[0], c[1], a[1], a[0]));
    find_shells(&b, 0);
    CHECK(b.shells.shell_count == 1 && b.shells.edge_count == 10 && !b.shells.shells[0].closed,
          "%d shells, %d edges", b.shells.shell_count, b.shells.edge_count);
    drop(&b);
}

/* What is no shell: three faces at an edge; a face and its copy; a whole on top of its part. */
static void test_not_joined(void)
{
    const double corner[4][3] = {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0}};
    const double up[2][3] = {{0, 0, 1}, {0, 1, 1}}, aside[2][3] = {{-1, 0, 0.5}, {-1, 1, 0.5}};
    const double half[2][3] = {{0.5, 0, 0}, {0.5, 1, 0}};
    body b = {.count = 0};
    add_face(&b, patch(corner[0], corner[1], corner[2], corner[3]));
    add_face(&b, patch(corner[0], corner[1], up[0], up[1]));
    add_face(&b, patch(corner[0], corner[1], aside[0], aside[1]));
    find_shells(&b, 0);
    check_counts(&b, 3, 12, 12, "three at an edge");
    drop(&b);
    for (int way = 0; way < 8; way++) {
        add_face(&b, shape_saddle(0.7));
        add_face(&b, turned(shape_saddle(0.7), way));
        find_shells(&b, 0);
        check_counts(&b, 2, 8, 8, "a copy");
        drop(&b);
    }
    add_face(&b, patch(corner[0], corner[1], corner[2], corner[3]));
    add_face(&b, patch(corner[0], corner[1], half[0], half[1]));
    add_face(&b, patch(half[0], half[1], corner[2], corner[3]));
    find_shells(&b, 0);
    check_counts(&b, 2, 11, 10, "a whole on its parts");
    drop(&b);
}

/* A flat bag: closed, joined at angles, but of no volume that counts; and a flat one that does. */
static void test_thin(void)
{
    for (int k = 0; k < 2; k++) {
        const double thick = k == 0 ? 1.2e-6 : 1e-4; /* volume over area is an 18th of it */
        double low[27], high[27];
        body b = {.count = 0};
        for (int i = 0; i < 3; i++) {
            for (int j = 0; j < 3; j++) {
                const double x[3] = {0.5 * i, 0.5 * j, i == 1 && j == 1 ? thick : 0};
                for (int c = 0; c < 3; c++) {
                    low[3 * (3 * i + j) + c] = c == 2 ? -x[c] : x[c];
                    high[3 * (3 * i + j) + c] = x[c];
                }
            }
        }
        add_face(&b, shape_surface(shape_bezier(2, 0, 1), shape_bezier(2, 0, 1), low, NULL));
        add_face(&b, shape_surface(shape_bezier(2, 0, 1), shape_bezier(2, 0, 1), high, NULL));
        find_shells(&b, 0);
        if (k == 0) {
            check_counts(&b, 2, 8, 8, "flat");
        } else {
            check_counts(&b, 1, 4, 4, "thin");
            check_first(&b, 1, 1, "thin");
        }
        drop(&b);
    }
}

/* A bar of three stretches, the last shorter than what long nets may be apart: sewn, edges as long as that stretch too. */
static void test_short(void)
{
    static const double ends[4] = {0, 1e4, 1e4 + 1, 1e4 + 1 + 1e-6};
    static const double around[5][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}};
    double x[4][5][3];
    body b = {.count = 0};
    for (int i = 0; i < 4; i++) {
        for (int j = 0; j < 5; j++) {
            x[i][j][0] = ends[i];
            memcpy(x[i][j] + 1, around[j], sizeof around[j]);
        }
        for (int j = 0; i > 0 && j < 4; j++) {
            add_face(&b, turned(patch(x[i - 1][j], x[i - 1][j + 1], x[i][j], x[i][j + 1]),
                                random_int(0, 7)));
        }
    }
    add_face(&b, patch(x[0][0], x[0][1], x[0][3], x[0][2]));
    add_face(&b, patch(x[3][0], x[3][1], x[3][3], x[3][2]));
    find_shells(&b, 0);
    check_counts(&b, 1, 28, 16, "a bar");
    check_first(&b, 1, 1, "a bar");
    drop(&b);
}

/* Edges of other degrees and knots are the same curve; of other speed they are not. */
static void test_other_bases(void)
{
    for (int way = 0; way < 8; way++) {
        const double corner[6][3] = {{0, 0, 0},   {0, 1, 0}, {1, 0, 0},
                                     {1, 1, 0.5}, {2, 0, 1}, {2, 1, 1}};
        taut_surface *raised = NULL, *cut = NULL, *moved = NULL;
        body b = {.count = 0};
        taut_surface *other = patch(corner[2], corner[3], corner[4], corner[5]);
        CHECK(taut_surface_elevate(other, TAUT_ALONG_V, 2, &raised, NULL) == TAUT_OK &&
                  taut_surface_insert(raised, TAUT_ALONG_V, 0.3, 1, &cut, NULL) == TAUT_OK &&
                  taut_surface_rerange(cut, TAUT_ALONG_V, -7, 4, &moved, NULL) == TAUT_OK,
              "other");
        add_face(&b, patch(corner[0], corner[1], corner[2], corner[3]));
        add_face(&b, turned(moved, way));
        find_shells(&b, 0);
        check_counts(&b, 1, 7, 6, "other bases");
        taut_surface_free(other);
        taut_surface_free(raised);
        taut_surface_free(cut);
        drop(&b);
    }
}

/* Eight plane sides around an axis, from radius 1 at z = shift to radius 1 + more at z = shift + height: the lid on the wide end
 * holds most of its volume. */
static taut_surface *funnel(double more, double height, double shift)
{
    static const double ring[9][2] = {{1, 0},   {1, 1},  {0, 1},  {-1, 1}, {-1, 0},
                                      {-1, -1}, {0, -1}, {1, -1}, {1, 0}};
    double points[9][2][3];
    for (int k = 0; k < 18; k++) {
        const double r = 1 + k % 2 * more;
        points[k / 2][k % 2][0] = shift + r * ring[k / 2][0];
        points[k / 2][k % 2][1] = r * ring[k / 2][1];
        points[k / 2][k % 2][2] = shift + k % 2 * height;
    }
    return shape_surface(shape_bspline(1, 9), shape_bezier(1, 0, 1), &points[0][0][0], NULL);
}

/* Tubes, whole and of two halves, show their outside, whichever way their parameters run; a flat ring, which has
 * none, stays as its parameters are. */
static void test_tubes(void)
{
    static const double middle[3] = {0, 0, 1.5}, high[3] = {0, 0, 2.5};
    for (int way = 0; way < 8; way++) {
        body b = {.count = 0};
        taut_model *halves = NULL;
        taut_surface *tube = shape_cylinder(2, 3, 1 + way % 2), *half = NULL;
        add_face(&b, turned(shape_cylinder(2, 3, 2), way));
        find_shells(&b, 0);
        check_first(&b, 0, 0, "tube");
        check_outwards(&b, middle, "tube");
        drop(&b);
        CHECK(taut_surface_split(tube, TAUT_ALONG_V, 0.5 * taut_basis_hi(taut_surface_v(tube)),
                                 &halves, NULL) == TAUT_OK,
              "split");
        for (int i = 0; i < 2; i++) {
            CHECK(taut_surface_copy(taut_model_surface(halves, i), &half) == TAUT_OK, "half");
            add_face(&b, turned(half, i == 0 ? way : 7 - way));
        }
        taut_model_free(halves);
        find_shells(&b, 0);
        CHECK(b.shells.shell_count == 1, "two halves are %d shells", b.shells.shell_count);
        check_outwards(&b, middle, "halves");
        drop(&b);
        taut_surface_free(tube);
        add_face(&b, turned(funnel(3, 3, 0), way));
        find_shells(&b, 0);
        check_outwards(&b, high, "funnel");
        drop(&b);
        add_face(&b, turned(funnel(1, 0, 1000), way));
        find_shells(&b, 0);
        CHECK(!b.shells.faces[0].turned, "way %d: a flat ring is turned", way);
        drop(&b);
    }
}

int main(void)
{
    random_seed(20261120);
    test_one_face();
    test_box();
    test_gap();
    test_weights();
    test_loop();
    test_twisted();
    test_not_joined();
    test_thin();
    test_short();
    test_tubes();
    test_other_bases();
    return check_failures != 0;
}
