/* test_part21.c -- the text of instances: reals with their point, strings escaped, lists broken. */
#include "check.h"

#include "core/memory.h"
#include "io/step/part21.h"

#include <stdlib.h>
#include <string.h>

/* What a call wrote, to be freed. */
static char *finish(taut_part21 *out)
{
    taut_part21_put(out, "%", (const taut_part21_value[]){TAUT_WORD("")});
    CHECK(taut_sink_finish(&out->sink) == TAUT_OK, "finish");
    return out->sink.text;
}

static void check_text(const char *found, const char *expected)
{
    CHECK(strcmp(found, expected) == 0, "\"%s\", expected \"%s\"", found, expected);
}

static void test_reals(void)
{
    static const struct {
        double x;
        const char *text;
    } rows[] = {{0, "0."},           {-0.0, "-0."},
                {1, "1."},           {-2.5, "-2.5"},
                {0.1, "0.1"},        {1e-7, "1.E-7"},
                {1.5e-7, "1.5E-7"},  {1e300, "1.E300"},
                {123456, "123456."}, {5e-324, "4.94065645841247E-324"}};
    for (int i = 0; i < (int)(sizeof rows / sizeof rows[0]); i++) {
        taut_part21 out = {.sink = taut_sink_to(NULL)};
        taut_part21_put(&out, "%", (const taut_part21_value[]){TAUT_REAL(rows[i].x)});
        char *text = finish(&out);
        CHECK(strchr(text, '.') != NULL && strchr(text, 'e') == NULL &&
                  strtod(text, NULL) == rows[i].x,
              "%s", text);
        check_text(text, rows[i].text);
        taut_free(text);
    }
    for (int i = 0; i < 10000; i++) {
        const double x = (random_int(0, 1) ? -1 : 1) * random_log(1e-300, 1e300);
        taut_part21 out = {.sink = taut_sink_to(NULL)};
        taut_part21_put(&out, "%", (const taut_part21_value[]){TAUT_REAL(x)});
        char *text = finish(&out);
        const char *digits = text + (text[0] == '-'), *point = strchr(text, '.');
        CHECK(strtod(text, NULL) == x && point != NULL && point > digits &&
                  strspn(digits, "0123456789") == (size_t)(point - digits) &&
                  strspn(point + 1, "0123456789E+-") == strlen(point + 1),
              "%.17g: %s", x, text);
        taut_free(text);
    }
}

static void test_strings(void)
{
    static const char *const rows[][2] = {{"", "''"},
                                          {"plain", "'plain'"},
                                          {"it's", "'it''s'"},
                                          {"a\\b", "'a\\\\b'"},
                                          {"\\X2\\0041\\X0\\", "'\\\\X2\\\\0041\\\\X0\\\\'"},
                                          {"a\nb\x7f", "'a\\X\\0Ab\\X\\7F'"},
                                          {"\303\244", "'\\X2\\00E4\\X0\\'"},
                                          {"\342\202\254", "'\\X2\\20AC\\X0\\'"},
                                          {"\360\237\230\200", "'\\X4\\0001F600\\X0\\'"},
                                          {"\377x\303", "'?x?'"},
                                          {"');\n#1=X(", "'\\X\\27);\\X\\0A#1=X('"},
                                          {"' ,'", "'\\X\\27 ,'''"},
                                          {"/* */", "'/* */'"}};
    for (int i = 0; i < (int)(sizeof rows / sizeof rows[0]); i++) {
        taut_part21 out = {.sink = taut_sink_to(NULL)};
        taut_part21_put(&out, "%", (const taut_part21_value[]){TAUT_TEXT(rows[i][0])});
        char *text = finish(&out);
        check_text(text, rows[i][1]);
        taut_free(text);
    }
}

static void test_lists(void)
{
    static const double numbers[] = {0, 0, 0, 0.5, 0.5, 1, 1, 1};
    static const size_t refs[] = {7, 12};
    taut_part21 out = {.sink = taut_sink_to(NULL)};
    const taut_part21_value grid = {
        .kind = PART21_GRID, .ref = 3, .count = 2, .across = 3, .step = 4};
    const taut_part21_value run = {.kind = PART21_RUN, .ref = 3, .step = 4, .count = 3};
    const taut_part21_value table = {
        .kind = PART21_TABLE, .reals = numbers + 2, .count = 2, .across = 2, .step = 2};
    CHECK(TAUT_NEW(&out, "A(%,%,%)", grid, run, table) == 1, "first");
    CHECK(TAUT_NEW(&out, "B(%,%,%,%)", TAUT_KNOTS(8, numbers), TAUT_TIMES(6, numbers + 1),
                   TAUT_REFS(2, refs), TAUT_REALS(3, numbers + 1, 3)) == 2,
          "second");
    CHECK(taut_part21_new(&out, "C()", NULL) == 3, "third");
    char *text = finish(&out);
    check_text(text, "#1=A(((#3,#4,#5),(#7,#8,#9)),(#3,#7,#11),((0.,0.5),(0.5,1.)));\n"
                     "#2=B((0.,0.5,1.),(3,2,3),(#7,#12),(0.,0.5,1.));\n#3=C();\n");
    taut_free(text);
}

/* Lines are broken between members, and only there. */
static void test_breaks(void)
{
    double numbers[200];
    taut_part21 out = {.sink = taut_sink_to(NULL)};
    for (int i = 0; i < 200; i++) {
        numbers[i] = random_in(-1, 1);
    }
    TAUT_NEW(&out, "A(%)", TAUT_REALS(200, numbers, 1));
    char *text = finish(&out), *next = NULL;
    int lines = 0;
    for (char *line = text; *line != '\0'; line = next) {
        const size_t length = strcspn(line, "\n");
        CHECK(length < 100, "a line of %zu", length);
        CHECK(line[length - 1] == ',' || line[length - 1] == ';', "%s", line);
        next = line + length + 1;
        lines++;
    }
    CHECK(lines > 20, "%d lines", lines);
    taut_free(text);
}

int main(void)
{
    random_seed(20261121);
    test_reals();
    test_strings();
    test_lists();
    test_breaks();
    return check_failures != 0;
}
