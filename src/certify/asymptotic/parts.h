/* parts.h -- the parts of the certificate of `asymptotic`. */
#ifndef TAUT_CERTIFY_ASYMPTOTIC_PARTS_H
#define TAUT_CERTIFY_ASYMPTOTIC_PARTS_H

#include "taut/asymptotic.h"

enum { TAUT_EDGE_SAMPLES = 201, TAUT_PLACE_TEXT = 96 };

/* The model's patch and its four curves in the order v0, u0, v1, u1; borrowed. */
typedef struct taut_asymptotic_model {
    const taut_surface *patch;
    const taut_curve *curves[4];
    /* Largest coordinates, absolute values, of the control points that rounding noise is judged by:
     * of the two rows along each edge, and of the curves. */
    double row_size[4], curve_size;
} taut_asymptotic_model;

/* What the edges show. */
typedef struct taut_edge_proof {
    double sampled;    /* largest |k_n| at the samples, singular points left out */
    double bound;      /* that |k_n| does not exceed on the share `covered` of the edge */
    double covered;    /* 1 unless the edge is singular */
    double osculating; /* largest sine between N and b at the samples, inflections left out; -1 on
                        * a straight edge */
    double sine_bound; /* that the sine between N and the edge's own b does not exceed there */
    double least_sine; /* between R_u and R_v at the samples */
    double noise;      /* k_n that rounding of the control points explains */
    double noise_sine; /* the same over the curvature there: of the sine */
    double given, given_sine; /* the same that the curves alone explain, by how well they meet */
    double at;                /* of the largest k_n */
    double sine_at;           /* of the largest sine */
    int singular;             /* samples at which the surface has no normal */
} taut_edge_proof;

/* Is the distance of its control points from its chord nothing but rounding? */
int taut_edge_on_chord(const taut_asymptotic_model *model, int edge);

/* What the curves at the two ends of an edge leave between R_c and the osculating plane: parts that
 * go with the first and second Bernstein function from there. */
typedef struct taut_edge_data {
    double plane[2], twist[2];
} taut_edge_data;
taut_edge_data taut_edge_data_of(const taut_asymptotic_model *model, int edge);
/* The length off the plane at t for a patch of degree m along the edge, end weights 1 over W. */
double taut_edge_data_at(const taut_edge_data *data, int m, double t);

/* TAUT_NO_MEMORY. */
taut_status taut_edge_prove(const taut_asymptotic_model *model, int edge, taut_edge_proof *proof);

/* Largest distance of the model from the given data, over its size, that is seen; a bound of it at
 * every parameter; and what rounding explains of it. With problem NULL only the patch is held
 * against the model's curves. `where`: which datum. */
void taut_boundary_distance(const taut_asymptotic_model *model,
                            const taut_asymptotic_problem *problem, double *distance, double *bound,
                            double *noise, char where[TAUT_PLACE_TEXT]);

/* Parameters of sample k of an edge. */
static inline void taut_edge_parameters(int edge, double t, double *u, double *v)
{
    *u = edge % 2 == 0 ? t : edge >= 2;
    *v = edge % 2 == 0 ? edge >= 2 : t;
}

#endif /* TAUT_CERTIFY_ASYMPTOTIC_PARTS_H */
