/* terms.c -- taut help WORD: what a construction makes, what a claim says, what a number of the report or a term of the
 * field is: rows of the tables of README.md and docs/, which are part of the program, so that they are written once. */
#include "cli/cli.h"
#include "cli/embedded_files.h"

#include <ctype.h>
#include <stdio.h>
#include <string.h>

enum { CELLS = 4, CELL_ROOM = 600 };

typedef struct table {
    const char *file, *heading;
    int word;              /* the cell that the words are in */
    int is_quoted;         /* words are those in `...`, else the cell is one */
    const char *kind;      /* after "WORD, " */
    int says[2];           /* the cells that are printed; -1: none */
    const char *labels[2]; /* before them */
    const char *page;      /* "": the one that the word links to */
} table;

static const table tables[] = {
    {"README.md",
     "## What you have, what you get",
     2,
     1,
     "a construction",
     {0, 1},
     {"You have:", "You get:"},
     ""},
    {"certificate.md",
     "## All claims",
     1,
     1,
     "a claim of certificates",
     {2, 3},
     {"What it says:", "How it is known:"},
     "docs/certificate.md"},
    {"certificate.md",
     "## Three kinds",
     0,
     1,
     "a kind of claims",
     {1, 2},
     {"What it is:", "Proved:"},
     "docs/certificate.md"},
    {"certificate.md",
     "## Words of the report",
     0,
     1,
     "a word of the report",
     {1, -1},
     {"What it is:", ""},
     "docs/certificate.md"},
    {"architecture.md",
     "## Glossary",
     0,
     0,
     "a term",
     {1, -1},
     {"What it is:", ""},
     "docs/architecture.md"},
};
enum { TABLES = (int)(sizeof tables / sizeof tables[0]) };

typedef struct row {
    const table *table;
    char cell[CELLS][CELL_ROOM];
    char word[CLI_TERM_ROOM];
} row;

/* Nonzero ends the walk. */
typedef int (*visitor)(void *context, const row *r);

/* The part of a line before the next bar that is not escaped, without blanks around it; the place behind the bar. */
static const char *take_cell(const char *at, char cell[CELL_ROOM])
{
    size_t length = 0;
    while (*at == ' ') {
        at++;
    }
    for (; *at != '\0' && *at != '\n' && *at != '|'; at++) {
        at += *at == '\\' && at[1] == '|';
        if (length + 1 < CELL_ROOM) {
            cell[length++] = *at;
        }
    }
    while (length > 0 && cell[length - 1] == ' ') {
        length--;
    }
    cell[length] = '\0';
    return *at == '|' ? at + 1 : at;
}

/* Rows of a construction begin with its name in the first only. */
static void take_row(const char *line, row *r)
{
    char name[CELL_ROOM];
    memcpy(name, r->cell[0], sizeof name);
    for (int k = 0; k < CELLS; k++) {
        line = take_cell(line, r->cell[k]);
    }
    if (r->cell[0][0] == '\0') {
        memcpy(r->cell[0], name, sizeof name);
    }
}

/* Every word of a row; what `visit` returned. */
static int visit_words(row *r, visitor visit, void *context)
{
    const char *at = r->cell[r->table->word];
    int end = 0;

    if (!r->table->is_quoted) {
        snprintf(r->word, sizeof r->word, "%.*s", (int)sizeof r->word - 1, at);
        return visit(context, r);
    }
    for (at = strchr(at, '`'); at != NULL && end == 0; at = strchr(at, '`')) {
        const size_t length = strcspn(at + 1, "`");
        snprintf(r->word, sizeof r->word, "%.*s", (int)length, at + 1);
        end = visit(context, r);
        at += length + 1;
        at += *at == '`';
    }
    return end;
}

static int visit_table(const table *t, const char *text, visitor visit, void *context)
{
    row r = {.table = t};
    const char *line = strstr(text, t->heading);
    int end = 0;

    line = line != NULL ? strstr(line, "\n|") : NULL;
    for (int k = 0; line != NULL && end == 0 && line[1] == '|'; k++) {
        if (k > 1) { /* names of columns, and a rule */
            take_row(line + 2, &r);
            end = visit_words(&r, visit, context);
        }
        line = strchr(line + 1, '\n');
    }
    return end;
}

static void walk(visitor visit, void *context)
{
    int end = 0;
    for (int i = 0; i < TABLES; i++) {
        for (const taut_embedded *file = taut_pages; file->name != NULL && end == 0; file++) {
            if (strcmp(file->name, tables[i].file) == 0) {
                end = visit_table(&tables[i], file->text, visit, context);
            }
        }
    }
}

/* Without the marks of bold text and of links. */
static void print_plain(const char *text)
{
    for (const char *at = text; *at != '\0'; at++) {
        if (at[0] == '*' && at[1] == '*') {
            at++;
        } else if (at[0] == ']' && at[1] == '(') {
            at += strcspn(at, ")");
        } else if (*at != '[') {
            putchar(*at);
        }
    }
}

/* "docs/film.md" of "[`film`](docs/film.md)". */
static void print_link(const char *cell)
{
    const char *from = strstr(cell, "](");
    printf("%.*s", from != NULL ? (int)strcspn(from + 2, ")#") : 0, from != NULL ? from + 2 : "");
}

static int is_same(const char *a, const char *b)
{
    for (; *a != '\0' && *b != '\0'; a++, b++) {
        const int x = *a == ' ' || *a == '-' ? '_' : tolower((unsigned char)*a);
        const int y = *b == ' ' || *b == '-' ? '_' : tolower((unsigned char)*b);
        if (x != y) {
            return 0;
        }
    }
    return *a == *b;
}

typedef struct asked {
    const char *word;
    int found, after;
} asked;

static int print_row(void *context, const row *r)
{
    asked *a = context;
    const table *t = r->table;

    if (!is_same(a->word, r->word)) {
        return 0;
    }
    printf("%s%s, %s", a->found > 0 || a->after ? "\n" : "", r->word, t->kind);
    if (t->word == 1) {
        printf(" (");
        print_plain(r->cell[0]);
        printf(")");
    }
    printf("\n\n");
    for (int k = 0; k < 2 && t->says[k] >= 0; k++) {
        printf("  %-17s", t->labels[k]);
        print_plain(r->cell[t->says[k]]);
        printf(".\n");
    }
    if (t->page[0] == '\0') {
        const char *example = cli_example_of(r->word);
        printf("  %-17staut example --construct %s\n", "Documents:", r->word);
        if (example != NULL) {
            printf("  %-17staut example %.*s | taut make - -o model.json -o model.png\n",
                   "Example:", (int)strcspn(example, "."), example);
        }
        printf("  %-17s", "More:");
        print_link(r->cell[t->word]);
    } else {
        printf("  %-17s%s", "More:", t->page);
    }
    printf("\n");
    a->found++;
    return 0;
}

int cli_term_help(const char *word, int after)
{
    asked a = {word, 0, after};
    walk(print_row, &a);
    return a.found;
}

typedef struct counted {
    int left;
    char *room;
} counted;

static int take_word(void *context, const row *r)
{
    counted *c = context;
    if (c->left-- > 0) {
        return 0;
    }
    memcpy(c->room, r->word, CLI_TERM_ROOM);
    return 1;
}

int cli_term_at(int i, char room[CLI_TERM_ROOM])
{
    counted c = {i, room};
    walk(take_word, &c);
    return c.left < 0;
}
