/* test_order.c -- bow ties. A convex quadrilateral in a plane, lifted a little and turned, has one order without a
 * crossing and two that cross, which is known from how it was made; saddles that are steep, and other films, have none. */
#include "check.h"

#include "construct/film/order.h"

#include <math.h>
#include <string.h>

static int note_of(const double ring[4][3], char text[200])
{
    static const int ring_of[4] = {0, 1, 3, 2}; /* of u0v0, u1v0, u0v1, u1v1 */
    taut_film_problem problem = {.has_corner = {1, 1, 1, 1}};
    for (int k = 0; k < 4; k++) {
        memcpy(problem.corners[k], ring[ring_of[k]], sizeof problem.corners[k]);
        problem.edges[k].kind = k % 2 == 0 ? TAUT_FILM_CABLE : TAUT_FILM_FIXED;
    }
    text[0] = '\0';
    return taut_film_order_note(&problem, text, 200);
}

/* Four places on an ellipse in their order, lifted by up to a tenth, turned. */
static void make_ring(double x[4][3])
{
    const double long_side = random_in(1, 3), begin = random_in(0, 6), c = cos(begin),
                 s = sin(begin), size = exp(random_in(-20, 20));
    for (int k = 0; k < 4; k++) {
        const double angle = begin + 1.5 * k + random_in(0, 0.6);
        const double p[3] = {long_side * cos(angle), sin(angle), random_in(-0.05, 0.05)};
        x[k][0] = size * (c * p[0] - s * p[2]);
        x[k][1] = size * (p[1] + 7);
        x[k][2] = size * (s * p[0] + c * p[2]);
    }
}

static void exchange(double a[3], double b[3])
{
    for (int c = 0; c < 3; c++) {
        const double kept = a[c];
        a[c] = b[c];
        b[c] = kept;
    }
}

static void test_rings(void)
{
    for (int trial = 0; trial < 2000; trial++) {
        double x[4][3];
        char text[200];
        make_ring(x);
        CHECK(!note_of((const double(*)[3])x, text), "in order: %s", text);
        exchange(x[2], x[3]);
        CHECK(note_of((const double(*)[3])x, text) && strstr(text, "corners u0v1 and u1v1") != NULL,
              "round the film: %s", text);
        exchange(x[2], x[3]);
        exchange(x[1], x[2]);
        CHECK(note_of((const double(*)[3])x, text) && strstr(text, "corners u1v0 and u1v1") != NULL,
              "twisted: %s", text);
    }
}

/* Edges of high saddles pass each other far apart. */
static void test_saddles(void)
{
    for (int k = 0; k <= 40; k++) {
        const double h = 0.1 * k;
        const double x[4][3] = {{-1, -1, h}, {1, -1, -h}, {1, 1, h}, {-1, 1, -h}};
        char text[200];
        CHECK(!note_of(x, text), "height %g: %s", h, text);
    }
}

/* Nothing is said of what need not be straight, nor of what is not known; numbers out of range say nothing. */
static void test_others(void)
{
    taut_film_problem problem = {.corners = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}},
                                 .has_corner = {1, 1, 1, 1}};
    char text[200];
    CHECK(taut_film_order_note(&problem, text, sizeof text), "it is one");
    problem.edges[2].kind = TAUT_FILM_POLE;
    CHECK(!taut_film_order_note(&problem, text, sizeof text), "a pole");
    problem.edges[2].kind = TAUT_FILM_FIXED;
    problem.corner_kinds[1] = TAUT_FILM_FREE;
    CHECK(!taut_film_order_note(&problem, text, sizeof text), "a free corner");
    problem.corner_kinds[1] = TAUT_FILM_HELD;
    problem.has_corner[3] = 0;
    CHECK(!taut_film_order_note(&problem, text, sizeof text), "no corner");
    problem.has_corner[3] = 1;
    problem.ring = TAUT_FILM_RING_U;
    CHECK(!taut_film_order_note(&problem, text, sizeof text), "a ring");
    problem.ring = TAUT_FILM_OPEN;
    problem.corners[2][0] = 1e300;
    CHECK(!taut_film_order_note(&problem, text, sizeof text), "beyond the range");
    memset(problem.corners, 0, sizeof problem.corners);
    CHECK(!taut_film_order_note(&problem, text, sizeof text), "one point");
}

int main(void)
{
    random_seed(30);
    test_rings();
    test_saddles();
    test_others();
    return check_failures != 0;
}
