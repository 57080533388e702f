/* described.c -- forgeries that tell a shape otherwise: a part of it by de Casteljau's algorithm, u
 * and v exchanged, mirrored, in other sizes, run through the other way, on other parameters. What
 * claims are about does not ask how a shape is told, `identity` does. */
#include "kinds.h"

#include <math.h>
#include <string.h>

static edit_surface *any_surface(edit_model *edit, forge_random *random)
{
    return edit->surfaces > 0 ? &edit->surface[forge_int(random, 0, edit->surfaces - 1)] : NULL;
}

static int is_bezier(const taut_basis_spec *spec)
{
    return strcmp(spec->type, "bezier") == 0;
}

/* One line of n homogeneous points, `stride` apart, from 0 to t of it (high: from t to 1). */
static void cut_line(double (*x)[4], int n, int stride, double t, int high)
{
    for (int r = 1; r < n; r++) {
        for (int k = 0; k < n - r; k++) {
            /* low: point n - 1 - k is taken last; high: point k first */
            const int at = (high ? k : n - 1 - k) * stride;
            const int from = at + (high ? stride : -stride);
            for (int c = 0; c < 4; c++) {
                x[at][c] = high ? (1 - t) * x[at][c] + t * x[from][c]
                                : (1 - t) * x[from][c] + t * x[at][c];
            }
        }
    }
}

static void cut_net(edit_model *edit, edit_surface *s, int along_v, double t, int high)
{
    const int n = s->nu * s->nv;
    double(*x)[4] = pool_take(edit->pool, (size_t)n * sizeof *x);

    for (int i = 0; i < n; i++) {
        x[i][3] = s->weights != NULL ? s->weights[i] : 1;
        for (int k = 0; k < 3; k++) {
            x[i][k] = x[i][3] * s->points[3 * i + k];
        }
    }
    for (int line = 0; line < (along_v ? s->nu : s->nv); line++) {
        cut_line(x + (along_v ? line * s->nv : line), along_v ? s->nv : s->nu, along_v ? 1 : s->nv,
                 t, high);
    }
    for (int i = 0; i < n; i++) {
        for (int k = 0; k < 3; k++) {
            s->points[3 * i + k] = x[i][k] / x[i][3];
        }
        if (s->weights != NULL) {
            s->weights[i] = x[i][3];
        }
    }
}

/* A part of a bezier surface; on its part of the range, or on all of it. */
void forge_part(edit_model *edit, const forge_base *base, const forge_base *other,
                forge_random *random)
{
    edit_surface *s = any_surface(edit, random);
    const int along_v = forge_int(random, 0, 1), high = forge_int(random, 0, 1);
    const double t = forge_bits(random) & 1 ? forge_in(random, 0, 1)
                                            : (high ? forge_log(random, 1e-12, 1e-2)
                                                    : 1 - forge_log(random, 1e-12, 1e-2));

    (void)base;
    (void)other;
    if (s == NULL || !is_bezier(along_v ? &s->v : &s->u)) {
        return;
    }
    taut_basis_spec *spec = along_v ? &s->v : &s->u;
    cut_net(edit, s, along_v, t, high);
    if (forge_bits(random) & 1) {
        const double lo = spec->has_range ? spec->range[0] : 0;
        const double hi = spec->has_range ? spec->range[1] : 1, at = lo + t * (hi - lo);
        spec->range[0] = high ? at : lo;
        spec->range[1] = high ? hi : at;
        spec->has_range = 1;
    }
}

void forge_transposed(edit_model *edit, const forge_base *base, const forge_base *other,
                      forge_random *random)
{
    edit_surface *s = any_surface(edit, random);

    (void)base;
    (void)other;
    if (s == NULL) {
        return;
    }
    const taut_basis_spec u = s->u;
    const int nu = s->nu, nv = s->nv;
    double *points = pool_take(edit->pool, (size_t)(3 * nu * nv) * sizeof *points);
    double *weights = pool_take(edit->pool, (size_t)(nu * nv) * sizeof *weights);
    for (int i = 0; i < nu * nv; i++) {
        const int to = i % nv * nu + i / nv;
        memcpy(points + 3 * to, s->points + 3 * i, 3 * sizeof *points);
        weights[to] = s->weights != NULL ? s->weights[i] : 1;
    }
    s->points = points;
    s->weights = s->weights != NULL ? weights : NULL;
    s->u = s->v;
    s->v = u;
    s->nu = nv;
    s->nv = nu;
}

static void multiply(double *points, int count, const double by[3])
{
    for (int i = 0; i < 3 * count; i++) {
        points[i] *= by[i % 3];
    }
}

/* Everything, or one surface alone. */
static void multiply_some(edit_model *edit, forge_random *random, const double by[3])
{
    const int one = forge_int(random, 0, 2) == 0 && edit->surfaces > 0
                        ? forge_int(random, 0, edit->surfaces - 1)
                        : -1;

    for (int i = 0; i < edit->surfaces; i++) {
        if (one < 0 || i == one) {
            multiply(edit->surface[i].points, edit->surface[i].nu * edit->surface[i].nv, by);
        }
    }
    for (int i = 0; i < edit->curves && one < 0; i++) {
        multiply(edit->curve[i].points, edit->curve[i].n, by);
    }
}

void forge_mirrored(edit_model *edit, const forge_base *base, const forge_base *other,
                    forge_random *random)
{
    double by[3] = {1, 1, 1};

    (void)base;
    (void)other;
    by[forge_int(random, 0, 2)] = -1;
    multiply_some(edit, random, by);
}

/* By any number: every coordinate is rounded. One direction alone, sometimes. */
void forge_scaled(edit_model *edit, const forge_base *base, const forge_base *other,
                  forge_random *random)
{
    const double all = forge_bits(random) & 1 ? forge_log(random, 1e-300, 1e300)
                                              : 1 + forge_log(random, 1e-15, 10);
    double by[3] = {all, all, all};

    (void)base;
    (void)other;
    if (forge_int(random, 0, 2) == 0) {
        by[forge_int(random, 0, 2)] = 1;
    }
    multiply_some(edit, random, by);
}

/* Of a curve: weights times c^i, one weight, or one degree more. */
void forge_curve_parameters(edit_model *edit, const forge_base *base, const forge_base *other,
                            forge_random *random)
{
    const int how = forge_int(random, 0, 2);

    (void)base;
    (void)other;
    if (edit->curves == 0) {
        return;
    }
    edit_curve *c = &edit->curve[forge_int(random, 0, edit->curves - 1)];
    if (how == 2) {
        double *points = pool_take(edit->pool, (size_t)(3 * c->n + 3) * sizeof *points);
        if (!is_bezier(&c->t) || c->weights != NULL) {
            return;
        }
        for (int i = 0; i < 3 * (c->n + 1); i++) {
            const double f = (double)(i / 3) / c->n;
            points[i] =
                (i >= 3 ? f * c->points[i - 3] : 0) + (i < 3 * c->n ? (1 - f) * c->points[i] : 0);
        }
        c->points = points;
        c->n++;
        c->t.degree++;
        return;
    }
    if (c->weights == NULL) {
        c->weights = pool_take(edit->pool, (size_t)c->n * sizeof *c->weights);
        for (int i = 0; i < c->n; i++) {
            c->weights[i] = 1;
        }
    }
    const double by = forge_log(random, 1e-8, 1e8);
    for (int i = 0; i < c->n && how == 0; i++) {
        c->weights[i] *= pow(by, i);
    }
    if (how == 1) {
        c->weights[forge_int(random, 0, c->n - 1)] *= by;
    }
}

static void turn_rows(double *points, int rows, int numbers)
{
    for (int i = 0; 2 * i < rows - 1; i++) {
        for (int k = 0; k < numbers; k++) {
            const double t = points[i * numbers + k];
            points[i * numbers + k] = points[(rows - 1 - i) * numbers + k];
            points[(rows - 1 - i) * numbers + k] = t;
        }
    }
}

/* All of the model run through the other way in u, curves too. */
void forge_backwards(edit_model *edit, const forge_base *base, const forge_base *other,
                     forge_random *random)
{
    (void)base;
    (void)other;
    (void)random;
    for (int i = 0; i < edit->surfaces; i++) {
        edit_surface *s = &edit->surface[i];
        turn_rows(s->points, s->nu, 3 * s->nv);
        if (s->weights != NULL) {
            turn_rows(s->weights, s->nu, s->nv);
        }
    }
    for (int i = 0; i < edit->curves; i++) {
        edit_curve *c = &edit->curve[i];
        turn_rows(c->points, c->n, 3);
        if (c->weights != NULL) {
            turn_rows(c->weights, c->n, 1);
        }
    }
}

/* Weights of 1e-8 to 1e8: one, all, or all alike. */
void forge_far_weights(edit_model *edit, const forge_base *base, const forge_base *other,
                       forge_random *random)
{
    edit_surface *s = any_surface(edit, random);
    const int how = forge_int(random, 0, 2);
    const double by = forge_log(random, 1e-8, 1e8);

    (void)base;
    (void)other;
    if (s == NULL) {
        return;
    }
    const int n = s->nu * s->nv, one = forge_int(random, 0, n - 1);
    if (s->weights == NULL) {
        s->weights = pool_take(edit->pool, (size_t)n * sizeof *s->weights);
        for (int i = 0; i < n; i++) {
            s->weights[i] = 1;
        }
    }
    for (int i = 0; i < n; i++) {
        s->weights[i] *= how == 0   ? (i == one ? by : 1)
                         : how == 1 ? forge_log(random, 1e-8, 1e8)
                                    : by;
    }
}
