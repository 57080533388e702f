/* reasons.c -- taut help REASON: what a word that an error gives means, and what to change, out of the lists of the headers. */
#include "cli/cli.h"

#include <stdio.h>
#include <string.h>

typedef struct row {
    const char *word, *meaning, *remedy;
} row;

#define AS_ROW(word, meaning, remedy) {word, meaning, remedy},
#define AS_ROWS(name, LIST) static const row name[] = {LIST(AS_ROW){NULL, NULL, NULL}};
AS_ROWS(of_any_call, TAUT_REASON_LIST)
AS_ROWS(of_documents, TAUT_DOCUMENT_REASON_LIST)
AS_ROWS(of_files, TAUT_FILE_REASON_LIST)
AS_ROWS(of_bases, TAUT_BASIS_REASON_LIST)
AS_ROWS(of_geometry, TAUT_GEOMETRY_REASON_LIST)
AS_ROWS(of_certificates, TAUT_CERTIFY_REASON_LIST)
AS_ROWS(of_words, CLI_REASON_LIST)
AS_ROWS(of_asymptotic, TAUT_ASYMPTOTIC_REASON_LIST)
AS_ROWS(of_biharmonic, TAUT_BIHARMONIC_REASON_LIST)
AS_ROWS(of_bonnet, TAUT_BONNET_REASON_LIST)
AS_ROWS(of_dirichlet, TAUT_DIRICHLET_REASON_LIST)
AS_ROWS(of_film, TAUT_FILM_REASON_LIST)
AS_ROWS(of_gradient, TAUT_GRADIENT_REASON_LIST)
AS_ROWS(of_harmonic, TAUT_HARMONIC_REASON_LIST)
AS_ROWS(of_panels, TAUT_PANELS_REASON_LIST)
AS_ROWS(of_pattern, TAUT_PATTERN_REASON_LIST)
AS_ROWS(of_pipe, TAUT_PIPE_REASON_LIST)
AS_ROWS(of_plateau, TAUT_PLATEAU_REASON_LIST)
AS_ROWS(of_trace, TAUT_TRACE_REASON_LIST)
#undef AS_ROWS
#undef AS_ROW

/* Where each list applies, and the page of docs/ with its table. */
static const struct {
    const char *where, *page;
    const row *rows;
} lists[] = {{"any call", "errors", of_any_call},
             {"documents", "errors", of_documents},
             {"files", "errors", of_files},
             {"bases", "errors", of_bases},
             {"surfaces, curves and models", "errors", of_geometry},
             {"certificates", "errors", of_certificates},
             {"the command line", "errors", of_words},
             {"asymptotic", "asymptotic", of_asymptotic},
             {"biharmonic", "biharmonic", of_biharmonic},
             {"bonnet", "bonnet", of_bonnet},
             {"dirichlet", "dirichlet", of_dirichlet},
             {"film", "film", of_film},
             {"gradient", "gradient", of_gradient},
             {"harmonic", "harmonic", of_harmonic},
             {"panels", "bonnet", of_panels},
             {"pattern", "pattern", of_pattern},
             {"pipe", "pipe", of_pipe},
             {"plateau", "plateau", of_plateau},
             {"trace", "trace", of_trace}};
enum { LISTS = (int)(sizeof lists / sizeof lists[0]), INDENT = 18 };

static void print_says(const char *label, const char *text)
{
    printf("  %-*s", INDENT - 2, label);
    cli_print_filled(text, INDENT, INDENT);
    printf(".\n");
}

int cli_reason_help(const char *word)
{
    int found = 0;
    for (int i = 0; i < LISTS; i++) {
        for (const row *r = lists[i].rows; r->word != NULL; r++) {
            if (strcmp(word, r->word) == 0) {
                printf("%s%s, a reason of errors (%s)\n\n", found > 0 ? "\n" : "", word,
                       lists[i].where);
                print_says("What is wrong:", r->meaning);
                print_says("What to do:", r->remedy);
                printf("  %-*sdocs/%s.md\n", INDENT - 2, "More:", lists[i].page);
                found++;
            }
        }
    }
    return found;
}

const char *cli_reason_at(int i)
{
    for (int k = 0; k < LISTS; k++) {
        for (const row *r = lists[k].rows; r->word != NULL; r++) {
            if (i-- == 0) {
                return r->word;
            }
        }
    }
    return NULL;
}
