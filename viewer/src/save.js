// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Saves pictures and videos as files.

const videoKinds = ["video/webm;codecs=vp9", "video/webm;codecs=vp8", "video/webm", "video/mp4"];
const framesPerSecond = 30;
const bitsPerSecond = 8e6;

const videoKind = () => videoKinds.find((kind) => MediaRecorder.isTypeSupported(kind));

/// The reason why this browser cannot save a video, or null.
export function videoFault(text) {
  if (typeof MediaRecorder === "undefined" || !HTMLCanvasElement.prototype.captureStream)
    return text.noRecorder;
  return videoKind() ? null : text.noVideoFormat;
}

function download(blob, name) {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(blob);
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 60e3);
}

/// A file name from a title: "a-planetary-mill-at-12-ms.png".
const fileName = (words, ending) =>
  `${words.toLowerCase().replace(/[^a-z0-9.]+/g, "-").replace(/^-|-$/g, "") || "replay"}.${ending}`;

export const savePicture = (canvas, words) =>
  canvas.toBlob((blob) => download(blob, fileName(words, "png")), "image/png");

/// Records a canvas until `stop` is called, then saves the video. Calls `failed` with the reason if
/// the recording fails.
export function film(canvas, words, text, failed) {
  const kind = videoKind();
  const stream = canvas.captureStream(framesPerSecond);
  const recorder = new MediaRecorder(stream, { mimeType: kind, videoBitsPerSecond: bitsPerSecond });
  const pieces = [];
  recorder.ondataavailable = ({ data }) => pieces.push(data);
  recorder.onerror = ({ error }) => failed(error?.message ?? text.recorderStopped);
  recorder.onstop = () => {
    stream.getTracks().forEach((track) => track.stop());
    const blob = new Blob(pieces, { type: kind });
    if (blob.size === 0) return failed(text.noFrames);
    download(blob, fileName(words, kind.startsWith("video/mp4") ? "mp4" : "webm"));
  };
  recorder.start(1000);
  return { stop: () => recorder.state !== "inactive" && recorder.stop() };
}
