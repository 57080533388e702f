/* disc.cpp -- planes between circles or ellipses, which are surfaces with natural boundaries all the same. */
#include "occt.hpp"

#include <BRep_Tool.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_Circle.hxx>
#include <Geom_Conic.hxx>
#include <Geom_Ellipse.hxx>
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

/* A circle or an ellipse once around: two half diameters, conjugate, the first to where an edge begins; or none. */
struct ring {
    bool is_found;
    gp_Pnt centre;
    gp_Vec ways[2];
};

/* Of a circle or an ellipse, whose derivative is the conjugate half diameter. */
static ring ring_of_conic(const Handle(Geom_Conic) & conic, double at)
{
    gp_Pnt start;
    gp_Vec along;
    conic->D1(at, start, along);
    return {true, conic->Location(), {gp_Vec(conic->Location(), start), along}};
}

static double radius_of(const Handle(Geom_Conic) & conic, int which)
{
    const Handle(Geom_Circle) circle = Handle(Geom_Circle)::DownCast(conic);
    const Handle(Geom_Ellipse) ellipse = Handle(Geom_Ellipse)::DownCast(conic);
    return !circle.IsNull()   ? circle->Radius()
           : ellipse.IsNull() ? 0
           : which == 0       ? ellipse->MajorRadius()
                              : ellipse->MinorRadius();
}

static bool are_one(const Handle(Geom_Conic) & a, const Handle(Geom_Conic) & b)
{
    const double size = radius_of(a, 0);
    return std::fabs(size - radius_of(b, 0)) <= 1e-12 * size &&
           std::fabs(radius_of(a, 1) - radius_of(b, 1)) <= 1e-12 * size &&
           a->Location().Distance(b->Location()) <= 1e-12 * size;
}

/* The conic that all edges of a wire lie on, once around. */
static ring conic_around(const TopoDS_Shape &wire)
{
    const double around = 2 * std::acos(-1.0);
    ring none = {false, {}, {}}, out = none;
    Handle(Geom_Conic) found;
    double all = 0;
    for (TopExp_Explorer at(wire, TopAbs_EDGE); at.More(); at.Next()) {
        double first = 0, last = 0;
        Handle(Geom_Curve) curve = BRep_Tool::Curve(TopoDS::Edge(at.Current()), first, last);
        const Handle(Geom_TrimmedCurve) cut = Handle(Geom_TrimmedCurve)::DownCast(curve);
        const Handle(Geom_Conic) conic =
            Handle(Geom_Conic)::DownCast(cut.IsNull() ? curve : cut->BasisCurve());
        if (conic.IsNull() || !(radius_of(conic, 1) > 0) ||
            (!found.IsNull() && !are_one(found, conic))) {
            return none;
        }
        out = found.IsNull() ? ring_of_conic(conic, first) : out;
        found = conic;
        all += last - first;
    }
    return !found.IsNull() && std::fabs(all - around) <= 1e-7 * around ? out : none;
}

/* A quarter of an ellipse as three points. */
struct quarter {
    gp_Pnt points[3];
};

/* The quarters of an edge, a spline of them and of no other weights; false if it is none. */
static bool add_quarters(const TopoDS_Edge &edge, std::vector<quarter> &list)
{
    double first = 0, last = 0;
    Handle(Geom_BSplineCurve) curve =
        Handle(Geom_BSplineCurve)::DownCast(BRep_Tool::Curve(edge, first, last));
    if (!curve.IsNull() && curve->IsPeriodic()) { /* readers make closed ones so */
        curve = Handle(Geom_BSplineCurve)::DownCast(curve->Copy());
        curve->Segment(first, last);
    }
    if (curve.IsNull() || curve->Degree() != 2 || !curve->IsRational() ||
        curve->NbPoles() != 2 * (curve->NbKnots() - 1) + 1) {
        return false;
    }
    const double off =
        std::fabs(first - curve->FirstParameter()) + std::fabs(last - curve->LastParameter());
    if (off > 1e-12 * (curve->LastParameter() - curve->FirstParameter())) {
        return false;
    }
    for (int k = 1; k + 2 <= curve->NbPoles(); k += 2) {
        const double w = curve->Weight(k + 1) / std::sqrt(curve->Weight(k) * curve->Weight(k + 2));
        if (std::fabs(w - std::sqrt(0.5)) > 1e-12) {
            return false;
        }
        list.push_back({{curve->Pole(k), curve->Pole(k + 1), curve->Pole(k + 2)}});
    }
    return true;
}

/* An ellipse whose four quarters, between half diameters that are conjugate, are splines: where the tangents of a quarter
 * meet is as far from the centre as both half diameters together. */
static ring spline_around(const TopoDS_Shape &wire)
{
    const ring none = {false, {}, {}};
    std::vector<quarter> list;
    gp_XYZ sum(0, 0, 0);
    int found = 0;
    for (TopExp_Explorer at(wire, TopAbs_EDGE); at.More(); at.Next()) {
        if (!add_quarters(TopoDS::Edge(at.Current()), list)) {
            return none;
        }
    }
    if (list.size() != 4) {
        return none;
    }
    for (const quarter &q : list) {
        sum += (q.points[0].XYZ() + q.points[2].XYZ()) / 8;
    }
    const gp_Pnt centre(sum);
    const ring out = {
        true, centre, {gp_Vec(centre, list[0].points[0]), gp_Vec(centre, list[0].points[2])}};
    const double near = 1e-12 * (out.ways[0].Magnitude() + out.ways[1].Magnitude());
    for (const quarter &q : list) {
        for (int k = 0; k < 4; k++) {
            const gp_Vec ways[2] = {out.ways[0] * (k % 2 == 0 ? 1 : -1),
                                    out.ways[1] * (k / 2 == 0 ? 1 : -1)};
            const gp_Pnt ends[2] = {centre.Translated(ways[0]), centre.Translated(ways[1])};
            const double straight = q.points[0].Distance(ends[0]) + q.points[2].Distance(ends[1]);
            const double turned = q.points[2].Distance(ends[0]) + q.points[0].Distance(ends[1]);
            const double corner = q.points[1].Distance(centre.Translated(ways[0] + ways[1]));
            found |= std::fmin(straight, turned) + corner <= near ? 1 << k : 0;
        }
    }
    return found == 15 ? out : none;
}

/* Nine points of an ellipse from half diameters of these lengths: ahead, then aside. */
static void set_ring(const gp_Pnt &centre, const gp_Vec ways[2], const double radii[2], int row,
                     TColgp_Array2OfPnt &points)
{
    static const double places[9][2] = {{1, 0},   {1, 1},  {0, 1},  {-1, 1}, {-1, 0},
                                        {-1, -1}, {0, -1}, {1, -1}, {1, 0}};
    for (int j = 0; j < 9; j++) {
        const gp_Vec way =
            ways[0] * (radii[0] * places[j][0]) + ways[1] * (radii[1] * places[j][1]);
        points.SetValue(row, j + 1, centre.Translated(way));
    }
}

/* The disc of half diameters `wide` without that of `narrow`: straight from the inside out, then around. */
static Handle(Geom_BSplineSurface) new_disc(const gp_Pnt &centre, const gp_Vec ways[2],
                                            const double narrow[2], const double wide[2])
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
        const ring conic = conic_around(at.Current());
        rings.push_back(conic.is_found ? conic : spline_around(at.Current()));
        if (rings.size() > 2 || !rings.back().is_found) {
            return nullptr;
        }
    }
    if (rings.empty()) {
        return nullptr;
    }
    const gp_Vec up = plane->Position().Direction();
    for (ring &one : rings) {
        if (one.ways[0].Crossed(one.ways[1]).Dot(up) < 0) {
            one.ways[1].Reverse();
        }
    }
    const ring &a = rings.front(), &b = rings.back();
    const ring &outer = a.ways[0].Magnitude() >= b.ways[0].Magnitude() ? a : b;
    const ring &inner = &outer == &a ? b : a;
    const double wide[2] = {outer.ways[0].Magnitude(), outer.ways[1].Magnitude()};
    /* from where its edge begins, as the neighbour does there; of circles any half diameters are conjugate */
    const bool is_round = std::fabs(wide[0] - wide[1]) <= 1e-12 * wide[0] &&
                          std::fabs(outer.ways[0].Dot(outer.ways[1])) <= 1e-12 * wide[0] * wide[1];
    const gp_Vec ahead = outer.ways[0] / wide[0];
    const gp_Vec ways[2] = {ahead, is_round ? up.Crossed(ahead) : outer.ways[1] / wide[1]};
    double narrow[2] = {0, 0};
    for (int d = 0; d < 2 && rings.size() == 2; d++) {
        narrow[d] = inner.ways[d].Magnitude();
        if (!(narrow[d] < wide[d]) ||
            (!is_round && inner.ways[d].Crossed(ways[d]).Magnitude() > 1e-9 * wide[d])) {
            return nullptr;
        }
    }
    const bool is_round_inside = std::fabs(narrow[0] - narrow[1]) <= 1e-12 * wide[0];
    if (a.centre.Distance(b.centre) > 1e-12 * wide[0] || (is_round && !is_round_inside)) {
        return nullptr;
    }
    return new_disc(outer.centre, ways, narrow, wide);
}
