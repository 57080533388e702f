/* round.cpp -- surfaces of revolution as splines of arcs of a quarter turn at most, which is how Taut writes them.
 *
 *     profile   the curve at u = 0: a line, arcs, or what GeomConvert makes of it
 *     arcs      n = ceil(angle / (pi / 2)) of one angle a: between two points of the circle the point where their tangents
 *               meet, 1 / cos(a / 2) times as far out, of weight cos(a / 2)
 *     surface   each point of the profile turned by all arcs
 *
 * GeomConvert takes a full turn as three arcs of 120 degrees, whose ends are not those of its neighbours' circles.
 */
#include "occt.hpp"

#include <GeomConvert.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_ConicalSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_SurfaceOfRevolution.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColStd_Array2OfReal.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <gp_Ax3.hxx>

#include <cmath>
#include <vector>

static const double quarter = std::acos(0.0);

/* A rational curve or one coordinate of a net: knots once each with their multiplicities. */
struct row {
    int degree;
    std::vector<gp_Vec> points; /* of arcs: on the unit circle, X and Y */
    std::vector<double> weights, knots;
    std::vector<int> often;
};

/* The point of the unit circle at an angle; quarters exactly. */
static gp_Vec on_circle(double angle)
{
    const double turns = std::round(angle / quarter);
    static const double exact[4][2] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
    if (std::fabs(angle - turns * quarter) <= 1e-14 * std::fmax(1, std::fabs(angle))) {
        const double *at = exact[(static_cast<long>(std::fmod(turns, 4)) + 4) % 4];
        return {at[0], at[1], 0};
    }
    return {std::cos(angle), std::sin(angle), 0};
}

static row arcs(double from, double to)
{
    const double angle = to - from;
    const int pieces = static_cast<int>(std::fmax(1, std::ceil(angle / quarter - 1e-9)));
    const bool around = std::fabs(angle - 4 * quarter) <= 1e-9;
    const double step = around ? quarter : angle / pieces;
    row out = {2, {}, {}, {}, {}};
    for (int k = 0; k <= pieces; k++) {
        const gp_Vec start = on_circle(from), across(-start.Y(), start.X(), 0);
        const gp_Vec turned = on_circle(k * step);
        const gp_Vec at =
            around ? start * turned.X() + across * turned.Y() : on_circle(from + k * step);
        if (k > 0) {
            out.points.push_back((out.points.back() + at) / (1 + on_circle(step).X()));
            out.weights.push_back(around ? std::sqrt(0.5) : std::cos(step / 2));
        }
        out.points.push_back(around && k == pieces ? out.points.front() : at);
        out.weights.push_back(1);
        out.knots.push_back(k == pieces ? to : from + k * step);
        out.often.push_back(k == 0 || k == pieces ? 3 : 2);
    }
    return out;
}

/* Between two points, or their like on a meridian. */
static row straight(double from, double to, const gp_Vec &first, const gp_Vec &last)
{
    return {1, {first, last}, {1, 1}, {from, to}, {2, 2}};
}

/* A circle of a meridian: of this radius, at this distance from the axis. */
static row meridian(double from, double to, double distance, double radius)
{
    row out = arcs(from, to);
    for (gp_Vec &at : out.points) {
        at = gp_Vec(distance + radius * at.X(), 0, radius * at.Y());
    }
    return out;
}

/* Of any curve, in the axes. */
static row profile_of(const Handle(Geom_Curve) & curve, const gp_Ax3 &axes, double from, double to)
{
    const Handle(Geom_BSplineCurve) made =
        GeomConvert::CurveToBSplineCurve(new Geom_TrimmedCurve(curve, from, to));
    row out = {made->Degree(), {}, {}, {}, {}};
    made->SetNotPeriodic();
    for (int i = 1; i <= made->NbPoles(); i++) {
        const gp_Vec way(axes.Location(), made->Pole(i));
        out.points.emplace_back(way.Dot(axes.XDirection()), way.Dot(axes.YDirection()),
                                way.Dot(axes.Direction()));
        out.weights.push_back(made->Weight(i));
    }
    for (int k = 1; k <= made->NbKnots(); k++) {
        out.knots.push_back(made->Knot(k));
        out.often.push_back(made->Multiplicity(k));
    }
    return out;
}

/* The meridian of a surface at u = 0, in its axes; false for surfaces of another kind. */
static bool find_profile(const Handle(Geom_Surface) & surface, double from, double to, gp_Ax3 &axes,
                         row &out)
{
    if (surface->IsKind(STANDARD_TYPE(Geom_ElementarySurface))) {
        axes = Handle(Geom_ElementarySurface)::DownCast(surface)->Position();
    }
    if (surface->IsKind(STANDARD_TYPE(Geom_CylindricalSurface))) {
        const double r = Handle(Geom_CylindricalSurface)::DownCast(surface)->Radius();
        out = straight(from, to, {r, 0, from}, {r, 0, to});
    } else if (surface->IsKind(STANDARD_TYPE(Geom_ConicalSurface))) {
        const Handle(Geom_ConicalSurface) cone = Handle(Geom_ConicalSurface)::DownCast(surface);
        const double r = cone->RefRadius(), s = std::sin(cone->SemiAngle()),
                     c = std::cos(cone->SemiAngle());
        out = straight(from, to, {r + from * s, 0, from * c}, {r + to * s, 0, to * c});
    } else if (surface->IsKind(STANDARD_TYPE(Geom_SphericalSurface))) {
        out = meridian(from, to, 0, Handle(Geom_SphericalSurface)::DownCast(surface)->Radius());
    } else if (surface->IsKind(STANDARD_TYPE(Geom_ToroidalSurface))) {
        const Handle(Geom_ToroidalSurface) torus = Handle(Geom_ToroidalSurface)::DownCast(surface);
        out = meridian(from, to, torus->MajorRadius(), torus->MinorRadius());
    } else if (surface->IsKind(STANDARD_TYPE(Geom_SurfaceOfRevolution))) {
        const Handle(Geom_SurfaceOfRevolution) turned =
            Handle(Geom_SurfaceOfRevolution)::DownCast(surface);
        axes = gp_Ax3(turned->Location(), turned->Direction());
        out = profile_of(turned->BasisCurve(), axes, from, to);
    } else {
        return false;
    }
    return true;
}

static void copy(const row &from, TColStd_Array1OfReal &knots, TColStd_Array1OfInteger &often)
{
    for (size_t k = 0; k < from.knots.size(); k++) {
        knots.SetValue(static_cast<int>(k) + 1, from.knots[k]);
        often.SetValue(static_cast<int>(k) + 1, from.often[k]);
    }
}

Handle(Geom_BSplineSurface)
    occt_round(const Handle(Geom_Surface) & surface, const double lo[2], const double hi[2])
{
    gp_Ax3 axes;
    row up;
    if (!find_profile(surface, lo[1], hi[1], axes, up)) {
        return nullptr;
    }
    const row round = arcs(lo[0], hi[0]);
    const int nu = static_cast<int>(round.points.size()), nv = static_cast<int>(up.points.size());
    const int ku = static_cast<int>(round.knots.size()), kv = static_cast<int>(up.knots.size());
    TColgp_Array2OfPnt points(1, nu, 1, nv);
    TColStd_Array2OfReal weights(1, nu, 1, nv);
    TColStd_Array1OfReal u(1, ku), v(1, kv);
    TColStd_Array1OfInteger often_u(1, ku), often_v(1, kv);
    for (int i = 0; i < nu; i++) {
        const gp_Vec at = round.points[static_cast<size_t>(i)];
        for (int j = 0; j < nv; j++) {
            const gp_Vec p = up.points[static_cast<size_t>(j)];
            const gp_Vec way = gp_Vec(axes.XDirection()) * (at.X() * p.X() - at.Y() * p.Y()) +
                               gp_Vec(axes.YDirection()) * (at.X() * p.Y() + at.Y() * p.X()) +
                               gp_Vec(axes.Direction()) * p.Z();
            points.SetValue(i + 1, j + 1, axes.Location().Translated(way));
            weights.SetValue(i + 1, j + 1,
                             round.weights[static_cast<size_t>(i)] *
                                 up.weights[static_cast<size_t>(j)]);
        }
    }
    copy(round, u, often_u);
    copy(up, v, often_v);
    return new Geom_BSplineSurface(points, weights, u, v, often_u, often_v, round.degree,
                                   up.degree);
}
