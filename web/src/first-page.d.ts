declare module "virtual:first-page" {
  const page: import("./core").Catalogue;
  export default page;
}
