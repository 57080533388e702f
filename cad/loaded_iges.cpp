/* loaded_iges.cpp -- what a reader of IGES found fault with, entity by entity.
 *
 *     shape                           a trimmed, bounded or B-rep face; a surface or a curve that is a part of none
 *     broken entity                   every shape that it is a part of is left out; a part of none: the file is refused if it
 *                                     holds shapes (a group, a solid, a placement), and read without if not (a text)
 *     shape that nothing was made of  named, with what the library says
 */
#include "occt.hpp"

#include <IGESData_IGESEntity.hxx>
#include <IGESData_UndefinedEntity.hxx>
#include <IGESGeom_BSplineCurve.hxx>
#include <IGESGeom_BSplineSurface.hxx>
#include <IGESGeom_BoundedSurface.hxx>
#include <IGESGeom_TrimmedSurface.hxx>
#include <IGESSolid_Face.hxx>
#include <IGESSolid_HArray1OfLoop.hxx>
#include <Interface_EntityIterator.hxx>
#include <Interface_Graph.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TransferBRep.hxx>
#include <Transfer_Binder.hxx>

#include <set>
#include <vector>

using entity_handle = Handle(IGESData_IGESEntity);

/* Geometry by its type: curves, surfaces and solids, and what these are put together of. */
static bool is_geometry(const entity_handle &entity)
{
    const int type = entity->TypeNumber();
    return (type >= 100 && type < 200 && type != 124) || (type >= 500 && type < 600) ||
           (type == 402 && entity->FormNumber() == 9);
}

/* What shapes stand in: groups, figures and their uses, placements. */
static bool is_frame(const entity_handle &entity)
{
    const int type = entity->TypeNumber();
    return type == 124 || type == 308 || type == 402 || type == 408 || type == 430;
}

static bool is_face(const entity_handle &entity)
{
    return entity->IsKind(STANDARD_TYPE(IGESGeom_TrimmedSurface)) ||
           entity->IsKind(STANDARD_TYPE(IGESGeom_BoundedSurface)) ||
           entity->IsKind(STANDARD_TYPE(IGESSolid_Face));
}

/* Geometry that is a shape where it is a part of none; not so points, lists of points, finite elements, what is only ever a
 * part, and what holds faces. */
static bool can_be_shape(const entity_handle &entity)
{
    static const std::set<int> others = {116, 125, 132, 134, 136, 138, 141, 142,
                                         146, 148, 186, 502, 504, 508, 514};
    const int type = entity->TypeNumber(), form = entity->FormNumber();
    return is_geometry(entity) && others.count(type) == 0 &&
           (type != 106 || (form >= 11 && form <= 13) || form == 63);
}

static const char *word_for(const entity_handle &entity)
{
    static const std::set<int> curves = {100, 102, 104, 106, 110, 112, 126, 130};
    static const std::set<int> surfaces = {108, 114, 118, 120, 122, 128, 140, 143,
                                           144, 190, 192, 194, 196, 198, 402, 510};
    const int type = entity->TypeNumber();
    return curves.count(type) > 0 ? "curve " : surfaces.count(type) > 0 ? "face " : "entity ";
}

/* What an entity is a direct part of. */
static std::vector<entity_handle> wholes_of(const Interface_Graph &graph,
                                            const entity_handle &entity)
{
    std::vector<entity_handle> wholes;
    for (Interface_EntityIterator up = graph.Sharings(entity); up.More(); up.Next()) {
        const entity_handle whole = entity_handle::DownCast(up.Value());
        if (!whole.IsNull() && is_geometry(whole)) {
            wholes.push_back(whole);
        }
    }
    return wholes;
}

/* All shapes that an entity is a part of, or is; those that a placement is of. */
static std::vector<entity_handle> shapes_over(const Interface_Graph &graph,
                                              const entity_handle &entity)
{
    std::vector<entity_handle> shapes, open = {entity};
    std::set<const Standard_Transient *> known = {entity.get()};
    while (!open.empty()) {
        const entity_handle at = open.back();
        open.pop_back();
        const std::vector<entity_handle> wholes =
            is_face(at) ? std::vector<entity_handle>() : wholes_of(graph, at);
        if (is_face(at) || (wholes.empty() && can_be_shape(at))) {
            shapes.push_back(at);
        }
        for (const entity_handle &whole : wholes) {
            if (known.insert(whole.get()).second) {
                open.push_back(whole);
            }
        }
    }
    return shapes;
}

/* A face without a surface is none. */
static void take_surface(const entity_handle &shape)
{
    const auto trimmed = Handle(IGESGeom_TrimmedSurface)::DownCast(shape);
    const auto bounded = Handle(IGESGeom_BoundedSurface)::DownCast(shape);
    const auto face = Handle(IGESSolid_Face)::DownCast(shape);
    if (!trimmed.IsNull()) {
        trimmed->Init(nullptr, 0, nullptr, nullptr);
    } else if (!bounded.IsNull()) {
        bounded->Init(0, nullptr, nullptr);
    } else if (!face.IsNull()) {
        face->Init(nullptr, Standard_False, new IGESSolid_HArray1OfLoop(1, 0));
    }
}

static bool is_shape(const Interface_Graph &graph, const entity_handle &entity)
{
    return is_face(entity) || (can_be_shape(entity) && wholes_of(graph, entity).empty());
}

std::vector<iges_shape> occt_iges_shapes(const Handle(Interface_InterfaceModel) & model,
                                         const occt_sink &sink)
{
    const Interface_Graph graph(model);
    std::vector<iges_shape> shapes;
    std::map<const Standard_Transient *, std::string> faults;
    occt_check_whole(model);
    for (int i = 1; i <= model->NbEntities(); i++) {
        const std::string fault = occt_fault(model, i, STANDARD_TYPE(IGESData_IGESEntity));
        const entity_handle entity = entity_handle::DownCast(model->Value(i));
        if (fault.empty()) {
            continue;
        }
        const bool bears = is_geometry(entity) || entity->TypeNumber() == 124;
        const std::vector<entity_handle> over =
            bears ? shapes_over(graph, entity) : std::vector<entity_handle>();
        if (over.empty() && (is_frame(entity) || is_geometry(entity))) {
            throw occt_failure(TAUT_BAD_INPUT, "broken", fault);
        }
        if (over.empty()) {
            occt_say(sink, fault + "; the file is read without it");
        }
        for (const entity_handle &shape : over) {
            faults.emplace(shape.get(), fault);
        }
    }
    for (int i = 1; i <= model->NbEntities(); i++) {
        const entity_handle entity = entity_handle::DownCast(model->Value(i));
        if (!entity.IsNull() && is_shape(graph, entity)) {
            const auto fault = faults.find(entity.get());
            shapes.push_back({entity, fault != faults.end() ? fault->second : ""});
        }
    }
    return shapes;
}

void occt_take_broken(const std::vector<iges_shape> &shapes)
{
    for (const iges_shape &shape : shapes) {
        if (!shape.fault.empty()) {
            take_surface(shape.entity);
        }
    }
}

/* Why nothing was made of a shape that is not broken itself. */
static std::string excuse_of(const Handle(Transfer_TransientProcess) & process,
                             const entity_handle &shape)
{
    const std::string words = occt_words(process, shape);
    if (shape->IsKind(STANDARD_TYPE(IGESGeom_BSplineSurface)) ||
        shape->IsKind(STANDARD_TYPE(IGESGeom_BSplineCurve))) {
        return "OpenCASCADE makes no spline of it: its degrees, knots and points do not agree, or "
               "it is a point";
    }
    const bool is_read = !words.empty() && !shape->IsKind(STANDARD_TYPE(IGESData_UndefinedEntity));
    return is_read ? words
                   : "OpenCASCADE makes nothing of entities of type " +
                         std::to_string(shape->TypeNumber());
}

static bool is_made(const Handle(Transfer_TransientProcess) & process, const entity_handle &shape)
{
    const int mapped = process->MapIndex(shape);
    const Handle(Transfer_Binder) binder = mapped > 0 ? process->MapItem(mapped) : nullptr;
    return !binder.IsNull() && !TransferBRep::ShapeResult(binder).IsNull();
}

int occt_name_left_out_iges(const Handle(Interface_InterfaceModel) & model,
                            const Handle(Transfer_TransientProcess) & process,
                            const std::vector<iges_shape> &shapes, const occt_sink &sink)
{
    int count = 0;
    for (const iges_shape &shape : shapes) {
        const entity_handle &entity = shape.entity;
        if (!shape.fault.empty() || !is_made(process, entity)) {
            occt_say_left_out(sink, word_for(entity) + occt_label(model, entity),
                              entity->HasName() ? entity->NameValue()->ToCString() : "",
                              !shape.fault.empty() ? shape.fault : excuse_of(process, entity));
            count++;
        }
    }
    return count;
}
