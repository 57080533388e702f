/* energy.h -- the energy of a film of many patches, and its first and second derivatives by nodes.
 *
 *     E / s = sum (s_i / s) A_i, or P_i / s of threads, + sum C_k - sum p_c V_c,    s the tension of the first patch; cells of given pressure; C_k as laws.h
 *     H     is that of E + sum r_k L_k - sum p_c V_c over given lengths and all cells, without the k dL dL' of springs
 *     B     = (1 - theta) H + theta L             of construct/plateau/area.h and cable.h, summed over the sheets
 *           = H + theta diag(L)                   of theta from 0 to 1e-3: a shift that turns no move within a sheet into one across it
 */
#ifndef TAUT_CONSTRUCT_FILM_COMPLEX_ENERGY_H
#define TAUT_CONSTRUCT_FILM_COMPLEX_ENERGY_H

#include "construct/film/complex/layout.h"
#include "construct/plateau/density.h"
#include "construct/plateau/elements.h"
#include "core/crew.h"
#include "numeric/sparse.h"

typedef struct taut_film_energy {
    const taut_film_layout *layout;
    taut_pulse *pulse;                 /* or NULL */
    taut_arena *arena;                 /* of one rule */
    taut_area_functional **areas;      /* [patch_count] */
    const taut_area_functional **seen; /* the same, to be read */
    taut_area_elements *elements;
    taut_area_density *densities; /* [patch_count]: of patches of threads */
    unsigned char *threads;       /* [nodes]: is it one of such a patch? All its moves are seen */
    double *shares;               /* [patch_count]: s_i / s */
    taut_area_cable *cables;      /* [strand_count] */
    double *forces;  /* [rope_count]: of given lengths what H is to take, else of the last value */
    double *lengths; /* [rope_count]: of the last value */
    double **stretches; /* [rope_count]: [nodes][3], dL of the last gradient; NULL: a given force */
    double soft;        /* above 0: cables are as they begin (laws.h) */
    double *pressures;  /* [cell_count]: of given volumes what H is to take */
    double *volumes;    /* [cell_count]: of the last value */
    double *swells;     /* [cell_count][nodes][3]: dV of the last gradient */
    double **
        places; /* [patch_count]: construct/film/complex/volume.h; of sides of cells those of the last value */
    unsigned char *in_cells; /* [patch_count]: is it a side? */
    double *pull,
        *lever; /* [patch_count], [patch_count][3]: sum of +-p_c / share, +-p_c from_c / share */
    double *rows, *bulge, *moments; /* scratch */
    double *net, *slopes;           /* [points][3]: patch by patch */
    unsigned char *size;            /* [nodes]: how many directions are free */
    double *free;                   /* [nodes][3][3]: these, unit and orthogonal */
    unsigned char *all_size,
        *seen_size; /* what size, free and sparse are: all, or what is seen (ways.h) */
    double *all_free, *seen_free;
    taut_sparse *all_sparse, *seen_sparse;
    int *start, *column;     /* blocks (a, b), b <= a, of row a: column[start[a]] .. */
    double *second, *metric; /* [blocks][9], [blocks] */
    taut_sparse *sparse;
    double theta;
    double least; /* of the last value: smallest W over its mean, of all patches */
} taut_film_energy;

/* extra nodes a span. The energy's arena is its own. TAUT_NO_MEMORY. */
taut_status taut_film_energy_new(const taut_film_layout *layout, int extra, const taut_crew *crew,
                                 taut_film_energy **energy);
void taut_film_energy_free(taut_film_energy *energy); /* NULL is fine */

/* x double[nodes][3], scaled; gradient of the same shape, at held nodes too, or NULL. scales double[nodes], or
 * NULL: the largest coordinate of a derivative of the sheets that meet in a node, each alone, and before cables add to it. */
double taut_film_energy_value(taut_film_energy *energy, const double *x, double *gradient,
                              double *scales);
/* H and L at the x of the last gradient. TAUT_INTERRUPTED as the pulse says. */
taut_status taut_film_energy_second(taut_film_energy *energy);
/* From now on all that is free counts, or, narrow, the moves that are seen at the x of the last value alone. TAUT_NO_MEMORY. */
taut_status taut_film_energy_narrow(taut_film_energy *energy, int narrow);
/* The factor of B; *negative as of taut_sparse_factor. */
taut_status taut_film_energy_factor(taut_film_energy *energy, double theta, int *negative);
/* d = B^-1 c along what is free. c, d double[nodes][3]. right: scratch of as many rows as B has. */
void taut_film_energy_solve(const taut_film_energy *energy, const double *c, double *right,
                            double *d);

#endif /* TAUT_CONSTRUCT_FILM_COMPLEX_ENERGY_H */
