#include "io/csv/table.h"

static const taut_csv_column cables[] = {{"edge", "edge"},
                                         {"force", "force"},
                                         {"length", "length"},
                                         {"unstressed", "unstressed_length"},
                                         {NULL, NULL}};

static const taut_csv_kind kinds[] = {{"cables", cables}};

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
