/* test_core.c -- arenas, records and certificates when memory runs out. */
#include "calls.h"
#include "check.h"
#include "fault.h"

#include "core/arena.h"
#include "core/memory.h"
#include "taut/abi.h"
#include "taut/certify.h"
#include "taut/record.h"

#include <stdlib.h>
#include <string.h>

static void release_arena(void *arena)
{
    taut_arena_free(arena);
}

static taut_status make_arena(const void *context, void **result, taut_error *error)
{
    static const double numbers[3] = {1, 2, 3};
    taut_arena *arena = taut_arena_new();
    (void)error;
    if (arena == NULL) {
        return TAUT_NO_MEMORY;
    }
    if (taut_arena_take(arena, 100, sizeof(double)) == NULL ||
        taut_arena_copy(arena, numbers, 3, sizeof(double)) == NULL ||
        taut_arena_text(arena, context) == NULL ||
        !taut_arena_keep(arena, taut_alloc(7, 1), taut_free)) {
        taut_arena_free(arena);
        return TAUT_NO_MEMORY;
    }
    *result = arena;
    return TAUT_OK;
}

/* One of everything, more members than one growth holds, one replaced. */
static taut_record *filled_record(void)
{
    static const double numbers[] = {1, 2, 3, 4, 5, 6};
    taut_record *record = taut_record_new();
    taut_record *list = NULL;
    taut_record_add_null(record, "nothing");
    taut_record_add_bool(record, "truth", 1);
    taut_record_add_number(record, "number", 2.5);
    taut_record_add_text(record, "text", "first");
    taut_record_add_text(record, "text", "second");
    taut_record_add_numbers(record, "numbers", 6, numbers);
    list = taut_record_add_list(record, "list");
    taut_record_add_number(taut_record_add_object(list, NULL), "inside", 1);
    taut_record_add_record(record, "copy", list);
    return record;
}

static taut_status make_record(const void *context, void **result, taut_error *error)
{
    taut_record *record = filled_record();
    (void)context;
    (void)error;
    if (taut_record_status(record) != TAUT_OK) {
        taut_record_free(record);
        return TAUT_NO_MEMORY;
    }
    *result = record;
    return TAUT_OK;
}

static taut_status copy_record(const void *context, void **result, taut_error *error)
{
    taut_record *copy = taut_record_copy(context);
    (void)error;
    if (copy == NULL) {
        return TAUT_NO_MEMORY;
    }
    *result = copy;
    return TAUT_OK;
}

static taut_status make_layouts(const void *context, void **result, taut_error *error)
{
    taut_record *record = taut_abi_record();
    (void)context;
    (void)error;
    if (record == NULL) {
        return TAUT_NO_MEMORY;
    }
    *result = record;
    return TAUT_OK;
}

static taut_status make_certificate(const void *context, void **result, taut_error *error)
{
    static const taut_claim claim = {.claim = "stationary",
                                     .kind = TAUT_BOUND,
                                     .residual = 1e-16,
                                     .limit = 1e-12,
                                     .holds = TAUT_TRUE,
                                     .where = "/points/1/1"};
    taut_certificate *certificate = NULL;
    taut_record *figures = NULL;
    taut_status status = taut_certificate_new("dirichlet", &certificate);
    (void)context;
    (void)error;
    for (int i = 0; i < 3 && status == TAUT_OK; i++) {
        status = taut_certificate_add(certificate, &claim);
    }
    if (status == TAUT_OK) {
        figures = filled_record();
        status = taut_record_status(figures);
    }
    if (status != TAUT_OK) {
        taut_record_free(figures);
        taut_certificate_free(certificate);
        return status;
    }
    taut_certificate_set_figures(certificate, figures);
    *result = certificate;
    return TAUT_OK;
}

static taut_status copy_certificate(const void *context, void **result, taut_error *error)
{
    taut_certificate *copy = *result;
    const taut_status status = taut_certificate_copy(context, &copy);
    (void)error;
    *result = copy;
    return status;
}

/* A record that failed says so for ever, takes nothing more, and is still safe to read. */
static void test_failed_record(void)
{
    taut_record *record = taut_record_new();
    taut_record_add_number(record, "before", 1);
    fault_arm(1, 0);
    taut_record_add_number(record, "missing", 2);
    CHECK(fault_disarm() == 1, "one allocation fails");
    taut_record_add_number(record, "after", 3);
    CHECK(taut_record_status(record) == TAUT_NO_MEMORY, "the failure is remembered");
    CHECK(taut_record_get(record, "missing") == NULL && taut_record_get(record, "after") == NULL,
          "nothing is added after a failure");
    CHECK_NEAR(taut_record_number(taut_record_get(record, "before")), 1, 0, "what was there stays");
    taut_record_free(record);
}

/* The countdown itself: a fault loop that never fails anything would prove nothing. */
static void test_countdown(void)
{
    void *a = NULL, *b = NULL, *c = NULL;
    fault_arm(2, 0);
    a = taut_alloc(1, 1);
    b = taut_alloc(1, 1);
    c = taut_alloc(1, 1);
    CHECK(a != NULL && b == NULL && c != NULL, "the second alone fails");
    CHECK(fault_disarm() == 1 && fault_live() == 2, "counted");
    taut_free(a);
    taut_free(c);
    fault_arm(1, 1);
    a = taut_alloc_aligned(1, 1);
    b = taut_alloc_zero(1, 1);
    c = taut_realloc(NULL, 1, 1);
    CHECK(a == NULL && b == NULL && c == NULL, "all fail from the first on");
    CHECK(fault_disarm() == 3 && fault_live() == 0, "counted");
}

int main(void)
{
    taut_record *record = NULL;
    void *certificate = NULL;
    long allocations = 0;

    test_countdown();
    test_failed_record();
    allocations = fault_loop(&(fault_call){"arena", make_arena, release_arena, "text"});
    /* 9 where addresses are watched: each take then has a block of its own */
    CHECK(allocations == 5 || allocations == 9,
          "an arena, a block for what is small, one thing kept: 5, found %ld", allocations);
    fault_loop(&(fault_call){"record", make_record, release_record, NULL});
    record = filled_record();
    allocations = fault_loop(&(fault_call){"record copy", copy_record, release_record, record});
    CHECK(allocations > 20, "found %ld", allocations);
    allocations =
        fault_loop_some(&(fault_call){"layouts", make_layouts, release_record, NULL}, 200);
    CHECK(allocations > 1000, "found %ld", allocations);
    fault_loop(&(fault_call){"certificate", make_certificate, release_certificate, NULL});
    CHECK(make_certificate(NULL, &certificate, NULL) == TAUT_OK, "certificate");
    fault_loop(
        &(fault_call){"certificate copy", copy_certificate, release_certificate, certificate});
    taut_certificate_free(certificate);
    taut_record_free(record);
    CHECK(fault_live() == 0, "%ld blocks left", fault_live());
    return check_failures != 0;
}
