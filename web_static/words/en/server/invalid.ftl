### What is wrong with one field of a form, a file or a request, and what to do: the end of a sentence that begins with
### its place ("What was sent, points[3].x: ...").

# $where: a file or a form, such as "What was sent". $problem: one of the texts below.
invalid-in = { $where }: { $problem }
# $place: the name of a field, such as channels[3].name.
invalid-at = { $where }, { $place }: { $problem }
invalid-more =
    { $count ->
        [one] { $sentence } ({ $count } more problem in it)
       *[other] { $sentence } ({ $count } more problems in it)
    }

invalid-missing = this is missing, add it
invalid-unknown-field = this is not known here, leave it out
# $problem: what the reader of the file says, in English.
invalid-not-json = this is not JSON, correct it ({ $problem })
# $field: the name of a field that says of which kind an object is; $kinds: names that it may have.
invalid-kind = { $field } must be one of { $kinds }, choose one of these
invalid-kind-missing = { $field } is missing, add it
invalid-too-many = there may be at most { $most }, but there are { $count }, remove some
invalid-too-few = there must be at least { $least }, but there are { $count }, add some

## $value: what was given, in quotes.

invalid-greater-than = this must be greater than { $limit }, but it is { $value }: correct it
invalid-greater-than-equal = this must be at least { $limit }, but it is { $value }: correct it
invalid-less-than = this must be less than { $limit }, but it is { $value }: correct it
invalid-less-than-equal = this must be at most { $limit }, but it is { $value }: correct it
invalid-finite-number = this must be a finite number, but it is { $value }: correct it
invalid-number = this must be a number, but it is { $value }: correct it
invalid-whole-number = this must be a whole number, but it is { $value }: correct it
invalid-truth = this must be true or false, but it is { $value }: correct it
invalid-text = this must be a text, but it is { $value }: correct it
invalid-text-longer =
    { $limit ->
        [one] this must have at least { $limit } character, but it is { $value }: correct it
       *[other] this must have at least { $limit } characters, but it is { $value }: correct it
    }
invalid-text-shorter =
    { $limit ->
        [one] this must have at most { $limit } character, but it is { $value }: correct it
       *[other] this must have at most { $limit } characters, but it is { $value }: correct it
    }
invalid-list = this must be a list, but it is { $value }: correct it
invalid-object = this must be an object with fields, but it is { $value }: correct it
# $choices: the values that are allowed.
invalid-choice = this must be one of { $choices }, but it is { $value }: correct it
invalid-date = this must be a date, but it is { $value }: correct it
invalid-nothing = this must be empty, but it is { $value }: correct it
# $problem: what the library that reads the value says, in English.
invalid-other = { $problem }, but it is { $value }: correct it
# $place: the number of the character in the text; $code: such as U+200B; $name: its name in Unicode, English.
invalid-invisible = character { $place } is { $code } ({ $name }), which nobody sees: leave it out
