/* probe.cpp -- OpenCASCADE's reader with names and colours, its check and its integration. */
#include "probe.h"

#include <BRepBndLib.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepGProp.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <GProp_GProps.hxx>
#include <IGESControl_Reader.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Quantity_Color.hxx>
#include <STEPCAFControl_Reader.hxx>
#include <STEPControl_Reader.hxx>
#include <ShapeAnalysis_ShapeTolerance.hxx>
#include <Standard_Failure.hxx>
#include <TCollection_ExtendedString.hxx>
#include <TDF_LabelSequence.hxx>
#include <TDataStd_Name.hxx>
#include <TDocStd_Document.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <XCAFDoc_ColorTool.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_WorkSession.hxx>

#include <cstdio>
#include <cstring>

int step_probe_is_there(void)
{
    return 1;
}

static int count_of(const TopoDS_Shape &shape, TopAbs_ShapeEnum kind)
{
    TopTools_IndexedMapOfShape map;
    TopExp::MapShapes(shape, kind, map);
    return map.Extent();
}

static void count_edges(const TopoDS_Shape &shape, step_probe *found)
{
    TopTools_IndexedDataMapOfShapeListOfShape map;
    TopExp::MapShapesAndAncestors(shape, TopAbs_EDGE, TopAbs_FACE, map);
    for (int i = 1; i <= map.Extent(); i++) {
        const TopoDS_Edge edge = TopoDS::Edge(map.FindKey(i));
        if (BRep_Tool::Degenerated(edge)) {
            continue;
        }
        found->edges++;
        found->free_edges +=
            map(i).Extent() == 1 && !BRep_Tool::IsClosed(edge, TopoDS::Face(map(i).First()));
    }
}

static void look_at(const TopoDS_Shape &shape, step_probe *found)
{
    GProp_GProps inside, on;
    Bnd_Box box;
    found->valid = BRepCheck_Analyzer(shape).IsValid();
    found->solids = count_of(shape, TopAbs_SOLID);
    found->shells = count_of(shape, TopAbs_SHELL);
    found->faces = count_of(shape, TopAbs_FACE);
    found->vertices = count_of(shape, TopAbs_VERTEX);
    count_edges(shape, found);
    found->closed = found->solids > 0;
    for (TopExp_Explorer solid(shape, TopAbs_SOLID); solid.More(); solid.Next()) {
        for (TopExp_Explorer at(solid.Current(), TopAbs_SHELL); at.More(); at.Next()) {
            found->closed = found->closed && BRep_Tool::IsClosed(at.Current());
        }
    }
    BRepGProp::VolumeProperties(shape, inside, 1e-9, Standard_True, Standard_True);
    BRepGProp::SurfaceProperties(shape, on, 1e-9, Standard_True);
    found->volume = inside.Mass();
    found->area = on.Mass();
    found->tolerance = ShapeAnalysis_ShapeTolerance().Tolerance(shape, 1);
    BRepBndLib::AddOptimal(shape, box, Standard_False, Standard_False);
    if (!box.IsVoid()) {
        box.Get(found->box[0], found->box[1], found->box[2], found->box[3], found->box[4],
                found->box[5]);
    }
}

static void look_at_labels(const Handle(TDocStd_Document) & document, step_probe *found)
{
    const Handle(XCAFDoc_ShapeTool) shapes = XCAFDoc_DocumentTool::ShapeTool(document->Main());
    const Handle(XCAFDoc_ColorTool) colours = XCAFDoc_DocumentTool::ColorTool(document->Main());
    TDF_LabelSequence roots;
    shapes->GetFreeShapes(roots);
    for (int i = 1; i <= roots.Length(); i++) {
        const TopoDS_Shape shape = XCAFDoc_ShapeTool::GetShape(roots.Value(i));
        Handle(TDataStd_Name) name;
        if (i == 1) {
            look_at(shape, found);
            if (roots.Value(i).FindAttribute(TDataStd_Name::GetID(), name)) {
                Standard_PCharacter text = found->product;
                if (name->Get().LengthOfCString() < static_cast<int>(sizeof found->product)) {
                    name->Get().ToUTF8CString(text);
                }
            }
        }
        TopTools_IndexedMapOfShape faces;
        TopExp::MapShapes(shape, TopAbs_FACE, faces);
        for (int f = 1; f <= faces.Extent(); f++) {
            Quantity_Color colour;
            found->colours += colours->GetColor(faces(f), XCAFDoc_ColorSurf, colour);
        }
    }
    found->is_read = roots.Length() == 1;
}

int step_probe_areas(const char *path)
{
    try {
        Message::DefaultMessenger()->ChangePrinters().Clear();
        STEPControl_Reader step;
        IGESControl_Reader iges;
        XSControl_Reader &reader = std::strstr(path, ".ig") != nullptr
                                       ? static_cast<XSControl_Reader &>(iges)
                                       : static_cast<XSControl_Reader &>(step);
        if (reader.ReadFile(path) != IFSelect_RetDone) {
            return 0;
        }
        reader.TransferRoots();
        TopTools_IndexedMapOfShape faces;
        TopExp::MapShapes(reader.OneShape(), TopAbs_FACE, faces);
        for (int i = 1; i <= faces.Extent(); i++) {
            GProp_GProps on;
            BRepGProp::SurfaceProperties(faces(i), on, 1e-9);
            std::printf("%.15g\n", on.Mass());
        }
        return 1;
    } catch (const Standard_Failure &failure) {
        std::fprintf(stderr, "%s: %s\n", path, failure.DynamicType()->Name());
        return 0;
    }
}

void step_probe_file(const char *path, step_probe *found)
{
    std::memset(found, 0, sizeof *found);
    try {
        Message::DefaultMessenger()->ChangePrinters().Clear();
        Handle(TDocStd_Document) document = new TDocStd_Document("BinXCAF");
        STEPCAFControl_Reader reader;
        reader.SetNameMode(true);
        reader.SetColorMode(true);
        if (reader.ReadFile(path) == IFSelect_RetDone && reader.Transfer(document)) {
            look_at_labels(document, found);
        }
    } catch (const Standard_Failure &failure) {
        std::fprintf(stderr, "%s: %s %s\n", path, failure.DynamicType()->Name(),
                     failure.GetMessageString());
        found->is_read = 0;
    }
}
