/* A robot's firmware in C: it opens the field in its flash, checks it, and asks how far it may move. Built for the host it is
 * the same program. */
#include <nearfield.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

extern const uint8_t field_start[], field_end[];
__asm__(".section .rodata\n"
        ".global field_start\n.global field_end\n"
        "field_start: .incbin \"fields/octree.nfd\"\n"
        "field_end:\n"
        ".text\n");

/* A hash of the bits of the answers along a line through the box. */
static uint32_t checksum(const NearfieldField *field) {
    const NearfieldInfo info = nearfield_info(field);
    const NearfieldVector size = {info.box_max.x - info.box_min.x, info.box_max.y - info.box_min.y,
                                  info.box_max.z - info.box_min.z};
    uint32_t hash = 0x811c9dc5u;
    for (int step = 0; step < 64; ++step) {
        const float share = (float)step * (1.0f / 64.0f);
        const NearfieldVector point = {info.box_min.x + share * size.x, info.box_min.y + share * size.y,
                                       info.box_min.z + share * size.z};
        const NearfieldSample sample = nearfield_distance_and_gradient(field, point);
        uint32_t bits[4];
        memcpy(bits, &sample, sizeof bits);
        for (int part = 0; part < 4; ++part) hash = (hash ^ bits[part]) * 0x01000193u;
    }
    return hash;
}

int main(void) {
    static NearfieldField field; /* not on a small stack */
    const NearfieldVector hand = {0.4f, 0.1f, -0.2f};
    NearfieldResult result = nearfield_open(&field, field_start, (size_t)(field_end - field_start));
    if (result == NEARFIELD_RESULT_OK) result = nearfield_validate(&field);
    if (result != NEARFIELD_RESULT_OK) {
        puts(nearfield_result_text(result));
        return 1;
    }
    printf("the hand may move by %ld micrometres\n", (long)(nearfield_clearance(&field, hand) * 1e6f));
    printf("octree %08lx\n", (unsigned long)checksum(&field));
    return 0;
}
