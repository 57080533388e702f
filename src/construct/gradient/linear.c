/* linear.c -- derivatives through a construction whose points are linear in what it is given, the
 * same for each coordinate:
 *
 *     P = J k,    dF/dk = J^T F_P
 *
 * The columns of J are what the construction makes of unit points, three at a time, one a coordinate.
 */
#include "construct/gradient/gradient.h"
#include "core/fail.h"

#include <string.h>

/* What is pulled back. */
typedef struct pulling {
    const taut_gradient_net *net;
    taut_gradient_remake *remake;
    const void *context;
    taut_make_options options;
    size_t count;
    const double *outer; /* F_P, [count][3] */
    double *unit;        /* a net of unit points */
} pulling;

/* gradient[at[c]] = column . F_P for c = 0 .. some - 1, the columns in the coordinates. */
static void multiply(const pulling *p, const double *columns, const size_t *at, int some,
                     double *gradient)
{
    for (int c = 0; c < some; c++) {
        double sum[3] = {0, 0, 0};
        for (size_t i = 0; i < p->count; i++) {
            for (int d = 0; d < 3; d++) {
                sum[d] += columns[3 * i + (size_t)c] * p->outer[3 * i + (size_t)d];
            }
        }
        memcpy(gradient + 3 * at[c], sum, sizeof sum);
    }
}

static taut_status pull_some(const pulling *p, const size_t *at, int some, double *gradient,
                             taut_error *error)
{
    taut_model *model = NULL;
    taut_status status = TAUT_OK;

    for (int c = 0; c < some; c++) {
        p->unit[3 * at[c] + (size_t)c] = 1;
    }
    status = p->remake(p->context, p->unit, &p->options, &model, error);
    for (int c = 0; c < some; c++) {
        p->unit[3 * at[c] + (size_t)c] = 0;
    }
    if (status == TAUT_OK) {
        multiply(p, taut_surface_points(taut_model_surface(model, 0)), at, some, gradient);
        taut_model_free(model);
    }
    return status;
}

taut_status taut_gradient_pull_linear(const taut_gradient_net *net, taut_gradient_remake *remake,
                                      const void *context, const taut_monitor *monitor,
                                      taut_arena *arena, double *seed, taut_error *error)
{
    pulling p = {.net = net, .remake = remake, .context = context};
    size_t at[3];
    int some = 0;
    taut_status status = TAUT_OK;

    p.count = (size_t)taut_basis_count(net->u) * (size_t)taut_basis_count(net->v);
    p.options.monitor = *monitor;
    p.outer = taut_arena_copy(arena, seed, p.count, 3 * sizeof(double));
    p.unit = taut_arena_take(arena, p.count, 3 * sizeof(double));
    if (taut_arena_status(arena) != TAUT_OK) {
        return taut_fail_memory(error);
    }
    memset(seed, 0, 3 * p.count * sizeof(double));
    for (size_t i = 0; i < p.count && status == TAUT_OK; i++) {
        if (net->known[i]) {
            at[some++] = i;
        }
        if (some == 3 || (some > 0 && i + 1 == p.count)) {
            status = pull_some(&p, at, some, seed, error);
            some = 0;
        }
    }
    return status;
}
