#include "compiler/importers/values.h"

namespace patina::importers {

GraphValue value_of(const json::Json& json) {
    switch (json.kind) {
        case json::Json::Kind::Bool: return json.boolean;
        case json::Json::Kind::Number: return static_cast<float>(json.number);
        case json::Json::Kind::String: return json.string;
        case json::Json::Kind::Array: {
            std::vector<GraphValue> items;
            for (const json::Json& each : json.elements) items.push_back(value_of(each));
            return GraphValue::list(std::move(items));
        }
        case json::Json::Kind::Object: {
            GraphMembers members;
            for (const json::JsonMember& each : json.members) members.push_back({each.key, value_of(each.value)});
            return GraphValue::object(std::move(members));
        }
        case json::Json::Kind::Null: break;
    }
    return 0;
}

}  // namespace patina::importers
