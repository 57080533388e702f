/* iges.cpp -- IGES 5.3: entity 128 for each surface, 126 for each curve, untrimmed, their names as
 * properties (406, form 15). They are made here and not by the library's translator, which would
 * cut what is not smooth, and print few digits. */
#include "occt.hpp"

#include <IGESBasic_GroupWithoutBackP.hxx>
#include <IGESBasic_Name.hxx>
#include <IGESControl_Controller.hxx>
#include <IGESControl_Reader.hxx>
#include <IGESData_GlobalSection.hxx>
#include <IGESData_IGESModel.hxx>
#include <IGESData_IGESWriter.hxx>
#include <IGESData_Protocol.hxx>
#include <IGESGeom_BSplineCurve.hxx>
#include <IGESGeom_BSplineSurface.hxx>
#include <IGESSelect_WorkLibrary.hxx>
#include <Interface_Static.hxx>
#include <TColStd_HArray1OfReal.hxx>
#include <TColStd_HArray2OfReal.hxx>
#include <TColgp_HArray1OfXYZ.hxx>
#include <TColgp_HArray2OfXYZ.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TransferBRep.hxx>
#include <Transfer_Binder.hxx>
#include <Transfer_TransientProcess.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_WorkSession.hxx>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>

/* A name in one line: the lines of the file are of fixed width, so that a control character in a
 * name makes it unreadable. */
static std::string printable(std::string name)
{
    std::replace_if(
        name.begin(), name.end(), [](unsigned char c) { return c < 0x20 || c == 0x7f; }, ' ');
    return name;
}

/* IGES's number of a unit, and the name in its files. */
struct unit_row {
    const char *unit, *occt, *iges;
    int flag;
};

static const unit_row units[] = {{"mm", "MM", "MM", 2},
                                 {"in", "INCH", "IN", 1},
                                 {"ft", "FT", "FT", 4},
                                 {"m", "M", "M", 6},
                                 {"cm", "CM", "CM", 10}};

static const unit_row &row_of(const std::string &unit)
{
    for (const unit_row &row : units) {
        if (unit == row.unit) {
            return row;
        }
    }
    throw occt_failure(TAUT_INTERNAL, "fault", "there is no unit \"" + unit + "\"");
}

const char *occt_unit(const char *unit)
{
    return row_of(unit).occt;
}

static Handle(TCollection_HAsciiString) to_text(const std::string &from)
{
    return new TCollection_HAsciiString(from.c_str());
}

/* Knots as IGES counts them, from -degree to count. */
static Handle(TColStd_HArray1OfReal) knots_of(const taut_cad_item &item, int d)
{
    const int degree = item.degree[d], count = item.count[d];
    Handle(TColStd_HArray1OfReal) knots = new TColStd_HArray1OfReal(-degree, count);
    for (int i = 0; i <= count + degree; i++) {
        knots->SetValue(i - degree, item.knots[d][i]);
    }
    return knots;
}

static gp_XYZ point_at(const taut_cad_item &item, int i)
{
    return gp_XYZ(item.points[3 * i], item.points[3 * i + 1], item.points[3 * i + 2]);
}

static double weight_at(const taut_cad_item &item, int i)
{
    return item.weights != nullptr ? item.weights[i] : 1.0;
}

static Handle(IGESData_IGESEntity) entity_of_surface(const taut_cad_item &item)
{
    const int nu = item.count[0], nv = item.count[1], last_u = nu - 1, last_v = nv - 1;
    Handle(TColgp_HArray2OfXYZ) points = new TColgp_HArray2OfXYZ(0, last_u, 0, last_v);
    Handle(TColStd_HArray2OfReal) weights = new TColStd_HArray2OfReal(0, last_u, 0, last_v);
    Handle(IGESGeom_BSplineSurface) made = new IGESGeom_BSplineSurface();
    bool closed_u = true, closed_v = true;
    for (int i = 0; i < nu; i++) {
        for (int j = 0; j < nv; j++) {
            points->SetValue(i, j, point_at(item, i * nv + j));
            weights->SetValue(i, j, weight_at(item, i * nv + j));
        }
    }
    for (int j = 0; j < nv; j++) {
        closed_u = closed_u && points->Value(0, j).IsEqual(points->Value(last_u, j), 0);
    }
    for (int i = 0; i < nu; i++) {
        closed_v = closed_v && points->Value(i, 0).IsEqual(points->Value(i, last_v), 0);
    }
    made->Init(last_u, last_v, item.degree[0], item.degree[1], closed_u, closed_v,
               item.weights == nullptr, Standard_False, Standard_False, knots_of(item, 0),
               knots_of(item, 1), weights, points, item.knots[0][0], item.knots[0][nu],
               item.knots[1][0], item.knots[1][nv]);
    return made;
}

/* Lies the curve in a plane, and which is it? From the widest cross product of its legs. */
static bool is_planar(const taut_cad_item &item, gp_XYZ &normal)
{
    const gp_XYZ first = point_at(item, 0);
    double size = 0;
    normal = gp_XYZ(0, 0, 0);
    for (int i = 1; i < item.count[0]; i++) {
        size = std::max(size, (point_at(item, i) - first).Modulus());
        for (int j = 1; j < i; j++) {
            const gp_XYZ cross = (point_at(item, j) - first).Crossed(point_at(item, i) - first);
            normal = cross.Modulus() > normal.Modulus() ? cross : normal;
        }
    }
    if (!(normal.Modulus() > 1e-12 * size * size)) {
        normal = gp_XYZ(0, 0, 0);
        return false;
    }
    normal.Normalize();
    for (int i = 1; i < item.count[0]; i++) {
        if (std::fabs((point_at(item, i) - first).Dot(normal)) > 1e-12 * size) {
            return false;
        }
    }
    return true;
}

static Handle(IGESData_IGESEntity) entity_of_curve(const taut_cad_item &item)
{
    const int n = item.count[0], last = n - 1;
    Handle(TColgp_HArray1OfXYZ) points = new TColgp_HArray1OfXYZ(0, last);
    Handle(TColStd_HArray1OfReal) weights = new TColStd_HArray1OfReal(0, last);
    Handle(IGESGeom_BSplineCurve) made = new IGESGeom_BSplineCurve();
    gp_XYZ normal;
    const bool planar = n <= 64 && is_planar(item, normal);
    for (int i = 0; i < n; i++) {
        points->SetValue(i, point_at(item, i));
        weights->SetValue(i, weight_at(item, i));
    }
    made->Init(last, item.degree[0], planar, points->Value(0).IsEqual(points->Value(last), 0),
               item.weights == nullptr, Standard_False, knots_of(item, 0), weights, points,
               item.knots[0][0], item.knots[0][n], planar ? normal : gp_XYZ(0, 0, 0));
    return made;
}

static void set_global(const taut_cad_job &job, const Handle(IGESData_IGESModel) & model)
{
    IGESData_GlobalSection global = model->GlobalSection();
    const unit_row &unit = row_of(job.unit);
    std::string date = job.date; /* 2026-03-01T12:00:00 as 20260301.120000 */
    date.erase(std::remove(date.begin(), date.end(), '-'), date.end());
    date.erase(std::remove(date.begin(), date.end(), ':'), date.end());
    std::replace(date.begin(), date.end(), 'T', '.');
    global.SetSendName(to_text(printable(job.name)));
    global.SetReceiveName(to_text(printable(job.name)));
    global.SetFileName(to_text(printable(job.name)));
    global.SetSystemId(to_text("taut"));
    global.SetInterfaceVersion(to_text("OpenCASCADE 7.6"));
    global.SetUnitFlag(unit.flag);
    global.SetUnitName(to_text(unit.iges));
    global.SetResolution(job.precision);
    global.SetDate(to_text(date));
    global.SetLastChangeDate(to_text(date));
    global.SetAuthorName(to_text(""));
    global.SetCompanyName(to_text(""));
    model->SetGlobalSection(global);
    model->ClearStartSection();
    for (int i = 0; i < job.note_count; i++) {
        model->AddStartLine(job.notes[i]);
    }
}

static void add_named(const Handle(IGESData_IGESModel) & model,
                      const Handle(IGESData_IGESEntity) & entity, const char *name)
{
    if (name[0] != '\0') {
        Handle(IGESBasic_Name) property = new IGESBasic_Name();
        property->Init(1, to_text(printable(name)));
        property->InitStatus(0, 1, 0, 0);
        entity->AddProperty(property);
        model->AddEntity(property);
    }
    model->AddEntity(entity);
}

std::string occt_write_iges(const taut_cad_job &job, int count, const taut_cad_item *items)
{
    IGESControl_Controller::Init();
    const Handle(IGESData_Protocol) protocol = IGESSelect_WorkLibrary::DefineProtocol();
    Handle(IGESData_IGESModel) model = new IGESData_IGESModel();
    Handle(IGESData_HArray1OfIGESEntity) members = new IGESData_HArray1OfIGESEntity(1, count);
    double reach = 0;

    for (int i = 0; i < count; i++) {
        const int n = items[i].count[0] * (items[i].count[1] > 0 ? items[i].count[1] : 1);
        for (int k = 0; k < 3 * n; k++) {
            reach = std::max(reach, std::fabs(items[i].points[k]));
        }
        const Handle(IGESData_IGESEntity) entity =
            items[i].count[1] > 0 ? entity_of_surface(items[i]) : entity_of_curve(items[i]);
        add_named(model, entity, items[i].name);
        members->SetValue(i + 1, entity);
    }
    if (count > 1) {
        const Handle(IGESBasic_GroupWithoutBackP) group = new IGESBasic_GroupWithoutBackP();
        group->Init(members);
        add_named(model, group, job.name);
    }
    set_global(job, model);
    IGESData_GlobalSection global = model->GlobalSection();
    global.SetMaxCoord(reach);
    model->SetGlobalSection(global);
    IGESData_IGESWriter output(model);
    output.FloatWriter().SetFormat(
        "%.16E"); /* with one digit more -1E-178 has no room in the library, and ends it */
    output.SendModel(protocol);
    std::ostringstream text;
    if (!output.Print(text) || !text.flush()) {
        throw occt_failure(TAUT_INTERNAL, "library", "OpenCASCADE does not print the file");
    }
    return text.str();
}

TopoDS_Shape occt_read_iges(const taut_cad_job &job, const occt_sink &sink, occt_names &names)
{
    IGESControl_Reader reader;
    const char *unit = nullptr;

    occt_keep_closed();
    Interface_Static::SetIVal("read.iges.bspline.continuity", 0); /* cut nothing that has a kink */
    if (reader.ReadFile(job.path) != IFSelect_RetDone) {
        throw occt_failure(TAUT_BAD_INPUT, "broken", "this is no IGES file, or a broken one");
    }
    const Handle(IGESData_IGESModel) model = reader.IGESModel();
    const std::vector<iges_shape> shapes = occt_iges_shapes(model, sink);
    for (const unit_row &row : units) {
        if (model->GlobalSection().UnitFlag() == row.flag) {
            unit = row.unit;
        }
    }
    IGESData_GlobalSection global = model->GlobalSection();
    global.SetCascadeUnit(1);
    const double millimetres = global.UnitValue(); /* 1 / so many is the file's unit */
    if (unit != nullptr) {
        global.SetCascadeUnit(millimetres);
    } else {
        const Handle(TCollection_HAsciiString) name = global.UnitName();
        occt_say(sink, std::string("the file is in units of ") +
                           (name.IsNull() ? "no name" : name->ToCString()) +
                           ": its lengths are converted, to be in mm");
        unit = "mm";
    }
    model->SetGlobalSection(global);
    sink.unit(sink.context, unit);
    reader
        .NbRootsForTransfer(); /* what is to be read, before parts of what is broken hang on nothing */
    occt_take_broken(shapes);
    reader.TransferRoots();
    const Handle(Transfer_TransientProcess) process =
        reader.WS()->TransferReader()->TransientProcess();
    for (int i = 1; i <= process->NbMapped(); i++) {
        const Handle(IGESData_IGESEntity) entity =
            Handle(IGESData_IGESEntity)::DownCast(process->Mapped(i));
        const Handle(Transfer_Binder) binder = process->MapItem(i);
        if (!entity.IsNull() && entity->HasName() && !binder.IsNull()) {
            names.add(TransferBRep::ShapeResult(binder), entity->NameValue()->ToCString());
        }
    }
    const TopoDS_Shape shape = reader.OneShape();
    const int left_out = occt_name_left_out_iges(model, process, shapes, sink);
    if (left_out > 0 && shape.IsNull()) {
        throw occt_failure(TAUT_BAD_INPUT, "broken",
                           !shapes[0].fault.empty()
                               ? shapes[0].fault
                               : "none of its " + std::to_string(left_out) + " shapes can be read");
    }
    return shape;
}
