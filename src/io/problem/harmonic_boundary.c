#include "io/problem/harmonic_boundary.h"

#include "core/fail.h"
#include "io/problem/boundary_document.h"
#include "io/problem/member.h"
#include "taut/operations.h"

#include <string.h>

/* What the document says, and what comes of it. */
typedef struct harmonic_boundary {
    const taut_curve *pair[2];
    int along_u; /* the pair are the edges v0 and v1 */
    int degree;
    double widths[2];
    const taut_basis *bases[2];
    double *points;
    unsigned char *known;
} harmonic_boundary;

static taut_status make_basis(int degree, double width, taut_arena *arena, const taut_basis **basis,
                              taut_error *error)
{
    const taut_basis_spec spec = {
        .type = "bezier", .degree = degree, .has_range = 1, .range = {0, width}};
    taut_basis *made = NULL;
    const taut_status status = taut_basis_new(&spec, 0, &made, error);
    return status == TAUT_OK ? taut_member_keep_basis(arena, made, basis, error) : status;
}

/* The members but the file. */
static taut_status read_choices(const taut_json *document, harmonic_boundary *rows,
                                taut_error *error)
{
    static const char *const pairs[] = {"u", "v", NULL};
    const taut_json widths_at = taut_json_member(document, "widths");
    taut_status status = TAUT_OK;
    rows->along_u = 1;
    rows->widths[0] = rows->widths[1] = 1;
    status = taut_member_word(document, "known", pairs, &rows->along_u, error);
    if (status != TAUT_OK || widths_at.value == NULL) {
        return status;
    }
    status = taut_json_numbers(&widths_at, 2, rows->widths, error);
    if (status == TAUT_OK && !(rows->widths[0] > 0 && rows->widths[1] > 0)) {
        status = taut_json_expected(&widths_at, error, "two positive numbers");
    }
    return status;
}

static int is_polynomial(const taut_curve *curve)
{
    const double *weights = taut_curve_weights(curve);
    const int count = taut_basis_count(taut_curve_t(curve));
    int same = 1;
    for (int i = 1; weights != NULL && i < count; i++) {
        same &= weights[i] == weights[0];
    }
    return same;
}

static taut_status choose_pair(const taut_json *document, const taut_curve *const sides[TAUT_SIDES],
                               harmonic_boundary *rows, taut_error *error)
{
    const taut_json at = taut_json_member(document, "boundary");
    rows->pair[0] = sides[rows->along_u ? TAUT_SIDE_V0 : TAUT_SIDE_U0];
    rows->pair[1] = sides[rows->along_u ? TAUT_SIDE_V1 : TAUT_SIDE_U1];
    for (int k = 0; k < 2; k++) {
        const int n = taut_basis_degree(taut_curve_t(rows->pair[k]));
        rows->degree = n > rows->degree ? n : rows->degree;
        if (!is_polynomial(rows->pair[k])) {
            taut_json_fail(&at, error, "rational", taut_none, taut_none,
                           "the curve \"%.40s\" is rational, but harmonic surfaces are polynomial",
                           taut_curve_name(rows->pair[k]));
            if (error != NULL) {
                error->status = TAUT_NO_SOLUTION;
            }
            return TAUT_NO_SOLUTION;
        }
    }
    return TAUT_OK;
}

/* Puts the points of one curve, raised to the common degree, into its row or column. */
static taut_status lay_curve(harmonic_boundary *rows, int last, taut_error *error)
{
    const int n = rows->degree, times = n - taut_basis_degree(taut_curve_t(rows->pair[last]));
    const taut_curve *curve = rows->pair[last];
    taut_curve *raised = NULL;
    if (times > 0) {
        const taut_status status = taut_curve_elevate(curve, times, &raised, error);
        if (status != TAUT_OK) {
            return status;
        }
        curve = raised;
    }
    for (int k = 0; k <= n; k++) {
        const int other = last ? n : 0;
        const int at = rows->along_u ? k * (n + 1) + other : other * (n + 1) + k;
        memcpy(rows->points + 3 * at, taut_curve_points(curve) + 3 * k, 3 * sizeof(double));
        rows->known[at] = 1;
    }
    taut_curve_free(raised);
    return TAUT_OK;
}

static taut_status fill_net(harmonic_boundary *rows, taut_arena *arena, taut_error *error)
{
    const size_t count = ((size_t)rows->degree + 1) * ((size_t)rows->degree + 1);
    taut_status status = TAUT_OK;
    rows->points = taut_arena_take(arena, 3 * count, sizeof(double));
    rows->known = taut_arena_take(arena, count, 1);
    if (taut_arena_status(arena) != TAUT_OK) {
        return taut_fail_memory(error);
    }
    for (int k = 0; k < 2 && status == TAUT_OK; k++) {
        status = lay_curve(rows, k, error);
    }
    for (int d = 0; d < 2 && status == TAUT_OK; d++) {
        status = make_basis(rows->degree, rows->widths[d], arena, &rows->bases[d], error);
    }
    return status;
}

static taut_status read_rows(const taut_json *document, taut_problem *problem,
                             harmonic_boundary *rows, taut_error *error)
{
    static const char *const others[] = {"u", "v", "points", "from", "edge", "cross_derivative",
                                         NULL};
    const taut_curve *sides[TAUT_SIDES];
    taut_status status = read_choices(document, rows, error);

    if (status != TAUT_OK) {
        return status;
    }
    status = taut_boundary_document_bezier(document, problem, others, 0, sides, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = choose_pair(document, sides, rows, error);
    return status == TAUT_OK ? fill_net(rows, problem->arena, error) : status;
}

taut_status taut_harmonic_boundary_read(const taut_json *document, taut_problem *problem,
                                        taut_harmonic_problem *data, taut_error *error)
{
    harmonic_boundary rows = {.degree = 0};
    const taut_status status = read_rows(document, problem, &rows, error);

    if (status != TAUT_OK) {
        return status;
    }
    data->u = rows.bases[0];
    data->v = rows.bases[1];
    data->rows.points = rows.points;
    data->rows.known = rows.known;
    return TAUT_OK;
}
