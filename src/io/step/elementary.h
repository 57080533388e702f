/* elementary.h -- surfaces that CAD systems have names for: discs, cylinders, bends of a round pipe; discs and rings between
 * ellipses.
 *
 * They are told by their nets. All are swept from a ring, a circle as nine points and the weights 1 and
 * sqrt(1/2) in turns: moved along its axis (cylinder), shrunk within its plane, to its centre or not
 * (plane), or turned about a line in its plane by less than a half turn (torus; three points, or three and
 * two more, along the arc). A ring in a plane may be an affine image of a circle. A net is one of these where it is the exact net of it but for the rounding of
 * its coordinates: a surface is then as near to the other as its points are.
 */
#ifndef TAUT_IO_STEP_ELEMENTARY_H
#define TAUT_IO_STEP_ELEMENTARY_H

#include "io/step/part21.h"
#include "taut/surface.h"

typedef enum taut_step_kind {
    TAUT_STEP_SPLINE = 0,
    TAUT_STEP_PLANE,
    TAUT_STEP_CYLINDER,
    TAUT_STEP_TORUS
} taut_step_kind;

/* A circle from ahead on, the way that ahead x aside goes about the axis; or an ellipse, whose half diameters along ahead and aside,
 * which are conjugate, are not alike or not across each other. */
typedef struct taut_step_ring {
    double centre[3], ahead[3], aside[3]; /* both unit */
    double radius, other;                 /* along ahead, along aside; 0: a point */
} taut_step_ring;

typedef struct taut_step_form {
    taut_step_kind kind;
    int around;              /* rings run along 0 u, 1 v */
    taut_step_ring rings[2]; /* at the beginning and the end of the other direction */
    double origin[3], axis[3], ahead[3];
    int is_round;  /* its rings are circles */
    double radius; /* of the arc, TAUT_STEP_TORUS */
    int inwards;   /* du x dv points against the normal of the form: inwards, or against the axis */
    double distance; /* from the surface, a bound */
} taut_step_form;

/* What the surface is, TAUT_STEP_SPLINE if none of these. */
void taut_step_recognise(const taut_surface *surface, taut_step_form *form);

/* The surface; the curve of edge 0..3 of the surface, in the edge's sense, of one that is round. */
size_t taut_step_put_form(taut_part21 *out, const taut_step_form *form);
size_t taut_step_put_form_edge(taut_part21 *out, const taut_step_form *form,
                               const taut_surface *surface, int edge);

/* Does edge 0..3 run around? The others are the seam. */
static inline int taut_step_is_ring(const taut_step_form *form, int edge)
{
    return (edge < 2) == (form->around == 1);
}

#endif /* TAUT_IO_STEP_ELEMENTARY_H */
