/* Reads golden files. Ends the program if a file is missing, empty or of another form. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MAX_CELLS = 64, MAX_LINE = 2048 };

/* An open golden file and its last row read. */
struct table {
    FILE *file;
    char name[64];
    int line;
    char text[MAX_LINE];
    char *cells[MAX_CELLS];
    int count;
};

static struct table open_golden(const char *directory, const char *name) {
    static struct table table;
    char path[1024];
    snprintf(table.name, sizeof(table.name), "%s", name);
    snprintf(path, sizeof(path), "%s/%s", directory, name);
    table.file = fopen(path, "r");
    table.line = 0;
    if (!table.file || !fgets(table.text, MAX_LINE, table.file)) {
        fprintf(stderr, "%s: missing or empty\n", path);
        exit(2);
    }
    table.line = 1;
    return table;
}

/* Reads the next row; the number of its cells must be `count`. */
static int next_row(struct table *table, int count) {
    char *cell = table->text;
    if (!fgets(table->text, MAX_LINE, table->file)) {
        fclose(table->file);
        if (table->line < 2) {
            fprintf(stderr, "%s: no rows\n", table->name);
            exit(2);
        }
        return 0;
    }
    ++table->line;
    table->text[strcspn(table->text, "\r\n")] = 0;
    for (table->count = 0; cell && table->count < MAX_CELLS; ++table->count) {
        table->cells[table->count] = cell;
        cell = strchr(cell, ',');
        if (cell) { *cell++ = 0; }
    }
    if (table->count != count) {
        fprintf(stderr, "%s:%d: %d cells instead of %d\n", table->name, table->line, table->count, count);
        exit(2);
    }
    return 1;
}

