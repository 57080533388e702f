#include "construct/plateau/newton_step.h"

#include "construct/plateau/hessian_band.h"
#include "core/arena.h"
#include "core/fail.h"
#include "core/memory.h"
#include "core/pulse.h"
#include "core/vec3.h"
#include "geometry/nurbs/gram.h"
#include "numeric/tensor/solver.h"

#include <assert.h>
#include <string.h>

enum {
    PRODUCTS = 30,    /* of a step, as a rule */
    REPORTED = 16,    /* products from one report to the next */
    ROUNDS_MAX = 400, /* products of one solve: a step cut short is still one downhill */
};

struct taut_newton_step {
    taut_area_functional *functional;
    const taut_mask *mask;
    taut_pulse own, *pulse; /* the functional's, or its own, which the functional tells meanwhile */
    const char *what;       /* the pulse's word, which is another meanwhile */
    const double *directions;
    int parts;
    size_t size; /* of a vector of unknowns */
    int products;
    taut_arena *arena;
    taut_area_hessian *hessian; /* or NULL: the rest is for conjugate gradients */
    int is_assembled;
    taut_gram u, v; /* of the hull */
    taut_tensor_solver *tensor;
    double *hull;
    double *residual, *smooth, *search, *image; /* unknowns */
    double *move, *force;                       /* nets */
    const taut_conditions *conditions;          /* or NULL */
    taut_held *held;                            /* or NULL */
};

int taut_newton_step_parts(const taut_newton_step *newton)
{
    return newton->parts;
}

double taut_newton_step_floor(const taut_newton_step *newton)
{
    const double by_factors = 1e-10;  /* below it H alone is as definite, to rounding */
    const double by_gradients = 1e-5; /* below it moves within the surface take too many products */
    return newton->hessian != NULL ? by_factors : newton->parts == 1 ? 0 : by_gradients;
}

const char *taut_newton_step_method(const taut_newton_step *newton)
{
    return newton->hessian != NULL ? "factors" : "conjugate-gradients";
}

int taut_newton_step_products(const taut_newton_step *newton)
{
    return newton->products;
}

double taut_newton_step_cost(const taut_newton_step *newton)
{
    const double look = taut_area_functional_cost(newton->functional);
    return newton->hessian != NULL
               ? taut_area_hessian_factor_cost(newton->functional, newton->mask) +
                     taut_area_hessian_assembly_cost(newton->functional) + 8 * look
               : 2 * PRODUCTS * look;
}

int taut_newton_step_is_stopped(const taut_newton_step *newton)
{
    return taut_pulse_is_stopped(newton->pulse);
}

taut_status taut_newton_step_report(taut_newton_step *newton)
{
    return taut_pulse_report(newton->pulse) ? TAUT_INTERRUPTED : TAUT_OK;
}

void taut_newton_step_free(taut_newton_step *newton)
{
    if (newton != NULL) {
        newton->pulse->what = newton->what;
        if (newton->pulse == &newton->own) {
            newton->functional->pulse = NULL;
        }
        taut_area_hessian_free(newton->hessian);
        taut_gram_clear(&newton->u);
        taut_gram_clear(&newton->v);
        taut_tensor_solver_free(newton->tensor);
        taut_arena_free(newton->arena);
        taut_free(newton);
    }
}

static taut_status make_preconditioner(const taut_dirichlet_form *form, double aspect,
                                       taut_newton_step *newton)
{
    const taut_gram *u = &newton->u, *v = &newton->v;
    const taut_crew crew = {1, newton->pulse};
    const taut_status status =
        taut_dirichlet_form_select(form, newton->mask, &newton->u, &newton->v);

    return status == TAUT_OK
               ? taut_tensor_solver_new(&u->stiffness, &u->mass, &v->stiffness, &v->mass, aspect,
                                        1 / aspect, &crew, &newton->tensor)
               : status;
}

/* Factors where they pay, else what conjugate gradients need. */
static taut_status make_solver(const taut_dirichlet_form *form, double aspect,
                               taut_newton_step *newton)
{
    const taut_mask *mask = newton->mask;
    const size_t hull = (size_t)mask->rows * (size_t)mask->columns;
    taut_status status = TAUT_OK;

    if (newton->directions == NULL && taut_area_hessian_pays(newton->functional, mask)) {
        return taut_area_hessian_new(newton->functional, mask, &newton->hessian);
    }
    status = make_preconditioner(form, aspect, newton);
    if (status != TAUT_OK) {
        return status == TAUT_NO_MEMORY || status == TAUT_INTERRUPTED ? status : TAUT_NOT_CONVERGED;
    }
    newton->hull = taut_arena_take(newton->arena, hull, (size_t)newton->parts * sizeof(double));
    newton->residual = taut_arena_take(newton->arena, newton->size, sizeof(double));
    newton->smooth = taut_arena_take(newton->arena, newton->size, sizeof(double));
    newton->search = taut_arena_take(newton->arena, newton->size, sizeof(double));
    newton->image = taut_arena_take(newton->arena, newton->size, sizeof(double));
    return taut_arena_status(newton->arena);
}

taut_status taut_newton_step_new(taut_area_functional *functional, const taut_dirichlet_form *form,
                                 const taut_mask *mask, const double *directions, double aspect,
                                 const taut_monitor *monitor, taut_newton_step **newton)
{
    const size_t count = (size_t)mask->nu * (size_t)mask->nv;
    taut_newton_step *made = taut_alloc_zero(1, sizeof *made);
    taut_status status = TAUT_OK;

    if (made == NULL) {
        return TAUT_NO_MEMORY;
    }
    made->functional = functional;
    made->own = (taut_pulse){.monitor = monitor, .done = taut_none};
    made->pulse = functional->pulse != NULL ? functional->pulse : &made->own;
    made->what = made->pulse->what;
    made->pulse->what = "least area";
    functional->pulse = made->pulse;
    made->mask = mask;
    made->directions = directions;
    made->parts = directions != NULL ? 1 : 3;
    made->size = (size_t)made->parts * count;
    made->arena = taut_arena_new();
    made->move = taut_arena_take(made->arena, count, 3 * sizeof(double));
    made->force = taut_arena_take(made->arena, count, 3 * sizeof(double));
    status = made->force != NULL ? make_solver(form, aspect, made) : TAUT_NO_MEMORY;
    if (status != TAUT_OK) {
        taut_newton_step_free(made);
        return status;
    }
    *newton = made;
    return TAUT_OK;
}

void taut_newton_step_reduce(const taut_newton_step *newton, const double *net, double *z)
{
    const size_t count = (size_t)newton->mask->nu * (size_t)newton->mask->nv;
    const unsigned char *known = newton->mask->known;

    if (newton->directions == NULL) {
        memcpy(z, net, 3 * count * sizeof(double));
        taut_mask_reduce(newton->mask, z);
    }
    for (size_t i = 0; newton->directions != NULL && i < count; i++) {
        z[i] = known[i] ? 0 : taut_dot(newton->directions + 3 * i, net + 3 * i);
    }
    if (newton->held != NULL) {
        taut_held_project(newton->held, z);
    }
}

void taut_newton_step_expand(const taut_newton_step *newton, const double *z, double *net)
{
    const size_t count = (size_t)newton->mask->nu * (size_t)newton->mask->nv;

    for (size_t i = 0; i < 3 * count; i++) {
        net[i] = newton->directions == NULL ? z[i] : z[i / 3] * newton->directions[i];
    }
    taut_mask_follow(newton->mask, net);
}

void taut_newton_step_renew(taut_newton_step *newton)
{
    newton->is_assembled = 0;
}

double taut_newton_step_dot(const taut_newton_step *newton, const double *a, const double *b)
{
    double sum = 0;
    for (size_t i = 0; i < newton->size; i++) {
        sum += a[i] * b[i];
    }
    return sum;
}

void taut_newton_step_product(taut_newton_step *newton, double theta, const double *z,
                              double *product)
{
    taut_newton_step_expand(newton, z, newton->move);
    taut_area_functional_product(newton->functional, theta, newton->move, newton->force);
    taut_newton_step_reduce(newton, newton->force, product);
    newton->products++;
}

/* smooth = M^-1 residual, by the hull and back. */
static taut_status precondition(taut_newton_step *newton)
{
    const taut_mask *p = newton->mask;
    const size_t parts = (size_t)newton->parts, nv = (size_t)p->nv;
    const unsigned char *known = p->hull_known;
    double *hull = newton->hull;
    taut_status status = TAUT_OK;

    for (int a = 0; a < p->rows; a++) {
        const double *row = newton->residual + (size_t)p->row[a] * nv * parts;
        for (int b = 0; b < p->columns; b++, hull += parts) {
            memcpy(hull, row + (size_t)p->column[b] * parts, parts * sizeof(double));
        }
    }
    status = taut_tensor_solver_solve(newton->tensor, newton->parts, newton->hull);
    hull = newton->hull;
    memset(newton->smooth, 0, newton->size * sizeof(double));
    for (int a = 0; a < p->rows; a++) {
        double *row = newton->smooth + (size_t)p->row[a] * nv * parts;
        for (int b = 0; b < p->columns; b++, hull += parts) {
            if (!*known++) {
                memcpy(row + (size_t)p->column[b] * parts, hull, parts * sizeof(double));
            }
        }
    }
    return status;
}

/* The same among the moves that are allowed. */
static taut_status smoothen_residual(taut_newton_step *newton)
{
    const taut_status status = precondition(newton);
    if (newton->held != NULL) {
        taut_held_correct(newton->held, newton->smooth);
    }
    return status;
}

/* The images of the rows that hold, by the preconditioner, which stays. */
static taut_status precondition_rows(taut_newton_step *newton)
{
    taut_held *held = newton->held;
    taut_status status = TAUT_OK;

    for (int r = 0; status == TAUT_OK && r < held->count; r++) {
        memcpy(newton->residual, taut_held_row(held, r), newton->size * sizeof(double));
        status = precondition(newton);
        memcpy(taut_held_image(held, r), newton->smooth, newton->size * sizeof(double));
    }
    if (status != TAUT_OK) {
        return status;
    }
    return taut_held_factor(held) ? TAUT_OK : TAUT_NOT_CONVERGED;
}

taut_status taut_newton_step_hold(taut_newton_step *newton, const taut_conditions *conditions,
                                  taut_held *held)
{
    newton->conditions = conditions;
    newton->held = held;
    return newton->hessian == NULL ? precondition_rows(newton) : TAUT_OK;
}

/* The images of the rows that hold, by the factors at hand. */
static taut_status solve_rows(taut_newton_step *newton)
{
    taut_held *held = newton->held;

    for (int r = 0; r < held->count; r++) {
        memcpy(taut_held_image(held, r), taut_held_row(held, r), newton->size * sizeof(double));
        taut_area_hessian_solve(newton->hessian, taut_held_image(held, r));
    }
    return taut_held_factor(held) ? TAUT_OK : TAUT_NO_SOLUTION;
}

/* z = B^-1 z by the factors, among the moves that are allowed. */
static void solve_by_factors(taut_newton_step *newton, double *z)
{
    taut_area_hessian_solve(newton->hessian, z);
    if (newton->held != NULL) {
        taut_held_correct(newton->held, z);
    }
}

/* One step of conjugate gradients: *rho = residual . smooth on entry and return. */
static taut_status iterate(taut_newton_step *newton, double theta, double *z, double *rho)
{
    const double before = *rho;
    double curvature = 0;
    taut_status status = TAUT_OK;

    taut_newton_step_product(newton, theta, newton->search, newton->image);
    curvature = taut_newton_step_dot(newton, newton->search, newton->image);
    if (!(curvature > 0)) {
        return TAUT_NO_SOLUTION;
    }
    for (size_t i = 0; i < newton->size; i++) {
        z[i] += before / curvature * newton->search[i];
        newton->residual[i] -= before / curvature * newton->image[i];
    }
    status = smoothen_residual(newton);
    *rho = taut_newton_step_dot(newton, newton->residual, newton->smooth);
    for (size_t i = 0; i < newton->size; i++) {
        newton->search[i] = newton->smooth[i] + *rho / before * newton->search[i];
    }
    return status;
}

static taut_status conjugate_gradients(taut_newton_step *newton, double theta, double forcing,
                                       const double *b, double *z, double *model)
{
    double rho = 0, enough = 0;
    taut_status status = TAUT_OK;

    memset(z, 0, newton->size * sizeof(double));
    memcpy(newton->residual, b, newton->size * sizeof(double));
    status = smoothen_residual(newton);
    memcpy(newton->search, newton->smooth, newton->size * sizeof(double));
    rho = taut_newton_step_dot(newton, newton->residual, newton->smooth);
    enough = forcing * forcing * rho;
    for (int k = 0; status == TAUT_OK && k < ROUNDS_MAX && rho > enough; k++) {
        status = iterate(newton, theta, z, &rho);
        if (k % REPORTED == REPORTED - 1 && status == TAUT_OK) {
            status = taut_newton_step_report(newton);
        }
    }
    *model = 0;
    for (size_t i = 0; i < newton->size; i++) {
        *model += 0.5 * z[i] * (b[i] + newton->residual[i]);
    }
    return status;
}

taut_status taut_newton_step_solve(taut_newton_step *newton, double theta, double forcing,
                                   const double *b, double *z, double *model)
{
    taut_area_functional *functional = newton->functional;
    taut_status status = TAUT_OK;

    if (newton->hessian == NULL) {
        return conjugate_gradients(newton, theta, forcing, b, z, model);
    }
    if (!newton->is_assembled) {
        taut_area_hessian_assemble(newton->hessian, functional);
        if (newton->held != NULL) {
            taut_area_hessian_hold(newton->hessian, newton->conditions);
        }
        newton->is_assembled = 1;
        functional->work += taut_area_hessian_assembly_cost(functional);
    }
    status = taut_area_hessian_factor(newton->hessian, theta);
    functional->work += taut_area_hessian_factor_cost(functional, newton->mask);
    newton->products++;
    if (status == TAUT_OK && newton->held != NULL) {
        status = solve_rows(newton);
    }
    if (status != TAUT_OK) {
        return status;
    }
    memcpy(z, b, newton->size * sizeof(double));
    solve_by_factors(newton, z);
    *model = 0.5 * taut_newton_step_dot(newton, z, b);
    return TAUT_OK;
}

int taut_newton_step_has_factors(const taut_newton_step *newton)
{
    return newton->hessian != NULL;
}

void taut_newton_step_again(taut_newton_step *newton, double *z)
{
    assert(newton->hessian != NULL);
    solve_by_factors(newton, z);
}
