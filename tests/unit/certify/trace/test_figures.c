/* test_figures.c -- no number, and no word, of laths, nodes and panels is believed: each one changed alone makes a claim false. */
#include "certificates.h"
#include "check.h"
#include "nets.h"

#include <math.h>
#include <string.h>

/* The leaf that is changed, counted as they are met, and what it was. */
typedef struct change {
    int at, count;
    double factor;
    const char *key;
} change;

/* What nobody vouches for, how many steps it took; and where the largest curvatures are, which hardly change beside there. */
static int is_free(const char *key)
{
    return key != NULL && (strcmp(key, "steps") == 0 || strcmp(key, "max_at") == 0);
}

static void copy_changed(const taut_record *from, const char *key, int inside, taut_record *to,
                         const char *name, change *c)
{
    const taut_record_kind kind = taut_record_kind_of(from);
    const int is_list = kind == TAUT_RECORD_LIST, is_object = kind == TAUT_RECORD_OBJECT;
    if (is_list || is_object) {
        taut_record *part =
            is_list ? taut_record_add_list(to, name) : taut_record_add_object(to, name);
        for (size_t k = 0; k < taut_record_count(from); k++) {
            const char *member = is_object ? taut_record_key(from, k) : NULL;
            copy_changed(taut_record_at(from, k), member != NULL ? member : key, inside, part,
                         member, c);
        }
        return;
    }
    const int is_it = inside && !is_free(key) &&
                      (kind == TAUT_RECORD_NUMBER || kind == TAUT_RECORD_TEXT) &&
                      c->count++ == c->at;
    if (!is_it) {
        taut_record_add_record(to, name, from);
        return;
    }
    c->key = key;
    if (kind == TAUT_RECORD_TEXT) {
        taut_record_add_text(to, name, "another");
    } else {
        taut_record_add_number(to, name, taut_record_number(from) * c->factor + 1e-2);
    }
}

/* The pieces with the outlines of their slots to change. */
static void copy_pieces(const taut_record *pieces, taut_record *details, change *c)
{
    taut_record *list = taut_record_add_list(details, "pieces");
    for (size_t k = 0; k < taut_record_count(pieces); k++) {
        const taut_record *piece = taut_record_at(pieces, k);
        taut_record *to = taut_record_add_object(list, NULL);
        for (size_t i = 0; i < taut_record_count(piece); i++) {
            const char *key = taut_record_key(piece, i);
            copy_changed(taut_record_at(piece, i), key, strcmp(key, "slots") == 0, to, key, c);
        }
    }
}

static taut_record *details_changed(const taut_record *old, change *c)
{
    taut_record *details = taut_record_new();
    for (size_t k = 0; k < taut_record_count(old); k++) {
        const char *key = taut_record_key(old, k);
        const int inside = strcmp(key, "laths") == 0 || strcmp(key, "nodes") == 0 ||
                           strcmp(key, "panels") == 0 || strcmp(key, "panel_count") == 0 ||
                           strcmp(key, "max_planarity") == 0;
        if (strcmp(key, "pieces") == 0) {
            copy_pieces(taut_record_at(old, k), details, c);
        } else {
            copy_changed(taut_record_at(old, k), key, inside, details, key, c);
        }
    }
    return details;
}

static void check_all(const char *what, made_net *made)
{
    int held = 0, tried = 0;

    CHECK(made->status == TAUT_OK, "%s: %s", what, made->error.message);
    CHECK(taut_certificate_holds(made->proof) == TAUT_TRUE, "%s as made", what);
    CHECK(claim_of(made->proof, "figures")->residual < 1e-7, "%s: %g at %s", what,
          claim_of(made->proof, "figures")->residual, claim_of(made->proof, "figures")->where);
    for (int at = 0;; at++) {
        change c = {.at = at, .factor = 1.001};
        taut_model *model = NULL;
        taut_certificate *proof = NULL;
        taut_error error = {.status = TAUT_OK};
        taut_record *details = details_changed(taut_model_details(made->model), &c);
        if (c.count <= at) {
            taut_record_free(details);
            break;
        }
        CHECK(taut_model_copy(made->model, &model) == TAUT_OK, "copy");
        taut_model_set_details(model, details);
        const taut_status status = taut_certify(model, made->problem, NULL, &proof, &error);
        const int fails = status != TAUT_OK || taut_certificate_holds(proof) == TAUT_FALSE;
        CHECK(fails, "%s: %s (%d) is believed", what, c.key, at);
        held += !fails;
        tried++;
        taut_certificate_free(proof);
        taut_model_free(model);
    }
    printf("%s: %d figures changed, %d believed\n", what, tried, held);
    net_free(made);
}

/* The last panel left out, and all else as it is then. */
static void check_fewer(const made_net *made)
{
    const taut_record *old = taut_model_details(made->model);
    const taut_record *panels = taut_record_get(old, "panels");
    taut_record *details = taut_record_new();
    taut_model *model = NULL;
    taut_certificate *proof = NULL;
    const size_t count = taut_record_count(panels);
    double largest = 0;

    CHECK(count > 1, "%d panels", (int)count);
    for (size_t i = 0; i + 1 < count; i++) {
        largest = fmax(largest,
                       taut_record_number(taut_record_get(taut_record_at(panels, i), "planarity")));
    }
    for (size_t k = 0; k < taut_record_count(old); k++) {
        const char *key = taut_record_key(old, k);
        if (strcmp(key, "panel_count") == 0) {
            taut_record_add_number(details, key, (double)count - 1);
        } else if (strcmp(key, "max_planarity") == 0) {
            taut_record_add_number(details, key, largest);
        } else if (strcmp(key, "panels") == 0) {
            taut_record *list = taut_record_add_list(details, key);
            for (size_t i = 0; i + 1 < count; i++) {
                taut_record_add_record(list, NULL, taut_record_at(panels, i));
            }
        } else {
            taut_record_add_record(details, key, taut_record_at(old, k));
        }
    }
    CHECK(taut_model_copy(made->model, &model) == TAUT_OK, "copy");
    taut_model_set_details(model, details);
    CHECK(taut_certify(model, made->problem, NULL, &proof, NULL) == TAUT_OK, "fewer");
    CHECK(claim_of(proof, "figures")->holds == TAUT_FALSE, "a panel less");
    taut_certificate_free(proof);
    taut_model_free(model);
}

int main(void)
{
    made_net standing = net_make(
        "asymptotic", BONNET("0"),
        "\"seeds\": [{ \"edge\": \"v0\", \"family\": \"+\", \"count\": 2 }, { \"edge\": \"u0\", "
        "\"family\": \"-\", \"count\": 2 }], \"laths\": { \"strip\": \"standing\", \"width\": "
        "0.1, \"thickness\": 0.0015, \"material\": \"steel-s235\" }");
    check_all("standing", &standing);
    made_net planks =
        net_make("geodesic", CATENOID,
                 "\"seeds\": [{ \"at\": [0.5, 0.5], \"direction\": [1, 0.3], \"both\": true }, { "
                 "\"at\": [0, 0.2], \"direction\": [-0.4, 1], \"both\": true }], \"laths\": { "
                 "\"strip\": \"plank\", \"width\": 0.05, \"thickness\": 0.002, \"material\": "
                 "\"timber-c24\", \"cut\": \"axis\" }");
    check_all("planks", &planks);
    made_net panels =
        net_make("principal", BILINEAR, "\"seeds\": [{ \"cells\": 5 }], \"panels\": true");
    check_fewer(&panels);
    check_all("panels", &panels);
    made_net bent =
        net_make("asymptotic", CATENOID,
                 "\"seeds\": [{ \"at\": [0.6, 0.55], \"family\": \"+\" }], "
                 "\"max_length\": 0.2, \"laths\": { \"strip\": \"developable\", "
                 "\"width\": 0.02, \"thickness\": 0.001, \"material\": \"steel-s235\" }");
    check_all("bent", &bent);
    return check_failures != 0;
}
