#include "certify/common/figures.h"

#include <stdio.h>

static void add_numbers(taut_record *figures, const char *name, int count, const double *numbers)
{
    if (count == 1) {
        taut_record_add_number(figures, name, numbers[0]);
    } else {
        taut_record_add_numbers(figures, name, count, numbers);
    }
}

void taut_certify_add_integrals(taut_record *figures, const char *name, int count,
                                const double *values, const double *errors)
{
    char error_name[64];
    int is_worth_a_word = 0;

    for (int i = 0; i < count; i++) {
        is_worth_a_word |= !(errors[i] <= 0);
    }
    add_numbers(figures, name, count, values);
    if (is_worth_a_word) {
        (void)snprintf(error_name, sizeof error_name, "%s_error", name);
        add_numbers(figures, error_name, count, errors);
    }
}
