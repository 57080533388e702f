/* cli.h -- what the commands share: options, messages, outputs. Commands use the public API only.
 */
#ifndef TAUT_CLI_H
#define TAUT_CLI_H

#include "core/printf.h"
#include "taut/taut.h"

#include <stddef.h>

enum { CLI_LIST_MAX = 4096 }; /* how often an option may be repeated */

/* All that any command can be told; each command's table says which of it. Zero: not given. */
typedef struct cli_options {
    const char *files[TAUT_MODELS_MAX]; /* operands */
    int file_count;
    const char **outputs; /* -o, repeated */
    int output_count;
    const char **at; /* --at, repeated */
    int at_count;
    const char *report;
    const char *surface;
    const char *curve;
    const char *colour;
    const char *view;
    const char *title;
    const char *text_u; /* split --u T */
    const char *text_v;
    const char *kind;   /* panels --kind */
    const char *panels; /* panels --divide NU,NV */
    const char *words;  /* the command whose words were made a document, or NULL */
    const char *net;    /* trace */
    const char **families;
    int family_count;
    const char **seed_edges;
    int seed_edge_count;
    const char **seed_lines;
    int seed_line_count;
    const char *direction, *to;
    const char *cell;
    const char *by;
    const char *max_length;
    const char *strip;
    const char *lath_width;
    const char *thickness;
    const char *material;
    const char *cut;
    const char *play;
    int judge_panels;            /* trace --panels */
    int carry;                   /* trace --carry */
    int solid;                   /* trace, make: --solid */
    const char *cut_sheet;       /* trace --sheet */
    const char *across, *radial; /* pattern */
    const char **geodesics;
    int geodesic_count;
    const char **seam_lines;
    int seam_line_count;
    const char *warp, *weft, *strain, *allowance, *border, *marks;
    const char *seam_length;
    const char **holds; /* pattern --hold */
    int hold_count;
    int count;
    int cells;
    int both;
    double tolerance;
    double time_limit;
    double sheet; /* make and convert --thickness */
    int coefficients;
    int lagrange;
    int threads;
    int grid;
    int divide;
    int quiet;
    int json;
    int lines;             /* make --lines */
    int watch;             /* make --watch */
    const char *construct; /* example --construct */
    int markdown;
    int flag_u; /* refine --u */
    int flag_v;
    int no_net, show_net;
    int exact;
    int short_knots;
    int untrim;
    int pieces;
    int isolines;
    int reflections;
    int combs;
    int reactions;
    int column;
    const char *tiles, *scale;
    int side_by_side;
    int width;
    int help;
} cli_options;

typedef enum cli_kind {
    CLI_FLAG,    /* int, set to 1 */
    CLI_TEXT,    /* const char * */
    CLI_LIST,    /* const char ** and the int after it */
    CLI_NUMBER,  /* double in [lo, hi] */
    CLI_INTEGER, /* int in [lo, hi] */
    CLI_END
} cli_kind;

typedef struct cli_option {
    const char *name; /* "--tolerance" or "-o" */
    cli_kind kind;
    size_t offset;       /* into cli_options */
    size_t offset_count; /* CLI_LIST: of its count */
    double lo, hi;
    const char *value; /* what the help calls its value */
    const char *help;
} cli_option;

typedef struct cli_command {
    const char *name;
    const char *usage;   /* after "taut NAME" */
    const char *summary; /* one line */
    const char *text;    /* the rest of the help */
    const char *example; /* command lines to try, one a line */
    int files_min, files_max;
    const cli_option *options; /* ended by CLI_END */
    int (*run)(const cli_options *options);
} cli_command;

/* Option rows that several commands use. */
#define CLI_OUTPUT                                                                                 \
    {                                                                                              \
        "-o", CLI_LIST, offsetof(cli_options, outputs), offsetof(cli_options, output_count), 0, 0, \
            "FILE", "write FILE in the format of its ending; may be repeated"                      \
    }
#define CLI_JSON                                                                                   \
    {                                                                                              \
        "--json", CLI_FLAG, offsetof(cli_options, json), 0, 0, 0, NULL, "print JSON"               \
    }
#define CLI_THREADS                                                                                \
    {                                                                                              \
        "--threads", CLI_INTEGER, offsetof(cli_options, threads), 0, 1, TAUT_THREADS_MAX, "N",     \
            "use N threads, not one, or all for large nets; the result is the same"                \
    }
#define CLI_SOLID                                                                                  \
    {                                                                                              \
        "--solid", CLI_FLAG, offsetof(cli_options, solid), 0, 0, 0, NULL,                          \
            "CAD and meshes: laths of a net as solids of their thickness, not as strips"           \
    }
#define CLI_SHEET                                                                                  \
    {                                                                                              \
        "--thickness", CLI_NUMBER, offsetof(cli_options, sheet), 0, 1e-9, 1e9, "T",                \
            "CAD and meshes: surfaces as closed sheets of this thickness, in the model's unit"     \
    }
#define CLI_COEFFICIENTS                                                                           \
    {                                                                                              \
        "--coefficients", CLI_FLAG, offsetof(cli_options, coefficients), 0, 0, 0, NULL,            \
            "VTU: fields as coefficients of Bezier cells, nearer between points, not in range"     \
    }
#define CLI_LAGRANGE                                                                               \
    {                                                                                              \
        "--lagrange", CLI_FLAG, offsetof(cli_options, lagrange), 0, 0, 0, NULL,                    \
            "VTU: Lagrange cells through points of the surfaces, which meshio reads too"           \
    }
#define CLI_TOLERANCE                                                                              \
    {                                                                                              \
        "--tolerance", CLI_NUMBER, offsetof(cli_options, tolerance), 0, 1e-14, 1, "T",             \
            "largest distance from the exact surface over its size (default 1e-6; 1e-3 for "       \
            "meshes)"                                                                              \
    }
#define CLI_DIVIDE                                                                                 \
    {                                                                                              \
        "--divide", CLI_INTEGER, offsetof(cli_options, divide), 0, 1, 1000, "N",                   \
            "meshes and figures: N cells per knot span in each direction"                          \
    }
#define CLI_SURFACE                                                                                \
    {                                                                                              \
        "--surface", CLI_TEXT, offsetof(cli_options, surface), 0, 0, 0, "NAME",                    \
            "only the surface of this name"                                                        \
    }
#define CLI_FIGURE_BUT_WIDTH                                                                       \
    {"--colour",                                                                                   \
     CLI_TEXT,                                                                                     \
     offsetof(cli_options, colour),                                                                \
     0,                                                                                            \
     0,                                                                                            \
     0,                                                                                            \
     "H|K|I|gap|warp|weft|strain",                                                                 \
     "figures, GLB: colour by curvature, isothermality, gap, forces or strain"},                   \
        {"--isolines",                                                                             \
         CLI_INTEGER,                                                                              \
         offsetof(cli_options, isolines),                                                          \
         0,                                                                                        \
         1,                                                                                        \
         TAUT_ISOLINES_MAX,                                                                        \
         "N",                                                                                      \
         "figures: N lines of equal colour from 0 to the scale's end, or of equal u and v"},       \
        {"--reflections",                                                                          \
         CLI_INTEGER,                                                                              \
         offsetof(cli_options, reflections),                                                       \
         0,                                                                                        \
         1,                                                                                        \
         TAUT_LIGHTS_MAX,                                                                          \
         "N",                                                                                      \
         "figures: stripes as N upright lamps all around leave (12 is a good number)"},            \
        {"--combs",                                                                                \
         CLI_FLAG,                                                                                 \
         offsetof(cli_options, combs),                                                             \
         0,                                                                                        \
         0,                                                                                        \
         0,                                                                                        \
         NULL,                                                                                     \
         "figures: curvature combs along the edges"},                                              \
        {"--reactions",                                                                            \
         CLI_FLAG,                                                                                 \
         offsetof(cli_options, reactions),                                                         \
         0,                                                                                        \
         0,                                                                                        \
         0,                                                                                        \
         NULL,                                                                                     \
         "figures: arrows, as the cables of a film pull at its supports"},                         \
        {"--side-by-side",                                                                         \
         CLI_FLAG,                                                                                 \
         offsetof(cli_options, side_by_side),                                                      \
         0,                                                                                        \
         0,                                                                                        \
         0,                                                                                        \
         NULL,                                                                                     \
         "figures: each surface apart, such as the frames of a deformation"},                      \
        {"--view", CLI_TEXT, offsetof(cli_options, view), 0, 0,                                    \
         0,        "AZ,EL",  "figures: camera in degrees"},                                        \
        {"--title", CLI_TEXT, offsetof(cli_options, title), 0, 0,                                  \
         0,         "TEXT",   "figures: a line above"},                                            \
        {"--tiles",                                                                                \
         CLI_TEXT,                                                                                 \
         offsetof(cli_options, tiles),                                                             \
         0,                                                                                        \
         0,                                                                                        \
         0,                                                                                        \
         "a4|a3",                                                                                  \
         "pdf: pieces to cut 1:1 on sheets of paper, to be put together"},                         \
        {"--scale",                                                                                \
         CLI_TEXT,                                                                                 \
         offsetof(cli_options, scale),                                                             \
         0,                                                                                        \
         0,                                                                                        \
         0,                                                                                        \
         "1:N",                                                                                    \
         "pdf: pieces to cut on one page, so much smaller (default 1:1)"},                         \
        {"--no-net", CLI_FLAG, offsetof(cli_options, no_net),       0, 0,                          \
         0,          NULL,     "figures: leave the control net out"},                              \
        {"--show-net",                                                                             \
         CLI_FLAG,                                                                                 \
         offsetof(cli_options, show_net),                                                          \
         0,                                                                                        \
         0,                                                                                        \
         0,                                                                                        \
         NULL,                                                                                     \
         "figures: the control net, of pipes, films, traces and patterns too"},                    \
    {                                                                                              \
        "--column", CLI_FLAG, offsetof(cli_options, column), 0, 0, 0, NULL,                        \
            "figures: 88 mm wide, for a paper's column"                                            \
    }
#define CLI_FIGURE                                                                                 \
    CLI_FIGURE_BUT_WIDTH,                                                                          \
    {                                                                                              \
        "--width", CLI_INTEGER, offsetof(cli_options, width), 0, 16, TAUT_WIDTH_MAX, "PIXELS",     \
            "png: how wide (default 1200)"                                                         \
    }
#define CLI_EXACT                                                                                  \
    {                                                                                              \
        "--exact", CLI_FLAG, offsetof(cli_options, exact), 0, 0, 0, NULL,                          \
            "in rational arithmetic (harmonic surfaces): coordinates come out as \"p/q\""          \
    }
#define CLI_UNTRIM                                                                                 \
    {                                                                                              \
        "--untrim", CLI_FLAG, offsetof(cli_options, untrim), 0, 0, 0, NULL,                        \
            "STEP, IGES: read trimmed faces as the whole surfaces under them"                      \
    }
#define CLI_SHORT_KNOTS                                                                            \
    {                                                                                              \
        "--short-knots", CLI_FLAG, offsetof(cli_options, short_knots), 0, 0, 0, NULL,              \
            "json: B-spline knots without the outermost two, as openNURBS has them"                \
    }
#define CLI_LAST                                                                                   \
    {                                                                                              \
        NULL, CLI_END, 0, 0, 0, 0, NULL, NULL                                                      \
    }

/* Parses the words after the command into *options; 0, or the exit code after one message. */
int cli_parse(const cli_command *command, int count, char **words, cli_options *options);
void cli_parse_free(cli_options *options);
/* A whole word as a finite number; 0 if it is none. Independent of the locale. */
int cli_number(const char *word, double *value);
/* "U,V" as two numbers; 0 if it is none. */
int cli_pair(const char *word, double *a, double *b);

/* Reasons that the command line itself is wrong (exit 2): word, meaning, remedy. */
#define CLI_REASON_LIST(X)                                                                         \
    X("command", "there is no such command, or none was given", "see taut --help")                 \
    X("operand", "too few files or words, or too many", "see the command's --help")                \
    X("option", "an unknown option, one that is missing, or some that exclude each other",         \
      "see the command's --help")                                                                  \
    X("value", "the value of an option is not one that it takes", "give one that `expected` says") \
    X("name", "the model, or the list of examples, papers or schemas, has nothing of this name",   \
      "take one of the names that are there")                                                      \
    X("range", "a parameter outside the range of its basis", "give one inside the range")

enum { CLI_TERM_ROOM = 64 };
/* Prints what a reason means and what to change, once for each list that has it; how many had. */
int cli_reason_help(const char *word);
/* The same of a construction, a claim, a word of the report or of the glossary; blanks and hyphens are as underscores.
 * `after`: nonzero where something was printed before. How many it is. */
int cli_term_help(const char *word, int after);
/* The file of the shortest worked problem of a construction; NULL where there is none. */
const char *cli_example_of(const char *construct);
/* Word i = 0, 1, ... of these, in `room`; 0 at the end. */
int cli_term_at(int i, char room[CLI_TERM_ROOM]);
/* All reasons, i = 0, 1, ..., some twice; NULL at the end. */
const char *cli_reason_at(int i);

/* From now on what goes wrong is told as JSON: one line on standard error. */
void cli_speak_json(void);
/* From now on a signal that stops the program is told too, and what is half written goes. */
void cli_catch_signals(void);
int cli_speaks_json(void);

/* Prints "taut: WHERE: message", or the error as JSON, and returns the status's exit code. */
int cli_fail(const taut_error *error);
/* The same about a document: where the place is a JSON pointer the file's name comes first. */
int cli_fail_in(const char *file, const taut_error *error);
/* The same about the document that the words of a command made: what is wrong with a word is a wrong
 * command line, 2. */
int cli_fail_in_words(const char *command, const char *file, const taut_error *error);
/* The same, told to a program with the place where it happened, a path: the sentence has it already. */
int cli_fail_at(const char *path, const taut_error *error);
/* Prints "taut: FILE: warning: text": what is not as it seems, and no reason to stop. With --json it is kept. */
void cli_warn(const char *file, const char *text);
/* With --json prints what was warned of, unless an error was printed: { "warnings": [ { "where", "message" } ] }, in a line. */
void cli_warnings_done(void);
/* Prints "taut: message" and returns 2: the command line is wrong. `reason` is a word of the list
 * above. */
int cli_misuse(const char *reason, const char *format, ...) TAUT_PRINTF(2, 3);
/* The same of one path. */
int cli_misuse_path(const char *reason, const char *path, const char *format, ...)
    TAUT_PRINTF(3, 4);
/* "taut: OPTION WORD: expected EXPECTED", and 2: the value of an option is wrong. */
int cli_misuse_value(const char *option, const char *word, const char *expected, ...)
    TAUT_PRINTF(3, 4);
/* An option, and whether it is given. */
typedef struct cli_given {
    int is_given;
    const char *name;
} cli_given;
/* 2 where one of them is given, which need `without` and a surface: a document beside them would have the last word. Else 0. */
int cli_refuse_given(const char *command, const char *without, size_t count,
                     const cli_given *words);
/* The error as a record { "error": { ... } }, the caller's; `where` is the pointer, or what else says the place. */
taut_record *cli_error_record(const taut_error *error, const char *where);
/* JSON text in one line, in place: its ends of lines and what follows them become a blank each, the last one goes. */
size_t cli_one_line(char *text, size_t length);
/* Memory ran out: 6, after its message. */
int cli_no_memory(void);
/* The known word nearest to a wrong one, or NULL if none is near; words ended by NULL. */
const char *cli_nearest(const char *word, const char *const *words);

/* The write options that the command line asked for; 0, or the exit code after one message. */
int cli_write_options(const cli_options *options, taut_write_options *chosen);
/* Checks that each output has a format before any work is done; 0 or the exit code. */
int cli_check_outputs(const cli_options *options);
/* Outputs with the signal handlers that remove what is half done; free by cli_outputs_free. */
int cli_outputs_new(taut_outputs **outputs);
void cli_outputs_free(taut_outputs *outputs);
/* Puts the outputs in place; 0, or the exit code after one message. */
int cli_commit(taut_outputs *outputs);
/* ", within 3e-07 mm" or ", exact" for the proved distance of an output, "" where it is NaN. */
enum { CLI_DISTANCE_ROOM = 64 };
const char *cli_distance(double bound, const taut_model *model, char room[CLI_DISTANCE_ROOM]);
/* The words of a text on standard output, in lines of at most 100: the first goes on at `column`, the others begin after `indent`
 * blanks; no end of line after the last. */
void cli_print_filled(const char *text, int column, int indent);
/* A file's name without folder and ending. */
void cli_label(const char *file, char *text, size_t size);
/* Writes several models into every -o side by side; 0 or the exit code. */
int cli_write_models(int count, const taut_model *const *models, const cli_options *options);
/* A model from a file, as its options say; what its reader left out or changed is told on standard error. */
taut_status cli_read_model(const char *path, const cli_options *options, taut_model **model,
                           taut_error *error);
/* The same; of trimmed faces the edges, but with --untrim. */
taut_status cli_read_edges(const char *path, const cli_options *options, taut_model **model,
                           taut_error *error);
/* The same, of a file that may hold a problem instead: the other one is NULL. */
taut_status cli_read_either(const char *path, const cli_options *options, taut_problem **problem,
                            taut_model **model, taut_error *error);
/* Proves the certificate that a model of `file` carries again, for whoever looks at it; warns where it fails, and where it stays
 * as it was saved. */
void cli_prove_again(const char *file, taut_model *model, const cli_options *options);
/* Its certificate is what its problem proves; a claim that does not hold is warned of. 0 or the exit code. */
int cli_prove_against(const char *file, const char *problem_file, taut_model *model,
                      const cli_options *options);
/* Before it is written anywhere: a model of which a claim does not hold any more gets the certificate that says so, in place of the
 * saved one; of one that holds *shown is a copy with its certificate proved again, for pictures, else NULL. 0 or the exit code. */
int cli_prove_for_outputs(const char *file, taut_model **model, const cli_options *options,
                          taut_model **shown);
/* *model is converted to the unit of the first one, with a warning where that is not `told` otherwise; 0 or the exit code. */
int cli_one_unit(const char *file, const taut_model *first, taut_model **model, int told);
/* " mm^2" for what is measured under a key such as "area", "" for a number without a unit of length. */
enum { CLI_UNIT_ROOM = 16 };
const char *cli_unit_of(const char *key, const char *unit, char room[CLI_UNIT_ROOM]);
/* Nonzero where the format of a path is a figure or a page. */
int cli_is_picture(const char *path);
/* Nonzero where the format of a path is taut's own. */
int cli_is_json(const char *path);
/* The model that a file at `path` gets, *written: laths of a net as strips, or solids (options->solid), in CAD and
 * meshes, which *strips (NULL before the first) then holds, the caller's; else the model itself. 0 or the exit
 * code. */
int cli_strips(const taut_model *model, const cli_options *options, const char *path,
               taut_model **strips, const taut_model **written);

/* Writes the model to every -o, or as JSON to standard output without one; where `nurbs` is not
 * NULL it stands for the model in JSON, within `bound` of it; where `shown` is not, it does in pictures. 0 or the exit code. */
int cli_write_or_nurbs(const taut_model *model, const taut_model *nurbs, double bound,
                       const taut_model *shown, const cli_options *options);
/* The same with the model alone. */
int cli_write_model(const taut_model *model, const cli_options *options);
/* Prints a record as JSON on standard output; 0 or the exit code after one message. Frees the
 * record. */
int cli_print_record(taut_record *record);
/* The same on standard error. */
int cli_report_json(taut_record *record);
/* Prints text on standard output, checking that it arrived. */
int cli_print_text(const char *text, size_t length);

/* A monitor that shows a progress line on a terminal once work has taken a second. */
taut_monitor cli_monitor(int quiet);

/* What --threads says; else for small problems and models 0 (one), for large ones the number of processors. */
int cli_threads_to_make(const cli_options *options, const taut_problem *problem);
int cli_threads_of(const cli_options *options, const taut_model *model);
void cli_monitor_done(void); /* wipes the line */
/* From now on: long work is told once on standard error, also where no terminal is watching. */
void cli_announce(const char *command);
double cli_seconds(void); /* a clock */

#endif /* TAUT_CLI_H */
