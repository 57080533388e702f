/* test_elements.c -- elements of cells: the second derivative of the area by differences of its gradient, and the same bytes for
 * any number of threads. */
#include "check.h"

#include "construct/plateau/elements.h"
#include "core/memory.h"

#include <math.h>
#include <string.h>

enum { NETS = 2, NU = 14, NV = 11, NUMBERS = 3 * NU * NV };

static double net[NETS][NUMBERS], gradient[NUMBERS], step[NUMBERS], image[NUMBERS], after[NUMBERS],
    before[NUMBERS];

static void random_net(double *x)
{
    for (int i = 0; i < NU; i++) {
        for (int j = 0; j < NV; j++, x += 3) {
            x[0] = i + random_in(-0.2, 0.2);
            x[1] = j + random_in(-0.2, 0.2);
            x[2] = random_in(-0.5, 0.5);
        }
    }
}

/* image += the element of cell (a, b) times the step: H d = s n (n . d) + t n x d. */
static void add_product(const taut_area_functional *area, int a, int b, const double *element)
{
    const size_t wide = (size_t)taut_area_wide(area);
    const int local_v = area->v.local, local = area->u.local * local_v;
    const int fu = area->u.first[a * area->u.nodes], fv = area->v.first[b * area->v.nodes];

    for (int p = 0; p < local; p++, element += TAUT_AREA_BLOCK * wide) {
        const int at_p = 3 * ((fu + p / local_v) * NV + fv + p % local_v);
        for (int q = 0; q <= p; q++) {
            const int at_q = 3 * ((fu + q / local_v) * NV + fv + q % local_v);
            double m[TAUT_AREA_BLOCK];
            for (size_t c = 0; c < TAUT_AREA_BLOCK; c++) {
                m[c] = element[c * wide + (size_t)q];
            }
            const double h[3][3] = {{m[0], m[1] - m[8], m[3] + m[7]},
                                    {m[1] + m[8], m[2], m[4] - m[6]},
                                    {m[3] - m[7], m[4] + m[6], m[5]}};
            for (int i = 0; i < 3; i++) {
                for (int j = 0; j < 3; j++) {
                    image[at_p + i] += h[i][j] * step[at_q + j];
                    image[at_q + j] += p != q ? h[i][j] * step[at_p + i] : 0;
                }
            }
        }
    }
}

static void test_differences(taut_area_functional *area)
{
    const taut_area_functional *seen = area;
    const double h = 1e-6;
    double moved[NUMBERS], largest = 0, size = 0;
    taut_area_elements *elements = NULL;

    for (int i = 0; i < NUMBERS; i++) {
        step[i] = random_in(-1, 1);
    }
    memset(image, 0, sizeof image);
    CHECK(taut_area_elements_new(1, &seen, 3, &elements) == TAUT_OK, "elements");
    taut_area_functional_gradient(area, net[0], gradient);
    taut_area_elements_begin(elements, &seen, NULL, NULL);
    for (int a = 0; a < area->u.count / area->u.nodes; a++) {
        for (int b = 0; b < area->v.count / area->v.nodes; b++) {
            add_product(area, a, b, taut_area_elements_next(elements));
        }
    }
    for (int sign = -1; sign <= 1; sign += 2) {
        for (int i = 0; i < NUMBERS; i++) {
            moved[i] = net[0][i] + sign * h * step[i];
        }
        taut_area_functional_gradient(area, moved, sign > 0 ? after : before);
    }
    for (int i = 0; i < NUMBERS; i++) {
        largest = fmax(largest, fabs((after[i] - before[i]) / (2 * h) - image[i]));
        size = fmax(size, fabs(image[i]));
    }
    CHECK(largest < 1e-8 * size, "differences: %.3g of %.3g", largest, size);
    taut_area_elements_free(elements);
}

static void add_one(const void *context, int which, int line, int k, double *element)
{
    (void)context;
    element[0] += which + 0.001 * line + 0.01 * k;
}

static void test_threads(taut_area_functional *const areas[NETS])
{
    static const int threads[3] = {1, 2, 5};
    const taut_area_functional *seen[NETS] = {areas[0], areas[1]};
    taut_area_elements *elements[3];

    for (int k = 0; k < NETS; k++) {
        taut_area_functional_gradient(areas[k], net[k], gradient);
    }
    for (int t = 0; t < 3; t++) {
        CHECK(taut_area_elements_new(NETS, seen, threads[t], &elements[t]) == TAUT_OK, "elements");
    }
    for (int round = 0; round < 2; round++) { /* one may be begun again */
        for (int t = 0; t < 3; t++) {
            taut_area_elements_begin(elements[t], seen, add_one, NULL);
        }
        for (int k = 0; k < NETS; k++) {
            const taut_area_functional *area = areas[k];
            const int cells = area->u.count / area->u.nodes * (area->v.count / area->v.nodes);
            const size_t row = (size_t)taut_area_wide(area) * TAUT_AREA_BLOCK * sizeof(double);
            for (int cell = 0; cell < cells; cell++) {
                const double *first = taut_area_elements_next(elements[0]);
                for (int t = 1; t < 3; t++) {
                    const double *other = taut_area_elements_next(elements[t]);
                    for (size_t p = 0; p < (size_t)(area->u.local * area->v.local); p++) {
                        CHECK(memcmp(first + p * (row / sizeof(double)),
                                     other + p * (row / sizeof(double)),
                                     (p + 1) * sizeof(double)) == 0,
                              "net %d, cell %d, row %zu by %d threads", k, cell, p, threads[t]);
                    }
                }
            }
        }
    }
    for (int t = 0; t < 3; t++) {
        taut_area_elements_free(elements[t]);
    }
}

int main(void)
{
    const taut_basis_spec cubic = {.type = "bspline", .degree = 3, .count = NU};
    const taut_basis_spec fourth = {.type = "bspline", .degree = 4, .count = NV};
    taut_area_functional *areas[NETS] = {NULL, NULL};
    taut_basis *u = NULL, *v = NULL;

    random_seed(3);
    CHECK(taut_basis_new(&cubic, NU, &u, NULL) == TAUT_OK &&
              taut_basis_new(&fourth, NV, &v, NULL) == TAUT_OK,
          "bases");
    for (int k = 0; k < NETS; k++) {
        random_net(net[k]);
        CHECK(taut_area_functional_new(u, v, NULL, k, &areas[k]) == TAUT_OK, "area");
    }
    test_differences(areas[0]);
    test_threads(areas);
    for (int k = 0; k < NETS; k++) {
        taut_area_functional_free(areas[k]);
    }
    taut_basis_free(u);
    taut_basis_free(v);
    return check_failures != 0;
}
