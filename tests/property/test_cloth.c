/* test_cloth.c -- random strips of random surfaces: every claim of the certificate holds, seams are equal to 1e-9, no strain is below what
 * curvature alone says that none avoids, and pieces that are mounted again by the inverse of their flattening meet along their seams, at
 * their marks. */
#include "certificates.h"
#include "check.h"
#include "cloths.h"
#include "models.h"

#include <math.h>
#include <stdio.h>

enum {
    ROUNDS = 16,
    RULE_ROUNDS = 14,
    PRINT_ROUNDS = 6,
    PAIR_ROUNDS = 8,
    ROLL_ROUNDS = 8,
    POLE_ROUNDS = 8,
    PLACES = 16
};
/* How far a place of a seam is from where it comes back to: of strips, and of pieces that are held all around. */
static const double strip_away = 1e-7, rule_away = 1e-5;

/* Four by four points over a square of side 2, up to `height` up or down, edges bent by up to a tenth. */
static void surface_of(double height, char *text, size_t room)
{
    size_t n =
        (size_t)snprintf(text, room,
                         "{ \"taut\": 1, \"surfaces\": [{ \"name\": \"s\", \"u\": { \"type\": "
                         "\"bezier\", \"degree\": 3 }, \"v\": { \"type\": \"bezier\", "
                         "\"degree\": 3 }, \"points\": [");
    for (int i = 0; i < 4; i++) {
        n += (size_t)snprintf(text + n, room - n, "%s[", i > 0 ? ", " : "");
        for (int k = 0; k < 4; k++) {
            n += (size_t)snprintf(text + n, room - n, "%s[%.17g, %.17g, %.17g]", k > 0 ? ", " : "",
                                  -1 + 2.0 * i / 3 + random_in(-0.1, 0.1),
                                  -1 + 2.0 * k / 3 + random_in(-0.1, 0.1),
                                  random_in(-height, height));
        }
        n += (size_t)snprintf(text + n, room - n, "]");
    }
    snprintf(text + n, room - n, "] }] }");
}

/* Two such surfaces beside each other, which share an edge that the second one may run against. */
static void pair_of(double height, int is_turned, char *text, size_t room)
{
    double points[7][4][3];
    size_t n = (size_t)snprintf(text, room, "{ \"taut\": 1, \"surfaces\": [");
    for (int i = 0; i < 7; i++) {
        for (int k = 0; k < 4; k++) {
            points[i][k][0] = -1 + 2.0 * i / 3 + random_in(-0.1, 0.1);
            points[i][k][1] = -1 + 2.0 * k / 3 + random_in(-0.1, 0.1);
            points[i][k][2] = random_in(-height, height);
        }
    }
    for (int which = 0; which < 2; which++) {
        n += (size_t)snprintf(text + n, room - n,
                              "%s{ \"name\": \"%c\", \"u\": { \"type\": \"bezier\", \"degree\": 3 "
                              "}, \"v\": { \"type\": \"bezier\", \"degree\": 3 }, \"points\": [",
                              which > 0 ? ", " : "", 'a' + which);
        for (int i = 0; i < 16; i++) {
            const double *x = points[3 * which + i / 4][which > 0 && is_turned ? 3 - i % 4 : i % 4];
            n += (size_t)snprintf(text + n, room - n, "%s%s[%.17g, %.17g, %.17g]%s",
                                  i > 0 ? ", " : "", i % 4 == 0 ? "[" : "", x[0], x[1], x[2],
                                  i % 4 == 3 ? "]" : "");
        }
        n += (size_t)snprintf(text + n, room - n, "] }");
    }
    snprintf(text + n, room - n, "] }");
}

/* A cone or a dome around an angle, its apex the edge v0; points but those next to it up to a fraction of their distance elsewhere. */
static void pole_of(int is_dome, double uneven, char *text, size_t room)
{
    const double angle = random_in(0.6, 2.2), height = random_in(-0.8, 0.8);
    size_t n =
        (size_t)snprintf(text, room,
                         "{ \"taut\": 1, \"surfaces\": [{ \"name\": \"s\", \"u\": { \"type\": "
                         "\"bezier\", \"degree\": 3 }, \"v\": { \"type\": \"bezier\", "
                         "\"degree\": 3 }, \"points\": [");
    for (int i = 0; i < 4; i++) {
        const double way = i < 2 ? 0 : angle, on = i == 1 ? angle / 3 : i == 2 ? -angle / 3 : 0;
        n += (size_t)snprintf(text + n, room - n, "%s[", i > 0 ? ", " : "");
        for (int k = 0; k < 4; k++) {
            const double x = k / 3.0, off = k > 1 ? uneven : 0;
            n += (size_t)snprintf(text + n, room - n, "%s[%.17g, %.17g, %.17g]", k > 0 ? ", " : "",
                                  x * (cos(way) - on * sin(way)) * (1 + random_in(-off, off)),
                                  x * (sin(way) + on * cos(way)) * (1 + random_in(-off, off)),
                                  height * (1 - (is_dome ? x * x : x)) + random_in(-off, off));
        }
        n += (size_t)snprintf(text + n, room - n, "]");
    }
    snprintf(text + n, room - n, "] }] }");
}

/* The (s, t) of a flat place, by Newton's method from another one. */
static void find(const taut_surface *flat, const double y[2], double at[2])
{
    for (int round = 0; round < 30; round++) {
        double x[3][3];
        taut_surface_eval(flat, at[0], at[1], 1, x[0]);
        const double gap[2] = {y[0] - x[0][0], y[1] - x[0][1]};
        const double det = x[1][0] * x[2][1] - x[1][1] * x[2][0];
        at[0] = fmin(fmax(at[0] + (gap[0] * x[2][1] - gap[1] * x[2][0]) / det, 0), 1);
        at[1] = fmin(fmax(at[1] + (x[1][0] * gap[1] - x[1][1] * gap[0]) / det, 0), 1);
    }
}

/* Is a place of an edge that the piece begins or ends with in one place? */
static int is_tip(const taut_surface *flat, int e, int k)
{
    int found = 0;
    for (int end = 0; end < 2; end++) {
        double a[3], b[3];
        taut_surface_eval(flat, end, 0, 0, a);
        taut_surface_eval(flat, end, 1, 0, b);
        const int is_there = e % 2 == 0 ? k == end * PLACES : e == (end == 0 ? 3 : 1);
        found |= is_there && fabs(a[0] - b[0]) + fabs(a[1] - b[1]) < 1e-12;
    }
    return found;
}

/* Along each seam: the lines that are sewn, one on either piece, put back on their pieces, are at one and the same share of the seam. */
static void check_sewn(const made_cloth *made, double most, const char *what)
{
    const taut_record *details = taut_model_details(made->model);
    const taut_record *pieces = taut_record_get(details, "pieces");
    double worst = 0;
    for (size_t p = 0; p < taut_record_count(pieces); p++) {
        static const char *const edges[] = {"right", "end", "left", "start"};
        const taut_record *piece = taut_record_at(pieces, p);
        const char *name = taut_record_text(taut_record_get(piece, "name"));
        for (int e = 0; e < 4; e++) {
            char line[64];
            snprintf(line, sizeof line, "%s.%s", name, edges[e]);
            const taut_curve *sewn = curve_named(made->model, line);
            const taut_surface *flat = surface_named(made->model, name);
            for (int k = 0; sewn != NULL && flat != NULL && k <= PLACES; k++) {
                if (is_tip(flat, e, k)) { /* where the way back is not one */
                    continue;
                }
                const double x = (double)k / PLACES, fixed = e == 1 || e == 2;
                const double to[2] = {e % 2 == 0 ? x : fixed, e % 2 == 0 ? fixed : x};
                double y[3], at[2] = {to[0], to[1]};
                taut_curve_eval(sewn, x, 0, y);
                find(flat, y, at);
                worst = fmax(worst, fmax(fabs(at[0] - to[0]), fabs(at[1] - to[1])));
            }
        }
    }
    CHECK(worst < most, "%s: a place of a seam comes back %g of it away", what, worst);
}

static void check_cloth(const made_cloth *made, double away, const char *what)
{
    for (int k = 0; k < taut_certificate_claim_count(made->proof); k++) {
        const taut_claim *claim = taut_certificate_claim(made->proof, k);
        CHECK(claim->holds == TAUT_TRUE, "%s: %s %g at %s", what, claim->claim, claim->residual,
              claim->where);
    }
    const double least = figure_of(made->proof, "unavoidable_strain");
    const double most =
        fmax(figure_of(made->proof, "max_strain"), -figure_of(made->proof, "min_strain"));
    CHECK(!(most < least), "%s: strained by %g, and %g cannot be avoided", what, most, least);
    const double proved = figure_of(made->proof, "proved_strain");
    CHECK(!(most < proved), "%s: strained by %g, and %g is proved", what, most, proved);
    check_sewn(made, away, what);
}

/* A rule at random: of each kind of seam; of some with another rule after it. */
static void rules_of(int round, char *text, size_t room)
{
    const double a = random_in(0.25, 0.4), b = random_in(0.6, 0.75);
    const double c = random_in(0.25, 0.4), d = random_in(0.6, 0.75);
    switch (round % 7) {
    case 0: /* two geodesics, one of them backwards */
        snprintf(text, room,
                 "{ \"geodesic\": [{ \"edge\": \"v0\", \"part\": %.17g }, { \"edge\": \"v1\", "
                 "\"part\": %.17g }] }, { \"geodesic\": [[%.17g, 1], [%.17g, 0]] }",
                 a, c, b, d);
        return;
    case 1:
        snprintf(text, room, "{ \"line\": { \"v\": [%.17g, %.17g] } }", a, b);
        return;
    case 2:
        snprintf(text, room, "{ \"parallel\": [[0.1, %.17g], [0.9, %.17g]], \"spacing\": %.17g }",
                 random_in(0.4, 0.6), random_in(0.4, 0.6), random_in(0.5, 0.8));
        return;
    case 3: /* strips cut across */
        snprintf(
            text, room,
            "{ \"across\": [\"u1\", \"u0\"], \"count\": %d }, { \"butt\": \"P2\", \"at\": %.17g "
            "}, { \"butt\": \"P1\", \"at\": [%.17g, %.17g] }",
            random_int(2, 4), random_in(0.3, 0.7), a, b);
        return;
    case 4: /* between others */
        snprintf(text, room,
                 "{ \"line\": { \"u\": %.17g } }, { \"geodesic\": [[%.17g, 0], [%.17g, 1]] }", a, b,
                 d);
        return;
    case 5: /* three sides */
        snprintf(text, room,
                 "{ \"geodesic\": [[0, 1], [%.17g, 0]] }, { \"geodesic\": [[%.17g, 0], [1, 1]] }",
                 a, b);
        return;
    default:
        snprintf(text, room, "{ \"radial\": \"u1\", \"count\": %d, \"by\": \"parameter\" }",
                 random_int(2, 4));
        return;
    }
}

/* Seams of every rule. */
static void test_rules(void)
{
    const int trials = random_trials(RULE_ROUNDS);
    int made_count = 0;
    for (int round = 0; round < trials; round++) {
        random_seed((uint64_t)round + 1001);
        char surface[4096], rules[512], members[768];
        surface_of(0.25, surface, sizeof surface);
        rules_of(round, rules, sizeof rules);
        snprintf(members, sizeof members, "\"seams\": [%s], \"seam_length\": \"%s\"", rules,
                 round % 4 == 3 ? "true" : "shared");
        made_cloth made = cloth_make(surface, members);
        CHECK(made.status == TAUT_OK || made.status == TAUT_NO_SOLUTION, "%d: %s", round,
              made.error.message);
        if (made.status == TAUT_OK) {
            made_count++;
            check_cloth(&made, rule_away, members);
        }
        cloth_free(&made);
    }
    CHECK(2 * made_count > trials, "%d of %d were made", made_count, trials);
}

/* Two surfaces: seams between them with joints on one side, on both at different places, and on both at one. */
static void test_pairs(void)
{
    static const char *const seams[] = {"{ \"across\": [\"u0\", \"u1\"], \"count\": 3 }",
                                        "{ \"across\": [\"v0\", \"v1\"], \"count\": 2 }",
                                        "{ \"across\": [\"u0\", \"u1\"], \"count\": 2, "
                                        "\"surface\": \"a\" }, { \"across\": [\"u0\", "
                                        "\"u1\"], \"count\": 3, \"surface\": \"b\" }",
                                        "{ \"across\": [\"v0\", \"v1\"], \"count\": 2, "
                                        "\"surface\": \"a\" }, { \"across\": [\"u0\", "
                                        "\"u1\"], \"count\": 2, \"surface\": \"b\" }"};
    const int trials = random_trials(PAIR_ROUNDS);
    int made_count = 0;
    for (int round = 0; round < trials; round++) {
        random_seed((uint64_t)round + 3001);
        char surface[4096], members[768];
        pair_of(0.25, round % 3 == 1, surface, sizeof surface);
        snprintf(members, sizeof members,
                 "\"seams\": [%s], \"seam_length\": \"%s\", \"compensation\": { \"warp\": %.17g, "
                 "\"weft\": %.17g }",
                 seams[round % 4], round % 5 == 3 ? "true" : "shared", random_in(0, 0.04),
                 random_in(0, 0.04));
        made_cloth made = cloth_make(surface, members);
        CHECK(made.status == TAUT_OK || made.status == TAUT_NO_SOLUTION ||
                  made.status == TAUT_NOT_CONVERGED,
              "%d: %s", round, made.error.message);
        if (made.status == TAUT_OK) {
            made_count++;
            check_cloth(&made, rule_away, members);
        }
        cloth_free(&made);
    }
    CHECK(2 * made_count > trials, "%d of %d were made", made_count, trials);
}

/* Compensation that fades out, strips cut for a length of cloth, pieces on a roll. */
static void test_rolls(void)
{
    static const char *const edges[] = {"u0", "u1", "v0", "v1"};
    const int trials = random_trials(ROLL_ROUNDS);
    int made_count = 0;
    for (int round = 0; round < trials; round++) {
        random_seed((uint64_t)round + 4001);
        char surface[4096], members[768];
        surface_of(0.25, surface, sizeof surface);
        const int n = snprintf(members, sizeof members,
                               "\"seams\": [{ \"across\": [\"v0\", \"v1\"], \"count\": %d }%s], "
                               "\"compensation\": { \"warp\": %.17g, \"weft\": %.17g }, "
                               "\"allowance\": { \"seam\": 0.01, \"border\": %.17g }, \"cloth\": { "
                               "\"width\": %.17g, \"length\": %.17g, \"nap\": %s }",
                               random_int(2, 4), round % 2 == 0 ? ", { \"butt\": \"auto\" }" : "",
                               random_in(-0.01, 0.06), random_in(-0.01, 0.06), random_in(0, 0.03),
                               random_in(1.5, 3), round % 2 == 0 ? random_in(0.7, 2) : 5,
                               round % 3 == 0 ? "true" : "false");
        if (round % 2 == 1) {
            snprintf(members + n, sizeof members - (size_t)n,
                     ", \"decompensate\": [{ \"edge\": \"%s\", \"length\": %.17g, \"component\": "
                     "\"%s\" }]",
                     edges[round / 2 % 4], random_in(0.2, 1.5), round % 4 == 1 ? "along" : "both");
        }
        made_cloth made = cloth_make(surface, members);
        CHECK(made.status == TAUT_OK || made.status == TAUT_NO_SOLUTION, "%d: %s", round,
              made.error.message);
        if (made.status == TAUT_OK) {
            made_count++;
            check_cloth(&made, rule_away, members);
        }
        cloth_free(&made);
    }
    CHECK(2 * made_count > trials, "%d of %d were made", made_count, trials);
}

/* Gores that meet in a pole, or end around a cap. */
static void test_poles(void)
{
    const int trials = random_trials(POLE_ROUNDS);
    int made_count = 0;
    for (int round = 0; round < trials; round++) {
        random_seed((uint64_t)round + 5001);
        char surface[4096], trim[64] = "", members[768];
        pole_of(round % 2, round % 4 < 2 ? 0 : 0.15, surface, sizeof surface);
        if (round % 3 == 1) {
            snprintf(trim, sizeof trim, ", \"trim\": %.17g", random_in(0.1, 0.4));
        }
        snprintf(members, sizeof members,
                 "\"seams\": [{ \"radial\": \"v%d\", \"count\": %d%s }], \"seam_length\": \"%s\", "
                 "\"compensation\": { \"warp\": %.17g, \"weft\": 0.02 }, \"allowance\": { "
                 "\"seam\": 0.02, \"border\": 0.03 }",
                 round % 5 == 2, random_int(1, 5), trim, round % 4 == 3 ? "true" : "shared",
                 random_in(0, 0.03));
        made_cloth made = cloth_make(surface, members);
        CHECK(made.status == TAUT_OK || made.status == TAUT_NO_SOLUTION, "%d: %s", round,
              made.error.message);
        if (made.status == TAUT_OK) {
            made_count++;
            check_cloth(&made, rule_away, members);
        }
        cloth_free(&made);
    }
    CHECK(2 * made_count > trials, "%d of %d were made", made_count, trials);
}

/* Laid flat by angles: these are kept within what is claimed, and lengths of seams. */
static void test_prints(void)
{
    const int trials = random_trials(PRINT_ROUNDS);
    int made_count = 0;
    for (int round = 0; round < trials; round++) {
        random_seed((uint64_t)round + 2001);
        char surface[4096], members[256];
        surface_of(0.4, surface, sizeof surface);
        snprintf(members, sizeof members,
                 "\"seams\": [{ \"across\": [\"v0\", \"v1\"], \"count\": %d }], \"flatten\": "
                 "\"conformal\"",
                 random_int(2, 5));
        made_cloth made = cloth_make(surface, members);
        CHECK(made.status == TAUT_OK || made.status == TAUT_NO_SOLUTION, "%d: %s", round,
              made.error.message);
        if (made.status == TAUT_OK) {
            made_count++;
            check_cloth(&made, strip_away, members);
            CHECK(claim_of(made.proof, "conformal")->residual < 1e-3, "%s", members);
        }
        cloth_free(&made);
    }
    CHECK(2 * made_count > trials, "%d of %d were made", made_count, trials);
}

int main(void)
{
    static const char *const edges[] = {"\"v0\", \"v1\"", "\"v1\", \"v0\"", "\"u0\", \"u1\"",
                                        "\"u1\", \"u0\""};
    const int trials = random_trials(ROUNDS);
    int made_count = 0;
    for (int round = 0; round < trials; round++) {
        random_seed((uint64_t)round + 1);
        char surface[4096], members[512];
        surface_of(0.35, surface, sizeof surface);
        const double warp = random_in(0, 0.03), left = random_in(0.01, 0.05);
        snprintf(
            members, sizeof members,
            "\"seams\": [{ \"across\": [%s], \"count\": %d }], \"seam_length\": \"%s\", "
            "\"compensation\": { \"warp\": %.17g, \"weft\": 0.01 }, \"allowance\": { \"seam\": "
            "%.17g, \"border\": 0.03, \"S1\": [%.17g, %.17g] }, \"marks\": { \"spacing\": 0.2 }",
            edges[round % 4], random_int(2, 5), round % 3 == 2 ? "true" : "shared",
            round % 2 == 0 ? 0 : warp, left, round % 3 == 0 ? 0 : left / 3, left + 0.01);
        made_cloth made = cloth_make(surface, members);
        CHECK(made.status == TAUT_OK || made.status == TAUT_NO_SOLUTION, "%d: %s", round,
              made.error.message);
        if (made.status == TAUT_OK) {
            made_count++;
            check_cloth(&made, strip_away, members);
        }
        cloth_free(&made);
    }
    CHECK(2 * made_count > trials, "%d of %d were made", made_count, trials);
    test_rules();
    test_prints();
    test_pairs();
    test_rolls();
    test_poles();
    return check_failures != 0;
}
