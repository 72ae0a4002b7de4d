# bash completion for heatladder; the words are those of its help
_heatladder() {
    local words='' program=${COMP_WORDS[0]} current=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]}
    local values
    if [ "$COMP_CWORD" = 1 ]; then
        words="--help --version $("$program" --help | sed -n 's/^  heatladder \([a-z]*\) .*/\1/p')"
    else
        # The words of a value follow the last colon of the option's text.
        values=$("$program" "${COMP_WORDS[1]}" --help | awk -v option="$before" '
            /^  --/ || !/^      / { found = $1 == option }
            found { text = text " " $0 }
            END { if (match(text, /: [a-z0-9_, ]*$/)) { text = substr(text, RSTART + 2); gsub(/,/, "", text); print text } }')
        case $values in
        *' '*) words=$values ;;
        *)
            words="--help $("$program" "${COMP_WORDS[1]}" --help | sed -n 's/^  \(--[a-z-]*\) .*/\1/p')"
            case $current in
            -*) ;;
            *) words="$words $("$program" list scenes 2>/dev/null | sed -n 's/^\([a-z][a-z-]*\):.*/\1/p')
                      $("$program" list methods 2>/dev/null | sed -n 's/^\([a-z][a-z_]*\):.*/\1/p')" ;;
            esac
            ;;
        esac
    fi
    mapfile -t COMPREPLY < <(compgen -W "$words" -- "$current")
}
complete -o default -F _heatladder heatladder
