// The messages between the page and Python.

/** @import { Picture, Point } from "./pen.js" */
/** @import { Row } from "./table.js" */
/** @import { Shape } from "./shapes.js" */
/**
 * What the reader has made of a scene.
 * @typedef {object} Pose
 * @property {Shape} a
 * @property {Shape} b
 * @property {string | null} view "shortcut" or "truth"; null for a scene without a shortcut.
 * @property {string} scene The scene that the pose is of, as JSON.
 * @property {string | null} goal The challenge.
 * @property {number | null} pinned The row of the axis that is shown.
 * @property {number | null} degree The direction of a free axis.
 * @property {boolean} mtv Is the MTV shown?
 * @property {boolean} difference Is the difference B − A shown?
 */
/** @typedef {{ goal: string, met: boolean, task: string, status: string, hint: string }} Goal */
/**
 * Everything that an explorer shows.
 * @typedef {object} State
 * @property {Picture} picture
 * @property {Shape} a
 * @property {Shape} b
 * @property {string[]} names
 * @property {string} sentence
 * @property {string} enough How many axes are enough.
 * @property {Row[]} rows
 * @property {number | null} lit
 * @property {string} json
 * @property {string | null} view
 * @property {string} link
 * @property {string} scene
 * @property {Goal} [goal]
 * @property {Picture} [difference]
 * @property {string[]} [heading]
 * @property {string} [map]
 * @property {Picture} [line] Both ranges of the shown test on a line with ticks.
 * @property {Picture} [dial] All directions of the free axis, with those that have a gap.
 * @property {string} relation
 * @property {string} [snapped] What became of snapping to where the shapes touch.
 * @property {Picture} [curve]
 * @property {Point} [knob] The handle of the free axis.
 */
/** @typedef {{ name: string, label: string, said: string, excerpt: string, refused: string }} PastedShape */
/** @typedef {{ choice: string, meaning: string, gives: string }} PastedAnswer */
/** @typedef {{ what: string, asks: string, answers: PastedAnswer[], matters: boolean }} PastedQuestion */
/** @typedef {{ kind: string, text: string, help: string }} PastedFinding */
/** @typedef {{ definition: string, answer: string, why: string }} PastedView */
/** @typedef {{ a: string, b: string, relation: string, others: PastedView[] }} PastedPair */
/**
 * What Python says of a pasted text; `why` alone where nothing could be read.
 * @typedef {object} Pasted
 * @property {string} [why]
 * @property {string} [sentence]
 * @property {boolean} [open] Whether a question must be answered first.
 * @property {PastedShape[]} [shapes]
 * @property {PastedQuestion[]} [questions]
 * @property {PastedFinding[]} [findings]
 * @property {PastedPair[]} [pairs]
 * @property {Pasted} [without] The answer without what was not understood, where only that is asked.
 * @property {number} [pair] The pair that the explorer shows.
 * @property {string} [note] What the picture calls the shapes of the pair.
 * @property {Picture} [refused] An outline that crosses itself.
 * @property {string} [wkt]
 * @property {string} [json]
 * @property {string} [scene]
 * @property {string} [link]
 * @property {Picture | null} [picture] The pair, to be saved.
 * @property {Record<string, string>} [tests] Minimal tests, by language.
 */
/** @typedef {{ kind: "pasted", n?: undefined, pasted: Pasted }} PastedMessage A text without a pair to show. */
/** @typedef {{ kind: "state", n?: number | null, pasted?: Pasted } & State} StateMessage `n` is the number of the pose that it answers. */
/** @typedef {{ kind: "refused", n?: number | null, why: string }} RefusedMessage */
/** @typedef {{ kind: "file", name: string, mime: string }} FileMessage Its content is in the buffers. */
/** @typedef {StateMessage | RefusedMessage | FileMessage | PastedMessage} Message */
/** @typedef {(content: Message, buffers: BlobPart[]) => void} Listener */
/**
 * What a widget needs of its model: that of anywidget, or the site's own.
 * @typedef {object} WidgetModel
 * @property {(name: string) => any} get
 * @property {(event: "msg:custom", listener: Listener) => void} on
 * @property {(event: "msg:custom", listener: Listener) => void} off
 * @property {(content: Record<string, unknown>) => void} send
 */
