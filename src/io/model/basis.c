#include "io/model/basis.h"

#include "basis/basis_ops.h"
#include "core/fail.h"
#include "core/memory.h"
#include "geometry/keep.h"
#include "taut/read.h"

#include <assert.h>
#include <stddef.h>
#include <string.h>

/* How a member is written. */
typedef enum member_kind { MEMBER_INTEGER, MEMBER_NUMBER, MEMBER_KNOTS, MEMBER_RANGE } member_kind;

typedef struct basis_member {
    unsigned bit;
    const char *name;
    member_kind kind;
    size_t offset; /* in the spec, of integers and numbers */
    int most;      /* of integers; the least is 1 */
} basis_member;

enum { KNOTS_MAX = TAUT_COUNT_MAX + TAUT_DEGREE_MAX + 1 };

static const basis_member member_table[] = {
    {TAUT_MEMBER_DEGREE, "degree", MEMBER_INTEGER, offsetof(taut_basis_spec, degree),
     TAUT_DEGREE_MAX},
    {TAUT_MEMBER_COUNT, "count", MEMBER_INTEGER, offsetof(taut_basis_spec, count), TAUT_COUNT_MAX},
    {TAUT_MEMBER_KNOTS, "knots", MEMBER_KNOTS, 0, 0},
    {TAUT_MEMBER_ALPHA, "alpha", MEMBER_NUMBER, offsetof(taut_basis_spec, alpha), 0},
    {TAUT_MEMBER_BETA, "beta", MEMBER_NUMBER, offsetof(taut_basis_spec, beta), 0},
    {TAUT_MEMBER_GAMMA, "gamma", MEMBER_NUMBER, offsetof(taut_basis_spec, gamma), 0},
    {TAUT_MEMBER_SEGMENTS, "segments", MEMBER_INTEGER, offsetof(taut_basis_spec, segments),
     TAUT_COUNT_MAX},
    {TAUT_MEMBER_RANGE, "range", MEMBER_RANGE, 0, 0},
};
enum { MEMBER_COUNT = (int)(sizeof member_table / sizeof member_table[0]) };

/* The ops of the type that the document names. */
static taut_status read_type(const taut_json *at, const taut_basis_ops **ops, taut_error *error)
{
    const taut_json type = taut_json_member(at, "type");
    const char *types[64];
    const char *name = NULL;
    taut_status status = TAUT_OK;
    int count = 0;

    if (taut_json_kind_at(at) != TAUT_JSON_OBJECT) {
        return taut_json_refuse(at, error, "type",
                                "an object, such as {\"type\": \"bezier\", "
                                "\"degree\": 3}");
    }
    status = taut_json_text(&type, &name, error);
    if (status != TAUT_OK) {
        return status;
    }
    *ops = taut_basis_ops_find(name);
    if (*ops == NULL) {
        while (count < 63 && taut_basis_ops_at(count) != NULL) {
            types[count] = taut_basis_ops_at(count)->type;
            count++;
        }
        types[count] = NULL;
        return taut_json_refuse(&type, error, "name", "a type of basis; the nearest one is \"%s\"",
                                taut_nearest_word(name, types, NULL));
    }
    return TAUT_OK;
}

/* Has it members of its type only? What is another type's is no slip of the pen. */
static taut_status check_members(const taut_json *at, const taut_basis_ops *ops, taut_error *error)
{
    const char *names[MEMBER_COUNT + 2] = {"type"};
    int count = 1;
    for (int i = 0; i < MEMBER_COUNT; i++) {
        const taut_json member = taut_json_member(at, member_table[i].name);
        if (member.value != NULL && ((ops->needs | ops->allows) & member_table[i].bit) == 0) {
            return taut_json_fail(&member, error, "unknown-member", taut_none, taut_none,
                                  "there is no such member in a basis of type \"%s\"", ops->type);
        }
        if (((ops->needs | ops->allows) & member_table[i].bit) != 0) {
            names[count++] = member_table[i].name;
        }
    }
    names[count] = NULL;
    return taut_json_object(at, names, error);
}

/* The knots, into memory that the caller frees (spec->knots). */
static taut_status read_knots(const taut_json *at, taut_basis_spec *spec, taut_error *error)
{
    double *knots = NULL;
    size_t count = 0;
    const taut_status status = taut_json_array(at, 2, KNOTS_MAX, "numbers", &count, error);

    if (status != TAUT_OK) {
        return status;
    }
    knots = taut_alloc(count, sizeof(double));
    if (knots == NULL) {
        return taut_fail_memory(error);
    }
    spec->knots = knots;
    spec->knot_count = (int)count;
    return taut_json_numbers(at, count, knots, error);
}

static taut_status read_member(const basis_member *member, const taut_json *at,
                               taut_basis_spec *spec, taut_error *error)
{
    char *field = (char *)spec + member->offset;
    if (member->kind == MEMBER_INTEGER) {
        return taut_json_integer(at, 1, member->most, (int *)(void *)field, error);
    }
    if (member->kind == MEMBER_NUMBER) {
        return taut_json_number(at, (double *)(void *)field, error);
    }
    if (member->kind == MEMBER_KNOTS) {
        return read_knots(at, spec, error);
    }
    spec->has_range = 1;
    return taut_json_numbers(at, 2, spec->range, error);
}

/* spec->knots is the caller's to free, also on failure. */
static taut_status read_basis(const taut_json *at, int functions, taut_basis_spec *spec,
                              taut_basis **basis, taut_error *error)
{
    const taut_basis_ops *ops = NULL;
    taut_status status = read_type(at, &ops, error);

    if (status != TAUT_OK) {
        return status;
    }
    status = check_members(at, ops, error);
    for (int i = 0; status == TAUT_OK && i < MEMBER_COUNT; i++) {
        const taut_json member = taut_json_member(at, member_table[i].name);
        if (member.value != NULL || (ops->needs & member_table[i].bit) != 0) {
            status = read_member(&member_table[i], &member, spec, error);
        }
    }
    if (status != TAUT_OK) {
        return status;
    }
    spec->type = ops->type;
    return taut_json_within(at, taut_basis_new(spec, functions, basis, error), error);
}

taut_status taut_basis_document_read(const taut_json *at, int functions, taut_basis **basis,
                                     taut_error *error)
{
    taut_basis_spec spec = {0};
    const taut_status status = read_basis(at, functions, &spec, basis, error);
    taut_free((void *)(size_t)spec.knots);
    return status;
}

taut_status taut_basis_document_keep(const taut_json *at, int functions, taut_arena *arena,
                                     const taut_basis **basis, taut_error *error)
{
    taut_basis *made = NULL;
    const taut_status status = taut_basis_document_read(at, functions, &made, error);
    if (status == TAUT_OK && !taut_keep_basis(arena, made)) {
        return taut_fail_memory(error);
    }
    *basis = made;
    return status;
}

/* Of members that may be left out; a shape number never may. */
static int is_given(const basis_member *member, const taut_basis_spec *spec)
{
    const char *field = (const char *)spec + member->offset;
    assert(member->kind != MEMBER_NUMBER);
    if (member->kind == MEMBER_INTEGER) {
        return *(const int *)(const void *)field != 0;
    }
    return member->kind == MEMBER_KNOTS ? spec->knots != NULL : spec->has_range;
}

static void write_member(taut_json_out *out, const basis_member *member,
                         const taut_basis_spec *spec)
{
    const char *field = (const char *)spec + member->offset;
    taut_json_key(out, member->name);
    if (member->kind == MEMBER_INTEGER) {
        taut_json_put_number(out, *(const int *)(const void *)field);
    } else if (member->kind == MEMBER_NUMBER) {
        taut_json_put_number(out, *(const double *)(const void *)field);
    } else if (member->kind == MEMBER_KNOTS) {
        const int skip = out->short_knots != 0;
        taut_json_put_numbers(out, (size_t)(spec->knot_count - 2 * skip), spec->knots + skip);
    } else {
        taut_json_put_numbers(out, 2, spec->range);
    }
}

void taut_basis_document_write(taut_json_out *out, const taut_basis *basis)
{
    const taut_basis_ops *ops = taut_basis_ops_find(taut_basis_type(basis));
    taut_basis_spec spec;

    taut_basis_spec_of(basis, &spec);
    taut_json_open_inline(out, '{');
    taut_json_pair_text(out, "type", spec.type);
    for (int i = 0; i < MEMBER_COUNT; i++) {
        const unsigned bit = member_table[i].bit;
        if ((ops->needs & bit) != 0 ||
            ((ops->allows & bit) != 0 && is_given(&member_table[i], &spec))) {
            write_member(out, &member_table[i], &spec);
        }
    }
    taut_json_close(out, '}');
}
