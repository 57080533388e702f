/* lines.c -- groups of consecutive parameters, whichever spans they lie in.
 *
 * A group's sums run over the window of functions that any of its points has, N_b(t_j) = 0 for the
 * others: so groups stay where they are in the result, and a knot in one costs a function or two
 * more. Parameters that jump about, or are fewer than the spans, have windows too wide for that:
 * their points make a group each.
 */
#include "geometry/grid/lines.h"

#include "core/memory.h"

#include <assert.h>
#include <string.h>

typedef struct window {
    int points, low, high;
    int single; /* too wide: point by point */
} window;

static window window_at(const taut_table *table, int start, int size)
{
    window w = {.points = table->count - start < size ? table->count - start : size,
                .low = table->first[start],
                .high = table->first[start]};
    for (int j = start; j < start + w.points; j++) {
        w.low = table->first[j] < w.low ? table->first[j] : w.low;
        w.high = table->first[j] > w.high ? table->first[j] : w.high;
    }
    w.high += table->local;
    w.single = w.high - w.low > 2 * table->local;
    return w;
}

/* basis[k][b][lane], the functions low..low+local-1 at points start + min(lane, points - 1). */
static void fill_basis(const taut_table *table, int start, int points, int size, int low, int local,
                       double *basis)
{
    memset(basis, 0, (size_t)(table->order + 1) * (size_t)(local * size) * sizeof(double));
    for (int lane = 0; lane < size; lane++) {
        const int point = start + (lane < points ? lane : points - 1);
        const int shift = table->first[point] - low;
        for (int k = 0; k <= table->order; k++) {
            const double *row = taut_table_row(table, point, k);
            for (int b = 0; b < table->local; b++) {
                basis[(k * local + shift + b) * size + lane] = row[b];
            }
        }
    }
}

/* The groups of one window, at the end of block; returns the basis numbers used. */
static size_t append_groups(const taut_table *table, int start, const window *w, int size,
                            taut_grid_group *groups, double *basis)
{
    const int count = w->single ? w->points : 1, points = w->single ? 1 : w->points;
    size_t used = 0;
    for (int i = 0; i < count; i++) {
        const int low = w->single ? table->first[start + i] : w->low;
        const int local = w->single ? table->local : w->high - w->low;
        fill_basis(table, start + i, points, size, low, local, basis + used);
        groups[i] = (taut_grid_group){.first = low, .local = local, .basis = basis + used};
        used += (size_t)(table->order + 1) * (size_t)local * (size_t)size;
    }
    return used;
}

/* Whether a window continues the block before it. */
static int continues_block(const taut_grid_block *last, const window *w)
{
    return last != NULL && !w->single && !last->single &&
           last->points + w->points <= TAUT_GRID_BLOCK;
}

static void fill_lines(const taut_table *table, taut_grid_lines *lines)
{
    taut_grid_block *block = NULL;
    size_t used = 0;
    int group = 0;
    for (int start = 0; start < table->count; start += lines->size) {
        const window w = window_at(table, start, lines->size);
        const int count = w.single ? w.points : 1;
        if (!continues_block(block, &w)) {
            block = &lines->blocks[lines->block_count++];
            *block = (taut_grid_block){
                .start = start, .group = group, .low = w.low, .high = w.high, .single = w.single};
        }
        block->points += w.points;
        block->count += count;
        block->low = w.low < block->low ? w.low : block->low;
        block->high = w.high > block->high ? w.high : block->high;
        used += append_groups(table, start, &w, lines->size, lines->groups + group,
                              lines->basis + used);
        group += count;
    }
    for (int i = 0; i < lines->block_count; i++) {
        const taut_grid_block *b = &lines->blocks[i];
        for (int g = b->group; g < b->group + b->count; g++) {
            lines->groups[g].first -= b->low;
        }
    }
}

taut_status taut_grid_lines_make(const taut_table *table, int group_size, taut_grid_lines *lines)
{
    size_t groups = 0, basis = 0, blocks = 0;

    assert(table->count > 0 && group_size > 0 && group_size <= TAUT_GRID_GROUP_MAX);
    for (int start = 0; start < table->count; start += group_size) {
        const window w = window_at(table, start, group_size);
        const size_t functions =
            w.single ? (size_t)w.points * (size_t)table->local : (size_t)(w.high - w.low);
        groups += w.single ? (size_t)w.points : 1;
        basis += (size_t)(table->order + 1) * functions * (size_t)group_size;
        blocks++;
    }
    *lines = (taut_grid_lines){
        .size = group_size,
        .blocks = taut_alloc_aligned(blocks, sizeof(taut_grid_block)),
        .groups = taut_alloc_aligned(groups, sizeof(taut_grid_group)),
        .basis = taut_alloc_aligned(basis, sizeof(double)),
    };
    if (lines->blocks == NULL || lines->groups == NULL || lines->basis == NULL) {
        taut_grid_lines_clear(lines);
        return TAUT_NO_MEMORY;
    }
    fill_lines(table, lines);
    return TAUT_OK;
}

void taut_grid_lines_clear(taut_grid_lines *lines)
{
    taut_free(lines->blocks);
    taut_free(lines->groups);
    taut_free(lines->basis);
    *lines = (taut_grid_lines){0};
}
