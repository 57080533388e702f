/* nearest.c -- the known word that a misspelt one was meant for. */
#include "taut/read.h"

#include <string.h>

enum { WORD_MAX = 64 }; /* of longer words only so much is compared */

static size_t least_of(size_t a, size_t b, size_t c)
{
    const size_t ab = a < b ? a : b;
    return ab < c ? ab : c;
}

/* The smallest number of letters put in, left out or replaced that turns one word into the other,
 * row by row of the table d[i][j] over their beginnings of lengths i and j. */
static size_t edit_distance(const char *a, const char *b)
{
    const size_t m = strnlen(a, WORD_MAX), n = strnlen(b, WORD_MAX);
    size_t row[WORD_MAX + 1];

    for (size_t j = 0; j <= n; j++) {
        row[j] = j;
    }
    for (size_t i = 1; i <= m; i++) {
        size_t diagonal = row[0]; /* d[i-1][j-1] */
        row[0] = i;
        for (size_t j = 1; j <= n; j++) {
            const size_t above = row[j];
            row[j] = least_of(above + 1, row[j - 1] + 1, diagonal + (a[i - 1] != b[j - 1]));
            diagonal = above;
        }
    }
    return row[n];
}

const char *taut_nearest_word(const char *word, const char *const *words, int *edits)
{
    const char *nearest = NULL;
    size_t least = 0;
    for (; *words != NULL; words++) {
        const size_t distance = edit_distance(word, *words);
        if (nearest == NULL || distance < least) {
            nearest = *words;
            least = distance;
        }
    }
    if (nearest != NULL && edits != NULL) {
        *edits = (int)least;
    }
    return nearest;
}
