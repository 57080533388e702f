#include "evolver.h"

#include <fcntl.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

static double seconds_of(const struct rusage *usage)
{
    return (double)(usage->ru_utime.tv_sec + usage->ru_stime.tv_sec) +
           1e-6 * (double)(usage->ru_utime.tv_usec + usage->ru_stime.tv_usec);
}

double bench_run(const char *const *arguments, const char *output)
{
    struct rusage before, after;
    int status = 0;
    getrusage(RUSAGE_CHILDREN, &before);
    const pid_t child = fork();
    if (child == 0) {
        const int out = open(output, O_WRONLY | O_CREAT | O_TRUNC, 0600);
        dup2(out, STDOUT_FILENO);
        dup2(out, STDERR_FILENO);
        execv(arguments[0], (char *const *)(size_t)arguments);
        _exit(127);
    }
    if (child < 0 || waitpid(child, &status, 0) != child) {
        return -1;
    }
    getrusage(RUSAGE_CHILDREN, &after);
    return WIFEXITED(status) && WEXITSTATUS(status) == 0 ? seconds_of(&after) - seconds_of(&before)
                                                         : -1;
}

double bench_evolver(const char *file, int degree, int levels, double *seconds)
{
    char folder[] = "/tmp/bench-plateau-XXXXXX", commands[64], option[80], output[64], alias[64],
         dump[72], line[256];
    double area = nan("");
    if (mkdtemp(folder) == NULL) {
        exit(5);
    }
    snprintf(commands, sizeof commands, "%s/commands", folder);
    snprintf(output, sizeof output, "%s/output", folder);
    snprintf(alias, sizeof alias, "%s/film.fe", folder);
    snprintf(dump, sizeof dump, "%s.dmp", alias); /* it leaves one beside its file */
    if (symlink(file, alias) != 0) {
        exit(5);
    }
    snprintf(option, sizeof option, "-f%s", commands);
    FILE *script = fopen(commands, "w");
    if (script == NULL) {
        exit(5);
    }
    fputs("quiet\nM 2\nr\ng 5\n", script);
    for (int k = 1; k < levels; k++) {
        fputs("r; g 2; hessian_seek\n", script);
    }
    if (degree > 2) {
        fprintf(script, "lagrange %d\n", degree);
    }
    fputs("hessian_seek; hessian; hessian\nprintf \"area %.15g\\n\", total_area\nq\nq\n", script);
    fclose(script);
    const char *const arguments[] = {BENCH_EVOLVER, "-x", option, alias, NULL};
    *seconds = bench_run(arguments, output);
    FILE *said = fopen(output, "r");
    while (said != NULL && fgets(line, sizeof line, said) != NULL) {
        const char *at = strstr(line, "area ");
        if (at != NULL) {
            area = strtod(at + 5, NULL);
        }
    }
    if (said != NULL) {
        fclose(said);
    }
    remove(commands);
    remove(output);
    remove(alias);
    remove(dump);
    rmdir(folder);
    return area;
}
