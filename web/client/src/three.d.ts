// three.js without its types, which would bring eight more packages.
declare module "three";
declare module "three/examples/jsm/*";
