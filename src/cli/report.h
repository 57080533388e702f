/* report.h -- what `make` and `certify` tell: a short aligned table for a person, a record for a
 * program. */
#ifndef TAUT_CLI_REPORT_H
#define TAUT_CLI_REPORT_H

#include "cli/cli.h"

typedef struct cli_report {
    const char *construct;
    const taut_model *model;
    const taut_certificate *certificate;
    const char *const *outputs;
    const double *bounds; /* of each output: its proved distance from the model, NaN if none */
    int output_count;
    double seconds_made, seconds_proved, seconds_written;
} cli_report;

/* The table, on standard error. */
void cli_report_print(const cli_report *report);
/* The report as a record (docs/schema/report.json), the caller's; check taut_record_status. */
taut_record *cli_report_record(const cli_report *report);
/* A certificate as the contract's record, added to `record` under `key`. */
void cli_certificate_record(taut_record *record, const char *key,
                            const taut_certificate *certificate);
/* Claims and figures of a model's certificate as lines of the table. */
void cli_certificate_print(const taut_certificate *certificate, const taut_model *model);
/* The last of these: whether the certificate holds, of how many claims, and which are false or undecided. */
void cli_verdict_print(const taut_certificate *certificate);
/* Warns of a film whose curvatures are not resolved at some place. */
void cli_warn_of_curvature(const char *file, const taut_certificate *certificate);

/* Numbers, texts and lists of a record as such lines. */
void cli_members_print(const taut_record *record, const char *unit);

#endif /* TAUT_CLI_REPORT_H */
