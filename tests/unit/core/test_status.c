/* test_status.c -- statuses, their exit codes, and what a failure carries. */
#include "check.h"

#include "core/fail.h"
#include "taut/version.h"

#include <stdio.h>
#include <string.h>

/* The exit codes are a promise to scripts. */
static void test_exit_codes(void)
{
    static const struct {
        taut_status status;
        int code;
    } promised[] = {{TAUT_OK, 0},           {TAUT_NOT_CONVERGED, 1}, {TAUT_CHECK_FAILED, 1},
                    {TAUT_BAD_ARGUMENT, 2}, {TAUT_BAD_INPUT, 3},     {TAUT_NO_SOLUTION, 4},
                    {TAUT_IO, 5},           {TAUT_NO_MEMORY, 6},     {TAUT_INTERNAL, 6},
                    {TAUT_INTERRUPTED, 130}};
    for (size_t i = 0; i < sizeof promised / sizeof promised[0]; i++) {
        CHECK(taut_status_exit_code(promised[i].status) == promised[i].code, "i=%zu", i);
        CHECK(strlen(taut_status_text(promised[i].status)) > 3, "i=%zu", i);
    }
    CHECK(taut_status_exit_code((taut_status)99) == 6, "a status that is none");
    CHECK(strlen(taut_status_text((taut_status)99)) > 3, "a status that is none");
}

static void test_fail(void)
{
    taut_error error;
    char longest[1000];
    memset(&error, 1, sizeof error);
    CHECK(taut_fail(&error, TAUT_BAD_INPUT, "value", "/knots/3", 2, 1, "%d of %s", 2, "them") ==
              TAUT_BAD_INPUT,
          "the status comes back");
    CHECK(error.status == TAUT_BAD_INPUT && error.found == 2 && error.limit == 1, "numbers");
    CHECK(strcmp(error.where, "/knots/3") == 0, "%s", error.where);
    CHECK(strcmp(error.message, "2 of them") == 0, "%s", error.message);
    taut_error_prefix(&error, "/u");
    CHECK(strcmp(error.where, "/u/knots/3") == 0, "%s", error.where);

    memset(longest, 'x', sizeof longest - 1);
    longest[sizeof longest - 1] = '\0';
    CHECK(taut_fail(&error, TAUT_IO, "file", longest, taut_none, taut_none, "%s", longest) ==
              TAUT_IO,
          "too long");
    CHECK(strlen(error.where) == sizeof error.where - 1, "cut");
    CHECK(strlen(error.message) == sizeof error.message - 1, "cut");
    taut_error_prefix(&error, longest);
    CHECK(strlen(error.where) == sizeof error.where - 1, "cut");
    CHECK(isnan(error.found) && isnan(error.limit), "no numbers");

    CHECK(taut_fail(NULL, TAUT_IO, "file", NULL, 0, 0, "x") == TAUT_IO, "nobody listens");
    CHECK(taut_fail_expected(&error, TAUT_BAD_INPUT, "type", "/u", 3, "a list", "found %d", 3) ==
              TAUT_BAD_INPUT,
          "the status comes back");
    CHECK(strcmp(error.reason, "type") == 0 && strcmp(error.expected, "a list") == 0 &&
              strcmp(error.message, "found 3, expected a list") == 0 && isnan(error.limit),
          "%s, %s, %s", error.reason, error.expected, error.message);
    taut_fail_expected(&error, TAUT_BAD_INPUT, "value", "/x", 0.1, "less",
                       "found %.17g and (%.17g), not %.17g", 0.1, -3.1e-220, 1 - 0x1p-53);
    CHECK(strcmp(error.message,
                 "found 0.1 and (-3.1e-220), not 0.9999999999999999, expected less") == 0,
          "%s", error.message);
    taut_fail(&error, TAUT_BAD_INPUT, "value", "/x", 0.1, 1,
              "\"%.17g\" of file-%.17g [%.17g, %.3g]", 0.1, 0.1, 0.1, 0.1);
    CHECK(strcmp(error.message, "\"0.10000000000000001\" of file-0.10000000000000001 [0.1, 0.1]") ==
              0,
          "words are left alone: %s", error.message);
    CHECK(taut_fail_memory(&error) == TAUT_NO_MEMORY && error.status == TAUT_NO_MEMORY, "memory");
    CHECK(error.where[0] == '\0', "nowhere");
    taut_error_prefix(NULL, "/u");
}

static void test_version(void)
{
    char text[32];
    snprintf(text, sizeof text, "%d.%d.%d", TAUT_VERSION_MAJOR, TAUT_VERSION_MINOR,
             TAUT_VERSION_PATCH);
    CHECK(strcmp(text, taut_version()) == 0, "%s is not %s", text, taut_version());
}

int main(void)
{
    test_exit_codes();
    test_fail();
    test_version();
    return check_failures != 0;
}
