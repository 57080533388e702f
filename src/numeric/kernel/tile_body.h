/* tile_body.h -- the matrix product kernel: a TILE_ROWS x TILE_COLUMNS block stays in registers
 * while `depth` rank-one terms are added to it. */

TARGET static void tile(size_t depth, const double *a, const double *b, double *c, size_t c_stride)
{
    v_double sum[TILE_ROWS][TILE_GROUPS];

#pragma GCC unroll 8
    for (int r = 0; r < TILE_ROWS; r++) {
#pragma GCC unroll 8
        for (int g = 0; g < TILE_GROUPS; g++) {
            sum[r][g] = v_all(0.0);
        }
    }
    for (size_t k = 0; k < depth; k++) {
        v_double bk[TILE_GROUPS];
#pragma GCC unroll 8
        for (int g = 0; g < TILE_GROUPS; g++) {
            bk[g] = v_load(b + g * V_SIZE);
        }
#pragma GCC unroll 8
        for (int r = 0; r < TILE_ROWS; r++) {
            const v_double ar = v_all(a[r]);
#pragma GCC unroll 8
            for (int g = 0; g < TILE_GROUPS; g++) {
                sum[r][g] = v_fma(ar, bk[g], sum[r][g]);
            }
        }
        a += TILE_ROWS;
        b += TILE_COLUMNS;
    }
#pragma GCC unroll 8
    for (int r = 0; r < TILE_ROWS; r++) {
        double *row = c + (size_t)r * c_stride;
#pragma GCC unroll 8
        for (int g = 0; g < TILE_GROUPS; g++) {
            v_store(row + g * V_SIZE, v_load(row + g * V_SIZE) + sum[r][g]);
        }
    }
}

TARGET static void pack(size_t units, const double *from, size_t to_stride, double *to)
{
    for (size_t q = 0; q < units; q++, from += TILE_COLUMNS, to += to_stride) {
        for (int g = 0; g < TILE_GROUPS; g++) {
            v_store(to + g * V_SIZE, v_load(from + g * V_SIZE));
        }
    }
}
