/* test_pipe_forged.c -- pipes that are not what they were made as: with a fin between two knots, cut
 * open, wound twice, with straight pipes moved; the certificate says so, with the problem. What is
 * the same pipe still holds: with knots put in, or gone around the other way.
 */
#include "certificates.h"
#include "check.h"
#include "pipes.h"

#include "core/vec3.h"

#include <stdlib.h>
#include <string.h>

enum { COLUMNS = 64, BLEND = 0, PIPE_1 = 1, PIPE_2 = 2 };

/* A surface as a net that may be changed; v is a spline of degree 2. */
typedef struct net {
    const taut_surface *from;
    int nu, nv, knot_count;
    double knots[COLUMNS + 3];
    double (*x)[COLUMNS][4]; /* [nu]: homogeneous */
} net;

static net net_of(const taut_surface *s)
{
    net n = {.from = s,
             .nu = taut_basis_count(taut_surface_u(s)),
             .nv = taut_basis_count(taut_surface_v(s))};
    taut_basis_spec spec;
    taut_basis_spec_of(taut_surface_v(s), &spec);
    n.knot_count = spec.knot_count;
    memcpy(n.knots, spec.knots, (size_t)spec.knot_count * sizeof *n.knots);
    n.x = calloc((size_t)n.nu, sizeof *n.x);
    for (int i = 0; i < n.nu * n.nv; i++) {
        double *x = n.x[i / n.nv][i % n.nv];
        x[3] = taut_surface_weights(s)[i];
        for (int k = 0; k < 3; k++) {
            x[k] = x[3] * taut_surface_points(s)[3 * i + k];
        }
    }
    return n;
}

/* One more knot in v, the surface stays ([PieglTiller1997] section 5.2). */
static void insert_knot(net *n, double t)
{
    int span = 2;
    while (n->knots[span + 1] <= t) {
        span++;
    }
    for (int i = 0; i < n->nu; i++) {
        for (int j = n->nv; j > span - 2; j--) {
            const double part = j > span ? 0 : (t - n->knots[j]) / (n->knots[j + 2] - n->knots[j]);
            for (int k = 0; k < 4; k++) {
                n->x[i][j][k] = part * n->x[i][j][k] + (1 - part) * n->x[i][j - 1][k];
            }
        }
    }
    memmove(n->knots + span + 2, n->knots + span + 1,
            (size_t)(n->knot_count - span - 1) * sizeof *n->knots);
    n->knots[span + 1] = t;
    n->knot_count++;
    n->nv++;
}

/* The surface of the net, which is freed. */
static taut_surface *surface_of(net *n)
{
    const taut_basis_spec spec = {
        .type = "bspline", .degree = 2, .knot_count = n->knot_count, .knots = n->knots};
    double *points = calloc((size_t)(n->nu * n->nv), 4 * sizeof *points);
    double *weights = points + 3 * n->nu * n->nv;
    taut_basis *v = NULL;
    taut_surface *s = NULL;
    for (int i = 0; i < n->nu * n->nv; i++) {
        const double *x = n->x[i / n->nv][i % n->nv];
        weights[i] = x[3];
        for (int k = 0; k < 3; k++) {
            points[3 * i + k] = x[k] / x[3];
        }
    }
    CHECK(taut_basis_new(&spec, n->nv, &v, NULL) == TAUT_OK &&
              taut_surface_new(taut_surface_name(n->from), taut_surface_u(n->from), v, points,
                               weights, &s, NULL) == TAUT_OK,
          "a surface of %d by %d", n->nu, n->nv);
    taut_basis_free(v);
    free(points);
    free(n->x);
    return s;
}

typedef struct forgery {
    const char *name, *claim;
    taut_verdict expected; /* of the claim */
    void (*forge)(net nets[3], double radius);
} forgery;

static void keep(net nets[3], double radius)
{
    (void)nets;
    (void)radius;
}

/* A double knot at two places, so that nothing else changes but what lies between them. */
static void add_knots(net nets[3], double from, double to)
{
    for (int i = 0; i < 4 * 3; i++) {
        insert_knot(&nets[i / 4], i % 4 < 2 ? from : to);
    }
}

static void put_knots_in(net nets[3], double radius)
{
    const double from = random_in(0.01, 0.9);
    (void)radius;
    add_knots(nets, from, from + random_in(0.005, 0.08));
}

/* Column of the point that lies in the middle of the piece that begins at a double knot. */
static int column_at(const net *n, double knot)
{
    int j = 0;
    while (n->knots[j] < knot) {
        j++;
    }
    return j;
}

/* A fin on the inside of the blend, far from its joints, ten times the limit to 100 radii high. */
static void raise_fin(net nets[3], double radius)
{
    const double width = random_log(1e-3, 0.02), from = random_in(0.01, 0.24 - width);
    const double place = from + 0.25 * random_int(0, 3);
    const double height = random_log(4e-5, 100) * radius; /* a quarter of it is seen, or more */
    double way[3];
    add_knots(nets, place, place + width);
    net *b = &nets[BLEND];
    const int column = column_at(b, place);
    for (int i = 3; i < b->nu - 3; i++) { /* away from the opposite point */
        double *x = b->x[i][column];
        const double *y = b->x[i][(column + b->nv / 2) % b->nv];
        for (int k = 0; k < 3; k++) {
            way[k] = x[k] / x[3] - y[k] / y[3];
        }
        taut_add_scaled(height * x[3] / taut_norm(way), way, x);
    }
}

/* One to three quarters of the ring, at its own knots. */
static void cut_open(net nets[3], double radius)
{
    const int quarters = random_int(1, 3);
    (void)radius;
    for (int i = 0; i < 3; i++) {
        net *n = &nets[i];
        n->nv = 2 * quarters + 1;
        n->knot_count = n->nv + 3;
        n->knots[n->knot_count - 1] = n->knots[n->knot_count - 2];
    }
}

/* Two or three times around, on as many quarters. */
static void wind_again(net nets[3], double radius)
{
    const int times = random_int(2, 3), quarters = 4 * times;
    (void)radius;
    for (int i = 0; i < 3; i++) {
        net *n = &nets[i];
        for (int row = 0; row < n->nu; row++) {
            for (int j = 9; j < 2 * quarters + 1; j++) {
                memcpy(n->x[row][j], n->x[row][j % 8], sizeof n->x[row][j]);
            }
        }
        n->nv = 2 * quarters + 1;
        n->knot_count = n->nv + 3;
        for (int k = 0; k < n->knot_count; k++) {
            const int at = (k - 1) / 2;
            n->knots[k] = (double)(k == 0 ? 0 : at < quarters ? at : quarters) / quarters;
        }
    }
}

static void go_back(net nets[3], double radius)
{
    (void)radius;
    for (int n = 0; n < 3 * nets[BLEND].nu; n++) {
        net *s = &nets[n / nets[BLEND].nu];
        const int row = n % nets[BLEND].nu;
        for (int j = 0; row < s->nu && 2 * j < s->nv; j++) {
            double swapped[4];
            memcpy(swapped, s->x[row][j], sizeof swapped);
            memcpy(s->x[row][j], s->x[row][s->nv - 1 - j], sizeof swapped);
            memcpy(s->x[row][s->nv - 1 - j], swapped, sizeof swapped);
        }
    }
}

/* The far ring of one straight pipe moved along it, either way, or across. */
static void move_ring(net nets[3], double radius)
{
    const int side = random_int(0, 1), across = random_int(0, 2) == 0;
    net *n = &nets[PIPE_1 + side];
    double way[3], length = 0;
    double(*far)[4] = n->x[side == 0 ? 0 : n->nu - 1];
    const double(*near)[4] = (const double(*)[4])n->x[side == 0 ? n->nu - 1 : 0];
    for (int k = 0; k < 3; k++) {
        way[k] = across ? far[0][k] / far[0][3] - far[4][k] / far[4][3]
                        : far[0][k] / far[0][3] - near[0][k] / near[0][3];
    }
    length = taut_norm(way);
    const double move = (random_int(0, 1) == 0 ? 1 : -1) * random_log(1e-5, 100) * radius;
    for (int j = 0; j < n->nv; j++) {
        taut_add_scaled(move * far[j][3] / length, way, far[j]);
    }
}

/* A slit along the pipe. */
static void slit(net nets[3], double radius)
{
    const double place = 1 - random_log(1e-5, 1e-4);
    (void)radius;
    for (int i = 0; i < 3; i++) {
        net *n = &nets[i];
        insert_knot(n, place);
        insert_knot(n, place);
        n->nv = column_at(n, place);
        n->knot_count = n->nv + 3;
        n->knots[n->knot_count - 1] = place;
    }
}

/* All of a straight pipe moved aside, by less than the tube can tell. */
static void move_aside(net nets[3], double radius)
{
    net *n = &nets[PIPE_1];
    double way[3];
    for (int k = 0; k < 3; k++) {
        way[k] = n->x[0][0][k] / n->x[0][0][3] - n->x[0][4][k] / n->x[0][4][3];
    }
    const double move = random_log(1e-11, 1e-8) * radius / taut_norm(way);
    for (int i = 0; i < n->nu * n->nv; i++) {
        double *x = n->x[i / n->nv][i % n->nv];
        taut_add_scaled(move * x[3], way, x);
    }
}

/* Around a quarter, back again, and on: all points are where they should be. */
static void turn_back(net nets[3], double radius)
{
    enum { QUARTERS = 6, COUNT = 2 * QUARTERS + 1 };
    static const int order[COUNT] = {0, 1, 2, 3, 4, 3, 2, 3, 4, 5, 6, 7, 8};
    (void)radius;
    for (int i = 0; i < 3; i++) {
        net *n = &nets[i];
        for (int row = 0; row < n->nu; row++) {
            double kept[9][4];
            memcpy(kept, n->x[row], sizeof kept);
            for (int j = 0; j < COUNT; j++) {
                memcpy(n->x[row][j], kept[order[j]], sizeof kept[0]);
            }
        }
        n->nv = COUNT;
        n->knot_count = COUNT + 3;
        for (int k = 0; k < n->knot_count; k++) {
            const int at = (k - 1) / 2;
            n->knots[k] = (double)(k == 0 ? 0 : at < QUARTERS ? at : QUARTERS) / QUARTERS;
        }
    }
}

static const forgery forgeries[] = {
    {"kept", "tube", TAUT_TRUE, keep},
    {"knots put in", "tube", TAUT_TRUE, put_knots_in},
    {"gone around the other way", "tube", TAUT_TRUE, go_back},
    {"a fin", "tube", TAUT_FALSE, raise_fin},
    {"cut open", "tube", TAUT_FALSE, cut_open},
    {"slit", "tube", TAUT_FALSE, slit},
    {"wound again", "tube", TAUT_FALSE, wind_again},
    {"a straight pipe moved", "tube", TAUT_FALSE, move_ring},
    {"a straight pipe aside", "joint1", TAUT_FALSE, move_aside},
    {"turned back", "tube", TAUT_FALSE, turn_back},
};

static taut_model *forged(const taut_model *model, const forgery *how, double radius)
{
    net nets[3];
    taut_model *out = NULL;
    taut_curve *axis = NULL;
    CHECK(taut_model_new(&out) == TAUT_OK, "a model");
    for (int i = 0; i < 3; i++) {
        nets[i] = net_of(taut_model_surface(model, i));
    }
    how->forge(nets, radius);
    for (int i = 0; i < 3; i++) {
        CHECK(taut_model_add_surface(out, surface_of(&nets[i])) == TAUT_OK, "a surface");
    }
    CHECK(taut_curve_copy(taut_model_curve(model, 0), &axis) == TAUT_OK &&
              taut_model_add_curve(out, axis) == TAUT_OK,
          "the axis");
    return out;
}

static taut_pipe_problem random_problem(int trial)
{
    taut_pipe_problem problem = pipe_random_ends();
    problem.section.radius = random_log(0.01, 0.3);
    problem.joint = trial % 3 == 0 ? TAUT_PIPE_G2 : TAUT_PIPE_G1;
    problem.lengths[0] = trial % 2 == 0 ? random_in(0.5, 2) : 0;
    problem.lengths[1] = trial % 4 == 0 ? random_in(0.5, 2) : 0;
    if (trial % 5 == 3) {
        problem.section = (taut_pipe_section){.kind = TAUT_PIPE_ELLIPTIC};
        for (int side = 0; side < 2; side++) {
            problem.section.ellipses[side] = (taut_pipe_ellipse){
                random_in(0.1, 0.2), random_in(0.05, 0.1), {0.3, random_in(-1, 1), 1}};
        }
    } else if (trial % 5 == 4) {
        problem.joint = TAUT_PIPE_G1;
        problem.section = (taut_pipe_section){.kind = TAUT_PIPE_CANAL,
                                              .radii = {random_in(0.1, 0.2), random_in(0.1, 0.2)}};
    }
    return problem;
}

static void test_forgeries(void)
{
    enum { KINDS = sizeof forgeries / sizeof forgeries[0] };
    for (int trial = 0; trial < random_trials(10); trial++) {
        const taut_pipe_problem problem = random_problem(trial);
        taut_model *model = NULL;
        if (taut_pipe_make(&problem, NULL, &model, NULL) != TAUT_OK) {
            continue; /* too wide */
        }
        const double radius = detail_of(model, "radius");
        for (int i = 0; i < KINDS; i++) {
            if (problem.section.kind != TAUT_PIPE_ROUND && forgeries[i].forge == turn_back) {
                continue; /* where points are on an ellipse is not held against anything */
            }
            taut_model *other = forged(model, &forgeries[i], radius);
            taut_certificate *certificate = pipe_proved(other, &problem, 1e-6);
            const taut_claim *claim = claim_of(certificate, forgeries[i].claim);
            CHECK(claim->holds == forgeries[i].expected, "trial %d, %s: %d, %g, limit %g, %s",
                  trial, forgeries[i].name, (int)claim->holds, claim->residual, claim->limit,
                  claim->where);
            taut_certificate_free(certificate);
            taut_model_free(other);
        }
        taut_model_free(model);
    }
}

/* An axis that comes back to one place of itself at t_1 and t_2, t_1 + t_2 = s, t_1 t_2 = p, of the
 * plain cubic or of the quintic: no radius is possible, however short the loop is. */
static void test_loops(void)
{
    for (int trial = 0; trial < random_trials(24); trial++) {
        const double s = random_log(3e-3, 0.05), p = random_in(0.05, 0.23) * s * s, q = s * s - p;
        const double turn = random_in(-1, 1), size = random_log(1e-2, 1e2);
        taut_pipe_problem problem = {.axis = {.kind = TAUT_PIPE_POLYGON,
                                              .polygon = {{0, 0, 0},
                                                          {(3 * s - q) / (3 - 6 * s + 3 * q), 0, 0},
                                                          {-1, -q / (3 * s - 3 * q), 0},
                                                          {-2, 1, 0}}},
                                     .section = {.radius = random_log(2e-13, 1e-11) * size}};
        const taut_make_options coarse = {.tolerance = 1e-2};
        taut_model *model = NULL;
        for (int i = 0; i < 4; i++) { /* turned about x + y, so that rounding is not kind */
            double *v = problem.axis.polygon[i];
            const double along = 0.5 * (v[0] + v[1]), across = 0.5 * (v[0] - v[1]);
            v[0] = size * (along + across * (1 - 0.5 * turn * turn));
            v[1] = size * (along - across * (1 - 0.5 * turn * turn));
            v[2] = size * across * turn;
        }
        if (taut_pipe_make(&problem, &coarse, &model, NULL) != TAUT_OK) {
            continue; /* seen by the construction */
        }
        taut_certificate *certificate = pipe_proved(model, &problem, 1e-2);
        const taut_claim *embedded = claim_of(certificate, "embedded");
        CHECK(embedded->holds == TAUT_FALSE || embedded->holds == TAUT_UNDECIDED,
              "trial %d: s = %g, %d, %g, %s", trial, s, (int)embedded->holds, embedded->residual,
              embedded->where);
        taut_certificate_free(certificate);
        taut_model_free(model);
    }
}

int main(void)
{
    random_seed(20261201);
    test_forgeries();
    test_loops();
    return check_failures != 0;
}
