#include "io/file/sink.h"

#include "core/memory.h"
#include "core/number_text.h"

#include <errno.h>
#include <math.h>
#include <string.h>

enum {
    BUFFER_ROOM = 1 << 16,
    FIRST_ROOM = 1 << 10,
    BYTE_WORK = 30 /* operations, as pulses count them: numbers become decimals */
};

taut_sink taut_sink_to(FILE *file)
{
    taut_sink sink = {.file = file, .status = TAUT_OK};
    sink.room = file != NULL ? BUFFER_ROOM : FIRST_ROOM;
    sink.text = taut_alloc(sink.room, 1);
    if (sink.text == NULL) {
        sink.status = TAUT_NO_MEMORY;
        sink.room = 0;
    }
    return sink;
}

void taut_sink_watch(taut_sink *sink, const taut_monitor *monitor)
{
    sink->pulse = (taut_pulse){
        .monitor = monitor->progress != NULL ? monitor : NULL, .what = "writing", .done = NAN};
}

static void send_bytes(taut_sink *sink, const char *bytes, size_t length)
{
    errno = 0;
    if (fwrite(bytes, 1, length, sink->file) != length) {
        sink->status = TAUT_IO;
        sink->reason = errno != 0 ? errno : EIO;
    }
}

/* Makes room for `length` bytes more: by emptying the buffer, or by growing it. */
static void make_room(taut_sink *sink, size_t length)
{
    if (sink->file != NULL) {
        send_bytes(sink, sink->text, sink->length);
        sink->length = 0;
    } else {
        size_t factor = 2;
        char *larger = NULL;
        while (factor * sink->room - sink->length < length) {
            factor *= 2;
        }
        larger = taut_realloc(sink->text, factor, sink->room);
        if (larger == NULL) {
            sink->status = TAUT_NO_MEMORY;
        } else {
            sink->text = larger;
            sink->room *= factor;
        }
    }
}

void taut_sink_bytes(taut_sink *sink, const char *bytes, size_t length)
{
    if (sink->pulse.monitor != NULL && sink->status == TAUT_OK &&
        taut_pulse_beat(&sink->pulse, (double)BYTE_WORK * (double)length)) {
        sink->status = TAUT_INTERRUPTED;
    }
    if (sink->status == TAUT_OK && length > sink->room - sink->length) {
        make_room(sink, length);
    }
    if (sink->status != TAUT_OK) {
        return;
    }
    if (length > sink->room) {
        send_bytes(sink, bytes, length);
        return;
    }
    memcpy(sink->text + sink->length, bytes, length);
    sink->length += length;
}

void taut_sink_text(taut_sink *sink, const char *text)
{
    taut_sink_bytes(sink, text, strlen(text));
}

void taut_sink_number(taut_sink *sink, double x)
{
    char text[TAUT_NUMBER_ROOM];
    if (sink->status != TAUT_OK) {
        return;
    }
    const size_t length = taut_number_text(x, text);
    taut_sink_bytes(sink, text, length);
}

void taut_sink_count(taut_sink *sink, size_t n)
{
    char text[24];
    char *begin = text + sizeof text;
    do {
        *--begin = (char)('0' + n % 10);
        n /= 10;
    } while (n > 0);
    taut_sink_bytes(sink, begin, (size_t)(text + sizeof text - begin));
}

void taut_sink_low_bytes(taut_sink *sink, uint64_t value, size_t count)
{
    char bytes[8];
    for (size_t i = 0; i < count; i++) {
        bytes[i] = (char)(unsigned char)(value >> (8 * i) & 0xff);
    }
    taut_sink_bytes(sink, bytes, count);
}

taut_status taut_sink_finish(taut_sink *sink)
{
    if (sink->file != NULL) {
        if (sink->status == TAUT_OK) {
            send_bytes(sink, sink->text, sink->length);
        }
        errno = 0;
        if (sink->status == TAUT_OK && fflush(sink->file) != 0) {
            sink->status = TAUT_IO;
            sink->reason = errno != 0 ? errno : EIO;
        }
        taut_free(sink->text);
        sink->text = NULL;
    } else {
        taut_sink_bytes(sink, "", 1);
        if (sink->status != TAUT_OK) {
            taut_free(sink->text);
            sink->text = NULL;
        } else {
            sink->length--;
        }
    }
    errno = sink->reason;
    return sink->status;
}
