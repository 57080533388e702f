"""What a program that uses the package looks like to mypy --strict; it is not run."""
import numpy as np

import taut

points = np.full((8, 8, 3), np.nan)
model = taut.plateau(points, u=taut.bspline(3, count=8), v={"type": "bspline", "degree": 3, "count": 8}, method="normal")
holds: "bool | None" = model.certificate["stationary"].holds
area: float = model.certificate.figures["area"]
shape: "tuple[int, ...]" = model.surfaces[0](0.5, 0.5).shape
vertices, faces = model.mesh().vertices, model.mesh().faces
several: "list[taut.Model]" = taut.make([{"construct": "plateau", "points": points}])
net: taut.Model = taut.trace(trace="principal", of=model)
slope = taut.gradient({"construct": "plateau", "points": points}, model, of=np.ones((8, 8, 3)))
model.surfaces[0].grid([0.0, 1.0], np.linspace(0, 1, 5), 0, out=np.empty((2, 5, 3)))
for index, result in taut.map([{"construct": "plateau"}], out="results.jsonl"):
    print(index, result.reason if isinstance(result, taut.Error) else result.certificate.holds)
model.certificate.figure  # type: ignore[union-attr]
