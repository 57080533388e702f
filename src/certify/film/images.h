/* images.h -- the copies of a film, each as a product of mirrors.
 *
 *     mirror               M(n, c):  x - 2 (n . x - c) n
 *     turn by a about d    M in the plane through the axis, then M in that plane turned by a / 2
 *     translation by v     M in a plane across v, then M in that plane moved by v / 2
 *
 * The construction has other formulas. */
#ifndef TAUT_CERTIFY_FILM_IMAGES_H
#define TAUT_CERTIFY_FILM_IMAGES_H

#include "certify/common/identity.h"
#include "taut/film.h"

/* The claim `images`, exact: the largest distance of a point of a copy from the image of the film's, over the size of both; 64
 * 2^-53 for each map. names[patches]: of the film's surfaces. Nothing where there are no images. */
taut_status taut_film_images_certify(const taut_model *model, const taut_film_problem *problem,
                                     int patches, const char *const *names,
                                     taut_certificate *certificate, taut_error *error);
/* What is to be there of one surface of the film. */
void taut_film_images_identify(const taut_film_problem *problem, const char *name,
                               const taut_expected_basis *u, const taut_expected_basis *v,
                               taut_identity *identity);

#endif /* TAUT_CERTIFY_FILM_IMAGES_H */
