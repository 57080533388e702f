/* loaded_step.cpp -- what a reader of STEP found fault with, entity by entity.
 *
 *     broken entity                    every face that it is a part of is left out; a part of none: the file is refused
 *     face that nothing was made of    named, with what the library says
 */
#include "occt.hpp"

#include <Interface_EntityIterator.hxx>
#include <Interface_Graph.hxx>
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

void occt_leave_out_broken_step(const Handle(Interface_InterfaceModel) & model, occt_faults &faults)
{
    std::vector<std::pair<int, std::string>> broken;
    occt_check_whole(model);
    for (int i = 1; i <= model->NbEntities(); i++) {
        const std::string fault = occt_fault(model, i, STANDARD_TYPE(StepRepr_RepresentationItem));
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

/* Why nothing was made of a face that is not broken itself. */
static std::string excuse_of(const Handle(Interface_InterfaceModel) & model,
                             const Handle(Transfer_TransientProcess) & process,
                             const Handle(StepShape_FaceSurface) & face)
{
    const Handle(StepGeom_Surface) surface = face->FaceGeometry();
    if (!surface.IsNull() && surface->IsKind(STANDARD_TYPE(StepGeom_BSplineSurface))) {
        return "OpenCASCADE makes no spline of entity " + occt_label(model, surface) +
               ": its degrees, knots, multiplicities and points do not agree, or it is a point";
    }
    const std::string words = occt_words(process, surface), own = occt_words(process, face);
    return !words.empty() ? words : !own.empty() ? own : "OpenCASCADE makes no face of it";
}

int occt_name_left_out_step(const Handle(Interface_InterfaceModel) & model,
                            const Handle(Transfer_TransientProcess) & process,
                            const occt_faults &faults, const occt_sink &sink)
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
        occt_say_left_out(sink, "face " + occt_label(model, face), name,
                          fault != faults.end() ? fault->second : excuse_of(model, process, face));
        count++;
    }
    return count;
}
