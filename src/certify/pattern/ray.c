#include "certify/pattern/ray.h"

#include "core/constants.h"
#include "core/elementary/elementary.h"
#include "core/vec3.h"

#include <math.h>
#include <string.h>

enum { STEPS_MOST = 200, CORRECTIONS = 3, SQUARE_ROUNDS = 12, AROUND = 12, STEPS = 10 };
/* A cosine that is none. */
static const double is_square = 1e-7;
/* Rays are followed for so many times the distance that is known. */
static const double room = 1.3;

static double inside(double x)
{
    return fmin(fmax(x, 0), 1);
}

int taut_cloth_spot_at(const taut_cloth *cloth, const taut_cloth_piece *piece, double s, double t,
                       taut_cloth_spot *spot)
{
    double w[6][2], x[6][3], normal[3];
    taut_cloth_across across;

    taut_cloth_across_at(cloth, piece, inside(s), 2, &across);
    if (!taut_cloth_bend_on(cloth, &across, inside(t), w) ||
        taut_surface_eval(piece->on, w[0][0], w[0][1], 2, x[0]) != TAUT_OK) {
        return 0;
    }
    const double *ws = w[1], *wt = w[2], *const bent[3] = {w[3], w[4], w[5]};
    for (int c = 0; c < 3; c++) {
        const double uu = x[TAUT_XUU][c], uv = x[TAUT_XUV][c], vv = x[TAUT_XVV][c];
        const double xu = x[TAUT_XU][c], xv = x[TAUT_XV][c];
        spot->first[0][c] = xu * ws[0] + xv * ws[1];
        spot->first[1][c] = xu * wt[0] + xv * wt[1];
        spot->second[0][c] = uu * ws[0] * ws[0] + 2 * uv * ws[0] * ws[1] + vv * ws[1] * ws[1] +
                             xu * bent[0][0] + xv * bent[0][1];
        spot->second[1][c] = uu * ws[0] * wt[0] + uv * (ws[0] * wt[1] + ws[1] * wt[0]) +
                             vv * ws[1] * wt[1] + xu * bent[1][0] + xv * bent[1][1];
        spot->second[2][c] = uu * wt[0] * wt[0] + 2 * uv * wt[0] * wt[1] + vv * wt[1] * wt[1] +
                             xu * bent[2][0] + xv * bent[2][1];
    }
    spot->g[0] = taut_dot(spot->first[0], spot->first[0]);
    spot->g[1] = taut_dot(spot->first[0], spot->first[1]);
    spot->g[2] = taut_dot(spot->first[1], spot->first[1]);
    const double det = spot->g[0] * spot->g[2] - spot->g[1] * spot->g[1];
    if (!(det > 0)) {
        return 0;
    }
    spot->area = sqrt(det);
    taut_cross(spot->first[0], spot->first[1], normal);
    double form[3], sideways[3];
    for (int k = 0; k < 3; k++) {
        form[k] = taut_dot(spot->second[k], normal) / spot->area;
    }
    spot->gauss = (form[0] * form[2] - form[1] * form[1]) / det;
    taut_cross(normal, spot->first[0], sideways);
    spot->bend = taut_dot(spot->second[0], sideways) / (spot->area * spot->g[0] * sqrt(spot->g[0]));
    return 1;
}

/* ---- one ray ---- */

/* s, t and their derivatives by the length. */
typedef struct state {
    double at[2], way[2];
} state;

typedef struct runner {
    const taut_cloth *cloth;
    const taut_cloth_piece *piece;
    taut_cloth_ray *ray;
    taut_cloth_spot spot; /* of the last state looked at */
} runner;

/* The derivatives of a state whose place was looked at. */
static int bend(runner *r, const state *x, state *out)
{
    double force[2] = {0, 0};
    const taut_cloth_spot *spot = &r->spot;
    for (int l = 0; l < 2; l++) {
        force[l] = x->way[0] * x->way[0] * taut_dot(spot->second[0], spot->first[l]) +
                   2 * x->way[0] * x->way[1] * taut_dot(spot->second[1], spot->first[l]) +
                   x->way[1] * x->way[1] * taut_dot(spot->second[2], spot->first[l]);
    }
    const double det = spot->area * spot->area;
    memcpy(out->at, x->way, sizeof out->at);
    out->way[0] = -(spot->g[2] * force[0] - spot->g[1] * force[1]) / det;
    out->way[1] = -(spot->g[0] * force[1] - spot->g[1] * force[0]) / det;
    r->ray->gauss[0] = fmin(r->ray->gauss[0], spot->gauss);
    r->ray->gauss[1] = fmax(r->ray->gauss[1], spot->gauss);
    return 1;
}

/* Of one that is looked at now; 0 where there are none. */
static int slope_of(runner *r, const state *x, state *out)
{
    return taut_cloth_spot_at(r->cloth, r->piece, x->at[0], x->at[1], &r->spot) && bend(r, x, out);
}

static state moved(const state *x, double h, const state *slope)
{
    state y = *x;
    for (int d = 0; d < 2; d++) {
        y.at[d] += h * slope->at[d];
        y.way[d] += h * slope->way[d];
    }
    return y;
}

/* One step, whose first slope is known. */
static int step_by(runner *r, state *x, double h, const state *first)
{
    state k[4] = {*first}, y;
    static const double share[4] = {0, 0.5, 0.5, 1};
    for (int i = 1; i < 4; i++) {
        y = moved(x, share[i] * h, &k[i - 1]);
        if (!slope_of(r, &y, &k[i])) {
            return 0;
        }
    }
    for (int d = 0; d < 2; d++) {
        x->at[d] += h / 6 * (k[0].at[d] + 2 * k[1].at[d] + 2 * k[2].at[d] + k[3].at[d]);
        x->way[d] += h / 6 * (k[0].way[d] + 2 * k[1].way[d] + 2 * k[2].way[d] + k[3].way[d]);
    }
    return 1;
}

/* The least length after which x + v h + a h^2 / 2 leaves [0, 1], and its end. */
static double leaves_after(double x, double v, double a, int *end)
{
    double least = INFINITY;
    for (int hi = 0; hi < 2; hi++) {
        const double gap = hi - x, sign = hi ? 1 : -1;
        const double square = v * v + 2 * a * gap;
        const double h = square >= 0 ? 2 * gap / (v + sign * sqrt(square)) : INFINITY;
        if (h >= 0 && h < least) {
            least = h;
            *end = hi;
        }
    }
    return least;
}

/* Onto the border, by Newton's method from a place next to it. */
static int settle(runner *r, state *x, int way, int end)
{
    for (int k = 0; k < CORRECTIONS; k++) {
        state slope;
        if (!slope_of(r, x, &slope)) {
            return 0;
        }
        const double h = (end - x->at[way]) / x->way[way];
        *x = moved(x, h, &slope);
        r->ray->length += h;
    }
    return slope_of(r, x, &(state){{0, 0}, {0, 0}});
}

static void leave(runner *r, const state *x, int way, int end)
{
    static const int borders[2][2] = {{TAUT_CLOTH_START, TAUT_CLOTH_END},
                                      {TAUT_CLOTH_RIGHT, TAUT_CLOTH_LEFT}};
    const double *g = r->spot.g;
    const int along = 1 - way;
    r->ray->border = borders[way][end];
    r->ray->slant = (x->way[along] * g[2 * along] + x->way[way] * g[1]) / sqrt(g[2 * along]);
}

/* Given up once it is longer than `longest`, of border -1. */
static void follow(const taut_cloth *cloth, const taut_cloth_piece *piece, const double at[2],
                   double angle, double limit, double longest, double step, taut_cloth_ray *ray)
{
    runner r = {.cloth = cloth, .piece = piece, .ray = ray};
    state x = {{at[0], at[1]}, {0, 0}}, slope;

    *ray = (taut_cloth_ray){.border = -2, .gauss = {INFINITY, -INFINITY}};
    if (!taut_cloth_spot_at(cloth, piece, at[0], at[1], &r.spot)) {
        return;
    }
    const double *g = r.spot.g, across = taut_sin(angle);
    x.way[0] = taut_cos(angle) / sqrt(g[0]) - across * g[1] / (sqrt(g[0]) * r.spot.area);
    x.way[1] = across * sqrt(g[0]) / r.spot.area;
    for (int k = 0; k < STEPS_MOST && (k == 0 ? bend(&r, &x, &slope) : slope_of(&r, &x, &slope));
         k++) {
        int ends[2] = {0, 0};
        const double out[2] = {leaves_after(x.at[0], x.way[0], slope.way[0], &ends[0]),
                               leaves_after(x.at[1], x.way[1], slope.way[1], &ends[1])};
        const int way = out[1] < out[0];
        const double h = fmin(step, limit - ray->length);
        const int is_last = out[way] <= h;
        if (!step_by(&r, &x, is_last ? out[way] : h, &slope)) {
            return;
        }
        ray->length += is_last ? out[way] : h;
        if (is_last && settle(&r, &x, way, ends[way])) {
            leave(&r, &x, way, ends[way]);
            return;
        }
        if (is_last) {
            return;
        }
        if (ray->length >= limit * (1 - 1e-12) || ray->length > longest) {
            ray->border = -1;
            return;
        }
    }
}

void taut_cloth_ray_from(const taut_cloth *cloth, const taut_cloth_piece *piece, const double at[2],
                         double angle, double limit, double step, taut_cloth_ray *ray)
{
    follow(cloth, piece, at, angle, limit, limit, step, ray);
}

/* ---- distance ---- */

typedef struct search {
    const taut_cloth *cloth;
    const taut_cloth_piece *piece;
    const double *at;
    double limit, longest, step, best; /* longest: what is longer is of no use */
} search;

static void look(search *s, double angle, taut_cloth_ray *ray)
{
    follow(s->cloth, s->piece, s->at, angle, s->limit, s->longest, s->step, ray);
    if (ray->border >= 0) {
        s->best = fmin(s->best, ray->length);
    }
}

/* The ray near an angle that meets its border squarely, by secants. */
static void square_up(search *s, double angle)
{
    taut_cloth_ray ray;
    look(s, angle, &ray);
    if (ray.border < 0) {
        return;
    }
    const int border = ray.border;
    double before = angle, slant = ray.slant;
    /* on a flat disc the angle is off by that of the slant */
    const double sign = border == TAUT_CLOTH_LEFT || border == TAUT_CLOTH_START ? 1 : -1;
    angle += sign * slant;
    for (int k = 0; k < SQUARE_ROUNDS && fabs(slant) > is_square; k++) {
        look(s, angle, &ray);
        if (ray.border != border || !(fabs(ray.slant - slant) > 0)) {
            return;
        }
        const double next = angle - ray.slant * (angle - before) / (ray.slant - slant);
        before = angle;
        slant = ray.slant;
        angle = next;
    }
}

double taut_cloth_distance(const taut_cloth *cloth, const taut_cloth_piece *piece,
                           const double at[2], double limit)
{
    search s = {cloth, piece, at, room * limit, room * limit, limit / STEPS, limit};
    double nearest = 0, least = INFINITY;
    for (int k = 0; k < AROUND;
         k++) { /* of strips those to the sides first: the others are cut short */
        taut_cloth_ray ray;
        const double angle = 2 * TAUT_PI * ((k + AROUND / 4) % AROUND) / AROUND;
        look(&s, angle, &ray);
        if (ray.border >= 0 && ray.length < least) {
            s.longest = least = ray.length;
            nearest = angle;
        }
    }
    if (!(least < INFINITY)) {
        return 0;
    }
    s.limit = s.longest = room * least;
    square_up(&s, nearest);
    return s.best;
}
