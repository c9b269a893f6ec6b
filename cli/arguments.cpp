#include "cli/arguments.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <functional>
#include <sstream>
#include <string>
#include <thread>

#include "cli/console.hpp"
#include "io/text/nearest_name.hpp"
#include "io/text/number_text.hpp"
#include "quadline/errors.hpp"
#include "quadline/version.hpp"

namespace quadline {

namespace {

/// An option with a number. The parser's own conversion depends on the locale, and takes "nan" and "0x1p3".
CLI::Option* add_number(CLI::App& app, const std::string& name, const std::string& help, const std::string& bounds,
                        const std::function<bool(double)>& set) {
  const auto read = [name, bounds, set](const std::string& text) {
    const auto value = parse_number<double>(text);
    if (!value || !std::isfinite(*value) || !set(*value))
      throw InputError(ErrorCode::InvalidOption, name + ": expected " + bounds + ", found '" + text + "'");
  };
  return app.add_option_function<std::string>(name, read, help)->type_name("NUMBER");
}

/// An option with a few words to choose from, two at least.
template <class Choice>
CLI::Option* add_choice(CLI::App& app, const std::string& name, const std::string& help, Choice& choice,
                        const std::vector<std::pair<std::string, Choice>>& words) {
  std::string type = words[0].first, expected = "'" + words[0].first + "'";
  for (std::size_t i = 1; i < words.size(); ++i) {
    type += "|" + words[i].first;
    expected += (i + 1 < words.size() ? ", '" : " or '") + words[i].first + "'";
  }
  const auto read = [name, &choice, words, expected](const std::string& text) {
    for (const auto& [word, meaning] : words)
      if (word == text) return void(choice = meaning);
    throw InputError(ErrorCode::InvalidOption, name + ": expected " + expected + ", found '" + text + "'");
  };
  return app.add_option_function<std::string>(name, read, help)->type_name(type);
}

void add_model(CLI::App& app, std::filesystem::path& model) {
  app.add_option("MODEL", model, "the model: .json (model v1) or .poly (Triangle)")->required()->type_name("");
}

void add_mesh_file(CLI::App& app, std::filesystem::path& mesh) {
  app.add_option("MESH", mesh, "the mesh: .vtu, .vtk, .msh (2.2 or 4.1), .inp or .json")->required()->type_name("");
}

void add_size(CLI::App& app, Options& options) {
  add_number(app, "--size", "target edge length, instead of the model's and of a .poly's areas", "a length above 0",
             [&options](double value) {
               options.size = value;
               return kLengthRange.contains(value);
             });
}

void add_tolerance(CLI::App& app, Options& options) {
  add_number(app, "--tolerance",
             "points nearer than this are one, and those within half of it of a curve lie on it; default 8e-7 of the "
             "model's diagonal, or 1e-3 of the least size where that is less",
             "a length above 0", [&options](double value) {
               options.tolerance = value;
               return kLengthRange.contains(value);
             });
}

void add_arrangement_options(CLI::App& app, Options& options) {
  add_size(app, options);
  add_tolerance(app, options);
  const auto set_growth = [&options](double value) {
    options.growth = value;
    return kGrowthRange.contains(value);
  };
  add_number(app, "--growth", "largest ratio of the sizes of neighbouring edges; default 1.3", kGrowthRange.text(),
             set_growth);
  const auto set_per_circle = [&options](double value) {
    options.edges_per_circle = value;
    return kEdgesPerCircleRange.contains(value);
  };
  add_number(
      app, "--edges-per-circle",
      "at least so many edges on a full turn of a curve; on circles small beside the sizes down to half; default 16",
      kEdgesPerCircleRange.text(), set_per_circle);
}

// For CLI11: the complaint, empty where there is none.
std::string refuse_empty(const std::string& text) { return text.empty() ? "expected a name, found nothing" : ""; }

void add_criteria(CLI::App& app, const std::string& does, std::string& criteria) {
  app.add_option("--criteria", criteria, does + ": csr-fine, hypermesh-10mm, growth, or a JSON file")
      ->check(refuse_empty)
      ->type_name("NAME");
}

CLI::App* add_mesh(CLI::App& app, MeshArguments& arguments) {
  CLI::App* mesh = app.add_subcommand("mesh", "Mesh a model with quadrilaterals");
  add_model(*mesh, arguments.model);
  mesh->add_option("-o,--output", arguments.outputs,
                   "a file to write: .vtu, .msh, .inp, .svg or .json, or FORMAT:FILE as in msh:/dev/stdout; may be "
                   "given several times")
      ->allow_extra_args(false)
      ->type_name("FILE");
  add_arrangement_options(*mesh, arguments.options);
  add_choice<LineFronts>(*mesh, "--lines", "where the front on a line constraint starts; default two-sided",
                         arguments.options.lines,
                         {{"one-sided", LineFronts::OneSided}, {"two-sided", LineFronts::TwoSided}});
  add_choice<Triangles>(*mesh, "--triangles",
                        "who makes the triangles that are merged; default both: the better in each cell",
                        arguments.options.triangles,
                        {{"delaunay", Triangles::Delaunay}, {"front", Triangles::Front}, {"both", Triangles::Both}});
  add_choice<Method>(
      *mesh, "--method", "how cells are meshed; default layout: grids where they suit, Q-Morph elsewhere",
      arguments.options.method,
      {{"layout", Method::Layout}, {"qmorph", Method::QMorph}, {"merge", Method::Merge}, {"split", Method::Split}});
  const auto set_threads = [&arguments](double value) {
    if (!(value >= 1 && value <= 1024) || value != std::floor(value)) return false;
    arguments.threads = static_cast<unsigned>(value);
    return true;
  };
  add_number(*mesh, "--threads", "default: all cores; the mesh does not depend on it", "a whole number from 1 to 1024",
             set_threads);
  const auto set_max_quads = [&arguments](double value) {
    arguments.options.max_quads = value;
    return kMaxQuadsRange.contains(value);
  };
  add_number(*mesh, "--max-quads", "refuse models that are expected to need more; default 5e7", kMaxQuadsRange.text(),
             set_max_quads);
  mesh->add_option("--stages", arguments.stages, "write a .svg and a .vtu after every stage into this folder")
      ->check(refuse_empty)
      ->type_name("DIR");
  mesh->add_option("--report", arguments.report, "write counts, quality, seconds and memory into this JSON file")
      ->check(refuse_empty)
      ->type_name("FILE");
  add_criteria(*mesh, "move nodes where quads are beyond limits, count those that stay so, and name the worst",
               arguments.criteria);
  mesh->add_flag("--json", arguments.json, "print the report instead of the table");
  mesh->add_flag("--quiet", arguments.quiet, "print nothing but errors and what of the model was dropped");
  mesh->add_flag("--keep-bad", arguments.keep_bad, "write the mesh even if it breaks the promise; exits with 3 still");
  return mesh;
}

CLI::App* add_check(CLI::App& app, CheckArguments& arguments) {
  CLI::App* check = app.add_subcommand("check", "Validity and quality of a mesh; exits with 3 where it is not valid");
  add_mesh_file(*check, arguments.mesh);
  check->add_option("--model", arguments.model, "check too that the mesh keeps what this model asks for")
      ->type_name("MODEL");
  check->add_flag("--all-quad", arguments.all_quad, "triangles make the mesh invalid");
  add_tolerance(*check, arguments.options);
  add_criteria(*check, "count the quads beyond limits, and name the worst", arguments.criteria);
  check->add_flag("--json", arguments.json, "print JSON instead of the table");
  return check;
}

CLI::App* add_info(CLI::App& app, InfoArguments& arguments) {
  CLI::App* info = app.add_subcommand("info", "What a model holds, what was repaired, what is wrong and where");
  add_model(*info, arguments.model);
  add_size(*info, arguments.options);
  add_tolerance(*info, arguments.options);
  info->add_flag("--json", arguments.json, "print JSON instead of the table");
  return info;
}

CLI::App* add_draw(CLI::App& app, DrawArguments& arguments) {
  CLI::App* draw = app.add_subcommand("draw", "A picture of a mesh, coloured by quality, line constraints bold");
  add_mesh_file(*draw, arguments.mesh);
  draw->add_option("-o,--output", arguments.output, "the picture: .svg")->required()->type_name("FILE");
  return draw;
}

[[noreturn]] void refuse_word(const std::string& kind, const std::string& word, const std::string& dashes,
                              const std::vector<std::string>& known, const std::string& help) {
  const std::string nearest = nearest_name(word, known);
  throw InputError(ErrorCode::InvalidOption,
                   "unknown " + kind + " '" + dashes + word +
                       "': " + (nearest.empty() ? "see '" + help + "'" : "did you mean '" + dashes + nearest + "'?"));
}

/// @throws InputError  a command or a long option is none that there is: names the one that was probably meant.
void refuse_unknown_words(const CLI::App& app, int argc, const char* const* argv) {
  const std::vector<const CLI::App*> commands = app.get_subcommands(nullptr);
  std::vector<std::string> known;
  for (const CLI::App* command : commands) known.push_back(command->get_name());
  const std::string first = argc > 1 ? argv[1] : "";
  const auto chosen = std::find(known.begin(), known.end(), first);
  if (chosen == known.end()) {
    if (!first.empty() && first[0] != '-') refuse_word("command", first, "", known, "quadline --help");
    return;
  }
  const CLI::App* command = commands[static_cast<std::size_t>(chosen - known.begin())];
  known.clear();
  for (const CLI::Option* option : command->get_options(nullptr))
    known.insert(known.end(), option->get_lnames().begin(), option->get_lnames().end());
  for (int i = 2; i < argc; ++i) {
    const std::string word = argv[i];
    if (!word.starts_with("--") || word == "--") continue;
    const std::string name = word.substr(2, word.find('=') - 2);
    if (std::find(known.begin(), known.end(), name) == known.end())
      refuse_word("option", name, "--", known, "quadline " + first + " --help");
  }
}

}  // namespace

std::optional<Arguments> parse_arguments(int argc, const char* const* argv) {
  CLI::App app("Quadline: all-quadrilateral meshes of plane domains, with element edges along every line constraint",
               "quadline");
  app.set_version_flag("--version", std::string("quadline ") + kVersion);
  MeshArguments mesh;
  CheckArguments check;
  InfoArguments info;
  DrawArguments draw;
  mesh.threads = std::max(1u, std::thread::hardware_concurrency());
  const CLI::App* mesh_command = add_mesh(app, mesh);
  const CLI::App* check_command = add_check(app, check);
  const CLI::App* info_command = add_info(app, info);
  add_draw(app, draw);
  app.require_subcommand(0, 1);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& asked) {  // for help or the version
    std::ostringstream text;
    app.exit(asked, text, text);
    print(text.str());
    return std::nullopt;
  } catch (const CLI::ParseError& error) {
    refuse_unknown_words(app, argc, argv);
    const std::vector<CLI::App*> chosen = app.get_subcommands();
    const std::string command = chosen.empty() ? "" : " " + chosen.front()->get_name();
    throw InputError(ErrorCode::InvalidOption, std::string(error.what()) + ": see 'quadline" + command + " --help'");
  }
  if (app.get_subcommands().empty())
    throw InputError(ErrorCode::InvalidOption, "expected a command: mesh, check, info or draw: see 'quadline --help'");
  const CLI::App* chosen = app.get_subcommands().front();
  if (chosen == mesh_command) return mesh;
  if (chosen == check_command) return check;
  if (chosen == info_command) return info;
  return draw;
}

}  // namespace quadline
