/* test_strain.c -- the claim `strain`: proved where nothing is strained more, of a limit hardly above what a fine grid finds; false of
 * one below; and no bound where the proof does not reach. */
#include "certificates.h"
#include "certify/pattern/energy.h"
#include "certify/pattern/strain.h"
#include "check.h"
#include "cloths.h"

#include <math.h>
#include <string.h>

static const char strips[] = "\"seams\": [{ \"across\": [\"v0\", \"v1\"], \"count\": 3 }], "
                             "\"compensation\": { \"warp\": 0.02, \"weft\": 0.045 }";

/* Of all pieces, on a grid that is no multiple of their cells. */
static double largest_of(const taut_cloth *cloth)
{
    enum { PLACES = 301 };
    double most = 0;
    for (int k = 0; k < cloth->piece_count; k++) {
        for (int i = 0; i <= PLACES; i++) {
            for (int j = 0; j <= PLACES / 4; j++) {
                const double strain = taut_cloth_strain_at(
                    cloth, &cloth->pieces[k], (double)i / PLACES, j / (double)(PLACES / 4));
                most = fmax(most, fabs(strain));
            }
        }
    }
    return most;
}

static void test_bounds(const made_cloth *made)
{
    const taut_crew crew = {.threads = 1};
    taut_cloth cloth = {.crew = &crew};
    taut_arena *arena = taut_arena_new();
    CHECK(taut_cloth_read(arena, made->model, NULL, &cloth, NULL) == TAUT_OK, "read");
    const double most = largest_of(&cloth);
    static const double shares[] = {1.0001, 1.01, 1.5, 8};
    for (size_t k = 0; k < sizeof shares / sizeof shares[0]; k++) {
        double bound = 0;
        for (int i = 0; i < cloth.piece_count; i++) {
            const double own =
                taut_cloth_strain_bound(&cloth, &cloth.pieces[i], most, shares[k] * most, NULL);
            bound = fmax(bound, own);
            CHECK(own <= shares[k] * most, "%g: %g of %g", shares[k], own, most);
        }
        CHECK(bound >= most, "%g: %.17g, found %.17g", shares[k], bound, most);
    }
    /* what is strained by more is not proved, even where what was found is said to be less */
    int any = 0;
    for (int i = 0; i < cloth.piece_count; i++) {
        const double own =
            taut_cloth_strain_bound(&cloth, &cloth.pieces[i], most / 2, most * (1 - 1e-6), NULL);
        any |= !(own <= most * (1 - 1e-6));
    }
    CHECK(any, "%.17g is more than was proved", most);
    taut_arena_free(arena);
}

static void test_claim(const made_cloth *made)
{
    char members[512];
    const double most =
        fmax(figure_of(made->proof, "max_strain"), -figure_of(made->proof, "min_strain"));
    for (int k = 0; k < 2; k++) {
        snprintf(members, sizeof members, "%s, \"strain\": %.17g", strips,
                 most * (k == 0 ? 1.001 : 0.999));
        made_cloth asked = cloth_make(SADDLE, members);
        const taut_claim *claim = claim_of(asked.proof, "strain");
        CHECK(asked.status == TAUT_OK, "%s", asked.error.message);
        CHECK(claim->holds == (k == 0 ? TAUT_TRUE : TAUT_FALSE) &&
                  claim->kind == (k == 0 ? TAUT_BOUND : TAUT_CHECK),
              "%d: kind %d, %g of %g", k, (int)claim->kind, claim->residual, claim->limit);
        cloth_free(&asked);
    }
}

int main(void)
{
    made_cloth made = cloth_make(SADDLE, strips);
    CHECK(made.status == TAUT_OK, "%s", made.error.message);
    test_bounds(&made);
    test_claim(&made);
    cloth_free(&made);
    return check_failures != 0;
}
