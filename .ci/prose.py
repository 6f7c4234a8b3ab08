#!/usr/bin/env python3
"""Find stilted English in the prose of a Rust project.

    prose.py [options] PATH...

Reads the comments of `*.rs` files (`//`, `///`, `//!` and trailing `//`) and the prose of `*.md` files.
Code blocks, inline code, formulas, link targets, table headings and URLs are blanked first, so that only
English is searched. Patterns match whole sentences, also over several lines, and report the line
on which the hit starts.

Output, one line per hit:   file:line: pattern: text      then a table of counts (`--summary`: only the table).

    --summary          counts only
    --only A,B         only these patterns         --skip A,B      all patterns except these
    --level N          1: precision about 0.9, suitable for failing a build   2 (default): about 0.85, for review
                       3: also weak patterns (that of, may, hold ...), for manual review
    --strings          also the texts of #[error("...")] in *.rs files
    --names            also declarations (struct, enum, trait, type) of the coined names listed in NAMES
    --baseline FILE    fail only if a pattern has more hits than FILE states (written by --record FILE)
    --list             print the patterns and the recommended replacements

Needs only the standard library. Exit status: 0 without hits (or within the baseline), 1 with hits, 2 for wrong usage.
"""

import argparse
import json
import os
import re
import sys
from collections import Counter

# Name, level, regular expression, replacement. A pattern that starts with ^ matches only at the start of a
# sentence. Expressions are case-sensitive unless they start with (?i).
PATTERNS = []


def pattern(name, level, expression, advice):
    PATTERNS.append((name, level, re.compile(expression), advice))


# --- fragments, and sentences that do not start with their subject ---------------------------------------------------
pattern("what-subject", 1, r"^(What|Whatever|Whoever|Who)\b(?![^.?!]*\?)",
        "begin with a noun: 'What a solve has come to' -> 'Result of a solve'")
pattern("that-of-start", 1, r"^(That|Those)\s+(of|which|who|that|there|by|with|in|on|at|under|where|alone|between)\b",
        "repeat the noun: 'That of a cell' -> 'The value of a cell'")
pattern("of-start", 1, r"^Of\s+(?!course\b)\S+",
        "the item's doc is a fragment: name the thing ('Of the pressure' -> 'Sum of the pressure')")
pattern("the-same-start", 1, r"^The same\b(?!\s+(as\s+\[|value|number|order|sign|grid|unit)\b)",
        "say what it does; 'Like [`f`], but ...'")
pattern("with-fragment", 2, r"^(?!As CODE)(With|As|By|From|In|On|To|At|Under|Behind|Before|Beside|Around|Along|Into|Among|Over|Within)\s(?!(?:\S+\s)*(?:is|are|was|were|has|have|had|can|may|must|will|would|does|do|did|takes|gives|finds|needs|follows|moves|strain|strains|touches|converges|makes|holds|comes|becomes|stays|keeps|returns|falls|rises|grows|says|writes|reads|depends|carries|stick|sticks|slip|slips|spreads|displaces|costs|uses|yields|transforms|means|changes|begins|starts|ends|applies|contains|gets|puts|steps|runs|works|sees|leaves|sums|forms|counts|remembers|knows|refers|bounds|acts|waits|solves|defines|corresponds|reduces|names|decides|serves|covers|seems|solved|found|contact|nothing|they|it)\b)[^,;:.]*\.?$",
        "a fragment without a verb: 'Sets ...', 'Returns ...'")
pattern("so-many", 1, r"\b[Ss]o (many|few)\b(?!\s+(that|as)\b)(?!,)",
        "'n', 'this many', 'the given number of'")
pattern("inverted", 1, r"^(Nor|Never|Seldom|Nowhere)\s+(is|are|was|were|do|does|did|has|have|can|may|will)\b|[;,] nor (is|are|was|were|do|does|did|has|have|can|may|will)\b|^(Were|Had|Should)\s+(it|they|the|a|there|this|that)\b",
        "subject before verb; 'if' instead of inversion")
pattern("where-start", 3, r"^Where\b(?![^.?!]*\?)", "'If' or 'When' unless it is a place")
pattern("where-if", 3, r"(?<=[a-z,;)] )where (it|there|that|this|they|these|those|one|none|nothing|no|a|an|any|all|both|each|only|some|what)\b",
        "'if' or 'when' unless it is a place")

# --- free relatives and pronouns instead of nouns --------------------------------------------------------------------
pattern("prep-what", 1, r"\b(of|from|with|by|than|to|for|in|on|into|as|beside|beyond|behind|below|before|after|under|over|and|or|like|about|at|but|less|minus|times|against|between) what\b(?! (follows|if)\b)(?![^.?!]*\?)",
        "name the thing: 'what is left of the residual' -> 'the remaining residual'")
pattern("verb-what", 2, r"\b(is|are|was|says|gives|has|have|holds|takes|makes|finds|keeps|sets|does|adds|names|knows|leaves|returns|writes|puts|judges|shows|tells|see|sees) what\b(?! (if|to)\b)(?![^.?!]*\?)",
        "name the thing")
pattern("comma-what", 2, r"[,;:(] what\b(?! (if|about)\b)(?![^.?!]*\?)", "name the thing")
pattern("that-of-pair", 2, r"\b(that|those) of (that|those|it|this|what|one|all|them|both|each)\b|\b(that|those) (by|at|on|with|beside|where|there) (the|a|an|its|that|those|which|what|one|it)\b",
        "repeat the noun")
pattern("that-of", 3, r"\b(that|those) of\b", "repeat the noun, or use a possessive")
pattern("prep-who", 1, r"\b(to|by|of|with|for|from|than) (who|whoever)\b|\b(nobody|anyone|everybody|everyone|somebody|whoever)\b",
        "name the agent: caller, user, thread, rank")

# --- verbs that personify things -------------------------------------------------------------------------------------
pattern("tell", 1, r"\b(tells|told)\b|\b(may|can|will|would|could|must|not|which|that|to|and|cells|reports?|warnings?|they|columns|names|digits|numbers|bounds?) tell\b",
        "'shows', 'reports', 'determines', 'returns', 'is given'")
pattern("know", 1, r"\b(knows|knew)\b|\b(is|are|not|be|was) known (of|to|by|beside|with|at|beforehand|before|yet|in)\b|\bknow (nothing|no|of|how|which|what|their|its|theirs|the)\b",
        "'stores', 'has', 'contains', 'is available'")
pattern("ask", 1, r"\b(asks|asked)\b|\b(to|may|can|must|they|calls|who) ask\b",
        "'requested', 'required', 'calls', 'queries'")
pattern("say", 2, r"\b(says|said|says so)\b|\bsaying\b", "'states', 'reports', 'returns whether'")
pattern("see", 2, r"\b(sees to|sees every|sees the|sees that|seen by|is seen|are seen|was seen)\b(?! (in|from)\b)",
        "'receives', 'is notified of', 'handles'")
pattern("want", 2, r"\b(wants|wanted|for want of|want of)\b", "'needs', 'requires', 'for lack of'")
pattern("owe-bear", 2, r"\b(bears?|bore|borne)\b(?! in mind)|\bgives? way\b|\bgave way\b|\bmends?\b|\bmended\b|\bspoils?\b|\bspoilt\b|\bspoiled\b",
        "'has', 'carries', 'deforms', 'corrects', 'degrades'")
pattern("look", 1, r"\b(a|the|one|another|with|without|each|no|every|of) looks?\b|\blooks at\b|\blooked (at|for)\b|\blooks for\b|\blooks it up\b",
        "'check', 'check on the whole grid', 'examines', 'searches for'")
pattern("stand", 1, r"\b(stands?|stood|standing)\b(?! (for|out|alone|deviation|by the)\b)",
        "'is', 'remains', 'is written in', 'is at its bound'")
pattern("stand-for", 2, r"\b(stands?|stood|standing) for\b", "'represents', 'denotes', 'replaces'")
pattern("lie-so", 1, r"\b(lies?|lay|lying) (so|there|here|alike)\b(?! (close|near|far|many|few)\b)|\bhow (its|the|their|these|those)? ?\w+ (lie|lies)\b|\bwhere (it|they|he) (lies?|lay)\b",
        "'are laid out', 'are stored', 'layout'")
pattern("go-on", 1, r"\b(go|goes|going|gone|went) on\b(?! (to the|a )\b)", "'continues', 'proceeds', 'resumes'")
pattern("come-to", 1, r"\b(come|comes|came|coming) to\b(?! (rest|equilibrium)\b)|\bcomes? out\b|\bcame out\b",
        "'reaches', 'results in', 'amounts to', 'returns'")
pattern("anew", 1, r"\banew\b|\bbegins? again\b|\bbegan again\b", "'again', 'from scratch', 're-'")
pattern("begin", 3, r"\b(begin|begins|began|begun|beginning)\b", "'start', unless it is the beginning of a file")
pattern("worth", 1, r"\bworth\b(?! (noting|mentioning))", "say how much, or when to use it")
pattern("hold", 3, r"\b(holds?|held|holding)\b", "'stores', 'contains', 'is constrained', 'is valid', 'can carry'")
pattern("held-here", 1, r"\bheld (here|there|by this|on this|by ranks|of)\b", "'local' (cells, rows): 'the local rows'")
pattern("refuse", 3, r"\brefus(e|es|ed|al|als|ing)\b", "'rejects', 'returns an error'")
pattern("remark", 2, r"\bremark(s|ed|ing)?\b", "'warning'")
pattern("answer", 3, r"\banswers?\b", "'solution', 'result'")
pattern("serve", 2, r"\b(serves?|served)\b(?! as\b)", "'is used for', 'works for'")
pattern("give-up", 2, r"\b(gives?|gave|given) (up|back|away)\b", "'releases', 'frees', 'drops', 'returns'")
pattern("put-back", 2, r"\b(puts?|taken?|takes|took|brought|brings?|handed|hands?) (back|down|off|over|on|out|together|away)\b(?! (the|a) )",
        "'restored', 'removed', 'passed', 'projected', 'interpolated', 'assembled'")
pattern("deal-out", 1, r"\b(deals?|dealt|dealing)( \w+){0,4} out\b|\bdealt\b", "'distributes', 'partitioned'")
pattern("lend", 2, r"\b(lends?|lent|lending|borrows?|borrowed)\b(?=[^.]*\b(buffers?|memory|pieces?|gap|field|pools?|state)\b)",
        "'by reference', 'checked out of the pool'")

# --- dated words and set phrases --------------------------------------------------------------------------------------
pattern("archaic", 1, r"\b(henceforth|thence|whence|thereof|therein|whereof|wherein|hitherto|whilst|amidst|seldom|aught|naught|forthwith|thereupon|lest|for ever|to and fro|again and again|over and over|now and then|at the least|at the most|on the mean|some times over|by and by|all the same|as it were|right round|to no purpose)\b",
        "modern word: 'rarely', 'repeatedly', 'back and forth', 'on average', 'forever'")
pattern("beside", 1, r"\bbeside\b", "'next to', 'compared with', 'in addition to', 'outside', 'together with'")
pattern("but-for", 1, r"\bbut for\b|(?<![,;]) but (at|in|where|by|those|that of|once|with|under|what|few|one|its|a small|of|for|no)\b(?<!not but )|\b(nothing|none|all|anything|everything|no one|zero|uncoupled|certified there|the same) but\b(?! (also|not)\b)",
        "'except', 'only', 'apart from'")
pattern("is-no", 1, r"(?<!there )(?<!There )\b(is|are|was|were|be|being) no (?!longer|more|less|fewer|larger|smaller|greater|worse|better|need|guarantee|doubt|wider|narrower|stricter|looser|higher|lower|later|earlier|faster|slower|reason|such|\w+er than)\w+",
        "'is not a ...'")
pattern("no-number", 2, r"\b(no|not a|not) numbers?\b", "'NaN', 'not finite'")
pattern("another-than", 2, r"(?<!rather )(?<!cells )(?<!forms )\b(another|other|others) than\b|\banother one\b|\b(is|are|was) another\b(?! (\w+ )?(of|to|for|pointer)\b)|\bof another (grid|boundary|version|state|shape|length|number|kind|form|size|team|model|axis)\b|\bunder another\b",
        "'a different', 'differs from'")
pattern("less-minus", 1, r"\bless (the|that|those|this|these|its|their|twice|half|one|two|three|four|what)\b|\bless \d+ than\b",
        "'minus', 'the difference of'")
pattern("by-derivative", 1, r"\b(slopes?|derivatives?|stiffness(?:es)?|force|forces|loads?|moments?|response|changes?)\b[^.,;:]{0,40}\bby (the |a |its |their )?(approach|shifts?|twist|motions?|creepages?|spin|displacements?|pressures?|loads?|forces?|unit|parameters?)\b",
        "'with respect to': the derivative of the force with respect to the approach")
pattern("from-on", 1, r"\b[Ff]rom (\S+ ){1,6}?(on|onwards?|up)\b(?=[ ,.;:)]|$)(?! (the|a|an|its|their|which|one|two|all|each|any|grids?|cells?|\d|MATH|CODE)\b)",
        "'from 64 cells', 'for 64 cells or more'")
pattern("as-it-was", 1, r"\bas (it|they|he|this|that|these|all) (is|are|was|were|stands?|lies?|goes|go)\b|\bas (it|they) (had|has|have) (been|it|them)\b|\bis then as\b|\bare then as\b",
        "'unchanged', 'in its previous state'")
pattern("in-place-of", 2, r"\bin (the )?place of\b|\bin (its|their) place\b|\btakes? the place\b", "'instead of', 'replaces'")
pattern("alike", 1, r"\balike\b|\bthe likes?\b|\bits like\b|\blikewise\b|\band such\b", "'in the same way', 'both', 'similar'")
pattern("one-after-other", 2, r"\bone (after|behind|beside|above|below) (the|an)other\b|\bone by one\b|\beach (by itself|with nothing|alone)\b|\bby (itself|themselves)\b",
        "'sequentially', 'consecutive', 'separately'")
pattern("of-its-own", 2, r"\bof (its|their|his|your|one's) own\b", "'its own ...', 'separate'; 'compliance of its own' -> 'local compliance'")
pattern("is-to", 2, r"\b(is|are|was|were) to (be|stay|hold|have|take|go|carry|say|do|keep|come|see|read|find|ask|become|remain|move|lie|get|add|make|run|start)\b",
        "'must', 'should', 'will'")
pattern("some-n", 2, r"\b[Ss]ome (\d|ten|twenty|thirty|forty|fifty|hundred|thousand)", "'about'")
pattern("bits-of", 2, r"\bto the (same |last )?bits?\b|\b(the|same|other) bits (of|as|on)\b|\b(keeps?|has|have|with|of) (the|all|its|their) (same )?bits\b",
        "'bitwise identical', 'bit for bit'")
pattern("digits", 2, r"\b(keeps?|keep|lost|lose|loses|has|have|with) (its|their|all|half|no|the|a|all its|all their|fewer|more)? ?(of its |of their |last )?digits\b|\bdigit lost\b|\bto the last (bit|digit)\b",
        "'is accurate to full precision', 'loses accuracy'")
pattern("at-hand", 2, r"\b(at hand|at rest|all at once|in force|on the way|in the way|under way|on its way|on their way|in sight|out of step|apart from others)\b|\bin all(?=[.,;:)]|$)",
        "'available', 'simultaneously', 'meanwhile', 'in total'")
pattern("missing-of", 1, r"\bmissing of\b|\bis left of\b|\bmore of it\b|\bis there of\b|\bthere (is|are) of\b", "'the remaining ...', 'the deficit'")
pattern("there-is-clause", 2, r"\b(that|which|as|what|than|where|those|all) there (is|are|was|were|be)\b(?! (no|a|an|one)\b)",
        "'existing', 'available', 'of the n cells'")
pattern("that-is-there", 1, r"\b(that|which) (is|are) (there|in it|at hand|here)\b", "'existing'")
pattern("extraposed", 2, r"\b(are|is|were|was) (known|left|there|taken|found|given|shown|made|told|solved|sought|moved|kept|freed|held|meant|lost|added|missing|open|free|due|over) (that|which|whose)\b(?! (is|are|was|were|the|a|an|it|they|this|there|no|all|any|each|every|one|some|these|those|its|their)\b)",
        "keep the relative clause next to its noun")
pattern("elliptical-none", 2, r"(?:^|[;,:] )(?:None|none) (?!(?:of|is|are|was|were|has|can|the)\b)\w+|(?:^|[;,:] )(?:Nothing|nothing) (?:where|at|of|without|for|yet|there|near|by|if|on|under|to|in)\b",
        "a full sentence: 'Returns `None` if ...', 'does nothing if ...'")
pattern("do-so", 3, r"\bdo(es)? so\b",
        "repeat the verb")
pattern("as-many-as", 3, r"\bas (many|few|much|long|far|large|soon|little|well|often) as\b", "check that it is needed")
pattern("may", 3, r"\bmay\b", "'can' for ability, 'might' for possibility; 'may' for permission")
pattern("double-prep-which", 3, r", (of|by|from|with|in|on|to|at|for|under|over|through|behind|beside) (which|whom|whose)\b",
        "split the sentence")

LONG = 42  # largest number of words in a sentence that is not reported as long
LONG_NAME, LONG_ADVICE = "long-sentence", f"more than {LONG} words: split it"
CLAUSES_NAME, CLAUSES_ADVICE = "clause-chain", "four or more clauses joined by ; : and commas: split it"

# Coined names, for --names: identifier -> standard term.
NAMES = {
    "Own": "LocalCompliance", "OwnCompliance": "EntryCompliance", "Seen": "PassOutcome", "Passage": "ParticleShift",
    "Travel": "RollingShift", "Demand": "TangentialTarget", "CoupledDemand": "CoupledTarget", "Known": "StartKind",
    "Reached": "LoadPoint", "Ahead": "LoadIncrement", "Turn": "DiscMotion", "Standing": "BoundState",
    "Dealt": "Distribution", "Posed": "PosedScene", "Held": "LinearResponse", "Shown": "IterateNorms",
    "Survey": "ContactCounts", "Erased": "DynOperator", "Shifted": "ShiftedSums", "Carried": "BoundedPressure",
    "Within": "BallConstraint", "Moves": "CellCounts", "Course": "SolveContext", "Stand": "ContactState",
    "Nearest": "NearestCell", "Moved": "UpdatedIterate", "Look": "Check", "Left": "Retired", "Taken": "CommittedStep",
    "Account": "CellEnergies", "Attempt": "TrialStep", "Whole": "GlobalSums", "Findings": "ConvergenceData",
    "ConeFindings": "ConeConvergenceData", "Opening": "ConeStart", "Follow": "RollingResponse",
    "Increments": "StepDifferences", "Remarks": "StepWarnings", "Office": "Mailboxes", "Post": "MessageQueue",
    "Leaving": "DisconnectGuard", "Words": "WireFormat", "Tally": "Reduction", "Ragged": "UnevenSlices",
    "Share": "Partition", "Team": "Communicator", "Lease": "PooledBuffer", "Drawing": "CouplingDisplacement",
    "Composed": "ComposedSpectra", "Travelling": "FragmentMessage", "Joint": "CoupledWorkspace", "Mark": "ActiveSetMark",
}

# --------------------------------------------------------------------------------------------------------------------

RUST_LINE = re.compile(r"^\s*(///|//!|//)(?!/)(.*)$")
TRAILING = re.compile(r"(?<![:\"'\w/])//(?!/)\s(.*)$")
ERROR_TEXT = re.compile(r"#\[error\(\s*(?:\n\s*)?\"((?:[^\"\\]|\\.)*)\"", re.S)
DECLARATION = re.compile(r"\b(?:struct|enum|trait|type)\s+([A-Z]\w*)")
SUFFIXES = (".rs", ".md")
SKIPPED = {"target", ".git", "node_modules", "__pycache__", "katex"}


BLANKS = [
    (re.compile(r"\$`[^`]*`\$"), "MATH"),
    (re.compile(r"!\[[^\]]*\]\([^)]*\)"), ""),
    (re.compile(r"``[^`]*``|`[^`]*`"), "CODE"),
    (re.compile(r"\[([^\[\]]*)\]\((?:[^()]|\([^()]*\))*\)"), None),  # a link: its text stays
    (re.compile(r"\[(CODE)\](?:\[[^\]]*\])?"), None),
    (re.compile(r"<https?://[^>]*>|https?://\S+"), "URL"),
    (re.compile(r"\*\*|</?[a-z][^>]*>"), ""),
]


def blanked(text):
    """Returns the text with all code, formulas and links replaced by placeholders, and the original position of each character."""
    places = range(len(text))
    for expression, placeholder in BLANKS:
        pieces, moved, last = [], [], 0
        for match in expression.finditer(text):
            pieces.append(text[last:match.start()])
            moved.extend(places[last:match.start()])
            if placeholder is None:
                pieces.append(match.group(1))
                moved.extend(places[match.start(1):match.end(1)])
            else:
                pieces.append(placeholder)
                moved.extend([places[match.start()]] * len(placeholder))
            last = match.end()
        if last:
            pieces.append(text[last:])
            moved.extend(places[last:])
            text, places = "".join(pieces), moved
    return text, places


def paragraphs(lines):
    """Yields paragraphs, list items and table cells of numbered lines as lists of (line, text), without code blocks."""
    found, fence = [], False
    for number, line in lines:
        text = line.strip()
        if text.startswith(("```", "~~~")):
            fence = not fence
            found.append([])
            continue
        if fence or not text or re.match(r"^(#+ |[-=|: ]+$|\[[^\]]+\]: |>>> )", text):
            found.append([])
            continue
        if re.match(r"^\*{0,2}\w[\w, .*]* : ", text):  # a parameter of a Python docstring
            found.append([])
            continue
        if text.startswith("|"):
            for cell in text.strip("|").split("|"):
                if len(cell.split()) >= 3:
                    found.append([(number, cell.strip())])
            found.append([])
            continue
        bullet = re.match(r"^([-*+]|\d+[.)])\s+", text)
        if bullet:
            found.append([])
            text = text[bullet.end():]
        if not found:
            found.append([])
        found[-1].append((number, text))
    return [paragraph for paragraph in found if paragraph]


ABBREVIATION = re.compile(r"(?:\b(?:e\.g|i\.e|Fig|Figs|Eq|cf|vs|etc|St|Dr|al|approx|No|pp|[A-Z])\.)$")


def sentences(paragraph):
    """Yields the sentences of a paragraph, each with a function that maps a position in it to a line."""
    starts, position = [], 0
    for number, text in paragraph:
        starts.append((position, number))
        position += len(text) + 1
    clean, places = blanked(" ".join(text for _, text in paragraph))

    def line_at(offset):
        at = places[min(offset, len(places) - 1)] if len(places) else 0
        line = starts[0][1]
        for start, number in starts:
            if start <= at:
                line = number
        return line

    begin, word = None, None
    for word in re.finditer(r"\S+", clean):
        begin = word.start() if begin is None else begin
        end = word.group()
        if re.search(r"[.!?][)\"'*]*$", end) and not ABBREVIATION.search(end):
            following = clean[word.end():].lstrip()
            if not following or following[0].isupper() or following[0] in "([\"'*0123456789":
                yield clean[begin:word.end()], lambda offset, begin=begin: line_at(begin + offset)
                begin = None
    if begin is not None:
        yield clean[begin:].rstrip(), lambda offset, begin=begin: line_at(begin + offset)


def comments(text):
    """Yields runs of comment lines of Rust source as lists of (line, text), and whether they document an item."""
    runs, current, kind, last = [], None, None, -1
    for number, line in enumerate(text.split("\n"), 1):
        match = RUST_LINE.match(line)
        if match:
            body = match.group(2)
            body = body[1:] if body.startswith(" ") else body
            if current is not None and kind == match.group(1) and last == number - 1:
                current.append((number, body))
            else:
                current = [(number, body)]
                runs.append(current)
            kind, last = match.group(1), number
            continue
        current = None
        trailing = TRAILING.search(line)
        if trailing and line.count('"', 0, trailing.start()) % 2 == 0:
            runs.append([(number, trailing.group(1))])
    return runs


def files_of(paths):
    for path in paths:
        if os.path.isfile(path):
            yield path
            continue
        for folder, folders, names in os.walk(path):
            folders[:] = sorted(name for name in folders if name not in SKIPPED and not name.startswith("."))
            for name in sorted(names):
                if name.endswith(SUFFIXES):
                    yield os.path.join(folder, name)


def hits_of(path, patterns, options):
    with open(path, encoding="utf-8", errors="replace") as file:
        text = file.read()
    if path.endswith(".md"):
        runs = [list(enumerate(text.split("\n"), 1))]
    else:
        runs = comments(text)
        if options.strings:
            for match in ERROR_TEXT.finditer(text):
                runs.append([(text.count("\n", 0, match.start(1)) + 1, re.sub(r"\{[^}]*\}", "X", match.group(1)))])
    for run in runs:
        for paragraph in paragraphs(run):
            for sentence, line_at in sentences(paragraph):
                if len(sentence.split()) < 2 or re.match(r"^(SAFETY|TODO|#\[|use |let |fn )", sentence):
                    continue
                yield None, 1, None, sentence  # counts sentences
                for name, _, expression, _ in patterns:
                    match = expression.search(sentence)
                    if match:
                        yield name, line_at(match.start()), match.group(), sentence
                if sentence.count("CODE") > 3 and re.match(r"^(As |Of \w+ |)CODE", sentence):
                    continue  # a list of errors
                count = len(sentence.split())
                if options.long and count > LONG:
                    yield LONG_NAME, line_at(0), f"{count} words", sentence
                joints = len(re.findall(r"[;:]|, (?:and|but|which|that|where|as|so|if|of which|with|by)\b|, who", sentence))
                if options.long and joints >= 4:
                    yield CLAUSES_NAME, line_at(0), f"{joints} joints", sentence
    if options.names and path.endswith(".rs"):
        for number, line in enumerate(text.split("\n"), 1):
            for name in DECLARATION.findall(line):
                if name in NAMES:
                    yield "coined-name", number, name, f"{name} -> {NAMES[name]}"


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("paths", nargs="*")
    parser.add_argument("--summary", action="store_true")
    parser.add_argument("--only", default="")
    parser.add_argument("--skip", default="")
    parser.add_argument("--level", type=int, default=2)
    parser.add_argument("--strings", action="store_true")
    parser.add_argument("--names", action="store_true")
    parser.add_argument("--baseline")
    parser.add_argument("--record")
    parser.add_argument("--list", action="store_true")
    options = parser.parse_args()
    only = set(filter(None, options.only.split(",")))
    skip = set(filter(None, options.skip.split(",")))
    chosen = [p for p in PATTERNS if (p[0] in only or not only and p[1] <= options.level) and p[0] not in skip]
    options.long = (LONG_NAME in only or CLAUSES_NAME in only or not only and options.level >= 2) and LONG_NAME not in skip
    if options.list:
        for name, level, _, advice in PATTERNS:
            print(f"{name:18} {level}  {advice}")
        print(f"{LONG_NAME:18} 2  {LONG_ADVICE}\n{CLAUSES_NAME:18} 2  {CLAUSES_ADVICE}")
        return 0
    if not options.paths:
        parser.print_usage()
        return 2
    counts, flagged, total, read = Counter(), 0, 0, 0
    for path in files_of(options.paths):
        read += 1
        seen = None
        for name, line, found, sentence in hits_of(path, chosen, options):
            if name is None:
                total += 1
                seen = None
                continue
            counts[name] += 1
            if name != "coined-name" and seen is None:
                flagged += 1
                seen = sentence
            if not options.summary:
                text = sentence if len(sentence) <= 200 else sentence[:197] + "..."
                print(f"{path}:{line}: {name}: {text}")
    out = sys.stdout if options.summary else sys.stderr
    print(f"\n{read} files, {total} sentences, {flagged} with a hit ({100 * flagged / max(1, total):.1f} %)", file=out)
    for name, count in counts.most_common():
        print(f"{count:7} {name}", file=out)
    if options.record:
        with open(options.record, "w", encoding="utf-8") as file:
            json.dump(dict(sorted(counts.items())), file, indent=1)
    if options.baseline:
        with open(options.baseline, encoding="utf-8") as file:
            allowed = json.load(file)
        worse = {name: count for name, count in counts.items() if count > allowed.get(name, 0)}
        for name, count in sorted(worse.items()):
            print(f"{name}: {count} hits, {allowed.get(name, 0)} allowed", file=sys.stderr)
        return 1 if worse else 0
    return 1 if counts else 0


if __name__ == "__main__":
    try:
        sys.exit(main())
    except BrokenPipeError:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        sys.exit(1)
