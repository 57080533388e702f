/* harmonic.c -- the problem `harmonic`: two opposite rows, out of the document or out of a file of
 * curves, or a row and the derivative across it, or four rows (docs/format.md). */
#include "taut/harmonic.h"
#include "core/fail.h"
#include "geometry/keep.h"
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
static void read_basis(taut_reader *document, const char *key, taut_arena *arena,
                       const taut_basis **basis)
{
    static const char *const any[] = {"type", "degree", "range", NULL};
    const taut_json at = taut_json_member(document->object, key);
    taut_reader in = taut_reader_inside(document, &at, any);
    int n = 0;

    taut_reader_integer(&in, "degree", 1, TAUT_DEGREE_MAX, &n);
    document->status = in.status == TAUT_OK
                           ? taut_basis_document_keep(&at, n + 1, arena, basis, document->error)
                           : in.status;
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
static void read_row(taut_reader *document, const char *key, int count, taut_arena *arena,
                     const double **row, const char *const **texts)
{
    const taut_json at = taut_json_member(document->object, key);
    double *points = taut_arena_take(arena, 3 * (size_t)count, sizeof(double));
    size_t found = 0;

    taut_reader_array(document, key, (size_t)count, (size_t)count, "points", &found);
    if (document->status == TAUT_OK) {
        document->status =
            points != NULL ? taut_net_document_points(&at, 0, count, points, NULL, document->error)
                           : taut_fail_memory(document->error);
    }
    if (document->status == TAUT_OK) {
        *row = points;
        document->status = read_texts(&at, 0, count, arena, texts, document->error);
    }
}

static void read_derivative(taut_reader *document, taut_arena *arena, taut_harmonic_problem *data)
{
    static const char *const strangers[] = {"points", NULL};
    taut_harmonic_derivative *const given = &data->derivative;

    taut_member_refuse(document, strangers,
                       "beside \"from\": the edge and the derivative across it say all");
    data->given = TAUT_HARMONIC_DERIVATIVE;
    read_basis(document, "u", arena, &data->u);
    read_basis(document, "v", arena, &data->v);
    if (document->status == TAUT_OK) {
        const int count = taut_basis_count(data->v);
        read_row(document, "edge", count, arena, &given->edge, &given->exact_edge);
        read_row(document, "cross_derivative", count, arena, &given->cross, &given->exact_cross);
    }
}

static void read_net(taut_reader *document, taut_arena *arena, taut_harmonic_problem *data)
{
    static const char *const strangers[] = {"edge", "cross_derivative", NULL};
    const taut_json points = taut_json_member(document->object, "points");
    taut_net_document net = {NULL, NULL, NULL, NULL, NULL};

    taut_net_document_read(document, arena, &net);
    taut_member_refuse(document, strangers, "without \"from\": \"derivative\"");
    taut_member_check_bezier(document, "u", net.u);
    taut_member_check_bezier(document, "v", net.v);
    data->u = net.u;
    data->v = net.v;
    data->rows.points = net.points;
    data->rows.known = net.known;
    if (document->status == TAUT_OK) {
        document->status = read_texts(&points, taut_basis_count(net.u), taut_basis_count(net.v),
                                      arena, &data->rows.exact, document->error);
    }
}

/* "fit" takes four boundary rows as they are, in place of two. */
static void read_fit(taut_reader *document, taut_harmonic_problem *data)
{
    const taut_json at = taut_json_member(document->object, "fit");
    const int derivative = data->given == TAUT_HARMONIC_DERIVATIVE;
    int fit = 0;

    taut_reader_flag(document, "fit", &fit);
    if (document->status == TAUT_OK && fit && (derivative || taut_reader_has(document, "even"))) {
        document->status =
            taut_json_fail(&at, document->error, "conflict", taut_none, taut_none,
                           "found \"fit\" beside \"%s\": it takes four boundary rows as they are",
                           derivative ? "from" : "even");
    } else if (fit) {
        const taut_harmonic_boundary boundary = {data->rows.points, data->rows.known};
        data->given = TAUT_HARMONIC_BOUNDARY;
        data->boundary = boundary;
    }
}

/* What to do where data of even degree does not agree, and whatever the rounding. */
static void read_choices(taut_reader *document, taut_harmonic_problem *data)
{
    static const char *const repairs[] = {"refuse", "corner", "project", "raise", NULL};
    const taut_json at = taut_json_member(document->object, "even");
    int even = TAUT_EVEN_REFUSE, allow = 0;

    taut_reader_optional_word(document, "even", repairs, &even);
    if (document->status == TAUT_OK && data->given == TAUT_HARMONIC_DERIVATIVE &&
        (even == TAUT_EVEN_CORNER || even == TAUT_EVEN_PROJECT)) {
        document->status =
            taut_json_expected(&at, document->error, "\"refuse\" or \"raise\", with a derivative");
    }
    taut_member_allow_ill_conditioned(document, &allow);
    if (data->given == TAUT_HARMONIC_DERIVATIVE) {
        data->derivative.raise = even == TAUT_EVEN_RAISE;
        data->derivative.allow_ill_conditioned = allow;
    } else if (data->given == TAUT_HARMONIC_ROWS) {
        data->rows.even = (taut_harmonic_even)even;
        data->rows.allow_ill_conditioned = allow;
    }
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
    if (status == TAUT_OK && !taut_keep_basis(arena, made)) {
        return taut_fail_memory(error);
    }
    *basis = made;
    return status;
}

/* "known" and "widths". */
static void read_sides(taut_reader *document, harmonic_boundary *rows)
{
    static const char *const pairs[] = {"u", "v", NULL};
    const taut_json widths = taut_json_member(document->object, "widths");

    rows->along_u = 1;
    rows->widths[0] = rows->widths[1] = 1;
    taut_reader_optional_word(document, "known", pairs, &rows->along_u);
    if (widths.value != NULL) {
        taut_reader_numbers(document, "widths", 2, rows->widths);
    }
    if (document->status == TAUT_OK && !(rows->widths[0] > 0 && rows->widths[1] > 0)) {
        document->status = taut_json_expected(&widths, document->error, "two positive numbers");
    }
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

/* Two opposite curves of the file "boundary", those that "known" names, become the known rows of
 * bidegree (n, n) over [0, a] x [0, b], "widths": [a, b]; the other two only say which ends face
 * each other. */
static void read_boundary(taut_reader *document, taut_problem *problem, taut_harmonic_problem *data)
{
    static const char *const others[] = {"u", "v", "points", "from", "edge", "cross_derivative",
                                         NULL};
    const taut_curve *sides[TAUT_SIDES];
    harmonic_boundary rows = {.degree = 0};

    read_sides(document, &rows);
    taut_boundary_document_bezier(document, problem, others, 0, sides);
    if (document->status == TAUT_OK) {
        document->status = choose_pair(document->object, sides, &rows, document->error);
    }
    if (document->status == TAUT_OK) {
        document->status = fill_net(&rows, problem->arena, document->error);
    }
    data->u = rows.bases[0];
    data->v = rows.bases[1];
    data->rows.points = rows.points;
    data->rows.known = rows.known;
}

static void harmonic_read(taut_reader *document, taut_problem *problem, void *into)
{
    static const char *const sources[] = {"derivative", NULL};
    taut_harmonic_problem *const data = into;
    int word = 0;

    taut_reader_optional_word(document, "from", sources, &word);
    if (taut_boundary_document_is(document)) {
        read_boundary(document, problem, data);
    } else if (taut_reader_has(document, "from")) {
        read_derivative(document, problem->arena, data);
    } else {
        read_net(document, problem->arena, data);
    }
    taut_member_name(document, problem->arena, &data->name);
    read_fit(document, data);
    read_choices(document, data);
}

const taut_document_ops taut_document_harmonic = {
    .members = members,
    .size = sizeof(taut_harmonic_problem),
    .read = harmonic_read,
};
