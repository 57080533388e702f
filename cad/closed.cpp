/* closed.cpp -- surfaces that close are read as they are. */
#include "occt.hpp"

#include <Geom_Surface.hxx>
#include <ShapeAlgo.hxx>
#include <ShapeAlgo_AlgoContainer.hxx>

/* OpenCASCADE's readers make a surface periodic whose opposite edges lie within 1e-7: that moves
 * points of thin ones, and rounds those of rational ones. */
class as_it_is : public ShapeAlgo_AlgoContainer
{
  public:
    Handle(Geom_Surface) ConvertToPeriodic(const Handle(Geom_Surface) &) const override
    {
        return nullptr; /* none: the reader goes on with what it has */
    }
};

void occt_keep_closed()
{
    ShapeAlgo::SetAlgoContainer(new as_it_is);
}
