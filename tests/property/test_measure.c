/* test_measure.c -- figures of random surfaces: two routes to one number, and what must not change
 * when a surface is moved, turned over or scaled. */
#include "check.h"
#include "shapes.h"

#include "numeric/quadrature.h"
#include "taut/measure.h"

#include <stdlib.h>
#include <string.h>

static taut_surface_measure measured(const taut_surface *surface)
{
    taut_surface_measure m;
    memset(&m, 0, sizeof m);
    CHECK(taut_measure_surface(surface, NULL, &m, NULL) == TAUT_OK, "measure");
    return m;
}

/* Every span cut in `pieces`, `order` Gauss nodes in each: parameters and weights. */
static int composite(const taut_basis *basis, int pieces, int order, double **t, double **w)
{
    const double *breaks = taut_basis_breaks(basis);
    const int spans = taut_basis_span_count(basis), count = spans * pieces * order;
    double nodes[16], weights[16];
    *t = malloc((size_t)count * sizeof(double));
    *w = malloc((size_t)count * sizeof(double));
    taut_gauss_rule(order, nodes, weights);
    for (int k = 0; k < count; k++) {
        const int span = k / (pieces * order), piece = k / order % pieces;
        const double h = (breaks[span + 1] - breaks[span]) / pieces;
        (*t)[k] = breaks[span] + h * (piece + 0.5 + nodes[k % order] / 2);
        (*w)[k] = h * weights[k % order] / 2;
    }
    return count;
}

/* Area, energies and int |H| by brute force from taut_surface_eval_grid and taut_forms_of. */
static void brute_force(const taut_surface *s, int pieces, int order, double sums[5],
                        double box[2][3])
{
    double *u, *wu, *v, *wv;
    const int nu = composite(taut_surface_u(s), pieces, order, &u, &wu);
    const int nv = composite(taut_surface_v(s), pieces, order, &v, &wv);
    double(*x)[6][3] = malloc((size_t)nv * sizeof *x);
    memset(sums, 0, 5 * sizeof(double));
    for (int c = 0; c < 3; c++) {
        box[0][c] = INFINITY;
        box[1][c] = -INFINITY;
    }
    for (int i = 0; i < nu; i++) {
        CHECK(taut_surface_eval_grid(s, 1, &u[i], nv, v, 2, 1, &x[0][0][0]) == TAUT_OK, "grid");
        for (int j = 0; j < nv; j++) {
            const double w = wu[i] * wv[j];
            taut_forms f;
            double bend = 0;
            taut_forms_of((const double(*)[3])x[j], &f);
            for (int c = 0; c < 3; c++) {
                bend +=
                    x[j][3][c] * x[j][3][c] + 2 * x[j][4][c] * x[j][4][c] + x[j][5][c] * x[j][5][c];
                box[0][c] = fmin(box[0][c], x[j][0][c]);
                box[1][c] = fmax(box[1][c], x[j][0][c]);
            }
            sums[0] += w * f.w;
            sums[1] += w * (f.e + f.g) / 2;
            sums[2] += w * bend;
            sums[3] += w * ((f.e - f.g) * (f.e - f.g) + 4 * f.f * f.f);
            sums[4] += f.regular ? w * fabs(f.mean) * f.w : 0;
        }
    }
    free(u);
    free(v);
    free(wu);
    free(wv);
    free(x);
}

/* Brute force is as good as its own change when its pieces are halved, and a few roundings of its
 * sum; on most surfaces that is 1e-10 and better. Not so for |H| with its kinks, of which each
 * piece has a share of either sign, about 1e-2 of the mean times the square of a piece's size. */
static void test_against_brute_force(void)
{
    int sharp = 0;
    for (int trial = 0; trial < 20; trial++) {
        taut_surface *s = shape_random(random_int(1, 5), random_int(1, 5), trial % 3 == 0);
        const taut_surface_measure m = measured(s);
        double half[5], sums[5], box[2][3];
        brute_force(s, 5, 8, half, box);
        brute_force(s, 10, 8, sums, box);
        half[3] = sqrt(half[3]) / (2 * half[1]);
        sums[3] = sqrt(sums[3]) / (2 * sums[1]);
        half[4] /= half[0];
        sums[4] /= sums[0];
        const double found[5] = {m.area, m.dirichlet_energy, m.bending_energy, m.isothermality,
                                 m.mean_abs_mean};
        for (int f = 0; f < 5; f++) {
            const double change = fabs(sums[f] - half[f]) / sums[f] * (f < 4 ? 1 : 20);
            const double kinks = f < 4 ? 0 : 1e-4;
            CHECK_NEAR(found[f], sums[f], (change + kinks + 2e-12) * sums[f], "trial %d, figure %d",
                       trial, f);
            CHECK(change < (f < 4 ? 1e-3 : 0.3), "trial %d, figure %d: brute force changed by %g",
                  trial, f, change);
            sharp += change < 1e-10;
        }
        CHECK(m.area <= m.dirichlet_energy * (1 + 1e-14), "A <= D, trial %d", trial);
        CHECK(m.area_error == 0, "trial %d: %g", trial, m.area_error);
        for (int c = 0; c < 3; c++) {
            CHECK(m.box[0][c] <= box[0][c] + 1e-15 && m.box[1][c] >= box[1][c] - 1e-15,
                  "trial %d: outside the box", trial);
            /* samples are at most 1/50 of a span apart, at extremes the slope is 0 or at an end */
            CHECK(m.box[0][c] > box[0][c] - 2e-2 && m.box[1][c] < box[1][c] + 2e-2,
                  "trial %d: box too large", trial);
        }
        taut_surface_free(s);
    }
    CHECK(sharp >= 40, "brute force was sharp for %d figures only", sharp);
}

static void check_same(const taut_surface_measure *a, const taut_surface_measure *b, double size,
                       double tolerance, const char *what)
{
    const double s2 = size * size;
    CHECK_NEAR(b->area / s2, a->area, tolerance * a->area, "%s", what);
    CHECK_NEAR(b->dirichlet_energy / s2, a->dirichlet_energy, tolerance * a->dirichlet_energy, "%s",
               what);
    CHECK_NEAR(b->bending_energy / s2, a->bending_energy, 10 * tolerance * a->bending_energy, "%s",
               what);
    CHECK_NEAR(b->isothermality, a->isothermality, tolerance, "%s", what);
    CHECK_NEAR(b->max_abs_mean * size, a->max_abs_mean, 1e3 * tolerance * a->max_abs_mean, "%s",
               what);
    /* |H| is integrated to 1e-6: rules may differ */
    CHECK_NEAR(b->mean_abs_mean * size, a->mean_abs_mean, 1e-6 * a->mean_abs_mean, "%s", what);
    CHECK_NEAR(b->max_laplacian / size, a->max_laplacian, 100 * tolerance * a->max_laplacian, "%s",
               what);
    CHECK_NEAR(b->max_f / s2, a->max_f, tolerance * (a->max_f + a->max_e_minus_g), "%s", what);
    CHECK(a->singular_points == b->singular_points, "%s", what);
}

static void check_same_edge(const taut_edge_measure *a, const taut_edge_measure *b, double size,
                            double tolerance, const char *what)
{
    CHECK_NEAR(b->length / size, a->length, tolerance * a->length, "%s", what);
    CHECK_NEAR(b->max_abs_normal_curvature * size, a->max_abs_normal_curvature,
               1e3 * tolerance * (1 + a->max_abs_normal_curvature), "%s", what);
    if (!isnan(a->max_angle_normal_binormal) || !isnan(b->max_angle_normal_binormal)) {
        /* a binormal is taken as soon as it has five digits */
        CHECK_NEAR(b->max_angle_normal_binormal, a->max_angle_normal_binormal, 1e-5, "%s", what);
    }
}

/* Rotation, translation and scale, by 300 decades; moved points are rounded, at an offset of ten
 * sizes to 1e-15 of it. */
static void test_moved(void)
{
    for (int trial = 0; trial < 16; trial++) {
        taut_surface *s = shape_random(random_int(2, 4), random_int(2, 4), trial % 2);
        const double size = random_log(1e-150, 1e150);
        double rotation[3][3], shift[3];
        taut_surface *t = NULL;
        shape_rotation(rotation);
        for (int c = 0; c < 3; c++) {
            shift[c] = random_in(-10, 10) * size;
        }
        t = shape_moved(s, size, (const double(*)[3])rotation, shift);
        const taut_surface_measure a = measured(s), b = measured(t);
        check_same(&a, &b, size, 1e-12, "moved");
        for (int edge = 0; edge < 4; edge++) {
            check_same_edge(&a.edges[edge], &b.edges[edge], size, 1e-12, "moved");
        }
        taut_surface_free(s);
        taut_surface_free(t);
    }
}

/* u and v change places, or u runs the other way. */
static void test_turned(void)
{
    static const int transposed_edge[4] = {2, 3, 0, 1}, reversed_edge[4] = {1, 0, 2, 3};
    for (int trial = 0; trial < 12; trial++) {
        taut_surface *s = shape_random(random_int(2, 4), random_int(2, 4), trial % 2);
        taut_surface *t = shape_transposed(s), *r = shape_reversed(s);
        const taut_surface_measure a = measured(s), b = measured(t), c = measured(r);
        check_same(&a, &b, 1, 1e-12, "transposed");
        check_same(&a, &c, 1, 1e-12, "reversed");
        for (int edge = 0; edge < 4; edge++) {
            check_same_edge(&a.edges[edge], &b.edges[transposed_edge[edge]], 1, 1e-12,
                            "transposed");
            check_same_edge(&a.edges[edge], &c.edges[reversed_edge[edge]], 1, 1e-12, "reversed");
        }
        taut_surface_free(s);
        taut_surface_free(t);
        taut_surface_free(r);
    }
}

/* Bit for bit the same for any number of threads. */
static void test_threads(void)
{
    const int threads[4] = {2, 3, 8, 64};
    for (int trial = 0; trial < 6; trial++) {
        taut_surface *s = trial == 0   ? shape_sphere(1)
                          : trial == 1 ? shape_torus(3, 1)
                                       : shape_random(3, 2, trial % 2);
        taut_surface_measure a, b;
        memset(&a, 0, sizeof a);
        CHECK(taut_measure_surface(s, NULL, &a, NULL) == TAUT_OK, "one");
        for (int k = 0; k < 4; k++) {
            const taut_measure_options options = {.threads = threads[k]};
            memset(&b, 0, sizeof b);
            CHECK(taut_measure_surface(s, &options, &b, NULL) == TAUT_OK, "many");
            CHECK(memcmp(&a, &b, sizeof a) == 0, "threads=%d", threads[k]);
        }
        taut_surface_free(s);
    }
}

/* Parameters over another range: the area stays, the Dirichlet energy goes with the ratio. */
static void test_ranges(void)
{
    for (int trial = 0; trial < 20; trial++) {
        const int k = random_int(-100, 100);
        const double points[16][3] = {{0, 0, 0},   {0, 1, 0.3},   {0, 2, 0.1}, {0, 3, 0},
                                      {1, 0, 0.2}, {1, 1.1, 0.4}, {1.2, 2, 0}, {1, 3, 1},
                                      {2, 0, 0},   {2, 1, 0},     {2, 2, 0.7}, {2.2, 3, 0},
                                      {3, 0, 0},   {3, 1, 0.5},   {3, 2, 0},   {3, 3, 0.1}};
        taut_surface *s =
            shape_surface(shape_bezier(3, 0, 1), shape_bezier(3, 0, 1), points[0], NULL);
        taut_surface *t = shape_surface(shape_bezier(3, 0, ldexp(1, k)),
                                        shape_bezier(3, 0, ldexp(1, k)), points[0], NULL);
        const taut_surface_measure a = measured(s), b = measured(t);
        CHECK_NEAR(b.area, a.area, 1e-13 * a.area, "k=%d", k);
        CHECK_NEAR(b.dirichlet_energy, a.dirichlet_energy, 1e-13 * a.dirichlet_energy, "k=%d", k);
        CHECK_NEAR(ldexp(b.bending_energy, 2 * k), a.bending_energy, 1e-13 * a.bending_energy,
                   "k=%d", k);
        CHECK_NEAR(ldexp(b.isothermality, k), a.isothermality, 1e-13, "k=%d", k);
        CHECK_NEAR(b.max_abs_mean, a.max_abs_mean, 1e-12, "k=%d", k);
        CHECK_NEAR(b.mean_abs_mean, a.mean_abs_mean, 1e-7, "k=%d", k);
        taut_surface_free(s);
        taut_surface_free(t);
    }
}

int main(void)
{
    random_seed(20260305);
    test_against_brute_force();
    test_moved();
    test_turned();
    test_threads();
    test_ranges();
    return check_failures != 0;
}
