#include "numeric/kernel/kernel.h"

#include <stdlib.h>
#include <string.h>

extern const taut_kernel taut_kernel_baseline;
#if defined(__x86_64__)
extern const taut_kernel taut_kernel_avx2;
extern const taut_kernel taut_kernel_avx512;

static int has_avx2(void)
{
    return __builtin_cpu_supports("avx2") != 0;
}

static int has_avx512(void)
{
    return has_avx2() && __builtin_cpu_supports("avx512f") != 0 &&
           __builtin_cpu_supports("avx512dq") != 0 && __builtin_cpu_supports("avx512vl") != 0;
}
#endif

static int has_always(void)
{
    return 1;
}

/* Best first. */
static const struct {
    const taut_kernel *kernel;
    int (*is_supported)(void);
} kernels[] = {
#if defined(__x86_64__)
    {&taut_kernel_avx512, has_avx512},
    {&taut_kernel_avx2, has_avx2},
#endif
    {&taut_kernel_baseline, has_always},
};

const taut_kernel *taut_kernel_find(const char *name)
{
    for (size_t i = 0; i < sizeof kernels / sizeof *kernels; i++) {
        if (strcmp(kernels[i].kernel->name, name) == 0 && kernels[i].is_supported()) {
            return kernels[i].kernel;
        }
    }
    return NULL;
}

const taut_kernel *taut_kernel_best(void)
{
    const char *wanted = getenv("TAUT_KERNEL");
    const taut_kernel *found = wanted == NULL ? NULL : taut_kernel_find(wanted);
    for (size_t i = 0; found == NULL; i++) {
        found = kernels[i].is_supported() ? kernels[i].kernel : NULL;
    }
    return found;
}

const char *taut_kernel_name(void)
{
    return taut_kernel_best()->name;
}

int taut_kernel_is(const char *name)
{
    return strcmp(taut_kernel_name(), name) == 0;
}
