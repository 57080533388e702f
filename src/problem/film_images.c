#include "problem/film_images.h"

#include <stdio.h>
#include <string.h>

enum { PRIMES = 8 };

static int powers_of(const taut_film_image *image)
{
    return image->count > 0 ? image->count : 1;
}

int taut_film_copies_count(const taut_film_problem *problem, int most)
{
    double count = 1;

    for (int k = 0; k < problem->image_count && count <= most; k++) {
        count *= 1.0 + powers_of(&problem->images[k]);
    }
    return count <= most ? (int)count : most + 1;
}

taut_status taut_film_copies_new(const taut_film_problem *problem, taut_arena *arena,
                                 taut_film_copies *copies)
{
    const int all = taut_film_copies_count(problem, TAUT_FILM_IMAGES_MAX);

    copies->count = 1;
    copies->copies = taut_arena_take(arena, (size_t)all, sizeof *copies->copies);
    if (copies->copies == NULL) {
        return TAUT_NO_MEMORY;
    }
    copies->copies[0].of = -1;
    for (int image = 0; image < problem->image_count; image++) {
        const int before = copies->count;
        for (int k = 0; k < powers_of(&problem->images[image]) * before; k++) {
            copies->copies[copies->count++] = (taut_film_copy){k % before, image, k / before + 1};
        }
    }
    return TAUT_OK;
}

void taut_film_copy_name(const char *name, int copy, char made[TAUT_FILM_COPY_NAME])
{
    static const char primes[] = "''''''''";

    if (copy <= PRIMES) {
        snprintf(made, TAUT_FILM_COPY_NAME, "%.240s%.*s", name, copy, primes);
    } else {
        snprintf(made, TAUT_FILM_COPY_NAME, "%.240s'%d", name, copy);
    }
}
