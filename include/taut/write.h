/* taut/write.h -- models and records out; figures and pages with what taut/draw.h adds.
 *
 * A file's ending says its format. An output appears whole or not at all: it is written beside its
 * place and renamed when all has gone well (a device or pipe is written directly). One set of outputs
 * is for one thread at a time, but for taut_outputs_abandon; several threads may each have their own.
 */
#ifndef TAUT_WRITE_H
#define TAUT_WRITE_H

#include "taut/model.h"
#include "taut/monitor.h"

#include <stddef.h>
#include <stdio.h>

#ifdef __cplusplus
extern "C" {
#endif

/* What can be wrong with a file, and with a model that a format is to hold: word, meaning, remedy.
 */
#define TAUT_FILE_REASON_LIST(X)                                                                   \
    X("read", "a file is not there or cannot be read", "see to the path and its permissions")      \
    X("write", "a file cannot be written", "see to its folder, permissions and room")              \
    X("large", "a file is larger than any document may be", "take it apart")                       \
    X("packed", "a file is packed by gzip", "unpack it, as by gunzip")                             \
    X("format", "the ending of a path is that of no format", "take one that is listed")            \
    X("not-a-file", "the format can be written to nothing else than a regular file",               \
      "write a file")                                                                              \
    X("same-place", "two outputs go to the same place", "give each its own path")                  \
    X("several", "the format holds one model a file, or not so many",                              \
      "write .json, or figures of fewer models")                                                   \
    X("surface", "no surface has the name asked for, or several have it",                          \
      "name one of the model's surfaces")                                                          \
    X("cells", "a grid of more points than a file may have", "ask for a coarser one")              \
    X("no-table", "the model is of no kind that has a table, or its table is empty",               \
      "write another format")                                                                      \
    X("no-drawing", "the model has neither curves nor panels, which is what DXF holds",            \
      "write another format, or `taut panels`")                                                    \
    X("single-precision", "a coordinate is too large for the single precision of the format",      \
      "write .ply or .obj")                                                                        \
    X("single-point",                                                                              \
      "a surface, or an edge of a solid, is one point to readers of STEP: 1e-7 mm",                \
      "leave the surface out or make it longer, or write IGES or JSON")                            \
    X("broken",                                                                                    \
      "not a STEP or IGES file, or one that is cut off or breaks the rules of its format",         \
      "export it again")                                                                           \
    X("trimmed", "faces of a STEP or IGES file are cut by curves within their surfaces",           \
      "read the whole surfaces under them: --untrim")                                              \
    X("claims", "a STEP or IGES file claims to hold more than its size explains",                  \
      "export it again")                                                                           \
    X("library", "OpenCASCADE failed over a file or a model", "try the other of STEP and IGES")    \
    X("process", "OpenCASCADE cannot be started in a process of its own",                          \
      "let the process have more files and children")                                              \
    X("helper", "the program taut-cad is another version's, or none at all",                       \
      "install taut anew, or correct what $TAUT_CAD names")

/* Colour of the surfaces in figures: none, H, K, or how far the parametrisation is from isothermal,
 * sqrt((E-G)^2 + 4 F^2) / (E+G) in [0, 1], 0 where it is; or of a film where its area is how far above
 * the lower bound of its witness, for each unit of area (docs/least.md; figures only); or of a film of force
 * densities what its threads pull with along u (warp) or v (weft), force per width, by the figure `force_density` of
 * its certificate (docs/film.md; figures only); or of the flat pieces of a cutting pattern the principal strain that is larger
 * in size (docs/pattern.md; figures and GLB). */
typedef enum taut_colour {
    TAUT_COLOUR_PLAIN,
    TAUT_COLOUR_MEAN,
    TAUT_COLOUR_GAUSSIAN,
    TAUT_COLOUR_ISOTHERMALITY,
    TAUT_COLOUR_GAP,
    TAUT_COLOUR_WARP,
    TAUT_COLOUR_WEFT,
    TAUT_COLOUR_STRAIN
} taut_colour;

/* Formats beyond the library's own, which another library brings: taut_draw_formats() of taut/draw.h. */
typedef struct taut_formats taut_formats;

/* Zero means default everywhere. */
/* Sheets of paper that plans of flat pieces are printed on. */
typedef enum taut_paper {
    TAUT_PAPER_NONE = 0,
    TAUT_PAPER_A4, /* 210 x 297 mm, either way round */
    TAUT_PAPER_A3  /* 297 x 420 mm */
} taut_paper;

typedef struct taut_write_options {
    double tolerance; /* 0: the format's own (1e-3 of the size for meshes) */
    int divide;  /* meshes and figures: cells per knot span in each direction; 0: by tolerance */
    int threads; /* 0: 1 */
    const char *format;          /* an ending, where the path does not say it; NULL: by the path */
    const taut_formats *formats; /* more formats to write in, such as figures; NULL: none */
    const char *surface;         /* only the surface of this name; NULL: all */
    int short_knots; /* json: nonzero leaves out the outermost two knots, as openNURBS does */
    /* figures */
    taut_colour colour;
    int no_net;   /* 0: control nets, but of pipes, films, traces, patterns; 1: none; -1: all */
    int has_view; /* nonzero: azimuth and elevation in degrees below */
    double view[2];
    const char *title; /* NULL: none */
    int isolines;      /* above 0: lines of equal value of the colour, so many from 0 to the end of
                          its scale; plain: so many lines of equal u and of equal v */
    int reflections; /* above 0: stripes of a room of so many lights, as the surface mirrors them */
    int combs;       /* nonzero: curvature combs along the edges */
    int side_by_side;          /* nonzero: each surface apart; figures show 12 of more */
    int width;                 /* png: pixels across; 0: 1200 */
    const char *const *labels; /* of taut_outputs_models: the title above each, or NULL */
    taut_monitor monitor;
    /* NULL, or where a format that approximates within a proved bound puts it: a length, 0 where
     * all is exact; with a thickness the largest distance between the sides and where they belong, NaN where that is not
     * proved. Other formats leave it alone. */
    double *bound;
    double
        thickness; /* meshes (taut/mesh.h), step, iges: of a sheet, in the model's unit; 0: none */
    int coefficients; /* vtu: nonzero: fields of Bezier cells as coefficients, not as values */
    int reactions;    /* figures: nonzero: arrows, as the cables of a film pull at its supports */
    int column; /* figures: nonzero: 88 mm wide, a paper's column, no letter smaller than 6 point */
    /* pdf, of models with flat pieces to cut: their plan */
    taut_paper tiles; /* 1:1 on sheets of this size to be put together; or on one page */
    double reduction; /* 1:this, of that page; 0: 1:1 */
    int lagrange; /* vtu: nonzero: Lagrange cells through points of the surfaces, in version 1.0 of the format */
} taut_write_options;

/* The library's own formats, i = 0 .. count-1: its ending without the dot, and one line on what it holds. */
TAUT_API int taut_format_count(void);
TAUT_API const char *taut_format_ending(int i);
TAUT_API const char *taut_format_text(int i);
/* Which of them is that of a path by its ending ("-" is json); -1 if none, then *error names those there are.
 */
TAUT_API int taut_format_of(const char *path, taut_error *error);
/* The ending of the format of a path, without the dot, among the library's own and `more` (or NULL): "json" of "-"; NULL if
 * none, then *error names those there are. */
TAUT_API const char *taut_formats_ending(const taut_formats *more, const char *path,
                                         taut_error *error);

/* Several outputs that appear together or not at all. */
typedef struct taut_outputs taut_outputs;
TAUT_API taut_status taut_outputs_new(taut_outputs **outputs);
/* Writes the model beside `path` in the format of its ending; nothing is visible yet.
 * TAUT_BAD_ARGUMENT: no such format or surface, an option out of its range; TAUT_NO_SOLUTION: what
 * the format cannot hold; TAUT_IO; TAUT_NO_MEMORY; TAUT_INTERRUPTED. */
TAUT_API taut_status taut_outputs_model(taut_outputs *outputs, const taut_model *model,
                                        const char *path, const taut_write_options *options,
                                        taut_error *error);
/* Writes several models to one path: as one list (JSON), or side by side (figures: at most
 * TAUT_MODELS_MAX, each at its own scale of length and all at one of colour). TAUT_BAD_ARGUMENT
 * where the format holds one model a file, or not so many. */
enum { TAUT_MODELS_MAX = 12 };
TAUT_API taut_status taut_outputs_models(taut_outputs *outputs, int count,
                                         const taut_model *const *models, const char *path,
                                         const taut_write_options *options, taut_error *error);
/* Writes a record as JSON, or plain text, likewise. */
TAUT_API taut_status taut_outputs_record(taut_outputs *outputs, const taut_record *record,
                                         const char *path, taut_error *error);
TAUT_API taut_status taut_outputs_text(taut_outputs *outputs, const char *text, size_t length,
                                       const char *path, taut_error *error);
/* Puts every output in its place. On failure none that was not yet in place appears. */
TAUT_API taut_status taut_outputs_commit(taut_outputs *outputs, taut_error *error);
/* Frees; what was not committed is removed. NULL is fine. */
TAUT_API void taut_outputs_free(taut_outputs *outputs);
/* Removes what is not yet in place; may be called from a signal handler. */
TAUT_API void taut_outputs_abandon(const taut_outputs *outputs);

/* One model to one path: the above in one call. */
TAUT_API taut_status taut_model_write(const taut_model *model, const char *path,
                                      const taut_write_options *options, taut_error *error);

/* One model into memory, in the format of an ending such as "json" or "svg" (options->format is not
 * read); *text, with a 0 behind its *length bytes, is the caller's, to be freed by taut_text_free.
 * Errors as taut_outputs_model; TAUT_BAD_ARGUMENT also where the format can be written to files only
 * ("not-a-file"). */
TAUT_API taut_status taut_model_write_text(const taut_model *model, const char *format,
                                           const taut_write_options *options, char **text,
                                           size_t *length, taut_error *error);

/* A record as JSON text, two spaces an indent, numbers to 17 digits as needed to read back the
 * same; *text is the caller's, to be freed by taut_text_free. */
TAUT_API taut_status taut_record_write(const taut_record *record, char **text, size_t *length);
TAUT_API void taut_text_free(char *text); /* NULL is fine */

#ifdef __cplusplus
}
#endif
#endif /* TAUT_WRITE_H */
