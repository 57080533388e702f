/* test_flat.c -- flat pieces against closed forms (cylinder, cone, bands whose width is a quadrature)
 * and against digits that two discretisations of another program share (gores, catenoid). */
#include "check.h"
#include "core/constants.h"
#include "pattern/flat/flat.h"

#include <math.h>

static const double third = TAUT_PI / 3;

static void set(double g[3], double ss, double st, double tt)
{
    g[0] = ss;
    g[1] = st;
    g[2] = tt;
}

/* Gore of the unit sphere, 12 to the turn, latitudes -+60 degrees. */
static void gore(const void *context, double s, double t, double g[3])
{
    const double width = *(const double *)context, c = cos((2 * s - 1) * third) * width;
    (void)t;
    set(g, 4 * third * third, 0, c * c);
}

/* Catenoid r = cosh v, -1 <= v <= 1.2, between meridians pi/8 apart, s in proportion to sinh v. */
static void catenoid(const void *context, double s, double t, double g[3])
{
    const double lo = sinh(-1.0), hi = sinh(1.2), x = lo + (hi - lo) * s;
    const double r = hypot(1, x) * TAUT_PI / 8;
    (void)context, (void)t;
    set(g, (hi - lo) * (hi - lo), 0, r * r);
}

/* Cylinder of radius 2 and height 3 between helices from angle 0 to 1.2, turned by 0.7. */
static void cylinder(const void *context, double s, double t, double g[3])
{
    (void)context, (void)s, (void)t;
    set(g, 4 * 1.44 + 9, -4 * 1.2 * 0.7, 4 * 0.49); /* t runs towards falling angle */
}

/* Cone of sine 0.6, slant 1 to 3, turn pi/4. */
static void cone(const void *context, double s, double t, double g[3])
{
    const double r = (1 + 2 * s) * 0.6 * TAUT_PI / 4;
    (void)context, (void)t;
    set(g, 4, 0, r * r);
}

/* Bands: latitudes -+0.25 of the sphere, or of its hyperbolic twin. */
static void band(const void *context, double s, double t, double g[3])
{
    const double h = (t - 0.5) * 0.5, f = *(const int *)context ? cosh(h) : cos(h);
    (void)s;
    set(g, f * f, 0, 0.25);
}

static double distance(const taut_flat *flat, double s0, double t0, double s1, double t1)
{
    double a[3][2], b[3][2];
    taut_flat_at(flat, s0, t0, a);
    taut_flat_at(flat, s1, t1, b);
    return hypot(a[0][0] - b[0][0], a[0][1] - b[0][1]);
}

static void strains(const taut_flat *flat, const taut_flat_strip *strip, double range[2])
{
    range[0] = INFINITY;
    range[1] = -INFINITY;
    for (int i = 0; i <= 32; i++) {
        for (int k = 0; k <= 8; k++) {
            double g[3], y[3][2], e[2];
            strip->metric(strip->context, i / 32.0, k / 8.0, g);
            taut_flat_at(flat, i / 32.0, k / 8.0, y);
            const double shrink[2] = {1 - flat->warp, 1 - flat->weft};
            taut_flat_strain(shrink, g, (const double(*)[2])y, e, NULL);
            range[0] = fmin(range[0], e[1]);
            range[1] = fmax(range[1], e[0]);
        }
    }
}

static int flatten(taut_arena *arena, const taut_flat_strip *strip,
                   const taut_flat_options *options, taut_flat *flat)
{
    const taut_status status = taut_flatten(arena, strip, options, NULL, flat);
    CHECK(status == TAUT_OK, "flatten: status %d", (int)status);
    if (status == TAUT_OK) {
        double y[3][2];
        taut_flat_at(flat, 0, 0.5, y);
        CHECK(flat->is_stable, "a minimum");
        CHECK(flat->residual < 1e-9, "stationary: %g", flat->residual);
        CHECK_NEAR(hypot(y[0][0], y[0][1]), 0, 1e-14, "the middle of start is the origin");
    }
    return status == TAUT_OK;
}

/* Isometric pieces: no strain, whatever their compensation. */
static void test_developable(void)
{
    const taut_flat_strip strips[2] = {{cylinder, NULL, NULL}, {cone, NULL, NULL}};
    const double angle = 0.471238898038468986; /* of the annular sector */
    for (int k = 0; k < 2; k++) {
        taut_arena *arena = taut_arena_new();
        taut_flat plain, small;
        const taut_flat_options none = {.spans = {0, 0}}, shrunk = {.warp = 0.02, .weft = 0.045};
        if (flatten(arena, &strips[k], &none, &plain) &&
            flatten(arena, &strips[k], &shrunk, &small)) {
            double range[2];
            strains(&plain, &strips[k], range);
            CHECK(range[0] > -1e-7 && range[1] < 1e-7, "%d: strain %g %g", k, range[0], range[1]);
            strains(&small, &strips[k], range);
            CHECK(range[0] > -1e-7 && range[1] < 1e-7, "%d: strain %g %g", k, range[0], range[1]);
            CHECK_NEAR(small.flat_area, plain.flat_area * 0.98 * 0.955, 1e-10, "area");
            if (k == 0) {
                CHECK_NEAR(plain.flat_area, 4.2, 1e-12, "area");
                CHECK_NEAR(distance(&plain, 0, 0, 1, 0), 3.84187454245970916, 1e-12, "seam");
                CHECK_NEAR(distance(&plain, 0, 0, 0, 1), 1.4, 1e-12, "end");
                CHECK_NEAR(distance(&small, 0, 0, 1, 0), 3.84187454245970916 * 0.98, 1e-11,
                           "seams run along the warp");
            } else {
                CHECK_NEAR(plain.flat_area, 1.88495559215387594, 1e-9, "area");
                CHECK_NEAR(distance(&plain, 1, 0, 1, 1), 6 * sin(angle / 2), 1e-7, "long end");
                CHECK_NEAR(distance(&plain, 0, 0, 0, 1), 2 * sin(angle / 2), 1e-7, "short end");
            }
        }
        taut_arena_free(arena);
    }
}

/* Bands held at m times their length, ends straight: width, energy, strain on the axis by quadrature. */
static void test_bands(void)
{
    const struct {
        int hyperbolic;
        double m, width, energy, axis;
    } rows[] = {{0, 1, 0.499859320096304401, 1.36444152740974141e-4, 0.0320850239843856444},
                {0, 1.02154656524663774, 0.499978185217249849, 2.15971133149202622e-5,
                 0.0103161804818985882},
                {1, 1, 0.49987947395860948, 1.24418752274469007e-4, -0.0304563708597854149},
                {1, 0.979843192336438776, 0.499978443064301217, 2.17909370996846344e-5,
                 -0.0105114402761373013}};
    double held[4 * TAUT_FLAT_GAUSS];

    for (size_t k = 0; k < sizeof rows / sizeof rows[0]; k++) {
        taut_arena *arena = taut_arena_new();
        const taut_flat_strip strip = {band, &rows[k].hyperbolic, NULL};
        const taut_flat_options options = {
            .spans = {4, 8},
            .straight = 1,
            .held = {[TAUT_FLAT_RIGHT] = held, [TAUT_FLAT_LEFT] = held}};
        taut_flat flat;
        for (int i = 0; i < 4 * TAUT_FLAT_GAUSS; i++) {
            held[i] = rows[k].m;
        }
        if (flatten(arena, &strip, &options, &flat)) {
            double g[3], y[3][2], e[2];
            band(&rows[k].hyperbolic, 0.5, 0.5, g);
            taut_flat_at(&flat, 0.5, 0.5, y);
            const double shrink[2] = {1 - flat.warp, 1 - flat.weft};
            taut_flat_strain(shrink, g, (const double(*)[2])y, e, NULL);
            const double axis = rows[k].axis > 0 ? e[0] : e[1];
            CHECK_NEAR(distance(&flat, 0.5, 0, 0.5, 1), rows[k].width, 1e-11, "width");
            CHECK_NEAR(flat.energy, rows[k].energy, 1e-10 * rows[k].energy, "energy");
            CHECK_NEAR(axis, rows[k].axis, 1e-8, "strain on the axis");
        }
        taut_arena_free(arena);
    }
}

typedef struct printed {
    const char *name;
    void (*metric)(const void *context, double s, double t, double g[3]);
    double seam, area, flat_area, width, axis, energy, low, high; /* alone */
    double length, true_flat_area, true_width, true_energy;       /* seams at true length */
    double waist, true_axis;                                      /* the strain on the axis there */
} printed;

static const printed rows[] = {{.name = "gore",
                                .metric = gore,
                                .seam = 2.127306067,
                                .area = 0.906899682117108925,
                                .flat_area = 0.90698411728,
                                .width = 0.5233316127,
                                .axis = 2.078842809,
                                .energy = 2.80274336e-5,
                                .low = -0.02206,
                                .high = 0.01080,
                                .length = 2.09439510239319549,
                                .true_flat_area = 0.8922630244,
                                .true_width = 0.522095538,
                                .true_energy = 1.67695339e-4,
                                .waist = 0.5,
                                .true_axis = 0.031144},
                               {.name = "catenoid",
                                .metric = catenoid,
                                .seam = 2.66317414,
                                .area = 1.32468097591267802,
                                .flat_area = 1.32470965874,
                                .width = 0.398058412,
                                .axis = 2.69542435,
                                .energy = 9.57919238e-6,
                                .low = -0.006398,
                                .high = 0.012819,
                                .length = 2.68466254905597415,
                                .true_flat_area = 1.333160032,
                                .true_width = 0.397973470469,
                                .true_energy = 5.08918761e-5,
                                .waist = 0.437746335775811,
                                .true_axis = -0.018174}};

static double axis_length(const taut_flat *flat)
{
    double sum = 0;
    enum { PARTS = 2000 };
    for (int k = 0; k < PARTS; k++) {
        double y[3][2];
        taut_flat_at(flat, (k + 0.5) / PARTS, 0.5, y);
        sum += hypot(y[1][0], y[1][1]) / PARTS;
    }
    return sum;
}

static void test_printed(void)
{
    const double width = TAUT_PI / 6;
    double held[32 * TAUT_FLAT_GAUSS], found[32 * TAUT_FLAT_GAUSS];
    for (int i = 0; i < 32 * TAUT_FLAT_GAUSS; i++) {
        held[i] = 1;
    }
    for (size_t k = 0; k < sizeof rows / sizeof rows[0]; k++) {
        const printed *p = &rows[k];
        const taut_flat_strip strip = {p->metric, &width, NULL};
        const taut_flat_options alone = {.spans = {32, 6}};
        const taut_flat_options held_true = {
            .spans = {32, 6}, .held = {[TAUT_FLAT_RIGHT] = held, [TAUT_FLAT_LEFT] = held}};
        taut_arena *arena = taut_arena_new();
        taut_flat flat;
        double range[2];

        if (flatten(arena, &strip, &alone, &flat)) {
            const double right = taut_flat_edge_length(&flat, &strip, TAUT_FLAT_RIGHT, NULL);
            const double left = taut_flat_edge_length(&flat, &strip, TAUT_FLAT_LEFT, found);
            strains(&flat, &strip, range);
            CHECK_NEAR(flat.area, p->area, 1e-12, "%s: area", p->name);
            /* corners are singular, and a seam ends in two: spans of half the size bring 1e-6 */
            CHECK_NEAR(right, p->seam, 1e-6, "%s: cut seam", p->name);
            CHECK_NEAR(left, right, 1e-12, "%s: both sides", p->name);
            CHECK_NEAR(flat.energy, p->energy, 1e-6 * p->energy, "%s: energy", p->name);
            CHECK_NEAR(flat.flat_area, p->flat_area, 1e-9, "%s: flat area", p->name);
            CHECK_NEAR(distance(&flat, 0.5, 0, 0.5, 1), p->width, 2e-9, "%s: width", p->name);
            CHECK_NEAR(axis_length(&flat), p->axis, 1e-7, "%s: axis", p->name);
            CHECK(flat.steps <= 7, "%s: %d steps", p->name, flat.steps);
            CHECK_NEAR(range[0], p->low, 3e-4, "%s: least strain", p->name);
            CHECK_NEAR(range[1], p->high, 3e-4, "%s: largest strain", p->name);
        }
        const taut_flat_options graded = {.spans = {32, 8}, .graded = 1};
        if (flatten(arena, &strip, &graded, &flat)) { /* narrower spans next to corners */
            const double right = taut_flat_edge_length(&flat, &strip, TAUT_FLAT_RIGHT, NULL);
            CHECK_NEAR(right, p->seam, 5e-8, "%s: cut seam, graded", p->name);
            CHECK_NEAR(distance(&flat, 0.5, 0, 0.5, 1), p->width, 2e-9, "%s: graded", p->name);
            CHECK_NEAR(flat.energy, p->energy, 1e-8 * p->energy, "%s: energy, graded", p->name);
        }
        if (flatten(arena, &strip, &held_true, &flat)) {
            double g[3], y[3][2], e[2];
            p->metric(&width, p->waist, 0.5, g);
            taut_flat_at(&flat, p->waist, 0.5, y);
            const double shrink[2] = {1 - flat.warp, 1 - flat.weft};
            taut_flat_strain(shrink, g, (const double(*)[2])y, e, NULL);
            const double right = taut_flat_edge_length(&flat, &strip, TAUT_FLAT_RIGHT, NULL);
            CHECK_NEAR(
                right,
                sqrt(k == 0 ? 16 * third * third / 4 : 2.68466254905597415 * 2.68466254905597415),
                1e-12, "%s: true", p->name);
            CHECK_NEAR(flat.energy, p->true_energy, 1e-7 * p->true_energy, "%s: energy", p->name);
            CHECK_NEAR(flat.flat_area, p->true_flat_area, 1e-8, "%s: flat area", p->name);
            CHECK_NEAR(distance(&flat, 0.5, 0, 0.5, 1), p->true_width, 1e-9, "%s: width", p->name);
            CHECK_NEAR(k == 0 ? e[0] : e[1], p->true_axis, 1e-6, "%s: axis", p->name);
            CHECK(flat.steps <= 14, "%s: true length in %d steps", p->name, flat.steps);
        }
        taut_arena_free(arena);
    }
}

/* Coated cloth shears more easily than it stretches: on the bias a piece costs a sixth of what it costs
 * along the thread. The thread lies at the angle asked for. */
static void test_bias(void)
{
    static const taut_flat_law coated = {1000 / 0.972, 700 / 0.972, 140 / 0.972, 20};
    const double width = TAUT_PI / 6, ratios[3] = {6.8, 1, 5.5};
    const taut_flat_strip strip = {gore, &width, NULL};
    taut_arena *arena = taut_arena_new();
    double energy[3] = {0, 1, 0};
    for (int k = 0; k < 3; k++) {
        const taut_flat_options options = {.law = &coated, .thread = k * TAUT_PI / 4};
        taut_flat flat;
        if (flatten(arena, &strip, &options, &flat)) {
            double from[3][2], to[3][2];
            taut_flat_at(&flat, 0, 0.5, from);
            taut_flat_at(&flat, 1, 0.5, to);
            CHECK_NEAR(atan2(to[0][1] - from[0][1], to[0][0] - from[0][0]), options.thread, 1e-12,
                       "thread");
            energy[k] = flat.energy;
            if (k == 0) {
                CHECK_NEAR(distance(&flat, 0.5, 0, 0.5, 1), 0.52345, 5e-6, "width");
                CHECK_NEAR(flat.torque, 0, 1e-9, "a symmetric piece does not turn");
            }
        }
    }
    for (int k = 0; k < 3; k++) {
        CHECK_NEAR(energy[k] / energy[1], ratios[k], 0.05, "energy at %d quarters of a turn", k);
    }
    taut_arena_free(arena);
}

/* A side 300 times as long as the piece, the other a 500th of it: refused. */
static void test_refusal(void)
{
    const double width = TAUT_PI / 6;
    double held[2][4 * TAUT_FLAT_GAUSS];
    const taut_flat_strip strip = {gore, &width, NULL};
    const taut_flat_options options = {
        .spans = {4, 2}, .held = {[TAUT_FLAT_RIGHT] = held[0], [TAUT_FLAT_LEFT] = held[1]}};
    taut_flat flat;
    taut_arena *arena = taut_arena_new();
    for (int k = 0; k < 4 * TAUT_FLAT_GAUSS; k++) {
        held[0][k] = 300;
        held[1][k] = 1.0 / 500;
    }
    const taut_status status = taut_flatten(arena, &strip, &options, NULL, &flat);
    CHECK(status == TAUT_NOT_CONVERGED, "status %d", (int)status);
    CHECK(flat.steps > 0 && flat.points == NULL, "after %d steps", flat.steps);
    taut_arena_free(arena);
}

/* From a piece alone to the same held at its own natural lengths: nothing moves. */
static void test_again(void)
{
    const double width = TAUT_PI / 6;
    double held[2][16 * TAUT_FLAT_GAUSS];
    const taut_flat_strip strip = {gore, &width, NULL};
    const taut_flat_options alone = {.warp = 0};
    const taut_flat_options again = {
        .held = {[TAUT_FLAT_RIGHT] = held[0], [TAUT_FLAT_LEFT] = held[1]}};
    taut_arena *arena = taut_arena_new();
    taut_flat first, second;
    if (flatten(arena, &strip, &alone, &first)) {
        taut_flat_edge_length(&first, &strip, TAUT_FLAT_RIGHT, held[0]);
        taut_flat_edge_length(&first, &strip, TAUT_FLAT_LEFT, held[1]);
        CHECK(taut_flatten(arena, &strip, &again, &first, &second) == TAUT_OK, "again");
        CHECK_NEAR(second.energy, first.energy, 1e-12 * first.energy, "energy");
        CHECK(second.steps <= 2, "%d steps", second.steps);
    }
    taut_arena_free(arena);
}

/* A plane annulus of radii 1 to 2 over an angle of 2: bent in its own plane, and unrolled as it is. */
static void annulus(const void *context, double s, double t, double g[3])
{
    (void)context, (void)s;
    set(g, 4 * (2 - t) * (2 - t), 0, 1);
}

static void test_annulus(void)
{
    const taut_flat_strip strip = {annulus, NULL, NULL};
    const taut_flat_options none = {.warp = 0};
    taut_arena *arena = taut_arena_new();
    taut_flat flat;
    if (flatten(arena, &strip, &none, &flat)) {
        CHECK(flat.steps <= 3, "%d steps", flat.steps);
        CHECK_NEAR(flat.energy, 0, 1e-12, "no strain");
        CHECK_NEAR(flat.flat_area, 3, 1e-6, "area");
        CHECK_NEAR(distance(&flat, 0, 0, 1, 0), 4 * sin(1.0), 1e-6, "chord of the outer edge");
    }
    taut_arena_free(arena);
}

/* A quarter of a sphere, strained by a fifth: alone and held. */
static void test_wide(void)
{
    const double width = TAUT_PI / 2;
    double held[16 * TAUT_FLAT_GAUSS];
    const taut_flat_strip strip = {gore, &width, NULL};
    const taut_flat_options alone = {.warp = 0};
    const taut_flat_options straight = {
        .held = {[TAUT_FLAT_RIGHT] = held, [TAUT_FLAT_LEFT] = held}};
    taut_arena *arena = taut_arena_new();
    taut_flat first, second;
    for (int k = 0; k < 16 * TAUT_FLAT_GAUSS; k++) {
        held[k] = 1;
    }
    if (flatten(arena, &strip, &alone, &first) && flatten(arena, &strip, &straight, &second)) {
        CHECK(first.steps <= 14, "alone in %d steps", first.steps);
        CHECK(second.steps <= 20, "held in %d steps", second.steps);
    }
    taut_arena_free(arena);
}

/* A piece on twice the spans is the same piece, and a start that is nearly the end. */
static void test_halved(void)
{
    const double width = TAUT_PI / 6;
    const taut_flat_strip strip = {gore, &width, NULL};
    const taut_flat_options coarse = {.spans = {8, 2}}, fine = {.spans = {16, 4}};
    taut_arena *arena = taut_arena_new();
    taut_flat first, start, again, cold;
    if (flatten(arena, &strip, &coarse, &first)) {
        CHECK(taut_flat_halve(arena, &first, &start) == TAUT_OK, "memory");
        for (int k = 0; k <= 40; k++) {
            double a[3][2], b[3][2];
            taut_flat_at(&first, k / 40.0, k % 7 / 6.0, a);
            taut_flat_at(&start, k / 40.0, k % 7 / 6.0, b);
            for (int d = 0; d < 3; d++) {
                CHECK_NEAR(b[d][0], a[d][0], 1e-12, "y_1, derivative %d", d);
                CHECK_NEAR(b[d][1], a[d][1], 1e-12, "y_2, derivative %d", d);
            }
        }
        CHECK(taut_flatten(arena, &strip, &fine, &start, &again) == TAUT_OK, "from it");
        CHECK(again.steps <= 4, "%d steps", again.steps);
        if (flatten(arena, &strip, &fine, &cold)) {
            CHECK_NEAR(again.energy, cold.energy, 1e-13, "energy");
        }
    }
    taut_arena_free(arena);
}

int main(void)
{
    test_developable();
    test_bands();
    test_printed();
    test_annulus();
    test_wide();
    test_bias();
    test_again();
    test_halved();
    test_refusal();
    return check_failures != 0;
}
