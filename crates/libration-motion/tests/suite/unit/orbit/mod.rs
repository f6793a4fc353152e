mod precise;
