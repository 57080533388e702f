/* make.h -- what `make` does with one problem and with a list of them share. */
#ifndef TAUT_CLI_MAKE_H
#define TAUT_CLI_MAKE_H

#include "cli/report.h"

/* A problem on its way to its files. */
typedef struct cli_made {
    taut_model *model; /* with its certificate; NULL: not made */
    cli_report report;
} cli_made;

/* Makes and proves. `file` and `place` ("" or "/2") say where the problem stands, for messages; 0,
 * or the exit code after one message. */
int cli_make_model(const taut_problem *problem, const cli_options *options, const char *place,
                   cli_made *made);

/* One problem: made, proved, written and told. 0 or the exit code. */
int cli_make_one(const taut_problem *problem, const cli_options *options);

/* All the documents of a list. 0 or the exit code. */
int cli_make_list(const taut_problem_list *list, const cli_options *options);

/* One problem a line of options->files[0], one model or one error a line of the only output, or of standard output. 0 or the exit
 * code. */
int cli_make_lines(const cli_options *options);

/* Makes by `make`, again whenever the problem's file is saved, until it is interrupted or saving cannot help; the exit code. */
int cli_watch(const cli_options *options, int (*make)(const cli_options *options));

#endif /* TAUT_CLI_MAKE_H */
