# Completion of sbeh for bash, and for zsh after `autoload bashcompinit && bashcompinit`: the words of --help.

_sbeh() {
  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]} command=() k help words=
  for ((k = 1; k < COMP_CWORD && k <= 2; ++k)); do  # such as: mesh sphere
    [[ ${COMP_WORDS[k]} =~ ^[a-z]+$ ]] && command+=("${COMP_WORDS[k]}")
  done
  help=$("${COMP_WORDS[0]}" "${command[@]}" --help 2> /dev/null) ||
    help=$("${COMP_WORDS[0]}" "${command[@]:0:1}" --help 2> /dev/null)
  if [[ $word == -* ]]; then
    words=$(sed -n 's/^  \(-[^ ]*\).*/\1/p' <<< "$help" | tr , '\n')
  elif [[ $before != -* ]]; then
    words=$(sed -n '/^Subcommands:/,/^$/s/^  \([a-z][a-z]*\) .*/\1/p' <<< "$help")
  fi
  mapfile -t COMPREPLY < <(compgen -W "$words" -- "$word")
  if [[ ${#COMPREPLY[@]} == 0 ]]; then
    compopt -o filenames
    mapfile -t COMPREPLY < <(compgen -f -- "$word")
  fi
}
complete -F _sbeh sbeh
