/* taut/model.h -- what comes out: surfaces, curves, what was decided and what was proved.
 *
 * A model is a container. It owns what is added to it. Calls that take it const are safe from any
 * thread while nobody changes it; those that change it are for one thread at a time.
 */
#ifndef TAUT_MODEL_H
#define TAUT_MODEL_H

#include "taut/certify.h"
#include "taut/curve.h"
#include "taut/record.h"
#include "taut/surface.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct taut_model taut_model;

/* An empty model in "mm", the caller's. TAUT_NO_MEMORY. */
TAUT_API taut_status taut_model_new(taut_model **model);
/* All of it, details and certificate too. TAUT_NO_MEMORY; *copy untouched on failure. */
TAUT_API taut_status taut_model_copy(const taut_model *model, taut_model **copy);
TAUT_API void taut_model_free(taut_model *model); /* NULL is fine */

/* On TAUT_OK the model owns the object; on failure the caller still does. TAUT_NO_MEMORY;
 * TAUT_BAD_ARGUMENT: NULL, or more than TAUT_OBJECTS_MAX. */
TAUT_API taut_status taut_model_add_surface(taut_model *model, taut_surface *surface);
TAUT_API taut_status taut_model_add_curve(taut_model *model, taut_curve *curve);
/* Replace (and free) what was there; NULL removes it. They cannot fail. */
TAUT_API void taut_model_set_details(taut_model *model, taut_record *details);
TAUT_API void taut_model_set_certificate(taut_model *model, taut_certificate *certificate);
/* "mm" (the default), "m", "cm", "in" or "ft"; else TAUT_BAD_INPUT. */
TAUT_API taut_status taut_model_set_unit(taut_model *model, const char *unit);

/* What is in it, i = 0 .. count-1, NULL beyond. Borrowed: it lives as long as the model. */
TAUT_API int taut_model_surface_count(const taut_model *model);
TAUT_API const taut_surface *taut_model_surface(const taut_model *model, int i);
TAUT_API int taut_model_curve_count(const taut_model *model);
TAUT_API const taut_curve *taut_model_curve(const taut_model *model, int i);
TAUT_API const taut_record *taut_model_details(const taut_model *model);          /* or NULL */
TAUT_API const taut_certificate *taut_model_certificate(const taut_model *model); /* or NULL */
TAUT_API const char *taut_model_unit(const taut_model *model);

#ifdef __cplusplus
}
#endif
#endif /* TAUT_MODEL_H */
