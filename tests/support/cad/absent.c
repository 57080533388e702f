/* absent.c -- the probe where OpenCASCADE is not installed. */
#include "probe.h"

#include <string.h>

int step_probe_is_there(void)
{
    return 0;
}

int step_probe_areas(const char *path)
{
    (void)path;
    return 0;
}

void step_probe_file(const char *path, step_probe *found)
{
    (void)path;
    memset(found, 0, sizeof *found);
}
