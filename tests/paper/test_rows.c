/* test_rows.c -- the rows of every paper are what they must be: a source, a reason, a tolerance of
 * half a unit of the last digit printed or less, and the right number wherever the paper is wrong.
 */
#include "check.h"

#include "cli/embedded_files.h"
#include "taut/read.h"

#include <stdlib.h>
#include <string.h>

static const char *text(const taut_record *row, const char *key)
{
    return taut_record_text(taut_record_get(row, key));
}

/* "-0.2756" or "-5/12" */
static double value_of(const char *printed)
{
    const char *slash = strchr(printed, '/');
    return strtod(printed, NULL) / (slash != NULL ? strtod(slash + 1, NULL) : 1);
}

/* Half a unit of the last digit of "-0.2756" or "1.2e-5"; a fraction is exact, so a rounding of it.
 */
static double half_unit(const char *printed)
{
    if (strchr(printed, '/') != NULL) {
        return 0x1p-48 * fmax(1, fabs(value_of(printed)));
    }
    const char *point = strchr(printed, '.'), *e = strpbrk(printed, "eE");
    const size_t decimals = point != NULL ? strcspn(point + 1, "eE") : 0;
    return 0.5 * pow(10, (e != NULL ? strtod(e + 1, NULL) : 0) - (double)decimals);
}

static void check_row(const taut_record *row, const char *paper, size_t i)
{
    const char *printed = text(row, "printed"), *erratum = text(row, "erratum");
    const double tolerance = taut_record_number(taut_record_get(row, "tolerance"));
    const double expected = taut_record_number(taut_record_get(row, "expected"));
    CHECK(text(row, "source")[0] == '[', "%s row %zu has no source", paper, i);
    CHECK(text(row, "because")[0] != '\0', "%s row %zu does not say why its tolerance", paper, i);
    CHECK(text(row, "problem")[0] != '\0' && text(row, "quantity")[0] != '\0', "%s row %zu", paper,
          i);
    CHECK(tolerance > 0 && tolerance < 1, "%s row %zu: tolerance %g", paper, i, tolerance);
    if (erratum[0] == '\0' && printed[0] != '\0') {
        CHECK(tolerance <= 1.000001 * half_unit(printed), "%s row %zu: %s within %g", paper, i,
              printed, tolerance);
    } else {
        CHECK(!isnan(expected), "%s row %zu has no right number", paper, i);
    }
    if (erratum[0] != '\0') {
        CHECK(fabs(value_of(printed) - expected) > half_unit(printed),
              "%s row %zu: the erratum is none", paper, i);
    }
}

int main(void)
{
    for (const taut_embedded *paper = taut_papers; paper->name != NULL; paper++) {
        taut_record *record = NULL;
        taut_error error = {.message = ""};
        CHECK(taut_record_read_text(paper->text, paper->length, paper->name, &record, &error) ==
                  TAUT_OK,
              "%s: %s %s", paper->name, error.where, error.message);
        const taut_record *rows = taut_record_get(record, "rows");
        CHECK(taut_record_count(rows) > 0, "%s has no rows", paper->name);
        for (size_t i = 0; i < taut_record_count(rows); i++) {
            check_row(taut_record_at(rows, i), paper->name, i);
        }
        taut_record_free(record);
    }
    return check_failures != 0;
}
