# shellcheck shell=sh disable=SC2154
# Functions for tables of seeded faults: name | file | text that occurs exactly once | its replacement | reason.

# Prints the rows of the table, separated by tabs; names may repeat unless $2 is 1.
fault_rows() { # table, whether names are of one row each
    awk -F ' +[|] +' -v OFS='\t' -v once="$2" '
        /^#/ || /^ *$/ { next }
        NF != 5 { printf "%s:%d: %d fields, 5 are wanted\n", FILENAME, FNR, NF > "/dev/stderr"; exit 1 }
        once && seen[$1]++ { printf "%s:%d: %s is there twice\n", FILENAME, FNR, $1 > "/dev/stderr"; exit 1 }
        { $1 = $1; print }
    ' "$1"
}

# Replaces the text $old by $new in the file; prints the reason on standard output if it cannot.
spoil() { # file, file to write; $old and $new
    OLD=$old NEW=$new TO=$2 awk '
        { text = text $0 "\n" }
        END {
            old = ENVIRON["OLD"]; at = index(text, old); rest = substr(text, at + length(old))
            if (!at) { print "not found: " old; exit 1 }
            if (index(rest, old)) { print "not unique: " old; exit 1 }
            printf "%s%s%s", substr(text, 1, at - 1), ENVIRON["NEW"], rest >ENVIRON["TO"]
        }
    ' "$1"
}
