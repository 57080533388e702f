/* test_examples.c -- every construction, by its smallest example: its document read, its model
 * made, proved and written when memory runs out. A construction that is new is in here by its
 * examples. */
#include "calls.h"
#include "check.h"
#include "cli/embedded_files.h"
#include "fault.h"

#include "taut/construct.h"
#include "taut/read.h"
#include "taut/write.h"

#include <stdlib.h>
#include <string.h>

enum { MOST = 400 }; /* allocations failed of one call, spread over all of them */

/* Calls of 10 ms and more, and how many of their allocations are failed. */
static const struct slow_call {
    const char *name;
    int most;
} slow_calls
    [] =
        {
            {"asymptotic, taut_certify", 20},
            {"film, taut_make", 20}, /* all of both without their bound: test_film.c */
            {"film, taut_certify", 40},
            {"pipe, taut_make", 20},
            {"pipe, taut_certify", 80},
            {"pattern, taut_make", 20},
            {"pattern, taut_certify", 20},
};

typedef struct subject {
    const taut_embedded *file;
    const taut_problem *problem;
    const taut_model *model;
} subject;

static taut_status read_example(const void *context, void **result, taut_error *error)
{
    const subject *s = context;
    taut_problem *problem = *result;
    const taut_status status =
        taut_problem_read_text(s->file->text, s->file->length, s->file->name, &problem, error);
    *result = problem;
    return status;
}

static taut_status make(const void *context, void **result, taut_error *error)
{
    const subject *s = context;
    taut_model *model = *result;
    const taut_status status = taut_make(s->problem, NULL, &model, error);
    *result = model;
    return status;
}

static taut_status certify(const void *context, void **result, taut_error *error)
{
    const subject *s = context;
    taut_certificate *certificate = *result;
    const taut_status status = taut_certify(s->model, s->problem, NULL, &certificate, error);
    *result = certificate;
    return status;
}

static taut_status certify_again(const void *context, void **result, taut_error *error)
{
    const subject *s = context;
    taut_certificate *certificate = *result;
    const taut_status status = taut_certify_again(s->model, NULL, &certificate, error);
    *result = certificate;
    return status;
}

static int most_of(const char *name)
{
    for (size_t i = 0; i < sizeof slow_calls / sizeof slow_calls[0]; i++) {
        if (strcmp(name, slow_calls[i].name) == 0) {
            return slow_calls[i].most;
        }
    }
    return MOST;
}

/* Fails the allocations of one call. */
static void run(const char *name, const char *what,
                taut_status (*call)(const void *, void **, taut_error *), void (*release)(void *),
                const subject *s)
{
    char words[96];
    void *made = NULL;
    taut_error error = {.status = TAUT_OK, .message = ""};
    const taut_status status = call(s, &made, &error);
    snprintf(words, sizeof words, "%.40s, %.40s", name, what);
    CHECK(status == TAUT_OK, "%s: %s %s", words, error.where, error.message);
    if (status == TAUT_OK) {
        release(made);
        const fault_call described = {words, call, release, s};
        const long count = fault_loop_some(&described, most_of(words));
        CHECK(count > 3, "%s: only %ld allocations", words, count);
        printf("%-44s %6ld allocations\n", words, count);
    }
}

/* The example of a construction with the shortest text; NULL if there is none. */
static const taut_embedded *smallest(const char *construct)
{
    const taut_embedded *best = NULL;
    for (const taut_embedded *file = taut_examples; file->name != NULL; file++) {
        taut_problem *problem = NULL;
        if ((best == NULL || file->length < best->length) &&
            taut_problem_read_text(file->text, file->length, file->name, &problem, NULL) ==
                TAUT_OK) {
            best = strcmp(taut_problem_construction(problem), construct) == 0 ? file : best;
        }
        taut_problem_free(problem);
    }
    return best;
}

static void test_construct(const char *construct)
{
    subject s = {smallest(construct), NULL, NULL};
    taut_problem *problem = NULL;
    taut_model *model = NULL;
    CHECK(s.file != NULL, "%s has no example", construct);
    if (s.file == NULL) {
        return;
    }
    run(construct, "taut_problem_read_text", read_example, release_problem, &s);
    CHECK(taut_problem_read_text(s.file->text, s.file->length, "", &problem, NULL) == TAUT_OK, "%s",
          construct);
    s.problem = problem;
    run(construct, "taut_make", make, release_model, &s);
    CHECK(taut_make(problem, NULL, &model, NULL) == TAUT_OK, "%s", construct);
    s.model = model;
    run(construct, "taut_certify", certify, release_certificate, &s);
    if (strcmp(construct, "harmonic") == 0) { /* quick, and needs no problem */
        taut_certificate *certificate = NULL;
        CHECK(taut_certify(model, problem, NULL, &certificate, NULL) == TAUT_OK, "%s", construct);
        taut_model_set_certificate(model, certificate);
        run(construct, "taut_certify_again", certify_again, release_certificate, &s);
    }
    taut_model_free(model);
    taut_problem_free(problem);
}

int main(void)
{
    random_seed(20260116);
    CHECK(taut_construct_count() > 0, "constructions");
    for (int i = 0; i < taut_construct_count(); i++) {
        test_construct(taut_construct_name(i));
    }
    CHECK(fault_live() == 0, "%ld blocks left", fault_live());
    return check_failures != 0;
}
