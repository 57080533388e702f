/* test_pattern.c -- patterns that do not fit: each claim fails on a model that was changed where it looks, by ten times what it allows,
 * and holds where the change is a tenth. */
#include "certificates.h"
#include "check.h"
#include "cloths.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const char strips[] = "\"seams\": [{ \"across\": [\"v0\", \"v1\"], \"count\": 3 }]";

/* What becomes of a point of an object: `x` is its share of the object's points. */
typedef struct change {
    const char *object;
    double bump[3]; /* times sin(pi x) */
    double scale;   /* of x and y, about the origin; 0: none */
    double turn;    /* the points of the right half turned over: y is that much less */
    int is_crossed; /* nonzero: y times cos(2 pi x) */
} change;

static void move(const change *c, const char *name, size_t count, const double *from, double *to)
{
    for (size_t k = 0; k < count; k++) {
        const double x = (double)k / (double)(count - 1), s = sin(3.14159265358979 * x);
        for (int d = 0; d < 3; d++) {
            to[3 * k + (size_t)d] = from[3 * k + (size_t)d];
            if (strcmp(name, c->object) == 0) {
                to[3 * k + (size_t)d] += (k > 0 && k + 1 < count) * s * c->bump[d];
                to[3 * k + (size_t)d] *= d < 2 && c->scale != 0 ? c->scale : 1;
            }
        }
        if (strcmp(name, c->object) == 0 && x > 0.5) {
            to[3 * k] -= c->turn * (x - 0.5);
        }
        if (strcmp(name, c->object) == 0 && c->is_crossed) {
            to[3 * k + 1] *= cos(2 * 3.14159265358979 * x);
        }
    }
}

static taut_model *changed(const made_cloth *made, const change *c, const taut_record *details)
{
    const taut_model *model = made->model;
    taut_model *copy = NULL;
    taut_model_new(&copy);
    for (int i = 0; i < taut_model_surface_count(model); i++) {
        const taut_surface *from = taut_model_surface(model, i);
        const size_t count = (size_t)taut_basis_count(taut_surface_u(from)) *
                             (size_t)taut_basis_count(taut_surface_v(from));
        double *points = malloc(3 * count * sizeof(double));
        taut_surface *surface = NULL;
        move(c, taut_surface_name(from), count, taut_surface_points(from), points);
        taut_surface_new(taut_surface_name(from), taut_surface_u(from), taut_surface_v(from),
                         points, NULL, &surface, NULL);
        taut_model_add_surface(copy, surface);
        free(points);
    }
    for (int i = 0; i < taut_model_curve_count(model); i++) {
        const taut_curve *from = taut_model_curve(model, i);
        const size_t count = (size_t)taut_basis_count(taut_curve_t(from));
        double *points = malloc(3 * count * sizeof(double));
        taut_curve *curve = NULL;
        move(c, taut_curve_name(from), count, taut_curve_points(from), points);
        taut_curve_new(taut_curve_name(from), taut_curve_t(from), points, NULL, &curve, NULL);
        taut_model_add_curve(copy, curve);
        free(points);
    }
    taut_model_set_details(copy,
                           taut_record_copy(details != NULL ? details : taut_model_details(model)));
    return copy;
}

static taut_verdict judge(const made_cloth *made, const change *c, const taut_record *details,
                          const char *claim)
{
    taut_model *model = changed(made, c, details);
    taut_certificate *proof = NULL;
    taut_error error = {.status = TAUT_OK};
    const taut_status status = taut_certify(model, made->problem, NULL, &proof, &error);
    const taut_verdict verdict = claim_of(proof, claim)->holds;
    CHECK(status == TAUT_OK, "%s: %s", claim, error.message);
    taut_certificate_free(proof);
    taut_model_free(model);
    return verdict;
}

static void test_moved(void)
{
    /* size 2: limits are times that */
    static const struct {
        const char *claim;
        change fine, wrong;
    } rows[] = {
        {"on-surface", {"S1", {0, 0, 2e-7}, 0, 0, 0}, {"S1", {0, 0, 2e-5}, 0, 0, 0}},
        {"geodesic", {"S1", {0, 0, 0}, 0, 0, 0}, {"S1", {1e-5, 0, 0}, 0, 0, 0}},
        {"edges", {"P2.left", {0, 2e-7, 0}, 0, 0, 0}, {"P2.left", {0, 2e-5, 0}, 0, 0, 0}},
        {"seams", {"P2.left", {0, 0, 0}, 1 + 1e-10, 0, 0}, {"P2.left", {0, 0, 0}, 1 + 1e-8, 0, 0}},
        {"stationary", {"P2", {1e-12, 0, 0}, 0, 0, 0}, {"P2", {1e-6, 0, 0}, 0, 0, 0}},
        {"no-fold", {"P1", {0, 0, 0}, 0, 0.1, 0}, {"P1", {0, 0, 0}, 0, 6, 0}},
        {"no-overlap", {"P1.cut", {0, 0, 0}, 0, 0, 0}, {"P1.cut", {0, 0, 0}, 0, 6, 0}},
        {"no-overlap", {"P2.cut", {0, 0, 0}, 0, 0, 0}, {"P2.cut", {0, 0, 0}, 0, 0, 1}},
        {"roll", {"P3.cut", {0, 0, 0}, 0, 0, 0}, {"P3.cut", {0, 3, 0}, 0, 0, 0}},
        {"roll", {"P1.cut", {0, 0, 0}, 1 - 1e-9, 0, 0}, {"P1.cut", {0, 0, 0}, 1.5, 0, 0}},
        {"surface", {"S1", {0, 0, 0}, 0, 0, 0}, {"sail", {0, 0, 1e-9}, 0, 0, 0}},
        {"exhausts", {"S1", {0, 0, 0}, 0, 0, 0}, {"S1", {0, 0, 0}, 0, 0, 0}}};
    made_cloth made = cloth_make(SADDLE, strips);
    CHECK(made.status == TAUT_OK, "%s", made.error.message);
    for (size_t k = 0; k < sizeof rows / sizeof rows[0]; k++) {
        CHECK(judge(&made, &rows[k].fine, NULL, rows[k].claim) == TAUT_TRUE, "%s: hardly moved",
              rows[k].claim);
        if (strcmp(rows[k].claim, "exhausts") != 0) {
            CHECK(judge(&made, &rows[k].wrong, NULL, rows[k].claim) == TAUT_FALSE, "%s: moved",
                  rows[k].claim);
        }
    }
    cloth_free(&made);
}

static void test_told(void)
{
    static const change none = {"", {0, 0, 0}, 0, 0, 0};
    made_cloth made = cloth_make(SADDLE, strips);
    const taut_record *details = taut_model_details(made.model);
    static const char *const rows[][3] = {
        {"seam", "S1", "S2"},  /* both sides of two seams are those of one */
        {"name", "S1", "S9"},  /* a seam that is not there */
        {"edge", "u0", "u1"},  /* one border twice */
        {"name", "P2", "P1"}}; /* one piece twice */
    for (size_t k = 0; k < sizeof rows / sizeof rows[0]; k++) {
        taut_record *other = cloth_edited(details, rows[k][0], rows[k][1], rows[k][2]);
        CHECK(judge(&made, &none, other, "cover") == TAUT_FALSE, "%s %s", rows[k][0], rows[k][1]);
        taut_record_free(other);
    }
    cloth_free(&made);
}

/* "P3.cut" as "P4.cut"; 0: it is no object of P3. */
static int renamed(const char *name, char other[32])
{
    const int is_it = strncmp(name, "P3", 2) == 0 && (name[2] == '\0' || name[2] == '.');
    snprintf(other, 32, "P4%s", is_it ? name + 2 : "");
    return is_it;
}

/* The piece P3 is there twice, the second time as P4. */
static void test_doubled(void)
{
    static const change none = {"", {0, 0, 0}, 0, 0, 0};
    made_cloth made = cloth_make(SADDLE, strips);
    const taut_record *details = taut_model_details(made.model);
    taut_record *doubled = taut_record_new();
    taut_model *model = changed(&made, &none, NULL);
    taut_certificate *proof = NULL;
    taut_error error = {.status = TAUT_OK};
    char name[32];

    for (int i = taut_model_surface_count(model) - 1; i >= 0; i--) {
        const taut_surface *from = taut_model_surface(model, i);
        taut_surface *surface = NULL;
        if (renamed(taut_surface_name(from), name)) {
            taut_surface_new(name, taut_surface_u(from), taut_surface_v(from),
                             taut_surface_points(from), NULL, &surface, NULL);
            taut_model_add_surface(model, surface);
        }
    }
    for (int i = taut_model_curve_count(model) - 1; i >= 0; i--) {
        const taut_curve *from = taut_model_curve(model, i);
        taut_curve *curve = NULL;
        if (renamed(taut_curve_name(from), name)) {
            taut_curve_new(name, taut_curve_t(from), taut_curve_points(from), NULL, &curve, NULL);
            taut_model_add_curve(model, curve);
        }
    }
    for (size_t k = 0; k < taut_record_count(details); k++) {
        taut_record *item = taut_record_copy(taut_record_at(details, k));
        if (strcmp(taut_record_key(details, k), "pieces") == 0) {
            taut_record *other = cloth_edited(taut_record_at(item, 2), "name", "P3", "P4");
            taut_record_add_record(item, NULL, other);
            taut_record_free(other);
        }
        taut_record_add_record(doubled, taut_record_key(details, k), item);
        taut_record_free(item);
    }
    taut_model_set_details(model, doubled);
    CHECK(taut_certify(model, made.problem, NULL, &proof, &error) == TAUT_OK, "%s", error.message);
    CHECK(claim_of(proof, "cover")->holds == TAUT_FALSE, "a piece twice");
    CHECK(claim_of(proof, "cover")->residual == 4, "along S2, u1, v0 and v1: %g",
          claim_of(proof, "cover")->residual);
    taut_certificate_free(proof);
    taut_model_free(model);
    cloth_free(&made);
}

/* Pieces that meet on a seam: parts that leave a gap or lie over each other tile nothing; one of two that is longer is told; and a
 * parameter line that nobody asked for. */
static void test_joints(void)
{
    static const change none = {"", {0, 0, 0}, 0, 0, 0};
    static const change longer = {"P2-2.left", {0, 0, 0}, 1 + 1e-7, 0, 0};
    static const char butts[] = "\"seams\": [{ \"across\": [\"v0\", \"v1\"], \"count\": 3 }, { "
                                "\"butt\": \"P2\", \"at\": 0.375 }]";
    static const char *const rows[][3] = {{"part", "0.375", "0.36"}, /* the butt is elsewhere */
                                          {"seam", "S3", "S2"}, /* one hand of a seam, once more */
                                          {"kind", "geodesic", "line"}};
    made_cloth made = cloth_make(SADDLE, butts);
    CHECK(made.status == TAUT_OK, "%s", made.error.message);
    CHECK(judge(&made, &none, NULL, "cover") == TAUT_TRUE, "as it is");
    CHECK(judge(&made, &longer, NULL, "seams") == TAUT_FALSE, "one part is longer");
    for (size_t k = 0; k < sizeof rows / sizeof rows[0]; k++) {
        taut_record *other =
            cloth_edited(taut_model_details(made.model), rows[k][0], rows[k][1], rows[k][2]);
        CHECK(judge(&made, &none, other, "cover") == TAUT_FALSE, "%s %s", rows[k][0], rows[k][1]);
        taut_record_free(other);
    }
    cloth_free(&made);
}

/* Ends that are to be straight, of a pattern whose ends are free. */
static void test_straight(void)
{
    static const char *const texts[2] = {
        "\"seams\": [{ \"across\": [\"v0\", \"v1\"], \"count\": 3 }]",
        "\"seams\": [{ \"across\": [\"v0\", \"v1\"], \"count\": 3 }], \"ends\": \"straight\""};
    made_cloth bent = cloth_make(SADDLE, texts[0]), straight = cloth_make(SADDLE, texts[1]);
    taut_certificate *proof = NULL;
    taut_error error = {.status = TAUT_OK};
    CHECK(bent.status == TAUT_OK && straight.status == TAUT_OK, "%s", straight.error.message);
    CHECK(claim_of(straight.proof, "ends")->holds == TAUT_TRUE, "as it is");
    CHECK(taut_certify(bent.model, straight.problem, NULL, &proof, &error) == TAUT_OK, "%s",
          error.message);
    CHECK(claim_of(proof, "ends")->holds == TAUT_FALSE, "of ends that are free");
    taut_certificate_free(proof);
    cloth_free(&bent);
    cloth_free(&straight);
}

/* Next to a tip det J is 0: what is proved is how it grows. A tip that is pulled apart is none, and then it folds. */
static void test_tips(void)
{
    static const change none = {"", {0, 0, 0}, 0, 0, 0};
    static const change turned = {"P1", {0, 0, 0}, 0, 6, 0};
    made_cloth made = cloth_make(SADDLE, "\"seams\": [{ \"geodesic\": [[0, 0], [0.6, 1]] }]");
    CHECK(made.status == TAUT_OK, "%s", made.error.message);
    CHECK(judge(&made, &none, NULL, "no-fold") == TAUT_TRUE, "as it is");
    CHECK(judge(&made, &none, NULL, "stationary") == TAUT_TRUE, "as it is");
    CHECK(judge(&made, &none, NULL, "stable") == TAUT_TRUE, "as it is");
    CHECK(judge(&made, &turned, NULL, "no-fold") == TAUT_FALSE, "turned over");
    cloth_free(&made);
}

/* A maximum or a saddle of the energy is none that stands still: the Hessian says so. */
static void test_true_length(void)
{
    static const change longer = {"P2.left", {0, 0, 0}, 1 + 1e-8, 0, 0};
    static const change fine = {"P2.left", {0, 0, 0}, 1 + 1e-10, 0, 0};
    made_cloth made = cloth_make(SADDLE, "\"seams\": [{ \"across\": [\"v0\", \"v1\"], \"count\": "
                                         "3 }], \"seam_length\": \"true\"");
    CHECK(made.status == TAUT_OK, "%s", made.error.message);
    CHECK(judge(&made, &fine, NULL, "lengths") == TAUT_TRUE, "as long");
    CHECK(judge(&made, &longer, NULL, "lengths") == TAUT_FALSE, "longer");
    cloth_free(&made);
}

/* A border that is held; and one that is not to be. */
static void test_held(void)
{
    static const change longer = {"P1.start", {0, 0, 0}, 1 + 1e-8, 0, 0};
    static const change fine = {"P1.start", {0, 0, 0}, 1 + 1e-10, 0, 0};
    made_cloth made = cloth_make(SADDLE, "\"seams\": [{ \"across\": [\"v0\", \"v1\"], \"count\": "
                                         "2 }], \"held\": [\"v0\"]");
    made_cloth other = cloth_make(SADDLE, "\"seams\": [{ \"across\": [\"v0\", \"v1\"], \"count\": "
                                          "2 }], \"held\": [\"v1\"]");
    CHECK(made.status == TAUT_OK && other.status == TAUT_OK, "%s", made.error.message);
    CHECK(judge(&made, &fine, NULL, "lengths") == TAUT_TRUE, "as long");
    CHECK(judge(&made, &longer, NULL, "lengths") == TAUT_FALSE, "longer");
    taut_problem *own = made.problem;
    made.problem = other.problem;
    CHECK(judge(&made, &fine, NULL, "lengths") == TAUT_FALSE, "another edge was to be held");
    made.problem = own;
    cloth_free(&made);
    cloth_free(&other);
}

/* A developed piece that is strained, by details of another: the claim is about what is there. */
static void test_isometric(void)
{
    static const char plane[] =
        "{ \"taut\": 1, \"surfaces\": [{ \"name\": \"p\", \"u\": { \"type\": \"bezier\", "
        "\"degree\": 2 }, \"v\": { \"type\": \"bezier\", \"degree\": 1 }, \"points\": [[[0, 0, 0], "
        "[0, 2, 0]], [[0.5, 0, 0], [0.5, 2, 0]], [[1, 0, 0], [1.5, 2, 0]]] }] }";
    static const change none = {"", {0, 0, 0}, 0, 0, 0};
    static const change wide = {"P1", {0, 1e-9, 0}, 0, 0, 0};
    made_cloth made =
        cloth_make(plane, "\"seams\": [{ \"across\": [\"v0\", \"v1\"], \"count\": 2 }]");
    CHECK(made.status == TAUT_OK, "%s", made.error.message);
    CHECK(judge(&made, &none, NULL, "isometric") == TAUT_TRUE, "a plane");
    CHECK(judge(&made, &wide, NULL, "isometric") == TAUT_FALSE, "strained");
    cloth_free(&made);
}

/* A line to cut along that is not where it is to be; and what is left that was not asked for. */
static void test_allowance(void)
{
    static const change none = {"", {0, 0, 0}, 0, 0, 0};
    static const change fine = {"P2.cut", {0, 0, 0}, 1 + 2e-9, 0, 0};
    static const change wide = {"P2.cut", {0, 0, 0}, 1 + 2e-6, 0, 0};
    char members[256];
    snprintf(members, sizeof members, "%s, \"allowance\": { \"seam\": 0.02, \"border\": 0.05 }",
             strips);
    made_cloth made = cloth_make(SADDLE, members), other = cloth_make(SADDLE, strips);
    CHECK(made.status == TAUT_OK, "%s", made.error.message);
    CHECK(judge(&made, &fine, NULL, "allowance") == TAUT_TRUE, "hardly moved");
    CHECK(judge(&made, &wide, NULL, "allowance") == TAUT_FALSE, "moved");
    taut_problem *own = made.problem;
    made.problem = other.problem;
    CHECK(judge(&made, &none, NULL, "allowance") == TAUT_FALSE, "none was asked for");
    made.problem = own;
    cloth_free(&made);
    cloth_free(&other);
}

/* What is left on the right of a seam is not what was asked for on its left, nor what others have. */
static void test_seams_of_their_own(void)
{
    static const char *const asked[] = {"\"S1\": [0.03, 0.01]", "\"S1\": [0.01, 0.03]",
                                        "\"S2\": [0.03, 0.01]", "\"S1\": 0.03", "\"seam\": 0.02"};
    static const change none = {"", {0, 0, 0}, 0, 0, 0};
    made_cloth made[5];
    for (int k = 0; k < 5; k++) {
        char members[256];
        snprintf(members, sizeof members, "%s, \"allowance\": { %s }", strips, asked[k]);
        made[k] = cloth_make(SADDLE, members);
        CHECK(made[k].status == TAUT_OK, "%s", made[k].error.message);
    }
    taut_problem *own = made[0].problem;
    for (int k = 0; k < 5; k++) {
        made[0].problem = k == 0 ? own : made[k].problem;
        CHECK(judge(&made[0], &none, NULL, "allowance") == (k == 0 ? TAUT_TRUE : TAUT_FALSE), "%s",
              asked[k]);
    }
    made[0].problem = own;
    for (int k = 0; k < 5; k++) {
        cloth_free(&made[k]);
    }
}

/* Of a surface with kinks in its metric all is there too: its area by cells that end at its knots. */
static void test_kinks(void)
{
    static const char kinks[] =
        "{\"taut\": 1, \"surfaces\": [{\"name\": \"s\", \"u\": {\"type\": \"bspline\", "
        "\"degree\": 2, \"count\": 5}, \"v\": {\"type\": \"bspline\", \"degree\": 2, \"count\": "
        "4}, \"points\": [[[0.0, 0.0, 1.009], [0.0, 0.6667, 0.0191], [0.0, 1.3333, -0.3812], "
        "[0.0, 2.0, -1.0046]], [[0.5, 0.0, 0.2805], [0.5, 0.6667, 0.1916], [0.5, 1.3333, "
        "0.0782], [0.5, 2.0, -0.5097]], [[1.0, 0.0, -0.0245], [1.0, 0.6667, 0.0607], [1.0, "
        "1.3333, -0.008], [1.0, 2.0, 0.1242]], [[1.5, 0.0, -0.4849], [1.5, 0.6667, -0.1948], "
        "[1.5, 1.3333, 0.3088], [1.5, 2.0, 0.4965]], [[2.0, 0.0, -1.3731], [2.0, 0.6667, "
        "-0.6526], [2.0, 1.3333, 0.3053], [2.0, 2.0, 0.9714]]]}]}";
    made_cloth made = cloth_make(kinks, "\"seams\": [{ \"across\": [\"v0\", \"v1\"], \"count\": "
                                        "1 }], \"cloth\": { \"material\": \"pvc-pes\" }");
    CHECK(made.status == TAUT_OK, "%s", made.error.message);
    const taut_claim *claim = claim_of(made.proof, "exhausts");
    CHECK(claim->holds == TAUT_TRUE && claim->residual < 1e-10 && claim->limit < 1e-9,
          "%g, limit %g", claim->residual, claim->limit);
    cloth_free(&made);
}

/* A pattern beside another document than its own. */
static taut_verdict judge_by(const made_cloth *made, const char *members, const char *claim)
{
    static const change none = {"", {0, 0, 0}, 0, 0, 0};
    made_cloth other = cloth_make(SADDLE, members), mixed = *made;
    CHECK(other.problem != NULL, "%s", other.error.message);
    mixed.problem = other.problem;
    const taut_verdict verdict = judge(&mixed, &none, NULL, claim);
    cloth_free(&other);
    return verdict;
}

/* A pattern whose details tell another number of a piece or a seam. */
static taut_verdict judge_number(const made_cloth *made, const char *list, const char *name,
                                 const char *path, double factor, const char *claim)
{
    static const change none = {"", {0, 0, 0}, 0, 0, 0};
    const double value = cloth_number(made, list, name, path);
    char old[32], new[32];
    snprintf(old, sizeof old, "%.17g", value);
    snprintf(new, sizeof new, "%.17g", factor * value);
    taut_record *details = cloth_edited(taut_model_details(made->model), "part", old, new);
    const taut_verdict verdict = judge(made, &none, details, claim);
    taut_record_free(details);
    return verdict;
}

/* Seams, the thread and shares are held against the document, numbers that are told against the model. */
static void test_asked(void)
{
    static const char true_seams[] =
        "\"seams\": [{ \"across\": [\"v0\", \"v1\"], \"count\": 3 }], \"compensation\": { "
        "\"warp\": 0.02, \"weft\": 0.045 }, \"seam_length\": \"true\"";
    static const char *const others[][2] = {
        {"layout", "\"seams\": [{ \"across\": [\"v0\", \"v1\"], \"count\": 2 }]"},
        {"layout", "\"seams\": [{ \"across\": [\"v0\", \"v1\"], \"count\": 4 }]"},
        {"layout", "\"seams\": [{ \"across\": [\"v0\", \"v1\"], \"count\": 3, \"by\": "
                   "\"parameter\" }]"},
        {"layout", "\"seams\": [{ \"geodesic\": [[0.3, 0], [0.3, 1]] }, { \"geodesic\": [[0.7, 0], "
                   "[0.7, 1]] }]"},
        {"roll", "\"seams\": [{ \"across\": [\"v0\", \"v1\"], \"count\": 3 }], \"cloth\": { "
                 "\"length\": 2 }"},
        {"thread", "\"seams\": [{ \"across\": [\"v0\", \"v1\"], \"count\": 3 }], \"cloth\": { "
                   "\"thread\": \"across\" }"}};
    made_cloth made = cloth_make(SADDLE, strips), held = cloth_make(SADDLE, true_seams);
    for (size_t k = 0; k < sizeof others / sizeof others[0]; k++) {
        CHECK(judge_by(&made, strips, others[k][0]) == TAUT_TRUE, "%s", others[k][0]);
        CHECK(judge_by(&made, others[k][1], others[k][0]) == TAUT_FALSE, "%s", others[k][1]);
    }
    CHECK(judge_number(&made, "pieces", "P1", "flat_area", 1 + 1e-11, "details") == TAUT_TRUE,
          "P1");
    CHECK(judge_number(&made, "pieces", "P1", "flat_area", 1 + 1e-8, "details") == TAUT_FALSE,
          "P1");
    CHECK(judge_number(&made, "pieces", "P2", "edges/left/flat_length", 1 + 1e-8, "details") ==
              TAUT_FALSE,
          "P2");
    CHECK(judge_number(&made, "pieces", "P2", "area", 1.1, "details") == TAUT_FALSE, "P2");
    CHECK(judge_number(&held, "seams", "S1", "compensation", 1.001, "compensation") == TAUT_TRUE,
          "S1");
    CHECK(judge_number(&held, "seams", "S1", "compensation", 1.02, "compensation") == TAUT_FALSE,
          "S1");
    /* an edge that yields, or does not, or another one */
    static const char fading[] =
        "\"seams\": [{ \"across\": [\"v0\", \"v1\"], \"count\": 3 }], \"compensation\": { "
        "\"warp\": 0.02, \"weft\": 0.045 }, \"decompensate\": [{ \"edge\": \"v0\", \"length\": 0.3 "
        "}]";
    static const char *const not_fading[] = {
        "\"seams\": [{ \"across\": [\"v0\", \"v1\"], \"count\": 3 }], \"compensation\": { "
        "\"warp\": 0.02, \"weft\": 0.045 }",
        "\"seams\": [{ \"across\": [\"v0\", \"v1\"], \"count\": 3 }], \"compensation\": { "
        "\"warp\": 0.02, \"weft\": 0.045 }, \"decompensate\": [{ \"edge\": \"v0\", \"length\": "
        "0.301 }]",
        "\"seams\": [{ \"across\": [\"v0\", \"v1\"], \"count\": 3 }], \"compensation\": { "
        "\"warp\": 0.02, \"weft\": 0.045 }, \"decompensate\": [{ \"edge\": \"v0\", \"length\": "
        "0.3, \"component\": \"both\" }]"};
    made_cloth fades = cloth_make(SADDLE, fading);
    CHECK(judge_by(&fades, fading, "stationary") == TAUT_TRUE, "fades out");
    for (size_t k = 0; k < sizeof not_fading / sizeof not_fading[0]; k++) {
        CHECK(judge_by(&fades, not_fading[k], "stationary") == TAUT_FALSE, "%s", not_fading[k]);
    }
    cloth_free(&fades);
    /* more seams than the document's */
    made_cloth lines = cloth_make(SADDLE, "\"seams\": [{ \"line\": { \"u\": [0.3, 0.7] } }]");
    CHECK(judge_by(&lines, "\"seams\": [{ \"line\": { \"u\": 0.3 } }]", "layout") == TAUT_FALSE,
          "one line of two");
    cloth_free(&lines);
    cloth_free(&made);
    cloth_free(&held);
}

int main(void)
{
    test_allowance();
    test_seams_of_their_own();
    test_moved();
    test_told();
    test_doubled();
    test_joints();
    test_tips();
    test_straight();
    test_true_length();
    test_held();
    test_isometric();
    test_kinks();
    test_asked();
    return check_failures != 0;
}
