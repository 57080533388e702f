"""Taut's models and problems in ParaView: load this file under Tools > Manage Plugins, and open .json files with "Taut".

Surfaces are exact Bezier cells with curvatures; a problem is made on the fly. The certificate is field data. The package taut is found
where ParaView's Python finds it, or beside this file in vendor/.
"""
import json
import os
import sys

from paraview.util.vtkAlgorithm import VTKPythonAlgorithmBase, smdomain, smhint, smproperty, smproxy
from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkStringArray
from vtkmodules.vtkCommonDataModel import vtkUnstructuredGrid
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader

try:
    import taut
except ImportError:
    sys.path.append(os.path.join(os.path.dirname(os.path.abspath(__file__)), "vendor"))
    try:
        import taut
    except ImportError as error:
        raise ImportError(f"the reader Taut finds no package taut ({error}): load the taut_reader.py of taut-paraview.zip, which `make plugins` writes "
                          "and which has it in it, or install a wheel of taut for the Python of ParaView") from None
from taut import hosts

WORDS = {True: "holds", False: "does not hold", None: "undecided"}


def model_of(path, progress=None):
    """The model in a file, or that of the problem in it; of a list of problems the first."""
    with open(path, encoding="utf-8-sig") as file:
        document = json.load(file)
    if isinstance(document, list) or (isinstance(document, dict) and "construct" in document):
        made = taut.make(path, progress=progress)
        return made[0] if isinstance(made, list) else made
    return taut.read(path)


def add(grid, name, values):
    """Field data: texts, or numbers."""
    is_text = bool(values) and isinstance(values[0], str)
    array = vtkStringArray() if is_text else vtkDoubleArray()
    array.SetName(name)
    array.SetNumberOfValues(len(values))
    for i, value in enumerate(values):
        array.SetValue(i, value)
    grid.GetFieldData().AddArray(array)


def grid_of(model, certificate):
    """The model as a grid, as `taut` writes it to VTU, and a certificate."""
    text = model.to_text("vtu")
    reader = vtkXMLUnstructuredGridReader()
    reader.ReadFromInputStringOn()
    reader.SetInputString(text.decode())
    reader.Update()
    grid = vtkUnstructuredGrid()
    grid.ShallowCopy(reader.GetOutput())
    add(grid, "taut certificate", hosts.claims(certificate))
    add(grid, "taut unit", [model.unit])
    if certificate is not None:
        add(grid, "taut holds", [WORDS[certificate.holds]])
        add(grid, "taut claims", [one.claim for one in certificate])
        add(grid, "taut kinds", [one.kind for one in certificate])
        add(grid, "taut verdicts", [WORDS[one.holds] for one in certificate])
        add(grid, "taut residuals", [float(one.residual) for one in certificate])
        add(grid, "taut limits", [float(one.limit) for one in certificate])
        for name, value in certificate.figures.items():
            if isinstance(value, (int, float)) and not isinstance(value, bool):
                add(grid, name, [float(value)])
    return grid


@smproxy.reader(name="TautReader", label="Taut", extensions="json", file_description="Taut models and problems")
class TautReader(VTKPythonAlgorithmBase):
    """A reader; a file that cannot be made says so in ParaView's messages, with what to change."""

    def __init__(self):
        VTKPythonAlgorithmBase.__init__(self, nInputPorts=0, nOutputPorts=1, outputType="vtkUnstructuredGrid")
        self._path, self._model, self._again = None, None, False

    @smproperty.stringvector(name="FileName")
    @smdomain.filelist()
    @smhint.filechooser(extensions="json", file_description="Taut models and problems")
    def SetFileName(self, path):
        """A model or a problem."""
        if path != self._path:
            self._path, self._model, self._again = path, None, False
            self.Modified()

    @smproperty.xml('<Property name="Read again" command="Again" panel_widget="command_button"/>')
    def Again(self):
        """The file has changed."""
        self._model, self._again = None, False
        self.Modified()

    @smproperty.xml('<Property name="Prove again" command="Prove" panel_widget="command_button"/>')
    def Prove(self):
        """The certificate is made anew from the numbers of the model, in place of the one that stands in its file."""
        self._again = True
        self.Modified()

    def RequestData(self, request, inputs, outputs):
        if not self._path or self._path == "None":
            return 1
        try:
            if self._model is None:
                self._model = model_of(self._path, lambda done, what: self.UpdateProgress(done if done == done else 0.5))
            certificate = taut.certify(self._model) if self._again else self._model.certificate
            if certificate is not None and certificate.holds is False:
                print(f"{self._path}: the certificate does not hold: its claims are in the field data", file=sys.stderr)
            vtkUnstructuredGrid.GetData(outputs, 0).ShallowCopy(grid_of(self._model, certificate))
            return 1
        except (taut.Error, OSError, ValueError, MemoryError, RecursionError) as error:
            print(f"{self._path}: {hosts.told(error)}", file=sys.stderr)
            return 0
