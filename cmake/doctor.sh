# `./course doctor`: what is here, what is missing, and which commands need it. Read by `course`.
# shellcheck shell=bash disable=SC2154  # release is set in course

# Exit status: 0 when what a student needs first is here, else 1.
doctor() {
    local missing_first=0
    echo "What every command needs (exercises, chapter 1):"
    doctor_group start || missing_first=1
    doctor_compiler || missing_first=1
    doctor_cmake || missing_first=1
    doctor_folder || missing_first=1
    echo "For some commands:"
    for group in $(groups | grep -v '^start$'); do doctor_group "$group" || true; done
    doctor_git
    doctor_sandbox
    doctor_room
    doctor_locale
    if ((missing_first)); then
        printf '\nSomething is missing that every command needs: the lines with "missing" and "wrong" above.\n'
        ways_to_install
    else
        printf '\nYou can start: ./course exercise 1.1, ./course run 1\n'
    fi
    return "$missing_first"
}

found() { printf '  %-8s %s\n' ok "$1"; }
wanting() { printf '  %-8s %s\n' "$1" "$2"; } # STATE WHAT

doctor_group() { # GROUP
    local missing
    if ! has_apt; then
        wanting unknown "$1 ($(what_for "$1")): this system has no dpkg that could tell; Debian's names: $(packages_of "$1" | cut -d' ' -f1 | paste -sd' ')"
        return 0
    fi
    missing=$(missing_packages "$1" | paste -sd' ')
    if [[ -z $missing ]]; then found "$1: $(what_for "$1")"; return 0; fi
    wanting missing "$1: $(what_for "$1")"
    while read -r package what; do
        [[ " $missing " != *" $package "* ]] || printf '           %s: %s\n' "$package" "$what"
    done < <(packages_of "$1")
    printf '           to install: ./course setup %s\n' "$1"
    return 1
}

doctor_compiler() { # the one that CMake would take
    local compiler=${CXX:-c++}
    if ! command -v "$compiler" >/dev/null; then wanting missing "the compiler $compiler"; return 1; fi
    if ! echo '#include <span>
        #include <numbers>
        consteval int one() { return 1; }
        int main() { return one() - 1; }' | "$compiler" -std=c++20 -x c++ -fsyntax-only - 2>/dev/null; then
        wanting wrong "$compiler does not know C++20: $("$compiler" --version | head -1); g++ 12 or clang 14 do"
        return 1
    fi
    found "compiler: $("$compiler" --version | head -1)"
}

doctor_cmake() {
    local asked version
    asked=$(sed -n 's/^cmake_minimum_required(VERSION \(.*\))/\1/p' CMakeLists.txt)
    version=$(cmake --version 2>/dev/null | sed -n 's/^cmake version //p')
    if [[ -z $version ]]; then wanting missing "cmake"; return 1; fi
    if [[ $(printf '%s\n' "$asked" "$version" | sort -V | head -1) != "$asked" ]]; then
        wanting wrong "cmake $version is older than $asked"
        return 1
    fi
    found "cmake $version"
}

doctor_folder() { # may be written to, and is where its build was made
    local home
    if [[ ! -w . ]]; then wanting wrong "$PWD cannot be written to: clone into your home"; return 1; fi
    home=$(sed -n 's/^CMAKE_HOME_DIRECTORY:INTERNAL=//p' "$release/CMakeCache.txt" 2>/dev/null)
    if [[ -n $home && $(readlink -f "$home") != "$PWD" ]]; then
        wanting wrong "$release was made for $home: remove it (rm -r $release), the next command makes it anew"
        return 1
    fi
    found "folder: $PWD"
    if [[ $PWD == /mnt/* ]] && grep -qi microsoft /proc/version; then
        wanting slow "this folder lies on Windows' disk, which WSL reads slowly: clone into your home (cd ~)"
    fi
}

doctor_git() {
    if ! command -v git >/dev/null; then wanting missing "git: ./course update, and ./course handout"
    elif ! git rev-parse --git-dir >/dev/null 2>&1; then wanting missing "this folder is no clone: ./course update cannot fetch from where it came, and there is no ./course handout"
    else found "git"; fi
}

doctor_sandbox() {
    local said
    command -v python3 >/dev/null || return 0 # told already
    said=$(PYTHONDONTWRITEBYTECODE=1 PYTHONPATH=exercises python3 -c 'import sandbox; sandbox.sandbox_works()' 2>&1) || true
    if [[ -z $said ]]; then found "sandbox: bubblewrap works"; else wanting missing "sandbox: ${said##*$'\n'}"; fi
}

doctor_room() { # the disk; and memory, of which a compiler takes up to a GB
    local disk memory
    disk=$(df -Pm . | awk 'NR == 2 { print $4 }')
    if ((disk < 3000)); then wanting small "disk: $disk MB are free; all programs, results and the book take 3000"; else found "disk: $disk MB are free"; fi
    memory=$(awk '/^MemTotal:/ { printf "%d", $2 / 1000 }' /proc/meminfo 2>/dev/null) || memory=0
    if ((memory && memory < 1000 * $(nproc))); then
        wanting small "memory: $memory MB for $(nproc) processors; where the compiler is killed, use fewer: taskset -c 0 ./course ..."
    else found "memory: $memory MB"; fi
}

doctor_locale() {
    if [[ $(locale charmap 2>/dev/null) == UTF-8 ]]; then found "locale: UTF-8"
    else wanting other "locale: this terminal may show ? for letters like τ; LC_ALL=C.UTF-8 shows them. Results are the same"; fi
}

ways_to_install() {
    if ! has_apt; then echo "This system has no apt: install what Debian calls by these names, or work in the container (docs/your_machine.md)."
    elif (($(id -u) == 0)) || command -v sudo >/dev/null; then echo "To install: ./course setup start"
    else echo "You are not root, and there is no sudo. Ask an administrator for: apt-get install --no-install-recommends $(missing_packages start | paste -sd' ')"; fi
}
