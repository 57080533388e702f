/* basis.h -- BASIS in documents, from and to. One table of members serves every type: what
 * a type needs and allows is in its ops (basis/basis_ops.h). */
#ifndef TAUT_IO_MODEL_BASIS_H
#define TAUT_IO_MODEL_BASIS_H

#include "core/arena.h"
#include "io/json/in.h"
#include "io/json/out.h"
#include "taut/basis.h"

/* Reads a basis that must serve `functions` control points (> 0). The caller owns *basis. */
taut_status taut_basis_document_read(const taut_json *at, int functions, taut_basis **basis,
                                     taut_error *error);
/* The same; the arena owns it. */
taut_status taut_basis_document_keep(const taut_json *at, int functions, taut_arena *arena,
                                     const taut_basis **basis, taut_error *error);
/* Writes it as an inline object. */
void taut_basis_document_write(taut_json_out *out, const taut_basis *basis);

#endif /* TAUT_IO_MODEL_BASIS_H */
