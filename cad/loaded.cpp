/* loaded.cpp -- what a reader found fault with, entity by entity.
 *
 *     broken entity of a STEP file     every face that it is a part of is left out; a part of none: the file is refused
 *     face that nothing was made of    named, with what the library says
 */
#include "occt.hpp"

#include <Interface_Check.hxx>
#include <Interface_EntityIterator.hxx>
#include <Interface_Graph.hxx>
#include <Interface_ReportEntity.hxx>
#include <StepGeom_BSplineSurface.hxx>
#include <StepGeom_Pcurve.hxx>
#include <StepGeom_Surface.hxx>
#include <StepRepr_RepresentationItem.hxx>
#include <StepShape_FaceSurface.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TransferBRep.hxx>
#include <Transfer_Binder.hxx>
#include <Transfer_TransientProcess.hxx>

#include <set>
#include <vector>

static std::string label_of(const Handle(Interface_InterfaceModel) & model,
                            const Handle(Standard_Transient) & entity)
{
    return model->StringLabel(entity)->ToCString();
}

static void check_whole(const Handle(Interface_InterfaceModel) & model)
{
    const Handle(Interface_Check) check = model->GlobalCheck();
    if (check->HasFailed()) {
        throw occt_failure(TAUT_BAD_INPUT, "broken",
                           std::string("the file is broken: ") + check->CFail(1));
    }
}

/* What is wrong with an entity of a kind; empty: nothing. */
static std::string fault_of(const Handle(Interface_InterfaceModel) & model, int i,
                            const Handle(Standard_Type) & needed)
{
    if (!model->IsReportEntity(i) || !model->Value(i)->IsKind(needed)) {
        return "";
    }
    const Handle(Interface_Check) check = model->ReportEntity(i)->Check();
    if (!check->HasFailed()) {
        return "";
    }
    const std::string words = check->CFail(1);
    const bool is_unknown = words.find("illegal type") != std::string::npos &&
                            words.find("face_geometry") != std::string::npos;
    return "entity " + label_of(model, model->Value(i)) + " is broken: " +
           (is_unknown ? "its surface is of a kind that OpenCASCADE does not know" : words);
}

void occt_check_loaded(const Handle(Interface_InterfaceModel) & model,
                       const Handle(Standard_Type) & needed)
{
    check_whole(model);
    for (int i = 1; i <= model->NbEntities(); i++) {
        const std::string fault = fault_of(model, i, needed);
        if (!fault.empty()) {
            throw occt_failure(TAUT_BAD_INPUT, "broken", fault);
        }
    }
}

/* All faces that an entity is a part of, but for traces of their neighbours' edges. */
static std::vector<Handle(StepShape_FaceSurface)>
faces_over(const Interface_Graph &graph, const Handle(Standard_Transient) & entity)
{
    std::vector<Handle(StepShape_FaceSurface)> faces;
    std::vector<Handle(Standard_Transient)> open = {entity};
    std::set<const Standard_Transient *> known = {entity.get()};
    while (!open.empty()) {
        const Handle(Standard_Transient) at = open.back();
        open.pop_back();
        if (at->IsKind(STANDARD_TYPE(StepShape_FaceSurface))) {
            faces.push_back(Handle(StepShape_FaceSurface)::DownCast(at));
            continue;
        }
        if (at->IsKind(STANDARD_TYPE(StepGeom_Pcurve))) {
            continue; /* where an edge is in a surface: the edge of a neighbour can be had without */
        }
        for (Interface_EntityIterator up = graph.Sharings(at); up.More(); up.Next()) {
            if (known.insert(up.Value().get()).second) {
                open.push_back(up.Value());
            }
        }
    }
    return faces;
}

void occt_leave_out_broken(const Handle(Interface_InterfaceModel) & model, occt_faults &faults)
{
    std::vector<std::pair<int, std::string>> broken;
    check_whole(model);
    for (int i = 1; i <= model->NbEntities(); i++) {
        const std::string fault = fault_of(model, i, STANDARD_TYPE(StepRepr_RepresentationItem));
        if (!fault.empty()) {
            broken.emplace_back(i, fault);
        }
    }
    if (broken.empty()) {
        return;
    }
    const Interface_Graph graph(model);
    for (const auto &part : broken) {
        const auto faces = faces_over(graph, model->Value(part.first));
        if (faces.empty() && !model->Value(part.first)->IsKind(STANDARD_TYPE(StepGeom_Pcurve))) {
            throw occt_failure(TAUT_BAD_INPUT, "broken", part.second);
        }
        for (const Handle(StepShape_FaceSurface) & face : faces) {
            faults.emplace(face.get(), part.second);
            face->SetFaceGeometry(nullptr); /* so that there will be no face */
        }
    }
}

/* What the library says where it makes nothing of an entity; empty: nothing. */
static std::string words_of(const Handle(Transfer_TransientProcess) & process,
                            const Handle(Standard_Transient) & entity)
{
    const int mapped = entity.IsNull() ? 0 : process->MapIndex(entity);
    const Handle(Transfer_Binder) binder = mapped > 0 ? process->MapItem(mapped) : nullptr;
    const Handle(Interface_Check) check = binder.IsNull() ? nullptr : binder->Check();
    return check.IsNull() || !check->HasFailed() ? "" : check->CFail(1);
}

/* Why nothing was made of a face that is not broken itself. */
static std::string excuse_of(const Handle(Interface_InterfaceModel) & model,
                             const Handle(Transfer_TransientProcess) & process,
                             const Handle(StepShape_FaceSurface) & face)
{
    const Handle(StepGeom_Surface) surface = face->FaceGeometry();
    if (!surface.IsNull() && surface->IsKind(STANDARD_TYPE(StepGeom_BSplineSurface))) {
        return "OpenCASCADE makes no spline of entity " + label_of(model, surface) +
               ": its degrees, knots, multiplicities and points do not agree, or it is a point";
    }
    const std::string words = words_of(process, surface), own = words_of(process, face);
    return !words.empty() ? words : !own.empty() ? own : "OpenCASCADE makes no face of it";
}

int occt_name_left_out(const Handle(Interface_InterfaceModel) & model,
                       const Handle(Transfer_TransientProcess) & process, const occt_faults &faults,
                       const occt_sink &sink)
{
    int count = 0;
    for (int i = 1; i <= model->NbEntities(); i++) {
        const Handle(StepShape_FaceSurface) face =
            Handle(StepShape_FaceSurface)::DownCast(model->Value(i));
        const int mapped = face.IsNull() ? 0 : process->MapIndex(face);
        const Handle(Transfer_Binder) binder = mapped > 0 ? process->MapItem(mapped) : nullptr;
        if (face.IsNull() || (!binder.IsNull() && !TransferBRep::ShapeResult(binder).IsNull())) {
            continue;
        }
        const auto fault = faults.find(face.get());
        const std::string name = face->Name().IsNull() ? "" : face->Name()->ToCString();
        const std::string note =
            "face " + label_of(model, face) + " of the file, \"" + name + "\", is left out: " +
            (fault != faults.end() ? fault->second : excuse_of(model, process, face));
        occt_say(sink, note);
        count++;
    }
    return count;
}
