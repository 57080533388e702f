#include "io/csv/table.h"

static const taut_csv_column cables[] = {
    {.title = "edge", .member = {"edge"}},
    {.title = "force", .member = {"force"}},
    {.title = "length", .member = {"length"}},
    {.title = "unstressed_length", .member = {"unstressed"}},
    {.title = NULL},
};

static const taut_csv_column laths[] = {
    {.title = "name", .member = {"name"}},
    {.title = "family", .member = {"family"}},
    {.title = "length", .member = {"length"}},
    {.title = "cut_length", .member = {"cut_length"}},
    {.title = "width", .member = {"width"}},
    {.title = "thickness", .member = {"thickness"}},
    {.title = "least_radius", .member = {"least_radius"}},
    {.title = "twist", .member = {"twist"}},
    {.title = "use", .member = {"stress/use"}},
    {.title = "nodes", .member = {"nodes"}, .cell = TAUT_CSV_TEXTS},
    {.title = NULL},
};

/* Of cut cloth: pieces, seams and the roll. Columns of pieces come first, where those who read by their number look for them. */
static const taut_csv_column cloth[] = {
    {.title = "name", .member = {"name", "name"}},
    {.title = "along", .member = {"extent/0"}},
    {.title = "across", .member = {"extent/1"}},
    {.title = "area", .member = {"area"}},
    {.title = "flat_area", .member = {"flat_area"}},
    {.title = "cut_area", .member = {"cut_area"}},
    {.title = "least_strain", .member = {"strain/min"}},
    {.title = "largest_strain", .member = {"strain/max"}},
    {.title = "right", .member = {"edges/right/seam"}},
    {.title = "right_length", .member = {"edges/right/length"}},
    {.title = "right_flat_length", .member = {"edges/right/flat_length"}},
    {.title = "end_flat_length", .member = {"edges/end/flat_length"}},
    {.title = "left", .member = {"edges/left/seam"}},
    {.title = "left_length", .member = {"edges/left/length"}},
    {.title = "left_flat_length", .member = {"edges/left/flat_length"}},
    {.title = "start_flat_length", .member = {"edges/start/flat_length"}},
    {.title = "kind", .cell = TAUT_CSV_KIND},
    {.title = "pieces", .member = {NULL, "pieces"}, .cell = TAUT_CSV_TEXTS},
    {.title = "length", .member = {NULL, "length", "length"}},
    {.title = "flat_length", .member = {NULL, "flat_length"}},
    {.title = "least_stretch", .member = {NULL, "stretch/0"}},
    {.title = "largest_stretch", .member = {NULL, "stretch/1"}},
    {.title = "disagreement", .member = {NULL, "disagreement"}},
    {.title = "width", .member = {NULL, NULL, "width"}},
    {.title = "gap", .member = {NULL, NULL, "gap"}},
    {.title = "waste", .member = {NULL, NULL, "waste"}},
    {.title = NULL},
};

static const taut_csv_kind kinds[] = {
    {.list = {"cables"}, .columns = cables},
    {.list = {"laths"}, .columns = laths},
    {.list = {"pieces", "seams", "roll"}, .word = {"piece", "seam", "roll"}, .columns = cloth}};

const taut_csv_kind *taut_csv_table(const taut_model *model)
{
    const taut_record *details = taut_model_details(model);

    for (size_t k = 0; details != NULL && k < sizeof kinds / sizeof kinds[0]; k++) {
        const taut_record *list = taut_record_get(details, kinds[k].list[0]);
        if (list != NULL && taut_record_kind_of(list) == TAUT_RECORD_LIST &&
            taut_record_count(list) > 0) {
            return &kinds[k];
        }
    }
    return NULL;
}
