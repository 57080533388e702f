/* limits.cpp -- how far a file may drive this process. */
#include "request.hpp"

#include <csignal>
#include <cstdio>

#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#if defined(__SANITIZE_ADDRESS__)
static const bool has_shadow = true;
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
static const bool has_shadow = true;
#else
static const bool has_shadow = false;
#endif
#else
static const bool has_shadow = false;
#endif

/* Bytes of address space in use. */
static double space_in_use()
{
    unsigned long pages = 0;
    int found = 0;
    FILE *file = std::fopen("/proc/self/statm", "r");
    if (file != nullptr) {
        found = std::fscanf(file, "%lu", &pages);
        std::fclose(file);
    }
    return found == 1 ? static_cast<double>(pages) * static_cast<double>(sysconf(_SC_PAGESIZE)) : 0;
}

/* Never above what the system allows. */
static void set_limit(int resource, double soft, double hard)
{
    struct rlimit now;
    if (getrlimit(resource, &now) != 0) {
        return;
    }
    const double highest = now.rlim_max == RLIM_INFINITY ? hard : static_cast<double>(now.rlim_max);
    now.rlim_max = static_cast<rlim_t>(hard < highest ? hard : highest);
    now.rlim_cur = static_cast<rlim_t>(soft < highest ? soft : highest);
    setrlimit(resource, &now);
}

static double size_of_file(const char *path)
{
    struct stat about;
    return stat(path, &about) == 0 ? static_cast<double>(about.st_size) : 0;
}

static double size_of_request()
{
    struct stat about;
    return fstat(STDIN_FILENO, &about) == 0 ? static_cast<double>(about.st_size) : 0;
}

/* What the request explains, which may still be raised by what its file explains. */
static void limit_softly(int resource, double soft)
{
    struct rlimit now;
    if (getrlimit(resource, &now) == 0 &&
        (now.rlim_max == RLIM_INFINITY || soft < static_cast<double>(now.rlim_max))) {
        now.rlim_cur = static_cast<rlim_t>(soft);
        setrlimit(resource, &now);
    }
}

void settle_process()
{
    const double size = size_of_request();
    std::signal(SIGPIPE, SIG_IGN);
    std::signal(SIGXFSZ, SIG_IGN);
    set_limit(RLIMIT_CORE, 0, 0);
    set_limit(RLIMIT_FSIZE, 0, 0);
    limit_softly(RLIMIT_CPU, taut_cad_seconds(size));
    if (!has_shadow) {
        limit_softly(RLIMIT_AS, space_in_use() + taut_cad_memory(size));
    }
}

/* Out of time is told by one signal, and the other comes a second later where that is not enough. An address sanitizer's
 * shadow takes terabytes of its own. */
void limit_process(const char *path)
{
    const double size = size_of_file(path) + size_of_request(), seconds = taut_cad_seconds(size);
    const double memory = space_in_use() + taut_cad_memory(size);
    set_limit(RLIMIT_CPU, seconds, seconds + 1);
    if (!has_shadow) {
        set_limit(RLIMIT_AS, memory, memory);
    }
}
