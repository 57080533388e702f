/* witness.c -- forged witnesses: the function psi that `details.least` proves a film by. Any psi
 * proves something true; none may prove too much. Its numbers are moved by 1e-15 of themselves to a
 * thousand times, scaled so that its slope passes 1, replaced; its direction is turned, long or 0;
 * its bases have other degrees, ranges and knots; and where there is none one is made up. */
#include "kinds.h"

#include <math.h>
#include <string.h>

static void put_basis(const taut_record *from, taut_record *to, const char *key, int how,
                      forge_random *random)
{
    taut_record *basis = taut_record_add_object(to, key);
    const char *type = taut_record_text(taut_record_get(from, "type"));
    const double degree = taut_record_number(taut_record_get(from, "degree"));

    taut_record_add_text(basis, "type", type != NULL && *type != 0 ? type : "bezier");
    taut_record_add_number(
        basis, "degree", (isnan(degree) ? 3 : degree) + (how == 1 ? forge_int(random, -2, 2) : 0));
    if (how == 2) {
        taut_record *range = taut_record_add_list(basis, "range");
        taut_record_add_number(range, NULL, forge_in(random, -1, 0.5));
        taut_record_add_number(range, NULL, forge_in(random, 0.4, 3));
    }
    for (size_t i = 0; i < taut_record_count(from); i++) {
        const char *name = taut_record_key(from, i);
        const taut_record *item = taut_record_at(from, i);
        if (strcmp(name, "type") == 0 || strcmp(name, "degree") == 0 ||
            (how == 2 && strcmp(name, "range") == 0)) {
            continue;
        }
        if (taut_record_kind_of(item) == TAUT_RECORD_LIST) {
            taut_record *list = taut_record_add_list(basis, name);
            const size_t one = (size_t)forge_int(random, 0, 20);
            for (size_t k = 0; k < taut_record_count(item); k++) {
                const double by = how == 3 && k == one ? forge_in(random, -0.5, 0.5) : 0;
                taut_record_add_number(list, NULL,
                                       taut_record_number(taut_record_at(item, k)) + by);
            }
        } else {
            taut_record_add_number(basis, name, taut_record_number(item));
        }
    }
}

/* how: 0 each moved, 1 all scaled, 2 one replaced, 3 all replaced, 4 one no number. */
static void put_coefficients(const taut_record *rows, taut_record *to, int how,
                             forge_random *random)
{
    static const double none[] = {NAN, INFINITY, -INFINITY, 1e308, 5e-324};
    const size_t count = rows != NULL ? taut_record_count(rows) : 4;
    const double by = how == 1 ? forge_log(random, 0.1, 10) : forge_log(random, 1e-15, 1e3);
    const size_t one = (size_t)forge_int(random, 0, (int)count - 1);
    taut_record *out = taut_record_add_list(to, "coefficients");

    for (size_t i = 0; i < count; i++) {
        const taut_record *row = taut_record_at(rows, i);
        const size_t n = rows != NULL ? taut_record_count(row) : 4;
        const size_t place = i == one ? (size_t)forge_int(random, 0, (int)n) : n;
        taut_record *line = taut_record_add_list(out, NULL);
        for (size_t j = 0; j < n; j++) {
            const double c = rows != NULL ? taut_record_number(taut_record_at(row, j)) : 0;
            const double noise = by * forge_in(random, -1, 1);
            taut_record_add_number(line, NULL,
                                   how == 0                 ? c + noise
                                   : how == 1               ? c * by
                                   : how == 3               ? noise
                                   : how == 2 && j == place ? noise
                                   : how == 4 && j == place ? none[forge_int(random, 0, 4)]
                                                            : c);
        }
    }
}

static void put_direction(const taut_record *from, taut_record *to, int how, forge_random *random)
{
    taut_record *out = taut_record_add_list(to, "direction");
    const double by = forge_log(random, 1e-15, 10);

    for (size_t k = 0; k < 3; k++) {
        const double own = from != NULL ? taut_record_number(taut_record_at(from, k)) : k == 2;
        taut_record_add_number(out, NULL,
                               how == 0   ? own
                               : how == 1 ? own + by * forge_in(random, -1, 1)
                               : how == 2 ? own * by
                               : how == 3 ? 0
                                          : forge_in(random, -1, 1));
    }
}

void forge_witness(edit_model *edit, const forge_base *base, const forge_base *other,
                   forge_random *random)
{
    const taut_record *least = taut_record_get(edit->details, "least");
    taut_record *details = taut_record_new();

    (void)base;
    (void)other;
    for (size_t i = 0; i < taut_record_count(edit->details); i++) {
        const char *name = taut_record_key(edit->details, i);
        if (strcmp(name, "least") != 0) {
            taut_record_add_record(details, name, taut_record_at(edit->details, i));
        }
    }
    taut_record *to = taut_record_add_object(details, "least");
    const int part = forge_int(random, 0, 3); /* what else than coefficients is changed */
    put_direction(taut_record_get(least, "direction"), to, part == 0 ? forge_int(random, 1, 4) : 0,
                  random);
    put_basis(taut_record_get(least, "u"), to, "u", part == 1 ? forge_int(random, 1, 3) : 0,
              random);
    put_basis(taut_record_get(least, "v"), to, "v", part == 2 ? forge_int(random, 1, 3) : 0,
              random);
    put_coefficients(taut_record_get(least, "coefficients"), to, forge_int(random, 0, 4), random);
    taut_record_free(edit->details);
    edit->details = details;
}
