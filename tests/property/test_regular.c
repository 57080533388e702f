/* test_regular.c -- the claim `regular` against a search of its own: random patches of which most
 * are singular somewhere inside, under weights c^i d^j that change nothing but the parameters, and
 * patches made on affine and projective images of the examples. It never holds where a sine at or
 * below the limit is found, and its bound is one.
 */
#include "asymptotic.h"
#include "certificates.h"
#include "check.h"

#include "certify/common/regular.h"
#include "core/memory.h"
#include "core/vec3.h"

#include <stdlib.h>
#include <string.h>

enum { GRID = 61, MOST = 40 };

/* The surface's homogeneous net, evaluated by sums of its own. */
typedef struct net {
    int p, q;
    double c[MOST][MOST][4];
} net;

static void fill_net(const taut_surface *surface, net *n)
{
    const double *const points = taut_surface_points(surface);
    const double *const weights = taut_surface_weights(surface);
    n->p = taut_basis_count(taut_surface_u(surface)) - 1;
    n->q = taut_basis_count(taut_surface_v(surface)) - 1;
    for (int i = 0; i <= n->p; i++) {
        for (int j = 0; j <= n->q; j++) {
            const int at = i * (n->q + 1) + j;
            n->c[i][j][3] = weights != NULL ? weights[at] : 1;
            for (int k = 0; k < 3; k++) {
                n->c[i][j][k] = n->c[i][j][3] * (points[3 * at + k] - points[k]);
            }
        }
    }
}

/* Bernstein functions and their derivatives by powers. */
static void fill_functions(int n, double t, double *b, double *slope)
{
    double binomial = 1;
    for (int i = 0; i <= n; i++) {
        const double low = pow(t, i), high = pow(1 - t, n - i);
        b[i] = binomial * low * high;
        slope[i] = binomial * ((i > 0 ? i * pow(t, i - 1) * high : 0) -
                               (i < n ? (n - i) * low * pow(1 - t, n - i - 1) : 0));
        binomial = binomial * (n - i) / (i + 1);
    }
}

static double sine_at(const net *n, double u, double v)
{
    double b[4][MOST], x[3][4] = {{0}}, a[2][3], normal[3];
    fill_functions(n->p, u, b[0], b[1]);
    fill_functions(n->q, v, b[2], b[3]);
    for (int i = 0; i <= n->p; i++) {
        for (int j = 0; j <= n->q; j++) {
            for (int k = 0; k < 4; k++) {
                x[0][k] += b[0][i] * b[2][j] * n->c[i][j][k];
                x[1][k] += b[1][i] * b[2][j] * n->c[i][j][k];
                x[2][k] += b[0][i] * b[3][j] * n->c[i][j][k];
            }
        }
    }
    for (int d = 0; d < 2; d++) {
        for (int k = 0; k < 3; k++) {
            a[d][k] = x[0][3] * x[d + 1][k] - x[d + 1][3] * x[0][k];
        }
    }
    taut_cross(a[0], a[1], normal);
    return taut_norm(normal) / (taut_norm(a[0]) * taut_norm(a[1]));
}

/* From a place down: steps in random directions, shorter after ten that were in vain. */
static double descend(const net *n, double u, double v, double value)
{
    double step = 1.0 / GRID;
    for (int failed = 0; step > 1e-12 && value > 1e-9;) {
        const double angle = random_in(0, 6.283185307179586), length = step * random_in(0.1, 1);
        const double x = fmin(fmax(u + length * cos(angle), 0), 1);
        const double y = fmin(fmax(v + length * sin(angle), 0), 1);
        const double sine = sine_at(n, x, y);
        if (sine < value) {
            value = sine;
            u = x;
            v = y;
            failed = 0;
        } else if (++failed == 10) {
            step *= 0.5;
            failed = 0;
        }
    }
    return value;
}

/* The places of the grid are even in s, t / (1 - t) = c^-1 s / (1 - s): where weights are c^i. */
static double place(double c, int k)
{
    const double s = (double)k / (GRID - 1);
    return s / (s + c * (1 - s));
}

/* The least sine of a grid whose `lows` lowest local minima are followed down. */
static double search(const net *n, double c, double d, int lows)
{
    static double sines[GRID][GRID];
    double least = 1;
    for (int i = 0; i < GRID; i++) {
        for (int j = 0; j < GRID; j++) {
            sines[i][j] = sine_at(n, place(c, i), place(d, j));
        }
    }
    for (int found = 0; found < lows; found++) {
        int best[2] = {-1, -1};
        for (int i = 0; i < GRID; i++) {
            for (int j = 0; j < GRID; j++) {
                int low = sines[i][j] < 2;
                for (int k = -1; k <= 1 && low; k++) {
                    for (int l = -1; l <= 1; l++) {
                        const int a = i + k, b = j + l;
                        low = low && (a < 0 || b < 0 || a >= GRID || b >= GRID ||
                                      fmod(sines[a][b], 4) >= fmod(sines[i][j], 4));
                    }
                }
                if (low && (best[0] < 0 || sines[i][j] < sines[best[0]][best[1]])) {
                    best[0] = i;
                    best[1] = j;
                }
            }
        }
        if (best[0] < 0) {
            break;
        }
        least =
            fmin(least, descend(n, place(c, best[0]), place(d, best[1]), sines[best[0]][best[1]]));
        sines[best[0]][best[1]] += 4;
    }
    return least;
}

typedef struct count {
    int holds, fails, open;
} count;

/* What the claim says is so. */
static void check_regular(const taut_surface *surface, double c, double d, int lows, count *all,
                          const char *what)
{
    static net n;
    taut_regular found;
    double least = 0;
    CHECK(taut_certify_regular(surface, NULL, &found) == TAUT_OK, "%s", what);
    fill_net(surface, &n);
    least = search(&n, c, d, lows);
    all->holds += found.holds == TAUT_TRUE;
    all->fails += found.holds == TAUT_FALSE;
    all->open += found.holds == TAUT_UNDECIDED;
    if (found.holds == TAUT_TRUE) {
        CHECK(least > TAUT_REGULAR_LEAST, "%s: %g, but proved above %g", what, least, found.bound);
        CHECK(found.bound <= least * (1 + 1e-9), "%s: %g is below the bound %g", what, least,
              found.bound);
        CHECK(found.bound > TAUT_REGULAR_LEAST && found.bound <= found.sine, "%s: bound %g of %g",
              what, found.bound, found.sine);
        CHECK(found.sine <= 1.01 * least, "%s: smallest sine %g, there is %g", what, found.sine,
              least);
    } else if (found.holds == TAUT_FALSE) {
        CHECK(found.sine <= TAUT_REGULAR_LEAST, "%s: false with %g", what, found.sine);
        CHECK(sine_at(&n, found.at[0], found.at[1]) < 1e-4, "%s: no small sine at %g %g", what,
              found.at[0], found.at[1]);
    }
}

/* A patch of bidegree (7, 7) like asymptotic-low with inner points anywhere: edges and the rows
 * beside them of a saddle. */
static taut_surface *random_patch(double deviation, double c, double d, int rational)
{
    enum { N = 8 };
    const taut_basis_spec spec = {.type = "bezier", .degree = N - 1};
    double points[N][N][3], weights[N][N];
    taut_basis *basis = NULL;
    taut_surface *surface = NULL;
    CHECK(taut_basis_new(&spec, 0, &basis, NULL) == TAUT_OK, "basis");
    for (int i = 0; i < N; i++) {
        for (int j = 0; j < N; j++) {
            const int inside = i > 1 && j > 1 && i < N - 2 && j < N - 2;
            const double x = i / (N - 1.0), y = j / (N - 1.0);
            points[i][j][0] = x;
            points[i][j][1] = y;
            points[i][j][2] = (x - 0.5) * (y - 0.5);
            for (int k = 0; inside && k < 3; k++) {
                points[i][j][k] += deviation * (random_in(-1, 1) + random_in(-1, 1));
            }
            weights[i][j] = pow(c, i) * pow(d, j) * (rational ? random_log(0.5, 2) : 1);
        }
    }
    CHECK(taut_surface_new("", basis, basis, &points[0][0][0], &weights[0][0], &surface, NULL) ==
              TAUT_OK,
          "surface");
    taut_basis_free(basis);
    return surface;
}

static void test_random_insides(int trials, int lows)
{
    static const double factors[5][2] = {{1, 1}, {30, 30}, {200, 200}, {1000, 1000}, {1000, 1}};
    count all = {0, 0, 0};
    for (int trial = 0; trial < trials; trial++) {
        const double deviation = random_log(0.05, 8);
        const double c = factors[trial % 5][0], d = factors[trial % 5][1];
        taut_surface *surface = random_patch(deviation, c, d, trial % 3 == 0);
        char what[64];
        (void)snprintf(what, sizeof what, "patch %d, inside moved by %.3g", trial, deviation);
        check_regular(surface, c, d, lows, &all, what);
        taut_surface_free(surface);
    }
    check_say("inside: %d hold, %d are false, %d undecided\n", all.holds, all.fails, all.open);
    CHECK(all.holds >= trials / 10 && all.fails >= trials / 4 && all.open <= trials / 50,
          "%d hold, %d fail, %d open", all.holds, all.fails, all.open);
}

/* The curves of a made model in the order of the edges, as a problem. */
static taut_asymptotic_problem curves_of(const taut_model *model)
{
    taut_asymptotic_problem problem;
    memset(&problem, 0, sizeof problem);
    problem.given = TAUT_ASYMPTOTIC_CURVES;
    for (int k = 0; k < taut_model_curve_count(model); k++) {
        const taut_curve *const curve = taut_model_curve(model, k);
        for (int e = 0; e < 4; e++) {
            if (strcmp(taut_curve_name(curve), taut_asymptotic_edge_name(e)) == 0) {
                problem.curves[e] = curve;
            }
        }
    }
    return problem;
}

/* Weights times f[0]^i along u and f[1]^j along v, alike at the corners: the same curves. */
static void move_parameters(taut_asymptotic_problem *problem, const double f[2])
{
    for (int e = 0; e < 4; e++) {
        const taut_curve *const curve = problem->curves[e];
        const int n = taut_basis_count(taut_curve_t(curve)) - 1;
        double w[TAUT_ASYMPTOTIC_DEGREE_MAX + 1];
        for (int j = 0; j <= n; j++) {
            w[j] = taut_curve_weights(curve)[j] * pow(f[e % 2], j) *
                   (e >= 2 ? pow(f[1 - e % 2], n) : 1);
        }
        problem->curves[e] =
            asymptotic_curve(taut_curve_name(curve), n, taut_curve_points(curve), w);
        taut_curve_free((taut_curve *)(uintptr_t)curve);
    }
}

/* A random affine map, of which one in two squeezes, and a projective part that keeps the points
 * (within some 2 of the origin) in front. */
static projective random_map(void)
{
    projective map = {.t = {0, 0, 0}};
    const double squeeze = random_in(0, 1) < 0.5 ? random_log(0.05, 1) : 1;
    for (int k = 0; k < 3; k++) {
        for (int l = 0; l < 3; l++) {
            map.a[k][l] = (random_in(-1, 1) + random_in(-1, 1)) * (k == 2 ? squeeze : 1);
        }
        map.c[k] = random_in(-0.2, 0.2);
    }
    return map;
}

static void test_images(int trials, int lows)
{
    const taut_asymptotic_problem from[4] = {
        asymptotic_example(1, NULL), asymptotic_example(1, "-+-+"), asymptotic_example(2, NULL),
        asymptotic_example(5, NULL)};
    taut_model *sources[4];
    count all = {0, 0, 0};
    int made = 0;
    for (int k = 0; k < 4; k++) {
        sources[k] = asymptotic_make(&from[k], "source");
    }
    for (int trial = 0; trial < trials; trial++) {
        const taut_asymptotic_problem source = curves_of(sources[trial % 4]);
        const projective map = random_map();
        const double f[2] = {trial % 3 == 0 ? random_log(1, 30) : 1,
                             trial % 3 == 0 ? random_log(1, 30) : 1};
        taut_asymptotic_problem problem = projective_image(&source, &map);
        taut_model *model = NULL;
        char what[32];
        (void)snprintf(what, sizeof what, "image %d", trial);
        move_parameters(&problem, f);
        problem.surface = trial % 5 == 0 ? TAUT_BIDEGREE_5N_MINUS_7 : TAUT_BIDEGREE_N_PLUS_3;
        if (taut_asymptotic_make(&problem, NULL, &model, NULL) == TAUT_OK) {
            made++;
            check_regular(taut_model_surface(model, 0), 1, 1, lows, &all, what);
            taut_model_free(model);
        }
        asymptotic_free_curves(&problem);
    }
    for (int k = 0; k < 4; k++) {
        taut_model_free(sources[k]);
    }
    check_say("images: of %d made %d hold, %d are false, %d undecided\n", made, all.holds,
              all.fails, all.open);
    CHECK(made >= trials / 8 && all.fails >= made / 25 && all.open <= 2 + made / 10,
          "of %d made %d fail, %d open", made, all.fails, all.open);
}

int main(void)
{
    random_seed(20261122);
    test_random_insides(random_trials(40), 6);
    test_images(random_trials(40), 6);
    return check_failures != 0;
}
