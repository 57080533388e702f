/* test_told.c -- what a pattern says, as structs: numbers of closed form, curves as long as they are told, places that there are not. */
#include "check.h"
#include "cloths.h"
#include "taut/construct.h"
#include "taut/pattern.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { STEPS = 4096 };

static double chords_of(const taut_curve *curve)
{
    double sum = 0, before[3] = {0, 0, 0}, at[3];
    for (int k = 0; curve != NULL && k <= STEPS; k++) {
        taut_curve_eval(curve, (double)k / STEPS, 0, at);
        sum += k > 0 ? hypot(hypot(at[0] - before[0], at[1] - before[1]), at[2] - before[2]) : 0;
        memcpy(before, at, sizeof before);
    }
    return sum;
}

static void check_piece(const made_cloth *made, int i)
{
    static const char *const seams[3][2] = {{"S1", NULL}, {"S2", "S1"}, {NULL, "S2"}};
    taut_pattern_flat_piece piece;
    char name[8];
    snprintf(name, sizeof name, "P%d", i + 1);
    CHECK(taut_pattern_piece_at(made->model, i, &piece, NULL) == TAUT_OK, "%s", name);
    CHECK(strcmp(piece.name, name) == 0 && strcmp(taut_surface_name(piece.flat), name) == 0 &&
              strncmp(taut_curve_name(piece.cut), name, 2) == 0,
          "%s", piece.name);
    for (int e = 0; e < 4; e++) {
        const taut_pattern_sewn_edge *edge = &piece.edges[e];
        const char *seam = e % 2 == 0 ? seams[i][e / 2] : NULL;
        CHECK((edge->seam == NULL) == (seam == NULL) &&
                  (seam == NULL || strcmp(edge->seam, seam) == 0),
              "%s: %s", name, edge->seam != NULL ? edge->seam : "none");
        CHECK(seam == NULL ? isnan(edge->part[0]) : edge->part[0] == 0 && edge->part[1] == 1,
              "%s part", name);
        CHECK_NEAR(chords_of(edge->line), edge->flat_length, 1e-6, "%s line %d", name, e);
        CHECK_NEAR(edge->allowance, seam != NULL ? 0.02 : 0.05, 1e-15, "%s allowance %d", name, e);
    }
    CHECK(piece.strain[0] < 0 && piece.strain[1] > 0 && piece.energy > 0 && piece.curvature < 0 &&
              piece.cut_area > piece.flat_area && piece.extent[0] > piece.extent[1],
          "%s", name);
    CHECK_NEAR(piece.area, piece.flat_area, 0.01, "%s areas", name);
    CHECK(piece.on_roll[0] > 0 && piece.on_roll[1] > 0, "%s on the roll", name);
}

static void test_sail(void)
{
    made_cloth made =
        cloth_make(SADDLE, "\"seams\": [{ \"across\": [\"v0\", \"v1\"], \"count\": 3 }], "
                           "\"allowance\": { \"seam\": 0.02, \"border\": 0.05 }, \"marks\": { "
                           "\"spacing\": 0.5 }");
    taut_error error;
    CHECK(made.status == TAUT_OK, "%s", made.error.message);
    CHECK(taut_pattern_piece_count(made.model) == 3 && taut_pattern_seam_count(made.model) == 2,
          "three pieces, two seams");
    for (int i = 0; i < 3; i++) {
        check_piece(&made, i);
    }
    taut_pattern_flat_piece piece;
    taut_pattern_sewn_seam seam;
    const char *pieces[2];
    double marks[4];
    const int rooms[2] = {2, 4}, small[2] = {1, 4}, few[2] = {2, 3};
    CHECK(taut_pattern_seam_at(made.model, 1, rooms, pieces, marks, &seam, NULL) == TAUT_OK, "S2");
    CHECK(strcmp(seam.name, "S2") == 0 && strcmp(seam.kind, "geodesic") == 0 &&
              strcmp(taut_curve_name(seam.curve), "S2") == 0,
          "%s", seam.name);
    CHECK(seam.piece_count == 2 && strcmp(pieces[0], "P2") == 0 && strcmp(pieces[1], "P3") == 0,
          "pieces of S2");
    CHECK(seam.mark_count == 4 && marks[0] == 0.5 && marks[3] == 2, "%d marks", seam.mark_count);
    CHECK(seam.stretch[0] > 0.9 && seam.stretch[1] < 1 && seam.disagreement > 0 &&
              seam.flat_length < seam.length,
          "a saddle's seams are tight");
    CHECK(taut_pattern_seam_at(made.model, 0, NULL, NULL, NULL, &seam, NULL) == TAUT_OK &&
              strcmp(seam.name, "S1") == 0,
          "the struct alone");
    CHECK(taut_pattern_seam_at(made.model, 0, small, pieces, NULL, &seam, &error) ==
                  TAUT_BAD_ARGUMENT &&
              strcmp(error.reason, "argument") == 0,
          "no room for pieces");
    CHECK(taut_pattern_seam_at(made.model, 0, few, pieces, marks, &seam, NULL) == TAUT_BAD_ARGUMENT,
          "no room for marks");
    CHECK(taut_pattern_seam_at(made.model, 0, NULL, pieces, NULL, &seam, NULL) == TAUT_BAD_ARGUMENT,
          "no room at all");
    CHECK(taut_pattern_seam_at(made.model, 2, NULL, NULL, NULL, &seam, NULL) == TAUT_BAD_ARGUMENT &&
              taut_pattern_seam_at(made.model, 0, NULL, NULL, NULL, NULL, NULL) ==
                  TAUT_BAD_ARGUMENT,
          "no such seam");
    CHECK(taut_pattern_piece_at(made.model, -1, &piece, NULL) == TAUT_BAD_ARGUMENT &&
              taut_pattern_piece_at(made.model, 3, &piece, NULL) == TAUT_BAD_ARGUMENT &&
              taut_pattern_piece_at(NULL, 0, &piece, NULL) == TAUT_BAD_ARGUMENT,
          "no such piece");
    cloth_free(&made);
}

/* A model that is no pattern, and one whose details are not those of one. */
static void test_others(void)
{
    taut_model *model = NULL;
    taut_pattern_flat_piece piece;
    CHECK(taut_model_new(&model) == TAUT_OK, "a model");
    CHECK(taut_pattern_piece_count(model) == 0 && taut_pattern_seam_count(NULL) == 0, "no pattern");
    taut_record *details = taut_record_new();
    taut_record_add_text(details, "pattern", "cloth");
    taut_record *list = taut_record_add_list(details, "pieces");
    taut_record_add_number(list, NULL, 7);
    taut_model_set_details(model, details);
    CHECK(taut_pattern_piece_count(model) == 1 &&
              taut_pattern_piece_at(model, 0, &piece, NULL) == TAUT_OK,
          "a piece that is none");
    CHECK(strcmp(piece.name, "") == 0 && piece.flat == NULL && piece.cut == NULL &&
              isnan(piece.area) && isnan(piece.extent[1]) && piece.edges[3].line == NULL,
          "nothing is told of it");
    taut_model_free(model);
}

int main(void)
{
    test_sail();
    test_others();
    return check_failures != 0;
}
