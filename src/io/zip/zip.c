/* zip.c -- for each file its header and its bytes; then all headers again, with where the first ones are, and how many. */
#include "io/zip/zip.h"

#include <assert.h>
#include <string.h>

enum { VERSION = 20, FIRST_DAY = 0x0021, LOCAL = 30, CENTRAL = 46, END = 22 };
enum { SIGN_LOCAL = 0x04034b50, SIGN_CENTRAL = 0x02014b50, SIGN_END = 0x06054b50 };
enum { ROOM = 1 << 16 }; /* for headers, names and the list */
enum { PART = 1 << 18 }; /* bytes at once */

int taut_zip_fits(size_t bytes)
{
    return bytes <= UINT32_MAX - ROOM;
}

uint32_t taut_crc32(const char *bytes, size_t length, taut_pulse *pulse)
{
    enum { BYTE_WORK = 10 }; /* operations, as pulses count them */
    uint32_t table[256], crc = 0xffffffff;
    for (uint32_t i = 0; i < 256; i++) {
        table[i] = i;
        for (int bit = 0; bit < 8; bit++) {
            table[i] = table[i] >> 1 ^ (table[i] & 1 ? 0xedb88320 : 0);
        }
    }
    for (size_t at = 0; at < length; at += PART) {
        const size_t end = length - at < PART ? length : at + PART;
        for (size_t i = at; i < end; i++) {
            crc = crc >> 8 ^ table[(crc ^ (unsigned char)bytes[i]) & 0xff];
        }
        if (taut_pulse_beat(pulse, (double)BYTE_WORK * (double)(end - at))) {
            break;
        }
    }
    return ~crc;
}

taut_zip taut_zip_to(taut_sink *sink)
{
    return (taut_zip){.sink = sink};
}

static void put_16(taut_zip *zip, unsigned value)
{
    taut_sink_low_bytes(zip->sink, value, 2);
}

static void put_32(taut_zip *zip, uint32_t value)
{
    taut_sink_low_bytes(zip->sink, value, 4);
}

/* What both headers of a file say: version, no flags, stored, when, CRC, size twice, length of the name, nothing more. */
static void put_common(taut_zip *zip, const taut_zip_file *file)
{
    put_16(zip, VERSION);
    put_16(zip, 0);
    put_16(zip, 0);
    put_16(zip, 0);
    put_16(zip, FIRST_DAY);
    put_32(zip, file->crc);
    put_32(zip, file->size);
    put_32(zip, file->size);
    put_16(zip, (unsigned)strlen(file->name));
    put_16(zip, 0);
}

void taut_zip_add(taut_zip *zip, const char *name, const char *bytes, size_t length)
{
    assert(zip->count < TAUT_ZIP_FILES && taut_zip_fits(zip->length + length));
    taut_zip_file *file = &zip->files[zip->count++];
    *file = (taut_zip_file){name, taut_crc32(bytes, length, &zip->sink->pulse), (uint32_t)length,
                            zip->length};
    put_32(zip, SIGN_LOCAL);
    put_common(zip, file);
    taut_sink_text(zip->sink, name);
    for (size_t at = 0; at < length; at += PART) {
        taut_sink_bytes(zip->sink, bytes + at, length - at < PART ? length - at : PART);
    }
    zip->length += (uint32_t)(LOCAL + strlen(name) + length);
}

/* The header again: made where, then the common part, no comment, first disk, no attributes, where its bytes are. */
static void put_central(taut_zip *zip, const taut_zip_file *file)
{
    put_32(zip, SIGN_CENTRAL);
    put_16(zip, VERSION);
    put_common(zip, file);
    put_16(zip, 0);
    put_16(zip, 0);
    put_16(zip, 0);
    put_32(zip, 0);
    put_32(zip, file->at);
    taut_sink_text(zip->sink, file->name);
}

void taut_zip_end(taut_zip *zip)
{
    uint32_t list = 0;
    for (int i = 0; i < zip->count; i++) {
        put_central(zip, &zip->files[i]);
        list += (uint32_t)(CENTRAL + strlen(zip->files[i].name));
    }
    put_32(zip, SIGN_END);
    put_16(zip, 0);
    put_16(zip, 0);
    put_16(zip, (unsigned)zip->count);
    put_16(zip, (unsigned)zip->count);
    put_32(zip, list);
    put_32(zip, zip->length);
    put_16(zip, 0);
    zip->length += list + END;
}
