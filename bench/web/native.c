/* native.c -- what web.mjs times in the module, by the same calls on this machine's own processor, the best kernel it has.
 *
 *     bench-web-native FILE OTHER POINTER VALUE TIMES
 *
 * Prints milliseconds, the least of so many times each: made, where the problem before had other bases (OTHER's), with 65 x 65
 * positions and normals; a point set, made, the same positions and normals; proved.
 */
#include "machine.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* src/web/web.c, which is a program's end and has no header. */
typedef struct taut_web taut_web;
taut_web *taut_web_open(const char *text, size_t length);
void taut_web_close(taut_web *web);
int taut_web_set(taut_web *web, const char *pointer, const char *value, size_t length);
int taut_web_make(taut_web *web);
int taut_web_certify(taut_web *web);
const float *taut_web_grid(taut_web *web, int s, int nu, int nv);
const char *taut_web_error(void);

enum { GRID = 65 };

static void require(int is_well, const char *what)
{
    if (!is_well) {
        fprintf(stderr, "bench-web-native: %s: %s\n", what, taut_web_error());
        exit(6);
    }
}

static taut_web *open_file(const char *path)
{
    static char text[1 << 20];
    FILE *file = fopen(path, "rb");
    require(file != NULL, path);
    const size_t length = fread(text, 1, sizeof text - 1, file);
    fclose(file);
    text[length] = '\0';
    taut_web *web = taut_web_open(text, length);
    require(web != NULL, path);
    return web;
}

int main(int argc, char **argv)
{
    if (argc != 6) {
        fprintf(stderr, "bench-web-native FILE OTHER POINTER VALUE TIMES\n");
        return 2;
    }
    taut_web *web = open_file(argv[1]), *other = open_file(argv[2]);
    const int times = atoi(argv[5]);
    double made = INFINITY, dragged = INFINITY, proved = INFINITY;
    for (int k = 0; k < times; k++) {
        require(taut_web_make(other) == 0, argv[2]);
        const double begin = bench_cpu_seconds();
        require(taut_web_make(web) == 0, argv[1]);
        require(taut_web_grid(web, 0, GRID, GRID) != NULL, "grid");
        made = fmin(made, bench_cpu_seconds() - begin);
    }
    for (int k = 0; k < times; k++) {
        const double begin = bench_cpu_seconds();
        require(taut_web_set(web, argv[3], argv[4], strlen(argv[4])) == 0, argv[3]);
        require(taut_web_make(web) == 0, argv[1]);
        require(taut_web_grid(web, 0, GRID, GRID) != NULL, "grid");
        dragged = fmin(dragged, bench_cpu_seconds() - begin);
    }
    for (int k = 0; k < (times + 9) / 10; k++) {
        const double begin = bench_cpu_seconds();
        require(taut_web_certify(web) == 0, "proof");
        proved = fmin(proved, bench_cpu_seconds() - begin);
    }
    printf("%.6f %.6f %.6f\n", 1e3 * made, 1e3 * dragged, 1e3 * proved);
    taut_web_close(web);
    taut_web_close(other);
    return 0;
}
