mod roots;
