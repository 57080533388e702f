/* embedded.h -- files of the source tree that are part of the program (cmake/embed.cmake). */
#ifndef TAUT_CORE_EMBEDDED_H
#define TAUT_CORE_EMBEDDED_H

#include <stddef.h>

typedef struct taut_embedded {
    const char *name; /* without folder; NULL ends the list */
    const char *text; /* ended by a 0 byte */
    size_t length;
} taut_embedded;

#endif /* TAUT_CORE_EMBEDDED_H */
