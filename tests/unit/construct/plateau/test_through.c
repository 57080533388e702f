/* test_through.c -- points that a surface of least area passes through: that it does; that no move along its directions that lets
 * it pass there has less area, by the measure of the surfaces alone; that a point of the surface holds nothing; nearest points; what
 * is refused; and what the certificate makes of it. */
#include "bases.h"
#include "certificates.h"
#include "check.h"
#include "shapes.h"

#include "taut/measure.h"
#include "taut/plateau.h"
#include "taut/record.h"

#include <math.h>
#include <string.h>

enum { COUNT = 7, SIZE = COUNT * COUNT, PLACES = 3 };

typedef struct scene {
    taut_basis *u, *v;
    double points[SIZE][3], weights[SIZE];
    unsigned char known[SIZE];
    taut_through through[PLACES];
    taut_plateau_problem problem;
} scene;

/* A saddle over a square, its rim known, with `count` places above or below it. */
static void scene_init(scene *s, int is_rational, int count)
{
    const double bend = random_in(-0.4, 0.4);
    s->u = shape_bspline(3, COUNT);
    s->v = shape_bspline(2, COUNT);
    for (int k = 0; k < SIZE; k++) {
        const int i = k / COUNT, j = k % COUNT;
        const double x = (double)i / (COUNT - 1), y = (double)j / (COUNT - 1);
        s->points[k][0] = x;
        s->points[k][1] = y;
        s->points[k][2] = bend * (x - 0.5) * (y - 0.5) + 0.1 * x * x;
        s->weights[k] = is_rational ? random_log(0.8, 1.25) : 1;
        s->known[k] = i == 0 || j == 0 || i == COUNT - 1 || j == COUNT - 1;
    }
    for (int k = 0; k < count; k++) {
        const double u = random_in(0.2 + 0.25 * k, 0.3 + 0.25 * k), v = random_in(0.3, 0.7);
        s->through[k] = (taut_through){u, v, {u, v, random_in(-0.2, 0.2)}};
    }
    s->problem = (taut_plateau_problem){.net = {.u = s->u,
                                                .v = s->v,
                                                .points = s->points[0],
                                                .known = s->known,
                                                .weights = is_rational ? s->weights : NULL,
                                                .through = s->through,
                                                .through_count = count},
                                        .method = TAUT_PLATEAU_NORMAL};
}

static void scene_free(scene *s)
{
    taut_basis_free(s->u);
    taut_basis_free(s->v);
}

static taut_model *made(const scene *s)
{
    taut_model *model = NULL;
    taut_error error = {.status = TAUT_OK};
    CHECK(taut_plateau_make(&s->problem, NULL, &model, &error) == TAUT_OK, "%s", error.message);
    return model;
}

static double area_of(const scene *s, const double *net)
{
    taut_surface *surface = NULL;
    double area = NAN;
    CHECK(taut_surface_new("net", s->u, s->v, net, s->problem.net.weights, &surface, NULL) ==
                  TAUT_OK &&
              taut_surface_area(surface, &area, NULL) == TAUT_OK,
          "area");
    taut_surface_free(surface);
    return area;
}

/* The largest distance of the surface from its places. */
static double miss_of(const scene *s, const taut_surface *surface)
{
    double worst = 0;
    for (int k = 0; k < s->problem.net.through_count; k++) {
        double x[3];
        taut_surface_eval(surface, s->through[k].u, s->through[k].v, 0, x);
        for (int c = 0; c < 3; c++) {
            worst = fmax(worst, fabs(x[c] - s->through[k].point[c]));
        }
    }
    return worst;
}

/* What a net moves the places by. */
static void moves_of(const scene *s, const double *net, double *moves)
{
    taut_surface *surface = NULL;
    CHECK(taut_surface_new("net", s->u, s->v, net, s->problem.net.weights, &surface, NULL) ==
              TAUT_OK,
          "net");
    for (int k = 0; k < s->problem.net.through_count; k++) {
        taut_surface_eval(surface, s->through[k].u, s->through[k].v, 0, moves + 3 * k);
    }
    taut_surface_free(surface);
}

/* A random move along the directions, less its part that moves the places: by the inverse of what 3 count other moves do. */
static void random_move(const scene *s, const taut_record *directions, double *move)
{
    enum { MOST = 3 * PLACES };
    static double nets[MOST + 1][3 * SIZE];
    const int n = 3 * s->problem.net.through_count;
    double a[MOST][MOST + 1], moves[MOST];

    for (int m = 0; m <= n; m++) {
        for (int k = 0; k < SIZE; k++) {
            const taut_record *d = taut_record_at(taut_record_at(directions, (size_t)(k / COUNT)),
                                                  (size_t)(k % COUNT));
            const double along = s->known[k] ? 0 : random_in(-1, 1);
            for (size_t c = 0; c < 3; c++) {
                nets[m][3 * k + (int)c] = along * taut_record_number(taut_record_at(d, c));
            }
        }
        moves_of(s, nets[m], moves);
        for (int r = 0; r < n; r++) {
            a[r][m == 0 ? n : m - 1] = m == 0 ? -moves[r] : moves[r];
        }
    }
    for (int k = 0; k < n; k++) {
        int most = k;
        for (int i = k + 1; i < n; i++) {
            most = fabs(a[i][k]) > fabs(a[most][k]) ? i : most;
        }
        for (int j = k; j <= n; j++) {
            const double other = a[k][j];
            a[k][j] = a[most][j];
            a[most][j] = other;
        }
        for (int i = 0; i < n; i++) {
            const double factor = i == k ? 0 : a[i][k] / a[k][k];
            for (int j = k; j <= n; j++) {
                a[i][j] -= factor * a[k][j];
            }
        }
    }
    double largest = 0;
    for (int i = 0; i < 3 * SIZE; i++) {
        move[i] = nets[0][i];
        for (int k = 0; k < n; k++) {
            move[i] += a[k][n] / a[k][k] * nets[k + 1][i];
        }
        largest = fmax(largest, fabs(move[i]));
    }
    for (int i = 0; i < 3 * SIZE; i++) {
        move[i] /= largest;
    }
}

/* A(x + h z) - A(x - h z) is 2 h dA z, of which 0 is left; A(x + h z) + A(x - h z) - 2 A(x) is above 0. */
static void check_least(const scene *s, const taut_model *model)
{
    const double step = 1e-3, *x = taut_surface_points(taut_model_surface(model, 0));
    const taut_record *directions = taut_record_get(taut_model_details(model), "directions");
    const double here = area_of(s, x);
    double move[3 * SIZE], net[2][3 * SIZE], areas[2];

    for (int trial = 0; trial < 4; trial++) {
        random_move(s, directions, move);
        for (int i = 0; i < 3 * SIZE; i++) {
            net[0][i] = x[i] + step * move[i];
            net[1][i] = x[i] - step * move[i];
        }
        for (int k = 0; k < 2; k++) {
            areas[k] = area_of(s, net[k]);
        }
        const double slope = fabs(areas[0] - areas[1]) / (2 * step * here);
        CHECK(areas[0] + areas[1] - 2 * here > 0, "another has less area");
        CHECK(slope <= 2e-5, "the area has the slope %.3g along a move", slope);
    }
}

static void check_certificate(const scene *s, const taut_model *model)
{
    static const char *const claims[] = {"stationary", "known", "through", "identity"};
    taut_certificate *certificate = NULL;

    CHECK(taut_plateau_certify(model, &s->problem, NULL, &certificate, NULL) == TAUT_OK, "proof");
    for (int k = 0; k < 4; k++) {
        const taut_claim *claim = claim_of(certificate, claims[k]);
        CHECK(claim != NULL && claim->holds == TAUT_TRUE, "%s: %.3g of %.3g", claims[k],
              claim != NULL ? claim->residual : NAN, claim != NULL ? claim->limit : NAN);
    }
    const taut_claim *least = claim_of(certificate, "least");
    CHECK(least != NULL && least->holds == TAUT_UNDECIDED &&
              strncmp(least->where, "inside", 6) == 0,
          "least");
    taut_certificate_free(certificate);
}

static void test_passes(void)
{
    double worst = 0;
    for (int trial = 0; trial < random_trials(12); trial++) {
        scene s;
        scene_init(&s, trial % 2, 1 + trial % PLACES);
        taut_model *model = made(&s);
        worst = fmax(worst, miss_of(&s, taut_model_surface(model, 0)));
        check_least(&s, model);
        check_certificate(&s, model);
        CHECK(taut_record_count(taut_record_get(taut_model_details(model), "warnings")) == 1,
              "a warning");
        taut_model_free(model);
        scene_free(&s);
    }
    CHECK(worst <= 2e-15, "it passes %.3g by", worst);
}

/* A point that the surface has holds nothing where all may move, by factors: but the steps begin elsewhere, and a film that is
 * level may rest anywhere in the valley of nets that slide within it, here 1.7e-10 higher. Along normals it begins from another net, that of the
 * Dirichlet surface through the point, and ends near by: 8.5e-7 more. */
static void test_nothing_held(void)
{
    for (int k = 0; k < 2; k++) {
        scene s;
        scene_init(&s, 0, 0);
        s.problem.method = k == 0 ? TAUT_PLATEAU_NORMAL : TAUT_PLATEAU_FULL;
        taut_model *plain = made(&s);
        s.through[0] = (taut_through){0.4, 0.55, {0}};
        taut_surface_eval(taut_model_surface(plain, 0), 0.4, 0.55, 0, s.through[0].point);
        s.problem.net.through_count = 1;
        taut_model *held = made(&s);
        const double areas[2] = {area_of(&s, taut_surface_points(taut_model_surface(plain, 0))),
                                 area_of(&s, taut_surface_points(taut_model_surface(held, 0)))};
        CHECK(fabs(areas[1] - areas[0]) <= (k == 0 ? 1e-5 : 3e-10) * areas[0],
              "%d: the area is %.3g more", k, areas[1] - areas[0]);
        CHECK(miss_of(&s, taut_model_surface(held, 0)) <= 1e-15, "%d: it passes by", k);
        check_certificate(&s, held);
        taut_model_free(plain);
        taut_model_free(held);
        scene_free(&s);
    }
}

/* Without u and v the place is that of the nearest point of the surface that passes through none: on its normal there. */
static void test_nearest(void)
{
    for (int trial = 0; trial < random_trials(4); trial++) {
        scene s;
        scene_init(&s, 0, 0);
        taut_model *plain = made(&s);
        const double at[2] = {random_in(0.3, 0.7), random_in(0.3, 0.7)}, height = 0.05;
        taut_forms forms;
        CHECK(taut_surface_forms_points(taut_model_surface(plain, 0), 1, &at[0], &at[1], 1,
                                        &forms) == TAUT_OK,
              "forms");
        s.through[0] = (taut_through){NAN, NAN, {0}};
        taut_surface_eval(taut_model_surface(plain, 0), at[0], at[1], 0, s.through[0].point);
        for (int c = 0; c < 3; c++) {
            s.through[0].point[c] += height * forms.normal[c];
        }
        s.problem.net.through_count = 1;
        taut_model *held = made(&s);
        const taut_record *told =
            taut_record_at(taut_record_get(taut_model_details(held), "through"), 0);
        CHECK(fabs(taut_record_number(taut_record_get(told, "u")) - at[0]) <= 1e-9 &&
                  fabs(taut_record_number(taut_record_get(told, "v")) - at[1]) <= 1e-9,
              "the nearest point");
        check_certificate(&s, held);
        taut_model_free(plain);
        taut_model_free(held);
        scene_free(&s);
    }
}

static void check_refused(const scene *s, taut_status status, const char *reason, const char *where)
{
    taut_model *model = NULL;
    taut_error error = {.status = TAUT_OK};
    CHECK(taut_plateau_make(&s->problem, NULL, &model, &error) == status && model == NULL, "%s: %s",
          reason, error.message);
    CHECK(strcmp(error.reason, reason) == 0 && strcmp(error.where, where) == 0, "%s %s, not %s %s",
          error.reason, error.where, reason, where);
}

static void test_refused(void)
{
    scene s;
    scene_init(&s, 0, 2);
    s.through[1] = (taut_through){0, 0.5, {0, 0.5, 3}}; /* the rim is known */
    check_refused(&s, TAUT_NO_SOLUTION, "through", "/through/1");
    s.through[1] = s.through[0];
    s.through[1].point[2] += 0.1;
    check_refused(&s, TAUT_NO_SOLUTION, "through", "/through/1");
    s.through[1].u = 1.5;
    check_refused(&s, TAUT_BAD_INPUT, "value", "/through/1/u");
    s.through[1].u = NAN;
    check_refused(&s, TAUT_BAD_INPUT, "value", "/through/1/u");
    s.problem.net.through_count = 1;
    s.problem.refine = 1;
    check_refused(&s, TAUT_BAD_INPUT, "conflict", "/through");
    s.problem.refine = 0;
    s.problem.gap = 1e-3;
    check_refused(&s, TAUT_BAD_INPUT, "conflict", "/through");
    scene_free(&s);
}

/* Moved by ten times the limit it passes no more; a tenth is nothing. Without the problem nothing is said. */
static void test_forged(void)
{
    scene s;
    scene_init(&s, 0, 2);
    taut_model *model = made(&s);
    taut_certificate *certificate = NULL;
    taut_error error;
    CHECK(taut_plateau_certify(model, NULL, NULL, &certificate, &error) == TAUT_BAD_INPUT &&
              strcmp(error.reason, "needs-problem") == 0,
          "the model alone");
    CHECK(taut_plateau_certify(model, &s.problem, NULL, &certificate, NULL) == TAUT_OK, "proof");
    const double limit = claim_of(certificate, "through")->limit;
    taut_certificate_free(certificate);
    for (int k = 0; k < 2; k++) {
        scene moved = s;
        moved.problem.net.through = moved.through;
        moved.through[1].point[2] += (k == 0 ? 0.1 : 10) * limit;
        CHECK(taut_plateau_certify(model, &moved.problem, NULL, &certificate, NULL) == TAUT_OK,
              "proof");
        CHECK(claim_of(certificate, "through")->holds == (k == 0 ? TAUT_TRUE : TAUT_FALSE),
              "moved by %s of the limit", k == 0 ? "a tenth" : "ten times");
        taut_certificate_free(certificate);
    }
    scene without = s;
    without.problem.net.through_count = 0; /* then it is not at rest */
    CHECK(taut_plateau_certify(model, &without.problem, NULL, &certificate, NULL) == TAUT_OK,
          "proof");
    CHECK(claim_of(certificate, "stationary")->holds != TAUT_TRUE, "held by nothing");
    taut_certificate_free(certificate);
    taut_model_free(model);
    scene_free(&s);
}

int main(void)
{
    test_passes();
    test_nothing_held();
    test_nearest();
    test_refused();
    test_forged();
    return check_failures != 0;
}
