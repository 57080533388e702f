/* html.c -- the format `html`: a page to turn the model in, one file that asks for no other.
 *
 * src/page/viewer/page.html with its places filled: @name@ for the file of that name, @data@ for the
 * numbers and names of the model as JSON (html_data.c), @document@ for the model's document. In these every < is written \u003c, which
 * within a JSON text can only stand in a string and means the same there: so no name, however
 * hostile, ends the element that holds it. The page's scripts put text into the page as text only.
 */
#include "core/fail.h"
#include "core/memory.h"
#include "io/flat/spread.h"
#include "io/format.h"
#include "io/mesh/out.h"
#include "page/html_page.h"
#include "page/viewer_files.h"
#include "taut/write.h"

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

enum { DOCUMENT_MOST = 1 << 20 }; /* bytes of the model in its page */

/* JSON that the page carries: its text, or of no length. */
typedef struct json_text {
    const char *name; /* of its place */
    char *text;
    size_t length;
} json_text;

static void put_place(taut_sink *sink, const char *name, size_t length, const json_text texts[2])
{
    const taut_viewer_file *file = find_file(name, length);
    if (file != NULL) {
        taut_sink_bytes(sink, file->text, file->length);
    }
    for (int k = 0; file == NULL && k < 2; k++) {
        if (length == strlen(texts[k].name) && memcmp(name, texts[k].name, length) == 0) {
            put_data(sink, texts[k].text, texts[k].length);
        }
    }
}

/* The template, its places filled. A place stands alone between two @ without blanks. */
static void put_page(taut_sink *sink, const json_text texts[2])
{
    const taut_viewer_file *page = find_file("page.html", strlen("page.html"));
    const char *at = page->text, *end = page->text + page->length;

    while (at < end) {
        const char *mark = memchr(at, '@', (size_t)(end - at));
        const char *close = mark != NULL ? memchr(mark + 1, '@', (size_t)(end - mark - 1)) : NULL;
        if (close == NULL) {
            taut_sink_bytes(sink, at, (size_t)(end - at));
            return;
        }
        taut_sink_bytes(sink, at, (size_t)(mark - at));
        put_place(sink, mark + 1, (size_t)(close - mark - 1), texts);
        at = close + 1;
    }
}

/* The model itself, that the page can give it away: of no length where it is too large for that. */
static taut_status document_text(const taut_model *model, const taut_write_options *options,
                                 json_text *document, taut_error *error)
{
    const taut_write_options only = {.surface = options->surface, .monitor = options->monitor};
    const taut_status status =
        taut_model_write_text(model, "json", &only, &document->text, &document->length, error);

    if (status == TAUT_OK && document->length > DOCUMENT_MOST) {
        document->length = 0;
    }
    return status;
}

static taut_status write_html(const taut_model *model, const taut_write_options *options, FILE *out,
                              taut_error *error)
{
    json_text texts[2] = {{.name = "data"}, {.name = "document"}};
    taut_model *spread = NULL;
    taut_status status = taut_flat_spread(model, NULL, &spread);

    if (status != TAUT_OK) {
        return taut_fail_memory(error);
    }
    status = taut_html_data(spread != NULL ? spread : model, options, &texts[0].text,
                            &texts[0].length, error);
    taut_model_free(spread);
    if (status == TAUT_OK) {
        status = document_text(model, options, &texts[1], error);
    }
    if (status == TAUT_OK) {
        taut_sink sink = taut_sink_to(out);
        put_page(&sink, texts);
        status = taut_mesh_out_finish(&sink, error);
    }
    taut_free(texts[0].text);
    taut_text_free(texts[1].text);
    return status;
}

const taut_format_ops taut_format_html = {.write = write_html};
