// The room `cli/watch` is `patina watch`: it compiles graphs again when they change, and shows the differences.
//
// Each round compiles the graphs with changed files, writes and prints the differences, and draws a picture if the user
// wants one. What is wrong is printed once. Failed work is tried again every second, because the reason may be a full
// disk, or a missing file that may appear anywhere.
//
//   Watch watch(console, compiler, arguments, inputs);
//   while (watch.look() != Exit::Machine) std::this_thread::sleep_for(200ms);
#pragma once

#include <chrono>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "compiler/cli/compile/compiled.h"
#include "compiler/cli/watch/changes.h"
#include "compiler/cli/watch/stamps.h"
#include "runtime/render/render_request.h"

namespace patina::cli {

struct WatchArguments {
    CompileArguments compile;
    std::string picture;  // --render; empty: none
    std::vector<std::string> set;
    runtime::RenderRequest request;
};

class Watch {
public:
    // `inputs`: as find_inputs() finds them at the beginning; folders are searched again at each look.
    Watch(const Console& console, const Compiler& compiler, const WatchArguments& arguments, Inputs inputs);

    // Does what is to do now. Machine: there is no device to draw with.
    Exit look();

private:
    using Clock = std::chrono::steady_clock;

    // Something that is made from files, and made again when one of them changes.
    struct Task {
        Stamps stamps{};
        Clock::time_point tried{};
        bool is_new = true, ok = false;
        std::string said{};      // the messages of the last time
        std::string obstacle{};  // why its files could not be written

        bool is_changed() const;
        bool is_due() const;  // also if its files could not be written
        // What has just been made. Returns true if the messages are not those of the last time.
        bool done(bool is_ok, Stamps read, std::string messages);
    };
    struct Graph {
        Input input{};
        Task task{};
        std::optional<Compiled> compiled{};  // the last result without errors
    };
    struct Made {
        Compiled compiled{};
        Stamps stamps{};
    };

    void find_graphs();
    void choose_subject(const std::vector<Input>& changed);
    Made make(const Input& input, bool counts_costs) const;
    Exit finish(const Input& input, Made& made, bool shows_changes);
    Exit draw();
    OutputFiles page_files(bool ok);
    bool write(Task& task, const std::string& source, const OutputFiles& files, const std::vector<std::string>& inputs);
    void tell(const std::string& subject, const std::string& line);

    const Console& console_;
    const Compiler& compiler_;
    const WatchArguments& arguments_;
    Inputs inputs_;
    std::vector<std::string> found_{};       // the paths of the last look
    std::map<std::string, Graph> graphs_{};  // by path
    bool is_first_ = true;

    std::string subject_{};  // what the picture shows
    Task picture_{};
    std::string text_{};  // messages about the subject, for the page
    std::int64_t page_version_ = 0;
    runtime::RenderMachine machine_{};
};

}  // namespace patina::cli
