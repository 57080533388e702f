/* test_heap.c -- the heap of the module for browsers (web/heap_body.h), over a block of this program: pieces taken, resized and
 * released at random keep what was written in them, are aligned, never overlap, and all of it is one free piece at the end. */
#include "check.h"

#include "web/heap_body.h"

#include <stdlib.h>

enum { ROOM = 1 << 20, BLOCKS = 300, TURNS = 200000 };

static uint32_t granted; /* of ROOM, a part at a time */

static uint32_t grant(heap *h, uint32_t size, uint32_t bytes)
{
    const uint32_t part = (bytes + 4095) & ~UINT32_C(4095);
    (void)h;
    if (size != granted || part > ROOM - granted) {
        return 0;
    }
    granted += part;
    return part;
}

static uint32_t next_random(void)
{
    static uint64_t state = 12345;
    state = state * UINT64_C(6364136223846793005) + 1442695040888963407u;
    return (uint32_t)(state >> 33);
}

/* Sizes small and large, as often as not below 100. */
static size_t some_size(void)
{
    const uint32_t kind = next_random() % 4;
    return next_random() % (kind < 2 ? 100 : kind == 2 ? 3000 : 40000);
}

typedef struct block {
    unsigned char *bytes;
    size_t count;
    unsigned char mark;
} block;

static int is_kept(const block *b, size_t count)
{
    for (size_t k = 0; k < count; k++) {
        if (b->bytes[k] != b->mark) {
            return 0;
        }
    }
    return 1;
}

/* Heads say one another's sizes, no two free neighbours are apart, and every free one is in its list. */
static int is_sound(const heap *h)
{
    uint32_t before = 0, free_ones = 0, listed = 0;
    int was_free = 0;
    for (uint32_t at = HEAP_HEAD; at < h->end;) {
        const heap_piece *piece = heap_at(h, at);
        const uint32_t size = piece->size & ~UINT32_C(1);
        const int is_free = heap_is_free(h, at);
        if (piece->before != before || size == 0 || (is_free && was_free)) {
            return 0;
        }
        free_ones += is_free ? 1 : 0;
        was_free = is_free;
        before = size;
        at += size;
    }
    for (int list = 0; list < HEAP_LISTS; list++) {
        if ((h->first[list] != 0) != ((h->some >> list & 1) != 0)) {
            return 0;
        }
        for (uint32_t at = h->first[list]; at != 0; at = heap_at(h, at)->next) {
            listed++;
        }
    }
    return free_ones == listed && heap_at(h, h->end)->before == before;
}

int main(void)
{
    char *room = malloc(ROOM + 64);
    heap h = {.base = room, .more = grant};
    static block blocks[BLOCKS];
    int refused = 0;

    CHECK(room != NULL, "room");
    h.base += -(uintptr_t)room % 64;
    for (int turn = 0; turn < TURNS; turn++) {
        block *b = &blocks[next_random() % BLOCKS];
        const size_t count = some_size();
        const uint32_t act = next_random() % 4;
        if (b->bytes != NULL && !is_kept(b, b->count)) {
            CHECK(0, "turn %d: what was written is gone", turn);
            break;
        }
        if (b->bytes != NULL && act == 0) {
            unsigned char *other = heap_resize(&h, b->bytes, count);
            refused += other == NULL;
            if (other == NULL) {
                continue;
            }
            b->bytes = other;
            CHECK(is_kept(b, count < b->count ? count : b->count), "turn %d", turn);
        } else if (b->bytes != NULL) {
            heap_release(&h, b->bytes);
            b->bytes = NULL;
            continue;
        } else {
            b->bytes = act == 1 ? heap_take_aligned(&h, 64, count) : heap_take(&h, count);
            refused += b->bytes == NULL;
            CHECK(b->bytes == NULL || (uintptr_t)b->bytes % (act == 1 ? 64 : 16) == 0, "turn %d",
                  turn);
        }
        if (b->bytes != NULL) {
            b->count = count;
            b->mark = (unsigned char)turn;
            memset(b->bytes, b->mark, count);
        }
        if (turn % 1000 == 0) {
            CHECK(is_sound(&h), "turn %d", turn);
        }
    }
    CHECK(refused > 0 && refused < TURNS / 2, "refused %d times", refused);
    CHECK(heap_take(&h, SIZE_MAX) == NULL && heap_take(&h, HEAP_MOST) == NULL, "too much");
    CHECK(heap_take_aligned(&h, 64, SIZE_MAX - 8) == NULL, "too much, aligned");
    for (int k = 0; k < BLOCKS; k++) {
        heap_release(&h, blocks[k].bytes);
    }
    heap_release(&h, NULL);
    CHECK(is_sound(&h), "at the end");
    CHECK(heap_is_free(&h, HEAP_HEAD) && HEAP_HEAD + heap_at(&h, HEAP_HEAD)->size == h.end,
          "all is one free piece");
    free(room);
    return check_failures != 0;
}
