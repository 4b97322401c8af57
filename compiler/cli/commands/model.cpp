// patina models: a list of the library's lighting models. patina model NAME: the manual page of one.
#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "compiler/cli/commands/commands.h"
#include "compiler/cli/pages/library_json.h"
#include "compiler/cli/pages/pages.h"

namespace patina::cli {
namespace {

struct Arguments {
    std::string name;
    bool json = false;
};

Exit list_models(const Console&, const Arguments& arguments) {
    const Compiler compiler;
    const std::vector<ModelInfo>& models = compiler.lighting_models();
    if (arguments.json) {
        print(to_json(compiler, models));
        return Exit::Ok;
    }
    std::size_t width = 0;
    for (const ModelInfo& model : models) width = std::max(width, model.name.size());
    for (const ModelInfo& model : models) {
        print(fmt::format("{:<{}}  {}\n", model.name, width, first_sentence(model.doc)));
    }
    return Exit::Ok;
}

Exit show_model(const Console& console, const Arguments& arguments) {
    const Compiler compiler;
    const std::vector<ModelInfo>& models = compiler.lighting_models();
    const auto model = std::ranges::find(models, arguments.name, &ModelInfo::name);
    if (model == models.end()) {
        std::vector<std::string> names;
        for (const ModelInfo& known : models) names.push_back(known.name);
        const std::string advice = suggestion(arguments.name, names);
        complain(console, Complaint::UnknownLighting,
                 {arguments.name, advice.empty() ? "'patina models' lists them" : advice});
        return Exit::Wrong;
    }
    print(arguments.json ? to_json(compiler, *model) : to_terminal(console, model_page(compiler, *model)));
    return Exit::Ok;
}

}  // namespace

void add_models(Program& program) {
    CLI::App& command = add_command(program, "models", {"patina models", "patina models --json"});
    auto arguments = std::make_shared<Arguments>();
    command.add_flag("--json", arguments->json, "Print everything about each model as JSON");
    set_work(program, command, [arguments](const Console& console) { return list_models(console, *arguments); });
}

void add_model(Program& program) {
    CLI::App& command = add_command(program, "model", {"patina model unity-brdf1", "patina model lambert --json"});
    auto arguments = std::make_shared<Arguments>();
    command.add_option("NAME", arguments->name, "Name of a lighting model, as in a material's \"lighting\"")
        ->required()
        ->type_name(" ");
    command.add_flag("--json", arguments->json, "Print it as JSON");
    set_work(program, command, [arguments](const Console& console) { return show_model(console, *arguments); });
}

}  // namespace patina::cli
