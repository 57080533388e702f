/* zip.h -- a zip archive of a few files, stored as they are (PKWARE's APPNOTE 4.3).
 *
 * Times are 1980-01-01, the first that there is: the same files give the same bytes. All of it stays below 4 GiB, which the
 * caller sees to by taut_zip_fits.
 */
#ifndef TAUT_IO_ZIP_ZIP_H
#define TAUT_IO_ZIP_ZIP_H

#include "io/file/sink.h"

#include <stdint.h>

enum { TAUT_ZIP_FILES = 8 };

typedef struct taut_zip_file {
    const char *name;
    uint32_t crc, size, at; /* at: where its header begins */
} taut_zip_file;

typedef struct taut_zip {
    taut_sink *sink;
    uint32_t length; /* bytes so far */
    int count;
    taut_zip_file files[TAUT_ZIP_FILES];
} taut_zip;

/* May the files of an archive have so many bytes together? */
int taut_zip_fits(size_t bytes);
taut_zip taut_zip_to(taut_sink *sink);
/* Adds a file; the name, ASCII with / between folders, is borrowed until the end. At most TAUT_ZIP_FILES. */
void taut_zip_add(taut_zip *zip, const char *name, const char *bytes, size_t length);
/* The list of the files, which ends an archive; the sink is the caller's to finish. */
void taut_zip_end(taut_zip *zip);

/* CRC-32 (ISO 3309, polynomial 0xEDB88320 reflected). pulse, which may be NULL, is told of it; once it is to end what is returned has
 * no meaning. */
uint32_t taut_crc32(const char *bytes, size_t length, taut_pulse *pulse);

#endif /* TAUT_IO_ZIP_ZIP_H */
