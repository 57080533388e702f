#include "core/arena.h"

#include "core/memory.h"

#include <stdint.h>
#include <string.h>

/* A list of blocks, newest first; each block is either memory handed out (release NULL) or an
 * object to be released. */
typedef struct arena_block {
    struct arena_block *next;
    void *object;
    void (*release)(void *);
} arena_block;

/* What is small is carved from blocks that many share, each of twice the size of the last; but not
 * where addresses are watched, so that each take has its own bounds. */
#if defined(__SANITIZE_ADDRESS__)
#define IS_WATCHED 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define IS_WATCHED 1
#endif
#endif
#ifdef IS_WATCHED
enum { SMALL = 0 };
#else
enum { SMALL = 2048 };
#endif
enum { SHARED_FIRST = 4096, SHARED_MOST = 131072, ALIGNMENT = 64 };

struct taut_arena {
    arena_block *blocks;
    int has_failed;
    char *room; /* what is left of the block that is shared now, */
    size_t left;
    size_t shared; /* and the size of that block */
};

taut_arena *taut_arena_new(void)
{
    return taut_alloc_zero(1, sizeof(taut_arena));
}

void taut_arena_free(taut_arena *arena)
{
    if (arena == NULL) {
        return;
    }
    while (arena->blocks != NULL) {
        arena_block *block = arena->blocks;
        arena->blocks = block->next;
        block->release(block->object);
        taut_free(block);
    }
    taut_free(arena);
}

taut_status taut_arena_status(const taut_arena *arena)
{
    return arena != NULL && !arena->has_failed ? TAUT_OK : TAUT_NO_MEMORY;
}

int taut_arena_keep(taut_arena *arena, void *object, void (*release)(void *))
{
    const int is_sound = object != NULL && arena != NULL && !arena->has_failed;
    arena_block *block = is_sound ? taut_alloc(1, sizeof *block) : NULL;
    if (block == NULL) {
        if (object != NULL) {
            release(object);
        }
        if (arena != NULL) {
            arena->has_failed = 1;
        }
        return 0;
    }
    *block = (arena_block){arena->blocks, object, release};
    arena->blocks = block;
    return 1;
}

static void *take_block(taut_arena *arena, size_t count, size_t size)
{
    const int is_sound = arena != NULL && !arena->has_failed;
    void *memory = is_sound ? taut_alloc_aligned(count, size) : NULL;
    return taut_arena_keep(arena, memory, taut_free) ? memory : NULL;
}

void *taut_arena_take_raw(taut_arena *arena, size_t count, size_t size)
{
    const int is_small = count > 0 && size > 0 && count <= SMALL / size;
    const size_t bytes = is_small ? (count * size + ALIGNMENT - 1) / ALIGNMENT * ALIGNMENT : 0;
    void *memory = NULL;
    if (!is_small || arena == NULL || arena->has_failed) {
        return take_block(arena, count, size);
    }
    if (arena->left < bytes) {
        arena->shared = arena->shared == 0            ? SHARED_FIRST
                        : arena->shared < SHARED_MOST ? 2 * arena->shared
                                                      : arena->shared;
        arena->room = take_block(arena, arena->shared, 1);
        arena->left = arena->room != NULL ? arena->shared : 0;
    }
    if (arena->room != NULL) {
        memory = arena->room;
        arena->room += bytes;
        arena->left -= bytes;
    }
    return memory;
}

void *taut_arena_take(taut_arena *arena, size_t count, size_t size)
{
    void *memory = taut_arena_take_raw(arena, count, size);
    if (memory != NULL) {
        memset(memory, 0, count * size);
    }
    return memory;
}

void *taut_arena_copy(taut_arena *arena, const void *from, size_t count, size_t size)
{
    void *memory = from != NULL ? taut_arena_take_raw(arena, count, size) : NULL;
    if (memory != NULL) {
        memcpy(memory, from, count * size);
    }
    return memory;
}

char *taut_arena_text(taut_arena *arena, const char *text)
{
    return text != NULL ? taut_arena_copy(arena, text, strlen(text) + 1, 1) : NULL;
}
