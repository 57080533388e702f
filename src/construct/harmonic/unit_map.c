#include "construct/harmonic/unit_map.h"
#include "core/vec3.h"

#include <float.h>
#include <math.h>

double taut_unit_map_size(double size)
{
    int exponent = 0;
    if (!(size > 0)) {
        return 1;
    }
    (void)frexp(size, &exponent);
    return ldexp(1, exponent < DBL_MAX_EXP ? exponent : DBL_MAX_EXP - 1);
}

/* A middle at least three times as far as the ends are from it: all points lie between half of it
 * and twice of it, where subtraction is exact. A nearer one is left at 0. */
taut_unit_map taut_unit_map_of(size_t count, const double *points, const unsigned char *known)
{
    taut_unit_map map = {{0, 0, 0}, 0};
    for (int c = 0; c < 3; c++) {
        double low = INFINITY, high = -INFINITY;
        for (size_t i = 0; i < count; i++) {
            if (known == NULL || known[i]) {
                low = fmin(low, points[3 * i + (size_t)c]);
                high = fmax(high, points[3 * i + (size_t)c]);
            }
        }
        if (low <= high) {
            const double middle = 0.5 * low + 0.5 * high;
            map.centre[c] = fabs(middle) > 3 * (0.5 * high - 0.5 * low) ? middle : 0;
            map.size = fmax(map.size, fmax(high - map.centre[c], map.centre[c] - low));
        }
    }
    map.size = taut_unit_map_size(map.size);
    return map;
}

double taut_unit_map_reach(const taut_unit_map *map)
{
    const double *c = map->centre;
    return 1 + taut_largest_coordinate(c) / map->size;
}

void taut_unit_map_apply(const taut_unit_map *map, size_t count, double *points)
{
    for (size_t i = 0; i < 3 * count; i++) {
        points[i] = (points[i] - map->centre[i % 3]) / map->size;
    }
}

void taut_unit_map_undo(const taut_unit_map *map, size_t count, double *points)
{
    for (size_t i = 0; i < 3 * count; i++) {
        points[i] = map->centre[i % 3] + map->size * points[i];
    }
}
