/* complex.h -- the certificate of films of many patches. */
#ifndef TAUT_CERTIFY_FILM_COMPLEX_COMPLEX_H
#define TAUT_CERTIFY_FILM_COMPLEX_COMPLEX_H

#include "certify/common/identity.h"
#include "core/crew.h"
#include "taut/film.h"

/* As taut_certify_ops, of a problem with patches. The status has no meaning where the pulse was answered by an end. */
taut_status taut_film_complex_certify(const taut_model *model, const taut_film_problem *problem,
                                      const taut_crew *crew, taut_certificate *certificate,
                                      taut_error *error);
void taut_film_complex_identify(const taut_film_problem *problem, taut_identity *identity);

#endif /* TAUT_CERTIFY_FILM_COMPLEX_COMPLEX_H */
