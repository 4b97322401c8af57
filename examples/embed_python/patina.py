"""Patina for Python programs: graphs in, shaders and their reflection out. Through ctypes, with no other module.

    from patina import Compiler

    compiler = Compiler()
    result = compiler.compile_file("rust.graph.json", targets=["glsl"])
    print(result.messages, end="")
    for shader in result.shaders:
        open(shader.file_name, "w").write(shader.text)

The shared library is searched as the system searches it; PATINA_LIBRARY or Compiler(library=...) names it:
/opt/patina/lib/libpatina.so. This file follows patina/patina_c.h, which says what each function does.
"""
import ctypes
import dataclasses
import json
import os
from ctypes import CFUNCTYPE, POINTER, byref, c_char_p, c_int, c_size_t, c_uint32, c_void_p

ABI = 1  # PATINA_C_ABI of the header that this file follows
OK, HAS_ERRORS = 0, 1


class Error(Exception):
    """No result could be made: the library is another one, or there is not enough memory."""


@dataclasses.dataclass
class Shader:
    """A stage of a pass, or a file that holds all passes."""
    file_name: str
    text: str
    pass_name: str
    stage: str
    engine: str
    language: str


@dataclasses.dataclass
class Result:
    """What a compilation makes. If it is not ok, the messages say why, and there are no shaders."""
    ok: bool
    messages: str
    diagnostics: list
    shaders: list
    reflection: dict
    dependencies: list  # files that were read
    missing: list  # files that were looked for and are not there: if one appears, the result may be another one


@dataclasses.dataclass
class Variants:
    """The different programs of a material's variants."""
    ok: bool
    messages: str
    combinations: list  # what each variant is, by combination
    program_of: list  # an index into `programs`, by combination
    programs: list
    dependencies: list  # of all combinations; those of a program are empty
    missing: list


@dataclasses.dataclass
class Scene:
    """A scene as its file says it, with the defaults filled in."""
    ok: bool
    messages: str
    scene: dict
    dependencies: list
    missing: list


class _Callbacks(ctypes.Structure):  # patina_callbacks
    Read = CFUNCTYPE(None, c_void_p, c_char_p, c_void_p)
    _fields_ = [("user", c_void_p), ("read", Read), ("exists", CFUNCTYPE(c_int, c_void_p, c_char_p)),
                ("resolve", CFUNCTYPE(None, c_void_p, c_char_p, c_char_p, c_void_p)),
                ("cancelled", CFUNCTYPE(c_int, c_void_p))]


class _Shader(ctypes.Structure):  # patina_shader
    _fields_ = [("file_name", c_char_p), ("text", c_char_p), ("size", c_size_t), ("pass_name", c_char_p),
                ("stage", c_char_p), ("engine", c_char_p), ("language", c_char_p)]


class _LibraryFile(ctypes.Structure):  # patina_library_file
    _fields_ = [("name", c_char_p), ("text", c_char_p), ("size", c_size_t)]


class _Node(ctypes.Structure):  # patina_node
    _fields_ = [(name, c_char_p) for name in ("name", "category", "doc", "file", "json")]


class _Path(ctypes.Structure):  # patina_path; patina_engine has as many texts
    _fields_ = [(name, c_char_p) for name in ("name", "second", "third", "json")]


_FUNCTIONS = [
    ("patina_compiler_create", c_int, c_uint32, POINTER(_LibraryFile), c_size_t, POINTER(c_void_p)),
    ("patina_compiler_free", None, c_void_p),
    ("patina_status_text", c_char_p, c_int),
    ("patina_reply_text", None, c_void_p, c_char_p, c_size_t),
    ("patina_reply_error", None, c_void_p, c_char_p),
    ("patina_compile", c_int, c_void_p, c_char_p, c_char_p, c_size_t, c_char_p, POINTER(_Callbacks),
     POINTER(c_void_p)),
    ("patina_compile_file", c_int, c_void_p, c_char_p, c_char_p, POINTER(_Callbacks), POINTER(c_void_p)),
    ("patina_result_messages", c_char_p, c_void_p),
    ("patina_result_diagnostics", c_char_p, c_void_p),
    ("patina_result_shader_count", c_size_t, c_void_p),
    ("patina_result_shader", POINTER(_Shader), c_void_p, c_size_t),
    ("patina_result_reflection", c_char_p, c_void_p),
    ("patina_result_dependency_count", c_size_t, c_void_p),
    ("patina_result_dependency", c_char_p, c_void_p, c_size_t),
    ("patina_result_missing_count", c_size_t, c_void_p),
    ("patina_result_missing", c_char_p, c_void_p, c_size_t),
    ("patina_result_free", None, c_void_p),
    ("patina_plan_variants", c_int, c_void_p, c_char_p, c_char_p, c_size_t, c_char_p, POINTER(_Callbacks),
     POINTER(c_void_p)),
    ("patina_plan_count", c_size_t, c_void_p),
    ("patina_plan_combination", c_char_p, c_void_p, c_size_t),
    ("patina_plan_messages", c_char_p, c_void_p),
    ("patina_plan_free", None, c_void_p),
    ("patina_compile_variants", c_int, c_void_p, c_void_p, POINTER(c_void_p)),
    ("patina_variants_program_count", c_size_t, c_void_p),
    ("patina_variants_program", c_void_p, c_void_p, c_size_t),
    ("patina_variants_program_of", c_size_t, c_void_p, c_size_t),
    ("patina_variants_messages", c_char_p, c_void_p),
    ("patina_variants_dependency_count", c_size_t, c_void_p),
    ("patina_variants_dependency", c_char_p, c_void_p, c_size_t),
    ("patina_variants_missing_count", c_size_t, c_void_p),
    ("patina_variants_missing", c_char_p, c_void_p, c_size_t),
    ("patina_variants_free", None, c_void_p),
    ("patina_read_scene", c_int, c_void_p, c_char_p, c_char_p, POINTER(_Callbacks), POINTER(c_void_p)),
    ("patina_scene_messages", c_char_p, c_void_p),
    ("patina_scene_json", c_char_p, c_void_p),
    ("patina_scene_dependency_count", c_size_t, c_void_p),
    ("patina_scene_dependency", c_char_p, c_void_p, c_size_t),
    ("patina_scene_missing_count", c_size_t, c_void_p),
    ("patina_scene_missing", c_char_p, c_void_p, c_size_t),
    ("patina_scene_free", None, c_void_p),
    ("patina_nodes", c_int, c_void_p, POINTER(POINTER(_Node)), POINTER(c_size_t)),
    ("patina_paths", c_int, c_void_p, POINTER(POINTER(_Path)), POINTER(c_size_t)),
    ("patina_engines", c_int, c_void_p, POINTER(POINTER(_Path)), POINTER(c_size_t)),
]


def _load(path):
    library = ctypes.CDLL(path)
    for name, result, *arguments in _FUNCTIONS:
        function = getattr(library, name)
        function.restype, function.argtypes = result, arguments
    return library


def _options(options):
    """Of compile(graph, targets=["glsl"], switches={"_Wet": True}): the text that the C functions read."""
    return json.dumps(options).encode() if options else None


class Compiler:
    """The compiler with its library of nodes. It is made once; any number of threads may use it.

    library: the path of libpatina.so. files: a dict of the program's own nodes, paths and models, text by name.
    """

    def __init__(self, library=None, files=None):
        self._library = _load(library or os.environ.get("PATINA_LIBRARY", "libpatina.so"))
        self._compiler = c_void_p()
        texts = [(name.encode(), text.encode()) for name, text in (files or {}).items()]
        given = (_LibraryFile * max(len(texts), 1))(*[(name, text, len(text)) for name, text in texts])
        self._check(self._library.patina_compiler_create(ABI, given, len(texts), byref(self._compiler)))

    def __del__(self):
        if getattr(self, "_compiler", None):
            self._library.patina_compiler_free(self._compiler)

    def compile(self, path, graph, read=None, **options):
        """Compiles a graph, a text or a dict. `path` names it; files that it names are searched from there.

        read: a function that gives the text of a path, or None; without it files are on the disk. What it raises is an
        error of the compilation. options: the keys of patina_compile(), such as targets, path, switches, preview.
        """
        text = (graph if isinstance(graph, str) else json.dumps(graph)).encode()
        with _Files(self._library, read) as files:
            result = c_void_p()
            self._check(self._library.patina_compile(self._compiler, path.encode(), text, len(text),
                                                     _options(options), files, byref(result)))
        return self._take(result)

    def compile_file(self, path, read=None, **options):
        """The same, of the text of a file."""
        with _Files(self._library, read) as files:
            result = c_void_p()
            self._check(self._library.patina_compile_file(self._compiler, path.encode(), _options(options), files,
                                                          byref(result)))
        return self._take(result)

    def compile_variants(self, path, wanted="all", limit=1024, read=None, **options):
        """Compiles the combinations of a graph's variants: "all", "listed" or "reachable"."""
        library = self._library
        with _Files(library, read) as files:
            plan, made = c_void_p(), c_void_p()
            self._check(library.patina_plan_variants(self._compiler, path.encode(), wanted.encode(), limit,
                                                     _options(options), files, byref(plan)))
            try:
                count = library.patina_plan_count(plan)
                if not count:
                    return Variants(False, library.patina_plan_messages(plan).decode(), [], [], [], [], [])
                status = self._check(library.patina_compile_variants(self._compiler, plan, byref(made)))
                combinations = [json.loads(library.patina_plan_combination(plan, i)) for i in range(count)]
            finally:
                library.patina_plan_free(plan)
        try:
            programs = [self._read(library.patina_variants_program(made, i))
                        for i in range(library.patina_variants_program_count(made))]
            program_of = [library.patina_variants_program_of(made, i) for i in range(count)] if programs else []
            return Variants(status == OK, library.patina_variants_messages(made).decode(), combinations, program_of,
                            programs, self._texts("patina_variants_dependency", made),
                            self._texts("patina_variants_missing", made))
        finally:
            library.patina_variants_free(made)

    def read_scene(self, path, read=None, **options):
        """Reads a scene; its graphs are found, not compiled."""
        with _Files(self._library, read) as files:
            scene = c_void_p()
            status = self._check(self._library.patina_read_scene(self._compiler, path.encode(), _options(options),
                                                                 files, byref(scene)))
        try:
            text = self._library.patina_scene_json(scene)
            return Scene(status == OK, self._library.patina_scene_messages(scene).decode(),
                         json.loads(text) if text else {}, self._texts("patina_scene_dependency", scene),
                         self._texts("patina_scene_missing", scene))
        finally:
            self._library.patina_scene_free(scene)

    def nodes(self):
        """All nodes, each a dict with its ports."""
        return self._list("patina_nodes", _Node)

    def paths(self):
        """All rendering paths, each a dict with its passes."""
        return self._list("patina_paths", _Path)

    def engines(self):
        """All engines, each a dict."""
        return self._list("patina_engines", _Path)

    def _list(self, function, entry):
        entries, count = POINTER(entry)(), c_size_t()
        self._check(getattr(self._library, function)(self._compiler, byref(entries), byref(count)))
        return [json.loads(entries[i].json) for i in range(count.value)]

    def _check(self, status):
        if status not in (OK, HAS_ERRORS):
            raise Error(self._library.patina_status_text(status).decode())
        return status

    def _take(self, result):
        try:
            return self._read(result)
        finally:
            self._library.patina_result_free(result)

    def _read(self, result):
        library = self._library
        shaders = []
        for i in range(library.patina_result_shader_count(result)):
            shader = library.patina_result_shader(result, i).contents
            shaders.append(Shader(*[getattr(shader, name).decode() for name in
                                    ("file_name", "text", "pass_name", "stage", "engine", "language")]))
        reflection = library.patina_result_reflection(result)
        return Result(ok=bool(reflection), messages=library.patina_result_messages(result).decode(),
                      diagnostics=json.loads(library.patina_result_diagnostics(result)), shaders=shaders,
                      reflection=json.loads(reflection) if reflection else {},
                      dependencies=self._texts("patina_result_dependency", result),
                      missing=self._texts("patina_result_missing", result))

    def _texts(self, function, made):
        """All texts of a function that gives one by its index."""
        one, count = getattr(self._library, function), getattr(self._library, function + "_count")
        return [one(made, i).decode() for i in range(count(made))]


class _Files:
    """The callbacks of a program that reads files itself, for the time of a call."""

    def __init__(self, library, read):
        self._callbacks = None
        if read is None:
            return

        @_Callbacks.Read
        def answer(_, path, reply):
            try:
                text = read(path.decode())
            except Exception as error:  # no exception crosses C
                library.patina_reply_error(reply, str(error).encode())
                return
            if text is not None:
                text = text.encode()
                library.patina_reply_text(reply, text, len(text))

        self._callbacks = _Callbacks(read=answer)

    def __enter__(self):
        return byref(self._callbacks) if self._callbacks else None

    def __exit__(self, *_):
        self._callbacks = None
