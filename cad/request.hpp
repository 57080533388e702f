/* request.hpp -- what taut-cad is asked, and what it allows itself for that. */
#ifndef TAUT_CAD_REQUEST_HPP
#define TAUT_CAD_REQUEST_HPP

#include "io/cad/wire.h"

#include <deque>
#include <string>
#include <vector>

/* Its numbers are kept here. What does not begin as a request of this version does, or holds what none does, is
 * an occt_failure. */
struct request {
    taut_cad_job job = {};
    int count = 0; /* of items; none: a file is to be read */
    std::vector<taut_cad_item> items;

    bool is_reading() const
    {
        return count == 0;
    }
    void read_job(FILE *from);
    void read_items(FILE *from);

  private:
    std::deque<std::string> words;
    std::deque<std::vector<double>> numbers; /* a deque, as what it holds does not move */
    std::vector<const char *> notes;

    const char *read_words(FILE *from);
    const double *read_numbers(FILE *from, size_t room);
    void read_item(FILE *from);
};

/* First of all: nothing is left behind of a crash, no file is written, the end of a reader is no signal, and time and memory are in
 * proportion to the request. */
void settle_process();
/* Then, before OpenCASCADE sees anything: in proportion to the request and the file `path`, for good. */
void limit_process(const char *path);

#endif /* TAUT_CAD_REQUEST_HPP */
