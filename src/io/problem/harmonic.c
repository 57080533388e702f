/* harmonic.c -- the problem `harmonic`: two opposite rows, out of the document or out of a file of
 * curves, or a row and the derivative across it, or four rows (docs/format.md). */
#include "taut/harmonic.h"
#include "core/fail.h"
#include "io/model/basis.h"
#include "io/problem/boundary_document.h"
#include "io/problem/document_ops.h"
#include "io/problem/member.h"
#include "io/problem/net_document.h"
#include "taut/operations.h"

#include <string.h>

static const char *const members[] = {"name",
                                      "u",
                                      "v",
                                      "points",
                                      "from",
                                      "edge",
                                      "cross_derivative",
                                      "even",
                                      "allow_ill_conditioned",
                                      "insist",
                                      "boundary",
                                      "known",
                                      "widths",
                                      "fit",
                                      NULL};

/* A bezier basis says itself how many functions it has. */
static taut_status read_basis(const taut_json *document, const char *key, taut_arena *arena,
                              const taut_basis **basis, taut_error *error)
{
    static const char *const any[] = {"type", "degree", "range", NULL};
    const taut_json at = taut_json_member(document, key);
    const taut_json degree = taut_json_member(&at, "degree");
    taut_basis *made = NULL;
    int n = 0;
    taut_status status = taut_json_object(&at, any, error);

    if (status != TAUT_OK) {
        return status;
    }
    status = taut_json_integer(&degree, 1, TAUT_DEGREE_MAX, &n, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = taut_basis_document_read(&at, n + 1, &made, error);
    return status == TAUT_OK ? taut_member_keep_basis(arena, made, basis, error) : status;
}

/* The texts of rational coordinates; NULL where all are numbers. */
static taut_status read_texts(const taut_json *at, int rows, int columns, taut_arena *arena,
                              const char *const **texts, taut_error *error)
{
    const size_t count = 3 * (size_t)(rows > 0 ? rows : 1) * (size_t)columns;
    const char **found = taut_arena_take(arena, count, sizeof *found);
    int any = 0;

    if (found == NULL) {
        return taut_fail_memory(error);
    }
    taut_net_document_texts(at, rows, columns, found, &any);
    for (size_t k = 0; any && k < count; k++) {
        if (found[k] != NULL) {
            found[k] = taut_arena_text(arena, found[k]);
            if (found[k] == NULL) {
                return taut_fail_memory(error);
            }
        }
    }
    *texts = any ? found : NULL;
    return TAUT_OK;
}

/* A list of `count` points. */
static taut_status read_row(const taut_json *document, const char *key, int count,
                            taut_arena *arena, const double **row, const char *const **texts,
                            taut_error *error)
{
    const taut_json at = taut_json_member(document, key);
    double *points = taut_arena_take(arena, 3 * (size_t)count, sizeof(double));
    size_t found = 0;
    taut_status status = TAUT_OK;

    if (points == NULL) {
        return taut_fail_memory(error);
    }
    status = taut_json_array(&at, (size_t)count, (size_t)count, "points", &found, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = taut_net_document_points(&at, 0, count, points, NULL, error);
    if (status != TAUT_OK) {
        return status;
    }
    *row = points;
    return read_texts(&at, 0, count, arena, texts, error);
}

static taut_status read_derivative(const taut_json *document, taut_arena *arena,
                                   taut_harmonic_problem *data, taut_error *error)
{
    static const char *const strangers[] = {"points", NULL};
    taut_harmonic_derivative *given = &data->derivative;
    taut_status status =
        taut_member_refuse(document, strangers,
                           "beside \"from\": the edge and the derivative across it say all", error);

    if (status != TAUT_OK) {
        return status;
    }
    data->given = TAUT_HARMONIC_DERIVATIVE;
    status = read_basis(document, "u", arena, &data->u, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = read_basis(document, "v", arena, &data->v, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = read_row(document, "edge", taut_basis_count(data->v), arena, &given->edge,
                      &given->exact_edge, error);
    if (status != TAUT_OK) {
        return status;
    }
    return read_row(document, "cross_derivative", taut_basis_count(data->v), arena, &given->cross,
                    &given->exact_cross, error);
}

static taut_status read_net(const taut_json *document, taut_arena *arena,
                            taut_harmonic_problem *data, taut_error *error)
{
    static const char *const strangers[] = {"edge", "cross_derivative", NULL};
    const taut_json points = taut_json_member(document, "points");
    taut_net_document net = {NULL, NULL, NULL, NULL, NULL};
    taut_status status = taut_net_document_read(document, arena, &net, error);

    if (status != TAUT_OK) {
        return status;
    }
    status = taut_member_refuse(document, strangers, "without \"from\": \"derivative\"", error);
    if (status != TAUT_OK) {
        return status;
    }
    status = taut_member_check_bezier(document, "u", net.u, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = taut_member_check_bezier(document, "v", net.v, error);
    if (status != TAUT_OK) {
        return status;
    }
    data->u = net.u;
    data->v = net.v;
    data->rows.points = net.points;
    data->rows.known = net.known;
    return read_texts(&points, taut_basis_count(net.u), taut_basis_count(net.v), arena,
                      &data->rows.exact, error);
}

/* "fit" takes four boundary rows as they are, in place of two. */
static taut_status read_fit(const taut_json *document, taut_harmonic_problem *data,
                            taut_error *error)
{
    const taut_json at = taut_json_member(document, "fit");
    const int derivative = data->given == TAUT_HARMONIC_DERIVATIVE;
    int fit = 0;
    const taut_status status = taut_json_flag(document, "fit", &fit, error);

    if (status != TAUT_OK || !fit) {
        return status;
    }
    if (derivative || taut_json_member(document, "even").value != NULL) {
        return taut_json_fail(&at, error, "conflict", taut_none, taut_none,
                              "found \"fit\" beside \"%s\": it takes four boundary rows as they "
                              "are",
                              derivative ? "from" : "even");
    }
    const taut_harmonic_boundary boundary = {data->rows.points, data->rows.known};
    data->given = TAUT_HARMONIC_BOUNDARY;
    data->boundary = boundary;
    return TAUT_OK;
}

/* What to do where data of even degree does not agree, and whatever the rounding. */
static taut_status read_choices(const taut_json *document, taut_harmonic_problem *data,
                                taut_error *error)
{
    static const char *const repairs[] = {"refuse", "corner", "project", "raise", NULL};
    const taut_json at = taut_json_member(document, "even");
    int even = TAUT_EVEN_REFUSE, allow = 0;
    taut_status status = taut_member_word(document, "even", repairs, &even, error);

    if (status != TAUT_OK) {
        return status;
    }
    if (data->given == TAUT_HARMONIC_DERIVATIVE &&
        (even == TAUT_EVEN_CORNER || even == TAUT_EVEN_PROJECT)) {
        return taut_json_expected(&at, error, "\"refuse\" or \"raise\", with a derivative");
    }
    status = taut_member_allow_ill_conditioned(document, &allow, error);
    if (status != TAUT_OK) {
        return status;
    }
    if (data->given == TAUT_HARMONIC_DERIVATIVE) {
        data->derivative.raise = even == TAUT_EVEN_RAISE;
        data->derivative.allow_ill_conditioned = allow;
    } else if (data->given == TAUT_HARMONIC_ROWS) {
        data->rows.even = (taut_harmonic_even)even;
        data->rows.allow_ill_conditioned = allow;
    }
    return TAUT_OK;
}

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

/* "known" and "widths". */
static taut_status read_sides(const taut_json *document, harmonic_boundary *rows, taut_error *error)
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

static taut_status read_boundary_rows(const taut_json *document, taut_problem *problem,
                                      harmonic_boundary *rows, taut_error *error)
{
    static const char *const others[] = {"u", "v", "points", "from", "edge", "cross_derivative",
                                         NULL};
    const taut_curve *sides[TAUT_SIDES];
    taut_status status = read_sides(document, rows, error);

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

/* Two opposite curves of the file "boundary", those that "known" names, become the known rows of
 * bidegree (n, n) over [0, a] x [0, b], "widths": [a, b]; the other two only say which ends face
 * each other. */
static taut_status read_boundary(const taut_json *document, taut_problem *problem,
                                 taut_harmonic_problem *data, taut_error *error)
{
    harmonic_boundary rows = {.degree = 0};
    const taut_status status = read_boundary_rows(document, problem, &rows, error);

    if (status != TAUT_OK) {
        return status;
    }
    data->u = rows.bases[0];
    data->v = rows.bases[1];
    data->rows.points = rows.points;
    data->rows.known = rows.known;
    return TAUT_OK;
}

static taut_status read_given(const taut_json *document, taut_problem *problem,
                              taut_harmonic_problem *data, taut_error *error)
{
    static const char *const sources[] = {"derivative", NULL};
    const taut_json from = taut_json_member(document, "from");
    int word = 0;
    const taut_status status = taut_member_word(document, "from", sources, &word, error);

    if (status != TAUT_OK) {
        return status;
    }
    return taut_boundary_document_is(document) ? read_boundary(document, problem, data, error)
           : from.value != NULL ? read_derivative(document, problem->arena, data, error)
                                : read_net(document, problem->arena, data, error);
}

static taut_status harmonic_read(const taut_json *document, taut_problem *problem,
                                 taut_error *error)
{
    taut_harmonic_problem *data = taut_arena_take(problem->arena, 1, sizeof *data);
    taut_status status = TAUT_OK;

    if (data == NULL) {
        return taut_fail_memory(error);
    }
    problem->data = data;
    status = read_given(document, problem, data, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = taut_member_name(document, problem->arena, &data->name, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = read_fit(document, data, error);
    return status == TAUT_OK ? read_choices(document, data, error) : status;
}

const taut_document_ops taut_document_harmonic = {
    .members = members,
    .read = harmonic_read,
};
