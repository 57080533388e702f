/* test_scan.c -- what is seen of a STEP or IGES file before a library reads it: each fault with
 * its line, and what only looks like one. */
#include "check.h"

#include "io/cad/scan.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define BEGIN "ISO-10303-21;\n"
#define END "END-ISO-10303-21;\n"

static void check_told(taut_status status, const taut_error *error, const char *where,
                       const char *message, const char *text)
{
    if (message == NULL) {
        CHECK(status == TAUT_OK, "%s: %s, of %s", error->where, error->message, text);
        return;
    }
    CHECK(status == TAUT_BAD_INPUT && error->status == status, "%d of %s", (int)status, text);
    CHECK(strcmp(error->where, where) == 0 && strcmp(error->reason, "broken") == 0 &&
              strcmp(error->message, message) == 0,
          "%s: %s, expected %s: %s", error->where, error->message, where, message);
}

/* message NULL: nothing is wrong. */
static void test_step(void)
{
    static const struct {
        const char *text, *where, *message;
    } rows[] = {
        {BEGIN END, NULL, NULL},
        {"/* first */ " BEGIN
         "DATA /* of\n it */;\n#1=A('it''s',(1.,-2.E-3,.T.,#2,\"0F\"),$,*);\n" END,
         NULL, NULL},
        {"/* no end", "line 1", "this is no STEP file: it does not begin with ISO-10303-21;"},
        {BEGIN "DATA/* no end\n" END, "line 3", "a comment that does not end"},
        {BEGIN "#1=A();\n/* no end" END, "line 3", "a comment that does not end"},
        {BEGIN "#1=A('no end);\n" END, "line 4", "a string that does not end"},
        {BEGIN "#1=A(.no end);\n"
               "END-ISO-10303-21;\n",
         "line 4", "an enumeration that does not end"},
        {BEGIN "#1=A(1E);\n" END, "line 2", "half a number"},
        {BEGIN "#1=A(1E308);\n" END, "line 2", "a number of 1e308 or more"},
        {BEGIN "#1=A(NAN);\n" END, "line 2", "found a word where a value is expected"},
        {BEGIN "#1=A(1;\n" END, "line 2", "parentheses that do not match"},
        {BEGIN "#1=A)\n" END, "line 2", "parentheses that do not match"},
        {BEGIN "#1=A();\n", "line 3", "the file is broken off: END-ISO-10303-21; is missing"},
    };
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        taut_error error = {.status = TAUT_OK};
        const taut_status status = taut_cad_scan_step(rows[i].text, strlen(rows[i].text), &error);
        check_told(status, &error, rows[i].where, rows[i].message, rows[i].text);
    }
}

/* A hundred parentheses in one another are fine, one more is not. */
static void test_depth(void)
{
    for (int depth = 100; depth <= 101; depth++) {
        char text[300] = BEGIN;
        taut_error error = {.status = TAUT_OK};
        memset(text + strlen(text), '(', (size_t)depth);
        memset(text + strlen(text), ')', (size_t)depth);
        memcpy(text + strlen(text), END, sizeof END);
        check_told(taut_cad_scan_step(text, strlen(text), &error), &error, "line 2",
                   depth > 100 ? "more than 100 parentheses in one another" : NULL, text);
    }
}

static void test_zero_byte(void)
{
    static const char text[] = BEGIN "#1=A();\n\0" END;
    taut_error error = {.status = TAUT_OK};
    check_told(taut_cad_scan_step(text, sizeof text - 1, &error), &error, "line 3",
               "a byte that is 0", text);
}

/* Lines of a drawing, S and T put around them: "G1H,,1H;,", "P110,0.;". Every two lines of D are
 * an entity of one line of parameters, and every line of P is the first one's, whose lines are
 * counted. */
static size_t drawing(const char *const *lines, char *text)
{
    static const char letters[] = "SGDP";
    int counts[4] = {1, 0, 0, 0}, parameters = 0;
    size_t n = (size_t)sprintf(text, "%-72sS%7d\n", "a test", 1);
    for (int i = 0; lines[i] != NULL; i++) {
        parameters += lines[i][0] == 'P';
    }
    for (int i = 0; lines[i] != NULL; i++) {
        const int section = (int)(strchr(letters, lines[i][0]) - letters);
        char content[80];
        counts[section]++;
        if (section == 2 && counts[2] % 2 == 1) {
            snprintf(content, sizeof content, "%8d%8d", 110, 1);
        } else if (section == 2) {
            snprintf(content, sizeof content, "%8d%8d%8d%8d", 110, 0, 0, parameters);
        } else {
            snprintf(content, sizeof content, section == 3 ? "%-64s%8d" : "%s", lines[i] + 1, 1);
        }
        n += (size_t)sprintf(text + n, "%-72s%c%7d\n", content, lines[i][0], counts[section]);
    }
    n += (size_t)sprintf(text + n, "S%7dG%7dD%7dP%7d%40sT%7d\n", counts[0], counts[1], counts[2],
                         counts[3], "", 1);
    return n;
}

#define GLOBAL "G1H,,1H;,4Htest;"
static const char not_a_number[] = "found something else where a number below 1e308 is expected";

static void test_iges(void)
{
    static const struct {
        const char *lines[8], *where, *message;
    } rows[] = {
        {{GLOBAL, "D", "D", "P110,0.,0.,0.,1.D0,1.,1.;"}, NULL, NULL},
        {{GLOBAL, "D", "D", "P110,0.,NAN,0.;"}, "line 5", not_a_number},
        {{GLOBAL, "D", "D", "P110,0.,1.E308;"}, "line 5", not_a_number},
        {{GLOBAL, "D", "D", "P110 ,  0. ,1. , ,1.D-2;"}, NULL, NULL},
        {{GLOBAL, "D", "D", "P110,0. 1.;"}, "line 5", not_a_number},
        /* a text is passed over with the commas and semicolons in it, and what follows is not */
        {{GLOBAL, "D", "D", "P110,0.,7HNAN,;,x,1.;"}, NULL, NULL},
        {{GLOBAL, "D", "D", "P110,0.,7HNAN,;,x,NAN;"}, "line 5", not_a_number},
        {{GLOBAL, "D", "D", "P110,0.,0H,1.;"}, NULL, NULL},
        {{GLOBAL, "D", "D", "P110,0.,-3Habc;"}, "line 5", not_a_number},
        /* ...also where it goes on in the next line, or fills more than one */
        {{GLOBAL, "D", "D", "P110,0.,60HNAN,", "PNAN   ,1.;"}, NULL, NULL},
        {{GLOBAL, "D", "D", "P110,0.,60HNAN,", "PNAN   ,NAN;"}, "line 6", not_a_number},
        {{GLOBAL, "D", "D", "P110,0.,124HNAN,", "PNAN,NAN", "PNAN   ,NAN;"},
         "line 7",
         not_a_number},
        /* only the usual marks, spelled out or left out, are known */
        {{"G,,4Htest;", "D", "D", "P110,NAN;"}, "line 5", not_a_number},
        {{"G1H,,,4Htest;", "D", "D", "P110,NAN;"}, "line 5", not_a_number},
        {{"G1H/,1H;/4Htest;", "D", "D", "P110/NAN;"}, NULL, NULL},
        /* only geometry is looked at: 406 is a property */
        {{GLOBAL, "D", "D", "P406,1,NAN;"}, NULL, NULL},
        {{GLOBAL, "D", "D", "P110,0.;", "D"}, "line 6", "sections out of order"},
        {{"D", "G"}, "line 3", "sections out of order"},
    };
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        char text[12 * 82];
        taut_error error = {.status = TAUT_OK};
        const size_t length = drawing(rows[i].lines, text);
        check_told(taut_cad_scan_iges(text, length, &error), &error, rows[i].where, rows[i].message,
                   text);
    }
}

int main(void)
{
    test_step();
    test_depth();
    test_zero_byte();
    test_iges();
    return check_failures != 0;
}
