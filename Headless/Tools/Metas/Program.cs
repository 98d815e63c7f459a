using Nowpose.Metas;

const string Help = """
    Makes and checks the .meta files of the Unity project that the current folder lies in.

      (no option)  write the missing ones, then list what else is wrong
      --prune      also remove those whose asset is gone
      --check      write nothing, only list what is wrong

    Exit status: 0 clean, 1 faults, 2 wrong use.
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
