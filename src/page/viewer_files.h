/* viewer_files.h -- the files of src/page/viewer that a page is made of, part of the library
 * (cmake/embed.cmake). */
#ifndef TAUT_PAGE_VIEWER_FILES_H
#define TAUT_PAGE_VIEWER_FILES_H

#include <stddef.h>

typedef struct taut_viewer_file {
    const char *name; /* without folder; NULL ends the list */
    const char *text; /* ended by a 0 byte */
    size_t length;
} taut_viewer_file;

extern const taut_viewer_file taut_viewer_files[];

#endif /* TAUT_PAGE_VIEWER_FILES_H */
