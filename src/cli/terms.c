/* terms.c -- taut help WORD: what a construction makes and which members its document has, what a member or a claim says,
 * what a number of the report or a term of the field is: rows of the tables of README.md and docs/, which are part of
 * the program, so that they are written once. */
#include "cli/cli.h"
#include "cli/embedded_files.h"

#include <ctype.h>
#include <stdio.h>
#include <string.h>

enum { CELLS = 4, CELL_ROOM = 600, INDENT = 19 };

typedef struct table {
    const char *file, *heading;
    int word;              /* the cell that the words are in */
    int is_quoted;         /* words are those in `...`, else the cell is one */
    const char *kind;      /* after "WORD, " */
    int says[2];           /* the cells that are printed; -1: none */
    const char *labels[2]; /* before them */
    const char *page;      /* "": the one that the word links to */
    const char *end;       /* NULL: one table; else all to this line, below "### `NAME`" */
} table;

static const char MEMBER[] = "a member of problems";

static const table tables[] = {
    {"README.md",
     "## What you have, what you get",
     2,
     1,
     "a construction",
     {0, 1},
     {"You have:", "You get:"},
     "",
     NULL},
    {"certificate.md",
     "## All claims",
     1,
     1,
     "a claim of certificates",
     {2, 3},
     {"What it says:", "How it is known:"},
     "docs/certificate.md",
     NULL},
    {"certificate.md",
     "## Three kinds",
     0,
     1,
     "a kind of claims",
     {1, 2},
     {"What it is:", "Proved:"},
     "docs/certificate.md",
     NULL},
    {"certificate.md",
     "## Words of the report",
     0,
     1,
     "a word of the report",
     {1, -1},
     {"What it is:", ""},
     "docs/certificate.md",
     NULL},
    {"architecture.md",
     "## Glossary",
     0,
     0,
     "a term",
     {1, -1},
     {"What it is:", ""},
     "docs/architecture.md",
     NULL},
    {"format.md",
     "## Problems",
     0,
     1,
     "a member of every problem",
     {1, 2},
     {"What it says:", "Default:"},
     "docs/format.md",
     NULL},
    {"format.md",
     "### `dirichlet`",
     0,
     1,
     MEMBER,
     {1, 2},
     {"What it says:", "Default:"},
     "docs/format.md",
     "## Reports"},
    {"format.md",
     "## Bases",
     0,
     1,
     "a basis",
     {1, 3},
     {"Members:", "Range:"},
     "docs/format.md",
     NULL},
    {"format.md",
     "Of their members:",
     0,
     1,
     "a member of bases",
     {1, -1},
     {"What it says:", ""},
     "docs/format.md",
     NULL},
    {"format.md",
     "## Surfaces and curves",
     0,
     1,
     "a part of documents",
     {1, -1},
     {"Written:", ""},
     "docs/format.md",
     NULL},
};
enum { TABLES = (int)(sizeof tables / sizeof tables[0]) };

typedef struct row {
    const table *table;
    char cell[CELLS][CELL_ROOM];
    char word[CLI_TERM_ROOM];
    char section[CLI_TERM_ROOM]; /* the heading that it is under, where its table has several */
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

/* The name in "### `NAME`". */
static void take_section(const char *line, row *r)
{
    const char *name = strchr(line, '`');
    if (name != NULL) {
        snprintf(r->section, sizeof r->section, "%.*s", (int)strcspn(name + 1, "`\n"), name + 1);
    }
}

static int visit_table(const table *t, const char *text, visitor visit, void *context)
{
    row r = {.table = t};
    const char *line = strstr(text, t->heading);
    int end = 0, lines = 0; /* of this table: names of columns, a rule, rows */

    for (; line != NULL && end == 0; line = strchr(line, '\n')) {
        line += *line == '\n';
        if (t->end != NULL && strncmp(line, t->end, strlen(t->end)) == 0) {
            break;
        }
        if (t->end != NULL && strncmp(line, "### ", 4) == 0) {
            take_section(line, &r);
        }
        if (*line == '|' && ++lines > 2) {
            take_row(line + 1, &r);
            end = visit_words(&r, visit, context);
        } else if (*line != '|' && lines > 0) {
            if (t->end == NULL) {
                break;
            }
            lines = 0;
        }
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

/* A label and a text without the marks of bold text and of links, and `end`. */
static void print_says(const char *label, const char *text, const char *end)
{
    char plain[CELL_ROOM];
    size_t length = 0;
    for (const char *at = text; *at != '\0'; at++) {
        if (at[0] == '*' && at[1] == '*') {
            at++;
        } else if (at[0] == ']' && at[1] == '(') {
            at += strcspn(at, ")");
        } else if (*at != '[' || strchr(at, ']') == NULL || strchr(at, ']')[1] != '(') {
            plain[length++] = *at;
        }
    }
    plain[length] = '\0';
    printf("  %-*s", INDENT - 2, label);
    cli_print_filled(plain, INDENT, INDENT);
    printf("%s\n", end);
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

/* The names of the members of a construction that are needed, or of those that are not. */
typedef struct listing {
    const char *construction;
    int is_needed, has_others; /* others may stand for one of them */
    char names[2 * CELL_ROOM];
} listing;

static int is_needed(const row *r)
{
    return strncmp(r->cell[2], "needed", 6) == 0;
}

static int has_name(const char *names, const char *name)
{
    const size_t length = strlen(name);
    for (const char *at = strstr(names, name); at != NULL; at = strstr(at + 1, name)) {
        if ((at == names || at[-1] == ' ') && (at[length] == ',' || at[length] == '\0')) {
            return 1;
        }
    }
    return 0;
}

static int list_member(void *context, const row *r)
{
    listing *l = context;
    const size_t used = strlen(l->names);

    if (r->table->kind == MEMBER && strcmp(r->section, l->construction) == 0 &&
        is_needed(r) == l->is_needed && !has_name(l->names, r->word)) {
        snprintf(l->names + used, sizeof l->names - used, "%s%s", used > 0 ? ", " : "", r->word);
        l->has_others = l->has_others || strncmp(r->cell[2], "needed, or", 10) == 0;
    }
    return 0;
}

static void print_members(const char *construction)
{
    for (int needed = 1; needed >= 0; needed--) {
        listing l = {construction, needed, 0, ""};
        walk(list_member, &l);
        if (l.names[0] != '\0') {
            print_says(needed ? "It needs:" : "It may have:", l.names,
                       l.has_others ? " (or others in their place)" : "");
        }
    }
}

typedef struct asked {
    const char *word;
    int found, after;
} asked;

static void print_construction(const row *r)
{
    const char *example = cli_example_of(r->word);
    print_members(r->word);
    printf("  %-17staut example --construct %s\n", "Documents:", r->word);
    if (example != NULL) {
        printf("  %-17staut example %.*s | taut make - -o model.json -o model.png\n",
               "Example:", (int)strcspn(example, "."), example);
    }
    printf("  %-17s", "More:");
    print_link(r->cell[r->table->word]);
    printf("\n");
}

static int print_row(void *context, const row *r)
{
    asked *a = context;
    const table *t = r->table;

    if (!is_same(a->word, r->word) || strcmp(r->section, r->word) == 0) {
        return 0; /* "trace": "asymptotic" is how a document names its construction */
    }
    printf("%s%s, %s", a->found > 0 || a->after ? "\n" : "", r->word, t->kind);
    if (r->section[0] != '\0') {
        printf(" (`%s`)", r->section);
    } else if (t->word == 1) {
        printf(" (%s)", r->cell[0]);
    }
    printf("\n\n");
    for (int k = 0; k < 2 && t->says[k] >= 0; k++) {
        const char *says = r->cell[t->says[k]];
        if (says[0] != '\0') {
            print_says(t->labels[k], strcmp(says, "needed") == 0 ? "none: it is needed" : says,
                       ".");
        }
    }
    if (t->page[0] == '\0') {
        print_construction(r);
    } else {
        printf("  %-17s%s\n", "More:", t->page);
    }
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
