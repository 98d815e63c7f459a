# What failed, by the output of dotnet test or of node --test: of each test a line with its name, a tabulator and how its message begins.
# Suites of node that failed by a test within, which has a line of its own, are left out. Without any test: the first errors of a build.

function told() {
  if (name != "") { print name "\t" substr(message, 1, 120); tests++ }
  name = message = ""
  isMessage = 0
}

function trimmed(text) { gsub(/^[ \t]+|[ \t\r]+$/, "", text); return text }

function said(text) { if (text != "" && length(message) < 120) message = message (message == "" ? "" : " ") text }

/^ +Failed .+ \[[^]]+\]$/ { told(); name = trimmed($0); sub(/^Failed /, "", name); sub(/ \[[^]]+\]$/, "", name); next }
/^The active test run was aborted/ { told(); name = trimmed($0); told() }
/^ +Error Message:$/ { isMessage = 1; next }
/^ +Stack Trace:$/ { told(); next }

/^ *not ok [0-9]+ - / { told(); name = trimmed($0); sub(/^not ok [0-9]+ - /, "", name); next }
/^ +failureType: 'subtestsFailed'$/ { name = "" }
/^ +error: / { isMessage = 1; sub(/^ +error: ([|>]-?$)?/, "") }
/^ +(code|stack|name|expected|actual|operator): / { isMessage = 0 }
/^ +\.\.\.$/ { told() }

isMessage { said(trimmed($0)) }

/(^|: )error( [A-Z]+[0-9]+)?: / {
  error = trimmed($0)
  if (!(error in seen) && errors < 5) first[errors++] = error
  seen[error] = 1
}

END {
  told()
  if (tests == 0) for (i = 0; i < errors; i++) print substr(first[i], 1, 240) "\t"
}
