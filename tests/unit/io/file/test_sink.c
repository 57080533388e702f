/* test_sink.c -- text on its way out: what goes in comes out, in memory and through a file, and a
 * file that takes no more is told at the end, with its reason. */
#include "check.h"

#include "core/memory.h"
#include "io/file/sink.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

enum { LARGE = 1 << 17 }; /* more than any buffer */

/* Letters that do not repeat in step with any buffer. */
static char *letters(size_t length)
{
    char *text = malloc(length);
    for (size_t i = 0; i < length; i++) {
        text[i] = (char)('a' + i % 23);
    }
    return text;
}

/* Whatever the sizes of its pieces: one may be many times the room there is. */
static void test_memory(void)
{
    static const size_t sizes[] = {1, 5, 1023, 0, LARGE, 3, 4 * LARGE, 1};
    char *text = letters(4 * LARGE);
    taut_sink sink = taut_sink_to(NULL);
    size_t length = 0;
    for (size_t i = 0; i < sizeof sizes / sizeof sizes[0]; i++) {
        taut_sink_bytes(&sink, text, sizes[i]);
    }
    CHECK(taut_sink_finish(&sink) == TAUT_OK, "finish");
    for (size_t i = 0; i < sizeof sizes / sizeof sizes[0]; i++) {
        CHECK(memcmp(sink.text + length, text, sizes[i]) == 0, "piece %zu", i);
        length += sizes[i];
    }
    CHECK(sink.length == length && sink.text[length] == '\0', "%zu of %zu", sink.length, length);
    taut_free(sink.text);
    free(text);
}

static void test_file(void)
{
    char *text = letters(LARGE), *found = malloc(2 * LARGE + 2);
    FILE *file = tmpfile();
    taut_sink sink = taut_sink_to(file);
    taut_sink_text(&sink, "x");
    taut_sink_bytes(&sink, text, LARGE);
    taut_sink_bytes(&sink, text, LARGE);
    CHECK(taut_sink_finish(&sink) == TAUT_OK, "finish");
    rewind(file);
    CHECK(fread(found, 1, 2 * LARGE + 2, file) == 2 * LARGE + 1, "length");
    CHECK(found[0] == 'x' && memcmp(found + 1, text, LARGE) == 0 &&
              memcmp(found + 1 + LARGE, text, LARGE) == 0,
          "text");
    fclose(file);
    free(text);
    free(found);
}

/* A disk that is full is met when a large piece is sent, or only when the last bytes are. */
static void test_full(void)
{
    char *text = letters(LARGE);
    const size_t sizes[] = {1, LARGE};
    for (int k = 0; k < 2; k++) {
        FILE *file = fopen("/dev/full", "wb");
        taut_sink sink = taut_sink_to(file);
        CHECK(file != NULL, "/dev/full");
        taut_sink_bytes(&sink, text, sizes[k]);
        CHECK(sink.status == (k == 0 ? TAUT_OK : TAUT_IO), "%zu bytes", sizes[k]);
        taut_sink_text(&sink, "after it");
        errno = 0;
        CHECK(taut_sink_finish(&sink) == TAUT_IO && errno == ENOSPC, "%zu bytes: errno %d",
              sizes[k], errno);
        CHECK(sink.text == NULL, "the buffer is gone");
        fclose(file);
    }
    free(text);
}

int main(void)
{
    test_memory();
    test_file();
    test_full();
    return check_failures != 0;
}
