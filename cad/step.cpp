/* step.cpp -- STEP (AP214): each surface a face bounded by its own edges, each curve an edge. */
#include "occt.hpp"

#include <APIHeaderSection_MakeHeader.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRep_Builder.hxx>
#include <Interface_HArray1OfHAsciiString.hxx>
#include <Interface_Static.hxx>
#include <STEPConstruct.hxx>
#include <STEPControl_Reader.hxx>
#include <STEPControl_Writer.hxx>
#include <StepData_Protocol.hxx>
#include <StepData_StepModel.hxx>
#include <StepData_StepWriter.hxx>
#include <StepRepr_RepresentationItem.hxx>
#include <StepShape_GeometricSet.hxx>
#include <TColStd_SequenceOfAsciiString.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TransferBRep.hxx>
#include <Transfer_Binder.hxx>
#include <Transfer_FinderProcess.hxx>
#include <Transfer_TransientProcess.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_TransferWriter.hxx>
#include <XSControl_WorkSession.hxx>

#include <fstream>
#include <vector>

static Handle(TCollection_HAsciiString) to_text(const std::string &from)
{
    return new TCollection_HAsciiString(from.c_str());
}

static void set_option(const char *name, const char *value)
{
    if (!Interface_Static::SetCVal(name, value)) {
        throw occt_failure(TAUT_INTERNAL, "library",
                           std::string("OpenCASCADE does not take ") + name + " " + value);
    }
}

/* Lengths stay as they are: the library's own unit is made the file's. */
static void set_unit(const char *unit)
{
    set_option("xstep.cascade.unit", occt_unit(unit));
    set_option("write.step.unit", occt_unit(unit));
}

static TopoDS_Shape shape_of(const taut_cad_item &item, double precision)
{
    if (item.count[1] == 0) {
        BRepBuilderAPI_MakeEdge make(occt_curve(item));
        if (!make.IsDone()) {
            throw occt_failure(TAUT_NO_SOLUTION, "library",
                               "OpenCASCADE makes no edge of the curve \"" +
                                   std::string(item.name) + "\"");
        }
        return make.Edge();
    }
    BRepBuilderAPI_MakeFace make(occt_surface(item), precision);
    if (!make.IsDone()) {
        throw occt_failure(TAUT_NO_SOLUTION, "library",
                           "OpenCASCADE makes no face of the surface \"" + std::string(item.name) +
                               "\"");
    }
    return make.Face();
}

/* The lines that say what the file is, and when and by what it was made. */
static void set_header(const taut_cad_job &job, const Handle(StepData_StepModel) & model)
{
    APIHeaderSection_MakeHeader header(model);
    const int count = job.note_count > 0 ? job.note_count : 1;
    Handle(Interface_HArray1OfHAsciiString) notes = new Interface_HArray1OfHAsciiString(1, count);
    notes->SetValue(1, to_text(""));
    for (int i = 0; i < job.note_count; i++) {
        notes->SetValue(i + 1, to_text(job.notes[i]));
    }
    header.SetDescription(notes);
    header.SetName(to_text(job.name));
    header.SetTimeStamp(to_text(job.date));
    header.SetAuthorValue(1, to_text(""));
    header.SetOrganizationValue(1, to_text(""));
    header.SetPreprocessorVersion(to_text("OpenCASCADE 7.6"));
    header.SetOriginatingSystem(to_text("taut"));
    header.SetAuthorisation(to_text(""));
}

void occt_write_step(const taut_cad_job &job, int count, const taut_cad_item *items)
{
    STEPControl_Writer writer;
    BRep_Builder builder;
    TopoDS_Compound all;
    std::vector<TopoDS_Shape> shapes;

    set_unit(job.unit);
    set_option("write.step.schema", "AP214IS");
    set_option("write.step.product.name", job.name);
    Interface_Static::SetIVal("write.precision.mode", 2);
    Interface_Static::SetRVal("write.precision.val", job.precision);
    Interface_Static::SetIVal("write.surfacecurve.mode", 1); /* spares readers a projection */
    Interface_Static::SetIVal("write.step.assembly", 0);
    writer.Model(Standard_True);
    builder.MakeCompound(all);
    for (int i = 0; i < count; i++) {
        shapes.push_back(shape_of(items[i], job.precision));
        builder.Add(all, shapes.back());
    }
    if (writer.Transfer(all, STEPControl_AsIs) != IFSelect_RetDone) {
        throw occt_failure(TAUT_INTERNAL, "library", "OpenCASCADE did not take the model");
    }
    const Handle(Transfer_FinderProcess) found = writer.WS()->TransferWriter()->FinderProcess();
    for (int i = 0; i < count; i++) {
        const Handle(StepRepr_RepresentationItem) entity =
            STEPConstruct::FindEntity(found, shapes[static_cast<size_t>(i)]);
        if (!entity.IsNull()) {
            entity->SetName(to_text(items[i].name));
        }
    }
    const Handle(StepData_StepModel) model = writer.Model(Standard_False);
    set_header(job, model);
    StepData_StepWriter output(model);
    output.FloatWriter().SetFormat("%.17E");
    output.SendModel(Handle(StepData_Protocol)::DownCast(model->Protocol()));
    std::ofstream file(job.path, std::ios::binary | std::ios::trunc);
    if (!output.Print(file) || !file.flush()) {
        throw occt_failure(TAUT_IO, "write", "the file cannot be written");
    }
}

/* "millimetre", or "MILLIMETRE", as the model says it; NULL for units that taut does not have. */
static const char *unit_of(const TCollection_AsciiString &name)
{
    static const char *const known[][2] = {
        {"millimetre", "mm"}, {"metre", "m"},       {"centimetre", "cm"}, {"millimeter", "mm"},
        {"meter", "m"},       {"centimeter", "cm"}, {"inch", "in"},       {"foot", "ft"},
        {"mm", "mm"},         {"cm", "cm"},         {"m", "m"},           {"in", "in"},
        {"ft", "ft"}};
    TCollection_AsciiString low(name);
    low.LowerCase();
    for (const auto &row : known) {
        if (low.IsEqual(row[0])) {
            return row[1];
        }
    }
    return nullptr;
}

TopoDS_Shape occt_read_step(const taut_cad_job &job, const taut_cad_sink &sink, occt_names &names)
{
    STEPControl_Reader reader;
    TColStd_SequenceOfAsciiString lengths, angles, solid_angles;
    const char *unit = "mm";

    occt_keep_closed();
    if (reader.ReadFile(job.path) != IFSelect_RetDone) {
        throw occt_failure(TAUT_BAD_INPUT, "broken", "this is no STEP file, or a broken one");
    }
    occt_check_loaded(reader.Model(), STANDARD_TYPE(StepRepr_RepresentationItem));
    reader.FileUnits(lengths, angles, solid_angles);
    if (lengths.Length() > 0 && unit_of(lengths.First()) != nullptr) {
        unit = unit_of(lengths.First());
    }
    set_unit(unit);
    sink.unit(sink.context, unit);
    reader.TransferRoots();
    const Handle(Transfer_TransientProcess) process =
        reader.WS()->TransferReader()->TransientProcess();
    for (int i = 1; i <= process->NbMapped(); i++) {
        const Handle(StepRepr_RepresentationItem) entity =
            Handle(StepRepr_RepresentationItem)::DownCast(process->Mapped(i));
        const Handle(Transfer_Binder) binder = process->MapItem(i);
        if (entity.IsNull() || entity->Name().IsNull() || binder.IsNull()) {
            continue;
        }
        const TopoDS_Shape shape = TransferBRep::ShapeResult(binder);
        names.add(shape, entity->Name()->ToCString());
        if (entity->IsKind(STANDARD_TYPE(StepShape_GeometricSet)) && !shape.IsNull()) {
            for (TopExp_Explorer at(shape, TopAbs_EDGE); at.More(); at.Next()) {
                names.add(at.Current(), entity->Name()->ToCString());
            }
        }
    }
    return reader.OneShape();
}
