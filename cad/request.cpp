/* request.cpp -- reading a request. It comes from libtaut, and is looked at all the same. */
#include "request.hpp"

#include "occt.hpp"

#include <cstring>

static const int words_max = 1 << 16, notes_max = 100, items_max = 200000;
static const size_t numbers_max = 150000000; /* three coordinates of the largest net */

static void get_bytes(FILE *from, void *to, size_t size)
{
    if (size > 0 && std::fread(to, size, 1, from) != 1) {
        throw occt_failure(TAUT_INTERNAL, "fault", "the request of taut-cad is cut off");
    }
}

static void check(bool is_right)
{
    if (!is_right) {
        throw occt_failure(TAUT_INTERNAL, "fault", "the request of taut-cad is none");
    }
}

const char *request::read_words(FILE *from)
{
    int length = 0;
    get_bytes(from, &length, sizeof length);
    check(length >= 0 && length <= words_max);
    words.emplace_back(static_cast<size_t>(length), '\0');
    get_bytes(from, &words.back()[0], static_cast<size_t>(length));
    return words.back().c_str();
}

const double *request::read_numbers(FILE *from, size_t room)
{
    check(room <= numbers_max);
    numbers.emplace_back(room);
    get_bytes(from, numbers.back().data(), room * sizeof(double));
    return numbers.back().data();
}

void request::read_job(FILE *from)
{
    const taut_cad_hello expected = taut_cad_hello_request();
    taut_cad_hello hello = {};
    int head[4] = {0, 0, 0, 0}; /* kind, items, notes, edges */

    get_bytes(from, &hello, sizeof hello);
    check(std::memcmp(&hello, &expected, sizeof hello) == 0);
    get_bytes(from, head, sizeof head);
    check((head[0] == TAUT_CAD_STEP || head[0] == TAUT_CAD_IGES) && head[1] >= 0 &&
          head[1] <= items_max && head[2] >= 0 && head[2] <= notes_max);
    job.kind = static_cast<taut_cad_kind>(head[0]);
    job.edges = head[3];
    count = head[1];
    get_bytes(from, &job.precision, sizeof job.precision);
    job.path = read_words(from);
    job.unit = read_words(from);
    job.name = read_words(from);
    job.date = read_words(from);
    for (int i = 0; i < head[2]; i++) {
        notes.push_back(read_words(from));
    }
    job.notes = notes.data();
    job.note_count = head[2];
}

void request::read_item(FILE *from)
{
    taut_cad_item_head head = {};
    taut_cad_item item = {};
    char tag = 0;

    get_bytes(from, &tag, 1);
    get_bytes(from, &head, sizeof head);
    check(tag == 'I' && head.name_length >= 0 && head.name_length <= words_max &&
          head.product_length >= 0 && head.product_length <= words_max && head.degree[0] >= 1 &&
          head.degree[0] < head.count[0] && head.count[1] >= 0 &&
          (head.count[1] == 0 || head.degree[1] >= 1) && head.degree[1] >= 0 &&
          head.degree[1] <= head.count[1]);
    words.emplace_back(static_cast<size_t>(head.name_length), '\0');
    get_bytes(from, &words.back()[0], static_cast<size_t>(head.name_length));
    item.name = words.back().c_str();
    words.emplace_back(static_cast<size_t>(head.product_length), '\0');
    get_bytes(from, &words.back()[0], static_cast<size_t>(head.product_length));
    item.product = words.back().c_str();
    for (int d = 0; d < 2; d++) {
        item.degree[d] = head.degree[d];
        item.count[d] = head.count[d];
        item.knots[d] = read_numbers(from, taut_cad_knot_count(&head, d));
    }
    const size_t n = taut_cad_point_count(&head);
    check(n <= numbers_max / 3);
    item.points = read_numbers(from, 3 * n);
    item.weights = head.is_rational != 0 ? read_numbers(from, n) : nullptr;
    items.push_back(item);
}

void request::read_items(FILE *from)
{
    for (int i = 0; i < count; i++) {
        read_item(from);
    }
}
