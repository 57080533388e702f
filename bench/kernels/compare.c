/* compare.c -- the loops of several trees side by side: compare NAME=MODULE.so..., modules made of loops.c.
 *
 * Each loop runs in turns, module after module, and the least time of many turns counts: what else the machine does only ever adds. */
#include <dlfcn.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MODULES_MAX = 8, TURNS = 200 };

typedef const char *name_call(size_t index);
typedef double run_call(const char *set, size_t index, int repeats);

int main(int argc, char **argv)
{
    static const char *const sets[] = {"baseline", "avx2", "avx512"};
    name_call *name = NULL;
    run_call *run[MODULES_MAX];
    int count = 0;
    printf("| loop | set |");
    for (int i = 1; i < argc && count < MODULES_MAX; i++) {
        char *path = strchr(argv[i], '=');
        void *module = path == NULL ? NULL : dlopen(path + 1, RTLD_NOW | RTLD_LOCAL);
        if (module == NULL) {
            fprintf(stderr, "compare: %s: %s\n", argv[i], dlerror());
            return 1;
        }
        *(void **)&name = dlsym(module, "bench_name");
        *(void **)&run[count++] = dlsym(module, "bench_run");
        printf(" %.*s, ns |", (int)(path - argv[i]), argv[i]);
    }
    printf(" last over first | last over second |\n|---|---|");
    for (int i = 0; i < count + 2; i++) {
        printf("---|");
    }
    printf("\n");
    for (size_t loop = 0; name != NULL && name(loop) != NULL; loop++) {
        for (int s = 0; s < 3; s++) {
            double least[MODULES_MAX];
            for (int m = 0; m < count; m++) {
                least[m] = run[m](sets[s], loop, 1);
            }
            if (least[0] < 0) {
                continue;
            }
            /* turns of some 50 us */
            const int repeats = (int)fmin(1000, fmax(1, 50e-6 / fmax(1e-7, 24 * least[0])));
            for (int m = 0; m < count; m++) {
                least[m] = INFINITY;
            }
            for (int turn = 0; turn < TURNS; turn++) {
                for (int m = 0; m < count; m++) {
                    least[m] = fmin(least[m], run[m](sets[s], loop, repeats));
                }
            }
            printf("| `%s` | %s |", name(loop), sets[s]);
            for (int m = 0; m < count; m++) {
                printf(" %.4g |", 1e9 * least[m]);
            }
            printf(" %.2f | %.2f |\n", least[count - 1] / least[0],
                   count > 2 ? least[count - 1] / least[1] : NAN);
        }
    }
    return 0;
}
