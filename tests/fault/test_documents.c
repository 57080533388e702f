/* test_documents.c -- reading, writing and meshing when memory runs out. */
#include "calls.h"
#include "check.h"
#include "fault.h"
#include "folder.h"

#include "taut/mesh.h"
#include "taut/read.h"
#include "taut/write.h"

#include <stdio.h>
#include <string.h>
#include <unistd.h>

#define TEN "1234567890"

static const char model_text[] =
    "{\"taut\": 1, \"unit\": \"m\", \"surfaces\": [{\"name\": \"a\",\n"
    "  \"u\": {\"type\": \"bezier\", \"degree\": 1},\n"
    "  \"v\": {\"type\": \"bspline\", \"degree\": 1, \"knots\": [0, 0, 0.30000000000000004, 1, "
    "1]},\n"
    "  \"points\": [[[0, 0, 0], [0, 1, 0.12345678901234567], [0, 2, 0]],\n"
    "               [[1, 0, 0], [1, 1, 2], [1, 2, 0]]],\n"
    "  \"weights\": [[1, 2, 1], [1, 1, 1]]}],\n"
    " \"curves\": [{\"t\": {\"type\": \"bezier\", \"degree\": 1}, \"points\": [[0, 0, 0], [1, 1, "
    "1]]}],\n"
    " \"details\": {\"list\": [1, [2, true], null], \"a name that is long enough\": \"and a "
    "text\"},\n"
    " \"certificate\": {\"construct\": \"dirichlet\", \"claims\": [{\"claim\": \"stationary\",\n"
    "  \"residual\": 1e-17, \"limit\": 1e-12, \"holds\": true}], \"figures\": {\"area\": 2}}}";

static const char problem_text[] =
    "{\"taut\": 1, \"construct\": \"dirichlet\", \"name\": \"lid\",\n"
    " \"u\": {\"type\": \"bezier\", \"degree\": 2}, \"v\": {\"type\": \"c-bspline\", \"alpha\": "
    "0.5, "
    "\"segments\": 1},\n"
    " \"points\": [[[0, 0, 0.12345678901234567], null, null, null], [null, null, null, null],\n"
    "              [null, null, null, null]]}";

/* Rational coordinates, and numbers and members too many for what is kept on the stack. */
static const char exact_text[] =
    "{\"taut\": 1, \"surfaces\": [{\"u\": {\"type\": \"bezier\", \"degree\": 1},\n"
    "  \"v\": {\"type\": \"bezier\", \"degree\": 1},\n"
    "  \"points\": [[[0, \"1/3\", 0], [0, 1, 0]], [[1, 0, \"-7\"], [1, 1, 2]]]}],\n"
    " \"details\": {\"empty\": [[]], \"a\": {\"a\": 1, \"b\": 1, \"c\": 1, \"d\": 1, \"e\": 1,\n"
    "  \"f\": 1, \"g\": 1, \"h\": 1, \"i\": 1, \"j\": 1, \"k\": 1, \"l\": 1, \"m\": 1, \"n\": 1,\n"
    "  \"o\": 1, \"p\": 1, \"long\": 0." TEN TEN TEN TEN TEN TEN TEN TEN TEN TEN TEN TEN TEN "}}}";

#define BEZIER(degree) "{\"type\": \"bezier\", \"degree\": " #degree "}"
#define LINE(from, to) "{\"t\": " BEZIER(1) ", \"points\": [" from ", " to "]}"

/* What the examples of test_examples.c have no need of. */
static const char *const problems[] = {
    "{\"taut\": 1, \"construct\": \"asymptotic\", \"curves\": {\"v0\": " LINE(
        "[0,0,0]", "[1,0,0]") ", "
                              "\"v1\": " LINE("[0,1,0]", "[1,1,0]") ", \"u0\": " LINE(
                                  "[0,0,0]", "[0,1,0]") ", \"u1\": " LINE("[1,0,0]",
                                                                          "[1,1,0]") "}}",
    "{\"taut\": 1, \"construct\": \"plateau\", \"u\": " BEZIER(2) ", \"v\": " BEZIER(
        2) ", "
           "\"curves\": {\"v0\": " LINE("[0,0,0]", "[1,0,0]") ", \"v1\": " LINE(
               "[0,1,0]", "[1,1,0]") ", "
                                     "\"u0\": " LINE("[0,0,0]", "[0,1,0]") ", \"u1\": " LINE(
                                         "[1,0,0]", "[1,1,0]") "}}",
    "{\"taut\": 1, \"construct\": \"biharmonic\", \"name\": \"rows\", \"u\": " BEZIER(
        1) ", \"v\": " BEZIER(1) ", \"points\": [[null, null], [null, null]]}",
    "{\"taut\": 1, \"construct\": \"biharmonic\", \"edge\": \"v0\", \"surface\": {\"u\": " BEZIER(
        1) ", \"v\": " BEZIER(1) ", \"points\": [[[0,0,0],[0,1,0]],[[1,0,0],[1,1,0]]]}}",
    "{\"taut\": 1, \"construct\": \"harmonic\", \"name\": \"rows\", \"u\": " BEZIER(
        1) ", \"v\": " BEZIER(1) ", \"points\": "
                                 "[[[0,\"1/3\",0],[0,1,0]],[[1,0,0],[1,\"2/7\",\"5\"]]]}",
};

static char path[64]; /* a file with the model in it */
static char out[64];  /* where outputs go */

static taut_status change_problem(const void *context, void **result, taut_error *error)
{
    taut_problem *changed = *result;
    const taut_status status =
        taut_problem_change(context, "/points/0/0", "[0, 1, 2]", 9, &changed, error);
    *result = changed;
    return status;
}

static void test_change(void)
{
    taut_problem *problem = NULL;
    CHECK(taut_problem_read_text(problem_text, strlen(problem_text), "text", &problem, NULL) ==
              TAUT_OK,
          "problem");
    fault_check("taut_problem_change", change_problem, release_problem, problem, 20);
    taut_problem_free(problem);
}

static taut_status new_mesh(const void *context, void **result, taut_error *error)
{
    const taut_mesh_options options = {.divide = 2};
    taut_mesh *mesh = *result;
    const taut_status status = taut_mesh_new(context, &options, &mesh, error);
    *result = mesh;
    return status;
}

static void release_mesh(void *mesh)
{
    taut_mesh_free(mesh);
}

/* Writes the model as JSON, as a mesh, and a record, and puts them in place. */
static taut_status write_all(const void *context, void **result, taut_error *error)
{
    const taut_write_options options = {.divide = 1};
    taut_outputs *outputs = NULL;
    taut_status status = taut_outputs_new(&outputs);
    char name[80];

    (void)result;
    for (int i = 0; status == TAUT_OK && i < 2; i++) {
        snprintf(name, sizeof name, "%s/%s", out, i == 0 ? "m.json" : "m.obj");
        status = taut_outputs_model(outputs, context, name, &options, error);
    }
    if (status == TAUT_OK) {
        snprintf(name, sizeof name, "%s/r.json", out);
        status = taut_outputs_record(outputs, taut_model_details(context), name, error);
    }
    if (status == TAUT_OK) {
        status = taut_outputs_commit(outputs, error);
    }
    taut_outputs_free(outputs);
    for (int i = 0; status == TAUT_OK && i < 3; i++) {
        static const char *const names[] = {"m.json", "m.obj", "r.json"};
        snprintf(name, sizeof name, "%s/%s", out, names[i]);
        CHECK(unlink(name) == 0, "%s is not in place", name);
    }
    /* nothing else is there; after a failure, nothing at all */
    CHECK(rmdir(out) == 0 && folder_add(out) == 0, "something was left in %s", out);
    return status;
}

static taut_status write_record(const void *context, void **result, taut_error *error)
{
    char *text = *result;
    size_t length = 0;
    const taut_status status = taut_record_write(context, &text, &length);
    (void)error;
    *result = text;
    return status;
}

static void release_text(void *text)
{
    taut_text_free(text);
}

int main(void)
{
    taut_model *model = NULL;

    folder_make();
    snprintf(path, sizeof path, "%s", in_folder("m.json"));
    snprintf(out, sizeof out, "%s", in_folder("out"));
    CHECK(folder_add(out) == 0, "%s", out);
    CHECK(taut_model_read_text(model_text, sizeof model_text - 1, "text", &model, NULL) == TAUT_OK,
          "model");
    CHECK(taut_model_write(model, path, NULL, NULL) == TAUT_OK, "written");
    fault_check("taut_model_read_text", read_model_text, release_model, model_text, 50);
    fault_check("taut_model_read_text, exact", read_model_text, release_model, exact_text, 30);
    fault_check("taut_model_read_with", read_model, release_model, path, 50);
    test_change();
    fault_check("taut_problem_read_text", read_problem_text, release_problem, problem_text, 20);
    for (size_t i = 0; i < sizeof problems / sizeof problems[0]; i++) {
        fault_check(problems[i], read_problem_text, release_problem, problems[i], 10);
    }
    fault_check("taut_mesh_new", new_mesh, release_mesh, model, 20);
    fault_check("taut_record_write", write_record, release_text, taut_model_details(model), 1);
    fault_check("taut_outputs", write_all, NULL, model, 20);
    taut_model_free(model);
    folder_remove();
    return check_failures != 0;
}
