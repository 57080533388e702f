/* scan_iges.c -- lines of 80 columns: 72 of content, the section's letter, its line's number.
 *
 * In section D each entity has two lines of ten fields: the second field of the first line points
 * at its parameters, the fourth of the second line counts their lines. Section P holds them in
 * columns 1-64, separated by commas, up to a semicolon; columns 66-72 point back at the entity. */
#include "io/cad/scan.h"

#include "core/fail.h"

#include <inttypes.h>
#include <stdio.h>
#include <string.h>

enum { SECTIONS = 5, LETTER = 72, FIELD = 8, PARAMETERS = 64, LINE = 80 };
enum { SECTION_G = 1, SECTION_D = 2, SECTION_P = 3, SECTION_T = 4 };

static const char letters[] = "SGDPT";

typedef struct iges_scan {
    const char *line; /* the present one */
    size_t size;      /* its columns, without the line's end */
    size_t number;    /* from 1 */
    int section;
    int64_t counts[SECTIONS];
    int64_t first; /* in section D: the parameters of the entity whose second line is due */
    int64_t last_parameter; /* the largest line of section P that an entity points at */
    int has_own_marks;      /* the file separates parameters by other marks */
    /* in section P */
    int64_t entity; /* whose parameters they are */
    int is_checked; /* they are geometry, and have not ended */
    int is_first;   /* the next parameter is the entity's type */
    int64_t skip;   /* characters of a text that go on in this line */
} iges_scan;

static taut_status refuse_line(const iges_scan *s, const char *what, taut_error *error)
{
    char where[32];
    snprintf(where, sizeof where, "line %zu", s->number);
    return taut_fail(error, TAUT_BAD_INPUT, "broken", where, taut_none, taut_none, "%s", what);
}

/* A number right-justified in the columns; -1 where there is none. */
static int64_t number_in(const char *columns, int width)
{
    int64_t value = 0;
    int digits = 0;
    for (int i = 0; i < width; i++) {
        if (columns[i] >= '0' && columns[i] <= '9') {
            value = value < 100000000 ? 10 * value + (columns[i] - '0') : value;
            digits++;
        } else if (columns[i] != ' ' || digits > 0) {
            return -1;
        }
    }
    return digits > 0 ? value : -1;
}

/* The last line: S, G, D, P, each with the number of its lines. */
static taut_status check_counts(const iges_scan *s, taut_error *error)
{
    if (s->size < LINE || number_in(s->line + LETTER + 1, FIELD - 1) != 1) {
        return refuse_line(s, "the file is broken off: its last line is not whole", error);
    }
    for (int k = 0; k < SECTIONS - 1; k++) {
        const char *field = s->line + k * FIELD;
        if (field[0] != letters[k] || number_in(field + 1, FIELD - 1) != s->counts[k]) {
            char what[96];
            snprintf(what, sizeof what,
                     "section %c has %" PRId64 " lines, which the last line denies", letters[k],
                     s->counts[k]);
            return refuse_line(s, what, error);
        }
    }
    if (s->last_parameter > s->counts[SECTION_P]) {
        return refuse_line(s, "an entity points at parameters that are not there", error);
    }
    return TAUT_OK;
}

/* A line of section D. */
static void note_entity(iges_scan *s)
{
    if (s->counts[SECTION_D] % 2 == 1) {
        s->first = number_in(s->line + FIELD, FIELD);
    } else {
        const int64_t lines = number_in(s->line + 3 * FIELD, FIELD);
        const int64_t last = s->first + (lines > 0 ? lines : 1) - 1;
        s->last_parameter = last > s->last_parameter ? last : s->last_parameter;
    }
}

/* One parameter of geometry: nothing, a number, or a text nH.... Returns how many columns it has up
 * to its comma or semicolon, which may be in the next line; -1 if it is none of these. */
static int parameter_length(iges_scan *s, const char *text, int room)
{
    int is_huge = 0, length = 0, blanks = 0;
    while (blanks < room && text[blanks] == ' ') {
        blanks++;
    }
    length = (int)taut_cad_number(text + blanks, (size_t)(room - blanks), "EeDd", &is_huge);
    if (length > 0 && blanks + length < room && text[blanks + length] == 'H') {
        const int64_t characters = number_in(text + blanks, length);
        if (characters < 0) {
            return -1;
        }
        s->skip = characters;
        length++;
    } else {
        while (blanks + length < room && text[blanks + length] == ' ') {
            length++;
        }
    }
    length += blanks;
    return is_huge || (s->skip == 0 && length < room && text[length] != ',' && text[length] != ';')
               ? -1
               : length;
}

/* A line of section P. */
static taut_status check_parameters(iges_scan *s, taut_error *error)
{
    const int64_t entity = number_in(s->line + PARAMETERS + 1, FIELD - 1);
    int at = 0;
    if (entity != s->entity || s->counts[SECTION_P] == 1) {
        s->entity = entity;
        s->is_first = s->is_checked = !s->has_own_marks;
        s->skip = 0;
    }
    while (s->is_checked && at < PARAMETERS) {
        if (s->skip > 0) {
            const int part = s->skip < PARAMETERS - at ? (int)s->skip : PARAMETERS - at;
            s->skip -= part;
            at += part;
        } else if (s->line[at] == ',' || s->line[at] == ';') {
            s->is_checked = s->line[at] == ',';
            at++;
        } else {
            const int64_t type = s->is_first ? number_in(s->line + at, 3) : 100;
            const int length = parameter_length(s, s->line + at, PARAMETERS - at);
            s->is_first = 0;
            s->is_checked = type >= 100 && type < 200;
            if (s->is_checked && length < 0) {
                return refuse_line(s, "found something else where a number below 1e308 is expected",
                                   error);
            }
            at += length > 0 ? length : 0;
        }
    }
    return TAUT_OK;
}

/* Which section the line is of, and what it must be there. */
static taut_status check_line(iges_scan *s, taut_error *error)
{
    const char *letter =
        s->size > LETTER && s->line[LETTER] != '\0' ? strchr(letters, s->line[LETTER]) : NULL;
    s->number++;
    if (letter == NULL) {
        return refuse_line(
            s,
            s->number == 1
                ? "this is no IGES file: its first line has no section's letter in column "
                  "73"
                : "no section's letter in column 73",
            error);
    }
    if (letter - letters < s->section) {
        return refuse_line(s, "sections out of order", error);
    }
    s->section = (int)(letter - letters);
    s->counts[s->section]++;
    if (s->section == SECTION_G && s->counts[SECTION_G] == 1) {
        s->has_own_marks = s->line[0] != ',' && memcmp(s->line, "1H,,1H;,", 8) != 0 &&
                           memcmp(s->line, "1H,,,", 5) != 0;
    }
    if (s->section == SECTION_D) {
        note_entity(s);
    }
    return s->section == SECTION_P   ? check_parameters(s, error)
           : s->section == SECTION_T ? check_counts(s, error)
                                     : TAUT_OK;
}

taut_status taut_cad_scan_iges(const char *text, size_t length, taut_error *error)
{
    iges_scan s = {.section = 0};
    size_t at = 0;
    taut_status status = TAUT_OK;

    while (status == TAUT_OK && at < length && s.section < SECTION_T) {
        const char *end = memchr(text + at, '\n', length - at);
        s.line = text + at;
        s.size = end != NULL ? (size_t)(end - s.line) : length - at;
        at += s.size + (end != NULL);
        status = check_line(&s, error);
    }
    if (status == TAUT_OK && s.section < SECTION_T) {
        status = refuse_line(
            &s, "the file is broken off: its last line, with a T in column 73, is missing", error);
    }
    return status;
}
