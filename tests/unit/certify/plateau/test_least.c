/* test_least.c -- the claim `least`: films whose least area is known, and witnesses that lie. */
#include "bases.h"
#include "check.h"
#include "films.h"
#include "problems.h"
#include "shapes.h"

#include "certify/plateau/flux.h"
#include "certify/plateau/least.h"
#include "construct/plateau/witness.h"
#include "core/memory.h"

#include <stdlib.h>
#include <string.h>

/* What a proof found. */
typedef struct proof {
    taut_verdict holds;
    double residual, lower, gap;
    char where[64];
} proof;

static double number_in(const taut_record *record, const char *key)
{
    return taut_record_number(taut_record_get(record, key));
}

/* The claim of a film with what its details say. `gap`: asked for, or 0. */
static proof prove_details(const taut_surface *surface, const taut_record *details, double area,
                           double gap)
{
    const taut_least_request request = {
        .surface = surface,
        .witness = taut_record_get(details, "least"),
        .boundary_only = 1,
        .gap = gap,
        .area = area,
    };
    taut_certificate *certificate = NULL;
    taut_record *figures = taut_record_new();
    proof p = {TAUT_FALSE, NAN, NAN, NAN, "no claim"};

    CHECK(taut_certificate_new("plateau", &certificate) == TAUT_OK, "certificate");
    CHECK(taut_certify_add_least(&request, figures, certificate) == TAUT_OK, "claim");
    const taut_claim *claim = taut_certificate_claim(certificate, 0);
    if (claim != NULL) {
        CHECK(strcmp(claim->claim, "least") == 0 && claim->kind == TAUT_BOUND, "%s", claim->claim);
        p.holds = claim->holds;
        p.residual = claim->residual;
        snprintf(p.where, sizeof p.where, "%s", claim->where);
    }
    p.lower = number_in(figures, "lower_bound");
    p.gap = number_in(figures, "gap");
    taut_record_free(figures);
    taut_certificate_free(certificate);
    return p;
}

static proof prove(const taut_surface *surface, const taut_plateau_witness *witness, double area)
{
    taut_record *details = taut_record_new();
    taut_plateau_witness_describe(witness, details);
    const proof p = prove_details(surface, details, area, 0);
    taut_record_free(details);
    return p;
}

static int is_why(const proof *p, const char *word)
{
    return p->holds == TAUT_UNDECIDED && strncmp(p->where, word, strlen(word)) == 0 &&
           isnan(p->lower) && isnan(p->residual);
}

/* The adjoint of Enneper's surface, (-v + u^2 v - v^3/3, -u - u^3/3 + u v^2, -2 u v) over
 * [-r, r]^2: bicubic, least, and along z a graph over a convex domain. */
static taut_surface *adjoint_enneper(double r, const double *weights)
{
    enum { N = 4 };
    double power[N][N], points[N][N][3];

    for (int k = 0; k < N; k++) {
        double c[N] = {0, 0, 0, 0};
        c[k] = 1;
        shape_bernstein(3, N, c, -r, r, power[k]);
    }
    for (int i = 0; i < N; i++) {
        for (int j = 0; j < N; j++) {
            const double u = power[1][i], u2 = power[2][i], u3 = power[3][i];
            const double v = power[1][j], v2 = power[2][j], v3 = power[3][j];
            points[i][j][0] = -v + u2 * v - v3 / 3;
            points[i][j][1] = -u - u3 / 3 + u * v2;
            points[i][j][2] = -2 * u * v;
        }
    }
    return shape_surface(shape_bezier(3, -r, r), shape_bezier(3, -r, r), &points[0][0][0], weights);
}

/* iint (1 + u^2 + v^2)^2 */
static double enneper_area(double r)
{
    return 4 * r * r * (1 + 4 * r * r / 3 + 28 * pow(r, 4) / 45);
}

static taut_plateau_witness *witness_of(const taut_surface *surface)
{
    taut_plateau_witness *witness = NULL;
    CHECK(taut_plateau_witness_new(surface, NULL, &witness) == TAUT_OK, "witness");
    CHECK(witness != NULL, "no witness was found");
    return witness;
}

static size_t size_of(const taut_plateau_witness *witness)
{
    return (size_t)taut_basis_count(witness->u) * (size_t)taut_basis_count(witness->v);
}

/* K(sqrt(3)/2) / K(1/2), Schwarz's quadrilateral, to all its digits. */
static void test_tetrahedron(void)
{
    const double exact = 1.279261571171006;
    const test_problem net = problem_tetrahedron(12);
    const taut_plateau_problem problem = film_problem(&net, TAUT_PLATEAU_FULL);
    taut_model *model = NULL;
    taut_certificate *certificate = NULL;
    taut_error error;

    CHECK(taut_plateau_make(&problem, NULL, &model, &error) == TAUT_OK, "%s", error.message);
    CHECK(taut_plateau_certify(model, &problem, NULL, &certificate, &error) == TAUT_OK, "%s",
          error.message);
    const taut_record *figures = taut_certificate_figures(certificate);
    const double lower = number_in(figures, "lower_bound"), area = number_in(figures, "area");
    CHECK(lower <= exact * (1 + 1e-15) && area >= exact * (1 - 1e-15), "%.17g %.17g", lower, area);
    CHECK(area - lower < 1.4e-11, "gap %g", area - lower);
    CHECK_NEAR(number_in(figures, "gap"), area - lower, 3e-15, "gap");
    taut_certificate_free(certificate);
    taut_model_free(model);
    problem_free((test_problem *)&net);
}

/* The conjugate function is a polynomial here: nothing but rounding is left. */
static void test_enneper(void)
{
    for (int k = 1; k <= 7; k++) {
        const double r = 0.1 * k, area = enneper_area(r);
        taut_surface *surface = adjoint_enneper(r, NULL);
        taut_plateau_witness *witness = witness_of(surface);
        const proof p = prove(surface, witness, area);
        CHECK(p.holds == TAUT_TRUE && p.residual >= 0 && p.residual < 1e-15, "r %g: %g %s", r,
              p.residual, p.where);
        CHECK(p.lower <= area && p.lower > area * (1 - 1e-14), "r %g: %.17g", r, p.lower);
        taut_plateau_witness_free(witness);
        taut_surface_free(surface);
    }
}

/* Moved, turned, scaled, reversed, with u and v changed: the same film. */
static void test_same_film(void)
{
    for (int trial = 0; trial < 40; trial++) {
        static const double scales[] = {1, 1e-80, 3e60, 1e-9, 1e120};
        const double r = random_in(0.1, 0.65), scale = scales[trial % 5];
        const double shift[3] = {scale * random_in(-1, 1), scale * random_in(-9, 9), scale};
        double rotation[3][3];
        taut_surface *surface = adjoint_enneper(r, NULL);
        shape_rotation(rotation);
        for (int k = 0; k < 3; k++) {
            taut_surface *next =
                k == 0 ? shape_moved(surface, scale, (const double(*)[3])rotation, shift)
                : k == 1 && trial % 2 ? shape_transposed(surface)
                : k == 2 && trial % 3 ? shape_reversed(surface)
                                      : NULL;
            if (next != NULL) {
                taut_surface_free(surface);
                surface = next;
            }
        }
        const double area = enneper_area(r) * scale * scale;
        taut_plateau_witness *witness = witness_of(surface);
        if (witness != NULL) {
            const proof p = prove(surface, witness, area);
            CHECK(p.holds == TAUT_TRUE && p.residual < 1e-14, "scale %g: %g %s", scale, p.residual,
                  p.where);
            CHECK(p.lower <= area * (1 + 1e-14), "scale %g: %.17g > %.17g", scale, p.lower, area);
            for (int c = 0; c < 3; c++) { /* the film seen from behind; another length */
                witness->direction[c] *= -7.5;
            }
            const proof behind = prove(surface, witness, area);
            CHECK(behind.holds == TAUT_TRUE && behind.residual < 1e-14, "behind: %g %s",
                  behind.residual, behind.where);
        }
        taut_plateau_witness_free(witness);
        taut_surface_free(surface);
    }
}

/* Weights c^i d^j are other parameters of the same film, where psi is no polynomial. */
static void test_rational(void)
{
    for (int trial = 0; trial < 12; trial++) {
        const double r = 0.5, area = enneper_area(r);
        const double c = random_log(0.6, 1.6), d = random_log(0.6, 1.6),
                     size = random_log(1e-9, 1e9);
        double weights[16];
        for (int k = 0; k < 16; k++) {
            weights[k] = size * pow(c, k / 4) * pow(d, k % 4);
        }
        taut_surface *surface = adjoint_enneper(r, weights);
        taut_plateau_witness *witness = witness_of(surface);
        if (witness != NULL) {
            const proof p = prove(surface, witness, area);
            CHECK(p.residual < 2e-2 && p.lower <= area, "c %g d %g: %g, %.17g, %s", c, d,
                  p.residual, p.lower, p.where);
        }
        taut_plateau_witness_free(witness);
        taut_surface_free(surface);
    }
}

/* Whatever is done to a witness: no bound above the least area. */
static void test_perturbed(void)
{
    int refused = 0, weaker = 0;

    for (int trial = 0; trial < random_trials(400); trial++) {
        const double r = random_in(0.2, 0.65), area = enneper_area(r);
        taut_surface *surface = adjoint_enneper(r, NULL);
        taut_plateau_witness *witness = witness_of(surface);
        const double size = random_log(1e-14, 3);
        for (size_t k = 0; k < size_of(witness); k++) {
            witness->coefficients[k] += random_int(0, 3) == 0 ? size * random_in(-1, 1) : 0;
        }
        for (int c = 0; c < 3; c++) {
            witness->direction[c] += random_int(0, 1) * size * random_in(-1, 1);
        }
        const proof p = prove(surface, witness, area);
        CHECK(!(p.lower > area), "size %g: %.17g above %.17g", size, p.lower, area);
        CHECK(p.holds != TAUT_FALSE, "nothing was asked for");
        CHECK(p.holds != TAUT_TRUE || p.residual <= 1e-6, "%g", p.residual);
        refused += isnan(p.lower) != 0;
        weaker += p.lower < area * (1 - 1e-9);
        taut_plateau_witness_free(witness);
        taut_surface_free(surface);
    }
    CHECK(refused > 10 && weaker > 10, "%d refused, %d weaker: nothing was tried", refused, weaker);
}

/* psi = 0: D is the area of the projection, 4 r^2 (1 - r^4 ..) less than the film's. */
static void test_projection(void)
{
    const double r = 0.5;
    taut_surface *surface = adjoint_enneper(r, NULL);
    taut_plateau_witness *witness = witness_of(surface);
    double shadow = 0;

    memset(witness->coefficients, 0, size_of(witness) * sizeof(double));
    /* J = (1 - (u^2 + v^2)^2 ..): iint (1 + s)(1 - s), s = u^2 + v^2 */
    shadow = 4 * r * r * (1 - 28 * pow(r, 4) / 45);
    const proof p = prove(surface, witness, enneper_area(r));
    CHECK(p.lower <= shadow * (1 + 1e-14) && p.lower > -1, "%.17g, %.17g", p.lower, shadow);
    CHECK(p.holds == TAUT_UNDECIDED && strncmp(p.where, "coarse", 6) == 0, "%s", p.where);
    taut_plateau_witness_free(witness);
    taut_surface_free(surface);
}

/* ---- what is no witness ---- */

/* details.least with one member as a list of numbers, or left out (count < 0). */
static proof prove_forged(const taut_surface *surface, const taut_plateau_witness *witness,
                          const char *key, int count, const double *numbers)
{
    taut_record *details = taut_record_new(), *forged = taut_record_new();
    taut_record *least = taut_record_add_object(forged, "least");
    proof p;

    taut_plateau_witness_describe(witness, details);
    const taut_record *from = taut_record_get(details, "least");
    for (size_t k = 0; k < taut_record_count(from); k++) {
        if (strcmp(taut_record_key(from, k), key) != 0) {
            taut_record_add_record(least, taut_record_key(from, k), taut_record_at(from, k));
        } else if (count >= 0) {
            taut_record_add_numbers(least, key, count, numbers);
        }
    }
    p = prove_details(surface, forged, enneper_area(0.5), 0);
    taut_record_free(details);
    taut_record_free(forged);
    return p;
}

static void test_forged(void)
{
    static const double directions[][3] = {
        {0, 0, 0}, {NAN, 0, 1}, {INFINITY, 0, 1}, {1e-300, 1e300, NAN}};
    taut_surface *surface = adjoint_enneper(0.5, NULL);
    taut_plateau_witness *witness = witness_of(surface);
    proof p;

    for (int k = 0; k < 4; k++) {
        p = prove_forged(surface, witness, "direction", 3, directions[k]);
        CHECK(is_why(&p, "witness"), "direction %d: %s", k, p.where);
    }
    static const char *const keys[] = {"direction", "u", "v", "coefficients"};
    for (int k = 0; k < 4; k++) {
        for (int count = -1; count < 5; count++) {
            p = prove_forged(surface, witness, keys[k], count == 3 ? 4 : count,
                             (const double[5]){0, 1, 2, 3, 4});
            CHECK(is_why(&p, "witness"), "%s %d: %s", keys[k], count, p.where);
        }
    }
    const double x =
        (p = prove_forged(surface, witness, "direction", 3, (const double[3]){1, 0.01, 0}))
            .lower; /* edge on */
    CHECK(isnan(x) && is_why(&p, "folds"), "%s", p.where);
    witness->coefficients[7] = 1e300;
    p = prove(surface, witness, enneper_area(0.5));
    CHECK(isnan(p.lower) && p.holds == TAUT_UNDECIDED, "%s", p.where);
    witness->coefficients[7] = NAN;
    p = prove(surface, witness, enneper_area(0.5));
    CHECK(is_why(&p, "witness"), "%s", p.where);
    for (size_t k = 0; k < size_of(witness); k++) {
        witness->coefficients[k] = 10 * (double)(k % 6);
    }
    p = prove(surface, witness, enneper_area(0.5));
    CHECK(is_why(&p, "steep"), "%s", p.where);
    taut_basis_free(witness->u);
    witness->u = shape_bezier(5, -0.5, 0.75);
    p = prove(surface, witness, enneper_area(0.5));
    CHECK(is_why(&p, "witness"), "another range: %s", p.where);
    taut_basis_free(witness->u);
    witness->u = shape_bezier(30, -0.5, 0.5);
    witness->coefficients = taut_realloc(witness->coefficients, size_of(witness), sizeof(double));
    memset(witness->coefficients, 0, size_of(witness) * sizeof(double));
    p = prove(surface, witness, enneper_area(0.5));
    CHECK(is_why(&p, "witness"), "another degree: %s", p.where);
    taut_plateau_witness_free(witness);
    taut_surface_free(surface);
}

/* A film with psi = 0 along z. */
static proof prove_flat(taut_surface *surface)
{
    const taut_basis *u = taut_surface_u(surface), *v = taut_surface_v(surface);
    const size_t count = (size_t)taut_basis_count(u) * (size_t)taut_basis_count(v);
    taut_plateau_witness witness = {.direction = {0, 0, 1}};
    proof p;

    witness.coefficients = calloc(count, sizeof(double));
    CHECK(taut_basis_copy(u, &witness.u) == TAUT_OK && taut_basis_copy(v, &witness.v) == TAUT_OK,
          "bases");
    p = prove(surface, &witness, 1);
    taut_basis_free(witness.u);
    taut_basis_free(witness.v);
    free(witness.coefficients);
    taut_surface_free(surface);
    return p;
}

/* A ramp around the z axis, over more than a turn or less. */
static taut_surface *ramp(double turns)
{
    enum { N = 40, M = 4 };
    double points[N][M][3];
    for (int i = 0; i < N; i++) {
        for (int j = 0; j < M; j++) {
            const double angle = 6.283185307179586 * turns * i / (N - 1), radius = 2 - j / 3.0;
            points[i][j][0] = radius * cos(angle);
            points[i][j][1] = radius * sin(angle);
            points[i][j][2] = 0.3 * angle;
        }
    }
    return shape_surface(shape_bspline(3, N), shape_bspline(3, M), &points[0][0][0], NULL);
}

/* A plane patch whose middle points of the edges are moved out by `out`. */
static taut_surface *cushion(double out)
{
    double points[3][3][3];
    for (int k = 0; k < 9; k++) {
        const int i = k / 3 - 1, j = k % 3 - 1;
        points[k / 3][k % 3][0] = i * (j == 0 ? 1 + out : 1);
        points[k / 3][k % 3][1] = j * (i == 0 ? 1 + out : 1);
        points[k / 3][k % 3][2] = 0.1 * i * j;
    }
    return shape_surface(shape_bezier(2, 0, 1), shape_bezier(2, 0, 1), &points[0][0][0], NULL);
}

/* A quadrilateral with a corner turned in, in two linear spans each way: (x, y) -> kinked by `in`. */
static taut_surface *kinked(double in)
{
    double points[3][2][3];
    for (int k = 0; k < 6; k++) {
        const int i = k / 2, j = k % 2;
        points[i][j][0] = i;
        points[i][j][1] = j * 2 + (i == 1 ? (j == 0 ? in : 0) : 0);
        points[i][j][2] = 0;
    }
    return shape_surface(shape_bspline(1, 3), shape_bspline(1, 2), &points[0][0][0], NULL);
}

static void test_outlines(void)
{
    proof p = prove_flat(ramp(0.2));
    CHECK(is_why(&p, "outline"), "a ramp of a fifth turns back: %s", p.where);
    p = prove_flat(ramp(1.7));
    CHECK(is_why(&p, "outline"), "a ramp over itself: %s", p.where);
    p = prove_flat(cushion(0.2));
    CHECK(p.holds == TAUT_UNDECIDED && p.lower > 0, "convex: %s", p.where);
    p = prove_flat(cushion(0));
    CHECK(p.holds == TAUT_UNDECIDED && p.lower > 0, "straight: %s", p.where);
    p = prove_flat(cushion(-1e-6));
    CHECK(is_why(&p, "outline"), "edges bent in: %s", p.where);
    p = prove_flat(kinked(-0.5));
    CHECK(p.holds == TAUT_TRUE && p.residual < 1e-18, "a kink outwards: %g %s", p.residual,
          p.where);
    p = prove_flat(kinked(0));
    CHECK(p.holds == TAUT_TRUE, "no kink: %s", p.where);
    p = prove_flat(kinked(1e-6));
    CHECK(is_why(&p, "outline"), "a kink inwards: %s", p.where);
    taut_surface *enneper = shape_enneper(-0.5, 0.5, -0.5, 0.5);
    taut_plateau_witness *witness = NULL;
    CHECK(taut_plateau_witness_new(enneper, NULL, &witness) == TAUT_OK && witness == NULL,
          "along no direction is the boundary convex");
    p = prove_flat(enneper);
    CHECK(is_why(&p, "outline"), "Enneper's own edges bend in: %s", p.where);
}

/* A gap that is asked for and not proved is false. */
static void test_asked(void)
{
    taut_surface *surface = adjoint_enneper(0.5, NULL);
    taut_plateau_witness *witness = witness_of(surface);
    taut_record *details = taut_record_new();
    proof p;

    witness->coefficients[8] += 1e-4;
    taut_plateau_witness_describe(witness, details);
    const double area = enneper_area(0.5);
    const double residual = prove_details(surface, details, area, 0.5).residual;
    CHECK(residual > 1e-12 && residual < 1e-6, "%g", residual);
    p = prove_details(surface, details, area, 2 * residual);
    CHECK(p.holds == TAUT_TRUE, "%g", p.residual);
    p = prove_details(surface, details, area, 0.5 * residual);
    CHECK(p.holds == TAUT_FALSE, "%g", p.residual);
    p = prove_details(surface, NULL, area, 0.5);
    CHECK(p.holds == TAUT_FALSE && strncmp(p.where, "convex", 6) == 0, "%s", p.where);
    p = prove_details(surface, NULL, area, 0);
    CHECK(is_why(&p, "convex"), "%s", p.where);
    taut_record_free(details);
    taut_plateau_witness_free(witness);
    taut_surface_free(surface);
}

/* What stands in the way whatever the witness shows. */
static void test_obstacles(void)
{
    taut_surface *surface = adjoint_enneper(0.5, NULL);
    taut_plateau_witness *witness = witness_of(surface);
    const taut_basis_spec wide = {.type = "h-bezier", .beta = 4.5};
    const double points[16][3] = {{0, 0, 0}, {0, 1, 0}, {0, 2, 0}, {0, 3, 0}, {1, 0, 0}, {1, 1, 0},
                                  {1, 2, 0}, {1, 3, 0}, {2, 0, 0}, {2, 1, 0}, {2, 2, 0}, {2, 3, 0},
                                  {3, 0, 0}, {3, 1, 0}, {3, 2, 0}, {3, 3, 0}};
    taut_surface *other =
        shape_surface(shape_basis(&wide), shape_bezier(3, 0, 1), &points[0][0], NULL);
    double *many = calloc(3 * 101 * 101, sizeof(double));
    taut_surface *large = shape_surface(shape_bspline(2, 101), shape_bspline(2, 101), many, NULL);
    static const char *const words[] = {"declined", "inside", "basis", "size"};
    taut_record *details = taut_record_new();

    taut_plateau_witness_describe(witness, details);
    for (int k = 0; k < 4; k++) {
        const taut_least_request request = {
            .surface = k == 2   ? other
                       : k == 3 ? large
                                : surface,
            .witness = taut_record_get(details, "least"),
            .boundary_only = k != 1,
            .is_declined = k == 0,
            .area = 1,
        };
        taut_certificate *certificate = NULL;
        taut_record *figures = taut_record_new();
        CHECK(taut_certificate_new("plateau", &certificate) == TAUT_OK &&
                  taut_certify_add_least(&request, figures, certificate) == TAUT_OK,
              "claim");
        const taut_claim *claim = taut_certificate_claim(certificate, 0);
        CHECK(claim->holds == TAUT_UNDECIDED && isnan(claim->residual) &&
                  strncmp(claim->where, words[k], strlen(words[k])) == 0 &&
                  taut_record_count(figures) == 0,
              "%s: %s", words[k], claim->where);
        CHECK(taut_certificate_holds(certificate) == TAUT_TRUE, "it is offered, not owed");
        taut_record_free(figures);
        taut_certificate_free(certificate);
    }
    taut_plateau_witness *none = witness; /* none is looked for */
    CHECK(taut_plateau_witness_new(large, NULL, &none) == TAUT_OK && none == NULL, "size");
    taut_record_free(details);
    taut_plateau_witness_free(witness);
    taut_surface_free(surface);
    taut_surface_free(other);
    taut_surface_free(large);
    free(many);
}

/* A film over the unit square on c- or h- bases, or mixed, with straight edges seen along z. The
 * gap that the construction's Gauss rule finds shares no code with the proof. */
static void test_quasi(void)
{
    static const char *const types[] = {"c-bezier", "h-bezier", "c-bspline", "h-bspline"};
    int proved = 0;

    for (int trial = 0; trial < 12; trial++) {
        const char *type = types[trial % 4];
        const int is_spline = strlen(type) == 9, is_mixed = trial % 3 == 1;
        const taut_basis_spec spec = spec_of_spans(type, random_in(0.3, type[0] == 'c' ? 3 : 3.5),
                                                   is_spline ? random_int(1, 2) : 1, 0);
        taut_basis *u = shape_basis(&spec);
        taut_basis *v = is_mixed ? shape_bspline(2, 4) : shape_basis(&spec);
        const int nu = taut_basis_count(u), nv = taut_basis_count(v);
        double points[64][3];
        for (int k = 0; k < nu * nv; k++) {
            points[k][0] = k / nv / (nu - 1.0);
            points[k][1] = k % nv / (nv - 1.0);
            points[k][2] = 0.1 * points[k][0] * points[k][1] + random_in(-0.002, 0.002);
        }
        taut_surface *surface = shape_surface(u, v, points[0], NULL);
        taut_plateau_witness *witness = witness_of(surface);
        if (witness != NULL) {
            const proof p = prove(surface, witness, 0);
            if (!isfinite(p.residual)) { /* rounding may turn edges back too far, and says so */
                CHECK(strncmp(p.where, "outline", 7) == 0, "%s: %s", type, p.where);
            }
            CHECK(!isfinite(p.residual) || p.residual >= witness->gap * (1 - 1e-6) - 1e-12,
                  "%s: gap %g, proved only %g", type, witness->gap, p.residual);
            CHECK(!isfinite(p.residual) || p.residual <= 1.5 * witness->gap + 1e-10,
                  "%s: gap %g, proved %g", type, witness->gap, p.residual);
            proved += isfinite(p.residual);
        }
        taut_plateau_witness_free(witness);
        taut_surface_free(surface);
    }
    CHECK(proved >= 8, "%d of 12 proved", proved);
}

/* The helicoid (v cos u, v sin u, u) over part of a turn, a graph along y: in
 * {1, u, cos u, sin u} x {1, v} it is exact, and as it is minimal over a convex domain it is least,
 * of area iint sqrt(v^2 + 1). */
static void test_helicoid(void)
{
    const double alpha = 0.6, from = -0.2, to = 0.2, h = alpha / 2;
    const taut_basis_spec arc = {.type = "c-bezier", .alpha = alpha};
    taut_basis *u = shape_basis(&arc), *v = shape_bezier(1, from, to);
    /* u - h, sin (u - h), cos (u - h) by their derivatives at both ends: f(0), f'(0), f'(a), f(a) */
    double jets[2][8], x[3][4];

    CHECK(taut_basis_eval(u, 0, 0, 1, jets[0]) == TAUT_OK, "ends");
    CHECK(taut_basis_eval(u, 0, alpha, 1, jets[1]) == TAUT_OK, "ends");
    for (int k = 0; k < 3; k++) {
        const double lo = k == 0 ? -h : k == 1 ? -sin(h) : cos(h);
        const double hi = k == 0 ? h : k == 1 ? sin(h) : cos(h);
        const double rise = k == 0 ? 1 : k == 1 ? cos(h) : sin(h);
        const double fall = k == 0 ? 1 : k == 1 ? cos(h) : -sin(h);
        x[k][0] = lo;
        x[k][3] = hi;
        x[k][1] = (rise - jets[0][4] * lo) / jets[0][5];
        x[k][2] = (fall - jets[1][7] * hi) / jets[1][6];
    }
    double points[4][2][3];
    for (int k = 0; k < 8; k++) {
        const double r = k % 2 == 0 ? from : to;
        points[k / 2][k % 2][0] = r * x[2][k / 2];
        points[k / 2][k % 2][1] = r * x[1][k / 2];
        points[k / 2][k % 2][2] = x[0][k / 2];
    }
    taut_surface *surface = shape_surface(u, v, points[0][0], NULL);
    const double high = to * sqrt(to * to + 1) + asinh(to);
    const double low = from * sqrt(from * from + 1) + asinh(from);
    const double exact = alpha * 0.5 * (high - low);
    taut_plateau_witness *witness = witness_of(surface);
    if (witness != NULL) {
        const proof p = prove(surface, witness, exact);
        CHECK(p.lower <= exact * (1 + 1e-15) && p.lower >= exact * (1 - 1e-4), "%.17g of %.17g",
              p.lower, exact);
    }
    taut_plateau_witness_free(witness);
    taut_surface_free(surface);
}

/* The area that is told counts only within its bounds. */
static void test_told_area(void)
{
    const double area = enneper_area(0.5);
    taut_surface *surface = adjoint_enneper(0.5, NULL);
    taut_plateau_witness *witness = witness_of(surface);
    static const double told[] = {0, -1, 1e-9, 1.2, 1e9, 1e300};

    for (int k = 0; k < 6; k++) {
        const proof p = prove(surface, witness, told[k] * area);
        CHECK(p.lower <= area && p.lower > 0.99 * area, "told %g: %.17g", told[k], p.lower);
    }
    taut_plateau_witness_free(witness);
    taut_surface_free(surface);
}

/* A proof that is stopped says so, and leaves a bound that may be read. */
static void test_stopped(void)
{
    taut_surface *surface = adjoint_enneper(0.5, NULL);
    const double psi[4 * 4] = {0};
    taut_pulse pulse = {.is_stopped = 1};
    const taut_crew crew = {.threads = 1, .pulse = &pulse};
    taut_flux_task task = {
        .surface = surface,
        .u = taut_surface_u(surface),
        .v = taut_surface_v(surface),
        .coefficients = psi,
        .frame = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
        .wanted = 1,
        .crew = &crew,
    };
    taut_flux_bound bound;

    memset(&bound, 0x55, sizeof bound);
    CHECK(taut_certify_flux(&task, &bound) == TAUT_INTERRUPTED, "it went on");
    CHECK(bound.verdict == TAUT_FLUX_ADMITTED && taut_least_reason(bound.verdict) == NULL,
          "verdict %d", (int)bound.verdict);
    taut_surface_free(surface);
}

int main(void)
{
    random_seed(20260119);
    test_tetrahedron();
    test_enneper();
    test_same_film();
    test_rational();
    test_perturbed();
    test_projection();
    test_forged();
    test_outlines();
    test_asked();
    test_obstacles();
    test_told_area();
    test_quasi();
    test_helicoid();
    test_stopped();
    return check_failures != 0;
}
