export { default } from "./gyroscope";
