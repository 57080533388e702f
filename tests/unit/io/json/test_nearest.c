/* test_nearest.c -- the nearest word, against the definition of the distance by recursion. */
#include "check.h"

#include "taut/read.h"

#include <string.h>

/* The fewest letters put in, left out or replaced, by what happens to the first ones. */
static int edits_between(const char *a, const char *b)
{
    if (*a == '\0' || *b == '\0') {
        return (int)(strlen(a) + strlen(b));
    }
    const int replaced = edits_between(a + 1, b + 1) + (*a != *b);
    const int out = edits_between(a + 1, b) + 1, in = edits_between(a, b + 1) + 1;
    const int moved = out < in ? out : in;
    return replaced < moved ? replaced : moved;
}

static void random_word(char word[7])
{
    const int length = (int)random_in(0, 7);
    for (int i = 0; i < length; i++) {
        word[i] = (char)('a' + (int)random_in(0, 3));
    }
    word[length] = '\0';
}

static void test_random_words(void)
{
    for (int trial = 0; trial < 300; trial++) {
        char word[7], list[4][7];
        const char *words[5] = {list[0], list[1], list[2], list[3], NULL};
        int least = 0, edits = -1;
        random_word(word);
        for (int i = 3; i >= 0; i--) {
            random_word(list[i]);
            const int d = edits_between(word, list[i]);
            least = i == 3 || d < least ? d : least;
        }
        const char *nearest = taut_nearest_word(word, words, &edits);
        CHECK(edits == least, "\"%s\": %d, expected %d", word, edits, least);
        for (int i = 0; i < 4; i++) {
            CHECK(nearest <= list[i] || edits_between(word, list[i]) > least,
                  "\"%s\": the first of those equally near is %d", word, i);
        }
        CHECK(taut_nearest_word(word, words, NULL) == nearest, "without edits");
    }
}

static void test_ends(void)
{
    static const char *const none[] = {NULL}, *const one[] = {"", NULL};
    char longest[200];
    int edits = 7;
    memset(longest, 'x', sizeof longest - 1);
    longest[sizeof longest - 1] = '\0';
    CHECK(taut_nearest_word("a", none, &edits) == NULL && edits == 7, "an empty list");
    CHECK(taut_nearest_word(longest, one, &edits) == one[0] && edits == 64, "a long word");
}

int main(void)
{
    random_seed(5);
    test_random_words();
    test_ends();
    return check_failures != 0;
}
