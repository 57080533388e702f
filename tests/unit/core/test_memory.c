/* test_memory.c -- sizes that overflow are refused; arenas free what they took and what they keep.
 */
#include "check.h"

#include "core/arena.h"
#include "core/memory.h"

#include <stddef.h>
#include <stdint.h>
#include <string.h>

/* 2^33 things of 2^33 bytes are 2^66 bytes: 0 modulo 2^64, which malloc would grant. */
static void test_overflow(void)
{
    static const size_t pairs[][2] = {{(size_t)1 << 33, (size_t)1 << 33},
                                      {SIZE_MAX, SIZE_MAX},
                                      {SIZE_MAX / 8 + 2, 8},
                                      {3, SIZE_MAX / 2}};
    taut_arena *arena = taut_arena_new();
    void *block = taut_alloc(1, 1);
    CHECK(arena != NULL && block != NULL, "memory for a test");
    for (size_t i = 0; i < sizeof pairs / sizeof pairs[0]; i++) {
        const size_t count = pairs[i][0], size = pairs[i][1];
        CHECK(taut_alloc(count, size) == NULL, "i=%zu", i);
        CHECK(taut_alloc_zero(count, size) == NULL, "i=%zu", i);
        CHECK(taut_alloc_aligned(count, size) == NULL, "i=%zu", i);
        CHECK(taut_realloc(block, count, size) == NULL, "i=%zu", i);
        CHECK(taut_arena_take(arena, count, size) == NULL, "i=%zu", i);
    }
    taut_free(block);
    taut_arena_free(arena);
}

static void test_nothing(void)
{
    void *blocks[] = {taut_alloc(0, 8), taut_alloc_zero(8, 0), taut_alloc_aligned(0, 0)};
    for (int i = 0; i < 3; i++) {
        CHECK(blocks[i] != NULL, "a count of 0 is not a failure: i=%d", i);
        taut_free(blocks[i]);
    }
    taut_free(NULL);
}

static char order[8];

static void note(void *object)
{
    strcat(order, object);
}

static void test_arena(void)
{
    static char first[] = "a", second[] = "b";
    static const double numbers[] = {1, 2, 3};
    taut_arena *arena = taut_arena_new();
    const double *taken = taut_arena_take(arena, 50, sizeof(double));
    const double *copied = taut_arena_copy(arena, numbers, 3, sizeof(double));
    for (int i = 0; i < 50; i++) {
        CHECK(taken[i] == 0, "zeroed: i=%d", i);
    }
    CHECK((uintptr_t)taken % 64 == 0 && (uintptr_t)copied % 64 == 0, "aligned");
    CHECK(memcmp(copied, numbers, sizeof numbers) == 0, "copied");
    CHECK(strcmp(taut_arena_text(arena, "text"), "text") == 0, "text");
    CHECK(taut_arena_copy(arena, NULL, 1, 1) == NULL && taut_arena_text(arena, NULL) == NULL,
          "nothing to copy");
    CHECK(taut_arena_keep(arena, first, note) == 1, "kept");
    CHECK(taut_arena_keep(arena, second, note) == 1, "kept");
    CHECK(order[0] == '\0', "released too early");
    taut_arena_free(arena);
    CHECK(strcmp(order, "ba") == 0, "last kept first: %s", order);
    taut_arena_free(NULL);
}

/* Once something failed all that comes after does, and what is given to keep is released. */
static void test_arena_sticks(void)
{
    static char object[] = "c";
    taut_arena *arena = taut_arena_new();
    CHECK(taut_arena_status(arena) == TAUT_OK, "nothing failed yet");
    CHECK(taut_arena_take(arena, SIZE_MAX, 2) == NULL, "too much");
    CHECK(taut_arena_status(arena) == TAUT_NO_MEMORY, "it sticks");
    CHECK(taut_arena_take(arena, 1, 1) == NULL, "and so does a little");
    order[0] = '\0';
    CHECK(taut_arena_keep(arena, object, note) == 0 && strcmp(order, "c") == 0, "released at once");
    taut_arena_free(arena);
    arena = taut_arena_new();
    CHECK(taut_arena_keep(arena, NULL, note) == 0, "making the object failed");
    CHECK(taut_arena_status(arena) == TAUT_NO_MEMORY, "which sticks");
    taut_arena_free(arena);
    CHECK(taut_arena_take(NULL, 1, 1) == NULL && taut_arena_status(NULL) == TAUT_NO_MEMORY,
          "no arena");
}

int main(void)
{
    test_overflow();
    test_nothing();
    test_arena();
    test_arena_sticks();
    return check_failures != 0;
}
