/** The entry for Node: the module is read from beside this file. */
import { readFile } from "node:fs/promises";
import { Field } from "./field.js";

export * from "./field.js";

let compiled: Promise<WebAssembly.Module> | undefined;

/**
 * Opens a field after copying and checking every byte of its file.
 *
 * The module is read with the first field, unless one is given.
 *
 * @throws FieldError when they are not a sound field.
 */
export async function open(bytes: Uint8Array, module?: WebAssembly.Module): Promise<Field> {
  return Field.open(bytes, module ?? (await (compiled ??= compile())));
}

/**
 * Opens the finest level of detail that is whole in the first bytes of a file, or the field itself once these are all its
 * bytes: what can be asked while the rest still arrives. Undefined while there is none yet.
 *
 * @throws FieldError when they cannot become a sound field.
 */
export async function openPrefix(bytes: Uint8Array): Promise<Field | undefined> {
  return Field.openPrefix(bytes, await (compiled ??= compile()));
}

async function compile(): Promise<WebAssembly.Module> {
  return WebAssembly.compile(await readFile(new URL("./nearfield.wasm", import.meta.url)));
}
