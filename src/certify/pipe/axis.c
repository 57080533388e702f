#include "certify/pipe/axis.h"

#include "certify/common/bernstein.h"
#include "certify/pipe/circle.h"
#include "core/constants.h"
#include "core/fail.h"
#include "core/vec3.h"
#include "numeric/quadrature.h"
#include "numeric/sum.h"
#include "taut/operations.h"

#include <math.h>
#include <string.h>

enum { GAUSS = 12, DEPTH_MAX = 40, INTERVALS = 8, INTEGRALS = 4, HALVINGS = 4000 };

/* The differences of each order, each then evaluated by de Casteljau's algorithm. */
void taut_pipe_piece_eval(const taut_pipe_piece *piece, double t, int order, double (*d)[3])
{
    double differences[TAUT_PIPE_PIECE_DEGREE + 1][3];
    double factor = 1;
    memcpy(differences, piece->points, sizeof differences);
    for (int k = 0; k <= order; k++) {
        const int n = piece->degree - k;
        double b[TAUT_PIPE_PIECE_DEGREE + 1][3] = {{0, 0, 0}};
        for (int i = 0; i <= n; i++) {
            memcpy(b[i], differences[i], sizeof b[i]);
        }
        for (int level = n; level > 0; level--) {
            for (int i = 0; i < level; i++) {
                for (int c = 0; c < 3; c++) {
                    b[i][c] += t * (b[i + 1][c] - b[i][c]);
                }
            }
        }
        for (int c = 0; c < 3; c++) {
            d[k][c] = factor * b[0][c];
        }
        for (int i = 0; i < n; i++) {
            taut_difference(differences[i + 1], differences[i], differences[i]);
        }
        factor *= n;
    }
}

double taut_pipe_piece_curvature(const taut_pipe_piece *piece, double t)
{
    double d[3][3], cross[3], speed = 0;
    if (piece->radius > 0) {
        return 1 / piece->radius;
    }
    taut_pipe_piece_eval(piece, t, 2, d);
    taut_cross(d[1], d[2], cross);
    speed = taut_norm(d[1]);
    return speed > 0 ? taut_norm(cross) / (speed * speed * speed) : 0;
}

static double power_below(double size)
{
    int exponent = 0;
    (void)frexp(size, &exponent);
    return size > 0 ? ldexp(1, exponent - 1) : 1;
}

/* Origin, scale and noise, of all curves together. */
static void set_coordinates(const taut_curve *const *curves, int count, taut_pipe_line *line)
{
    double size = 0, largest = 0;
    memcpy(line->origin, taut_curve_points(curves[0]), sizeof line->origin);
    for (int c = 0; c < count; c++) {
        const double *points = taut_curve_points(curves[c]);
        for (int i = 0; i < 3 * taut_basis_count(taut_curve_t(curves[c])); i++) {
            size = fmax(size, fabs(points[i] - line->origin[i % 3]));
            largest = fmax(largest, fabs(points[i]));
        }
    }
    line->scale = power_below(size);
    line->noise = TAUT_UNIT_ROUNDOFF * (largest + size) / line->scale;
}

/* The Bezier pieces of one curve, in local coordinates. */
static taut_status make_pieces(const taut_curve *curve, const taut_pipe_line *line,
                               taut_model **pieces, taut_error *error)
{
    const double s = 1 / line->scale, *o = line->origin;
    const double matrix[12] = {s, 0, 0, -s * o[0], 0, s, 0, -s * o[1], 0, 0, s, -s * o[2]};
    taut_curve *local = NULL;
    taut_status status = taut_curve_transform(curve, matrix, &local, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = taut_curve_pieces(local, pieces, error);
    taut_curve_free(local);
    return status;
}

static taut_status take_piece(const taut_curve *curve, taut_pipe_piece *piece, taut_error *error)
{
    const taut_basis *t = taut_curve_t(curve);
    const int n = taut_basis_degree(t);
    if (n < 1 || n > TAUT_PIPE_PIECE_DEGREE || taut_curve_weights(curve) != NULL) {
        return taut_fail(error, TAUT_BAD_INPUT, "value", "/curves/0", n, TAUT_PIPE_PIECE_DEGREE,
                         "the axis is no polynomial curve of a degree up to %d",
                         TAUT_PIPE_PIECE_DEGREE);
    }
    *piece = (taut_pipe_piece){.degree = n, .lo = taut_basis_lo(t), .hi = taut_basis_hi(t)};
    memcpy(piece->points, taut_curve_points(curve), 3 * ((size_t)n + 1) * sizeof(double));
    return TAUT_OK;
}

/* All pieces of a model of curves. */
static taut_status take_pieces(const taut_model *pieces, taut_pipe_line *line, taut_error *error)
{
    taut_status status = TAUT_OK;
    line->count = taut_model_curve_count(pieces);
    line->pieces = taut_arena_take(line->arena, (size_t)line->count, sizeof *line->pieces);
    if (line->pieces == NULL) {
        return taut_fail_memory(error);
    }
    for (int i = 0; i < line->count && status == TAUT_OK; i++) {
        status = take_piece(taut_model_curve(pieces, i), &line->pieces[i], error);
    }
    return status;
}

/* The one piece of curve i of a run. */
static taut_status take_only_piece(const taut_model *pieces, int i, taut_pipe_line *line,
                                   taut_error *error)
{
    const int count = taut_model_curve_count(pieces);
    taut_status status = TAUT_OK;
    if (count != 1) {
        return taut_fail(error, TAUT_BAD_INPUT, "value", "/curves", count, 1,
                         "an axis of the run has several pieces");
    }
    status = take_piece(taut_model_curve(pieces, 0), &line->pieces[i], error);
    line->pieces[i].lo = i;
    line->pieces[i].hi = i + 1;
    return status;
}

/* Has the axis no curvature at an end, by what it is made of and not by its rounding? A "ce-bezier"
 * has none where beta is 3 or -3, and at both ends where V_1 = V_2; a quintic has three points on
 * either end edge. */
static void mark_flat(const taut_curve *curve, int flat[2])
{
    const double *v = taut_curve_points(curve);
    taut_basis_spec spec;
    taut_basis_spec_of(taut_curve_t(curve), &spec);
    if (strcmp(taut_basis_type(taut_curve_t(curve)), "ce-bezier") == 0) {
        const int is_elbow = memcmp(v + 3, v + 6, 3 * sizeof *v) == 0;
        flat[0] = is_elbow || spec.beta == 3;
        flat[1] = is_elbow || spec.beta == -3;
    } else if (taut_basis_degree(taut_curve_t(curve)) == 5) {
        flat[0] = flat[1] = 1;
    }
}

/* Unit tangents at both ends. */
static taut_status find_tangents(taut_pipe_line *line, taut_error *error)
{
    for (int side = 0; side < 2; side++) {
        const taut_pipe_piece *piece = &line->pieces[side == 0 ? 0 : line->count - 1];
        double d[2][3], speed = 0;
        taut_pipe_piece_eval(piece, side, 1, d);
        speed = taut_norm(d[1]);
        if (!(speed > 0)) {
            return taut_fail(error, TAUT_BAD_INPUT, "value", "/curves/0", speed, 0,
                             "the axis has no direction at its %s", side == 0 ? "start" : "end");
        }
        for (int k = 0; k < 3; k++) {
            line->tangent[side][k] = d[1][k] / speed;
        }
    }
    return TAUT_OK;
}

taut_status taut_pipe_line_of_run(const taut_curve *const *curves, int count, taut_arena *arena,
                                  taut_pipe_line *line, taut_error *error)
{
    taut_status status = TAUT_OK;
    *line = (taut_pipe_line){.arena = arena, .count = count, .run = 1};
    set_coordinates(curves, count, line);
    line->pieces = taut_arena_take(arena, (size_t)count, sizeof *line->pieces);
    if (line->pieces == NULL) {
        return taut_fail_memory(error);
    }
    for (int i = 0; i < count; i++) {
        taut_model *pieces = NULL;
        taut_pipe_circle circle;
        if (taut_pipe_circle_of(curves[i], &circle)) {
            line->pieces[i] =
                (taut_pipe_piece){.lo = i, .hi = i + 1, .radius = circle.radius / line->scale};
            line->noise += taut_pipe_circle_piece(&circle, line, &line->pieces[i]);
            continue;
        }
        status = make_pieces(curves[i], line, &pieces, error);
        if (status != TAUT_OK) {
            return status;
        }
        status = take_only_piece(pieces, i, line, error);
        mark_flat(curves[i], line->pieces[i].flat);
        taut_model_free(pieces);
        if (status != TAUT_OK) {
            return status;
        }
    }
    return find_tangents(line, error);
}

taut_status taut_pipe_line_of(const taut_curve *curve, taut_arena *arena, taut_pipe_line *line,
                              taut_error *error)
{
    taut_model *pieces = NULL;
    taut_status status = TAUT_OK;
    *line = (taut_pipe_line){.arena = arena, .lengths = {INFINITY, INFINITY}};
    set_coordinates(&curve, 1, line);
    status = make_pieces(curve, line, &pieces, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = take_pieces(pieces, line, error);
    taut_model_free(pieces);
    if (status == TAUT_OK && line->count == 1) {
        mark_flat(curve, line->pieces[0].flat);
    }
    return status == TAUT_OK ? find_tangents(line, error) : status;
}

enum { BINORMAL_DEGREE = 2 * TAUT_PIPE_PIECE_DEGREE };

/* A binormal of any length, without the factors t and 1 - t that it has where the curvature vanishes
 * at an end; degree -1: there is none. */
typedef struct binormal {
    int degree;
    double c[BINORMAL_DEGREE + 1][3];
} binormal;

/* K = P' x P'' of a curve of degree n with legs E_i is n^2 (n - 1) A x B, A of the legs E_0, ..,
 * E_{n-2} and B of E_1, .., E_{n-1}, as P' = (1 - t) A + t B and P'' = (n - 1) (B - A); of degree
 * m = 2 n - 4, with (m over k) K_k = sum over i + j = k of (n-2 over i) (n-2 over j) E_i x E_{j+1}.
 * What a factor t is taken from begins with the next coefficient, and so at the other end. */
static void binormal_of(const taut_pipe_piece *piece, binormal *b)
{
    const int n = piece->degree, m = 2 * n - 4;
    double legs[TAUT_PIPE_PIECE_DEGREE][3], k[BINORMAL_DEGREE + 1][3];
    int first = piece->flat[0] != 0, last = m - (piece->flat[1] != 0);
    memset(k, 0, sizeof k);
    for (int i = 0; i < n; i++) {
        taut_difference(piece->points[i + 1], piece->points[i], legs[i]);
    }
    for (int i = 0; i + 1 < n; i++) {
        for (int j = 0; j + 1 < n; j++) {
            double product[3];
            taut_cross(legs[i], legs[j + 1], product);
            taut_add_scaled(taut_certify_binomial(n - 2, i) * taut_certify_binomial(n - 2, j),
                            product, k[i + j]);
        }
    }
    while (first <= last && taut_dot(k[first], k[first]) == 0) {
        first++;
    }
    while (last > first && taut_dot(k[last], k[last]) == 0) {
        last--;
    }
    b->degree = n < 2 ? -1 : last - first;
    for (int i = 0; i <= b->degree; i++) {
        for (int c = 0; c < 3; c++) {
            b->c[i][c] = k[first + i][c] / taut_certify_binomial(b->degree, i);
        }
    }
}

/* Does rounding leave the binormal no direction at an end? The torsion there is anybody's then. */
static int is_lost_at_end(const taut_pipe_line *line, const taut_pipe_piece *piece,
                          const binormal *b)
{
    double longest = 0;
    for (int i = 0; i < piece->degree; i++) {
        longest = fmax(longest, taut_distance(piece->points[i + 1], piece->points[i]));
    }
    const double noise = 64 * line->noise * longest;
    return b->degree >= 0 && (taut_norm(b->c[0]) <= noise || taut_norm(b->c[b->degree]) <= noise);
}

/* Torsion from a binormal C(t): -det(C', C, T) / C . C, which needs no division by what vanishes at
 * the ends. */
static double flat_torsion(const binormal *from, double t, const double tangent[3])
{
    double b[BINORMAL_DEGREE + 1][3], slope[3], square = 0;
    if (from->degree < 1) {
        return 0;
    }
    memcpy(b, from->c, sizeof b);
    for (int level = from->degree; level > 1; level--) {
        for (int i = 0; i < level; i++) {
            for (int k = 0; k < 3; k++) {
                b[i][k] += t * (b[i + 1][k] - b[i][k]);
            }
        }
    }
    for (int k = 0; k < 3; k++) {
        slope[k] = from->degree * (b[1][k] - b[0][k]);
        b[0][k] += t * (b[1][k] - b[0][k]);
    }
    square = taut_dot(b[0], b[0]);
    return square > 0 ? -taut_det(slope, b[0], tangent) / square : 0;
}

/* Length, turning, torsion and bending per unit of parameter. */
static void evaluate_integrands(const taut_pipe_piece *piece, int planar, const binormal *flat,
                                double t, double out[INTEGRALS])
{
    double d[4][3], cross[3], speed = 0, square = 0;
    taut_pipe_piece_eval(piece, t, 3, d);
    taut_cross(d[1], d[2], cross);
    speed = taut_norm(d[1]);
    square = taut_dot(cross, cross);
    memset(out, 0, INTEGRALS * sizeof *out);
    out[0] = speed;
    if (speed > 0) {
        const double curvature = sqrt(square) / (speed * speed * speed);
        out[1] = curvature * speed;
        out[3] = curvature * curvature * speed;
    }
    if (flat != NULL && speed > 0 && !planar) {
        for (int k = 0; k < 3; k++) {
            d[1][k] /= speed;
        }
        out[2] = flat_torsion(flat, t, d[1]);
    } else if (square > 0 && !planar) {
        out[2] = taut_dot(cross, d[3]) / square * speed;
    }
}

/* One piece under quadrature. */
typedef struct quadrature {
    double tolerance;
    const taut_pipe_piece *piece;
    int planar, flat;
    binormal binormal; /* of a flat one */
    double nodes[GAUSS], weights[GAUSS];
    double size[INTEGRALS]; /* what errors are measured against */
    taut_sum sums[INTEGRALS];
    int left; /* intervals that may still be halved */
} quadrature;

static void integrate_interval(const quadrature *q, double lo, double hi, double out[INTEGRALS])
{
    memset(out, 0, INTEGRALS * sizeof *out);
    for (int i = 0; i < GAUSS; i++) {
        double value[INTEGRALS];
        evaluate_integrands(q->piece, q->planar, q->flat ? &q->binormal : NULL,
                            0.5 * (lo + hi) + 0.5 * (hi - lo) * q->nodes[i], value);
        for (int k = 0; k < INTEGRALS; k++) {
            out[k] += 0.5 * (hi - lo) * q->weights[i] * value[k];
        }
    }
}

/* Halved until both halves agree with the whole: kinks at inflections are met by depth. */
static void integrate_adaptively(quadrature *q, double lo, double hi, const double whole[INTEGRALS],
                                 int depth)
{
    const double middle = 0.5 * (lo + hi);
    double left[INTEGRALS], right[INTEGRALS];
    int agree = 1;
    integrate_interval(q, lo, middle, left);
    integrate_interval(q, middle, hi, right);
    for (int k = 0; k < INTEGRALS; k++) {
        agree = agree && fabs(left[k] + right[k] - whole[k]) <= q->tolerance * q->size[k];
    }
    if (agree || depth >= DEPTH_MAX || q->left <= 0) {
        for (int k = 0; k < INTEGRALS; k++) {
            taut_sum_add(&q->sums[k], left[k]);
            taut_sum_add(&q->sums[k], right[k]);
        }
        return;
    }
    q->left--;
    integrate_adaptively(q, lo, middle, left, depth + 1);
    integrate_adaptively(q, middle, hi, right, depth + 1);
}

/* Do all edges lie in one plane, as far as rounding lets that be told? Then there is no torsion. */
static int is_planar(const taut_pipe_line *line, const taut_pipe_piece *piece)
{
    double edges[TAUT_PIPE_PIECE_DEGREE][3], longest = 0;
    for (int i = 0; i < piece->degree; i++) {
        taut_difference(piece->points[i + 1], piece->points[i], edges[i]);
        longest = fmax(longest, taut_norm(edges[i]));
    }
    for (int i = 0; i < piece->degree; i++) {
        for (int j = 0; j < i; j++) {
            for (int k = 0; k < j; k++) {
                if (fabs(taut_det(edges[i], edges[j], edges[k])) >
                    16 * line->noise * longest * longest) {
                    return 0;
                }
            }
        }
    }
    return 1;
}

/* All integrals of one piece, added to `figures`. */
static void integrate_piece(quadrature *q, taut_pipe_figures *figures)
{
    double intervals[INTERVALS][INTEGRALS];
    for (int k = 0; k < INTEGRALS; k++) {
        q->size[k] = k == 1 || k == 2 ? 1 : 0; /* angles are absolute */
        q->sums[k] = (taut_sum){0, 0};
    }
    for (int i = 0; i < INTERVALS; i++) {
        integrate_interval(q, (double)i / INTERVALS, (i + 1.0) / INTERVALS, intervals[i]);
        for (int k = 0; k < INTEGRALS; k++) {
            q->size[k] += fabs(intervals[i][k]);
        }
    }
    q->left = HALVINGS;
    for (int i = 0; i < INTERVALS; i++) {
        integrate_adaptively(q, (double)i / INTERVALS, (i + 1.0) / INTERVALS, intervals[i], 0);
    }
    figures->length += taut_sum_total(&q->sums[0]);
    figures->turning += taut_sum_total(&q->sums[1]);
    figures->torsion += taut_sum_total(&q->sums[2]);
    figures->bending += taut_sum_total(&q->sums[3]);
}

void taut_pipe_integrate(const taut_pipe_line *line, taut_pipe_figures *figures)
{
    quadrature q;
    taut_gauss_rule(GAUSS, q.nodes, q.weights);
    /* of one interval; a few dozen count, and no better than the points are rounded */
    q.tolerance = fmax(1e-14, 0.1 * line->noise);
    figures->length = figures->turning = figures->torsion = figures->bending = 0;
    for (int i = 0; i < line->count; i++) {
        q.piece = &line->pieces[i];
        q.planar = is_planar(line, q.piece);
        q.flat = q.piece->flat[0] || q.piece->flat[1];
        binormal_of(q.piece, &q.binormal);
        if (!q.planar && is_lost_at_end(line, q.piece, &q.binormal)) {
            figures->torsion = NAN; /* and stays so */
        }
        integrate_piece(&q, figures);
    }
    figures->ends[0] = taut_pipe_piece_curvature(&line->pieces[0], 0);
    figures->ends[1] = taut_pipe_piece_curvature(&line->pieces[line->count - 1], 1);
}
