using Nowpose.Metas;

const string Help = """
    Creates and checks the .meta files of the Unity project that contains the current folder.

      (no option)  write missing files, then list the remaining faults
      --prune      also remove .meta files without an asset
      --check      write nothing, only list the faults

    Exit status: 0 no faults, 1 faults, 2 invalid arguments.
    """;

if (args.Contains("--help"))
{
    Console.WriteLine(Help);
    return 0;
}
var unknown = args.FirstOrDefault(a => a is not ("--check" or "--prune"));
if (unknown != null) return Refuse($"unknown option {unknown}; use --check, --prune or --help");
if (args.Contains("--check") && args.Contains("--prune")) return Refuse("--check writes nothing, so it cannot be combined with --prune");

var root = ProjectRoot.Find(Directory.GetCurrentDirectory());
if (root == null) return Refuse($"there is no Unity project at or above {Directory.GetCurrentDirectory()}");

if (args.Contains("--prune"))
    foreach (var path in MetaWriter.Prune(root)) Console.WriteLine($"removed {path}");
if (!args.Contains("--check"))
    foreach (var path in MetaWriter.WriteMissing(root)) Console.WriteLine($"wrote {path}");

var faults = MetaCheck.Faults(root);
foreach (var fault in faults) Console.WriteLine(fault);
return faults.Count == 0 ? 0 : 1;

static int Refuse(string message)
{
    Console.Error.WriteLine(message);
    return 2;
}
