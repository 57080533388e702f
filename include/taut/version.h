/* taut/version.h -- which taut this is. */
#ifndef TAUT_VERSION_H
#define TAUT_VERSION_H

#include "taut/export.h"

#ifdef __cplusplus
extern "C" {
#endif

#define TAUT_VERSION_MAJOR 0
#define TAUT_VERSION_MINOR 1
#define TAUT_VERSION_PATCH 0
#define TAUT_VERSION "0.1.0"

/* The version of the library that is linked, such as "0.1.0". */
TAUT_API const char *taut_version(void);

#ifdef __cplusplus
}
#endif
#endif /* TAUT_VERSION_H */
