/*
 * Computes what the doctor checks a device by: out[i] = sqrt(in[i]) / (i + 1) - in[i] * 0.1, in single precision, each
 * operation rounded on its own.
 * Index space: one work-item an element, rounded up to whole work-groups. Cost a work-item: O(1).
 */
#pragma OPENCL FP_CONTRACT OFF

kernel void device_check(global const float *in, global float *out, int n) {
    size_t i = get_global_id(0);
    if (i >= (size_t) n) {
        return;
    }
    float quotient = sqrt(in[i]) / (float) (i + 1);
    float product = in[i] * 0.1f;
    out[i] = quotient - product;
}
