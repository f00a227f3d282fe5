// Moves the particles "x y z" of its input to the surface: `particles FIELD.nfd < points`. The answers go into the records
// of the particles. A line of output for each: distance and gradient, and the position after the move.
#include <nearfield.h>

#include <cstdio>
#include <fstream>
#include <iostream>
#include <iterator>
#include <vector>

struct Particle {
    NearfieldVector position;
    float distance;
    NearfieldVector gradient;
    std::uint8_t kind;
};

int main(int count, char **arguments) {
    if (count != 2 || nearfield_abi_version() != NEARFIELD_ABI_VERSION) {
        std::cerr << "usage: particles FIELD.nfd < points\n";
        return 2;
    }
    std::ifstream file(arguments[1], std::ios::binary);
    const std::vector<char> bytes{std::istreambuf_iterator<char>(file), {}};

    NearfieldField field = NEARFIELD_FIELD_NONE;
    const NearfieldResult result = nearfield_open(&field, bytes.data(), bytes.size());
    if (result != NEARFIELD_RESULT_OK) {
        std::cerr << arguments[1] << ": " << nearfield_result_text(result) << '\n';
        return 1;
    }

    std::vector<Particle> particles;
    for (Particle particle{}; std::cin >> particle.position.x >> particle.position.y >> particle.position.z;) {
        particles.push_back(particle);
    }
    if (particles.empty()) return 0;
    const std::size_t stride = sizeof(Particle);
    Particle &first = particles.front();
    const std::size_t answered = nearfield_distances_and_gradients(&field, &first.position.x, stride, &first.distance, stride,
                                                                   &first.gradient.x, stride, particles.size());

    NearfieldCursor cursor;
    nearfield_cursor(&field, &cursor);
    for (std::size_t index = 0; index < answered; ++index) {
        const Particle &particle = particles[index];
        const NearfieldVector moved = {particle.position.x - particle.distance * particle.gradient.x,
                                       particle.position.y - particle.distance * particle.gradient.y,
                                       particle.position.z - particle.distance * particle.gradient.z};
        std::printf("%.9g %.9g %.9g %.9g %.9g\n", particle.distance, particle.gradient.x, particle.gradient.y,
                    particle.gradient.z, nearfield_cursor_distance(&cursor, moved));
    }
    return 0;
}
