/* part21.h -- the clear text of ISO 10303-21: instances "#7=NAME(...);", reals, strings, lists.
 *
 *     real      the shortest decimal that reads back as the same double, with the point that the
 *               grammar wants: "2.", "1.5E-7"
 *     string    in quotes; ' and \ doubled, or ' as \X\27; control characters \X\0A; what is beyond ASCII as
 *               \X2\00E4\X0\ and, above U+FFFF, \X4\0001F600\X0\; what is no UTF-8 as ?
 *
 * Instances are numbered as they are written. Lines are broken between the members of lists. A
 * failure of the sink sticks.
 */
#ifndef TAUT_IO_STEP_PART21_H
#define TAUT_IO_STEP_PART21_H

#include "io/file/sink.h"

typedef struct taut_part21 {
    taut_sink sink;
    size_t count; /* instances so far: the number of the last one */
    size_t column;
} taut_part21;

/* What a % in a format stands for. */
typedef enum taut_part21_kind {
    PART21_REF,    /* #7 */
    PART21_NUMBER, /* 7 */
    PART21_REAL,   /* 7. */
    PART21_TEXT,   /* 'seven' */
    PART21_WORD,   /* as it is: a keyword, .T. */
    PART21_REFS,   /* (#1,#2), count of them from refs */
    PART21_RUN,    /* (#1,#4,#7), from ref by step */
    PART21_GRID, /* ((#1,#2),(#4,#5)), count rows of across, from ref on, each step after the last */
    PART21_REALS, /* (1.,2.), from reals by step */
    PART21_TABLE, /* ((1.,2.),(3.,4.)) */
    PART21_KNOTS, /* (0.,1.), the distinct ones of count */
    PART21_TIMES  /* (4,4), how often each is there; the ends once more than in reals */
} taut_part21_kind;

typedef struct taut_part21_value {
    taut_part21_kind kind;
    size_t ref, step, count, across;
    const size_t *refs;
    const double *reals;
    double real;
    const char *text;
} taut_part21_value;

#define TAUT_REF(at) ((taut_part21_value){.kind = PART21_REF, .ref = (at)})
#define TAUT_NUMBER(n) ((taut_part21_value){.kind = PART21_NUMBER, .count = (size_t)(n)})
#define TAUT_REAL(x) ((taut_part21_value){.kind = PART21_REAL, .real = (x)})
#define TAUT_TEXT(t) ((taut_part21_value){.kind = PART21_TEXT, .text = (t)})
#define TAUT_WORD(t) ((taut_part21_value){.kind = PART21_WORD, .text = (t)})
#define TAUT_REFS(n, at) ((taut_part21_value){.kind = PART21_REFS, .count = (n), .refs = (at)})
#define TAUT_REALS(n, at, by)                                                                      \
    ((taut_part21_value){.kind = PART21_REALS, .count = (n), .reals = (at), .step = (by)})
#define TAUT_KNOTS(n, at) ((taut_part21_value){.kind = PART21_KNOTS, .count = (n), .reals = (at)})
#define TAUT_TIMES(n, at) ((taut_part21_value){.kind = PART21_TIMES, .count = (n), .reals = (at)})
#define TAUT_TRUTH(is) TAUT_WORD((is) ? ".T." : ".F.")

/* Text with values in the place of each %. */
void taut_part21_put(taut_part21 *out, const char *format, const taut_part21_value *values);
/* The same as an instance, whose number is returned. */
size_t taut_part21_new(taut_part21 *out, const char *format, const taut_part21_value *values);

/* taut_part21_new(out, "LINE('',%,%)", point, vector), values made as above. */
#define TAUT_NEW(out, format, ...)                                                                 \
    taut_part21_new((out), (format), (const taut_part21_value[]){__VA_ARGS__})

#endif /* TAUT_IO_STEP_PART21_H */
