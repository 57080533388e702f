/* test_cone.c -- the largest b.x under bounds of lengths, against closed forms and the conditions of the top. */
#include "check.h"

#include "numeric/cone.h"

#include <math.h>
#include <string.h>

static const double mu = 1e-9;

static void climb(taut_cone *cone, const double *b, double weight, double *x)
{
    const taut_status status = taut_cone_climb(cone, b, weight, 80, x, NULL);
    CHECK(status == TAUT_OK, "status %d", (int)status);
}

/* One ball: x = b / |b|. */
static void test_ball(void)
{
    const double b[3] = {2, -3, 6};
    double x[3] = {0, 0, 0};
    taut_arena *arena = taut_arena_new();
    taut_cone cone;

    CHECK(taut_cone_new(3, 0, 0, 1, arena, &cone) == TAUT_OK, "memory");
    double *rows = taut_cone_add(&cone, -1);
    rows[0] = rows[4] = rows[8] = 1;
    CHECK(taut_cone_add(&cone, -1) == NULL, "there is room for one");
    climb(&cone, b, mu, x);
    for (int k = 0; k < 3; k++) {
        CHECK_NEAR(x[k], b[k] / 7, 2e-9, "x[%d]", k);
    }
    taut_arena_free(arena);
}

/* b x + sum b_k y_k under x^2 + y_k^2 <= 1: the y_k go to one end together, and the most is hypot(b, sum |b_k|). */
static void test_blocks(void)
{
    enum { BLOCKS = 5 };
    const double b[1 + BLOCKS] = {3, 1, -2, 0.5, 4, -1};
    double x[1 + BLOCKS] = {0}, most = 0;
    taut_arena *arena = taut_arena_new();
    taut_cone cone;

    CHECK(taut_cone_new(1, 1, BLOCKS, BLOCKS, arena, &cone) == TAUT_OK, "memory");
    for (int k = 0; k < BLOCKS; k++) {
        double *rows = taut_cone_add(&cone, k);
        rows[0] = 1;     /* of x, in the first row */
        rows[2 + 1] = 1; /* of y_k, in the second */
    }
    climb(&cone, b, mu, x);
    for (int k = 0; k <= BLOCKS; k++) {
        most += b[k] * x[k];
    }
    CHECK_NEAR(most, sqrt(3 * 3 + 8.5 * 8.5), 1e-8, "the most");
    for (int k = 0; k < BLOCKS; k++) {
        CHECK_NEAR(fabs(x[1 + k]), 8.5 / sqrt(3 * 3 + 8.5 * 8.5), 1e-8, "y_%d", k);
        CHECK(x[1 + k] * b[1 + k] > 0, "y_%d has the other sign", k);
    }
    taut_arena_free(arena);
}

/* Random places of three blocks, with so many numbers that the matrix goes by tiles where they are many. */
typedef struct heap {
    taut_arena *arena;
    taut_cone cone;
    int shared, own, blocks, n;
    double b[200], x[200];
} heap;

static void heap_new(int shared, int own, int blocks, int places, heap *h)
{
    *h = (heap){.arena = taut_arena_new(),
                .shared = shared,
                .own = own,
                .blocks = blocks,
                .n = shared + own * blocks};
    CHECK(taut_cone_new(shared, own, blocks, 2 * places, h->arena, &h->cone) == TAUT_OK, "memory");
    for (int k = 0; k < places; k++) {
        const int block = k % (blocks + 1) - 1;
        double *rows = taut_cone_add(&h->cone, block);
        for (int i = 0; i < 3 * (shared + own); i++) {
            rows[i] = block < 0 && i % (shared + own) >= shared ? 0 : random_in(-1, 1);
        }
    }
    for (int i = 0; i < h->n; i++) {
        h->b[i] = random_in(-1, 1);
    }
}

/* At the top b / mu is the sum of 2 A'y / (1 - |y|^2), and all lengths are below 1; where that is so b.x lies within mu
 * times the number of places of b.z for every z inside, as b.(z - x) <= sum of 2 mu y.(w - y) / (1 - |y|^2) <= 2 mu / (1 + |y|). */
static void expect_top(const heap *h, double weight)
{
    double slope[200], size = 0, off = 0;

    memcpy(slope, h->b, sizeof slope);
    for (int k = 0; k < h->cone.count; k++) {
        const int seen = h->shared + h->own, block = h->cone.block[k];
        const double *rows = h->cone.rows + 3 * (size_t)(seen * k);
        double y[3] = {0, 0, 0};
        taut_cone_apply(&h->cone, rows, block, h->x, y);
        const double left = 1 - y[0] * y[0] - y[1] * y[1] - y[2] * y[2];
        CHECK(left > 0, "place %d is %g outside", k, -left);
        for (int i = 0; i < (block < 0 ? h->shared : seen); i++) {
            const int at = i < h->shared ? i : i + block * h->own;
            for (int r = 0; r < 3; r++) {
                slope[at] -= 2 * weight * rows[r * seen + i] * y[r] / left;
            }
        }
    }
    for (int i = 0; i < h->n; i++) {
        size = fmax(size, fabs(h->b[i]));
        off = fmax(off, fabs(slope[i]));
    }
    CHECK(off <= 1e-3 * size, "%d + %d x %d numbers: the slope is %g of %g", h->shared, h->own,
          h->blocks, off, size);
}

static void test_top(void)
{
    static const int sizes[][4] = {{2, 0, 0, 5}, {4, 3, 2, 40}, {10, 12, 3, 120}, {20, 30, 4, 300}};

    for (int trial = 0; trial < random_trials(24); trial++) {
        const int *size = sizes[trial % 4];
        double most = 0, less = 0;
        heap h;
        heap_new(size[0], size[1], size[2], size[3], &h);
        climb(&h.cone, h.b, 1e-2, h.x);
        expect_top(&h, 1e-2);
        for (int i = 0; i < h.n; i++) {
            less += h.b[i] * h.x[i];
        }
        climb(&h.cone, h.b, 1e-4, h.x);
        expect_top(&h, 1e-4);
        for (int i = 0; i < h.n; i++) {
            most += h.b[i] * h.x[i];
        }
        CHECK(most > less && most - less <= 1e-2 * size[3], "%g after %g of %d places", most, less,
              size[3]);
        taut_arena_free(h.arena);
    }
}

/* Places that come later: x made shorter lies inside, and the most is less. */
static void test_added(void)
{
    heap h;
    double before = 0, after = 0;

    heap_new(4, 3, 2, 30, &h);
    climb(&h.cone, h.b, 1e-5, h.x);
    for (int i = 0; i < h.n; i++) {
        before += h.b[i] * h.x[i];
    }
    double *rows = taut_cone_add(&h.cone, -1);
    double length = 0;
    for (int i = 0; i < h.shared; i++) {
        rows[i] = h.b[i];
        length += rows[i] * h.x[i];
    }
    for (int i = 0; i < h.shared; i++) {
        rows[i] *= 1.25 / length; /* the length is 1.25 there */
    }
    for (int i = 0; i < h.n; i++) {
        h.x[i] *= 0.79;
    }
    climb(&h.cone, h.b, 1e-5, h.x);
    expect_top(&h, 1e-5);
    for (int i = 0; i < h.n; i++) {
        after += h.b[i] * h.x[i];
    }
    CHECK(after < before, "%g, before %g", after, before);
    taut_arena_free(h.arena);
}

/* Nothing bounds the second number. */
static void test_unbounded(void)
{
    const double b[2] = {1, 1};
    double x[2] = {0, 0};
    taut_arena *arena = taut_arena_new();
    taut_cone cone;

    CHECK(taut_cone_new(2, 0, 0, 1, arena, &cone) == TAUT_OK, "memory");
    taut_cone_add(&cone, -1)[0] = 1;
    CHECK(taut_cone_climb(&cone, b, 1, 20, x, NULL) == TAUT_NO_SOLUTION, "%g, %g", x[0], x[1]);
    CHECK(fabs(x[0]) < 1 && isfinite(x[1]), "%g, %g", x[0], x[1]);
    taut_arena_free(arena);
}

int main(void)
{
    random_seed(20261124);
    test_ball();
    test_blocks();
    test_top();
    test_added();
    test_unbounded();
    return check_failures != 0;
}
