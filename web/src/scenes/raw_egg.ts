export { default } from "./rolling_body";
