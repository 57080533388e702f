/* unit_map.h -- data brought to unit size, and near to the origin where it is far, without rounding:
 * what a completion amplifies are the numbers as they were given. */
#ifndef TAUT_HARMONIC_UNIT_MAP_H
#define TAUT_HARMONIC_UNIT_MAP_H

#include <stddef.h>

typedef struct taut_unit_map {
    double centre[3];
    double size; /* a power of two: the largest distance of a coordinate from the centre is below it
                  * and at least half of it; 1 where all points coincide */
} taut_unit_map;

/* The power of two for a largest distance. */
double taut_unit_map_size(double largest);

/* The map of points[count][3], of which only those with known[i] != 0 count (NULL: all). */
taut_unit_map taut_unit_map_of(size_t count, const double *points, const unsigned char *known);
/* The largest coordinate over the size, at least 1: how much coarser the rounding of the points is,
 * for points far from the origin. */
double taut_unit_map_reach(const taut_unit_map *map);

/* To unit size and back, in place. */
void taut_unit_map_apply(const taut_unit_map *map, size_t count, double *points);
void taut_unit_map_undo(const taut_unit_map *map, size_t count, double *points);

#endif /* TAUT_HARMONIC_UNIT_MAP_H */
