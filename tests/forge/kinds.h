/* kinds.h -- the ways to forge that stand in files of their own; kinds.c has the others and the list. */
#ifndef TAUT_TEST_FORGE_KINDS_H
#define TAUT_TEST_FORGE_KINDS_H

#include "edit.h"

/* The same shape told otherwise, or a part of it: described.c. */
void forge_part(edit_model *edit, const forge_base *base, const forge_base *other,
                forge_random *random);
void forge_transposed(edit_model *edit, const forge_base *base, const forge_base *other,
                      forge_random *random);
void forge_mirrored(edit_model *edit, const forge_base *base, const forge_base *other,
                    forge_random *random);
void forge_scaled(edit_model *edit, const forge_base *base, const forge_base *other,
                  forge_random *random);
void forge_curve_parameters(edit_model *edit, const forge_base *base, const forge_base *other,
                            forge_random *random);
void forge_backwards(edit_model *edit, const forge_base *base, const forge_base *other,
                     forge_random *random);
void forge_far_weights(edit_model *edit, const forge_base *base, const forge_base *other,
                       forge_random *random);

/* The dual function that a film's proof goes by: witness.c. */
void forge_witness(edit_model *edit, const forge_base *base, const forge_base *other,
                   forge_random *random);

#endif /* TAUT_TEST_FORGE_KINDS_H */
