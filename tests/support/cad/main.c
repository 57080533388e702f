/* main.c -- probe_step --areas FILE: the area of each face. probe_step FILE...: what OpenCASCADE sees in each, a line of "word value" pairs. Ends with
 * 77 where OpenCASCADE was not there when this was built. */
#include "probe.h"

#include <stdio.h>
#include <string.h>

int main(int count, char **words)
{
    int bad = 0;
    if (!step_probe_is_there()) {
        return 77;
    }
    if (count == 3 && strcmp(words[1], "--areas") == 0) {
        return !step_probe_areas(words[2]);
    }
    for (int i = 1; i < count; i++) {
        step_probe p;
        step_probe_file(words[i], &p);
        printf("%s read %d valid %d closed %d solids %d shells %d faces %d edges %d vertices %d "
               "free %d "
               "colours %d volume %.15g area %.15g tolerance %.3g product %s\n",
               words[i], p.is_read, p.valid, p.closed, p.solids, p.shells, p.faces, p.edges,
               p.vertices, p.free_edges, p.colours, p.volume, p.area, p.tolerance, p.product);
        bad |= !p.is_read;
    }
    return bad;
}
