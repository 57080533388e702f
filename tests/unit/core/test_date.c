/* test_date.c -- dates by the calendar against those of the C library. */
#include "check.h"

#include "core/date.h"

#include <string.h>
#include <time.h>

/* There is a C library that knows no date from the year 3001 on. */
static const int64_t end_of_some = 32535216000;

static void compare(int64_t seconds)
{
    const time_t date = (time_t)seconds;
    const struct tm *parts = gmtime(&date);
    char found[TAUT_DATE_ROOM], expected[TAUT_DATE_ROOM] = "";
    taut_date_text(seconds, found);
    if (parts == NULL && seconds >= end_of_some) {
        return;
    }
    CHECK(parts != NULL && strftime(expected, sizeof expected, "%Y-%m-%dT%H:%M:%S", parts) == 19,
          "second %.0f", (double)seconds);
    CHECK(strcmp(found, expected) == 0, "%s for %s", found, expected);
}

int main(void)
{
    char text[TAUT_DATE_ROOM];

    taut_date_text(0, text);
    CHECK(strcmp(text, "1970-01-01T00:00:00") == 0, "%s", text);
    taut_date_text(TAUT_DATE_MOST, text);
    CHECK(strcmp(text, "9999-12-31T23:59:59") == 0, "%s", text);
    for (int64_t day = 0; day <= TAUT_DATE_MOST / 86400; day += day < 60000 ? 1 : 13) {
        compare(86400 * day + day * 7919 % 86400);
    }
    return check_failures != 0;
}
