/* trace.c -- taut trace: a net of curves on a surface, from a model or a problem and a few words. */
#include "cli/cli.h"
#include "cli/make.h"
#include "cli/words.h"

#include <math.h>
#include <string.h>

static const int cells_default = 8;

/* "EDGE:N" or "PLACE:N": the part before the last colon, and the number; 0 if there is none. */
static int split_count(const char *word, char *before, size_t size, double *count)
{
    const char *colon = strrchr(word, ':');
    if (colon == NULL || (size_t)(colon - word) >= size || !cli_number(colon + 1, count)) {
        return 0;
    }
    memcpy(before, word, (size_t)(colon - word));
    before[colon - word] = '\0';
    return 1;
}

/* What all seeds of the command line have besides. */
static void end_seed(const cli_options *options, cli_words *t)
{
    if (options->by != NULL) {
        cli_put(t, ", \"by\": ");
        cli_put_word(t, options->by);
    }
    cli_put(t, " }, ");
}

static int put_at(const cli_options *options, const char *word, cli_words *t)
{
    double u = 0, v = 0, du = 0, dv = 0;
    if (!cli_pair(word, &u, &v)) {
        return cli_misuse_value("--seed", word, "U,V");
    }
    cli_put(t, "{ \"at\": [%.17g, %.17g]", u, v);
    if (options->direction != NULL) {
        if (!cli_pair(options->direction, &du, &dv)) {
            return cli_misuse_value("--direction", options->direction, "DU,DV");
        }
        cli_put(t, ", \"direction\": [%.17g, %.17g]", du, dv);
    }
    if (options->to != NULL) {
        if (!cli_pair(options->to, &du, &dv)) {
            return cli_misuse_value("--to", options->to, "U,V");
        }
        cli_put(t, ", \"to\": [%.17g, %.17g]", du, dv);
    }
    if (options->both) {
        cli_put(t, ", \"both\": true");
    }
    cli_put(t, " }, ");
    return 0;
}

static int put_edge(const cli_options *options, const char *word, cli_words *t)
{
    char edge[16];
    double count = 0;
    if (!split_count(word, edge, sizeof edge, &count)) {
        return cli_misuse_value("--edge", word, "EDGE:N, such as v0:7");
    }
    cli_put(t, "{ \"edge\": ");
    cli_put_word(t, edge);
    cli_put(t, ", \"count\": %.17g", count);
    end_seed(options, t);
    return 0;
}

static int put_line(const cli_options *options, const char *word, cli_words *t)
{
    char places[128], *second = NULL;
    double count = 0, from[2], to[2];
    if (split_count(word, places, sizeof places, &count)) {
        second = strchr(places, ':');
    }
    if (second != NULL) {
        *second++ = '\0';
    }
    if (second == NULL || !cli_pair(places, &from[0], &from[1]) ||
        !cli_pair(second, &to[0], &to[1])) {
        return cli_misuse_value("--line", word, "U,V:U,V:N");
    }
    cli_put(t, "{ \"line\": [[%.17g, %.17g], [%.17g, %.17g]], \"count\": %.17g", from[0], from[1],
            to[0], to[1], count);
    end_seed(options, t);
    return 0;
}

static int put_cells(const cli_options *options, int any, cli_words *t)
{
    double cell = 0;
    if (options->cell != NULL && (!cli_number(options->cell, &cell) || !(cell > 0))) {
        return cli_misuse_value("--cell", options->cell, "a positive number");
    }
    if (options->cell != NULL) {
        cli_put(t, "{ \"cell\": %.17g", cell);
        end_seed(options, t);
    }
    if (options->cells > 0 || !any) {
        cli_put(t, "{ \"cells\": %d", options->cells > 0 ? options->cells : cells_default);
        end_seed(options, t);
    }
    return 0;
}

static int put_seeds(const cli_options *options, cli_words *t)
{
    int code = 0;
    const int any = options->at_count + options->seed_edge_count + options->seed_line_count +
                    (options->cell != NULL) + (options->cells > 0);
    if (any == 0 && options->by == NULL) {
        return 0;
    }
    cli_put(t, ", \"seeds\": [");
    for (int k = 0; code == 0 && k < options->at_count; k++) {
        code = put_at(options, options->at[k], t);
    }
    for (int k = 0; code == 0 && k < options->seed_edge_count; k++) {
        code = put_edge(options, options->seed_edges[k], t);
    }
    for (int k = 0; code == 0 && k < options->seed_line_count; k++) {
        code = put_line(options, options->seed_lines[k], t);
    }
    code = code == 0 ? put_cells(options, any, t) : code;
    t->length -= t->length > 1 ? 2 : 0; /* the last comma */
    cli_put(t, "]");
    return code;
}

static int put_laths(const cli_options *options, cli_words *t)
{
    const int any = options->thickness != NULL || options->material != NULL ||
                    options->cut != NULL || options->play != NULL;
    if (options->strip == NULL) {
        return any ? cli_misuse("option", "`taut trace`: laths need --strip") : 0;
    }
    cli_put(t, ", \"laths\": { \"strip\": ");
    cli_put_word(t, options->strip);
    int code = cli_put_number("--width", options->lath_width, "width", t);
    code = code == 0 ? cli_put_number("--thickness", options->thickness, "thickness", t) : code;
    cli_put_named(options->material, "material", t);
    cli_put_named(options->cut, "cut", t);
    code = code == 0 ? cli_put_number("--play", options->play, "play", t) : code;
    cli_put(t, " }");
    return code;
}

static int put_sheet(const cli_options *options, cli_words *t)
{
    const char *word = options->cut_sheet, *times = word != NULL ? strchr(word, 'x') : NULL;
    char along[64];
    double size[2] = {0, 0};
    if (word == NULL) {
        return 0;
    }
    const size_t length = times != NULL ? (size_t)(times - word) : sizeof along;
    if (length < sizeof along) {
        memcpy(along, word, length);
        along[length] = '\0';
    }
    if (length >= sizeof along || !cli_number(along, &size[0]) ||
        !cli_number(times + 1, &size[1])) {
        return cli_misuse_value("--sheet", word, "WxH, such as 2500x1250");
    }
    cli_put(t, ", \"sheet\": { \"size\": [%.17g, %.17g] }", size[0], size[1]);
    return 0;
}

/* The document that the words ask for. 0, or the exit code after one message. */
static int write_document(const cli_options *options, cli_words *t)
{
    double most = 0;

    cli_put(t, "{ \"taut\": 1, \"trace\": ");
    cli_put_word(t, options->net);
    cli_put(t, ", \"of\": ");
    cli_put_word(t, options->files[0]);
    cli_put(t, options->untrim ? ", \"untrim\": true" : "");
    if (options->surface != NULL) {
        cli_put(t, ", \"surface\": ");
        cli_put_word(t, options->surface);
    }
    cli_put(t, options->carry ? ", \"carry\": true" : "");
    for (int k = 0; k < options->family_count; k++) {
        cli_put(t, k == 0 ? ", \"families\": [" : ", ");
        cli_put_word(t, options->families[k]);
        cli_put(t, k == options->family_count - 1 ? "]" : "");
    }
    if (options->max_length != NULL) {
        if (!cli_number(options->max_length, &most) || !(most > 0)) {
            return cli_misuse_value("--max-length", options->max_length, "a positive number");
        }
        cli_put(t, ", \"max_length\": %.17g", most);
    }
    int code = put_seeds(options, t);
    code = code == 0 ? put_laths(options, t) : code;
    code = code == 0 ? put_sheet(options, t) : code;
    cli_put(t, options->judge_panels ? ", \"panels\": true }" : " }");
    return code == 0 && t->failed ? cli_no_memory() : code;
}

/* Where there are no laths, --width is that of pictures, as for other commands. */
static int take_width(cli_options *options)
{
    double pixels = 0;
    if (options->lath_width == NULL || options->strip != NULL) {
        return 0;
    }
    if (!cli_number(options->lath_width, &pixels) || pixels != floor(pixels) || pixels < 16 ||
        pixels > TAUT_WIDTH_MAX) {
        return cli_misuse_value("--width", options->lath_width,
                                "a whole number from 16 to %d, or --strip too", TAUT_WIDTH_MAX);
    }
    options->width = (int)pixels;
    return 0;
}

/* Words that say of a net what its document would, which has the last word on it. */
static int refuse_words(const cli_options *o)
{
    const cli_given words[] = {{o->family_count > 0, "--family"},
                               {o->at_count > 0, "--seed"},
                               {o->direction != NULL, "--direction"},
                               {o->to != NULL, "--to"},
                               {o->both, "--both"},
                               {o->seed_edge_count > 0, "--edge"},
                               {o->seed_line_count > 0, "--line"},
                               {o->cell != NULL, "--cell"},
                               {o->cells > 0, "--cells"},
                               {o->by != NULL, "--by"},
                               {o->max_length != NULL, "--max-length"},
                               {o->strip != NULL, "--strip"},
                               {o->thickness != NULL, "--thickness"},
                               {o->material != NULL, "--material"},
                               {o->cut != NULL, "--cut"},
                               {o->play != NULL, "--play"},
                               {o->judge_panels, "--panels"},
                               {o->carry, "--carry"},
                               {o->cut_sheet != NULL, "--sheet"},
                               {o->surface != NULL, "--surface"}};
    return cli_refuse_given("trace", "--net", sizeof words / sizeof *words, words);
}

static int run(const cli_options *said)
{
    cli_options own = *said;
    const cli_options *options = &own;
    int code = cli_check_outputs(options);

    code = code == 0 ? take_width(&own) : code;
    if (code != 0) {
        return code;
    }
    if (options->net != NULL) {
        return cli_run_words(options, "trace", write_document);
    }
    code = refuse_words(options);
    if (code != 0) {
        return code;
    }
    return cli_run_document(options, "trace",
                            "`taut trace` needs --net with the surface of a problem or a model");
}

static const cli_option options_of_trace[] = {
    {"--net", CLI_TEXT, offsetof(cli_options, net), 0, 0, 0, "NET",
     "asymptotic, principal, geodesic or isoparametric"},
    {"--family", CLI_LIST, offsetof(cli_options, families), offsetof(cli_options, family_count), 0,
     0, "F", "only this family: + or -, max or min, u or v"},
    {"--seed", CLI_LIST, offsetof(cli_options, at), offsetof(cli_options, at_count), 0, 0, "U,V",
     "a curve of each family through this place"},
    {"--direction", CLI_TEXT, offsetof(cli_options, direction), 0, 0, 0, "DU,DV",
     "of the geodesics from the seeds"},
    {"--to", CLI_TEXT, offsetof(cli_options, to), 0, 0, 0, "U,V",
     "the geodesics from the seeds end there"},
    {"--both", CLI_FLAG, offsetof(cli_options, both), 0, 0, 0, NULL,
     "geodesics go both ways from their seeds"},
    {"--edge", CLI_LIST, offsetof(cli_options, seed_edges), offsetof(cli_options, seed_edge_count),
     0, 0, "EDGE:N", "curves from N places of an edge: u0, u1, v0, v1"},
    {"--line", CLI_LIST, offsetof(cli_options, seed_lines), offsetof(cli_options, seed_line_count),
     0, 0, "U,V:U,V:N", "curves from N places of a straight line of the window"},
    {"--cell", CLI_TEXT, offsetof(cli_options, cell), 0, 0, 0, "C",
     "a net over the whole window, its cells so large in the middle"},
    {"--cells", CLI_INTEGER, offsetof(cli_options, cells), 0, 1, TAUT_TRACE_SEEDS_MAX, "N",
     "the same with N cells along the longer curve through the middle (default 8)"},
    {"--by", CLI_TEXT, offsetof(cli_options, by), 0, 0, 0, "BY",
     "equal parts are measured by conformal, length or parameter"},
    {"--max-length", CLI_TEXT, offsetof(cli_options, max_length), 0, 0, 0, "L",
     "of a curve, each way (default 20 sizes)"},
    {"--strip", CLI_TEXT, offsetof(cli_options, strip), 0, 0, 0, "S",
     "laths on the curves: standing, plank, developable or envelope"},
    {"--width", CLI_TEXT, offsetof(cli_options, lath_width), 0, 0, 0, "W",
     "of the laths of --strip; without it PNG: how wide (default 1200)"},
    {"--thickness", CLI_TEXT, offsetof(cli_options, thickness), 0, 0, 0, "T", "of the laths"},
    {"--material", CLI_TEXT, offsetof(cli_options, material), 0, 0, 0, "M",
     "of the laths: steel-s235 or timber-c24"},
    {"--cut", CLI_TEXT, offsetof(cli_options, cut), 0, 0, 0, "CUT",
     "laths are cut as long as the mean of their width (default), or as their axis"},
    {"--play", CLI_TEXT, offsetof(cli_options, play), 0, 0, 0, "P",
     "of the slots (default 0.2 mm, at most the thickness)"},
    {"--panels", CLI_FLAG, offsetof(cli_options, judge_panels), 0, 0, 0, NULL,
     "principal nets: how plane the quads between nodes are"},
    {"--carry", CLI_FLAG, offsetof(cli_options, carry), 0, 0, 0, NULL,
     "curves go on to the other surfaces of the model, across edges that join smoothly"},
    CLI_SOLID,
    CLI_UNTRIM,
    {"--sheet", CLI_TEXT, offsetof(cli_options, cut_sheet), 0, 0, 0, "WxH",
     "the sheets that the laths are cut from (default: one as large as they need)"},
    CLI_SURFACE,
    CLI_OUTPUT,
    {"--report", CLI_TEXT, offsetof(cli_options, report), 0, 0, 0, "FILE",
     "write the report as JSON"},
    CLI_TOLERANCE,
    CLI_DIVIDE,
    CLI_THREADS,
    CLI_FIGURE_BUT_WIDTH,
    {"--json", CLI_FLAG, offsetof(cli_options, json), 0, 0, 0, NULL,
     "report and errors as JSON on standard error"},
    {"--quiet", CLI_FLAG, offsetof(cli_options, quiet), 0, 0, 0, NULL, "no report"},
    CLI_LAST};

const cli_command cli_command_trace = {
    .name = "trace",
    .usage =
        "MODEL.json|PROBLEM.json --net NET [--seed U,V]... [--cells N] [-o FILE]... | TRACE.json",
    .summary = "a net of asymptotic, principal, geodesic or isoparametric curves",
    .text = "Traces curves on a surface, finds where they cross, and proves it. The surface comes "
            "from any file that holds one, or from a problem, which is made first; or all of it "
            "from the document of a net, which `taut make` takes too.",
    .example = "taut trace model.json --net asymptotic --cells 8 -o net.json -o net.svg\n",
    .files_min = 1,
    .files_max = 1,
    .options = options_of_trace,
    .run = run,
};
