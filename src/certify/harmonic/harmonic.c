/* harmonic.c -- is this the harmonic surface with the given edges? Claims:
 *
 *   harmonic   claims.h
 *   boundary   largest distance of a given point from the model's over the size of the data, an
 *              identity of coefficients: the edges have the degrees and ranges that were given. 0
 *              where nothing was moved. Where the problem asks for it, and only then: after "corner"
 *              the last point of the second row may be the one that the others ask for, after
 *              "project" the rows the projected ones, both worked out here; after "raise" the
 *              degree across is one higher. With a derivative: its Bernstein coefficients n (P_1 -
 *              P_0) / a too; limit 8 n 2^-53, the rounding of that difference.
 *   nearest    of four boundary rows, in place of boundary: claims.h. Figures boundary_gap, the
 *              largest distance of the edges from the given rows, and boundary_gap_at.
 */
#include "taut/harmonic.h"

#include "certify/certify_ops.h"
#include "certify/common/bernstein.h"
#include "certify/harmonic/claims.h"
#include "certify/harmonic/residual.h"
#include "core/constants.h"
#include "core/fail.h"

#include <math.h>
#include <stdio.h>

/* What the boundary claim gathers. */
typedef struct boundary {
    double largest, size;
    int i, j;
} boundary;

static void compare(boundary *b, const double *found, const double *given, int i, int j)
{
    for (int c = 0; c < 3; c++) {
        const double apart = fabs(found[c] - given[c]);
        if (!(apart <= b->largest)) {
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

/* How much a "project" moved point j of the rows of even degree m:
 *     (-1)^(m-j) C(m,j) / (2 C(2m,m)) times the defect
 * ([NiWang2015] section 3, B.1). Row 0 moves by +, row 1 by -. */
static double project_weight(int m, int j)
{
    const double sign = (m - j) % 2 == 0 ? 1 : -1;
    return 0.5 * sign * taut_certify_binomial(m, j) / taut_certify_binomial(2 * m, m);
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

/* The two known lines of a problem, and what may have been made of them. */
typedef struct lines {
    int turned;                /* columns are known, not rows */
    int m;                     /* degree along */
    taut_harmonic_even repair; /* TAUT_EVEN_REFUSE: none can be needed */
    double defect[3];
} lines;

static void find_lines(const taut_harmonic_problem *p, lines *l)
{
    const int nu = taut_basis_count(p->u), nv = taut_basis_count(p->v);
    l->turned = nu > 2 && p->rows.known[nv]; /* point (1, 0) is not known where rows are */
    l->m = l->turned ? nu - 1 : nv - 1;
    const int is_whole =
        p->rows.known[nu * nv - 1]; /* without its corner nothing is to be repaired */
    l->repair = nu == nv && l->m % 2 == 0 && is_whole ? p->rows.even : TAUT_EVEN_REFUSE;
    l->defect[0] = l->defect[1] = l->defect[2] = 0;
    if (l->repair != TAUT_EVEN_REFUSE) {
        project_defect(p, l->turned, l->m, l->defect);
    }
}

/* Point j of line `side` as a repair leaves it. */
static void repaired_point(const taut_harmonic_problem *p, const lines *l, int side, int j,
                           double wanted[3])
{
    const double w = l->repair == TAUT_EVEN_PROJECT ? (side == 0 ? 1 : -1) * project_weight(l->m, j)
                     : l->repair == TAUT_EVEN_CORNER && side == 1 && j == l->m ? -1
                                                                               : 0;
    for (int c = 0; c < 3; c++) {
        wanted[c] = given_point(p, l->turned, side, j)[c] + w * l->defect[c];
    }
}

/* Two lines against the model's: as they were given, and as a repair leaves them. */
static void compare_lines(const taut_surface *surface, const taut_harmonic_problem *p,
                          const lines *l, boundary *given, boundary *repaired)
{
    const int nu = taut_basis_count(p->u), nv = taut_basis_count(p->v);
    const int rows = taut_basis_count(taut_surface_u(surface));
    const int columns = taut_basis_count(taut_surface_v(surface));

    for (int side = 0; side < 2; side++) {
        for (int j = 0; j <= l->m; j++) {
            const int i = l->turned ? j : side * (rows - 1),
                      k = l->turned ? side * (columns - 1) : j;
            const int given_i = l->turned ? j : side * (nu - 1);
            const int given_j = l->turned ? side * (nv - 1) : j;
            const double *found = taut_surface_points(surface) + 3 * (i * columns + k);
            double wanted[3];
            if (!p->rows.known[given_i * nv + given_j]) {
                continue;
            }
            compare(given, found, given_point(p, l->turned, side, j), i, k);
            repaired_point(p, l, side, j, wanted);
            compare(repaired, found, wanted, i, k);
        }
    }
}

/* The lines as given, or where the problem lets them be repaired as repaired, whichever is nearer:
 * a defect that rounding explains is let be. *limit is 0 for lines as given. The corner is 2^m times
 * as uncertain as the others. */
static void judge_lines(const taut_surface *surface, const taut_harmonic_problem *p, boundary *b,
                        double *limit)
{
    boundary repaired = *b;
    double reach = 0;
    lines l;

    find_lines(p, &l);
    compare_lines(surface, p, &l, b, &repaired);
    if ((l.repair == TAUT_EVEN_PROJECT || l.repair == TAUT_EVEN_CORNER) &&
        !(b->largest <= repaired.largest)) {
        (void)taut_certify_extent(p->rows.points, p->rows.known,
                                  (size_t)taut_basis_count(p->u) * (size_t)taut_basis_count(p->v),
                                  &reach);
        *b = repaired;
        *limit = 8 * l.m * TAUT_UNIT_ROUNDOFF * fmax(1, reach / b->size) *
                 (l.repair == TAUT_EVEN_CORNER ? ldexp(1, l.m) : 1);
    }
}

/* Has the model the degrees and ranges that the problem leads to? */
static int has_bases(const taut_surface *surface, const taut_harmonic_problem *p)
{
    const taut_basis *asked[2] = {p->u, p->v};
    const taut_basis *found[2] = {taut_surface_u(surface), taut_surface_v(surface)};
    int raised = -1; /* the direction that may be one degree higher */

    if (p->given == TAUT_HARMONIC_ROWS) {
        lines l;
        find_lines(p, &l);
        raised = l.repair == TAUT_EVEN_RAISE ? l.turned : -1;
    } else if (p->given == TAUT_HARMONIC_DERIVATIVE && p->derivative.raise) {
        raised = 0;
    }
    for (int d = 0; d < 2; d++) {
        const int more = taut_basis_degree(found[d]) - taut_basis_degree(asked[d]);
        if (more < 0 || more > (raised == d) ||
            taut_basis_lo(found[d]) != taut_basis_lo(asked[d]) ||
            taut_basis_hi(found[d]) != taut_basis_hi(asked[d])) {
            return 0;
        }
    }
    return 1;
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
                                const taut_crew *crew, taut_certificate *certificate,
                                taut_error *error)
{
    const taut_surface *surface = taut_model_surface(model, 0);
    const int nu = taut_basis_count(p->u), nv = taut_basis_count(p->v);
    const int n = taut_basis_degree(taut_surface_u(surface));
    boundary b = {0, 1, 0, 0};
    char where[64] = "";
    double limit = 0;

    if (!has_bases(surface, p)) {
        return taut_fail(error, TAUT_BAD_INPUT, "model", "/surfaces/0", taut_none, taut_none,
                         "the model and the problem do not belong together");
    }
    if (p->given == TAUT_HARMONIC_BOUNDARY) {
        return taut_harmonic_add_nearest(surface, p, crew, certificate);
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
        judge_lines(surface, p, &b, &limit);
    }
    if (b.largest > 0) {
        snprintf(where, sizeof where, "/surfaces/0/points/%d/%d", b.i, b.j);
    }
    return taut_harmonic_add_claim("boundary", TAUT_EXACT, b.largest / b.size, limit, where,
                                   certificate);
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
                           const taut_audit *audit, taut_certificate *certificate,
                           taut_error *error)
{
    taut_record *figures = NULL;
    taut_status status = taut_harmonic_add_harmonic(model, audit->exact, 0, certificate, error);

    if (status == TAUT_OK && problem != NULL) {
        status = add_boundary(model, problem, &audit->crew, certificate, error);
    }
    if (status != TAUT_OK) {
        return status;
    }
    figures = taut_record_new();
    status = taut_harmonic_add_figures(model, &audit->crew, figures);
    add_gap(model, problem, figures);
    taut_certificate_set_figures(certificate, figures);
    return status == TAUT_OK ? taut_record_status(figures) : status;
}

static taut_status certify(const taut_model *model, const void *data, const taut_audit *audit,
                           taut_certificate *certificate, taut_error *error)
{
    taut_status status = taut_harmonic_check_model(model, 1, error);

    if (status != TAUT_OK) {
        return status;
    }
    status = add_all(model, data, audit, certificate, error);
    return status == TAUT_NO_MEMORY ? taut_fail_memory(error) : status;
}

/* A bezier basis over the range given, of the degree given or, raised, of one more. */
static taut_expected_basis expected_basis(const taut_basis *basis, double range[2])
{
    const int degree = taut_basis_degree(basis);
    range[0] = taut_basis_lo(basis);
    range[1] = taut_basis_hi(basis);
    return (taut_expected_basis){.type = "bezier", .degree = {degree, degree + 1}, .range = range};
}

/* Without the problem every surface of the model is judged. */
static void identify(const taut_model *model, const void *data, taut_identity *identity)
{
    const taut_harmonic_problem *problem = data;
    double ranges[2][2];

    for (int i = 0; problem == NULL && i < taut_model_surface_count(model); i++) {
        taut_identity_surface(identity, i, NULL, NULL, NULL);
    }
    if (problem != NULL) {
        const taut_expected_basis u = expected_basis(problem->u, ranges[0]);
        const taut_expected_basis v = expected_basis(problem->v, ranges[1]);
        taut_identity_surface(identity, 0, problem->name != NULL ? problem->name : "harmonic", &u,
                              &v);
    }
}

const taut_certify_ops taut_certify_harmonic = {
    .certify = certify, .identify = identify, .exact = 1};

taut_status taut_harmonic_certify(const taut_model *model, const taut_harmonic_problem *problem,
                                  const taut_certify_options *options,
                                  taut_certificate **certificate, taut_error *error)
{
    return taut_certify_with(&taut_certify_harmonic, "harmonic", model, problem, options,
                             certificate, error);
}
