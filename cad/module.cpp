/* module.cpp -- STEP and IGES by OpenCASCADE: the table, and where its exceptions end. */
#include "occt.hpp"

#include <Standard_Failure.hxx>
#include <Standard_OutOfMemory.hxx>

#include <cmath>
#include <cstdio>
#include <cstring>
#include <new>

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

static taut_status cad_write(const taut_cad_job *job, int count, const taut_cad_item *items,
                             taut_error *error)
{
    return guard(TAUT_INTERNAL, error, [&] { occt_write_iges(*job, count, items); });
}

static taut_status cad_read(const taut_cad_job *job, const taut_cad_sink *sink, taut_error *error)
{
    return guard(TAUT_BAD_INPUT, error, [&] {
        occt_names names;
        const TopoDS_Shape shape = job->kind == TAUT_CAD_STEP ? occt_read_step(*job, *sink, names)
                                                              : occt_read_iges(*job, *sink, names);
        occt_give(shape, names, *sink);
    });
}

extern "C" {
extern TAUT_API const taut_cad_ops taut_module_table;
const taut_cad_ops taut_module_table = {cad_write, cad_read};
}
