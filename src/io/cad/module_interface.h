/* module_interface.h -- what the module `occt` does for CAD formats: NURBS from STEP and IGES files,
 * and to IGES files.
 *
 * Its functions run in a process of their own (io/cad/child.h), so that a file that brings the
 * library down, or makes it take all memory, costs no more than a message. Nothing of taut is
 * linked into the module.
 */
#ifndef TAUT_IO_CAD_MODULE_INTERFACE_H
#define TAUT_IO_CAD_MODULE_INTERFACE_H

#include "taut/status.h"

#ifdef __cplusplus
extern "C" {
#endif

/* What is to be said of an item that was read: the face is only part of this surface; the surface
 * is of a kind that has no NURBS of its own. */
enum { TAUT_CAD_TRIMMED = 1, TAUT_CAD_APPROXIMATE = 2 };

/* A surface, or a curve: then count[1] is 0 and so is all that belongs to it. */
typedef struct taut_cad_item {
    const char *name; /* UTF-8, "" if none */
    int degree[2], count[2];
    const double *knots[2]; /* double[count + degree + 1], clamped */
    const double *points; /* double[count[0]][count[1]][3], u slowest; curve: double[count[0]][3] */
    const double *weights; /* positive, or NULL */
    int notes;             /* read: TAUT_CAD_TRIMMED, TAUT_CAD_APPROXIMATE */
} taut_cad_item;

typedef enum taut_cad_kind { TAUT_CAD_STEP, TAUT_CAD_IGES } taut_cad_kind;

typedef struct taut_cad_job {
    taut_cad_kind kind;
    const char *path;
    /* writing, IGES only */
    const char *unit;         /* mm, m, cm, in, ft */
    const char *name;         /* of the file */
    const char *const *notes; /* [note_count] lines for the file's header, plain ASCII */
    int note_count;
    const char *date; /* "2026-03-01T12:00:00" */
    double precision; /* > 0, a length: what the file states as its uncertainty */
} taut_cad_job;

/* Where a reader puts what it finds; each returns 0 to stop. */
typedef struct taut_cad_sink {
    void *context;
    int (*unit)(void *context, const char *unit);
    int (*item)(void *context, const taut_cad_item *item);
} taut_cad_sink;

/* No C++ exception leaves them; *error is filled on failure. */
typedef struct taut_cad_ops {
    /* Degrees are at most 25, the most that OpenCASCADE has; IGES. TAUT_IO. */
    taut_status (*write)(const taut_cad_job *job, int count, const taut_cad_item *items,
                         taut_error *error);
    /* TAUT_BAD_INPUT: not a file of this kind, or nothing in it. */
    taut_status (*read)(const taut_cad_job *job, const taut_cad_sink *sink, taut_error *error);
} taut_cad_ops;

#ifdef __cplusplus
}
#endif
#endif /* TAUT_IO_CAD_MODULE_INTERFACE_H */
