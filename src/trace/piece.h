/* piece.h -- the flat pieces that laths are cut from, placed on sheets.
 *
 *     a band of the strip's width along the axis of its pattern, split where it is longer than a sheet
 *     its slots, straight and square to the axis, half as deep as it is wide
 *     marks: its name at both ends, the names of the laths that cross, an arrow to its end
 */
#ifndef TAUT_TRACE_PIECE_H
#define TAUT_TRACE_PIECE_H

#include "trace/strip.h"

enum { TAUT_PIECE_NAME = TAUT_LATH_NAME + 12, TAUT_PIECE_TEXT = TAUT_PIECE_NAME };

typedef struct taut_piece_text {
    char text[TAUT_PIECE_TEXT];
    double at[2], angle, height; /* at: its middle */
} taut_piece_text;

typedef struct taut_piece_slot {
    int node; /* of the net's */
    double corners[4][2];
} taut_piece_slot;

typedef struct taut_piece_line {
    double ends[2][2];
} taut_piece_line;

typedef struct taut_flat_piece {
    char name[TAUT_PIECE_NAME]; /* that of the lath, or A3/1, A3/2 */
    int lath, sheet;            /* sheet: from 0 */
    double (*outline)[2];       /* closed */
    int outline_count;
    taut_piece_slot *slots;
    int slot_count;
    taut_piece_line *lines; /* engraved */
    int line_count;
    taut_piece_text *texts;
    int text_count;
} taut_flat_piece;

typedef struct taut_pieces {
    taut_flat_piece *list;
    int count, sheets;
    double size[2]; /* of a sheet */
} taut_pieces;

/* In the net's arena; the laths have a width. gap: in the document's unit; tolerance: of curved
 * outlines, over the size. TAUT_NO_MEMORY; TAUT_NO_SOLUTION, reason "sheet". */
taut_status taut_pieces_new(const taut_net *net, const taut_strip *strips, double gap,
                            double tolerance, taut_pieces *pieces, taut_error *error);

#endif /* TAUT_TRACE_PIECE_H */
