/* html.c -- the format `html`: a page to turn the model in, one file that asks for no other.
 *
 * src/page/viewer/page.html with its places filled: @name@ for the file of that name, @data@ for the
 * numbers and names of the model as JSON (html_data.c). In that every < is written \u003c, which
 * within a JSON text can only stand in a string and means the same there: so no name, however
 * hostile, ends the element that holds it. The page's scripts put text into the page as text only.
 */
#include "core/fail.h"
#include "core/memory.h"
#include "io/format.h"
#include "io/mesh/out.h"
#include "page/html_page.h"
#include "page/viewer_files.h"

#include <string.h>

static const taut_viewer_file *find_file(const char *name, size_t length)
{
    for (const taut_viewer_file *file = taut_viewer_files; file->name != NULL; file++) {
        if (strlen(file->name) == length && memcmp(file->name, name, length) == 0) {
            return file;
        }
    }
    return NULL;
}

static void put_data(taut_sink *sink, const char *data, size_t length)
{
    size_t from = 0;
    for (size_t i = 0; i < length; i++) {
        if (data[i] == '<') {
            taut_sink_bytes(sink, data + from, i - from);
            taut_sink_text(sink, "\\u003c");
            from = i + 1;
        }
    }
    taut_sink_bytes(sink, data + from, length - from);
}

/* The template, its places filled. A place stands alone between two @ without blanks. */
static void put_page(taut_sink *sink, const char *data, size_t data_length)
{
    static const char data_place[] = "data";
    const taut_viewer_file *page = find_file("page.html", strlen("page.html"));
    const char *at = page->text, *end = page->text + page->length;

    while (at < end) {
        const char *mark = memchr(at, '@', (size_t)(end - at));
        const char *close = mark != NULL ? memchr(mark + 1, '@', (size_t)(end - mark - 1)) : NULL;
        if (close == NULL) {
            taut_sink_bytes(sink, at, (size_t)(end - at));
            return;
        }
        const size_t length = (size_t)(close - mark - 1);
        const taut_viewer_file *file = find_file(mark + 1, length);
        taut_sink_bytes(sink, at, (size_t)(mark - at));
        if (file != NULL) {
            taut_sink_bytes(sink, file->text, file->length);
        } else if (length == strlen(data_place) && memcmp(mark + 1, data_place, length) == 0) {
            put_data(sink, data, data_length);
        }
        at = close + 1;
    }
}

static taut_status write_html(const taut_model *model, const taut_write_options *options, FILE *out,
                              taut_error *error)
{
    char *data = NULL;
    size_t length = 0;
    taut_status status = taut_html_data(model, options, &data, &length, error);

    if (status != TAUT_OK) {
        return status;
    }
    taut_sink sink = taut_sink_to(out);
    put_page(&sink, data, length);
    status = taut_mesh_out_finish(&sink, error);
    taut_free(data);
    return status;
}

const taut_format_ops taut_format_html = {.write = write_html};
