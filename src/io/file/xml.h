/* xml.h -- text in XML 1.0. */
#ifndef TAUT_IO_FILE_XML_H
#define TAUT_IO_FILE_XML_H

#include "io/file/sink.h"

/* A text between quotes or tags: & < > " as their names, control characters as _, what is no UTF-8 or no character of XML as U+FFFD. */
void taut_xml_text(taut_sink *sink, const char *text);

#endif /* TAUT_IO_FILE_XML_H */
