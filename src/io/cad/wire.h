/* wire.h -- what libtaut and taut-cad say to each other: NURBS from STEP and IGES files, and to IGES files.
 *
 * taut-cad is a program of its own around OpenCASCADE (cad/), so that a file that brings the library down, or makes it
 * take all memory, costs no more than a message. A request is its standard input, a file; the answer its standard output,
 * a pipe:
 *
 *     request   hello, job, items        answer   hello, then  'U' unit[4]   'I' item   'N' size, text (what was left out)
 *                                                              'P' size, text (the product that is the whole of an assembly)
 *                                                              'T' size, text (of an IGES file)   'E' status, message: the end
 *
 * Numbers are as the machine has them: both run on the same one, and the hello says how they lie. This file and
 * wire.c are part of both; nothing else is.
 */
#ifndef TAUT_IO_CAD_WIRE_H
#define TAUT_IO_CAD_WIRE_H

#include "taut/status.h"

#include <stdio.h>

#ifdef __cplusplus
extern "C" {
#endif

/* What is to be said of an item that was read: the face is only part of this surface; the surface
 * is of a kind that has no NURBS of its own; the curve is an edge of a trimmed face. */
enum { TAUT_CAD_TRIMMED = 1, TAUT_CAD_APPROXIMATE = 2, TAUT_CAD_EDGE = 4 };

/* A surface, or a curve: then count[1] is 0 and so is all that belongs to it. */
typedef struct taut_cad_item {
    const char *name; /* UTF-8, "" if none */
    int degree[2], count[2];
    const double *knots[2]; /* double[count + degree + 1], clamped */
    const double *points; /* double[count[0]][count[1]][3], u slowest; curve: double[count[0]][3] */
    const double *weights; /* positive, or NULL */
    int notes;             /* read: TAUT_CAD_TRIMMED, TAUT_CAD_APPROXIMATE */
    const char *product;   /* read: of what it is a part, UTF-8; "" or NULL if nothing says so */
    int colour;            /* read: 0, or 1 + 0xRRGGBB */
    int instance; /* read: surfaces: of which use of a product it is a part, numbered as they appear */
    double place[12]; /* read: where that use has its product: the rows of (A | b), x -> A x + b */
} taut_cad_item;

/* What stands before the name, the product and the numbers of an item. */
typedef struct taut_cad_item_head {
    int degree[2], count[2], is_rational, notes;
    int name_length, product_length, colour, instance;
    double place[12];
} taut_cad_item_head;

typedef enum taut_cad_kind { TAUT_CAD_STEP, TAUT_CAD_IGES } taut_cad_kind;

/* A file to read; or, with items, one to write: IGES, its text is the answer. */
typedef struct taut_cad_job {
    taut_cad_kind kind;
    const char *path; /* reading */
    int edges; /* reading: nonzero: of faces that are trimmed, their edges in place of their surfaces, after all other curves */
    /* writing */
    const char *unit;         /* mm, m, cm, in, ft */
    const char *name;         /* of the file */
    const char *const *notes; /* [note_count] lines for the file's header, plain ASCII */
    int note_count;
    const char *date; /* "2026-03-01T12:00:00" */
    double precision; /* > 0, a length: what the file states as its uncertainty */
} taut_cad_job;

/* What stands first, both ways. A version changes with what is said, the layout with compilers. */
enum {
    TAUT_CAD_VERSION = 6,
    TAUT_CAD_MARK = 8,
    TAUT_CAD_UNIT = 4,
    TAUT_CAD_TEXT_MAX = 1 << 15,
    TAUT_CAD_NOTE_MAX = 400
};
typedef struct taut_cad_hello {
    char mark[TAUT_CAD_MARK];
    unsigned version, layout;
} taut_cad_hello;

/* The hello of a request, and that of an answer: a program that repeats what it is told is no taut-cad. */
taut_cad_hello taut_cad_hello_request(void);
taut_cad_hello taut_cad_hello_answer(void);

/* Seconds of processor time and bytes of memory, above its own, that taut-cad takes for a file or a request of `size`
 * bytes, at most: what a library of its size needs, and what a file may be blown up to. */
double taut_cad_seconds(double size);
double taut_cad_memory(double size);

/* Numbers of an item: in a row of direction d, and points in all. */
size_t taut_cad_knot_count(const taut_cad_item_head *head, int d);
size_t taut_cad_point_count(const taut_cad_item_head *head);

/* Each is 0 when the file takes no more. */
int taut_cad_put_hello(FILE *file, taut_cad_hello hello);
int taut_cad_put_request(FILE *file, const taut_cad_job *job, int count,
                         const taut_cad_item *items);
int taut_cad_put_unit(FILE *file, const char *unit);
int taut_cad_put_item(FILE *file, const taut_cad_item *item);
/* A name of at most TAUT_NAME_MAX bytes; what is beyond is cut off. */
int taut_cad_put_product(FILE *file, const char *name);
/* A sentence of at most TAUT_CAD_NOTE_MAX bytes; what is beyond is cut off. */
int taut_cad_put_note(FILE *file, const char *note);
int taut_cad_put_text(FILE *file, const char *text, size_t length);
int taut_cad_put_end(FILE *file, taut_status status, const taut_error *error);

#ifdef __cplusplus
}
#endif
#endif /* TAUT_IO_CAD_WIRE_H */
