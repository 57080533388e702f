/* bend.c -- the largest curvature of an axis, bounded from above on ever smaller pieces.
 *
 * On a Bezier piece with first differences E_i and unit vector m,
 *     |P' x P''| <= the largest Bernstein coefficient of P' x P'',   |P'| >= n min E_i . m,
 * so that the curvature is at most the one over the cube of the other. Pieces whose bound is not
 * above what was seen elsewhere are dropped; what is left shrinks onto the maximum.
 */
#include "certify/common/bernstein.h"
#include "certify/pipe/axis.h"
#include "core/vec3.h"

#include <float.h>
#include <math.h>
#include <string.h>

enum { DEPTH_MAX = 30, GOLDEN_STEPS = 80 };

/* Bounds are followed down to this: no other place is more curved by a larger part. */
static const double resolution = 1e-6;

typedef struct bound {
    const taut_pipe_piece *piece;
    int index;
    double best, best_t;
    int best_index;
} bound;

static void record(bound *b, double t)
{
    const double curvature = taut_pipe_piece_curvature(b->piece, t);
    if (curvature > b->best) {
        b->best = curvature;
        b->best_t = t;
        b->best_index = b->index;
    }
}

/* Bernstein coefficients of P' x P'' from all pairs of first and second differences. */
static double largest_cross(int n, const double (*points)[3], double *longest)
{
    double cross[2 * TAUT_PIPE_PIECE_DEGREE][3] = {{0, 0, 0}}, most = 0;
    double e[TAUT_PIPE_PIECE_DEGREE][3];
    for (int i = 0; i < n; i++) {
        taut_difference(points[i + 1], points[i], e[i]);
        *longest = fmax(*longest, taut_norm(e[i]));
    }
    for (int i = 0; i < n; i++) {
        for (int j = 0; j + 1 < n; j++) {
            double second[3], product[3];
            taut_difference(e[j + 1], e[j], second);
            taut_cross(e[i], second, product);
            taut_add_scaled(n * (double)n * (n - 1) * taut_certify_binomial(n - 1, i) *
                                taut_certify_binomial(n - 2, j) /
                                taut_certify_binomial(2 * n - 3, i + j),
                            product, cross[i + j]);
        }
    }
    for (int i = 0; i <= 2 * n - 3; i++) {
        most = fmax(most, taut_norm(cross[i]));
    }
    return most;
}

static double least_speed(int n, const double (*points)[3])
{
    double chord[3], least = INFINITY, length = 0;
    taut_difference(points[n], points[0], chord);
    length = taut_norm(chord);
    for (int i = 0; i < n; i++) {
        double e[3];
        taut_difference(points[i + 1], points[i], e);
        least = fmin(least, n * taut_dot(e, chord));
    }
    return length > 0 ? least / length : 0;
}

static void visit(bound *b, const double (*points)[3], double lo, double hi, int depth)
{
    const int n = b->piece->degree;
    double longest = 0;
    const double cross = largest_cross(n, points, &longest), speed = least_speed(n, points);
    /* coordinates of unit size, each rounded: so much of P' x P'' may be nothing */
    const double rounding = 32 * DBL_EPSILON * n * n * n * longest;
    double halves[2][TAUT_PIPE_PIECE_DEGREE + 1][3];

    record(b, 0.5 * (lo + hi));
    if (!(longest * longest > DBL_MIN)) {
        return; /* products vanish, so no speed is above 0, however short the piece: parts.c says that nothing is known of it */
    }
    if ((speed > 0 && cross <= b->best * (1 + resolution) * speed * speed * speed + rounding) ||
        depth == DEPTH_MAX) {
        return;
    }
    taut_certify_halve(n, 3, &points[0][0], &halves[0][0][0], &halves[1][0][0]);
    for (int upper = 0; upper < 2; upper++) {
        visit(b, (const double(*)[3])halves[upper], upper ? 0.5 * (lo + hi) : lo,
              upper ? hi : 0.5 * (lo + hi), depth + 1);
    }
}

/* A positive multiple of the derivative of kappa^2 = |K|^2 / |P'|^6, K = P' x P'', K' = P' x P'''.
 */
static double curvature_slope(const taut_pipe_piece *piece, double t)
{
    double d[4][3], cross[3], cross1[3];
    taut_pipe_piece_eval(piece, t, 3, d);
    taut_cross(d[1], d[2], cross);
    taut_cross(d[1], d[3], cross1);
    return taut_dot(cross, cross1) * taut_dot(d[1], d[1]) -
           3 * taut_dot(cross, cross) * taut_dot(d[1], d[2]);
}

/* Where values no longer tell (a maximum is flat), the slope does: bisection beside it. */
static void locate_by_slope(bound *b)
{
    const double width = 1e-5;
    double lo = b->best_t - width, hi = b->best_t + width;
    if (lo <= 0 || hi >= 1 ||
        !(curvature_slope(b->piece, lo) > 0 && curvature_slope(b->piece, hi) < 0)) {
        return;
    }
    for (int i = 0; i < 60; i++) {
        const double middle = 0.5 * (lo + hi);
        *(curvature_slope(b->piece, middle) > 0 ? &lo : &hi) = middle;
    }
    b->best_t = 0.5 * (lo + hi);
}

/* What the subdivision found, to the last digit. */
static void polish(bound *b, double width)
{
    const double ratio = 0.61803398874989485;
    double lo = fmax(0, b->best_t - width), hi = fmin(1, b->best_t + width);
    for (int i = 0; i < GOLDEN_STEPS; i++) {
        const double left = hi - ratio * (hi - lo), right = lo + ratio * (hi - lo);
        const double at_left = taut_pipe_piece_curvature(b->piece, left);
        const double at_right = taut_pipe_piece_curvature(b->piece, right);
        record(b, left);
        record(b, right);
        *(at_left >= at_right ? &hi : &lo) = at_left >= at_right ? right : left;
    }
}

void taut_pipe_bound_curvature(const taut_pipe_line *line, taut_pipe_figures *figures)
{
    bound b = {.best = 0};
    for (int i = 0; i < line->count; i++) {
        b.piece = &line->pieces[i];
        b.index = i;
        record(&b, 0);
        record(&b, 1);
        if (b.piece->radius > 0) {
            continue;
        }
        for (int k = 1; k < 64; k++) { /* a good first value drops most pieces at once */
            record(&b, k / 64.0);
        }
        visit(&b, (const double(*)[3])b.piece->points, 0, 1, 0);
    }
    b.piece = &line->pieces[b.best_index];
    b.index = b.best_index;
    if (b.piece->radius == 0) {
        polish(&b, 1.0 / 512);
        locate_by_slope(&b);
    }
    figures->curvature = b.best > TAUT_PIPE_STRAIGHT ? b.best : 0;
    figures->curvature_at = b.piece->lo + b.best_t * (b.piece->hi - b.piece->lo);
}
