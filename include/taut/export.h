/* taut/export.h -- which symbols leave the shared library. Everything else stays hidden. */
#ifndef TAUT_EXPORT_H
#define TAUT_EXPORT_H

#if defined(__GNUC__)
#define TAUT_API __attribute__((visibility("default")))
#else
#define TAUT_API
#endif

#endif /* TAUT_EXPORT_H */
