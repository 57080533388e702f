/* fill.c -- help in lines that a terminal holds. */
#include "cli/cli.h"

#include <stdio.h>
#include <string.h>

enum { WIDTH = 100 };

void cli_print_filled(const char *text, int column, int indent)
{
    const char *at = text + strspn(text, " \n");
    while (*at != '\0') {
        const int word = (int)strcspn(at, " \n");
        const char *next = at + word + strspn(at + word, " \n");
        printf("%.*s", word, at);
        column += word;
        if (*next != '\0' && column + 1 + (int)strcspn(next, " \n") > WIDTH) {
            printf("\n%*s", indent, "");
            column = indent;
        } else if (*next != '\0') {
            putchar(' ');
            column++;
        }
        at = next;
    }
}
