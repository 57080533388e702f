/* test_figure.c -- drawing when memory runs out. */
#include "check.h"
#include "fault.h"
#include "shapes.h"

#include "core/memory.h"
#include "draw/figure.h"
#include "page/html_page.h"
#include "platform/system.h"

#include <stdlib.h>

static taut_status draw(const void *context, void **result, taut_error *error)
{
    static const taut_write_options options = {
        .divide = 2, .colour = TAUT_COLOUR_GAUSSIAN, .title = "title"};
    char *text = NULL;
    size_t length = 0;
    FILE *out = taut_system_spool(&text, &length); /* not from our allocator */
    const taut_status status = taut_draw_figure(context, &options, "svg", out, error);
    (void)result;
    CHECK(taut_system_spooled(out, &text, &length) == 0, "kept");
    CHECK(status != TAUT_OK || length > 1000, "a figure of %zu bytes", length);
    free(text);
    return status;
}

static taut_status draw_marks(const void *context, void **result, taut_error *error)
{
    static const taut_write_options options = {.divide = 2,
                                               .colour = TAUT_COLOUR_ISOTHERMALITY,
                                               .isolines = 3,
                                               .reflections = 5,
                                               .combs = 1,
                                               .reactions = 1};
    const taut_model *models[2] = {context, context};
    char *text = NULL;
    size_t length = 0;
    FILE *out = taut_system_spool(&text, &length);
    const taut_status status = taut_draw_figures(2, models, &options, "svg", out, error);
    (void)result;
    CHECK(taut_system_spooled(out, &text, &length) == 0, "kept");
    CHECK(status != TAUT_OK || length > 1000, "a figure of %zu bytes", length);
    free(text);
    return status;
}

static taut_status page(const void *context, void **result, taut_error *error)
{
    static const taut_write_options options = {.title = "title", .divide = 3};
    char *text = *result;
    size_t length = 0;
    const taut_status status = taut_html_data(context, &options, &text, &length, error);
    CHECK(status != TAUT_OK || length > 1000, "data of %zu bytes", length);
    *result = text;
    return status;
}

int main(void)
{
    static const double points[4][3] = {{0, 0, 0}, {1, 1, 0}, {2, 0, 1}, {3, 1, 1}};
    taut_model *model = NULL;
    taut_surface *surface = NULL;
    taut_curve *curve = NULL;

    random_seed(20260114);
    surface = shape_random(2, 3, 1);
    curve = shape_curve(shape_bezier(3, 0, 1), &points[0][0], NULL);
    CHECK(taut_model_new(&model) == TAUT_OK, "model");
    CHECK(taut_model_add_surface(model, surface) == TAUT_OK, "surface");
    CHECK(taut_model_add_curve(model, curve) == TAUT_OK, "curve");
    fault_loop(&(fault_call){"taut_draw_figure", draw, NULL, model});
    fault_loop(&(fault_call){"taut_draw_figures", draw_marks, NULL, model});
    fault_loop(&(fault_call){"taut_html_data", page, taut_free, model});
    taut_model_free(model);
    CHECK(fault_live() == 0, "%ld blocks left", fault_live());
    return check_failures != 0;
}
