/* harmonic.c -- is this the harmonic surface with the given edges? Claims:
 *
 *   harmonic   claims.h
 *   boundary   largest distance of a given point from the model's over the size of the data; 0
 *              where nothing was moved. After "corner" the last point of the second row is left out,
 *              after "project" the rows are compared with the projected ones, worked out here. With
 *              a derivative: its Bernstein coefficients n (P_1 - P_0) / a too; limit 8 n 2^-53, the
 *              rounding of that difference.
 *   nearest    of four boundary rows, in place of boundary: claims.h. Figures boundary_gap, the
 *              largest distance of the edges from the given rows, and boundary_gap_at.
 */
#include "taut/harmonic.h"

#include "certify/certify_ops.h"
#include "certify/harmonic/claims.h"
#include "certify/harmonic/residual.h"
#include "core/constants.h"
#include "core/fail.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* What the boundary claim gathers. */
typedef struct boundary {
    double largest, size;
    int i, j;
} boundary;

static void compare(boundary *b, const double *found, const double *given, int i, int j)
{
    for (int c = 0; c < 3; c++) {
        const double apart = fabs(found[c] - given[c]);
        if (apart > b->largest) {
            b->largest = apart;
            b->i = i;
            b->j = j;
        }
    }
}

/* Half the largest extent of the given points. */
static double size_of(const double *points, const unsigned char *known, int count)
{
    double reach = 0;
    const double size = taut_certify_extent(points, known, (size_t)count, &reach);
    return size > 0 ? size : 1;
}

static const char *repair_of(const taut_model *model)
{
    return taut_record_text(
        taut_record_get(taut_record_get(taut_model_details(model), "repair"), "kind"));
}

/* How much a "project" moved point j of the rows of even degree m:
 *     (-1)^(m-j) C(m,j) / (2 C(2m,m)) times the defect
 * ([NiWang2015] section 3, B.1). Row 0 moves by +, row 1 by -. */
static double project_weight(int m, int j)
{
    const double sign = (m - j) % 2 == 0 ? 1 : -1;
    return 0.5 * sign *
           exp(3 * lgamma(m + 1.0) - lgamma(j + 1.0) - lgamma(m - j + 1.0) - lgamma(2 * m + 1.0));
}

/* Point j of line `side` (0 or 1) of the problem, turned so that the known lines are rows. */
static const double *given_point(const taut_harmonic_problem *p, int turned, int side, int j)
{
    const int nu = taut_basis_count(p->u), nv = taut_basis_count(p->v);
    const int row = turned ? j : side * (nu - 1), column = turned ? side * (nv - 1) : j;
    return p->rows.points + 3 * (row * nv + column);
}

static void project_defect(const taut_harmonic_problem *p, int turned, int m, double defect[3])
{
    for (int c = 0; c < 3; c++) {
        double binomial = m % 2 == 0 ? 1 : -1;
        defect[c] = 0;
        for (int j = 0; j <= m; j++) {
            defect[c] +=
                binomial * (given_point(p, turned, 1, j)[c] - given_point(p, turned, 0, j)[c]);
            binomial *= -(double)(m - j) / (j + 1);
        }
    }
}

/* Two lines against the model's. */
static void compare_lines(const taut_model *model, const taut_harmonic_problem *p, boundary *b)
{
    const taut_surface *surface = taut_model_surface(model, 0);
    const double *points = taut_surface_points(surface);
    const int nu = taut_basis_count(p->u), nv = taut_basis_count(p->v);
    const int rows = taut_basis_count(taut_surface_u(surface));
    const int columns = taut_basis_count(taut_surface_v(surface));
    const int turned = nu > 2 && !p->rows.known[nv]; /* point (1, 0) is not known where rows are */
    const int columns_known = nu > 2 && p->rows.known[nv];
    const int is_turned = turned ? 0 : columns_known;
    const int m = is_turned ? nu - 1 : nv - 1;
    const char *repair = repair_of(model);
    double defect[3] = {0, 0, 0};

    if (strcmp(repair, "project") == 0) {
        project_defect(p, is_turned, m, defect);
    }
    for (int side = 0; side < 2; side++) {
        for (int j = 0; j <= m; j++) {
            const int i = is_turned ? j : side * (rows - 1),
                      k = is_turned ? side * (columns - 1) : j;
            const int given_i = is_turned ? j : side * (nu - 1);
            const int given_j = is_turned ? side * (nv - 1) : j;
            const double w = (side == 0 ? 1 : -1) * project_weight(m, j);
            double wanted[3];
            if (!p->rows.known[given_i * nv + given_j] ||
                (side == 1 && j == m && strcmp(repair, "corner") == 0)) {
                continue;
            }
            for (int c = 0; c < 3; c++) {
                wanted[c] = given_point(p, is_turned, side, j)[c] + w * defect[c];
            }
            compare(b, points + 3 * (i * columns + k), wanted, i, k);
        }
    }
}

/* The edge, and n (P_1 - P_0) / a. */
static void compare_derivative(const taut_surface *surface, const taut_harmonic_problem *p,
                               boundary *b)
{
    const taut_basis *u = taut_surface_u(surface);
    const double *points = taut_surface_points(surface);
    const int n = taut_basis_degree(u), columns = taut_basis_count(taut_surface_v(surface));
    const double width = taut_basis_hi(u) - taut_basis_lo(u);

    for (int j = 0; j < columns; j++) {
        double first[3], wanted[3];
        compare(b, points + 3 * j, p->derivative.edge + 3 * j, 0, j);
        for (int c = 0; c < 3; c++) { /* as positions: P_1 against P_0 + a d / n */
            first[c] = points[3 * (columns + j) + c];
            wanted[c] = p->derivative.edge[3 * j + c] + p->derivative.cross[3 * j + c] * width / n;
        }
        compare(b, first, wanted, 1, j);
    }
}

static taut_status add_boundary(const taut_model *model, const taut_harmonic_problem *p,
                                taut_certificate *certificate, taut_error *error)
{
    const taut_surface *surface = taut_model_surface(model, 0);
    const int nu = taut_basis_count(p->u), nv = taut_basis_count(p->v);
    const int n = taut_basis_degree(taut_surface_u(surface));
    boundary b = {0, 1, 0, 0};
    char where[64] = "";
    double limit = 0;

    if (taut_basis_count(taut_surface_v(surface)) < nv ||
        taut_basis_count(taut_surface_u(surface)) < nu ||
        (p->given == TAUT_HARMONIC_BOUNDARY &&
         (!taut_basis_equal(taut_surface_u(surface), p->u) ||
          !taut_basis_equal(taut_surface_v(surface), p->v)))) {
        return taut_fail(error, TAUT_BAD_INPUT, "model", "/surfaces/0", taut_none, taut_none,
                         "the model and the problem do not belong together");
    }
    if (p->given == TAUT_HARMONIC_BOUNDARY) {
        return taut_harmonic_add_nearest(surface, p, certificate);
    }
    if (p->given == TAUT_HARMONIC_DERIVATIVE) {
        b.size = size_of(p->derivative.edge, NULL, nv);
        compare_derivative(surface, p, &b);
        limit = 8 * n * TAUT_UNIT_ROUNDOFF;
        for (int k = 0; k < 3 * nv; k++) { /* coordinates far from the origin round more */
            limit = fmax(limit, 4 * TAUT_UNIT_ROUNDOFF * fabs(p->derivative.edge[k]) / b.size);
        }
    } else {
        b.size = size_of(p->rows.points, p->rows.known, nu * nv);
        compare_lines(model, p, &b);
        limit = repair_of(model)[0] != '\0' && strcmp(repair_of(model), "project") == 0
                    ? 8 * n * TAUT_UNIT_ROUNDOFF
                    : 0;
    }
    if (b.largest > 0) {
        snprintf(where, sizeof where, "/surfaces/0/points/%d/%d", b.i, b.j);
    }
    return taut_harmonic_add_claim("boundary", b.largest / b.size, limit, where, certificate);
}

/* Of four boundary rows: how far the edges are from what was given. */
static void add_gap(const taut_model *model, const taut_harmonic_problem *p, taut_record *figures)
{
    if (p != NULL && p->given == TAUT_HARMONIC_BOUNDARY) {
        double gap = 0, at[2] = {0, 0};
        taut_harmonic_fit_gap(taut_model_surface(model, 0), p, &gap, at);
        taut_record_add_number(figures, "boundary_gap", gap);
        taut_record_add_numbers(figures, "boundary_gap_at", 2, at);
    }
}

/* The claims, and figures: every other failure than these tell of is one of memory. */
static taut_status add_all(const taut_model *model, const taut_harmonic_problem *problem,
                           const taut_certify_options *options, taut_certificate *certificate,
                           taut_error *error)
{
    taut_record *figures = NULL;
    taut_status status = taut_harmonic_add_harmonic(model, options->exact, 0, certificate, error);

    if (status == TAUT_OK && problem != NULL) {
        status = add_boundary(model, problem, certificate, error);
    }
    if (status != TAUT_OK) {
        return status;
    }
    figures = taut_record_new();
    status = taut_harmonic_add_figures(model, figures);
    add_gap(model, problem, figures);
    taut_certificate_set_figures(certificate, figures);
    return status == TAUT_OK ? taut_record_status(figures) : status;
}

static taut_status certify(const taut_model *model, const void *data,
                           const taut_certify_options *options, taut_certificate *certificate,
                           taut_error *error)
{
    taut_status status = taut_harmonic_check_model(model, 1, error);

    if (status != TAUT_OK) {
        return status;
    }
    status = add_all(model, data, options, certificate, error);
    return status == TAUT_NO_MEMORY ? taut_fail_memory(error) : status;
}

const taut_certify_ops taut_certify_harmonic = {.certify = certify, .exact = 1};
