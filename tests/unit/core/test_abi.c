/* test_abi.c -- the table of layouts against the compiler, asked for each struct by hand, and the words
 * of enumerations against those that documents and the calls of one enumeration have. */
#include "check.h"

#include "taut/taut.h"

#include <string.h>

static const taut_abi_struct *struct_of(const char *name)
{
    const taut_abi_table *table = taut_abi();
    for (size_t i = 0; i < table->struct_count; i++) {
        if (strcmp(table->structs[i].name, name) == 0) {
            return &table->structs[i];
        }
    }
    return NULL;
}

static const taut_abi_member *member_of(const taut_abi_struct *s, const char *name)
{
    for (size_t i = 0; s != NULL && i < s->count; i++) {
        if (strcmp(s->members[i].name, name) == 0) {
            return &s->members[i];
        }
    }
    return NULL;
}

/* One member of each kind: numbers, arrays, pointers, functions, structs inside, and what stands in
 * unions without a name, at both their ends. */
static void test_layouts(void)
{
    static const struct {
        const char *in, *name, *type;
        size_t offset, size, whole;
    } rows[] = {
#define ROW(in, name, type)                                                                        \
    {#in, #name, type, offsetof(in, name), sizeof(((in *)0)->name), sizeof(in)}
        ROW(taut_basis_spec, type, "const char *"),
        ROW(taut_basis_spec, knots, "const double *"),
        ROW(taut_basis_spec, range, "double[2]"),
        ROW(taut_error, status, "taut_status"),
        ROW(taut_error, message, "char[768]"),
        ROW(taut_monitor, progress, "int (*)(void *context, double done, const char *what)"),
        ROW(taut_make_options, tolerance, "double"),
        ROW(taut_make_options, monitor, "taut_monitor"),
        ROW(taut_make_options, exact, "int"),
        ROW(taut_dirichlet_problem, known, "const unsigned char *"),
        ROW(taut_dirichlet_problem, regular, "int"),
        ROW(taut_plateau_problem, net, "taut_dirichlet_problem"),
        ROW(taut_plateau_problem, curves, "const taut_curve *[4]"),
        ROW(taut_plateau_problem, gap, "double"),
        ROW(taut_harmonic_problem, v, "const taut_basis *"),
        ROW(taut_harmonic_problem, boundary, "taut_harmonic_boundary"),
        ROW(taut_harmonic_rows, exact, "const char *const *"),
        ROW(taut_asymptotic_problem, curves, "const taut_curve *[4]"),
        ROW(taut_asymptotic_problem, free_all, "int"),
        ROW(taut_pipe_problem, section, "taut_pipe_section"),
        ROW(taut_pipe_section, radii, "double[2]"),
        ROW(taut_pipe_axis, polygon, "double[4][3]"),
        ROW(taut_pipe_leg, direction, "double[3]"),
        ROW(taut_surface_measure, box, "double[2][3]"),
        ROW(taut_surface_measure, jacobian, "taut_jacobian"),
        ROW(taut_forms, normal, "double[3]"),
        ROW(taut_forms, regular, "int"),
        ROW(taut_mesh_group, first_quad, "size_t"),
        ROW(taut_write_options, bound, "double *"),
        ROW(taut_abi_table, enums, "const taut_abi_enum *"),
#undef ROW
    };
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        const taut_abi_struct *s = struct_of(rows[i].in);
        const taut_abi_member *m = member_of(s, rows[i].name);
        CHECK(m != NULL, "%s.%s", rows[i].in, rows[i].name);
        if (m != NULL) {
            CHECK(s->size == rows[i].whole, "%s", rows[i].in);
            CHECK(m->offset == rows[i].offset && m->size == rows[i].size, "%s.%s: %zu, %zu",
                  rows[i].in, rows[i].name, m->offset, m->size);
            CHECK(strcmp(m->type, rows[i].type) == 0, "%s.%s: %s", rows[i].in, rows[i].name,
                  m->type);
        }
    }
}

/* Every member lies in its struct, and where none stands in a union none overlaps the one before. */
static void test_members(void)
{
    const taut_abi_table *table = taut_abi();
    CHECK(table->number == TAUT_ABI_NUMBER, "%d", table->number);
    CHECK(table->pointer_size == (int)sizeof(void *) && table->size_size == sizeof(size_t),
          "sizes");
    for (size_t i = 0; i < table->struct_count; i++) {
        const taut_abi_struct *s = &table->structs[i];
        CHECK(i == 0 || strcmp(s[-1].name, s->name) < 0, "%s out of order", s->name);
        CHECK(s->count > 0, "%s has no members", s->name);
        CHECK(s->members[0].offset == 0, "%s does not begin with its first member", s->name);
        for (size_t k = 0; k < s->count; k++) {
            const taut_abi_member *m = &s->members[k];
            CHECK(m->size > 0 && m->offset + m->size <= s->size, "%s.%s", s->name, m->name);
            CHECK(k == 0 || m->offset >= m[-1].offset, "%s.%s", s->name, m->name);
        }
    }
}

/* Words there and back, and the refusals. */
static void test_words(void)
{
    static const struct {
        const char *in, *word;
        int value;
    } rows[] = {
        {"taut_status", "ok", TAUT_OK},
        {"taut_status", "interrupted", TAUT_INTERRUPTED},
        {"taut_verdict", "undecided", TAUT_UNDECIDED},
        {"taut_harmonic_even", "raise", TAUT_EVEN_RAISE},
        {"taut_plateau_method", "normal", TAUT_PLATEAU_NORMAL},
        {"taut_asymptotic_surface", "5n-7", TAUT_BIDEGREE_5N_MINUS_7},
        {"taut_asymptotic_surface", "n+3", TAUT_BIDEGREE_N_PLUS_3},
        {"taut_pipe_joint", "g2", TAUT_PIPE_G2},
        {"taut_pipe_frame", "rotation-minimizing", TAUT_PIPE_ROTATION_MINIMIZING},
        {"taut_pipe_shape_kind", "given", TAUT_PIPE_SHAPE_GIVEN},
        {"taut_pipe_shape_kind", "least-bending", TAUT_PIPE_LEAST_BENDING},
        {"taut_pipe_section_kind", "naive-sweep", TAUT_PIPE_NAIVE_SWEEP},
        {"taut_panels_kind", "circular", TAUT_PANELS_CIRCULAR},
        {"taut_jacobian_state", "one-sign", TAUT_JACOBIAN_ONE_SIGN},
        {"taut_record_kind", "object", TAUT_RECORD_OBJECT},
        {"taut_colour", "isothermality", TAUT_COLOUR_ISOTHERMALITY},
        {"", "TAUT_XVV", TAUT_XVV},
        {"", "TAUT_DEGREE_MAX", TAUT_DEGREE_MAX},
    };
    int value = 77;
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        CHECK(taut_enum_value(rows[i].in, rows[i].word, &value) == TAUT_OK, "%s", rows[i].word);
        CHECK(value == rows[i].value, "%s is %d", rows[i].word, value);
        CHECK(rows[i].in[0] == '\0' ||
                  strcmp(taut_enum_name(rows[i].in, rows[i].value), rows[i].word) == 0,
              "%s", taut_enum_name(rows[i].in, rows[i].value));
    }
    for (int i = 0; i < 4; i++) {
        CHECK(strcmp(taut_enum_name("taut_edge", i), taut_edge_name((taut_edge)i)) == 0, "%d", i);
    }
    for (int i = 0; i < 3; i++) {
        CHECK(strcmp(taut_enum_name("taut_claim_kind", i),
                     taut_claim_kind_name((taut_claim_kind)i)) == 0,
              "%d", i);
    }
    CHECK(taut_enum_value("taut_edge", "TAUT_EDGE_V1", &value) == TAUT_OK && value == 3, "%d",
          value);
    CHECK(taut_enum_value("taut_edge", "v2", &value) == TAUT_BAD_ARGUMENT && value == 3, "v2");
    CHECK(taut_enum_value("taut_edges", "v1", &value) == TAUT_BAD_ARGUMENT, "taut_edges");
    CHECK(taut_enum_value(NULL, "v1", &value) == TAUT_BAD_ARGUMENT, "NULL");
    CHECK(taut_enum_value("taut_edge", NULL, &value) == TAUT_BAD_ARGUMENT, "NULL");
    CHECK(taut_enum_value("taut_edge", "v1", NULL) == TAUT_BAD_ARGUMENT, "NULL");
    CHECK(strcmp(taut_enum_name("taut_edge", 4), "") == 0, "4");
    CHECK(strcmp(taut_enum_name("taut_edge", -1), "") == 0, "-1");
    CHECK(strcmp(taut_enum_name(NULL, 0), "") == 0, "NULL");
}

/* No two values of an enumeration share a word, and each value comes back from its word. */
static void test_values(void)
{
    const taut_abi_table *table = taut_abi();
    for (size_t i = 0; i < table->enum_count; i++) {
        const taut_abi_enum *e = &table->enums[i];
        CHECK(e->count > 0 && e->size == sizeof(int), "%s", e->name);
        for (size_t k = 0; k < e->count; k++) {
            int value = -99;
            CHECK(taut_enum_value(e->name, e->values[k].word, &value) == TAUT_OK &&
                      value == e->values[k].value,
                  "%s of %s is %d", e->values[k].word, e->name, value);
        }
    }
}

/* The record says what the table says. */
static void test_record(void)
{
    const taut_abi_table *table = taut_abi();
    taut_record *record = taut_abi_record();
    const taut_record *structs = taut_record_get(record, "structs");
    const taut_record *enums = taut_record_get(record, "enums");
    CHECK(taut_record_number(taut_record_get(record, "number")) == table->number, "number");
    CHECK(taut_record_number(taut_record_get(record, "pointer_size")) == sizeof(void *), "pointer");
    CHECK(taut_record_number(taut_record_get(record, "size_size")) == sizeof(size_t), "size");
    CHECK(taut_record_count(structs) == table->struct_count, "structs");
    CHECK(taut_record_count(enums) == table->enum_count, "enums");
    for (size_t i = 0; i < table->struct_count; i++) {
        const taut_abi_struct *s = &table->structs[i];
        const taut_record *one = taut_record_get(structs, s->name);
        const taut_record *members = taut_record_get(one, "members");
        CHECK(taut_record_number(taut_record_get(one, "size")) == (double)s->size, "%s", s->name);
        CHECK(taut_record_count(members) == s->count, "%s", s->name);
        for (size_t k = 0; k < s->count; k++) {
            const taut_record *m = taut_record_at(members, k);
            CHECK(strcmp(taut_record_text(taut_record_get(m, "name")), s->members[k].name) == 0 &&
                      strcmp(taut_record_text(taut_record_get(m, "type")), s->members[k].type) ==
                          0 &&
                      taut_record_number(taut_record_get(m, "offset")) ==
                          (double)s->members[k].offset &&
                      taut_record_number(taut_record_get(m, "size")) == (double)s->members[k].size,
                  "%s.%s", s->name, s->members[k].name);
        }
    }
    const taut_record *edges = taut_record_get(taut_record_get(enums, "taut_edge"), "values");
    CHECK(strcmp(taut_record_text(taut_record_get(taut_record_at(edges, 2), "word")), "v0") == 0 &&
              taut_record_number(taut_record_get(taut_record_at(edges, 2), "value")) == 2,
          "v0");
    taut_record_free(record);
}

int main(void)
{
    test_layouts();
    test_members();
    test_words();
    test_values();
    test_record();
    return check_failures != 0;
}
