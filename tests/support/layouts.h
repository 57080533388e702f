/* layouts.h -- random films of many patches, as documents: quads over shared vertices, each written with an orientation of its own,
 * edges that two or more of them share as seams. */
#ifndef TAUT_TEST_LAYOUTS_H
#define TAUT_TEST_LAYOUTS_H

enum { LAYOUT_PATCHES = 60, LAYOUT_VERTICES = 200, LAYOUT_EDGES = 300, LAYOUT_TEXT = 120000 };

typedef enum layout_kind {
    LAYOUT_GRID, /* over a rectangle, uneven, with holes; flat ones, and such between four lines */
    LAYOUT_STAR, /* quads about a vertex, in rounds */
    LAYOUT_BOOK, /* sheets along one line */
    LAYOUT_TUBE, /* between two circles or polygons */
    LAYOUT_KINDS
} layout_kind;

typedef struct layout_edge {
    int ends[2]; /* the smaller one first */
    int used, class, cable, slide;
    double force;
    char sides[6][16]; /* as it is run from ends[0] */
} layout_edge;

/* What is known of the film. */
typedef struct layout {
    layout_kind kind;
    int patches, vertices, edges;
    int across, along;            /* of a grid: vertex (i, j) is number i (along + 1) + j */
    int quads[LAYOUT_PATCHES][4]; /* round: u0v0, u1v0, u1v1, u0v1 */
    double points[LAYOUT_VERTICES][3];
    int held[LAYOUT_VERTICES], near[LAYOUT_VERTICES];
    layout_edge edge[LAYOUT_EDGES];
    int degree, even; /* even: all edges have as many functions */
    double tension;   /* of all */
    int arcs;         /* a tube between circles */
    double height;    /* a tube's */
    double area;      /* above 0: a flat film without cables */
    double corners[4][3];
    int is_frame; /* all that holds it are the four lines of `corners` */
    int cables;
    char text[LAYOUT_TEXT];
} layout;

/* Takes random numbers as they come (check.h). */
void layout_random(layout *l);
/* The same frame as a film of one patch, into text. */
void layout_frame(const layout *l, int degree, int count, char *text, unsigned long room);

#endif /* TAUT_TEST_LAYOUTS_H */
