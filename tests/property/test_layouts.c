/* test_layouts.c [COUNT | say COUNT | show K | try K] -- random films of up to 60 patches: each ends in a film whose claims hold, or in a
 * refusal for one of the reasons that films have, most of them in a film. A flat one without cables is never refused, and has the
 * area of its polygon; one between four lines has the energy that one patch finds between them, or a little more; no bound is above
 * these; no tube is found between circles that the theorem of the cone forbids.
 *
 *     COUNT    so many in place of 40: tools/nightly.sh makes a thousand
 *     say      each refusal
 *     show     document K
 *     try      no other than film K
 */
#include "certificates.h"
#include "check.h"
#include "documents.h"
#include "layouts.h"

#include "taut/taut.h"

#include <stdlib.h>
#include <string.h>

static const double parted = 1.32548683869836; /* of the radius: no catenoid beyond */
static int says;

typedef struct tally {
    int films, folded, weak, parted, unstable, other;
} tally;

/* The energy of the same four lines, by one patch; NaN where it makes none. */
static double frame_energy(const layout *l)
{
    char text[2000];
    taut_model *model = NULL;
    taut_certificate *proof = NULL;
    double energy = NAN;

    layout_frame(l, 4, 14, text, sizeof text);
    taut_problem *problem = problem_read(text);
    if (taut_make(problem, NULL, &model, NULL) == TAUT_OK &&
        taut_certify(model, problem, NULL, &proof, NULL) == TAUT_OK) {
        energy = figure_of(proof, "energy");
    }
    taut_certificate_free(proof);
    taut_model_free(model);
    taut_problem_free(problem);
    return energy;
}

static void check_film(const layout *l, const taut_certificate *proof, int trial)
{
    const double energy = figure_of(proof, "energy"), lower = figure_of(proof, "lower_bound");

    for (int k = 0; k < taut_certificate_claim_count(proof); k++) {
        const taut_claim *claim = taut_certificate_claim(proof, k);
        CHECK(claim->holds == TAUT_TRUE || strcmp(claim->claim, "least") == 0,
              "trial %d, kind %d: %s: %g, limit %g at %s", trial, (int)l->kind, claim->claim,
              claim->residual, claim->limit, claim->where);
    }
    CHECK(energy > 0, "trial %d: %g", trial, energy);
    if (l->area > 0) {
        CHECK_NEAR(energy, l->tension * l->area, 1e-9 * energy, "trial %d", trial);
        CHECK(!(lower > l->tension * l->area * (1 + 1e-12)), "trial %d: %.17g is no bound", trial,
              lower);
    } else if (l->is_frame) {
        const double one = frame_energy(l);
        CHECK(!(energy < one * (1 - 1e-6)) && !(energy > one * 1.01),
              "trial %d: %.12g, by one patch %.12g", trial, energy, one);
        CHECK(!(lower > one * (1 + 1e-12)), "trial %d: %.17g is no bound", trial, lower);
    }
    if (l->kind == LAYOUT_TUBE) {
        CHECK(!(l->arcs && l->cables == 0 && l->height > parted * (1 + 1e-3)),
              "trial %d: a film between circles %.6g apart", trial, l->height);
    }
}

static void check_refusal(const layout *l, const taut_error *error, int trial, tally *t)
{
    const char *const reasons[] = {"folds",     "not-converged", "cable-too-weak",
                                   "collapses", "unstable",      "ill-conditioned"};
    int *const counts[] = {&t->folded, &t->other, &t->weak, &t->parted, &t->unstable, &t->other};
    int known = 0;

    for (size_t k = 0; k < sizeof reasons / sizeof *reasons; k++) {
        if (strcmp(error->reason, reasons[k]) == 0) {
            known = 1;
            ++*counts[k];
        }
    }
    CHECK(known, "trial %d: %s at %s: %s", trial, error->reason, error->where, error->message);
    CHECK(!(l->kind == LAYOUT_TUBE && l->arcs && l->height < 0.97 * parted),
          "trial %d, circles %.6g apart: %s: %s", trial, l->height, error->reason, error->message);
    CHECK(!(l->area > 0), "trial %d, a flat one: %s: %s", trial, error->reason, error->message);
    if (says) {
        printf("trial %d: kind %d, %d patches of degree %d, %d cables, height %g: %s: %s\n", trial,
               (int)l->kind, l->patches, l->degree, l->cables, l->height, error->reason,
               error->message);
    }
}

static void try_layout(int trial, layout *l, tally *t)
{
    taut_model *model = NULL;
    taut_certificate *proof = NULL;
    taut_error error = {.status = TAUT_OK};
    taut_problem *problem = problem_read(l->text);

    if (problem == NULL) {
        return;
    }
    if (taut_make(problem, NULL, &model, &error) == TAUT_OK) {
        t->films++;
        CHECK(taut_certify(model, problem, NULL, &proof, &error) == TAUT_OK, "trial %d: %s", trial,
              error.message);
        check_film(l, proof, trial);
    } else {
        check_refusal(l, &error, trial, t);
    }
    taut_certificate_free(proof);
    taut_model_free(model);
    taut_problem_free(problem);
}

int main(int argc, char **argv)
{
    const int show = argc == 3 && strcmp(argv[1], "show") == 0 ? atoi(argv[2]) : -1;
    const int only = argc == 3 && strcmp(argv[1], "try") == 0 ? atoi(argv[2]) : -1;
    const int trials = show >= 0   ? show + 1
                       : only >= 0 ? only + 1
                       : argc > 1  ? atoi(argv[argc - 1])
                                   : random_trials(40);
    layout *l = malloc(sizeof *l);
    tally t = {0};

    /* beside corners of these the normal turns by a right angle within a span of degree 2, and they do not fold */
    static const int turning[] = {76, 241, 878, 952};

    says = argc == 3 && show < 0;
    for (size_t k = 0; l != NULL && argc == 1 && k < sizeof turning / sizeof *turning; k++) {
        random_seed((uint64_t)turning[k] + 1);
        layout_random(l);
        try_layout(turning[k], l, &t);
    }
    CHECK(argc > 1 || t.films == 4, "of what turns fast %d films", t.films);
    t = (tally){0};
    for (int k = only > 0 ? only : 0; l != NULL && k < trials; k++) {
        random_seed((uint64_t)k + 1);
        layout_random(l);
        if (show < 0) {
            try_layout(k, l, &t);
        }
    }
    if (show >= 0) {
        fputs(l != NULL ? l->text : "", stdout);
        free(l);
        return 0;
    }
    free(l);
    printf("%d films, %d folded, %d too weak, %d parted, %d unstable, %d not converged\n", t.films,
           t.folded, t.weak, t.parted, t.unstable, t.other);
    CHECK(trials < 40 || only >= 0 || 10 * t.films >= 7 * trials, "%d films of %d", t.films,
          trials);
    return check_failures != 0;
}
