/* test_tolerance.c -- lengths of flat pieces to a tolerance: digits of another program that the first splines do not have. */
#include "check.h"
#include "cli/embedded_files.h"
#include "cloths.h"

#include <string.h>

/* The pattern of an example, or of the saddle in one piece, made to a tolerance. */
static made_cloth made_to(const char *name, double tolerance)
{
    static const char saddle[] = "{ \"taut\": 1, \"pattern\": \"cloth\", \"of\": " SADDLE
                                 ", \"seams\": [{ \"across\": [\"v0\", \"v1\"], \"count\": 1 }] }";
    const taut_embedded *file = taut_examples;
    const taut_make_options options = {.tolerance = tolerance};
    made_cloth made = {.status = TAUT_OK};
    while (name != NULL && file->name != NULL && strcmp(file->name, name) != 0) {
        file++;
    }
    made.status = taut_problem_read_text(name != NULL ? file->text : saddle,
                                         name != NULL ? file->length : sizeof saddle - 1, "cloth",
                                         &made.problem, &made.error);
    CHECK(made.status == TAUT_OK, "%s", made.error.message);
    made.status = taut_make(made.problem, &options, &made.model, &made.error);
    return made;
}

/* Corners are singular: the first splines have 2.1273015, and equal ones of half the size twice 2.1273060. */
static void test_gore(void)
{
    made_cloth made = made_to("pattern-sphere.json", 3e-7);
    CHECK(made.status == TAUT_OK, "%s", made.error.message);
    if (made.status != TAUT_OK) {
        cloth_free(&made);
        return;
    }
    CHECK_NEAR(cloth_number(&made, "pieces", "P2", "edges/right/flat_length"), 2.127306067, 3e-8,
               "seam");
    CHECK_NEAR(cloth_number(&made, "pieces", "P2", "width_middle"), 0.5233316127, 1e-9, "width");
    CHECK_NEAR(cloth_number(&made, "pieces", "P2", "energy"), 2.80274336e-5, 1e-13, "energy");
    cloth_free(&made);
}

static void test_refused(void)
{
    made_cloth made = made_to(NULL, 1e-13);
    CHECK(made.status == TAUT_NOT_CONVERGED && strcmp(made.error.reason, "not-converged") == 0 &&
              strstr(made.error.message, "take a larger tolerance") != NULL,
          "%s", made.error.message);
    cloth_free(&made);
}

int main(void)
{
    test_gore();
    test_refused();
    return check_failures != 0;
}
