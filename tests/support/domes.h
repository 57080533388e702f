/* domes.h -- surfaces with a pole, as JSON for `of`. */
#ifndef TAUT_TEST_DOMES_H
#define TAUT_TEST_DOMES_H

typedef enum dome_kind {
    DOME_CONE,   /* a whole turn, sine 0.6, slant 0 (v0) to 3 */
    DOME_SPHERE, /* the unit sphere, a whole turn, from an angle off its pole (v0) to the pole (v1) */
    DOME_RAYS, /* plane, v c(u) over the first quadrant, c of uneven length, 1 to 2: the pole is v0 */
    DOME_RAYS_TURNED /* (1 - v) c(u) */
} dome_kind;

/* free_dome it. */
char *dome_text(dome_kind kind, double angle);
void free_dome(char *text);

#endif /* TAUT_TEST_DOMES_H */
