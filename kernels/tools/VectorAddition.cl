/*
 * Adds two vectors: out[i] = a[i] + b[i] for 0 <= i < n.
 * Index space: one work-item an element, rounded up to whole work-groups. Cost a work-item: O(1).
 */
kernel void add_floats(global const float *a, global const float *b, global float *out, int n) {
    size_t i = get_global_id(0);
    if (i >= (size_t) n) {
        return;
    }
    out[i] = a[i] + b[i];
}
