/* symmetry.c -- the mean of a film and its images.
 *
 *     the seven exchanges and reversals of u and v, of rings all moves around and reversals, each with an isometry of
 *         space: those that keep the start to rounding, and with it corners, held edges and knots, the planes and lines that
 *         points are kept on, and kinds and laws of edges
 *     net = the mean of the film and of what they make of it
 *     a few steps along the moves, of rings to any rest nearby, and the mean once more; where points are tied, or kept on
 *         planes and lines, until it moves nothing
 *
 * Newton's steps end anywhere within their tolerance, and area hardly sees how points lie within the film: two halves
 * that ought to be mirror images differ by 1e-7 without this, and rings turn within themselves by 0.01.
 *
 * An isometry keeps the middle of the start. It is told by two frames, laid between the directions to two points from there, and
 * to their images: where these are corners that lie alike it is a matrix of 0 and +-1 between them, and the mean has no
 * rounding but that of its sums.
 */
#include "construct/film/symmetry.h"

#include "core/fail.h"
#include "core/vec3.h"

#include <math.h>
#include <stddef.h>
#include <string.h>

/* A way: point (i, j) becomes (j, i), then i is reversed, and j; then what goes around is moved on. */
enum { EXCHANGE = 1, REVERSE_U = 2, REVERSE_V = 4, WAYS = 8, ROUNDS = 4 };

static const double rounding = 1e-13; /* over half the size */
static const double nearly =
    1e-6; /* over half the size: off by so much it is as stable as before */
static const double settled =
    1e-8; /* over half the size: what a mean moves it by leaves its square in the derivatives */
static const double energy_more = 1e-6; /* share: what a film of another net may have */

typedef struct symmetry {
    const taut_film_space *space;
    double centre[3], frame[3][3]; /* unit and orthogonal */
    size_t far;                    /* the frame is laid by the first point and this one */
    double *sum;                   /* [nu][nv][3] */
} symmetry;

static size_t image_of(const taut_film_space *space, int way, size_t at)
{
    const int n[2] = {space->nu, space->nv};
    const int i = (int)at / n[1], j = (int)at % n[1], k = way & EXCHANGE;
    int x[2] = {k ? j : i, k ? i : j};

    for (int d = 0; d < 2; d++) {
        x[d] = way & REVERSE_U << d ? n[d] - 1 - x[d] : x[d];
        if (space->around != NULL && (d == 0) == (space->problem->ring == TAUT_FILM_RING_U)) {
            x[d] = (x[d] + way / WAYS) % space->around->period;
        }
    }
    return (size_t)(x[0] * n[1] + x[1]);
}

static int make_unit(double x[3])
{
    const double size = taut_length(x);
    for (int k = 0; k < 3; k++) {
        x[k] /= size;
    }
    return size > 0;
}

static double part_of(const symmetry *s, const double *net, size_t at, const double axis[3])
{
    double x[3];
    taut_difference(net + 3 * at, s->centre, x);
    return taut_dot(x, axis);
}

static int lay_frame(const symmetry *s, int way, int sign, double frame[3][3])
{
    const double *start = s->space->start;
    double a[3], b[3];

    taut_difference(start + 3 * image_of(s->space, way, 0), s->centre, a);
    taut_difference(start + 3 * image_of(s->space, way, s->far), s->centre, b);
    int is_frame = make_unit(a) && make_unit(b);
    for (int k = 0; k < 3; k++) {
        frame[0][k] = a[k] + b[k];
        frame[1][k] = a[k] - b[k];
    }
    is_frame = is_frame && make_unit(frame[0]) && make_unit(frame[1]);
    taut_cross(frame[0], frame[1], frame[2]);
    (void)make_unit(frame[2]);
    for (int k = 0; k < 3; k++) {
        frame[2][k] *= sign;
    }
    return is_frame;
}

static int find_frame(symmetry *s)
{
    const taut_film_space *space = s->space;
    double most = 0, count = 0;

    for (size_t i = 0; i < space->count; i++) {
        if (space->leader == NULL || space->leader[i] == (int)i) {
            taut_add_scaled(1, space->start + 3 * i, s->centre);
            count++;
        }
    }
    for (int k = 0; k < 3; k++) {
        s->centre[k] /= count;
    }
    for (size_t i = 0; i < space->count; i++) {
        double a[3], b[3], across[3];
        taut_difference(space->start, s->centre, a);
        taut_difference(space->start + 3 * i, s->centre, b);
        taut_cross(a, b, across);
        const double size = taut_length(across);
        if (size > (1 + rounding) * most) {
            most = size;
            s->far = i;
        }
    }
    return lay_frame(s, 0, 1, s->frame);
}

static int keeps_laws(const taut_film_space *space, int way)
{
    const taut_film_problem *problem = space->problem;
    const size_t numbers = offsetof(taut_film_edge, has_plane) - offsetof(taut_film_edge, force);

    for (int e = 0; e < 4; e++) {
        const int across = (e >= 2) ^ (way & EXCHANGE);
        const taut_film_edge *a = &problem->edges[e],
                             *b = &problem->edges[2 * across + (e % 2 ^ (way >> (1 + across) & 1))];
        if (a->kind != b->kind || a->law != b->law || memcmp(&a->force, &b->force, numbers) != 0) {
            return 0;
        }
    }
    return !(way & EXCHANGE) ||
           (space->around == NULL && problem->force_density[0] == problem->force_density[1] &&
            space->nu == space->nv &&
            taut_basis_degree(problem->u) == taut_basis_degree(problem->v));
}

/* Where a point of the start is, and what is allowed of a move that no plane or line shares. */
static void look_at(const symmetry *s, size_t at, double (*frame)[3], double x[3])
{
    for (int k = 0; k < 3; k++) {
        x[k] = frame[0][k] + 0.7 * frame[1][k] + 0.4 * frame[2][k];
    }
    if (s->space->allowed != NULL) {
        taut_mask_project(s->space->allowed + 6 * at, x);
    }
    for (int k = 0; k < 3; k++) {
        x[k] += s->space->start[3 * at + (size_t)k] - s->centre[k];
    }
}

static int keeps_points(symmetry *s, int way, double frame[3][3])
{
    const double most = rounding * (1 + taut_largest_coordinate(s->space->scaling.centre));

    for (size_t i = 0; i < s->space->count; i++) {
        double here[3], there[3];
        look_at(s, i, s->frame, here);
        look_at(s, image_of(s->space, way, i), frame, there);
        for (int k = 0; k < 3; k++) {
            if (!(fabs(taut_dot(here, s->frame[k]) - taut_dot(there, frame[k])) <= most)) {
                return 0;
            }
        }
    }
    return 1;
}

static int is_symmetric(symmetry *s, int way, double frame[3][3])
{
    return keeps_laws(s->space, way) &&
           ((lay_frame(s, way, 1, frame) && keeps_points(s, way, frame)) ||
            (lay_frame(s, way, -1, frame) && keeps_points(s, way, frame)));
}

/* net becomes the mean: how far the farthest point moves; -1: it has no images. */
static double take_mean(symmetry *s, double *net)
{
    const taut_film_space *space = s->space;
    const int ways = WAYS * (space->around != NULL ? space->around->period : 1);
    double farthest = 0;
    int count = 0;

    memset(s->sum, 0, 3 * space->count * sizeof(double));
    for (int way = 0; way < ways; way++) {
        double frame[3][3];
        if (is_symmetric(s, way, frame)) {
            count++;
            for (size_t i = 0; i < 3 * space->count; i++) {
                s->sum[i] += part_of(s, net, image_of(space, way, i / 3), frame[i % 3]);
            }
        }
    }
    for (size_t i = 0; i < space->count && count > 1; i++) {
        double x[3];
        memcpy(x, s->centre, sizeof x);
        for (size_t k = 0; k < 3; k++) {
            taut_add_scaled(s->sum[3 * i + k] / count, s->frame[k], x);
        }
        if (!space->known[i]) {
            farthest = fmax(farthest, taut_length_between(x, net + 3 * i));
            memcpy(net + 3 * i, x, sizeof x);
        }
    }
    taut_mask_follow(&space->mask, net);
    return count > 1 ? farthest : -1;
}

taut_status taut_film_make_symmetric(taut_film_work *w, taut_arena *arena, taut_error *error)
{
    const taut_film_space *space = w->space;
    const taut_film_problem *problem = space->problem;
    const int moves = space->leader != NULL;
    symmetry s = {.space = space};
    taut_error inner = {.status = TAUT_OK};
    taut_film_rest_point at = {.negative = 0};

    if (problem->start != NULL || problem->prestress[0] > 0 || !find_frame(&s)) {
        return TAUT_OK;
    }
    s.sum = taut_arena_take(arena, space->count, 3 * sizeof(double));
    double *before = taut_arena_copy(arena, w->net, space->count, 3 * sizeof(double));
    if (taut_arena_status(arena) != TAUT_OK) {
        return taut_fail_memory(error);
    }
    const taut_film_work was = *w;
    const double energy = taut_area_functional_value(w->functional, w->net).area;
    const double first = take_mean(&s, w->net);
    if (first < 0) {
        return TAUT_OK;
    }
    double moved = first;
    for (int k = 0; k < (moves ? ROUNDS : 1) && inner.status == TAUT_OK; k++) {
        inner.status = taut_film_polish_again(w, &inner);
        moved = take_mean(&s, w->net);
        if (moved <= settled && w->region.residual <= w->region.tolerance) {
            break;
        }
    }
    if (inner.status == TAUT_OK && !(first <= nearly)) {
        inner.status = taut_fail_status(&inner, taut_film_judge(w, &at));
    }
    if (inner.status == TAUT_NO_MEMORY || inner.status == TAUT_INTERRUPTED) {
        return taut_film_pass_on(&inner, error);
    }
    w->is_definite = was.is_definite;
    if (inner.status != TAUT_OK || at.negative != 0 || w->region.residual > w->region.tolerance ||
        (moves && moved > settled) || !(w->region.area <= (1 + energy_more) * energy)) {
        memcpy(w->net, before, 3 * space->count * sizeof(double));
        memcpy(w->cables, was.cables, sizeof w->cables);
        w->region = was.region;
    }
    return TAUT_OK;
}
