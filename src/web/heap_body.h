/* heap_body.h -- memory given out in pieces, in a tenth of the code that the C library of WASI has for it: a page waits for
 * every byte of the module.
 *
 * Pieces stand one after the other, each behind a head with its size and that of the piece before ([Knuth1998] 2.5,
 * boundary tags), so that a free one joins its free neighbours at once. Free pieces are in lists by size; one of the list
 * after the size that is asked for always has room. Places are offsets from `base`, at 8 past a multiple of 16, so that
 * what is given out is aligned to 16.
 */
#ifndef TAUT_WEB_HEAP_BODY_H
#define TAUT_WEB_HEAP_BODY_H

#include <stddef.h>
#include <stdint.h>
#include <string.h>

enum { HEAP_UNIT = 16, HEAP_HEAD = 8, HEAP_LISTS = 64, HEAP_SMALL = 32 };
#define HEAP_MOST UINT32_C(0xf0000000)

typedef struct heap_piece {
    uint32_t before;     /* size of the piece before; 0: none */
    uint32_t size;       /* of this one with its head, and 1 where it is given out; 1: the end */
    uint32_t next, last; /* in the list of free ones, 0: none; else these are the owner's */
} heap_piece;

typedef struct heap {
    char *base;
    uint32_t end;               /* where the piece without size is that ends all; 0: nothing yet */
    uint64_t some;              /* bit k: list k is not empty */
    uint32_t first[HEAP_LISTS]; /* 0: none */
    /* Makes `bytes` or more beyond base + size, at most what 32 bits count; how many, a multiple of 16; 0: there are none. */
    uint32_t (*more)(struct heap *heap, uint32_t size, uint32_t bytes);
} heap;

static heap_piece *heap_at(const heap *h, uint32_t at)
{
    return (heap_piece *)(void *)(h->base + at);
}

/* Sizes below 512 have lists of their own; above each half of an octave has one, and the last what is larger. */
static int heap_list_of(uint32_t size)
{
    if (size < HEAP_SMALL * HEAP_UNIT) {
        return (int)(size / HEAP_UNIT);
    }
    const int octave = 31 - __builtin_clz(size);
    const int list = HEAP_SMALL + 2 * (octave - 9) + (int)(size >> (octave - 1) & 1);
    return list < HEAP_LISTS ? list : HEAP_LISTS - 1;
}

static void heap_list(heap *h, uint32_t at, uint32_t size)
{
    const int list = heap_list_of(size);
    heap_piece *piece = heap_at(h, at);
    piece->size = size;
    piece->last = 0;
    piece->next = h->first[list];
    if (piece->next != 0) {
        heap_at(h, piece->next)->last = at;
    }
    h->first[list] = at;
    h->some |= UINT64_C(1) << list;
    heap_at(h, at + size)->before = size;
}

static void heap_unlist(heap *h, uint32_t at)
{
    const heap_piece *piece = heap_at(h, at);
    const int list = heap_list_of(piece->size);
    if (piece->next != 0) {
        heap_at(h, piece->next)->last = piece->last;
    }
    if (piece->last != 0) {
        heap_at(h, piece->last)->next = piece->next;
    } else {
        h->first[list] = piece->next;
        h->some &= piece->next == 0 ? ~(UINT64_C(1) << list) : ~UINT64_C(0);
    }
}

static int heap_is_free(const heap *h, uint32_t at)
{
    return (heap_at(h, at)->size & 1) == 0;
}

/* A piece of this size becomes free, with its free neighbours. */
static void heap_free(heap *h, uint32_t at, uint32_t size)
{
    const uint32_t before = heap_at(h, at)->before, next = at + size;
    if (heap_is_free(h, next)) {
        heap_unlist(h, next);
        size += heap_at(h, next)->size;
    }
    if (before != 0 && heap_is_free(h, at - before)) {
        at -= before;
        heap_unlist(h, at);
        size += before;
    }
    heap_list(h, at, size);
}

/* Of a piece of `size` that is in no list the first `need` bytes are given out. */
static void *heap_give(heap *h, uint32_t at, uint32_t size, uint32_t need)
{
    const uint32_t rest = size - need;
    heap_at(h, at)->size = need | 1;
    heap_at(h, at + need)->before = need;
    if (rest > 0) {
        heap_free(h, at + need, rest);
    }
    return h->base + at + HEAP_HEAD;
}

/* The memory grows: 0 where it cannot. */
static int heap_grow(heap *h, uint32_t need)
{
    const uint32_t held = h->end > 0 ? h->end + HEAP_HEAD : 0;
    const uint32_t begin = h->end > 0 ? h->end : HEAP_HEAD;
    const uint32_t got = h->more(h, held, need + 2 * HEAP_UNIT);
    if (got == 0) {
        return 0;
    }
    h->end = held + got - HEAP_HEAD;
    if (held == 0) {
        heap_at(h, begin)->before = 0;
    }
    heap_at(h, h->end)->size = 1;
    heap_free(h, begin, h->end - begin);
    return 1;
}

/* A free piece of `need` bytes or more, in no list any more; 0: there is none. */
static uint32_t heap_find(heap *h, uint32_t need)
{
    const int list = heap_list_of(need);
    const uint64_t above = list + 1 < HEAP_LISTS ? h->some >> (list + 1) << (list + 1) : 0;
    uint32_t at = h->first[list];
    while (at != 0 && heap_at(h, at)->size < need) {
        at = heap_at(h, at)->next;
    }
    if (at == 0 && above != 0) {
        at = h->first[__builtin_ctzll(above)];
    }
    if (at != 0) {
        heap_unlist(h, at);
    }
    return at;
}

/* Size of a piece for so many bytes; 0: more than there can be. */
static uint32_t heap_size_for(size_t bytes)
{
    return bytes > HEAP_MOST
               ? 0
               : ((uint32_t)bytes + HEAP_HEAD + HEAP_UNIT - 1) & ~(uint32_t)(HEAP_UNIT - 1);
}

static void *heap_take(heap *h, size_t bytes)
{
    const uint32_t need = heap_size_for(bytes);
    uint32_t at = need > 0 ? heap_find(h, need) : 0;
    if (at == 0 && need > 0 && heap_grow(h, need)) {
        at = heap_find(h, need);
    }
    return at != 0 ? heap_give(h, at, heap_at(h, at)->size, need) : NULL;
}

static uint32_t heap_place_of(const heap *h, const void *block)
{
    return (uint32_t)((const char *)block - h->base) - HEAP_HEAD;
}

static void heap_release(heap *h, void *block)
{
    if (block != NULL) {
        const uint32_t at = heap_place_of(h, block);
        heap_free(h, at, heap_at(h, at)->size - 1);
    }
}

static void *heap_resize(heap *h, void *block, size_t bytes)
{
    if (block == NULL) {
        return heap_take(h, bytes);
    }
    const uint32_t at = heap_place_of(h, block), need = heap_size_for(bytes);
    const uint32_t size = heap_at(h, at)->size - 1, next = at + size;
    if (need > 0 && need <= size) {
        return heap_give(h, at, size, need);
    }
    if (need > 0 && heap_is_free(h, next) && size + heap_at(h, next)->size >= need) {
        heap_unlist(h, next);
        return heap_give(h, at, size + heap_at(h, next)->size, need);
    }
    void *other = heap_take(h, bytes);
    if (other != NULL) {
        memcpy(other, block, size - HEAP_HEAD);
        heap_release(h, block);
    }
    return other;
}

/* At a multiple of `alignment`, a power of two above 16. */
static void *heap_take_aligned(heap *h, size_t alignment, size_t bytes)
{
    const size_t room = bytes + alignment;
    char *block = room > bytes ? heap_take(h, room) : NULL;
    if (block == NULL) {
        return NULL;
    }
    const uint32_t at = heap_place_of(h, block), size = heap_at(h, at)->size - 1;
    const uint32_t skipped = (uint32_t)(-(uintptr_t)block & (alignment - 1));
    if (skipped > 0) { /* what stands before is a piece of its own */
        heap_at(h, at + skipped)->before = skipped;
        heap_at(h, at + skipped)->size = (size - skipped) | 1;
        heap_free(h, at, skipped);
    }
    return heap_give(h, at + skipped, size - skipped, heap_size_for(bytes));
}

#endif /* TAUT_WEB_HEAP_BODY_H */
