/* contact.c -- the order of contact of two surfaces at one point of a join.
 *
 * C^k compares Taylor coefficients across the edge. G^k writes each surface as a height over the
 * tangent plane of the first: with the frame e1 along the edge, e2 out of the first surface, n its
 * normal, x - x0 = xi e1 + eta e2 + zeta n, the power series xi(s,t), eta(s,t) are inverted and
 * put into zeta: zeta = h(xi, eta). Two regular surfaces have contact of order k, whatever their
 * parameters, when the coefficients of h agree up to order k.
 */
#include "measure/join/side.h"

#include "core/elementary/elementary.h"
#include "core/vec3.h"

#include <float.h>
#include <math.h>

enum { S1 = 1, T1 = 2 }; /* places of s and t in a jet; those of order k begin at k(k+1)/2 */

static double angle_between(const double *a, const double *b)
{
    double c[3];
    taut_cross(a, b, c);
    return taut_atan2(taut_length(c), taut_dot(a, b));
}

static void vector_at(const taut_spot *spot, int k, double *x)
{
    for (int c = 0; c < 3; c++) {
        x[c] = spot->x[c].c[k];
    }
}

/* The first derivatives of a spot, and how well they stand. */
typedef struct tangents {
    double s[3], t[3], normal[3];
    double length_s, length_t;
    double sine; /* of the angle of s and t */
    int regular;
} tangents;

static tangents tangents_of(const taut_spot *spot)
{
    tangents d;
    vector_at(spot, S1, d.s);
    vector_at(spot, T1, d.t);
    taut_cross(d.s, d.t, d.normal);
    d.length_s = taut_length(d.s);
    d.length_t = taut_length(d.t);
    const double w = taut_length(d.normal);
    /* each derivative is good to a few roundings of its bound; 2^-40 as in forms.c */
    const double noise =
        64 * DBL_EPSILON * (d.length_s * spot->bound[T1] + d.length_t * spot->bound[S1]);
    d.sine = w / (d.length_s * d.length_t);
    d.regular = w > noise && d.sine > 0x1p-40;
    return d;
}

/* How large the coefficients of order k of the height could be: those of x over the speeds, the
 * obliqueness of the parameters taken in; at order 3 products of two of order 2 come in too, each
 * with one of them as large as it could be and the other as large as it is. */
static void height_bounds(const taut_spot *spot, const tangents *d, double bound[4])
{
    double second = 0; /* the coefficients of order 2 as they are */
    for (int k = 1; k <= 3; k++) {
        bound[k] = 0;
        for (int i = k * (k + 1) / 2; i < (k + 1) * (k + 2) / 2; i++) {
            const double speeds = taut_pow(d->length_s, taut_jet_power[i][0]) *
                                  taut_pow(d->length_t, taut_jet_power[i][1]);
            double x[3];
            vector_at(spot, i, x);
            bound[k] += spot->bound[i] / speeds;
            second += k == 2 ? taut_length(x) / speeds : 0;
        }
        bound[k] /= taut_pow(d->sine, k);
    }
    bound[3] += 4 * bound[2] * second / (d->sine * d->sine);
}

/* f(s, t) with s and t themselves series without constant terms: a sum over the monomials. */
static taut_jet compose_jets(const taut_jet *f, const taut_jet *s, const taut_jet *t)
{
    taut_jet power[TAUT_JET];
    taut_jet sum = {{f->c[0]}};
    power[0] = (taut_jet){{1}};
    for (int k = 1; k < TAUT_JET; k++) {
        const int i = taut_jet_power[k][0], j = taut_jet_power[k][1];
        power[k] = i > 0 ? taut_jet_multiply(&power[taut_jet_index(i - 1, j)], s)
                         : taut_jet_multiply(&power[taut_jet_index(i, j - 1)], t);
        sum = taut_jet_add(&sum, f->c[k], &power[k]);
    }
    return sum;
}

/* The height of the surface over the plane of e1, e2: solves xi(s,t) = xi, eta(s,t) = eta for s and
 * t by the simplified Newton iteration from 0, which gains an order each time. Lengths along e1 and
 * e2 are taken over the speeds, so that everything is of size 1; returned in (xi, eta). */
static taut_jet height_over(const taut_spot *spot, const double frame[3][3])
{
    taut_jet coordinate[3];
    taut_jet s = {{0}}, t = {{0}};

    for (int r = 0; r < 3; r++) {
        for (int k = 0; k < TAUT_JET; k++) {
            double x[3];
            vector_at(spot, k, x);
            coordinate[r].c[k] = k > 0 ? taut_dot(frame[r], x) : 0;
        }
    }
    const double a = coordinate[0].c[S1], b = coordinate[0].c[T1];
    const double c = coordinate[1].c[S1], d = coordinate[1].c[T1];
    const double det = a * d - b * c;
    for (int order = 1; order <= 3; order++) {
        taut_jet xi = compose_jets(&coordinate[0], &s, &t),
                 eta = compose_jets(&coordinate[1], &s, &t);
        xi.c[S1] -= 1;
        eta.c[T1] -= 1;
        for (int k = 0; k < TAUT_JET; k++) {
            s.c[k] -= (d * xi.c[k] - b * eta.c[k]) / det;
            t.c[k] -= (a * eta.c[k] - c * xi.c[k]) / det;
        }
    }
    return compose_jets(&coordinate[2], &s, &t);
}

/* 0..3. */
static int geometric_order(const taut_spot *a, const tangents *da, const taut_spot *b,
                           const tangents *db)
{
    double frame[3][3], bound_a[4], bound_b[4];
    for (int c = 0; c < 3; c++) {
        frame[0][c] = da->s[c] / da->length_s;
        frame[2][c] = da->normal[c] / taut_length(da->normal);
    }
    taut_cross(frame[2], frame[0], frame[1]);
    if (!(taut_dot(db->t, frame[1]) > 0) || !(taut_dot(db->normal, da->normal) > 0)) {
        return 0; /* a fold, or at right angles */
    }
    const taut_jet ha = height_over(a, (const double(*)[3])frame);
    const taut_jet hb = height_over(b, (const double(*)[3])frame);
    height_bounds(a, da, bound_a);
    height_bounds(b, db, bound_b);
    for (int k = 1; k <= 3; k++) {
        const double limit = taut_join_tolerance * fmax(bound_a[k], bound_b[k]);
        for (int i = k * (k + 1) / 2; i < (k + 1) * (k + 2) / 2; i++) {
            if (!(fabs(ha.c[i] - hb.c[i]) <= limit)) {
                return k - 1;
            }
        }
    }
    return 3;
}

/* 0..3: coefficients of t^k. */
static int parametric_order(const taut_spot *a, const taut_spot *b)
{
    for (int k = 1; k <= 3; k++) {
        const int i = taut_jet_index(0, k);
        const double limit = taut_join_tolerance * fmax(a->bound[i], b->bound[i]);
        for (int c = 0; c < 3; c++) {
            if (!(fabs(a->x[c].c[i] - b->x[c].c[i]) <= limit)) {
                return k - 1;
            }
        }
    }
    return 3;
}

taut_join_contact taut_join_contact_of(const taut_spot *a, const taut_spot *b)
{
    const tangents da = tangents_of(a), db = tangents_of(b);
    taut_join_contact contact = {parametric_order(a, b), 3, nan(""), nan("")};

    if (da.length_t > 64 * DBL_EPSILON * a->bound[T1] &&
        db.length_t > 64 * DBL_EPSILON * b->bound[T1]) {
        contact.tangent_angle = angle_between(da.t, db.t);
    }
    if (da.regular && db.regular) {
        contact.normal_angle = angle_between(da.normal, db.normal);
        contact.g = geometric_order(a, &da, b, &db);
    }
    return contact;
}
