/* printf.h -- functions that take a format as printf does, which the compiler checks. */
#ifndef TAUT_CORE_PRINTF_H
#define TAUT_CORE_PRINTF_H

/* The format is argument `format_at`, what goes into it begins at `first`; formats are C17's everywhere, also where the
 * system's own printf knows others. */
#if defined(__clang__)
#define TAUT_PRINTF(format_at, first) __attribute__((format(printf, format_at, first)))
#else
#define TAUT_PRINTF(format_at, first) __attribute__((format(gnu_printf, format_at, first)))
#endif

#endif /* TAUT_CORE_PRINTF_H */
