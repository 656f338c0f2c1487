/** What the calls of web_static/js/api.js take and answer, by method and by the path as a page writes it. */
import type { paths } from "./api";

export type Method = "get" | "post" | "put" | "delete";

/** The paths of the API that know a method, without the prefix: "/trials/{trial_id}". */
type Route<M extends Method> = {
  [R in keyof paths]: paths[R] extends Record<M, object> ? (R extends `/api/v1${infer Short}` ? Short : never) : never;
}[keyof paths];

type WithoutQuery<P extends string> = P extends `${infer Path}?${string}` ? Path : P;

type Parts<P extends string> = P extends `${infer First}/${infer Rest}` ? [First, ...Parts<Rest>] : [P];

type Fits<Written extends string[], Declared extends string[]> = Declared extends [
  infer D extends string,
  ...infer Ds extends string[],
]
  ? Written extends [infer W extends string, ...infer Ws extends string[]]
    ? W extends (D extends `{${string}}` ? string : D)
      ? Fits<Ws, Ds>
      : false
    : false
  : Written extends []
    ? true
    : false;

/** The route that a written path means: "/trials/{trial_id}" for `/trials/${id}`; never when there is none. */
type RouteOf<M extends Method, P extends string, R = Route<M>> = R extends string
  ? Fits<Parts<WithoutQuery<P>>, Parts<R>> extends true
    ? R
    : never
  : never;

type Operation<M extends Method, P extends string> = `/api/v1${RouteOf<M, P>}` extends infer R extends keyof paths
  ? paths[R][M]
  : never;

/** A path that the API knows: anything else is an error where it is written. */
export type Known<M extends Method, P extends string> = [RouteOf<M, P>] extends [never] ? never : P;

type Json<Content> = Content extends { content: { "application/json": infer Value } } ? Value : null;

type Success<Responses> = Json<Responses[keyof Responses]>;

/** What a successful call answers; null when it answers nothing. */
export type Answer<M extends Method, P extends string> =
  Operation<M, P> extends { responses: infer Responses } ? Success<Responses> : never;

/** What a call sends; unknown where the API reads the body itself, as of floor plans. */
export type Body<M extends Method, P extends string> =
  Operation<M, P> extends { requestBody: { content: { "application/json": infer Value } } } ? Value : unknown;
