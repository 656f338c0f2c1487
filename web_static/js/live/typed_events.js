/** The browser's EventTarget for classes whose events the type checker knows by name: it runs as EventTarget does. */

/**
 * @template Events the event of each name, such as {open: Event, tick: CustomEvent<Message>}
 * @typedef {{
 *   addEventListener: <Name extends keyof Events>(
 *     name: Name, listener: (event: Events[Name]) => void, options?: AddEventListenerOptions,
 *   ) => void,
 *   dispatchEvent: (event: Event) => boolean,
 * }} EventSource
 */

export const TypedEvents = /** @type {new <Events>() => EventSource<Events>} */ (EventTarget);
