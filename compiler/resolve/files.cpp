#include "compiler/resolve/files.h"

#include <exception>
#include <filesystem>
#include <new>

#include "compiler/base/disk.h"
#include "compiler/base/file_names.h"

namespace patina::graph {
namespace {

// The result of a function of the program's. If it throws, that is a result without a value.
template <class Call>
auto answer_of(std::string& why, const Call& call) -> decltype(call()) {
    decltype(call()) answer{};
    succeeds([&] { answer = call(); }, why, "the program's file system failed");
    return answer;
}

}  // namespace

bool succeeds(const std::function<void()>& call, std::string& why, std::string_view unknown) {
    try {
        call();
        return true;
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::exception& exception) {
        why = exception.what();
    } catch (...) {
        why = unknown;
    }
    return false;
}

Files::Path Files::resolve(const std::string& from, const std::string& name) {
    Path made;
    if (system_.resolve)
        made.path = answer_of(made.why, [&] { return system_.resolve(from, name); });
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
        answer.text = answer_of(answer.why, [&] { return system_.read(path); });
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
        answer.exists = answer_of(answer.why, [&] { return system_.exists(path); });
    else
        answer.exists = system_.read ? read(path).text.has_value() : is_on_disk(path);
    return answer;
}

void Files::give_part(const std::string& path, std::string text) {
    const Path found = resolve(path, "./" + path.substr(path.rfind('/') + 1));
    if (!found.path.empty()) answers_[found.path] = {.exists = true, .is_read = true, .text = std::move(text)};
}

}  // namespace patina::graph
