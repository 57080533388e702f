/* quad.cpp -- planes between four straight lines, which are bilinear surfaces: what a box is bounded by, turned in its plane. */
#include "occt.hpp"

#include <BRepTools_WireExplorer.hxx>
#include <BRep_Tool.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_Line.hxx>
#include <Geom_Plane.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Wire.hxx>
#include <gp_Ax3.hxx>

#include <cmath>
#include <vector>

static const double same = 1e-7;     /* of the size: what readers take for one point */
static const double flattest = 1e-6; /* sine at a corner of a quadrilateral */

static bool is_straight(const Handle(Geom_Curve) & curve)
{
    const Handle(Geom_TrimmedCurve) cut = Handle(Geom_TrimmedCurve)::DownCast(curve);
    const Handle(Geom_Curve) whole = cut.IsNull() ? curve : cut->BasisCurve();
    const Handle(Geom_BSplineCurve) spline = Handle(Geom_BSplineCurve)::DownCast(whole);
    return !Handle(Geom_Line)::DownCast(whole).IsNull() ||
           (!spline.IsNull() && spline->NbPoles() == 2);
}

/* The places around which a wire goes straight from one to the next; none where it does not. */
static std::vector<gp_Pnt> corners_of(const TopoDS_Wire &wire, const TopoDS_Face &face)
{
    std::vector<gp_Pnt> starts, ends;
    double size = 0;
    for (BRepTools_WireExplorer at(wire, face); at.More(); at.Next()) {
        double first = 0, last = 0;
        const Handle(Geom_Curve) curve = BRep_Tool::Curve(at.Current(), first, last);
        if (curve.IsNull() || !is_straight(curve)) {
            return {};
        }
        const bool back = at.Current().Orientation() == TopAbs_REVERSED;
        starts.push_back(curve->Value(back ? last : first));
        ends.push_back(curve->Value(back ? first : last));
        size = std::fmax(size, starts.back().Distance(starts.front()));
    }
    for (size_t k = 0; k < starts.size(); k++) {
        if (ends[k].Distance(starts[(k + 1) % starts.size()]) > same * size) {
            return {};
        }
    }
    return starts;
}

/* The sine of the turn at b. */
static double turn(const gp_Pnt &a, const gp_Pnt &b, const gp_Pnt &c, const gp_Vec &up)
{
    const gp_Vec to(a, b), on(b, c);
    return up.Dot(to.Crossed(on)) / (to.Magnitude() * on.Magnitude());
}

/* Without places at which the way does not turn; false where it turns both ways, or back. */
static bool keep_turns(std::vector<gp_Pnt> &corners, const gp_Vec &up)
{
    std::vector<gp_Pnt> kept;
    double side = 0;
    for (size_t k = 0; k < corners.size(); k++) {
        const gp_Pnt &before = corners[(k + corners.size() - 1) % corners.size()];
        const gp_Pnt &after = corners[(k + 1) % corners.size()];
        const double sine = turn(before, corners[k], after, up);
        if (std::fabs(sine) <= same && gp_Vec(before, corners[k]).Dot({corners[k], after}) > 0) {
            continue;
        }
        if (!(std::fabs(sine) > flattest) || sine * side < 0) {
            return false;
        }
        side = sine;
        kept.push_back(corners[k]);
    }
    if (side < 0) {
        kept.assign(kept.rbegin(), kept.rend());
    }
    corners.swap(kept);
    return true;
}

Handle(Geom_BSplineSurface) occt_quad(const TopoDS_Face &face, const Handle(Geom_Surface) & surface)
{
    const Handle(Geom_Plane) plane = Handle(Geom_Plane)::DownCast(surface);
    TopExp_Explorer at(face, TopAbs_WIRE);
    if (plane.IsNull() || !at.More()) {
        return nullptr;
    }
    std::vector<gp_Pnt> corners = corners_of(TopoDS::Wire(at.Current()), face);
    const gp_Ax3 &own = plane->Position();
    at.Next();
    if (at.More() || corners.size() < 4 ||
        !keep_turns(corners, gp_Vec(own.XDirection().Crossed(own.YDirection()))) ||
        corners.size() != 4) {
        return nullptr;
    }
    TColgp_Array2OfPnt points(1, 2, 1, 2);
    TColStd_Array1OfReal knots(1, 2);
    TColStd_Array1OfInteger twice(1, 2);
    points.SetValue(1, 1, corners[0]);
    points.SetValue(2, 1, corners[1]);
    points.SetValue(2, 2, corners[2]);
    points.SetValue(1, 2, corners[3]);
    for (int k = 1; k <= 2; k++) {
        knots.SetValue(k, k - 1);
        twice.SetValue(k, 2);
    }
    return new Geom_BSplineSurface(points, knots, knots, twice, twice, 1, 1);
}
