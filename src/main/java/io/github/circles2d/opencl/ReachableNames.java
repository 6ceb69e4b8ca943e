package io.github.circles2d.opencl;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;

/**
 * The names that functions of a {@link KernelSource} reach: those in their own text, in the text of the functions, variables and macros that
 * these are names of, and so on. They may be too many: all branches of the preprocessor count. Names that macros put together ({@code ##})
 * are not found.
 */
public final class ReachableNames {
    /** The worlds of a program mostly have the same kernels. */
    private static volatile ReachableNames latest = new ReachableNames(KernelSource.ofText("none", ""), Set.of());

    /** By what is defined: the names in its text, of all its texts if there are several. */
    private final Map<String, Set<String>> definitions = new HashMap<>();

    /** A function that is defined, and the place of its text. */
    private record Function(String name, int from, int to) {}

    private final List<Function> functions = new ArrayList<>();
    private final KernelSource source;
    private final String text;
    private final Set<String> hidden;
    private int at;

    private ReachableNames(KernelSource source, Set<String> hidden) {
        this.source = source;
        text = source.text();
        this.hidden = hidden;
        while (skipSpace()) {
            if (text.charAt(at) == '#') {
                readDirective();
            } else {
                readDeclaration();
            }
        }
    }

    /**
     * Reads a source.
     *
     * @param source the kernels
     * @param hidden macros whose text does not count
     * @return what its functions reach
     * @throws IllegalArgumentException if braces are not in pairs where all branches of the preprocessor count
     */
    public static ReachableNames of(KernelSource source, Set<String> hidden) {
        ReachableNames names = latest;
        boolean isLatest = source.text().equals(names.text)
                && source.buildOptions().equals(names.source.buildOptions())
                && hidden.equals(names.hidden);
        if (!isLatest) {
            names = new ReachableNames(source, hidden);
            latest = names;
        }
        return names;
    }

    /**
     * Returns the names that a kernel reaches, its own included.
     *
     * @param kernel the name of a function
     * @return names
     * @throws IllegalArgumentException if the source has no such function
     */
    public Set<String> from(String kernel) {
        if (!definitions.containsKey(kernel)) {
            throw new IllegalArgumentException("the source has no function " + kernel);
        }
        Set<String> reached = new HashSet<>(Set.of(kernel));
        Deque<String> next = new ArrayDeque<>(reached);
        while (!next.isEmpty()) {
            for (String name : definitions.getOrDefault(next.pop(), Set.of())) {
                if (reached.add(name)) {
                    next.push(name);
                }
            }
        }
        return reached;
    }

    /** {@return the names of all kernels, whether or not the preprocessor leaves them in} */
    public Set<String> kernels() {
        Set<String> kernels = new HashSet<>();
        for (Function function : functions) {
            for (String name : definitions.get(function.name)) {
                // A macro may begin the definition.
                if (name.equals("kernel")
                        || definitions.getOrDefault(name, Set.of()).contains("kernel")) {
                    kernels.add(function.name);
                }
            }
        }
        return kernels;
    }

    /**
     * A program of some of the kernels: the source without the functions that none of them reaches. Compilers still tell the lines of its files.
     *
     * @param kernels names of kernels
     * @return the source, with the same definitions
     * @throws IllegalArgumentException if the source has no such function
     */
    public KernelSource sourceOf(Set<String> kernels) {
        Set<String> reached = new HashSet<>();
        kernels.forEach(kernel -> reached.addAll(from(kernel)));
        StringBuilder kept = new StringBuilder();
        int end = 0;
        for (Function function : functions) {
            if (!reached.contains(function.name)) {
                // No blank lines instead: JavaCL's search for #include takes the square of their number.
                kept.append(text, end, function.from)
                        .append("\n#line ")
                        .append(lineOf(function.to))
                        .append('\n');
                end = function.to;
            }
        }
        return source.withText(kept.append(text, end, text.length()).toString());
    }

    /** The line of a place in its file. */
    private int lineOf(int place) {
        int first = endOfLine(text.lastIndexOf("#line 1 ", place)) + 1;
        return 1
                + (int) text.substring(first, place)
                        .chars()
                        .filter(c -> c == '\n')
                        .count();
    }

    private void readDirective() {
        int end = at;
        do {
            end = endOfLine(end + 1);
        } while (end < text.length() && text.charAt(end - 1) == '\\');
        at++;
        boolean isMacro = nextName(end).equals("define");
        String macro = nextName(end);
        if (isMacro && !hidden.contains(macro)) {
            Set<String> names = namesOf(macro);
            for (String name = nextName(end); !name.isEmpty(); name = nextName(end)) {
                names.add(name);
            }
        }
        at = end;
    }

    /**
     * Reads up to a semicolon, or the body of a function. Types are left out: their members are not used where they are declared. Directives
     * may stand within.
     */
    private void readDeclaration() {
        Set<String> names = new HashSet<>();
        int from = at;
        boolean isFunction = false;
        String declared = "";
        String last = "";
        int braces = 0;
        int parentheses = 0;
        while (skipSpace()) {
            char c = text.charAt(at);
            if (c == '#') {
                readDirective();
                continue;
            }
            if (isOfName(c)) {
                last = nextName(text.length());
                names.add(last);
                continue;
            }
            at++;
            boolean outside = braces == 0 && parentheses == 0;
            if (outside && declared.isEmpty() && "(=[;".indexOf(c) >= 0 && !last.equals("__attribute__")) {
                declared = last;
                isFunction = c == '(';
            }
            parentheses += c == '(' ? 1 : c == ')' ? -1 : 0;
            braces += c == '{' ? 1 : c == '}' ? -1 : 0;
            if (braces == 0 && (c == ';' || (c == '}' && !names.contains("typedef")))) {
                break;
            }
        }
        if (braces != 0 || parentheses != 0) {
            throw new IllegalArgumentException(
                    "the declaration of '" + declared + "' has no end in all branches of the preprocessor");
        }
        if (!names.contains("typedef")) {
            namesOf(declared).addAll(names);
            if (isFunction && text.charAt(at - 1) == '}') {
                functions.add(new Function(declared, from, at));
            }
        }
    }

    private Set<String> namesOf(String definition) {
        return definitions.computeIfAbsent(definition, name -> new HashSet<>());
    }

    /** Goes to what is neither space nor comment; false at the end of the text. */
    private boolean skipSpace() {
        while (at < text.length()) {
            if (text.startsWith("//", at)) {
                at = endOfLine(at);
            } else if (text.startsWith("/*", at)) {
                int end = text.indexOf("*/", at + 2);
                at = end < 0 ? text.length() : end + 2;
            } else if (Character.isWhitespace(text.charAt(at)) || text.charAt(at) == '\\') {
                at++;
            } else {
                return true;
            }
        }
        return false;
    }

    private int endOfLine(int from) {
        int end = text.indexOf('\n', from);
        return end < 0 ? text.length() : end;
    }

    /** The next name before an end, not in a comment; empty if there is none. */
    private String nextName(int end) {
        while (skipSpace() && at < end) {
            int from = at;
            while (at < end && isOfName(text.charAt(at))) {
                at++;
            }
            if (at > from) {
                return text.substring(from, at);
            }
            at++;
        }
        return "";
    }

    private static boolean isOfName(char c) {
        return c == '_' || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
    }
}
