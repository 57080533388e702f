#include "io/json/out.h"

#include "core/memory.h"
#include "io/json/utf8.h"
#include "platform/parallel.h"

#include <string.h>

taut_json_out taut_json_out_to(FILE *file)
{
    return (taut_json_out){.sink = taut_sink_to(file), .is_first = 1};
}

static void new_line(taut_json_out *out)
{
    static const char spaces[] = "                                ";
    size_t indent = 2 * (size_t)out->depth;
    taut_sink_bytes(&out->sink, "\n", 1);
    while (indent > 0) {
        const size_t some = indent < sizeof spaces - 1 ? indent : sizeof spaces - 1;
        taut_sink_bytes(&out->sink, spaces, some);
        indent -= some;
    }
}

/* What stands before an item or a key. */
static void separate(taut_json_out *out)
{
    if (out->has_key) {
        out->has_key = 0;
        return;
    }
    if (!out->is_first) {
        taut_sink_text(&out->sink, out->inline_ > 0 ? ", " : ",");
    }
    if (out->inline_ == 0 && out->depth > 0) {
        new_line(out);
    }
    out->is_first = 0;
}

void taut_json_open(taut_json_out *out, char c)
{
    separate(out);
    taut_sink_bytes(&out->sink, &c, 1);
    out->depth++;
    out->inline_ += out->inline_ > 0;
    out->is_first = 1;
}

void taut_json_open_inline(taut_json_out *out, char c)
{
    taut_json_open(out, c);
    out->inline_ += out->inline_ == 0;
}

void taut_json_close(taut_json_out *out, char c)
{
    out->depth--;
    if (out->inline_ == 0 && !out->is_first) {
        new_line(out);
    }
    out->inline_ -= out->inline_ > 0;
    out->is_first = 0;
    taut_sink_bytes(&out->sink, &c, 1);
}

/* A string with its quotes. What is not UTF-8 becomes U+FFFD: the document stays one. */
static void put_string(taut_sink *sink, const char *text)
{
    static const char hex[] = "0123456789abcdef";
    const char *end = text + strlen(text);
    taut_sink_bytes(sink, "\"", 1);
    while (*text != '\0') {
        const unsigned char byte = (unsigned char)*text;
        const size_t length = taut_utf8_length(text, end - text > 4 ? 4 : (size_t)(end - text));
        if (byte == '"' || byte == '\\') {
            const char escaped[2] = {'\\', *text};
            taut_sink_bytes(sink, escaped, 2);
        } else if (byte < 0x20 || byte == 0x7f) {
            const char escaped[6] = {'\\', 'u', '0', '0', hex[byte >> 4], hex[byte & 15]};
            taut_sink_bytes(sink, escaped, 6);
        } else if (length == 0) {
            taut_sink_text(sink, "\\ufffd");
        } else {
            taut_sink_bytes(sink, text, length);
        }
        text += length > 0 ? length : 1;
    }
    taut_sink_bytes(sink, "\"", 1);
}

void taut_json_key(taut_json_out *out, const char *key)
{
    separate(out);
    put_string(&out->sink, key);
    taut_sink_bytes(&out->sink, ": ", 2);
    out->has_key = 1;
}

void taut_json_put_number(taut_json_out *out, double x)
{
    separate(out);
    taut_sink_number(&out->sink, x);
}

void taut_json_put_text(taut_json_out *out, const char *text)
{
    separate(out);
    put_string(&out->sink, text);
}

static void put_word(taut_json_out *out, const char *word)
{
    separate(out);
    taut_sink_text(&out->sink, word);
}

void taut_json_put_verdict(taut_json_out *out, taut_verdict verdict)
{
    put_word(out, verdict == TAUT_TRUE ? "true" : verdict == TAUT_FALSE ? "false" : "null");
}

static void put_bare_numbers(taut_sink *sink, size_t count, const double *x)
{
    taut_sink_bytes(sink, "[", 1);
    for (size_t i = 0; i < count; i++) {
        if (i > 0) {
            taut_sink_bytes(sink, ", ", 2);
        }
        taut_sink_number(sink, x[i]);
    }
    taut_sink_bytes(sink, "]", 1);
}

void taut_json_put_numbers(taut_json_out *out, size_t count, const double *x)
{
    separate(out);
    put_bare_numbers(&out->sink, count, x);
}

/* One row on its line. */
static void put_row(taut_json_out *out, size_t columns, size_t size, const double *points)
{
    separate(out);
    if (size == 1) {
        put_bare_numbers(&out->sink, columns, points);
        return;
    }
    taut_sink_bytes(&out->sink, "[", 1);
    for (size_t j = 0; j < columns; j++) {
        if (j > 0) {
            taut_sink_bytes(&out->sink, ", ", 2);
        }
        put_bare_numbers(&out->sink, size, points + j * size);
    }
    taut_sink_bytes(&out->sink, "]", 1);
}

/* Rows of a net that several threads write into memory, a part each, and that go out in order. */
enum {
    NET_PARTS = 64,      /* of one round */
    NET_PART = 1 << 12,  /* numbers of each, or one row */
    NET_LEAST = 1 << 15, /* numbers of a net that is worth it */
};

typedef struct net_round {
    const taut_json_out *out;
    size_t first, rows, parts, columns,
        size;             /* of the rows of this round, parts that differ by one row */
    const double *points; /* of the whole net */
    taut_json_out part[NET_PARTS];
} net_round;

static void put_part(void *context, int worker, int64_t part)
{
    net_round *round = context;
    const size_t p = (size_t)part, from = round->first + round->rows * p / round->parts;
    const size_t upto = round->first + round->rows * (p + 1) / round->parts;
    taut_json_out *own = &round->part[p];

    (void)worker;
    *own = *round->out;
    own->sink = taut_sink_to(NULL);
    own->is_first = from == 0;
    for (size_t i = from; i < upto; i++) {
        put_row(own, round->columns, round->size, round->points + i * round->columns * round->size);
    }
}

/* The first trouble of a part is the whole's. */
static void append_part(taut_json_out *out, taut_json_out *part)
{
    const taut_status status = taut_sink_finish(&part->sink);

    if (status == TAUT_OK) {
        taut_sink_bytes(&out->sink, part->sink.text, part->sink.length);
        taut_free(part->sink.text);
    } else if (out->sink.status == TAUT_OK) {
        out->sink.status = status;
    }
}

static void put_rounds(taut_json_out *out, size_t rows, size_t columns, size_t size,
                       const double *points)
{
    const size_t most = 1 + NET_PARTS * (size_t)NET_PART / (columns * size); /* rows of a round */
    net_round round = {.out = out, .columns = columns, .size = size, .points = points};

    while (round.first < rows && out->sink.status == TAUT_OK) {
        round.rows = rows - round.first < most ? rows - round.first : most;
        round.parts = round.rows < NET_PARTS ? round.rows : NET_PARTS;
        taut_parallel_run(taut_parallel_workers(out->threads, (int64_t)round.parts),
                          (int64_t)round.parts, put_part, &round);
        for (size_t p = 0; p < round.parts; p++) {
            append_part(out, &round.part[p]);
        }
        round.first += round.rows;
    }
    out->is_first = 0;
}

void taut_json_put_net(taut_json_out *out, size_t rows, size_t columns, size_t size,
                       const double *points)
{
    if (rows == 0) {
        put_row(out, columns, size, points);
        return;
    }
    taut_json_open(out, '[');
    if (out->threads > 1 && rows * columns * size >= NET_LEAST) {
        put_rounds(out, rows, columns, size, points);
    } else {
        for (size_t i = 0; i < rows; i++) {
            put_row(out, columns, size, points + i * columns * size);
        }
    }
    taut_json_close(out, ']');
}

/* Does it fit a line: a list of plain values? */
static int is_short(const taut_record *record)
{
    const size_t count = taut_record_count(record);
    for (size_t i = 0; i < count; i++) {
        const taut_record_kind kind = taut_record_kind_of(taut_record_at(record, i));
        if (kind == TAUT_RECORD_LIST || kind == TAUT_RECORD_OBJECT) {
            return 0;
        }
    }
    return 1;
}

static void put_items(taut_json_out *out, const taut_record *record, int is_object)
{
    const size_t count = taut_record_count(record);
    if (!is_object && is_short(record)) {
        taut_json_open_inline(out, '[');
    } else {
        taut_json_open(out, is_object ? '{' : '[');
    }
    for (size_t i = 0; i < count; i++) {
        if (is_object) {
            taut_json_key(out, taut_record_key(record, i));
        }
        taut_json_put_record(out, taut_record_at(record, i));
    }
    taut_json_close(out, is_object ? '}' : ']');
}

void taut_json_put_record(taut_json_out *out, const taut_record *record)
{
    const taut_record_kind kind = taut_record_kind_of(record);
    if (kind == TAUT_RECORD_OBJECT || kind == TAUT_RECORD_LIST) {
        put_items(out, record, kind == TAUT_RECORD_OBJECT);
    } else if (kind == TAUT_RECORD_NUMBER) {
        taut_json_put_number(out, taut_record_number(record));
    } else if (kind == TAUT_RECORD_TEXT) {
        taut_json_put_text(out, taut_record_text(record));
    } else if (kind == TAUT_RECORD_BOOL) {
        put_word(out, taut_record_bool(record) ? "true" : "false");
    } else {
        put_word(out, "null");
    }
}

void taut_json_open_pair(taut_json_out *out, const char *key, char c)
{
    taut_json_key(out, key);
    taut_json_open(out, c);
}

void taut_json_pair_number(taut_json_out *out, const char *key, double x)
{
    taut_json_key(out, key);
    taut_json_put_number(out, x);
}

void taut_json_pair_numbers(taut_json_out *out, const char *key, size_t count, const double *x)
{
    taut_json_key(out, key);
    taut_json_put_numbers(out, count, x);
}

void taut_json_pair_text(taut_json_out *out, const char *key, const char *text)
{
    taut_json_key(out, key);
    taut_json_put_text(out, text);
}

void taut_json_pair_verdict(taut_json_out *out, const char *key, taut_verdict verdict)
{
    taut_json_key(out, key);
    taut_json_put_verdict(out, verdict);
}

void taut_json_pair_net(taut_json_out *out, const char *key, size_t rows, size_t columns,
                        size_t size, const double *points)
{
    taut_json_key(out, key);
    taut_json_put_net(out, rows, columns, size, points);
}

void taut_json_pair_record(taut_json_out *out, const char *key, const taut_record *record)
{
    taut_json_key(out, key);
    taut_json_put_record(out, record);
}

taut_status taut_json_out_finish(taut_json_out *out)
{
    taut_sink_bytes(&out->sink, "\n", 1);
    return taut_sink_finish(&out->sink);
}
