export { default } from "./sliding_cone";
