/* xml.h -- pieces of an unstructured grid as VTK's XML, their arrays in base 64. */
#ifndef TAUT_IO_VTU_XML_H
#define TAUT_IO_VTU_XML_H

#include "io/file/sink.h"
#include "io/vtu/grid.h"

void vtu_xml_begin(taut_sink *sink, const char *unit);
void vtu_xml_piece(taut_sink *sink, const vtu_grid *grid, int part);
void vtu_xml_end(taut_sink *sink);

#endif /* TAUT_IO_VTU_XML_H */
