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

struct taut_arena {
    arena_block *blocks;
    int has_failed;
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

void *taut_arena_take_raw(taut_arena *arena, size_t count, size_t size)
{
    const int is_sound = arena != NULL && !arena->has_failed;
    void *memory = is_sound ? taut_alloc_aligned(count, size) : NULL;
    return taut_arena_keep(arena, memory, taut_free) ? memory : NULL;
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
