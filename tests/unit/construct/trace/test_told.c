/* test_told.c -- what a net says as structs, and a curve that is followed step by step: the numbers of details, the steps
 * of the net.
 */
#include "check.h"
#include "core/vec3.h"
#include "nets.h"

#include <string.h>

enum { MOST = 200 };

typedef struct walked {
    taut_trace_step steps[MOST];
    int count, enough; /* so many are enough */
} walked;

static int take(void *context, const taut_trace_step *step)
{
    walked *w = context;
    if (w->count < MOST) {
        w->steps[w->count++] = *step;
    }
    return w->count == w->enough;
}

/* Followed both ways from the seed, a curve is the lath of the net: as long, with the same ends. */
static void test_follow(void)
{
    static const struct {
        const char *net, *surface, *lath;
        taut_trace_net which;
        int family;
        double at[2];
    } rows[] = {{"asymptotic", BONNET("1.1"), "A1", TAUT_TRACE_ASYMPTOTIC, 1, {0.5, 0.35}},
                {"principal", BILINEAR, "A1", TAUT_TRACE_PRINCIPAL, 1, {0.3, 0.2}},
                {"principal", BILINEAR, "B1", TAUT_TRACE_PRINCIPAL, 2, {0.3, 0.2}},
                {"isoparametric", CATENOID, "B1", TAUT_TRACE_ISOPARAMETRIC, 2, {0.3, 0.2}}};

    for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
        char seeds[100];
        snprintf(seeds, sizeof seeds, "\"seeds\": [{ \"at\": [%g, %g] }]", rows[k].at[0],
                 rows[k].at[1]);
        made_net made = net_make(rows[k].net, rows[k].surface, seeds);
        const taut_surface *surface = taut_model_surface(made.model, 0);
        double length = 0;
        for (int way = -1; way <= 1; way += 2) {
            const double direction[2] = {way * 1.0, way * 1e-3};
            walked w = {.count = 0};
            taut_trace_end end;
            taut_error error = {.status = TAUT_OK};
            CHECK(taut_trace_follow(surface, rows[k].which, rows[k].family, rows[k].at, direction,
                                    0, take, &w, &end, &error) == TAUT_OK,
                  "row %zu: %s", k, error.message);
            CHECK(w.count == end.steps + 1 && w.steps[0].s == 0, "row %zu: %d steps", k, w.count);
            CHECK(strcmp(end.word, "edge") == 0 || strcmp(end.word, "corner") == 0, "row %zu: %s",
                  k, end.word);
            CHECK_NEAR(w.steps[w.count - 1].s, end.length, 0, "row %zu", k);
            length += end.length;
            for (int i = 0; i < w.count; i++) {
                double x[3];
                taut_surface_eval(surface, w.steps[i].at[0], w.steps[i].at[1], 0, x);
                CHECK(taut_length_between(x, w.steps[i].point) < 1e-14, "row %zu step %d", k, i);
                CHECK_NEAR(taut_length(w.steps[i].tangent), 1, 1e-14, "row %zu step %d", k, i);
                CHECK(rows[k].which != TAUT_TRACE_PRINCIPAL || fabs(w.steps[i].tau_g) < 1e-14,
                      "row %zu step %d twists", k, i);
            }
            const double *to = end.at;
            const int is_to = fabs(to[0] - net_end(&made, rows[k].lath, "to", 0)) +
                                  fabs(to[1] - net_end(&made, rows[k].lath, "to", 1)) <
                              1e-13;
            const int is_from = fabs(to[0] - net_end(&made, rows[k].lath, "from", 0)) +
                                    fabs(to[1] - net_end(&made, rows[k].lath, "from", 1)) <
                                1e-13;
            CHECK(is_to || is_from, "row %zu: ends at (%g, %g)", k, to[0], to[1]);
        }
        CHECK_NEAR(length, net_number(&made, rows[k].lath, "length"), 1e-14 * length, "row %zu", k);
        net_free(&made);
    }
}

/* It stops when it is told to, at the length that was asked for, and at once where it begins at its end. */
static void test_stops(void)
{
    made_net made = net_make("principal", BILINEAR, "\"seeds\": [{ \"at\": [0.3, 0.2] }]");
    const taut_surface *surface = taut_model_surface(made.model, 0);
    const double at[2] = {0.3, 0.2}, border[2] = {1, 0.2}, way[2] = {1, 1};
    taut_trace_end end;
    for (int enough = 1; enough < 6; enough++) {
        walked w = {.enough = enough};
        CHECK(taut_trace_follow(surface, TAUT_TRACE_PRINCIPAL, 1, at, way, 0, take, &w, &end,
                                NULL) == TAUT_OK &&
                  strcmp(end.word, "sink") == 0 && w.count == enough,
              "%d: %d steps, %s", enough, w.count, end.word);
        CHECK(end.at[0] == w.steps[w.count - 1].at[0], "%d", enough);
    }
    walked w = {.count = 0};
    CHECK(taut_trace_follow(surface, TAUT_TRACE_GEODESIC, 1, at, way, 0.25, take, &w, &end, NULL) ==
                  TAUT_OK &&
              strcmp(end.word, "length") == 0,
          "%s", end.word);
    CHECK_NEAR(end.length, 0.25, 1e-15, "length");
    w.count = 0;
    CHECK(taut_trace_follow(surface, TAUT_TRACE_PRINCIPAL, 1, border, way, 0, take, &w, &end,
                            NULL) == TAUT_OK &&
              strcmp(end.word, "edge") == 0 && w.count == 1 && end.length == 0,
          "%s after %g", end.word, end.length);
    net_free(&made);
}

static void test_refused(void)
{
    made_net made = net_make("principal", BILINEAR, "\"seeds\": [{ \"at\": [0.3, 0.2] }]");
    const taut_surface *surface = taut_model_surface(made.model, 0);
    const double at[2] = {0.3, 0.2}, way[2] = {1, 1};
    const struct {
        taut_trace_net net;
        int family;
        double at[2], way[2], most;
        taut_status status;
        const char *reason;
    } rows[] = {{TAUT_TRACE_PRINCIPAL, 0, {0, 0}, {1, 1}, 0, TAUT_BAD_ARGUMENT, "argument"},
                {TAUT_TRACE_GEODESIC, 2, {0, 0}, {1, 1}, 0, TAUT_BAD_ARGUMENT, "argument"},
                {TAUT_TRACE_PRINCIPAL, 1, {2, 0}, {1, 1}, 0, TAUT_BAD_INPUT, "outside"},
                {TAUT_TRACE_PRINCIPAL, 1, {NAN, 0}, {1, 1}, 0, TAUT_BAD_INPUT, "outside"},
                {TAUT_TRACE_PRINCIPAL, 1, {0, 0}, {0, 0}, 0, TAUT_BAD_INPUT, "direction"},
                {TAUT_TRACE_PRINCIPAL, 1, {0, 0}, {INFINITY, 0}, 0, TAUT_BAD_INPUT, "direction"},
                {TAUT_TRACE_PRINCIPAL, 1, {0, 0}, {1, 0}, -1, TAUT_BAD_INPUT, "value"},
                {TAUT_TRACE_PRINCIPAL, 1, {0, 0}, {1, 0}, NAN, TAUT_BAD_INPUT, "value"}};
    for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
        walked w = {.count = 0};
        taut_error error = {.status = TAUT_OK};
        CHECK(taut_trace_follow(surface, rows[k].net, rows[k].family, rows[k].at, rows[k].way,
                                rows[k].most, take, &w, NULL, &error) == rows[k].status &&
                  strcmp(error.reason, rows[k].reason) == 0 && w.count == 0,
              "row %zu: %s", k, error.reason);
    }
    CHECK(taut_trace_follow(surface, TAUT_TRACE_PRINCIPAL, 1, at, way, 0, NULL, NULL, NULL, NULL) ==
              TAUT_BAD_ARGUMENT,
          "no sink");
    net_free(&made);
}

static void test_structs(void)
{
    made_net made = net_make("asymptotic", BONNET("0"),
                             "\"seeds\": [{ \"at\": [0.5, 0.35] }], \"laths\": { \"strip\": "
                             "\"standing\", \"width\": 0.15, \"thickness\": 0.001, \"material\": "
                             "\"steel-s235\" }");
    taut_trace_lath lath;
    taut_trace_node node;
    taut_trace_piece piece;
    double outline[64][2], area = 0;

    CHECK(taut_trace_lath_count(made.model) == 2 && taut_trace_node_count(made.model) == 1 &&
              taut_trace_piece_count(made.model) == 2,
          "%s", made.error.message);
    CHECK(taut_trace_lath_at(made.model, 0, &lath, NULL) == TAUT_OK, "A1");
    CHECK(strcmp(lath.name, "A1") == 0 && strcmp(lath.family, "+") == 0 &&
              strcmp(lath.from_word, "edge v0") == 0 && strcmp(lath.to_word, "edge v1") == 0,
          "%s %s from %s to %s", lath.name, lath.family, lath.from_word, lath.to_word);
    CHECK_NEAR(lath.length, 1.20921653200168, 1e-12, "length");
    CHECK_NEAR(lath.twist, 1.38403685462695, 5e-12, "twist");
    CHECK_NEAR(lath.k_g.seed, -0.226475940566633, 1e-12, "k_g");
    CHECK_NEAR(lath.tau_g.seed, 1.40505489993319, 1e-13, "tau_g");
    CHECK_NEAR(lath.edge_length, 1.21421294654451, 2e-12, "edge");
    CHECK_NEAR(lath.from[0], 0.15, 1e-14, "from");
    CHECK(lath.width == 0.15 && lath.node_count == 1 && lath.use > 0, "laths");
    CHECK(taut_trace_node_at(made.model, 0, &node, NULL) == TAUT_OK, "node");
    CHECK(strcmp(node.name, "A1B1") == 0 && !node.is_on_border, "%s", node.name);
    CHECK_NEAR(node.tau, 1.40505489993319, 1e-13, "tau");
    CHECK_NEAR(node.at[1], 0.35, 1e-14, "at");
    CHECK_NEAR(taut_length(node.normal), 1, 1e-15, "normal");
    CHECK_NEAR(node.slot, 1, 1e-14, "right-angled");
    CHECK(taut_trace_pattern(made.model, 0, 0, NULL, &piece, NULL) == TAUT_OK &&
              piece.point_count == 4 && piece.slot_count == 1 && piece.sheet == 1,
          "%d points", piece.point_count);
    CHECK(taut_trace_pattern(made.model, 0, 3, outline[0], &piece, NULL) == TAUT_BAD_ARGUMENT,
          "no room");
    CHECK(taut_trace_pattern(made.model, 0, 64, outline[0], &piece, NULL) == TAUT_OK, "%s",
          piece.name);
    for (int k = 0; k < piece.point_count; k++) {
        const double *a = outline[k], *b = outline[(k + 1) % piece.point_count];
        area += (a[0] * b[1] - a[1] * b[0]) / 2;
    }
    CHECK(taut_trace_lath_at(made.model, 0, &lath, NULL) == TAUT_OK, "A1");
    CHECK_NEAR(fabs(area), 0.15 * lath.cut_length, 1e-13, "a band of %s", piece.lath);
    CHECK(taut_trace_lath_at(made.model, 2, &lath, NULL) == TAUT_BAD_ARGUMENT &&
              taut_trace_lath_at(made.model, -1, &lath, NULL) == TAUT_BAD_ARGUMENT &&
              taut_trace_node_at(made.model, 0, NULL, NULL) == TAUT_BAD_ARGUMENT &&
              taut_trace_lath_count(NULL) == 0,
          "none");
    net_free(&made);
    made = net_make("asymptotic", BONNET("0"), "\"seeds\": [{ \"at\": [0.5, 0.35] }]");
    CHECK(taut_trace_lath_at(made.model, 0, &lath, NULL) == TAUT_OK && isnan(lath.width) &&
              isnan(lath.use) && isnan(lath.pattern_end[0]),
          "curves alone");
    net_free(&made);
}

int main(void)
{
    test_follow();
    test_stops();
    test_refused();
    test_structs();
    return check_failures != 0;
}
