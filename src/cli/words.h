/* words.h -- commands that write the document that their words ask for, and make that. */
#ifndef TAUT_CLI_WORDS_H
#define TAUT_CLI_WORDS_H

#include "cli/cli.h"

/* A document that is written piece by piece. */
typedef struct cli_words {
    char *bytes;
    size_t length, room;
    int failed;
} cli_words;

void cli_put(cli_words *t, const char *format, ...) TAUT_PRINTF(2, 3);
/* A word as JSON. */
void cli_put_word(cli_words *t, const char *word);
/* A member where its option was given: a number (0, or the exit code after one message), a word. */
int cli_put_number(const char *option, const char *word, const char *member, cli_words *t);
void cli_put_named(const char *word, const char *member, cli_words *t);

/* Makes what `write` writes, which returns 0 or the exit code after one message; the same. command: the name, for messages. */
int cli_run_words(const cli_options *options, const char *command,
                  int (*write)(const cli_options *options, cli_words *t));
/* The document in the first file, of the construction of this name; 0 or the exit code after one message, `needs` where it is
 * another's. */
int cli_run_document(const cli_options *options, const char *construction, const char *needs);

#endif /* TAUT_CLI_WORDS_H */
