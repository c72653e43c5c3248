# Completion of the command fieldfab: the command itself tells its verbs and options.
_fieldfab() {
  local word=${COMP_WORDS[COMP_CWORD]} verb=
  local i
  for ((i = 1; i < COMP_CWORD; ++i)); do
    case ${COMP_WORDS[i]} in
      -*) ;;
      [a-z]*) verb=${COMP_WORDS[i]}; break ;;
    esac
  done
  if [[ $word == -* ]]; then
    COMPREPLY=($(compgen -W "$("$1" ${verb:+"$verb"} --help 2>/dev/null | sed -nE 's/^  (-[^ ]*)? {0,8}(--[^ ]+)?.*/\1 \2/p' | tr ', ' '\n')" -- "$word"))
  elif [[ -z $verb ]]; then
    COMPREPLY=($(compgen -W "$("$1" --help 2>/dev/null | sed -n '/^Subcommands:/I,$ s/^  \([a-z]\+\) .*/\1/p')" -- "$word"))
  fi
}
complete -o default -F _fieldfab fieldfab
