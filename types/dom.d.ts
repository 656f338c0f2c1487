/** What web_static/js/widgets/dom.js takes. */

/** A child of an element; null, undefined and false leave it out. */
export type Child = Node | string | number | null | undefined | false | Child[];

type Listeners = { [E in keyof HTMLElementEventMap as `on${E}`]?: ((event: HTMLElementEventMap[E]) => unknown) | null };

/** Attributes and listeners of an element; `true` sets an empty attribute; false, null and undefined leave it out. */
export interface Attributes extends Listeners {
  [name: string]: string | number | boolean | null | undefined | ((event: never) => unknown);
}
