/* test_step.c -- random models written as STEP: OpenCASCADE finds them valid, sewn and closed as they
 * are, with the volume that another route says, and taut's reader gives back the same numbers.
 * links: step-probe */
#include "check.h"
#include "folder.h"
#include "models.h"
#include "probe.h"
#include "shapes.h"

#include "io/step/elementary.h"

#include "taut/measure.h"
#include "taut/operations.h"
#include "taut/read.h"
#include "taut/write.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char *const units[] = {"mm", "m", "cm", "in", "ft"};
static const double millimetres[] = {1, 1000, 10, 25.4, 304.8};

/* Names that could break a file; the reader gives each back. */
static const char *const hostile[] = {"plain",
                                      "it''s",
                                      "a\\X2\\0041\\X0\\b",
                                      "');\n#1=DIRECTION('",
                                      "/* */ ; ENDSEC;",
                                      "\303\244\342\202\254\360\237\230\200",
                                      "\\",
                                      "'",
                                      "tab\there"};

static taut_surface *turned(taut_surface *surface, int way)
{
    taut_surface *made = NULL;
    for (int d = 0; d < 2; d++) {
        if ((way & (1 << d)) != 0) {
            CHECK(taut_surface_reverse(surface, d, &made, NULL) == TAUT_OK, "reverse");
            taut_surface_free(surface);
            surface = made;
        }
    }
    if ((way & 4) != 0) {
        CHECK(taut_surface_transpose(surface, &made, NULL) == TAUT_OK, "transpose");
        taut_surface_free(surface);
        surface = made;
    }
    return surface;
}

/* The same surface under a name. */
static taut_surface *named(taut_surface *surface, const char *name)
{
    taut_surface *made = NULL;
    CHECK(taut_surface_new(name, taut_surface_u(surface), taut_surface_v(surface),
                           taut_surface_points(surface), taut_surface_weights(surface), &made,
                           NULL) == TAUT_OK,
          "named");
    taut_surface_free(surface);
    return made;
}

static void add(taut_model *model, taut_surface *surface)
{
    CHECK(taut_model_add_surface(model, surface) == TAUT_OK, "add");
}

/* Degree, knots and weights of a bilinear patch are made any others. */
static taut_surface *disguised(taut_surface *surface)
{
    taut_surface *made = NULL;
    for (int d = 0; d < 2; d++) {
        CHECK(taut_surface_elevate(surface, d, random_int(0, 3), &made, NULL) == TAUT_OK,
              "elevate");
        taut_surface_free(surface);
        surface = made;
        if (random_int(0, 1)) {
            CHECK(taut_surface_insert(surface, d, random_in(0.1, 0.9), 1, &made, NULL) == TAUT_OK,
                  "insert");
            taut_surface_free(surface);
            surface = made;
        }
        if (random_int(0, 1)) {
            const double lo = random_in(-9, 9);
            CHECK(taut_surface_rerange(surface, d, lo, lo + random_log(0.1, 20), &made, NULL) ==
                      TAUT_OK,
                  "rerange");
            taut_surface_free(surface);
            surface = made;
        }
    }
    return turned(surface, random_int(0, 7));
}

/* The volume of the trilinear box: the determinant of its derivative has degree 2 in each variable, so
 * that two Gauss points a direction are exact. */
static double box_volume(const double corner[8][3])
{
    double volume = 0;
    for (int g = 0; g < 8; g++) {
        double t[3], d[3][3] = {{0}};
        for (int c = 0; c < 3; c++) {
            t[c] = 0.5 + ((g >> c & 1) ? 0.5 : -0.5) / sqrt(3);
        }
        for (int i = 0; i < 8; i++) {
            for (int k = 0; k < 3; k++) {
                double slope = 1;
                for (int c = 0; c < 3; c++) {
                    slope *= c == k ? ((i >> c & 1) ? 1 : -1) : (i >> c & 1) ? t[c] : 1 - t[c];
                }
                for (int c = 0; c < 3; c++) {
                    d[k][c] += slope * corner[i][c];
                }
            }
        }
        volume += (d[0][0] * (d[1][1] * d[2][2] - d[1][2] * d[2][1]) -
                   d[0][1] * (d[1][0] * d[2][2] - d[1][2] * d[2][0]) +
                   d[0][2] * (d[1][0] * d[2][1] - d[1][1] * d[2][0])) /
                  8;
    }
    return fabs(volume);
}

static taut_model *new_model(const char *unit)
{
    taut_model *model = NULL;
    CHECK(taut_model_new(&model) == TAUT_OK && taut_model_set_unit(model, unit) == TAUT_OK,
          "model");
    return model;
}

/* Six faces of a box with moved corners, in any order of parameters, basis and name. */
static taut_model *any_box(double size, const char *unit, double *volume)
{
    static const int faces[6][4] = {{0, 1, 2, 3}, {4, 5, 6, 7}, {0, 1, 4, 5},
                                    {2, 3, 6, 7}, {0, 2, 4, 6}, {1, 3, 5, 7}};
    taut_model *model = new_model(unit);
    double corner[8][3], points[12];
    for (int i = 0; i < 8; i++) {
        for (int c = 0; c < 3; c++) {
            corner[i][c] = size * ((i >> c & 1) + random_in(-0.2, 0.2) - 0.3);
        }
    }
    *volume = box_volume((const double(*)[3])corner);
    for (int f = 0; f < 6; f++) {
        for (int k = 0; k < 4; k++) {
            memcpy(points + 3 * k, corner[faces[f][k]], 3 * sizeof *points);
        }
        add(model, named(disguised(shape_surface(shape_bezier(1, 0, 1), shape_bezier(1, 0, 1),
                                                 points, NULL)),
                         hostile[random_int(0, 8)]));
    }
    return model;
}

static void write_model(const taut_model *model, const char *path)
{
    taut_error error = {.status = TAUT_OK};
    CHECK(taut_model_write(model, path, NULL, &error) == TAUT_OK, "%s: %s", path, error.message);
}

/* What the file itself says, by a reader of its lines: instances of the kinds that make loops. */
enum { INSTANCES = 20000 };
typedef struct topology {
    int vertex[INSTANCES][2]; /* of an edge */
    int edge[INSTANCES];      /* of a use; 0: none */
    int along[INSTANCES];
    int uses[INSTANCES][2]; /* of an edge: against, along */
    int edges, joined;
} topology;

static void check_loop(topology *t, const char *list, int loop)
{
    int use[16] = {0}, count = 0;
    for (int read = 0;
         count < 16 && sscanf(list, count == 0 ? "(#%d%n" : ",#%d%n", &use[count], &read) == 1;
         count++) {
        list += read;
    }
    CHECK(count >= 1 && *list == ')', "loop %d: %s", loop, list);
    for (int k = 0; k < count; k++) {
        const int here = use[k], next = use[(k + 1) % count];
        CHECK(t->edge[here] != 0 && t->edge[next] != 0, "loop %d", loop);
        CHECK(t->vertex[t->edge[here]][t->along[here]] == t->vertex[t->edge[next]][!t->along[next]],
              "loop %d: use %d ends where %d does not begin", loop, here, next);
        t->uses[t->edge[here]][t->along[here]]++;
    }
}

/* A point of the file, of two coordinates or of three. */
static void read_point(const char *text, int id, double x[3])
{
    char start[40];
    const char *at = NULL;
    snprintf(start, sizeof start, "\n#%d=CARTESIAN_POINT('',(", id);
    at = strstr(text, start);
    CHECK(at != NULL && sscanf(at + strlen(start), "%lf,%lf,%lf", &x[0], &x[1], &x[2]) >= 2,
          "point %d", id);
}

/* What instance id refers to, four at most. */
static int read_refs(const char *text, int id, const char *format, int refs[4])
{
    char start[40];
    const char *at = NULL;
    snprintf(start, sizeof start, "\n#%d=", id);
    at = strstr(text, start);
    return at != NULL ? sscanf(at + strlen(start), format, &refs[0], &refs[1], &refs[2], &refs[3])
                      : 0;
}

/* The curve of an edge in a face's parameters begins and ends where its vertices are. `surfaces` are
 * the numbers of the surfaces, in the model's order. A straight LINE runs by the edge's own parameter,
 * and is the same for all. */
static void check_trace(const taut_model *model, const char *text, int trace, const int *ends,
                        const int *surfaces, double size)
{
    int pcurve[4] = {0}, whole[4] = {0}, line[4] = {0}, face = 0;
    CHECK(read_refs(text, trace, "PCURVE('',#%d,#%d)", pcurve) == 2 &&
              read_refs(text, pcurve[1], "DEFINITIONAL_REPRESENTATION('',(#%d)", whole) == 1,
          "trace %d", trace);
    while (face < taut_model_surface_count(model) && surfaces[face] != pcurve[0]) {
        face++;
    }
    if (read_refs(text, whole[0], "B_SPLINE_CURVE_WITH_KNOTS('',1,(#%d,#%d)", line) != 2) {
        return;
    }
    for (int end = 0; end < 2; end++) {
        int vertex[4] = {0};
        double t[3] = {0}, x[3] = {0}, y[3] = {0};
        CHECK(read_refs(text, ends[end], "VERTEX_POINT('',#%d)", vertex) == 1, "vertex %d",
              ends[end]);
        read_point(text, line[end], t);
        read_point(text, vertex[0], x);
        CHECK(taut_surface_eval(taut_model_surface(model, face), t[0], t[1], 0, y) == TAUT_OK,
              "face %d", face);
        for (int c = 0; c < 3; c++) {
            CHECK_NEAR(y[c], x[c], 1e-12 * size, "trace %d, end %d, coordinate %d", trace, end, c);
        }
    }
}

/* Every edge's curves in the parameters of its faces. */
static void check_traces(const taut_model *model, const char *path, double size)
{
    char *text = file_bytes(path, NULL);
    int surfaces[64] = {0}, count = 0, two = 0;
    for (const char *at = text; (at = strstr(at, "\n#")) != NULL; at++) {
        int id = 0, edge[4] = {0}, traces[4] = {0}, word = 0;
        sscanf(at, "\n#%d=%n", &id, &word);
        const char *kind = at + word;
        if (strncmp(kind, "B_SPLINE_SURFACE", 16) == 0 ||
            strncmp(kind, "(BOUNDED_SURFACE", 16) == 0) {
            surfaces[count++ % 64] = id;
        }
        if (sscanf(kind, "EDGE_CURVE('',#%d,#%d,#%d", &edge[0], &edge[1], &edge[2]) != 3) {
            continue;
        }
        const int found = read_refs(text, edge[2], "SURFACE_CURVE('',#%d,(#%d,#%d)", traces);
        for (int k = 1; k < found; k++) {
            check_trace(model, text, traces[k], edge, surfaces, size);
        }
        two += found == 3;
    }
    CHECK(count == taut_model_surface_count(model) && two == 12, "%d surfaces, %d edges of two",
          count, two);
    free(text);
}

/* Loops are closed chains; an edge is used once each way at most: faces agree on their outside. */
static void check_file(const char *path, int edges, int free_edges)
{
    topology *t = calloc(1, sizeof *t);
    char *text = file_bytes(path, NULL), *next = NULL;
    for (char *line = text; line != NULL && *line != '\0'; line = next) {
        int id = 0, a = 0, b = 0, c = 0, at = 0;
        char sense = ' ';
        next = line + strcspn(line, "\n");
        next += *next == '\n';
        if (sscanf(line, "#%d=", &id) != 1 || id >= INSTANCES) {
            continue;
        }
        if (sscanf(line, "#%d=EDGE_CURVE('',#%d,#%d,#%d,.%c", &id, &a, &b, &c, &sense) == 5) {
            CHECK(sense == 'T', "edge %d", id);
            t->vertex[id][0] = a;
            t->vertex[id][1] = b;
            t->edges++;
        } else if (sscanf(line, "#%d=ORIENTED_EDGE('',*,*,#%d,.%c", &id, &a, &sense) == 3) {
            t->edge[id] = a;
            t->along[id] = sense == 'T';
        } else if (sscanf(line, "#%d=EDGE_LOOP('',%n", &id, &at) == 1 && at > 0) {
            check_loop(t, line + at, id);
        }
    }
    for (int e = 0; e < INSTANCES; e++) {
        CHECK(t->uses[e][0] <= 1 && t->uses[e][1] <= 1, "edge %d is used %d and %d times", e,
              t->uses[e][0], t->uses[e][1]);
        t->joined += t->uses[e][0] == 1 && t->uses[e][1] == 1;
    }
    CHECK(t->edges == edges && t->edges - t->joined == free_edges, "%d edges, %d joined", t->edges,
          t->joined);
    free(text);
    free(t);
}

/* The same numbers, names and unit come back. */
static void check_back(const taut_model *model, const char *path)
{
    taut_model *back = NULL;
    taut_error error = {.status = TAUT_OK};
    CHECK(taut_model_read(path, &back, &error) == TAUT_OK, "%s: %s", path, error.message);
    if (back == NULL) {
        return;
    }
    CHECK(strcmp(taut_model_unit(back), taut_model_unit(model)) == 0, "%s", taut_model_unit(back));
    CHECK(taut_model_surface_count(back) == taut_model_surface_count(model), "%d of %d faces",
          taut_model_surface_count(back), taut_model_surface_count(model));
    for (int i = 0; i < taut_model_surface_count(model) && i < taut_model_surface_count(back);
         i++) {
        taut_surface *nurbs = NULL;
        CHECK(taut_surface_to_nurbs(taut_model_surface(model, i), 1, &nurbs, NULL, NULL) == TAUT_OK,
              "nurbs");
        CHECK(same_surface(taut_model_surface(back, i), nurbs), "%s: face %d, \"%s\" and \"%s\"",
              path, i, taut_surface_name(taut_model_surface(back, i)), taut_surface_name(nurbs));
        taut_surface_free(nurbs);
    }
    taut_model_free(back);
}

static void test_boxes(void)
{
    for (int trial = 0; trial < random_trials(40); trial++) {
        const int unit = random_int(0, 4);
        const double size = random_log(1e-3, 1e6), scale = millimetres[unit];
        const char *path = in_folder("box.step");
        step_probe found;
        double volume = 0;
        taut_model *model = any_box(size, units[unit], &volume);
        write_model(model, path);
        step_probe_file(path, &found);
        CHECK(found.is_read && found.valid && found.closed && found.solids == 1 &&
                  found.faces == 6 && found.edges == 12 && found.vertices == 8 &&
                  found.free_edges == 0 && found.colours == 6,
              "size %g %s: read %d valid %d closed %d, %d solids %d faces %d edges %d vertices %d "
              "free %d coloured",
              size, units[unit], found.is_read, found.valid, found.closed, found.solids,
              found.faces, found.edges, found.vertices, found.free_edges, found.colours);
        /* an edge lies on both faces at equal parameters: else the reader widens it */
        CHECK(found.tolerance <= fmax(1.01e-7, 1e-9 * size * scale), "tolerance %g of %g",
              found.tolerance, size * scale);
        check_file(path, 12, 0);
        check_traces(model, path, size);
        CHECK_NEAR(found.volume / (scale * scale * scale), volume, 1e-9 * volume, "size %g %s",
                   size, units[unit]);
        check_back(model, path);
        taut_model_free(model);
    }
}

/* A random smooth surface cut into a grid of pieces, each however it likes: one open shell, its edges
 * those of the grid. */
static void test_quilts(void)
{
    for (int trial = 0; trial < random_trials(20); trial++) {
        const char *path = in_folder("quilt.step");
        taut_surface *whole = shape_random(random_int(1, 4), random_int(1, 4), random_int(0, 1));
        const int nu = taut_basis_span_count(taut_surface_u(whole));
        const int nv = taut_basis_span_count(taut_surface_v(whole));
        taut_model *pieces = NULL, *model = new_model("mm");
        step_probe found;
        CHECK(taut_surface_pieces(whole, &pieces, NULL) == TAUT_OK, "pieces");
        const int count = taut_model_surface_count(pieces);
        for (int i = 0; i < count; i++) {
            taut_surface *copy = NULL;
            CHECK(taut_surface_copy(taut_model_surface(pieces, i), &copy) == TAUT_OK, "copy");
            add(model, turned(copy, random_int(0, 7)));
        }
        write_model(model, path);
        step_probe_file(path, &found);
        CHECK(found.is_read && found.solids == 0 && found.shells == 1 && found.faces == count &&
                  found.free_edges == 2 * (nu + nv) &&
                  found.edges == nu * (nv + 1) + nv * (nu + 1) &&
                  found.vertices == (nu + 1) * (nv + 1),
              "%d x %d: %d shells %d faces %d edges %d free %d vertices", nu, nv, found.shells,
              found.faces, found.edges, found.free_edges, found.vertices);
        CHECK(found.tolerance < 1.01e-7, "tolerance %g", found.tolerance);
        check_file(path, found.edges, found.free_edges);
        check_back(model, path);
        taut_model_free(model);
        taut_model_free(pieces);
        taut_surface_free(whole);
    }
}

/* Poles and seams, of every size and place, as closed forms say: a quarter of each circle is a
 * face. The tube is of degree 2 along, too: it has no name. */
static void test_round(void)
{
    static const int faces[3] = {8, 16, 4}, edges[3] = {12, 32, 12}, vertices[3] = {6, 16, 8};
    const double pi = 3.14159265358979323846;
    for (int trial = 0; trial < random_trials(32); trial++) {
        const int kind = trial % 3, way = random_int(0, 7);
        const double size = random_log(1e-2, 1e5);
        const char *path = in_folder("round.step");
        taut_model *model = new_model("mm");
        step_probe found;
        const double volume = kind == 0   ? 4 * pi / 3 * size * size * size
                              : kind == 1 ? 2 * pi * pi * size * size * size / 16
                                          : 0;
        add(model, turned(kind == 0   ? shape_sphere(size)
                          : kind == 1 ? shape_torus(size, size / 4)
                                      : shape_cylinder(size, 2 * size, 2),
                          way));
        write_model(model, path);
        step_probe_file(path, &found);
        CHECK(found.is_read && found.valid && found.faces == faces[kind] &&
                  found.vertices == vertices[kind] && found.solids == (kind < 2) &&
                  found.closed == (kind < 2) && found.free_edges == (kind < 2 ? 0 : 8),
              "kind %d, way %d, size %g: valid %d, %d solids, closed %d, %d free", kind, way, size,
              found.valid, found.solids, found.closed, found.free_edges);
        CHECK(found.tolerance <= fmax(1.01e-7, 1e-9 * size), "tolerance %g of %g", found.tolerance,
              size);
        check_file(path, edges[kind], kind < 2 ? 0 : 8);
        CHECK_NEAR(kind < 2 ? found.volume : 0, volume, 1e-7 * volume, "kind %d way %d size %g",
                   kind, way, size);
        check_back(model, path);
        taut_model_free(model);
    }
}

/* A tube that has a name on one that is four faces: the ring between them is four edges, in the loop of the first too. */
static void test_ringed(void)
{
    for (int trial = 0; trial < random_trials(16); trial++) {
        const double size = random_log(1e-2, 1e5);
        const char *path = in_folder("ringed.step");
        taut_model *model = new_model("mm");
        step_probe found;
        add(model, turned(shape_cylinder(size, 2 * size, 2), random_int(0, 7)));
        add(model, turned(shape_cylinder(size, -size, 1), random_int(0, 7)));
        write_model(model, path);
        step_probe_file(path, &found);
        CHECK(found.is_read && found.valid && found.shells == 1 && found.faces == 5 &&
                  found.vertices == 9 && found.free_edges == 5,
              "size %g: valid %d, %d shells, %d faces, %d vertices, %d free", size, found.valid,
              found.shells, found.faces, found.vertices, found.free_edges);
        check_file(path, 14, 5);
        taut_model_free(model);
    }
}

enum { DISC, WASHER, CYLINDER, BEND, FORMS };
static const char *const form_names[FORMS] = {"=PLANE(", "=PLANE(", "=CYLINDRICAL_SURFACE(",
                                              "=TOROIDAL_SURFACE("};

/* Points of a circle of this radius about (far, 0, high), in the plane of x and z turned by an angle about z. */
static void put_ring(double radius, double far, double high, double angle, double stretch,
                     double ring[9][3])
{
    static const double circle[9][2] = {{1, 0},   {1, 1},  {0, 1},  {-1, 1}, {-1, 0},
                                        {-1, -1}, {0, -1}, {1, -1}, {1, 0}};
    for (int j = 0; j < 9; j++) {
        const double x = stretch * (far + radius * circle[j][0]);
        ring[j][0] = x * cos(angle);
        ring[j][1] = x * sin(angle);
        ring[j][2] = high + radius * circle[j][1];
    }
}

/* Along u the form is drawn, around goes v; a and b are its radii, `more` a length or an angle. */
static taut_surface *new_form(int kind, double a, double b, double more)
{
    const double pieces = kind == BEND && more > 1.6 ? 2 : 1, step = more / (2 * pieces);
    const int rows = kind == BEND ? 2 * (int)pieces + 1 : 2;
    double points[5][9][3], weights[5][9];
    for (int i = 0; i < rows; i++) {
        const double inner = kind == DISC ? 0 : b;
        if (kind == BEND) {
            put_ring(a, b, 0, i * step, i % 2 == 1 ? 1 / cos(step) : 1, points[i]);
        } else if (kind == CYLINDER) {
            put_ring(a, 0, 0, 0, 1, points[i]);
            for (int j = 0; j < 9; j++) {
                points[i][j][1] = i * more;
            }
        } else {
            put_ring(i == 0 ? inner : a, 0, more, 0, 1, points[i]);
        }
        for (int j = 0; j < 9; j++) {
            weights[i][j] =
                (j % 2 == 1 ? sqrt(0.5) : 1) * (kind == BEND && i % 2 == 1 ? cos(step) : 1);
        }
    }
    const double knots[2][8] = {{0, 0, 0, 1, 1, 1}, {0, 0, 0, 1, 1, 2, 2, 2}};
    const taut_basis_spec arc = {.type = "bspline",
                                 .degree = 2,
                                 .knot_count = pieces > 1 ? 8 : 6,
                                 .knots = knots[pieces > 1]};
    const double around[12] = {0, 0, 0, 1, 1, 3, 3, 4, 4, 5, 5, 5};
    const taut_basis_spec ring = {
        .type = "bspline", .degree = 2, .knot_count = 12, .knots = around};
    taut_basis *u = NULL, *v = NULL;
    CHECK(taut_basis_new(&ring, 9, &v, NULL) == TAUT_OK, "ring");
    if (kind == BEND) {
        CHECK(taut_basis_new(&arc, rows, &u, NULL) == TAUT_OK, "arc");
    } else {
        u = shape_bezier(1, 0, 1);
    }
    return shape_surface(u, v, points[0][0], weights[0]);
}

/* Moved anywhere. */
static taut_surface *moved(taut_surface *surface, double size)
{
    double rotation[3][3], shift[3];
    shape_rotation(rotation);
    for (int k = 0; k < 3; k++) {
        shift[k] = random_in(-5, 5) * size;
    }
    taut_surface *made = shape_moved(surface, 1, (const double(*)[3])rotation, shift);
    taut_surface_free(surface);
    return made;
}

static double area_back(const char *path)
{
    taut_model *back = NULL;
    taut_error error = {.status = TAUT_OK};
    taut_surface_measure measure = {.area = 0};
    CHECK(taut_model_read(path, &back, &error) == TAUT_OK, "%s: %s", path, error.message);
    if (back != NULL) {
        CHECK(taut_measure_surface(taut_model_surface(back, 0), NULL, &measure, NULL) == TAUT_OK,
              "measure");
    }
    taut_model_free(back);
    return measure.area;
}

/* The ellipse that a disc in the plane of x and z is the image of: x times `wide`, then moved by `slant` z, which moves no area. */
static void make_oval(taut_surface **form, double wide, double slant)
{
    const taut_surface *from = *form;
    double points[2][9][3];
    taut_basis *u = NULL, *v = NULL;
    memcpy(points, taut_surface_points(from), sizeof points);
    for (int k = 0; k < 18; k++) {
        points[k / 9][k % 9][0] = wide * points[k / 9][k % 9][0] + slant * points[k / 9][k % 9][2];
    }
    CHECK(taut_basis_copy(taut_surface_u(from), &u) == TAUT_OK &&
              taut_basis_copy(taut_surface_v(from), &v) == TAUT_OK,
          "copy");
    taut_surface *made = shape_surface(u, v, points[0][0], taut_surface_weights(from));
    taut_surface_free(*form);
    *form = made;
}

/* Between ellipses, also such whose half diameters are not across each other: planes with splines for edges, which are exact, and back. */
static void test_ovals(void)
{
    const double pi = 3.14159265358979323846;
    for (int trial = 0; trial < random_trials(24); trial++) {
        const int kind = trial % 2 == 0 ? DISC : WASHER;
        const double a = random_log(1e-2, 1e4), b = a * random_in(0.1, 0.9);
        const double wide = random_in(0.2, 0.9), slant = trial % 3 == 0 ? random_in(-1, 1) : 0;
        const double area = pi * wide * (kind == DISC ? a * a : a * a - b * b);
        const char *path = in_folder("oval.step");
        taut_model *model = new_model("mm");
        taut_step_form form;
        step_probe found;
        taut_surface *oval = new_form(kind, a, b, 0);
        make_oval(&oval, wide, slant);
        oval = turned(oval, random_int(0, 7));
        taut_step_recognise(oval, &form);
        CHECK(form.kind == TAUT_STEP_PLANE && !form.is_round, "kind %d", (int)form.kind);
        add(model, moved(oval, a));
        write_model(model, path);
        step_probe_file(path, &found);
        CHECK(found.is_read && found.valid && found.faces == 1 && found.solids == 0 &&
                  found.free_edges == (kind == DISC ? 1 : 2),
              "oval %d, %g, %g: valid %d, %d free", kind, a, wide, found.valid, found.free_edges);
        CHECK_NEAR(found.area, area, 1e-9 * area, "oval %d, %g, %g, %g", kind, a, wide, slant);
        CHECK_NEAR(area_back(path), area, 1e-9 * area, "oval %d, back", kind);
        char *text = file_bytes(path, NULL);
        CHECK(strstr(text, "=PLANE(") != NULL && strstr(text, "B_SPLINE_SURFACE") == NULL,
              "oval %d, %g, %g", kind, a, wide);
        free(text);
        taut_model_free(model);
    }
}

/* As it is drawn, du x dv points outwards, or along the axis that the ring goes about; what each turn does to that. */
static void check_sense(const taut_surface *surface, int kind, int way)
{
    const int is_plane = kind == DISC || kind == WASHER;
    taut_step_form form;
    taut_step_recognise(surface, &form);
    CHECK(form.inwards == (((way >> 0) ^ (is_plane ? 0 : way >> 1) ^ (way >> 2)) & 1),
          "form %d, turned %d: inwards %d", kind, way, form.inwards);
}

/* What CAD systems have names for is written by these: their areas in closed form, and back. */
static void test_forms(void)
{
    const double pi = 3.14159265358979323846;
    for (int trial = 0; trial < random_trials(40); trial++) {
        const int kind = trial % FORMS;
        const double a = random_log(1e-2, 1e4), more = kind == BEND       ? random_in(0.05, 2.9)
                                                       : kind == CYLINDER ? a * random_log(0.1, 50)
                                                                          : 0;
        const double b = kind == BEND ? a * random_in(1.2, 8) : a * random_in(0.1, 0.9);
        const double area = kind == DISC       ? pi * a * a
                            : kind == WASHER   ? pi * (a * a - b * b)
                            : kind == CYLINDER ? 2 * pi * a * more
                                               : more * b * 2 * pi * a;
        const char *path = in_folder("form.step");
        taut_model *model = new_model("mm");
        step_probe found;
        const int way = random_int(0, 7);
        taut_surface *form = turned(new_form(kind, a, b, more), way);
        check_sense(form, kind, way);
        add(model, moved(form, a));
        write_model(model, path);
        step_probe_file(path, &found);
        CHECK(found.is_read && found.valid && found.faces == 1 && found.solids == 0 &&
                  found.free_edges == (kind == DISC ? 1 : 2),
              "form %d, %g, %g, %g: valid %d, %d free", kind, a, b, more, found.valid,
              found.free_edges);
        CHECK(found.tolerance <= fmax(1.01e-7, 1e-9 * a), "tolerance %g of %g", found.tolerance, a);
        CHECK_NEAR(found.area, area, 1e-9 * area, "form %d, %g, %g, %g", kind, a, b, more);
        CHECK_NEAR(area_back(path), area, 1e-9 * area, "form %d, back", kind);
        char *text = file_bytes(path, NULL);
        CHECK(strstr(text, form_names[kind]) != NULL && strstr(text, "B_SPLINE") == NULL,
              "form %d, %g, %g, %g", kind, a, b, more);
        free(text);
        taut_model_free(model);
    }
}

/* A disc on the ring that a form has at its last row or its first. */
static taut_surface *new_cap(const taut_surface *form, int last)
{
    const int row = last ? taut_basis_count(taut_surface_u(form)) - 1 : 0;
    double points[2][9][3], weights[2][9];
    taut_basis *v = NULL;
    memcpy(points[1], taut_surface_points(form) + (size_t)row * 27, sizeof points[1]);
    for (int j = 0; j < 9; j++) {
        for (int k = 0; k < 3; k++) {
            points[0][j][k] = 0.5 * (points[1][0][k] + points[1][4][k]);
        }
        weights[0][j] = weights[1][j] = j % 2 == 1 ? sqrt(0.5) : 1;
    }
    CHECK(taut_basis_copy(taut_surface_v(form), &v) == TAUT_OK, "copy");
    return shape_surface(shape_bezier(1, 0, 1), v, points[0][0], weights[0]);
}

/* Bends and cylinders with caps, in any sense of u and v: bodies that show their outside. */
static void test_capped(void)
{
    const double pi = 3.14159265358979323846;
    for (int trial = 0; trial < random_trials(32); trial++) {
        const int kind = trial % 2 == 0 ? BEND : CYLINDER;
        const double a = random_log(1e-2, 1e3), b = a * random_in(1.2, 8);
        const double more = kind == BEND ? random_in(0.05, 2.9) : a * random_log(0.1, 50);
        const double volume = pi * a * a * more * (kind == BEND ? b : 1);
        const char *path = in_folder("body.step");
        taut_surface *form = new_form(kind, a, b, more);
        taut_model *model = new_model("mm");
        step_probe found;
        add(model, turned(new_cap(form, 0), random_int(0, 7)));
        add(model, turned(new_cap(form, 1), random_int(0, 7)));
        add(model, turned(form, random_int(0, 7)));
        write_model(model, path);
        step_probe_file(path, &found);
        CHECK(found.is_read && found.valid && found.closed && found.solids == 1 && found.faces == 3,
              "kind %d: valid %d, closed %d, %d solids", kind, found.valid, found.closed,
              found.solids);
        CHECK_NEAR(found.volume, volume, 1e-9 * volume, "kind %d, %g, %g, %g", kind, a, b, more);
        taut_model_free(model);
    }
}

/* A net that is off by more than rounding stays what it is. */
static void test_no_form(void)
{
    for (int kind = 0; kind < FORMS; kind++) {
        const char *path = in_folder("form.step");
        taut_surface *form = new_form(kind, 1, kind == BEND ? 3 : 0.5, kind == DISC ? 0 : 1);
        taut_surface *made = NULL;
        const size_t count = (size_t)taut_basis_count(taut_surface_u(form)) * 9;
        double points[5 * 9 * 3];
        taut_model *model = new_model("mm");
        memcpy(points, taut_surface_points(form), 3 * count * sizeof *points);
        points[3 * (count - 5) + 1] += 1e-11;
        CHECK(taut_surface_new("off", taut_surface_u(form), taut_surface_v(form), points,
                               taut_surface_weights(form), &made, NULL) == TAUT_OK,
              "off");
        taut_surface_free(form);
        add(model, made);
        write_model(model, path);
        char *text = file_bytes(path, NULL);
        CHECK(strstr(text, form_names[kind]) == NULL, "form %d is taken for one", kind);
        free(text);
        check_back(model, path);
        taut_model_free(model);
    }
}

/* What a sheet and its copy are written as: two faces, and no body. */
static void test_no_body(void)
{
    const char *path = in_folder("sheets.step");
    taut_model *model = new_model("mm");
    step_probe found;
    add(model, shape_saddle(0.7));
    add(model, shape_saddle(0.7));
    write_model(model, path);
    step_probe_file(path, &found);
    CHECK(found.is_read && found.valid && found.solids == 0 && found.faces == 2 &&
              found.shells == 2 && found.free_edges == 8,
          "%d solids, %d shells, %d free", found.solids, found.shells, found.free_edges);
    taut_model_free(model);
}

int main(void)
{
    if (!step_probe_is_there()) {
        const char *required = getenv("TAUT_REQUIRE");
        printf("left out: OpenCASCADE is not here: tools/deps.sh test, and build anew\n");
        return required != NULL && strcmp(required, "all") == 0 ? 1 : 77;
    }
    random_seed(20261122);
    folder_make();
    test_boxes();
    test_quilts();
    test_round();
    test_ringed();
    test_forms();
    test_ovals();
    test_capped();
    test_no_form();
    test_no_body();
    folder_remove();
    return check_failures != 0;
}
