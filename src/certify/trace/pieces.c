#include "certify/trace/pieces.h"

#include "certify/common/verdict.h"
#include "certify/trace/laths.h"
#include "core/elementary/elementary.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* Of areas; of lengths around them, as ends of strips that only bend are on rulings; and of polylines, over the size: twice the
 * tolerance that they are drawn to. */
static const double same_area = 1e-6, askew = 0.25, polyline = 2;

typedef struct box {
    double low[2], high[2], sheet; /* sheet 0: no outline */
    double area, way;              /* of the outline, and how long it is */
    const char *lath, *name;
} box;

static box box_of(const taut_record *piece)
{
    const taut_record *outline = taut_record_get(piece, "outline");
    box b = {.low = {INFINITY, INFINITY},
             .high = {-INFINITY, -INFINITY},
             .sheet = taut_record_number(taut_record_get(piece, "sheet")),
             .lath = taut_record_text(taut_record_get(piece, "lath")),
             .name = taut_record_text(taut_record_get(piece, "name"))};
    const size_t count = taut_record_count(outline);
    for (size_t k = 0; k < count; k++) {
        for (size_t d = 0; d < 2; d++) {
            const double x = taut_record_number(taut_record_at(taut_record_at(outline, k), d));
            b.low[d] = taut_certify_min(b.low[d], x); /* what is no number lies on no sheet */
            b.high[d] = taut_certify_max(b.high[d], x);
        }
    }
    for (size_t k = 0; k < count; k++) {
        const taut_record *from = taut_record_at(outline, k),
                          *to = taut_record_at(outline, (k + 1) % count);
        const double x = taut_record_number(taut_record_at(from, 0)) - b.low[0];
        const double y = taut_record_number(taut_record_at(from, 1)) - b.low[1];
        const double next_x = taut_record_number(taut_record_at(to, 0)) - b.low[0];
        const double next_y = taut_record_number(taut_record_at(to, 1)) - b.low[1];
        b.area += (x * next_y - next_x * y) / 2;
        b.way += taut_hypot(next_x - x, next_y - y);
    }
    b.area = fabs(b.area);
    b.sheet = count >= 3 ? b.sheet : 0;
    return b;
}

/* Is it on a sheet of the list, of the size that the document asks for? */
static int is_on_sheet(const box *b, const taut_record *sheets, const taut_trace_sheet *asked)
{
    const double index = b->sheet - 1;
    if (!(index >= 0) || !(index < (double)taut_record_count(sheets)) || index != floor(index)) {
        return 0;
    }
    const taut_record *size = taut_record_get(taut_record_at(sheets, (size_t)index), "size");
    int is_on = 1;
    for (size_t d = 0; d < 2; d++) {
        const double side = taut_record_number(taut_record_at(size, d));
        is_on &= b->low[d] >= 0 && b->high[d] <= side;
        is_on &= asked == NULL || asked->size[d] == 0 || side == asked->size[d];
    }
    return is_on;
}

static int overlap(const box *a, const box *b)
{
    return a->sheet == b->sheet && a->low[0] < b->high[0] && b->low[0] < a->high[0] &&
           a->low[1] < b->high[1] && b->low[1] < a->high[1];
}

/* Are the pieces of a lath, one after the other, as long and as wide as it is said to be? Outlines of curved ones are polylines,
 * `room` from the band; bands are as large as length times width, and go twice along the length and once more across at each end,
 * which rulings may cross askew. */
static int is_cut(const taut_record *lath, const box *boxes, size_t count, double room)
{
    const double length = taut_record_number(taut_record_get(lath, "cut_length"));
    const double width = taut_record_number(taut_record_get(lath, "width"));
    const char *name = taut_record_text(taut_record_get(lath, "name"));
    double area = 0, way = 0, pieces = 0;

    for (size_t k = 0; k < count; k++) {
        if (strcmp(boxes[k].lath, name) == 0) {
            area += boxes[k].area;
            way += boxes[k].way;
            pieces++;
        }
    }
    const double off = fabs(area - length * width), edges = 2 * (length + pieces * width);
    return off <= same_area * length * width + room * way && way >= (1 - askew) * edges &&
           way <= (1 + askew) * edges;
}

taut_status taut_net_pieces_add(const taut_net_lines *lines, const taut_trace_problem *problem,
                                double tolerance, taut_arena *arena, taut_certificate *certificate)
{
    const taut_record *details = taut_model_details(lines->model);
    const taut_record *pieces = taut_record_get(details, "pieces");
    const taut_record *sheets = taut_record_get(details, "sheets");
    const taut_trace_laths *laths = problem != NULL ? problem->laths : NULL;
    const size_t count = taut_record_count(pieces);
    const char *worst = "";
    taut_claim claim = {.claim = "pattern", .kind = TAUT_EXACT, .limit = 0, .where = ""};
    char where[96];

    if (pieces == NULL && (laths == NULL || !(laths->width > 0))) {
        return TAUT_OK;
    }
    box *boxes = taut_arena_take(arena, count + 1, sizeof *boxes);
    if (boxes == NULL) {
        return TAUT_NO_MEMORY;
    }
    for (size_t i = 0; i < count; i++) {
        boxes[i] = box_of(taut_record_at(pieces, i));
        int is_wrong = !is_on_sheet(&boxes[i], sheets, problem != NULL ? problem->sheet : NULL);
        for (size_t k = 0; k < i; k++) {
            is_wrong |= overlap(&boxes[k], &boxes[i]);
        }
        claim.residual += is_wrong;
        worst = is_wrong && worst[0] == '\0' ? boxes[i].name : worst;
    }
    for (int k = 0; k < lines->count; k++) {
        const char *name = taut_curve_name(lines->lines[k].space);
        const taut_record *lath = taut_net_lath_of(lines, &lines->lines[k]);
        const int is_wrong = !is_cut(lath, boxes, count, polyline * tolerance * lines->size) ||
                             (laths != NULL && !taut_net_lath_is_asked(lath, laths));
        claim.residual += is_wrong;
        worst = is_wrong && worst[0] == '\0' ? name : worst;
    }
    snprintf(where, sizeof where, "%.60s", worst);
    claim.where = where;
    claim.holds = taut_certify_below(claim.residual, 0);
    return taut_certificate_add(certificate, &claim);
}
