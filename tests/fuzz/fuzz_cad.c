/* fuzz_cad.c -- what is looked at in STEP and IGES files before a library reads them.
 *
 * The bytes are taken for both: they pass, or are refused with a message. */
#include "io/cad/scan.h"

#include <stdint.h>
#include <stdlib.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

typedef taut_status scan_function(const char *text, size_t length, taut_error *error);

static void check(scan_function *scan, const char *text, size_t size)
{
    taut_error error = {.status = TAUT_OK};
    const taut_status status = scan(text, size, &error);
    if (status != TAUT_OK && (status != TAUT_BAD_INPUT || error.message[0] == '\0')) {
        abort();
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    const char *text = (const char *)data;
    int is_huge = 0;
    if (taut_cad_number(text, size, "EeDd", &is_huge) > size) {
        abort();
    }
    check(taut_cad_scan_step, text, size);
    check(taut_cad_scan_iges, text, size);
    return 0;
}
