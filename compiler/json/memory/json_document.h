// A JSON document with memory that is checked (json_memory.h).
//
//   JsonDocument document;
//   document.Parse(text);
//   for (const JsonValue& each : document["plots"].GetArray()) ...
#pragma once

#include <rapidjson/document.h>

#include "compiler/json/memory/json_memory.h"

namespace patina {

using JsonDocument =
    rapidjson::GenericDocument<rapidjson::UTF8<>, rapidjson::MemoryPoolAllocator<JsonMemory>, JsonMemory>;
using JsonValue = JsonDocument::ValueType;

}  // namespace patina
