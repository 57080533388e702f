#include "taut/status.h"

/* The list is in the order of the enum, so its rows are indexed by status. */
static const struct {
    int exit_code;
    const char *text;
} rows[] = {
#define TAUT_STATUS_ROW(name, exit_code, meaning) {exit_code, meaning},
    TAUT_STATUS_LIST(TAUT_STATUS_ROW)
#undef TAUT_STATUS_ROW
};

static int is_known(taut_status status)
{
    return (int)status >= 0 && (int)status < (int)(sizeof rows / sizeof rows[0]);
}

const char *taut_status_text(taut_status status)
{
    return is_known(status) ? rows[status].text : "an unknown status";
}

int taut_status_exit_code(taut_status status)
{
    return is_known(status) ? rows[status].exit_code : 6;
}
