/* film_images.h -- the copies that the images of a film make, in their order.
 *
 *     copies = the film
 *     for each image: for each power 1 .. count: for each copy that was there before the image: its image
 */
#ifndef TAUT_PROBLEM_FILM_IMAGES_H
#define TAUT_PROBLEM_FILM_IMAGES_H

#include "core/arena.h"
#include "taut/film.h"

typedef struct taut_film_copy {
    int of;           /* a copy before it; -1: the film itself */
    int image, power; /* of it */
} taut_film_copy;

typedef struct taut_film_copies {
    int count; /* 1 or more */
    taut_film_copy *copies;
} taut_film_copies;

/* How many there are; above `most`: more. */
int taut_film_copies_count(const taut_film_problem *problem, int most);
/* In the arena. Of a problem whose images have been checked. TAUT_NO_MEMORY. */
taut_status taut_film_copies_new(const taut_film_problem *problem, taut_arena *arena,
                                 taut_film_copies *copies);

enum { TAUT_FILM_COPY_NAME = 256 };
/* "a", "a'", "a''" .. "a''''''''", "a'9", ..; at most 255 bytes. */
void taut_film_copy_name(const char *name, int copy, char made[TAUT_FILM_COPY_NAME]);

#endif /* TAUT_PROBLEM_FILM_IMAGES_H */
