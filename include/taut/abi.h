/* taut/abi.h -- the layout of every public struct and the words of every enumeration, as the library
 * was compiled: for bindings that cannot read these headers.
 *
 * A binding looks once, when it loads the library: at the number, then at the members it fills. The
 * five structs below are how it reads the table; they are the same in every version. All of it is
 * constant, so that every call here is safe from any thread. docs/bindings.md shows one written.
 */
#ifndef TAUT_ABI_H
#define TAUT_ABI_H

#include "taut/record.h"
#include "taut/status.h"

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Raised where a struct changes its layout, a value its meaning, a function its arguments, or where
 * one of them goes; what comes new at an end raises nothing. While it is 0 nothing is promised from
 * one commit to the next: then the offsets are what to go by. */
#define TAUT_ABI_NUMBER 0

/* A member of a struct, those inside unions without a name too. */
typedef struct taut_abi_member {
    const char *name;
    const char *type; /* as in C, such as "double[2]", "const double *" or "taut_monitor" */
    size_t offset;    /* bytes from the beginning of the struct */
    size_t size;
} taut_abi_member;

typedef struct taut_abi_struct {
    const char *name; /* such as "taut_make_options" */
    size_t size;
    size_t count;
    const taut_abi_member *members; /* [count], in the order of the header */
} taut_abi_struct;

typedef struct taut_abi_value {
    const char *constant; /* such as "TAUT_EVEN_REFUSE" */
    const char *word;     /* such as "refuse": that of documents where they have one */
    int value;
} taut_abi_value;

/* An enumeration; all constants that belong to none, such as TAUT_XUU and the limits, stand together
 * in one whose name is "", the word being the constant. */
typedef struct taut_abi_enum {
    const char *name; /* such as "taut_harmonic_even" */
    size_t size;      /* bytes of a member of this type */
    size_t count;
    const taut_abi_value *values; /* [count], in the order of the header */
} taut_abi_enum;

typedef struct taut_abi_table {
    int number;       /* TAUT_ABI_NUMBER of the library */
    int pointer_size; /* bytes */
    size_t size_size; /* bytes of size_t */
    size_t struct_count;
    const taut_abi_struct *structs; /* [struct_count], by name */
    size_t enum_count;
    const taut_abi_enum *enums; /* [enum_count], by name */
} taut_abi_table;

/* Never NULL; it lives as long as the library. */
TAUT_API const taut_abi_table *taut_abi(void);

/* The same as a record, for languages that would rather read JSON (taut_record_write):
 *     { "number", "pointer_size", "size_size",
 *       "structs": { NAME: { "size", "members": [ { "name", "type", "offset", "size" }, ... ] }, ... },
 *       "enums": { NAME: { "size", "values": [ { "constant", "word", "value" }, ... ] }, ... } }
 * The caller's; NULL when memory runs out. */
TAUT_API taut_record *taut_abi_record(void);

/* The word of a value, "" where there is no such enumeration or value: taut_enum_name("taut_edge", 1)
 * is "u1". */
TAUT_API const char *taut_enum_name(const char *enumeration, int value);
/* The value of a word, or of the constant by its full name. TAUT_BAD_ARGUMENT, *value untouched,
 * where there is no such enumeration or name. */
TAUT_API taut_status taut_enum_value(const char *enumeration, const char *name, int *value);

#ifdef __cplusplus
}
#endif
#endif /* TAUT_ABI_H */
