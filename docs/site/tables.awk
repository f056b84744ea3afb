# Draws each table of a page: a line that is nothing but a link to a CSV file, which is in the folder `from`. A long table is folded.

match($0, /^\[[^]]*\]\(data\/[^)]*\.csv\)$/) {
    title = substr($0, 2, index($0, "](") - 2)
    file = substr($0, index($0, "](") + 2)
    sub(/\)$/, "", file)
    draw(title, file)
    next
}
{ print }

function draw(title, file,   line, rows, text, columns) {
    while ((getline line < (from "/" file)) > 0) {
        text = text (rows++ ? row(line, "td") : row(line, "th"))
        if (rows == 1) { columns = count }
        if (count != columns || rest != "") { fail(file ", line " rows ": " columns " fields are due") }
    }
    if (rows < 2) { fail(file " is no table") }
    printf "<details%s>\n<summary>%s: %d rows</summary>\n<p><a href=\"%s\">As a file</a></p>\n", (rows <= 25 ? " open" : ""), title, rows - 1, file
    printf "<div class=\"table-wrapper\"><table>\n%s</table></div>\n</details>\n", text
}

# The fields of a line, which may be quoted. Names of C and Rust are set as code, and numbers stand at the right.
function row(line, tag,   text, cell) {
    rest = line ","
    for (count = 0; match(rest, /^("([^"]|"")*"|[^",]*),/); rest = substr(rest, RLENGTH + 1)) {
        cell = substr(rest, 1, RLENGTH - 1)
        if (cell ~ /^"/) { cell = substr(cell, 2, length(cell) - 2); gsub(/""/, "\"", cell) }
        gsub(/&/, "\\&amp;", cell); gsub(/</, "\\&lt;", cell); gsub(/>/, "\\&gt;", cell)
        ++count
        if (tag == "th") { is_code[count] = cell ~ /^(function|file|condition|mutant)$/ }
        else if (is_code[count]) { cell = "<code>" cell "</code>" }
        text = text "<" tag (cell ~ /^-?[0-9.]+$/ ? " class=\"number\">" : ">") cell "</" tag ">"
    }
    return "<tr>" text "</tr>\n"
}

function fail(why) { print why > "/dev/stderr"; exit 1 }
