/* biharmonic.c -- is this the biharmonic surface with the given rows, or the neighbour of least
 * bending?
 *
 *   biharmonic     the largest control point of the Laplacian of the Laplacian, each by relation
 *                  (2) in twice the precision, over the largest of n^4/a^4, n^2 m^2/(a b)^2 and
 *                  m^4/b^4 of which the degrees have a derivative, and the size about the
 *                  mean point, which bounds it over the whole rectangle; of several surfaces the
 *                  worst. Limit 4 (n + m) 2^-53 times the largest coordinate over the size.
 *   boundary       largest distance of a given point from the model's, over the size of those; 0.
 *   continuity     of a neighbour: differences across the edge ([NiWang2015] section 2.6 (3)), the
 *                  Bernstein coefficients of the derivatives along it but for a factor,
 *                      |Delta^k q_0 - h^k Delta^k p_(n-k)| / (2^k max(1, h)^k size of the nets),
 *                  k up to the contact; limit 4 2^-53 times coordinate over size. The rectangles
 *                  meet there.
 *   least-bending  certify/biharmonic/bending.h: the quadrature is exact for these degrees, so that
 *                  it is an identity to rounding
 */
#include "taut/biharmonic.h"

#include "certify/biharmonic/bending.h"
#include "certify/certify_ops.h"
#include "certify/common/unit.h"
#include "certify/common/verdict.h"
#include "certify/harmonic/claims.h"
#include "certify/harmonic/residual.h"
#include "core/constants.h"
#include "core/elementary/elementary.h"
#include "core/fail.h"
#include "core/memory.h"
#include "core/twice.h"
#include "measure/integrate/integrals.h"
#include "measure/integrate/near_zero.h"
#include "taut/limits.h"

#include <float.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

static const double roundings = 4;

static double width_of(const taut_basis *basis)
{
    return taut_basis_hi(basis) - taut_basis_lo(basis);
}

static size_t count_of(const taut_surface *surface)
{
    return (size_t)taut_basis_count(taut_surface_u(surface)) *
           (size_t)taut_basis_count(taut_surface_v(surface));
}

/* What the bilaplacian of a net of size 1 may be: of x_uuuu, x_uuvv and x_vvvv those that the degrees
 * have. */
static double largest_bilaplacian(int n, int m, const taut_twice w[2])
{
    const double along = w[0].high * n * n, across = w[1].high * m * m;
    const double mixed = n > 1 && m > 1 ? along * across : 0;
    return fmax(mixed, fmax(n > 3 ? along * along : 0, m > 3 ? across * across : 0));
}

/* The scaled residual, in twice the precision, at unit size; *noise what rounding explains. */
static taut_status residual_of(const taut_surface *surface, double *residual, double *noise)
{
    const int n = taut_basis_degree(taut_surface_u(surface));
    const int m = taut_basis_degree(taut_surface_v(surface));
    const size_t count = count_of(surface), numbers = 3 * count;
    taut_twice *net = taut_alloc(2 * numbers, sizeof *net), w[2];
    double mean[3] = {0, 0, 0}, reach = 0, size = 0;
    int unit = 0;

    if (net == NULL) {
        return TAUT_NO_MEMORY;
    }
    (void)taut_certify_extent(taut_surface_points(surface), NULL, count, &reach);
    unit = reach > 0 && isfinite(reach) ? ilogb(reach) : 0;
    for (size_t k = 0; k < numbers; k++) {
        net[k] = taut_twice_of(ldexp(taut_surface_points(surface)[k], -unit));
        mean[k % 3] += net[k].high / (double)count;
    }
    for (size_t k = 0; k < numbers; k++) {
        size = taut_certify_max(size, fabs(net[k].high - mean[k % 3]));
    }
    taut_certify_laplacian_weights(width_of(taut_surface_u(surface)),
                                   width_of(taut_surface_v(surface)), w);
    const double most = largest_bilaplacian(n, m, w);
    taut_certify_laplacian(n, m, w, net, net + numbers);
    taut_certify_laplacian(n, m, w, net + numbers, net);
    *residual = 0;
    for (size_t k = 0; k < numbers && size > 0; k++) {
        const double left = fabs(taut_twice_round(net[k]));
        *residual = taut_certify_max(*residual, left == 0 ? 0 : left / (most * size));
    }
    *noise = roundings * (n + m) * TAUT_UNIT_ROUNDOFF *
             (size > 0 ? taut_certify_max(1, ldexp(reach, -unit) / size) : 1);
    taut_free(net);
    return TAUT_OK;
}

static taut_status add_biharmonic(const taut_model *model, taut_certificate *certificate)
{
    double worst = -1, residual = 0, limit = 0;
    char where[96] = "";

    /* The worst by what a claim is held against: a large one that its own rounding explains must not
     * stand behind a smaller one nearer to its rounding. */
    for (int k = 0; k < taut_model_surface_count(model); k++) {
        double found = 0, noise = 0, rank = 0;
        if (residual_of(taut_model_surface(model, k), &found, &noise) != TAUT_OK) {
            return TAUT_NO_MEMORY;
        }
        rank = taut_harmonic_rank(found, noise);
        if (!(rank <= worst)) {
            worst = rank;
            residual = found;
            limit = noise;
            snprintf(where, sizeof where, "surface %.40s, its own rectangle",
                     taut_surface_name(taut_model_surface(model, k)));
        }
    }
    return taut_harmonic_add_claim("biharmonic", TAUT_BOUND, residual, limit, where, certificate);
}

/* Given points against the model's first surface. */
static taut_status add_boundary(const taut_surface *found, const taut_basis *u, const taut_basis *v,
                                const double *points, const unsigned char *known,
                                taut_certificate *certificate)
{
    const int same =
        taut_basis_equal(taut_surface_u(found), u) && taut_basis_equal(taut_surface_v(found), v);
    const size_t count = count_of(found);
    double most = same ? 0 : 1, reach = 0, size = 1;
    char where[64] = "";

    if (same) {
        size = taut_certify_extent(points, known, count, &reach);
    }
    for (size_t k = 0; same && k < count; k++) {
        for (size_t c = 0; (known == NULL || known[k]) && c < 3; c++) {
            const double x = taut_surface_points(found)[3 * k + c], given = points[3 * k + c];
            const double apart = x != given ? fmax(fabs(x / 2 - given / 2), DBL_MIN) : 0;
            if (!(apart <= most)) {
                most = apart;
                snprintf(where, sizeof where, "/surfaces/0/points, point %zu", k);
            }
        }
    }
    return taut_harmonic_add_claim("boundary", TAUT_EXACT,
                                   most == 0 ? 0 : fmax(most / (size / 2), TAUT_UNIT_ROUNDOFF), 0,
                                   where, certificate);
}

static int is_along_v(taut_edge edge)
{
    return edge == TAUT_EDGE_U0 || edge == TAUT_EDGE_U1;
}

/* Point j of line k, counted from an edge into the surface. */
static const double *point_from(const taut_surface *surface, taut_edge edge, int k, int j)
{
    const int rows = taut_basis_count(taut_surface_u(surface));
    const int columns = taut_basis_count(taut_surface_v(surface));
    const int high = edge == TAUT_EDGE_U1 || edge == TAUT_EDGE_V1;
    const int i = is_along_v(edge) ? (high ? rows - 1 - k : k) : j;
    const int c = is_along_v(edge) ? j : (high ? columns - 1 - k : k);
    return taut_surface_points(surface) + 3 * (i * columns + c);
}

static taut_edge opposite(taut_edge edge)
{
    static const taut_edge others[] = {TAUT_EDGE_U1, TAUT_EDGE_U0, TAUT_EDGE_V1, TAUT_EDGE_V0};
    return others[edge];
}

/* Delta^k into the surface, of coordinates times 2^-unit, exactly but for twice the precision. */
static taut_twice difference(const taut_surface *surface, taut_edge edge, int k, int j, int c,
                             int unit)
{
    taut_twice sum = {0, 0};
    double binomial = k % 2 == 0 ? 1 : -1;
    for (int i = 0; i <= k; i++) {
        const double x = ldexp(point_from(surface, edge, i, j)[c], -unit);
        sum = taut_twice_add(sum, taut_twice_product(binomial, x));
        binomial *= -(double)(k - i) / (i + 1);
    }
    return sum;
}

/* The largest difference of order k over its unit: Bernstein coefficients of the derivatives along
 * the whole edge, up to a factor. */
static double jump_of(const taut_surface *p, const taut_surface *q, taut_edge edge, int k,
                      const taut_twice *h, double size, int unit)
{
    const int m = taut_basis_degree(is_along_v(edge) ? taut_surface_v(p) : taut_surface_u(p));
    const double over = taut_pow(2 * fmax(1, h->high), k) * size;
    double most = 0;
    for (int j = 0; j <= m; j++) {
        for (int c = 0; c < 3; c++) {
            const taut_twice into = difference(q, opposite(edge), k, j, c, unit);
            taut_twice out = difference(p, edge, k, j, c, unit);
            for (int i = 0; i < k; i++) {
                out = taut_twice_times((taut_twice){-h->high, -h->low}, out);
            }
            const double apart = fabs(taut_twice_round(taut_twice_less(into, out)));
            most = taut_certify_max(most, apart == 0 ? 0 : apart / over);
        }
    }
    return most;
}

/* Does q's rectangle begin at p's edge, and end along it as p's does? */
static int is_beyond(const taut_surface *p, const taut_surface *q, taut_edge edge)
{
    const int u = is_along_v(edge);
    const taut_basis *from = u ? taut_surface_u(p) : taut_surface_v(p);
    const taut_basis *beyond = u ? taut_surface_u(q) : taut_surface_v(q);
    const int high = edge == TAUT_EDGE_U1 || edge == TAUT_EDGE_V1;
    return taut_basis_equal(u ? taut_surface_v(p) : taut_surface_u(p),
                            u ? taut_surface_v(q) : taut_surface_u(q)) &&
           (high ? taut_basis_hi(from) == taut_basis_lo(beyond)
                 : taut_basis_lo(from) == taut_basis_hi(beyond));
}

static taut_status add_continuity(const taut_surface *p, const taut_surface *q, taut_edge edge,
                                  int contact, taut_certificate *certificate)
{
    const int u = is_along_v(edge), n = taut_basis_degree(taut_surface_u(p));
    const double widths[2] = {width_of(u ? taut_surface_u(p) : taut_surface_v(p)),
                              width_of(u ? taut_surface_u(q) : taut_surface_v(q))};
    const taut_twice h = taut_twice_over(taut_twice_of(widths[1]), taut_twice_of(widths[0]));
    double reach[2], most = 0;
    const double own = taut_certify_extent(taut_surface_points(p), NULL, count_of(p), &reach[0]);
    const double size =
        fmax(own, taut_certify_extent(taut_surface_points(q), NULL, count_of(q), &reach[1]));
    const double largest = taut_certify_max(reach[0], reach[1]);
    const int unit = largest > 0 && isfinite(largest) ? ilogb(largest) : 0;
    int worst = 0;
    char where[64];

    if (!is_beyond(p, q, edge)) {
        return taut_harmonic_add_claim("continuity", TAUT_BOUND, 1, 0,
                                       "the ranges of the two surfaces do not meet in the edge",
                                       certificate);
    }
    for (int k = 0; k <= contact && k <= n; k++) {
        /* the edge is p's, however far q goes */
        const double jump = jump_of(p, q, edge, k, &h, ldexp(k == 0 ? own : size, -unit), unit);
        worst = jump > most ? k : worst;
        most = taut_certify_max(most, jump);
    }
    snprintf(where, sizeof where, "derivative %d across", worst);
    return taut_harmonic_add_claim("continuity", TAUT_BOUND, most,
                                   4 * TAUT_UNIT_ROUNDOFF *
                                       (size > 0 ? taut_certify_max(1, largest / size) : 1),
                                   where, certificate);
}

/* At unit size, as energies are squares. */
static taut_status add_bending(const taut_surface *q, taut_edge edge, int contact,
                               taut_pulse *pulse, taut_certificate *certificate)
{
    taut_surface *unit = NULL, *moved = NULL; /* second derivatives want parameters with all their
                                               * digits */
    taut_bending_slope slope;
    char where[96];

    if (taut_certify_scaled(q, taut_certify_unit_of(q), &unit) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    if (!taut_surface_near_zero(unit, &moved)) {
        taut_surface_free(unit);
        return TAUT_NO_MEMORY;
    }
    slope = taut_bending_slope_of(moved != NULL ? moved : unit, opposite(edge), contact, pulse);
    taut_surface_free(moved);
    taut_surface_free(unit);
    snprintf(where, sizeof where, "along derivative %d across times power %d along", slope.order,
             slope.power);
    return taut_harmonic_add_claim("least-bending", TAUT_EXACT, slope.residual, slope.noise, where,
                                   certificate);
}

/* The edge the problem names, or without it the one where the two ranges meet. */
static taut_edge edge_of(const taut_surface *p, const taut_surface *q,
                         const taut_biharmonic_problem *problem)
{
    return problem != NULL ? problem->neighbour.edge : taut_certify_shared_edge(p, q);
}

static taut_status add_neighbour(const taut_model *model, const taut_biharmonic_problem *problem,
                                 taut_pulse *pulse, taut_certificate *certificate)
{
    const taut_surface *p = taut_model_surface(model, 0), *q = taut_model_surface(model, 1);
    const char *named = taut_record_text(taut_record_get(taut_model_details(model), "contact"));
    const int contact = problem != NULL            ? problem->neighbour.contact
                        : strcmp(named, "c2") == 0 ? 2
                                                   : 1;
    const taut_edge edge = edge_of(p, q, problem);
    taut_status status = add_continuity(p, q, edge, contact, certificate);
    return status == TAUT_OK ? add_bending(q, edge, contact, pulse, certificate) : status;
}

static taut_status add_figures(const taut_model *model, const taut_crew *crew,
                               taut_certificate *certificate)
{
    const int count = taut_model_surface_count(model);
    taut_record *figures = taut_record_new();
    double energy[2] = {0, 0}, error = 0;
    taut_status status = TAUT_OK;

    for (int i = 0; i < count && i < 2 && status == TAUT_OK; i++) {
        status = taut_surface_bending_of(taut_model_surface(model, i), crew, &energy[i], &error);
    }
    if (count == 1) {
        taut_record_add_number(figures, "bending_energy", energy[0]);
    } else {
        taut_record_add_numbers(figures, "bending_energy", 2, energy);
    }
    taut_certificate_set_figures(certificate, figures);
    return status == TAUT_OK ? taut_record_status(figures) : status;
}

/* The model has one or two surfaces, the second of one degree both ways, as the first. */
static taut_status check_model(const taut_model *model, const taut_biharmonic_problem *problem,
                               taut_error *error)
{
    const int count = taut_model_surface_count(model);
    const int wanted = problem == NULL                               ? count
                       : problem->given == TAUT_BIHARMONIC_NEIGHBOUR ? 2
                                                                     : 1;
    taut_status status = taut_harmonic_check_model(model, 1, error);

    for (int i = 0; i < count && status == TAUT_OK; i++) {
        const taut_surface *first = taut_model_surface(model, 0), *s = taut_model_surface(model, i);
        const int n = taut_basis_degree(taut_surface_u(s)),
                  m = taut_basis_degree(taut_surface_v(s));
        if (count != wanted || count > 2 ||
            (count == 2 && (n != m || n > 64 || n != taut_basis_degree(taut_surface_u(first))))) {
            status = taut_fail(error, TAUT_BAD_INPUT, "model", "/surfaces", count, wanted,
                               "the model is no biharmonic surface, nor one and its neighbour, of "
                               "this problem");
        }
    }
    return status;
}

/* What was given against the model's first surface. */
static taut_status add_given(const taut_model *model, const taut_biharmonic_problem *problem,
                             taut_certificate *certificate)
{
    const taut_surface *found = taut_model_surface(model, 0);
    if (problem->given == TAUT_BIHARMONIC_NEIGHBOUR) {
        const taut_surface *given = problem->neighbour.surface;
        return add_boundary(found, taut_surface_u(given), taut_surface_v(given),
                            taut_surface_points(given), NULL, certificate);
    }
    return add_boundary(found, problem->rows.u, problem->rows.v, problem->rows.points,
                        problem->rows.known, certificate);
}

static taut_status add_all(const taut_model *model, const taut_biharmonic_problem *problem,
                           const taut_crew *crew, taut_certificate *certificate)
{
    taut_status status = add_biharmonic(model, certificate);

    if (status == TAUT_OK && problem != NULL) {
        status = add_given(model, problem, certificate);
    }
    if (status == TAUT_OK && taut_model_surface_count(model) == 2) {
        status = add_neighbour(model, problem, crew->pulse, certificate);
    }
    return status == TAUT_OK ? add_figures(model, crew, certificate) : status;
}

static taut_status certify(const taut_model *model, const void *data, const taut_audit *audit,
                           taut_certificate *certificate, taut_error *error)
{
    const taut_status status = check_model(model, data, error);

    if (status != TAUT_OK) {
        return status;
    }
    return add_all(model, data, &audit->crew, certificate) == TAUT_OK ? TAUT_OK
                                                                      : taut_fail_memory(error);
}

static void identify(const taut_model *model, const void *data, taut_identity *identity)
{
    const taut_biharmonic_problem *problem = data;
    taut_expected_basis bezier = {.type = "bezier"}, u = bezier, v = bezier;

    for (int i = 0; problem == NULL && i < taut_model_surface_count(model); i++) {
        taut_identity_surface(identity, i, NULL, NULL, NULL);
    }
    if (problem != NULL && problem->given == TAUT_BIHARMONIC_ROWS) {
        const taut_biharmonic_rows *rows = &problem->rows;
        u.same = rows->u;
        v.same = rows->v;
        taut_identity_surface(identity, 0, rows->name != NULL ? rows->name : "biharmonic", &u, &v);
    } else if (problem != NULL) {
        const taut_surface *given = problem->neighbour.surface;
        u.same = taut_surface_u(given);
        v.same = taut_surface_v(given);
        taut_identity_surface(identity, 0, taut_surface_name(given), &u, &v);
        bezier.degree[0] = bezier.degree[1] = taut_basis_degree(u.same);
        taut_identity_surface(identity, 1, "extension", &bezier, &bezier);
    }
}

const taut_certify_ops taut_certify_biharmonic = {.certify = certify, .identify = identify};

taut_status taut_biharmonic_certify(const taut_model *model, const taut_biharmonic_problem *problem,
                                    const taut_certify_options *options,
                                    taut_certificate **certificate, taut_error *error)
{
    return taut_certify_with(&taut_certify_biharmonic, "biharmonic", model, problem, options,
                             certificate, error);
}
