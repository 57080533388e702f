/* test_roll.c -- pieces that lie into each other on their roll are proved apart; one moved by less than the gap still is, by more no
 * longer; nor is one inside another one, turned the wrong way, or outside the roll. */
#include "certificates.h"
#include "check.h"
#include "cloths.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The verdict on the roll of a model whose pieces' places on it are others: at += by, or of `as`, turned or not. */
static taut_verdict judge(const made_cloth *made, int piece, const double by[2], const char *turned,
                          int as)
{
    const taut_record *list =
        taut_record_get(taut_record_get(taut_model_details(made->model), "roll"), "pieces");
    char *text = NULL, *whole = NULL, item[200];
    size_t length = 0;
    taut_model *model = NULL;
    taut_certificate *proof = NULL;
    taut_error error = {.message = ""};

    taut_model_write_text(made->model, "json", NULL, &text, &length, NULL);
    snprintf(item, sizeof item, "\"name\": \"P%d\",\n          \"at\": [", piece + 1);
    char *begin = text != NULL ? strstr(text, item) : NULL,
         *end = begin ? strchr(begin, '}') : NULL;
    CHECK(begin != NULL && end != NULL, "P%d on the roll", piece + 1);
    const taut_record *at = taut_record_get(taut_record_at(list, (size_t)as), "at");
    snprintf(item, sizeof item, "\"name\": \"P%d\", \"at\": [%.17g, %.17g]%s", piece + 1,
             taut_record_number(taut_record_at(at, 0)) + by[0],
             taut_record_number(taut_record_at(at, 1)) + by[1], turned);
    whole = calloc(1, length + sizeof item);
    if (whole != NULL && begin != NULL && end != NULL) {
        memcpy(whole, text, (size_t)(begin - text));
        strcat(whole, item);
        strcat(whole, end);
        CHECK(taut_model_read_text(whole, strlen(whole), "json", &model, &error) == TAUT_OK, "%s",
              error.message);
    }
    CHECK(taut_certify(model, made->problem, NULL, &proof, &error) == TAUT_OK, "%s", error.message);
    const taut_verdict verdict = claim_of(proof, "roll")->holds;
    taut_certificate_free(proof);
    taut_model_free(model);
    taut_text_free(text);
    free(whole);
    return verdict;
}

int main(void)
{
    static const double none[2] = {0, 0}, less[2] = {0.009, 0}, out[2] = {-0.011, 0},
                        inside[2] = {0.3, 0}, across[2] = {3.5, 0};
    made_cloth made = cloth_make(
        SADDLE, "\"seams\": [{ \"across\": [\"v0\", \"v1\"], \"count\": 3 }], \"cloth\": { "
                "\"width\": 1.8, \"gap\": 0.02 }");
    CHECK(made.status == TAUT_OK, "%s", made.error.message);
    const taut_record *list =
        taut_record_get(taut_record_get(taut_model_details(made.model), "roll"), "pieces");
    /* two abreast at the roll's beginning, the third behind them */
    int last = 0, first = 0;
    for (int k = 0; k < 3; k++) {
        const taut_record *at = taut_record_get(taut_record_at(list, (size_t)k), "at");
        const double x = taut_record_number(taut_record_at(at, 0));
        last = x > 2 ? k : last;
        first = x < 1 ? k : first;
    }
    CHECK(judge(&made, first, none, "", first) == TAUT_TRUE, "as it is");
    CHECK(claim_of(made.proof, "roll")->kind == TAUT_BOUND, "a bound");
    const double back[2] = {-less[0], 0}, into[2] = {-0.06, 0};
    const char *turned = taut_record_get(taut_record_at(list, (size_t)last), "turned") != NULL
                             ? ", \"turned\": true"
                             : "";
    CHECK(judge(&made, last, back, turned, last) == TAUT_TRUE, "moved by half of the gap");
    CHECK(judge(&made, last, into, turned, last) == TAUT_FALSE, "moved by more than the gap");
    CHECK(judge(&made, first, out, "", first) == TAUT_FALSE, "moved out of the roll");
    CHECK(judge(&made, last, inside, turned, first) == TAUT_FALSE, "on top of another one");
    /* turned, so that neither's first corner lies in the other one: only their lines cross */
    CHECK(judge(&made, last, across, ", \"turned\": true", first) == TAUT_FALSE,
          "across another one");
    CHECK(judge(&made, last, none, turned[0] == '\0' ? ", \"turned\": true" : "", last) ==
              TAUT_FALSE,
          "turned the wrong way");
    cloth_free(&made);
    return check_failures != 0;
}
