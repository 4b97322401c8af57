#include "compiler/api/keys/request_fields.h"

#include <algorithm>

#include "compiler/resolve/session.h"

namespace patina {
namespace {

void add_request(Fields& fields, const CompileOptions& options) {
    fields.add(std::to_string(options.request.index()));
    const resolve::Request request(options);
    fields.add(request.path).add(request.passes).add(request.functions.value_or("")).add(request.preview.value_or(""));
}

}  // namespace

void add_options(Fields& fields, const CompileOptions& options) {
    for (auto target = options.targets.begin(); target != options.targets.end(); ++target) {
        if (std::find(options.targets.begin(), target, *target) == target)
            fields.add("target").add(target->engine).add(target->language);
    }
    add_request(fields, options);
    for (const auto& [name, value] : options.switches) fields.add("switch").add(name).add(value);
    fields.add_flag(options.keep_variants).add(options.lighting).add_flag(options.accept_parts);
    fields.add(options.include_dirs).add(options.dump).add_flag(options.keep_programs).add_flag(options.hashes);
}

}  // namespace patina
