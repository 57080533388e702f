/* polygon.h -- regions of the plane between straight lines and arcs of circles that bow into them (flat.h). */
#ifndef TAUT_CONSTRUCT_FILM_POLYGON_H
#define TAUT_CONSTRUCT_FILM_POLYGON_H

/* One side, run with the sail on its left. */
typedef struct taut_film_arc {
    double a[2], b[2]; /* its ends */
    double chord;
    double radius; /* of the arc, over size 1; 0: straight */
    double kept;   /* scratch */
} taut_film_arc;

typedef struct taut_film_polygon {
    int count; /* 3 or more */
    taut_film_arc *sides;
    double factor; /* scratch: of all radii */
} taut_film_polygon;

void taut_film_arc_set(taut_film_arc *side, const double a[2], const double b[2], double radius);

/* Is there a sail with all forces `factor` times what they are? */
int taut_film_polygon_exists(taut_film_polygon *polygon, double factor);
/* Do the chords bound no polygon? */
int taut_film_polygon_is_crossed(taut_film_polygon *polygon);
/* The least factor of all forces, 1 or more, with which there is a sail. */
double taut_film_polygon_factor(taut_film_polygon *polygon);

#endif /* TAUT_CONSTRUCT_FILM_POLYGON_H */
