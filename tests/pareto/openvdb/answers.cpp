// What OpenVDB's level sets and their NanoVDB forms answer at given points.
//
// answers FOLDER EDGE WIDTH: reads FOLDER/vertices (3 float each), FOLDER/triangles (3 uint32_t each) and FOLDER/points (3
// float each), all of the machine; makes a level set of voxels of that edge, valid as far as WIDTH from the surface, mesh
// units; for each form writes FOLDER/FORM (a float for each point) and prints "FORM BYTES NANOSECONDS".

#include <nanovdb/NanoVDB.h>
#include <nanovdb/util/OpenToNanoVDB.h>
#include <nanovdb/util/SampleFromVoxels.h>
#include <openvdb/io/Stream.h>
#include <openvdb/openvdb.h>
#include <openvdb/tools/Interpolation.h>
#include <openvdb/tools/MeshToVolume.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

template <class T>
static std::vector<T> read(const std::string& path) {
    std::ifstream file(path, std::ios::binary | std::ios::ate);
    std::vector<T> values(static_cast<size_t>(file.tellg()) / sizeof(T));
    file.seekg(0);
    file.read(reinterpret_cast<char*>(values.data()), static_cast<std::streamsize>(values.size() * sizeof(T)));
    if (!file) throw std::runtime_error("cannot read " + path);
    return values;
}

static double thread_seconds() {
    timespec time;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

struct Points {
    std::string folder;
    std::vector<openvdb::Vec3s> all;

    // The median of five passes, as the other fields are timed.
    template <class Field>
    void ask(const char* form, size_t bytes, Field field) const {
        std::vector<float> answers(all.size());
        std::vector<double> times;
        for (int pass = 0; pass < 5; ++pass) {
            const double start = thread_seconds();
            std::transform(all.begin(), all.end(), answers.begin(), field);
            times.push_back(thread_seconds() - start);
        }
        std::sort(times.begin(), times.end());
        std::ofstream file(folder + "/" + form, std::ios::binary);
        file.write(reinterpret_cast<const char*>(answers.data()), static_cast<std::streamsize>(4 * answers.size()));
        std::printf("%s %zu %.1f\n", form, bytes, 1e9 * times[2] / static_cast<double>(all.size()));
    }
};

template <class Build>
static void ask_nano(const char* form, const openvdb::FloatGrid& grid, const Points& points) {
    nanovdb::OpenToNanoVDB<float, Build> convert;
    const nanovdb::GridHandle<nanovdb::HostBuffer> handle = convert(grid);
    const auto* nano = handle.template grid<Build>();
    auto accessor = nano->getAccessor();
    auto sampler = nanovdb::createSampler<1>(accessor);
    points.ask(form, handle.size(), [&](const openvdb::Vec3s& point) {
        return sampler(nano->worldToIndexF(nanovdb::Vec3f(point[0], point[1], point[2])));
    });
}

int main(int, char** arguments) {
    const std::string folder = arguments[1];
    const double edge = std::atof(arguments[2]);
    const float width = static_cast<float>(std::atof(arguments[3]) / edge);
    openvdb::initialize();
    auto vertices = read<openvdb::Vec3s>(folder + "/vertices");
    const auto triangles = read<openvdb::Vec3I>(folder + "/triangles");
    Points points{folder, read<openvdb::Vec3s>(folder + "/points")};

    // The tables of the upper nodes count once where all voxels have positive coordinates.
    openvdb::Vec3s least = vertices[0];
    for (const auto& vertex : vertices) least = openvdb::math::minComponent(least, vertex);
    const openvdb::Vec3s shift = openvdb::Vec3s(static_cast<float>((width + 4) * edge)) - least;
    for (auto& point : points.all) point += shift;
    // Meshes are read by the coordinates of voxels.
    for (auto& vertex : vertices) vertex = (vertex + shift) / static_cast<float>(edge);

    // Not renormalized: that costs accuracy at creases.
    const auto transform = openvdb::math::Transform::createLinearTransform(edge);
    const openvdb::tools::QuadAndTriangleDataAdapter<openvdb::Vec3s, openvdb::Vec3I> mesh(vertices, triangles);
    const int flags = openvdb::tools::DISABLE_RENORMALIZATION | openvdb::tools::DISABLE_INTERSECTING_VOXEL_REMOVAL;
    const auto grid = openvdb::tools::meshToVolume<openvdb::FloatGrid>(mesh, *transform, width, width, flags);

    std::ostringstream stream(std::ios::binary);
    openvdb::io::Stream writer(stream);
    writer.setCompression(openvdb::io::COMPRESS_ACTIVE_MASK | openvdb::io::COMPRESS_ZIP);
    writer.write(openvdb::GridCPtrVec{grid});
    auto accessor = grid->getConstAccessor();
    const openvdb::tools::GridSampler<openvdb::FloatGrid::ConstAccessor, openvdb::tools::BoxSampler> sampler(
        accessor, grid->transform());
    points.ask("openvdb", stream.str().size(),
               [&](const openvdb::Vec3s& point) { return sampler.wsSample(openvdb::Vec3d(point)); });
    ask_nano<nanovdb::Fp8>("nanovdb-fp8", *grid, points);
    ask_nano<nanovdb::FpN>("nanovdb-fpn", *grid, points);
}
