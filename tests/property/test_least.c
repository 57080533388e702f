/* test_least.c -- no lower bound of a film is above the area of another surface with its boundary,
 * whatever is done to its witness. */
#include "check.h"
#include "problems.h"

#include "certify/plateau/least.h"
#include "construct/plateau/witness.h"
#include "taut/measure.h"
#include "taut/plateau.h"

#include <math.h>

/* A net over a rectangle whose edges may bulge, with heights at random, only its boundary known. */
static test_problem random_net(void)
{
    const int n = random_int(3, 6), m = random_int(3, 6);
    test_problem net = problem_new(basis_uniform(2, n), basis_uniform(random_int(2, 3), m + 1));
    const int nv = m + 1;
    const double bulge = random_int(0, 1) * random_in(0, 0.2), height = random_log(1e-3, 1);

    for (int i = 0; i < n; i++) {
        for (int j = 0; j < nv; j++) {
            const double x = (double)i / (n - 1), y = (double)j / (nv - 1);
            if (i == 0 || j == 0 || i == n - 1 || j == nv - 1) {
                problem_know(&net, i, j, x + bulge * (2 * x - 1) * 4 * y * (1 - y),
                             y + bulge * (2 * y - 1) * 4 * x * (1 - x),
                             height * random_in(-0.3, 0.3));
            }
        }
    }
    return net;
}

/* lower_bound, or NaN. */
static double lower_bound(const taut_surface *film, const taut_plateau_witness *witness,
                          double area)
{
    taut_record *details = taut_record_new(), *figures = taut_record_new();
    taut_certificate *certificate = NULL;
    double found = 0;

    taut_plateau_witness_describe(witness, details);
    const taut_least_request request = {
        .surface = film,
        .witness = taut_record_get(details, "least"),
        .boundary_only = 1,
        .area = area,
    };
    CHECK(taut_certificate_new("plateau", &certificate) == TAUT_OK &&
              taut_certify_add_least(&request, figures, certificate) == TAUT_OK,
          "claim");
    found = taut_record_number(taut_record_get(figures, "lower_bound"));
    taut_certificate_free(certificate);
    taut_record_free(details);
    taut_record_free(figures);
    return found;
}

/* The area of a film as measured; NaN where none was made. */
static double film_of(const taut_plateau_problem *problem, taut_model **model)
{
    double area = NAN, error = 0;
    *model = NULL;
    if (taut_plateau_make(problem, NULL, model, NULL) == TAUT_OK) {
        CHECK(taut_surface_area(taut_model_surface(*model, 0), &area, &error) == TAUT_OK, "area");
    }
    return area;
}

/* The witness, then the same forged many times, against the area of a finer film. */
static int check_net(const test_problem *net)
{
    taut_plateau_problem problem = {.net = net->data, .method = TAUT_PLATEAU_NORMAL};
    taut_plateau_witness *witness = NULL;
    taut_model *coarse = NULL, *fine = NULL;
    const double area = film_of(&problem, &coarse);
    double least = area, bound = NAN;

    problem.gap = 1e-5;
    least = fmin(area, film_of(&problem, &fine));
    if (coarse != NULL) {
        CHECK(taut_plateau_witness_new(taut_model_surface(coarse, 0), NULL, &witness) == TAUT_OK,
              "none");
    }
    for (int trial = 0; witness != NULL && trial < 12; trial++) {
        const size_t count =
            (size_t)taut_basis_count(witness->u) * (size_t)taut_basis_count(witness->v);
        const double size = trial == 0 ? 0 : random_log(1e-9, 1e-1);
        for (size_t k = 0; k < count; k++) {
            witness->coefficients[k] += size * random_in(-1, 1);
        }
        witness->direction[0] += size * random_in(-1, 1);
        bound = lower_bound(taut_model_surface(coarse, 0), witness, area);
        CHECK(!(bound > least * (1 + 1e-13)), "trial %d: %.17g above %.17g", trial, bound, least);
        CHECK(trial > 0 || bound > 0.5 * least, "%g of %g: no bound", bound, least);
    }
    const int tried = witness != NULL;
    taut_plateau_witness_free(witness);
    taut_model_free(coarse);
    taut_model_free(fine);
    return tried;
}

int main(void)
{
    int tried = 0;

    random_seed(20260120);
    for (int trial = 0; trial < random_trials(40); trial++) {
        test_problem net = random_net();
        tried += check_net(&net);
        problem_free(&net);
    }
    CHECK(tried > 0, "no net had a witness");
    printf("%d films\n", tried);
    return check_failures != 0;
}
