# Lists the failures in the output of dotnet test or node --test: one line per test with its name, a tab and the start of its message.
# Omits suites of node that failed because of a test in them, which has its own line. If no test failed, lists the first build errors.

function report() {
  if (name != "") { print name "\t" substr(message, 1, 120); tests++ }
  name = message = ""
  isMessage = 0
}

function trimmed(text) { gsub(/^[ \t]+|[ \t\r]+$/, "", text); return text }

function append(text) { if (text != "" && length(message) < 120) message = message (message == "" ? "" : " ") text }

/^ +Failed .+ \[[^]]+\]$/ { report(); name = trimmed($0); sub(/^Failed /, "", name); sub(/ \[[^]]+\]$/, "", name); next }
/^The active test run was aborted/ { report(); name = trimmed($0); report() }
/^ +Error Message:$/ { isMessage = 1; next }
/^ +Stack Trace:$/ { report(); next }

/^ *not ok [0-9]+ - / { report(); name = trimmed($0); sub(/^not ok [0-9]+ - /, "", name); next }
/^ +failureType: 'subtestsFailed'$/ { name = "" }
/^ +error: / { isMessage = 1; sub(/^ +error: ([|>]-?$)?/, "") }
/^ +(code|stack|name|expected|actual|operator): / { isMessage = 0 }
/^ +\.\.\.$/ { report() }

isMessage { append(trimmed($0)) }

/(^|: )error( [A-Z]+[0-9]+)?: / {
  error = trimmed($0)
  if (!(error in seen) && errors < 5) first[errors++] = error
  seen[error] = 1
}

END {
  report()
  if (tests == 0) for (i = 0; i < errors; i++) print substr(first[i], 1, 240) "\t"
}
