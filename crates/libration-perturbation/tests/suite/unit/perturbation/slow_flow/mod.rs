mod half_swing;
