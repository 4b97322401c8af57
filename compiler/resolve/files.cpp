#include "compiler/resolve/files.h"

#include <exception>
#include <filesystem>

#include "compiler/base/disk.h"
#include "compiler/base/file_names.h"

namespace patina::graph {
namespace {

// Calls a function of the caller's. If it throws, returns what its result is without a value.
template <class Call>
auto guarded(std::string& why, Call call) -> decltype(call()) {
    try {
        return call();
    } catch (const std::exception& exception) {
        why = exception.what();
    } catch (...) {
    }
    if (why.empty()) why = "the program's file system failed";
    return {};
}

}  // namespace

Files::Path Files::resolve(const std::string& from, const std::string& name) {
    Path made;
    if (system_.resolve)
        made.path = guarded(made.why, [&] { return system_.resolve(from, name); });
    else
        made.path = join_names(from, name);
    resolved_.push_back({.from = from, .name = name, .path = made});
    return made;
}

const Files::Answer& Files::read(const std::string& path) {
    Answer& answer = answers_[path];
    if (answer.is_read) return answer;
    answer.is_read = true;
    if (system_.read) {
        answer.text = guarded(answer.why, [&] { return system_.read(path); });
    } else {
        answer.text = read_from_disk(path, answer.why);
        std::error_code ignored;
        if (!answer.text && !std::filesystem::exists(path, ignored)) answer.why.clear();
    }
    if (answer.text) bytes_ += answer.text->size();
    return answer;
}

const Files::Answer& Files::find(const std::string& path) {
    Answer& answer = answers_[path];
    if (answer.exists) return answer;
    if (system_.exists)
        answer.exists = guarded(answer.why, [&] { return system_.exists(path); });
    else
        answer.exists = system_.read ? read(path).text.has_value() : is_on_disk(path);
    return answer;
}

void Files::give_part(const std::string& path, std::string text) {
    const Path found = resolve(path, "./" + path.substr(path.rfind('/') + 1));
    if (!found.path.empty()) answers_[found.path] = {.exists = true, .is_read = true, .text = std::move(text)};
}

}  // namespace patina::graph
