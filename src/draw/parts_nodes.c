/* parts_nodes.c -- the nodes of a net: a point each, and its name where there is room.
 *
 *     of each node: the name beside its point, right above first, at the first of four corners that lies on the
 *     surface and away from all names before it; where there is none, the point alone
 */
#include "draw/label.h"
#include "draw/parts.h"
#include "taut/record.h"

#include <string.h>

/* Of points and of the way from them to their names, in page units. */
static const double radius = 2.6, beside = 6;

static void add_name(const double at[3], const char *name, taut_scene *scene)
{
    static const taut_ink ink = {60, 60, 60}, paper = {255, 255, 255};
    taut_tag tag = {.ink = ink, .paper = paper};

    taut_label_clean(name, sizeof tag.text / 4, tag.text, sizeof tag.text);
    const double size[2] = {taut_label_width(tag.text, scene->tag_size) + 4,
                            1.12 * scene->tag_size};
    for (int corner = 0; corner < 4; corner++) {
        const double x = at[0] + (corner % 2 == 0 ? 1 : -1) * (beside + size[0] / 2);
        const double y = at[1] + (corner < 2 ? -1 : 1) * (beside + size[1] / 2);
        const double place[3] = {x, y, at[2]};
        if (taut_scene_has_room(scene, place, size, 1.1 * size[0])) {
            tag.xy[0] = x;
            tag.xy[1] = y;
            taut_scene_tag(scene, &tag);
            return;
        }
    }
}

taut_status taut_parts_nodes(const taut_model *model, const taut_camera *camera, taut_scene *scene)
{
    static const taut_ink ink = {60, 60, 60}, rim = {255, 255, 255};
    const taut_record *details = taut_model_details(model);
    const taut_record *nodes = taut_record_get(details, "nodes");
    const int is_net = taut_record_get(details, "trace") != NULL;

    for (size_t k = 0; is_net && k < taut_record_count(nodes) && k < TAUT_PARTS_NODES; k++) {
        const taut_record *node = taut_record_at(nodes, k), *at = taut_record_get(node, "point");
        double point[3], page[3];
        for (size_t c = 0; c < 3; c++) {
            point[c] = taut_record_number(taut_record_at(at, c));
        }
        taut_camera_project(camera, point, page);
        taut_scene_disc(scene, page, ink, rim, radius);
        if (!taut_scene_hides(scene, page, 3)) {
            add_name(page, taut_record_text(taut_record_get(node, "node")), scene);
        }
    }
    return scene->status;
}
