// 3MF through lib3mf 1.8's C interface.
#include <Model/COM/NMR_DLLInterfaces.h>

#include <algorithm>
#include <type_traits>

#include "fieldfab/core/error.h"
#include "mesh_file.h"

namespace fieldfab {
namespace {

/// A lib3mf object, released when it goes out of scope.
template <class Object>
class Handle {
 public:
  Handle() = default;
  ~Handle() {
    if (object_ != nullptr) NMR::lib3mf_release(object_);
  }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  Object** out() { return &object_; }
  Object* get() const { return object_; }

 private:
  Object* object_ = nullptr;
};

class ThreeMf {
 public:
  ThreeMf(const std::filesystem::path& path, ErrorKind kind, const char* message) : path_(path), kind_(kind), message_(message) {}
  void must(LIB3MFRESULT result) const {
    if (result != 0) throw Error(kind_, path_.string(), message_);
  }

 private:
  const std::filesystem::path& path_;
  ErrorKind kind_;
  const char* message_;
};

}  // namespace

void write_3mf(const TriangleMesh& mesh, const std::filesystem::path& path) {
  const ThreeMf file(path, ErrorKind::io, "cannot write as 3MF");
  Handle<NMR::PLib3MFModel> model;
  Handle<NMR::PLib3MFModelMeshObject> object;
  Handle<NMR::PLib3MFModelBuildItem> item;
  Handle<NMR::PLib3MFModelWriter> writer;
  std::vector<NMR::MODELMESHVERTEX> vertices(mesh.vertices.size());
  for (std::size_t i = 0; i < vertices.size(); ++i)
    std::copy(mesh.vertices[i].begin(), mesh.vertices[i].end(), vertices[i].m_fPosition);
  std::vector<NMR::MODELMESHTRIANGLE> triangles(mesh.triangles.size());
  for (std::size_t i = 0; i < triangles.size(); ++i)
    std::copy(mesh.triangles[i].begin(), mesh.triangles[i].end(), triangles[i].m_nIndices);
  file.must(NMR::lib3mf_createmodel(model.out()));
  file.must(NMR::lib3mf_model_setunit(model.get(), NMR::MODELUNIT_MILLIMETER));
  file.must(NMR::lib3mf_model_addmeshobject(model.get(), object.out()));
  file.must(NMR::lib3mf_meshobject_setgeometry(object.get(), vertices.data(), static_cast<DWORD>(vertices.size()),
                                               triangles.data(), static_cast<DWORD>(triangles.size())));
  file.must(NMR::lib3mf_model_addbuilditem(model.get(), object.get(), nullptr, item.out()));
  file.must(NMR::lib3mf_model_querywriter(model.get(), "3mf", writer.out()));
  file.must(NMR::lib3mf_writer_writetofileutf8(writer.get(), path.c_str()));
}

TriangleMesh read_3mf(const std::filesystem::path& path) {
  const ThreeMf file(path, ErrorKind::bad_input, "is not a 3MF file that can be read");
  Handle<NMR::PLib3MFModel> model;
  Handle<NMR::PLib3MFModelReader> reader;
  Handle<NMR::PLib3MFModelResourceIterator> objects;
  file.must(NMR::lib3mf_createmodel(model.out()));
  file.must(NMR::lib3mf_model_queryreader(model.get(), "3mf", reader.out()));
  file.must(NMR::lib3mf_reader_readfromfileutf8(reader.get(), path.c_str()));
  file.must(NMR::lib3mf_model_getmeshobjects(model.get(), objects.out()));
  TriangleMesh mesh;
  for (BOOL more = 0;;) {
    file.must(NMR::lib3mf_resourceiterator_movenext(objects.get(), &more));
    if (more == 0) return mesh;
    Handle<NMR::PLib3MFModelResource> object;
    file.must(NMR::lib3mf_resourceiterator_getcurrent(objects.get(), object.out()));
    DWORD vertex_count = 0, triangle_count = 0;
    file.must(NMR::lib3mf_meshobject_getvertexcount(object.get(), &vertex_count));
    file.must(NMR::lib3mf_meshobject_gettrianglecount(object.get(), &triangle_count));
    std::vector<NMR::MODELMESHVERTEX> vertices(vertex_count);
    std::vector<NMR::MODELMESHTRIANGLE> triangles(triangle_count);
    if (vertex_count == 0 || triangle_count == 0) continue;
    file.must(NMR::lib3mf_meshobject_getvertices(object.get(), vertices.data(), vertex_count, nullptr));
    file.must(NMR::lib3mf_meshobject_gettriangleindices(object.get(), triangles.data(), triangle_count, nullptr));
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (const auto& p : vertices) mesh.vertices.push_back({p.m_fPosition[0], p.m_fPosition[1], p.m_fPosition[2]});
    for (const auto& t : triangles)
      mesh.triangles.push_back({first + t.m_nIndices[0], first + t.m_nIndices[1], first + t.m_nIndices[2]});
  }
}

}  // namespace fieldfab
