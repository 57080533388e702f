/* constants.h -- numbers of mathematics and of the arithmetic. */
#ifndef TAUT_CORE_CONSTANTS_H
#define TAUT_CORE_CONSTANTS_H

#define TAUT_PI 3.14159265358979323846
#define TAUT_UNIT_ROUNDOFF 0x1p-53 /* the largest relative error of one rounding */

#endif /* TAUT_CORE_CONSTANTS_H */
