#include "io/cad/wire.h"

#include "taut/limits.h"

#include <string.h>

/* The sizes of what is sent as it lies; that both ends have the same order of bytes shows in the number itself. */
static unsigned layout_of_wire(void)
{
    return (unsigned)(sizeof(int) + 16 * sizeof(double) + 256 * sizeof(taut_cad_item_head) +
                      65536 * sizeof(taut_error));
}

static taut_cad_hello hello_of(const char mark[TAUT_CAD_MARK + 1])
{
    taut_cad_hello hello = {.version = TAUT_CAD_VERSION, .layout = layout_of_wire()};
    memcpy(hello.mark, mark, TAUT_CAD_MARK);
    return hello;
}

taut_cad_hello taut_cad_hello_request(void)
{
    return hello_of("tautcad?");
}

taut_cad_hello taut_cad_hello_answer(void)
{
    return hello_of("tautcad!");
}

double taut_cad_seconds(double size)
{
    return 20 + 2e-5 * size;
}

double taut_cad_memory(double size)
{
    return 1e9 + 400 * size;
}

size_t taut_cad_knot_count(const taut_cad_item_head *head, int d)
{
    return head->count[d] > 0 ? (size_t)head->count[d] + (size_t)head->degree[d] + 1 : 0;
}

size_t taut_cad_point_count(const taut_cad_item_head *head)
{
    return (size_t)head->count[0] * (head->count[1] > 0 ? (size_t)head->count[1] : 1);
}

static int put_bytes(FILE *file, const void *bytes, size_t size, size_t count)
{
    return count == 0 || fwrite(bytes, size, count, file) == count;
}

int taut_cad_put_hello(FILE *file, taut_cad_hello hello)
{
    return put_bytes(file, &hello, sizeof hello, 1);
}

int taut_cad_put_unit(FILE *file, const char *unit)
{
    char bytes[TAUT_CAD_UNIT] = "";
    memcpy(bytes, unit, strlen(unit) < TAUT_CAD_UNIT ? strlen(unit) : TAUT_CAD_UNIT - 1);
    return put_bytes(file, "U", 1, 1) && put_bytes(file, bytes, 1, TAUT_CAD_UNIT);
}

static int name_length(const char *name)
{
    const size_t length = name != NULL ? strlen(name) : 0;
    return length < TAUT_NAME_MAX ? (int)length : TAUT_NAME_MAX;
}

int taut_cad_put_item(FILE *file, const taut_cad_item *item)
{
    taut_cad_item_head head = {{item->degree[0], item->degree[1]},
                               {item->count[0], item->count[1]},
                               item->weights != NULL,
                               item->notes,
                               name_length(item->name),
                               name_length(item->product),
                               item->colour,
                               item->instance,
                               {0}};
    memcpy(head.place, item->place, sizeof head.place);
    const size_t n = taut_cad_point_count(&head);
    return put_bytes(file, "I", 1, 1) && put_bytes(file, &head, sizeof head, 1) &&
           put_bytes(file, item->name, 1, (size_t)head.name_length) &&
           put_bytes(file, item->product, 1, (size_t)head.product_length) &&
           put_bytes(file, item->knots[0], sizeof(double), taut_cad_knot_count(&head, 0)) &&
           put_bytes(file, item->knots[1], sizeof(double), taut_cad_knot_count(&head, 1)) &&
           put_bytes(file, item->points, 3 * sizeof(double), n) &&
           put_bytes(file, item->weights, sizeof(double), head.is_rational ? n : 0);
}

/* The first `most` bytes of a text, after their number. */
static int put_some(FILE *file, const char *tag, const char *text, size_t most)
{
    const size_t whole = strlen(text);
    const int length = (int)(whole < most ? whole : most);
    return put_bytes(file, tag, 1, 1) && put_bytes(file, &length, sizeof length, 1) &&
           put_bytes(file, text, 1, (size_t)length);
}

int taut_cad_put_product(FILE *file, const char *name)
{
    return put_some(file, "P", name, TAUT_NAME_MAX);
}

int taut_cad_put_note(FILE *file, const char *note)
{
    return put_some(file, "N", note, TAUT_CAD_NOTE_MAX);
}

int taut_cad_put_text(FILE *file, const char *text, size_t length)
{
    while (length > 0) {
        const int part = length < TAUT_CAD_TEXT_MAX ? (int)length : TAUT_CAD_TEXT_MAX;
        if (!put_bytes(file, "T", 1, 1) || !put_bytes(file, &part, sizeof part, 1) ||
            !put_bytes(file, text, 1, (size_t)part)) {
            return 0;
        }
        text += part;
        length -= (size_t)part;
    }
    return 1;
}

int taut_cad_put_end(FILE *file, taut_status status, const taut_error *error)
{
    const int number = (int)status;
    return put_bytes(file, "E", 1, 1) && put_bytes(file, &number, sizeof number, 1) &&
           put_bytes(file, error, sizeof *error, 1) && fflush(file) == 0;
}

/* NULL goes as "". */
static int put_words(FILE *file, const char *words)
{
    const int length = words != NULL ? (int)strlen(words) : 0;
    return put_bytes(file, &length, sizeof length, 1) && put_bytes(file, words, 1, (size_t)length);
}

static int put_job(FILE *file, const taut_cad_job *job, int count)
{
    const int numbers[4] = {(int)job->kind, count, job->note_count, job->edges != 0};
    int whole = put_bytes(file, numbers, sizeof numbers, 1) &&
                put_bytes(file, &job->precision, sizeof job->precision, 1) &&
                put_words(file, job->path) && put_words(file, job->unit) &&
                put_words(file, job->name) && put_words(file, job->date);
    for (int i = 0; whole && i < job->note_count; i++) {
        whole = put_words(file, job->notes[i]);
    }
    return whole;
}

int taut_cad_put_request(FILE *file, const taut_cad_job *job, int count, const taut_cad_item *items)
{
    int whole = taut_cad_put_hello(file, taut_cad_hello_request()) && put_job(file, job, count);
    for (int i = 0; whole && i < count; i++) {
        whole = taut_cad_put_item(file, &items[i]);
    }
    return whole && fflush(file) == 0;
}
