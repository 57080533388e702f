#include "construct/dirichlet/through.h"

#include "core/fail.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { PASSES = 2 }; /* the second for what rounding left of the first */
/* Conditions whose pivot is below this share of their own are combinations of those before, and
 * then hold to this, in units of the net, or contradict them. */
static const double dependent = 1e-11, contradicts = 1e-10;

typedef struct work {
    taut_dirichlet_system *system; /* or NULL */
    double aspect;
    const taut_mask *mask;
    const taut_conditions *all;
    double *right, *step;   /* nets */
    double *schur, *factor; /* [count][count]; the factor of those that are kept, row by row */
    double *defect, *part;  /* [count][3] */
    int *kept, kept_count;  /* independent ones, in the order of the problem */
} work;

static int take_arrays(work *w, taut_arena *arena)
{
    const size_t count = (size_t)w->all->count;
    const size_t size = 3 * (size_t)w->mask->nu * (size_t)w->mask->nv;

    w->right = taut_arena_take(arena, size, sizeof(double));
    w->step = taut_arena_take(arena, size, sizeof(double));
    w->schur = taut_arena_take(arena, count * count, sizeof(double));
    w->factor = taut_arena_take(arena, count * count, sizeof(double));
    w->defect = taut_arena_take(arena, 3 * count, sizeof(double));
    w->part = taut_arena_take(arena, 3 * count, sizeof(double));
    w->kept = taut_arena_take(arena, count, sizeof(int));
    return taut_arena_status(arena) == TAUT_OK;
}

static void clear_net(const work *w, double *net)
{
    memset(net, 0, 3 * (size_t)w->mask->nu * (size_t)w->mask->nv * sizeof(double));
}

/* step = A^-1 right at the unknown points, 0 at the others; right is brought to about 1 for it. */
static taut_status solve_right(work *w, taut_error *error)
{
    const size_t size = 3 * (size_t)w->mask->nu * (size_t)w->mask->nv;
    double largest = 0;

    taut_mask_clear_known(w->mask, w->right);
    clear_net(w, w->step);
    for (size_t i = 0; i < size; i++) {
        largest = fmax(largest, fabs(w->right[i]));
    }
    if (!(largest > 0)) {
        return TAUT_OK;
    }
    const int power = ilogb(largest);
    for (size_t i = 0; i < size; i++) {
        w->right[i] = ldexp(w->right[i], -power);
    }
    const taut_status status =
        taut_dirichlet_system_solve_right(w->system, w->aspect, w->right, w->step, error);
    for (size_t i = 0; i < size; i++) {
        w->step[i] = ldexp(w->step[i], power);
    }
    return status;
}

/* S, three columns a solve. */
static taut_status fill_schur(work *w, taut_error *error)
{
    const int count = w->all->count;
    taut_status status = TAUT_OK;

    for (int from = 0; from < count && status == TAUT_OK && w->system != NULL; from += 3) {
        const int most = count - from < 3 ? count - from : 3;
        clear_net(w, w->right);
        for (int c = 0; c < most; c++) {
            taut_condition_add(w->all, from + c, 1, w->right, c);
        }
        status = solve_right(w, error);
        for (int k = 0; k < count; k++) {
            for (int c = 0; c < most; c++) {
                w->schur[(size_t)k * (size_t)count + (size_t)(from + c)] =
                    taut_condition_sum(w->all, k, w->step, c);
            }
        }
    }
    return status;
}

/* Row `row` of the factor for condition k: 0 where it is a combination of those that are kept. */
static int append_row(work *w, int k)
{
    const size_t count = (size_t)w->all->count;
    double *row = w->factor + (size_t)w->kept_count * count;
    const double own = w->schur[(size_t)k * count + (size_t)k];
    double rest = own;

    for (int i = 0; i < w->kept_count; i++) {
        const double *other = w->factor + (size_t)i * count;
        double sum = w->schur[(size_t)k * count + (size_t)w->kept[i]];
        for (int j = 0; j < i; j++) {
            sum -= row[j] * other[j];
        }
        row[i] = sum / other[i];
        rest -= row[i] * row[i];
    }
    if (!(rest > dependent * own)) {
        return 0;
    }
    row[w->kept_count] = sqrt(rest);
    w->kept[w->kept_count++] = k;
    return 1;
}

/* part = the multipliers of the conditions that are kept, for their defects. */
static void solve_factor(work *w)
{
    const size_t count = (size_t)w->all->count;

    memset(w->part, 0, 3 * count * sizeof(double));
    for (int c = 0; c < 3; c++) {
        for (int i = 0; i < w->kept_count; i++) {
            const double *row = w->factor + (size_t)i * count;
            double sum = w->defect[3 * w->kept[i] + c];
            for (int j = 0; j < i; j++) {
                sum -= row[j] * w->part[3 * w->kept[j] + c];
            }
            w->part[3 * w->kept[i] + c] = sum / row[i];
        }
        for (int i = w->kept_count - 1; i >= 0; i--) {
            double sum = w->part[3 * w->kept[i] + c];
            for (int j = i + 1; j < w->kept_count; j++) {
                sum -= w->factor[(size_t)j * count + (size_t)i] * w->part[3 * w->kept[j] + c];
            }
            w->part[3 * w->kept[i] + c] = sum / w->factor[(size_t)i * count + (size_t)i];
        }
    }
}

static void find_defects(work *w, const double *net)
{
    for (int k = 0; k < w->all->count; k++) {
        for (int c = 0; c < 3; c++) {
            w->defect[3 * k + c] = w->all->at[k].point[c] - taut_condition_sum(w->all, k, net, c);
        }
    }
}

static double defect_of(const work *w, int k)
{
    const double *d = w->defect + 3 * k;
    return fmax(fabs(d[0]), fmax(fabs(d[1]), fabs(d[2])));
}

static taut_status refuse(const work *w, int k, taut_error *error)
{
    char where[64];
    snprintf(where, sizeof where, "/through/%d", k);
    return taut_fail(error, TAUT_NO_SOLUTION, "through", where, defect_of(w, k), 0,
                     "the known points, and the points to pass through before this one, put the "
                     "surface elsewhere there: move the point, or leave it out");
}

static taut_status add_step(work *w, double *net, taut_error *error)
{
    const size_t size = 3 * (size_t)w->mask->nu * (size_t)w->mask->nv;

    solve_factor(w);
    clear_net(w, w->right);
    for (int i = 0; i < w->kept_count; i++) {
        for (int c = 0; c < 3; c++) {
            taut_condition_add(w->all, w->kept[i], w->part[3 * w->kept[i] + c], w->right, c);
        }
    }
    const taut_status status = solve_right(w, error);
    for (size_t i = 0; i < size; i++) {
        net[i] += w->step[i];
    }
    return status;
}

taut_status taut_dirichlet_through_solve(taut_dirichlet_system *system, double aspect,
                                         const taut_mask *mask, const taut_conditions *conditions,
                                         taut_arena *arena, double *net, taut_error *error)
{
    work w = {.system = system, .aspect = aspect, .mask = mask, .all = conditions};

    if (!take_arrays(&w, arena)) {
        return taut_fail_memory(error);
    }
    taut_status status = fill_schur(&w, error);
    if (status != TAUT_OK) {
        return status;
    }
    for (int k = 0; k < conditions->count; k++) {
        append_row(&w, k);
    }
    for (int pass = 0; pass < PASSES && w.kept_count > 0; pass++) {
        find_defects(&w, net);
        status = add_step(&w, net, error);
        if (status != TAUT_OK) {
            return status;
        }
    }
    find_defects(&w, net);
    for (int k = 0; k < conditions->count; k++) {
        if (!(defect_of(&w, k) <= contradicts)) {
            return refuse(&w, k, error);
        }
    }
    return TAUT_OK;
}
