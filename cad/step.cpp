/* step.cpp -- reading STEP, of any application protocol. */
#include "occt.hpp"

#include <APIHeaderSection_MakeHeader.hxx>
#include <Interface_Static.hxx>
#include <Quantity_Color.hxx>
#include <STEPConstruct_Styles.hxx>
#include <STEPControl_Reader.hxx>
#include <StepBasic_Product.hxx>
#include <StepBasic_ProductDefinition.hxx>
#include <StepBasic_ProductDefinitionFormation.hxx>
#include <StepData_StepModel.hxx>
#include <StepRepr_NextAssemblyUsageOccurrence.hxx>
#include <StepRepr_RepresentationItem.hxx>
#include <StepShape_GeometricSet.hxx>
#include <StepVisual_ColourRgb.hxx>
#include <StepVisual_StyledItem.hxx>
#include <TColStd_SequenceOfAsciiString.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TransferBRep.hxx>
#include <Transfer_Binder.hxx>
#include <Transfer_TransientProcess.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_WorkSession.hxx>

#include <cmath>
#include <map>
#include <set>
#include <utility>

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

/* How many faces and edges: parts come before what they are parts of. */
static int size_of(const TopoDS_Shape &shape)
{
    TopTools_IndexedMapOfShape parts;
    if (shape.IsNull()) {
        return 0;
    }
    TopExp::MapShapes(shape, TopAbs_FACE, parts);
    TopExp::MapShapes(shape, TopAbs_EDGE, parts);
    return parts.Extent();
}

/* The product that each face belongs to: the innermost one of an assembly. */
static void add_products(const Handle(Transfer_TransientProcess) & process, occt_names &names)
{
    std::multimap<int, std::pair<TopoDS_Shape, std::string>> products;
    for (int i = 1; i <= process->NbMapped(); i++) {
        const Handle(StepBasic_ProductDefinition) definition =
            Handle(StepBasic_ProductDefinition)::DownCast(process->Mapped(i));
        const Handle(Transfer_Binder) binder = process->MapItem(i);
        if (definition.IsNull() || binder.IsNull() || definition->Formation().IsNull() ||
            definition->Formation()->OfProduct().IsNull()) {
            continue;
        }
        const Handle(StepBasic_Product) product = definition->Formation()->OfProduct();
        const TopoDS_Shape shape = TransferBRep::ShapeResult(binder);
        if (!shape.IsNull() && !product->Name().IsNull()) {
            products.emplace(size_of(shape), std::make_pair(shape, product->Name()->ToCString()));
        }
    }
    for (const auto &product : products) {
        names.add_product(product.second.first, product.second.second);
    }
}

/* The product that an assembly is; "" where there is none, or several. */
static std::string whole_of(const Handle(Interface_InterfaceModel) & model)
{
    std::set<Handle(StepBasic_ProductDefinition)> wholes, parts;
    for (int i = 1; i <= model->NbEntities(); i++) {
        const Handle(StepRepr_NextAssemblyUsageOccurrence) use =
            Handle(StepRepr_NextAssemblyUsageOccurrence)::DownCast(model->Value(i));
        if (!use.IsNull() && !use->RelatingProductDefinition().IsNull()) {
            wholes.insert(use->RelatingProductDefinition());
            parts.insert(use->RelatedProductDefinition());
        }
    }
    for (const auto &part : parts) {
        wholes.erase(part);
    }
    if (wholes.size() != 1 || (*wholes.begin())->Formation().IsNull()) {
        return "";
    }
    const Handle(StepBasic_Product) product = (*wholes.begin())->Formation()->OfProduct();
    return product.IsNull() || product->Name().IsNull() ? "" : product->Name()->ToCString();
}

/* 1 + 0xRRGGBB; 0 where it is none. */
static int number_of(const Handle(StepVisual_Colour) & colour)
{
    double parts[3];
    const Handle(StepVisual_ColourRgb) rgb = Handle(StepVisual_ColourRgb)::DownCast(colour);
    Quantity_Color known;
    int number = 0;
    if (!rgb.IsNull()) {
        parts[0] = rgb->Red(), parts[1] = rgb->Green(), parts[2] = rgb->Blue();
    } else if (!colour.IsNull() && STEPConstruct_Styles::DecodeColor(colour, known)) {
        parts[0] = known.Red(), parts[1] = known.Green(), parts[2] = known.Blue(); /* 0 or 1 */
    } else {
        return 0;
    }
    for (const double part : parts) {
        if (!(part >= 0 && part <= 1)) {
            return 0;
        }
        number = 256 * number + static_cast<int>(std::lround(255 * part));
    }
    return 1 + number;
}

/* Colours of faces and curves; what is said of a face counts before what is said of its solid. */
static void add_colours(const Handle(XSControl_WorkSession) & session,
                        const Handle(Transfer_TransientProcess) & process, occt_names &names)
{
    std::multimap<int, std::pair<TopoDS_Shape, int>> colours;
    STEPConstruct_Styles styles(session);
    if (!styles.LoadStyles()) {
        return;
    }
    for (int i = 1; i <= styles.NbStyles(); i++) {
        const Handle(StepVisual_StyledItem) style = styles.Style(i);
        Handle(StepVisual_Colour) surface, boundary, curve, rendered;
        double transparency = 0;
        Standard_Boolean is_component = Standard_False;
        if (style.IsNull() || style->Item().IsNull() ||
            !styles.GetColors(style, surface, boundary, curve, rendered, transparency,
                              is_component)) {
            continue;
        }
        const int mapped = process->MapIndex(style->Item());
        const int colour = number_of(!surface.IsNull()    ? surface
                                     : !rendered.IsNull() ? rendered
                                                          : curve);
        const TopoDS_Shape shape =
            mapped > 0 ? TransferBRep::ShapeResult(process->MapItem(mapped)) : TopoDS_Shape();
        if (!shape.IsNull() && colour > 0) {
            colours.emplace(size_of(shape), std::make_pair(shape, colour));
        }
    }
    for (const auto &colour : colours) {
        names.add_colour(colour.second.first, colour.second.second);
    }
}

/* Does the header say that taut wrote the file? */
static bool is_own(const Handle(Interface_InterfaceModel) & model)
{
    const APIHeaderSection_MakeHeader header(Handle(StepData_StepModel)::DownCast(model));
    return header.HasFn() && !header.OriginatingSystem().IsNull() &&
           header.OriginatingSystem()->IsSameString(new TCollection_HAsciiString("taut"));
}

TopoDS_Shape occt_read_step(const taut_cad_job &job, const occt_sink &sink, occt_names &names)
{
    STEPControl_Reader reader;
    TColStd_SequenceOfAsciiString lengths, angles, solid_angles;
    const char *unit = "mm";
    occt_faults faults;

    occt_keep_closed();
    if (reader.ReadFile(job.path) != IFSelect_RetDone) {
        throw occt_failure(TAUT_BAD_INPUT, "broken", "this is no STEP file, or a broken one");
    }
    names.are_own = is_own(reader.Model());
    occt_leave_out_broken_step(reader.Model(), faults);
    reader.FileUnits(lengths, angles, solid_angles);
    if (lengths.Length() > 0 && unit_of(lengths.First()) != nullptr) {
        unit = unit_of(lengths.First());
    }
    set_unit(unit);
    sink.unit(sink.context, unit);
    if (lengths.Length() == 0) {
        occt_say(sink, "the file says no unit: taken as mm");
    } else if (unit_of(lengths.First()) == nullptr) {
        occt_say(sink, std::string("the file is in units of ") + lengths.First().ToCString() +
                           ": its lengths are converted, to be in mm");
    }
    const std::string whole = whole_of(reader.Model());
    if (!sink.product(sink.context, whole.c_str())) {
        throw occt_failure(TAUT_IO, "write", "what was read could not be passed on");
    }
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
    add_products(process, names);
    add_colours(reader.WS(), process, names);
    const TopoDS_Shape shape = reader.OneShape();
    const int left_out = occt_name_left_out_step(reader.Model(), process, faults, sink);
    if (left_out > 0 && size_of(shape) == 0) {
        throw occt_failure(TAUT_BAD_INPUT, "broken",
                           faults.empty()
                               ? "none of its " + std::to_string(left_out) + " faces can be read"
                               : faults.begin()->second);
    }
    return shape;
}
