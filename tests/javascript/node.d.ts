// What satviz/site/browser/memory.mjs uses of Node.

declare module "node:fs" {
  export function readFileSync(path: string | number): Uint8Array;
  export function readFileSync(path: string | number, encoding: "utf8"): string;
  export function writeFileSync(path: string, data: Uint8Array): void;
}
declare module "node:process" {
  export const argv: string[];
  export function exit(code: number): never;
}
declare module "node:url" {
  export function pathToFileURL(path: string): URL;
}
