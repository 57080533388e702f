/* test_symmetry.c -- films of symmetric data. Sails are made from data that an isometry of the test's own maps to themselves,
 * and turned and moved: their points have to be mapped so too, to 1e-12 of the size. Data that are symmetric but for one number
 * leave any net as it is, bit for bit. */
#include "certificates.h"
#include "check.h"
#include "sails.h"

#include "construct/film/symmetry.h"

#include <stdlib.h>
#include <string.h>

/* Ways to be symmetric: what becomes of (u, v), and of (x, y, z) before the sail is turned. */
enum { MIRROR, MIRROR_V, HALF_TURN, DIAGONAL, DIAGONAL_TURN, SADDLE, KINDS };

static const struct map {
    int exchanges, reverses[2], swaps;
    double sign[3];
} maps[KINDS] = {[MIRROR] = {0, {1, 0}, 0, {-1, 1, 1}},
                 [MIRROR_V] = {0, {0, 1}, 0, {1, -1, 1}},
                 [HALF_TURN] = {0, {1, 1}, 0, {-1, -1, 1}},
                 [DIAGONAL] = {1, {0, 0}, 1, {1, 1, 1}},
                 [DIAGONAL_TURN] = {1, {0, 0}, 1, {1, 1, -1}},
                 [SADDLE] = {1, {1, 0}, 1, {-1, 1, -1}}}; /* a quarter of a turn, and a mirror */

static void map_point(const struct map *m, const double x[3], double image[3])
{
    image[0] = m->sign[0] * x[m->swaps ? 1 : 0];
    image[1] = m->sign[1] * x[m->swaps ? 0 : 1];
    image[2] = m->sign[2] * x[2];
}

static void map_place(const struct map *m, int last, int i, int j, int *a, int *b)
{
    const int p = m->exchanges ? j : i, q = m->exchanges ? i : j;
    *a = m->reverses[0] ? last - p : p;
    *b = m->reverses[1] ? last - q : q;
}

static int map_corner(const struct map *m, int c)
{
    int a = 0, b = 0;
    map_place(m, 1, c % 2, c / 2, &a, &b);
    return a + 2 * b;
}

/* By their corners, which the images of its own are. */
static int map_edge(const struct map *m, int e)
{
    static const int ends[4][2] = {{0, 2}, {1, 3}, {0, 1}, {2, 3}};
    const int a = map_corner(m, ends[e][0]), b = map_corner(m, ends[e][1]);
    for (int f = 0; f < 4; f++) {
        if ((ends[f][0] == a && ends[f][1] == b) || (ends[f][0] == b && ends[f][1] == a)) {
            return f;
        }
    }
    return e;
}

typedef struct sample {
    sail s;
    const struct map *map;
    double rows[3][3], offset[3]; /* turned and moved: x becomes rows x + offset */
} sample;

static void random_rows(double rows[3][3])
{
    double q[4], square = 0;
    for (int k = 0; k < 4; k++) {
        q[k] = random_in(-1, 1);
        square += q[k] * q[k];
    }
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            const int k = 3 - i - j;
            const double w = i == j ? 0 : ((j - i + 3) % 3 == 1 ? -q[3] : q[3]) * q[k];
            rows[i][j] = (i == j) + 2 * (q[i] * q[j] + w) / square;
            rows[i][j] -= i == j ? 2 * (square - q[3] * q[3]) / square : 0;
        }
    }
}

static void place(const sample *t, const double x[3], double out[3])
{
    for (int k = 0; k < 3; k++) {
        out[k] = t->offset[k] + t->rows[k][0] * x[0] + t->rows[k][1] * x[1] + t->rows[k][2] * x[2];
    }
}

static void take_back(const sample *t, const double x[3], double out[3])
{
    for (int k = 0; k < 3; k++) {
        out[k] = 0;
        for (int c = 0; c < 3; c++) {
            out[k] += t->rows[c][k] * (x[c] - t->offset[c]);
        }
    }
}

static taut_film_edge random_edge(void)
{
    taut_film_edge edge = {.kind = TAUT_FILM_CABLE, .force = random_in(2, 6)};
    switch (random_int(0, 5)) {
    case 0:
        return (taut_film_edge){.kind = TAUT_FILM_FIXED};
    case 1:
        return (taut_film_edge){
            .kind = TAUT_FILM_CABLE, .law = TAUT_FILM_SAG, .sag = random_in(0.05, 0.12)};
    case 2:
        return (taut_film_edge){.kind = TAUT_FILM_CABLE,
                                .law = TAUT_FILM_ELASTIC,
                                .unstressed = random_in(1.3, 1.5),
                                .stiffness = random_in(10, 30)};
    default:
        return edge;
    }
}

/* Corners and edges are carried round by the map until all are images of others. */
static sample random_sample(int kind)
{
    const int degree = random_int(2, 4);
    double corners[4][3], placed[4][3];
    sample t = {.map = &maps[kind]};
    taut_film_edge edges[4];

    for (int c = 0; c < 4; c++) {
        corners[c][0] = 2 * (c % 2) - 1 + random_in(-0.2, 0.2);
        corners[c][1] = 2 * (c / 2) - 1 + random_in(-0.2, 0.2);
        corners[c][2] = random_in(-0.5, 0.5);
        edges[c] = random_edge();
    }
    for (int c = 3; c >= 0; c--) { /* what is fixed is on the way of its orbit's mean */
        double x[3] = {0, 0, 0}, y[3];
        int order = 0;
        for (int at = c; order == 0 || at != c; order++) {
            at = map_corner(t.map, at);
        }
        memcpy(y, corners[c], sizeof y);
        for (int k = 0; k < 4; k++) { /* 4 is a multiple of all orders */
            for (int n = 0; n < order; n++) {
                double image[3];
                map_point(t.map, y, image);
                memcpy(y, image, sizeof y);
            }
            for (int n = 0; n < 3; n++) {
                x[n] += 0.25 * y[n];
            }
        }
        for (int at = c, k = 0; k < order; k++) {
            memcpy(corners[at], x, sizeof x);
            map_point(t.map, corners[at], x);
            at = map_corner(t.map, at);
        }
        for (int at = c, next = map_edge(t.map, c); next != c; next = map_edge(t.map, at)) {
            edges[next] = edges[c];
            at = next;
        }
    }
    random_rows(t.rows);
    for (int k = 0; k < 3; k++) {
        t.offset[k] = random_in(-2, 2);
    }
    for (int c = 0; c < 4; c++) {
        place(&t, corners[c], placed[c]);
    }
    t.s = sail_new(degree, degree + random_int(2, 8), (const double(*)[3])placed, 1);
    memcpy(t.s.problem.edges, edges, sizeof edges);
    t.s.problem.without_least = 1;
    return t;
}

/* How far the farthest point is from where the map wants it. */
static double asymmetry(const sample *t, const double *points)
{
    const int n = taut_basis_count(t->s.u);
    double worst = 0;

    for (int i = 0; i < n; i++) {
        for (int j = 0; j < n; j++) {
            int a = 0, b = 0;
            double x[3], y[3], image[3];
            map_place(t->map, n - 1, i, j, &a, &b);
            take_back(t, points + 3 * (i * n + j), x);
            take_back(t, points + 3 * (a * n + b), y);
            map_point(t->map, x, image);
            for (int c = 0; c < 3; c++) {
                worst = fmax(worst, fabs(image[c] - y[c]));
            }
        }
    }
    return worst;
}

/* points become the mean of themselves and their images, of all powers of the map, 4 at most. */
static void take_mean(const sample *t, double *points)
{
    const int n = taut_basis_count(t->s.u);
    double *mean = calloc((size_t)(3 * n * n), sizeof *mean);

    for (int at = 0; at < n * n; at++) {
        int i = at / n, j = at % n;
        double x[3], image[3];
        take_back(t, points + 3 * at, x);
        for (int power = 0; power < 4; power++) {
            int a = 0, b = 0;
            place(t, x, image);
            for (int c = 0; c < 3; c++) {
                mean[3 * (n * i + j) + c] += 0.25 * image[c];
            }
            map_place(t->map, n - 1, i, j, &a, &b);
            map_point(t->map, x, image);
            memcpy(x, image, sizeof x);
            i = a;
            j = b;
        }
    }
    memcpy(points, mean, (size_t)(3 * n * n) * sizeof *points);
    free(mean);
}

static double energy_of(const taut_film_problem *problem, const taut_model *model)
{
    taut_certificate *proof = NULL;
    CHECK(taut_film_certify(model, problem, NULL, &proof, NULL) == TAUT_OK, "certify");
    const double energy = figure_of(proof, "energy");
    taut_certificate_free(proof);
    return energy;
}

/* Weak cables, and coarse nets, buckle: what has least energy need not be symmetric. From the mean of it and its images there is a
 * symmetric film of more energy then, or none. */
static void check_buckled(const sample *t, const taut_model *model, int trial)
{
    const taut_surface *surface = taut_model_surface(model, 0);
    const size_t bytes =
        3 * (size_t)taut_basis_count(t->s.u) * (size_t)taut_basis_count(t->s.v) * sizeof(double);
    taut_film_problem begun = t->s.problem;
    taut_model *other = NULL;
    double *start = malloc(bytes);

    memcpy(start, taut_surface_points(surface), bytes);
    take_mean(t, start);
    begun.start = start;
    if (taut_film_make(&begun, NULL, &other, NULL) == TAUT_OK) {
        const double *points = taut_surface_points(taut_model_surface(other, 0));
        CHECK(asymmetry(t, points) > 1e-3 ||
                  energy_of(&begun, other) > (1 + 1e-7) * energy_of(&t->s.problem, model),
              "trial %d", trial);
    }
    taut_model_free(other);
    free(start);
}

static void test_sails(void)
{
    const int trials = random_trials(48);
    int films = 0, buckled = 0;

    for (int trial = 0; trial < trials; trial++) {
        sample t = random_sample(trial % KINDS);
        taut_model *model = NULL;
        taut_error error = {.status = TAUT_OK};
        if (taut_film_make(&t.s.problem, NULL, &model, &error) == TAUT_OK) {
            const double *points = taut_surface_points(taut_model_surface(model, 0));
            const double off = asymmetry(&t, points);
            films++;
            if (off > 1e-12) {
                CHECK(off > 1e-3, "trial %d: %g", trial, off);
                check_buckled(&t, model, trial);
                buckled++;
            }
        }
        taut_model_free(model);
        sail_free(&t.s);
    }
    CHECK(films > 0, "no film of %d", trials);
    printf("%d films of %d, %d buckled\n", films, trials, buckled);
}

/* The saddle has all eight, and no rounding: its forces are one number. */
static void test_saddle(void)
{
    sail s = sail_new(4, 12, sail_saddle, 2);
    taut_certificate *proof = NULL;
    taut_model *model = sail_make(&s, &proof);

    for (int kind = 0; kind < KINDS; kind++) {
        struct map m = maps[kind];
        m.sign[2] = m.reverses[0] != m.reverses[1] ? -1 : 1; /* z = x y / 2 */
        const sample t = {.s = s, .map = &m, .rows = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
        const double off = asymmetry(&t, taut_surface_points(taut_model_surface(model, 0)));
        CHECK(off <= 1e-15, "kind %d: %g", kind, off);
    }
    CHECK(figure_of(proof, "balance") <= 1e-15, "balance %g", figure_of(proof, "balance"));
    taut_certificate_free(proof);
    taut_model_free(model);
    sail_free(&s);
}

/* Held lines that meet at blunt corners: the net of least energy slides to one side within its film, and its mean with its
 * image, which stays at rest along the moves, is none in all coordinates. Every claim holds. */
static void test_blunt(void)
{
    static const int spaces[][2] = {{3, 8}, {4, 10}, {3, 12}, {4, 12}};

    for (int angle = 125; angle <= 150; angle += 5) {
        const double h = tan(0.5 * (180 - angle) * 3.14159265358979323846 / 180);
        const double corners[4][3] = {{-1, 0, 0}, {0, -h, 0}, {0, 1.2, 0.7}, {1, 0, 0}};
        for (size_t k = 0; k < sizeof spaces / sizeof *spaces; k++) {
            sail s = sail_new(spaces[k][0], spaces[k][1], corners, 0);
            taut_certificate *proof = NULL;
            s.problem.without_least = 1;
            taut_model *model = sail_make(&s, &proof);
            taut_certificate_free(proof);
            taut_model_free(model);
            sail_free(&s);
        }
    }
}

/* What is kept on planes and lines is symmetric where these are: slides, cables in planes, corners on lines. */
static void test_kept(void)
{
    static const double high[4][3] = {{-1, -1, 0.3}, {1, -1, 0.3}, {-1, 1, 0}, {1, 1, 0}};
    static const sample mirror = {.map = &maps[MIRROR], .rows = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

    for (int kind = 0; kind < 4; kind++) {
        sail s = sail_new(kind == 3 ? 2 : 4, 9 + kind % 2, high, 4);
        taut_certificate *proof = NULL;
        taut_film_problem *problem = &s.problem;
        taut_film_edge *near = &problem->edges[2];
        sample t = mirror;

        problem->without_least = 1;
        near->plane = (taut_film_guide){{0, -1, 0.3}, {0, 1, kind == 2 ? 0.4 : 0}};
        if (kind == 2) {
            near->has_plane = 1;
        } else {
            near->kind = TAUT_FILM_SLIDE;
            near->law = TAUT_FILM_FORCE;
            near->force = 0;
            problem->corner_kinds[0] = problem->corner_kinds[1] = TAUT_FILM_FREE;
        }
        for (int c = 0; c < 2 && kind == 1; c++) {
            problem->corner_kinds[c] = TAUT_FILM_ON_LINE;
            problem->guides[c] = (taut_film_guide){{0, -1, 0.3}, {1, 0, c ? 0.2 : -0.2}};
        }
        taut_model *model = sail_make(&s, &proof);
        t.s = s;
        const double off = asymmetry(&t, taut_surface_points(taut_model_surface(model, 0)));
        CHECK(off <= 1e-14, "kind %d: %g", kind, off);
        taut_certificate_free(proof);
        taut_model_free(model);
        sail_free(&s);
    }
}

/* What is done to a net near the start by the data of a sail: how far a number moves. */
static double moved_by(const sail *s)
{
    taut_arena *arena = taut_arena_new();
    taut_film_problem normal = s->problem; /* at rest along the moves is enough, near the start */
    taut_film_space space;
    taut_film_work w = {
        .space = &space,
        .region = {
            .tolerance = 1e-6, .max_iterations = 200, .work_max = 1e11, .theta_least = 1e-6}};
    taut_error error = {.status = TAUT_OK};
    double farthest = 0;

    normal.method = TAUT_FILM_NORMAL;
    CHECK(taut_film_space_new(&normal, arena, &space, &error) == TAUT_OK, "%s", error.message);
    w.net = taut_arena_copy(arena, space.start, space.count, 3 * sizeof(double));
    double *before = taut_arena_take(arena, space.count, 3 * sizeof(double));
    CHECK(taut_arena_status(arena) == TAUT_OK, "memory");
    CHECK(taut_dirichlet_form_new(s->problem.u, s->problem.v, NULL, &w.form, &error) == TAUT_OK,
          "form");
    taut_film_start_laws(&w, 1);
    CHECK(taut_film_take_rule(&w, 0, 1) == TAUT_OK, "rule");
    for (size_t i = 0; i < 3 * space.count; i++) {
        w.net[i] += space.known[i / 3] ? 0 : random_in(-1e-7, 1e-7);
        before[i] = w.net[i];
    }
    CHECK(taut_film_make_symmetric(&w, arena, &error) == TAUT_OK, "%s", error.message);
    for (size_t i = 0; i < 3 * space.count; i++) {
        farthest = fmax(farthest, fabs(w.net[i] - before[i]));
    }
    taut_film_memory_clear(&w.memory);
    taut_film_drop_rule(&w);
    taut_dirichlet_form_clear(&w.form);
    taut_arena_free(arena);
    return farthest;
}

/* One number is another, and all that was symmetric is so no more. */
static void test_asymmetric(void)
{
    for (int change = 0; change < 11; change++) {
        sail s = sail_new(3, 7, sail_saddle, 4);
        taut_basis *uneven = NULL;
        const double knots[11] = {0, 0, 0, 0, 0.2, 0.5, 0.7, 1, 1, 1, 1};
        const taut_basis_spec spec = {
            .type = "bspline", .degree = 3, .knots = knots, .knot_count = 11};
        CHECK(taut_basis_new(&spec, 7, &uneven, NULL) == TAUT_OK, "knots");
        switch (change) {
        case 0:
            break;
        case 1:
            s.problem.corners[1][0] += 1e-9;
            s.problem.corners[1][1] += 3e-9;
            break;
        case 2:
            s.problem.edges[0].force *= 1 + 1e-9;
            s.problem.edges[1].force *= 1 + 2e-9;
            s.problem.edges[2].force *= 1 + 3e-9;
            break;
        case 3:
            s.problem.edges[0] = (taut_film_edge){.kind = TAUT_FILM_FIXED};
            s.problem.edges[3].force = 4.5;
            break;
        case 4:
            s.problem.edges[2].law = TAUT_FILM_SAG;
            s.problem.edges[2].sag = 0.1;
            s.problem.edges[0].force = 4.5;
            break;
        case 5:
            s.problem.u = uneven;
            s.problem.edges[2].force = 4.5;
            break;
        case 6:
            s.problem.u = s.problem.v = uneven;
            s.problem.edges[0].force = 4.5;
            break;
        case 7:
            s.problem.edges[0].law = s.problem.edges[1].law = TAUT_FILM_ELASTIC;
            s.problem.edges[0].unstressed = s.problem.edges[1].unstressed = 2;
            s.problem.edges[0].stiffness = 40;
            s.problem.edges[1].stiffness = 40.0000001;
            s.problem.edges[2].force = 4.5;
            break;
        case 8:
            s.problem.force_density[0] = 2;
            s.problem.force_density[1] = 1;
            s.problem.edges[0].force = s.problem.edges[2].force = 4.5;
            break;
        default: /* cables in planes that half a turn exchanges, or nearly */
            s.problem.edges[0].force = 4.5;
            for (int e = 2; e < 4; e++) {
                taut_film_edge *edge = &s.problem.edges[e];
                edge->has_plane = 1;
                memcpy(edge->plane.point, s.problem.corners[e == 2 ? 0 : 2], 3 * sizeof(double));
                edge->plane.direction[0] = 1;
                edge->plane.direction[1] = e == 2 ? 0.3 : change == 9 ? -0.3 : -0.300000001;
                edge->plane.direction[2] = e == 2 ? 2 : -2;
            }
        }
        const double moved = moved_by(&s);
        CHECK((moved > 0) == (change == 0 || change == 9), "change %d: moved by %g", change, moved);
        taut_basis_free(uneven);
        sail_free(&s);
    }
}

int main(void)
{
    random_seed(31);
    test_saddle();
    test_sails();
    test_kept();
    test_blunt();
    test_asymmetric();
    return check_failures != 0;
}
