/* proof.c -- isothermal, harmonic and minimal over whole pieces, from coefficients (local.h).
 *
 * On a piece let W = r_u - i r_v, zeta = tau + i eta, S and C the functions phi_1 + s phi_3 and
 * phi_2 of zeta, in which (s_u = -s_v = s) sin(zeta) or sinh(zeta) and its like are told. Then
 *
 *     W = Phi + D,  Phi = w0 + w1 S + w2 C,  w0 = x10 - i x01,  w1 = x20 - i x11,  w2 = x30 - i x21
 *
 * where D, a table of coefficients again, vanishes where r is harmonic; and as S^2 = 2 C + s C^2,
 *
 *     Phi.Phi   = w0.w0 + 2 w0.w1 S + 2 (w0.w2 + w1.w1) C + 2 w1.w2 S C + (w2.w2 + s w1.w1) C^2
 *     Phi'.Phi' = w1.w1 + (w2.w2 + s w1.w1) S^2 + 2 w1.w2 S (1 + s C)
 *
 * all of whose coefficients but the last line's first vanish where r is isothermal too. With bounds
 * of |S|, |C|, |D| on the piece:
 *
 *     x = |Phi.Phi| + 2 |Phi| |D| + |D|^2  >=  |W.W| = |E - G - 2 i F|
 *     E >= (|W|^2 - x)/2                        so that |E-G|/E, |F|/E <= x/E =: eps
 *     Q >= |r_uu + r_vv|                        from its own coefficients, over |W_u|
 *     |H|/sqrt|K| = |E N - 2 F M + G L| / (2 sqrt(J) sqrt|LN - M^2|), J = EG - F^2 >= E^2 (1 - eps - eps^2/4)
 *                <= (Q + eps |b|) / (2 sqrt(1 - eps - eps^2/4) sqrt(B))
 *
 * B bounds |LN - M^2| >= L^2 + M^2 - |L| Q from below. With n the unit normal L - iM = W_u.n =: b,
 * f = e1 - i e2 of an orthonormal pair that begins with r_u:
 *     b^2 = W_u.W_u - (W_u.f)(W_u.conj f),   |W_u.f| <= |W_u.W|/sqrt(E) + 1.2 eps |W_u|,  eps <= 1/10
 * ([XuWang2006] sections 1, 9 and 10). Each bound comes with what rounding of the points explains of
 * it, the limit; and a claim that is false is seen to be in the middle of some piece. Pieces that
 * settle nothing are cut in four.
 */
#include "certify/bonnet/proof.h"

#include "core/elementary/elementary.h"
#include "core/vec3.h"

#include <math.h>
#include <stdint.h>
#include <string.h>

enum { DEPTH = 32, CUTS = 8000, CUTS_OF_PIECE = 500 };

static const double largest_limit = 1e-6;
static const double root_2 = 1.4142135623730951;
/* Of what rounding explains, how much a claim may have. */
static const double allowance = 4;

/* |value| is at most `upper`; of a value that should vanish, rounding explains `noise`. */
typedef struct amount {
    double upper, noise;
} amount;

static amount amount_sum(amount a, amount b)
{
    return (amount){a.upper + b.upper, a.noise + b.noise};
}

static amount amount_times(double factor, amount a)
{
    return (amount){factor * a.upper, factor * a.noise};
}

/* A complex vector, its length, what this calculation and what rounding the points do to it. */
typedef struct wave {
    double value[6]; /* real parts, imaginary parts */
    double size, own, noise;
} wave;

/* f a.b + g c.d, in absolute value: the root of a sum of squares, as all is about 1 in size. */
static double dot_size(double f, const wave *a, const wave *b, double g, const wave *c,
                       const wave *d)
{
    double real = 0, imaginary = 0;
    for (int k = 0; k < 3; k++) {
        real += f * (a->value[k] * b->value[k] - a->value[k + 3] * b->value[k + 3]);
        real += g * (c->value[k] * d->value[k] - c->value[k + 3] * d->value[k + 3]);
        imaginary += f * (a->value[k] * b->value[k + 3] + a->value[k + 3] * b->value[k]);
        imaginary += g * (c->value[k] * d->value[k + 3] + c->value[k + 3] * d->value[k]);
    }
    return sqrt(real * real + imaginary * imaginary);
}

/* The error of a.b for errors e, f of a and b. */
static double dot_error(const wave *a, double e, const wave *b, double f)
{
    return a->size * f + b->size * e + e * f;
}

static amount dot_amount(double factor, const wave *a, const wave *b)
{
    const double noise = dot_error(a, a->noise, b, b->noise);
    const double own = dot_error(a, a->own, b, b->own);
    return (amount){fabs(factor) * (dot_size(1, a, b, 0, a, b) + own), fabs(factor) * noise};
}

/* The sum of two products that cancel. */
static amount pair_amount(double f, const wave *a, const wave *b, double g, const wave *c,
                          const wave *d)
{
    const amount one = dot_amount(f, a, b), two = dot_amount(g, c, d);
    const double own =
        fabs(f) * dot_error(a, a->own, b, b->own) + fabs(g) * dot_error(c, c->own, d, d->own);
    return (amount){dot_size(f, a, b, g, c, d) + own, one.noise + two.noise};
}

/* The table of W, or of D: coefficients of phi_d psi_e, and errors of their lengths. */
typedef struct table {
    double of[4][4][6]; /* real parts, imaginary parts */
    double own[4][4], noise[4][4];
} table;

enum { REAL = 0, IMAGINARY = 3 };

/* Adds factor x[d][e] to a part of entry (i, j). A vector is at most 1.75 times its largest
 * coordinate. */
static void add_entry(table *t, int i, int j, int part, double factor, const taut_bonnet_local *l,
                      int d, int e)
{
    const double size = 1.75 * fabs(factor);
    for (int c = 0; c < 3; c++) {
        t->of[i][j][part + c] += factor * l->x[d][e][c];
    }
    t->own[i][j] += size * l->own[d][e];
    t->noise[i][j] += size * (l->own[d][e] + l->points[d][e]);
}

static void fill_w(const taut_bonnet_local *l, table *w)
{
    memset(w, 0, sizeof *w);
    for (int k = 0; k < 4; k++) {
        add_entry(w, 0, k, REAL, 1, l, 1, k);
        add_entry(w, 1, k, REAL, 1, l, 2, k);
        add_entry(w, 2, k, REAL, 1, l, 3, k);
        add_entry(w, 3, k, REAL, l->s[0], l, 2, k);
        add_entry(w, k, 0, IMAGINARY, -1, l, k, 1);
        add_entry(w, k, 1, IMAGINARY, -1, l, k, 2);
        add_entry(w, k, 2, IMAGINARY, -1, l, k, 3);
        add_entry(w, k, 3, IMAGINARY, -l->s[1], l, k, 2);
    }
}

/* Of r_uu + r_vv. */
static void fill_laplacian(const taut_bonnet_local *l, table *q)
{
    memset(q, 0, sizeof *q);
    for (int k = 0; k < 4; k++) {
        add_entry(q, 0, k, REAL, 1, l, 2, k);
        add_entry(q, 1, k, REAL, 1, l, 3, k);
        add_entry(q, 2, k, REAL, l->s[0], l, 2, k);
        add_entry(q, 3, k, REAL, l->s[0], l, 3, k);
        add_entry(q, k, 0, REAL, 1, l, k, 2);
        add_entry(q, k, 1, REAL, 1, l, k, 3);
        add_entry(q, k, 2, REAL, l->s[1], l, k, 2);
        add_entry(q, k, 3, REAL, l->s[1], l, k, 3);
    }
}

static double length_of(const double v[6])
{
    return sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2] + v[3] * v[3] + v[4] * v[4] + v[5] * v[5]);
}

static wave wave_of(const table *t, int i, int j)
{
    wave a = {.size = length_of(t->of[i][j]), .own = t->own[i][j], .noise = t->noise[i][j]};
    memcpy(a.value, t->of[i][j], sizeof a.value);
    return a;
}

/* Takes factor w, or factor i w, off entry (i, j). */
static void take_off(table *t, int i, int j, int part, double factor, const wave *w)
{
    for (int c = 0; c < 3; c++) {
        t->of[i][j][c] -= factor * (part == REAL ? w->value[c] : -w->value[c + 3]);
        t->of[i][j][c + 3] -= factor * (part == REAL ? w->value[c + 3] : w->value[c]);
    }
    t->own[i][j] += fabs(factor) * w->own;
    t->noise[i][j] += fabs(factor) * w->noise;
}

/* W less w0 + w1 S + w2 C; S = (phi_1 + s phi_3)(1 + s' psi_2) + i (1 + s phi_2)(psi_1 + s' psi_3),
 * C = phi_2 - psi_2 + s' phi_2 psi_2 + i (phi_1 + s phi_3)(psi_1 + s' psi_3), s' = -s. */
static void take_holomorphic(const taut_bonnet_local *l, const wave w[3], table *t)
{
    const double s = l->s[0], z = l->s[1];
    take_off(t, 1, 2, REAL, z, &w[1]);
    take_off(t, 3, 0, REAL, s, &w[1]);
    take_off(t, 3, 2, REAL, s * z, &w[1]);
    take_off(t, 0, 1, IMAGINARY, 1, &w[1]);
    take_off(t, 0, 3, IMAGINARY, z, &w[1]);
    take_off(t, 2, 1, IMAGINARY, s, &w[1]);
    take_off(t, 2, 3, IMAGINARY, s * z, &w[1]);
    take_off(t, 0, 2, REAL, -1, &w[2]);
    take_off(t, 2, 2, REAL, z, &w[2]);
    take_off(t, 1, 1, IMAGINARY, 1, &w[2]);
    take_off(t, 1, 3, IMAGINARY, z, &w[2]);
    take_off(t, 3, 1, IMAGINARY, s, &w[2]);
    take_off(t, 3, 3, IMAGINARY, s * z, &w[2]);
    for (int d = 0; d < 3; d++) { /* what w0, w1, w2 are themselves */
        t->own[d][0] = t->noise[d][0] = 0;
        memset(t->of[d][0], 0, sizeof t->of[d][0]);
    }
}

/* sum |t[d][e]| f[d] g[e] */
static amount table_amount(const table *t, const double f[4], const double g[4])
{
    amount sum = {0, 0};
    for (int d = 0; d < 4; d++) {
        for (int e = 0; e < 4; e++) {
            sum.upper += (length_of(t->of[d][e]) + t->own[d][e]) * f[d] * g[e];
            sum.noise += t->noise[d][e] * f[d] * g[e];
        }
    }
    return sum;
}

/* What a piece says of the three claims. */
typedef struct judgement {
    amount claim[TAUT_BONNET_PROVED]; /* upper infinite where nothing is separated */
    double seen[TAUT_BONNET_PROVED];  /* in the middle, less what rounding explains there */
    int is_close;                     /* the bounds are about what they would be on a point */
    int is_lost[TAUT_BONNET_PROVED]; /* rounding hides what it is held against: cutting is no use */
} judgement;

/* a product of two that should both be small, added to them: |p|^2 + 2 P |p| */
static amount disturbed(double size, amount p)
{
    return (amount){(2 * size + p.upper) * p.upper, (2 * size + p.noise) * p.noise};
}

/* From the residuals of the middle, by the derivatives there alone; returns |E N - 2 F M + G L| / E. */
static double see_middle(const taut_bonnet_local *l, double second_size, const amount at[3],
                         double seen[TAUT_BONNET_PROVED])
{
    const double *u = l->x[1][0], *v = l->x[0][1];
    const double e = taut_dot(u, u), g = taut_dot(v, v), f = taut_dot(u, v);
    double q[3], normal[3], second[3] = {0, 0, 0};
    const double(*x[3])[3] = {&l->x[2][0], &l->x[1][1], &l->x[0][2]};

    for (int c = 0; c < 3; c++) {
        q[c] = l->x[2][0][c] + l->x[0][2][c];
    }
    taut_cross(u, v, normal);
    const double area = taut_length(normal);
    for (int k = 0; k < 3 && area > 0; k++) {
        second[k] = taut_dot(*x[k], normal) / area;
    }
    const double most = fmax(taut_length(*x[0]), fmax(taut_length(*x[1]), taut_length(*x[2])));
    const double bend = sqrt(fabs(second[0] * second[2] - second[1] * second[1]));
    const double mean = fabs(e * second[2] - 2 * f * second[1] + g * second[0]) / 2;
    seen[TAUT_BONNET_ISOTHERMAL] = (fmax(fabs(e - g), fabs(f)) - at[0].noise) / e;
    seen[TAUT_BONNET_HARMONIC] = (taut_length(q) - at[1].noise) / most;
    seen[TAUT_BONNET_MINIMAL] =
        (mean / area - 0.5 * (at[1].noise + at[0].noise / e * root_2 * second_size)) / bend;
    for (int k = 0; k < TAUT_BONNET_PROVED; k++) {
        seen[k] = seen[k] > 0 ? seen[k] : 0; /* NaN: nothing was seen */
    }
    return 2 * mean / e;
}

/* |W_u.W_u| from below and above. */
typedef struct range {
    double low, high;
} range;

/* What the bound of |H|/sqrt|K| is made of. */
typedef struct bending {
    amount x, q, t;            /* |W.W|, |r_uu + r_vv|, |W_u.W| */
    double e, wu;              /* below E, above |W_u| */
    range hopf;                /* |W_u.W_u| */
    double middle;             /* |E N - 2 F M + G L| / E in the middle, and its error */
    double x_middle, q_middle; /* |W.W|, |r_uu + r_vv| there */
    double e_middle;           /* E there */
    double varied, varied_u;   /* of W, of W_u about the middle */
} bending;

/* |E N - 2 F M + G L| / E from the middle: with it = Q.n - Re(W.W conj b)/E, whose parts may cancel,
 * changes by no more than they do. The normals of W and of the middle differ by theta. */
static double from_middle(const bending *f, double bend)
{
    const double part = f->varied / sqrt(f->e_middle);
    const double theta = fmin(2, 4.4 * part + 2.2 * part * part);
    const double e = 2 * part + part * part;
    return f->middle + (f->q.upper - f->q_middle) + f->q_middle * theta +
           (f->x.upper - f->x_middle) / f->e * bend +
           f->x_middle / f->e * (f->varied_u + f->wu * theta + bend * e);
}

static amount mean_amount(const bending *f)
{
    const double eps = f->x.upper / f->e;
    const double along = root_2 * f->wu * (f->t.upper / sqrt(f->e) + 1.2 * eps * f->wu);
    const double bend = sqrt(f->hopf.high + along); /* |L - iM| */
    const double b = f->hopf.low - along - bend * f->q.upper;
    const double root = 2 * sqrt(1 - eps - 0.25 * eps * eps) * sqrt(b);
    if (!(eps <= 0.1) || !(b > 0)) {
        return (amount){INFINITY, INFINITY};
    }
    return (amount){fmin(f->q.upper + eps * bend, from_middle(f, bend)) / root,
                    (f->q.noise + f->x.noise / f->e * bend) / root};
}

static void judge(const taut_bonnet_local *l, judgement *j)
{
    const double rho = taut_hypot(l->bound[0][1], l->bound[1][1]), s = fabs(l->s[0]);
    const double more = s == 0 ? 1 : 1.25; /* sinh(x)/x and (cosh x - 1)/(x^2/2), x^2 <= 5/4 */
    const double bs = more * rho, bc = more * rho * rho / 2;
    table t, q;
    wave w[3];

    fill_w(l, &t);
    fill_laplacian(l, &q);
    for (int d = 0; d < 3; d++) {
        w[d] = wave_of(&t, d, 0);
    }
    take_holomorphic(l, w, &t);

    /* of Phi.Phi: constant, S, C, S C, C^2 */
    const amount a[5] = {dot_amount(1, &w[0], &w[0]), dot_amount(2, &w[0], &w[1]),
                         pair_amount(2, &w[0], &w[2], 2, &w[1], &w[1]), dot_amount(2, &w[1], &w[2]),
                         pair_amount(1, &w[2], &w[2], l->s[0], &w[1], &w[1])};
    const amount off = table_amount(&t, l->bound[0], l->bound[1]);
    const amount off_u = table_amount(&t, l->slope[0], l->bound[1]);
    const amount laplacian = table_amount(&q, l->bound[0], l->bound[1]);
    const double hopf_size = dot_size(1, &w[1], &w[1], 0, &w[1], &w[1]);
    double own[3], varied, varied_u;
    for (int d = 0; d < 3; d++) {
        own[d] = w[d].size + w[d].own;
    }
    varied = own[1] * bs + own[2] * bc;       /* of Phi about w0 */
    varied_u = own[1] * s * bc + own[2] * bs; /* of Phi' about w1 */
    const double phi = own[0] + varied, phi_u = own[1] + varied_u;
    const double low = w[0].size - w[0].own - varied - off.upper;
    const double wu = phi_u + off_u.upper;
    amount x = {0, 0}, slope = {0, 0}, hopf = {0, 0};
    const double by[5] = {1, bs, bc, bs * bc, bc * bc};
    const double by_u[5] = {0, 1 + s * bc, bs, (1 + s * bc) * bc + bs * bs, 2 * bs * bc};
    for (int k = 0; k < 5; k++) {
        x = amount_sum(x, amount_times(by[k], a[k]));
        slope = amount_sum(slope, amount_times(0.5 * by_u[k], a[k]));
    }
    x = amount_sum(x, disturbed(phi, off));
    slope.upper += wu * off.upper + phi * off_u.upper;
    hopf = amount_sum(amount_times(bs * bs, a[4]), amount_times(bs * (1 + s * bc), a[3]));
    hopf = amount_sum(hopf, disturbed(phi_u, off_u));

    const double e = 0.5 * (low * low - x.upper);
    const double wu_low =
        fmax(w[1].size - w[1].own - varied_u,
             sqrt(fmax(0, hopf_size - dot_error(&w[1], w[1].own, &w[1], w[1].own) - hopf.upper))) -
        off_u.upper;
    const double hopf_own = dot_error(&w[1], w[1].own, &w[1], w[1].own);
    const range turn = {hopf_size - hopf_own - hopf.upper, hopf_size + hopf_own + hopf.upper};
    const amount none = {INFINITY, INFINITY};
    j->is_lost[TAUT_BONNET_ISOTHERMAL] = !(w[0].size > 4 * w[0].own);
    j->is_lost[TAUT_BONNET_HARMONIC] = !(w[1].size > 4 * w[1].own);
    j->is_lost[TAUT_BONNET_MINIMAL] =
        j->is_lost[TAUT_BONNET_ISOTHERMAL] ||
        !(hopf_size > 4 * dot_error(&w[1], w[1].own, &w[1], w[1].own));
    j->is_close = low > 0.7 * w[0].size && wu_low > 0.6 * w[1].size;
    j->claim[TAUT_BONNET_ISOTHERMAL] = low > 0 && e > 0 ? amount_times(1 / e, x) : none;
    j->claim[TAUT_BONNET_HARMONIC] = wu_low > 0 ? amount_times(root_2 / wu_low, laplacian) : none;
    const amount middle[3] = {a[0], {0, q.noise[0][0]}, {0, 0}};
    bending bent = {.x = x, .q = laplacian, .t = slope, .e = e, .wu = wu, .hopf = turn};
    bent.middle = see_middle(l, w[1].size, middle, j->seen) + q.own[0][0] +
                  2 * dot_error(&w[0], w[0].own, &w[0], w[0].own) / e * wu;
    bent.x_middle = a[0].upper;
    bent.q_middle = length_of(q.of[0][0]) + q.own[0][0];
    bent.e_middle = taut_dot(l->x[1][0], l->x[1][0]);
    bent.varied = varied + off.upper;
    bent.varied_u = varied_u + off_u.upper;
    j->claim[TAUT_BONNET_MINIMAL] = low > 0 && e > 0 ? mean_amount(&bent) : none;
}

/* A surface being proved. */
typedef struct search {
    const taut_surface *surface;
    const taut_bonnet_scale *scale;
    int unit;
    int64_t cuts, most;               /* pieces cut so far; and how many may be */
    double noise[TAUT_BONNET_PROVED]; /* the largest that rounding explains on a piece */
    int is_measuring;                 /* noise only */
    taut_bonnet_proof proofs[TAUT_BONNET_PROVED];
} search;

static double limit_of(const search *s, int claim)
{
    const double noise = s->noise[claim];
    return noise > 0 ? fmin(allowance * noise, largest_limit) : largest_limit;
}

/* Is the piece to be cut before its noise says anything? */
static int measure(search *s, const judgement *j, int depth)
{
    if (!j->is_close && !j->is_lost[TAUT_BONNET_ISOTHERMAL] && !j->is_lost[TAUT_BONNET_HARMONIC] &&
        depth < DEPTH && s->cuts < s->most) {
        return 1;
    }
    for (int c = 0; c < TAUT_BONNET_PROVED; c++) {
        if (isfinite(j->claim[c].noise)) {
            s->noise[c] = fmax(s->noise[c], j->claim[c].noise);
        }
    }
    return 0;
}

static void tell(search *s, int claim, taut_verdict holds, double residual,
                 const taut_bonnet_piece *piece, const char *why)
{
    s->proofs[claim] = (taut_bonnet_proof){.holds = holds,
                                           .residual = residual,
                                           .limit = limit_of(s, claim),
                                           .at = {piece->middle[0], piece->middle[1]},
                                           .why = why};
}

/* Is the piece to be cut for this claim? Where it is settled, or cutting settles nothing, it is
 * told, where it is worst. */
static int settle(search *s, int claim, const judgement *j, const taut_bonnet_piece *piece,
                  int depth)
{
    const taut_bonnet_proof *p = &s->proofs[claim];
    const amount a = j->claim[claim];
    const double seen = j->seen[claim], limit = limit_of(s, claim);
    const double noise = isfinite(a.noise) ? allowance * a.noise : 0;

    if (isfinite(a.upper) && a.upper <= limit) {
        if (p->holds == TAUT_TRUE && !(a.upper <= p->residual)) {
            tell(s, claim, TAUT_TRUE, a.upper, piece, NULL);
        }
        return 0;
    }
    if (isfinite(seen) && seen > limit && seen > noise) {
        if (p->holds != TAUT_FALSE || seen > p->residual) {
            tell(s, claim, TAUT_FALSE, seen, piece, NULL);
        }
        return 0;
    }
    if (p->holds == TAUT_FALSE) {
        return 0;
    }
    if (!j->is_lost[claim] &&
        (!isfinite(a.upper) || !j->is_close || a.upper > 1.5 * (seen + a.noise)) && depth < DEPTH &&
        s->cuts < s->most) {
        return 1;
    }
    if (p->holds == TAUT_TRUE || (isfinite(a.upper) && a.upper > p->residual)) {
        tell(s, claim, TAUT_UNDECIDED, a.upper, piece,
             !isfinite(a.upper) ? "warning: no bound could be separated from 0"
             : a.upper <= noise ? "warning: rounding alone may leave as much"
                                : "warning: the bound does not separate it from its limit");
    }
    return 0;
}

/* Quarters, or halves of a piece twice as long as wide. */
static void judge_piece(search *s, const taut_bonnet_piece *piece, int depth)
{
    taut_bonnet_local local;
    judgement j;
    int cut = 0;

    taut_bonnet_local_of(s->surface, s->scale, s->unit, piece, &local);
    judge(&local, &j);
    cut = s->is_measuring && measure(s, &j, depth);
    for (int k = 0; k < TAUT_BONNET_PROVED && !s->is_measuring; k++) {
        cut |= settle(s, k, &j, piece, depth);
    }
    if (!cut) {
        return;
    }
    s->cuts++;
    const int along[2] = {2 * piece->half[0] > piece->half[1], 2 * piece->half[1] > piece->half[0]};
    for (int k = 0; k < 4; k++) {
        taut_bonnet_piece part = *piece;
        const int side[2] = {k % 2, k / 2};
        if ((side[0] && !along[0]) || (side[1] && !along[1])) {
            continue;
        }
        for (int d = 0; d < 2; d++) {
            if (along[d]) {
                part.half[d] = 0.5 * piece->half[d];
                part.middle[d] += side[d] ? part.half[d] : -part.half[d];
            }
        }
        judge_piece(s, &part, depth + 1);
    }
}

/* On bases that no such surface is told in nothing is proved, but a place can tell that it is none. */
static void refute(search *s)
{
    enum { LINES = 9 };
    const taut_basis *bases[2] = {taut_surface_u(s->surface), taut_surface_v(s->surface)};

    for (int c = 0; c < TAUT_BONNET_PROVED; c++) {
        s->noise[c] = INFINITY; /* the limit is the largest there is */
    }
    for (int k = 0; k < LINES * LINES; k++) {
        const int step[2] = {k / LINES, k % LINES};
        taut_bonnet_piece piece = {{0, 0}, {0, 0}, {0, 0}};
        judgement j = {.is_lost = {1, 1, 1}};
        taut_bonnet_local l;
        double x[6][3];
        for (int d = 0; d < 2; d++) {
            const double lo = taut_basis_lo(bases[d]), width = taut_basis_hi(bases[d]) - lo;
            piece.middle[d] = lo + width * (step[d] + 0.5) / LINES;
        }
        (void)taut_surface_eval(s->surface, piece.middle[0], piece.middle[1], 2, &x[0][0]);
        memcpy(l.x[1][0], x[TAUT_XU], sizeof x[0]);
        memcpy(l.x[0][1], x[TAUT_XV], sizeof x[0]);
        memcpy(l.x[2][0], x[TAUT_XUU], sizeof x[0]);
        memcpy(l.x[1][1], x[TAUT_XUV], sizeof x[0]);
        memcpy(l.x[0][2], x[TAUT_XVV], sizeof x[0]);
        /* no errors are known here: only what is far above any rounding tells */
        const double e = taut_dot(x[TAUT_XU], x[TAUT_XU]) + taut_dot(x[TAUT_XV], x[TAUT_XV]);
        const double width = fmin(taut_basis_hi(bases[0]) - taut_basis_lo(bases[0]),
                                  taut_basis_hi(bases[1]) - taut_basis_lo(bases[1]));
        const amount at[3] = {{0, 1e-9 * e}, {0, 1e-9 * sqrt(e) / width}, {0, 0}};
        (void)see_middle(&l, 0, at, j.seen);
        for (int c = 0; c < TAUT_BONNET_PROVED; c++) {
            j.claim[c] = (amount){INFINITY, INFINITY};
            (void)settle(s, c, &j, &piece, DEPTH);
            if (s->proofs[c].holds == TAUT_UNDECIDED) {
                s->proofs[c].why = "warning: such surfaces are not written in its bases,";
            }
        }
    }
}

/* The limits come first, the same for the whole surface: from the largest noise of pieces on which
 * the bounds are about what they are on a point. */
static void prove_pieces(search *s)
{
    const taut_bonnet_cuts cuts = taut_bonnet_cuts_of(s->surface);

    for (s->is_measuring = 1; s->is_measuring >= 0; s->is_measuring--) {
        s->cuts = 0;
        for (int c = 0; c < TAUT_BONNET_PROVED; c++) {
            s->proofs[c].limit = limit_of(s, c);
        }
        for (int i = 0; i < cuts.count[0]; i++) {
            for (int k = 0; k < cuts.count[1]; k++) {
                const taut_bonnet_piece piece = taut_bonnet_piece_at(s->surface, &cuts, i, k);
                s->most = s->cuts + CUTS_OF_PIECE < CUTS ? s->cuts + CUTS_OF_PIECE : CUTS;
                judge_piece(s, &piece, 0);
            }
        }
    }
}

/* Is a proof of one surface weaker than that of those before? */
static int is_weaker(const taut_bonnet_proof *one, const taut_bonnet_proof *all)
{
    static const int ranks[] = {[TAUT_TRUE] = 0, [TAUT_UNDECIDED] = 1, [TAUT_FALSE] = 2};
    if (one->holds != all->holds) {
        return ranks[one->holds] > ranks[all->holds];
    }
    return all->limit == 0 || one->residual / one->limit > all->residual / all->limit;
}

void taut_bonnet_proof_init(taut_bonnet_proof proofs[TAUT_BONNET_PROVED])
{
    for (int k = 0; k < TAUT_BONNET_PROVED; k++) {
        proofs[k] = (taut_bonnet_proof){.holds = TAUT_TRUE};
    }
}

int taut_bonnet_prove(const taut_surface *surface, const taut_bonnet_scale *scale, int unit,
                      taut_bonnet_proof proofs[TAUT_BONNET_PROVED])
{
    search s = {.surface = surface, .scale = scale, .unit = unit};
    double sign[2];
    int told = 0;

    taut_bonnet_proof_init(s.proofs);
    if (!taut_bonnet_sign_of(taut_surface_u(surface), &sign[0]) ||
        !taut_bonnet_sign_of(taut_surface_v(surface), &sign[1]) || sign[0] != -sign[1]) {
        refute(&s);
    } else {
        prove_pieces(&s);
    }
    for (int k = 0; k < TAUT_BONNET_PROVED; k++) {
        if (is_weaker(&s.proofs[k], &proofs[k])) {
            proofs[k] = s.proofs[k];
            told |= 1 << k;
        }
    }
    return told;
}
