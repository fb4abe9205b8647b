# Where results lie, and whose they are. Read by `course`.
# shellcheck shell=bash disable=SC2154  # quick is set in course
#   .runs           of all folders: ninja's graph of the last run, its stamps, logs and seconds (cmake/run_beside.py)
#   FOLDER/.made_by the hash of the program that made all of a folder; the book refuses those of another program (docs/tools/checks.py)

results_root() { # small results never mix with full ones
    if [[ $quick == yes ]]; then echo build/results-quick; else echo build/results; fi
}

results_of() { echo "$(results_root)/$1"; } # FOLDER

# A program that runs by itself, with a scene of the reader's own perhaps, may write where results lie: they hold no longer then.
begin_to_watch() { # FOLDER
    mkdir -p "$(results_of "$1")"
    touch "$(results_of "$1")/.started.part"
}

forget_if_touched() { # FOLDER
    local out
    out=$(results_of "$1")
    if [[ -n $(find "$out" -maxdepth 1 -type f ! -name '.*' -newer "$out/.started.part" -print -quit) ]]; then
        rm -rf "$out/.made_by" "$(results_root)/.runs/done/$1"
    fi
    rm -f "$out"/.*.part
    rmdir --ignore-fail-on-non-empty "$out"
}
