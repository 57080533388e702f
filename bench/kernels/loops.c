/* loops.c -- every loop of src/numeric/kernel on data that fits the second cache, once for each instruction set.
 *
 * Compiled against the kernel.h of the tree that is measured, into one module with that tree's kernels: tools/bench_kernels.sh
 * does so for several trees, and compare.c loads them side by side. TAUT_LANES is a constant today; -DLANES_OF_KERNEL says that
 * the tree has them in the table. */
#include "numeric/kernel/kernel.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#ifdef LANES_OF_KERNEL
#define LANES ((size_t)kernel->lanes)
typedef long long exponent_type;
#else
#define LANES ((size_t)TAUT_LANES)
typedef int64_t exponent_type;
#endif

enum {
    N = 96,
    WIDTH = 3,
    RIGHT_SIDES = 3,
    DEPTH = 192,
    COUNT = 4096,
    LANES_MAX = 32,
    SIZE = 1 << 16
};

static double *numbers(size_t count, double lo, double hi)
{
    double *x = aligned_alloc(64, count * sizeof *x);
    uint64_t state = 88172645463325252u;
    for (size_t i = 0; x != NULL && i < count; i++) {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        x[i] = lo + (hi - lo) * (double)(state >> 11) * 0x1p-53;
    }
    return x;
}

typedef struct data {
    double *a, *b, *c, *d, *k, *m, *factor, *shift, *sums;
    double *fresh; /* what `c`, which loops change, begins with */
    exponent_type exponent[LANES_MAX];
} data;

/* What one run of a loop does; how many numbers (multiply-adds of tile and bands) it handles is its weight. */
static void tile(const taut_kernel *kernel, data *x)
{
    kernel->tile(DEPTH, x->a, x->b, x->c, TAUT_TILE_COLUMNS_MAX);
}

static void pack(const taut_kernel *kernel, data *x)
{
    kernel->pack(DEPTH, x->a, TAUT_TILE_COLUMNS_MAX, x->b);
}

static void band_factor(const taut_kernel *kernel, data *x)
{
    double negative[LANES_MAX] = {0};
    kernel->band_factor(0, N, WIDTH, x->k, x->m, 1.0, x->shift, 1e-300, x->factor, negative);
}

static void band_substitute(const taut_kernel *kernel, data *x)
{
    kernel->band_substitute(N, WIDTH, RIGHT_SIDES, x->factor + WIDTH * (WIDTH + 1) * LANES, x->c);
}

static void band_pencil(const taut_kernel *kernel, data *x)
{
    kernel->band_pencil(N, WIDTH, x->k, x->m, x->shift, x->a, x->b, x->d, x->sums);
}

static void lane_dot(const taut_kernel *kernel, data *x)
{
    kernel->lane_dot(N, x->a, x->b, x->sums, x->sums + LANES_MAX);
}

static void lane_product(const taut_kernel *kernel, data *x)
{
    kernel->lane_product(N, LANES, x->a, x->sums, x->exponent);
}

static void dot(const taut_kernel *kernel, data *x)
{
    x->sums[0] += kernel->dot(COUNT, x->a, x->b);
}

static void diagonals_multiply(const taut_kernel *kernel, data *x)
{
    kernel->diagonals_multiply(COUNT / 4, WIDTH, x->a, x->b, x->c);
}

static void add_scaled(const taut_kernel *kernel, data *x)
{
    kernel->add_scaled(COUNT, 1e-9, x->a, x->c);
}

static void add_products(const taut_kernel *kernel, data *x)
{
    kernel->add_products(COUNT, x->a, x->b, x->c);
}

static void add_scaled_exactly(const taut_kernel *kernel, data *x)
{
    kernel->add_scaled_exactly(COUNT, 1e-9, x->a, x->b, x->c, x->d);
}

static void add_products_exactly(const taut_kernel *kernel, data *x)
{
    kernel->add_products_exactly(COUNT, x->a, x->b, x->c, x->d);
}

static const struct {
    const char *name;
    void (*run)(const taut_kernel *kernel, data *x);
} loops[] = {
    {"tile", tile},
    {"pack", pack},
    {"band_factor", band_factor},
    {"band_substitute", band_substitute},
    {"band_pencil", band_pencil},
    {"lane_dot", lane_dot},
    {"lane_product", lane_product},
    {"dot", dot},
    {"diagonals_multiply", diagonals_multiply},
    {"add_scaled", add_scaled},
    {"add_products", add_products},
    {"add_scaled_exactly", add_scaled_exactly},
    {"add_products_exactly", add_products_exactly},
};

/* The name of loop `index`, NULL after the last. */
const char *bench_name(size_t index)
{
    return index < sizeof loops / sizeof *loops ? loops[index].name : NULL;
}

static double seconds(void)
{
    struct timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* Processor seconds that `repeats` runs of loop `index` take by the set of this name, each of its units (a tile of its own shape,
 * lanes of its own number) divided out; below 0 where the processor lacks the set. */
double bench_run(const char *set, size_t index, int repeats)
{
    static data x;
    const taut_kernel *kernel = taut_kernel_find(set);
    if (kernel == NULL) {
        return -1.0;
    }
    if (x.a == NULL) {
        x = (data){.a = numbers(SIZE, 1, 2),
                   .b = numbers(SIZE, 0.5, 1),
                   .c = numbers(SIZE, -1, 1),
                   .d = numbers(SIZE, 0, 1e-17),
                   .k = numbers(SIZE, 0, 0.1),
                   .m = numbers(SIZE, 0, 0.1),
                   .factor = calloc(SIZE, sizeof(double)),
                   .shift = numbers(LANES_MAX, 1, 2),
                   .sums = numbers(SIZE, 1, 2),
                   .fresh = numbers(SIZE, -1, 1)};
        for (size_t i = 0; i < SIZE; i += WIDTH + 1) {
            x.k[i] += 2; /* so that every pivot is positive */
        }
    }
    memcpy(
        x.c, x.fresh,
        SIZE *
            sizeof *x
                .c); /* or what is solved in place again and again would end below the normal numbers */
    loops[index].run(kernel, &x);
    const double begin = seconds();
    for (int r = 0; r < repeats; r++) {
        loops[index].run(kernel, &x);
    }
    const double took = seconds() - begin;
    const double units = index == 0   ? (double)kernel->tile_rows * kernel->tile_columns
                         : index == 1 ? (double)kernel->tile_columns
                         : index < 7  ? (double)LANES
                                      : 1.0;
    return took / (repeats * units);
}
