/* symmetry.c -- the mean of a film and its images.
 *
 *     the seven exchanges and reversals of u and v, each with an isometry of space: those that keep the start to rounding,
 *         and with it corners, held edges and knots, and kinds and laws of edges
 *     net = the mean of the film and of what they make of it
 *     a few steps along the moves, and the mean once more
 *
 * Newton's steps end anywhere within their tolerance, and area hardly sees how points lie within the film: two halves
 * that ought to be mirror images differ by 1e-7 without this.
 *
 * The isometries keep the middle of the corners, and exchange or reverse the two directions between the diagonals: in
 * the frame of these they are matrices of 0 and +-1, and the mean has no rounding but that of its sums.
 */
#include "construct/film/symmetry.h"

#include "core/fail.h"
#include "core/vec3.h"

#include <math.h>
#include <string.h>

/* A turn: point (i, j) becomes (j, i), then i is reversed, and j; the first two numbers of a vector are exchanged, then each
 * changes its sign. */
enum {
    EXCHANGE = 1,
    REVERSE_U = 2,
    REVERSE_V = 4,
    SWAP = 8,
    SIGN = 16,
    TURNS = 8,
    ISOMETRIES = 16
};

static const double rounding = 1e-13;   /* over half the size */
static const double least_angle = 1e-3; /* between the diagonals */
static const double nearly =
    1e-6; /* over half the size: off by so much it is as stable as before */
static const double energy_more = 1e-6; /* share: what a film of another net may have */

typedef struct symmetry {
    const taut_film_space *space;
    double centre[3], frame[3][3]; /* unit and orthogonal: between the diagonals, and across */
    int count, turns[TURNS];
    double *in_frame; /* [nu][nv][3] */
} symmetry;

static size_t image_of(const taut_film_space *space, int turn, size_t at)
{
    const size_t nv = (size_t)space->nv, i = at / nv, j = at % nv;
    const size_t a = turn & EXCHANGE ? j : i, b = turn & EXCHANGE ? i : j;

    return (turn & REVERSE_U ? (size_t)space->nu - 1 - a : a) * nv +
           (turn & REVERSE_V ? nv - 1 - b : b);
}

/* Number k of an image is sign times number `from` of what it is of. */
static int from_of(int turn, int k)
{
    return turn & SWAP && k < 2 ? 1 - k : k;
}

static double signed_of(int turn, int k, double x)
{
    return turn & SIGN << k ? -x : x;
}

static int make_unit(double x[3])
{
    const double size = taut_length(x);
    for (int k = 0; k < 3; k++) {
        x[k] /= size;
    }
    return size > least_angle;
}

/* Is there a frame: do the diagonals lie apart? */
static int find_frame(symmetry *s)
{
    const size_t last = 3 * (s->space->count - 1), v = 3 * ((size_t)s->space->nv - 1);
    const double *x = s->space->start;
    double a[3], b[3];

    taut_difference(x + last, x, a);
    taut_difference(x + v, x + last - v, b);
    if (!make_unit(a) || !make_unit(b)) {
        return 0;
    }
    for (size_t k = 0; k < 3; k++) {
        s->centre[k] = 0.25 * ((x[k] + x[last + k]) + (x[v + k] + x[last - v + k]));
        s->frame[0][k] = a[k] + b[k];
        s->frame[1][k] = a[k] - b[k];
    }
    if (!make_unit(s->frame[0]) || !make_unit(s->frame[1])) {
        return 0;
    }
    taut_cross(s->frame[0], s->frame[1], s->frame[2]);
    (void)make_unit(s->frame[2]);
    taut_cross(s->frame[2], s->frame[0], s->frame[1]);
    return 1;
}

static void lay_in_frame(symmetry *s, const double *net)
{
    for (size_t i = 0; i < 3 * s->space->count; i++) {
        double x[3];
        taut_difference(net + i / 3 * 3, s->centre, x);
        s->in_frame[i] = taut_dot(x, s->frame[i % 3]);
    }
}

static int keeps_laws(const taut_film_problem *problem, int turn)
{
    for (int e = 0; e < 4; e++) {
        const int across = (e >= 2) ^ (turn & EXCHANGE);
        const taut_film_edge *a = &problem->edges[e],
                             *b =
                                 &problem->edges[2 * across + (e % 2 ^ (turn >> (1 + across) & 1))];
        if (a->kind != b->kind || a->law != b->law || a->force != b->force ||
            a->length != b->length || a->sag != b->sag || a->unstressed != b->unstressed ||
            a->stiffness != b->stiffness) {
            return 0;
        }
    }
    return !(turn & EXCHANGE) || (problem->force_density[0] == problem->force_density[1] &&
                                  taut_basis_count(problem->u) == taut_basis_count(problem->v) &&
                                  taut_basis_degree(problem->u) == taut_basis_degree(problem->v));
}

static int keeps_points(const symmetry *s, int turn)
{
    const double most = rounding * (1 + taut_largest_coordinate(s->space->scaling.centre));

    for (size_t i = 0; i < s->space->count; i++) {
        for (int k = 0; k < 3; k++) {
            const double image = signed_of(turn, k, s->in_frame[3 * i + (size_t)from_of(turn, k)]);
            if (!(fabs(image - s->in_frame[3 * image_of(s->space, turn, i) + (size_t)k]) <= most)) {
                return 0;
            }
        }
    }
    return 1;
}

static void find_turns(symmetry *s)
{
    lay_in_frame(s, s->space->start);
    for (int way = 1; way < TURNS; way++) {
        int turn = way;
        while (turn < SWAP * ISOMETRIES &&
               !(keeps_laws(s->space->problem, turn) && keeps_points(s, turn))) {
            turn += SWAP;
        }
        if (turn < SWAP * ISOMETRIES) {
            s->turns[s->count++] = turn;
        }
    }
}

/* net becomes the mean: how far the farthest point moves. */
static double take_mean(symmetry *s, double *net)
{
    double farthest = 0;

    lay_in_frame(s, net);
    for (size_t i = 0; i < s->space->count; i++) {
        double y[3];
        memcpy(y, s->in_frame + 3 * i, sizeof y);
        for (int n = 0; n < s->count; n++) {
            const int turn = s->turns[n];
            const double *image = s->in_frame + 3 * image_of(s->space, turn, i);
            for (int k = 0; k < 3; k++) {
                y[from_of(turn, k)] += signed_of(turn, k, image[k]);
            }
        }
        if (!s->space->known[i]) {
            double x[3];
            memcpy(x, s->centre, sizeof x);
            for (int k = 0; k < 3; k++) {
                taut_add_scaled(y[k] / (s->count + 1), s->frame[k], x);
            }
            farthest = fmax(farthest, taut_length_between(x, net + 3 * i));
            memcpy(net + 3 * i, x, sizeof x);
        }
    }
    return farthest;
}

taut_status taut_film_make_symmetric(taut_film_work *w, taut_arena *arena, taut_error *error)
{
    const taut_film_space *space = w->space;
    const taut_film_problem *problem = space->problem;
    symmetry s = {.space = space};
    taut_error inner = {.status = TAUT_OK};

    if (space->around != NULL || space->leader != NULL || problem->start != NULL ||
        problem->prestress[0] > 0 || !find_frame(&s)) {
        return TAUT_OK;
    }
    s.in_frame = taut_arena_take(arena, space->count, 3 * sizeof(double));
    double *before = taut_arena_copy(arena, w->net, space->count, 3 * sizeof(double));
    if (taut_arena_status(arena) != TAUT_OK) {
        return taut_fail_memory(error);
    }
    find_turns(&s);
    if (s.count == 0) {
        return TAUT_OK;
    }
    const double residual = w->region.residual;
    const double energy = taut_area_functional_value(w->functional, w->net).area;
    const int is_near = take_mean(&s, w->net) <= nearly;
    taut_film_rest_point at = {.negative = 0};
    inner.status = taut_film_polish_again(w, &inner);
    (void)take_mean(&s, w->net);
    if (inner.status == TAUT_OK && !is_near) {
        inner.status = taut_fail_status(&inner, taut_film_judge(w, &at));
    }
    if (inner.status == TAUT_NO_MEMORY || inner.status == TAUT_INTERRUPTED) {
        return taut_film_pass_on(&inner, error);
    }
    if (inner.status != TAUT_OK || at.negative != 0 || w->region.residual > w->region.tolerance ||
        !(w->region.area <= (1 + energy_more) * energy)) {
        memcpy(w->net, before, 3 * space->count * sizeof(double));
        w->region.residual = residual;
    }
    return TAUT_OK;
}
