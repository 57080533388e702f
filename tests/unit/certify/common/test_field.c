/* test_field.c -- Bernstein coefficients with errors, against sums in long double.
 *
 * Every coefficient must be within its own bound of the exact one; the bound must not be far above
 * what rounding can do, and must not be missing where rounding happens.
 */
#include "certify/common/field.h"

#include "bases.h"
#include "check.h"
#include "shapes.h"

#include "certify/common/quasi.h"

#include <math.h>
#include <string.h>

static double random_number(void)
{
    return random_in(-1, 1);
}

static taut_field random_field(taut_arena *arena, int p, int q)
{
    taut_field f = taut_field_new(arena, p, q);
    for (int k = 0; k < (p + 1) * (q + 1); k++) {
        f.a[k] = random_number() * ldexp(1, random_int(-10, 9));
    }
    return f;
}

static long double binomial(int n, int k)
{
    long double value = 1;
    for (int i = 1; i <= k; i++) {
        value = value * (n - k + i) / i;
    }
    return value;
}

/* The exact coefficient (k, l) of the product, to 2^-60 of the gross sum. */
static long double product_of(const taut_field *f, const taut_field *g, int k, int l)
{
    long double sum = 0;
    for (int i = 0; i <= f->p; i++) {
        for (int j = 0; j <= f->q; j++) {
            const int r = k - i, s = l - j;
            if (r >= 0 && r <= g->p && s >= 0 && s <= g->q) {
                sum += binomial(f->p, i) * binomial(g->p, r) / binomial(f->p + g->p, k) *
                       binomial(f->q, j) * binomial(g->q, s) / binomial(f->q + g->q, l) *
                       (long double)f->a[i * (f->q + 1) + j] *
                       (long double)g->a[r * (g->q + 1) + s];
            }
        }
    }
    return sum;
}

static void test_product(void)
{
    taut_arena *arena = taut_arena_new();
    int rounded = 0;
    for (int trial = 0; trial < 60; trial++) {
        const taut_field f = random_field(arena, random_int(0, 8), random_int(0, 8));
        const taut_field other =
            random_field(arena, random_int(0, 8), trial < 30 ? random_int(0, 8) : 0);
        const taut_field g = trial % 5 == 4 ? f : other; /* or a square */
        const taut_field h = taut_field_product(arena, &f, &g);
        CHECK(h.p == f.p + g.p && h.q == f.q + g.q, "degree %d %d", h.p, h.q);
        for (int k = 0; k < (h.p + 1) * (h.q + 1); k++) {
            const long double exact = product_of(&f, &g, k / (h.q + 1), k % (h.q + 1));
            const double apart = (double)fabsl(exact - (long double)h.a[k]);
            CHECK(apart <= h.e[k], "off by %g, bound %g", apart, h.e[k]);
            CHECK(h.e[k] <= 0x1p-40 * taut_field_largest(&f) * taut_field_largest(&g) + 1e-300,
                  "bound %g is idle", h.e[k]);
            rounded += apart > 0;
        }
    }
    CHECK(rounded > 100, "nothing was rounded");
    taut_arena_free(arena);
}

/* The same product with one bound for all its errors, which counts those of both factors. */
static void test_even_product(void)
{
    taut_arena *arena = taut_arena_new();
    for (int trial = 0; trial < 80; trial++) {
        const taut_field f = random_field(arena, random_int(0, 8), random_int(0, 9));
        const taut_field other = random_field(arena, random_int(0, 8), random_int(0, 9));
        const taut_field g = trial % 5 == 4 ? f : other;
        for (int k = 0; trial % 2 == 1 && k < (f.p + 1) * (f.q + 1); k++) {
            f.e[k] = trial % 4 == 1 ? 1e-3 * fabs(random_number()) : 0;
        }
        for (int k = 0; trial % 4 == 3 && k < (g.p + 1) * (g.q + 1); k++) {
            g.e[k] = 1e-3 * fabs(random_number());
        }
        const taut_field h = taut_field_product(arena, &f, &g);
        const taut_field even = taut_field_product_even(arena, &f, &g);
        const double size = taut_field_largest(&f) * taut_field_largest(&g);
        const double off = trial % 2 == 1 ? 2.1e-3 * size / 0.1 : 0x1p-40 * size;
        CHECK(even.p == h.p && even.q == h.q, "degree %d %d", even.p, even.q);
        for (int k = 0; k < (h.p + 1) * (h.q + 1); k++) {
            const long double exact = product_of(&f, &g, k / (h.q + 1), k % (h.q + 1));
            const double apart = (double)fabsl(exact - (long double)even.a[k]);
            CHECK(apart <= 0x1p-44 * size + 1e-300, "off by %g", apart);
            CHECK(even.e[k] >= 0.999999 * h.e[k], "bound %g, one by one %g", even.e[k], h.e[k]);
            CHECK(even.e[k] == even.e[0] && even.e[k] <= off + 1e-300, "bound %g is idle",
                  even.e[k]);
        }
    }
    taut_arena_free(arena);
}

/* What the coefficients' own errors make of a product: f +- e must stay inside. */
static void test_errors_travel(void)
{
    taut_arena *arena = taut_arena_new();
    for (int trial = 0; trial < 40; trial++) {
        taut_field f = random_field(arena, 3, 2), moved = taut_field_copy(arena, &f);
        const taut_field g = random_field(arena, 2, trial % 2 == 0 ? 3 : 1);
        taut_field h = taut_field_product(arena, &f, &g), there, low, high, low_moved, high_moved;
        for (int k = 0; k < 12; k++) {
            f.e[k] = 1e-3 * (0.1 + fabs(random_number()));
            moved.a[k] += (random_int(0, 1) == 0 ? 1 : -1) * (1 - 1e-9) * f.e[k];
        }
        h = taut_field_product(arena, &f, &g);
        there = taut_field_product(arena, &moved, &g);
        for (int k = 0; k < (h.p + 1) * (h.q + 1); k++) {
            CHECK(fabs(h.a[k] - there.a[k]) <= h.e[k], "product: %g, bound %g",
                  fabs(h.a[k] - there.a[k]), h.e[k]);
        }
        h = taut_field_product(arena, &g, &f);
        there = taut_field_product(arena, &g, &moved);
        for (int k = 0; k < (h.p + 1) * (h.q + 1); k++) {
            CHECK(fabs(h.a[k] - there.a[k]) <= h.e[k], "product the other way: %g, bound %g",
                  fabs(h.a[k] - there.a[k]), h.e[k]);
        }
        h = taut_field_product(arena, &f, &f);
        there = taut_field_product(arena, &moved, &moved);
        for (int k = 0; k < (h.p + 1) * (h.q + 1); k++) {
            CHECK(fabs(h.a[k] - there.a[k]) <= h.e[k], "square: %g, bound %g",
                  fabs(h.a[k] - there.a[k]), h.e[k]);
        }
        h = taut_field_du(arena, &f);
        there = taut_field_du(arena, &moved);
        for (int k = 0; k < (h.p + 1) * (h.q + 1); k++) {
            CHECK(fabs(h.a[k] - there.a[k]) <= h.e[k], "derivative along u");
        }
        h = taut_field_dv(arena, &f);
        there = taut_field_dv(arena, &moved);
        for (int k = 0; k < (h.p + 1) * (h.q + 1); k++) {
            CHECK(fabs(h.a[k] - there.a[k]) <= h.e[k], "derivative along v");
        }
        taut_field_halve(arena, &f, trial % 2, &low, &high);
        taut_field_halve(arena, &moved, trial % 2, &low_moved, &high_moved);
        for (int k = 0; k < 12; k++) {
            CHECK(fabs(low.a[k] - low_moved.a[k]) <= low.e[k], "low half");
            CHECK(fabs(high.a[k] - high_moved.a[k]) <= high.e[k], "high half");
        }
    }
    taut_arena_free(arena);
}

static void test_values(void)
{
    taut_arena *arena = taut_arena_new();
    for (int trial = 0; trial < 40; trial++) {
        const taut_field f = random_field(arena, 4, 3), g = random_field(arena, 2, 5);
        const taut_field sum = taut_field_combine(arena, 2, &f, -3, &g);
        const taut_field slope = taut_field_du(arena, &f), across = taut_field_dv(arena, &f);
        const double u = 0.5 + 0.5 * random_number(), v = 0.5 + 0.5 * random_number(), h = 1e-6;
        const double size = taut_field_largest(&f) + taut_field_largest(&g);
        taut_field low, high, edge;
        CHECK(fabs(taut_field_value(&sum, u, v) - 2 * taut_field_value(&f, u, v) +
                   3 * taut_field_value(&g, u, v)) <= 1e-13 * size,
              "sum");
        CHECK(fabs(taut_field_value(&slope, u, v) -
                   (taut_field_value(&f, u + h, v) - taut_field_value(&f, u - h, v)) / (2 * h)) <=
                  1e-6 * size,
              "slope along u");
        CHECK(fabs(taut_field_value(&across, u, v) -
                   (taut_field_value(&f, u, v + h) - taut_field_value(&f, u, v - h)) / (2 * h)) <=
                  1e-6 * size,
              "slope along v");
        taut_field_halve(arena, &f, 0, &low, &high);
        CHECK(fabs(taut_field_value(&low, u, v) - taut_field_value(&f, u / 2, v)) <= 1e-13 * size,
              "low half along u");
        CHECK(fabs(taut_field_value(&high, u, v) - taut_field_value(&f, 0.5 + u / 2, v)) <=
                  1e-13 * size,
              "high half along u");
        taut_field_halve(arena, &f, 1, &low, &high);
        CHECK(fabs(taut_field_value(&high, u, v) - taut_field_value(&f, u, 0.5 + v / 2)) <=
                  1e-13 * size,
              "high half along v");
        for (int e = 0; e < 4; e++) {
            edge = taut_field_edge(arena, &f, e);
            CHECK(fabs(taut_field_value(&edge, u, 0) -
                       taut_field_value(&f, e < 2 ? e : u, e < 2 ? u : e - 2)) <= 1e-13 * size,
                  "edge %d", e);
        }
        CHECK(taut_field_low(&f) <= taut_field_value(&f, u, v) + 1e-13 * size &&
                  taut_field_value(&f, u, v) <= taut_field_high(&f) + 1e-13 * size,
              "range");
    }
    taut_arena_free(arena);
}

/* Spans of a rational spline surface agree with its evaluation. */
static void test_pieces(void)
{
    static const double knots_u[] = {0, 0, 0, 0, 0.3, 0.3, 0.7, 1, 1, 1, 1};
    static const double knots_v[] = {-1, -1, -1, 0.25, 2, 2, 2};
    const taut_basis_spec specs[2] = {
        {.type = "bspline", .degree = 3, .knot_count = 11, .knots = knots_u},
        {.type = "bspline", .degree = 2, .knot_count = 7, .knots = knots_v}};
    const double origin[3] = {0.5, -1, 2};
    taut_basis *u = NULL, *v = NULL;
    taut_surface *surface = NULL;
    taut_arena *arena = taut_arena_new();
    double points[7 * 4 * 3], weights[7 * 4];
    CHECK(taut_basis_new(&specs[0], 7, &u, NULL) == TAUT_OK, "u");
    CHECK(taut_basis_new(&specs[1], 4, &v, NULL) == TAUT_OK, "v");
    for (int k = 0; k < 7 * 4; k++) {
        weights[k] = exp(2 * random_number());
        for (int c = 0; c < 3; c++) {
            points[3 * k + c] = 5 * random_number();
        }
    }
    CHECK(taut_surface_new("", u, v, points, weights, &surface, NULL) == TAUT_OK, "surface");
    for (int i = 0; i < taut_basis_span_count(u); i++) {
        for (int j = 0; j < taut_basis_span_count(v); j++) {
            taut_field x[4];
            double widths[2], place[3];
            CHECK(taut_field_of_surface(arena, surface, i, j, origin, 3, x, widths), "piece");
            for (int k = 0; k < 9; k++) {
                const int row = k / 3;
                const double s = 0.5 * row, t = 0.5 * (k % 3);
                const double lo = taut_basis_breaks(u)[i], low = taut_basis_breaks(v)[j];
                const double w = taut_field_value(&x[3], s, t);
                CHECK(taut_surface_eval(surface, lo + s * widths[0], low + t * widths[1], 0,
                                        place) == TAUT_OK,
                      "place");
                for (int c = 0; c < 3; c++) {
                    const double found = 8 * taut_field_value(&x[c], s, t) / w + origin[c];
                    CHECK(fabs(found - place[c]) <= 1e-13 * 10, "piece %d %d: %g", i, j,
                          found - place[c]);
                }
            }
        }
    }
    taut_surface_free(surface);
    taut_basis_free(u);
    taut_basis_free(v);
    taut_arena_free(arena);
}

/* The largest that the errors of a field come to at a place. */
static double error_at(taut_arena *arena, const taut_field *f, double s, double t)
{
    taut_field errors = taut_field_copy(arena, f);
    memcpy(errors.a, f->e, (size_t)(f->p + 1) * (size_t)(f->q + 1) * sizeof *f->e);
    return taut_field_value(&errors, s, t);
}

/* Places of a span: values and derivatives of the first two orders against evaluation, which is
 * known to 1e-14 of the largest function times the size of the net, 5. Returns the largest error
 * told of the value. */
static double compare_span(taut_arena *arena, const taut_surface *surface, int i, int j,
                           const taut_field x[4], const double widths[2])
{
    const double lo = taut_basis_breaks(taut_surface_u(surface))[i];
    const double low = taut_basis_breaks(taut_surface_v(surface))[j];
    double most = 0;

    for (int k = 0; k < 25; k++) {
        const double s = 0.02 + 0.24 * (k % 5), t = 0.02 + 0.24 * (k / 5); /* between knots */
        double place[6][3]; /* x, x_u, x_v, x_uu, x_uv, x_vv */
        CHECK(taut_surface_eval(surface, lo + s * widths[0], low + t * widths[1], 2, place[0]) ==
                  TAUT_OK,
              "place");
        for (int c = 0; c < 3; c++) {
            const taut_field du = taut_field_du(arena, &x[c]), dv = taut_field_dv(arena, &x[c]);
            const taut_field both[6] = {x[c],
                                        du,
                                        dv,
                                        taut_field_du(arena, &du),
                                        taut_field_dv(arena, &du),
                                        taut_field_dv(arena, &dv)};
            const double unit[6] = {1,
                                    widths[0],
                                    widths[1],
                                    widths[0] * widths[0],
                                    widths[0] * widths[1],
                                    widths[1] * widths[1]};
            for (int r = 0; r < 6; r++) {
                const double found = taut_field_value(&both[r], s, t) / unit[r];
                const double told = error_at(arena, &both[r], s, t) / unit[r];
                const double known = 2e-12 / unit[r];
                CHECK(fabs(found - place[r][c]) <= told + known,
                      "%s, derivative %d: off %g, told %g",
                      taut_basis_type(taut_surface_u(surface)), r, found - place[r][c], told);
                most = r == 0 ? fmax(most, told) : most;
            }
        }
    }
    return most;
}

/* Edges, taken of the outermost rows, against evaluation. */
static void compare_edges(taut_arena *arena, const taut_surface *surface)
{
    const taut_basis *u = taut_surface_u(surface), *v = taut_surface_v(surface);
    const double origin[3] = {0, 0, 0};

    for (int edge = 0; edge < 4; edge++) {
        const taut_basis *along = edge < 2 ? v : u, *across = edge < 2 ? u : v;
        const double held = edge % 2 == 0 ? taut_basis_lo(across) : taut_basis_hi(across);
        for (int k = 0; k < 3 * taut_basis_span_count(along); k++) {
            const double *breaks = taut_basis_breaks(along) + k / 3, s = 0.1 + 0.4 * (k % 3);
            const double t = breaks[0] + s * (breaks[1] - breaks[0]);
            double place[3];
            taut_field x[4];
            CHECK(taut_field_of_edge(arena, surface, edge, k / 3, origin, 0, x), "edge");
            CHECK(taut_surface_eval(surface, edge < 2 ? held : t, edge < 2 ? t : held, 0, place) ==
                      TAUT_OK,
                  "place");
            for (int c = 0; c < 3; c++) {
                const double off = fabs(taut_field_value(&x[c], s, 0) - place[c]);
                CHECK(off <= error_at(arena, &x[c], s, 0) + 2e-12, "edge %d is off %g", edge, off);
            }
        }
    }
}

/* Spans of surfaces on c- and h- bases, and mixed with others, agree with their evaluation as far as
 * they tell, and that is far. */
static void test_quasi(void)
{
    static const char *const types[] = {"c-bezier", "c-bspline", "h-bezier", "h-bspline"};
    for (int trial = 0; trial < 60; trial++) {
        taut_arena *arena = taut_arena_new();
        const char *type = types[trial % 4];
        const double wide = random_log(1e-3, type[0] == 'c' ? 3.14159 : 3.9);
        const double start = trial % 5 == 0 ? 20 * random_number() : 0, origin[3] = {0, 0, 0};
        taut_basis_spec spec = spec_of_spans(type, wide, random_int(1, 3), start);
        taut_basis *u = NULL;
        spec.has_range = start != 0;
        CHECK(taut_basis_new(&spec, 0, &u, NULL) == TAUT_OK, "%s", type);
        taut_basis *v = NULL;
        if (trial % 3 == 0) {
            v = shape_bspline(random_int(1, 3), 5);
        } else {
            CHECK(taut_basis_new(&spec, 0, &v, NULL) == TAUT_OK, "%s", type);
        }
        double points[3 * 64];
        for (int k = 0; k < 3 * 64; k++) {
            points[k] = 5 * random_number();
        }
        taut_surface *surface =
            trial % 2 == 0 ? shape_surface(u, v, points, NULL) : shape_surface(v, u, points, NULL);
        compare_edges(arena, surface);
        const taut_basis *bu = taut_surface_u(surface), *bv = taut_surface_v(surface);
        for (int k = 0; k < taut_basis_span_count(bu) * taut_basis_span_count(bv); k++) {
            const int i = k / taut_basis_span_count(bv), j = k % taut_basis_span_count(bv);
            taut_field x[4];
            double widths[2];
            CHECK(taut_field_of_surface(arena, surface, i, j, origin, 0, x, widths), "piece");
            const double told = compare_span(arena, surface, i, j, x, widths);
            const double rounded = 1 + fabs(start) / wide;
            CHECK(told <= 2e-11 * rounded, "%s, spans of %g: errors of %g", type, wide, told);
        }
        taut_surface_free(surface);
        taut_arena_free(arena);
    }
}

/* Wide spans are refused, and so are bases that are none of these. */
static void test_quasi_refused(void)
{
    taut_quasi_span out;
    const taut_basis_spec wide = {.type = "h-bezier", .beta = 4.5}, other = {.type = "ce-bezier"};
    taut_basis *u = shape_basis(&wide), *v = shape_basis(&other);
    CHECK(!taut_certify_quasi(u, 0, &out) && taut_certify_degree(u) == -1, "a wide span");
    CHECK(!taut_certify_quasi(v, 0, &out), "another basis");
    taut_basis_free(u);
    taut_basis_free(v);
}

/* What is not there or leaves the range proves nothing. */
static void test_nothing_is_proved(void)
{
    taut_arena *arena = taut_arena_new();
    taut_field f = taut_field_new(arena, 1, 1), g, huge = taut_field_constant(arena, 1e200);
    const taut_field absent = {0, 0, NULL, NULL};
    f.a[2] = NAN;
    CHECK(isnan(taut_field_low(&f)) && isnan(taut_field_high(&f)), "a NaN was swallowed");
    f.a[2] = 0;
    f.e[0] = NAN;
    CHECK(isnan(taut_field_low(&f)) && isnan(taut_field_largest(&f)), "a NaN error was swallowed");
    g = taut_field_product(arena, &absent, &huge);
    CHECK(g.a == NULL && isnan(taut_field_low(&g)), "a product of nothing");
    g = taut_field_product_even(arena, &absent, &huge);
    CHECK(g.a == NULL && isnan(taut_field_low(&g)), "an even product of nothing");
    g = taut_field_product(arena, &huge, &huge);
    CHECK(!isfinite(taut_field_high(&g)) && !(taut_field_low(&g) > 0), "an overflow proves %g",
          taut_field_low(&g));
    g = taut_field_new(arena, TAUT_FIELD_DEGREE + 1, 0);
    CHECK(g.a == NULL, "the degree is not bounded");
    taut_arena_free(arena);
}

int main(void)
{
    random_seed(1);
    test_product();
    test_even_product();
    test_errors_travel();
    test_values();
    test_pieces();
    test_quasi();
    test_quasi_refused();
    test_nothing_is_proved();
    return check_failures != 0;
}
