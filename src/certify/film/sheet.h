/* sheet.h -- a film at Gauss nodes of the certificate's own: its energy, what it weighs at each
 * point, and the derivatives of both.
 *
 *     E / s = A + sum r_k L_k,      r = force of a cable over the tension s of the film
 *     dA    = iint ((G x_u - F x_v) . d_u + (E x_v - F x_u) . d_v) / W du dv
 *     n_a   = iint N_a x_u x x_v du dv
 *
 * The force of a cable is the problem's, or by its law
 *
 *     elastic           r = k (L - L0),  k = EA / (s L0)
 *     given length      r = - sum dA . dL / sum dL . dL,  over its points, across the tangents:
 *                       the multiplier with which the film is nearest to rest along the cable
 *
 * so that nothing of the construction's is taken on trust. Where threads are drawn P stands in the place of s A. E, F, G the first fundamental form: the metric form of the gradient, where the construction has
 * the one of cross products. All in scaled coordinates: the first corner at 0, about size 1.
 */
#ifndef TAUT_CERTIFY_FILM_SHEET_H
#define TAUT_CERTIFY_FILM_SHEET_H

#include "core/arena.h"
#include "geometry/grid/table.h"
#include "geometry/nurbs/loop.h"
#include "taut/film.h"

/* Gauss nodes in one direction. Where the film goes around, moves are those of the functions that do
 * (geometry/nurbs/loop.h), m of them; what is measured is the model's own net all the same. */
typedef struct taut_film_nodes {
    taut_table *table; /* order 1; of the arena */
    taut_table *moves; /* the same of the functions that move */
    int period;        /* of these; 0: the film does not go around */
    double *weights;   /* [table->count] */
    double *at;        /* [table->count] */
} taut_film_nodes;

typedef struct taut_film_sheet {
    taut_arena *arena;
    const taut_surface *surface;
    const taut_film_problem *problem;
    int nu, nv;
    int unit; /* points were divided by 2^unit */
    double origin[3];
    double *points; /* [nu][nv][3], scaled */
    double
        tension; /* of the film, in the user's unit; where threads are drawn the larger of their two forces */
    double ratios[4];    /* r of each cable, scaled; 0: no cable */
    double forces[4];    /* of each cable, in the user's unit */
    double stiffness[4]; /* k of elastic cables, scaled; else 0 */
    taut_film_nodes u, v;
    double *still,
        *along;      /* [nv][3]: of the line last laid, what is x and x_u on it as functions of v */
    double *back[3]; /* [nv][3]: what goes back to a line */
} taut_film_sheet;

/* Are forces given along threads, in place of a tension? */
static inline int taut_film_sheet_has_threads(const taut_film_problem *problem)
{
    return problem->force_density[0] > 0 || problem->prestress[0] > 0;
}

/* alpha, beta over the tension at (u, v): P = 1/2 iint alpha |x_u|^2 + beta |x_v|^2 du dv by the surface's own parameters. Of
 * force densities a, b over [0, 1] they are a l / m, b m / l, l and m the ranges of u and v; of a prestress s |X_u x X_v| / |X_u|^2,
 * s |X_u x X_v| / |X_v|^2 on the reference. */
void taut_film_sheet_threads(const taut_film_sheet *sheet, double u, double v, double threads[2]);
/* P over the tension, scaled. */
double taut_film_sheet_stored(const taut_film_sheet *sheet);

/* How a point of the net may move. */
typedef enum taut_film_way {
    TAUT_FILM_STILL,  /* not at all, or with another */
    TAUT_FILM_INSIDE, /* with the film: a point inside, a pole */
    TAUT_FILM_ALONG,  /* with a cable or a slide */
    TAUT_FILM_CORNER  /* a corner that is not held */
} taut_film_way;

/* x, x_u, x_v at a node, scaled. */
typedef struct taut_film_place {
    double u[3], v[3], normal[3]; /* x_u, x_v, x_u x x_v */
    double e, f, g, w;            /* the first fundamental form; W */
    double weight;
} taut_film_place;

/* The length that the problem gives to cable e, in the user's unit; 0 where it gives none. */
double taut_film_sheet_given(const taut_surface *surface, const taut_film_problem *problem, int e);

/* Is edge e a cable? */
static inline int taut_film_sheet_is_cable(const taut_film_sheet *sheet, int e)
{
    return sheet->problem->edges[e].kind == TAUT_FILM_CABLE;
}

/* Is edge e one that the film has, no seam? */
static inline int taut_film_sheet_has_edge(const taut_film_problem *problem, int e)
{
    return problem->ring == TAUT_FILM_OPEN || (problem->ring == TAUT_FILM_RING_U) == (e >= 2);
}

/* Is it kept in its plane? */
static inline int taut_film_sheet_in_plane(const taut_film_edge *edge)
{
    return edge->kind == TAUT_FILM_SLIDE || (edge->kind == TAUT_FILM_CABLE && edge->has_plane);
}

/* The point of the net that function (i, j) of those that move belongs to. */
int taut_film_sheet_owner(const taut_film_sheet *sheet, int i, int j);
/* How point (i, j) moves; *edge: of a line, which. */
taut_film_way taut_film_sheet_way(const taut_film_sheet *sheet, int i, int j, int *edge);
/* The normals of the planes that point (i, j) is kept on, unit and orthogonal: how many. */
int taut_film_sheet_normals(const taut_film_sheet *sheet, int i, int j, double normals[3][3]);

/* The surface is that of the problem. `extra` nodes a span more than functions alive. The arena
 * owns it all. TAUT_NO_MEMORY. */
taut_status taut_film_sheet_new(const taut_surface *surface, const taut_film_problem *problem,
                                int extra, taut_arena *arena, taut_film_sheet *sheet);

/* Lays the line u = const of node a, and node b on it. */
void taut_film_sheet_line(const taut_film_sheet *sheet, int a);
void taut_film_sheet_place(const taut_film_sheet *sheet, int a, int b, taut_film_place *place);

/* Where the points of edge e lie: the first, from one to the next, how many. */
void taut_film_sheet_edge(const taut_film_sheet *sheet, int e, size_t *first, size_t *step,
                          int *count);
/* The point of the net that function k of edge e belongs to. */
static inline int taut_film_sheet_on_edge(const taut_film_sheet *sheet, int e, int k)
{
    return e < 2 ? taut_film_sheet_owner(sheet, e == 1 ? sheet->nu - 1 : 0, k)
                 : taut_film_sheet_owner(sheet, k, e == 3 ? sheet->nv - 1 : 0);
}

/* x_t of edge e at a node of its direction. */
void taut_film_sheet_slope(const taut_film_sheet *sheet, int e, int node, double d[3]);

/* pull double[count][3] = dL of edge e by its functions that move, scaled; returns its length, scaled. */
double taut_film_sheet_pull(const taut_film_sheet *sheet, int e, double *pull);

/* The unit tangent of edge e at the Greville abscissa of its function k. */
void taut_film_sheet_tangent(const taut_film_sheet *sheet, int e, int k, double t[3]);

/* gradient, moments double[nu][nv][3], at the points that own; *area, and lengths of the cables, all scaled. *largest: the
 * largest coordinate of the gradient of the area alone, held points too. */
void taut_film_sheet_gradient(const taut_film_sheet *sheet, double *gradient, double *moments,
                              double *area, double *largest, double lengths[4]);

/* What forces are compared with: the tension, or the larger of the two along the threads. */
double taut_film_threads_tension(const taut_film_problem *problem);
/* Of threads, over a tension: what x_u, x_v by the knots of a surface count with at (u, v). */
void taut_film_threads_of(const taut_film_problem *problem, const taut_surface *surface,
                          double tension, double u, double v, double threads[2]);

#endif /* TAUT_CERTIFY_FILM_SHEET_H */
