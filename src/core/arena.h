/* arena.h -- scratch that is freed all at once.
 *
 * A construction makes one arena, takes what it needs, and has one thing to free on every exit. An
 * arena also keeps objects that need a call of their own to be freed. Failure sticks: once memory
 * ran out every later take is NULL too, so that a block of takes is checked once, with
 * taut_arena_status. An arena that is NULL counts as one that failed.
 */
#ifndef TAUT_CORE_ARENA_H
#define TAUT_CORE_ARENA_H

#include "taut/status.h"

#include <stddef.h>

typedef struct taut_arena taut_arena;

taut_arena *taut_arena_new(void);        /* NULL when memory runs out */
void taut_arena_free(taut_arena *arena); /* NULL is fine */

/* count * size bytes, aligned to 64, zeroed; NULL when memory runs out or the product overflows. */
void *taut_arena_take(taut_arena *arena, size_t count, size_t size);
/* The same, not zeroed: for large scratch that is written before it is read. */
void *taut_arena_take_raw(taut_arena *arena, size_t count, size_t size);
/* A copy of count * size bytes; NULL as above or when `from` is NULL. */
void *taut_arena_copy(taut_arena *arena, const void *from, size_t count, size_t size);
char *taut_arena_text(taut_arena *arena, const char *text); /* a copy of a string */
/* TAUT_OK while all that was taken and kept is there, else TAUT_NO_MEMORY. */
taut_status taut_arena_status(const taut_arena *arena);

/* Makes the arena call release(object) when it is freed, last kept first. On failure (0) the object
 * is released at once, so that the caller never holds it: 1 on success. A NULL object is 0 too: making it
 * failed. */
int taut_arena_keep(taut_arena *arena, void *object, void (*release)(void *));

#endif /* TAUT_CORE_ARENA_H */
