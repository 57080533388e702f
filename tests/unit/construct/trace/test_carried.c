/* test_carried.c -- nets that go on from one surface to the next: pieces of a surface have the curves of the
 * whole, however their parameters run.
 */
#include "certificates.h"
#include "check.h"
#include "nets.h"

#include <stdlib.h>
#include <string.h>

/* z = 1.1 x y over [-1, 1]^2 in four pieces that meet at (0, 0.25): each a bilinear patch whose parameters run
 * as `turned` says, in ranges of their own. `upside`: this piece has its normal the other way. */
static void write_pieces(const int turned[4], int upside, char *text, size_t room)
{
    static const double x[3] = {-1, 0, 1}, y[3] = {-1, 0.25, 1};
    size_t length = (size_t)snprintf(text, room, "{ \"taut\": 1, \"surfaces\": [");
    for (int k = 0; k < 4; k++) {
        /* the corners, counter-clockwise from low x and y */
        const double xs[4] = {x[k / 2], x[k / 2 + 1], x[k / 2 + 1], x[k / 2]};
        const double ys[4] = {y[k % 2], y[k % 2], y[k % 2 + 1], y[k % 2 + 1]};
        static const int order[4] = {0, 3, 1, 2}; /* of rows u0v0, u0v1, u1v0, u1v1 */
        length += (size_t)snprintf(
            text + length, room - length,
            "%s{ \"name\": \"p%d\", \"u\": { \"type\": \"bezier\", \"degree\": 1, \"range\": "
            "[%d, %d] }, \"v\": { \"type\": \"bezier\", \"degree\": 1 }, \"points\": [",
            k > 0 ? ", " : "", k, k, 2 * k + 2);
        for (int corner = 0; corner < 4; corner++) {
            const int other = corner == 1 ? 2 : corner == 2 ? 1 : corner;
            const int c = (order[k == upside ? other : corner] + turned[k]) % 4;
            length +=
                (size_t)snprintf(text + length, room - length, "%s[%.17g, %.17g, %.17g]%s",
                                 corner % 2 == 0 ? "[" : ", ", xs[c], ys[c], 1.1 * xs[c] * ys[c],
                                 corner % 2 == 0 ? ""
                                 : corner == 1   ? "], "
                                                 : "]");
        }
        length += (size_t)snprintf(text + length, room - length, "] }");
    }
    snprintf(text + length, room - length, "] }");
}

static made_net pieces_net(const char *kind, const int turned[4], int upside, const char *members)
{
    char surfaces[4000], text[1000];
    write_pieces(turned, upside, surfaces, sizeof surfaces);
    snprintf(text, sizeof text, "\"carry\": true, %s", members);
    return net_make(kind, surfaces, text);
}

/* Where in space a lath begins (0) or ends (1). */
static void end_of(const made_net *made, const char *name, int end, double x[3])
{
    for (int i = 0; i < taut_model_curve_count(made->model); i++) {
        const taut_curve *curve = taut_model_curve(made->model, i);
        if (strcmp(taut_curve_name(curve), name) == 0) {
            const taut_basis *t = taut_curve_t(curve);
            taut_curve_eval(curve, end == 0 ? taut_basis_lo(t) : taut_basis_hi(t), 0, x);
        }
    }
}

static void check_lath(const made_net *made, const char *name, double length, const double a[2],
                       const double b[2])
{
    double x[2][3] = {{0, 0, 0}, {0, 0, 0}};
    const double found = net_number(made, name, "length");

    end_of(made, name, 0, x[0]);
    end_of(made, name, 1, x[1]);
    CHECK_NEAR(found, length, 4e-13 * length, "%s", name);
    const double along =
        fabs(x[0][0] - a[0]) + fabs(x[0][1] - a[1]) + fabs(x[1][0] - b[0]) + fabs(x[1][1] - b[1]);
    const double against =
        fabs(x[0][0] - b[0]) + fabs(x[0][1] - b[1]) + fabs(x[1][0] - a[0]) + fabs(x[1][1] - a[1]);
    CHECK(fmin(along, against) < 4e-12, "%s: ends off by %g", name, fmin(along, against));
}

/* The place (x, y) in the window of piece k. */
static void place_in(const int turned[4], int k, double x, double y, double at[2])
{
    const double a = k / 2 == 0 ? x + 1 : x, b = k % 2 == 0 ? (y + 1) / 1.25 : (y - 0.25) / 0.75;
    const double share[4][2] = {{a, b}, {b, 1 - a}, {1 - a, 1 - b}, {1 - b, a}};
    at[0] = k + (k + 2) * share[turned[k]][0];
    at[1] = share[turned[k]][1];
}

static made_net net_from(const char *kind, const int turned[4], int k, double x, double y,
                         const char *more)
{
    char members[600];
    double at[2];
    place_in(turned, k, x, y, at);
    snprintf(members, sizeof members,
             "\"seeds\": [{ \"at\": [%.17g, %.17g], \"surface\": \"p%d\" }]%s", at[0], at[1], k,
             more);
    return pieces_net(kind, turned, -1, members);
}

static const int ways[3][4] = {{0, 0, 0, 0}, {0, 1, 2, 3}, {3, 3, 1, 2}};

/* The closed forms of z = 1.1 x y: lines of curvature keep asinh 1.1x -+ asinh 1.1y, asymptotic curves are
 * rulings. */
static void test_closed_forms(void)
{
    static const double max_from[2] = {-0.862070697356428, -1}, max_to[2] = {1, 0.862070697356428};
    static const double min_from[2] = {-0.381086187806727, 1}, min_to[2] = {1, -0.381086187806727};
    static const double across_from[2] = {-1, -0.7}, across_to[2] = {1, -0.7};
    static const double along_from[2] = {0.4, -1}, along_to[2] = {0.4, 1};

    for (int k = 0; k < 3; k++) {
        made_net made = net_from("principal", ways[k], 2, 0.3, 0.2, "");
        CHECK(made.status == TAUT_OK, "%s: %s", made.error.where, made.error.message);
        CHECK(taut_certificate_holds(made.proof) == TAUT_TRUE, "way %d", k);
        check_lath(&made, "A1", 3.37424383734586, max_from, max_to);
        check_lath(&made, "B1", 2.24879656954454, min_from, min_to);
        CHECK(claim_of(made.proof, "seams")->residual < 1e-14, "%g",
              claim_of(made.proof, "seams")->residual);
        CHECK(net_count(&made, "joins") == 4, "%d joins", net_count(&made, "joins"));
        net_free(&made);
        made = net_from("asymptotic", ways[k], 2, 0.4, -0.7, "");
        CHECK(taut_certificate_holds(made.proof) == TAUT_TRUE, "way %d: %s", k, made.error.message);
        check_lath(&made, "A1", 2.52420284446397, across_from, across_to);
        check_lath(&made, "B1", 2.18504004539963, along_from, along_to);
        net_free(&made);
    }
}

/* Through the point where all four meet: a curve passes from one piece to the one beyond it. */
static void test_corner(void)
{
    for (int k = 0; k < 3; k++) {
        made_net made = net_from("principal", ways[k], 0, 0, 0.25, "");
        made_net whole = net_make("principal", BILINEAR, "\"seeds\": [{ \"at\": [0, 0.25] }]");
        CHECK(taut_certificate_holds(made.proof) == TAUT_TRUE, "way %d: %s", k, made.error.message);
        CHECK_NEAR(net_number(&made, "A1", "length"), net_number(&whole, "A1", "length"), 1e-12,
                   "way %d", k);
        CHECK_NEAR(net_number(&made, "B1", "length"), net_number(&whole, "B1", "length"), 1e-12,
                   "way %d", k);
        net_free(&whole);
        net_free(&made);
    }
}

/* What is cut for curves of pieces is what is cut for those of the whole. */
static void test_laths(void)
{
    static const char *const kinds[] = {"asymptotic", "principal"};
    static const char *const strips[] = {"standing", "plank"};
    static const char *const keys[] = {"length", "twist", "edge_length", "mean_stretch",
                                       "cut_length"};

    for (int k = 0; k < 2; k++) {
        char laths[200], members[400];
        snprintf(laths, sizeof laths,
                 ", \"laths\": { \"strip\": \"%s\", \"width\": 0.08, \"thickness\": 0.004 }",
                 strips[k]);
        snprintf(members, sizeof members, "\"seeds\": [{ \"at\": [0.3, -0.4] }]%s", laths);
        made_net made = net_from(kinds[k], ways[1], 2, 0.3, -0.4, laths);
        made_net whole = net_make(kinds[k], BILINEAR, members);
        CHECK(taut_certificate_holds(made.proof) == TAUT_TRUE, "%s: %s", strips[k],
              made.error.message);
        for (int lath = 0; lath < 2; lath++) {
            for (size_t key = 0; key < sizeof keys / sizeof keys[0]; key++) {
                const char *name = lath == 0 ? "A1" : "B1";
                CHECK_NEAR(net_number(&made, name, keys[key]), net_number(&whole, name, keys[key]),
                           1e-11, "%s %s", name, keys[key]);
            }
        }
        taut_model *solids = NULL;
        CHECK(taut_trace_strips(made.model, 1, &solids, &made.error) == TAUT_OK, "%s",
              made.error.message);
        CHECK(taut_model_surface_count(solids) == 12, "%d faces", taut_model_surface_count(solids));
        taut_model_free(solids);
        net_free(&whole);
        net_free(&made);
    }
}

static int is_carried(const made_net *made, size_t join)
{
    const taut_record *joins = taut_record_get(taut_model_details(made->model), "joins");
    return taut_record_bool(taut_record_get(taut_record_at(joins, join), "carried"));
}

/* A piece with its normal the other way: curves end where they come to it. */
static void test_upside(void)
{
    made_net made = pieces_net("asymptotic", ways[0], 3,
                               "\"seeds\": [{ \"at\": [2.5, 0.5], \"surface\": \"p2\" }]");
    CHECK(taut_certificate_holds(made.proof) == TAUT_TRUE, "%s", made.error.message);
    CHECK(net_count(&made, "joins") == 4, "%d joins", net_count(&made, "joins"));
    CHECK(is_carried(&made, 0) && is_carried(&made, 1), "p0");
    CHECK(!is_carried(&made, 2) && !is_carried(&made, 3), "p3");
    CHECK_NEAR(net_number(&made, "B1", "length"), 1.25 * sqrt(1 + 1.21 * 0.125 * 0.125), 1e-12,
               "%s", "to the seam");
    net_free(&made);
}

/* Surfaces are told by their names. */
static void test_names(void)
{
    made_net made = pieces_net("asymptotic", ways[0], -1,
                               "\"seeds\": [{ \"at\": [0, 0], \"surface\": \"p7\" }]");
    CHECK(made.status == TAUT_BAD_INPUT && strcmp(made.error.reason, "no-such-object") == 0 &&
              strcmp(made.error.where, "/seeds/0/surface") == 0,
          "%s at %s", made.error.reason, made.error.where);
    net_free(&made);
    made =
        net_make("asymptotic",
                 "{ \"taut\": 1, \"surfaces\": ["
                 "{ \"u\": { \"type\": \"bezier\", \"degree\": 1 }, \"v\": { \"type\": \"bezier\", "
                 "\"degree\": 1 }, \"points\": [[[0, 0, 0], [0, 1, 0]], [[1, 0, 0], [1, 1, 1]]] }, "
                 "{ \"u\": { \"type\": \"bezier\", \"degree\": 1 }, \"v\": { \"type\": \"bezier\", "
                 "\"degree\": 1 }, \"points\": [[[1, 0, 0], [1, 1, 1]], [[2, 0, 0], [2, 1, 2]]] }]"
                 " }",
                 "\"carry\": true, \"seeds\": [{ \"at\": [0.5, 0.5] }]");
    CHECK(made.status == TAUT_BAD_INPUT, "%s at %s", made.error.reason, made.error.where);
    net_free(&made);
}

/* Parameter lines belong to their surface. */
static void test_isoparametric(void)
{
    made_net made = net_from("isoparametric", ways[1], 2, 0.3, -0.4, "");
    CHECK(taut_certificate_holds(made.proof) == TAUT_TRUE, "%s", made.error.message);
    CHECK_NEAR(net_number(&made, "A1", "length") + net_number(&made, "B1", "length"),
               1.25 * sqrt(1 + 1.21 * 0.09) + sqrt(1 + 1.21 * 0.16), 1e-12, "%s", "of p2 alone");
    net_free(&made);
}

int main(void)
{
    test_closed_forms();
    test_corner();
    test_laths();
    test_upside();
    test_names();
    test_isoparametric();
    return check_failures != 0;
}
