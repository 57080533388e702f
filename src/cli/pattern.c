/* pattern.c -- taut pattern: a surface cut into flat pieces of cloth, from a model or a problem and a few words. */
#include "cli/cli.h"
#include "cli/make.h"
#include "cli/words.h"

#include <string.h>

/* "v0,v1" as two words. */
static int put_edges(const char *word, cli_words *t)
{
    const char *comma = strchr(word, ',');
    char first[16];
    if (comma == NULL || (size_t)(comma - word) >= sizeof first) {
        return cli_misuse_value("--across", word, "two opposite edges, such as v0,v1");
    }
    memcpy(first, word, (size_t)(comma - word));
    first[comma - word] = '\0';
    cli_put(t, "\"across\": [");
    cli_put_word(t, first);
    cli_put(t, ", ");
    cli_put_word(t, comma + 1);
    cli_put(t, "]");
    return 0;
}

/* Strips across or from an edge. */
static int put_strips(const cli_options *options, cli_words *t)
{
    cli_put(t, "{ ");
    if (options->across != NULL) {
        const int code = put_edges(options->across, t);
        if (code != 0) {
            return code;
        }
    } else {
        cli_put(t, "\"radial\": ");
        cli_put_word(t, options->radial);
    }
    cli_put_named(options->by, "by", t);
    if (options->count > 0) {
        cli_put(t, ", \"count\": %d", options->count);
    } else if (options->lath_width != NULL || options->strain == NULL) {
        cli_put(t, ", \"width\": true");
    }
    if (options->count == 0 && options->strain != NULL) {
        const int code = cli_put_number("--strain", options->strain, "strain", t);
        if (code != 0) {
            return code;
        }
    }
    cli_put(t, " }");
    return 0;
}

/* Two numbers, or a word and one, with a sign between them; 0 where it is not that. */
static int split_at(const char *word, char sign, char first[32], double *second)
{
    const char *at = strchr(word, sign);
    if (at == NULL || at == word || (size_t)(at - word) >= 32) {
        return 0;
    }
    memcpy(first, word, (size_t)(at - word));
    first[at - word] = '\0';
    return cli_number(at + 1, second);
}

/* "0,0.5", or "u1:0.25": a part of an edge. */
static int put_at(const char *word, cli_words *t)
{
    char first[32];
    double x = 0, y = 0;
    if (split_at(word, ':', first, &y)) {
        cli_put(t, "{ \"edge\": ");
        cli_put_word(t, first);
        cli_put(t, ", \"part\": %.17g }", y);
        return 1;
    }
    if (split_at(word, ',', first, &y) && cli_number(first, &x)) {
        cli_put(t, "[%.17g, %.17g]", x, y);
        return 1;
    }
    return 0;
}

/* "AT AT" */
static int put_geodesic(const char *word, cli_words *t)
{
    const char *space = strchr(word, ' ');
    char first[64];
    int is_fine = space != NULL && (size_t)(space - word) < sizeof first;
    cli_put(t, "{ \"geodesic\": [");
    if (is_fine) {
        memcpy(first, word, (size_t)(space - word));
        first[space - word] = '\0';
        is_fine = put_at(first, t);
        cli_put(t, ", ");
        is_fine = is_fine && put_at(space + 1 + strspn(space + 1, " "), t);
    }
    cli_put(t, "] }");
    return is_fine ? 0
                   : cli_misuse_value("--geodesic", word,
                                      "two places, such as \"0,0.5 u1:0.25\" (u,v, or a part of an "
                                      "edge)");
}

/* "u=0.5" */
static int put_line(const char *word, cli_words *t)
{
    char first[32];
    double value = 0;
    if (!split_at(word, '=', first, &value) ||
        (strcmp(first, "u") != 0 && strcmp(first, "v") != 0)) {
        return cli_misuse_value("--line", word, "a parameter line, such as u=0.5");
    }
    cli_put(t, "{ \"line\": { \"%s\": %.17g } }", first, value);
    return 0;
}

/* Strips first, then lines and geodesics. */
static int put_rules(const cli_options *options, cli_words *t)
{
    int count = 0, code = 0;
    cli_put(t, ", \"seams\": [");
    if (options->across != NULL && options->radial != NULL) {
        return cli_misuse_value("--radial", options->radial, "no --across beside it");
    }
    if (options->across != NULL || options->radial != NULL) {
        code = put_strips(options, t);
        count++;
    }
    for (int k = 0; code == 0 && k < options->seam_line_count; k++) {
        cli_put(t, count++ > 0 ? ", " : "");
        code = put_line(options->seam_lines[k], t);
    }
    for (int k = 0; code == 0 && k < options->geodesic_count; k++) {
        cli_put(t, count++ > 0 ? ", " : "");
        code = put_geodesic(options->geodesics[k], t);
    }
    cli_put(t, "]");
    return code;
}

/* An object of those of its members that were given. */
typedef struct member {
    const char *option, *word, *name;
} member;

static int put_object(const char *name, int count, const member *members, cli_words *t)
{
    int any = 0, code = 0;
    for (int k = 0; k < count; k++) {
        any |= members[k].word != NULL;
    }
    if (!any) {
        return 0;
    }
    cli_put(t, ", \"%s\": { ", name);
    const size_t begin = t->length;
    for (int k = 0; code == 0 && k < count; k++) {
        if (members[k].option != NULL) {
            code = cli_put_number(members[k].option, members[k].word, members[k].name, t);
        } else {
            cli_put_named(members[k].word, members[k].name, t);
        }
    }
    if (!t->failed) { /* the first comma */
        memset(t->bytes + begin, ' ', t->length > begin ? 1 : 0);
    }
    cli_put(t, " }");
    return code;
}

/* The document that the words ask for. 0, or the exit code after one message. */
static int write_document(const cli_options *options, cli_words *t)
{
    const member cloth[] = {{"--width", options->lath_width, "width"},
                            {NULL, options->material, "material"}};
    const member allowance[] = {{"--allowance", options->allowance, "seam"},
                                {"--border", options->border, "border"}};
    const member marks[] = {{"--marks", options->marks, "spacing"}};
    const member compensation[] = {{"--warp", options->warp, "warp"},
                                   {"--weft", options->weft, "weft"}};

    cli_put(t, "{ \"taut\": 1, \"pattern\": \"cloth\", \"of\": ");
    cli_put_word(t, options->files[0]);
    cli_put(t, options->untrim ? ", \"untrim\": true" : "");
    cli_put_named(options->surface, "surface", t);
    int code = put_rules(options, t);
    cli_put_named(options->seam_length, "seam_length", t);
    for (int k = 0; k < options->hold_count; k++) {
        cli_put(t, k == 0 ? ", \"held\": [" : ", ");
        cli_put_word(t, options->holds[k]);
    }
    cli_put(t, options->hold_count > 0 ? "]" : "");
    code = code == 0 ? put_object("cloth", 2, cloth, t) : code;
    code = code == 0 ? put_object("compensation", 2, compensation, t) : code;
    code = code == 0 ? put_object("allowance", 2, allowance, t) : code;
    code = code == 0 ? put_object("marks", 1, marks, t) : code;
    const int is_searched =
        options->count == 0 && (options->across != NULL || options->radial != NULL);
    if (code == 0 && !is_searched && options->strain != NULL) {
        code = cli_put_number("--strain", options->strain, "strain", t);
    }
    cli_put(t, " }");
    return code == 0 && t->failed ? cli_no_memory() : code;
}

static int run(const cli_options *options)
{
    int code = cli_check_outputs(options);

    if (code != 0) {
        return code;
    }
    if (options->across != NULL || options->radial != NULL || options->geodesic_count > 0 ||
        options->seam_line_count > 0) {
        return cli_run_words(options, "pattern", write_document);
    }
    const cli_given words[] = {{options->count > 0, "--count"},
                               {options->by != NULL, "--by"},
                               {options->lath_width != NULL, "--width"},
                               {options->material != NULL, "--material"},
                               {options->warp != NULL, "--warp"},
                               {options->weft != NULL, "--weft"},
                               {options->allowance != NULL, "--allowance"},
                               {options->border != NULL, "--border"},
                               {options->marks != NULL, "--marks"},
                               {options->strain != NULL, "--strain"},
                               {options->hold_count > 0, "--hold"},
                               {options->seam_length != NULL, "--seam-length"},
                               {options->surface != NULL, "--surface"}};
    code = cli_refuse_given("pattern", "--across, --radial, --geodesic or --line",
                            sizeof words / sizeof *words, words);
    if (code != 0) {
        return code;
    }
    return cli_run_document(options, "pattern",
                            "`taut pattern` needs --across, --radial, --geodesic or --line with "
                            "the surface of a problem or a model");
}

static const cli_option options_of_pattern[] = {
    {"--across", CLI_TEXT, offsetof(cli_options, across), 0, 0, 0, "E,E",
     "strips from one edge to the opposite one: v0,v1 or u0,u1, or the other way"},
    {"--radial", CLI_TEXT, offsetof(cli_options, radial), 0, 0, 0, "E",
     "gores from a short edge to the opposite one"},
    {"--geodesic", CLI_LIST, offsetof(cli_options, geodesics),
     offsetof(cli_options, geodesic_count), 0, 0, "\"AT AT\"",
     "a seam between two places of the border, each u,v or E:PART; repeated"},
    {"--line", CLI_LIST, offsetof(cli_options, seam_lines), offsetof(cli_options, seam_line_count),
     0, 0, "u=U", "a seam along a parameter line, u=U or v=V; repeated"},
    {"--count", CLI_INTEGER, offsetof(cli_options, count), 0, 1, TAUT_PATTERN_PIECES_MAX, "N",
     "of strips; without it the least number that fits --width and --strain"},
    {"--by", CLI_TEXT, offsetof(cli_options, by), 0, 0, 0, "BY",
     "the edges are cut in equal parts of length (default) or parameter"},
    {"--width", CLI_TEXT, offsetof(cli_options, lath_width), 0, 0, 0, "W", "of the roll"},
    {"--material", CLI_TEXT, offsetof(cli_options, material), 0, 0, 0, "M",
     "default, etfe, ptfe-glass or pvc-pes"},
    {"--warp", CLI_TEXT, offsetof(cli_options, warp), 0, 0, 0, "C",
     "compensation: the share by which the warp is cut smaller"},
    {"--weft", CLI_TEXT, offsetof(cli_options, weft), 0, 0, 0, "C", "the same of the weft"},
    {"--allowance", CLI_TEXT, offsetof(cli_options, allowance), 0, 0, 0, "A",
     "cloth that is left beyond seams"},
    {"--border", CLI_TEXT, offsetof(cli_options, border), 0, 0, 0, "B",
     "cloth that is left beyond borders"},
    {"--marks", CLI_TEXT, offsetof(cli_options, marks), 0, 0, 0, "D",
     "marks across seams, so far apart on the surface"},
    {"--strain", CLI_TEXT, offsetof(cli_options, strain), 0, 0, 0, "E",
     "no more than this: claimed, and without --count as many strips as it takes"},
    {"--hold", CLI_LIST, offsetof(cli_options, holds), offsetof(cli_options, hold_count), 0, 0,
     "EDGE",
     "an edge at the length of the surface: u0 to v1, or right, end, left, start of pieces"},
    {"--seam-length", CLI_TEXT, offsetof(cli_options, seam_length), 0, 0, 0, "L",
     "shared (default): the mean of both sides; true: that of the surface"},
    CLI_SURFACE,
    CLI_UNTRIM,
    CLI_OUTPUT,
    {"--report", CLI_TEXT, offsetof(cli_options, report), 0, 0, 0, "FILE",
     "write the report as JSON"},
    {"--tolerance", CLI_NUMBER, offsetof(cli_options, tolerance), 0, 1e-14, 1, "T",
     "largest distance from the surface over its size (default 1e-6; 1e-3 for meshes); below that "
     "lengths of flat pieces too"},
    CLI_DIVIDE,
    CLI_THREADS,
    CLI_FIGURE_BUT_WIDTH,
    {"--json", CLI_FLAG, offsetof(cli_options, json), 0, 0, 0, NULL,
     "report and errors as JSON on standard error"},
    {"--quiet", CLI_FLAG, offsetof(cli_options, quiet), 0, 0, 0, NULL, "no report"},
    CLI_LAST};

const cli_command cli_command_pattern = {
    .name = "pattern",
    .usage = "MODEL.json|PROBLEM.json --across E,E|--radial E [--count N | --width W | --strain E] "
             "[--geodesic \"AT AT\"]... [--line u=U]... [-o FILE]... | PATTERN.json",
    .summary = "flat pieces of cloth for a surface, with seams that fit",
    .text = "Cuts a surface into strips along geodesics and lines, and lays each flat so that the "
            "cloth is strained least; the two sides of a seam are equally long at every point. "
            "The surface comes from any file that holds one, or from a problem, which is made "
            "first; or all of it from the document of a pattern, which `taut make` takes too.",
    .example = "taut pattern sail.json --across v0,v1 --count 4 -o cloth.json -o cloth.dxf\n",
    .files_min = 1,
    .files_max = 1,
    .options = options_of_pattern,
    .run = run,
};
