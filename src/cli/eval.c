/* eval.c -- taut eval: one surface or curve at given parameters. */
#include "cli/cli.h"

#include <float.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

static const taut_surface *surface_named(const taut_model *model, const char *name)
{
    for (int i = 0; i < taut_model_surface_count(model); i++) {
        const taut_surface *surface = taut_model_surface(model, i);
        if (name == NULL || strcmp(name, taut_surface_name(surface)) == 0) {
            return surface;
        }
    }
    return NULL;
}

static const taut_curve *curve_named(const taut_model *model, const char *name)
{
    for (int i = 0; i < taut_model_curve_count(model); i++) {
        const taut_curve *curve = taut_model_curve(model, i);
        if (name == NULL || strcmp(name, taut_curve_name(curve)) == 0) {
            return curve;
        }
    }
    return NULL;
}

/* Brings a parameter that is one rounding error outside the range back to its end. */
static int clamp(const taut_basis *basis, double *t)
{
    const double lo = taut_basis_lo(basis), hi = taut_basis_hi(basis);
    const double slack = DBL_EPSILON * fmax(fabs(lo), fabs(hi));
    if (!(*t >= lo - slack && *t <= hi + slack)) {
        return 0;
    }
    *t = *t < lo ? lo : *t > hi ? hi : *t;
    return 1;
}

static int outside(const char *name, double t, const taut_basis *basis)
{
    const double lo = taut_basis_lo(basis), hi = taut_basis_hi(basis);
    taut_error error = {
        .status = TAUT_BAD_ARGUMENT, .reason = "range", .found = t, .limit = t < lo ? lo : hi};
    snprintf(error.message, sizeof error.message, "--at: %s is %.17g, expected %.17g to %.17g",
             name, t, lo, hi);
    return cli_fail(&error);
}

static void add_or_null(taut_record *record, const char *key, int regular, int count,
                        const double *values)
{
    if (!regular) {
        taut_record_add_null(record, key);
    } else if (count == 1) {
        taut_record_add_number(record, key, values[0]);
    } else {
        taut_record_add_numbers(record, key, count, values);
    }
}

static int eval_surface(const taut_surface *surface, const char *at, taut_record *list)
{
    static const char *const names[] = {"point", "du", "dv", "duu", "duv", "dvv"};
    taut_record *row = NULL;
    taut_forms forms;
    double values[6][3];
    double u = 0, v = 0;

    if (!cli_pair(at, &u, &v)) {
        return cli_misuse_value("--at", at, "two numbers U,V");
    }
    if (!clamp(taut_surface_u(surface), &u)) {
        return outside("u", u, taut_surface_u(surface));
    }
    if (!clamp(taut_surface_v(surface), &v)) {
        return outside("v", v, taut_surface_v(surface));
    }
    if (taut_surface_eval(surface, u, v, 2, &values[0][0]) != TAUT_OK) {
        return cli_misuse("range", "--at %.40s: it cannot be evaluated there", at);
    }
    taut_forms_of((const double(*)[3])values, &forms);
    row = taut_record_add_object(list, NULL);
    taut_record_add_number(row, "u", u);
    taut_record_add_number(row, "v", v);
    for (int i = 0; i < 6; i++) {
        taut_record_add_numbers(row, names[i], 3, values[i]);
    }
    add_or_null(row, "normal", forms.regular, 3, forms.normal);
    add_or_null(row, "mean_curvature", forms.regular, 1, &forms.mean);
    add_or_null(row, "gaussian_curvature", forms.regular, 1, &forms.gaussian);
    return 0;
}

/* kappa = |d1 x d2| / |d1|^3, tau = det(d1, d2, d3) / |d1 x d2|^2; NaN where undefined. */
static void curvature_torsion(double d[4][3], double *curvature, double *torsion)
{
    const double *a = d[1], *b = d[2];
    const double cross[3] = {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
                             a[0] * b[1] - a[1] * b[0]};
    const double speed = sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]);
    const double area2 = cross[0] * cross[0] + cross[1] * cross[1] + cross[2] * cross[2];
    *curvature = sqrt(area2) / (speed * speed * speed);
    *torsion = (cross[0] * d[3][0] + cross[1] * d[3][1] + cross[2] * d[3][2]) / area2;
}

static int eval_curve(const taut_curve *curve, const char *at, taut_record *list)
{
    static const char *const names[] = {"point", "d1", "d2", "d3"};
    taut_record *row = NULL;
    double values[4][3];
    double t = 0, curvature = 0, torsion = 0;

    if (!cli_number(at, &t)) {
        return cli_misuse_value("--at", at, "one number T");
    }
    if (!clamp(taut_curve_t(curve), &t)) {
        return outside("t", t, taut_curve_t(curve));
    }
    if (taut_curve_eval(curve, t, 3, &values[0][0]) != TAUT_OK) {
        return cli_misuse("range", "--at %.40s: it cannot be evaluated there", at);
    }
    curvature_torsion(values, &curvature, &torsion);
    row = taut_record_add_object(list, NULL);
    taut_record_add_number(row, "t", t);
    for (int i = 0; i < 4; i++) {
        taut_record_add_numbers(row, names[i], 3, values[i]);
    }
    taut_record_add_number(row, "curvature", curvature);
    taut_record_add_number(row, "torsion", torsion);
    return 0;
}

/* Lines of a surface or a curve, lengths and curvatures with their unit; parameters have none. */
static void print_rows(const taut_record *list, const char *unit)
{
    char room[CLI_UNIT_ROOM];
    for (size_t i = 0; i < taut_record_count(list); i++) {
        const taut_record *row = taut_record_at(list, i);
        for (size_t k = 0; k < taut_record_count(row); k++) {
            const taut_record *value = taut_record_at(row, k);
            printf("%-20s", taut_record_key(row, k));
            for (size_t c = 0; c < taut_record_count(value); c++) {
                printf(" %22.15g", taut_record_number(taut_record_at(value, c)));
            }
            if (taut_record_kind_of(value) == TAUT_RECORD_NUMBER) {
                printf(" %22.15g", taut_record_number(value));
            }
            printf("%s\n", taut_record_kind_of(value) == TAUT_RECORD_NULL
                               ? " -"
                               : cli_unit_of(taut_record_key(row, k), unit, room));
        }
    }
}

static int eval_model(const taut_model *model, const cli_options *options)
{
    const taut_surface *surface =
        options->curve == NULL ? surface_named(model, options->surface) : NULL;
    const taut_curve *curve =
        surface == NULL && options->surface == NULL ? curve_named(model, options->curve) : NULL;
    taut_record *list = NULL;
    int code = 0;

    if (surface == NULL && curve == NULL) {
        return cli_misuse("name", "the model has no %s %.80s",
                          options->curve != NULL ? "curve" : "surface",
                          options->curve != NULL     ? options->curve
                          : options->surface != NULL ? options->surface
                                                     : "or curve at all");
    }
    list = taut_record_new_list();
    for (int i = 0; i < options->at_count && code == 0; i++) {
        code = surface != NULL ? eval_surface(surface, options->at[i], list)
                               : eval_curve(curve, options->at[i], list);
    }
    if (code == 0 && options->json) {
        return cli_print_record(list);
    }
    if (code == 0) {
        print_rows(list, taut_model_unit(model));
        code = cli_print_text("", 0);
    }
    taut_record_free(list);
    return code;
}

static int run(const cli_options *options)
{
    taut_model *model = NULL;
    taut_error error;
    int code = 0;

    if (options->at_count == 0) {
        return cli_misuse("option",
                          "`taut eval` needs at least one --at U,V (or --at T for a curve)");
    }
    if (options->surface != NULL && options->curve != NULL) {
        return cli_misuse("option", "give either --surface or --curve");
    }
    if (cli_read_model(options->files[0], options, &model, &error) != TAUT_OK) {
        return cli_fail_in(options->files[0], &error);
    }
    code = eval_model(model, options);
    taut_model_free(model);
    return code;
}

static const cli_option options_of_eval[] = {
    {"--at", CLI_LIST, offsetof(cli_options, at), offsetof(cli_options, at_count), 0, 0, "U,V",
     "where: U,V on a surface, T on a curve; may be repeated"},
    CLI_JSON,
    CLI_SURFACE,
    {"--curve", CLI_TEXT, offsetof(cli_options, curve), 0, 0, 0, "NAME", "the curve of this name"},
    CLI_UNTRIM,
    CLI_THREADS,
    CLI_LAST};

const cli_command cli_command_eval = {
    .name = "eval",
    .usage = "MODEL.json [--surface NAME | --curve NAME] --at U,V [--at U,V]... [--json]",
    .summary = "points, derivatives, normal and curvature at given parameters",
    .text = "Without a name the first surface is taken, or the first curve where there is none.\n"
            "At a knot derivatives are those from the right.\n",
    .example = "taut eval model.json --at 0.5,0.5 --at 0,1\n",
    .files_min = 1,
    .files_max = 1,
    .options = options_of_eval,
    .run = run,
};
