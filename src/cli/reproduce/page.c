/* page.c -- the rows of `taut reproduce` as a page of Markdown: each paper in one line,
 * then place by place.
 *
 * The page is compared with the one in docs/ on every machine, so ours is written to the digits
 * that the row's tolerance vouches for: the rounding of one processor must not show.
 */
#include "cli/cli.h"
#include "cli/embedded_files.h"
#include "cli/reproduce/reproduce.h"

#include "core/elementary/elementary.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { DIGITS_MAX = 10, NUMBER_ROOM = 64, CELL_ROOM = 512 };

static const char *const verdicts[] = {"agrees", "erratum", "beyond the paper", "differs"};
enum { VERDICTS = sizeof verdicts / sizeof verdicts[0] };

static const char *text(const taut_record *row, const char *key)
{
    return taut_record_text(taut_record_get(row, key));
}

/* A number to the place of its tolerance, or to ten digits; no zeros at the end, no -0. */
static void shown(double value, double tolerance, char room[NUMBER_ROOM])
{
    const int whole = value != 0 && isfinite(value) ? (int)floor(taut_log10(fabs(value))) : 0;
    int places = tolerance > 0 ? (int)ceil(-taut_log10(tolerance)) : DIGITS_MAX;
    char *end = NULL;
    if (!isfinite(value)) {
        snprintf(room, NUMBER_ROOM, "-");
        return;
    }
    if (fabs(value) <= tolerance) {
        snprintf(room, NUMBER_ROOM, "0");
        return;
    }
    places = places > DIGITS_MAX - 1 - whole ? DIGITS_MAX - 1 - whole : places;
    snprintf(room, NUMBER_ROOM, "%.*f", places > 0 ? places : 0, value);
    if (strchr(room, '.') != NULL) {
        for (end = room + strlen(room); end[-1] == '0'; end--) {
            end[-1] = '\0';
        }
        if (end[-1] == '.') {
            end[-1] = '\0';
        }
    }
}

/* Is the next row the next coordinate of the same point, with the same said about it? */
static int continues(const taut_record *row, const taut_record *next)
{
    static const char *const same[] = {"source", "problem", "verdict", "erratum"};
    const char *a = text(row, "quantity"), *b = text(next, "quantity");
    const size_t length = strlen(a);
    for (size_t i = 0; i < sizeof same / sizeof same[0]; i++) {
        if (strcmp(text(row, same[i]), text(next, same[i])) != 0) {
            return 0;
        }
    }
    return length > 2 && length == strlen(b) && strncmp(a, b, length - 1) == 0 &&
           a[length - 2] == ' ' && b[length - 1] == a[length - 1] + 1 && a[length - 1] >= 'x' &&
           b[length - 1] <= 'z';
}

/* Appends words to a cell that has room for them. */
static void append(char cell[CELL_ROOM], const char *words)
{
    const size_t used = strlen(cell);
    snprintf(cell + used, CELL_ROOM - used, "%s", words);
}

/* The words of the last cell; a bar in them would end it. */
static void print_last_cell(const char *words)
{
    if (*words != '\0') {
        putchar(' ');
    }
    for (; *words != '\0'; words++) {
        if (*words == '|') {
            putchar('\\');
        }
        putchar(*words);
    }
    printf(" |\n");
}

/* Rows first .. first + count - 1 as one line of the table. */
static void print_line(const taut_record *list, size_t first, size_t count)
{
    const taut_record *row = taut_record_at(list, first);
    const char *quantity = text(row, "quantity");
    const int whole_point = count == 3;
    const int silent = text(row, "as_printed")[0] == '\0';
    char printed[CELL_ROOM] = "", ours[CELL_ROOM] = "", room[NUMBER_ROOM];

    for (size_t k = 0; k < count; k++) {
        const taut_record *part = taut_record_at(list, first + k);
        const char *as_printed = text(part, "as_printed");
        shown(taut_record_number(taut_record_get(part, "ours")),
              taut_record_number(taut_record_get(part, "tolerance")), room);
        append(printed, k > 0 ? ", " : "");
        append(printed, as_printed);
        append(ours, k > 0 ? ", " : "");
        append(ours, room);
    }
    if (silent) {
        snprintf(printed, sizeof printed, "-");
    }
    printf("| %.*s | %s%s%s | %s%s%s | %s |", (int)strlen(quantity) - (whole_point ? 2 : 0),
           quantity, whole_point && !silent ? "(" : "", printed, whole_point && !silent ? ")" : "",
           whole_point ? "(" : "", ours, whole_point ? ")" : "", text(row, "verdict"));
    print_last_cell(text(row, "erratum"));
}

/* The place within the paper: the source without its key. */
static const char *place_of(const taut_record *row)
{
    const char *end = strstr(text(row, "source"), "] ");
    return end != NULL ? end + 2 : text(row, "source");
}

static void print_places(const taut_record *list, const char *paper)
{
    const char *place = "", *problem = "";
    size_t used = 1;
    for (size_t i = 0; i < taut_record_count(list); i += used) {
        const taut_record *row = taut_record_at(list, i);
        used = 1;
        if (strcmp(text(row, "paper"), paper) != 0) {
            continue;
        }
        if (strcmp(place, place_of(row)) != 0 || strcmp(problem, text(row, "problem")) != 0) {
            place = place_of(row);
            problem = text(row, "problem");
            printf("\n### %s: `taut example %s`\n\n"
                   "| quantity | printed | ours | verdict | erratum |\n|---|---|---|---|---|\n",
                   place, problem);
        }
        if (i + 2 < taut_record_count(list) && continues(row, taut_record_at(list, i + 1)) &&
            continues(taut_record_at(list, i + 1), taut_record_at(list, i + 2))) {
            used = 3;
        }
        print_line(list, i, used);
    }
}

static void print_summary(const taut_record *list, const char *paper, const char *label)
{
    int counts[VERDICTS] = {0}, all = 0;
    for (size_t i = 0; i < taut_record_count(list); i++) {
        const taut_record *row = taut_record_at(list, i);
        for (int v = 0; v < VERDICTS && strcmp(text(row, "paper"), paper) == 0; v++) {
            counts[v] += strcmp(text(row, "verdict"), verdicts[v]) == 0;
        }
    }
    for (int v = 0; v < VERDICTS; v++) {
        all += counts[v];
    }
    printf("| %s | %d |", label, all);
    for (int v = 0; v < VERDICTS; v++) {
        printf(" %d |", counts[v]);
    }
    putchar('\n');
}

/* "[WuWang2011], Extending ..." for the paper of one embedded table. */
static void title_of(const taut_embedded *file, char *room, size_t size)
{
    taut_record *rows = NULL;
    if (taut_record_read_text(file->text, file->length, file->name, &rows, NULL) != TAUT_OK) {
        snprintf(room, size, "%s", file->name);
        return;
    }
    snprintf(room, size, "[%s] %s", text(rows, "paper"), text(rows, "title"));
    taut_record_free(rows);
}

void cli_reproduction_page(const taut_record *list)
{
    char title[CELL_ROOM];
    printf("| paper | numbers | agrees | erratum | beyond the paper | differs |\n"
           "|---|---|---|---|---|---|\n");
    for (const taut_embedded *file = taut_papers; file->name != NULL; file++) {
        title_of(file, title, sizeof title);
        print_summary(list, file->name, title);
    }
    for (const taut_embedded *file = taut_papers; file->name != NULL; file++) {
        title_of(file, title, sizeof title);
        printf("\n## %s\n", title);
        print_places(list, file->name);
    }
}
