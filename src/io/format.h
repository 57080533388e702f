/* format.h -- what one format must provide. */
#ifndef TAUT_IO_FORMAT_H
#define TAUT_IO_FORMAT_H

#include "core/pulse.h"
#include "io/format_list.h"
#include "taut/model.h"
#include "taut/read.h"
#include "taut/write.h"

#include <stdio.h>

typedef struct taut_format_ops {
    /* Writes into an open file; errors of the file itself are seen by the caller as well. options
     * is never NULL, and options->surface names a surface of the model or is NULL. One of this...
     */
    taut_status (*write)(const taut_model *model, const taut_write_options *options, FILE *out,
                         taut_error *error);
    /* Likewise, where a file can hold several models, models_max at most; else NULL. */
    taut_status (*write_many)(int count, const taut_model *const *models,
                              const taut_write_options *options, FILE *out, taut_error *error);
    int models_max;
    /* ...or, for libraries that want a name: writes the file `path`, which is there and empty. */
    taut_status (*write_path)(const taut_model *model, const taut_write_options *options,
                              const char *path, taut_error *error);
    /* Reads a model from a file in this format; NULL where taut does not. options is never NULL; with `edges`, where the format has
     * such, the edges of trimmed faces are curves in place of their surfaces: the last curves, details.edges of them. */
    taut_status (*read)(const char *path, const taut_read_options *options, taut_model **model,
                        taut_error *error);
} taut_format_ops;

#define TAUT_FORMAT_DECLARE(identifier, ending, text)                                              \
    extern const taut_format_ops taut_format_##identifier;
TAUT_FORMAT_LIST(TAUT_FORMAT_DECLARE)

/* A line of a list of formats. */
typedef struct taut_format_row {
    const taut_format_ops *ops;
    const char *ending, *text;
} taut_format_row;
#ifdef TAUT_NO_MODULES /* nobody asks a page what formats hold */
#define TAUT_FORMAT_ROW(identifier, ending, text) {&taut_format_##identifier, ending, ""},
#else
#define TAUT_FORMAT_ROW(identifier, ending, text) {&taut_format_##identifier, ending, text},
#endif

/* A list of another library. What the rows are is known to the library of the same version alone. */
struct taut_formats {
    const char *version; /* TAUT_VERSION; stays first */
    int count;
    const taut_format_row *rows; /* sorted by ending */
};

/* The ops of format i, or NULL. */
const taut_format_ops *taut_format_ops_at(int i);
/* The format of a path among the library's own and `more` (or NULL), as taut_formats_ending has it. */
const taut_format_row *taut_format_find(const taut_formats *more, const char *path,
                                        taut_error *error);

/* A model in a format that taut reads; trimmed faces as options say (NULL: refused). */
taut_status taut_model_format_read(const taut_format_ops *ops, const char *path,
                                   const taut_read_options *options, taut_model **model,
                                   taut_error *error);

/* What is told while a document is read; options may be NULL. */
taut_pulse taut_read_pulse(const taut_read_options *options);

/* Nonzero when options ask for surface i of the model. */
int taut_format_wants(const taut_model *model, const taut_write_options *options, int i);
/* Is options->surface the name of one surface, and are the numbers in their ranges? */
taut_status taut_format_check(const taut_model *model, const taut_write_options *options,
                              taut_error *error);

#endif /* TAUT_IO_FORMAT_H */
