#include "layouts.h"

#include "check.h"

#include <stdarg.h>
#include <string.h>

/* ---- what it is of ---- */

static int add_vertex(layout *l, double x, double y, double z, int held)
{
    const double point[3] = {x, y, z};
    memcpy(l->points[l->vertices], point, sizeof point);
    l->held[l->vertices] = held;
    return l->vertices++;
}

static void add_quad(layout *l, int a, int b, int c, int d)
{
    const int quad[4] = {a, b, c, d};
    memcpy(l->quads[l->patches++], quad, sizeof quad);
}

/* A vertex in a quad's square, on its four lines where it is at an end. */
static void bilinear(const double corners[4][3], double u, double v, double x[3])
{
    for (int k = 0; k < 3; k++) {
        x[k] = (1 - v) * ((1 - u) * corners[0][k] + u * corners[1][k]) +
               v * ((1 - u) * corners[3][k] + u * corners[2][k]);
    }
}

static double polygon_area(const layout *l, const int quad[4])
{
    double sum = 0;
    for (int k = 0; k < 4; k++) {
        const double *a = l->points[quad[k]], *b = l->points[quad[(k + 1) % 4]];
        sum += 0.5 * (a[0] * b[1] - a[1] * b[0]);
    }
    return sum;
}

static void make_grid(layout *l)
{
    const int m = random_int(1, 8), n = random_int(m == 1 ? 2 : 1, LAYOUT_PATCHES / m < 8 ? 7 : 8);
    const int flat = random_int(0, 3) == 0, holes = m > 2 && n > 2 && random_int(0, 2) == 0;
    const double height = flat ? 0 : random_log(0.05, 1), off = 0.25;
    double cut_u[9], cut_v[9];
    int at[9][9], gone[8][8] = {{0}};

    l->across = m;
    l->along = n;

    for (int c = 0; c < 4; c++) {
        l->corners[c][0] = (c == 1 || c == 2) + random_in(-off, off);
        l->corners[c][1] = (c >= 2) + random_in(-off, off);
        l->corners[c][2] = height * random_in(-1, 1);
    }
    for (int i = 0; i <= 8; i++) {
        cut_u[i] = (i + (i > 0 && i < m ? random_in(-0.3, 0.3) : 0)) / m;
        cut_v[i] = (i + (i > 0 && i < n ? random_in(-0.3, 0.3) : 0)) / n;
    }
    for (int i = 0; i <= m; i++) {
        for (int j = 0; j <= n; j++) {
            double x[3];
            bilinear((const double(*)[3])l->corners, cut_u[i], cut_v[j], x);
            at[i][j] = add_vertex(l, x[0], x[1], x[2], i == 0 || j == 0 || i == m || j == n);
            l->near[at[i][j]] = random_int(0, 2) == 0;
        }
    }
    for (int k = 0; holes && k < 2; k++) {
        const int i = random_int(1, m - 2), j = random_int(1, n - 2);
        gone[i][j] = 1;
        for (int c = 0; c < 4; c++) {
            l->held[at[i + c % 2][j + c / 2]] = 1;
        }
    }
    l->is_frame = !holes;
    for (int i = 0; i < m; i++) {
        for (int j = 0; j < n; j++) {
            const int quad[4] = {at[i][j], at[i + 1][j], at[i + 1][j + 1], at[i][j + 1]};
            if (!gone[i][j]) {
                add_quad(l, quad[0], quad[1], quad[2], quad[3]);
                l->area += flat ? polygon_area(l, quad) : 0;
            }
        }
    }
}

static void make_star(layout *l)
{
    const int sides = random_int(3, 9), rounds = random_int(1, sides > 6 ? 2 : 3);
    const int center = add_vertex(l, 0, 0, 0, 0);
    const double height = random_log(0.05, 0.8);
    int at[4][18];

    for (int r = 1; r <= rounds; r++) {
        for (int k = 0; k < 2 * sides; k++) {
            const double angle = 2 * acos(-1) * (k + random_in(-0.1, 0.1)) / (2 * sides);
            const double radius = r * random_in(0.9, 1.1);
            at[r][k] = add_vertex(l, radius * cos(angle), radius * sin(angle),
                                  r == rounds ? height * random_in(-1, 1) : 0, r == rounds);
        }
    }
    for (int k = 0; k < sides; k++) {
        add_quad(l, at[1][2 * k], at[1][2 * k + 1], center,
                 at[1][(2 * k + 2 * sides - 1) % (2 * sides)]);
    }
    for (int r = 1; r < rounds; r++) {
        for (int k = 0; k < 2 * sides; k++) {
            const int next = (k + 1) % (2 * sides);
            add_quad(l, at[r + 1][k], at[r + 1][next], at[r][next], at[r][k]);
        }
    }
}

static void make_book(layout *l)
{
    const int sheets = random_int(2, 5), m = random_int(1, 4), n = random_int(1, 3);
    const double height = random_log(0.3, 2), uneven = random_in(0, 0.3);
    int spine[5], at[4][5];

    for (int j = 0; j <= m; j++) {
        spine[j] = add_vertex(l, random_in(-0.1, 0.1), random_in(-0.1, 0.1), height * j / m,
                              j == 0 || j == m);
        l->near[spine[j]] = random_int(0, 1);
    }
    for (int s = 0; s < sheets; s++) {
        const double angle = 2 * acos(-1) * (s + random_in(-uneven, uneven)) / sheets;
        memcpy(at[0], spine, sizeof spine);
        for (int i = 1; i <= n; i++) {
            for (int j = 0; j <= m; j++) {
                at[i][j] = add_vertex(l, cos(angle) * i / n, sin(angle) * i / n, height * j / m,
                                      i == n || j == 0 || j == m);
                if (i < n && (j == 0 || j == m)) { /* on the chord from the spine's end */
                    for (int k = 0; k < 2; k++) {
                        const double end = k == 0 ? cos(angle) : sin(angle);
                        l->points[at[i][j]][k] =
                            l->points[spine[j]][k] + (end - l->points[spine[j]][k]) * i / n;
                    }
                }
            }
        }
        for (int i = 0; i < n; i++) {
            for (int j = 0; j < m; j++) {
                add_quad(l, at[i][j], at[i + 1][j], at[i + 1][j + 1], at[i][j + 1]);
            }
        }
    }
}

static void make_tube(layout *l)
{
    const int around = random_int(3, 10), along = random_int(1, 4);
    int at[5][10];

    l->arcs = random_int(0, 1);
    l->height = random_log(0.2, 2);
    for (int j = 0; j <= along; j++) {
        for (int k = 0; k < around; k++) {
            const double angle = 2 * acos(-1) * k / around;
            at[j][k] =
                add_vertex(l, cos(angle), sin(angle), l->height * j / along, j == 0 || j == along);
        }
    }
    for (int j = 0; j < along; j++) {
        for (int k = 0; k < around; k++) {
            const int next = (k + 1) % around;
            add_quad(l, at[j][k], at[j][next], at[j + 1][next], at[j + 1][k]);
        }
    }
}

/* ---- its edges ---- */

static int find_edge(layout *l, int a, int b)
{
    const int lo = a < b ? a : b, hi = a < b ? b : a;
    for (int e = 0; e < l->edges; e++) {
        if (l->edge[e].ends[0] == lo && l->edge[e].ends[1] == hi) {
            return e;
        }
    }
    l->edge[l->edges] = (layout_edge){.ends = {lo, hi}, .class = l->edges};
    return l->edges++;
}

/* Which of the others have the bases of edge e: opposite ones of a quad. */
static void find_edges(layout *l)
{
    int changed = 1;

    for (int p = 0; p < l->patches; p++) {
        for (int k = 0; k < 4; k++) {
            l->edge[find_edge(l, l->quads[p][k], l->quads[p][(k + 1) % 4])].used++;
        }
    }
    while (changed) {
        changed = 0;
        for (int p = 0; p < l->patches; p++) {
            for (int k = 0; k < 2; k++) {
                layout_edge *a = &l->edge[find_edge(l, l->quads[p][k], l->quads[p][k + 1])];
                layout_edge *b =
                    &l->edge[find_edge(l, l->quads[p][k + 2], l->quads[p][(k + 3) % 4])];
                const int least = a->class < b->class ? a->class : b->class;
                changed |= a->class != b->class;
                a->class = b->class = least;
            }
        }
    }
}

static void lay_cable(layout *l, int a, int b, double force)
{
    layout_edge *edge = &l->edge[find_edge(l, a, b)];
    if (edge->used > 0 && !edge->cable) {
        edge->cable = 1;
        edge->force = force;
        l->cables++;
    }
}

/* Cables of grids: along whole lines inside from side to side, each of one force, and at outer edges between held corners. */
static void choose_cables(layout *l)
{
    if (l->kind != LAYOUT_GRID || random_int(0, 1) == 0) {
        return;
    }
    for (int line = 1; line < l->across; line++) {
        const double force = l->tension * random_log(0.01, 1);
        const int is_one = random_int(0, 1);
        for (int j = 0; is_one && j < l->along; j++) {
            lay_cable(l, line * (l->along + 1) + j, line * (l->along + 1) + j + 1, force);
        }
    }
    for (int e = 0; e < l->edges; e++) {
        const layout_edge *edge = &l->edge[e];
        if (edge->used == 1 && random_int(0, 5) == 0) {
            lay_cable(l, edge->ends[0], edge->ends[1], l->tension * random_log(0.3, 10));
        }
    }
    if (l->cables > 0) {
        l->area = l->is_frame = 0;
    }
}

/* ---- its text ---- */

static void say(layout *l, const char *format, ...)
{
    const size_t used = strlen(l->text);
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(l->text + used, LAYOUT_TEXT - used, format, arguments);
    va_end(arguments);
}

static int count_of(const layout *l, int class)
{
    return l->degree + 1 + (l->even ? 1 : class % 3);
}

static void say_edge(layout *l, int e, const char *name, int *first)
{
    layout_edge *edge = &l->edge[e];
    const double *a = l->points[edge->ends[0]], *b = l->points[edge->ends[1]];

    if (edge->used > 1 || !(edge->cable || l->arcs)) {
        return;
    }
    say(l, "%s\"%s\":", *first ? "" : ",", name);
    *first = 0;
    if (edge->cable) {
        say(l, "{\"cable\":{\"force\":%.17g}}", edge->force);
    } else { /* between neighbours on the unit circle */
        const double x = a[0] + b[0], y = a[1] + b[1], r = hypot(x, y);
        say(l,
            "{\"fixed\":{\"arc\":[[%.17g,%.17g,%.17g],[%.17g,%.17g,%.17g],[%.17g,%.17g,%.17g]]}}",
            a[0], a[1], a[2], x / r, y / r, a[2], b[0], b[1], b[2]);
    }
}

/* Patch p from its corner `turn` on, and mirrored or not; arcs are run from the smaller vertex on. */
static void say_patch(layout *l, int p, int turn, int mirror)
{
    static const char *const corner[4] = {"u0v0", "u1v0", "u1v1", "u0v1"};
    int round[4], first = 1;

    for (int k = 0; k < 4; k++) {
        round[k] = l->quads[p][(turn + (mirror ? 4 - k : k)) % 4];
    }
    /* v0 from 0 to 1, u1 from 1 to 2, v1 from 3 to 2, u0 from 0 to 3 */
    const int from[4] = {0, 1, 0, 3}, to[4] = {3, 2, 1, 2};
    static const char *const names[4] = {"u0", "u1", "v0", "v1"};
    const int class_u = l->edge[find_edge(l, round[0], round[1])].class,
              class_v = l->edge[find_edge(l, round[0], round[3])].class;
    say(l,
        "%s{\"name\":\"p%d\",\"tension\":%.17g,\"u\":{\"type\":\"bspline\",\"degree\":%d,\"count\":"
        "%d},"
        "\"v\":{\"type\":\"bspline\",\"degree\":%d,\"count\":%d},\"corners\":{",
        p > 0 ? ",\n" : "", p, l->tension, l->degree, count_of(l, class_u), l->degree,
        count_of(l, class_v));
    for (int k = 0; k < 4; k++) {
        const int at = round[k];
        const double *x = l->points[at];
        if (l->held[at]) {
            say(l, "%s\"%s\":[%.17g,%.17g,%.17g]", k > 0 ? "," : "", corner[k], x[0], x[1], x[2]);
        } else if (l->near[at]) {
            say(l, "%s\"%s\":{\"near\":[%.17g,%.17g,%.17g]}", k > 0 ? "," : "", corner[k], x[0],
                x[1], x[2]);
        } else {
            say(l, "%s\"%s\":null", k > 0 ? "," : "", corner[k]);
        }
    }
    say(l, "},\"edges\":{");
    for (int k = 0; k < 4; k++) {
        const int a = round[from[k]], b = round[to[k]], e = find_edge(l, a, b);
        const int often = l->edge[e].used;
        say_edge(l, e, names[k], &first);
        for (int s = 0; often > 1 && s < often && s < 6; s++) {
            if (l->edge[e].sides[s][0] == 0) {
                snprintf(l->edge[e].sides[s], 16, "%sp%d.%s", a < b ? "" : "-", p, names[k]);
                break;
            }
        }
    }
    say(l, "}}");
}

/* Arcs run with their edges: from the smaller vertex, which is where u and v begin. */
static void say_patches(layout *l)
{
    for (int p = 0; p < l->patches; p++) {
        int turn = random_int(0, 3), mirror = random_int(0, 1);
        for (int tries = 0; l->arcs && tries < 8; tries++) {
            int runs = 1;
            turn = tries % 4;
            mirror = tries / 4;
            for (int k = 0; k < 4; k++) { /* of outer edges alone */
                static const int from[4] = {0, 1, 0, 3}, to[4] = {3, 2, 1, 2};
                const int a = l->quads[p][(turn + (mirror ? 4 - from[k] : from[k])) % 4];
                const int b = l->quads[p][(turn + (mirror ? 4 - to[k] : to[k])) % 4];
                runs &= l->edge[find_edge(l, a, b)].used > 1 || a < b;
            }
            if (runs) {
                break;
            }
        }
        say_patch(l, p, turn, mirror);
    }
}

static void say_seams(layout *l)
{
    int first = 1;

    for (int e = 0; e < l->edges; e++) {
        const layout_edge *edge = &l->edge[e];
        if (edge->used < 2) {
            continue;
        }
        say(l, "%s%s[", first ? "" : ",", edge->cable ? "{\"edges\":" : "");
        for (int s = 0; s < edge->used; s++) {
            say(l, "%s\"%s\"", s > 0 ? "," : "", edge->sides[s]);
        }
        say(l, "]");
        if (edge->cable) {
            say(l, ",\"cable\":{\"force\":%.17g}}", edge->force);
        }
        first = 0;
    }
}

void layout_random(layout *l)
{
    static void (*const makers[LAYOUT_KINDS])(layout *) = {make_grid, make_star, make_book,
                                                           make_tube};
    memset(l, 0, sizeof *l);
    l->kind = (layout_kind)random_int(0, LAYOUT_KINDS - 1);
    l->degree = random_int(2, 4);
    l->even = random_int(0, 1);
    l->tension = random_int(0, 2) == 0 ? random_log(0.1, 10) : 1;
    makers[l->kind](l);
    find_edges(l);
    choose_cables(l);
    say(l, "{\"taut\":1,\"construct\":\"film\",\"patches\":[");
    say_patches(l);
    say(l, "],\n\"seams\":[");
    say_seams(l);
    say(l, "]}\n");
}

void layout_frame(const layout *l, int degree, int count, char *text, unsigned long room)
{
    char at[4][96];
    for (int c = 0; c < 4; c++) {
        snprintf(at[c], sizeof at[c], "[%.17g,%.17g,%.17g]", l->corners[c][0], l->corners[c][1],
                 l->corners[c][2]);
    }
    snprintf(text, room,
             "{\"taut\":1,\"construct\":\"film\",\"least\":false,\"tension\":%.17g,\"u\":{\"type\":"
             "\"bspline\",\"degree\":%d,"
             "\"count\":%d},\"v\":{\"type\":\"bspline\",\"degree\":%d,\"count\":%d},\"corners\":{"
             "\"u0v0\":%s,\"u1v0\":%s,\"u1v1\":%s,\"u0v1\":%s}}",
             l->tension, degree, count, degree, count, at[0], at[1], at[2], at[3]);
}
