/* judge_nets.c -- judges of nets with unknown points and of harmonic and biharmonic ones.
 *
 *     stationary   own integrals of the derivatives by every point
 *     harmonic     sup |x_uu + x_vv| over samples is at most the largest control point of it
 *     boundary     the given points, number by number
 *     continuity   positions and derivatives along the shared edge, or normals
 *     contact      what of the neighbour's derivative leads out of the tangent plane
 *     merged       both pieces against the surface over both, at equal parameters
 *     aspect       the two parts of the energy, by exact rules
 *     least        the area against that of another surface with the same boundary
 */
#include "oracle/oracle.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* unknown[i] nonzero where the problem (or `details.known` of a model alone) leaves it open; how
 * many, or -1 where that is not said. */
static int find_unknown(const oracle_case *about, const oracle_sheet *sheet, char *unknown)
{
    const taut_record *rows = taut_record_get(about->problem, "points");
    const char *known =
        taut_record_text(taut_record_get(taut_model_details(about->model), "known"));
    int count = 0;

    if (about->problem != NULL &&
        (rows == NULL || taut_record_count(rows) != (size_t)sheet->u.count ||
         taut_record_count(taut_record_at(rows, 0)) != (size_t)sheet->v.count)) {
        return -1;
    }
    if (about->problem == NULL && strcmp(known, "all") != 0 && strcmp(known, "boundary") != 0) {
        return -1;
    }
    for (int i = 0; i < sheet->u.count; i++) {
        for (int j = 0; j < sheet->v.count; j++) {
            const int inside = i > 0 && j > 0 && i < sheet->u.count - 1 && j < sheet->v.count - 1;
            const taut_record *point = taut_record_at(taut_record_at(rows, (size_t)i), (size_t)j);
            const int open = about->problem != NULL ? taut_record_kind_of(point) == TAUT_RECORD_NULL
                                                    : inside && strcmp(known, "boundary") == 0;
            unknown[i * sheet->v.count + j] = (char)open;
            count += open;
        }
    }
    return count;
}

static oracle_real aspect_of(const oracle_case *about, const oracle_sheet *sheet)
{
    const taut_record *aspect = taut_record_get(
        about->problem != NULL ? about->problem : taut_model_details(about->model), "aspect");

    (void)sheet;
    if (taut_record_kind_of(aspect) == TAUT_RECORD_TEXT) {
        aspect = taut_record_get(taut_model_details(about->model), "aspect");
    }
    return taut_record_kind_of(aspect) == TAUT_RECORD_NUMBER ? taut_record_number(aspect) : 1;
}

static double relative_gradient(const oracle_case *about, const oracle_sheet *sheet,
                                const char *unknown, oracle_real *gradient)
{
    const int area = strcmp(about->construct, "plateau") == 0;
    oracle_real open = 0, all = 0, error;

    if (!oracle_gradient(sheet, area, area ? 1 : aspect_of(about, sheet), gradient, &error)) {
        return NAN;
    }
    for (int i = 0; i < sheet->u.count * sheet->v.count; i++) {
        const oracle_real d = oracle_norm(gradient + 3 * (size_t)i);
        all = fmaxl(all, d);
        if (unknown[i]) {
            open = fmaxl(open, d);
        }
    }
    return (double)((open - 2 * error) / (all + error));
}

double oracle_stationary(const oracle_case *about)
{
    const taut_record *method = taut_record_get(
        about->problem != NULL ? about->problem : taut_model_details(about->model), "method");
    oracle_sheet sheet;
    char *unknown = NULL;
    oracle_real *gradient = NULL;
    double found = NAN;
    size_t n;

    if (strcmp(taut_record_text(method), "normal") == 0 &&
        strcmp(about->construct, "plateau") == 0) {
        return NAN; /* along directions: the distance from the made model judges */
    }
    if (!oracle_sheet_of(oracle_subject(about, 0), &sheet)) {
        return NAN;
    }
    n = (size_t)sheet.u.count * (size_t)sheet.v.count;
    unknown = calloc(n, 1);
    gradient = calloc(3 * n, sizeof *gradient);
    if (unknown != NULL && gradient != NULL && n <= 900 &&
        sheet.u.spans * sheet.v.spans <= (strcmp(about->construct, "plateau") == 0 ? 4 : 400)) {
        const int count = find_unknown(about, &sheet, unknown);
        if (count == 0) {
            found = INFINITY; /* nothing was unknown: that is undecided, not stationary */
        } else if (count > 0) {
            found = relative_gradient(about, &sheet, unknown, gradient);
        }
    }
    free(unknown);
    free(gradient);
    oracle_sheet_free(&sheet);
    return found;
}

/* The largest difference of a given point from the model's own; NaN where the nets do not match. */
static double given_points(const taut_record *rows, const taut_surface *surface, int skip_last)
{
    const int nu = taut_basis_count(taut_surface_u(surface));
    const int nv = taut_basis_count(taut_surface_v(surface));
    const double *points = taut_surface_points(surface);
    double worst = 0, size = 0;

    if (taut_record_count(rows) != (size_t)nu) {
        return NAN;
    }
    for (int i = 0; i < nu; i++) {
        const taut_record *row = taut_record_at(rows, (size_t)i);
        if (taut_record_count(row) != (size_t)nv) {
            return NAN;
        }
        for (int j = 0; j < nv; j++) {
            double p[3];
            if (!oracle_point(taut_record_at(row, (size_t)j), p) ||
                (skip_last && i == nu - 1 && j == nv - 1)) {
                continue;
            }
            for (int k = 0; k < 3; k++) {
                worst = fmax(worst, fabs(p[k] - points[3 * (i * nv + j) + k]));
                size = fmax(size, fabs(p[k]));
            }
        }
    }
    return size > 0 ? worst / size : worst;
}

double oracle_known(const oracle_case *about)
{
    const taut_record *rows = taut_record_get(about->problem, "points");
    const taut_surface *surface = oracle_subject(about, 0);

    return rows == NULL || surface == NULL ? NAN : given_points(rows, surface, 0);
}

double oracle_rows(const oracle_case *about)
{
    const taut_record *given = taut_record_get(about->problem, "surface");
    const char *even = taut_record_text(taut_record_get(about->problem, "even"));
    const taut_record *rows = taut_record_get(given != NULL ? given : about->problem, "points");
    const taut_surface *surface = oracle_subject(about, 0);

    if (rows == NULL || surface == NULL || strcmp(even, "raise") == 0 ||
        strcmp(even, "project") == 0) {
        return NAN;
    }
    return given_points(rows, surface, strcmp(even, "corner") == 0);
}

/* Largest distance of a point of the net from their mean, as |.| over all three coordinates. */
static oracle_real spread(const oracle_sheet *sheet)
{
    const int n = sheet->u.count * sheet->v.count;
    oracle_real mean[3] = {0}, worst = 0;

    for (int i = 0; i < 3 * n; i++) {
        mean[i % 3] += (oracle_real)sheet->points[i] / n;
    }
    for (int i = 0; i < n; i++) {
        oracle_real d[3];
        for (int k = 0; k < 3; k++) {
            d[k] = sheet->points[3 * i + k] - mean[k];
        }
        worst = fmaxl(worst, oracle_norm(d));
    }
    return worst;
}

static double worst_equation(const oracle_case *about, int twice)
{
    oracle_real worst = 0;

    for (int s = 0; s < oracle_subject_count(about); s++) {
        oracle_sheet sheet;
        oracle_real scale, found = 0;
        if (!oracle_sheet_of(oracle_subject(about, s), &sheet)) {
            return NAN;
        }
        const oracle_real a = (oracle_real)sheet.u.hi - sheet.u.lo;
        const oracle_real b = (oracle_real)sheet.v.hi - sheet.v.lo;
        scale = fmaxl((oracle_real)(sheet.u.degree * sheet.u.degree) / (a * a),
                      (oracle_real)(sheet.v.degree * sheet.v.degree) / (b * b));
        scale = (twice ? scale * scale : scale) * spread(&sheet);
        for (int i = 0; i < 15 * 15 && scale > 0 && sheet.weights == NULL; i++) {
            const oracle_real u = sheet.u.lo + a * (oracle_real)(i % 15) / 14;
            const oracle_real v = sheet.v.lo + b * (oracle_real)(i / 15) / 14;
            oracle_real x[3], y[3], z[3] = {0}, sum[3];
            oracle_sheet_mixed(&sheet, u, v, twice ? 4 : 2, 0, x);
            oracle_sheet_mixed(&sheet, u, v, 0, twice ? 4 : 2, y);
            if (twice) {
                oracle_sheet_mixed(&sheet, u, v, 2, 2, z);
            }
            for (int k = 0; k < 3; k++) {
                sum[k] = x[k] + 2 * z[k] + y[k];
                found = fmaxl(found, fabsl(sum[k]) / scale);
            }
        }
        if (sheet.weights != NULL) {
            found = NAN;
        }
        oracle_sheet_free(&sheet);
        worst = fmaxl(worst, found);
    }
    return (double)worst;
}

double oracle_laplace(const oracle_case *about)
{
    return worst_equation(about, 0);
}

double oracle_bilaplace(const oracle_case *about)
{
    return worst_equation(about, 1);
}

/* Where surface 1 begins: the edge of surface 0 whose parameter it carries on; -1 for none. */
static int shared_edge(const oracle_sheet *a, const oracle_sheet *b)
{
    const double slack_u = 1e-9 * (a->u.hi - a->u.lo), slack_v = 1e-9 * (a->v.hi - a->v.lo);

    if (fabs(a->v.lo - b->v.lo) <= slack_v && fabs(a->v.hi - b->v.hi) <= slack_v) {
        if (fabs(a->u.hi - b->u.lo) <= slack_u) {
            return 1;
        }
        if (fabs(a->u.lo - b->u.hi) <= slack_u) {
            return 0;
        }
    }
    if (fabs(a->u.lo - b->u.lo) <= slack_u && fabs(a->u.hi - b->u.hi) <= slack_u) {
        if (fabs(a->v.hi - b->v.lo) <= slack_v) {
            return 3;
        }
        if (fabs(a->v.lo - b->v.hi) <= slack_v) {
            return 2;
        }
    }
    return -1;
}

static void at_edge(const oracle_sheet *sheet, int along_v, int high, oracle_real t,
                    oracle_real out[6][3])
{
    const oracle_real u = along_v ? (high ? sheet->u.hi : sheet->u.lo)
                                  : sheet->u.lo + t * ((oracle_real)sheet->u.hi - sheet->u.lo);
    const oracle_real v = !along_v ? (high ? sheet->v.hi : sheet->v.lo)
                                   : sheet->v.lo + t * ((oracle_real)sheet->v.hi - sheet->v.lo);

    oracle_sheet_eval(sheet, u, v, 1, out);
}

static double contact_of(const oracle_case *about, const oracle_sheet *a, const oracle_sheet *b)
{
    const int edge = shared_edge(a, b),
              tangent =
                  strcmp(taut_record_text(taut_record_get(about->problem, "contact")), "g1") == 0;
    oracle_real worst = 0;
    int normals = 0;

    if (edge < 0 || about->problem == NULL) {
        return NAN;
    }
    for (int i = 0; i <= 40; i++) {
        oracle_real x[6][3], y[6][3], n[2][3], gap = 0, slope = 0, cross[3];
        at_edge(a, edge < 2, edge % 2, (oracle_real)i / 40, x);
        at_edge(b, edge < 2, 1 - edge % 2, (oracle_real)i / 40, y);
        const int d = edge < 2 ? 1 : 2;
        for (int k = 0; k < 3; k++) {
            gap = fmaxl(gap, fabsl(x[0][k] + a->middle[k] - y[0][k] - b->middle[k]));
            slope = fmaxl(slope, fabsl(x[d][k] - y[d][k]));
        }
        oracle_cross(x[1], x[2], n[0]);
        oracle_cross(y[1], y[2], n[1]);
        worst = fmaxl(worst, gap / (10 * (a->size + b->size)));
        if (!tangent) { /* at most 100 slopes of the net: degree, and ratio of widths */
            const oracle_real width =
                edge < 2 ? fmaxl((oracle_real)a->u.hi - a->u.lo, (oracle_real)b->u.hi - b->u.lo)
                         : fmaxl((oracle_real)a->v.hi - a->v.lo, (oracle_real)b->v.hi - b->v.lo);
            worst = fmaxl(worst, slope * width / (100 * (a->size + b->size)) /
                                     (a->u.degree + a->v.degree));
        } else if (oracle_norm(n[0]) > 0 && oracle_norm(n[1]) > 0) {
            oracle_cross(n[0], n[1], cross);
            worst = fmaxl(worst, oracle_norm(cross) / (oracle_norm(n[0]) * oracle_norm(n[1])) / 4);
            normals++;
        }
    }
    return tangent && normals == 0 ? (double)INFINITY : (double)worst;
}

double oracle_contact(const oracle_case *about)
{
    oracle_sheet a, b;
    double found;

    if (!oracle_sheet_of(oracle_subject(about, 0), &a)) {
        return NAN;
    }
    if (!oracle_sheet_of(oracle_subject(about, 1), &b)) {
        oracle_sheet_free(&a);
        return NAN;
    }
    found = contact_of(about, &a, &b);
    oracle_sheet_free(&a);
    oracle_sheet_free(&b);
    return found;
}

/* |N . Q_across| is no more than |Q_across - c P_across - (alpha + beta s) P_along|, whatever c,
 * alpha and beta; the derivatives are no larger than degree times size over width. */
static double tangent_of(const oracle_sheet *a, const oracle_sheet *b)
{
    const int edge = shared_edge(a, b), d = edge < 2 ? 1 : 2;
    oracle_real worst = 0;

    if (edge < 0) {
        return NAN;
    }
    for (int i = 0; i <= 40; i++) {
        oracle_real x[6][3], y[6][3], n[3];
        at_edge(a, edge < 2, edge % 2, (oracle_real)i / 40, x);
        at_edge(b, edge < 2, 1 - edge % 2, (oracle_real)i / 40, y);
        oracle_cross(x[1], x[2], n);
        if (oracle_norm(n) > 0) {
            worst = fmaxl(worst, fabsl(oracle_dot(n, y[d])) / oracle_norm(n));
        }
    }
    const oracle_real most[2] = {fmaxl(a->u.degree * a->size / ((oracle_real)a->u.hi - a->u.lo),
                                       a->v.degree * a->size / ((oracle_real)a->v.hi - a->v.lo)),
                                 fmaxl(b->u.degree * b->size / ((oracle_real)b->u.hi - b->u.lo),
                                       b->v.degree * b->size / ((oracle_real)b->v.hi - b->v.lo))};
    return (double)(worst / (8 * fmaxl(most[0], most[1])));
}

static oracle_real apart_at_places(const oracle_sheet *part, const oracle_sheet *whole)
{
    oracle_real worst = 0;

    for (int i = 0; i < 49; i++) {
        const oracle_real s = (oracle_real)(i % 7) / 6, t = (oracle_real)(i / 7) / 6;
        const oracle_real u = part->u.lo * (1 - s) + part->u.hi * s;
        const oracle_real v = part->v.lo * (1 - t) + part->v.hi * t;
        oracle_real a[6][3], b[6][3];
        oracle_sheet_eval(part, u, v, 0, a);
        oracle_sheet_eval(whole, u, v, 0, b);
        for (int k = 0; k < 3; k++) {
            worst = fmaxl(worst, fabsl(a[0][k] + part->middle[k] - b[0][k] - whole->middle[k]));
        }
    }
    return worst;
}

double oracle_tangent(const oracle_case *about)
{
    oracle_sheet a, b;
    double found;

    if (!oracle_sheet_of(oracle_subject(about, 0), &a)) {
        return NAN;
    }
    if (!oracle_sheet_of(oracle_subject(about, 1), &b)) {
        oracle_sheet_free(&a);
        return NAN;
    }
    found = tangent_of(&a, &b);
    oracle_sheet_free(&a);
    oracle_sheet_free(&b);
    return found;
}

/* Over twice the largest coordinate difference, of which the size of a piece is no less than half. */
double oracle_merged(const oracle_case *about)
{
    oracle_sheet whole, part;
    oracle_real worst = 0;

    if (!oracle_sheet_of(oracle_surface(about->model, "h"), &whole)) {
        return NAN;
    }
    for (int s = 0; s < 2; s++) {
        if (oracle_sheet_of(oracle_subject(about, s), &part)) {
            worst = fmaxl(worst, apart_at_places(&part, &whole) / (2 * part.size));
            oracle_sheet_free(&part);
        }
    }
    oracle_sheet_free(&whole);
    return (double)worst;
}

/* |log(lambda^2 iint |x_u|^2 / iint |x_v|^2)|, the integrals from the energies of two aspects: the
 * energy is (1/2) sum of g . x, g its derivatives by the points, as it is of degree two in them. */
double oracle_aspect(const oracle_case *about)
{
    oracle_sheet sheet;
    oracle_real *gradient, parts[2], error, energy[2] = {0, 0};
    double found = NAN;

    if (!oracle_sheet_of(oracle_subject(about, 0), &sheet)) {
        return NAN;
    }
    const int n = 3 * sheet.u.count * sheet.v.count;
    const oracle_real lambda = aspect_of(about, &sheet);
    gradient = calloc((size_t)n, sizeof *gradient);
    for (int k = 0; k < 2 && gradient != NULL && sheet.weights == NULL; k++) {
        if (!oracle_gradient(&sheet, 0, k == 0 ? 1 : 2, gradient, &error)) {
            break;
        }
        for (int i = 0; i < n; i++) {
            energy[k] += gradient[i] * sheet.net[4 * (i / 3) + i % 3] / 2;
        }
    }
    /* energy[0] = (a + b) / 2, energy[1] = (2 a + b / 2) / 2 */
    parts[0] = (4 * energy[1] - 2 * energy[0]) / 3;
    parts[1] = 2 * energy[0] - parts[0];
    if (sheet.u.type == 'p' && sheet.v.type == 'p' && parts[0] > 0 && parts[1] > 0) {
        found = (double)fabsl(logl(lambda * lambda * parts[0] / parts[1]));
    }
    free(gradient);
    oracle_sheet_free(&sheet);
    return found;
}

/* How much of the film's area another surface with its boundary saves: the one that was made, where
 * the known points are the problem's. */
double oracle_least(const oracle_case *about)
{
    oracle_sheet film;
    oracle_integrals own = {.area = NAN, .area_error = 0};
    const double known = about->problem != NULL ? oracle_known(about) : NAN;

    if (!(known == 0) || isnan(about->honest_area) ||
        !oracle_sheet_of(oracle_subject(about, 0), &film)) {
        return NAN;
    }
    if (film.u.spans * film.v.spans <= 4) {
        oracle_integrate(&film, 1e-9L, 2, &own);
    }
    oracle_sheet_free(&film);
    return (double)((own.area - own.area_error - about->honest_area * (1 + 1e-9L)) / own.area);
}
