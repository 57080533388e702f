/* test_scene.c -- what is in front covers: the painted page against a ray through each point. */
#include "check.h"

#include "draw/scene.h"

#include <string.h>

enum { N = 24, PAGE = 400 };

/* A sheet: a grid of (x, y, depth), gently curved, anywhere on the page. */
typedef struct sheet {
    double at[N + 1][N + 1][3];
    taut_ink ink;
} sheet;

static void random_sheet(sheet *s, double depth, unsigned char mark)
{
    const double cx = random_in(150, 250), cy = random_in(150, 250), turn = random_in(0, 6.28);
    const double a = random_in(60, 140), b = random_in(60, 140);
    const double bend = random_in(-30, 30), tilt = random_in(-0.3, 0.3);
    for (int i = 0; i <= N; i++) {
        for (int j = 0; j <= N; j++) {
            const double x = a * (2.0 * i / N - 1), y = b * (2.0 * j / N - 1);
            s->at[i][j][0] = cx + x * cos(turn) - y * sin(turn);
            s->at[i][j][1] = cy + x * sin(turn) + y * cos(turn);
            s->at[i][j][2] = depth + bend * sin(0.02 * x) * cos(0.02 * y) + tilt * x;
        }
    }
    s->ink = (taut_ink){mark, 0, 0};
}

/* The depth of a sheet at a point of the page by looking through every triangle; -INFINITY beside
 * it. */
static double depth_by_ray(const sheet *s, double x, double y)
{
    double found = -INFINITY;
    for (int i = 0; i < N; i++) {
        for (int j = 0; j < N; j++) {
            const double *q[4] = {s->at[i][j], s->at[i + 1][j], s->at[i + 1][j + 1],
                                  s->at[i][j + 1]};
            for (int half = 0; half < 2; half++) {
                const double *a = q[0], *b = q[half + 1], *c = q[half + 2];
                const double d[2] = {b[0] - a[0], b[1] - a[1]}, e[2] = {c[0] - a[0], c[1] - a[1]};
                const double f[2] = {x - a[0], y - a[1]};
                const double det = d[0] * e[1] - d[1] * e[0];
                const double s1 = (f[0] * e[1] - f[1] * e[0]) / det;
                const double s2 = (d[0] * f[1] - d[1] * f[0]) / det;
                if (s1 >= 0 && s2 >= 0 && s1 + s2 <= 1) {
                    found = fmax(found, a[2] + s1 * (b[2] - a[2]) + s2 * (c[2] - a[2]));
                }
            }
        }
    }
    return found;
}

/* A canvas that remembers what colour was last laid on each of some points. */
typedef struct taut_canvas {
    int count;
    double at[400][2];
    int mark[400];
    int lines;
    double drawn; /* length of all lines */
    double end[2][2];
} taut_canvas;

static int inside(int count, const double (*xy)[2], const double p[2])
{
    int in = 0;
    for (int i = 0, j = count - 1; i < count; j = i++) {
        if ((xy[i][1] > p[1]) != (xy[j][1] > p[1]) &&
            p[0] < (xy[j][0] - xy[i][0]) * (p[1] - xy[i][1]) / (xy[j][1] - xy[i][1]) + xy[i][0]) {
            in = !in;
        }
    }
    return in;
}

static void lay_polygon(taut_canvas *canvas, int count, const double (*xy)[2], taut_ink ink)
{
    for (int k = 0; k < canvas->count; k++) {
        if (inside(count, xy, canvas->at[k])) {
            canvas->mark[k] = ink.r;
        }
    }
}

static void lay_line(taut_canvas *canvas, int count, const double (*xy)[2], taut_ink ink,
                     double width)
{
    (void)ink;
    (void)width;
    canvas->lines++;
    for (int i = 1; i < count; i++) {
        canvas->drawn += hypot(xy[i][0] - xy[i - 1][0], xy[i][1] - xy[i - 1][1]);
    }
    memcpy(canvas->end[0], xy[0], sizeof canvas->end[0]);
    memcpy(canvas->end[1], xy[count - 1], sizeof canvas->end[1]);
}

static const taut_canvas_ops recorder = {
    .size = sizeof(taut_canvas), .polygon = lay_polygon, .line = lay_line};

static void add_sheet(taut_scene *scene, const sheet *s)
{
    for (int i = 0; i < N; i++) {
        for (int j = 0; j < N; j++) {
            const double *const q[4] = {s->at[i][j], s->at[i + 1][j], s->at[i + 1][j + 1],
                                        s->at[i][j + 1]};
            taut_scene_cell(scene, q, s->ink);
        }
    }
}

/* Is (x, y) beside a sheet but within a unit of it? Cells reach 0.35 units over their border. All
 * around, and at shares of the unit: beside a corner a sheet lies in few directions only. */
static int at_border(const sheet *s, double x, double y)
{
    const int inside = isfinite(depth_by_ray(s, x, y));
    int near = 0;
    for (int k = 0; k < 64 && !inside && !near; k++) {
        const double angle = k % 16 * 0.39269908169872414, r = 0.25 * (1 + k / 16);
        near = isfinite(depth_by_ray(s, x + r * cos(angle), y + r * sin(angle)));
    }
    return near;
}

/* The colour of the sheet that a ray meets first, 0 if none, -1 at a border. */
static int first_met(const sheet sheets[3], const double p[2])
{
    double nearest = -INFINITY;
    int top = 0;
    for (int i = 0; i < 3; i++) {
        const double depth = depth_by_ray(&sheets[i], p[0], p[1]);
        if (at_border(&sheets[i], p[0], p[1])) {
            return -1;
        }
        if (depth > nearest) {
            nearest = depth;
            top = sheets[i].ink.r;
        }
    }
    return top;
}

/* Three sheets in random order, 150 apart and within 75 of their own depth: wherever a ray meets
 * one, the nearest it meets is on top. */
static void test_painter(void)
{
    for (int trial = 0; trial < 20; trial++) {
        sheet sheets[3];
        taut_canvas canvas = {.count = 400};
        taut_arena *arena = taut_arena_new();
        taut_scene scene;
        int met = 0;
        CHECK(taut_scene_init(&scene, PAGE, PAGE, arena) == TAUT_OK, "scene");
        for (int k = 0; k < 3; k++) {
            random_sheet(&sheets[k], 150.0 * ((k * 2 + trial) % 3), (unsigned char)(k + 1));
            add_sheet(&scene, &sheets[k]);
        }
        for (int k = 0; k < canvas.count; k++) {
            canvas.at[k][0] = random_in(0, PAGE);
            canvas.at[k][1] = random_in(0, PAGE);
        }
        taut_scene_paint(&scene, &recorder, &canvas);
        for (int k = 0; k < canvas.count; k++) {
            const int top = first_met((const sheet *)sheets, canvas.at[k]);
            met += top > 0;
            CHECK(top == -1 || canvas.mark[k] == top, "at (%g, %g) found %d, nearest is %d",
                  canvas.at[k][0], canvas.at[k][1], canvas.mark[k], top);
        }
        CHECK(met > 40, "%d points met a sheet", met);
        taut_scene_clear(&scene);
        taut_arena_free(arena);
    }
}

/* A line through a level sheet: the part before the sheet and the part beside it are drawn, the
 * part behind is not. The sheet covers x in [100, 300] at depth 0; the line runs along x with depth
 * falling through 0 at x = crossing. One step of a unit and the 1.5 units of slack may be off. */
static void test_line(void)
{
    for (int trial = 0; trial < 100; trial++) {
        const double crossing = random_in(120, 280), slope = random_in(0.5, 3);
        const double line[6] = {20,  200.5, (crossing - 20) * slope,
                                380, 200.5, (crossing - 380) * slope};
        const double q[4][3] = {{100, 100, 0}, {300, 100, 0}, {300, 300, 0}, {100, 300, 0}};
        const double *const corner[4] = {q[0], q[1], q[2], q[3]};
        const double bound = 1 + 1.5 / slope;
        taut_canvas canvas = {.count = 0};
        taut_arena *arena = taut_arena_new();
        taut_scene scene;
        CHECK(taut_scene_init(&scene, PAGE, PAGE, arena) == TAUT_OK, "scene");
        taut_scene_cell(&scene, corner, (taut_ink){0, 0, 0});
        taut_scene_line(&scene, 2, line, (taut_ink){0, 0, 0}, 1);
        taut_scene_paint(&scene, &recorder, &canvas);
        CHECK(canvas.lines == 2, "%d pieces, crossing=%g", canvas.lines, crossing);
        CHECK_NEAR(canvas.drawn, (crossing - 20) + (380 - 300), 2 * bound, "slope=%g", slope);
        CHECK_NEAR(canvas.end[0][0], 300, 3, "comes out beside the sheet");
        taut_scene_clear(&scene);
        taut_arena_free(arena);
    }
}

/* A line of a net: what a surface hides is there too, and what lies behind by less than the slack counts as seen. */
static void test_through(void)
{
    for (int near = 0; near < 2; near++) {
        const double depth = near ? -4 : -40;
        const double line[6] = {20, 200, depth, 380, 200, depth};
        double q[4][3] = {{100, 100, 0}, {300, 100, 0}, {300, 300, 0}, {100, 300, 0}};
        const double *const corner[4] = {q[0], q[1], q[2], q[3]};
        taut_canvas canvas = {.count = 0};
        taut_arena *arena = taut_arena_new();
        taut_scene scene;
        CHECK(taut_scene_init(&scene, PAGE, PAGE, arena) == TAUT_OK, "scene");
        taut_scene_cell(&scene, corner, (taut_ink){0, 0, 0});
        taut_scene_line_through(&scene, 2, line, (taut_ink){0, 0, 0}, (taut_ink){9, 9, 9}, 1, 8);
        taut_scene_paint(&scene, &recorder, &canvas);
        CHECK(canvas.lines == (near ? 1 : 3), "%d pieces", canvas.lines);
        CHECK_NEAR(canvas.drawn, 360, 1e-9, "all of it");
        taut_scene_clear(&scene);
        taut_arena_free(arena);
    }
}

/* What is not finite or has no length leaves nothing, and nothing else is harmed. */
static void test_not_finite(void)
{
    const double bad[4] = {(double)NAN, INFINITY, -INFINITY, (double)NAN};
    for (int k = 0; k < 12; k++) {
        double line[12] = {10, 10, 0, 20, 10, 0, 30, 10, 0, 40, 10, 0};
        double q[4][3] = {{100, 100, 0}, {300, 100, 0}, {300, 300, 0}, {100, 300, 0}};
        const double *const corner[4] = {q[0], q[1], q[2], q[3]};
        taut_canvas canvas = {.count = 1, .at = {{200, 200}}};
        taut_arena *arena = taut_arena_new();
        taut_scene scene;
        line[k] = bad[k % 4];
        q[k / 3][k % 3] = bad[k % 4];
        CHECK(taut_scene_init(&scene, PAGE, PAGE, arena) == TAUT_OK, "scene");
        taut_scene_cell(&scene, corner, (taut_ink){9, 0, 0});
        taut_scene_line(&scene, 4, line, (taut_ink){0, 0, 0}, 1);
        taut_scene_paint(&scene, &recorder, &canvas);
        CHECK(canvas.mark[0] == 0, "no cell");
        CHECK_NEAR(canvas.drawn, k / 3 == 0 || k / 3 == 3 ? 20 : 10, 1e-12, "k=%d", k);
        taut_scene_clear(&scene);
        taut_arena_free(arena);
    }
}

/* A joint of a tube, seen at 30 degrees: the circle about the axis at a point of it is an ellipse on the page, 20 by 40
 * units of half width, whose left half is in front. What is behind ends where it goes round the edge: within 0.4 units of
 * the tube's edge it still counts as seen, which is at 40 (1 - cos d) = 0.4, 20 sin d = 2.8 units behind the edge, and a
 * step of a unit may be off. The left half is whole. */
static void test_joint(void)
{
    enum { ROUND = 96 };
    static const double radius = 40, middle[2] = {200, 200}, tilt[2] = {0.5, 0.86602540378443865};
    taut_arena *arena = taut_arena_new();
    taut_scene scene;
    double ring[2][ROUND + 1][3], joint[ROUND + 1][3], low = INFINITY, high = -INFINITY, edge = 0;

    CHECK(taut_scene_init(&scene, PAGE, PAGE, arena) == TAUT_OK, "scene");
    for (int k = 0; k <= ROUND; k++) {
        const double t = 2 * 3.14159265358979324 * k / ROUND, c = radius * cos(t);
        for (int end = -1; end <= 1; end++) {
            double *at = end < 0 ? ring[0][k] : end > 0 ? ring[1][k] : joint[k];
            at[0] = middle[0] - tilt[0] * c + 100 * end * tilt[1];
            at[1] = middle[1] + radius * sin(t);
            at[2] = tilt[1] * c + 100 * end * tilt[0];
        }
    }
    for (int k = 0; k < ROUND; k++) {
        const double *const q[4] = {ring[0][k], ring[1][k], ring[1][k + 1], ring[0][k + 1]};
        taut_scene_cell(&scene, q, (taut_ink){0, 0, 0});
    }
    taut_scene_line(&scene, ROUND + 1, joint[0], (taut_ink){0, 0, 0}, 1);
    for (size_t i = 0; i < scene.point_count; i++) {
        low = fmin(low, scene.points[i][0]);
        high = fmax(high, scene.points[i][0]);
        edge = fmax(edge, fabs(scene.points[i][1] - middle[1]));
    }
    CHECK_NEAR(low, middle[0] - tilt[0] * radius, 1e-9, "the front is seen");
    CHECK(edge > radius - 0.05, "the front is seen to the edge, %g", edge);
    CHECK(high < middle[0] + 4, "behind, the joint is seen to %g", high - middle[0]);
    taut_scene_clear(&scene);
    taut_arena_free(arena);
}

int main(void)
{
    random_seed(20260412);
    test_painter();
    test_line();
    test_joint();
    test_through();
    test_not_finite();
    return check_failures != 0;
}
