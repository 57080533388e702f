/* biharmonic.c -- is this the biharmonic surface with the given rows, or the neighbour of least
 * bending?
 *
 *   biharmonic     the largest control point of the Laplacian of the Laplacian, each by relation
 *                  (2), over max(n^2/a^2, n^2/b^2)^2 and the size about the mean point; of several
 *                  surfaces the worst. Limit 8 (n + m) 2^-53 times the largest coordinate over the
 *                  size.
 *   boundary       largest distance of a given point from the model's, over the size of those; 0.
 *   continuity     of a neighbour: differences across the edge ([NiWang2015] section 2.6 (3)),
 *                      |Delta^k q_0 - h^k Delta^k p_(n-k)| / (2^k max(1, h)^k size of the nets),
 *                  k up to the contact; limit 8 (n + m) 2^-53 times coordinate over size.
 *   least-bending  certify/biharmonic/bending.h
 */
#include "taut/biharmonic.h"

#include "certify/biharmonic/bending.h"
#include "certify/certify_ops.h"
#include "certify/harmonic/claims.h"
#include "certify/harmonic/residual.h"
#include "core/constants.h"
#include "core/fail.h"
#include "core/memory.h"
#include "measure/integrate/near_zero.h"
#include "taut/limits.h"
#include "taut/measure.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const double roundings = 8;

static double width_of(const taut_basis *basis)
{
    return taut_basis_hi(basis) - taut_basis_lo(basis);
}

static size_t count_of(const taut_surface *surface)
{
    return (size_t)taut_basis_count(taut_surface_u(surface)) *
           (size_t)taut_basis_count(taut_surface_v(surface));
}

/* The scaled residual; *noise what rounding explains. */
static taut_status residual_of(const taut_surface *surface, double *residual, double *noise)
{
    const int n = taut_basis_degree(taut_surface_u(surface));
    const int m = taut_basis_degree(taut_surface_v(surface));
    const double a = width_of(taut_surface_u(surface)), b = width_of(taut_surface_v(surface));
    const double most = fmax(n * n / (a * a), m * m / (b * b));
    const size_t count = count_of(surface), numbers = 3 * count;
    double *net = taut_alloc(2 * numbers, sizeof *net), mean[3] = {0, 0, 0}, reach = 0, size = 0;

    if (net == NULL) {
        return TAUT_NO_MEMORY;
    }
    for (size_t k = 0; k < numbers; k++) {
        mean[k % 3] += taut_surface_points(surface)[k] / (double)count;
    }
    for (size_t k = 0; k < numbers; k++) {
        net[k] = taut_surface_points(surface)[k] - mean[k % 3];
        size = fmax(size, fabs(net[k]));
        reach = fmax(reach, fabs(taut_surface_points(surface)[k]));
    }
    for (int pass = 0; pass < 2; pass++) {
        taut_certify_laplacian(n, m, 1 / (a * a) / most, 1 / (b * b) / most,
                               net + (pass == 0 ? 0 : numbers), net + (pass == 0 ? numbers : 0));
    }
    *residual = 0;
    for (size_t k = 0; k < numbers && size > 0; k++) {
        *residual = fmax(*residual, fabs(net[k]) / size);
    }
    *noise = roundings * (n + m) * TAUT_UNIT_ROUNDOFF * (size > 0 ? fmax(1, reach / size) : 1);
    taut_free(net);
    return TAUT_OK;
}

static taut_status add_biharmonic(const taut_model *model, taut_certificate *certificate)
{
    double worst = -1, residual = 0, limit = 0;
    char where[96] = "";

    for (int k = 0; k < taut_model_surface_count(model); k++) {
        double found = 0, noise = 0;
        if (residual_of(taut_model_surface(model, k), &found, &noise) != TAUT_OK) {
            return TAUT_NO_MEMORY;
        }
        if (!(found / noise <= worst)) {
            worst = found / noise;
            residual = found;
            limit = noise;
            snprintf(where, sizeof where, "surface %.40s, its own rectangle",
                     taut_surface_name(taut_model_surface(model, k)));
        }
    }
    return taut_harmonic_add_claim("biharmonic", residual, limit, where, certificate);
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
            const double apart = fabs(taut_surface_points(found)[3 * k + c] - points[3 * k + c]);
            if (apart > most) {
                most = apart;
                snprintf(where, sizeof where, "/surfaces/0/points, point %zu", k);
            }
        }
    }
    return taut_harmonic_add_claim("boundary", size > 0 ? most / size : most, 0, where,
                                   certificate);
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

/* Delta^k into the surface, and the largest coordinate that took part about the first. */
static double difference(const taut_surface *surface, taut_edge edge, int k, int j, int c,
                         double origin)
{
    double sum = 0, binomial = k % 2 == 0 ? 1 : -1;
    for (int i = 0; i <= k; i++) {
        sum += binomial * (point_from(surface, edge, i, j)[c] - origin);
        binomial *= -(double)(k - i) / (i + 1);
    }
    return sum;
}

static taut_status add_continuity(const taut_surface *p, const taut_surface *q, taut_edge edge,
                                  int contact, taut_certificate *certificate)
{
    const taut_basis *u[2] = {taut_surface_u(p), taut_surface_u(q)};
    const taut_basis *v[2] = {taut_surface_v(p), taut_surface_v(q)};
    const int across = is_along_v(edge), n = taut_basis_degree(across ? u[0] : v[0]);
    const int m = taut_basis_degree(across ? v[0] : u[0]);
    const double h = across ? width_of(u[1]) / width_of(u[0]) : width_of(v[1]) / width_of(v[0]);
    double reach[2], most = 0;
    const double size =
        fmax(taut_certify_extent(taut_surface_points(p), NULL, count_of(p), &reach[0]),
             taut_certify_extent(taut_surface_points(q), NULL, count_of(q), &reach[1]));
    int worst = 0;
    char where[64];

    for (int k = 0; k <= contact && k <= n; k++) {
        const double unit = pow(2 * fmax(1, h), k) * (size > 0 ? size : 1);
        for (int j = 0; j <= m; j++) {
            for (int c = 0; c < 3; c++) {
                const double origin = point_from(p, edge, 0, j)[c];
                const double into = difference(q, opposite(edge), k, j, c, origin);
                const double out = difference(p, edge, k, j, c, origin) * pow(-h, k);
                const double apart = fabs(into - out) / unit;
                worst = apart > most ? k : worst;
                most = fmax(most, apart);
            }
        }
    }
    snprintf(where, sizeof where, "derivative %d across", worst);
    return taut_harmonic_add_claim("continuity", most,
                                   4 * TAUT_UNIT_ROUNDOFF *
                                       fmax(1, size > 0 ? fmax(reach[0], reach[1]) / size : 1),
                                   where, certificate);
}

static taut_status add_bending(const taut_surface *q, taut_edge edge, int contact,
                               taut_certificate *certificate)
{
    taut_surface *moved = NULL; /* second derivatives want parameters with all their digits */
    taut_bending_slope slope;
    char where[96];

    if (!taut_surface_near_zero(q, &moved)) {
        return TAUT_NO_MEMORY;
    }
    slope = taut_bending_slope_of(moved != NULL ? moved : q, opposite(edge), contact);
    taut_surface_free(moved);
    snprintf(where, sizeof where, "along derivative %d across times power %d along", slope.order,
             slope.power);
    return taut_harmonic_add_claim("least-bending", slope.residual, slope.noise, where,
                                   certificate);
}

/* The edge the problem names, or without it the one where the two ranges meet. */
static taut_edge edge_of(const taut_surface *p, const taut_surface *q,
                         const taut_biharmonic_problem *problem)
{
    return problem != NULL ? problem->neighbour.edge : taut_certify_shared_edge(p, q);
}

static taut_status add_neighbour(const taut_model *model, const taut_biharmonic_problem *problem,
                                 taut_certificate *certificate)
{
    const taut_surface *p = taut_model_surface(model, 0), *q = taut_model_surface(model, 1);
    const char *named = taut_record_text(taut_record_get(taut_model_details(model), "contact"));
    const int contact = problem != NULL            ? problem->neighbour.contact
                        : strcmp(named, "c2") == 0 ? 2
                                                   : 1;
    const taut_edge edge = edge_of(p, q, problem);
    taut_status status = add_continuity(p, q, edge, contact, certificate);
    return status == TAUT_OK ? add_bending(q, edge, contact, certificate) : status;
}

static taut_status add_figures(const taut_model *model, taut_certificate *certificate)
{
    const int count = taut_model_surface_count(model);
    taut_record *figures = taut_record_new();
    double energy[2] = {0, 0};
    taut_status status = TAUT_OK;

    for (int i = 0; i < count && i < 2 && status == TAUT_OK; i++) {
        status = taut_surface_bending_energy(taut_model_surface(model, i), &energy[i]);
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
                           taut_certificate *certificate)
{
    taut_status status = add_biharmonic(model, certificate);

    if (status == TAUT_OK && problem != NULL) {
        status = add_given(model, problem, certificate);
    }
    if (status == TAUT_OK && taut_model_surface_count(model) == 2) {
        status = add_neighbour(model, problem, certificate);
    }
    return status == TAUT_OK ? add_figures(model, certificate) : status;
}

static taut_status certify(const taut_model *model, const void *data,
                           const taut_certify_options *options, taut_certificate *certificate,
                           taut_error *error)
{
    const taut_status status = check_model(model, data, error);

    (void)options;
    if (status != TAUT_OK) {
        return status;
    }
    return add_all(model, data, certificate) == TAUT_OK ? TAUT_OK : taut_fail_memory(error);
}

const taut_certify_ops taut_certify_biharmonic = {.certify = certify};
