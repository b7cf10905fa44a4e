#include "geometry/io/read_3mf.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "geometry/base/tests/expect_error.hpp"
#include "geometry/io/tests/zip_bytes.hpp"

namespace isopatch::geometry {
namespace {

const std::string relations = R"(<?xml version="1.0" encoding="UTF-8"?>
<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships">
<Relationship Target="/3D/part.model" Id="r0" Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/>
</Relationships>)";

const std::string corner_mesh = R"(<mesh><vertices><vertex x="0" y="0" z="0"/><vertex x="10.5" y="0" z="0"/>
<vertex x="0" y="20" z="0"/><vertex x="0" y="0" z="30"/></vertices><triangles><triangle v1="0" v2="2" v3="1"/>
<triangle v1="0" v2="1" v3="3"/><triangle v1="1" v2="2" v3="3"/><triangle v1="2" v2="0" v3="3"/></triangles></mesh>)";

std::string model(const std::string& resources, const std::string& build,
                  const std::string& attributes = "unit=\"millimeter\"") {
  return fmt::format(
      "<?xml version=\"1.0\"?>\n<model {} xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/"
      "2015/02\" xmlns:p=\"http://schemas.microsoft.com/3dmanufacturing/production/2015/06\">\n"
      "<resources>{}</resources>\n<build>{}</build>\n</model>",
      attributes, resources, build);
}

std::string object(int id, const std::string& content) {
  return fmt::format("<object id=\"{}\" type=\"model\">{}</object>", id, content);
}

MeasuredTriangles read(const std::string& text, std::map<std::string, std::string> more = {}) {
  more["_rels/.rels"] = relations;
  more["3D/part.model"] = text;
  return read_3mf(test::zip_bytes(more), "a.3mf");
}

const std::string corner = model(object(1, corner_mesh), "<item objectid=\"1\"/>");

TEST(Read3mf, TakesTrianglesAndTheirUnit) {
  const MeasuredTriangles found = read(corner);
  EXPECT_EQ(found.metres, 1e-3);
  EXPECT_EQ(found.mesh.vertices.cols(), 4);
  EXPECT_EQ(found.mesh.triangles.cols(), 4);
  EXPECT_DOUBLE_EQ(volume(found.mesh), 10.5 * 20 * 30 / 6);
  EXPECT_EQ(read(model(object(1, corner_mesh), "<item objectid=\"1\"/>", "unit=\"inch\"")).metres, 0.0254);
  EXPECT_EQ(read(model(object(1, corner_mesh), "<item objectid=\"1\"/>", "")).metres, 1e-3);
}

TEST(Read3mf, PlacesItemsAndComponents) {
  // Moved by (100, 0, 0) as an item; as a component it is turned by 90 degrees about z and moved by 5 along
  // x.
  const std::string turned =
      "<components><component objectid=\"1\" transform=\"0 1 0 -1 0 0 0 0 1 5 0 0\"/></components>";
  const MeasuredTriangles found =
      read(model(object(1, corner_mesh) + object(2, turned),
                 "<item objectid=\"2\" transform=\"1 0 0 0 1 0 0 0 1 100 0 0\"/>"));
  EXPECT_EQ(Eigen::Vector3d(found.mesh.vertices.col(1)), Eigen::Vector3d(105, 10.5, 0));
  EXPECT_EQ(Eigen::Vector3d(found.mesh.vertices.col(2)), Eigen::Vector3d(85, 0, 0));
}

TEST(Read3mf, KeepsMirrorImagesRightSideOut) {
  const MeasuredTriangles found =
      read(model(object(1, corner_mesh), "<item objectid=\"1\" transform=\"-1 0 0 0 1 0 0 0 1 0 0 0\"/>"));
  EXPECT_DOUBLE_EQ(volume(found.mesh), 10.5 * 20 * 30 / 6);
}

TEST(Read3mf, FindsObjectsInOtherParts) {
  const std::string elsewhere =
      "<components><component objectid=\"7\" p:path=\"/3D/Objects/o.model\"/></components>";
  const MeasuredTriangles found = read(model(object(1, elsewhere), "<item objectid=\"1\"/>"),
                                       {{"3D/Objects/o.model", model(object(7, corner_mesh), "")}});
  EXPECT_EQ(found.mesh.triangles.cols(), 4);
}

TEST(Read3mf, TakesAllObjectsWhereNothingIsListed) {
  const std::string support = "<object id=\"2\" type=\"support\">" + corner_mesh + "</object>";
  EXPECT_EQ(read(model(object(1, corner_mesh) + support, "")).mesh.triangles.cols(), 4);
}

TEST(Read3mf, SaysWhatIsWrong) {
  EXPECT_ERROR(read_3mf("no archive", "a.3mf"), ErrorCode::bad_format, "a.3mf: no ZIP archive");
  EXPECT_ERROR(read_3mf(test::zip_bytes({{"a", "b"}}), "a.3mf"), ErrorCode::bad_format, "_rels/.rels");
  const std::string item = "<item objectid=\"1\"/>";
  EXPECT_ERROR(read(model(object(1, ""), item)), ErrorCode::bad_format, "no triangles");
  EXPECT_ERROR(read(model(object(2, corner_mesh), item)), ErrorCode::bad_format, "no object with id '1'");
  EXPECT_ERROR(read(model(object(1, corner_mesh) + object(1, corner_mesh), item)), ErrorCode::bad_format,
               "second object");
  EXPECT_ERROR(read(model(object(1, corner_mesh), item, "unit=\"ell\"")), ErrorCode::bad_format, "ell");
  EXPECT_ERROR(read(model(object(1, "<components><component objectid=\"1\"/></components>"), item)),
               ErrorCode::bad_format, "component of itself");
  for (const char* transform : {"1 0", "1 0 0 0 1 0 0 0 1 0 0 0 7", "1 0 0 0 1 0 0 0 1 0 0 nan"})
    EXPECT_ERROR(read(model(object(1, corner_mesh),
                            fmt::format("<item objectid=\"1\" transform=\"{}\"/>", transform))),
                 ErrorCode::bad_format, "is no twelve numbers");
  EXPECT_ERROR(read("<svg/>"), ErrorCode::bad_format, "root element is not <model>");
  std::string text = corner;
  text.replace(text.find("10.5"), 4, "nan");
  EXPECT_ERROR(read(text), ErrorCode::bad_format, "x = \"nan\"");
  text = corner;
  text.replace(text.find("v3=\"1\""), 6, "v3=\"4\"");
  EXPECT_ERROR(read(text), ErrorCode::bad_format, "v3");
}

TEST(Read3mf, SaysWhatIsWrongWithThePackage) {
  const auto package = [](const std::string& relationships) {
    return test::zip_bytes({{"_rels/.rels", relationships}, {"3D/part.model", corner}});
  };
  EXPECT_ERROR(read_3mf(package("<Relationships/>"), "a.3mf"), ErrorCode::bad_format,
               "a.3mf: _rels/.rels:1: the package has no 3D model");
  std::string elsewhere = relations;
  elsewhere.replace(elsewhere.find("part.model"), 10, "lost.model");
  EXPECT_ERROR(read_3mf(package(elsewhere), "a.3mf"), ErrorCode::bad_format,
               "the package has no part '3D/lost.model'");

  // The marks of encryption, in the list of parts at the archive's end, and a byte of what was compressed.
  const std::string good = package(relations);
  const std::size_t listed = good.rfind("3D/part.model") - 46;
  ASSERT_EQ(good.substr(listed, 4), "PK\1\2");
  std::string encrypted = good;
  encrypted[listed + 8] = static_cast<char>(encrypted[listed + 8] | 1);
  EXPECT_ERROR(read_3mf(encrypted, "a.3mf"), ErrorCode::unsupported, "'3D/part.model' is encrypted");
  std::string damaged = good;
  damaged[good.find("3D/part.model") + 40] ^= 0x55;
  EXPECT_ERROR(read_3mf(damaged, "a.3mf"), ErrorCode::bad_format, "'3D/part.model' is damaged");
}

TEST(Read3mf, RefusesWhatGrowsWithoutEnd) {
  // Thirty objects of twice the one before would be a thousand million.
  std::string resources = object(1, corner_mesh);
  for (int id = 2; id <= 31; ++id)
    resources += object(id, fmt::format("<components><component objectid=\"{0}\"/><component "
                                        "objectid=\"{0}\"/></components>",
                                        id - 1));
  EXPECT_ERROR(read(model(resources, "<item objectid=\"31\"/>")), ErrorCode::unsupported, "100,000 objects");
  resources = object(1, corner_mesh);
  for (int id = 2; id <= 200; ++id)
    resources += object(id, fmt::format("<components><component objectid=\"{}\"/></components>", id - 1));
  EXPECT_ERROR(read(model(resources, "<item objectid=\"200\"/>")), ErrorCode::unsupported, "100 levels");
}

TEST(Read3mf, SurvivesDamage) {
  const std::string sound = test::zip_bytes({{"_rels/.rels", relations}, {"3D/part.model", corner}});
  for (std::size_t i = 0; i < sound.size(); ++i) {
    std::string damaged = sound;
    damaged[i] = static_cast<char>(damaged[i] ^ 0x55);
    for (const std::string& bytes : {damaged, sound.substr(0, i)}) try {
        EXPECT_EQ(read_3mf(bytes, "a.3mf").mesh.triangles.cols(), 4);  // a byte that says nothing
      } catch (const Error&) {
      }
  }
}

}  // namespace
}  // namespace isopatch::geometry
