/** A catalogue of messages: values, numbers, plurals, ids of which a part comes from elsewhere. */
import assert from "node:assert/strict";

const [folder] = process.argv.slice(2);
const { catalogue } = await import(`${folder}/words.js`);

const { t, textWith, hasText } = catalogue(`
plain = Plain
value = { $a }, { $b }
trials =
    { $count ->
        [one] { $count } trial
       *[other] { $count } trials
    }
ends = It ends in { $left } s.
end-by-hand = by hand
control-u1-plus = forwards
control-u1-minus = back
row-cross-talk = cross talk
another-clinic-s-id = id
broken = { $a
`);

assert.equal(t("plain"), "Plain");
assert.equal(t("value", { a: "{ $b } <b>", b: 12345.678 }), "{ $b } <b>, 12345.678");
assert.equal(t("value", { a: 0.1 + 0.2, b: -0 }), "0.30000000000000004, 0");
assert.equal(t("value", { a: NaN, b: Infinity }), "NaN, Infinity");
assert.equal(t("value", { a: null, b: undefined }), ", ");
assert.equal(t("value", { a: 1 }), "1, ");
assert.deepEqual(
  [0, 1, 2, 1.5, 1000].map((count) => t("trials", { count })),
  ["0 trials", "1 trial", "2 trials", "1.5 trials", "1000 trials"],
);
assert.deepEqual(textWith("ends", "left", 0.5), ["It ends in ", 0.5, " s."]);
for (const [id, text] of [
  [`end-${"by hand"}`, "by hand"],
  [`control-${"u1+"}`, "forwards"],
  [`control-${"u1-"}`, "back"],
  [`row-${"cross_talk"}`, "cross talk"],
  ["another clinic's id", "id"],
]) {
  assert.equal(t(id), text);
  assert.ok(hasText(id));
}
for (const id of ["none", "end-by", "broken"]) {
  assert.equal(t(id), id);
  assert.ok(!hasText(id));
}
console.log("messages hold");
