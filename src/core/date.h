/* date.h -- a second as a date, by the calendar alone: no zone, and no language of the C library. */
#ifndef TAUT_CORE_DATE_H
#define TAUT_CORE_DATE_H

#include <stdint.h>
#include <stdio.h>

enum { TAUT_DATE_ROOM = 64 };
#define TAUT_DATE_MOST INT64_C(253402300799) /* the last second of the year 9999 */

/* "1970-01-01T00:00:00" of second 0; 0 <= seconds <= TAUT_DATE_MOST. Years begin in March here, so that the day that only some
 * have is their last; 400 years have 146097 days. */
static inline void taut_date_text(int64_t seconds, char text[TAUT_DATE_ROOM])
{
    const int from_march =
        719468; /* days from the first of March of the year 0 to that of second 0 */
    const int days = (int)(seconds / 86400) + from_march, rest = (int)(seconds % 86400);
    const int age = days % 146097, year = (age - age / 1460 + age / 36524 - age / 146096) / 365;
    const int day = age - (365 * year + year / 4 - year / 100), month = (5 * day + 2) / 153;
    const int is_next = month >= 10;
    snprintf(text, TAUT_DATE_ROOM, "%04d-%02d-%02dT%02d:%02d:%02d",
             days / 146097 * 400 + year + is_next, is_next ? month - 9 : month + 3,
             day - (153 * month + 2) / 5 + 1, rest / 3600, rest / 60 % 60, rest % 60);
}

#endif /* TAUT_CORE_DATE_H */
