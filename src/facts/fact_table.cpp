#include "facts/fact_groups.h"

#include "stages/matrices.h"

namespace rasterwalk {

Value z_ndc(const Facts& facts, float z) {
    const Frame& frame = facts.results().a.frame;
    if (frame.scene->space == SceneSpace::pixels) return {};
    return number(
        ndc_depth(static_cast<double>(z), vertex_rules(frame.settings, frame.scene->space)));
}

std::span<const Fact> fact_table() {
    static const std::vector<Fact> table = [] {
        std::vector<Fact> facts;
        add_cursor_facts(facts);
        add_test_facts(facts);
        add_session_facts(facts);
        add_side_facts(facts);
        add_frame_facts(facts);
        add_model_facts(facts);
        add_pixel_facts(facts);
        add_light_facts(facts);
        add_shadow_facts(facts);
        add_clip_facts(facts);
        add_outline_facts(facts);
        add_shared_edge_facts(facts);
        add_table_facts(facts);
        add_vertex_facts(facts);
        add_compare_facts(facts);
        return facts;
    }();
    return table;
}

} // namespace rasterwalk
