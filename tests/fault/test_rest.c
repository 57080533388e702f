/* test_rest.c -- the public calls that no other file of this folder makes, when memory runs out. */
#include "calls.h"
#include "check.h"
#include "fault.h"
#include "folder.h"
#include "shapes.h"

#include "taut/abi.h"
#include "taut/draw.h"
#include "taut/join.h"
#include "taut/measure.h"
#include "taut/operations.h"
#include "taut/panels.h"
#include "taut/pattern.h"
#include "taut/read.h"
#include "taut/recognise.h"
#include "taut/write.h"

#include <stdio.h>
#include <string.h>
#include <unistd.h>

/* A call that makes something of a surface. */
#define MAKER(name, type, expression)                                                              \
    static taut_status name(const void *context, void **result, taut_error *error)                 \
    {                                                                                              \
        const taut_surface *surface = context;                                                     \
        type *made = *result;                                                                      \
        const taut_status status = expression;                                                     \
        *result = made;                                                                            \
        return status;                                                                             \
    }

MAKER(insert, taut_surface, taut_surface_insert(surface, TAUT_ALONG_U, 0.4, 2, &made, error))
MAKER(elevate, taut_surface, taut_surface_elevate(surface, TAUT_ALONG_V, 2, &made, error))

/* Rational points, some of them the double itself. */
static taut_status new_exact(const void *context, void **result, taut_error *error)
{
    static const char *const exact[12] = {"1/3", NULL, "2", NULL, "-5/12"};
    static const double points[12] = {1.0 / 3, 0, 2, 0, -5.0 / 12, 0, 1, 0, 0, 1, 1, 1};
    taut_surface *made = *result;
    const taut_basis *line = taut_curve_t(context);
    const taut_status status =
        taut_surface_new_exact("s", line, line, points, NULL, exact, &made, error);
    *result = made;
    return status;
}

static taut_status jacobian(const void *context, void **result, taut_error *error)
{
    taut_jacobian found = {.cells = -1};
    const taut_status status = taut_surface_jacobian(context, &found);
    (void)result;
    (void)error;
    CHECK((status == TAUT_OK) == (found.cells >= 0), "the Jacobian is untouched on failure");
    return status;
}

static taut_status dirichlet(const void *context, void **result, taut_error *error)
{
    double energy = -1;
    const taut_status status = taut_surface_dirichlet_energy(context, &energy);
    (void)result;
    (void)error;
    CHECK((status == TAUT_OK) == (energy >= 0), "the energy is untouched on failure");
    return status;
}

/* A bicubic over knots far from 0, which an integral moves. */
static taut_surface *far_surface(void)
{
    static const double knots[8] = {1e7, 1e7, 1e7, 1e7, 1e7 + 1, 1e7 + 1, 1e7 + 1, 1e7 + 1};
    const taut_basis_spec spec = {.type = "bspline", .degree = 3, .knots = knots, .knot_count = 8};
    double points[48];
    for (int k = 0; k < 48; k++) {
        points[k] = random_in(-1, 1);
    }
    return shape_surface(shape_basis(&spec), shape_bezier(3, 1e7, 1e7 + 1), points, NULL);
}

static taut_status join(const void *context, void **result, taut_error *error)
{
    taut_join found = {.max_gap = -1};
    const taut_status status =
        taut_join_measure_with(context, TAUT_EDGE_U0, context, TAUT_EDGE_U1, NULL, &found, error);
    (void)result;
    CHECK((status == TAUT_OK) == (found.max_gap >= 0), "the join is untouched on failure");
    return status;
}

static taut_status panels(const void *context, void **result, taut_error *error)
{
    static const taut_panels_options options = {.divide = {2, 3}};
    taut_model *made = *result;
    const taut_status status = taut_panels_of_problem(context, &options, &made, error);
    *result = made;
    return status;
}

/* A list of what the two measuring calls print. */
static taut_status records(const void *context, void **result, taut_error *error)
{
    static const taut_join found = {.one_surface = 1};
    static const taut_curve_measure measure = {.length = 1};
    taut_record *list = taut_record_new_list();
    (void)error;
    taut_join_record(&found, taut_record_add_object(list, NULL));
    taut_measure_curve_record(context, &measure, taut_record_add_object(list, NULL));
    if (taut_record_status(list) != TAUT_OK) {
        taut_record_free(list);
        return TAUT_NO_MEMORY;
    }
    *result = list;
    return TAUT_OK;
}

static taut_status read_record(const void *context, void **result, taut_error *error)
{
    taut_record *record = *result;
    const taut_status status =
        taut_record_read_text(context, strlen(context), "text", &record, error);
    *result = record;
    return status;
}

static taut_status read_list(const void *context, void **result, taut_error *error)
{
    taut_problem_list *list = *result;
    const taut_status status = taut_problem_list_read(context, &list, error);
    *result = list;
    return status;
}

/* Twice the same problem, as a list. */
static taut_status read_list_text(const void *context, void **result, taut_error *error)
{
    taut_problem_list *list = *result;
    const taut_status status =
        taut_problem_list_read_text(context, strlen(context), "text", &list, error);
    *result = list;
    return status;
}

static void release_list(void *list)
{
    taut_problem_list_free(list);
}

/* A text in a file; after a failure the file is not there. */
static taut_status write_text(const void *context, void **result, taut_error *error)
{
    taut_outputs *outputs = NULL;
    const char *const path = in_folder("t.txt");
    taut_status status = taut_outputs_new(&outputs);
    (void)result;
    if (status == TAUT_OK) {
        status = taut_outputs_text(outputs, context, strlen(context), path, error);
    }
    if (status == TAUT_OK) {
        status = taut_outputs_commit(outputs, error);
    }
    taut_outputs_free(outputs);
    CHECK((unlink(path) == 0) == (status == TAUT_OK), "a text that is there after all, or not");
    return status;
}

static taut_status write_model(const void *context, void **result, taut_error *error)
{
    const char *const path = in_folder("m.stl");
    const taut_status status = taut_model_write(context, path, NULL, error);
    (void)result;
    CHECK((unlink(path) == 0) == (status == TAUT_OK), "a model that is there after all, or not");
    return status;
}

static void release_text(void *text)
{
    taut_text_free(text);
}

static taut_status write_model_text(const void *context, void **result, taut_error *error)
{
    const taut_write_options options = {.divide = 1};
    char *text = *result;
    size_t length = 0;
    const taut_status status =
        taut_model_write_text(context, "stl", &options, &text, &length, error);
    *result = text;
    return status;
}

static taut_status copy_model(const void *context, void **result, taut_error *error)
{
    taut_model *copy = *result;
    const taut_status status = taut_model_copy(context, &copy);
    (void)error;
    *result = copy;
    return status;
}

/* One model beside itself, in one figure. */
static taut_status write_models(const void *context, void **result, taut_error *error)
{
    const taut_model *const models[2] = {context, context};
    const taut_write_options options = {.divide = 1, .formats = taut_draw_formats()};
    taut_outputs *outputs = NULL;
    const char *const path = in_folder("two.svg");
    taut_status status = taut_outputs_new(&outputs);
    (void)result;
    if (status == TAUT_OK) {
        status = taut_outputs_models(outputs, 2, models, path, &options, error);
    }
    if (status == TAUT_OK) {
        status = taut_outputs_commit(outputs, error);
    }
    taut_outputs_free(outputs);
    CHECK((unlink(path) == 0) == (status == TAUT_OK), "a figure that is there after all, or not");
    return status;
}

static const char problem_text[] =
    "{\"taut\": 1, \"construct\": \"dirichlet\", \"u\": {\"type\": \"bezier\", \"degree\": 1},\n"
    " \"v\": {\"type\": \"bezier\", \"degree\": 1},\n"
    " \"points\": [[[0, 0, 0], [0, 1, 0]], [[1, 0, 0], null]]}\n";

/* A piece and a seam of a pattern, of which little is told; the model's own. */
static taut_model *little_cloth(void)
{
    taut_model *cloth = NULL;
    taut_record *details = taut_record_new();
    CHECK(taut_model_new(&cloth) == TAUT_OK, "a model");
    taut_record_add_text(details, "pattern", "cloth");
    taut_record_add_text(taut_record_add_object(taut_record_add_list(details, "pieces"), NULL),
                         "name", "P1");
    taut_record_add_text(taut_record_add_object(taut_record_add_list(details, "seams"), NULL),
                         "name", "S1");
    taut_model_set_details(cloth, details);
    return cloth;
}

/* What tests/fault/no_memory.txt says takes none. */
static void test_no_memory(const taut_surface *surface, const taut_curve *curve, taut_model *model)
{
    double values[6 * 8];
    taut_family_member member;
    taut_edge edge = TAUT_EDGE_U0;
    taut_forms forms;
    const double half = 0.5;
    int word = 0;
    taut_pattern_flat_piece piece;
    taut_pattern_sewn_seam seam;
    taut_model *cloth = little_cloth();
    fault_arm(1000, 0);
    CHECK(taut_pattern_piece_at(cloth, 0, &piece, NULL) == TAUT_OK, "piece");
    CHECK(taut_pattern_seam_at(cloth, 0, NULL, NULL, NULL, &seam, NULL) == TAUT_OK, "seam");
    CHECK(taut_basis_eval(taut_curve_t(curve), 0, 0.5, 2, values) == TAUT_OK, "basis");
    CHECK(taut_curve_eval(curve, 0.5, 2, values) == TAUT_OK, "curve");
    CHECK(taut_surface_eval(surface, 0.5, 0.5, 2, values) == TAUT_OK, "surface");
    CHECK(taut_curve_eval_points(curve, 1, &half, 2, 1, values) == TAUT_OK, "curve, places");
    CHECK(taut_surface_eval_points(surface, 1, &half, &half, 2, 1, values) == TAUT_OK, "places");
    CHECK(taut_surface_forms_points(surface, 1, &half, &half, 1, &forms) == TAUT_OK, "forms");
    CHECK(taut_edge_of_name("v1", &edge) == TAUT_OK, "edge");
    CHECK(taut_enum_value("taut_edge", "v1", &word) == TAUT_OK, "word");
    CHECK(taut_model_set_unit(model, "in") == TAUT_OK, "unit");
    (void)taut_surface_recognise(surface, &member, NULL); /* whatever it finds */
    CHECK(fault_counted() == 0, "%ld allocations", fault_counted());
    fault_disarm();
    taut_model_free(cloth);
}

int main(void)
{
    static const double points[2][3] = {{0, 0, 0}, {1, 1, 0}};
    char path[64], two[2 * sizeof problem_text + 8];
    static const char bonnet_text[] = "{\"taut\": 1, \"construct\": \"bonnet\", \"lambda\": 0.5,"
                                      " \"sign\": \"+\", \"alpha\": 0.5, \"beta\": 0.5}";
    taut_problem *bonnet = NULL;
    static const double flat[12] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0};
    taut_surface *surface = NULL, *copy = NULL, *plane = NULL, *far = NULL;
    taut_model *model = NULL;
    taut_curve *curve = shape_curve(shape_bezier(1, 0, 1), &points[0][0], NULL);

    random_seed(20260117);
    surface = shape_random(2, 3, 1);
    copy = shape_random(2, 2, 0);
    CHECK(taut_surface_transform(copy, flat, &plane, NULL) == TAUT_OK, "a surface in a plane");
    taut_surface_free(copy);
    folder_make();
    CHECK(taut_model_new(&model) == TAUT_OK && taut_surface_copy(surface, &copy) == TAUT_OK &&
              taut_model_add_surface(model, copy) == TAUT_OK,
          "model");
    snprintf(path, sizeof path, "%s", in_folder("problem.json"));
    file_put_text(path, problem_text);

    fault_check("taut_surface_insert", insert, release_surface, surface, 1);
    fault_check("taut_surface_elevate", elevate, release_surface, surface, 1);
    fault_check("taut_surface_new_exact", new_exact, release_surface, curve, 1);
    fault_check("taut_surface_jacobian", jacobian, NULL, plane, 1);
    far = far_surface();
    fault_check("taut_surface_dirichlet_energy", dirichlet, NULL, far, 1);
    taut_surface_free(far);
    fault_check("taut_join_measure", join, NULL, surface, 1);
    CHECK(taut_problem_read_text(bonnet_text, sizeof bonnet_text - 1, "text", &bonnet, NULL) ==
              TAUT_OK,
          "bonnet");
    fault_check("taut_panels_of_problem", panels, release_model, bonnet, 1);
    taut_problem_free(bonnet);
    fault_check("taut_join_record, taut_measure_curve_record", records, release_record, curve, 1);
    fault_check("taut_record_read_text", read_record, release_record, problem_text, 1);
    fault_check("taut_record_read_text of nothing", read_record, release_record, "[]", 1);
    fault_check("taut_problem_read", read_problem, release_problem, path, 1);
    fault_check("taut_problem_list_read", read_list, release_list, path, 1);
    snprintf(two, sizeof two, "[%s, %s]", problem_text, problem_text);
    fault_check("taut_problem_list_read_text", read_list_text, release_list, two, 1);
    fault_check("taut_outputs_text", write_text, NULL, problem_text, 1);
    fault_check("taut_model_write", write_model, NULL, model, 1);
    fault_check("taut_model_write_text", write_model_text, release_text, model, 1);
    fault_check("taut_model_copy", copy_model, release_model, model, 1);
    fault_check("taut_outputs_models", write_models, NULL, model, 1);

    test_no_memory(surface, curve, model);
    taut_model_free(model);
    taut_surface_free(surface);
    taut_surface_free(plane);
    taut_curve_free(curve);
    CHECK(fault_live() == 0, "%ld blocks left", fault_live());
    folder_remove();
    return check_failures != 0;
}
