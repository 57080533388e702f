/* recognise.c -- lambda, theta, scale and place of a net of the family; taut/recognise.h has the
 * formulas.
 *
 *   1. Phi' = r_x - i r_y, Phi'' = r_xx - i r_xy, Phi''' = r_xxx - i r_xxy at one point give
 *      A = Phi' + Phi''',  B + D = -Phi'',  B - D = i Phi'''.
 *   2. The invariants of A, B, D give scale, theta and lambda; |B|/|D| and the angle of A.conj(B)
 *      how the window is shifted; what is left is a rotation.
 *   3. The surface that this describes is compared with the net on a grid. Of several points in 1,
 *      for coefficients drown where cosh y is large, the one that fits best is taken.
 *
 * The limit lambda = 1 is Enneper's surface, whose net is bicubic: harmonic and isothermal,
 * Phi' = a + b z + c z^2 with Phi'.Phi' = 0 is (p^2 - q^2, i (p^2 + q^2), 2 p q) up to rotation, p
 * and q linear in z; a unitary change of p and q, which turns the surface, makes p constant. So it
 * is Enneper's surface in parameters z / L, times a scale s, and
 *
 *     |b.b| = 4 s^2 / L^4,    |c| = sqrt(2) s / L^3
 */
#include "taut/recognise.h"

#include "core/constants.h"
#include "core/elementary/complex.h"
#include "core/fail.h"
#include "core/vec3.h"
#include "taut/measure.h"

#include <math.h>
#include <stdint.h>
#include <string.h>

enum { TRIES = 5, GRID = 9, SIDE = 8 };
static const double close_enough = 1e-9;

typedef double complex vector[3];

static double complex dot(const vector a, const vector b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static double complex dot_conjugate(const vector a, const vector b)
{
    return a[0] * conj(b[0]) + a[1] * conj(b[1]) + a[2] * conj(b[2]);
}

static double length(const vector a)
{
    return sqrt(creal(dot_conjugate(a, a)));
}

/* Phi', Phi'', Phi''' at (x, y): x runs along u, or along v where turned. Four functions alive in
 * each direction. */
static void phi_of(const taut_surface *surface, int turned, const double at[2],
                   double complex phi[3][3])
{
    static const int orders[3][2][2] = {{{1, 0}, {0, 1}}, {{2, 0}, {1, 1}}, {{3, 0}, {2, 1}}};
    const taut_basis *bases[2] = {taut_surface_u(surface), taut_surface_v(surface)};
    const int columns = taut_basis_count(bases[1]);
    double values[2][4][4];
    int first[2];

    for (int d = 0; d < 2; d++) {
        const double t = at[turned ? 1 - d : d];
        const int span = taut_basis_span(bases[d], t);
        first[d] = taut_basis_first(bases[d], span);
        taut_basis_eval(bases[d], span, t, 3, &values[d][0][0]);
    }
    memset(phi, 0, sizeof(double complex[3][3]));
    for (int k = 0; k < 6; k++) {
        const int *order = orders[k / 2][k % 2];
        const int du = order[turned ? 1 : 0], dv = order[turned ? 0 : 1];
        for (int i = 0; i < 16; i++) {
            const double f = values[0][du][i / 4] * values[1][dv][i % 4];
            const double *p = taut_surface_points(surface) +
                              3 * ((int64_t)(first[0] + i / 4) * columns + first[1] + i % 4);
            for (int c = 0; c < 3; c++) {
                phi[k / 2][c] += (k % 2 == 0 ? 1 : -I) * f * p[c];
            }
        }
    }
}

/* r_theta of sign - at zeta; lambda in (0, 1) or 0, w with it. */
static void family_point(const taut_family_member *m, double w, double x, double y, double r[3])
{
    const double l = m->lambda, c = taut_cos(m->theta), s = taut_sin(m->theta);
    const double one[3] = {(l * x - taut_sin(x) * taut_cosh(y)) / w,
                           (y - l * taut_cos(x) * taut_sinh(y)) / w, -taut_cos(x) * taut_cosh(y)};
    const double two[3] = {(l * y - taut_cos(x) * taut_sinh(y)) / w,
                           -(x - l * taut_sin(x) * taut_cosh(y)) / w, taut_sin(x) * taut_sinh(y)};
    for (int k = 0; k < 3; k++) {
        r[k] = c * one[k] + s * two[k];
    }
}

static void move_point(const taut_family_member *m, double w, const double at[2], double moved[3])
{
    double r[3];
    family_point(m, w, at[0] + m->shift[0], at[1] + m->shift[1], r);
    for (int k = 0; k < 3; k++) {
        const double *row = m->motion[k];
        moved[k] = m->scale * (taut_dot(row, r)) + row[3];
    }
}

/* The columns of the rotation. Turned back by theta, the shift and the scale, A = (lambda, -i,
 * 0)/w, B + D = (0, 0, -1) and B - D = (i, lambda, 0)/w. */
static int rotation_of(const vector a, const vector b, const vector d, double w,
                       taut_family_member *m)
{
    const double complex turn = taut_cexp(I * m->theta) / m->scale;
    const double complex shift = taut_cexp(I * (m->shift[0] + I * m->shift[1]));
    const double complex back = taut_cexp(-I * (m->shift[0] + I * m->shift[1]));
    double column[3][3], defect = 0, volume = 0;

    for (int k = 0; k < 3; k++) {
        const double complex bk = turn * b[k] * back, dk = turn * d[k] * shift;
        column[0][k] = w * cimag(bk - dk);
        column[1][k] = -w * cimag(turn * a[k]);
        column[2][k] = -creal(bk + dk);
    }
    for (int i = 0; i < 3; i++) {
        const double *p = column[i], *q = column[(i + 1) % 3];
        defect = fmax(defect, fabs(taut_dot(p, p) - 1));
        defect = fmax(defect, fabs(taut_dot(p, q)));
        volume += column[0][i] * (column[1][(i + 1) % 3] * column[2][(i + 2) % 3] -
                                  column[1][(i + 2) % 3] * column[2][(i + 1) % 3]);
    }
    for (int i = 0; i < 3; i++) {
        for (int k = 0; k < 3; k++) {
            m->motion[k][i] = volume < 0 ? -column[i][k] : column[i][k];
        }
    }
    if (volume < 0) {
        m->theta += m->theta > 0 ? -TAUT_PI : TAUT_PI;
    }
    return defect <= 1e-6;
}

/* Steps 1 and 2 at one point; 0 where the coefficients belong to no member. */
static int describe_at(const taut_surface *surface, const double at[2], double *w,
                       taut_family_member *m)
{
    vector phi[3], a, b, d;
    phi_of(surface, m->turned, at, phi);
    for (int k = 0; k < 3; k++) {
        a[k] = phi[0][k] + phi[2][k];
        b[k] = 0.5 * (-phi[1][k] + I * phi[2][k]);
        d[k] = 0.5 * (-phi[1][k] - I * phi[2][k]);
    }
    const double product = length(b) * length(d);
    const double complex ab = dot_conjugate(a, b), aa = dot(a, a);
    if (!(product > 0) || !(taut_cabs(aa) > 0) || !isfinite(product)) {
        return 0;
    }
    const double w2 = taut_cabs(dot(b, d)) / product;
    const double along = sqrt(taut_cabs(ab) * taut_cabs(dot_conjugate(a, d))) / (2 * product);
    if (!(w2 > 0) || !(w2 <= 1 + 1e-6)) {
        return 0;
    }
    m->lambda = w2 < 0.5 ? sqrt(1 - w2) : along;
    *w = w2 < 0.5 ? sqrt(w2) : sqrt((1 - along) * (1 + along));
    m->scale = sqrt(taut_cabs(aa));
    m->theta = -0.5 * taut_carg(-aa);
    m->shift[0] = taut_cabs(ab) > 0 ? -taut_carg(I * ab) - at[0] : 0;
    m->shift[1] = -0.5 * taut_log(length(b) / length(d)) - at[1];
    /* the phases of B and D are those at `at`: bring them to zeta - shift = 0 */
    const double complex back = taut_cexp(-I * (at[0] + I * at[1]));
    const double complex on = taut_cexp(I * (at[0] + I * at[1]));
    for (int k = 0; k < 3; k++) {
        b[k] *= back;
        d[k] *= on;
    }
    return isfinite(m->shift[1]) && rotation_of(a, b, d, *w, m);
}

static double parameter_at(const taut_basis *basis, int k, int steps)
{
    const double lo = taut_basis_lo(basis), hi = taut_basis_hi(basis);
    return k == steps ? hi : lo + (hi - lo) * k / steps;
}

/* Step 3: the residual, with the translation that makes the point `at` agree. */
static void compare_with_net(const taut_surface *surface, const double at[2], double w,
                             taut_family_member *m)
{
    const taut_basis *bases[2] = {taut_surface_u(surface), taut_surface_v(surface)};
    double apart = 0, box[2][3] = {{0}}, r[3];

    for (int k = -1; k < (GRID + 1) * (GRID + 1); k++) {
        const double uv[2] = {k < 0 ? at[m->turned] : parameter_at(bases[0], k / (GRID + 1), GRID),
                              k < 0 ? at[1 - m->turned]
                                    : parameter_at(bases[1], k % (GRID + 1), GRID)};
        const double xy[2] = {uv[m->turned], uv[1 - m->turned]};
        double x[3];
        taut_surface_eval(surface, uv[0], uv[1], 0, x);
        move_point(m, w, xy, r);
        for (int c = 0; c < 3; c++) {
            if (k < 0) {
                m->motion[c][3] = x[c] - r[c];
                box[0][c] = box[1][c] = x[c];
            } else {
                apart = fmax(apart, isfinite(r[c]) ? fabs(x[c] - r[c]) : INFINITY);
                box[0][c] = fmin(box[0][c], x[c]);
                box[1][c] = fmax(box[1][c], x[c]);
            }
        }
    }
    m->residual = apart / taut_hypot(box[1][0] - box[0][0],
                                     taut_hypot(box[1][1] - box[0][1], box[1][2] - box[0][2]));
}

static const char *name_of(const taut_family_member *m)
{
    static const char *const names[2][3] = {
        {"catenoid", "helicoid", "associate of the catenoid"},
        {"Bonnet's surface", "Thomsen's surface", "associate of Bonnet's surface"}};
    const double c = fabs(taut_cos(m->theta)), s = fabs(taut_sin(m->theta));
    return names[m->lambda > close_enough][s <= close_enough ? 0 : c <= close_enough ? 1 : 2];
}

static int is_type(const taut_basis *basis, const char *bezier, const char *bspline)
{
    const char *type = taut_basis_type(basis);
    return strcmp(type, bezier) == 0 || strcmp(type, bspline) == 0;
}

static int is_circular(const taut_basis *basis)
{
    return is_type(basis, "c-bezier", "c-bspline");
}

static int is_hyperbolic(const taut_basis *basis)
{
    return is_type(basis, "h-bezier", "h-bspline");
}

static void recognise_member(const taut_surface *surface, int turned, taut_family_member *best)
{
    const taut_basis *bases[2] = {taut_surface_u(surface), taut_surface_v(surface)};
    for (int k = 0; k < TRIES; k++) {
        taut_family_member m = {.turned = turned};
        const double at[2] = {parameter_at(bases[turned], 1, 2),
                              parameter_at(bases[1 - turned], k, TRIES - 1)};
        double w = 1;
        if (describe_at(surface, at, &w, &m)) {
            compare_with_net(surface, at, w, &m);
            if (m.residual < best->residual) {
                *best = m;
            }
        }
    }
    if (best->residual <= close_enough) {
        best->name = name_of(best);
        if (best->lambda <= close_enough) {
            best->lambda = 0;
        }
    }
}

/* Largest of |E-G|/E, |F|/E, |r_uu + r_vv|/|r_uu| on a grid. */
static double defect_of(const taut_surface *surface)
{
    double largest = 0;
    for (int k = 0; k < (SIDE + 1) * (SIDE + 1); k++) {
        const double u = parameter_at(taut_surface_u(surface), k / (SIDE + 1), SIDE);
        const double v = parameter_at(taut_surface_v(surface), k % (SIDE + 1), SIDE);
        double x[6][3], sum[3];
        taut_forms f;
        taut_surface_eval(surface, u, v, 2, &x[0][0]);
        taut_forms_of((const double(*)[3])x, &f);
        for (int c = 0; c < 3; c++) {
            sum[c] = x[TAUT_XUU][c] + x[TAUT_XVV][c];
        }
        const double second = fmax(taut_length(x[TAUT_XUU]), taut_length(x[TAUT_XUV]));
        const double here = fmax(fmax(fabs(f.e - f.g), fabs(f.f)) / f.e, taut_length(sum) / second);
        largest = here <= largest ? largest : here;
        if (!(here <= 1)) { /* infinite or NaN too: a point, a line, a plane in affine parameters */
            return INFINITY;
        }
    }
    return largest;
}

/* A bicubic net without weights; residual stays infinite where it cannot be Enneper's surface. */
static void recognise_enneper(const taut_surface *surface, taut_family_member *member)
{
    const taut_basis *u = taut_surface_u(surface), *v = taut_surface_v(surface);
    const double at[2] = {0.5 * (taut_basis_lo(u) + taut_basis_hi(u)),
                          0.5 * (taut_basis_lo(v) + taut_basis_hi(v))};
    const double defect = defect_of(surface);
    double complex phi[3][3], bb = 0;
    double cc = 0, b2 = 0;

    phi_of(surface, 0, at, phi);
    for (int k = 0; k < 3; k++) {
        bb += phi[1][k] * phi[1][k];
        b2 += creal(phi[1][k] * conj(phi[1][k]));
        cc += 0.25 * creal(phi[2][k] * conj(phi[2][k]));
    }
    /* a plane conformally mapped has b.b = 0 */
    if (!(taut_cabs(bb) > 1e-6 * b2) || !(cc > 0)) {
        return;
    }
    const double second = 0.5 * sqrt(taut_cabs(bb)), third = sqrt(0.5 * cc), unit = second / third;
    member->name = "Enneper's surface";
    member->scale = second * unit * unit;
    member->lambda = 1;
    member->residual = defect;
}

taut_status taut_surface_recognise(const taut_surface *surface, taut_family_member *member,
                                   taut_error *error)
{
    taut_family_member best = {.residual = INFINITY};

    if (surface == NULL || member == NULL) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, "argument", NULL, taut_none, taut_none,
                         "taut_surface_recognise needs a surface and a place for the answer");
    }
    const taut_basis *u = taut_surface_u(surface), *v = taut_surface_v(surface);
    if (taut_surface_weights(surface) == NULL) {
        if (is_circular(u) && is_hyperbolic(v)) {
            recognise_member(surface, 0, &best);
        } else if (is_hyperbolic(u) && is_circular(v)) {
            recognise_member(surface, 1, &best);
        } else if (taut_basis_degree(u) == 3 && taut_basis_degree(v) == 3) {
            recognise_enneper(surface, &best);
        }
    }
    if (!(best.residual <= close_enough)) {
        return taut_fail(error, TAUT_NO_SOLUTION, "not-in-family", NULL, best.residual,
                         close_enough,
                         "the surface is not a minimal surface with planar curvature lines, or an "
                         "associate of one, on a basis that holds it");
    }
    *member = best;
    return TAUT_OK;
}
