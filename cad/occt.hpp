/* occt.hpp -- what the files around OpenCASCADE share. */
#ifndef TAUT_CAD_OCCT_HPP
#define TAUT_CAD_OCCT_HPP

#include "io/cad/wire.h"

#include <Geom_BSplineSurface.hxx>
#include <IGESData_IGESEntity.hxx>
#include <Interface_InterfaceModel.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <Transfer_TransientProcess.hxx>

#include <map>
#include <stdexcept>
#include <string>
#include <vector>

/* A failure with its status and its reason (TAUT_FILE_REASON_LIST); the message is a sentence. */
class occt_failure : public std::runtime_error
{
  public:
    occt_failure(taut_status code, const char *word, const std::string &message)
        : std::runtime_error(message), status(code), reason(word)
    {
    }
    taut_status status;
    const char *reason;
};

/* Where a reader puts what it finds; each returns 0 to stop. */
struct occt_sink {
    void *context;
    int (*unit)(void *context, const char *unit);
    int (*item)(void *context, const taut_cad_item *item);
    int (*note)(void *context, const char *note);
    int (*product)(void *context, const char *name);
};

/* A sentence about the file, for details.notes. */
void occt_say(const occt_sink &sink, const std::string &note);

/* Closed surfaces are to be read as they are; for a reader that has been made. */
void occt_keep_closed();

/* The unit as OpenCASCADE's settings and as taut's documents call it. */
const char *occt_unit(const char *unit);

/* The text of an IGES file. */
std::string occt_write_iges(const taut_cad_job &job, int count, const taut_cad_item *items);

/* What the file says of a face or an edge, by the geometry it hangs on. */
struct occt_about {
    std::string name, product;
    int colour = 0; /* as in taut_cad_item */
};
struct occt_names {
    std::map<const void *, occt_about> of;
    bool are_own = false; /* the file says that taut wrote it */
    void add(const TopoDS_Shape &shape, const std::string &name);
    /* All faces and free edges of a shape: what the first call says of one stays. */
    void add_product(const TopoDS_Shape &shape, const std::string &product);
    void add_colour(const TopoDS_Shape &shape, int colour);
    const occt_about &find(const TopoDS_Shape &shape) const;
};

/* Reads a file: its shapes, names, and its unit told to the sink. */
TopoDS_Shape occt_read_step(const taut_cad_job &job, const occt_sink &sink, occt_names &names);
TopoDS_Shape occt_read_iges(const taut_cad_job &job, const occt_sink &sink, occt_names &names);

/* What an entity is called in its file: "#12", "D3". */
std::string occt_label(const Handle(Interface_InterfaceModel) & model,
                       const Handle(Standard_Transient) & entity);

/* TAUT_BAD_INPUT if the library found fault with the file as a whole. */
void occt_check_whole(const Handle(Interface_InterfaceModel) & model);

/* What is wrong with the i-th entity, if it is of a kind; empty: nothing. */
std::string occt_fault(const Handle(Interface_InterfaceModel) & model, int i,
                       const Handle(Standard_Type) & needed);

/* What the library says where it makes nothing of an entity; empty: nothing. */
std::string occt_words(const Handle(Transfer_TransientProcess) & process,
                       const Handle(Standard_Transient) & entity);

/* The sentence about what is not read: "face #12", its name, why. */
void occt_say_left_out(const occt_sink &sink, const std::string &what, const std::string &name,
                       const std::string &why);

/* Faces and curves that are left out, each with the reason. */
using occt_faults = std::map<const void *, std::string>;

/* A file's faces are worth having without those that something broken is a part of: these get no surface. TAUT_BAD_INPUT where
 * what is broken holds faces, and is a part of none. */
void occt_leave_out_broken_step(const Handle(Interface_InterfaceModel) & model,
                                occt_faults &faults);

/* Names all faces that the library made nothing of; how many they are. */
int occt_name_left_out_step(const Handle(Interface_InterfaceModel) & model,
                            const Handle(Transfer_TransientProcess) & process,
                            const occt_faults &faults, const occt_sink &sink);

/* The same for IGES, whose curves are worth having too: first the shapes, faces and curves that are a part of no other, each
 * with what is broken in it. */
struct iges_shape {
    Handle(IGESData_IGESEntity) entity;
    std::string fault; /* empty: nothing */
};
std::vector<iges_shape> occt_iges_shapes(const Handle(Interface_InterfaceModel) & model,
                                         const occt_sink &sink);
void occt_take_broken(const std::vector<iges_shape> &shapes);
int occt_name_left_out_iges(const Handle(Interface_InterfaceModel) & model,
                            const Handle(Transfer_TransientProcess) & process,
                            const std::vector<iges_shape> &shapes, const occt_sink &sink);

/* A plane within one circle, or between two about one centre, as a surface; null where the face is no such one. */
Handle(Geom_BSplineSurface)
    occt_disc(const TopoDS_Face &face, const Handle(Geom_Surface) & surface);

/* A plane within four straight lines that turn one way, as a bilinear surface; null where the face is no such one. */
Handle(Geom_BSplineSurface)
    occt_quad(const TopoDS_Face &face, const Handle(Geom_Surface) & surface);

/* A cylinder, cone, sphere, torus or surface of revolution over a range of its parameters, in arcs of a quarter turn at most;
 * null for surfaces of another kind. */
Handle(Geom_BSplineSurface)
    occt_round(const Handle(Geom_Surface) & surface, const double lo[2], const double hi[2]);

/* A surface with the numbers of its item; weights are there always. */
struct occt_surface {
    taut_cad_item item;
    std::string name;
    std::vector<double> knots[2], points, weights;
    bool is_rational;
};

/* Passes surfaces on in their order; of taut's `own` file those that it cut as one (join.cpp). */
class occt_joiner
{
  public:
    occt_joiner(const occt_sink &to, bool own);
    void add(occt_surface surface);
    void end();

  private:
    void give();
    const occt_sink &sink;
    const bool is_own;
    std::vector<occt_surface> held;
};

/* Every face and every edge that bounds no face, as items, in the order of the shape; with `edges` faces that are trimmed as
 * their edges, after all else: "FACE.1", "FACE.2", ..., the outer ones first, around. */
void occt_give(const TopoDS_Shape &shape, const occt_names &names, bool edges,
               const occt_sink &sink);

#endif /* TAUT_CAD_OCCT_HPP */
