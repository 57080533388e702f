/* test_numeric.c -- the tensor-product solver when memory runs out. */
#include "check.h"
#include "fault.h"
#include "gram.h"

#include "numeric/modes.h"
#include "numeric/tensor/solver.h"

#include <string.h>

enum { DEGREE = 3, COUNT = 12, INNER = COUNT - 2, RHS = 3 };

typedef struct fixture {
    taut_band stiff[2], mass[2]; /* of mirrored knots, and of others */
    taut_tensor_solver *solver;
    double right[INNER * INNER * RHS];
} fixture;

static void release_solver(void *solver)
{
    taut_tensor_solver_free(solver);
}

static void release_modes(void *modes)
{
    taut_modes_free(modes);
}

static taut_status new_modes(const void *context, void **result, taut_error *error)
{
    const fixture *f = context;
    taut_modes *modes = *result;
    const taut_status status = taut_modes_new(&f->stiff[0], &f->mass[0], NULL, &modes);
    (void)error;
    *result = modes;
    return status;
}

static taut_status new_solver(const void *context, void **result, taut_error *error)
{
    const fixture *f = context;
    taut_tensor_solver *solver = *result;
    const taut_status status = taut_tensor_solver_new(&f->stiff[0], &f->mass[0], &f->stiff[1],
                                                      &f->mass[1], 1, 2, NULL, &solver);
    (void)error;
    *result = solver;
    return status;
}

static taut_status solve(const void *context, void **result, taut_error *error)
{
    const fixture *f = context;
    double x[INNER * INNER * RHS];
    taut_status status = TAUT_OK;
    (void)result;
    (void)error;
    memcpy(x, f->right, sizeof x);
    status = taut_tensor_solver_solve(f->solver, RHS, x);
    CHECK(status == TAUT_OK || memcmp(x, f->right, sizeof x) == 0, "x is untouched on failure");
    return status;
}

static taut_status refine(const void *context, void **result, taut_error *error)
{
    const fixture *f = context;
    double x[INNER * INNER * RHS];
    double before = -1;
    taut_status status = TAUT_OK;
    (void)result;
    (void)error;
    memcpy(x, f->right, sizeof x);
    status = taut_tensor_solver_refine(f->solver, RHS, f->right, x, &before);
    CHECK(status == TAUT_OK || memcmp(x, f->right, sizeof x) == 0, "x is untouched on failure");
    CHECK((status == TAUT_OK) == (before >= 0), "so is *before");
    return status;
}

int main(void)
{
    fixture f;
    memset(&f, 0, sizeof f);
    for (int i = 0; i < 2; i++) {
        double knots[COUNT + DEGREE + 1];
        gram_knots_make(i == 0 ? GRAM_UNIFORM : GRAM_RANDOM, DEGREE, COUNT, 7, knots);
        CHECK(gram_make(DEGREE, COUNT, knots, 1, COUNT - 2, &f.stiff[i], &f.mass[i]), "gram");
    }
    random_seed(20260111);
    for (int i = 0; i < INNER * INNER * RHS; i++) {
        f.right[i] = random_in(-1, 1);
    }
    CHECK(taut_tensor_solver_new(&f.stiff[0], &f.mass[0], &f.stiff[1], &f.mass[1], 1, 2, NULL,
                                 &f.solver) == TAUT_OK,
          "solver");
    const fault_call calls[] = {
        {"taut_modes_new", new_modes, release_modes, &f},
        {"taut_tensor_solver_new", new_solver, release_solver, &f},
        {"taut_tensor_solver_solve", solve, NULL, &f},
        {"taut_tensor_solver_refine", refine, NULL, &f},
    };
    for (size_t i = 0; i < sizeof calls / sizeof calls[0]; i++) {
        CHECK(fault_loop(&calls[i]) > 0, "%s takes memory", calls[i].name);
    }
    taut_tensor_solver_free(f.solver);
    for (int i = 0; i < 2; i++) {
        taut_band_clear(&f.stiff[i]);
        taut_band_clear(&f.mass[i]);
    }
    CHECK(fault_live() == 0, "%ld blocks left", fault_live());
    return check_failures != 0;
}
