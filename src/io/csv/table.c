#include "io/csv/table.h"

static const taut_csv_column cables[] = {
    {.member = "edge", .title = "edge"},
    {.member = "force", .title = "force"},
    {.member = "length", .title = "length"},
    {.member = "unstressed", .title = "unstressed_length"},
    {.member = NULL},
};

static const taut_csv_column laths[] = {
    {.member = "name", .title = "name"},
    {.member = "family", .title = "family"},
    {.member = "length", .title = "length"},
    {.member = "cut_length", .title = "cut_length"},
    {.member = "width", .title = "width"},
    {.member = "thickness", .title = "thickness"},
    {.member = "least_radius", .title = "least_radius"},
    {.member = "twist", .title = "twist"},
    {.member = "stress/use", .title = "use"},
    {.member = "nodes", .is_list = 1, .title = "nodes"},
    {.member = NULL},
};

/* Of cut cloth. */
static const taut_csv_column pieces[] = {
    {.member = "name", .title = "name"},
    {.member = "extent/0", .title = "along"},
    {.member = "extent/1", .title = "across"},
    {.member = "area", .title = "area"},
    {.member = "flat_area", .title = "flat_area"},
    {.member = "cut_area", .title = "cut_area"},
    {.member = "strain/min", .title = "least_strain"},
    {.member = "strain/max", .title = "largest_strain"},
    {.member = "edges/right/seam", .title = "right"},
    {.member = "edges/right/length", .title = "right_length"},
    {.member = "edges/right/flat_length", .title = "right_flat_length"},
    {.member = "edges/end/flat_length", .title = "end_flat_length"},
    {.member = "edges/left/seam", .title = "left"},
    {.member = "edges/left/length", .title = "left_length"},
    {.member = "edges/left/flat_length", .title = "left_flat_length"},
    {.member = "edges/start/flat_length", .title = "start_flat_length"},
    {.member = NULL},
};

static const taut_csv_kind kinds[] = {{"cables", cables}, {"laths", laths}, {"pieces", pieces}};

const taut_csv_kind *taut_csv_table(const taut_model *model, const taut_record **rows)
{
    const taut_record *details = taut_model_details(model);

    for (size_t k = 0; details != NULL && k < sizeof kinds / sizeof kinds[0]; k++) {
        const taut_record *list = taut_record_get(details, kinds[k].list);
        if (list != NULL && taut_record_kind_of(list) == TAUT_RECORD_LIST &&
            taut_record_count(list) > 0) {
            *rows = list;
            return &kinds[k];
        }
    }
    return NULL;
}
