"""stack.py: reads `objdump -d` of a linked image and prints "function bytes" for each C function of the library: how much stack a call takes at
most, with all that it calls.

The instructions alone tell how deep the stack is at each place, so this is a bound and no measurement. A call through a pointer may lead to each
function whose address is taken on the way. The clock of a `claraty_trapezoid` comes from the caller, so its stack is not known here. A recursion and
a stack pointer that it cannot follow are errors.
"""

import re
import sys

FUNCTION = re.compile(r"^([0-9a-f]+) <(.*)>:$")
INSTRUCTION = re.compile(r"^ *([0-9a-f]+):\t(\S+)(?:\t(.*))?$")
OURS = re.compile(r"^(a_traj|a_poly|atraj_|claraty_)")
CONDITIONAL = re.compile(r"^add(eq|ne|cs|cc|mi|pl|vs|vc|hi|ls|ge|lt|gt|le)$")
REGISTER = re.compile(r"^(r\d+|ip|lr|fp|sl|s\d+|a\d|t\d|ra)$")


class Unknown(Exception):
    """What a function does to its stack that this program does not understand."""


def number(text):
    return int(text.lstrip("#"), 0)


def size_of(registers):
    """The bytes that the registers in braces take: {r4, r5, lr}, {d8-d11}."""
    size = 0
    for part in re.sub(r".*\{|\}.*|\s", "", registers).split(","):
        first, _, last = part.partition("-")
        several = int(last[1:]) - int(first[1:]) + 1 if last else 1
        size += several * (8 if part.startswith("d") else 4)
    return size


class Code:
    """One function: its frame, and how deep the stack is at each call."""

    def __init__(self, name, lines, words, places):
        self.first, self.last = (lines[0][0], lines[-1][0]) if lines else (0, 0)
        self.name, self.words, self.entries = name, words, places
        self.frame, self.calls, self.shares = 0, {}, set()
        self.pointer, self.taken = None, set()  # how deep the stack is at a call through a pointer, and the addresses that are taken
        self.at = {}  # the depth at each address that a branch leads to
        # Once for the branches that lead forward, and again for the branches that lead back.
        for _ in range(3):
            self.walk(lines)

    def walk(self, lines):
        self.depth, self.switched = 0, None
        self.places, self.values = {}, {}  # registers that point into the stack, and those that hold a number
        falls_through = True
        for address, mnemonic, operands in lines:
            if address in self.at:
                self.depth = max(self.at[address], self.depth if falls_through else 0)
            elif not falls_through:
                if self.switched is None:
                    continue  # these bytes are no code
                # A jump table leads here, for no branch does.
                self.depth = self.switched
            label = re.search(r"([0-9a-f]+) <.*>", operands)
            arguments = re.split(r", *", re.sub(r"\s*[;@#] .*| <.*", "", operands))
            mnemonic = re.sub(r"\.[nw]$", "", mnemonic)
            self.stack(mnemonic, operands, arguments)
            falls_through = self.flow(mnemonic, operands, arguments, label and int(label[1], 16))
        behind = min((entry for entry in self.entries if entry > self.last), default=None)
        if falls_through and lines and behind:
            self.call(behind)

    def take(self, size):
        self.depth += size
        self.frame = max(self.frame, self.depth)

    def stack(self, mnemonic, operands, arguments):
        """What the instruction does to the stack pointer, and to registers that may be added to it."""
        first, last = arguments[0], arguments[-1]
        if mnemonic in ("push", "vpush") or mnemonic in ("stmdb", "vstmdb") and first == "sp!":
            self.take(size_of(operands))
        elif mnemonic in ("pop", "vpop") or mnemonic in ("ldmia", "vldmia") and first == "sp!":
            self.depth -= size_of(operands)
        elif write_back := re.search(r"\[sp, #-(\d+)\]!", operands):
            self.take(int(write_back[1]))
        elif write_back := re.search(r"\[sp\], #(\d+)", operands):
            self.depth -= int(write_back[1])
        elif first == "sp" and not mnemonic.startswith(("st", "ld", "vst", "vld", "cmp")):
            self.move(mnemonic, arguments[1] if len(arguments) == 3 else "sp", last)
        elif REGISTER.match(first) and not mnemonic.startswith(("st", "sw", "sb", "sh", "cmp", "tst", "b", "cb", "j")):
            self.register(mnemonic, operands, arguments)

    def move(self, mnemonic, source, by):
        if CONDITIONAL.match(mnemonic):
            return  # a return that may not happen gives nothing back
        if mnemonic in ("mov", "mv"):
            source, by = by, "0"
        size = self.values.get(by) if by in self.values else number(by) if re.match(r"^#?-?\d", by) else None
        if size is None or mnemonic not in ("mov", "mv", "add", "addw", "adds", "addi", "sub", "subw", "subs"):
            raise Unknown(f"{mnemonic} sp, {source}, {by}")
        size = -size if mnemonic.startswith("add") else size
        if source == "sp":
            self.take(size)
        elif source in self.places:
            self.depth = self.places[source] + size
        else:
            raise Unknown(f"{mnemonic} sp, {source}, {by}")

    def register(self, mnemonic, operands, arguments):
        first, *rest = arguments
        place, value = None, None
        if rest and mnemonic in ("add", "adds", "addw", "addi", "mov", "mv") and rest[0] == "sp" and not REGISTER.match(rest[-1]):
            place = self.depth - (number(rest[1]) if len(rest) == 2 else 0)
        elif len(rest) == 2 and mnemonic in ("sub", "subs", "subw") and rest[0] in self.places and rest[1].startswith("#"):
            place = self.places[rest[0]] + number(rest[1])
        elif mnemonic == "ldr" and (literal := re.search(r"\(([0-9a-f]+) <", operands)):
            value = self.words.get(int(literal[1], 16))
        elif mnemonic == "movt":
            value = self.values.get(first, 0) + (number(rest[0]) << 16)
        elif mnemonic in ("mov", "movs", "movw", "li") and re.match(r"^#?-?\d", rest[0]):
            value = number(rest[0])
        elif mnemonic in ("lui", "c.lui"):
            value = number(rest[0]) << 12
        elif mnemonic in ("add", "addi") and rest[0] in self.values and re.match(r"^-?\d", rest[-1]):
            value = self.values[rest[0]] + number(rest[1])
        elif mnemonic == "lsls" and rest[0] in self.values and rest[-1].startswith("#"):
            value = self.values[rest[0]] << number(rest[-1])
        # The address of a Thumb function is odd. An even number may be the size of a frame.
        thumb = mnemonic in ("movt", "ldr")
        if value is not None and (thumb or mnemonic in ("add", "addi")) and value - thumb in self.entries:
            self.taken.add(self.entries[value - thumb])
        for known, now in ((self.places, place), (self.values, value)):
            known.pop(first, None)
            if now is not None:
                known[first] = now

    def flow(self, mnemonic, operands, arguments, target):
        """Follows calls and branches to the address `target`; whether the next instruction runs too."""
        first = arguments[0]
        is_call = mnemonic in ("bl", "jal") and (len(arguments) == 1 or first == "ra") or mnemonic == "jalr" and target and first != "zero"
        if is_call and not self.first < target <= self.last:
            self.call(target)
        elif is_call or mnemonic in ("b", "j"):
            # A Cortex-M0 has no other branch than `bl` that leads far.
            self.branch(target)
            return False
        elif mnemonic in ("blx", "jalr") or mnemonic == "bx" and first != "lr":
            self.pointer = max(self.depth, self.pointer or 0)
            return mnemonic != "bx"
        elif mnemonic in ("bx", "ret", "udf", "ebreak", "unimp", "mret"):
            return False
        elif mnemonic in ("pop", "ldmia") and "pc" in operands or mnemonic == "ldr" and first == "pc" and "[sp]" in operands:
            return False
        elif mnemonic in ("tbb", "tbh", "jr") or first == "pc":
            if target:
                self.branch(target)
            self.switched = self.depth
            return False
        elif target and re.match(r"^(b(eq|ne|cs|cc|mi|pl|vs|vc|hi|ls|ge|lt|gt|le)|cbn?z|b(eq|ne|lt|ge|gt|le)z?u?)$", mnemonic):
            self.branch(target)
        return True

    def call(self, target):
        entry = max(entry for entry in self.entries if entry <= target)
        callee = self.entries[entry]
        if entry != target:
            # Assembly of libgcc shares its ends, which take nothing more than the function that they belong to.
            self.shares.add(callee)
            return
        self.calls[callee] = max(self.depth, self.calls.get(callee, 0))

    def branch(self, target):
        """A branch to another function is a call that does not come back here."""
        if self.first <= target <= self.last:
            self.at[target] = max(self.depth, self.at.get(target, 0))
        else:
            self.call(target)


def functions(text):
    """The code of each function, by its name."""
    code, words, places, lines = {}, {}, {}, None
    for line in text:
        if found := FUNCTION.match(line):
            lines = code.setdefault(found[2], [])
            places[int(found[1], 16)] = found[2]
        elif (found := INSTRUCTION.match(line)) and lines is not None:
            address, mnemonic, operands = int(found[1], 16), found[2], found[3] or ""
            if mnemonic == ".word":
                word = int(operands.split()[0], 0)
                words[address] = word - (word >> 31 << 32)
            elif not mnemonic.startswith("."):
                lines.append((address, mnemonic, operands))
    return {name: Code(name, lines, words, places) for name, lines in code.items()}


def reached(name, code):
    """The functions that a call may reach, and those among them that it may reach through a pointer."""
    found, pointers, left = set(), set(), {name}
    while left:
        function = left.pop()
        found.add(function)
        pointers |= code[function].taken
        left |= {*code[function].calls, *code[function].shares, *pointers} - found
    return pointers


def bound(name, code, pointers, bounds, callers=()):
    """The stack of a function with all that it calls."""
    if name in callers:
        raise Unknown(f"{name} calls itself: {callers}")
    if name not in bounds:
        function = code[name]
        calls = [*function.calls.items(), *((end, 0) for end in function.shares if end not in callers)]
        if function.pointer is not None:
            calls += [(pointer, function.pointer) for pointer in pointers]
        needs = [depth + bound(callee, code, pointers, bounds, (*callers, name)) for callee, depth in calls]
        bounds[name] = max([function.frame, *needs])
    return bounds[name]


def main():
    code = functions(sys.stdin.read().splitlines())
    for name in sorted(code):
        if OURS.match(name):
            print(name, bound(name, code, reached(name, code), {}))


main()
