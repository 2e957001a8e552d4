// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Saved entries of the history in the browser's IndexedDB: the entries, and their files, which are read when they are
// needed. A browser without storage (private windows, frames of other sites) throws at the first call.

const name = "mahlwerk";
const stores = ["entries", "files"];

const done = (request) => new Promise((resolve, reject) => {
  request.onsuccess = () => resolve(request.result);
  request.onerror = () => reject(request.error);
});

function opened() {
  const request = indexedDB.open(name, 1);
  request.onupgradeneeded = () => stores.forEach((each) => request.result.createObjectStore(each, { keyPath: "id" }));
  return done(request);
}

export class Storage {
  async transaction(mode) {
    this.base ??= opened();
    return (await this.base).transaction(stores, mode);
  }

  async entries() {
    return done((await this.transaction("readonly")).objectStore("entries").getAll());
  }

  /// The files of an entry: name -> text; null if it has none.
  async files(id) {
    return (await done((await this.transaction("readonly")).objectStore("files").get(id)))?.files ?? null;
  }

  /// `files`: undefined leaves those that are stored.
  async put(entry, files) {
    const transaction = await this.transaction("readwrite");
    transaction.objectStore("entries").put(entry);
    if (files) transaction.objectStore("files").put({ id: entry.id, files });
    return this.completed(transaction);
  }

  async remove(id) {
    const transaction = await this.transaction("readwrite");
    stores.forEach((each) => transaction.objectStore(each).delete(id));
    return this.completed(transaction);
  }

  completed(transaction) {
    return new Promise((resolve, reject) => {
      transaction.oncomplete = resolve;
      transaction.onabort = transaction.onerror = () => reject(transaction.error);
    });
  }
}
