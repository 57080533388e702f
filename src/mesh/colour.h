/* colour.h -- the colours of figures, pages and meshes: a diverging map for curvature, a palette,
 * shading. */
#ifndef TAUT_MESH_COLOUR_H
#define TAUT_MESH_COLOUR_H

#include "taut/model.h"

#include <stddef.h>

typedef struct taut_ink {
    unsigned char r, g, b;
} taut_ink;

/* The map, t in [-1, 1] (cut off outside; NaN gives grey): blue below 0, near white at 0, red
 * above. Along each arm CIELAB lightness falls linearly and alike, so that equal steps look equal
 * and the two signs weigh the same; blue and orange-red are told apart by every common colour
 * vision. */
taut_ink taut_colour_diverging(double t);

/* The i-th plain surface colour; they repeat. From TAUT_COLOUR_OWN on it is the colour 0xRRGGBB beyond it. */
enum { TAUT_COLOUR_OWN = 1 << 24 };
taut_ink taut_colour_plain(int i);

/* Which plain or curve colour thing i of a model takes: things whose names differ in their number
 * only ("blend1", "blend2"; "film", its image "film'3"; "a.u0", "b.u1") share one, in the order in which they appear; what is called pipe is
 * the first colour and what is called blend the second, in every model. Things without a name, or
 * of a number alone, take one each. name(of, i): never NULL. */
int taut_colour_group(const char *(*name)(const void *of, int i), const void *of, int count, int i);

/* TAUT_COLOUR_OWN and the colour that the file had for surface i that the model was read from, details.colours; else -1. */
int taut_colour_said(const taut_model *model, int i);

/* The colour of surface i, its own or that of its group, and of curve i, of a model. */
int taut_colour_of_surface(const taut_model *model, int i);
int taut_colour_of_curve(const taut_model *model, int i);

/* The i-th curve colour; they repeat. */
taut_ink taut_colour_curve(int i);

/* The colour of a piece of surface under soft light, from any normal towards the viewer in the
 * frame of the camera (right, up, eye), not 0. strength 0..1: how much light changes it. */
taut_ink taut_colour_shade(taut_ink ink, const double normal[3], double strength);

/* a + t (b - a), t in [0, 1] */
taut_ink taut_colour_mix(taut_ink a, taut_ink b, double t);

/* The range [-limit, limit] that the map is to show for these values (NaN: none). It holds all of
 * them, unless a few stand far out: then `*cut` is 1. Never below `noise` (> 0), so that rounding
 * does not show as colour. */
double taut_colour_limit(size_t count, double *values, double noise, int *cut);

/* The limit; *sign 1: no value is below 0, -1: none above it, but for rounding (noise, or what no shade of the map shows, 1/256 of
 * the limit); 0: there are both, or nothing but noise. Values of one sign need one arm of the map only. */
double taut_colour_range(size_t count, double *values, double noise, int *cut, int *sign);

#endif /* TAUT_MESH_COLOUR_H */
