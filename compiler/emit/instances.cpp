#include "compiler/emit/instances.h"

namespace patina::emit {

const Instance* Instances::find(const InstanceKey& key) {
    const auto found = made_.find(key);
    if (found == made_.end()) return nullptr;
    if (found->second.is_passing) note_passing_answer();
    return &found->second;
}

std::vector<InstanceInfo> Instances::of(const FunctionDecl& function) const {
    std::vector<InstanceInfo> made;
    for (const auto& [key, instance] : made_) {
        if (key.function == &function && instance.id) made.push_back({.id = instance.id, .half = key.half});
    }
    return made;
}

void Instances::forget_passing() {
    std::erase_if(made_, [](const auto& entry) { return entry.second.is_passing; });
}

}  // namespace patina::emit
