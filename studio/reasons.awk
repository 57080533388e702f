# reasons.awk HEADER... -- what helps against each reason of an error, as JSON: { "FILM": { "cable-too-weak": "...", ... }, "": { those of any call } }.
/^#define TAUT_([A-Z]*_)?REASON_LIST\(X\)/ {
    list = $2
    sub(/^TAUT_/, "", list)
    sub(/_?REASON_LIST\(X\)$/, "", list)
    text = ""
    inside = 1
    next
}
inside {
    inside = /\\$/
    sub(/[ \t]*\\$/, "")
    text = text $0
    if (!inside) show()
}
function show() {
    gsub(/\\"/, "\001", text)     # a quotation in a text
    gsub(/"[ \t]+"/, "", text)    # a text in two parts is one
    printf("%s\"%s\":{", (lists++ ? "," : "{"), list)
    count = split(text, rows, /X\(/)
    for (i = 2; i <= count; i++) {
        split(rows[i], parts, /"/)
        gsub(/\001/, "\\\"", parts[6])
        printf("%s\"%s\":\"%s\"", (i > 2 ? "," : ""), parts[2], parts[6])
    }
    printf("}")
}
END { print "}" }
