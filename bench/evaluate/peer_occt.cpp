// peer_occt.cpp -- OpenCASCADE: the adaptor that caches the span.
#include "peer.h"

#include "machine.h"

#include <GeomAdaptor_Surface.hxx>
#include <Geom_BSplineSurface.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColStd_Array2OfReal.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <gp_Vec.hxx>

static Handle(Geom_BSplineSurface) surface(const peer_task *task)
{
    const int n = task->n;
    TColgp_Array2OfPnt poles(1, n, 1, n);
    TColStd_Array2OfReal weights(1, n, 1, n);
    TColStd_Array1OfReal knots(1, n - 2);
    TColStd_Array1OfInteger times(1, n - 2);
    for (int i = 0; i < n; i++) {
        for (int j = 0; j < n; j++) {
            const double *p = task->points + 3 * (i * n + j);
            poles.SetValue(i + 1, j + 1, gp_Pnt(p[0], p[1], p[2]));
            weights.SetValue(i + 1, j + 1, task->weights[i * n + j]);
        }
    }
    for (int i = 0; i < n - 2; i++) {
        knots.SetValue(i + 1, task->knots[i + 3]);
        times.SetValue(i + 1, i == 0 || i == n - 3 ? 4 : 1);
    }
    return new Geom_BSplineSurface(poles, weights, knots, knots, times, times, 3, 3);
}

static void put(double *to, const gp_XYZ &v)
{
    to[0] = v.X();
    to[1] = v.Y();
    to[2] = v.Z();
}

double peer_occt_cached(const peer_task *task, int order, double *values)
{
    const GeomAdaptor_Surface adaptor(surface(task));
    const int g = task->grid, vectors = (order + 1) * (order + 2) / 2;
    gp_Pnt p;
    gp_Vec u, v, uu, vv, uv;
    double took = bench_cpu_seconds();
    for (int i = 0; i < g; i++) {
        for (int j = 0; j < g; j++) {
            double *out = values + ((long)i * g + j) * vectors * 3;
            if (order == 0) {
                adaptor.D0(task->t[i], task->t[j], p);
                put(out, p.XYZ());
                continue;
            }
            adaptor.D2(task->t[i], task->t[j], p, u, v, uu, vv, uv);
            put(out, p.XYZ());
            put(out + 3, u.XYZ());
            put(out + 6, v.XYZ());
            put(out + 9, uu.XYZ());
            put(out + 12, uv.XYZ());
            put(out + 15, vv.XYZ());
        }
    }
    took = bench_cpu_seconds() - took;
    return took;
}
