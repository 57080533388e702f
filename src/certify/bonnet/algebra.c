/* algebra.c -- a proof that a net on these bases is minimal, without samples.
 *
 * On a span u runs over {1, u, sin u, cos u} and v over {1, v, exp(-v), exp(v)}. The coefficients
 * of a function N in them are seen from its derivatives at one point, u from there:
 *
 *     N + N'', N' + N''', -N''', -N''       and       N - N'', N' - N''', (N'' -+ N''')/2
 *
 * The surface is harmonic if and only if r = Re Phi, Phi = const + A z + B e^(iz) + D e^(-iz), z =
 * u + i v, which leaves nine of the sixteen coefficients zero; and isothermal if and only if Phi' .
 * Phi' vanishes, which is
 *
 *     B.B = D.D = A.B = A.D = 0,   A.A + 2 B.D = 0
 *
 * (the relations of [XuWang2006] section 10 with S = i (B - D), T = B + D, in which large v do not
 * drown small ones). On cubics, Phi' = a + b z + c z^2 and a.a = a.b = b.c = c.c = 0, 2 a.c + b.b =
 * 0.
 */
#include "certify/bonnet/parts.h"

#include "core/constants.h"
#include "core/elementary/complex.h"
#include "core/vec3.h"

#include <math.h>
#include <stdint.h>
#include <string.h>

/* A coefficient of the surface, and the sum of the absolute values it comes from. */
typedef struct mode {
    double value[3];
    double gross;
} mode;

/* A complex vector and its error. */
typedef struct triple {
    double complex value[3];
    double size, error;
} triple;

/* The net of one span, turned so that i runs along the circular direction. */
typedef struct patch {
    const double *points;
    double sizes[4][4];
    int64_t step[2]; /* points to the next in i, in j */
    double lo[2], hi[2];
    double shift; /* relative rounding of modes from far parameters */
} patch;

/* Coefficients of the four functions of a span, that of exp(-v) at v - lo, of exp(v) at v - hi; and
 * the sums of the absolute values they come from. */
typedef struct table {
    double of[4][4], gross[4][4]; /* [mode][function] */
} table;

/* values[d][a], d = 0..3: derivatives of the four functions. */
typedef double derivatives[4][4];

/* Mode k is factor (derivative d + sign derivative e). */
static void add_entry(derivatives n, int k, double factor, int d, double sign, int e, table *c)
{
    for (int a = 0; a < 4; a++) {
        c->of[k][a] = factor * (n[d][a] + sign * n[e][a]);
        c->gross[k][a] = fabs(factor) * (fabs(n[d][a]) + fabs(sign * n[e][a]));
    }
}

static void circular_table(const taut_basis *basis, int span, double lo, double hi, table *c)
{
    derivatives n;
    taut_basis_eval(basis, span, lo + 0.5 * (hi - lo), 3, &n[0][0]);
    add_entry(n, 0, 1, 0, 1, 2, c);
    add_entry(n, 1, 1, 1, 1, 3, c);
    add_entry(n, 2, -1, 3, 0, 3, c);
    add_entry(n, 3, -1, 2, 0, 2, c);
}

/* 1 and v are told best where the exponentials weigh least, at `t`. */
static void hyperbolic_table(const taut_basis *basis, int span, double lo, double hi, double t,
                             table *c)
{
    derivatives n;
    taut_basis_eval(basis, span, t, 3, &n[0][0]);
    add_entry(n, 0, 1, 0, -1, 2, c);
    add_entry(n, 1, 1, 1, -1, 3, c);
    taut_basis_eval(basis, span, lo, 3, &n[0][0]);
    add_entry(n, 2, 0.5, 2, -1, 3, c);
    taut_basis_eval(basis, span, hi, 3, &n[0][0]);
    add_entry(n, 3, 0.5, 2, 1, 3, c);
}

static void power_table(const taut_basis *basis, int span, double lo, double hi, table *c)
{
    static const double inverse_factorial[4] = {1, 1, 0.5, 1.0 / 6};
    derivatives n;
    taut_basis_eval(basis, span, lo + 0.5 * (hi - lo), 3, &n[0][0]);
    for (int k = 0; k < 4; k++) {
        add_entry(n, k, inverse_factorial[k], k, 0, k, c);
    }
}

static mode mode_of(const patch *p, const table *u, int k, const table *v, int l)
{
    mode m = {{0, 0, 0}, 0};
    for (int i = 0; i < 4; i++) {
        for (int j = 0; j < 4; j++) {
            const double f = u->of[k][i] * v->of[l][j];
            for (int c = 0; c < 3; c++) {
                m.value[c] += f * p->points[3 * (i * p->step[0] + j * p->step[1]) + c];
            }
            m.gross += u->gross[k][i] * v->gross[l][j] * p->sizes[i][j];
        }
    }
    return m;
}

/* re + i factor im */
static triple join(const patch *p, const mode *re, double factor, const mode *im)
{
    triple t = {.error = TAUT_UNIT_ROUNDOFF * (re->gross + fabs(factor) * im->gross)};
    for (int c = 0; c < 3; c++) {
        t.value[c] = re->value[c] + I * factor * im->value[c];
    }
    t.size = taut_hypot(taut_length(re->value), factor * taut_length(im->value));
    t.error += p->shift * t.size;
    return t;
}

static double complex dot(const triple *a, const triple *b)
{
    return a->value[0] * b->value[0] + a->value[1] * b->value[1] + a->value[2] * b->value[2];
}

/* |a.b| over |a||b| vanishes up to the errors of both. */
static void orthogonal(const triple *a, const triple *b, const patch *p, taut_bonnet_finding *found)
{
    const double size = a->size * b->size;
    taut_bonnet_raise(found, taut_cabs(dot(a, b)) / size, a->error / a->size + b->error / b->size,
                      p->lo[0], p->lo[1]);
}

/* A coefficient that must vanish, times `factor`, against the size of its kin. */
static void vanish(const mode *m, double factor, double size, const patch *p,
                   taut_bonnet_finding *found)
{
    taut_bonnet_raise(found, factor * taut_length(m->value) / size,
                      TAUT_UNIT_ROUNDOFF * factor * m->gross / size, p->lo[0], p->lo[1]);
}

/* a.a + factor b.c = 0 */
static void balance(const triple *a, double factor, const triple *b, const triple *c,
                    const patch *p, taut_bonnet_finding *found)
{
    const double size = a->size * a->size + factor * b->size * c->size;
    const double error =
        2 * a->size * a->error + factor * (b->size * c->error + c->size * b->error);
    taut_bonnet_raise(found, taut_cabs(dot(a, a) + factor * dot(b, c)) / size, error / size,
                      p->lo[0], p->lo[1]);
}

static void judge_modes(const patch *p, const table *u, const table *v, taut_bonnet_finding *found)
{
    const double width = p->hi[0] - p->lo[0], height = p->hi[1] - p->lo[1];
    mode k[4][4];
    triple a, b, d;

    for (int i = 0; i < 4; i++) {
        for (int j = 0; j < 4; j++) {
            k[i][j] = mode_of(p, u, i, v, j);
        }
    }
    a = join(p, &k[1][0], -1, &k[0][1]);
    b = join(p, &k[3][2], -1, &k[2][2]);
    d = join(p, &k[3][3], 1, &k[2][3]);
    vanish(&k[1][1], fmax(width, height), a.size, p, found);
    for (int i = 2; i < 4; i++) {
        vanish(&k[i][0], 1, a.size, p, found);
        vanish(&k[i][1], fmax(1, height), a.size, p, found);
        vanish(&k[0][i], 1, i == 2 ? b.size : d.size, p, found);
        vanish(&k[1][i], fmax(1, width), i == 2 ? b.size : d.size, p, found);
    }
    orthogonal(&a, &b, p, found);
    orthogonal(&a, &d, p, found);
    orthogonal(&b, &b, p, found);
    orthogonal(&d, &d, p, found);
    balance(&a, 2 * taut_exp(-height), &b, &d, p, found);
}

/* The v in which sum |P| (|N| + |N''| + |N'| + |N'''|) is least. */
static double quietest(const patch *p, const taut_basis *basis, int span)
{
    enum { TRIES = 17 };
    double best = p->lo[1], least = INFINITY;
    for (int k = 0; k < TRIES; k++) {
        const double t =
            k == TRIES - 1 ? p->hi[1] : p->lo[1] + (p->hi[1] - p->lo[1]) * k / (TRIES - 1);
        double gross = 0;
        derivatives n;
        taut_basis_eval(basis, span, t, 3, &n[0][0]);
        for (int i = 0; i < 16; i++) {
            const int j = i % 4;
            gross += p->sizes[i / 4][j] *
                     (fabs(n[0][j]) + fabs(n[2][j]) + fabs(n[1][j]) + fabs(n[3][j]));
        }
        if (gross < least) {
            least = gross;
            best = t;
        }
    }
    return best;
}

/* Harmonic: K20 + K02 = K12 + 3 K30 = K21 + 3 K03 = 0 and nothing of order 4 or more. */
static void judge_powers(const patch *p, const table *u, const table *v, taut_bonnet_finding *found)
{
    const double h = fmax(p->hi[0] - p->lo[0], p->hi[1] - p->lo[1]);
    mode k[4][4];
    triple a, b, c;
    double size = 0;

    for (int i = 0; i < 4; i++) {
        for (int j = 0; j < 4; j++) {
            k[i][j] = mode_of(p, u, i, v, j);
        }
    }
    a = join(p, &k[1][0], -1, &k[0][1]);
    for (int x = 0; x < 3; x++) { /* the halves that must be equal, into one */
        const double even = k[2][0].value[x] + k[0][2].value[x];
        const double third = k[1][2].value[x] + 3 * k[3][0].value[x];
        const double other = k[2][1].value[x] + 3 * k[0][3].value[x];
        k[0][2].value[x] = even;
        k[1][2].value[x] = third;
        k[0][3].value[x] = other;
        k[2][0].value[x] = 2 * k[2][0].value[x] - even; /* of b = 2 K20 - i K11 */
        k[3][0].value[x] *= 3;
    }
    k[0][2].gross += k[2][0].gross;
    k[1][2].gross += 3 * k[3][0].gross;
    k[0][3].gross = 3 * k[0][3].gross + k[2][1].gross;
    k[2][0].gross += k[0][2].gross;
    k[3][0].gross *= 3;
    b = join(p, &k[2][0], -1, &k[1][1]);
    c = join(p, &k[3][0], -1, &k[2][1]);
    size = a.size + h * b.size + h * h * c.size;
    vanish(&k[0][2], h, size, p, found);
    vanish(&k[1][2], h * h, size, p, found);
    vanish(&k[0][3], h * h, size, p, found);
    for (int i = 1; i < 4; i++) {
        for (int j = 4 - i; j < 4; j++) {
            vanish(&k[i][j], taut_pow(h, i + j - 1), size, p, found);
        }
    }
    orthogonal(&a, &a, p, found);
    orthogonal(&a, &b, p, found);
    orthogonal(&b, &c, p, found);
    orthogonal(&c, &c, p, found);
    balance(&b, 2, &a, &c, p, found);
}

static int is_type(const taut_basis *basis, const char *bezier, const char *bspline)
{
    const char *type = taut_basis_type(basis);
    return strcmp(type, bezier) == 0 || strcmp(type, bspline) == 0;
}

/* The four by four of spans su, sv, turned. */
static void take_patch(const taut_surface *surface, const taut_bonnet_scale *scale, int turned,
                       const int span[2], patch *p)
{
    const taut_basis *bases[2] = {taut_surface_u(surface), taut_surface_v(surface)};
    const int nv = taut_basis_count(bases[1]);
    int first[2];
    for (int d = 0; d < 2; d++) {
        const int axis = turned ? 1 - d : d;
        first[axis] = taut_basis_first(bases[axis], span[d]);
        p->lo[d] = taut_basis_breaks(bases[axis])[span[d]];
        p->hi[d] = taut_basis_breaks(bases[axis])[span[d] + 1];
        p->step[d] = axis == 0 ? nv : 1;
    }
    p->points = taut_surface_points(surface) + 3 * ((int64_t)first[0] * nv + first[1]);
    p->shift = scale->shift[0] + scale->shift[1];
    for (int i = 0; i < 4; i++) {
        for (int j = 0; j < 4; j++) {
            p->sizes[i][j] = taut_bonnet_point_size(surface, scale, first[0] + (turned ? j : i),
                                                    first[1] + (turned ? i : j));
        }
    }
}

int taut_bonnet_algebra(const taut_surface *surface, const taut_bonnet_scale *scale,
                        taut_bonnet_finding *found)
{
    const taut_basis *u = taut_surface_u(surface), *v = taut_surface_v(surface);
    const int turned = is_type(u, "h-bezier", "h-bspline");
    const taut_basis *around = turned ? v : u, *along = turned ? u : v;
    const int cubic = is_type(u, "bezier", "bezier") && is_type(v, "bezier", "bezier") &&
                      taut_basis_degree(u) == 3 && taut_basis_degree(v) == 3;
    int span[2];

    if (!cubic &&
        (!is_type(around, "c-bezier", "c-bspline") || !is_type(along, "h-bezier", "h-bspline"))) {
        return 0;
    }
    for (span[0] = 0; span[0] < taut_basis_span_count(around); span[0]++) {
        for (span[1] = 0; span[1] < taut_basis_span_count(along); span[1]++) {
            table cu, cv;
            patch p;
            take_patch(surface, scale, turned, span, &p);
            if (cubic) {
                power_table(around, span[0], p.lo[0], p.hi[0], &cu);
                power_table(along, span[1], p.lo[1], p.hi[1], &cv);
                judge_powers(&p, &cu, &cv, found);
            } else {
                circular_table(around, span[0], p.lo[0], p.hi[0], &cu);
                hyperbolic_table(along, span[1], p.lo[1], p.hi[1], quietest(&p, along, span[1]),
                                 &cv);
                judge_modes(&p, &cu, &cv, found);
            }
        }
    }
    return 1;
}
