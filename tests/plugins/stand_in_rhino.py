"""The few types of RhinoCommon that the scripts use, as its documentation describes them; what has no place there is refused."""
import types


class Point3d:
    def __init__(self, x, y, z):
        self.X, self.Y, self.Z = float(x), float(y), float(z)


class Fixed(list):
    """A list of a length that is given: Rhino's knot lists."""

    Count = property(len)

    def append(self, value):
        raise TypeError("it has its length")


class Points:
    def __init__(self, nu, nv, rational):
        self.places, self.weights, self.rational = [[None] * nv for _ in range(nu)], [[1.0] * nv for _ in range(nu)], rational

    def SetPoint(self, u, v, point, weight=None):
        assert isinstance(point, Point3d) and (weight is None or (self.rational and isinstance(weight, float)))
        self.places[u][v] = [point.X, point.Y, point.Z]
        self.weights[u][v] = 1.0 if weight is None else weight
        return True


class NurbsSurface:
    @staticmethod
    def Create(dimension, rational, order_u, order_v, count_u, count_v):
        assert dimension == 3 and isinstance(rational, bool)
        one = NurbsSurface()
        one.IsRational, one.OrderU, one.OrderV = rational, order_u, order_v
        one.Points = Points(count_u, count_v, rational)
        one.KnotsU, one.KnotsV = Fixed([0.0] * (order_u + count_u - 2)), Fixed([0.0] * (order_v + count_v - 2))
        return one


class ControlPoints(list):
    Count = property(len)


class NurbsCurve:
    """What `Curve.ToNurbsCurve` gives."""

    def __init__(self, degree, knots, points, weights=None, closed=False):
        self.Degree, self.Knots, self.IsRational, self.IsClosed, self.IsPeriodic = degree, Fixed(knots), weights is not None, closed, False
        self.Points = ControlPoints(types.SimpleNamespace(Location=Point3d(*p), Weight=w) for p, w in zip(points, weights or [1.0] * len(points)))

    def ToNurbsCurve(self):
        return self


class Line:
    def __init__(self, a, b):
        self.From, self.To = Point3d(*a), Point3d(*b)


def module(unit="Millimeters"):
    """What `import Rhino` gives."""
    rhino = types.ModuleType("Rhino")
    rhino.Geometry = types.SimpleNamespace(NurbsSurface=NurbsSurface, Point3d=Point3d, Line=Line)
    rhino.RhinoDoc = types.SimpleNamespace(ActiveDoc=types.SimpleNamespace(ModelUnitSystem=unit))
    return rhino
