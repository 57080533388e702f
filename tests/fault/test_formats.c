/* test_formats.c -- formats and boundaries out of files when memory runs out. */
#include "calls.h"
#include "check.h"
#include "fault.h"
#include "folder.h"
#include "shapes.h"

#include "geometry/boundary/boundary.h"
#include "taut/read.h"
#include "taut/write.h"

#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* A rational surface of two spans, and a c- one: exact cells and quads. */
static const char surfaces_text[] =
    "{\"taut\": 1, \"surfaces\": [{\"u\": {\"type\": \"bspline\", \"degree\": 1, \"knots\": [0, 0, "
    "1, 2, 2]}, \"v\": {\"type\": \"bezier\", \"degree\": 1}, \"points\": [[[0,0,0],[0,1,0]], "
    "[[1,0,1],[1,1,0]], [[2,0,0],[2,1,1]]], \"weights\": [[1,2],[1,1],[1,1]]}, {\"u\": {\"type\": "
    "\"c-bezier\", \"alpha\": 1}, \"v\": {\"type\": \"bezier\", \"degree\": 1}, \"points\": "
    "[[[0,0,0],[0,1,0]], [[1,0,0],[1,1,0]], [[2,0,1],[2,1,0]], [[3,0,0],[3,1,0]]]}]}";

/* Four curves of unlike degrees, one of them rational, one of two spans, out of order. */
static const char frame_text[] =
    "{\"taut\": 1, \"curves\": [{\"t\": {\"type\": \"bezier\", \"degree\": 2}, \"points\": "
    "[[0,0,0],[1,0,1],[2,0,0]], \"weights\": [1,2,3]}, {\"t\": {\"type\": \"bspline\", \"degree\": "
    "1, \"knots\": [0,0,1,2,2]}, \"points\": [[2,2,0],[1,2,1],[0,2,0]]}, {\"t\": {\"type\": "
    "\"bezier\", \"degree\": 1}, \"points\": [[0,2,0],[0,0,0]]}, {\"t\": {\"type\": \"bezier\", "
    "\"degree\": 1}, \"points\": [[2,0,0],[2,2,0]]}]}";

/* Four polynomial curves, the first of them of a degree of its own. */
static const char raised_text[] =
    "{\"taut\": 1, \"curves\": [{\"t\": {\"type\": \"bezier\", \"degree\": 1}, \"points\": "
    "[[0,0,0],[2,0,0]]}, {\"t\": {\"type\": \"bezier\", \"degree\": 3}, \"points\": "
    "[[2,0,0],[2,1,1],[2,1,0],[2,2,0]]}, {\"t\": {\"type\": \"bezier\", \"degree\": 1}, "
    "\"points\": "
    "[[2,2,0],[0,2,0]]}, {\"t\": {\"type\": \"bezier\", \"degree\": 1}, \"points\": "
    "[[0,2,0],[0,0,0]]}]}";

/* A table of one line. */
static const char cables_text[] =
    "{\"taut\": 1, \"curves\": [{\"t\": {\"type\": \"bezier\", \"degree\": 1}, \"points\": "
    "[[0,0,0],[2,0,0]]}], \"details\": {\"cables\": [{\"edge\": \"u0\", \"force\": 2}]}}";

/* An elbow at a corner. */
static const char bends_text[] =
    "{\"taut\": 1, \"curves\": [{\"t\": {\"type\": \"bezier\", \"degree\": 1}, \"points\": "
    "[[0,0,0],[2,0,0]]}, {\"t\": {\"type\": \"bezier\", \"degree\": 1}, \"points\": "
    "[[4,2,0],[4,4,0]]}], \"details\": {\"blends\": [{\"polygon\": "
    "[[2,0,0],[4,0,0],[4,0,0],[4,2,0]], \"least_bend_radius\": 1}]}}";

/* Writes the model in the format of its name and takes the file away again. */
static taut_status write_file(const taut_model *model, const char *name, taut_error *error)
{
    const taut_write_options options = {.divide = 1};
    const char *const path = in_folder(name);
    const taut_status status = taut_model_write(model, path, &options, error);
    CHECK((unlink(path) == 0) == (status == TAUT_OK), "%s is there although it failed", name);
    return status;
}

static taut_status write_vtu(const void *context, void **result, taut_error *error)
{
    (void)result;
    return write_file(context, "a.vtu", error);
}

/* Two sheets that share an edge on other knots, and a curve. */
static const char sheets_text[] =
    "{\"taut\": 1, \"surfaces\": [{\"u\": {\"type\": \"bezier\", \"degree\": 1}, \"v\": "
    "{\"type\": \"bezier\", \"degree\": 2}, \"points\": [[[0,0,0],[0,1,1e-9],[0,2,0]], "
    "[[1,0,0],[1,1,0],[1,2,0]]]}, {\"u\": {\"type\": \"bezier\", \"degree\": 1}, \"v\": {\"type\": "
    "\"bspline\", \"degree\": 1, \"knots\": [0, 0, 1, 2, 2]}, \"points\": "
    "[[[1,0,0],[1,1,0],[1,2,0]], "
    "[[2,0,0],[2,1,1],[2,2,0]]], \"weights\": [[1,1,1],[1,2,1]]}], \"curves\": [{\"t\": {\"type\": "
    "\"bezier\", \"degree\": 1}, \"points\": [[2,0,0],[2,2,0]]}]}";

/* Two pieces of a saddle, which meet smoothly. */
static const char plate_text[] =
    "{\"taut\": 1, \"surfaces\": [{\"u\": {\"type\": \"bezier\", \"degree\": 1}, \"v\": "
    "{\"type\": \"bezier\", \"degree\": 1}, \"points\": [[[0,0,0],[0,1,0]], [[1,0,0],[1,1,1]]]}, "
    "{\"u\": {\"type\": \"bezier\", \"degree\": 1}, \"v\": {\"type\": \"bezier\", \"degree\": 1}, "
    "\"points\": [[[1,1,1],[1,0,0]], [[2,1,2],[2,0,0]]]}], \"details\": {\"parts\": [{\"product\": "
    "\"p\", "
    "\"placement\": [[0,1,0,5],[-1,0,0,0],[0,0,1,0]], \"surfaces\": [0]}, {\"product\": \"q\", "
    "\"surfaces\": [1]}]}}";

static taut_status write_step(const void *context, void **result, taut_error *error)
{
    (void)result;
    return write_file(context, "a.step", error);
}

static taut_status write_thick(const void *context, void **result, taut_error *error)
{
    const taut_write_options options = {.thickness = 0.01, .tolerance = 1e-4};
    const char *const path = in_folder("b.step");
    const taut_status status = taut_model_write(context, path, &options, error);
    (void)result;
    CHECK((unlink(path) == 0) == (status == TAUT_OK), "b.step is there although it failed");
    return status;
}

static taut_status write_geomdl(const void *context, void **result, taut_error *error)
{
    (void)result;
    return write_file(context, "a.geomdl.json", error);
}

static taut_status write_glb(const void *context, void **result, taut_error *error)
{
    const taut_write_options options = {.divide = 1, .colour = TAUT_COLOUR_GAUSSIAN};
    const char *const path = in_folder("a.glb");
    const taut_status status = taut_model_write(context, path, &options, error);
    (void)result;
    CHECK((unlink(path) == 0) == (status == TAUT_OK), "a.glb is there although it failed");
    return status;
}

/* A plane in two strips, with its strains and lines. */
static taut_model *cloth_of_plane(void)
{
    static const char text[] =
        "{ \"taut\": 1, \"pattern\": \"cloth\", \"of\": { \"taut\": 1, \"surfaces\": [{ \"u\": { "
        "\"type\": "
        "\"bezier\", \"degree\": 1 }, \"v\": { \"type\": \"bezier\", \"degree\": 1 }, \"points\": "
        "[[[0, 0, 0], "
        "[0, 1, 0]], [[1, 0, 0], [1, 1, 0]]] }] }, \"seams\": [{ \"line\": { \"u\": 0.5 } }] }";
    taut_problem *problem = NULL;
    taut_model *model = NULL;
    CHECK(taut_problem_read_text(text, sizeof text - 1, "cloth", &problem, NULL) == TAUT_OK,
          "read");
    CHECK(taut_make(problem, NULL, &model, NULL) == TAUT_OK, "make");
    taut_problem_free(problem);
    return model;
}

static taut_status write_3mf(const void *context, void **result, taut_error *error)
{
    const taut_write_options options = {.divide = 1, .thickness = 0.01};
    const char *const path = in_folder("a.3mf");
    const taut_status status = taut_model_write(context, path, &options, error);
    (void)result;
    CHECK((unlink(path) == 0) == (status == TAUT_OK), "a.3mf is there although it failed");
    return status;
}

static taut_status write_dxf(const void *context, void **result, taut_error *error)
{
    (void)result;
    return write_file(context, "a.dxf", error);
}

static taut_status write_csv(const void *context, void **result, taut_error *error)
{
    (void)result;
    return write_file(context, "a.csv", error);
}

/* In order, and on common bases. */
static taut_status fit(const void *context, void **result, taut_error *error)
{
    static const int degree[2] = {3, 0}, halvings[2] = {0, 1};
    const taut_curve *curves[TAUT_SIDES];
    taut_curve *sides[TAUT_SIDES] = {NULL, NULL, NULL, NULL};
    taut_curve *fitted[TAUT_SIDES] = {NULL, NULL, NULL, NULL};
    taut_status status = TAUT_OK;
    for (int i = 0; i < TAUT_SIDES; i++) {
        curves[i] = taut_model_curve(context, i);
    }
    status = taut_boundary_order(curves, 1e-9, sides, error);
    if (status == TAUT_OK) {
        status = taut_boundary_fit(sides, degree, halvings, fitted, error);
    }
    taut_boundary_free(sides);
    taut_boundary_free(fitted);
    (void)result;
    return status;
}

/* One closed curve with kinks, joined to four sides. */
static const char loop_text[] =
    "{\"taut\": 1, \"curves\": [{\"name\": \"loop\", \"t\": {\"type\": \"bspline\", \"degree\": 1, "
    "\"knots\": [0,0,1,2,3,4,4]}, \"points\": [[0,0,0],[4,0,0],[4,3,0],[2,3.1,0],[0,0,0]]}]}";

static taut_status join(const void *context, void **result, taut_error *error)
{
    const taut_curve *loop = taut_model_curve(context, 0);
    taut_curve *joined[TAUT_SIDES] = {NULL, NULL, NULL, NULL};
    const taut_status status = taut_boundary_join(1, &loop, 1e-9, joined, error);
    taut_boundary_free(joined);
    (void)result;
    return status;
}

/* The same, behind itself. */
static taut_status link_to(const void *context, void **result, taut_error *error)
{
    const taut_curve *loop = taut_model_curve(context, 0);
    taut_curve *linked = NULL;
    const taut_status status = taut_boundary_link(loop, loop, &linked, error);
    taut_curve_free(linked);
    (void)result;
    return status;
}

/* A block inserted twice, of an arc and a text. */
static const char drawing_text[] =
    "0\nSECTION\n2\nBLOCKS\n0\nBLOCK\n2\nb\n0\nARC\n8\nl\n40\n2\n50\n0\n51\n200\n0\nTEXT\n0\nENDBLK"
    "\n0\n"
    "ENDSEC\n0\nSECTION\n2\nENTITIES\n0\nINSERT\n2\nb\n0\nINSERT\n2\nb\n10\n5\n0\nENDSEC\n0\nEOF\n";

static taut_model *model_of(const char *text)
{
    taut_model *model = NULL;
    taut_error error = {.status = TAUT_OK};
    CHECK(taut_model_read_text(text, strlen(text), "text", &model, &error) == TAUT_OK, "%s: %s",
          error.where, error.message);
    return model;
}

int main(void)
{
    static const char dirichlet[] =
        "{\"taut\": 1, \"construct\": \"dirichlet\", \"boundary\": \"frame.json\"}";
    static const char asymptotic[] =
        "{\"taut\": 1, \"construct\": \"asymptotic\", \"boundary\": \"single.json\"}";
    static const char harmonic[] = "{\"taut\": 1, \"construct\": \"harmonic\", \"known\": \"u\", "
                                   "\"boundary\": \"single.json\"}";
    static const char raised[] = "{\"taut\": 1, \"construct\": \"harmonic\", \"known\": \"u\", "
                                 "\"boundary\": \"raised.json\"}";
    static const char *const problems[] = {dirichlet, asymptotic, harmonic, raised};
    const char *path = NULL;
    char *single = strdup(frame_text);
    taut_model *surfaces = model_of(surfaces_text), *frame = model_of(frame_text);
    taut_model *cables = model_of(cables_text), *bends = model_of(bends_text);
    taut_model *sheets = model_of(sheets_text), *body = shape_model(shape_sphere(2));
    taut_model *plate = model_of(plate_text);

    folder_make();
    /* the side of two spans as one: its middle point and a knot blotted out */
    memcpy(strstr(single, "0,0,1,2,2"), "0,0,  2,2", 9);
    memcpy(strstr(single, "[1,2,1],"), "        ", 8);
    file_put_text(in_folder("single.json"), single);
    file_put_text(in_folder("raised.json"), raised_text);
    file_put_text(in_folder("frame.json"), frame_text);
    fault_check("vtu", write_vtu, NULL, surfaces, 20);
    fault_check("geomdl", write_geomdl, NULL, surfaces, 10);
    fault_check("geomdl of curves", write_geomdl, NULL, frame, 10);
    fault_check("step", write_step, NULL, sheets, 20);
    fault_check("step of a body", write_step, NULL, body, 20);
    fault_check("step of an assembly", write_step, NULL, plate, 40);
    fault_check("step of a sheet", write_thick, NULL, plate, 40);
    fault_check("glb", write_glb, NULL, surfaces, 20);
    taut_model *cloth = cloth_of_plane();
    fault_check("glb of cloth", write_glb, NULL, cloth, 40);
    taut_model_free(cloth);
    fault_check("3mf", write_3mf, NULL, sheets, 30);
    fault_check("dxf", write_dxf, NULL, frame, 20);
    fault_check("csv", write_csv, NULL, cables, 3);
    fault_check("bends", write_csv, NULL, bends, 3);
    fault_check("boundary", fit, NULL, frame, 20);
    for (size_t i = 0; i < sizeof problems / sizeof problems[0]; i++) {
        path = in_folder("problem.json");
        file_put_text(path, problems[i]);
        fault_check(problems[i], read_problem, release_problem, path, 30);
    }
    path = in_folder("b.dxf");
    file_put_text(path, drawing_text);
    fault_check("dxf in", read_model, release_model, path, 20);
    taut_model *loop = model_of(loop_text);
    fault_check("loop", join, NULL, loop, 20);
    fault_check("link", link_to, NULL, loop, 20);
    taut_model_free(loop);
    path = in_folder("b.geomdl.json");
    CHECK(taut_model_write(surfaces, path, NULL, NULL) == TAUT_OK, "write");
    fault_check("geomdl in", read_model, release_model, path, 30);
    CHECK(taut_model_write(frame, path, NULL, NULL) == TAUT_OK, "write");
    fault_check("geomdl of curves in", read_model, release_model, path, 30);
    taut_model_free(surfaces);
    taut_model_free(frame);
    taut_model_free(sheets);
    taut_model_free(cables);
    taut_model_free(bends);
    taut_model_free(body);
    taut_model_free(plate);
    free(single);
    folder_remove();
    return check_failures != 0;
}
