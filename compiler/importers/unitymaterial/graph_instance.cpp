#include "compiler/importers/unitymaterial/graph_instance.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>

#include "compiler/base/disk/disk.h"
#include "compiler/base/letters.h"
#include "compiler/importers/unitymaterial/chosen_state.h"
#include "compiler/importers/values.h"
#include "compiler/json/json.h"

namespace patina::importers::unitymaterial {
namespace {

namespace fs = std::filesystem;
using json::Json;

std::string_view word(const Json& object, std::string_view key) {
    const Json* value = object.find(key);
    return value ? std::string_view(value->string) : std::string_view();
}

// The value of a property as a scene sets it; no value: it is the graph's default.
class Values {
public:
    explicit Values(MaterialMaker& maker) : maker_(maker) {}

    GraphMembers members{};  // of "set"

    void read(const Json& property) {
        const std::string name(word(property, "name")), type(word(property, "type"));
        const Json* otherwise = property.find("default");
        if (type == "bool") flag_value(name, property, otherwise);
        if (type == "enum") choice(name, property, otherwise);
        if (type == "float" || type == "int") {
            if (maker_.source().numbers.contains(name)) add(name, number_of(name), otherwise);
        }
        if (type == "color") color_value(name, property, otherwise);
        if (type == "float2" || type == "float3" || type == "float4") {
            if (!maker_.source().colors.contains(name)) return;
            const std::array<double, 4> all = maker_.color(name, {});
            std::vector<float> some(all.begin(), all.begin() + (type.back() - '0'));
            add(name, list_of(some), otherwise);
        }
        if (type.starts_with("texture")) texture(name, property);
    }

private:
    GraphValue number_of(const std::string& name) const { return static_cast<float>(maker_.number(name, 0)); }

    void add(const std::string& name, const GraphValue& value, const Json* otherwise) {
        if (otherwise && value_of(*otherwise) == value) {
            maker_.taken(name, "the default of the graph");
            return;
        }
        members.push_back({name, value});
        maker_.taken(name, fmt::format("the value of '{}' in the scene", name));
    }

    bool is_on(const std::string& keyword) const {
        const std::vector<SavedKeyword>& on = maker_.source().keywords;
        return std::ranges::find(on, keyword, &SavedKeyword::name) != on.end();
    }

    void flag_value(const std::string& name, const Json& property, const Json* otherwise) {
        const std::string_view bound = word(property, "as");
        const bool is_keyword = bound == "variant" || bound == "specialization" || is_on(name);
        if (!is_keyword && !maker_.source().numbers.contains(name)) return;
        const bool value = is_keyword ? is_on(name) : maker_.number(name, 0) != 0;
        add(name, value, otherwise);
        maker_.note_keyword(name, Remark::Kind::Taken, fmt::format("the value of '{}'", name));
    }

    // The keyword of an entry is the property's name with the entry's behind it, in capitals.
    void choice(const std::string& name, const Json& property, const Json* otherwise) {
        const Json* values = property.find("values");
        if (!values || values->elements.empty()) return;
        std::string chosen = values->elements.front().string;
        for (const Json& each : values->elements) {
            const std::string keyword = small_letters(name + "_" + each.string);
            for (const SavedKeyword& on : maker_.source().keywords) {
                if (small_letters(on.name) != keyword) continue;
                chosen = each.string;
                maker_.note_keyword(on.name, Remark::Kind::Taken, fmt::format("the value of '{}'", name));
            }
        }
        add(name, chosen, otherwise);
    }

    void color_value(const std::string& name, const Json& property, const Json* otherwise) {
        if (!maker_.source().colors.contains(name)) return;
        const Json* range = property.find("range");
        const bool is_hdr = range && range->elements.size() == 2 && range->elements[1].number > 1;
        add(name, shown_color(maker_.color(name, {}), is_hdr), otherwise);
    }

    void texture(const std::string& name, const Json& property) {
        const auto saved = maker_.source().textures.find(name);
        if (saved == maker_.source().textures.end()) return;
        if (!maker_.has_picture(name)) {
            maker_.taken(name, "none: the default of the graph");
        } else {
            const Picture& picture = maker_.picture(name);
            std::string difference = picture.missing;
            if (!picture.file.empty()) members.push_back({name, picture.file});
            for (const std::string& each : picture.differences) difference += (difference.empty() ? "" : "; ") + each;
            if (!picture.more.empty())
                difference += (difference.empty() ? "" : "; ") + std::string("the graph's sampler counts");
            const std::string what =
                picture.file.empty() ? "the default of the graph" : fmt::format("the value of '{}' in the scene", name);
            maker_.note(name, difference.empty() ? Remark::Kind::Taken : Remark::Kind::Changed,
                        difference.empty() ? what : what + ": " + difference);
        }
        const Json* tiling = property.find("tiling");
        if (!saved->second.is_moved() || !tiling || !tiling->boolean) return;
        const SavedTexture& moved = saved->second;
        // Unity counts v from the bottom of the picture.
        const double down = 1 - moved.scale[1] - moved.offset[1];
        const std::vector<float> four = {static_cast<float>(moved.scale[0]), static_cast<float>(moved.scale[1]),
                                         static_cast<float>(moved.offset[0]), static_cast<float>(down)};
        members.push_back({name + "_ST", list_of(four)});
    }

    MaterialMaker& maker_;
};

std::string scene_of(const std::string& name, const std::string& graph, const GraphMembers& values) {
    const std::string own = terms::identifier(name), word = own.empty() ? "material" : own;
    GraphMembers material = {{"name", word}, {"graph", graph}};
    if (!values.empty()) material.push_back({"set", GraphValue::object(values)});
    return write_scene(
        {{"name", name},
         {"camera", GraphValue::object({{"position", GraphValue::list({0, 0, 5})}})},
         {"lights", default_lights()},
         {"materials", GraphValue::list({GraphValue::object(std::move(material))})},
         {"objects",
          GraphValue::list({GraphValue::object({{"id", "ball"}, {"mesh", "sphere"}, {"material", word}})})}});
}

// The text of the graph that the output folder has already.
std::optional<std::string> text_in(const std::string& folder, const std::string& name) {
    return read_disk((fs::path(folder.empty() ? "." : folder) / name).string(), kMostTextBytes).bytes;
}

}  // namespace

Imported make_instance(MaterialMaker& maker, const std::string& name, const Options& options) {
    const std::string& path = maker.shader().graph;
    const Source source{.path = path, .start = {}};
    const Importer* importer = importer_of(source);
    if (!importer) return {.error = fmt::format("nothing reads '{}'", path)};
    Imported made = importer->read(source, options);
    if (!made.error.empty()) return made;
    const std::string file = fs::path(path).filename().string();
    for (Remark& each : made.remarks)
        if (each.file.empty()) each.file = file;
    if (made.graphs.empty()) return {.error = fmt::format("{}: there is no graph in it", path)};
    std::string graph_name = made.graphs.back().name;
    std::string graph_text = made.graphs.back().text;
    if (const auto there = text_in(options.folder, graph_name)) {
        graph_text = *there;
        made = {};
        made.remarks.push_back(
            {.part = file, .text = fmt::format("'{}', which the output folder has already", graph_name)});
    }
    SourceMap sources;
    Diagnostics diagnostics;
    const std::uint32_t begin = sources.add(graph_name, graph_text);
    const std::unique_ptr<Json> root = json::parse_json(sources, begin, diagnostics);
    if (!root) return {.error = fmt::format("'{}' in the output folder is not a graph", graph_name)};
    Values values(maker);
    if (const Json* properties = root->find("properties"))
        for (const Json& each : properties->elements) values.read(each);
    if (std::optional<std::string> changed = with_chosen_state(maker, *root, begin, graph_text)) {
        // The graph belongs to other materials, too.
        std::string own_name = name + ".graph.json";
        if (own_name == graph_name) own_name = name + "-of-the-material.graph.json";
        graph_name = std::move(own_name);
        made.graphs.push_back({.name = graph_name, .text = std::move(*changed)});
    }
    if (const Setting* queue = maker.source().setting("m_CustomRenderQueue")) {
        static constexpr std::string_view kUsual[] = {"-1", "2000", "2450", "3000"};
        const bool is_usual = std::ranges::find(kUsual, queue->text) != std::end(kUsual);
        maker.note_setting(queue->key, is_usual ? Remark::Kind::Taken : Remark::Kind::Changed,
                           "the queue is that of the graph");
    }
    std::string scene = scene_of(name, graph_name, values.members);
    if (scene.empty()) return {.error = fmt::format("{}: a name in it is not UTF-8", maker.source().path)};
    made.scene = name + ".scene.json";
    made.graphs.push_back({.name = made.scene, .text = std::move(scene)});
    return made;
}

}  // namespace patina::importers::unitymaterial
