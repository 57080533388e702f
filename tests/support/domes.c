#include "domes.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { ROOM = 8192 };

/* Four quarters of a circle about the z axis through each place (r, z, w) of a profile. */
static size_t put_turn(char *text, size_t n, int count, double profile[][3])
{
    static const double ways[9][2] = {{1, 0},   {1, 1},  {0, 1},  {-1, 1}, {-1, 0},
                                      {-1, -1}, {0, -1}, {1, -1}, {1, 0}};
    for (int pass = 0; pass < 2; pass++) {
        n +=
            (size_t)snprintf(text + n, ROOM - n, pass == 0 ? "\"points\": [" : "], \"weights\": [");
        for (int i = 0; i < 9; i++) {
            n += (size_t)snprintf(text + n, ROOM - n, "%s[", i > 0 ? ", " : "");
            for (int k = 0; k < count; k++) {
                const double *p = profile[k], w = p[2] * (i % 2 == 0 ? 1 : sqrt(0.5));
                n += pass == 0
                         ? (size_t)snprintf(text + n, ROOM - n, "%s[%.17g, %.17g, %.17g]",
                                            k > 0 ? ", " : "", p[0] * ways[i][0], p[0] * ways[i][1],
                                            p[1])
                         : (size_t)snprintf(text + n, ROOM - n, "%s%.17g", k > 0 ? ", " : "", w);
            }
            n += (size_t)snprintf(text + n, ROOM - n, "]");
        }
    }
    return n + (size_t)snprintf(text + n, ROOM - n, "]");
}

/* Half a turn on the trigonometric basis of pi. */
static const char cone[] =
    "\"u\": { \"type\": \"c-bezier\", \"alpha\": 3.141592653589793 }, \"v\": { \"type\": "
    "\"bezier\", "
    "\"degree\": 1 }, \"points\": [[[0, 0, 0], [1.8, 0, -2.4]], [[0, 0, 0], [1.8, "
    "2.827433388230814, "
    "-2.4]], [[0, 0, 0], [-1.8, 2.827433388230814, -2.4]], [[0, 0, 0], [-1.8, 0, -2.4]]]";

char *dome_text(dome_kind kind, double angle)
{
    static const char rays[] = "\"u\": { \"type\": \"bezier\", \"degree\": 2 }, \"v\": { \"type\": "
                               "\"bezier\", \"degree\": 1 }, "
                               "\"points\": [[%s], [%s], [%s]]";
    static const char *const ends[3][2] = {{"[0, 0, 0], [1, 0, 0]", "[1, 0, 0], [0, 0, 0]"},
                                           {"[0, 0, 0], [1, 1, 0]", "[1, 1, 0], [0, 0, 0]"},
                                           {"[0, 0, 0], [0, 2, 0]", "[0, 2, 0], [0, 0, 0]"}};
    char *text = malloc(ROOM);
    const int k = kind == DOME_RAYS_TURNED;
    if (text == NULL) {
        abort();
    }
    size_t n = (size_t)snprintf(text, ROOM, "{ \"taut\": 1, \"surfaces\": [{ \"name\": \"dome\", ");
    if (kind == DOME_CONE) {
        n += (size_t)snprintf(text + n, ROOM - n, "%s", cone);
    } else if (kind == DOME_RAYS || kind == DOME_RAYS_TURNED) {
        n += (size_t)snprintf(text + n, ROOM - n, rays, ends[0][k], ends[1][k], ends[2][k]);
    } else {
        double cap[3][3] = {
            {sin(angle), cos(angle), 1}, {tan(angle / 2), 1, cos(angle / 2)}, {0, 1, 1}};
        n += (size_t)snprintf(text + n, ROOM - n,
                              "\"u\": { \"type\": \"bspline\", \"degree\": 2, \"knots\": [0, 0, 0, "
                              "1, 1, 2, 2, 3, 3, 4, 4, 4] }, \"v\": { \"type\": \"bezier\", "
                              "\"degree\": 2 }, ");
        n = put_turn(text, n, 3, cap);
    }
    snprintf(text + n, ROOM - n, " }] }");
    return text;
}

void free_dome(char *text)
{
    free(text);
}
