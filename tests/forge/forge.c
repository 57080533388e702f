/* forge.c -- forgeries of made models by the thousand, each judged by the certificate and, where it
 * holds, by the oracle (tests/support/oracle).
 *
 *     forge [--seed S] [--count N] [--construct C] [--threads T] [--mode forge|made] [--only I]
 *           [--bases LIST] [--folder F] [--table]
 *
 * Forgery i of a seed is the same whatever else is run: a base, one way to forge it or two, the
 * numbers. Each is certified with its problem and alone. `made` makes random legal problems instead
 * and compares claims and figures. A false `holds` is told with its number and its documents are
 * written to the folder; the program then ends with 1. With --only those of that one are written,
 * whatever is found.
 */
#include "edit.h"

#include "cli/embedded_files.h"
#include "oracle/oracle.h"
#include "taut/read.h"
#include "taut/write.h"

#include <math.h>
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

enum { BASES_MAX = 80, KINDS_MAX = 40, CONSTRUCTS_MAX = 12 };

/* Small ones, so that a forgery costs little. Of several constructions those that differ in kind. */
static const char *const usual[] = {"dirichlet-biquadratic",
                                    "dirichlet-bicubic",
                                    "dirichlet-biquadratic-spline",
                                    "dirichlet-aspect",
                                    "dirichlet-tent",
                                    "plateau-biquadratic",
                                    "plateau-bicubic",
                                    "plateau-enneper",
                                    "harmonic-rows",
                                    "harmonic-derivative",
                                    "harmonic-even",
                                    "harmonic-fit",
                                    "harmonic-extension",
                                    "harmonic-neighbour",
                                    "biharmonic-rows",
                                    "biharmonic-c1",
                                    "biharmonic-c2",
                                    "bonnet-roof",
                                    "bonnet-enneper",
                                    "bonnet-helicoid",
                                    "bonnet-figure-1b",
                                    "asymptotic-low",
                                    "asymptotic-ruled",
                                    "asymptotic-inflection",
                                    "pipe-paper",
                                    "pipe-ones",
                                    "pipe-flat-start",
                                    "pipe-cubic",
                                    "pipe-canal",
                                    "pipe-elliptic",
                                    "pipe-run-coil",
                                    "pipe-run",
                                    "pipe-g2"};

enum { VERDICT_TRUE, VERDICT_FALSE, VERDICT_NULL, VERDICT_REFUSED, VERDICTS };

typedef struct forge_tally {
    long verdict[CONSTRUCTS_MAX][KINDS_MAX][2][VERDICTS];
    long judged, unjudged, impossible, lies, figures, figures_off;
    int done;
    double slowest;
    int slowest_number;
} forge_tally;

typedef struct forge_run {
    uint64_t seed;
    int first, count, step, made;
    const forge_base *bases;
    const double *area; /* of the first surface of each */
    int base_count;
    const char *folder;
    time_t until;
    forge_tally *tally;
} forge_run;

static double seconds(void)
{
    struct timespec now;

    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

static int construct_index(const char *name)
{
    for (int i = 0; i < taut_construct_count(); i++) {
        if (strcmp(taut_construct_name(i), name) == 0) {
            return i;
        }
    }
    return 0;
}

/* The documents of a forgery, in the folder. */
static void keep_documents(const forge_run *run, int number, const taut_model *model,
                           const char *text)
{
    char path[300];

    snprintf(path, sizeof path, "%s/%llu-%d.model.json", run->folder, (unsigned long long)run->seed,
             number);
    taut_model_write(model, path, NULL, NULL);
    snprintf(path, sizeof path, "%s/%llu-%d.problem.json", run->folder,
             (unsigned long long)run->seed, number);
    FILE *file = fopen(path, "w");
    if (file != NULL) {
        fputs(text, file);
        fclose(file);
    }
}

static void keep_lie(const forge_run *run, int number, const char *base, const char *kind,
                     int alone, const oracle_finding *finding, const taut_model *model,
                     const char *text)
{
    forge_tally *tally = run->tally;

    tally->lies++;
    printf("FALSE HOLDS %d: %s, %s, %s: %s: %s (%.6g, limit %.6g)\n", number, base, kind,
           alone ? "alone" : "with the problem", finding->claim, finding->why, finding->found,
           finding->limit);
    fflush(stdout);
    if (run->folder != NULL) {
        keep_documents(run, number, model, text);
    }
}

/* Certifies once and judges what holds. */
static void try_model(const forge_run *run, int number, const forge_base *base,
                      const taut_model *model, int kind, const char *kinds, int alone)
{
    forge_tally *tally = run->tally;
    taut_certificate *certificate = NULL;
    const char *construct =
        alone ? taut_certificate_construct(taut_model_certificate(model)) : base->construct;
    const double begin = seconds();
    const taut_status status =
        taut_certify(model, alone ? NULL : base->problem, NULL, &certificate, NULL);
    const double took = seconds() - begin;
    int verdict = VERDICT_REFUSED;

    if (took > tally->slowest) {
        tally->slowest = took;
        tally->slowest_number = number;
    }
    if (status == TAUT_OK) {
        const taut_verdict holds = taut_certificate_holds(certificate);
        const oracle_case about = {construct,
                                   model,
                                   alone ? NULL : base->document,
                                   alone ? NULL : base->model,
                                   run->area[base - run->bases],
                                   0};
        oracle_finding finding;
        verdict = holds == TAUT_TRUE    ? VERDICT_TRUE
                  : holds == TAUT_FALSE ? VERDICT_FALSE
                                        : VERDICT_NULL;
        if (oracle_judge(&about, certificate, &finding)) {
            keep_lie(run, number, base->name, kinds, alone, &finding, model, base->text);
        }
        tally->judged += finding.judged;
        tally->unjudged += finding.unjudged;
    }
    tally->verdict[construct_index(base->construct)][kind][alone][verdict]++;
    taut_certificate_free(certificate);
}

static void forge_one(const forge_run *run, int number, forge_pool *pool, edit_model *edit)
{
    forge_random random = {run->seed * 0x2545f4914f6cdd1du +
                           (uint64_t)number * 0x9e3779b97f4a7c15u};
    char kinds[80];

    pool->used = 0;
    forge_bits(&random);
    const forge_base *base = &run->bases[forge_int(&random, 0, run->base_count - 1)];
    const forge_base *other = base;
    for (int i = 0, from = forge_int(&random, 0, run->base_count - 1); i < run->base_count; i++) {
        const forge_base *next = &run->bases[(from + i) % run->base_count];
        if (next != base && strcmp(next->construct, base->construct) == 0) {
            other = next;
            break;
        }
    }
    const int kind = forge_int(&random, 0, forge_kind_count - 1);
    const int second =
        forge_int(&random, 0, 2) == 0 ? forge_int(&random, 1, forge_kind_count - 1) : 0;
    edit_open(base->model, base->construct, pool, edit);
    forge_kinds[kind].apply(edit, base, other, &random);
    forge_kinds[second].apply(edit, base, other, &random);
    snprintf(kinds, sizeof kinds, "%s%s%s", forge_kinds[kind].name, second ? " + " : "",
             second ? forge_kinds[second].name : "");
    taut_model *model = edit_close(edit);
    if (model == NULL) {
        run->tally->impossible++;
        return;
    }
    if (run->count == run->first + 1 && run->folder != NULL) {
        printf("%d: %s, %s\n", number, base->name, kinds);
        keep_documents(run, number, model, base->text);
    }
    for (int alone = 0; alone < 2; alone++) {
        try_model(run, number, base, model, kind, kinds, alone);
    }
    taut_model_free(model);
}

static double figure(const taut_certificate *certificate, const char *name)
{
    return taut_record_number(taut_record_get(taut_certificate_figures(certificate), name));
}

/* A figure against the own integral, to 1e-10 or to the error that is told. */
static void compare_figure(const forge_run *run, int number, const forge_base *base,
                           const taut_certificate *certificate, const taut_model *model,
                           const char *name, oracle_real own, oracle_real own_error,
                           const char *text)
{
    char error_name[60];
    const double told = figure(certificate, name);

    snprintf(error_name, sizeof error_name, "%s_error", name);
    const double error = figure(certificate, error_name);
    if (isnan(told) || !(own_error <= 1e-11L * fabsl(own))) {
        return;
    }
    run->tally->figures++;
    if (fabsl(told - own) > 1.01e-10L * fabsl(own) + 2 * own_error + (error > 0 ? error : 0)) {
        const oracle_finding finding = {.claim = name,
                                        .found = told,
                                        .limit = (double)own,
                                        .why = "the figure is not the own integral"};
        run->tally->figures_off++;
        keep_lie(run, number, base->name, "made", 0, &finding, model, text);
    }
}

static void compare_figures(const forge_run *run, int number, const forge_base *base,
                            const taut_certificate *certificate, const taut_model *model,
                            const char *text)
{
    oracle_sheet sheet;
    oracle_integrals own;

    if (taut_model_surface_count(model) != 1 || strcmp(base->construct, "asymptotic") == 0 ||
        !oracle_sheet_of(taut_model_surface(model, 0), &sheet)) {
        return;
    }
    if (sheet.u.spans * sheet.v.spans <= 16) {
        oracle_integrate(&sheet, 1e-12L, 2, &own);
        compare_figure(run, number, base, certificate, model, "area", own.area, own.area_error,
                       text);
        compare_figure(run, number, base, certificate, model, "dirichlet_energy", own.dirichlet,
                       own.dirichlet_error, text);
    }
    oracle_sheet_free(&sheet);
    if (strcmp(base->construct, "film") == 0) {
        const oracle_case about = {base->construct, model, base->document, base->model, NAN, 0};
        const double tension = oracle_number(taut_record_get(base->document, "tension"));
        double error = NAN;
        const double energy = oracle_film_energy(&about, model, &error);
        compare_figure(run, number, base, certificate, model, "energy",
                       (tension > 0 ? tension : 1) * (oracle_real)energy,
                       (tension > 0 ? tension : 1) * (oracle_real)error, text);
    }
}

static void make_one(const forge_run *run, int number, forge_pool *pool)
{
    forge_random random = {run->seed * 0x2545f4914f6cdd1du +
                           (uint64_t)number * 0x9e3779b97f4a7c15u};
    const forge_base *base;
    forge_base made = {0};
    taut_certificate *certificate = NULL;

    pool->used = 0;
    forge_bits(&random);
    base = &run->bases[forge_int(&random, 0, run->base_count - 1)];
    const char *text = made_problem(base, pool, &random);
    const double begin = seconds();
    if (!base_open(base->name, text, strlen(text), &made)) {
        run->tally->impossible++;
        return;
    }
    if (taut_certify(made.model, made.problem, NULL, &certificate, NULL) == TAUT_OK) {
        const oracle_case about = {made.construct, made.model, made.document, made.model, NAN, 0};
        const taut_verdict holds = taut_certificate_holds(certificate);
        oracle_finding finding;
        run->tally->verdict[construct_index(made.construct)][0][0][holds == TAUT_TRUE ? VERDICT_TRUE
                                                                   : holds == TAUT_FALSE
                                                                       ? VERDICT_FALSE
                                                                       : VERDICT_NULL]++;
        if (oracle_judge(&about, certificate, &finding)) {
            keep_lie(run, number, base->name, "made", 0, &finding, made.model, text);
        }
        run->tally->judged += finding.judged;
        run->tally->unjudged += finding.unjudged;
        compare_figures(run, number, &made, certificate, made.model, text);
    }
    if (seconds() - begin > run->tally->slowest) {
        run->tally->slowest = seconds() - begin;
        run->tally->slowest_number = number;
    }
    taut_certificate_free(certificate);
    base_close(&made);
}

static void *work(void *argument)
{
    const forge_run *run = argument;
    forge_pool pool = {malloc((size_t)8 << 20), (size_t)8 << 20, 0};
    edit_model *edit = malloc(sizeof *edit);

    if (pool.bytes != NULL && edit != NULL) {
        for (int i = run->first; i < run->count && time(NULL) < run->until; i += run->step) {
            run->tally->done++;
            if (run->made) {
                make_one(run, i, &pool);
            } else {
                forge_one(run, i, &pool, edit);
            }
        }
    }
    free(edit);
    free(pool.bytes);
    return NULL;
}

static void add_tally(forge_tally *to, const forge_tally *from)
{
    const long *a = &from->verdict[0][0][0][0];
    long *b = &to->verdict[0][0][0][0];

    for (size_t i = 0; i < sizeof from->verdict / sizeof *a; i++) {
        b[i] += a[i];
    }
    to->judged += from->judged;
    to->unjudged += from->unjudged;
    to->impossible += from->impossible;
    to->figures += from->figures;
    to->figures_off += from->figures_off;
    to->lies += from->lies;
    to->done += from->done;
    if (from->slowest > to->slowest) {
        to->slowest = from->slowest;
        to->slowest_number = from->slowest_number;
    }
}

static void print_tally(const forge_tally *tally, int made)
{
    printf("| construction | %s | certified | holds | false | null | refused "
           "|\n|---|---|---|---|---|---|---|\n",
           made ? "made" : "forgery");
    for (int c = 0; c < taut_construct_count(); c++) {
        for (int k = 0; k < (made ? 1 : forge_kind_count); k++) {
            for (int alone = 0; alone < 2; alone++) {
                const long *v = tally->verdict[c][k][alone];
                if (v[0] + v[1] + v[2] + v[3] > 0) {
                    printf("| %s | %s | %s | %ld | %ld | %ld | %ld |\n", taut_construct_name(c),
                           made ? "at random" : forge_kinds[k].name,
                           alone ? "alone" : "with the problem", v[0], v[1], v[2], v[3]);
                }
            }
        }
    }
}

static int is_wanted(const char *name, const char *construct, const char *list, int all)
{
    char only[80], whole[82];

    if (construct != NULL) {
        const size_t n = strlen(construct);
        if (strncmp(name, construct, n) != 0 || (name[n] != '-' && name[n] != 0)) {
            return 0;
        }
    }
    if (list != NULL) {
        snprintf(whole, sizeof whole, ",%s,", list);
        snprintf(only, sizeof only, ",%s,", name);
        return strstr(whole, only) != NULL;
    }
    for (size_t i = 0; i < sizeof usual / sizeof usual[0]; i++) {
        if (strcmp(usual[i], name) == 0) {
            return 1;
        }
    }
    return all;
}

/* Small, and of kinds that no example is. */
static const taut_embedded others[] = {
    {"film-small.json",
     "{\"taut\":1,\"construct\":\"film\",\"u\":{\"type\":\"bspline\",\"degree\":3,\"count\":6},"
     "\"v\":{\"type\":\"bspline\",\"degree\":4,\"count\":6},\"corners\":{\"u0v0\":[-1,-1,0.5],"
     "\"u1v0\":[1,-1,-0.5],\"u0v1\":[-1,1,-0.5],\"u1v1\":[1,1,0.5]},\"edges\":{"
     "\"u0\":{\"cable\":{\"force\":3}},\"u1\":{\"cable\":{\"force\":2}},"
     "\"v0\":{\"cable\":{\"force\":2}},\"v1\":{\"cable\":{\"force\":4}}}}",
     0},
    {"film-held.json",
     "{\"taut\":1,\"construct\":\"film\",\"u\":{\"type\":\"bspline\",\"degree\":3,\"count\":5},"
     "\"v\":{\"type\":\"bspline\",\"degree\":3,\"count\":6},\"tension\":3,\"corners\":{"
     "\"u0v0\":[-1,-1,0.5],\"u1v0\":[1,-1,-0.5],\"u0v1\":[-1,1,-0.5],\"u1v1\":[1,1,0.5]},\"edges\":"
     "{"
     "\"u1\":{\"cable\":{\"force\":9}},\"v1\":{\"cable\":{\"force\":700}}}}",
     0},
    {"film-curve.json",
     "{\"taut\":1,\"construct\":\"film\",\"u\":{\"type\":\"bspline\",\"degree\":3,\"count\":5},"
     "\"v\":{\"type\":\"bspline\",\"degree\":4,\"count\":6},\"corners\":{\"u1v0\":[2,0,0],\"u1v1\":"
     "[2,2,0]},"
     "\"edges\":{\"u0\":{\"fixed\":{\"t\":{\"type\":\"bezier\",\"degree\":2},\"weights\":[1,0.75,1]"
     ","
     "\"points\":[[0,0,0],[0,1,1],[0,2,0]]}},\"u1\":{\"cable\":{\"force\":4}},"
     "\"v0\":{\"cable\":{\"force\":5}},\"v1\":{\"cable\":{\"force\":6}}}}",
     0},
    {NULL, NULL, 0}};

static void open_list(const taut_embedded *file, forge_base *bases, const char *construct,
                      const char *list, int all, int *count)
{
    static char names[BASES_MAX][60];

    for (; file->name != NULL && *count < BASES_MAX; file++) {
        char *const name = names[*count];
        snprintf(name, sizeof names[0], "%.*s", (int)(strlen(file->name) - 5), file->name);
        if (is_wanted(name, construct, list, all) &&
            base_open(name, file->text, strlen(file->text), &bases[*count])) {
            ++*count;
        }
    }
}

static int open_bases(forge_base *bases, const char *construct, const char *list)
{
    int count = 0;

    open_list(taut_examples, bases, construct, list, 0, &count);
    open_list(others, bases, construct, list, 1, &count);
    return count;
}

/* What no bound of the least area may pass. */
static void measure_bases(const forge_base *bases, int count, double *area)
{
    for (int i = 0; i < count; i++) {
        oracle_sheet sheet;
        oracle_integrals own = {.area = NAN};
        if (strcmp(bases[i].construct, "plateau") == 0 &&
            oracle_sheet_of(taut_model_surface(bases[i].model, 0), &sheet)) {
            oracle_integrate(&sheet, 1e-11L, 2, &own);
            oracle_sheet_free(&sheet);
        }
        area[i] = (double)own.area;
    }
}

static const char *option(int argc, char **argv, const char *name)
{
    for (int i = 1; i + 1 < argc; i++) {
        if (strcmp(argv[i], name) == 0) {
            return argv[i + 1];
        }
    }
    return NULL;
}

int main(int argc, char **argv)
{
    static forge_base bases[BASES_MAX];
    static double area[BASES_MAX];
    const char *seed = option(argc, argv, "--seed"), *count = option(argc, argv, "--count");
    const char *threads = option(argc, argv, "--threads"), *mode = option(argc, argv, "--mode");
    const char *only = option(argc, argv, "--only"), *limit = option(argc, argv, "--seconds");
    forge_run run[2] = {{.seed = seed != NULL ? strtoull(seed, NULL, 10) : 1,
                         .count = count != NULL ? atoi(count) : 1000,
                         .step = 1,
                         .made = mode != NULL && strcmp(mode, "made") == 0,
                         .bases = bases,
                         .area = area,
                         .folder = option(argc, argv, "--folder"),
                         .until = time(NULL) + (limit != NULL ? atoi(limit) : 1000000000),
                         .tally = calloc(1, sizeof(forge_tally))}};
    const int two = threads != NULL && atoi(threads) > 1;

    run[0].base_count =
        open_bases(bases, option(argc, argv, "--construct"), option(argc, argv, "--bases"));
    if (run[0].base_count == 0 || run[0].tally == NULL) {
        fprintf(stderr, "forge: no base\n");
        return 2;
    }
    measure_bases(bases, run[0].base_count, area);
    if (only != NULL) {
        run[0].first = atoi(only);
        run[0].count = run[0].first + 1;
    }
    if (two) {
        pthread_t other;
        run[0].step = 2;
        run[1] = run[0];
        run[1].first++;
        run[1].tally = calloc(1, sizeof(forge_tally));
        if (run[1].tally == NULL || pthread_create(&other, NULL, work, &run[1]) != 0) {
            return 2;
        }
        work(&run[0]);
        pthread_join(other, NULL);
        add_tally(run[0].tally, run[1].tally);
        free(run[1].tally);
    } else {
        work(&run[0]);
    }
    const forge_tally *tally = run[0].tally;
    for (int i = 1; i < argc; i++) {
        if (strcmp(argv[i], "--table") == 0) {
            print_tally(tally, run[0].made);
        }
    }
    printf(
        "seed %llu, %d %s: %ld false holds; %ld claims judged, %ld without a judge; %ld could not "
        "be built; %ld figures compared; slowest %.3f s (%d)\n",
        (unsigned long long)run[0].seed, tally->done, run[0].made ? "problems" : "forgeries",
        tally->lies, tally->judged, tally->unjudged, tally->impossible, tally->figures,
        tally->slowest, tally->slowest_number);
    const int failed = tally->lies > 0;
    free(run[0].tally);
    for (int i = 0; i < run[0].base_count; i++) {
        base_close(&bases[i]);
    }
    return failed;
}
