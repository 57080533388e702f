/* loaded.cpp -- what a reader found fault with, in files of either kind. */
#include "occt.hpp"

#include <Interface_Check.hxx>
#include <Interface_ReportEntity.hxx>
#include <TCollection_HAsciiString.hxx>
#include <Transfer_Binder.hxx>

std::string occt_label(const Handle(Interface_InterfaceModel) & model,
                       const Handle(Standard_Transient) & entity)
{
    return model->StringLabel(entity)->ToCString();
}

void occt_check_whole(const Handle(Interface_InterfaceModel) & model)
{
    const Handle(Interface_Check) check = model->GlobalCheck();
    if (check->HasFailed()) {
        throw occt_failure(TAUT_BAD_INPUT, "broken",
                           std::string("the file is broken: ") + check->CFail(1));
    }
}

/* The library's own words, where they are whole: some of its messages are not in its table, some keep their place for a number. */
static std::string words_or(const Handle(Interface_Check) & check, const std::string &otherwise)
{
    const std::string words = check->CFail(1);
    const bool is_whole = words.find("Unknown message") == std::string::npos &&
                          words.find('%') == std::string::npos && !words.empty();
    return is_whole ? words : otherwise;
}

std::string occt_fault(const Handle(Interface_InterfaceModel) & model, int i,
                       const Handle(Standard_Type) & needed)
{
    if (!model->IsReportEntity(i) || !model->Value(i)->IsKind(needed)) {
        return "";
    }
    const Handle(Interface_Check) check = model->ReportEntity(i)->Check();
    if (!check->HasFailed()) {
        return "";
    }
    const std::string words = words_or(check, "its numbers are not those of its type");
    const bool is_unknown = words.find("illegal type") != std::string::npos &&
                            words.find("face_geometry") != std::string::npos;
    return "entity " + occt_label(model, model->Value(i)) + " is broken: " +
           (is_unknown ? "its surface is of a kind that OpenCASCADE does not know" : words);
}

std::string occt_words(const Handle(Transfer_TransientProcess) & process,
                       const Handle(Standard_Transient) & entity)
{
    const int mapped = entity.IsNull() ? 0 : process->MapIndex(entity);
    const Handle(Transfer_Binder) binder = mapped > 0 ? process->MapItem(mapped) : nullptr;
    const Handle(Interface_Check) check = binder.IsNull() ? nullptr : binder->Check();
    return check.IsNull() || !check->HasFailed() ? "" : words_or(check, "");
}

void occt_say_left_out(const occt_sink &sink, const std::string &what, const std::string &name,
                       const std::string &why)
{
    occt_say(sink, what + " of the file, \"" + name + "\", is left out: " + why);
}
