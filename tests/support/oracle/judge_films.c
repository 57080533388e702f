/* judge_films.c -- judges of films between held edges and cables, E = area + sum of r L, r the force
 * of a cable over the tension of the film (docs/film.md).
 *
 *     held, cables  corners, and the numbers of curves and edges, bit for bit
 *     boundary      an edge against its chord, or its Bezier curve, at places
 *     stationary    dE by the own integrals of dA and dL: inside along the moment of a point's
 *                   function, across the tangent of a cable, and of all coordinates as far as they
 *                   count
 *     stable        (E(x + h d) - 2 E(x) + E(x - h d)) / h^2 over the norm of d, of a few smooth moves d
 */
#include "oracle/oracle.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum {
    NODES = 7,
    NODES_EDGE = 40, /* of cables, whose slope may dip to a tenth: 20 were off by 3e-9 there */
    PLACES = 33,
    TRIALS = 6,
    CURVE_MAX = 24,
    COUNT_MOST = 60,
    SPANS_MOST = 16 /* what more costs is not worth it */
};

static const char *const edge_names[4] = {"u0", "u1", "v0", "v1"};
static const char *const corner_names[4] = {"u0v0", "u1v0", "u0v1", "u1v1"};

/* The rows of a basis at the nodes of all its spans. */
typedef struct nodes {
    int count;
    oracle_row *row;
    oracle_real *weight;
} nodes;

typedef struct film {
    oracle_sheet sheet;
    const taut_record *edges[4];
    oracle_real ratio[4]; /* 0: held */
    oracle_real size;     /* largest coordinate difference from the first point */
    nodes u, v;
} film;

static int take_nodes(const oracle_basis *basis, int each, nodes *n)
{
    oracle_real at[NODES_EDGE], weight[NODES_EDGE];

    oracle_gauss(each, at, weight);
    n->count = each * basis->spans;
    n->row = calloc((size_t)n->count, sizeof *n->row);
    n->weight = calloc((size_t)n->count, sizeof *n->weight);
    for (int k = 0; n->row != NULL && n->weight != NULL && k < n->count; k++) {
        const oracle_real lo = basis->breaks[k / each], width = basis->breaks[k / each + 1] - lo;
        oracle_basis_row(basis, k / each, lo + width * at[k % each], 1, &n->row[k]);
        n->weight[k] = width * weight[k % each];
    }
    return n->row != NULL && n->weight != NULL;
}

static void film_free(film *f)
{
    free(f->u.row);
    free(f->u.weight);
    free(f->v.row);
    free(f->v.weight);
    oracle_sheet_free(&f->sheet);
}

static int film_of(const oracle_case *about, const taut_model *model, int each, film *f)
{
    const taut_record *edges = taut_record_get(about->problem, "edges");
    const double tension = oracle_number(taut_record_get(about->problem, "tension"));
    const oracle_case of = {about->construct,   model,          about->problem, about->honest,
                            about->honest_area, about->by_place};

    memset(f, 0, sizeof *f);
    if (about->problem == NULL || !oracle_sheet_of(oracle_subject(&of, 0), &f->sheet)) {
        return 0;
    }
    for (int e = 0; e < 4; e++) {
        f->edges[e] = taut_record_get(edges, edge_names[e]);
        const taut_record *cable = taut_record_get(f->edges[e], "cable");
        if (cable != NULL) {
            f->ratio[e] = (oracle_real)oracle_number(taut_record_get(cable, "force")) /
                          (tension > 0 ? tension : 1);
        }
    }
    for (int k = 0; k < 3 * f->sheet.u.count * f->sheet.v.count; k++) {
        f->size = fmaxl(f->size, fabsl((oracle_real)f->sheet.points[k] - f->sheet.points[k % 3]));
    }
    if (f->sheet.weights != NULL || f->sheet.u.type != 'p' || f->sheet.v.type != 'p' ||
        f->sheet.u.count > COUNT_MOST || f->sheet.v.count > COUNT_MOST ||
        (each > 0 && f->sheet.u.spans * f->sheet.v.spans > SPANS_MOST) || !(f->size > 0) ||
        (each > 0 &&
         !(take_nodes(&f->sheet.u, each, &f->u) && take_nodes(&f->sheet.v, each, &f->v)))) {
        film_free(f);
        return 0;
    }
    return 1;
}

/* Point k of edge e is number first + k step. */
static int edge_of(const film *f, int e, int *first, int *step)
{
    const int nu = f->sheet.u.count, nv = f->sheet.v.count;
    *first = e == 1 ? (nu - 1) * nv : e == 3 ? nv - 1 : 0;
    *step = e < 2 ? 1 : nv;
    return e < 2 ? nv : nu;
}

static int corner_at(const film *f, int c)
{
    return c % 2 * (f->sheet.u.count - 1) * f->sheet.v.count + c / 2 * (f->sheet.v.count - 1);
}

/* ---- edges ---- */

double oracle_film_held(const oracle_case *about)
{
    const taut_record *corners = taut_record_get(about->problem, "corners");
    oracle_real worst = 0;
    film f;

    if (!film_of(about, about->model, 0, &f)) {
        return NAN;
    }
    for (int c = 0; c < 4; c++) {
        double p[3];
        if (oracle_point(taut_record_get(corners, corner_names[c]), p)) {
            for (int k = 0; k < 3; k++) {
                worst = fmaxl(worst,
                              fabsl((oracle_real)f.sheet.points[3 * corner_at(&f, c) + k] - p[k]));
            }
        }
    }
    worst /= f.size;
    film_free(&f);
    return (double)worst;
}

double oracle_film_cables(const oracle_case *about)
{
    int differ = 0;
    film f;

    if (!film_of(about, about->model, 0, &f)) {
        return NAN;
    }
    for (int e = 0; e < 4; e++) {
        const taut_curve *curve = oracle_curve(about->model, edge_names[e]);
        int first, step;
        const int n = edge_of(&f, e, &first, &step);
        if (!(f.ratio[e] > 0)) {
            continue;
        }
        if (curve == NULL || taut_basis_count(taut_curve_t(curve)) != n) {
            differ++;
            continue;
        }
        for (int k = 0; k < 3 * n; k++) {
            differ +=
                taut_curve_points(curve)[k] != f.sheet.points[3 * (first + k / 3 * step) + k % 3];
        }
    }
    film_free(&f);
    return differ;
}

/* The Bezier curve of a document at t, by de Casteljau's triangle; 0: it is none. */
static int curve_at(const taut_record *curve, oracle_real t, oracle_real x[3])
{
    const taut_record *points = taut_record_get(curve, "points"),
                      *weights = taut_record_get(curve, "weights");
    const int n = (int)taut_record_count(points);
    oracle_real h[CURVE_MAX][4];

    if (strcmp(taut_record_text(taut_record_get(taut_record_get(curve, "t"), "type")), "bezier") !=
            0 ||
        n > CURVE_MAX || n < 2) {
        return 0;
    }
    for (int i = 0; i < n; i++) {
        double p[3];
        if (!oracle_point(taut_record_at(points, (size_t)i), p)) {
            return 0;
        }
        h[i][3] = weights != NULL ? oracle_number(taut_record_at(weights, (size_t)i)) : 1;
        for (int k = 0; k < 3; k++) {
            h[i][k] = h[i][3] * p[k];
        }
    }
    for (int m = n - 1; m > 0; m--) {
        for (int i = 0; i < m; i++) {
            for (int k = 0; k < 4; k++) {
                h[i][k] = (1 - t) * h[i][k] + t * h[i + 1][k];
            }
        }
    }
    for (int k = 0; k < 3; k++) {
        x[k] = h[0][k] / h[0][3];
    }
    return 1;
}

static oracle_real edge_apart(const film *f, int e)
{
    const taut_record *curve = taut_record_get(f->edges[e], "fixed");
    const oracle_basis *t = e < 2 ? &f->sheet.v : &f->sheet.u;
    const double *p = f->sheet.points;
    const int a = corner_at(f, e < 2 ? e : 2 * (e - 2)),
              b = corner_at(f, e < 2 ? e + 2 : 2 * e - 3);
    oracle_real worst = 0;

    for (int i = 0; i < PLACES; i++) {
        const oracle_real s = (oracle_real)i / (PLACES - 1), at = t->lo * (1 - s) + t->hi * s;
        oracle_real x[6][3], wanted[3], apart[3];
        oracle_sheet_eval(&f->sheet,
                          e == 0   ? f->sheet.u.lo
                          : e == 1 ? f->sheet.u.hi
                                   : at,
                          e == 2   ? f->sheet.v.lo
                          : e == 3 ? f->sheet.v.hi
                                   : at,
                          0, x);
        for (int k = 0; k < 3; k++) {
            wanted[k] = (1 - s) * p[3 * a + k] + s * p[3 * b + k];
        }
        if (curve != NULL && !curve_at(curve, s, wanted)) {
            return 0;
        }
        for (int k = 0; k < 3; k++) {
            apart[k] = x[0][k] + f->sheet.middle[k] - wanted[k];
        }
        worst = fmaxl(worst, oracle_norm(apart));
    }
    return worst / f->size;
}

/* The limit of a curve is its own fit's: all straight edges, or one edge alone, are judged. */
double oracle_film_boundary(const oracle_case *about)
{
    oracle_real worst = 0;
    int held = 0, curves = 0;
    film f;

    if (!film_of(about, about->model, 0, &f)) {
        return NAN;
    }
    for (int e = 0; e < 4; e++) {
        if (!(f.ratio[e] > 0)) {
            worst = fmaxl(worst, edge_apart(&f, e));
            held++;
            curves += taut_record_get(f.edges[e], "fixed") != NULL;
        }
    }
    film_free(&f);
    return curves > 0 && held > 1 ? NAN : (double)worst;
}

/* ---- at rest ---- */

static void edge_slope(const film *f, int e, const oracle_row *row, oracle_real d[3])
{
    int first, step;

    edge_of(f, e, &first, &step);
    d[0] = d[1] = d[2] = 0;
    for (int a = 0; a < row->local; a++) {
        const oracle_real *x = f->sheet.net + 4 * (first + (row->first + a) * step);
        for (int k = 0; k < 3; k++) {
            d[k] += row->n[1][a] * x[k];
        }
    }
}

static void add_cable(const film *f, int e, oracle_real *gradient)
{
    const nodes *n = e < 2 ? &f->v : &f->u;
    int first, step;

    edge_of(f, e, &first, &step);
    for (int i = 0; i < n->count; i++) {
        const oracle_row *row = &n->row[i];
        oracle_real d[3];
        edge_slope(f, e, row, d);
        const oracle_real speed = oracle_norm(d);
        for (int a = 0; a < row->local; a++) {
            for (int k = 0; k < 3; k++) {
                gradient[3 * (first + (row->first + a) * step) + k] +=
                    f->ratio[e] * n->weight[i] * row->n[1][a] * d[k] / speed;
            }
        }
    }
}

/* iint N_a x_u x x_v du dv. */
static void find_moments(const film *f, oracle_real *moments)
{
    for (int i = 0; i < f->u.count; i++) {
        for (int j = 0; j < f->v.count; j++) {
            const oracle_row *u = &f->u.row[i], *v = &f->v.row[j];
            oracle_real x[6][3], n[3];
            oracle_sheet_at(&f->sheet, u, v, 1, x);
            oracle_cross(x[1], x[2], n);
            for (int a = 0; a < u->local; a++) {
                for (int b = 0; b < v->local; b++) {
                    for (int k = 0; k < 3; k++) {
                        moments[3 * ((u->first + a) * f->sheet.v.count + v->first + b) + k] +=
                            f->u.weight[i] * f->v.weight[j] * u->n[0][a] * v->n[0][b] * n[k];
                    }
                }
            }
        }
    }
}

/* The tangent of edge e at the mean of the inner knots of function k; unit. */
static void tangent_of(const film *f, int e, int k, oracle_real t[3])
{
    const oracle_basis *basis = e < 2 ? &f->sheet.v : &f->sheet.u;
    oracle_real at = 0;
    oracle_row row;

    for (int i = 1; i <= basis->degree; i++) {
        at += (oracle_real)basis->knots[k + i] / basis->degree;
    }
    at = fminl(fmaxl(at, basis->lo), basis->hi);
    oracle_basis_row(basis, oracle_basis_span(basis, at), at, 1, &row);
    edge_slope(f, e, &row, t);
    const oracle_real size = oracle_norm(t);
    for (int i = 0; i < 3; i++) {
        t[i] /= size;
    }
}

/* Which edge point (i, j) is on: -1 inside, -2 a corner or held. */
static int place_of(const film *f, int i, int j)
{
    const int on_u = i == 0 ? 0 : i == f->sheet.u.count - 1 ? 1 : -1;
    const int on_v = j == 0 ? 2 : j == f->sheet.v.count - 1 ? 3 : -1;
    const int e = on_u >= 0 ? on_u : on_v;
    return on_u >= 0 && on_v >= 0 ? -2 : e >= 0 && !(f->ratio[e] > 0) ? -2 : e;
}

static oracle_real largest_of(const oracle_real g[3])
{
    return fmaxl(fabsl(g[0]), fmaxl(fabsl(g[1]), fabsl(g[2])));
}

/* The residual of one point, at least. */
static oracle_real residual_of(const film *f, int i, int j, const oracle_real g[3],
                               const oracle_real moment[3], oracle_real area, oracle_real share)
{
    const int e = place_of(f, i, j);
    oracle_real along = 0;

    if (e == -2) {
        return 0;
    }
    if (e == -1) {
        const oracle_real size = oracle_norm(moment);
        along = size > 0 ? fabsl(oracle_dot(g, moment)) / size : 0;
        return fmaxl(along, share * largest_of(g)) / area;
    }
    oracle_real t[3], across[3];
    tangent_of(f, e, e < 2 ? j : i, t);
    for (int k = 0; k < 3; k++) {
        across[k] = g[k] - oracle_dot(g, t) * t[k];
    }
    along = oracle_norm(across) / sqrtl(2); /* of two moves at right angles the larger */
    return fmaxl(along, share * largest_of(g)) / fmaxl(area, f->ratio[e]);
}

static double find_rest(const film *f, double tolerance)
{
    const int n = f->sheet.u.count * f->sheet.v.count, nv = f->sheet.v.count;
    oracle_real *gradient = calloc(3 * (size_t)n, sizeof *gradient);
    oracle_real *moments = calloc(3 * (size_t)n, sizeof *moments);
    oracle_real error = INFINITY, area = 0, worst = 0;
    double found = NAN;

    if (gradient != NULL && moments != NULL && oracle_gradient(&f->sheet, 1, 1, gradient, &error)) {
        find_moments(f, moments);
        for (int i = 0; i < n; i++) {
            area = fmaxl(area, largest_of(gradient + 3 * i));
        }
        for (int e = 0; e < 4; e++) {
            if (f->ratio[e] > 0) {
                add_cable(f, e, gradient);
            }
        }
        for (int i = 0; i < n; i++) {
            worst = fmaxl(worst, residual_of(f, i / nv, i % nv, gradient + 3 * i, moments + 3 * i,
                                             area, tolerance / 1e-6L));
        }
        found = (double)(worst - 4 * error / area);
    }
    free(gradient);
    free(moments);
    return found;
}

/* By the method `normal`, which a model may say that it was found by, moves alone count. */
static int is_by_moves(const oracle_case *about)
{
    const taut_record *method = taut_record_get(taut_model_details(about->model), "method");
    return strcmp(taut_record_text(method), "normal") == 0;
}

static double tolerance_of(const oracle_case *about)
{
    const double asked = oracle_number(taut_record_get(about->problem, "tolerance"));
    return asked > 0 ? asked : 1e-10;
}

double oracle_film_stationary(const oracle_case *about)
{
    film f;

    if (!film_of(about, about->model, NODES_EDGE, &f)) {
        return NAN;
    }
    const double found = find_rest(&f, is_by_moves(about) ? 0 : tolerance_of(about));
    film_free(&f);
    return found;
}

/* ---- stable ---- */

/* Area and r L apart: beside the one the other may have no digits. */
static void energy_of(const film *f, oracle_real parts[2])
{
    parts[0] = parts[1] = 0;
    for (int i = 0; i < f->u.count; i++) {
        for (int j = 0; j < f->v.count; j++) {
            oracle_real x[6][3], n[3];
            oracle_sheet_at(&f->sheet, &f->u.row[i], &f->v.row[j], 1, x);
            oracle_cross(x[1], x[2], n);
            parts[0] += f->u.weight[i] * f->v.weight[j] * oracle_norm(n);
        }
    }
    for (int e = 0; e < 4; e++) {
        const nodes *n = e < 2 ? &f->v : &f->u;
        for (int i = 0; i < n->count && f->ratio[e] > 0; i++) {
            oracle_real d[3];
            edge_slope(f, e, &n->row[i], d);
            parts[1] += f->ratio[e] * n->weight[i] * oracle_norm(d);
        }
    }
}

double oracle_film_energy(const oracle_case *about, const taut_model *model, double *error)
{
    double energy[2] = {NAN, NAN};

    for (int i = 0; i < (error != NULL ? 2 : 1); i++) {
        film f;
        if (!film_of(about, model, i == 0 ? 2 * NODES : NODES, &f)) {
            return NAN;
        }
        oracle_real parts[2];
        energy_of(&f, parts);
        energy[i] = (double)(parts[0] + parts[1]);
        film_free(&f);
    }
    if (error != NULL) {
        *error = fabs(energy[0] - energy[1]);
    }
    return energy[0];
}

/* A smooth move that the energy sees: along moments inside, across the tangents of cables. */
static void make_trial(const film *f, const oracle_real *moments, int trial, oracle_real *d)
{
    static const int waves[TRIALS][2] = {{1, 1}, {2, 1}, {1, 2}, {1, 1}, {1, 1}, {1, 1}};
    const oracle_real pi = 3.14159265358979323846L;
    const int nu = f->sheet.u.count, nv = f->sheet.v.count;

    for (int i = 0; i < nu * nv; i++) {
        const int e = place_of(f, i / nv, i % nv);
        const oracle_real s = sinl(pi * waves[trial][0] * (i / nv) / (nu - 1));
        const oracle_real t = sinl(pi * waves[trial][1] * (i % nv) / (nv - 1));
        oracle_real tangent[3];
        d[3 * i] = d[3 * i + 1] = d[3 * i + 2] = 0;
        if (e == -1) {
            const oracle_real size = oracle_norm(moments + 3 * i);
            for (int k = 0; k < 3 && size > 0; k++) {
                d[3 * i + k] = (trial < 3 ? s * t : 1) * moments[3 * i + k] / size;
            }
        } else if (e >= 0 && trial >= 3) {
            tangent_of(f, e, e < 2 ? i % nv : i / nv, tangent);
            for (int k = 0; k < 3; k++) {
                d[3 * i + k] =
                    (e < 2 ? t : s) * ((k == trial - 3) - tangent[trial - 3] * tangent[k]);
            }
        }
    }
}

static void move_net(film *f, const oracle_real *d, oracle_real by)
{
    for (int i = 0; i < 3 * f->sheet.u.count * f->sheet.v.count; i++) {
        f->sheet.net[4 * (i / 3) + i % 3] += by * d[i];
    }
}

/* iint (n . d)^2 dA + size sum over cables of int |d across|^2 ds. */
static oracle_real norm_of(const film *f, const oracle_real *d)
{
    oracle_real sum = 0;

    for (int i = 0; i < f->u.count; i++) {
        for (int j = 0; j < f->v.count; j++) {
            const oracle_row *u = &f->u.row[i], *v = &f->v.row[j];
            oracle_real x[6][3], n[3], along = 0;
            oracle_sheet_at(&f->sheet, u, v, 1, x);
            oracle_cross(x[1], x[2], n);
            for (int a = 0; a < u->local; a++) {
                for (int b = 0; b < v->local; b++) {
                    along +=
                        u->n[0][a] * v->n[0][b] *
                        oracle_dot(n, d + 3 * ((u->first + a) * f->sheet.v.count + v->first + b));
                }
            }
            sum += f->u.weight[i] * f->v.weight[j] * along * along / oracle_norm(n);
        }
    }
    for (int e = 0; e < 4; e++) {
        const nodes *n = e < 2 ? &f->v : &f->u;
        int first, step;
        edge_of(f, e, &first, &step);
        for (int i = 0; i < n->count && f->ratio[e] > 0; i++) {
            oracle_real t[3], w[3] = {0, 0, 0};
            edge_slope(f, e, &n->row[i], t);
            for (int a = 0; a < n->row[i].local; a++) {
                for (int k = 0; k < 3; k++) {
                    w[k] += n->row[i].n[0][a] * d[3 * (first + (n->row[i].first + a) * step) + k];
                }
            }
            const oracle_real speed = oracle_norm(t), along = oracle_dot(w, t) / speed;
            sum += f->size * n->weight[i] * speed * (oracle_dot(w, w) - along * along);
        }
    }
    return sum;
}

/* The smallest Rayleigh quotient of the trials, times the size squared. */
static oracle_real find_lowest(film *f, oracle_real *moments, oracle_real *d)
{
    const oracle_real h = f->size * 1e-4L;
    oracle_real lowest = INFINITY, still[2], more[2], less[2];

    energy_of(f, still);
    find_moments(f, moments);
    for (int trial = 0; trial < TRIALS; trial++) {
        make_trial(f, moments, trial, d);
        const oracle_real norm = norm_of(f, d);
        move_net(f, d, h);
        energy_of(f, more);
        move_net(f, d, -2 * h);
        energy_of(f, less);
        move_net(f, d, h);
        const oracle_real bend = (more[0] - still[0]) + (less[0] - still[0]) +
                                 ((more[1] - still[1]) + (less[1] - still[1]));
        if (norm > 1e-9L * f->size * f->size) { /* a wave may vanish at all points of a small net */
            lowest = fminl(lowest, bend / (h * h) / norm * f->size * f->size);
        }
    }
    return lowest;
}

/* By two rules, the larger and their difference: where they disagree nobody is accused. */
double oracle_film_lowest(const oracle_case *about)
{
    oracle_real found[2] = {NAN, NAN};

    for (int i = 0; i < 2; i++) {
        film f;
        if (!film_of(about, about->model, i == 0 ? NODES : 2 * NODES, &f)) {
            return NAN;
        }
        const size_t n = (size_t)f.sheet.u.count * (size_t)f.sheet.v.count;
        oracle_real *moments = calloc(3 * n, sizeof *moments), *d = calloc(3 * n, sizeof *d);
        if (moments != NULL && d != NULL) {
            found[i] = find_lowest(&f, moments, d);
        }
        free(moments);
        free(d);
        film_free(&f);
    }
    return (double)(fmaxl(found[0], found[1]) + 10 * fabsl(found[0] - found[1]));
}
