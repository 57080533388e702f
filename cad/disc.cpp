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

/* The circle that all edges of a wire lie on, once around, and where the first of them begins; a null circle if there is none. */
struct ring {
    Handle(Geom_Circle) circle;
    gp_Pnt start;
};

static ring circle_around(const TopoDS_Shape &wire)
{
    const double around = 2 * std::acos(-1.0);
    Handle(Geom_Circle) found;
    gp_Pnt start;
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
            return {nullptr, start};
        }
        start = found.IsNull() ? circle->Value(first) : start;
        found = circle;
        all += last - first;
    }
    return {!found.IsNull() && std::fabs(all - around) <= 1e-7 * around ? found : nullptr, start};
}

/* Nine points of a circle of this radius, from its centre ahead, then aside. */
static void set_ring(const gp_Pnt &centre, const gp_Vec ways[2], double radius, int row,
                     TColgp_Array2OfPnt &points)
{
    static const double places[9][2] = {{1, 0},   {1, 1},  {0, 1},  {-1, 1}, {-1, 0},
                                        {-1, -1}, {0, -1}, {1, -1}, {1, 0}};
    for (int j = 0; j < 9; j++) {
        const gp_Vec way = ways[0] * (radius * places[j][0]) + ways[1] * (radius * places[j][1]);
        points.SetValue(row, j + 1, centre.Translated(way));
    }
}

/* The disc of radius `wide` without that of radius `narrow`: straight from the inside out, then around. */
static Handle(Geom_BSplineSurface)
    new_disc(const gp_Pnt &centre, const gp_Vec ways[2], double narrow, double wide)
{
    TColgp_Array2OfPnt points(1, 2, 1, 9);
    TColStd_Array2OfReal weights(1, 2, 1, 9);
    TColStd_Array1OfReal along(1, 2), around(1, 5);
    TColStd_Array1OfInteger twice(1, 2), often(1, 5);
    set_ring(centre, ways, narrow, 1, points);
    set_ring(centre, ways, wide, 2, points);
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
    std::vector<ring> rings;
    for (TopExp_Explorer at(face, TopAbs_WIRE); at.More() && !plane.IsNull(); at.Next()) {
        rings.push_back(circle_around(at.Current()));
        if (rings.size() > 2 || rings.back().circle.IsNull()) {
            return nullptr;
        }
    }
    if (rings.empty()) {
        return nullptr;
    }
    const ring &a = rings.front(), &b = rings.back();
    const ring &outer = a.circle->Radius() >= b.circle->Radius() ? a : b;
    const double wide = outer.circle->Radius();
    const double narrow = rings.size() == 2 ? std::fmin(a.circle->Radius(), b.circle->Radius()) : 0;
    const gp_Pnt centre = a.circle->Location();
    if (centre.Distance(b.circle->Location()) > 1e-12 * wide || !(narrow < wide)) {
        return nullptr;
    }
    /* from where its edge begins, as the neighbour does there */
    const gp_Vec up = plane->Position().Direction(), ahead = gp_Vec(centre, outer.start) / wide;
    const gp_Vec ways[2] = {ahead, up.Crossed(ahead)};
    return new_disc(centre, ways, narrow, wide);
}
