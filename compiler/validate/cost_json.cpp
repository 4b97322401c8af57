#include <rapidjson/prettywriter.h>
#include <rapidjson/stringbuffer.h>

#include "patina/cost.h"

namespace patina {
namespace {

class Json {
public:
    Json() {
        writer_.SetIndent(' ', 2);
        writer_.StartObject();
    }
    std::string take() {
        writer_.EndObject();
        return std::string(buffer_.GetString(), buffer_.GetSize());
    }

    void text(const char* key, std::string_view value) {
        writer_.Key(key);
        writer_.String(value.data(), rapidjson::SizeType(value.size()));
    }

    void passes(const char* key, const MaterialCost& cost) {
        writer_.Key(key);
        writer_.StartArray();
        for (const PassCost& pass : cost.passes) {
            writer_.StartObject();
            text("name", pass.name);
            stage("vertex", pass.vertex);
            stage("fragment", pass.fragment);
            number("textures", pass.textures);
            number("uniformBytes", pass.uniform_bytes);
            writer_.EndObject();
        }
        writer_.EndArray();
    }

private:
    void number(const char* key, std::uint32_t value) {
        writer_.Key(key);
        writer_.Uint(value);
    }

    void instructions(const char* key, const Instructions& cost) {
        if (cost == Instructions{}) return;
        writer_.Key(key);
        writer_.StartObject();
        number("all", cost.total());
        number("arithmetic", cost.arithmetic);
        number("transcendental", cost.transcendental);
        number("texture", cost.texture);
        number("derivative", cost.derivative);
        number("other", cost.other);
        writer_.EndObject();
    }

    void stage(const char* key, const StageCost& cost) {
        writer_.Key(key);
        writer_.StartObject();
        instructions("once", cost.once);
        instructions("perLight", cost.per_light);
        number("varyings", cost.varyings);
        number("registers", cost.registers);
        writer_.Key("nodes");
        writer_.StartArray();
        for (const NodeCost& node : cost.nodes) {
            writer_.StartObject();
            if (!node.node.empty()) text("node", node.node);
            if (!node.source.empty()) text("source", node.source);
            if (!node.file.empty()) text("file", node.file);
            if (node.line > 0) number("line", std::uint32_t(node.line));
            instructions("once", node.once);
            instructions("perLight", node.per_light);
            writer_.EndObject();
        }
        writer_.EndArray();
        writer_.EndObject();
    }

    rapidjson::StringBuffer buffer_;
    rapidjson::PrettyWriter<rapidjson::StringBuffer> writer_{buffer_};
};

}  // namespace

std::string to_json(const MaterialCost& cost, std::string_view graph) {
    Json json;
    json.text("graph", graph);
    json.passes("passes", cost);
    return json.take();
}

std::string with_cost(std::string reflection_json, const MaterialCost& cost) {
    Json json;
    json.passes("cost", cost);
    // Both are objects: the members of the second one follow those of the first.
    reflection_json.erase(reflection_json.rfind('}'));
    reflection_json.erase(reflection_json.find_last_not_of(" \n") + 1);
    return reflection_json + "," + json.take().substr(1) + "\n";
}

}  // namespace patina
