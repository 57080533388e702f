/* test_film_laws.c [SAILS [RINGS [FIRST LAST]]] -- random sails and rings by all laws: each ends in a film whose claims hold and that has
 * no fold, or in a refusal whose reason is true by other means.
 *
 *     flat sails   a closed curve of sampled arcs that crosses itself nowhere, and turns once, is all that a sail needs; the
 *                  least forces are bisected by it
 *     weak ones    in space: a film with forces above those that are named, none with forces well below
 *     rings        between circles about one axis, or a circle and a closed cable, by the catenoids there are
 *
 * What only says that it was not found (`folds`, `not-converged`) counts, and must be rare. With FIRST and LAST only those of
 * the sails in space are tried that have these numbers, and no flat ones. */
#include "certificates.h"
#include "check.h"
#include "geometry/arc.h"
#include "rings.h"
#include "sails.h"

#include <stdlib.h>
#include <string.h>

enum { SIDE = 200 /* pieces of an arc, short ones at its ends */, GRID = 41 };
static const double pi = 3.14159265358979324;

typedef struct tally {
    int films, refused, lost;
    int first, last; /* of those that are drawn, the ones to try */
} tally;

static int is_left_out(const tally *t, int trial)
{
    return trial < t->first || trial > t->last;
}

/* ---- films ---- */

/* Does the normal turn over from one place of a grid to the next? */
static int has_fold(const taut_surface *surface)
{
    static double n[GRID][GRID][3];
    const taut_basis *u = taut_surface_u(surface), *v = taut_surface_v(surface);

    for (int i = 0; i < GRID; i++) {
        for (int j = 0; j < GRID; j++) {
            const double a = (i + 0.5) / GRID, b = (j + 0.5) / GRID;
            double x[TAUT_SURFACE_VECTORS(1)][3];
            const double at[2] = {taut_basis_lo(u) + a * (taut_basis_hi(u) - taut_basis_lo(u)),
                                  taut_basis_lo(v) + b * (taut_basis_hi(v) - taut_basis_lo(v))};
            (void)taut_surface_eval(surface, at[0], at[1], 1, x[0]);
            const double *p = x[TAUT_XU], *q = x[TAUT_XV];
            for (int c = 0; c < 3; c++) {
                const int d = (c + 1) % 3, e = (c + 2) % 3;
                n[i][j][c] = p[d] * q[e] - p[e] * q[d];
            }
            const double *before[2] = {i > 0 ? n[i - 1][j] : n[i][j],
                                       j > 0 ? n[i][j - 1] : n[i][j]};
            for (int k = 0; k < 2; k++) {
                const double *o = before[k], *m = n[i][j];
                if (!(m[0] * o[0] + m[1] * o[1] + m[2] * o[2] > 0)) {
                    return 1;
                }
            }
        }
    }
    return 0;
}

/* The claims of a film that was made. */
static void check_film(const taut_model *model, const taut_film_problem *problem, const char *kind,
                       int trial)
{
    taut_certificate *proof = NULL;
    taut_error error = {.status = TAUT_OK};

    CHECK(taut_film_certify(model, problem, NULL, &proof, &error) == TAUT_OK, "%s %d: %s", kind,
          trial, error.message);
    for (int k = 0; k < taut_certificate_claim_count(proof); k++) {
        const taut_claim *claim = taut_certificate_claim(proof, k);
        CHECK(claim->holds == TAUT_TRUE || strcmp(claim->claim, "least") == 0,
              "%s %d: %s: %g, limit %g: %s", kind, trial, claim->claim, claim->residual,
              claim->limit, claim->where);
    }
    CHECK(!(claim_of(proof, "least")->residual < -1e-12), "%s %d: below the bound", kind, trial);
    CHECK(!has_fold(taut_model_surface(model, 0)), "%s %d: a fold", kind, trial);
    taut_certificate_free(proof);
}

static int is_one_of(const char *reason, const char *const *words)
{
    for (; *words != NULL && strcmp(reason, *words) != 0; words++) {
    }
    return *words != NULL;
}

/* Makes it; what came of it is counted. */
static taut_status try_film(const taut_film_problem *problem, const char *kind, int trial, tally *t,
                            taut_error *error)
{
    static const char *const lost[] = {"folds", "not-converged", NULL};
    taut_model *model = NULL;
    const taut_status status = taut_film_make(problem, NULL, &model, error);

    if (status == TAUT_OK) {
        t->films++;
        check_film(model, problem, kind, trial);
    } else if (is_one_of(error->reason, lost)) {
        t->lost++;
        CHECK(strcmp(error->reason, "folds") != 0 || strstr(error->message, " near u = ") != NULL,
              "%s %d: no place: %s", kind, trial, error->message);
    } else {
        t->refused++;
    }
    taut_model_free(model);
    return status;
}

/* The document of a sail, for whom a failure is to be looked at. */
static void say_sail(const taut_film_problem *problem, int count, int degree)
{
    static const char *const corners[4] = {"u0v0", "u1v0", "u0v1", "u1v1"};
    static const char *const edges[4] = {"u0", "u1", "v0", "v1"};
    const char *basis = "{\"type\": \"bspline\", \"degree\": %d, \"count\": %d}";

    printf("{\"taut\": 1, \"construct\": \"film\", \"least\": false, \"tension\": %.17g, \"u\": ",
           problem->tension);
    printf(basis, degree, count);
    printf(", \"v\": ");
    printf(basis, degree, count);
    printf(", \"corners\": {");
    for (int c = 0; c < 4; c++) {
        const double *x = problem->corners[c], *d = problem->guides[c].direction;
        const int held = problem->corner_kinds[c] == TAUT_FILM_HELD;
        printf("%s\"%s\": ", c > 0 ? ", " : "", corners[c]);
        if (!held) {
            printf("{\"line\": {\"direction\": [%.17g, %.17g, %.17g], \"point\": ", d[0], d[1],
                   d[2]);
        }
        printf("[%.17g, %.17g, %.17g]", x[0], x[1], x[2]);
        if (!held) {
            printf("}, \"near\": [%.17g, %.17g, %.17g]}", x[0], x[1], x[2]);
        }
    }
    printf("}, \"edges\": {");
    for (int e = 0; e < 4; e++) {
        const taut_film_edge *edge = &problem->edges[e];
        printf("%s\"%s\": ", e > 0 ? ", " : "", edges[e]);
        if (edge->kind == TAUT_FILM_FIXED) {
            printf("\"fixed\"");
        } else if (edge->law == TAUT_FILM_ELASTIC) {
            printf("{\"cable\": {\"unstressed\": %.17g, \"stiffness\": %.17g}}", edge->unstressed,
                   edge->stiffness);
        } else {
            printf("{\"cable\": {\"%s\": %.17g}}",
                   edge->law == TAUT_FILM_FORCE    ? "force"
                   : edge->law == TAUT_FILM_LENGTH ? "length"
                                                   : "sag",
                   edge->law == TAUT_FILM_FORCE    ? edge->force
                   : edge->law == TAUT_FILM_LENGTH ? edge->length
                                                   : edge->sag);
        }
    }
    printf("}}\n");
}

static int is_made(const taut_film_problem *problem)
{
    taut_model *model = NULL;
    const taut_status status = taut_film_make(problem, NULL, &model, NULL);
    taut_model_free(model);
    return status == TAUT_OK;
}

/* ---- flat sails ---- */

typedef struct outline {
    double corners[4][2]; /* counter-clockwise */
    double radius[4];     /* of the side from each corner to the next; 0: straight */
} outline;

static double side_length(const outline *o, int k)
{
    const double *a = o->corners[k], *b = o->corners[(k + 1) % 4];
    return hypot(b[0] - a[0], b[1] - a[1]);
}

/* Point i of SIDE of a side: an arc bows to the left. */
static void place_of(const outline *o, double factor, int k, int i, double x[2])
{
    const double *a = o->corners[k], *b = o->corners[(k + 1) % 4];
    const double c = side_length(o, k), t = 0.5 - 0.5 * cos(pi * i / SIDE),
                 r = factor * o->radius[k];
    const double along[2] = {(b[0] - a[0]) / c, (b[1] - a[1]) / c};
    double s = t * c, h = 0;

    if (r > 0) {
        const double half = asin(fmin(1, c / (2 * r))), angle = half * (2 * t - 1);
        s = 0.5 * c + r * sin(angle);
        h = r * (cos(angle) - cos(half));
    }
    x[0] = a[0] + s * along[0] - h * along[1];
    x[1] = a[1] + s * along[1] + h * along[0];
}

static double turn_of(const double a[2], const double b[2], const double c[2])
{
    return (b[0] - a[0]) * (c[1] - b[1]) - (b[1] - a[1]) * (c[0] - b[0]);
}

static int cross(const double a[2], const double b[2], const double c[2], const double d[2])
{
    return turn_of(a, b, c) * turn_of(a, b, d) < 0 && turn_of(c, d, a) * turn_of(c, d, b) < 0;
}

/* Is there a sail with all radii `factor` times what they are? */
static int is_sail(const outline *o, double factor)
{
    static double x[4 * SIDE][2];
    const int count = 4 * SIDE;
    double turned = 0;

    for (int k = 0; k < 4; k++) {
        if (o->radius[k] > 0 && side_length(o, k) > 2 * factor * o->radius[k]) {
            return 0;
        }
        for (int i = 0; i < SIDE; i++) {
            place_of(o, factor, k, i, x[k * SIDE + i]);
        }
    }
    for (int i = 0; i < count; i++) {
        const double *a = x[i], *b = x[(i + 1) % count], *c = x[(i + 2) % count];
        turned +=
            atan2(turn_of(a, b, c), (b[0] - a[0]) * (c[0] - b[0]) + (b[1] - a[1]) * (c[1] - b[1]));
        for (int j = i + 2; j < count; j++) {
            if (j / SIDE != i / SIDE && (j + 1) % count != i &&
                cross(a, b, x[j], x[(j + 1) % count])) {
                return 0;
            }
        }
    }
    return fabs(turned - 2 * pi) < 1;
}

/* The least factor, to the sampling. */
static double least_factor(const outline *o)
{
    double no = 1e-4, yes = 1e5;
    while (yes > 1.0001 * no) {
        const double middle = sqrt(no * yes);
        *(is_sail(o, middle) ? &yes : &no) = middle;
    }
    return yes;
}

/* The radius of an arc of this length over a chord: length = 2 r asin(c / (2 r)), up to half a circle. */
static double radius_of_length(double c, double length)
{
    double lo = 0.5 * c, hi = 1e9 * c;
    for (int k = 0; k < 200; k++) {
        const double r = 0.5 * (lo + hi);
        *(2 * r * asin(c / (2 * r)) > length ? &lo : &hi) = r;
    }
    return lo;
}

/* Of an elastic cable: r = EA (L - L0) / (L0 s), L the arc's. */
static double radius_of_spring(double c, double unstressed, double stiffness, double s)
{
    double lo = 0.5 * c, hi = 1e9 * c;
    for (int k = 0; k < 200; k++) {
        const double r = 0.5 * (lo + hi);
        const double length = 2 * r * asin(c / (2 * r));
        *(stiffness * (length - unstressed) / unstressed > s * r ? &lo : &hi) = r;
    }
    return lo;
}

static const int edge_of[4] = {2, 1, 3, 0}; /* as sides run counter-clockwise */
static const int corner_of[4] = {0, 1, 3, 2};

/* 0 where a law has no arc of at most half a circle. */
static double radius_of(const taut_film_edge *edge, double c, double s)
{
    if (edge->law == TAUT_FILM_FORCE) {
        return edge->force / s;
    }
    if (edge->law == TAUT_FILM_ELASTIC) {
        return radius_of_spring(c, edge->unstressed, edge->stiffness, s);
    }
    return radius_of_length(c, edge->law == TAUT_FILM_LENGTH
                                   ? edge->length
                                   : c * (1 + 4 * edge->sag * edge->sag) / (4 * edge->sag) *
                                         asin(4 * edge->sag / (1 + 4 * edge->sag * edge->sag)));
}

/* All corners about those of a square; size: its side. */
static sail random_sail(int flat, double *size)
{
    double corners[4][3];
    *size = random_log(1e-2, 1e2);
    const double off = random_int(0, 9) == 0 ? 1 : 0.35;
    for (int c = 0; c < 4; c++) {
        for (int k = 0; k < 3; k++) {
            const double at = k == 0 ? c % 2 : k == 1 ? c / 2 : 0;
            corners[c][k] = *size * (at + (k == 2 && flat ? 0 : random_in(-off, off)));
        }
    }
    const int degree = random_int(3, 4);
    sail s = sail_new(degree, degree + random_int(2, 5), (const double(*)[3])corners, 1);
    s.problem.tension = random_log(1e-2, 1e2);
    s.problem.without_least = !flat;
    return s;
}

static double chord_of(const taut_film_problem *problem, int k)
{
    const double *a = problem->corners[corner_of[k]], *b = problem->corners[corner_of[(k + 1) % 4]];
    return sqrt((a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]) +
                (a[2] - b[2]) * (a[2] - b[2]));
}

static void random_law(taut_film_problem *problem, int k, int any)
{
    taut_film_edge *edge = &problem->edges[edge_of[k]];
    const double c = chord_of(problem, k);
    const int law = any ? random_int(0, 4) : 0;

    edge->force = problem->tension * c * random_log(0.4, 10);
    edge->law = law == 1   ? TAUT_FILM_LENGTH
                : law == 2 ? TAUT_FILM_SAG
                : law == 3 ? TAUT_FILM_ELASTIC
                           : TAUT_FILM_FORCE;
    edge->length = c * random_in(0.98, 1.25);
    edge->sag = random_in(0.01, 0.3);
    edge->unstressed = c * random_in(0.8, 1.1);
    edge->stiffness = problem->tension * c * random_log(3, 100);
    if (law == 4) {
        *edge = (taut_film_edge){.kind = TAUT_FILM_FIXED};
    }
}

static int has_law(const taut_film_problem *problem, taut_film_law law)
{
    for (int e = 0; e < 4; e++) {
        if (problem->edges[e].kind == TAUT_FILM_CABLE && problem->edges[e].law == law) {
            return 1;
        }
    }
    return 0;
}

static int is_too_short(const taut_film_problem *problem)
{
    for (int k = 0; k < 4; k++) {
        const taut_film_edge *edge = &problem->edges[edge_of[k]];
        if (edge->kind == TAUT_FILM_CABLE && edge->law == TAUT_FILM_LENGTH &&
            edge->length <= chord_of(problem, k)) {
            return 1;
        }
    }
    return 0;
}

/* The outline that the laws give. */
static void find_outline(const taut_film_problem *problem, outline *o)
{
    double area = 0;
    for (int k = 0; k < 4; k++) {
        memcpy(o->corners[k], problem->corners[corner_of[k]], sizeof o->corners[k]);
    }
    for (int k = 0; k < 4; k++) {
        const double *a = o->corners[k], *b = o->corners[(k + 1) % 4];
        area += a[0] * b[1] - a[1] * b[0];
    }
    for (int k = 0; k < 4; k++) {
        const taut_film_edge *edge = &problem->edges[edge_of[k]];
        o->radius[k] = edge->kind == TAUT_FILM_CABLE
                           ? radius_of(edge, side_length(o, k), problem->tension)
                           : 0;
    }
    for (int k = 0; k < 4 && area < 0; k++) { /* the other way up */
        o->corners[k][1] *= -1;
    }
}

static void end_sail(sail *s, int failures)
{
    if (check_failures > failures) {
        say_sail(&s->problem, taut_basis_count(s->u), taut_basis_degree(s->u));
    }
    sail_free(s);
}

static void try_flat(int trial, tally *t)
{
    const int failures = check_failures;
    double size = 0;
    sail s = random_sail(1, &size);
    for (int k = 0; k < 4; k++) {
        random_law(&s.problem, k, trial % 2);
    }
    if (is_left_out(t, trial)) {
        sail_free(&s);
        return;
    }
    taut_error error = {.status = TAUT_OK};
    const taut_status status = try_film(&s.problem, "flat sail", trial, t, &error);
    if (is_too_short(&s.problem)) {
        CHECK(status != TAUT_OK && strcmp(error.reason, "cable-too-short") == 0, "%d: %s", trial,
              error.reason);
        end_sail(&s, failures);
        return;
    }
    outline o;
    find_outline(&s.problem, &o);
    outline chords = o;
    memset(chords.radius, 0, sizeof chords.radius);
    const int is_crossed = !is_sail(&chords, 1);
    const double least = is_crossed ? 0 : least_factor(&o);
    CHECK((strcmp(error.reason, "crossed") == 0) == is_crossed, "flat %d: %s", trial,
          error.message);
    if (is_crossed) {
        end_sail(&s, failures);
        return;
    }
    if (status == TAUT_OK) {
        CHECK(least < 1.001, "flat %d: a film where %g times the forces are needed", trial, least);
    } else if (strcmp(error.reason, "cable-too-weak") == 0) {
        CHECK_NEAR(error.limit / error.found, least, 1e-3 * least, "flat %d: %s", trial,
                   error.message);
    } else { /* there may be one */
        CHECK(error.status == TAUT_NOT_CONVERGED, "flat %d: %s", trial, error.message);
        printf("flat %d, least factor %.6g: %s: %s\n", trial, least, error.reason, error.message);
    }
    end_sail(&s, failures);
}

/* ---- sails in space ---- */

/* So often as strong: forces so often, what given lengths have over their chords so often less, squared. */
static void strengthen(taut_film_problem *problem, double factor)
{
    for (int k = 0; k < 4; k++) {
        taut_film_edge *edge = &problem->edges[edge_of[k]];
        const double c = chord_of(problem, k);
        if (edge->law == TAUT_FILM_SAG) {
            const double f = edge->sag;
            edge->length = c * (1 + 4 * f * f) / (4 * f) * asin(4 * f / (1 + 4 * f * f));
            edge->law = TAUT_FILM_LENGTH;
        }
        edge->force *= factor;
        edge->length = c + (edge->length - c) / (factor * factor);
    }
}

/* How many times stronger the cables have to be, of which the error tells one. */
static double factor_told(const taut_film_problem *problem, const taut_error *error)
{
    for (int k = 0; k < 4; k++) {
        const taut_film_edge *edge = &problem->edges[edge_of[k]];
        if (strncmp(error->where + 7,
                    edge_of[k] == 0   ? "u0"
                    : edge_of[k] == 1 ? "u1"
                    : edge_of[k] == 2 ? "v0"
                                      : "v1",
                    2) == 0) {
            const double c = chord_of(problem, k);
            return edge->law == TAUT_FILM_FORCE ? error->limit / error->found
                                                : sqrt((error->found - c) / (error->limit - c));
        }
    }
    return NAN;
}

/* There is a film with cables a little stronger than is told, and none with weaker ones. */
static void check_weak(const taut_film_problem *problem, const taut_error *error, int trial,
                       tally *t)
{
    const double factor = factor_told(problem, error);
    taut_film_problem other = *problem;

    CHECK(factor > 1, "sail %d: %g: %s", trial, factor, error->message);
    strengthen(&other, 0.9 * factor);
    CHECK(!is_made(&other), "sail %d: a film with 0.9 of the least: %s", trial, error->message);
    other = *problem;
    strengthen(&other, 1.1 * factor);
    taut_model *model = NULL;
    taut_error above = {.status = TAUT_OK};
    const taut_status status = taut_film_make(&other, NULL, &model, &above);
    taut_model_free(model);
    if (status ==
        TAUT_NOT_CONVERGED) { /* not found, which is no statement; report() bounds how many */
        t->lost++;
        printf("sail %d, 1.1 of the least: %s: %s\n", trial, above.reason, above.message);
        return;
    }
    /* the way down from stronger cables begins elsewhere, and may end a little earlier */
    CHECK(status == TAUT_OK ||
              (strcmp(above.reason, "cable-too-weak") == 0 && factor_told(&other, &above) < 1.1),
          "sail %d: no film with 1.1 of the least: %s", trial, above.message);
}

static void try_space(int trial, tally *t)
{
    static const char *const known[] = {"cable-too-weak", "cable-too-short", "folds",
                                        "not-converged",  "slides-away",     NULL};
    const int failures = check_failures;
    double size = 0;
    sail s = random_sail(0, &size);
    for (int k = 0; k < 4; k++) {
        random_law(&s.problem, k, trial % 2);
    }
    if (random_int(0, 3) == 0) { /* a corner glides on a mast */
        const int c = random_int(0, 3);
        const double up[3] = {random_in(-0.3, 0.3), random_in(-0.3, 0.3), 1};
        const taut_film_edge *ends[2] = {&s.problem.edges[c % 2], &s.problem.edges[2 + c / 2]};
        if (ends[0]->kind == TAUT_FILM_CABLE && ends[1]->kind == TAUT_FILM_CABLE &&
            ends[0]->law != TAUT_FILM_SAG && ends[1]->law != TAUT_FILM_SAG) {
            s.problem.corner_kinds[c] = TAUT_FILM_ON_LINE;
            memcpy(s.problem.guides[c].point, s.problem.corners[c], sizeof up);
            memcpy(s.problem.guides[c].direction, up, sizeof up);
        }
    }
    if (is_left_out(t, trial)) {
        sail_free(&s);
        return;
    }
    taut_error error = {.status = TAUT_OK};
    const taut_status status = try_film(&s.problem, "sail", trial, t, &error);
    CHECK(status == TAUT_OK || is_one_of(error.reason, known), "sail %d: %s: %s", trial,
          error.reason, error.message);
    if (status != TAUT_OK && strcmp(error.reason, "cable-too-weak") == 0 &&
        !has_law(&s.problem, TAUT_FILM_ELASTIC)) {
        check_weak(&s.problem, &error, trial, t);
    } else if (status != TAUT_OK && strcmp(error.reason, "cable-too-short") == 0) {
        CHECK(is_too_short(&s.problem), "sail %d: %s", trial, error.message);
    } else if (error.status == TAUT_NOT_CONVERGED) {
        printf("sail %d: %s: %s\n", trial, error.reason, error.message);
    }
    end_sail(&s, failures);
}

/* ---- rings ---- */

/* The farthest that circles of radius p and q about one axis may be apart: h = a (acosh(p / a) + acosh(q / a)), the largest
 * over the neck a. */
static double reach_of_circles(double p, double q)
{
    double most = 0;
    for (int k = 1; k < 200000; k++) {
        const double a = fmin(p, q) * k / 200000;
        most = fmax(most, a * (acosh(p / a) + acosh(q / a)));
    }
    return most;
}

/* The same of a circle of radius 1 and a closed cable of force t over the tension inside it, whose radius r is
 * sqrt(a^2 + t^2): the film draws it outwards by sqrt(1 - a^2 / r^2), its neck below or above it. */
static double reach_of_cable(double t)
{
    double most = 0;
    for (int k = 1; k < 200000; k++) {
        const double a = (double)k / 200000, r = sqrt(a * a + t * t);
        most = r < 1 ? fmax(most, a * (acosh(1 / a) - acosh(r / a))) : most;
    }
    return most;
}

static void try_ring(int trial, tally *t)
{
    const int kind = random_int(0, 3), degree = random_int(3, 4);
    ring r = ring_new(degree, 2 * degree + random_int(6, 10), degree, degree + random_int(2, 5));
    const double q = random_in(0.4, 1.6), force = random_in(0.05, 0.6), tilt = random_in(0, 0.3);
    const double reach = kind == 0   ? reach_of_circles(1, q)
                         : kind == 1 ? reach_of_cable(force)
                         : kind == 2 ? 0.5 * reach_of_circles(1, 1)
                                     : 0.8;
    const double h = reach * random_in(0.3, 1.3);
    taut_error error = {.status = TAUT_OK};

    ring_circle(&r, 0, 0, 1);
    if (kind == 0) {
        ring_circle(&r, 1, h, q);
    } else if (kind == 1) {
        ring_cable(&r, 1, h, force);
    } else if (kind == 2) {
        ring_slide(&r, 1, h);
    } else { /* about another axis */
        const double center[3] = {tilt, 0, h}, normal[3] = {tilt, tilt, 1};
        CHECK(taut_circle_new(center, normal, q, NULL, &r.rims[1]) == TAUT_OK, "%g", q);
        r.problem.edges[3] = (taut_film_edge){.kind = TAUT_FILM_FIXED, .curve = r.rims[1]};
    }
    const taut_status status = try_film(&r.problem, "ring", trial, t, &error);
    if (status == TAUT_OK && kind < 3) {
        CHECK(h < reach * (1 + 1e-4), "ring %d: a film at %g of what there is", trial, h / reach);
    } else if (status != TAUT_OK && error.status == TAUT_NO_SOLUTION) {
        CHECK(strcmp(error.reason, "collapses") == 0 || strcmp(error.reason, "slides-away") == 0,
              "ring %d: %s: %s", trial, error.reason, error.message);
        CHECK(kind == 3 || h > reach * (1 - 5e-3),
              "ring %d of kind %d: none at %g of what there is: %s", trial, kind, h / reach,
              error.message);
    } else if (status != TAUT_OK) {
        printf(
            "ring %d of kind %d, %g of what there is: degree %d, %d and %d points, height %.17g, "
            "radius %.17g, force %.17g: %s: %s\n",
            trial, kind, h / reach, degree, taut_basis_count(r.problem.u),
            taut_basis_count(r.problem.v), h, q, force, error.reason, error.message);
    }
    ring_free(&r);
}

static int report(const char *kind, int count, const tally *t)
{
    printf("%s: %d films, %d refused, %d not found\n", kind, t->films, t->refused, t->lost);
    return t->lost <= 1 + count / 10;
}

int main(int argc, char **argv)
{
    const int sails = argc > 1 ? atoi(argv[1]) : random_trials(40);
    const int rings = argc > 2 ? atoi(argv[2]) : random_trials(20);
    const int some = argc > 4;
    tally flat = {.last = some ? -1 : sails}, around = {.last = rings};
    tally space = {.first = some ? atoi(argv[3]) : 0, .last = some ? atoi(argv[4]) : sails};

    random_seed(23);
    for (int k = 0; k < sails / 2; k++) {
        try_flat(k, &flat);
    }
    for (int k = 0; k < sails - sails / 2; k++) {
        try_space(k, &space);
    }
    for (int k = 0; k < rings; k++) {
        try_ring(k, &around);
    }
    CHECK(report("flat sails", sails / 2, &flat), "too many are not found");
    CHECK(report("sails", sails - sails / 2, &space), "too many are not found");
    CHECK(report("rings", rings, &around), "too many are not found");
    return check_failures != 0;
}
