/* threads.c -- how many threads, where nobody said: all processors for what is large, one for what is done before they are
 * started. The bytes are the same for any number. */
#include "cli/cli.h"
#include "platform/system.h"

enum {
    LARGE_POINTS = 10000, /* 100 x 100 */
    LARGE_TEXT = 60000,   /* a document of as many, nearly all of them null */
    MOST = 16
};

static int threads_for(const cli_options *options, int is_large)
{
    if (options->threads > 0 || !is_large) {
        return options->threads;
    }
    const int processors = taut_system_processors();
    return processors < MOST ? processors : MOST;
}

int cli_threads_to_make(const cli_options *options, const taut_problem *problem)
{
    size_t length = 0;
    (void)taut_problem_text(problem, &length);
    return threads_for(options, length >= LARGE_TEXT);
}

int cli_threads_of(const cli_options *options, const taut_model *model)
{
    double points = 0;
    for (int i = 0; i < taut_model_surface_count(model); i++) {
        const taut_surface *surface = taut_model_surface(model, i);
        points += (double)taut_basis_count(taut_surface_u(surface)) *
                  (double)taut_basis_count(taut_surface_v(surface));
    }
    return threads_for(options, points >= LARGE_POINTS);
}
