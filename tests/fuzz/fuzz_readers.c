/* fuzz_readers.c -- any bytes as a file, by every reader there is: the first line is its ending.
 *
 * A refusal is told whole; a model that was read can be written and read again.
 */
#include "outcome.h"

#include "io/format.h"
#include "taut/read.h"

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

/* The format whose ending is the first line; *used is how long that is. -1: none that is read. */
static int format_of(const uint8_t *data, size_t size, size_t *used)
{
    for (int i = 0; i < taut_format_count(); i++) {
        const char *ending = taut_format_ending(i);
        const size_t length = strlen(ending);
        const int is_read = taut_format_ops_at(i)->read != NULL || strcmp(ending, "json") == 0;
        if (is_read && size > length && memcmp(data, ending, length) == 0 && data[length] == '\n') {
            *used = length + 1;
            return i;
        }
    }
    return -1;
}

/* In memory where the system has such a place. */
static void name_file(int format, char path[64])
{
    const char *folder = access("/dev/shm", W_OK) == 0 ? "/dev/shm" : "/tmp";
    snprintf(path, 64, "%s/taut-fuzz-%ld.%.20s", folder, (long)getpid(),
             taut_format_ending(format));
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    size_t used = 0;
    const int format = format_of(data, size, &used);
    char path[64];
    FILE *file = NULL;
    taut_model *model = NULL;
    taut_error error = {.status = TAUT_OK};

    if (format < 0) {
        return 0;
    }
    name_file(format, path);
    file = fopen(path, "wb");
    if (file == NULL) {
        return 0;
    }
    const int written = fwrite(data + used, 1, size - used, file) == size - used;
    if (fclose(file) == 0 && written) {
        const taut_status status = taut_model_read(path, &model, &error);
        if (status == TAUT_OK) {
            require_model(model);
        } else {
            require_error(status, &error);
            require(model == NULL && status != TAUT_INTERNAL);
        }
    }
    taut_model_free(model);
    unlink(path);
    return 0;
}
