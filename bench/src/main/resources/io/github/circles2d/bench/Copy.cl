// Copies a buffer. Index space: one work-item for every float4. Cost: 16 bytes read and 16 written.
__kernel void copy(__global const float4 *source, __global float4 *target, uint elements) {
    const uint i = (uint)get_global_id(0);
    if (i < elements) {
        target[i] = source[i];
    }
}
