// A constant outside a cbuffer.

float loose;
