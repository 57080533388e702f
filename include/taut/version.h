/* taut/version.h -- which taut this is. */
#ifndef TAUT_VERSION_H
#define TAUT_VERSION_H

#include "taut/export.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The version of these headers. */
#define TAUT_VERSION_MAJOR 0
#define TAUT_VERSION_MINOR 2
#define TAUT_VERSION_PATCH 0
#define TAUT_VERSION "0.2.0"

/* The version of the library that is linked, such as "0.2.0". */
TAUT_API const char *taut_version(void);

/* The instruction set that the inner loops use on this processor: "baseline", "avx2" or "avx512";
 * the environment variable TAUT_KERNEL can name a lesser one; an unknown name, or one that the
 * processor lacks, is passed over. */
TAUT_API const char *taut_kernel_in_use(void);

#ifdef __cplusplus
}
#endif
#endif /* TAUT_VERSION_H */
