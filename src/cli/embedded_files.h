/* embedded_files.h -- examples, paper tables and schemas that are part of the program
 * (cmake/embed.cmake).
 */
#ifndef TAUT_CLI_EMBEDDED_FILES_H
#define TAUT_CLI_EMBEDDED_FILES_H

#include <stddef.h>

typedef struct taut_embedded {
    const char *name; /* without folder; NULL ends the list */
    const char *text; /* ended by a 0 byte */
    size_t length;
} taut_embedded;

extern const taut_embedded taut_examples[]; /* examples/NAME.json */
extern const taut_embedded taut_papers[];   /* data/papers/KEY.json */
extern const taut_embedded taut_schemas[];  /* docs/schema/KIND.json */
extern const taut_embedded taut_pages[];    /* pages whose tables `taut help WORD` reads */
extern const taut_embedded taut_titles[];   /* examples/titles.txt: "NAME: title", one a line */

/* The file whose name is `name` plus ".json", or NULL. */
const taut_embedded *cli_embedded_find(const taut_embedded *files, const char *name);
/* Prints the names, without ".json", one a line. */
void cli_embedded_list(const taut_embedded *files);
/* "there is no KIND ...; there are: a, b, c"; returns 2. */
int cli_embedded_unknown(const taut_embedded *files, const char *kind, const char *name);

#endif /* TAUT_CLI_EMBEDDED_FILES_H */
