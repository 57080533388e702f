#include "certify/pattern/repeats.h"

#include "certify/pattern/allowance.h"
#include "core/unit.h"
#include "problem/problem.h"

#include <string.h>

/* Relatively; what is computed of them, as compensation of prestress is, is rounded. */
static const double rounding = 1e-12, of_waste = 1e-9;
/* Between pieces on the roll where the document says none: mm. */
static const double usual_gap = 5;

static void wrong(taut_worst *w, int is_so, const char *list, const char *member)
{
    char place[64];
    snprintf(place, sizeof place, "%.24s/%.24s", list, member);
    taut_worst_take(w, is_so ? 0 : INFINITY, place, 0);
}

static int is_number(const taut_record *told, double asked)
{
    return told != NULL && fabs(taut_record_number(told) - asked) <= rounding * fabs(asked);
}

/* Is a number told that was asked for, and none else? */
static void look_at_number(const taut_record *at, const char *list, const char *key, int is_asked,
                           double asked, taut_worst *w)
{
    const taut_record *told = taut_record_get(at, key);
    wrong(w, is_asked ? is_number(told, asked) : told == NULL, list, key);
}

static void look_at_word(const taut_record *at, const char *list, const char *key,
                         const char *asked, taut_worst *w)
{
    const taut_record *told = taut_record_get(at, key);
    wrong(w, asked != NULL ? strcmp(taut_record_text(told), asked) == 0 : told == NULL, list, key);
}

static void look_at_cloth(const taut_cloth *cloth, const taut_record *details, taut_worst *w)
{
    const taut_pattern_problem *p = cloth->problem;
    const taut_record *told = taut_record_get(details, "cloth");
    const taut_record *material = taut_record_get(told, "material");
    const taut_record *share = taut_record_get(details, "compensation");
    const taut_record *moduli = taut_record_get(material, "E");

    look_at_number(told, "cloth", "thread", 1, cloth->thread, w);
    wrong(w, (material != NULL) == (cloth->has_law != 0), "cloth", "material");
    for (size_t k = 0; cloth->has_law && k < 2; k++) {
        wrong(w, is_number(taut_record_at(moduli, k), p->cloth.material.e[k]), "material", "E");
    }
    if (cloth->has_law) {
        look_at_number(material, "material", "nu", 1, p->cloth.material.nu, w);
        look_at_number(material, "material", "G", 1, p->cloth.material.g, w);
    }
    look_at_word(told, "cloth", "side", p->cloth.shows_lower ? "lower" : NULL, w);
    look_at_number(share, "compensation", "warp", 1, cloth->warp, w);
    look_at_number(share, "compensation", "weft", 1, cloth->weft, w);
    look_at_number(share, "compensation", "seam", cloth->has_seam && p->decompensate_count > 0,
                   cloth->seam, w);
}

static void look_at_fades(const taut_pattern_problem *p, const taut_record *details, taut_worst *w)
{
    static const char *const components[] = {"along", "both"};
    const taut_record *list = taut_record_get(details, "decompensate");
    wrong(w, taut_record_count(list) == (size_t)p->decompensate_count, "decompensate", "count");
    for (int k = 0; k < p->decompensate_count; k++) {
        const taut_record *at = taut_record_at(list, (size_t)k);
        look_at_word(at, "decompensate", "edge", taut_edge_name(p->decompensate[k].edge), w);
        look_at_number(at, "decompensate", "length", 1, p->decompensate[k].length, w);
        look_at_word(at, "decompensate", "component", components[p->decompensate[k].component], w);
    }
}

static void look_at_allowance(const taut_pattern_allowance *a, const taut_record *details,
                              taut_worst *w)
{
    static const char *const corners[] = {"mitre", "square", "mirror"};
    const taut_record *told = taut_record_get(details, "allowance");
    const int is_asked =
        a->seam > 0 || a->border > 0 || a->overlap > 0 || a->butt > 0 || a->seam_count > 0;

    wrong(w, (told != NULL) == is_asked, "details", "allowance");
    if (!is_asked) {
        return;
    }
    look_at_number(told, "allowance", "seam", 1, a->overlap > 0 ? 0 : a->seam, w);
    look_at_number(told, "allowance", "border", 1, a->border, w);
    look_at_number(told, "allowance", "overlap", a->overlap > 0, a->overlap, w);
    wrong(w, taut_record_bool(taut_record_get(told, "split")) == (a->overlap > 0 && a->is_split),
          "allowance", "split");
    look_at_number(told, "allowance", "butt", a->has_butt, a->butt, w);
    look_at_word(told, "allowance", "corner", corners[a->corner], w);
    for (int k = 0; k < a->seam_count; k++) {
        const taut_record *pair = taut_record_get(told, a->seams[k].seam);
        wrong(w,
              is_number(taut_record_at(pair, 0), a->seams[k].right) &&
                  is_number(taut_record_at(pair, 1), a->seams[k].left),
              "allowance", a->seams[k].seam);
    }
}

static void look_at_marks(const taut_pattern_marks *marks, const taut_record *details,
                          taut_worst *w)
{
    static const char *const notches[] = {"slit", "v", "dot"};
    const taut_record *told = taut_record_get(details, "marks");
    const int is_asked = marks->spacing > 0;
    wrong(w, (told != NULL) == is_asked, "details", "marks");
    look_at_number(told, "marks", "spacing", is_asked, marks->spacing, w);
    look_at_word(told, "marks", "notch", is_asked ? notches[marks->notch] : NULL, w);
}

/* Edges folded over, the pieces along them together. */
static void look_at_hems(const taut_cloth *cloth, const taut_record *details, taut_worst *w)
{
    const taut_pattern_problem *p = cloth->problem;
    const taut_record *list = taut_record_get(details, "hems");
    wrong(w, taut_record_count(list) == (size_t)p->hem_count, "hems", "count");
    for (int h = 0; h < p->hem_count; h++) {
        const taut_record *at = taut_record_at(list, (size_t)h);
        double sums[2] = {0, 0};
        for (int i = 0; i < cloth->piece_count * TAUT_CLOTH_EDGES; i++) {
            const taut_cloth_piece *piece = &cloth->pieces[i / TAUT_CLOTH_EDGES];
            const int e = i % TAUT_CLOTH_EDGES, is_here = piece->border[e] == (int)p->hems[h].edge;
            sums[0] += is_here ? piece->lengths[e] : 0;
            sums[1] += is_here ? piece->flat_lengths[e] : 0;
        }
        look_at_word(at, "hems", "edge", taut_edge_name(p->hems[h].edge), w);
        look_at_number(at, "hems", "pocket", 1, p->hems[h].pocket, w);
        for (int k = 0; k < 2; k++) {
            const char *key = k == 0 ? "length" : "flat_length";
            const double told = ldexp(taut_record_number(taut_record_get(at, key)), -cloth->unit);
            const double off = fabs(told - sums[k]) / cloth->size;
            taut_worst_take(w, isnan(off) ? INFINITY : (k == 0 ? 1e-3 : 1) * off, "hems", k);
        }
    }
}

static void look_at_roll(const taut_cloth *cloth, const taut_record *details, taut_worst *w)
{
    const taut_record *roll = taut_record_get(details, "roll");
    const double area = taut_record_number(taut_record_get(roll, "length")) *
                        taut_record_number(taut_record_get(roll, "width"));
    const double told = taut_record_number(taut_record_get(roll, "waste"));
    double cut = 0;
    for (int k = 0; k < cloth->piece_count; k++) {
        cut += taut_cloth_cut_area(cloth, &cloth->pieces[k]);
    }
    const double off = fabs(told - (1 - ldexp(cut, 2 * cloth->unit) / area));
    wrong(w, off <= of_waste, "roll", "waste");
    if (cloth->problem != NULL) {
        const taut_pattern_cloth *asked = &cloth->problem->cloth;
        const char *unit = taut_model_unit(cloth->model);
        const double gap = usual_gap * taut_unit_ratio("mm", unit != NULL ? unit : "mm");
        look_at_number(roll, "roll", "gap", 1, asked->has_gap ? asked->gap : gap, w);
    }
    wrong(w, taut_record_number(taut_record_get(roll, "gap")) >= 0, "roll", "gap");
}

void taut_cloth_look_at_repeats(const taut_cloth *cloth, taut_worst *w)
{
    const taut_record *details = taut_model_details(cloth->model);
    const taut_pattern_problem *p = cloth->problem;

    look_at_word(details, "details", "pattern", "cloth", w);
    look_at_roll(cloth, details, w);
    if (p == NULL) {
        return;
    }
    look_at_cloth(cloth, details, w);
    look_at_fades(p, details, w);
    look_at_word(details, "details", "seam_length", cloth->is_true ? "true" : "shared", w);
    look_at_word(details, "details", "flatten", cloth->is_conformal ? "conformal" : NULL, w);
    look_at_word(details, "details", "ends", cloth->is_straight ? "straight" : NULL, w);
    look_at_number(details, "details", "strain", cloth->strain > 0, cloth->strain, w);
    look_at_allowance(&p->allowance, details, w);
    look_at_marks(&p->marks, details, w);
    look_at_hems(cloth, details, w);
}
