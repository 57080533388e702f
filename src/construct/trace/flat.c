#include "construct/trace/flat.h"

#include "construct/trace/details.h"

#include <math.h>

static void add_place(taut_record *list, const char *key, const double at[2], int scale)
{
    const double place[2] = {ldexp(at[0], scale), ldexp(at[1], scale)};
    taut_record_add_numbers(list, key, 2, place);
}

static void add_slots(const taut_net *net, const taut_flat_piece *piece, taut_record *at)
{
    taut_record *list = taut_record_add_list(at, "slots");
    for (int k = 0; k < piece->slot_count; k++) {
        const taut_piece_slot *slot = &piece->slots[k];
        char name[2 * TAUT_LATH_NAME + 8];
        taut_record *one = taut_record_add_object(list, NULL);
        taut_trace_node_name(net, &net->nodes.list[slot->node], name, sizeof name);
        taut_record_add_text(one, "node", name);
        taut_record *corners = taut_record_add_list(one, "outline");
        for (int i = 0; i < 4; i++) {
            add_place(corners, NULL, slot->corners[i], net->carrier->scale);
        }
    }
}

static void add_marks(const taut_flat_piece *piece, int scale, taut_record *at)
{
    taut_record *lines = taut_record_add_list(at, "lines");
    for (int k = 0; k < piece->line_count; k++) {
        taut_record *line = taut_record_add_list(lines, NULL);
        add_place(line, NULL, piece->lines[k].ends[0], scale);
        add_place(line, NULL, piece->lines[k].ends[1], scale);
    }
    taut_record *texts = taut_record_add_list(at, "texts");
    for (int k = 0; k < piece->text_count; k++) {
        const taut_piece_text *text = &piece->texts[k];
        taut_record *one = taut_record_add_object(texts, NULL);
        taut_record_add_text(one, "text", text->text);
        add_place(one, "at", text->at, scale);
        taut_record_add_number(one, "angle", text->angle);
        taut_record_add_number(one, "height", ldexp(text->height, scale));
    }
}

void taut_trace_describe_flat(const taut_net *net, const taut_pieces *pieces, taut_record *details)
{
    const int scale = net->carrier->scale;
    taut_record *sheets = taut_record_add_list(details, "sheets");
    for (int k = 0; k < pieces->sheets; k++) {
        add_place(taut_record_add_object(sheets, NULL), "size", pieces->size, scale);
    }
    taut_record *list = taut_record_add_list(details, "pieces");
    for (int k = 0; k < pieces->count; k++) {
        const taut_flat_piece *piece = &pieces->list[k];
        taut_record *at = taut_record_add_object(list, NULL);
        taut_record_add_text(at, "name", piece->name);
        taut_record_add_text(at, "lath", net->laths[piece->lath].name);
        taut_record_add_number(at, "sheet", piece->sheet + 1);
        taut_record *outline = taut_record_add_list(at, "outline");
        for (int i = 0; i < piece->outline_count; i++) {
            add_place(outline, NULL, piece->outline[i], scale);
        }
        add_slots(net, piece, at);
        add_marks(piece, scale, at);
    }
}
