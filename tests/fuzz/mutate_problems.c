/* mutate_problems.c -- changes JSON documents as documents: a number, a word, an item of a list, a
 * member, a known point to an unknown one, a whole row or column of a net with its degree.
 *
 * The text is taken apart into tokens anew for each change. What is no JSON any more is left to
 * libFuzzer's own mutations, as is one change in sixteen.
 */
#include <ctype.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

size_t LLVMFuzzerMutate(uint8_t *data, size_t size, size_t max_size);
size_t LLVMFuzzerCustomMutator(uint8_t *data, size_t size, size_t max_size, unsigned int seed);

enum { TOKENS_MAX = 4096 };

typedef struct document {
    char *text;
    size_t size, room;
} document;

/* Where a value begins, and where it ends. */
typedef struct place {
    size_t from, to;
} place;

static uint64_t state;

static size_t below(size_t n)
{
    state += 0x9e3779b97f4a7c15u;
    uint64_t z = state;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    z ^= z >> 31;
    return n > 0 ? (size_t)(z % n) : 0;
}

/* strchr, but for 0, which may stand anywhere in what is to be mutated. */
static int is_one_of(const char *set, char c)
{
    return c != '\0' && strchr(set, c) != NULL;
}

/* Replaces text[p.from .. p.to); nothing when it would not fit. */
static void replace(document *d, place p, const char *by, size_t length)
{
    if (p.from <= p.to && p.to <= d->size && d->size - (p.to - p.from) + length <= d->room) {
        memmove(d->text + p.from + length, d->text + p.to, d->size - p.to);
        memcpy(d->text + p.from, by, length);
        d->size = d->size - (p.to - p.from) + length;
    }
}

/* The end of the value that begins at `at`: its closing bracket, quote, or last letter. */
static size_t value_end(const document *d, size_t at)
{
    int depth = 0;
    for (size_t i = at; i < d->size; i++) {
        const char c = d->text[i];
        if (c == '"') {
            for (i++; i < d->size && d->text[i] != '"'; i++) {
                i += d->text[i] == '\\';
            }
        } else if (c == '[' || c == '{') {
            depth++;
        } else if (c == ']' || c == '}') {
            depth--;
        } else if (depth == 0) {
            while (i < d->size && !is_one_of(",]} \t\r\n:", d->text[i])) {
                i++;
            }
            return i;
        }
        if (depth == 0) {
            return i + 1 < d->size ? i + 1 : d->size;
        }
    }
    return d->size;
}

/* All values of one kind: 'n' numbers, 's' strings, '[' lists, '{' objects, '0' nulls. */
static size_t find(const document *d, char kind, place *places)
{
    size_t count = 0;
    for (size_t i = 0; i < d->size && count < TOKENS_MAX; i++) {
        const char c = d->text[i];
        const int is_number = isdigit((unsigned char)c) || c == '-';
        const size_t end = c == '"' || is_number || c == 'n' ? value_end(d, i) : i + 1;
        if (kind == (c == '"' ? 's' : is_number ? 'n' : c == 'n' ? '0' : c)) {
            places[count++] = (place){i, c == '[' || c == '{' ? value_end(d, i) : end};
        }
        i = end - 1;
    }
    return count;
}

/* Items of the list (or members of the object) at p. */
static size_t items_of(const document *d, place p, place *items)
{
    size_t count = 0, i = p.from + 1;
    while (i + 1 < p.to && count < TOKENS_MAX) {
        const size_t begin = i;
        while (i + 1 < p.to && d->text[i] != ',') {
            i = is_one_of("[{\"", d->text[i]) ? value_end(d, i) : i + 1;
        }
        items[count++] = (place){begin, i};
        i++;
    }
    return count;
}

static void change_number(document *d, place p)
{
    static const char *const interesting[] = {"0",      "-0",
                                              "1",      "-1",
                                              "2",      "3",
                                              "4",      "0.5",
                                              "1e-300", "1e300",
                                              "1e-9",   "1e-5",
                                              "1e150",  "1e-160",
                                              "0.9999", "3.1415",
                                              "1e60",   "128",
                                              "129",    "1000000",
                                              "700",    "1e-60",
                                              "5e-324", "1.7976931348623157e308",
                                              "0.1",    "1.0000000000000002"};
    char text[64], old[64] = "0";
    double x = 0;
    memcpy(old, d->text + p.from, p.to - p.from < 63 ? p.to - p.from : 63);
    x = strtod(old, NULL);
    switch (below(6)) {
    case 0:
        snprintf(text, sizeof text, "%s",
                 interesting[below(sizeof interesting / sizeof interesting[0])]);
        break;
    case 1:
        snprintf(text, sizeof text, "%.17g", x + (double)below(3) - 1);
        break;
    case 2:
        snprintf(text, sizeof text, "%.17g", -x);
        break;
    case 3:
        snprintf(text, sizeof text, "%.17g", x * (1 + ((double)below(2001) - 1000) * 1e-16));
        break;
    case 4:
        snprintf(text, sizeof text, "%.6g", x + ((double)below(2001) - 1000) / 500);
        break;
    default:
        snprintf(text, sizeof text, "%.6g", x * (double)below(1000) / 100);
        break;
    }
    if (strpbrk(text, "in") == NULL) { /* inf, nan */
        replace(d, p, text, strlen(text));
    }
}

static void change_word(document *d, place p)
{
    static const char allow[] = "\"allow_ill_conditioned\"";
    static const char *const words[] = {
        "\"bezier\"",    "\"bspline\"",   "\"c-bezier\"", "\"c-bspline\"", "\"h-bezier\"",
        "\"h-bspline\"", "\"ce-bezier\"", "\"auto\"",     "\"corner\"",    "\"project\"",
        "\"raise\"",     "\"refuse\"",    "\"c1\"",       "\"g1\"",        "\"u0\"",
        "\"u1\"",        "\"v0\"",        "\"v1\"",       "\"full\"",      "\"normal\"",
        "\"lowest\"",    "\"n+3\"",       "\"5n-7\"",     "\"report\"",    "\"all\"",
        "\"+-+-\"",      "\"+\"",         "\"-\"",        "\"strict\"",    "\"extended\"",
        "\"frenet\"",    "\"degree\"",    "\"count\"",    "\"range\"",     "\"weights\"",
        "\"insist\"",    "\"aspect\"",    "\"alpha\"",    "\"beta\"",      allow};
    const char *word = words[below(sizeof words / sizeof words[0])];
    replace(d, p, word, strlen(word));
}

/* One item taken out, put in twice, or put in the place of another. */
static void change_list(document *d, place p)
{
    static place items[TOKENS_MAX];
    static char copy[4096];
    const size_t count = items_of(d, p, items);
    if (count == 0) {
        return;
    }
    const size_t i = below(count), j = below(count);
    const size_t length = items[i].to - items[i].from;
    if (length + 1 > sizeof copy) {
        return;
    }
    memcpy(copy, d->text + items[i].from, length);
    switch (below(3)) {
    case 0: /* with the comma before or after it */
        replace(d, (place){items[i].from - (i > 0), items[i].to + (i == 0 && count > 1)}, "", 0);
        break;
    case 1:
        copy[length] = ',';
        replace(d, (place){items[j].from, items[j].from}, copy, length + 1);
        break;
    default:
        replace(d, items[j], copy, length);
        break;
    }
}

/* An unknown point becomes a known one, or the other way round. */
static void change_known(document *d)
{
    static place lists[TOKENS_MAX];
    size_t count = find(d, '0', lists);
    if (count > 0 && below(2) == 0) {
        char point[48];
        snprintf(point, sizeof point, "[%d,%d,%d]", (int)below(5), (int)below(5), (int)below(3));
        replace(d, lists[below(count)], point, strlen(point));
        return;
    }
    count = find(d, '[', lists);
    for (int tries = 0; count > 0 && tries < 8; tries++) {
        const place p = lists[below(count)];
        if (p.from + 1 < d->size && d->text[p.from + 1] != '[' && d->text[p.from + 1] != 'n') {
            replace(d, p, "null", 4);
            return;
        }
    }
}

/* The value of a member, from a place on; from == to when there is none. */
static place member(const document *d, const char *quoted, place inside)
{
    const size_t length = strlen(quoted);
    for (size_t i = inside.from; i + length < inside.to; i++) {
        if (memcmp(d->text + i, quoted, length) == 0) {
            for (i += length; i < inside.to && is_one_of(": \n\t", d->text[i]); i++) {
            }
            return (place){i, value_end(d, i)};
        }
    }
    return (place){0, 0};
}

/* Adds to the degree, count or segments of a basis. */
static void change_size(document *d, const char *direction, int by)
{
    static const char *const sizes[] = {"\"degree\"", "\"count\"", "\"segments\""};
    const place basis = member(d, direction, (place){0, d->size});
    for (size_t i = 3; i-- > 0;) {
        const place size = member(d, sizes[i], basis);
        if (size.to > size.from) {
            char text[24];
            snprintf(text, sizeof text, "%d", atoi(d->text + size.from) + by);
            replace(d, size, text, strlen(text));
            return;
        }
    }
}

/* A row, or an item of every row, twice or gone; and the basis of that direction follows. */
static void change_net(document *d)
{
    static place rows[TOKENS_MAX], items[TOKENS_MAX];
    static char copy[4096];
    const place net = member(d, "\"points\"", (place){0, d->size});
    const size_t count = net.to > net.from ? items_of(d, net, rows) : 0;
    const int by_row = below(2) == 0, add = below(2) == 0;
    const size_t at = below(by_row ? count : 8);

    if (count < 2) {
        return;
    }
    for (size_t r = count; r-- > 0;) { /* from the end, so that earlier places stay */
        place p = rows[r];
        if (by_row && r != at) {
            continue;
        }
        if (!by_row) {
            while (p.from < p.to && d->text[p.from] != '[') {
                p.from++;
            }
            const size_t columns = items_of(d, p, items);
            if (columns < 2) {
                return;
            }
            p = items[at % columns];
        }
        const size_t length = p.to - p.from;
        if (p.from == 0 || p.to >= d->size) {
            return; /* the text ends within the net */
        }
        if (add && length + 1 <= sizeof copy) {
            memcpy(copy, d->text + p.from, length);
            copy[length] = ',';
            replace(d, (place){p.from, p.from}, copy, length + 1);
        } else if (!add) {
            const int first = d->text[p.to] == ',';
            replace(d, (place){p.from - !first, p.to + (size_t)first}, "", 0);
        }
    }
    change_size(d, by_row ? "\"u\"" : "\"v\"", add ? 1 : -1);
}

static void change(document *d)
{
    static place places[TOKENS_MAX];
    static const char kinds[] = "nnnnns[[{?NN";
    const char kind = kinds[below(sizeof kinds - 1)];
    size_t count = 0;
    if (kind == '?') {
        change_known(d);
    } else if (kind == 'N') {
        change_net(d);
    } else if ((count = find(d, kind, places)) > 0) {
        const place p = places[below(count)];
        if (kind == 'n') {
            change_number(d, p);
        } else if (kind == 's') {
            change_word(d, p);
        } else {
            change_list(d, p);
        }
    }
}

size_t LLVMFuzzerCustomMutator(uint8_t *data, size_t size, size_t max_size, unsigned int seed)
{
    document d = {(char *)data, size, max_size};
    state = seed;
    if (size == 0 || data[0] != '{' || below(16) == 0) {
        return LLVMFuzzerMutate(data, size, max_size);
    }
    for (size_t i = 1 + below(3); i > 0; i--) {
        change(&d);
    }
    return d.size;
}
