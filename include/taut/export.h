/* taut/export.h -- which symbols leave the shared library. Everything else stays hidden.
 *
 * On Windows a program says whether it takes them out of libtaut-0.dll or, with TAUT_STATIC defined, out of libtaut.a.
 */
#ifndef TAUT_EXPORT_H
#define TAUT_EXPORT_H

#if defined(_WIN32) && defined(TAUT_BUILD)
#define TAUT_API __declspec(dllexport)
#elif defined(_WIN32) && !defined(TAUT_STATIC)
#define TAUT_API __declspec(dllimport)
#elif defined(__GNUC__) && !defined(_WIN32)
#define TAUT_API __attribute__((visibility("default")))
#else
#define TAUT_API
#endif

#endif /* TAUT_EXPORT_H */
