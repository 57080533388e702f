/* fake_cad.h -- a test as its own taut-cad: one that answers, and ones that do not as they should.
 *
 * The test's main begins with fake_cad_play(); after fake_cad_as(role) what libtaut starts is the test's own program,
 * which plays that role and is gone. */
#ifndef TAUT_TEST_FAKE_CAD_H
#define TAUT_TEST_FAKE_CAD_H

#include "io/cad/wire.h"

/* Plays the role of this process, if it has one, and does not return then. */
void fake_cad_play(void);

/* From now on taut-cad is `role`; NULL: the one that is there.
 *
 *     "reader"    a face and an edge, in inches                    "writer"    the text "an IGES file\n"
 *     "silent"    ends at once                                     "no-load"   so, as where its libraries are missing
 *     "stranger"  says something else                              "echo"      repeats the request
 *     "endless"   something else, and never ends                   "hang"      says who it is and waits for ever
 *     "mute"      says nothing and waits for ever
 *     "deaf"      closes its answer and waits for ever             "half"      ends in the middle of an item
 *     "word-less" says who it is and ends                          "signal N"  likewise, of signal N
 *     "version"   is one version ahead                             "layout"    lays numbers out otherwise
 *     "nonsense"  ends with a status that is none                  "host"      fails where it has anything of the host's
 *                                                                              but a request, an answer, and no signal blocked
 */
void fake_cad_as(const char *role);

/* What "reader" says there is. */
extern const taut_cad_item fake_cad_items[2];

#endif /* TAUT_TEST_FAKE_CAD_H */
