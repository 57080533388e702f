/* abi.c -- the table of what was compiled: names out of abi_list.h, numbers out of the compiler. */
#include "taut/abi.h"

#include "core/abi_list.h"
#include "taut/taut.h"

#include <string.h>

#define COUNT(array) (sizeof(array) / sizeof(array)[0])

#define MEMBER(name, member, type)                                                                 \
    {#member, type, offsetof(name, member), sizeof(((const name *)0)->member)},
#define MEMBERS(name)                                                                              \
    static const taut_abi_member members_of_##name[] = {TAUT_ABI_MEMBERS_##name(MEMBER)};
TAUT_ABI_STRUCT_LIST(MEMBERS)

#define STRUCT(name) {#name, sizeof(name), COUNT(members_of_##name), members_of_##name},
static const taut_abi_struct structs[] = {TAUT_ABI_STRUCT_LIST(STRUCT)};

#define VALUE(constant, word) {#constant, word, (int)(constant)},
#define VALUES(name)                                                                               \
    static const taut_abi_value values_of_##name[] = {TAUT_ABI_VALUES_##name(VALUE)};
TAUT_ABI_ENUM_LIST(VALUES)

/* #constant would be its value where it is a macro: the word is its name here. */
#define CONSTANT(constant, word) {word, word, constant},
static const taut_abi_value constants[] = {TAUT_ABI_CONSTANT_LIST(CONSTANT)};

#define ENUM(name) {#name, sizeof(name), COUNT(values_of_##name), values_of_##name},
static const taut_abi_enum enums[] = {{"", sizeof(int), COUNT(constants), constants},
                                      TAUT_ABI_ENUM_LIST(ENUM)};

static const taut_abi_table table = {.number = TAUT_ABI_NUMBER,
                                     .pointer_size = (int)sizeof(void *),
                                     .size_size = sizeof(size_t),
                                     .struct_count = COUNT(structs),
                                     .structs = structs,
                                     .enum_count = COUNT(enums),
                                     .enums = enums};

const taut_abi_table *taut_abi(void)
{
    return &table;
}

static void add_struct(taut_record *to, const taut_abi_struct *s)
{
    taut_record *made = taut_record_add_object(to, s->name);
    taut_record_add_number(made, "size", (double)s->size);
    taut_record *list = taut_record_add_list(made, "members");
    for (size_t i = 0; i < s->count; i++) {
        taut_record *member = taut_record_add_object(list, NULL);
        taut_record_add_text(member, "name", s->members[i].name);
        taut_record_add_text(member, "type", s->members[i].type);
        taut_record_add_number(member, "offset", (double)s->members[i].offset);
        taut_record_add_number(member, "size", (double)s->members[i].size);
    }
}

static void add_enum(taut_record *to, const taut_abi_enum *e)
{
    taut_record *made = taut_record_add_object(to, e->name);
    taut_record_add_number(made, "size", (double)e->size);
    taut_record *list = taut_record_add_list(made, "values");
    for (size_t i = 0; i < e->count; i++) {
        taut_record *value = taut_record_add_object(list, NULL);
        taut_record_add_text(value, "constant", e->values[i].constant);
        taut_record_add_text(value, "word", e->values[i].word);
        taut_record_add_number(value, "value", e->values[i].value);
    }
}

taut_record *taut_abi_record(void)
{
    taut_record *root = taut_record_new();

    taut_record_add_number(root, "number", table.number);
    taut_record_add_number(root, "pointer_size", table.pointer_size);
    taut_record_add_number(root, "size_size", (double)table.size_size);
    taut_record *all = taut_record_add_object(root, "structs");
    for (size_t i = 0; i < table.struct_count; i++) {
        add_struct(all, &structs[i]);
    }
    all = taut_record_add_object(root, "enums");
    for (size_t i = 0; i < table.enum_count; i++) {
        add_enum(all, &enums[i]);
    }
    if (taut_record_status(root) != TAUT_OK) {
        taut_record_free(root);
        return NULL;
    }
    return root;
}

static const taut_abi_enum *find_enum(const char *name)
{
    for (size_t i = 0; name != NULL && i < COUNT(enums); i++) {
        if (strcmp(enums[i].name, name) == 0) {
            return &enums[i];
        }
    }
    return NULL;
}

const char *taut_enum_name(const char *enumeration, int value)
{
    const taut_abi_enum *e = find_enum(enumeration);
    for (size_t i = 0; e != NULL && i < e->count; i++) {
        if (e->values[i].value == value) {
            return e->values[i].word;
        }
    }
    return "";
}

taut_status taut_enum_value(const char *enumeration, const char *name, int *value)
{
    const taut_abi_enum *e = find_enum(enumeration);
    if (name == NULL || value == NULL) {
        return TAUT_BAD_ARGUMENT;
    }
    for (size_t i = 0; e != NULL && i < e->count; i++) {
        if (strcmp(e->values[i].word, name) == 0 || strcmp(e->values[i].constant, name) == 0) {
            *value = e->values[i].value;
            return TAUT_OK;
        }
    }
    return TAUT_BAD_ARGUMENT;
}
