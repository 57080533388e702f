/* test_figures.c -- no number, and no word, of laths, nodes and panels is believed: each one changed alone makes a claim false. */
#include "certificates.h"
#include "check.h"
#include "nets.h"

#include <math.h>
#include <string.h>

/* The leaf that is changed, counted as they are met, and what it was. */
typedef struct change {
    int at, count;
    double factor;
    const char *key;
} change;

/* What nobody vouches for, how many steps it took; and where the largest curvatures are, which hardly change beside there. */
static int is_free(const char *key)
{
    return key != NULL && (strcmp(key, "steps") == 0 || strcmp(key, "max_at") == 0);
}

static void copy_changed(const taut_record *from, const char *key, int inside, taut_record *to,
                         const char *name, change *c)
{
    const taut_record_kind kind = taut_record_kind_of(from);
    const int is_list = kind == TAUT_RECORD_LIST, is_object = kind == TAUT_RECORD_OBJECT;
    if (is_list || is_object) {
        taut_record *part =
            is_list ? taut_record_add_list(to, name) : taut_record_add_object(to, name);
        for (size_t k = 0; k < taut_record_count(from); k++) {
            const char *member = is_object ? taut_record_key(from, k) : NULL;
            copy_changed(taut_record_at(from, k), member != NULL ? member : key, inside, part,
                         member, c);
        }
        return;
    }
    const int is_it = inside && !is_free(key) &&
                      (kind == TAUT_RECORD_NUMBER || kind == TAUT_RECORD_TEXT) &&
                      c->count++ == c->at;
    if (!is_it) {
        taut_record_add_record(to, name, from);
        return;
    }
    c->key = key;
    if (kind == TAUT_RECORD_TEXT) {
        taut_record_add_text(to, name, "another");
    } else {
        taut_record_add_number(to, name, taut_record_number(from) * c->factor + 1e-2);
    }
}

/* The pieces with the outlines of their slots to change. */
static void copy_pieces(const taut_record *pieces, taut_record *details, change *c)
{
    taut_record *list = taut_record_add_list(details, "pieces");
    for (size_t k = 0; k < taut_record_count(pieces); k++) {
        const taut_record *piece = taut_record_at(pieces, k);
        taut_record *to = taut_record_add_object(list, NULL);
        for (size_t i = 0; i < taut_record_count(piece); i++) {
            const char *key = taut_record_key(piece, i);
            copy_changed(taut_record_at(piece, i), key, strcmp(key, "slots") == 0, to, key, c);
        }
    }
}

static taut_record *details_changed(const taut_record *old, change *c)
{
    taut_record *details = taut_record_new();
    for (size_t k = 0; k < taut_record_count(old); k++) {
        const char *key = taut_record_key(old, k);
        const int inside = strcmp(key, "laths") == 0 || strcmp(key, "nodes") == 0 ||
                           strcmp(key, "panels") == 0 || strcmp(key, "panel_count") == 0 ||
                           strcmp(key, "max_planarity") == 0 || strcmp(key, "kinks") == 0 ||
                           strcmp(key, "singular_points") == 0 ||
                           strcmp(key, "hyperbolic_share") == 0;
        if (strcmp(key, "pieces") == 0) {
            copy_pieces(taut_record_at(old, k), details, c);
        } else {
            copy_changed(taut_record_at(old, k), key, inside, details, key, c);
        }
    }
    return details;
}

static void check_all(const char *what, made_net *made)
{
    int held = 0, tried = 0;

    CHECK(made->status == TAUT_OK, "%s: %s", what, made->error.message);
    CHECK(taut_certificate_holds(made->proof) == TAUT_TRUE, "%s as made", what);
    CHECK(claim_of(made->proof, "figures")->residual < 1e-7, "%s: %g at %s", what,
          claim_of(made->proof, "figures")->residual, claim_of(made->proof, "figures")->where);
    for (int at = 0;; at++) {
        change c = {.at = at, .factor = 1.001};
        taut_model *model = NULL;
        taut_certificate *proof = NULL;
        taut_error error = {.status = TAUT_OK};
        taut_record *details = details_changed(taut_model_details(made->model), &c);
        if (c.count <= at) {
            taut_record_free(details);
            break;
        }
        CHECK(taut_model_copy(made->model, &model) == TAUT_OK, "copy");
        taut_model_set_details(model, details);
        const taut_status status = taut_certify(model, made->problem, NULL, &proof, &error);
        const int fails = status != TAUT_OK || taut_certificate_holds(proof) == TAUT_FALSE;
        CHECK(fails, "%s: %s (%d) is believed", what, c.key, at);
        held += !fails;
        tried++;
        taut_certificate_free(proof);
        taut_model_free(model);
    }
    printf("%s: %d figures changed, %d believed\n", what, tried, held);
    net_free(made);
}

/* z = 0.4 x^2 + 0.25 y^3: K < 0 where y < 0. */
static const char *const cusps =
    "{ \"taut\": 1, \"surfaces\": [{ \"u\": { \"type\": \"bezier\", \"degree\": 2, \"range\": [-1, "
    "1] }, "
    "\"v\": { \"type\": \"bezier\", \"degree\": 3, \"range\": [-1, 1] }, \"points\": ["
    "[[-1, -1, 0.15], [-1, -0.3333333333333333, 0.65], [-1, 0.3333333333333333, 0.15], [-1, 1, "
    "0.65]], "
    "[[0, -1, -0.65], [0, -0.3333333333333333, -0.15], [0, 0.3333333333333333, -0.65], [0, 1, "
    "-0.15]], "
    "[[1, -1, 0.15], [1, -0.3333333333333333, 0.65], [1, 0.3333333333333333, 0.15], [1, 1, 0.65]]] "
    "}] }";

/* K < 0 on half of the surface alone, though details say everywhere. */
static void check_share(void)
{
    made_net made = net_make("asymptotic", cusps, "\"seeds\": [{ \"at\": [0.2, -0.5] }]");
    const taut_record *old = taut_model_details(made.model);
    taut_record *details = taut_record_new();
    taut_model *model = NULL;
    taut_certificate *proof = NULL;

    CHECK(taut_certificate_holds(made.proof) == TAUT_TRUE, "as made");
    CHECK(fabs(taut_record_number(taut_record_get(old, "hyperbolic_share")) - 0.5) < 0.01, "share");
    for (size_t k = 0; k < taut_record_count(old); k++) {
        const char *key = taut_record_key(old, k);
        if (strcmp(key, "hyperbolic_share") == 0) {
            taut_record_add_number(details, key, 1);
        } else {
            taut_record_add_record(details, key, taut_record_at(old, k));
        }
    }
    CHECK(taut_model_copy(made.model, &model) == TAUT_OK, "copy");
    taut_model_set_details(model, details);
    CHECK(taut_certify(model, made.problem, NULL, &proof, NULL) == TAUT_OK, "certify");
    CHECK(claim_of(proof, "figures")->holds == TAUT_FALSE, "a share of 1 is believed");
    taut_certificate_free(proof);
    taut_model_free(model);
    net_free(&made);
}

/* The last panel left out, and all else as it is then. */
static void check_fewer(const made_net *made)
{
    const taut_record *old = taut_model_details(made->model);
    const taut_record *panels = taut_record_get(old, "panels");
    taut_record *details = taut_record_new();
    taut_model *model = NULL;
    taut_certificate *proof = NULL;
    const size_t count = taut_record_count(panels);
    double largest = 0;

    CHECK(count > 1, "%d panels", (int)count);
    for (size_t i = 0; i + 1 < count; i++) {
        largest = fmax(largest,
                       taut_record_number(taut_record_get(taut_record_at(panels, i), "planarity")));
    }
    for (size_t k = 0; k < taut_record_count(old); k++) {
        const char *key = taut_record_key(old, k);
        if (strcmp(key, "panel_count") == 0) {
            taut_record_add_number(details, key, (double)count - 1);
        } else if (strcmp(key, "max_planarity") == 0) {
            taut_record_add_number(details, key, largest);
        } else if (strcmp(key, "panels") == 0) {
            taut_record *list = taut_record_add_list(details, key);
            for (size_t i = 0; i + 1 < count; i++) {
                taut_record_add_record(list, NULL, taut_record_at(panels, i));
            }
        } else {
            taut_record_add_record(details, key, taut_record_at(old, k));
        }
    }
    CHECK(taut_model_copy(made->model, &model) == TAUT_OK, "copy");
    taut_model_set_details(model, details);
    CHECK(taut_certify(model, made->problem, NULL, &proof, NULL) == TAUT_OK, "fewer");
    CHECK(claim_of(proof, "figures")->holds == TAUT_FALSE, "a panel less");
    taut_certificate_free(proof);
    taut_model_free(model);
}

/* Another list in the place of one of details. */
static int holds_with(const made_net *made, const char *key, const taut_record *list)
{
    const taut_record *old = taut_model_details(made->model);
    taut_record *details = taut_record_new();
    taut_model *model = NULL;
    taut_certificate *proof = NULL;

    for (size_t k = 0; k < taut_record_count(old); k++) {
        const char *member = taut_record_key(old, k);
        taut_record_add_record(details, member,
                               strcmp(member, key) == 0 ? list : taut_record_at(old, k));
    }
    CHECK(taut_model_copy(made->model, &model) == TAUT_OK, "copy");
    taut_model_set_details(model, details);
    CHECK(taut_certify(model, made->problem, NULL, &proof, NULL) == TAUT_OK, "%s", key);
    const int holds = taut_certificate_holds(proof) != TAUT_FALSE;
    taut_certificate_free(proof);
    taut_model_free(model);
    return holds;
}

/* What is in a list of details twice, or is no longer in it, is not believed. */
static void check_counts(const char *what, const made_net *made, const char *key)
{
    const taut_record *old = taut_record_get(taut_model_details(made->model), key);
    const size_t count = taut_record_count(old);
    taut_record *twice = taut_record_new(), *fewer = taut_record_new();
    taut_record *longer = taut_record_add_list(twice, key),
                *shorter = taut_record_add_list(fewer, key);

    CHECK(count > 0, "%s has %s", what, key);
    for (size_t k = 0; k <= count; k++) {
        taut_record_add_record(longer, NULL, taut_record_at(old, k < count ? k : 0));
        if (k > 0 && k < count) {
            taut_record_add_record(shorter, NULL, taut_record_at(old, k));
        }
    }
    CHECK(!holds_with(made, key, shorter), "%s: fewer %s", what, key);
    CHECK(!holds_with(made, key, longer), "%s: one of %s twice", what, key);
    taut_record_free(twice);
    taut_record_free(fewer);
}

/* A node that is there twice, also in the lists of both of its laths. */
static void check_node_twice(const made_net *made)
{
    const taut_record *old = taut_model_details(made->model);
    const taut_record *nodes = taut_record_get(old, "nodes");
    const char *name = taut_record_text(taut_record_get(taut_record_at(nodes, 0), "node"));
    taut_record *whole = taut_record_new(), *list = taut_record_add_list(whole, "laths");

    for (size_t k = 0; k < taut_record_count(taut_record_get(old, "laths")); k++) {
        const taut_record *lath = taut_record_at(taut_record_get(old, "laths"), k);
        taut_record *to = taut_record_add_object(list, NULL);
        for (size_t i = 0; i < taut_record_count(lath); i++) {
            const char *key = taut_record_key(lath, i);
            const taut_record *from = taut_record_at(lath, i);
            if (strcmp(key, "nodes") != 0) {
                taut_record_add_record(to, key, from);
                continue;
            }
            taut_record *passed = taut_record_add_list(to, key);
            for (size_t j = 0; j < taut_record_count(from); j++) {
                taut_record_add_record(passed, NULL, taut_record_at(from, j));
            }
            for (size_t j = 0; j < taut_record_count(from); j++) {
                const taut_record *pair = taut_record_at(from, j);
                if (strcmp(taut_record_text(taut_record_at(pair, 0)), name) == 0) {
                    taut_record_add_record(passed, NULL, pair);
                }
            }
        }
    }
    list = taut_record_add_list(whole, "nodes");
    for (size_t k = 0; k <= taut_record_count(nodes); k++) {
        taut_record_add_record(list, NULL,
                               taut_record_at(nodes, k < taut_record_count(nodes) ? k : 0));
    }
    CHECK(!holds_with(made, "laths", taut_record_get(whole, "laths")), "lists alone");
    taut_model *model = NULL;
    taut_record *details = taut_record_new();
    taut_certificate *proof = NULL;
    for (size_t k = 0; k < taut_record_count(old); k++) {
        const char *key = taut_record_key(old, k);
        const taut_record *other = taut_record_get(whole, key);
        taut_record_add_record(details, key, other != NULL ? other : taut_record_at(old, k));
    }
    CHECK(taut_model_copy(made->model, &model) == TAUT_OK, "copy");
    taut_model_set_details(model, details);
    CHECK(taut_certify(model, made->problem, NULL, &proof, NULL) == TAUT_OK, "twice");
    CHECK(claim_of(proof, "figures")->holds == TAUT_FALSE, "a node twice");
    taut_certificate_free(proof);
    taut_model_free(model);
    taut_record_free(whole);
}

/* A node of the border that is told to be none, and one that is none and told to be. */
static void check_borders(const made_net *made)
{
    const taut_record *nodes = taut_record_get(taut_model_details(made->model), "nodes");
    int kinds[2] = {0, 0};
    for (size_t k = 0; k < taut_record_count(nodes); k++) {
        const int was = taut_record_bool(taut_record_get(taut_record_at(nodes, k), "border"));
        taut_record *whole = taut_record_new(), *list = taut_record_add_list(whole, "nodes");
        for (size_t i = 0; i < taut_record_count(nodes); i++) {
            const taut_record *node = taut_record_at(nodes, i);
            taut_record *to = taut_record_add_object(list, NULL);
            for (size_t j = 0; j < taut_record_count(node); j++) {
                if (i != k || strcmp(taut_record_key(node, j), "border") != 0) {
                    taut_record_add_record(to, taut_record_key(node, j), taut_record_at(node, j));
                }
            }
            if (i == k && !was) {
                taut_record_add_bool(to, "border", 1);
            }
        }
        CHECK(!holds_with(made, "nodes", list), "border of node %zu", k);
        kinds[was]++;
        taut_record_free(whole);
    }
    CHECK(kinds[0] > 0 && kinds[1] > 0, "%d inside, %d on the border", kinds[0], kinds[1]);
}

/* Curves of a lattice, or of a line, touch the window alone, in the middle of two edges, and are no laths. Of a place elsewhere, of the
 * other family there, or of one where the net does not exist, that is not true. */
static void check_short(void)
{
    static const double heights[] = {0,    0.3, 0.3, 0,    -0.3, 0.1, 0.1, -0.3,
                                     -0.3, 0.1, 0.1, -0.3, 0,    0.3, 0.3, 0};
    static const struct {
        const char *family;
        double at[2];
        int is_true;
    } tries[] = {{"max", {0.5, 0}, 1}, {"max", {0.5, 1}, 1},    {"min", {0.5, 0}, 0},
                 {"max", {0, 0.5}, 0}, {"max", {0.5, 1e-4}, 0}, {"max", {0.4, 0}, 0}};
    const int degree[2] = {3, 3}, count[2] = {4, 4};
    char surface[4096];

    net_heights(degree, count, heights, surface, sizeof surface);
    made_net made = net_make("principal", surface, "\"seeds\": [{ \"cells\": 4 }]");
    CHECK(made.status == TAUT_OK && taut_certificate_holds(made.proof) == TAUT_TRUE, "touching: %s",
          made.error.message);
    CHECK(net_count(&made, "laths") == 8, "%d curves", net_count(&made, "laths"));
    CHECK(net_count(&made, "left_out") == 2, "%d left out", net_count(&made, "left_out"));
    for (size_t i = 0; made.status == TAUT_OK && i < sizeof tries / sizeof *tries; i++) {
        taut_record *whole = taut_record_new(), *list = taut_record_add_list(whole, "left_out");
        taut_record *to = taut_record_add_object(list, NULL);
        taut_record_add_text(to, "family", tries[i].family);
        taut_record_add_numbers(to, "at", 2, tries[i].at);
        taut_record_add_text(to, "reason", "short");
        CHECK(holds_with(&made, "left_out", list) == tries[i].is_true, "short %zu", i);
        taut_record_free(whole);
    }
    net_free(&made);
    made = net_make(
        "principal", surface,
        "\"seeds\": [{ \"line\": [[2e-8, 0], [1, 0]], \"count\": 3, \"by\": \"parameter\" }]");
    CHECK(made.status == TAUT_OK && taut_certificate_holds(made.proof) == TAUT_TRUE, "line: %s",
          made.error.message);
    CHECK(net_count(&made, "left_out") == 1, "line: %d left out", net_count(&made, "left_out"));
    net_free(&made);
}

/* Another reason, another family, a place beside the edge of its seed. */
static void check_left_out(const made_net *made)
{
    static const char *const words[] = {"along", "flat", "singular", "crease", "moved", "max"};
    const taut_record *old = taut_record_get(taut_model_details(made->model), "left_out");

    CHECK(taut_record_count(old) > 0, "left out");
    for (size_t i = 0; i < sizeof words / sizeof *words; i++) {
        taut_record *whole = taut_record_new(), *list = taut_record_add_list(whole, "left_out");
        for (size_t k = 0; k < taut_record_count(old); k++) {
            const taut_record *item = taut_record_at(old, k);
            const taut_record *at = taut_record_get(item, "at");
            const double place[2] = {taut_record_number(taut_record_at(at, 0)) +
                                         (i == 4 ? 0.01 : 0),
                                     taut_record_number(taut_record_at(at, 1))};
            taut_record *to = taut_record_add_object(list, NULL);
            if (i == 5) {
                taut_record_add_text(to, "family", words[i]);
            } else {
                taut_record_add_record(to, "family", taut_record_get(item, "family"));
            }
            taut_record_add_numbers(to, "at", 2, place);
            if (i < 4) {
                taut_record_add_text(to, "reason", words[i]);
            } else {
                taut_record_add_record(to, "reason", taut_record_get(item, "reason"));
            }
        }
        CHECK(!holds_with(made, "left_out", list), "left out: %s", words[i]);
        taut_record_free(whole);
    }
}

/* Flat points and umbilics, corners at knots, seeds where there is no net. */
static void check_told(void)
{
    static const int cubic[2] = {3, 3}, quadratic[2] = {2, 2}, four[2] = {4, 4};
    double heights[16];
    char surface[4000];

    for (int i = 0; i < 4; i++) { /* x^3 - 3 x y^2 about a place that is no node of a grid */
        for (int j = 0; j < 4; j++) {
            const double x[4] = {-0.9, -0.9 + 2.0 / 3, -0.9 + 4.0 / 3, 1.1};
            const double y2[4] = {1.21, 1.21 - 4.4 / 3, 1.21 - 8.8 / 3 + 4.0 / 3, 0.81};
            const double x3[4] = {-0.729, -0.729 + 2 * 0.81, -0.729 + 4 * 0.81 - 4 * 0.9, 1.331};
            heights[4 * i + j] = 0.3 * (x3[i] - 3 * x[i] * y2[j]);
        }
    }
    net_heights(cubic, four, heights, surface, sizeof surface);
    made_net monkey = net_make("asymptotic", surface, "\"seeds\": [{ \"at\": [0.3, 0.4] }]");
    check_counts("monkey saddle", &monkey, "singular_points");
    check_counts("monkey saddle", &monkey, "laths");
    check_counts("monkey saddle", &monkey, "nodes");
    check_node_twice(&monkey);
    check_all("monkey saddle", &monkey);
    made_net umbilic = net_make("principal", surface, "\"seeds\": [{ \"at\": [0.3, 0.4] }]");
    check_counts("umbilic", &umbilic, "singular_points");
    check_all("umbilic", &umbilic);
    for (int k = 0; k < 16; k++) {
        heights[k] = 0.5 * (k / 4 - 1.4) * (k % 4 - 1.7) + 0.1 * (k % 3);
    }
    net_heights(quadratic, four, heights, surface, sizeof surface);
    made_net seeded = net_make("asymptotic", surface, "\"seeds\": [{ \"at\": [0.3, 0.5] }]");
    check_counts("seed on a knot", &seeded, "kinks");
    CHECK(net_count(&seeded, "kinks") >= 2, "a corner of each curve at the seed");
    net_free(&seeded);
    made_net knots = net_make("asymptotic", surface, "\"seeds\": [{ \"at\": [0.3, 0.55] }]");
    check_counts("knots", &knots, "kinks");
    check_all("knots", &knots);
    made_net edges =
        net_make("principal", BILINEAR, "\"seeds\": [{ \"edge\": \"v0\", \"count\": 2 }]");
    check_borders(&edges);
    net_free(&edges);
    for (int k = 0; k < 16; k++) { /* K < 0 for one half of the edge u0 alone */
        const double y[4] = {-1, -1 + 2.0 / 3, -1 + 4.0 / 3, 1}, y3[4] = {-1, 1, -1, 1};
        const double x2[4] = {1, -1.0 / 3, -1.0 / 3, 1};
        heights[k] = 0.4 * x2[k / 4] + 0.25 * y3[k % 4] + 0.02 * y[k % 4];
    }
    net_heights(cubic, four, heights, surface, sizeof surface);
    made_net half = net_make("asymptotic", surface,
                             "\"seeds\": [{ \"edge\": \"u0\", \"count\": 4, \"by\": "
                             "\"parameter\" }]");
    CHECK(half.status == TAUT_OK, "%s", half.error.message);
    check_left_out(&half);
    check_short();
    net_free(&half);
}

int main(void)
{
    check_told();
    made_net standing = net_make(
        "asymptotic", BONNET("0"),
        "\"seeds\": [{ \"edge\": \"v0\", \"family\": \"+\", \"count\": 2 }, { \"edge\": \"u0\", "
        "\"family\": \"-\", \"count\": 2 }], \"laths\": { \"strip\": \"standing\", \"width\": "
        "0.1, \"thickness\": 0.0015, \"material\": \"steel-s235\" }");
    check_all("standing", &standing);
    made_net planks =
        net_make("geodesic", CATENOID,
                 "\"seeds\": [{ \"at\": [0.5, 0.5], \"direction\": [1, 0.3], \"both\": true }, { "
                 "\"at\": [0, 0.2], \"direction\": [-0.4, 1], \"both\": true }], \"laths\": { "
                 "\"strip\": \"plank\", \"width\": 0.05, \"thickness\": 0.002, \"material\": "
                 "\"timber-c24\", \"cut\": \"axis\" }");
    check_all("planks", &planks);
    made_net panels =
        net_make("principal", BILINEAR, "\"seeds\": [{ \"cells\": 5 }], \"panels\": true");
    check_fewer(&panels);
    check_share();
    check_all("panels", &panels);
    made_net bent =
        net_make("asymptotic", CATENOID,
                 "\"seeds\": [{ \"at\": [0.6, 0.55], \"family\": \"+\" }], "
                 "\"max_length\": 0.2, \"laths\": { \"strip\": \"developable\", "
                 "\"width\": 0.02, \"thickness\": 0.001, \"material\": \"steel-s235\" }");
    check_all("bent", &bent);
    return check_failures != 0;
}
