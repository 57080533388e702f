/* test_certificate.c -- claims go in and come out, and one that is false makes the whole false. */
#include "check.h"

#include "taut/certify.h"

#include <string.h>

static taut_certificate *certificate_of(int count, const taut_verdict *verdicts)
{
    taut_certificate *certificate = NULL;
    CHECK(taut_certificate_new("name", &certificate) == TAUT_OK, "new");
    for (int i = 0; i < count; i++) {
        const taut_claim claim = {.claim = "claim",
                                  .kind = TAUT_EXACT,
                                  .residual = i,
                                  .limit = 2.0 * i,
                                  .holds = verdicts[i],
                                  .where = NULL};
        CHECK(taut_certificate_add(certificate, &claim) == TAUT_OK, "i=%d", i);
    }
    return certificate;
}

/* False before undecided before true, wherever it stands. */
static void test_verdict(void)
{
    for (int n = 0; n <= 4; n++) {
        int combinations = 1;
        for (int i = 0; i < n; i++) {
            combinations *= 3;
        }
        for (int code = 0; code < combinations; code++) {
            taut_verdict verdicts[4] = {TAUT_TRUE};
            taut_verdict expected = TAUT_TRUE;
            taut_certificate *certificate = NULL;
            for (int i = 0, rest = code; i < n; i++, rest /= 3) {
                verdicts[i] = (taut_verdict)(rest % 3);
                if (verdicts[i] == TAUT_FALSE || expected == TAUT_FALSE) {
                    expected = TAUT_FALSE;
                } else if (verdicts[i] == TAUT_UNDECIDED) {
                    expected = TAUT_UNDECIDED;
                }
            }
            certificate = certificate_of(n, verdicts);
            CHECK(taut_certificate_holds(certificate) == expected, "n=%d code=%d", n, code);
            taut_certificate_free(certificate);
        }
    }
}

static void test_copy(void)
{
    const taut_verdict verdicts[] = {TAUT_TRUE, TAUT_UNDECIDED};
    taut_certificate *certificate = certificate_of(2, verdicts);
    taut_certificate *copy = NULL;
    taut_record *figures = taut_record_new();
    taut_record_add_number(figures, "area", 4.25);
    taut_certificate_set_figures(certificate, figures);
    CHECK(taut_certificate_copy(certificate, &copy) == TAUT_OK, "copy");
    taut_certificate_free(certificate);

    CHECK(strcmp(taut_certificate_construct(copy), "name") == 0, "construct");
    CHECK(taut_certificate_claim_count(copy) == 2, "claims");
    CHECK(taut_certificate_claim(copy, 2) == NULL && taut_certificate_claim(copy, -1) == NULL,
          "beyond");
    for (int i = 0; i < 2; i++) {
        const taut_claim *claim = taut_certificate_claim(copy, i);
        CHECK(strcmp(claim->claim, "claim") == 0 && strcmp(claim->where, "") == 0, "i=%d", i);
        CHECK(claim->residual == i && claim->limit == 2 * i && claim->holds == verdicts[i], "i=%d",
              i);
    }
    CHECK_NEAR(taut_record_number(taut_record_get(taut_certificate_figures(copy), "area")), 4.25, 0,
               "figures");
    taut_certificate_free(copy);
    taut_certificate_free(NULL);
}

int main(void)
{
    test_verdict();
    test_copy();
    return check_failures != 0;
}
