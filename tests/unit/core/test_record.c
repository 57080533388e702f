/* test_record.c -- the tree of results: what goes in comes out, and nothing else does harm. */
#include "check.h"

#include "taut/record.h"

#include <string.h>

static void test_members(void)
{
    static const double numbers[] = {1, 2.5, -3};
    taut_record *record = taut_record_new();
    taut_record *list = NULL;
    const taut_record *found = NULL;

    taut_record_add_null(record, "null");
    taut_record_add_bool(record, "yes", 7);
    taut_record_add_bool(record, "no", 0);
    taut_record_add_number(record, "number", 0x1.8p-1);
    taut_record_add_text(record, "text", "word");
    taut_record_add_numbers(record, "numbers", 3, numbers);
    list = taut_record_add_list(record, "list");
    taut_record_add_text(taut_record_add_object(list, NULL), "inside", "deep");
    CHECK(taut_record_status(record) == TAUT_OK, "no failure");
    CHECK(taut_record_count(record) == 7, "found %zu", taut_record_count(record));
    CHECK(strcmp(taut_record_key(record, 4), "text") == 0, "in the order added");

    CHECK(taut_record_kind_of(taut_record_get(record, "null")) == TAUT_RECORD_NULL, "null");
    CHECK(taut_record_bool(taut_record_get(record, "yes")) == 1, "yes");
    CHECK(taut_record_bool(taut_record_get(record, "no")) == 0, "no");
    CHECK_NEAR(taut_record_number(taut_record_get(record, "number")), 0.75, 0, "number");
    CHECK(strcmp(taut_record_text(taut_record_get(record, "text")), "word") == 0, "text");
    found = taut_record_get(record, "numbers");
    for (size_t i = 0; i < 3; i++) {
        CHECK_NEAR(taut_record_number(taut_record_at(found, i)), numbers[i], 0, "i=%zu", i);
        CHECK(taut_record_key(found, i)[0] == '\0', "a list has no keys");
    }
    found = taut_record_get(taut_record_at(taut_record_get(record, "list"), 0), "inside");
    CHECK(strcmp(taut_record_text(found), "deep") == 0, "nested");
    taut_record_free(record);
}

static void test_replaces(void)
{
    taut_record *record = taut_record_new();
    taut_record_add_number(record, "a", 1);
    taut_record_add_number(record, "b", 2);
    taut_record_add_text(record, "a", "now a word");
    CHECK(taut_record_count(record) == 2, "a member is replaced, not repeated");
    CHECK(strcmp(taut_record_text(taut_record_at(record, 0)), "now a word") == 0, "in its place");
    taut_record_free(record);
}

/* JSON has no word for them, so a record has none either. */
static void test_not_finite(void)
{
    taut_record *record = taut_record_new();
    taut_record_add_number(record, "nan", nan(""));
    taut_record_add_number(record, "infinity", HUGE_VAL);
    CHECK(taut_record_kind_of(taut_record_get(record, "nan")) == TAUT_RECORD_NULL, "NaN");
    CHECK(taut_record_kind_of(taut_record_get(record, "infinity")) == TAUT_RECORD_NULL, "infinity");
    taut_record_free(record);
}

static int same(const taut_record *a, const taut_record *b)
{
    int equal = taut_record_kind_of(a) == taut_record_kind_of(b) &&
                taut_record_count(a) == taut_record_count(b) &&
                taut_record_bool(a) == taut_record_bool(b) &&
                strcmp(taut_record_text(a), taut_record_text(b)) == 0;
    if (taut_record_kind_of(a) == TAUT_RECORD_NUMBER) {
        equal = equal && taut_record_number(a) == taut_record_number(b);
    }
    for (size_t i = 0; equal && i < taut_record_count(a); i++) {
        equal = strcmp(taut_record_key(a, i), taut_record_key(b, i)) == 0 &&
                same(taut_record_at(a, i), taut_record_at(b, i));
    }
    return equal;
}

static void add_random(taut_record *record, int list, int depth)
{
    const int count = random_int(0, 9);
    for (int i = 0; i < count; i++) {
        const char name[] = {(char)('a' + i), '\0'};
        const char *key = list ? NULL : name;
        switch (random_int(0, depth > 0 ? 5 : 3)) {
        case 0:
            taut_record_add_null(record, key);
            break;
        case 1:
            taut_record_add_bool(record, key, random_int(0, 1));
            break;
        case 2:
            taut_record_add_number(record, key, random_in(-1, 1));
            break;
        case 3:
            taut_record_add_text(record, key, i % 2 ? "text" : "");
            break;
        case 4:
            add_random(taut_record_add_list(record, key), 1, depth - 1);
            break;
        default:
            add_random(taut_record_add_object(record, key), 0, depth - 1);
        }
    }
}

static void test_copy(void)
{
    for (int trial = 0; trial < 200; trial++) {
        taut_record *record = trial % 2 ? taut_record_new() : taut_record_new_list();
        taut_record *copy = NULL;
        add_random(record, trial % 2 == 0, 3);
        copy = taut_record_copy(record);
        CHECK(same(record, copy), "trial=%d", trial);
        taut_record_free(record); /* the copy stands alone */
        if (taut_record_kind_of(copy) == TAUT_RECORD_OBJECT) {
            taut_record_add_number(copy, "more", trial);
            CHECK(taut_record_status(copy) == TAUT_OK, "a copy can grow");
        }
        taut_record_free(copy);
    }
}

static void test_harmless(void)
{
    taut_record *record = taut_record_new();
    taut_record_add_number(NULL, "x", 1);
    CHECK(taut_record_add_list(NULL, "x") == NULL, "NULL gives NULL");
    CHECK(taut_record_status(NULL) == TAUT_NO_MEMORY, "a NULL root is a failure");
    CHECK(taut_record_copy(NULL) == NULL, "nothing to copy");
    CHECK(isnan(taut_record_number(record)) && taut_record_text(record)[0] == '\0' &&
              taut_record_bool(record) == 0,
          "wrong kinds");
    CHECK(taut_record_get(record, "absent") == NULL && taut_record_at(record, 0) == NULL &&
              taut_record_key(record, 3)[0] == '\0' && taut_record_get(NULL, "x") == NULL,
          "absent members");
    taut_record_add_record(record, "null", NULL);
    CHECK(taut_record_count(record) == 1, "a NULL record is null");
    taut_record_free(record);
    taut_record_free(NULL);
}

int main(void)
{
    random_seed(20260103);
    test_members();
    test_replaces();
    test_not_finite();
    test_copy();
    test_harmless();
    return check_failures != 0;
}
