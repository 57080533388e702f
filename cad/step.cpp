/* step.cpp -- reading STEP, of any application protocol. */
#include "occt.hpp"

#include <Interface_Static.hxx>
#include <STEPControl_Reader.hxx>
#include <StepData_StepModel.hxx>
#include <StepRepr_RepresentationItem.hxx>
#include <StepShape_GeometricSet.hxx>
#include <TColStd_SequenceOfAsciiString.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TopExp_Explorer.hxx>
#include <TransferBRep.hxx>
#include <Transfer_Binder.hxx>
#include <Transfer_TransientProcess.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_WorkSession.hxx>

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

TopoDS_Shape occt_read_step(const taut_cad_job &job, const occt_sink &sink, occt_names &names)
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
