#include "io/json/slice.h"

#include "io/json/tree.h"

#include <string.h>

typedef taut_json_scan scan;

static void skip_space(scan *s)
{
    while (s->at < s->length && strchr(" \t\r\n", s->text[s->at]) != NULL) {
        s->at++;
    }
}

/* Past the quote that ends the string that begins here. */
static void skip_string(scan *s)
{
    for (s->at++; s->at < s->length && s->text[s->at] != '"'; s->at++) {
        s->at += s->text[s->at] == '\\';
    }
    s->at++;
}

/* Past the value that begins here: brackets are counted, strings are none of them. */
static void skip_value(scan *s)
{
    int depth = 0;
    do {
        const char c = s->text[s->at];
        if (c == '"') {
            skip_string(s);
        } else if (strchr("{}[],: \t\r\n", c) != NULL) {
            depth += (c == '{' || c == '[') - (c == '}' || c == ']');
            s->at++;
        } else {
            while (s->at < s->length && strchr("{}[],: \t\r\n", s->text[s->at]) == NULL) {
                s->at++;
            }
        }
    } while (depth > 0 && s->at < s->length);
}

/* Is `key` the word of a pointer from `word` to `end`, where ~0 is ~ and ~1 is / ? */
static int is_word(const char *key, const char *word, const char *end)
{
    for (; word < end; word++, key++) {
        char c = *word;
        if (c == '~' && word + 1 < end && (word[1] == '0' || word[1] == '1')) {
            word++;
            c = *word == '0' ? '~' : '/';
        }
        if (*key != c) {
            return 0;
        }
    }
    return *key == '\0';
}

/* The same of the key in quotes that begins here: escapes in it are the parser's to read. */
static taut_status compare_key(const scan *s, const char *word, const char *end, int *same)
{
    taut_json_document *document = NULL;
    scan past = *s;
    skip_string(&past);
    const taut_status status =
        taut_json_parse(s->text + s->at, past.at - s->at, "key", NULL, &document, NULL);
    if (status == TAUT_OK) {
        *same = is_word(taut_json_document_root(document)->as.string, word, end);
        taut_json_document_free(document);
    }
    return status;
}

/* Into an object, to the value of its member; *found 0, at the closing brace, where it has none. */
static taut_status enter_object(scan *s, const char *word, const char *end, int *found,
                                int *is_empty)
{
    *found = 0;
    *is_empty = 1;
    s->at++;
    skip_space(s);
    while (s->text[s->at] != '}') {
        taut_status status = TAUT_OK;
        *is_empty = 0;
        status = compare_key(s, word, end, found);
        if (status != TAUT_OK) {
            return status;
        }
        skip_string(s);
        skip_space(s);
        s->at++; /* the colon */
        skip_space(s);
        if (*found) {
            return TAUT_OK;
        }
        skip_value(s);
        skip_space(s);
        if (s->text[s->at] == ',') {
            s->at++;
            skip_space(s);
        }
    }
    return TAUT_OK;
}

/* Into a list, to item `word`; 0 where there is none, or that is no number. */
static int enter_list(scan *s, const char *word, const char *end)
{
    size_t index = 0;
    if (word == end || (end - word > 1 && *word == '0') || end - word > 9) {
        return 0;
    }
    for (; word < end; word++) {
        if (*word < '0' || *word > '9') {
            return 0;
        }
        index = 10 * index + (size_t)(*word - '0');
    }
    s->at++;
    skip_space(s);
    for (; s->text[s->at] != ']'; index--) {
        if (index == 0) {
            return 1;
        }
        skip_value(s);
        skip_space(s);
        if (s->text[s->at] == ',') {
            s->at++;
            skip_space(s);
        }
    }
    return 0;
}

taut_status taut_json_slice_find(const char *text, size_t length, const char *pointer,
                                 taut_json_slice *slice)
{
    scan s = {text, length, 0};
    const char *word = pointer;

    *slice = (taut_json_slice){.place = TAUT_JSON_NOWHERE};
    skip_space(&s);
    while (*word == '/') {
        word++;
        const char *end = word + strcspn(word, "/");
        int found = 0, is_empty = 0;
        if (text[s.at] == '{') {
            const taut_status status = enter_object(&s, word, end, &found, &is_empty);
            if (status != TAUT_OK) {
                return status;
            }
        } else if (text[s.at] == '[') {
            found = enter_list(&s, word, end);
        }
        if (!found) {
            const int may_be = text[s.at] == '}' && *end == '\0';
            *slice = (taut_json_slice){.place = may_be ? TAUT_JSON_ABSENT : TAUT_JSON_NOWHERE,
                                       .from = s.at,
                                       .to = s.at,
                                       .is_empty = is_empty,
                                       .key = (size_t)(word - pointer),
                                       .key_end = (size_t)(end - pointer)};
            return TAUT_OK;
        }
        word = end;
    }
    if (*word == '\0') {
        slice->place = TAUT_JSON_THERE;
        slice->from = s.at;
        skip_value(&s);
        slice->to = s.at;
    }
    return TAUT_OK;
}

taut_json_scan taut_json_scan_items(const char *text, size_t length)
{
    scan s = {text, length, 0};
    skip_space(&s);
    s.at++; /* the bracket */
    return s;
}

const char *taut_json_scan_next(taut_json_scan *s, size_t *length)
{
    skip_space(s);
    const size_t from = s->at;
    skip_value(s);
    *length = s->at - from;
    skip_space(s);
    s->at++; /* the comma, or the end */
    return s->text + from;
}
