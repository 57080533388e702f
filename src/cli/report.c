#include "cli/report.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { COLUMN = 22, OBJECTS = 8, ROWS = 6 };

/* "dirichlet_energy" as "dirichlet energy". */
static const char *words(const char *key, char *buffer, size_t size)
{
    snprintf(buffer, size, "%s", key);
    for (char *p = buffer; *p != '\0'; p++) {
        if (*p == '_') {
            *p = ' ';
        }
    }
    return buffer;
}

/* "350 ms", "0.095 ms", "1.29 s": two digits that count, never a power of ten. */
static void print_duration(const char *what, double seconds, const char *end)
{
    const double ms = 1e3 * seconds;
    if (ms >= 995) {
        fprintf(stderr, "%s %.2f s%s", what, seconds, end);
    } else if (ms >= 99.5) {
        fprintf(stderr, "%s %.0f ms%s", what, 10 * round(ms / 10), end);
    } else {
        fprintf(stderr, "%s %.*f ms%s", what,
                ms >= 9.95     ? 0
                : ms >= 0.995  ? 1
                : ms >= 0.0995 ? 2
                               : 3,
                ms, end);
    }
}

/* Integrals are good to 1e-10 relative: one digit more, so that rounding adds nothing to that. */
enum { DIGITS = 11 };

static int ends_in(const char *key, const char *end)
{
    const size_t length = strlen(key), tail = strlen(end);
    return length >= tail && strcmp(key + length - tail, end) == 0;
}

/* Three digits of what is an error, a difference or a share; four of what is sought on a grid or integrated across kinks, or
 * is the net's and not the continuous film's; forces on supports come to five (film-sail of 12 x 12 points beside 30 x 30). */
static const struct {
    const char *end;
    int digits;
} few_digits[] = {
    {"lower_bound", DIGITS},  {"_bound", 3},         {"_error", 3},    {"gap", 3},
    {"balance", 3},           {"residual", 3},       {"drift", 3},     {"deviation", 3},
    {"seam_angle", 3},        {"slide_angle", 3},    {"planarity", 3}, {"amplification", 3},
    {"cable_normal", 3},      {"cable_geodesic", 3}, {"waste", 3},     {"mean_curvature", 4},
    {"lowest_eigenvalue", 4}, {"_strain", 4},        {"sags", 4},      {"reactions", 5}};

/* How many digits of a figure are vouched for: those of its kind, or those above the error that stands beside it. */
static int digits_of(const taut_record *record, const char *key)
{
    char name[80];
    snprintf(name, sizeof name, "%s_error", key);
    const taut_record *error = taut_record_get(record, name);
    const double size = fabs(taut_record_number(taut_record_get(record, key)));
    for (size_t i = 0; i < sizeof few_digits / sizeof few_digits[0]; i++) {
        if (ends_in(key, few_digits[i].end)) {
            return few_digits[i].digits;
        }
    }
    if (error != NULL && taut_record_number(error) > 0 && size > 0) {
        int digits = 0;
        for (double rest = taut_record_number(error); digits < DIGITS && 10 * rest <= size;
             rest *= 10) {
            digits++;
        }
        return digits < 1 ? 1 : digits;
    }
    return DIGITS;
}

/* Few members, none of which has members: short enough for a line. */
static int is_short(const taut_record *object)
{
    const size_t count = taut_record_count(object);
    for (size_t i = 0; i < count; i++) {
        const taut_record_kind kind = taut_record_kind_of(taut_record_at(object, i));
        if (kind == TAUT_RECORD_LIST || kind == TAUT_RECORD_OBJECT) {
            return 0;
        }
    }
    return count <= 3;
}

/* Rows of points, or objects that are long themselves, which no line holds. */
static int is_table(const taut_record *list)
{
    const taut_record *row = taut_record_at(list, 0);
    return (taut_record_kind_of(row) == TAUT_RECORD_OBJECT && !is_short(row)) ||
           (taut_record_kind_of(row) == TAUT_RECORD_LIST &&
            taut_record_kind_of(taut_record_at(row, 0)) == TAUT_RECORD_LIST);
}

/* `unit`: of lengths in it, or NULL. */
static void print_value(const taut_record *value, int digits, const char *unit)
{
    char name[64], room[CLI_UNIT_ROOM];
    switch (taut_record_kind_of(value)) {
    case TAUT_RECORD_NUMBER:
        fprintf(stderr, "%.*g", digits, taut_record_number(value));
        break;
    case TAUT_RECORD_TEXT:
        fprintf(stderr, "%s", taut_record_text(value));
        break;
    case TAUT_RECORD_BOOL:
        fprintf(stderr, "%s", taut_record_bool(value) ? "yes" : "no");
        break;
    case TAUT_RECORD_LIST:
        if (is_table(value)) {
            fprintf(stderr, "(%zu row%s: see --report)", taut_record_count(value),
                    taut_record_count(value) == 1 ? "" : "s");
            break;
        }
        for (size_t i = 0; i < taut_record_count(value) && i < 6; i++) {
            fprintf(stderr, "%s", i > 0 ? ", " : "");
            print_value(taut_record_at(value, i), digits, unit);
        }
        fprintf(stderr, "%s", taut_record_count(value) > 6 ? ", ..." : "");
        break;
    case TAUT_RECORD_OBJECT:
        for (size_t i = 0; is_short(value) && i < taut_record_count(value); i++) {
            fprintf(stderr, "%s%s ", i > 0 ? " " : "",
                    words(taut_record_key(value, i), name, sizeof name));
            print_value(taut_record_at(value, i), digits, unit);
            if (unit != NULL &&
                taut_record_kind_of(taut_record_at(value, i)) == TAUT_RECORD_NUMBER) {
                fprintf(stderr, "%s", cli_unit_of(taut_record_key(value, i), unit, room));
            }
        }
        if (!is_short(value)) {
            fprintf(stderr, "(%zu members: see --report)", taut_record_count(value));
        }
        break;
    case TAUT_RECORD_NULL:
    default:
        fprintf(stderr, "-");
        break;
    }
}

/* Rows of numbers, or short objects: a line each. */
static int is_rows(const taut_record *value)
{
    const taut_record_kind kind = taut_record_kind_of(taut_record_at(value, 0));
    return taut_record_kind_of(value) == TAUT_RECORD_LIST && taut_record_count(value) > 1 &&
           !is_table(value) && (kind == TAUT_RECORD_LIST || kind == TAUT_RECORD_OBJECT);
}

/* The first is beside the key already; `names`: what each row is of, or NULL. */
static void print_rows(const taut_record *value, const taut_record *names, int digits,
                       const char *unit)
{
    for (size_t i = 0; i < taut_record_count(value) && i < ROWS; i++) {
        const char *name = taut_record_text(taut_record_at(names, i));
        if (i > 0) {
            fprintf(stderr, "\n  %-*s ", COLUMN - 1, "");
        }
        if (name != NULL && name[0] != '\0') {
            fprintf(stderr, "%s: ", name);
        }
        print_value(taut_record_at(value, i), digits, unit);
    }
    if (taut_record_count(value) > ROWS) {
        fprintf(stderr, "\n  %-*s ... and %zu more", COLUMN - 1, "",
                taut_record_count(value) - ROWS);
    }
}

/* Films and cloth, whose certificates have an `energy`, call numbers without a unit of length by words that have one
 * elsewhere: what bounds an energy, a force times a length; curvature times size; the integral of K. */
static int lacks_unit(const taut_record *figures, const char *key)
{
    static const char *const words[] = {"gap", "lower_bound", "mean_curvature", "curvature"};
    for (size_t i = 0; i < sizeof words / sizeof words[0]; i++) {
        if (strcmp(key, words[i]) == 0) {
            return taut_record_get(figures, "energy") != NULL;
        }
    }
    return 0;
}

/* What the report calls a member. A word that is a claim too names only that: `cables` says that the cables are the
 * problem's; what they carry is a table. A `seam_length` is a rule of the document and a figure. */
static const char *label_of(const taut_record *record, const char *key, char *buffer, size_t size)
{
    const int is_rule = strcmp(key, "seam_length") == 0 &&
                        taut_record_kind_of(taut_record_get(record, key)) == TAUT_RECORD_TEXT;
    return is_rule                         ? "seam rule"
           : strcmp(key, "cables") == 0    ? "each cable"
           : strcmp(key, "known") == 0     ? "known points"
           : strcmp(key, "reactions") == 0 ? "forces on supports"
                                           : words(key, buffer, size);
}

/* `supports`: the corners that rows of reactions are of, or NULL. */
static void print_members(const taut_record *record, const taut_record *supports, const char *unit)
{
    char room[CLI_UNIT_ROOM];
    char name[64];
    for (size_t i = 0; i < taut_record_count(record); i++) {
        const taut_record *value = taut_record_at(record, i);
        const taut_record_kind kind = taut_record_kind_of(value);
        if (kind == TAUT_RECORD_OBJECT ||
            (kind == TAUT_RECORD_LIST && taut_record_count(value) == 0)) {
            continue;
        }
        const char *key = taut_record_key(record, i);
        const int width =
            fprintf(stderr, "  %-*s ", COLUMN - 1, label_of(record, key, name, sizeof name));
        fprintf(stderr, "%s", width > COLUMN + 2 ? " " : ""); /* long names have two as well */
        const int digits = digits_of(record, key);
        const taut_record *names = strcmp(key, "reactions") == 0 ? supports : NULL;
        if (is_rows(value) || names != NULL) {
            print_rows(value, names, digits, unit);
        } else {
            print_value(value, digits, unit);
        }
        const int has_unit = unit != NULL && kind != TAUT_RECORD_TEXT && !lacks_unit(record, key);
        fprintf(stderr, "%s\n", has_unit ? cli_unit_of(key, unit, room) : "");
    }
}

void cli_members_print(const taut_record *record, const char *unit)
{
    print_members(record, NULL, unit);
}

void cli_certificate_print(const taut_certificate *certificate, const taut_model *model)
{
    for (int i = 0; i < taut_certificate_claim_count(certificate); i++) {
        const taut_claim *claim = taut_certificate_claim(certificate, i);
        const char *verdict = claim->holds == TAUT_TRUE    ? "holds"
                              : claim->holds == TAUT_FALSE ? "DOES NOT HOLD"
                                                           : "undecided";
        char residual[32] = "-"; /* where nothing was found */
        if (isfinite(claim->residual)) {
            snprintf(residual, sizeof residual, "%.3g", claim->residual);
        }
        /* some hold above their limit: `stable`, `regular`, `graph`, `positive-weights` */
        const int is_least = (claim->holds == TAUT_TRUE && claim->residual > claim->limit) ||
                             (claim->holds == TAUT_FALSE && claim->residual < claim->limit);
        fprintf(stderr, "  %-*s%s (%s): %s, %s %.3g%s%s\n", COLUMN, claim->claim, verdict,
                taut_claim_kind_name(claim->kind), residual, is_least ? "at least" : "limit",
                claim->limit,
                claim->where[0] == '\0'          ? ""
                : claim->holds == TAUT_UNDECIDED ? ": "
                                                 : ", at ",
                claim->where);
    }
    print_members(taut_certificate_figures(certificate),
                  taut_record_get(taut_model_details(model), "supports"), taut_model_unit(model));
}

static void print_names(const taut_certificate *certificate, taut_verdict verdict)
{
    const char *before = ": ";
    for (int i = 0; i < taut_certificate_claim_count(certificate); i++) {
        const taut_claim *claim = taut_certificate_claim(certificate, i);
        if (claim->holds == verdict) {
            fprintf(stderr, "%s%s", before, claim->claim);
            before = ", ";
        }
    }
}

static int count_claims(const taut_certificate *certificate, taut_verdict verdict)
{
    int count = 0;
    for (int i = 0; i < taut_certificate_claim_count(certificate); i++) {
        count += taut_certificate_claim(certificate, i)->holds == verdict;
    }
    return count;
}

void cli_verdict_print(const taut_certificate *certificate)
{
    const taut_verdict whole = taut_certificate_holds(certificate);
    const int of = taut_certificate_claim_count(certificate);
    const int wrong = count_claims(certificate, TAUT_FALSE),
              open = count_claims(certificate, TAUT_UNDECIDED);

    fprintf(stderr, "  %-*s%s: ", COLUMN, "certificate",
            whole == TAUT_TRUE    ? "holds"
            : whole == TAUT_FALSE ? "DOES NOT HOLD"
                                  : "undecided");
    if (wrong + open == 0) {
        fprintf(stderr, "all %d claims", of);
    } else {
        fprintf(stderr, "%d of %d claims", of - wrong - open, of);
    }
    if (wrong > 0) {
        fprintf(stderr, "; false");
        print_names(certificate, TAUT_FALSE);
    }
    if (open > 0) {
        fprintf(stderr, "; undecided");
        print_names(certificate, TAUT_UNDECIDED);
    }
    fprintf(stderr, "\n");
}

/* Of films: what is 0 for the continuous one is below 0.2 in every example, and where a cable is off by all that it bends, or the
 * curvature by ten over the size, the places are too few for it. Of threads, which have no `cable_normal`, nothing is known. */
void cli_warn_of_curvature(const char *file, const taut_certificate *certificate)
{
    static const double most[2] = {10, 1};
    const taut_record *figures = taut_certificate_figures(certificate);
    const double mean = taut_record_number(taut_record_get(figures, "mean_curvature")),
                 cable = taut_record_get(figures, "cable_normal") != NULL
                             ? taut_record_number(taut_record_get(figures, "cable_geodesic"))
                             : 0;
    char text[400];

    if (mean > most[0] || cable > most[1]) {
        const int is_mean = mean > most[0];
        snprintf(
            text, sizeof text,
            "the film's curvatures are not resolved everywhere, as at a nearly straight corner: "
            "%s is %.3g where the continuous film has 0; area, energy, lengths and forces are as "
            "certified; for curvatures use several patches, or move the corners",
            is_mean ? "mean_curvature" : "cable_geodesic", is_mean ? mean : cable);
        cli_warn(file, text);
    }
}

static void print_rest(int count)
{
    if (count > OBJECTS) {
        fprintf(stderr, "  %-*s... and %d more\n", COLUMN, "", count - OBJECTS);
    }
}

static void print_objects(const taut_model *model)
{
    for (int i = 0; i < taut_model_surface_count(model) && i < OBJECTS; i++) {
        const taut_surface *surface = taut_model_surface(model, i);
        const taut_basis *u = taut_surface_u(surface), *v = taut_surface_v(surface);
        fprintf(stderr, "  %-*s%s: %d x %d points, %s x %s%s\n", COLUMN, i == 0 ? "surface" : "",
                taut_surface_name(surface), taut_basis_count(u), taut_basis_count(v),
                taut_basis_type(u), taut_basis_type(v),
                taut_surface_weights(surface) != NULL ? ", rational" : "");
    }
    print_rest(taut_model_surface_count(model));
    for (int i = 0; i < taut_model_curve_count(model) && i < OBJECTS; i++) {
        const taut_curve *curve = taut_model_curve(model, i);
        fprintf(stderr, "  %-*s%s: %d points, %s\n", COLUMN, i == 0 ? "curve" : "",
                taut_curve_name(curve), taut_basis_count(taut_curve_t(curve)),
                taut_basis_type(taut_curve_t(curve)));
    }
    print_rest(taut_model_curve_count(model));
}

void cli_report_print(const cli_report *report)
{
    fprintf(stderr, "%s\n", report->construct);
    print_objects(report->model);
    cli_members_print(taut_model_details(report->model), taut_model_unit(report->model));
    cli_certificate_print(report->certificate, report->model);
    cli_verdict_print(report->certificate);
    if (report->seconds_proved > 0.1 && report->seconds_proved > 10 * report->seconds_made) {
        fprintf(stderr, "  %-*s%s\n", COLUMN, "", "the proof took over ten times the making");
    }
    fprintf(stderr, "  %-*s", COLUMN, "time");
    print_duration("made", report->seconds_made, ", ");
    print_duration("proved", report->seconds_proved, ", ");
    print_duration("written", report->seconds_written, "\n");
    for (int i = 0; i < report->output_count; i++) {
        char distance[CLI_DISTANCE_ROOM];
        fprintf(stderr, "  %-*s%s%s\n", COLUMN, i == 0 ? "written" : "", report->outputs[i],
                cli_distance(report->bounds[i], report->model, distance));
    }
}

static void add_verdict(taut_record *record, taut_verdict verdict)
{
    if (verdict == TAUT_UNDECIDED) {
        taut_record_add_null(record, "holds");
    } else {
        taut_record_add_bool(record, "holds", verdict == TAUT_TRUE);
    }
}

void cli_certificate_record(taut_record *record, const char *key,
                            const taut_certificate *certificate)
{
    taut_record *object = key != NULL ? taut_record_add_object(record, key) : record;
    taut_record *claims = NULL;
    taut_record_add_text(object, "construct", taut_certificate_construct(certificate));
    add_verdict(object, taut_certificate_holds(certificate));
    claims = taut_record_add_list(object, "claims");
    for (int i = 0; i < taut_certificate_claim_count(certificate); i++) {
        const taut_claim *claim = taut_certificate_claim(certificate, i);
        taut_record *row = taut_record_add_object(claims, NULL);
        taut_record_add_text(row, "claim", claim->claim);
        taut_record_add_text(row, "kind", taut_claim_kind_name(claim->kind));
        taut_record_add_number(row, "residual", claim->residual);
        taut_record_add_number(row, "limit", claim->limit);
        add_verdict(row, claim->holds);
        taut_record_add_text(row, "where", claim->where);
    }
    taut_record_add_record(object, "figures", taut_certificate_figures(certificate));
}

taut_record *cli_report_record(const cli_report *report)
{
    taut_record *record = taut_record_new();
    taut_record *list = NULL;
    taut_record_add_number(record, "taut", 1);
    taut_record_add_text(record, "construct", report->construct);
    if (taut_model_details(report->model) != NULL) {
        taut_record_add_record(record, "details", taut_model_details(report->model));
    }
    cli_certificate_record(record, "certificate", report->certificate);
    list = taut_record_add_object(record, "seconds");
    taut_record_add_number(list, "made", report->seconds_made);
    taut_record_add_number(list, "proved", report->seconds_proved);
    taut_record_add_number(list, "written", report->seconds_written);
    list = taut_record_add_list(record, "outputs");
    for (int i = 0; i < report->output_count; i++) {
        taut_record_add_text(list, NULL, report->outputs[i]);
    }
    list = taut_record_add_list(record, "distances");
    for (int i = 0; i < report->output_count; i++) {
        taut_record_add_number(list, NULL, report->bounds[i]);
    }
    return record;
}
