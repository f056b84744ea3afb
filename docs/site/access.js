// What mdBook's pages lack for who reads them without a mouse or a screen: the label that opens the contents is a button, and code and
// tables that are wider than the page can be scrolled by keys.
document.getElementById("sidebar-toggle")?.setAttribute("role", "button");
for (const wide of document.querySelectorAll("pre > code, .table-wrapper")) {
    wide.tabIndex = 0;
}
