/* test_ruled_out.c -- strains that are proved to be unavoidable: refused before anything is laid flat, with a number of strips of which
 * that is not proved; with one less it is. */
#include "check.h"
#include "cloths.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Of so many strips and a strain; the number that is told, 0: made, -1: refused with none. */
static int try_strips(const char *of, const char *rule, int count, double strain, double *least)
{
    char members[256];
    snprintf(members, sizeof members, "\"seams\": [{ %s, \"count\": %d }], \"strain\": %.17g", rule,
             count, strain);
    made_cloth made = cloth_make(of, members);
    const char *told = strstr(made.error.message, "at least ");
    const int found = made.status == TAUT_OK ? 0 : told != NULL ? atoi(told + 9) : -1;
    if (made.status != TAUT_OK) {
        CHECK(made.status == TAUT_NO_SOLUTION && strcmp(made.error.reason, "strain") == 0 &&
                  strcmp(made.error.where, "/strain") == 0 && made.error.limit == strain &&
                  made.error.found > strain,
              "%s: %s", made.error.reason, made.error.message);
    }
    *least = made.status == TAUT_OK ? 0 : made.error.found;
    cloth_free(&made);
    return found;
}

int main(void)
{
    static const char across[] = "\"across\": [\"v0\", \"v1\"]";
    double least, other;
    const int found = try_strips(SADDLE, across, 4, 0.001, &least);
    CHECK(found == 5, "%d strips", found);
    CHECK(try_strips(SADDLE, across, found, 0.001, &other) == 0, "%d are not ruled out", found);
    CHECK(try_strips(SADDLE, across, 3, 0.001, &other) == found && other > least,
          "%g of three strips, %g of four", other, least);
    CHECK(try_strips(SADDLE, across, 4, least * (1 - 1e-9), &other) > 0 && other == least,
          "the strain itself: %.17g", other);
    CHECK(try_strips(SADDLE, across, 4, least * (1 + 1e-9), &other) == 0, "and hardly more");
    return check_failures != 0;
}
