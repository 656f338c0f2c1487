/** The modules with the messages of a language, which the server makes from web_static/words/ (app/api/pages.py). */
declare module "*.ftl.js" {
  const messages: string;
  export default messages;
}
