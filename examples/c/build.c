/* build.c -- from a problem's document to files: what `taut make` does, in a program of yours.
 *
 *     cc build.c $(pkg-config --cflags --libs taut-draw) -o build
 *     taut example harmonic-rows > rows.json
 *     ./build rows.json rows.obj rows.svg
 */
#include <stdio.h>
#include <taut/taut.h>

/* Called now and then by long work; an answer other than 0 would stop it. */
static int progress(void *context, double done, const char *what)
{
    (void)context;
    fprintf(stderr, "%s %.0f %%\n", what, 100 * done);
    return 0;
}

/* The model with its certificate. */
static taut_status build(const char *path, taut_model **model, taut_error *error)
{
    const taut_make_options options = {.monitor = {.progress = progress}};
    taut_problem *problem = NULL;
    taut_certificate *certificate = NULL;
    taut_status status = taut_problem_read(path, &problem, error);
    if (status == TAUT_OK) {
        status = taut_make(problem, &options, model, error);
    }
    if (status == TAUT_OK) {
        status = taut_certify(*model, problem, NULL, &certificate, error);
    }
    if (status == TAUT_OK) {
        printf("%s: what it claims %s\n", taut_problem_construction(problem),
               taut_certificate_holds(certificate) == TAUT_TRUE ? "holds" : "does not hold");
        taut_model_set_certificate(*model, certificate); /* which is the model's from now on */
    }
    taut_problem_free(problem);
    return status;
}

int main(int argc, char **argv)
{
    const taut_write_options options = {.formats = taut_draw_formats()}; /* figures too */
    taut_model *model = NULL;
    taut_outputs *outputs = NULL;
    taut_error error = {.status = TAUT_OK};
    taut_status status = TAUT_OK;

    if (argc < 3) {
        fprintf(stderr, "usage: %s PROBLEM.json OUTPUT...\n", argv[0]);
        return 2;
    }
    status = build(argv[1], &model, &error);
    if (status == TAUT_OK) {
        status = taut_outputs_new(&outputs);
    }
    for (int i = 2; i < argc && status == TAUT_OK; i++) {
        status = taut_outputs_model(outputs, model, argv[i], &options, &error);
    }
    if (status == TAUT_OK) {
        status = taut_outputs_commit(outputs, &error); /* all of them appear, or none */
    }
    if (status != TAUT_OK) {
        fprintf(stderr, "%s %s\n", error.where, error.message);
    }
    taut_outputs_free(outputs);
    taut_model_free(model);
    return taut_status_exit_code(status);
}
