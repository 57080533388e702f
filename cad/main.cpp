/* main.cpp -- taut-cad: one request on standard input, one answer on standard output (io/cad/wire.h).
 *
 *     say who it is; limit itself; read the request; work; say how it went
 *
 * Where OpenCASCADE's exceptions end. What it prints goes nowhere; what it breaks is this process.
 */
#include "occt.hpp"
#include "request.hpp"

#include <Standard_Failure.hxx>
#include <Standard_OutOfMemory.hxx>
#include <Standard_Version.hxx>

#include <cmath>
#include <cstdio>
#include <cstring>
#include <new>

#include <fcntl.h>
#include <unistd.h>

/* Runs `work`; what it throws becomes a status, a word and a message, `blame` where the library
 * fails. */
template <class Work> static taut_status guard(taut_status blame, taut_error *error, Work work)
{
    taut_status status = TAUT_OK;
    const char *reason = "library";
    std::string message;
    try {
        work();
    } catch (const occt_failure &failure) {
        status = failure.status;
        reason = failure.reason;
        message = failure.what();
    } catch (const Standard_OutOfMemory &) {
        status = TAUT_NO_MEMORY;
    } catch (const std::bad_alloc &) {
        status = TAUT_NO_MEMORY;
    } catch (const Standard_Failure &failure) {
        status = blame;
        message = std::string("OpenCASCADE failed: ") + failure.DynamicType()->Name();
    } catch (...) {
        status = blame;
        message = "OpenCASCADE failed";
    }
    if (status != TAUT_OK && error != nullptr) {
        std::memset(error, 0, sizeof *error);
        error->status = status;
        error->found = error->limit = std::nan("");
        std::snprintf(error->reason, sizeof error->reason, "%s",
                      status == TAUT_NO_MEMORY ? "memory" : reason);
        std::snprintf(error->message, sizeof error->message, "%s",
                      status == TAUT_NO_MEMORY ? "memory ran out" : message.c_str());
    }
    return status;
}

static int put_unit(void *answer, const char *unit)
{
    return taut_cad_put_unit(static_cast<FILE *>(answer), unit);
}

static int put_item(void *answer, const taut_cad_item *item)
{
    return taut_cad_put_item(static_cast<FILE *>(answer), item);
}

static int put_note(void *answer, const char *note)
{
    return taut_cad_put_note(static_cast<FILE *>(answer), note);
}

static int put_product(void *answer, const char *name)
{
    return taut_cad_put_product(static_cast<FILE *>(answer), name);
}

static void read_file(const taut_cad_job &job, FILE *answer)
{
    const occt_sink sink = {answer, put_unit, put_item, put_note, put_product};
    occt_names names;
    const TopoDS_Shape shape = job.kind == TAUT_CAD_STEP ? occt_read_step(job, sink, names)
                                                         : occt_read_iges(job, sink, names);
    occt_give(shape, names, job.edges != 0, sink);
}

static void write_file(const request &asked, FILE *answer)
{
    const std::string text =
        occt_write_iges(asked.job, static_cast<int>(asked.items.size()), asked.items.data());
    if (!taut_cad_put_text(answer, text.data(), text.size())) {
        throw occt_failure(TAUT_IO, "write", "what was written could not be passed on");
    }
}

static taut_status work(FILE *answer, taut_error *error)
{
    request asked;
    taut_status blame = TAUT_INTERNAL;
    const taut_status status = guard(blame, error, [&] { asked.read_job(stdin); });
    if (status != TAUT_OK) {
        return status;
    }
    limit_process(asked.job.path);
    blame = asked.is_reading() ? TAUT_BAD_INPUT : TAUT_INTERNAL;
    return guard(blame, error, [&] {
        asked.read_items(stdin);
        if (asked.is_reading()) {
            read_file(asked.job, answer);
        } else {
            write_file(asked, answer);
        }
    });
}

/* A stream of its own for the answer: what libraries print on standard output would be in it. */
static FILE *open_answer()
{
    const int kept = fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, STDERR_FILENO + 1);
    const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
    if (kept < 0 || nowhere < 0 || dup2(nowhere, STDOUT_FILENO) < 0 ||
        dup2(nowhere, STDERR_FILENO) < 0) {
        return nullptr;
    }
    return fdopen(kept, "wb");
}

int main(int count, char **words)
{
    taut_error error = {};
    if (count > 1) {
        const bool asks = std::strcmp(words[1], "--version") == 0;
        std::fprintf(asks ? stdout : stderr, "taut-cad, protocol %d, OpenCASCADE %s%s\n",
                     TAUT_CAD_VERSION, OCC_VERSION_COMPLETE,
                     asks ? "" : ": started by libtaut, it takes no arguments");
        return asks ? 0 : 2;
    }
    settle_process();
    FILE *answer = open_answer();
    if (answer == nullptr || !taut_cad_put_hello(answer, taut_cad_hello_answer()) ||
        std::fflush(answer) != 0) {
        _exit(1);
    }
    const taut_status status = work(answer, &error);
    _exit(taut_cad_put_end(answer, status, &error)
              ? 0
              : 1); /* what else would be freed, the system frees */
}
