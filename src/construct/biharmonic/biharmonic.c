/* biharmonic.c -- construct `biharmonic`: from four rows (rows.c), or a neighbour (neighbour.c). */
#include "construct/biharmonic/biharmonic.h"

#include "construct/common/build.h"
#include "construct/construct_ops.h"
#include "core/fail.h"

#include <string.h>

/* From here on data known to rounding gives less than nine digits. */
static const double amplification_warning = 5e6;

static taut_status check_rows(const taut_biharmonic_rows *rows, taut_error *error)
{
    if (strcmp(taut_basis_type(rows->u), "bezier") != 0 ||
        strcmp(taut_basis_type(rows->v), "bezier") != 0) {
        return taut_fail(error, TAUT_BAD_INPUT, "not-bezier",
                         strcmp(taut_basis_type(rows->u), "bezier") != 0 ? "/u" : "/v", taut_none,
                         taut_none, "expected a basis of type \"bezier\"");
    }
    return TAUT_OK;
}

static int has_data(const taut_biharmonic_problem *problem)
{
    const taut_biharmonic_rows *rows = &problem->rows;
    return problem->given == TAUT_BIHARMONIC_NEIGHBOUR
               ? problem->neighbour.surface != NULL
               : rows->u != NULL && rows->v != NULL && rows->points != NULL && rows->known != NULL;
}

static taut_status check_problem(const taut_biharmonic_problem *problem, taut_error *error)
{
    if (problem == NULL || !has_data(problem)) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, "argument", NULL, taut_none, taut_none,
                         "a biharmonic problem needs two bases and points, or a surface");
    }
    if (problem->given == TAUT_BIHARMONIC_ROWS) {
        return check_rows(&problem->rows, error);
    }
    if (problem->neighbour.contact != 1 && problem->neighbour.contact != 2) {
        return taut_fail_expected(error, TAUT_BAD_INPUT, "value", "/contact",
                                  problem->neighbour.contact, "1 or 2", "contact of order %d",
                                  problem->neighbour.contact);
    }
    return TAUT_OK;
}

/* The amplification, and a warning where it is large. */
static void add_amplification(double amplification, taut_record *details)
{
    taut_record_add_number(details, "amplification", amplification);
    if (!(amplification < amplification_warning)) {
        taut_record_add_text(
            taut_record_add_list(details, "warnings"), NULL,
            "rounding in the data grows by the amplification: expect few true digits");
    }
}

typedef struct request {
    const taut_biharmonic_problem *problem;
    taut_pulse *pulse;
} request;

static taut_status fill_model(void *context, taut_arena *arena, taut_model *model,
                              taut_error *error)
{
    const request *asked = context;
    const taut_biharmonic_problem *problem = asked->problem;
    taut_record *details = taut_record_new();
    double amplification = 0;
    const taut_status status =
        problem->given == TAUT_BIHARMONIC_NEIGHBOUR
            ? taut_biharmonic_add_neighbour(&problem->neighbour, arena, asked->pulse, model,
                                            details, &amplification, error)
            : taut_biharmonic_add_rows(&problem->rows, arena, asked->pulse, model, &amplification,
                                       error);

    if (status != TAUT_OK) {
        taut_record_free(details);
        return status;
    }
    add_amplification(amplification, details);
    return taut_construct_set_details(model, details, error);
}

taut_status taut_biharmonic_make(const taut_biharmonic_problem *problem,
                                 const taut_make_options *options, taut_model **model,
                                 taut_error *error)
{
    taut_pulse pulse = {.monitor = options != NULL ? &options->monitor : NULL,
                        .what = "solving",
                        .done = taut_none};
    request asked = {problem, &pulse};
    const taut_status status = check_problem(problem, error);

    return status == TAUT_OK ? taut_construct_build(fill_model, &asked, model, error) : status;
}

static taut_status make(const void *data, const taut_make_options *options, taut_model **model,
                        taut_error *error)
{
    return taut_biharmonic_make(data, options, model, error);
}

const taut_construct_ops taut_construct_biharmonic = {.make = make};
