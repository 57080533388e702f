/* test_film_curves.c [COUNT] -- random boundaries of 3 to 12 lines that go round, some with corners in the middle of a straight side, in a
 * plane and in space: a film whose claims hold, flat ones with the area of their polygon, but for one in ten that is not found. */
#include "certificates.h"
#include "check.h"

#include "taut/taut.h"

#include <stdlib.h>
#include <string.h>

enum { CURVES = 12 };
static const double pi = 3.14159265358979323846;

typedef struct boundary {
    int count, is_flat;
    double corners[CURVES][3];
} boundary;

static void random_angles(int count, double *angles)
{
    double at = 0, sum = 0;
    for (int k = 0; k < count; k++) {
        angles[k] = sum;
        sum += random_in(0.5, 1.5);
    }
    for (at = 2 * pi / sum; count > 0; count--) {
        angles[count - 1] *= at;
    }
}

static boundary random_boundary(void)
{
    boundary b = {.count = random_int(3, CURVES), .is_flat = random_int(0, 3) == 0};
    const int extra = random_int(0, 2) == 0 && b.count > 3 ? random_int(1, b.count - 3) : 0;
    const double rough = extra > 0 ? 0 : random_in(0, 0.3),
                 height = b.is_flat ? 0 : random_in(0, 0.6), turn = random_in(0, 6.28);
    const int waves = random_int(1, 3);
    double angles[CURVES];
    int count = b.count - extra;

    random_angles(count, angles);
    for (int k = 0; k < count; k++) {
        b.corners[k][0] = cos(angles[k]) * (1 + random_in(-rough, rough));
        b.corners[k][1] = sin(angles[k]) * (1 + random_in(-rough, rough));
        b.corners[k][2] = height * (sin(waves * angles[k] + turn) + random_in(-0.3, 0.3));
    }
    for (; count < b.count; count++) {
        const int k = random_int(0, count - 1);
        const double at = random_in(0.3, 0.7), bend = random_int(0, 2) == 0 ? 1.02 : 1;
        double middle[3];
        for (int c = 0; c < 3; c++) {
            middle[c] = (c < 2 ? bend : 1) *
                        ((1 - at) * b.corners[k][c] + at * b.corners[(k + 1) % count][c]);
        }
        memmove(b.corners + k + 2, b.corners + k + 1, (size_t)(count - k - 1) * sizeof *b.corners);
        memcpy(b.corners[k + 1], middle, sizeof middle);
    }
    return b;
}

static double area_of(const boundary *b)
{
    double area = 0;
    for (int k = 0; k < b->count; k++) {
        const double *p = b->corners[k], *q = b->corners[(k + 1) % b->count];
        area += 0.5 * (p[0] * q[1] - p[1] * q[0]);
    }
    return area;
}

static void write_boundary(const boundary *b, char *text, size_t room)
{
    int at = snprintf(text, room,
                      "{\"taut\":1,\"construct\":\"film\",\"degree\":3,\"count\":7,\"least\":false,"
                      "\"curves\":[");
    for (int k = 0; k < b->count; k++) {
        const double *p = b->corners[k], *q = b->corners[(k + 1) % b->count];
        at += snprintf(text + at, room - (size_t)at,
                       "%s{\"line\":[[%.17g,%.17g,%.17g],[%.17g,%.17g,%.17g]]}", k == 0 ? "" : ",",
                       p[0], p[1], p[2], q[0], q[1], q[2]);
    }
    snprintf(text + at, room - (size_t)at, "]}");
}

/* Is there a film? */
static int try_boundary(const boundary *b, int trial)
{
    char text[4000];
    taut_problem *problem = NULL;
    taut_model *model = NULL;
    taut_certificate *proof = NULL;
    taut_error error = {.status = TAUT_OK};
    int holds = 0;

    write_boundary(b, text, sizeof text);
    CHECK(taut_problem_read_text(text, strlen(text), "text", &problem, &error) == TAUT_OK, "%s",
          error.message);
    const taut_status status = taut_make(problem, NULL, &model, &error);
    if (status == TAUT_OK) {
        CHECK(taut_certify(model, problem, NULL, &proof, &error) == TAUT_OK, "%d: %s", trial,
              error.message);
        holds = 1;
        for (int k = 0; k < taut_certificate_claim_count(proof); k++) {
            const taut_claim *claim = taut_certificate_claim(proof, k);
            holds &= claim->holds != TAUT_FALSE;
            CHECK(claim->holds != TAUT_FALSE || strcmp(claim->claim, "stationary") == 0,
                  "trial %d: %s: %g, limit %g", trial, claim->claim, claim->residual, claim->limit);
        }
        if (b->is_flat && holds) {
            CHECK_NEAR(figure_of(proof, "area"), area_of(b), 1e-9 * area_of(b), "trial %d", trial);
        }
    } else {
        CHECK(strcmp(error.reason, "folds") == 0 || strcmp(error.reason, "not-converged") == 0,
              "trial %d: %s: %s", trial, error.reason, error.message);
    }
    if (!holds) {
        printf("trial %d: %d curves: %s: %s\n", trial, b->count, error.reason, text);
    }
    taut_certificate_free(proof);
    taut_model_free(model);
    taut_problem_free(problem);
    return holds;
}

int main(int argc, char **argv)
{
    const int trials = argc > 1 ? atoi(argv[1]) : random_trials(24);
    int films = 0;

    for (int k = 0; k < trials; k++) {
        random_seed((uint64_t)k + 1);
        const boundary b = random_boundary();
        films += try_boundary(&b, k);
    }
    printf("%d films, %d not found\n", films, trials - films);
    CHECK(trials < 24 || 10 * films >= 9 * trials, "%d films of %d", films, trials);
    return check_failures != 0;
}
