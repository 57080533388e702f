/* give.cpp -- from shapes to items: the surface under every face, the curve of every free edge. */
#include "occt.hpp"

#include <BRepTools.hxx>
#include <BRepTools_WireExplorer.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <GeomConvert.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_OffsetCurve.hxx>
#include <Geom_OffsetSurface.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <Standard_Failure.hxx>
#include <Standard_OutOfMemory.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopLoc_Location.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopTools_MapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Wire.hxx>
#include <gp_Trsf.hxx>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

/* The geometry a face or an edge hangs on, where it is not moved: what names are kept by. */
static const void *geometry_of(const TopoDS_Shape &shape)
{
    TopLoc_Location place;
    double first = 0, last = 0;
    if (shape.IsNull()) {
        return nullptr;
    }
    if (shape.ShapeType() == TopAbs_FACE) {
        return BRep_Tool::Surface(TopoDS::Face(shape), place).get();
    }
    if (shape.ShapeType() == TopAbs_EDGE) {
        return BRep_Tool::Curve(TopoDS::Edge(shape), place, first, last).get();
    }
    return nullptr;
}

void occt_names::add(const TopoDS_Shape &shape, const std::string &name)
{
    const void *key = geometry_of(shape);
    if (key != nullptr && of[key].name.empty()) {
        of[key].name = name;
    }
}

/* Every face of a shape and every edge that bounds none. */
static TopTools_IndexedMapOfShape parts_of(const TopoDS_Shape &shape)
{
    TopTools_IndexedMapOfShape parts;
    if (!shape.IsNull()) {
        TopExp::MapShapes(shape, TopAbs_FACE, parts);
        for (TopExp_Explorer at(shape, TopAbs_EDGE, TopAbs_FACE); at.More(); at.Next()) {
            parts.Add(at.Current());
        }
    }
    return parts;
}

void occt_names::add_product(const TopoDS_Shape &shape, const std::string &product)
{
    const TopTools_IndexedMapOfShape parts = parts_of(shape);
    for (int i = 1; i <= parts.Extent(); i++) {
        const void *key = geometry_of(parts(i));
        if (key != nullptr && of[key].product.empty()) {
            of[key].product = product;
        }
    }
}

void occt_names::add_colour(const TopoDS_Shape &shape, int colour)
{
    const TopTools_IndexedMapOfShape parts = parts_of(shape);
    for (int i = 1; i <= parts.Extent(); i++) {
        const void *key = geometry_of(parts(i));
        if (key != nullptr && of[key].colour == 0) {
            of[key].colour = colour;
        }
    }
}

const occt_about &occt_names::find(const TopoDS_Shape &shape) const
{
    static const occt_about nothing;
    const auto at = of.find(geometry_of(shape));
    return at != of.end() ? at->second : nothing;
}

/* The ranges a face takes of its surface, as its boundary has them. */
struct face_box {
    double lo[2], hi[2];
};

/* Does an edge run along a side of the box? */
static bool is_along_side(const TopoDS_Edge &edge, const TopoDS_Face &face, const face_box &box)
{
    double first = 0, last = 0;
    const Handle(Geom2d_Curve) curve = BRep_Tool::CurveOnSurface(edge, face, first, last);
    bool on[4] = {true, true, true, true};
    if (curve.IsNull()) {
        return false;
    }
    for (int k = 0; k <= 4; k++) {
        const gp_Pnt2d p = curve->Value(first + (last - first) * k / 4);
        const double at[2] = {p.X(), p.Y()};
        for (int d = 0; d < 2; d++) {
            const double close = 1e-7 * (box.hi[d] - box.lo[d]);
            on[2 * d] = on[2 * d] && std::fabs(at[d] - box.lo[d]) <= close;
            on[2 * d + 1] = on[2 * d + 1] && std::fabs(at[d] - box.hi[d]) <= close;
        }
    }
    return on[0] || on[1] || on[2] || on[3];
}

static bool is_trimmed(const TopoDS_Face &face, const face_box &box)
{
    int wires = 0;
    if (BRep_Tool::NaturalRestriction(face)) {
        return false;
    }
    for (TopExp_Explorer at(face, TopAbs_WIRE); at.More(); at.Next()) {
        wires++;
    }
    for (TopExp_Explorer at(face, TopAbs_EDGE); at.More(); at.Next()) {
        if (!is_along_side(TopoDS::Edge(at.Current()), face, box)) {
            return true;
        }
    }
    return wires > 1;
}

/* Do the end knots come once more often than the degree? Periodic and floating ones do not. */
static bool is_clamped(int first, int last, int degree)
{
    return first == degree + 1 && last == degree + 1;
}

/* Cuts the surface where the face ends; ends that are its own stay bit for bit. No beyond a seam, where nothing can be cut. */
static bool cut_to(const Handle(Geom_BSplineSurface) & made, const face_box &box)
{
    double ends[4] = {0, 0, 0, 0}, cut[4] = {0, 0, 0, 0};
    bool wanted = false;

    made->Bounds(ends[0], ends[1], ends[2], ends[3]);
    for (int d = 0; d < 2; d++) {
        const double lo = ends[2 * d], hi = ends[2 * d + 1], close = 1e-7 * (hi - lo);
        cut[2 * d] = std::fabs(box.lo[d] - lo) <= close ? lo : box.lo[d];
        cut[2 * d + 1] = std::fabs(box.hi[d] - hi) <= close ? hi : box.hi[d];
        if (cut[2 * d] < lo || cut[2 * d + 1] > hi || !(cut[2 * d + 1] - cut[2 * d] > close)) {
            return false;
        }
        wanted = wanted || cut[2 * d] > lo || cut[2 * d + 1] < hi;
    }
    if (wanted) {
        made->Segment(cut[0], cut[1], cut[2], cut[3]);
    }
    return true;
}

/* On knots that end as taut's do. */
static void clamp(const Handle(Geom_BSplineSurface) & made)
{
    double ends[4] = {0, 0, 0, 0};

    made->SetUNotPeriodic();
    made->SetVNotPeriodic();
    made->Bounds(ends[0], ends[1], ends[2], ends[3]);
    if (!is_clamped(made->UMultiplicity(1), made->UMultiplicity(made->NbUKnots()),
                    made->UDegree()) ||
        !is_clamped(made->VMultiplicity(1), made->VMultiplicity(made->NbVKnots()),
                    made->VDegree())) {
        made->Segment(ends[0], ends[1], ends[2], ends[3]);
    }
}

/* The surface under a face, without the ends that a file may have given it. */
static Handle(Geom_Surface) surface_under(const TopoDS_Face &face)
{
    const Handle(Geom_Surface) surface = BRep_Tool::Surface(face);
    if (surface.IsNull()) {
        throw occt_failure(TAUT_BAD_INPUT, "broken", "it has no surface");
    }
    const Handle(Geom_RectangularTrimmedSurface) cut =
        Handle(Geom_RectangularTrimmedSurface)::DownCast(surface);
    return cut.IsNull() ? surface : cut->BasisSurface();
}

/* The ranges that a face takes. Once around is once around: files with fewer digits say a little more or less. */
static face_box box_of(const TopoDS_Face &face, const Handle(Geom_Surface) & surface)
{
    double ends[4] = {0, 0, 0, 0};
    const bool around[2] = {surface->IsUPeriodic() != 0, surface->IsVPeriodic() != 0};
    face_box box = {};

    BRepTools::UVBounds(face, box.lo[0], box.hi[0], box.lo[1], box.hi[1]);
    surface->Bounds(ends[0], ends[1], ends[2], ends[3]);
    for (int d = 0; d < 2; d++) {
        const double period = around[d] ? ends[2 * d + 1] - ends[2 * d] : 0;
        if (around[d] && std::fabs(box.hi[d] - box.lo[d] - period) <= 1e-7 * period) {
            box.lo[d] =
                std::fabs(box.lo[d] - ends[2 * d]) <= 1e-7 * period ? ends[2 * d] : box.lo[d];
            box.hi[d] = box.lo[d] + period;
        }
    }
    return box;
}

/* Surfaces without ends of their own, or of another kind, are taken as far as the face goes; splines so where the face is a box
 * of their parameters, else whole. Where edges are asked for, those of a quadrilateral are the file's own. */
static Handle(Geom_BSplineSurface)
    convert_surface(const TopoDS_Face &face, bool with_edges, int &notes)
{
    const Handle(Geom_Surface) surface = surface_under(face);
    Handle(Geom_BSplineSurface) made = Handle(Geom_BSplineSurface)::DownCast(surface);
    const Handle(Geom_BSplineSurface) disc = occt_disc(face, surface);
    if (!disc.IsNull()) {
        return disc;
    }
    const face_box box = box_of(face, surface);
    bool whole = !is_trimmed(face, box);
    const Handle(Geom_BSplineSurface) quad =
        whole || with_edges ? nullptr : occt_quad(face, surface);
    if (!quad.IsNull()) {
        return quad;
    }
    if (!made.IsNull()) {
        made = Handle(Geom_BSplineSurface)::DownCast(made->Copy());
        clamp(made);
        whole = whole && (BRep_Tool::NaturalRestriction(face) || cut_to(made, box));
    } else {
        notes |= surface->IsKind(STANDARD_TYPE(Geom_OffsetSurface)) ? TAUT_CAD_APPROXIMATE : 0;
        made = occt_round(surface, box.lo, box.hi);
    }
    if (made.IsNull()) {
        made = GeomConvert::SurfaceToBSplineSurface(new Geom_RectangularTrimmedSurface(
            surface, box.lo[0], box.hi[0], box.lo[1], box.hi[1]));
        clamp(made);
    }
    notes |= whole ? 0 : TAUT_CAD_TRIMMED;
    return made;
}

static std::vector<double> numbers(const TColStd_Array1OfReal &array)
{
    std::vector<double> out;
    for (int i = array.Lower(); i <= array.Upper(); i++) {
        out.push_back(array.Value(i));
    }
    return out;
}

static void give_item(const occt_sink &sink, const occt_about &about, const char *name,
                      taut_cad_item &item)
{
    item.name = name;
    item.product = about.product.c_str();
    item.colour = about.colour;
    if (!sink.item(sink.context, &item)) {
        throw occt_failure(TAUT_IO, "write", "what was read could not be passed on");
    }
}

/* Uses of products, by their places, in the order in which they appear. */
class uses
{
  public:
    void find(const TopoDS_Shape &shape, const std::string &product, taut_cad_item &item)
    {
        const gp_Trsf place = shape.Location().Transformation();
        std::array<double, 12> rows{};
        for (int i = 0; i < 3; i++) {
            for (int j = 0; j < 4; j++) {
                rows[static_cast<size_t>(4 * i + j)] = place.Value(i + 1, j + 1);
            }
        }
        const auto at =
            known.emplace(std::make_pair(product, rows), static_cast<int>(known.size())).first;
        item.instance = at->second;
        std::copy(rows.begin(), rows.end(), item.place);
    }

  private:
    std::map<std::pair<std::string, std::array<double, 12>>, int> known;
};

/* False, and nothing given, where the face is trimmed and only `whole` ones are wanted. */
static bool give_face(const TopoDS_Face &face, const occt_about &about, const char *name,
                      bool whole, uses &used, occt_joiner &joiner)
{
    occt_surface out = {};
    taut_cad_item &item = out.item;
    const Handle(Geom_BSplineSurface) s = convert_surface(face, whole, item.notes);
    if (whole && (item.notes & TAUT_CAD_TRIMMED) != 0) {
        return false;
    }
    used.find(face, about.product, item);
    out.knots[0] = numbers(s->UKnotSequence());
    out.knots[1] = numbers(s->VKnotSequence());
    for (int i = 1; i <= s->NbUPoles(); i++) {
        for (int j = 1; j <= s->NbVPoles(); j++) {
            const gp_Pnt p = s->Pole(i, j);
            out.points.insert(out.points.end(), {p.X(), p.Y(), p.Z()});
            out.weights.push_back(s->Weight(i, j));
        }
    }
    item.degree[0] = s->UDegree();
    item.degree[1] = s->VDegree();
    item.count[0] = s->NbUPoles();
    item.count[1] = s->NbVPoles();
    item.product = about.product.c_str();
    item.colour = about.colour;
    out.name = name;
    out.is_rational = s->IsURational() || s->IsVRational();
    joiner.add(std::move(out));
    return true;
}

static void give_edge(const TopoDS_Edge &edge, const occt_about &about, const char *name, int notes,
                      const occt_sink &sink)
{
    double first = 0, last = 0;
    Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, first, last);
    taut_cad_item item = {};
    item.notes = notes;
    if (curve.IsNull()) {
        return; /* shrunk to a point */
    }
    Handle(Geom_BSplineCurve) made = Handle(Geom_BSplineCurve)::DownCast(curve);
    if (!made.IsNull() && first == made->FirstParameter() && last == made->LastParameter()) {
        made = Handle(Geom_BSplineCurve)::DownCast(made->Copy());
    } else {
        item.notes |= curve->IsKind(STANDARD_TYPE(Geom_OffsetCurve)) ? TAUT_CAD_APPROXIMATE : 0;
        made = GeomConvert::CurveToBSplineCurve(new Geom_TrimmedCurve(curve, first, last));
    }
    made->SetNotPeriodic();
    if (!is_clamped(made->Multiplicity(1), made->Multiplicity(made->NbKnots()), made->Degree())) {
        made->Segment(made->FirstParameter(), made->LastParameter());
    }
    const std::vector<double> t = numbers(made->KnotSequence());
    std::vector<double> points, weights;
    for (int i = 1; i <= made->NbPoles(); i++) {
        const gp_Pnt p = made->Pole(i);
        points.insert(points.end(), {p.X(), p.Y(), p.Z()});
        weights.push_back(made->Weight(i));
    }
    item.degree[0] = made->Degree();
    item.count[0] = made->NbPoles();
    item.knots[0] = t.data();
    item.points = points.data();
    item.weights = made->IsRational() ? weights.data() : nullptr;
    give_item(sink, about, name, item);
}

void occt_say(const occt_sink &sink, const std::string &note)
{
    if (!sink.note(sink.context, note.c_str())) {
        throw occt_failure(TAUT_IO, "write", "what was read could not be passed on");
    }
}

/* Gives one object; one that OpenCASCADE fails on is named and left out, the rest of the file is worth having. 0 where it was. */
template <class Give>
static int give_or_name(const char *what, int number, const char *name, const occt_sink &sink,
                        Give give)
{
    std::string why;
    try {
        give(name);
        return 1;
    } catch (const Standard_OutOfMemory &) {
        throw;
    } catch (const Standard_Failure &failure) {
        why = std::string("OpenCASCADE failed: ") + failure.DynamicType()->Name();
    } catch (const occt_failure &failure) {
        if (failure.status != TAUT_BAD_INPUT) {
            throw;
        }
        why = failure.what();
    }
    const std::string note = std::string(what) + " " + std::to_string(number) + " of the file, \"" +
                             name + "\", is left out: " + why;
    occt_say(sink, note);
    return 0;
}

/* What has no name is called after its product where the file has several: with a number where it is not alone there. */
class namer
{
  public:
    namer(const occt_names &said, const TopTools_IndexedMapOfShape &faces,
          const TopTools_IndexedMapOfShape &edges)
        : names(said)
    {
        for (const TopTools_IndexedMapOfShape *parts : {&faces, &edges}) {
            for (int i = 1; i <= parts->Extent(); i++) {
                const occt_about &about = names.find((*parts)(i));
                nameless[about.product] += about.name.empty() ? 1 : 0;
            }
        }
    }
    std::string name(const TopoDS_Shape &shape)
    {
        const occt_about &about = names.find(shape);
        if (!about.name.empty() || about.product.empty() || nameless.size() < 2) {
            return about.name;
        }
        const int number = ++given[about.product];
        return nameless[about.product] > 1 ? about.product + "." + std::to_string(number)
                                           : about.product;
    }

  private:
    const occt_names &names;
    std::map<std::string, int> nameless, given;
};

/* The edges of a face, but for seams: those of its outer wire, as they go around, then those of its holes. */
static std::vector<TopoDS_Edge> edges_of(const TopoDS_Face &face)
{
    std::vector<TopoDS_Edge> edges;
    TopTools_MapOfShape known;
    const TopoDS_Wire outer = BRepTools::OuterWire(face);
    for (int pass = 0; pass < 2; pass++) {
        for (TopExp_Explorer wire(face, TopAbs_WIRE); wire.More(); wire.Next()) {
            if (wire.Current().IsSame(outer) != (pass == 0)) {
                continue;
            }
            for (BRepTools_WireExplorer at(TopoDS::Wire(wire.Current()), face); at.More();
                 at.Next()) {
                const TopoDS_Edge edge = at.Current();
                if (!BRep_Tool::Degenerated(edge) && !BRep_Tool::IsClosed(edge, face) &&
                    known.Add(edge)) {
                    edges.push_back(edge);
                }
            }
        }
    }
    return edges;
}

void occt_give(const TopoDS_Shape &shape, const occt_names &names, bool with_edges,
               const occt_sink &sink)
{
    TopTools_IndexedMapOfShape faces, edges;
    if (!shape.IsNull()) {
        TopExp::MapShapes(shape, TopAbs_FACE, faces);
        for (TopExp_Explorer at(shape, TopAbs_EDGE, TopAbs_FACE); at.More(); at.Next()) {
            edges.Add(at.Current());
        }
    }
    if (faces.IsEmpty() && edges.IsEmpty()) {
        throw occt_failure(TAUT_BAD_INPUT, "empty", "the file holds no surface and no curve");
    }
    namer namer(names, faces, edges);
    std::vector<std::pair<int, std::string>> trimmed;
    uses used;
    occt_joiner joiner(sink, names.are_own);
    int given = 0;
    for (int i = 1; i <= faces.Extent(); i++) {
        const TopoDS_Face face = TopoDS::Face(faces(i));
        const std::string own = namer.name(face);
        /* edges are found by name: those of trimmed faces and of others are counted as one */
        const std::string said = own.empty() && with_edges ? "face" + std::to_string(i) : own;
        given += give_or_name("face", i, said.c_str(), sink, [&](const char *name) {
            if (!give_face(face, names.find(face), name, with_edges, used, joiner)) {
                trimmed.emplace_back(i, said);
            }
        });
    }
    joiner.end();
    for (int i = 1; i <= edges.Extent(); i++) {
        const TopoDS_Edge edge = TopoDS::Edge(edges(i));
        const std::string said = namer.name(edge);
        given += give_or_name("edge", i, said.c_str(), sink, [&](const char *name) {
            give_edge(edge, names.find(edge), name, 0, sink);
        });
    }
    for (const auto &part : trimmed) {
        const TopoDS_Face face = TopoDS::Face(faces(part.first));
        int number = 0;
        for (const TopoDS_Edge &edge : edges_of(face)) {
            const std::string said = part.second + "." + std::to_string(++number);
            give_or_name("edge", number, said.c_str(), sink, [&](const char *name) {
                give_edge(edge, names.find(face), name, TAUT_CAD_EDGE, sink);
            });
        }
    }
    if (given == 0) {
        throw occt_failure(TAUT_BAD_INPUT, "broken",
                           "none of its " + std::to_string(faces.Extent()) + " faces and " +
                               std::to_string(edges.Extent()) + " edges can be read");
    }
}
