/* panels.c -- taut panels: plane quads on a minimal surface with planar curvature lines. */
#include "cli/cli.h"
#include "cli/report.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* What the command line asks for; 0, or the exit code after one message. */
static int chosen_options(const cli_options *options, taut_panels_options *chosen)
{
    double divide[2] = {0, 0};

    *chosen =
        (taut_panels_options){.surface = options->surface, .monitor = cli_monitor(options->json)};
    if (options->kind == NULL ||
        (strcmp(options->kind, "conical") != 0 && strcmp(options->kind, "circular") != 0)) {
        return cli_misuse(options->kind != NULL ? "value" : "option",
                          "`taut panels` needs --kind conical or --kind circular%s%.40s",
                          options->kind != NULL ? ", not " : "",
                          options->kind != NULL ? options->kind : "");
    }
    chosen->kind =
        strcmp(options->kind, "circular") == 0 ? TAUT_PANELS_CIRCULAR : TAUT_PANELS_CONICAL;
    if (options->panels == NULL) {
        return 0;
    }
    if (!cli_pair(options->panels, &divide[0], &divide[1])) {
        return cli_misuse_value("--divide", options->panels, "NU,NV");
    }
    for (int d = 0; d < 2; d++) {
        if (!(divide[d] >= 1) || !(divide[d] <= TAUT_COUNT_MAX / 2) ||
            floor(divide[d]) != divide[d]) {
            return cli_misuse_value("--divide", options->panels, "whole numbers from 1 to %d",
                                    TAUT_COUNT_MAX / 2);
        }
        chosen->divide[d] = (int)divide[d];
    }
    return 0;
}

static taut_status make(const cli_options *options, const taut_panels_options *chosen,
                        taut_model **panels, taut_error *error)
{
    taut_problem *problem = NULL;
    taut_model *model = NULL;
    taut_status status = cli_read_either(options->files[0], options, &problem, &model, error);

    if (status == TAUT_OK) {
        status = problem != NULL ? taut_panels_of_problem(problem, chosen, panels, error)
                                 : taut_panels_of_model(model, chosen, panels, error);
    }
    taut_model_free(model);
    taut_problem_free(problem);
    return status;
}

static int run(const cli_options *options)
{
    taut_panels_options chosen;
    taut_model *panels = NULL;
    taut_error error;
    cli_options all = *options;
    int code = chosen_options(options, &chosen);

    if (code == 0) {
        code = cli_check_outputs(options);
    }
    if (code != 0) {
        return code;
    }
    if (make(options, &chosen, &panels, &error) != TAUT_OK) {
        cli_monitor_done();
        return cli_fail_in(options->files[0], &error);
    }
    all.surface = NULL;
    all.divide = 1; /* each panel one quad */
    code = cli_write_model(panels, &all);
    if (code == 0 && !options->quiet && options->json) {
        code = cli_report_json(taut_record_copy(taut_model_details(panels)));
    } else if (code == 0 && !options->quiet) {
        fprintf(stderr, "panels\n");
        cli_members_print(taut_model_details(panels), taut_model_unit(panels));
    }
    taut_model_free(panels);
    return code;
}

static const cli_option options_of_panels[] = {
    {"--kind", CLI_TEXT, offsetof(cli_options, kind), 0, 0, 0, "KIND",
     "conical (tangent panels, exact offsets) or circular (panels with circumcircles)"},
    {"--divide", CLI_TEXT, offsetof(cli_options, panels), 0, 0, 0, "NU,NV",
     "panels along u and along v (default 8,8)"},
    CLI_OUTPUT,
    CLI_SURFACE,
    CLI_UNTRIM,
    {"--quiet", CLI_FLAG, offsetof(cli_options, quiet), 0, 0, 0, NULL, "print no residuals"},
    CLI_FIGURE,
    CLI_LAST};

const cli_command cli_command_panels = {
    .name = "panels",
    .usage = "PROBLEM.json|MODEL.json --kind conical|circular [--divide NU,NV] [-o FILE]...",
    .summary = "plane panels on a minimal surface with planar curvature lines",
    .text = "Makes the exact conical or circular mesh of a problem `bonnet`, or of any model whose "
            "surfaces `taut\nmeasure` recognises. In obj and ply each panel is one plane quad. "
            "Prints the largest residuals:\nplanarity (over the size of a panel), balance "
            "(conical: of the angles around a vertex) or circle\n(circular: of opposite angles), "
            "in radians, and distance from the surface.\n",
    .example = "taut panels roof.json --kind conical --divide 12,8 -o roof.obj -o panels.dxf\n",
    .files_min = 1,
    .files_max = 1,
    .options = options_of_panels,
    .run = run,
};
