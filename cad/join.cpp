/* join.cpp -- what taut writes as several faces, cut at knots that are there as often as the degree, is read as the one
 * surface that it was.
 *
 *     two surfaces, one after the other, of one name, product, place and colour, are one where the second goes on in u or v
 *     at the knot at which the first ends, with the same points, the same weights there and the same knots across
 *
 * All of it bit for bit, and only in files that say that taut wrote them: what others cut stays cut.
 */
#include "occt.hpp"
#include "taut/limits.h"

#include <utility>

occt_joiner::occt_joiner(const occt_sink &to, bool own) : sink(to), is_own(own)
{
}

static taut_cad_item item_of(const occt_surface &s)
{
    taut_cad_item item = s.item;
    item.name = s.name.c_str();
    item.knots[0] = s.knots[0].data();
    item.knots[1] = s.knots[1].data();
    item.points = s.points.data();
    item.weights = s.is_rational ? s.weights.data() : nullptr;
    return item;
}

static bool are_alike(const occt_surface &a, const occt_surface &b)
{
    const taut_cad_item &p = a.item, &q = b.item;
    return a.name == b.name && std::string(p.product) == q.product && p.colour == q.colour &&
           p.instance == q.instance && p.notes == 0 && q.notes == 0 && p.degree[0] == q.degree[0] &&
           p.degree[1] == q.degree[1];
}

/* Does b go on in direction d where a ends? */
static bool goes_on(const occt_surface &a, const occt_surface &b, int d)
{
    const int other = 1 - d, last = a.item.count[d] - 1, across = a.item.count[other];
    if (!are_alike(a, b) || a.item.degree[d] < 2 || a.knots[other] != b.knots[other] ||
        a.knots[d].back() != b.knots[d].front() ||
        a.item.count[d] >= TAUT_COUNT_MAX - b.item.count[d] ||
        a.weights.size() + b.weights.size() > TAUT_POINTS_MAX) {
        return false;
    }
    for (int i = 0; i < across; i++) {
        const int at[2] = {d == 0 ? last * across + i : i * (last + 1) + last,
                           d == 0 ? i : i * b.item.count[1]};
        const auto p = static_cast<size_t>(at[0]), q = static_cast<size_t>(at[1]);
        if (a.weights[p] != b.weights[q] || a.points[3 * p] != b.points[3 * q] ||
            a.points[3 * p + 1] != b.points[3 * q + 1] ||
            a.points[3 * p + 2] != b.points[3 * q + 2]) {
            return false;
        }
    }
    return true;
}

/* Numbers in rows, `size` a point: those of b behind those of a, without b's first. */
static std::vector<double> behind(const occt_surface &a, const occt_surface &b, int d,
                                  const std::vector<double> &x, const std::vector<double> &y,
                                  size_t size)
{
    const auto row = size * static_cast<size_t>(d == 0 ? 1 : a.item.count[1]);
    const auto more = size * static_cast<size_t>(d == 0 ? 1 : b.item.count[1]);
    const size_t skip = d == 0 ? size * static_cast<size_t>(b.item.count[1]) : size;
    std::vector<double> both;
    if (d == 0) {
        both = x;
        both.insert(both.end(), y.begin() + static_cast<std::ptrdiff_t>(skip), y.end());
        return both;
    }
    for (size_t i = 0; i < static_cast<size_t>(a.item.count[0]); i++) {
        const auto p = x.begin() + static_cast<std::ptrdiff_t>(i * row);
        const auto q = y.begin() + static_cast<std::ptrdiff_t>(i * more);
        both.insert(both.end(), p, p + static_cast<std::ptrdiff_t>(row));
        both.insert(both.end(), q + static_cast<std::ptrdiff_t>(skip),
                    q + static_cast<std::ptrdiff_t>(more));
    }
    return both;
}

static void join(occt_surface &a, const occt_surface &b, int d)
{
    a.points = behind(a, b, d, a.points, b.points, 3);
    a.weights = behind(a, b, d, a.weights, b.weights, 1);
    a.is_rational = a.is_rational || b.is_rational;
    a.knots[d].pop_back();
    a.knots[d].insert(a.knots[d].end(), b.knots[d].begin() + a.item.degree[d] + 1,
                      b.knots[d].end());
    a.item.count[d] += b.item.count[d] - 1;
}

/* Rows of pieces come one after the other: one that is complete, one that is not. */
void occt_joiner::add(occt_surface surface)
{
    held.push_back(std::move(surface));
    for (int d = 1; is_own && held.size() > 1 && d >= 0;) {
        occt_surface &a = held[held.size() - 2];
        if (goes_on(a, held.back(), d)) {
            join(a, held.back(), d);
            held.pop_back();
            d = 1;
        } else {
            d--;
        }
    }
    while (held.size() > 2) {
        give();
    }
}

void occt_joiner::give()
{
    const taut_cad_item item = item_of(held.front());
    if (!sink.item(sink.context, &item)) {
        throw occt_failure(TAUT_IO, "write", "what was read could not be passed on");
    }
    held.erase(held.begin());
}

void occt_joiner::end()
{
    while (!held.empty()) {
        give();
    }
}
