#include "model_json.hpp"

#include <nlohmann/json.hpp>

namespace quadline {

namespace {

using Json = nlohmann::ordered_json;

Json json(Point p) { return Json::array({p.x, p.y}); }

Json json(const Circle& circle) {
  Json out{{"center", json(circle.center)}, {"radius", circle.radius}};
  if (circle.edges) out["edges"] = *circle.edges;
  if (circle.rings) out["rings"] = *circle.rings;
  if (circle.ring_width) out["ring_width"] = *circle.ring_width;
  return out;
}

Json json(const Path& path) {
  if (path.circle) return json(*path.circle);
  Json out = Json::array();
  for (const PathItem& item : path.items)
    out.push_back(item.via ? Json{{"to", json(item.to)}, {"via", json(*item.via)}} : json(item.to));
  return out;
}

template <class Named>
Json with_size(Json out, const Named& from) {
  if (from.size) out["size"] = *from.size;
  return out;
}

}  // namespace

std::string to_model_json(const Model& model) {
  Json out{{"name", model.name}, {"about", model.about}, {"size", model.size}};
  for (const Path& loop : model.outer) out["outer"].push_back(json(loop));
  for (const Path& hole : model.holes) out["holes"].push_back(json(hole));
  for (const Line& line : model.lines)
    out["lines"].push_back(with_size({{"name", line.name}, {"path", json(line.path)}}, line));
  for (const NamedPoint& point : model.points)
    out["points"].push_back(with_size({{"name", point.name}, {"at", json(point.at)}}, point));
  for (const Region& region : model.regions)
    out["regions"].push_back(with_size({{"name", region.name}, {"at", json(region.at)}}, region));
  return out.dump(1) + "\n";
}

}  // namespace quadline
