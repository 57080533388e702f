/* parts.h -- what the steps of making a sheet hand to each other. Shares, 0 to 1, run along a surface's own parameters. */
#ifndef TAUT_SHELL_THICK_PARTS_H
#define TAUT_SHELL_THICK_PARTS_H

#include "mesh/seams.h"
#include "shell/shell.h"
#include "shell/thick/thick.h"

enum { TAUT_THICK_DEGREE = 5 };

/* The breaks that all directions of a chain share, as its root has them. */
typedef struct taut_thick_line {
    int count;             /* of breaks; 0 where this is no root */
    double *breaks;        /* [count], 0 to 1 */
    int *times;            /* [count]: how often each is a knot */
    unsigned char *halved; /* [count - 1]: marks of spans that are too wide */
} taut_thick_line;

typedef struct taut_thick_work {
    const taut_surface *const *surfaces;
    int count;
    double half; /* T/2 */
    int threads;
    const taut_shells *shells;
    int *partner;            /* [4 count]: the edge that is the same, or -1 */
    unsigned char *reversed; /* [4 count]: it runs against it */
    int *vertex;             /* [4 count], of corners */
    int *first, *next; /* corners of each vertex: first[vertex], then next[corner], -1 at the end */
    taut_mirror_sets sets;  /* of directions, 2 f for u and 2 f + 1 for v of surface f */
    taut_thick_line *lines; /* [2 count] */
    taut_arena *arena;
} taut_thick_work;

/* ---- lines.c ---- */

/* Chains of directions, and their breaks to begin with: those of their members. TAUT_NO_MEMORY. */
taut_status taut_thick_find_lines(taut_thick_work *work);
/* Halves the spans that are marked; *halved: how many. TAUT_NO_MEMORY; TAUT_NO_SOLUTION: a line has too many. */
taut_status taut_thick_halve_lines(taut_thick_work *work, int *halved, taut_error *error);
/* A direction's breaks as it runs itself: breaks[line count], and their number. */
int taut_thick_breaks_of(taut_thick_work *work, int direction, double *breaks);
/* Marks span k of a direction, as it runs itself. */
void taut_thick_mark(taut_thick_work *work, int direction, int k);
/* The spline basis of a direction, over [0, 1]; the caller's. */
taut_status taut_thick_basis(taut_thick_work *work, int direction, taut_basis **basis,
                             taut_error *error);

/* ---- target.c ---- */

/* A grid of shares on one surface, and what is there. */
typedef struct taut_thick_grid {
    int nu, nv;
    const double *u, *v; /* shares */
    double *places;      /* [nu][nv][3]: x, and what joins it to its neighbours at edges */
    double *moves;       /* [nu][nv][3]: n likewise: sides are at places +- T/2 moves */
    double *surface;     /* [nu][nv][3]: x itself */
    double *normals;     /* [nu][nv][3]: n itself, turned as the sheet is */
} taut_thick_grid;

/* Fills a grid whose u and v are there, its arrays from the arena. Statuses as taut_thick_new. */
taut_status taut_thick_fill_grid(const taut_thick_work *work, int face, taut_arena *arena,
                                 taut_thick_grid *grid, taut_error *error);

/* ---- fit.c ---- */

/* The places of interpolation of a basis, [count]: means of its knots. */
void taut_thick_nodes(const taut_basis *basis, double *nodes);
/* values double[nu][nv][3] at the nodes become control points. TAUT_NO_MEMORY. */
taut_status taut_thick_fit(const taut_basis *u, const taut_basis *v, double *values);

/* ---- prove.c ---- */

/* Splines of one surface: nets of x^ and n^. */
typedef struct taut_thick_sides {
    taut_basis *u, *v;
    double *places, *moves;
} taut_thick_sides;

/* *bound: how far both sides are from where they belong at most, over all of the surface; infinite where nothing is proved (the
 * degree is above 25, or the surface is not regular). `found` was found, `tolerance` asked for. TAUT_NO_MEMORY. */
taut_status taut_thick_prove(const taut_thick_work *work, int face, const taut_thick_sides *sides,
                             double tolerance, double found, double *bound);

#endif /* TAUT_SHELL_THICK_PARTS_H */
