#include "machine.h"

#include <stdio.h>
#include <string.h>
#include <time.h>

#if defined(__x86_64__)
#include <immintrin.h>
#endif

static double seconds(clockid_t clock)
{
    struct timespec t;
    clock_gettime(clock, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

double bench_cpu_seconds(void)
{
    return seconds(CLOCK_PROCESS_CPUTIME_ID);
}

double bench_wall_seconds(void)
{
    return seconds(CLOCK_MONOTONIC);
}

const char *bench_processor(void)
{
    static char name[128] = "unknown";
    FILE *file = fopen("/proc/cpuinfo", "r");
    char line[256];
    while (file != NULL && fgets(line, sizeof line, file) != NULL) {
        char *colon = strchr(line, ':');
        if (strncmp(line, "model name", 10) == 0 && colon != NULL) {
            snprintf(name, sizeof name, "%s", colon + 2);
            name[strcspn(name, "\n")] = '\0';
            break;
        }
    }
    if (file != NULL) {
        fclose(file);
    }
    return name;
}

#if defined(__x86_64__)
__attribute__((target("avx"))) static void store(double *buffer, size_t bytes)
{
    const __m256d value = _mm256_set1_pd(1.5);
    for (size_t i = 0; i + 4 <= bytes / 8; i += 4) {
        _mm256_stream_pd(buffer + i, value);
    }
    _mm_sfence();
}

__attribute__((target("avx2,fma"))) static double fma256(long rounds)
{
    __m256d a[12];
    const __m256d x = _mm256_set1_pd(0.999999), y = _mm256_set1_pd(1e-9);
    double sum = 0, part[4];
    for (int i = 0; i < 12; i++) {
        a[i] = _mm256_set1_pd(i);
    }
    for (long r = 0; r < rounds; r++) {
        for (int i = 0; i < 12; i++) {
            a[i] = _mm256_fmadd_pd(a[i], x, y);
        }
    }
    for (int i = 0; i < 12; i++) {
        _mm256_storeu_pd(part, a[i]);
        sum += part[0];
    }
    return sum;
}

__attribute__((target("avx512f"))) static double fma512(long rounds)
{
    __m512d a[12];
    const __m512d x = _mm512_set1_pd(0.999999), y = _mm512_set1_pd(1e-9);
    double sum = 0, part[8];
    for (int i = 0; i < 12; i++) {
        a[i] = _mm512_set1_pd(i);
    }
    for (long r = 0; r < rounds; r++) {
        for (int i = 0; i < 12; i++) {
            a[i] = _mm512_fmadd_pd(a[i], x, y);
        }
    }
    for (int i = 0; i < 12; i++) {
        _mm512_storeu_pd(part, a[i]);
        sum += part[0];
    }
    return sum;
}
#endif

double bench_store_rate(double *buffer, size_t bytes)
{
    double best = 1e30;
    for (int i = 0; i < 3; i++) {
        const double start = bench_cpu_seconds();
#if defined(__x86_64__)
        store(buffer, bytes);
#else
        memset(buffer, 0, bytes);
#endif
        const double took = bench_cpu_seconds() - start;
        best = took < best ? took : best;
    }
    return (double)bytes / best;
}

double bench_fma_rate(void)
{
    const long rounds = 10000000;
    double best = 1e30;
    volatile double sink = 0;
    int width = 0;
    for (int i = 0; i < 3; i++) {
        const double start = bench_cpu_seconds();
#if defined(__x86_64__)
        if (__builtin_cpu_supports("avx512f")) {
            sink = fma512(rounds);
            width = 8;
        } else if (__builtin_cpu_supports("fma")) {
            sink = fma256(rounds);
            width = 4;
        }
#endif
        const double took = bench_cpu_seconds() - start;
        best = took < best ? took : best;
    }
    (void)sink;
    return width > 0 ? 2.0 * 12 * width * (double)rounds / best : 0;
}
