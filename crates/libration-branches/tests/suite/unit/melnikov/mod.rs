mod separatrix;
