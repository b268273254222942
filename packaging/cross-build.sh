# Libraries from the sources of Debian's packages, built for another system; sourced by scripts/check-windows and scripts/browser.
# They say: root, work, prefix, sources (folders), jobs, target (its name), toolchain (a list of options for cmake), host (a list of
# options for configure), configure_environment (a list of assignments).

# The source of a Debian package, unpacked; prints its folder.
source_of() {
  local folder=$sources/$1
  if [ ! -d "$folder" ]; then
    local suite
    suite=$(. /etc/os-release && echo "$VERSION_CODENAME")
    echo "deb-src ${MIRROR:-$(apt-get indextargets --format '$(SITE)' 'Created-By: Packages' | head -1)} $suite main" >"$sources/sources.list"
    local places=(-o "Dir::Etc::sourcelist=$sources/sources.list" -o Dir::Etc::sourceparts=/dev/null -o "Dir::State::lists=$sources/lists" -o APT::Sandbox::User=root)
    [ -n "$(ls "$sources"/lists/*Sources* 2>/dev/null)" ] || apt-get "${places[@]}" update >&2
    (cd "$sources" && apt-get "${places[@]}" source --download-only "$1" >&2 && dpkg-source -x --no-check "$1"_*.dsc "$folder" >&2)
  fi
  echo "$folder"
}
by_cmake() { # SOURCE PACKAGE'S OPTIONS...
  local folder
  folder=$(source_of "$1")
  [ -f "$prefix/.$1" ] && return
  echo "building $1 for $target" >&2
  cmake -G Ninja -S "$folder${subfolder:-}" -B "$work/$1" "${toolchain[@]}" \
    -D CMAKE_INSTALL_PREFIX="$prefix" -D CMAKE_BUILD_TYPE=Release -D BUILD_SHARED_LIBS=OFF "${@:2}" >"$work/$1.log" 2>&1 &&
    ninja -C "$work/$1" -j "$jobs" install >>"$work/$1.log" 2>&1 || { tail -30 "$work/$1.log" >&2; exit 1; }
  touch "$prefix/.$1"
}
by_configure() {
  local folder
  folder=$(source_of "$1")
  [ -f "$prefix/.$1" ] && return
  echo "building $1 for $target" >&2
  mkdir -p "$work/$1" "$folder/doc"
  [ -f "$folder/doc/Makefile.in" ] || printf 'all install:\n' >"$folder/doc/Makefile.in" # Debian leaves GMP's manual out
  (cd "$work/$1" && env "${configure_environment[@]}" "$folder/configure" "${host[@]}" --prefix="$prefix" \
    --enable-static --disable-shared "${@:2}" && make -j "$jobs" && make install) >"$work/$1.log" 2>&1 || { tail -30 "$work/$1.log" >&2; exit 1; }
  touch "$prefix/.$1"
}
# Headers alone are the same for every system.
link_headers() { # NAMES...
  mkdir -p "$prefix/include" "$prefix/lib/cmake" "$prefix/share/cmake"
  local headers
  for headers in "$@"; do
    [ ! -e "/usr/include/$headers" ] || ln -sfn "/usr/include/$headers" "$prefix/include/$headers"
  done
  ln -sfn /usr/lib/*/cmake/CGAL "$prefix/lib/cmake/CGAL"
  ln -sfn /usr/share/cmake/nlohmann_json "$prefix/share/cmake/nlohmann_json"
  ln -sfn /usr/share/cmake/CLI11 "$prefix/share/cmake/CLI11"
  ln -sfn /usr/share/eigen3 "$prefix/share/eigen3"
}
