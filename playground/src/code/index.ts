// The programs that plan what the page shows, in C, C++, Rust and Python.
import type { Change } from "../run";
import type { State } from "../state";
import { C, CPP, cWriter } from "./c";
import { pythonWriter } from "./python";
import { rustWriter } from "./rust";

export type Language = "C" | "C++" | "Rust" | "Python";

export const LANGUAGES: Language[] = ["C", "C++", "Rust", "Python"];

/** The program that plans `state`, or runs it with these changes. Its last line tells the duration and where the axis is then. */
export function code(language: Language, state: State, changes?: Change[]): string {
    const { profile, values, commands, points, unit } = state;
    const write = { C: cWriter(C, unit), "C++": cWriter(CPP, unit), Rust: rustWriter(unit), Python: pythonWriter(unit) }[language];
    switch (profile) {
        case "bell":
        case "liba-bell":
            return write.bell(profile === "bell", values);
        case "trap":
        case "liba-trap":
            return write.trap(profile === "trap", values);
        case "poly3":
        case "poly5":
        case "poly7":
            return write.poly(Number(profile.slice(4)), values);
        case "sync":
        case "line":
            return write.axes(profile, values, changes);
        case "path":
            return write.path(values, points, changes);
        default:
            return write.move(values, commands, changes);
    }
}
