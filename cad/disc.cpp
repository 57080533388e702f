/* disc.cpp -- planes between circles, which are surfaces with natural boundaries all the same. */
#include "occt.hpp"

#include <BRep_Tool.hxx>
#include <Geom_Circle.hxx>
#include <Geom_Plane.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColStd_Array2OfReal.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <gp_Ax3.hxx>

#include <cmath>
#include <vector>

/* The circle that all edges of a wire lie on, once around; null if there is none. */
static Handle(Geom_Circle) circle_around(const TopoDS_Shape &wire)
{
    const double around = 2 * std::acos(-1.0);
    Handle(Geom_Circle) found;
    double all = 0;
    for (TopExp_Explorer at(wire, TopAbs_EDGE); at.More(); at.Next()) {
        double first = 0, last = 0;
        Handle(Geom_Curve) curve = BRep_Tool::Curve(TopoDS::Edge(at.Current()), first, last);
        const Handle(Geom_TrimmedCurve) cut = Handle(Geom_TrimmedCurve)::DownCast(curve);
        const Handle(Geom_Circle) circle =
            Handle(Geom_Circle)::DownCast(cut.IsNull() ? curve : cut->BasisCurve());
        if (circle.IsNull() ||
            (!found.IsNull() &&
             (std::fabs(circle->Radius() - found->Radius()) > 1e-12 * found->Radius() ||
              circle->Location().Distance(found->Location()) > 1e-12 * found->Radius()))) {
            return nullptr;
        }
        found = circle;
        all += last - first;
    }
    return !found.IsNull() && std::fabs(all - around) <= 1e-7 * around ? found : nullptr;
}

/* Nine points of a circle of this radius about a centre, in the plane's axes. */
static void set_ring(const gp_Ax3 &axes, const gp_Pnt &centre, double radius, int row,
                     TColgp_Array2OfPnt &points)
{
    static const double places[9][2] = {{1, 0},   {1, 1},  {0, 1},  {-1, 1}, {-1, 0},
                                        {-1, -1}, {0, -1}, {1, -1}, {1, 0}};
    for (int j = 0; j < 9; j++) {
        const gp_Vec way = gp_Vec(axes.XDirection()) * (radius * places[j][0]) +
                           gp_Vec(axes.YDirection()) * (radius * places[j][1]);
        points.SetValue(row, j + 1, centre.Translated(way));
    }
}

/* The disc of radius `wide` without that of radius `narrow`: straight from the inside out, then around. */
static Handle(Geom_BSplineSurface)
    new_disc(const gp_Ax3 &axes, const gp_Pnt &centre, double narrow, double wide)
{
    TColgp_Array2OfPnt points(1, 2, 1, 9);
    TColStd_Array2OfReal weights(1, 2, 1, 9);
    TColStd_Array1OfReal along(1, 2), around(1, 5);
    TColStd_Array1OfInteger twice(1, 2), often(1, 5);
    set_ring(axes, centre, narrow, 1, points);
    set_ring(axes, centre, wide, 2, points);
    for (int j = 1; j <= 9; j++) {
        weights.SetValue(1, j, j % 2 == 0 ? std::sqrt(0.5) : 1);
        weights.SetValue(2, j, j % 2 == 0 ? std::sqrt(0.5) : 1);
    }
    for (int k = 1; k <= 5; k++) {
        around.SetValue(k, (k - 1) / 4.0);
        often.SetValue(k, k == 1 || k == 5 ? 3 : 2);
    }
    for (int k = 1; k <= 2; k++) {
        along.SetValue(k, k - 1);
        twice.SetValue(k, 2);
    }
    return new Geom_BSplineSurface(points, weights, along, around, twice, often, 1, 2);
}

Handle(Geom_BSplineSurface) occt_disc(const TopoDS_Face &face, const Handle(Geom_Surface) & surface)
{
    const Handle(Geom_Plane) plane = Handle(Geom_Plane)::DownCast(surface);
    std::vector<Handle(Geom_Circle)> rings;
    for (TopExp_Explorer at(face, TopAbs_WIRE); at.More() && !plane.IsNull(); at.Next()) {
        rings.push_back(circle_around(at.Current()));
        if (rings.size() > 2 || rings.back().IsNull()) {
            return nullptr;
        }
    }
    if (rings.empty()) {
        return nullptr;
    }
    const Handle(Geom_Circle) a = rings.front(), b = rings.back();
    const double wide = std::fmax(a->Radius(), b->Radius());
    const double narrow = rings.size() == 2 ? std::fmin(a->Radius(), b->Radius()) : 0;
    if (a->Location().Distance(b->Location()) > 1e-12 * wide || !(narrow < wide)) {
        return nullptr;
    }
    return new_disc(plane->Position(), a->Location(), narrow, wide);
}
