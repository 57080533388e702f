/* unit.h -- the units of length that documents may say. */
#ifndef TAUT_CORE_UNIT_H
#define TAUT_CORE_UNIT_H

/* How many of the unit `to` one of the unit `from` is, rounded once; 0 where one of them is none of "mm", "cm", "m", "in",
 * "ft". */
double taut_unit_ratio(const char *from, const char *to);

#endif /* TAUT_CORE_UNIT_H */
