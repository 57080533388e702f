#include "geometry/operate/change.h"

#include "core/fail.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* Is t inside the open range? */
static taut_status check_inside(const taut_basis *basis, double t, taut_error *error)
{
    const double lo = taut_basis_lo(basis), hi = taut_basis_hi(basis);
    if (!(t > lo && t < hi)) {
        return taut_fail(error, TAUT_NO_SOLUTION, "parameter", NULL, t, t <= lo ? lo : hi,
                         "parameter %.17g is not inside the open range from %.17g to %.17g", t, lo,
                         hi);
    }
    return TAUT_OK;
}

static taut_status refuse_change(const taut_basis *basis, const char *what, taut_error *error)
{
    return taut_fail(error, TAUT_NO_SOLUTION, "basis", NULL, taut_none, taut_none,
                     "a basis of type \"%s\" has no %s; convert it to NURBS first",
                     taut_basis_type(basis), what);
}

taut_status taut_operate_split(const taut_basis *basis, double t, taut_change_list *list,
                               taut_error *error)
{
    const taut_status status = check_inside(basis, t, error);
    return status == TAUT_OK ? basis->ops->changes->split(basis, t, list, error) : status;
}

taut_status taut_operate_insert(const taut_basis *basis, double t, int times, taut_change **change,
                                taut_error *error)
{
    if (basis->ops->changes->insert == NULL) {
        return refuse_change(basis, "knots to insert", error);
    }
    const taut_status status = check_inside(basis, t, error);
    return status == TAUT_OK ? basis->ops->changes->insert(basis, t, times, change, error) : status;
}

/* *made becomes itself and one step of degree more. */
static taut_status raise_once(taut_change **made, const taut_basis *from, taut_error *error)
{
    taut_change *step = NULL, *both = NULL;
    taut_status status = from->ops->changes->elevate(from, &step, error);

    if (status != TAUT_OK) {
        return status;
    }
    if (*made == NULL) {
        *made = step;
        return TAUT_OK;
    }
    status = taut_change_compose(*made, step, &both, error);
    taut_change_free(step);
    taut_change_free(*made);
    *made = both;
    return status;
}

taut_status taut_operate_elevate(const taut_basis *basis, int times, taut_change **change,
                                 taut_error *error)
{
    const int room = TAUT_DEGREE_MAX - taut_basis_degree(basis);
    taut_change *made = NULL;

    if (basis->ops->changes->elevate == NULL) {
        return refuse_change(basis, "degree to raise", error);
    }
    if (times < 0 || times > room) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, "degree", NULL, times, room,
                         "degree %d cannot be raised by %d, expected 0 to %d",
                         taut_basis_degree(basis), times, room);
    }
    if (times == 0) {
        return taut_change_select(&basis->spec, basis->shape.count, 0, 0, change, error);
    }
    for (int i = 0; i < times; i++) {
        const taut_status status = raise_once(&made, made != NULL ? made->to : basis, error);
        if (status != TAUT_OK) {
            taut_change_free(made);
            return status;
        }
    }
    *change = made;
    return TAUT_OK;
}

taut_status taut_operate_rerange(const taut_basis *basis, double lo, double hi,
                                 taut_change **change, taut_error *error)
{
    if (!(lo < hi) || !isfinite(hi - lo)) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, "argument", NULL, hi - lo, 0,
                         "range is [%.17g, %.17g], expected two increasing numbers", lo, hi);
    }
    return basis->ops->changes->rerange(basis, lo, hi, change, error);
}

void taut_operate_piece_name(const char *name, int dashes, int i, char out[TAUT_NAME_MAX + 1])
{
    const char *whole = name[0] != '\0' ? name : "piece";
    char tail[64];
    size_t length = strlen(whole), tail_length = 0;

    dashes = dashes < 32 ? dashes : 32;
    memset(tail, '-', (size_t)dashes);
    snprintf(tail + dashes, sizeof tail - (size_t)dashes, "%d", i);
    tail_length = strlen(tail);
    if (length + tail_length > TAUT_NAME_MAX) {
        length = TAUT_NAME_MAX - tail_length;
        while (length > 0 && ((unsigned char)whole[length] & 0xc0) == 0x80) {
            length--; /* not within a character of UTF-8 */
        }
    }
    memcpy(out, whole, length);
    memcpy(out + length, tail, tail_length + 1);
}

taut_status taut_operate_null(taut_error *error)
{
    return taut_fail(error, TAUT_BAD_ARGUMENT, "argument", NULL, taut_none, taut_none,
                     "an object to work on, a direction, or a place for the result is missing");
}
