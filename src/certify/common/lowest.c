/* lowest.c -- Lanczos for A = (K - shift M)^-1 M, which is symmetric in the product x . M y. Its
 * largest eigenvalue is 1 / (lambda - shift).
 *
 *     v_0 = A (start), of unit mass
 *     w = A v_j, orthogonal to all v; v_(j+1) = w of unit mass      A v_j = b_(j-1) v_(j-1) + a_j v_j + b_j v_(j+1)
 *     until b_j times the last entry of T's first eigenvector is small: that is the residual
 */
#include "certify/common/lowest.h"

#include <math.h>

enum { VECTORS = 24, ROUNDS = 20, BISECTIONS = 64 };
static const double settled = 1e-7; /* residual: of the eigenvalue of A */

/* What Lanczos has found: T, and v with M v. */
typedef struct space {
    const taut_lowest *form;
    taut_pulse *pulse;
    double a[VECTORS], b[VECTORS]; /* of T: the diagonal, what is beside it */
    double first[VECTORS];         /* T's first eigenvector, of unit length */
    double *v, *mv;                /* [VECTORS + 1][count] */
    int found;
} space;

static double dot(int n, const double *x, const double *y)
{
    double sum = 0;
    for (int i = 0; i < n; i++) {
        sum += x[i] * y[i];
    }
    return sum;
}

/* Are all eigenvalues of T below t? */
static int is_above(const space *s, double t)
{
    double pivot = t - s->a[0];
    for (int i = 1; i < s->found && pivot > 0; i++) {
        pivot = t - s->a[i] - s->b[i - 1] * s->b[i - 1] / pivot;
    }
    return pivot > 0;
}

/* x = (t - T)^-1 x, t above all eigenvalues. */
static void solve_tridiagonal(const space *s, double t, double *x)
{
    double pivots[VECTORS];

    pivots[0] = t - s->a[0];
    for (int i = 1; i < s->found; i++) {
        const double share = s->b[i - 1] / pivots[i - 1];
        pivots[i] = t - s->a[i] - s->b[i - 1] * share;
        x[i] += share * x[i - 1];
    }
    x[s->found - 1] /= pivots[s->found - 1];
    for (int i = s->found - 2; i >= 0; i--) {
        x[i] = (x[i] + s->b[i] * x[i + 1]) / pivots[i];
    }
}

/* T's largest eigenvalue, from above, and `first`, by inverse iteration there: nothing cancels. */
static double find_first(space *s)
{
    double above = 0, below = 0;

    for (int i = 0; i < s->found; i++) {
        const double row = s->a[i] + (i > 0 ? s->b[i - 1] : 0) + (i < s->found - 1 ? s->b[i] : 0);
        above = row > above ? row : above;
    }
    above *= 1 + 1e-12; /* where a pivot is not lost */
    for (int k = 0; k < BISECTIONS; k++) {
        const double middle = 0.5 * (below + above);
        if (is_above(s, middle)) {
            above = middle;
        } else {
            below = middle;
        }
    }
    for (int i = 0; i < s->found; i++) {
        s->first[i] = 1;
    }
    for (int k = 0; k < 3; k++) {
        solve_tridiagonal(s, above * (1 + 1e-14), s->first);
        const double size = sqrt(dot(s->found, s->first, s->first));
        for (int i = 0; i < s->found; i++) {
            s->first[i] /= size;
        }
    }
    return above;
}

/* v[at] and mv[at] of unit mass, from v[at] as it is. Returns its mass' root; 0: there is none. NaN: out of range. */
static double enter(space *s, int at)
{
    const int n = s->form->count;
    double *v = s->v + (size_t)at * (size_t)n, *mv = s->mv + (size_t)at * (size_t)n;

    s->form->weigh(s->form->of, v, mv);
    const double mass = dot(n, v, mv);
    if (!(mass > 0) || !isfinite(mass)) {
        return mass <= 0 ? 0 : NAN;
    }
    const double size = sqrt(mass);
    for (int i = 0; i < n; i++) {
        v[i] /= size;
        mv[i] /= size;
    }
    return size;
}

/* The vector after the last that was found, without what lies along the others. */
static void step(space *s)
{
    const int n = s->form->count, last = s->found;
    const double *mv = s->mv + (size_t)last * (size_t)n;
    double *w = s->v + (size_t)(last + 1) * (size_t)n;

    for (int i = 0; i < n; i++) {
        w[i] = mv[i];
    }
    s->form->solve(s->form->of, w);
    s->a[last] = dot(n, mv, w);
    for (int round = 0; round < 2; round++) { /* the second takes what rounding left */
        for (int k = last; k >= 0; k--) {
            const double along = dot(n, s->mv + (size_t)k * (size_t)n, w);
            const double *v = s->v + (size_t)k * (size_t)n;
            for (int i = 0; i < n; i++) {
                w[i] -= along * v[i];
            }
        }
    }
    s->found++;
}

/* x = the eigenvector as far as it is known. */
static void gather(const space *s, double *x)
{
    const int n = s->form->count;

    for (int i = 0; i < n; i++) {
        x[i] = 0;
    }
    for (int k = 0; k < s->found; k++) {
        const double *v = s->v + (size_t)k * (size_t)n;
        for (int i = 0; i < n; i++) {
            x[i] += s->first[k] * v[i];
        }
    }
}

/* Lanczos from x; *is_settled where it need not begin again. */
static taut_status follow(space *s, double *x, int *is_settled)
{
    const int n = s->form->count;

    for (int i = 0; i < n; i++) {
        s->v[i] = x[i];
    }
    s->found = 0;
    if (!(enter(s, 0) > 0)) {
        return TAUT_NOT_CONVERGED;
    }
    while (s->found < VECTORS && !*is_settled) {
        step(s);
        const double beside = enter(s, s->found), largest = find_first(s);
        s->b[s->found - 1] = beside;
        if (!isfinite(beside) || !isfinite(largest) || !(largest > 0)) {
            return TAUT_NOT_CONVERGED;
        }
        *is_settled = beside * fabs(s->first[s->found - 1]) <= settled * largest;
        if (taut_pulse_beat(s->pulse, s->form->work + 8.0 * n * s->found)) {
            return TAUT_INTERRUPTED;
        }
    }
    gather(s, x);
    return TAUT_OK;
}

taut_status taut_certify_lowest(const taut_lowest *form, taut_arena *arena, taut_pulse *pulse,
                                double *x)
{
    const size_t n = (size_t)form->count;
    space s = {.form = form, .pulse = pulse};
    unsigned seed = 12345;
    int is_settled = 0;

    s.v = taut_arena_take_raw(arena, (VECTORS + 1) * n, sizeof(double));
    s.mv = taut_arena_take_raw(arena, (VECTORS + 1) * n, sizeof(double));
    if (taut_arena_status(arena) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    for (size_t i = 0; i < n; i++) {
        seed = 1664525u * seed + 1013904223u;
        s.v[i] = (double)(seed >> 8) * 0x1p-24 - 0.25;
    }
    form->weigh(form->of, s.v, x);
    form->solve(form->of, x);
    for (int round = 0; round < ROUNDS && !is_settled; round++) {
        const taut_status status = follow(&s, x, &is_settled);
        if (status != TAUT_OK) {
            return status;
        }
    }
    return TAUT_OK;
}
