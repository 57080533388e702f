/* geometry.cpp -- between items and OpenCASCADE's B-splines. */
#include "occt.hpp"

#include <ShapeAlgo.hxx>
#include <ShapeAlgo_AlgoContainer.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColStd_Array2OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TColgp_Array2OfPnt.hxx>

#include <vector>

/* Distinct knots with how often each is there. */
struct knot_vector {
    std::vector<double> values;
    std::vector<int> times;
};

static knot_vector distinct(const double *knots, int count)
{
    knot_vector out;
    for (int i = 0; i < count; i++) {
        if (i == 0 || knots[i] != knots[i - 1]) {
            out.values.push_back(knots[i]);
            out.times.push_back(0);
        }
        out.times.back()++;
    }
    return out;
}

static TColStd_Array1OfReal reals(const std::vector<double> &values)
{
    return TColStd_Array1OfReal(values[0], 1, static_cast<int>(values.size()));
}

static TColStd_Array1OfInteger integers(const std::vector<int> &values)
{
    return TColStd_Array1OfInteger(values[0], 1, static_cast<int>(values.size()));
}

void occt_check_degree(const taut_cad_item &item)
{
    for (int d = 0; d < 2; d++) {
        if (item.degree[d] > Geom_BSplineSurface::MaxDegree()) {
            throw occt_failure(TAUT_NO_SOLUTION, "degree",
                               "\"" + std::string(item.name) + "\" has degree " +
                                   std::to_string(item.degree[d]) +
                                   ", and OpenCASCADE writes none above " +
                                   std::to_string(Geom_BSplineSurface::MaxDegree()));
        }
    }
}

static gp_Pnt point_at(const taut_cad_item &item, int i)
{
    const double *p = item.points + 3 * i;
    return gp_Pnt(p[0], p[1], p[2]);
}

Handle(Geom_BSplineSurface) occt_surface(const taut_cad_item &item)
{
    const int nu = item.count[0], nv = item.count[1];
    const knot_vector u = distinct(item.knots[0], nu + item.degree[0] + 1);
    const knot_vector v = distinct(item.knots[1], nv + item.degree[1] + 1);
    TColgp_Array2OfPnt points(1, nu, 1, nv);
    TColStd_Array2OfReal weights(1, nu, 1, nv);

    occt_check_degree(item);
    for (int i = 0; i < nu; i++) {
        for (int j = 0; j < nv; j++) {
            points.SetValue(i + 1, j + 1, point_at(item, i * nv + j));
            weights.SetValue(i + 1, j + 1,
                             item.weights != nullptr ? item.weights[i * nv + j] : 1.0);
        }
    }
    if (item.weights == nullptr) {
        return new Geom_BSplineSurface(points, reals(u.values), reals(v.values), integers(u.times),
                                       integers(v.times), item.degree[0], item.degree[1]);
    }
    return new Geom_BSplineSurface(points, weights, reals(u.values), reals(v.values),
                                   integers(u.times), integers(v.times), item.degree[0],
                                   item.degree[1]);
}

Handle(Geom_BSplineCurve) occt_curve(const taut_cad_item &item)
{
    const int n = item.count[0];
    const knot_vector t = distinct(item.knots[0], n + item.degree[0] + 1);
    TColgp_Array1OfPnt points(1, n);
    TColStd_Array1OfReal weights(1, n);

    occt_check_degree(item);
    for (int i = 0; i < n; i++) {
        points.SetValue(i + 1, point_at(item, i));
        weights.SetValue(i + 1, item.weights != nullptr ? item.weights[i] : 1.0);
    }
    if (item.weights == nullptr) {
        return new Geom_BSplineCurve(points, reals(t.values), integers(t.times), item.degree[0]);
    }
    return new Geom_BSplineCurve(points, weights, reals(t.values), integers(t.times),
                                 item.degree[0]);
}

/* OpenCASCADE's readers make a surface periodic whose opposite edges lie within 1e-7: that moves
 * points of thin ones, and rounds those of rational ones. */
class as_it_is : public ShapeAlgo_AlgoContainer
{
  public:
    Handle(Geom_Surface) ConvertToPeriodic(const Handle(Geom_Surface) &) const override
    {
        return nullptr; /* none: the reader goes on with what it has */
    }
};

void occt_keep_closed()
{
    ShapeAlgo::SetAlgoContainer(new as_it_is);
}
